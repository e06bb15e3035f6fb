// A self-test of the exact functions in `shared/`: inputs made from a counter, and what is kept of the results.
//
// The texts beside this one (`wide.wgsl`, `divide.wgsl`, …) have one entry point a function, named after it. A
// workgroup takes a block of 4,096 inputs, on each calls the function, and hands up to four result words to `emit`.
//
//     whole = 1   one block: input i is a pair (i mod 64, i / 64) of the edge table; output[4 i] … output[4 i + 3] are
//                 the words of its result
//     whole = 0   inputs of many shapes; output[block] is the sum modulo 2^32, over the inputs of the block, of a hash
//                 of input number and result words. A sum has no order, so it does not depend on the device's, and the
//                 hash is one to one in each word, so no wrong word alone can leave it unchanged.

struct Params {
    /// Block of the first workgroup.
    first: u32,
    whole: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> edges: array<u32, 64>;
@group(0) @binding(2) var<storage, read_write> output: array<atomic<u32>>;

/// Inputs a workgroup.
const BLOCK: u32 = 4096u;

/// Wellons's lowbias32 (2018).
fn scramble(v: u32) -> u32 {
    var x = v;
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    return x ^ (x >> 16u);
}

/// Random word `k` < 8 of input `i`, uniform: it chooses what kind of input is made.
fn noise(i: u32, k: u32) -> u32 {
    return scramble(i * 16u + 8u + k + 0x9e3779b9u);
}

/// A word of one of eight shapes, two of them uniform: few bits, few zeros, powers of two -1 to +2, all magnitudes,
/// their negatives, the edge table.
fn shaped(r: u32) -> u32 {
    let s = scramble(r ^ 0x5bd1e995u);
    let t = s * 0x9e3779b1u;
    let kind = t >> 29u;
    let k = (t >> 24u) & 31u;
    let thin = r & s & ((s >> 13u) | (s << 19u));
    var x = r;
    x = select(x, thin, kind == 2u);
    x = select(x, ~thin, kind == 3u);
    x = select(x, (1u << k) + ((t >> 22u) & 3u) - 1u, kind == 4u);
    x = select(x, r >> k, kind == 5u);
    x = select(x, 0u - (r >> k), kind == 6u);
    return select(x, edges[r & 63u], kind == 7u);
}

/// Word `k` < 16 of input `i`. Of the edge table, words 0 and 1 take all pairs, further words stride through it.
fn raw(i: u32, k: u32) -> u32 {
    if (params.whole != 0u) {
        let row = i & 63u;
        let column = i >> 6u;
        let place = row * (2u * k + 1u) + column * (4u * k - 1u) + k;
        return edges[select(place, select(row, column, k == 1u), k < 2u) & 63u];
    }
    return shaped(scramble(i * 16u + k));
}

/// First input of a lane; the others follow 256 apart.
fn first_input(group: u32, lane: u32) -> u32 {
    return (params.first + group) * BLOCK + lane;
}

/// One past the last input of a workgroup.
fn end_input(group: u32) -> u32 {
    return (params.first + group + 1u) * BLOCK;
}

fn absorb(hash: u32, word: u32) -> u32 {
    let h = (hash ^ word) * 0x9e3779b1u;
    return h ^ (h >> 15u);
}

/// Keeps the result of input `i`: whole, or as the hash that is returned.
fn emit(i: u32, words: vec4<u32>) -> u32 {
    if (params.whole != 0u) {
        atomicStore(&output[4u * i], words.x);
        atomicStore(&output[4u * i + 1u], words.y);
        atomicStore(&output[4u * i + 2u], words.z);
        atomicStore(&output[4u * i + 3u], words.w);
    }
    return absorb(absorb(absorb(absorb(scramble(i), words.x), words.y), words.z), words.w);
}

fn emit1(i: u32, word: u32) -> u32 {
    return emit(i, vec4<u32>(word, 0u, 0u, 0u));
}

fn emit2(i: u32, words: vec2<u32>) -> u32 {
    return emit(i, vec4<u32>(words, 0u, 0u));
}

/// Adds what a lane's inputs hashed to into the digest of its block.
fn finish(group: u32, sum: u32) {
    if (params.whole == 0u) {
        atomicAdd(&output[params.first + group], sum);
    }
}

// Logical operations on masks without an integer unit: by a table of the operation's result for any three bytes.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications" (Computer Graphics Forum 26(3), 2007), section 5
// and equation 4: a texture of 256³ texels holds i AND j AND k, or any other operation; one look-up a channel joins
// three masks of 8-bit channels. An operation is given by its truth table: bit x + 2y + 4z of `truth` is its result for
// bits x, y, z.
//
//     op_map, byte i + 256 j + 65536 k         = op(i, j, k) bit by bit; four bytes a word, the first in the lowest
//     bits combined[w], byte n                      = byte (a[w] byte n) + 256 (b[w] byte n) + 65536 (c[w] byte n) of
//     op_map
//
// Of two masks the first 256² bytes are enough, those of k = 0.
//
// `combine_two` and `combine_three` use no bitwise operation: bytes are taken out and put together by the format
// conversions that a texture and a render target of RGBA8 have.

struct Params {
    /// Words of masks to combine, or of a table to build.
    words: u32,
    truth: u32,
    /// Word of the first invocation.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read_write> table: array<u32>;
@group(0) @binding(2) var<storage, read> op_map: array<u32>;
@group(0) @binding(3) var<storage, read> a: array<u32>;
@group(0) @binding(4) var<storage, read> b: array<u32>;
@group(0) @binding(5) var<storage, read> c: array<u32>;
@group(0) @binding(6) var<storage, read_write> combined: array<u32>;

/// Bit by bit `one` where `bits` is 1, else `zero`.
fn pick(bits: u32, zero: u32, one: u32) -> u32 {
    return zero ^ (bits & (zero ^ one));
}

/// The operation on whole words: the truth table's rows, chosen between by x, then by y, then by z.
fn operate(x: u32, y: u32, z: u32) -> u32 {
    let rows = vec4<u32>(0u, 1u, 2u, 3u);
    let low = vec4<u32>(0u) - ((vec4<u32>(params.truth) >> rows) & vec4<u32>(1u));
    let high = vec4<u32>(0u) - ((vec4<u32>(params.truth) >> (rows + 4u)) & vec4<u32>(1u));
    let without_z = pick(y, pick(x, low.x, low.y), pick(x, low.z, low.w));
    let with_z = pick(y, pick(x, high.x, high.y), pick(x, high.z, high.w));
    return pick(z, without_z, with_z);
}

@compute @workgroup_size(256)
fn build(@builtin(global_invocation_id) id: vec3<u32>) {
    let word = params.first + id.x;
    if (word >= params.words) {
        return;
    }
    let four = (word % 64u) * 0x04040404u + 0x03020100u;
    table[word] = operate(four, ((word / 64u) % 256u) * 0x01010101u, (word / 16384u) * 0x01010101u);
}

fn look_up(i: u32, j: u32, k: u32) -> u32 {
    let byte = i + 256u * j + 65536u * k;
    return unpack4xU8(op_map[byte / 4u])[byte % 4u];
}

@compute @workgroup_size(256)
fn combine_two(@builtin(global_invocation_id) id: vec3<u32>) {
    let word = params.first + id.x;
    if (word >= params.words) {
        return;
    }
    let i = unpack4xU8(a[word]);
    let j = unpack4xU8(b[word]);
    combined[word] = pack4xU8(vec4<u32>(
        look_up(i.x, j.x, 0u),
        look_up(i.y, j.y, 0u),
        look_up(i.z, j.z, 0u),
        look_up(i.w, j.w, 0u),
    ));
}

@compute @workgroup_size(256)
fn combine_three(@builtin(global_invocation_id) id: vec3<u32>) {
    let word = params.first + id.x;
    if (word >= params.words) {
        return;
    }
    let i = unpack4xU8(a[word]);
    let j = unpack4xU8(b[word]);
    let k = unpack4xU8(c[word]);
    combined[word] = pack4xU8(vec4<u32>(
        look_up(i.x, j.x, k.x),
        look_up(i.y, j.y, k.y),
        look_up(i.z, j.z, k.z),
        look_up(i.w, j.w, k.w),
    ));
}

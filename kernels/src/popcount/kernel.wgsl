// Bit counts of hidden-sample masks.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications" (Computer Graphics Forum 26(3), 2007), section 8
// and figure 4: a second pass turns the mask of hidden light samples of every receiver into a shadow intensity.
//
// Sample s of a receiver is bit `s % bits` of its word `s / bits`; word w of receiver r is `masks[w * receivers + r]`,
// one plane a word as in the paper's render targets. All other bits are ignored. For every receiver r
//
//     hidden[r]  = number of samples whose bit is 1        (|B_r| of section 2)
//     visible[r] = samples - hidden[r]                     (the zero bits that section 8 counts)
//
// by four methods, one an entry point, with equal results.

struct Params {
    receivers: u32,
    /// Words a receiver.
    words: u32,
    /// Samples a receiver, at least 1.
    samples: u32,
    /// Samples a word, 1 to 32.
    bits: u32,
    /// Receiver of the first invocation.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> masks: array<u32>;
@group(0) @binding(2) var<storage, read_write> hidden: array<u32>;
@group(0) @binding(3) var<storage, read_write> visible: array<u32>;
/// Number of set bits of every byte.
@group(0) @binding(4) var<storage, read> byte_counts: array<u32, 256>;

/// A word with its lowest `n` bits set, 1 to 32.
fn low_bits(n: u32) -> u32 {
    return 0xffffffffu >> (32u - n);
}

/// One word of a receiver's mask, without the bits that are no samples.
fn word_of(receiver: u32, word: u32) -> u32 {
    let n = min(params.samples - word * params.bits, params.bits);
    return masks[word * params.receivers + receiver] & low_bits(n);
}

fn store(receiver: u32, count: u32) {
    hidden[receiver] = count;
    visible[receiver] = params.samples - count;
}

/// Figure 4: keep the even fields in one copy and the odd fields in another, shift the second onto the first, add;
/// fields double until one is left.
fn count_logarithmic(mask: u32) -> u32 {
    var n = (mask & 0x55555555u) + ((mask & 0xaaaaaaaau) >> 1u);
    n = (n & 0x33333333u) + ((n & 0xccccccccu) >> 2u);
    n = (n & 0x0f0f0f0fu) + ((n & 0xf0f0f0f0u) >> 4u);
    n = (n & 0x00ff00ffu) + ((n & 0xff00ff00u) >> 8u);
    return (n & 0x0000ffffu) + ((n & 0xffff0000u) >> 16u);
}

fn count_bit_loop(mask: u32) -> u32 {
    var n = 0u;
    for (var bit = 0u; bit < 32u; bit += 1u) {
        n += (mask >> bit) & 1u;
    }
    return n;
}

fn count_table(mask: u32) -> u32 {
    return byte_counts[mask & 0xffu] + byte_counts[(mask >> 8u) & 0xffu] + byte_counts[(mask >> 16u) & 0xffu]
        + byte_counts[mask >> 24u];
}

@compute @workgroup_size(256)
fn logarithmic(@builtin(global_invocation_id) id: vec3<u32>) {
    let receiver = params.first + id.x;
    if (receiver >= params.receivers) {
        return;
    }
    var count = 0u;
    for (var word = 0u; word < params.words; word += 1u) {
        count += count_logarithmic(word_of(receiver, word));
    }
    store(receiver, count);
}

@compute @workgroup_size(256)
fn bit_loop(@builtin(global_invocation_id) id: vec3<u32>) {
    let receiver = params.first + id.x;
    if (receiver >= params.receivers) {
        return;
    }
    var count = 0u;
    for (var word = 0u; word < params.words; word += 1u) {
        count += count_bit_loop(word_of(receiver, word));
    }
    store(receiver, count);
}

@compute @workgroup_size(256)
fn table(@builtin(global_invocation_id) id: vec3<u32>) {
    let receiver = params.first + id.x;
    if (receiver >= params.receivers) {
        return;
    }
    var count = 0u;
    for (var word = 0u; word < params.words; word += 1u) {
        count += count_table(word_of(receiver, word));
    }
    store(receiver, count);
}

@compute @workgroup_size(256)
fn builtin(@builtin(global_invocation_id) id: vec3<u32>) {
    let receiver = params.first + id.x;
    if (receiver >= params.receivers) {
        return;
    }
    var count = 0u;
    for (var word = 0u; word < params.words; word += 1u) {
        count += countOneBits(word_of(receiver, word));
    }
    store(receiver, count);
}

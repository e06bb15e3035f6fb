// How two hidden-samples maps differ: what a table of lines gets wrong, against the map of the definition.
//
// Output: `counts[slot]` grows by the number of bits that are set in `found` and not in `truth`, `counts[slot + 1]` by
// the number of those that are set in `truth` and not in `found`.

struct Params {
    /// Word of the first invocation.
    first: u32,
    /// Words of a map.
    words: u32,
    slot: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> found: array<u32>;
@group(0) @binding(2) var<storage, read> truth: array<u32>;
@group(0) @binding(3) var<storage, read_write> counts: array<atomic<u32>>;

@compute @workgroup_size(256)
fn differ(@builtin(global_invocation_id) id: vec3<u32>) {
    let word = params.first + id.x;
    if (word >= params.words) {
        return;
    }
    let surplus = countOneBits(found[word] & ~truth[word]);
    let missing = countOneBits(truth[word] & ~found[word]);
    if (surplus + missing != 0u) {
        atomicAdd(&counts[params.slot], surplus);
        atomicAdd(&counts[params.slot + 1u], missing);
    }
}

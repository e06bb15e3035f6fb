// Memory latency: 64 loads from a table of 256 KiB, each at an index that the one before it gave.

@group(0) @binding(0) var<storage, read_write> results: array<u32>;
@group(0) @binding(1) var<storage, read> words: array<u32, 65536>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    var at = id.x;
    for (var i = 0u; i < 64u; i++) {
        // The lane's own number keeps chains apart that have met.
        at = (words[at] + id.x) & 0xffffu;
    }
    results[id.x] = at;
}

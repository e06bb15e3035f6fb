// Barriers: eight tree sums over 256 invocations, each of eight steps; a workgroup passes 80 barriers.

@group(0) @binding(0) var<storage, read_write> results: array<u32>;

var<workgroup> sums: array<u32, 256>;

@compute @workgroup_size(256)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var value = id.x;
    for (var i = 0u; i < 8u; i++) {
        sums[lane] = value;
        workgroupBarrier();
        for (var half = 128u; half > 0u; half >>= 1u) {
            if lane < half {
                sums[lane] += sums[lane + half];
            }
            workgroupBarrier();
        }
        value = value * 3u + sums[0];
        workgroupBarrier();
    }
    results[id.x] = value;
}

// A workgroup of 256 with storage and workgroup barriers in a uniform loop; neighbours exchange.
//! buffer 0: zero 256
//! buffer 1: zero 1
//! dispatch: main 1 1 1
//! expect 1: u32 32640

@group(0) @binding(0) var<storage, read_write> data: array<u32>;
@group(0) @binding(1) var<storage, read_write> sum: atomic<u32>;
var<workgroup> ring: array<u32, 256>;

@compute @workgroup_size(16, 4, 4)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    ring[i] = id.x + 16u * id.y + 64u * id.z;
    for (var k = 0; k < 256; k++) {
        workgroupBarrier();
        let next = ring[(i + 1u) % 256u];
        workgroupBarrier();
        ring[i] = next;
    }
    data[255u - i] = ring[i];
    storageBarrier();
    atomicAdd(&sum, select(1000000u, data[i], data[i] == 255u - i));
}

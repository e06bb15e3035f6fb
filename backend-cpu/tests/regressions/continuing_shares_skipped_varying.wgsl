// All invocations jump over statements that compute the same index as the continuing block.
//! buffer 0: u32 1 2 3 4
//! dispatch: main 1 1 1
//! expect 0: u32 3 4 5 1

@group(0) @binding(0) var<storage, read_write> data: array<u32>;
var<workgroup> ring: array<u32, 4>;

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) i: u32) {
    ring[i] = data[i];
    workgroupBarrier();
    var v = 0u;
    var k = 0u;
    loop {
        if data[0] < 77u {
            continue;
        }
        v = ring[(i + 1u) % 4u];
        continuing {
            k++;
            v = ring[(i + 1u) % 4u] + (k & 1u) - 1u;
            break if k > 2u;
        }
    }
    data[i] = v + select(1u, 0u, i == 3u);
}

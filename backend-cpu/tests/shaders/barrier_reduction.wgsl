// A tree reduction and a scan in workgroup memory, several workgroups, twice the same array.
//! buffer 0: zero 256
//! buffer 1: zero 4
//! dispatch: fill 4 1 1
//! dispatch: main 4 1 1
//! expect 1: u32 2080 6176 10272 14368

@group(0) @binding(0) var<storage, read_write> data: array<u32>;
@group(0) @binding(1) var<storage, read_write> sums: array<u32>;
var<workgroup> partial: array<u32, 64>;

@compute @workgroup_size(64)
fn fill(@builtin(global_invocation_id) id: vec3<u32>) {
    data[id.x] = id.x + 1u;
}

@compute @workgroup_size(64)
fn main(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) i: u32,
    @builtin(workgroup_id) group: vec3<u32>,
) {
    // Prefix sums by doubling.
    partial[i] = data[id.x];
    workgroupBarrier();
    for (var step = 1u; step < 64u; step *= 2u) {
        var before = 0u;
        if i >= step {
            before = partial[i - step];
        }
        workgroupBarrier();
        partial[i] += before;
        workgroupBarrier();
    }
    let total = partial[63];
    workgroupBarrier();
    // A tree.
    partial[i] = data[id.x];
    for (var half = 32u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if i < half {
            partial[i] += partial[i + half];
        }
    }
    workgroupBarrier();
    if i == 0u {
        sums[group.x] = select(0u, partial[0], partial[0] == total);
    }
}

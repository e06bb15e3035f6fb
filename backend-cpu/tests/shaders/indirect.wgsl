// The number of workgroups comes from a buffer that an earlier dispatch wrote; zero groups do nothing.
//! buffer 0: zero 8
//! buffer 1: zero 8
//! dispatch: prepare 1 1 1
//! indirect: main 0 4
//! indirect: main 0 16
//! expect 1: u32 1 1 1 1 1 1 0 0

@group(0) @binding(0) var<storage, read_write> counts: array<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(1)
fn prepare() {
    counts[1] = 3u;
    counts[2] = 2u;
    counts[3] = 1u;
    counts[4] = 3u;
    counts[5] = 0u;
    counts[6] = 1u;
}

@compute @workgroup_size(1)
fn main(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    out[group.x + groups.x * group.y] += 1u;
}

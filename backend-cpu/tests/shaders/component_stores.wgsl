// A store to one component leaves the others alone, whoever writes them, and padding stays as it was.
//! buffer 0: u32 7*16
//! dispatch: main 1 1 1
//! expect 0: u32 0 10 20 7 1 11 21 7 2 12 22 7 3 13 23 7

@group(0) @binding(0) var<storage, read_write> data: array<vec3<u32>, 4>;

@compute @workgroup_size(12)
fn main(@builtin(local_invocation_index) i: u32) {
    data[i / 3u][i % 3u] = i / 3u + 10u * (i % 3u);
}

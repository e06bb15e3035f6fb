// An index out of range in a branch that is not taken is no error.
//! buffer 0: zero 4
//! dispatch: main 1 1 1
//! expect 0: u32 0 1 2 3

@group(0) @binding(0) var<storage, read_write> data: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    if i < 4u {
        data[i] = i;
    }
    if i < arrayLength(&data) && data[i] > 7u {
        data[i] = 99u;
    }
}

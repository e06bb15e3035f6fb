// The trap names index and length of the first invocation in question.
//! buffer 0: zero 4
//! dispatch: main 1 1 1
//! expect 0: u32 1 1 1 1
//! trap: 12 index 4 is out of bounds of length 4

@group(0) @binding(0) var<storage, read_write> data: array<u32>;

@compute @workgroup_size(6)
fn main(@builtin(local_invocation_index) i: u32) {
    if i != 3u {
        data[i] = 1u;
    }
    if i == 3u { data[i] = 1u; }
}

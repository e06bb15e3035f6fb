// A loop that never ends is stopped.
//! buffer 0: zero 1
//! dispatch: main 1 1 1
//! fails: no end after

@group(0) @binding(0) var<storage, read_write> data: array<u32>;

@compute @workgroup_size(1)
fn main() {
    var x = 0u;
    loop {
        x += 2u;
        if x == 7u {
            break;
        }
    }
    data[0] = x;
}

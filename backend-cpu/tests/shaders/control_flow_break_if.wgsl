// break if sees variables of the body and of the continuing block; the body runs at least once.
//! buffer 0: zero 8
//! dispatch: main 1 1 1
//! expect 0: u32 1 1 3 6 10 15 21 28

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(8)
fn main(@builtin(local_invocation_index) i: u32) {
    var sum = 0u;
    var k = 0u;
    loop {
        let next = k + 1u;
        sum += next;
        continuing {
            k = next;
            let end = k >= i;
            break if end;
        }
    }
    out[i] = sum;
}

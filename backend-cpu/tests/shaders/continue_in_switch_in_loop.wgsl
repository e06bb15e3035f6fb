// Every turn adds 101, and 1 but for turn 4. A continue inside a switch runs the continuing block; a break inside a switch does not leave the loop.
//! buffer 0: zero 8
//! dispatch: main 1 1 1
//! expect 0: u32 0 102 204 1306 1408 11509 11611 11713

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(8)
fn main(@builtin(local_invocation_index) i: u32) {
    var a = 0u;
    var k = 0u;
    loop {
        if k >= i {
            break;
        }
        switch k {
            case 2u: {
                a += 1000u;
                break;
            }
            case 4u: {
                a += 10000u;
                continue;
            }
            default: {
            }
        }
        a += 1u;
        continuing {
            a += 101u;
            k++;
        }
    }
    out[i] = a;
}

// Cases of several selectors, a default in the middle, break inside a case, continue out of a switch.
//! buffer 0: zero 12
//! buffer 1: zero 12
//! dispatch: main 1 1 1
//! expect 0: u32 10 21 21 40 50 40 66 40 40 40 40 40
//! expect 1: i32 7 6 5 4 3 2 1 -1 -1 -1 -1 -1

@group(0) @binding(0) var<storage, read_write> out: array<u32>;
@group(0) @binding(1) var<storage, read_write> signed: array<i32>;

fn choose(i: u32) -> u32 {
    var x = 0u;
    switch i {
        case 0u: {
            x = 10u;
        }
        case 1u, 2u: {
            x = 21u;
            if i == 9u {
                x = 22u;
            }
        }
        default: {
            x = 40u;
        }
        case 4u: {
            x = 50u;
            if i < 100u {
                break;
            }
            x = 51u;
        }
        case 6u: {
            return 66u;
        }
    }
    return x;
}

@compute @workgroup_size(12)
fn main(@builtin(local_invocation_index) i: u32) {
    out[i] = choose(i);
    var count = 0i;
    for (var k = i32(i); k < 12; k++) {
        switch k - 7 {
            case -1, -2, -3, -4, -5, -6, -7: {
                count += 1;
                continue;
            }
            case 0: {
                if count == 0 {
                    count = -1;
                }
            }
            case 1, 2, 3, 4: {
                if count == 0 {
                    count = -1;
                }
                continue;
            }
            default: {
                count = 1000;
            }
        }
        if k != 7 {
            count = 2000;
        }
    }
    signed[i] = count;
}

// What is computed behind a return, break or continue that all take is not there for what comes after.
//! buffer 0: u32 10 20 30 40
//! buffer 1: zero 16
//! dispatch: main 1 1 1
//! expect 1: u32 21 31 41 41 22 32 42 42 23 33 43 43 24 34 44 44
//! trap: 20 index 4 is out of bounds of length 4

@group(0) @binding(0) var<storage, read> data: array<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;

fn early(i: u32) -> u32 {
    if data[i] > 5u {
        return 1u;
    }
    return data[i + 1u];
}

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) i: u32) {
    out[i] = early(i) + data[i + 1u];
    var x = 0u;
    loop {
        x = 2u;
        if data[i] > 5u {
            break;
        }
        x = data[i + 2u - 1u];
    }
    out[4u + i] = x + data[i + 2u - 1u];
    for (var k = 0u; k < 2u; k++) {
        x = 3u;
        if data[i] > 5u {
            continue;
        }
        x = data[i + 3u - 2u];
    }
    out[8u + i] = x + data[i + 3u - 2u];
    switch i / 8u {
        case 0u: {
            x = 4u;
            if data[i] > 5u {
                break;
            }
            x = data[i + 4u - 3u];
        }
        default: {
            x = data[i + 4u - 3u];
        }
    }
    out[12u + i] = x + data[i + 4u - 3u];
}

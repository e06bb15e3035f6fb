// Nested conditions that differ between invocations; every path stores.
//! buffer 0: zero 16
//! dispatch: main 1 1 1
//! expect 0: u32 100 11 212 13 100 11 212 13 108 21 222 23 108 21 222 23

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(16)
fn main(@builtin(local_invocation_index) i: u32) {
    var x = i % 4u;
    if (i & 1u) == 0u {
        if (i & 2u) != 0u {
            x = 200u + 10u + x;
        } else {
            x = 100u;
        }
        if i >= 8u && x < 200u {
            x += 8u;
        }
    } else {
        x += 10u;
    }
    if i >= 8u && x != 108u {
        x += 10u;
    }
    out[i] = x;
}

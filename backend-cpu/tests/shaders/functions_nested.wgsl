// Calls in calls, early returns that differ between invocations, the same function twice in one expression.
//! buffer 0: zero 10
//! dispatch: main 1 1 1
//! expect 0: u32 2 4 6 12 20 40 72 144 272 544

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

fn power(i: u32) -> u32 {
    var x = 1u;
    for (var k = 0u; k < 32u; k++) {
        if k == i {
            return x;
        }
        x *= 2u;
    }
    return 0u;
}

fn combine(i: u32) -> u32 {
    if i % 2u == 1u {
        return 2u * combine_even(i - 1u);
    }
    return combine_even(i);
}

fn combine_even(i: u32) -> u32 {
    return power(i) + power(i / 2u);
}

@compute @workgroup_size(10)
fn main(@builtin(local_invocation_index) i: u32) {
    out[i] = combine(i);
}

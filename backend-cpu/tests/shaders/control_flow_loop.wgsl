// Trip counts differ between invocations; break, continue and return leave at different places.
//! buffer 0: zero 32
//! dispatch: main 1 1 1
//! expect 0: u32 0 0 1 1 1 3 4 6 4 10 9 15 9 21 16 999 16 999 25 999 25 999 36 999 36 999 49 999 49 999 64 999

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(16)
fn main(@builtin(local_invocation_index) i: u32) {
    // The sum of the odd numbers up to i.
    var odd = 0u;
    var k = 0u;
    loop {
        if k > i {
            break;
        }
        if (k & 1u) == 0u {
            continue;
        }
        odd += k;
        continuing {
            k += 1u;
        }
    }
    out[2u * i] = odd;
    // The sum of all numbers up to i; many invocations return from inside.
    var sum = 0u;
    for (var j = 0u; j <= i; j++) {
        if j == 7u {
            out[2u * i + 1u] = 999u;
            return;
        }
        sum += j;
    }
    out[2u * i + 1u] = sum;
}

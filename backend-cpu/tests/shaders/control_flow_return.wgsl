// Returns out of nested loops in called functions leave only the call.
//! buffer 0: zero 16
//! dispatch: main 1 1 1
//! expect 0: i32 0 -11 -10 -9 0 -5 1 -7 -8 11 -10 -11 -12 -13 -14 -15

@group(0) @binding(0) var<storage, read_write> out: array<i32>;

// 10 a + b of the first a <= b < 4 whose product is n, else -1.
fn factor(n: i32) -> i32 {
    for (var a = 1; a < 4; a++) {
        for (var b = a; b < 4; b++) {
            if a * b == n {
                return a * 10 + b;
            }
            if a * b > n {
                break;
            }
        }
    }
    return -1;
}

@compute @workgroup_size(16)
fn main(@builtin(local_invocation_index) i: u32) {
    let n = i32(i);
    let f = factor(n);
    if f == -1 {
        out[i] = -n;
        return;
    }
    out[i] = f - factor(4);
}

// The Collatz sequence: long divergent loops with inner branches.
//! buffer 0: zero 32
//! dispatch: main 2 1 1
//! expect 0: u32 0 0 1 7 2 5 8 16 3 19 6 14 9 9 17 17 4 12 20 20 7 7 15 15 10 23 10 111 18 18 18 106

@group(0) @binding(0) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(16)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    var n = id.x;
    var steps = 0u;
    while n > 1u {
        if n % 2u == 0u {
            n /= 2u;
        } else {
            n = 3u * n + 1u;
        }
        steps++;
    }
    out[id.x] = steps;
}

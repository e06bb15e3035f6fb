// Loops whose rounds are known before they run: none, some, up to the most that become a sequence and one more; with
// branches, barriers and a counter that is read behind the loop.
//! buffer 0: zero 8
//! dispatch: main 1 1 1
//! expect 0: u32 0 10 2016 2080 7 3 252 4

@group(0) @binding(0) var<storage, read_write> out: array<u32>;
var<workgroup> shared_sum: atomic<u32>;

fn triangle(rounds: u32) -> u32 {
    var sum = 0u;
    for (var i = 0u; i < rounds; i++) {
        sum += i;
    }
    return sum;
}

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) lane: u32) {
    var first = 0u;
    for (var i = 0u; i < 8u; i++) {
        if i < lane + 5u {
            first = i;
        }
    }
    var left = 9u;
    while left > 3u {
        left -= 2u;
    }
    for (var round = 0u; round < 3u; round++) {
        workgroupBarrier();
        for (var i = 0u; i < 7u; i++) {
            atomicAdd(&shared_sum, i);
        }
    }
    workgroupBarrier();
    var rounds = 0u;
    for (var i = 0u; i < 4u; i++) {
        rounds = i + 1u;
    }
    if lane == 3u {
        out[0] = triangle(0u);
        out[1] = triangle(5u);
        out[2] = triangle(64u);
        out[3] = triangle(65u);
        out[4] = first;
        out[5] = left;
        out[6] = atomicLoad(&shared_sum);
        out[7] = rounds;
    }
}

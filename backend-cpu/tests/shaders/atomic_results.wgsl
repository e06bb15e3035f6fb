// Old values of all operations, in one invocation.
//! buffer 0: zero 24
//! dispatch: main 1 1 1
//! expect 0: u32 5 8 6 2 10 15 15 3 20 20 99 1 7 0 7 0xfffffffb 0xfffffffb 4 4 1 1 0xfffffff7 0 1

@group(0) @binding(0) var<storage, read_write> out: array<u32>;
var<workgroup> u: atomic<u32>;
var<workgroup> s: atomic<i32>;

@compute @workgroup_size(1)
fn main() {
    atomicStore(&u, 5u);
    out[0] = atomicAdd(&u, 3u);
    out[1] = atomicSub(&u, 2u);
    out[2] = atomicAnd(&u, 3u);
    out[3] = atomicOr(&u, 8u);
    out[4] = atomicXor(&u, 5u);
    out[5] = atomicMin(&u, 20u);
    out[6] = atomicMin(&u, 3u);
    out[7] = atomicMax(&u, 20u);
    out[8] = atomicMax(&u, 1u);
    out[9] = atomicExchange(&u, 99u);
    let good = atomicCompareExchangeWeak(&u, 99u, 7u);
    out[10] = good.old_value;
    out[11] = u32(good.exchanged);
    let bad = atomicCompareExchangeWeak(&u, 99u, 8u);
    out[12] = bad.old_value;
    out[13] = u32(bad.exchanged);
    out[14] = atomicLoad(&u);
    atomicStore(&s, -5);
    out[15] = u32(atomicMin(&s, 3));
    out[16] = u32(atomicMax(&s, 4));
    out[17] = u32(atomicMax(&s, -7));
    let swapped = atomicCompareExchangeWeak(&s, 4, 1);
    out[18] = u32(swapped.old_value);
    out[19] = u32(swapped.exchanged);
    out[20] = u32(atomicMin(&s, -9));
    let kept = atomicCompareExchangeWeak(&s, 1, 2);
    out[21] = u32(kept.old_value);
    out[22] = u32(kept.exchanged);
    out[23] = select(0u, 1u, atomicLoad(&s) == -9);
}

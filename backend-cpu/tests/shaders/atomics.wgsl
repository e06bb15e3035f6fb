// Every atomic operation on storage; only results that do not depend on the order.
//! buffer 0: i32 0 100 -1 0 0 1000 -1000 0 5 0
//! buffer 1: u32 0 100 0xffffffff 0 0 1000 5 0 0
//! dispatch: main 2 1 1
//! expect 0: i32 64 36 16777216 255 128 -31 32 32 7 0
//! expect 1: u32 2016 0xfffff884 0x80000000 63 0 0 63 77 64

@group(0) @binding(0) var<storage, read_write> s: array<atomic<i32>, 10>;
@group(0) @binding(1) var<storage, read_write> u: array<atomic<u32>, 9>;

@compute @workgroup_size(32)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    let n = i32(i);
    atomicAdd(&s[0], 1);
    atomicSub(&s[1], 1);
    atomicAnd(&s[2], i32(0x01000000u | select(0xffu, 0u, i == 3u)));
    atomicOr(&s[3], i32(1u << (i % 8u)));
    atomicXor(&s[4], i32(select(2u * i, 128u, i == 63u) ^ select(0u, 126u, i == 62u)));
    atomicMin(&s[5], 32 - n);
    atomicMax(&s[6], 32 - n);
    atomicMax(&s[7], 32 - n);
    atomicMin(&s[8], n + 7 - select(0, 2, n == 500));
    atomicStore(&s[8], 7);
    atomicAdd(&u[0], i);
    atomicSub(&u[1], i);
    atomicAnd(&u[2], 0x80000000u | (1u << (i % 31u)));
    atomicOr(&u[3], i);
    atomicXor(&u[4], i);
    atomicMin(&u[5], i);
    atomicMax(&u[6], i);
    // One invocation alone may look at old values.
    if i == 40u {
        let old = atomicExchange(&u[7], 76u);
        let more = atomicAdd(&u[7], 1u);
        if old != 0u || more != 76u || atomicLoad(&u[7]) != 77u {
            atomicStore(&u[7], 0xbadu);
        }
    }
    // A lock-free increment: ends whatever the order.
    loop {
        let seen = atomicLoad(&u[8]);
        let result = atomicCompareExchangeWeak(&u[8], seen, seen + 1u);
        if result.exchanged {
            break;
        }
    }
}

// Integer square roots.
//
// `inverseSqrt` gives a guess; the residual n - s * s is small, hence exact modulo 2^32 or 2^64, and comparisons with
// it leave the one s with s * s <= n < (s + 1) * (s + 1). `inverseSqrt` may be off by 64 ULP in `isqrt32` and by 24 in
// `isqrt64` before that fails; WGSL permits 2.

import package::shared::wide::{clz64, shl64, sub64, umul_wide};

/// floor(sqrt(n)).
/// float: guess - off by at most 1, which the sign of the residual corrects
fn isqrt32(n: u32) -> u32 {
    let f = f32(max(n, 1u));
    let s = u32(f * inverseSqrt(f));
    let r = bitcast<i32>(n - s * s);
    return s - select(0u, 1u, r < 0) + select(0u, 1u, r > bitcast<i32>(2u * s));
}

/// Whether a residual leaves room for one more: r > 2 * x.
fn root_is_short(r: vec2<u32>, x: u32) -> bool {
    return (r.y > (x >> 31u)) | ((r.y == (x >> 31u)) & (r.x > 2u * x));
}

/// floor(sqrt(n)) of an unsigned n.
/// float: guess - a residual below 2^47 corrects the first, exact comparisons the second, which is at most 2 short
fn isqrt64(n: vec2<u32>) -> u32 {
    let s = clz64(n) & 62u;
    let m = shl64(n, s); // in [2^62, 2^64), unless n is 0
    let f = f32(max(m.y, 1u));
    let y = inverseSqrt(f);
    var x = u32(min(f * y * 65536.0, 4294967040.0));
    var r = sub64(m, umul_wide(x, x));
    let r16 = bitcast<i32>((r.y << 16u) | (r.x >> 16u));
    x += bitcast<u32>(i32(floor(f32(r16) * y * 0.5)) - 1);
    r = sub64(m, umul_wide(x, x));
    var up = root_is_short(r, x);
    r = select(r, sub64(r, vec2<u32>(2u * x + 1u, x >> 31u)), up);
    x += select(0u, 1u, up);
    up = root_is_short(r, x);
    x += select(0u, 1u, up);
    return select(x >> (s >> 1u), 0u, (n.x | n.y) == 0u);
}

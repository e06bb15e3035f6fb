// Between fixed point and bit patterns of f32: the one rounding that a result takes when it leaves the library.

import package::shared::soft_float::{F_INF, F_SIGN, f_pack};
import package::shared::wide::{clz64, shl64, uabs};

/// floor(x * 2^k) of a pattern x, clamped to [-2^31, 2^31); 0 for NaN. |k| <= 64.
fn f_to_fix(x: u32, k: i32) -> i32 {
    let negative = (x >> 31u) != 0u;
    let f = (x >> 23u) & 255u;
    if ((x & 0x7fffffffu) > F_INF) {
        return 0;
    }
    let m = (x & 0x7fffffu) | select(0x800000u, 0u, f == 0u);
    let sh = bitcast<i32>(max(f, 1u)) - 150 + k;
    let right = bitcast<u32>(clamp(-sh, 0, 31));
    let lost = (m & ~(0xffffffffu << right)) != 0u;
    let mag = ((m >> right) << bitcast<u32>(clamp(sh, 0, 7))) + select(0u, 1u, negative & lost);
    let big = ((sh > 7) & (m != 0u)) | (mag > 0x7fffffffu);
    let v = select(mag, 0u - mag, negative);
    return bitcast<i32>(select(v, 0x7fffffffu + (x >> 31u), big));
}

/// The pattern of v / 2^k, rounded to nearest, ties to even. |k| <= 96.
fn fix_to_f(v: i32, k: i32) -> u32 {
    if (v == 0) {
        return 0u;
    }
    let sign = bitcast<u32>(v) & F_SIGN;
    let m = uabs(v);
    let s = countLeadingZeros(m);
    // Nothing is lost: the lowest bit is set only for s > 0.
    return f_pack(sign, 158 - bitcast<i32>(s) - k, (m << s) >> 1u);
}

/// The same of an unsigned 64-bit v; infinity beyond the largest finite value. |k| <= 96.
fn u64_to_f(v: vec2<u32>, k: i32) -> u32 {
    if ((v.x | v.y) == 0u) {
        return 0u;
    }
    let s = clz64(v);
    let n = shl64(v, s);
    let h = (n.y >> 1u) | (n.y & 1u) | select(0u, 1u, n.x != 0u);
    return f_pack(0u, 190 - bitcast<i32>(s) - k, h);
}

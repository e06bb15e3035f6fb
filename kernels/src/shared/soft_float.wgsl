// IEEE 754 binary32 on bit patterns: sums, products, quotients and roots rounded to nearest, ties to even.
//
// WGSL's own f32 promises none of that. Subnormals and infinities are right in full; every NaN is 0x7fc00000. These
// cost 70 to 100 operations each: for set-up and for tests, not for inner loops.

import package::shared::wide::umul_wide;

const F_INF: u32 = 0x7f800000u;
const F_NAN: u32 = 0x7fc00000u;
const F_SIGN: u32 = 0x80000000u;

/// `sign` with the rounded magnitude of `sig * 2^(e - 157)`, for `sig` in [2^30, 2^31) whose bit 0 is set where
/// anything below it was lost.
fn f_pack(sign: u32, e: i32, sig: u32) -> u32 {
    let sh = bitcast<u32>(clamp(1 - e, 0, 31));
    let lost = sig & ~(0xffffffffu << sh);
    let s = (sig >> sh) | select(0u, 1u, lost != 0u);
    let r = (s + 63u + ((s >> 7u) & 1u)) >> 7u;
    let bits = ((bitcast<u32>(max(e, 1)) - 1u) << 23u) + r;
    return sign | select(bits, F_INF, e > 254);
}

/// Significand in [2^23, 2^24) and exponent (perhaps below 1, as i32) of a finite pattern that is not zero.
fn f_norm(a: u32) -> vec2<u32> {
    let f = (a >> 23u) & 255u;
    let m = a & 0x7fffffu;
    let z = countLeadingZeros(m) - 8u;
    return select(vec2<u32>(m | 0x800000u, f), vec2<u32>(m << z, 1u - z), f == 0u);
}

/// a + b.
fn rn_add(a: u32, b: u32) -> u32 {
    let swap = (b & 0x7fffffffu) > (a & 0x7fffffffu);
    let x = select(a, b, swap);
    let y = select(b, a, swap);
    let opposed = ((x ^ y) >> 31u) != 0u;
    let fx = (x >> 23u) & 255u;
    let fy = (y >> 23u) & 255u;
    if (fx == 255u) {
        let nan = ((x & 0x7fffffffu) > F_INF) | (((y & 0x7fffffffu) == F_INF) & opposed);
        return select(x, F_NAN, nan);
    }
    let ex = max(fx, 1u);
    let ey = max(fy, 1u);
    let mx = ((x & 0x7fffffu) | select(0x800000u, 0u, fx == 0u)) << 6u;
    let my = ((y & 0x7fffffu) | select(0x800000u, 0u, fy == 0u)) << 6u;
    let d = min(ex - ey, 31u);
    let ys = (my >> d) | select(0u, 1u, (my & ~(0xffffffffu << d)) != 0u);
    let s = select(mx + ys, mx - ys, opposed);
    if (s == 0u) {
        return select(x & F_SIGN, 0u, opposed);
    }
    let k = countLeadingZeros(s) - 1u;
    return f_pack(x & F_SIGN, bitcast<i32>(ex + 1u - k), s << k);
}

/// a * b.
fn rn_mul(a: u32, b: u32) -> u32 {
    let sign = (a ^ b) & F_SIGN;
    let ua = a & 0x7fffffffu;
    let ub = b & 0x7fffffffu;
    if (max(ua, ub) >= F_INF) {
        let nan = (max(ua, ub) > F_INF) | (min(ua, ub) == 0u);
        return select(sign | F_INF, F_NAN, nan);
    }
    if (min(ua, ub) == 0u) {
        return sign;
    }
    let na = f_norm(a);
    let nb = f_norm(b);
    let p = umul_wide(na.x << 8u, nb.x << 8u); // in [2^62, 2^64)
    let h = p.y | select(0u, 1u, p.x != 0u);
    let c = h >> 31u;
    return f_pack(sign, bitcast<i32>(na.y + nb.y - 127u + c), (h >> c) | (h & c));
}

/// a / b.
/// float: guess - 25 bits of the quotient within 16, then within 1; residuals correct both
fn rn_div(a: u32, b: u32) -> u32 {
    let sign = (a ^ b) & F_SIGN;
    let ua = a & 0x7fffffffu;
    let ub = b & 0x7fffffffu;
    if ((max(ua, ub) >= F_INF) | (min(ua, ub) == 0u)) {
        // Infinity by infinity and zero by zero have no value.
        let nan = (max(ua, ub) > F_INF) | (ua == ub);
        let infinite = (ua == F_INF) | (ub == 0u);
        return select(select(sign, sign | F_INF, infinite), F_NAN, nan);
    }
    let na = f_norm(a);
    let nb = f_norm(b);
    let less = select(0u, 1u, na.x < nb.x);
    let ma = na.x << less; // ma / mb in [1, 2)
    let mb = bitcast<i32>(nb.x);
    let inv = 1.0 / f32(nb.x);
    var q = u32(f32(ma) * inv * 16777216.0);
    var r = bitcast<i32>((ma << 24u) - q * nb.x); // |r| < 2^28
    let dq = i32(floor(f32(r) * inv));
    q += bitcast<u32>(dq);
    r -= dq * mb;
    let below = r < 0;
    let above = r >= mb;
    q = q - select(0u, 1u, below) + select(0u, 1u, above);
    r = r + select(0, mb, below) - select(0, mb, above);
    return f_pack(sign, bitcast<i32>(na.y - nb.y - less + 127u), (q << 6u) | select(0u, 1u, r != 0));
}

/// The square root of a. `inverseSqrt` may be off by 6 ULP; WGSL permits 2.
/// float: guess - 25 bits of the root within 16, then within 1; residuals correct both
fn rn_sqrt(a: u32) -> u32 {
    let ua = a & 0x7fffffffu;
    if (ua == 0u) {
        return a;
    }
    if (a >= F_INF) {
        return select(F_NAN, F_INF, a == F_INF);
    }
    let n = f_norm(a);
    let odd = (n.y & 1u) ^ 1u;
    let m = n.x << odd; // the value is m * 4^t, m in [2^23, 2^25)
    let f = f32(2u * m);
    let y = inverseSqrt(f);
    var s = u32(f * y * 4096.0); // sqrt(m * 2^25)
    var r = bitcast<i32>((m << 25u) - s * s); // |r| < 2^31
    let ds = i32(floor(f32(r) * y * 0.0001220703125)); // y / 8192 is about 1 / (2 s)
    r -= ds * (bitcast<i32>(2u * s) + ds);
    s += bitcast<u32>(ds);
    let below = r < 0;
    let above = r > bitcast<i32>(2u * s);
    r = r + select(0, bitcast<i32>(2u * s) - 1, below) - select(0, bitcast<i32>(2u * s) + 1, above);
    s = s - select(0u, 1u, below) + select(0u, 1u, above);
    let e = ((bitcast<i32>(n.y - odd) - 127) >> 1u) + 127;
    return f_pack(0u, e, (s << 6u) | select(0u, 1u, r != 0));
}

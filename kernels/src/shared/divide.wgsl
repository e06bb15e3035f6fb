// Quotients of 64-bit by 32-bit integers.
//
// The f32 quotient is a guess. Its products and one reciprocal have bounded relative errors, whichever way a device
// rounds, fuses or reassociates them, so the residual n - q * d is small; taken modulo 2^64 it is therefore exact, and
// exact comparisons turn the guess into the one q with 0 <= n - q * d < d. The division may be off by 32 ULP before
// that fails; WGSL permits 2.5.

import package::shared::wide::{abs64, shl64, sub64, umul_wide};

/// (floor(n / d), n mod d) for n.y < d, which implies d > 0 and a quotient below 2^32.
/// float: guess - the first quotient is off by less than 2^12, the second by 1; residuals correct both
fn udiv64_32(n: vec2<u32>, d: u32) -> vec2<u32> {
    let s = countLeadingZeros(d);
    let dn = d << s;
    let nn = shl64(n, s);
    let inv = 1.0 / f32(dn);
    // The bound is the largest f32 below 2^32.
    var q = u32(min(f32(nn.y) * inv * 4294967296.0, 4294967040.0));
    var r = sub64(nn, umul_wide(q, dn)); // |r| < 2^44
    let r16 = bitcast<i32>((r.y << 16u) | (r.x >> 16u));
    let dq = i32(floor(f32(r16) * inv * 65536.0)) - 1;
    q = select(q + bitcast<u32>(dq), 0u, (dq < 0) & (q < bitcast<u32>(0 - dq)));
    r = sub64(nn, umul_wide(q, dn)); // 0 <= r < 3 dn
    var up = (r.y != 0u) | (r.x >= dn);
    q += select(0u, 1u, up);
    r = select(r, sub64(r, vec2<u32>(dn, 0u)), up);
    up = (r.y != 0u) | (r.x >= dn);
    q += select(0u, 1u, up);
    return vec2<u32>(q, select(r.x, r.x - dn, up) >> s);
}

/// The same as `udiv64_32` without f32: two digits of 16 bits by Knuth's algorithm D.
fn udiv64_32i(n: vec2<u32>, d: u32) -> vec2<u32> {
    let s = countLeadingZeros(d);
    let dn = d << s;
    let nn = shl64(n, s);
    let dh = dn >> 16u;
    let dl = dn & 0xffffu;
    let n1 = nn.x >> 16u;
    let n0 = nn.x & 0xffffu;
    var q1 = nn.y / dh;
    var r1 = nn.y - q1 * dh;
    var over = (q1 > 0xffffu) | (q1 * dl > ((r1 << 16u) | n1));
    q1 -= select(0u, 1u, over);
    r1 += select(0u, dh, over);
    over = (r1 <= 0xffffu) & ((q1 > 0xffffu) | (q1 * dl > ((r1 << 16u) | n1)));
    q1 -= select(0u, 1u, over);
    let m = ((nn.y << 16u) | n1) - q1 * dn; // < dn
    var q0 = m / dh;
    var r0 = m - q0 * dh;
    over = (q0 > 0xffffu) | (q0 * dl > ((r0 << 16u) | n0));
    q0 -= select(0u, 1u, over);
    r0 += select(0u, dh, over);
    over = (r0 <= 0xffffu) & ((q0 > 0xffffu) | (q0 * dl > ((r0 << 16u) | n0)));
    q0 -= select(0u, 1u, over);
    return vec2<u32>((q1 << 16u) | q0, (((m << 16u) | n0) - q0 * dn) >> s);
}

/// floor(n / d) of a signed n, d > 0, clamped to [-2^31, 2^31).
fn fdiv64_sat(n: vec2<u32>, d: u32) -> i32 {
    let negative = (n.y >> 31u) != 0u;
    let least_or_most = bitcast<i32>(0x7fffffffu + select(0u, 1u, negative));
    let a = abs64(n);
    if (a.y >= d) {
        return least_or_most;
    }
    let qr = udiv64_32(a, d);
    let q = qr.x + select(0u, 1u, negative & (qr.y != 0u));
    let most = select(0x7fffffffu, 0x80000000u, negative);
    let clamped = (q > most) | (q < qr.x);
    return select(bitcast<i32>(select(q, 0u - q, negative)), least_or_most, clamped);
}

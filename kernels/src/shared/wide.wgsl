// 64-bit integers as vec2<u32>(low, high), two's complement: sums, products, shifts, comparisons.
//
// WGSL core has no 64-bit type. Everything here is integer arithmetic that WGSL defines completely, so the results are
// the same on every device. All sums are modulo 2^64.

/// floor(a * b / 2^32), from four products of 16-bit halves; no partial sum exceeds 2^32 - 1.
fn umul_hi(a: u32, b: u32) -> u32 {
    let al = a & 0xffffu;
    let ah = a >> 16u;
    let bl = b & 0xffffu;
    let bh = b >> 16u;
    let t = ah * bl + ((al * bl) >> 16u);
    let u = al * bh + (t & 0xffffu);
    return ah * bh + (t >> 16u) + (u >> 16u);
}

/// a * b, exact.
fn umul_wide(a: u32, b: u32) -> vec2<u32> {
    return vec2<u32>(a * b, umul_hi(a, b));
}

/// a * b, exact and signed.
fn imul_wide(a: i32, b: i32) -> vec2<u32> {
    let ua = bitcast<u32>(a);
    let ub = bitcast<u32>(b);
    let high = umul_hi(ua, ub) - select(0u, ub, a < 0) - select(0u, ua, b < 0);
    return vec2<u32>(ua * ub, high);
}

/// a + b modulo 2^64.
fn add64(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let low = a.x + b.x;
    return vec2<u32>(low, a.y + b.y + select(0u, 1u, low < a.x));
}

/// a - b modulo 2^64.
fn sub64(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(a.x - b.x, a.y - b.y - select(0u, 1u, a.x < b.x));
}

/// -a modulo 2^64.
fn neg64(a: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(0u - a.x, 0u - a.y - select(0u, 1u, a.x != 0u));
}

/// |a| of a signed a, as unsigned: right for -2^63 too.
fn abs64(a: vec2<u32>) -> vec2<u32> {
    return select(a, neg64(a), (a.y >> 31u) != 0u);
}

/// Whether a < b, both unsigned.
fn ltu64(a: vec2<u32>, b: vec2<u32>) -> bool {
    return (a.y < b.y) | ((a.y == b.y) & (a.x < b.x));
}

/// Sign of a signed a: -1, 0 or 1.
fn sgn64(a: vec2<u32>) -> i32 {
    return select(select(1, 0, (a.x | a.y) == 0u), -1, (a.y >> 31u) != 0u);
}

/// a . b modulo 2^64.
fn dot64(a: vec3<i32>, b: vec3<i32>) -> vec2<u32> {
    return add64(add64(imul_wide(a.x, b.x), imul_wide(a.y, b.y)), imul_wide(a.z, b.z));
}

/// |v| as unsigned: right for -2^31 too.
fn uabs(v: i32) -> u32 {
    let u = bitcast<u32>(v);
    return select(u, 0u - u, v < 0);
}

/// a * 2^s modulo 2^64, 0 <= s <= 63.
fn shl64(a: vec2<u32>, s: u32) -> vec2<u32> {
    let k = s & 31u;
    let r = vec2<u32>(a.x << k, (a.y << k) | ((a.x >> 1u) >> (31u - k)));
    return select(r, vec2<u32>(0u, r.x), s > 31u);
}

/// floor(a / 2^s) of an unsigned a, 0 <= s <= 63.
fn shr64(a: vec2<u32>, s: u32) -> vec2<u32> {
    let k = s & 31u;
    let r = vec2<u32>((a.x >> k) | ((a.y << 1u) << (31u - k)), a.y >> k);
    return select(r, vec2<u32>(r.y, 0u), s > 31u);
}

/// Zero bits above the highest set bit; 64 for 0.
fn clz64(a: vec2<u32>) -> u32 {
    return select(countLeadingZeros(a.y), 32u + countLeadingZeros(a.x), a.y == 0u);
}

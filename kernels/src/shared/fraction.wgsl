// Binary fractions: the first bits of a quotient that is at most 1.

/// (floor(n * 2^k / d), n * 2^k mod d) for n <= d, 1 <= d <= 2^30, k <= 20.
///
/// The guess is off by less than 1, so the residual is above -2^31 and below 2^31: exact modulo 2^32. The division may
/// be off by 6 ULP for k = 20, and by 128 for k <= 15, before that fails; WGSL permits 2.5.
/// float: guess - off by less than 1, which the sign of the residual corrects
fn ufrac(n: u32, d: u32, k: u32) -> vec2<u32> {
    let q = u32(f32(n) / f32(d) * f32(1u << k));
    let r = bitcast<i32>((n << k) - q * d);
    let below = r < 0;
    let above = r >= bitcast<i32>(d);
    let exact_q = q - select(0u, 1u, below) + select(0u, 1u, above);
    let exact_r = bitcast<u32>(r) + select(0u, d, below) - select(0u, d, above);
    return vec2<u32>(exact_q, exact_r);
}

//! IEEE binary32 on bit patterns, by the host's own arithmetic: Rust's f32 and f64 round to nearest even.
//!
//! Every NaN is 0x7fc00000.

fn pattern(x: f32) -> u32 {
    if x.is_nan() { 0x7fc0_0000 } else { x.to_bits() }
}

/// a + b.
pub fn rn_add(a: u32, b: u32) -> u32 {
    pattern(f32::from_bits(a) + f32::from_bits(b))
}

/// a * b.
pub fn rn_mul(a: u32, b: u32) -> u32 {
    pattern(f32::from_bits(a) * f32::from_bits(b))
}

/// a / b.
pub fn rn_div(a: u32, b: u32) -> u32 {
    pattern(f32::from_bits(a) / f32::from_bits(b))
}

/// The square root of a.
pub fn rn_sqrt(a: u32) -> u32 {
    pattern(f32::from_bits(a).sqrt())
}

/// 2^k, exact for |k| <= 1022.
fn power(k: i32) -> f64 {
    f64::from_bits(((k + 1023) as u64) << 52)
}

/// floor(x 2^k), clamped to i32; 0 for NaN. The product is exact in f64.
pub fn f_to_fix(x: u32, k: i32) -> i32 {
    (f64::from(f32::from_bits(x)) * power(k)).floor() as i32
}

/// v / 2^k, rounded once: f64 holds the quotient.
pub fn fix_to_f(v: i32, k: i32) -> u32 {
    pattern((f64::from(v) * power(-k)) as f32)
}

/// v / 2^k, rounded once: the conversion rounds, and no quotient is subnormal.
pub fn u64_to_f(v: u64, k: i32) -> u32 {
    pattern((f64::from(v as f32) * power(-k)) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_patterns() {
        assert_eq!(rn_add(0x3f80_0000, 0x3380_0000), 0x3f80_0000, "1 + 2^-24 is a tie, and 1 is even");
        assert_eq!(rn_add(0x3f80_0001, 0x3380_0000), 0x3f80_0002);
        assert_eq!(rn_mul(0x0080_0000, 0x3f00_0000), 0x0040_0000, "subnormals are kept");
        assert_eq!(rn_div(0, 0), 0x7fc0_0000);
        assert_eq!(rn_sqrt(0x8000_0000), 0x8000_0000);
        assert_eq!(rn_sqrt(0xbf80_0000), 0x7fc0_0000);
        assert_eq!(f_to_fix(0xbf00_0000, 0), -1, "the floor of -1/2");
        assert_eq!(f_to_fix(0x7f80_0000, -64), i32::MAX);
        assert_eq!(f_to_fix(0x7fc0_0000, 0), 0);
        assert_eq!(fix_to_f(-3, 1), 0xbfc0_0000);
        assert_eq!(u64_to_f(u64::MAX, 64), 0x3f80_0000);
        assert_eq!(u64_to_f(1 << 63, -65), 0x7f80_0000);
    }
}

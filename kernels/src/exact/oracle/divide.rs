//! Quotients and roots of wide integers.

/// (floor(n / d), n mod d) where the quotient has 32 bits.
pub fn udiv64_32(n: u64, d: u32) -> (u32, u32) {
    let d = u64::from(d);
    ((n / d) as u32, (n % d) as u32)
}

/// floor(n / d), clamped to i32.
pub fn fdiv64_sat(n: i64, d: u32) -> i32 {
    n.div_euclid(i64::from(d)).clamp(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
}

/// (floor(n 2^k / d), n 2^k mod d).
pub fn ufrac(n: u32, d: u32, k: u32) -> (u32, u32) {
    udiv64_32(u64::from(n) << k, d)
}

/// floor(sqrt(n)).
pub fn isqrt32(n: u32) -> u32 {
    n.isqrt()
}

/// floor(sqrt(n)).
pub fn isqrt64(n: u64) -> u32 {
    n.isqrt() as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floors_and_limits() {
        assert_eq!(fdiv64_sat(-7, 2), -4);
        assert_eq!(fdiv64_sat(-8, 2), -4);
        assert_eq!(fdiv64_sat(i64::MIN, 1), i32::MIN);
        assert_eq!(fdiv64_sat(i64::MAX, u32::MAX), i32::MAX);
        assert_eq!(fdiv64_sat(-(1 << 31), 1), i32::MIN);
        assert_eq!(udiv64_32(u64::from(u32::MAX - 1) << 32 | 5, u32::MAX), (u32::MAX, 4));
        assert_eq!(ufrac(1, 3, 20), (349_525, 1));
        assert_eq!((isqrt32(u32::MAX), isqrt64(u64::MAX)), (65_535, u32::MAX));
    }
}

//! Scalar i32 and u32: everything WGSL defines beyond Rust's wrapping operators.
//!
//! Functions that only look at bits take u32 and serve i32 through `as`. Invariant: total, as WGSL demands at run time.

/// `x / y` of i32: truncates; y = 0 and i32::MIN / −1 give x.
#[must_use]
pub fn div_i32(x: i32, y: i32) -> i32 {
    x.checked_div(y).unwrap_or(x)
}

/// `x / y` of u32: y = 0 gives x.
#[must_use]
pub fn div_u32(x: u32, y: u32) -> u32 {
    x.checked_div(y).unwrap_or(x)
}

/// `x % y` of i32: has the sign of x; y = 0 and i32::MIN % −1 give 0.
#[must_use]
pub fn rem_i32(x: i32, y: i32) -> i32 {
    x.checked_rem(y).unwrap_or(0)
}

/// `x % y` of u32: y = 0 gives 0.
#[must_use]
pub fn rem_u32(x: u32, y: u32) -> u32 {
    x.checked_rem(y).unwrap_or(0)
}

/// `x << y` of i32 and u32: the amount is taken modulo 32.
#[must_use]
pub fn shl(x: u32, y: u32) -> u32 {
    x.wrapping_shl(y)
}

/// `x >> y` of u32: zeros come in; the amount is taken modulo 32.
#[must_use]
pub fn shr_u32(x: u32, y: u32) -> u32 {
    x.wrapping_shr(y)
}

/// `x >> y` of i32: copies of the sign come in; the amount is taken modulo 32.
#[must_use]
pub fn shr_i32(x: i32, y: u32) -> i32 {
    x.wrapping_shr(y)
}

/// `abs(x)` of i32: i32::MIN gives itself.
#[must_use]
pub fn abs_i32(x: i32) -> i32 {
    x.wrapping_abs()
}

/// `sign(x)` of i32: −1, 0 or 1.
#[must_use]
pub fn sign_i32(x: i32) -> i32 {
    x.signum()
}

/// `clamp(x, low, high)` of i32: `min(max(x, low), high)`, also where low > high.
#[must_use]
pub fn clamp_i32(x: i32, low: i32, high: i32) -> i32 {
    x.max(low).min(high)
}

/// `clamp(x, low, high)` of u32: `min(max(x, low), high)`, also where low > high.
#[must_use]
pub fn clamp_u32(x: u32, low: u32, high: u32) -> u32 {
    x.max(low).min(high)
}

/// `countOneBits(x)`.
#[must_use]
pub fn count_one_bits(x: u32) -> u32 {
    x.count_ones()
}

/// `countLeadingZeros(x)`: 32 for 0.
#[must_use]
pub fn count_leading_zeros(x: u32) -> u32 {
    x.leading_zeros()
}

/// `countTrailingZeros(x)`: 32 for 0.
#[must_use]
pub fn count_trailing_zeros(x: u32) -> u32 {
    x.trailing_zeros()
}

/// `reverseBits(x)`.
#[must_use]
pub fn reverse_bits(x: u32) -> u32 {
    x.reverse_bits()
}

/// `firstTrailingBit(x)`: position of the lowest 1; all ones (−1 as i32) for 0.
#[must_use]
pub fn first_trailing_bit(x: u32) -> u32 {
    if x == 0 { u32::MAX } else { x.trailing_zeros() }
}

/// `firstLeadingBit(x)` of u32: position of the highest 1; all ones for 0.
#[must_use]
pub fn first_leading_bit_u32(x: u32) -> u32 {
    31u32.wrapping_sub(x.leading_zeros())
}

/// `firstLeadingBit(x)` of i32: position of the highest bit that differs from the sign; −1 for 0 and −1.
#[must_use]
pub fn first_leading_bit_i32(x: i32) -> i32 {
    first_leading_bit_u32((x ^ x >> 31) as u32) as i32
}

/// Offset and count of a bit field, clamped as WGSL does: `min(offset, 32)` and `min(count, 32 - offset)`.
fn field(offset: u32, count: u32) -> (u32, u32) {
    let offset = offset.min(32);
    (offset, count.min(32 - offset))
}

/// `extractBits(e, offset, count)` of u32: the field, zero-extended; an empty field gives 0.
#[must_use]
pub fn extract_bits_u32(e: u32, offset: u32, count: u32) -> u32 {
    match field(offset, count) {
        (_, 0) => 0,
        (offset, count) => e << (32 - offset - count) >> (32 - count),
    }
}

/// `extractBits(e, offset, count)` of i32: the field, sign-extended; an empty field gives 0.
#[must_use]
pub fn extract_bits_i32(e: i32, offset: u32, count: u32) -> i32 {
    match field(offset, count) {
        (_, 0) => 0,
        (offset, count) => e << (32 - offset - count) >> (32 - count),
    }
}

/// `insertBits(e, new, offset, count)`: e with the field replaced by the low bits of `new`; an empty field gives e.
#[must_use]
pub fn insert_bits(e: u32, new: u32, offset: u32, count: u32) -> u32 {
    match field(offset, count) {
        (_, 0) => e,
        (offset, count) => {
            let mask = u32::MAX >> (32 - count) << offset;
            e & !mask | new << offset & mask
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn division_is_total() {
        assert_eq!([div_i32(7, 0), div_i32(i32::MIN, -1), div_i32(-7, 2)], [7, i32::MIN, -3]);
        assert_eq!([rem_i32(7, 0), rem_i32(i32::MIN, -1), rem_i32(-7, 2)], [0, 0, -1]);
        assert_eq!([div_u32(7, 0), rem_u32(7, 0), div_u32(u32::MAX, 2), rem_u32(9, 5)], [7, 0, 0x7fff_ffff, 4]);
    }

    #[test]
    fn shifts_are_modulo_32() {
        assert_eq!([shl(1, 33), shr_u32(0x8000_0000, 63), shl(3, 31)], [2, 1, 0x8000_0000]);
        assert_eq!([shr_i32(-8, 1), shr_i32(-8, 32), shr_i32(-8, 35)], [-4, -8, -1]);
    }

    #[test]
    fn leading_and_trailing_bits() {
        assert_eq!(
            [first_leading_bit_u32(0), first_leading_bit_u32(1), first_leading_bit_u32(u32::MAX)],
            [u32::MAX, 0, 31]
        );
        assert_eq!([0, -1, 1, -2, i32::MIN, i32::MAX].map(first_leading_bit_i32), [-1, -1, 0, 0, 30, 30]);
        assert_eq!([0, 1, 0x8000_0000].map(first_trailing_bit), [u32::MAX, 0, 31]);
        assert_eq!([count_leading_zeros(0), count_trailing_zeros(0), count_one_bits(u32::MAX)], [32; 3]);
        assert_eq!(reverse_bits(0x1234_5678), 0x1e6a_2c48);
        assert_eq!([abs_i32(i32::MIN), abs_i32(-3), sign_i32(-3), sign_i32(0)], [i32::MIN, 3, -1, 0]);
    }

    #[test]
    fn bit_fields_are_clamped() {
        assert_eq!(extract_bits_u32(0xf0e1_d2c3, 4, 8), 0x2c);
        assert_eq!(extract_bits_i32(0xf0e1_d2c3u32 as i32, 4, 6), -20);
        assert_eq!(extract_bits_u32(0xf0e1_d2c3, 28, 99), 0xf);
        assert_eq!(extract_bits_i32(i32::MIN, 31, 1), -1);
        assert_eq!([extract_bits_u32(7, 32, 4), extract_bits_u32(7, u32::MAX, u32::MAX)], [0; 2]);
        assert_eq!([extract_bits_u32(7, 0, 0), extract_bits_u32(u32::MAX, 0, 32)], [0, u32::MAX]);
        assert_eq!(insert_bits(0xffff_ffff, 0, 8, 8), 0xffff_00ff);
        assert_eq!(insert_bits(0, 0xabcd, 24, 40), 0xcd00_0000);
        assert_eq!([insert_bits(5, 9, 0, 32), insert_bits(5, 9, 40, 3), insert_bits(5, 9, 3, 0)], [9, 5, 5]);
    }

    #[test]
    fn clamp_with_crossed_limits_gives_high() {
        assert_eq!([clamp_i32(0, 5, -5), clamp_i32(-9, -5, 5)], [-5, -5]);
        assert_eq!([clamp_u32(3, 5, 1), clamp_u32(9, 2, 5)], [1, 5]);
    }
}

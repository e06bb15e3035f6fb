//! Packing, unpacking and f16 rounding.
//!
//! The normalised formats follow WGSL's formulas `⌊0.5 + 127·e⌋` … over the reals: they are evaluated in binary64,
//! where the product is exact and the sum cannot round across an integer. Component 0 is in the lowest bits.

use super::clamp_f32;

/// f32 to the bits of the nearest f16, ties to even; overflow gives ±∞, NaN the quiet NaN 0x7e00.
#[must_use]
pub fn f32_to_f16_bits(x: f32) -> u16 {
    if x.is_nan() {
        return 0x7e00;
    }
    let sign = (x.to_bits() >> 16 & 0x8000) as u16;
    let magnitude = x.abs();
    if magnitude >= 65520.0 {
        return sign | 0x7c00;
    }
    if magnitude < f32::from_bits(0x3880_0000) {
        // Below 2^-14 the f16 are the multiples of 2^-24: scaling is exact and one rounding remains.
        return sign | (magnitude * 16_777_216.0).round_ties_even() as u16;
    }
    // The exponent is rebiased from 127 to 15; a carry out of the mantissa moves into it, as it should.
    let bits = magnitude.to_bits() - (112 << 23);
    let half = 0xfff + (bits >> 13 & 1);
    sign | ((bits + half) >> 13) as u16
}

/// The value of f16 bits, exact; NaN keeps its payload's upper bits.
#[must_use]
pub fn f16_bits_to_f32(bits: u16) -> f32 {
    let sign = u32::from(bits & 0x8000) << 16;
    let (exponent, mantissa) = (u32::from(bits >> 10 & 0x1f), u32::from(bits & 0x3ff));
    let magnitude = match exponent {
        0 => (mantissa as f32 * f32::from_bits(0x3380_0000)).to_bits(),
        31 => 0x7f80_0000 | mantissa << 13,
        _ => (exponent + 112) << 23 | mantissa << 13,
    };
    f32::from_bits(sign | magnitude)
}

/// `quantizeToF16(x)`: the nearest f16, ties to even; overflow gives ±∞ (WGSL leaves it open).
#[must_use]
pub fn quantize_to_f16(x: f32) -> f32 {
    f16_bits_to_f32(f32_to_f16_bits(x))
}

/// ⌊0.5 + scale·clamp(e, low, 1)⌋ over the reals; NaN counts as low.
fn normalise(e: f32, low: f32, scale: f64) -> i32 {
    (0.5 + scale * f64::from(clamp_f32(e, low, 1.0))).floor() as i32
}

/// The fields in one word, component 0 lowest; only the low `32 / N` bits of each count.
fn join<const N: usize>(fields: [u32; N]) -> u32 {
    let width = 32 / N as u32;
    let mask = u32::MAX >> (32 - width);
    fields.iter().rev().fold(0, |word, field| word.wrapping_shl(width) | field & mask)
}

fn bytes(x: u32) -> [u8; 4] {
    x.to_le_bytes()
}

fn halves(x: u32) -> [u16; 2] {
    [x as u16, (x >> 16) as u16]
}

/// `pack4x8snorm(e)`: `⌊0.5 + 127·clamp(e, −1, 1)⌋` in each byte; NaN packs as −127.
#[must_use]
pub fn pack4x8_snorm(e: [f32; 4]) -> u32 {
    join(e.map(|e| normalise(e, -1.0, 127.0) as u32))
}

/// `pack4x8unorm(e)`: `⌊0.5 + 255·clamp(e, 0, 1)⌋` in each byte; NaN packs as 0.
#[must_use]
pub fn pack4x8_unorm(e: [f32; 4]) -> u32 {
    join(e.map(|e| normalise(e, 0.0, 255.0) as u32))
}

/// `pack2x16snorm(e)`: `⌊0.5 + 32767·clamp(e, −1, 1)⌋` in each half; NaN packs as −32767.
#[must_use]
pub fn pack2x16_snorm(e: [f32; 2]) -> u32 {
    join(e.map(|e| normalise(e, -1.0, 32767.0) as u32))
}

/// `pack2x16unorm(e)`: `⌊0.5 + 65535·clamp(e, 0, 1)⌋` in each half; NaN packs as 0.
#[must_use]
pub fn pack2x16_unorm(e: [f32; 2]) -> u32 {
    join(e.map(|e| normalise(e, 0.0, 65535.0) as u32))
}

/// `pack2x16float(e)`: [`f32_to_f16_bits`] in each half.
#[must_use]
pub fn pack2x16_float(e: [f32; 2]) -> u32 {
    join(e.map(|e| u32::from(f32_to_f16_bits(e))))
}

/// `pack4xI8(e)`, and `pack4xU8` on the bits: the low byte of each component.
#[must_use]
pub fn pack4x_8(e: [u32; 4]) -> u32 {
    join(e)
}

/// `pack4xI8Clamp(e)`: each component clamped to [−128, 127].
#[must_use]
pub fn pack4x_i8_clamp(e: [i32; 4]) -> u32 {
    join(e.map(|e| e.clamp(-128, 127) as u32))
}

/// `pack4xU8Clamp(e)`: each component clamped to [0, 255].
#[must_use]
pub fn pack4x_u8_clamp(e: [u32; 4]) -> u32 {
    join(e.map(|e| e.min(255)))
}

/// `unpack4x8snorm(x)`: `max(v / 127, −1)` of each byte, one rounding.
#[must_use]
pub fn unpack4x8_snorm(x: u32) -> [f32; 4] {
    bytes(x).map(|v| (f32::from(v as i8) / 127.0).max(-1.0))
}

/// `unpack4x8unorm(x)`: `v / 255` of each byte, one rounding.
#[must_use]
pub fn unpack4x8_unorm(x: u32) -> [f32; 4] {
    bytes(x).map(|v| f32::from(v) / 255.0)
}

/// `unpack2x16snorm(x)`: `max(v / 32767, −1)` of each half, one rounding.
#[must_use]
pub fn unpack2x16_snorm(x: u32) -> [f32; 2] {
    halves(x).map(|v| (f32::from(v as i16) / 32767.0).max(-1.0))
}

/// `unpack2x16unorm(x)`: `v / 65535` of each half, one rounding.
#[must_use]
pub fn unpack2x16_unorm(x: u32) -> [f32; 2] {
    halves(x).map(|v| f32::from(v) / 65535.0)
}

/// `unpack2x16float(x)`: [`f16_bits_to_f32`] of each half.
#[must_use]
pub fn unpack2x16_float(x: u32) -> [f32; 2] {
    halves(x).map(f16_bits_to_f32)
}

/// `unpack4xI8(x)`: each byte sign-extended.
#[must_use]
pub fn unpack4x_i8(x: u32) -> [i32; 4] {
    bytes(x).map(|v| i32::from(v as i8))
}

/// `unpack4xU8(x)`: each byte zero-extended.
#[must_use]
pub fn unpack4x_u8(x: u32) -> [u32; 4] {
    bytes(x).map(u32::from)
}

/// `dot4I8Packed(x, y)`: the sum of the products of signed bytes; it cannot overflow.
#[must_use]
pub fn dot4_i8_packed(x: u32, y: u32) -> i32 {
    unpack4x_i8(x).iter().zip(unpack4x_i8(y)).map(|(a, b)| a * b).sum()
}

/// `dot4U8Packed(x, y)`: the sum of the products of unsigned bytes; it cannot overflow.
#[must_use]
pub fn dot4_u8_packed(x: u32, y: u32) -> u32 {
    unpack4x_u8(x).iter().zip(unpack4x_u8(y)).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::NAN;

    #[test]
    fn every_f16_survives_and_every_midpoint_goes_to_even() {
        for bits in 0..0x7c00u16 {
            let (low, high) = (f16_bits_to_f32(bits), f16_bits_to_f32(bits + 1).min(65536.0));
            assert_eq!([f32_to_f16_bits(low), f32_to_f16_bits(-low)], [bits, bits | 0x8000]);
            let middle = low + (high - low) * 0.5;
            assert_eq!(f32_to_f16_bits(middle), bits + (bits & 1), "{bits:#x}");
            assert_eq!(f32_to_f16_bits(middle.next_down()), bits);
            assert_eq!(f32_to_f16_bits(middle.next_up()), bits + 1);
        }
    }

    #[test]
    fn f16_of_known_values() {
        assert_eq!(f16_bits_to_f32(0x3555), 0.333_251_95);
        assert_eq!(f16_bits_to_f32(1), f32::from_bits(0x3380_0000));
        assert_eq!(f16_bits_to_f32(0xfbff), -65504.0);
        assert_eq!([f32_to_f16_bits(65519.0), f32_to_f16_bits(65520.0)], [0x7bff, 0x7c00]);
        assert_eq!([f32_to_f16_bits(NAN), f32_to_f16_bits(f32::NEG_INFINITY)], [0x7e00, 0xfc00]);
        assert_eq!([quantize_to_f16(1.0 / 3.0), quantize_to_f16(1e-9)], [0.333_251_95, 0.0]);
    }

    #[test]
    fn normalised_formats() {
        assert_eq!(pack4x8_snorm([1.0, -1.0, 0.0, 0.5]), 0x4000_817f);
        assert_eq!(pack4x8_unorm([0.0, 1.0, 0.5, 2.0]), 0xff80_ff00);
        assert_eq!(pack2x16_snorm([-1.0, 1.0]), 0x7fff_8001);
        assert_eq!(pack2x16_unorm([0.5, NAN]), 0x0000_8000);
        assert_eq!(pack4x8_snorm([NAN, -0.5, 9.0, -9.0]), 0x817f_c181);
        assert_eq!(unpack4x8_snorm(0x8081_7f00), [0.0, 1.0, -1.0, -1.0]);
        assert_eq!(unpack4x8_unorm(0x00ff_0033), [0.2, 0.0, 1.0, 0.0]);
        assert_eq!(unpack2x16_snorm(0x8000_7fff), [1.0, -1.0]);
        assert_eq!(unpack2x16_unorm(0xffff_0000), [0.0, 1.0]);
        assert_eq!(pack2x16_float([1.0, -2.0]), 0xc000_3c00);
        assert_eq!(unpack2x16_float(0xc000_3c00), [1.0, -2.0]);
    }

    #[test]
    fn the_formula_is_over_the_reals() {
        // Below one half by less than an ULP of 0.5: in f32 the sum would round up to 1.
        let below = f32::from_bits(0x3b00_8080);
        assert!(255.0 * f64::from(below) < 0.5);
        assert_eq!(pack4x8_unorm([below; 4]), 0);
    }

    #[test]
    fn unpacked_and_packed_again() {
        for x in [0, 0x8000_7fff, 0x1234_fedc, u32::MAX] {
            assert_eq!(pack4x8_unorm(unpack4x8_unorm(x)), x);
            assert_eq!(pack2x16_unorm(unpack2x16_unorm(x)), x);
            assert_eq!(pack4x_u8_clamp(unpack4x_u8(x)), x);
            assert_eq!(pack4x_i8_clamp(unpack4x_i8(x)), x);
            assert_eq!(pack4x_8(unpack4x_i8(x).map(|v| v as u32)), x);
        }
    }

    #[test]
    fn packed_bytes() {
        assert_eq!(pack4x_8([0x101, 0xff02, 3, 4]), 0x0403_0201);
        assert_eq!(pack4x_i8_clamp([-1000, 1000, -1, 0]), 0x00ff_7f80);
        assert_eq!(pack4x_u8_clamp([256, 255, 7, u32::MAX]), 0xff07_ffff);
        assert_eq!(dot4_i8_packed(0x80ff_0102, 0x7f01_0203), -128 * 127 - 1 + 2 + 6);
        assert_eq!(dot4_u8_packed(u32::MAX, u32::MAX), 4 * 255 * 255);
    }
}

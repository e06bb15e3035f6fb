//! What every operation means, on one word: the single definition that folding, scalar registers and the rare vector
//! operations share, and that the SIMD forms of the common ones are tested against.
//!
//! All operations are total. Arithmetic of f32 is IEEE 754 binary32, round to nearest even, subnormals kept, never
//! fused unless the text says `fma`; what IEEE does not fix is pinned in [`crate::math`].

use std::cmp::Ordering;

use crate::code::{AtomicOp, BinOp, Compare, TernOp, UnOp};
#[cfg(test)]
use crate::code::{Pair, QuadOp};
use crate::math;

fn truth(condition: bool) -> u32 {
    if condition { u32::MAX } else { 0 }
}

fn f(word: u32) -> f32 {
    f32::from_bits(word)
}

/// The value of a unary operation.
pub(crate) fn unary(op: UnOp, a: u32) -> u32 {
    let float = |g: fn(f32) -> f32| g(f(a)).to_bits();
    match op {
        UnOp::Move => a,
        UnOp::Not => !a,
        UnOp::NegI => a.wrapping_neg(),
        UnOp::AbsI => (a as i32).wrapping_abs() as u32,
        UnOp::SignI => (a as i32).signum() as u32,
        UnOp::NegF => a ^ 0x8000_0000,
        UnOp::AbsF => a & 0x7fff_ffff,
        UnOp::SignF => float(math::sign_f32),
        UnOp::Floor => float(math::floor),
        UnOp::Ceil => float(math::ceil),
        UnOp::Trunc => float(math::trunc),
        UnOp::Round => float(math::round),
        UnOp::Sqrt => float(f32::sqrt),
        UnOp::InverseSqrt => float(math::inverse_sqrt),
        UnOp::FloatToInt => math::f32_to_i32(f(a)) as u32,
        UnOp::FloatToUint => math::f32_to_u32(f(a)),
        UnOp::IntToFloat => (a as i32 as f32).to_bits(),
        UnOp::UintToFloat => (a as f32).to_bits(),
        UnOp::CountOneBits => a.count_ones(),
        UnOp::CountLeadingZeros => a.leading_zeros(),
        UnOp::CountTrailingZeros => a.trailing_zeros(),
        UnOp::ReverseBits => a.reverse_bits(),
        UnOp::FirstLeadingBitI => first_leading_bit(if (a as i32) < 0 { !a } else { a }),
        UnOp::FirstLeadingBitU => first_leading_bit(a),
        UnOp::FirstTrailingBit => {
            if a == 0 {
                u32::MAX
            } else {
                a.trailing_zeros()
            }
        }
        UnOp::Sin => float(math::sin),
        UnOp::Cos => float(math::cos),
        UnOp::Tan => float(math::tan),
        UnOp::Asin => float(math::asin),
        UnOp::Acos => float(math::acos),
        UnOp::Atan => float(math::atan),
        UnOp::Sinh => float(math::sinh),
        UnOp::Cosh => float(math::cosh),
        UnOp::Tanh => float(math::tanh),
        UnOp::Asinh => float(math::asinh),
        UnOp::Acosh => float(math::acosh),
        UnOp::Atanh => float(math::atanh),
        UnOp::Exp => float(math::exp),
        UnOp::Exp2 => float(math::exp2),
        UnOp::Log => float(math::log),
        UnOp::Log2 => float(math::log2),
        UnOp::QuantizeToF16 => float(math::quantize_to_f16),
        UnOp::PackHalf => u32::from(math::f32_to_f16_bits(f(a))),
        UnOp::UnpackHalf => math::f16_bits_to_f32(a as u16).to_bits(),
        UnOp::PackSnorm8 => math::pack4x8_snorm([f(a), 0.0, 0.0, 0.0]) & 0xff,
        UnOp::PackUnorm8 => math::pack4x8_unorm([f(a), 0.0, 0.0, 0.0]) & 0xff,
        UnOp::PackSnorm16 => math::pack2x16_snorm([f(a), 0.0]) & 0xffff,
        UnOp::PackUnorm16 => math::pack2x16_unorm([f(a), 0.0]) & 0xffff,
        UnOp::FrexpFraction => math::frexp(f(a)).0.to_bits(),
        UnOp::FrexpExponent => math::frexp(f(a)).1 as u32,
    }
}

fn first_leading_bit(a: u32) -> u32 {
    31u32.wrapping_sub(a.leading_zeros())
}

/// The value of a binary operation.
pub(crate) fn binary(op: BinOp, a: u32, b: u32) -> u32 {
    let (ia, ib) = (a as i32, b as i32);
    let (fa, fb) = (f(a), f(b));
    match op {
        BinOp::Add => a.wrapping_add(b),
        BinOp::Sub => a.wrapping_sub(b),
        BinOp::Mul => a.wrapping_mul(b),
        BinOp::MulHigh => ((u64::from(a) * u64::from(b)) >> 32) as u32,
        BinOp::MulHighI => ((i64::from(ia) * i64::from(ib)) >> 32) as u32,
        BinOp::And => a & b,
        BinOp::Or => a | b,
        BinOp::Xor => a ^ b,
        BinOp::Shl => a.wrapping_shl(b),
        BinOp::ShrU => a.wrapping_shr(b),
        BinOp::ShrI => ia.wrapping_shr(b) as u32,
        BinOp::DivU => math::div_u32(a, b),
        BinOp::DivI => math::div_i32(ia, ib) as u32,
        BinOp::RemU => math::rem_u32(a, b),
        BinOp::RemI => math::rem_i32(ia, ib) as u32,
        BinOp::MinU => a.min(b),
        BinOp::MaxU => a.max(b),
        BinOp::MinI => ia.min(ib) as u32,
        BinOp::MaxI => ia.max(ib) as u32,
        BinOp::Eq => truth(compare(Compare::Eq, a, b)),
        BinOp::Ne => truth(compare(Compare::Ne, a, b)),
        BinOp::LtU => truth(compare(Compare::LtU, a, b)),
        BinOp::LeU => truth(compare(Compare::LeU, a, b)),
        BinOp::LtI => truth(compare(Compare::LtI, a, b)),
        BinOp::LeI => truth(compare(Compare::LeI, a, b)),
        BinOp::AddF => (fa + fb).to_bits(),
        BinOp::SubF => (fa - fb).to_bits(),
        BinOp::MulF => (fa * fb).to_bits(),
        BinOp::DivF => (fa / fb).to_bits(),
        BinOp::RemF => math::rem_f32(fa, fb).to_bits(),
        BinOp::MinF => math::min_f32(fa, fb).to_bits(),
        BinOp::MaxF => math::max_f32(fa, fb).to_bits(),
        BinOp::EqF => truth(compare(Compare::EqF, a, b)),
        BinOp::NeF => truth(compare(Compare::NeF, a, b)),
        BinOp::LtF => truth(compare(Compare::LtF, a, b)),
        BinOp::LeF => truth(compare(Compare::LeF, a, b)),
        BinOp::Atan2 => math::atan2(fa, fb).to_bits(),
        BinOp::Pow => math::pow(fa, fb).to_bits(),
        BinOp::Ldexp => math::ldexp(fa, ib).to_bits(),
    }
}

/// Whether a comparison holds.
pub(crate) fn compare(op: Compare, a: u32, b: u32) -> bool {
    let (ia, ib) = (a as i32, b as i32);
    let (fa, fb) = (f(a), f(b));
    match op {
        Compare::Eq => a == b,
        Compare::Ne => a != b,
        Compare::LtU => a < b,
        Compare::LeU => a <= b,
        Compare::LtI => ia < ib,
        Compare::LeI => ia <= ib,
        Compare::EqF => fa == fb,
        Compare::NeF => fa != fb,
        Compare::LtF => fa < fb,
        Compare::LeF => fa <= fb,
        Compare::NotLtF => fa.partial_cmp(&fb) != Some(Ordering::Less),
        Compare::NotLeF => !matches!(fa.partial_cmp(&fb), Some(Ordering::Less | Ordering::Equal)),
    }
}

/// The value of a pair: what its vector form is held to.
#[cfg(test)]
pub(crate) fn pair(op: Pair, a: u32, b: u32, c: u32) -> u32 {
    let Some(parts) = op.parts() else { return (a ^ a.wrapping_shr(b)).wrapping_mul(c) };
    let t = binary(parts.first, a, b);
    let (left, right) = if parts.left { (t, c) } else { (c, t) };
    binary(parts.second, left, right)
}

/// The value of an operation on four words: what its vector form is held to.
#[cfg(test)]
pub(crate) fn quad(op: QuadOp, [a, b, c, d]: [u32; 4]) -> u32 {
    let wide = |high: u32, low: u32| u64::from(high) << 32 | u64::from(low);
    match op {
        QuadOp::MulMulAdd => a.wrapping_mul(b).wrapping_add(c.wrapping_mul(d)),
        QuadOp::MulMulSub => a.wrapping_mul(b).wrapping_sub(c.wrapping_mul(d)),
        QuadOp::ShlShrOr => a.wrapping_shl(b) | c.wrapping_shr(d),
        QuadOp::AddCarry => a.wrapping_add(b).wrapping_add(u32::from(c < d)),
        QuadOp::SubBorrow => a.wrapping_sub(b).wrapping_sub(u32::from(c < d)),
        QuadOp::EqLtU => truth(a == b && c < d),
        QuadOp::LtWide => truth(wide(a, c) < wide(b, d)),
        QuadOp::GeWide => truth(wide(a, c) >= wide(b, d)),
    }
}

/// The value of [`crate::code::Inst::Mix`].
#[cfg(test)]
pub(crate) fn mix(x: u32, by: [u32; 5]) -> u32 {
    let x = (x ^ x.wrapping_shr(by[0])).wrapping_mul(by[1]);
    let x = (x ^ x.wrapping_shr(by[2])).wrapping_mul(by[3]);
    x ^ x.wrapping_shr(by[4])
}

/// The value of a ternary operation.
pub(crate) fn ternary(op: TernOp, a: u32, b: u32, c: u32) -> u32 {
    match op {
        TernOp::Select => {
            if a != 0 {
                b
            } else {
                c
            }
        }
        TernOp::Fma => math::fma(f(a), f(b), f(c)).to_bits(),
    }
}

/// What an atomic operation leaves in memory, from the old value and the operand.
pub(crate) fn atomic(op: AtomicOp, old: u32, value: u32) -> u32 {
    match op {
        AtomicOp::Exchange | AtomicOp::CompareExchange => value,
        AtomicOp::Add => old.wrapping_add(value),
        AtomicOp::Sub => old.wrapping_sub(value),
        AtomicOp::And => old & value,
        AtomicOp::Or => old | value,
        AtomicOp::Xor => old ^ value,
        AtomicOp::MinU => old.min(value),
        AtomicOp::MaxU => old.max(value),
        AtomicOp::MinI => (old as i32).min(value as i32) as u32,
        AtomicOp::MaxI => (old as i32).max(value as i32) as u32,
    }
}

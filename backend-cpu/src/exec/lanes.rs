//! Binary operations on sixteen lanes: the SIMD form of each, as a type.
//!
//! A type for each operation lets single operations, pairs and choices share one definition and be compiled without a
//! branch on the operation inside a loop. Every form computes what [`crate::semantics`] says.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x16, f64x8, i32x16, mask32x16, u32x16, u64x8};

use super::mask::CHUNK;
use crate::math;
use crate::semantics;

/// A binary operation on lanes.
pub(super) trait Lanes {
    /// `a op b` on each lane.
    fn apply<S: Simd>(s: S, a: u32x16<S>, b: u32x16<S>) -> u32x16<S>;

    /// `a op b`, `b` the same for all lanes: shifts are cheaper then.
    #[inline(always)]
    fn by<S: Simd>(s: S, a: u32x16<S>, b: u32) -> u32x16<S> {
        Self::apply(s, a, s.splat_u32x16(b))
    }
}

/// Declares operations: an expression for two rows, and for shifts one for a row and a word.
macro_rules! lanes {
    ($($op:ident($s:ident, $a:ident, $b:ident) $form:expr $(, by $by:expr)?;)*) => {
        /// The operations that have a SIMD form.
        pub(super) mod op {
            $(pub(in crate::exec) struct $op;)*
        }

        $(impl Lanes for op::$op {
            #[inline(always)]
            fn apply<S: Simd>($s: S, $a: u32x16<S>, $b: u32x16<S>) -> u32x16<S> {
                $form
            }

            $(#[inline(always)]
            fn by<S: Simd>($s: S, $a: u32x16<S>, $b: u32) -> u32x16<S> {
                $by
            })?
        })*

        /// Hands the operation's type to a macro-like match: `$f!(type)`, or `$other` for one without a SIMD form.
        macro_rules! for_operation {
            ($value:expr, $f:ident, $rest:pat => $other:expr) => {
                match $value {
                    $(crate::code::BinOp::$op => $f!(super::lanes::op::$op),)*
                    $rest => $other,
                }
            };
        }
        pub(super) use for_operation;
    };
}

/// Hands the type of a comparison to a macro; negated orders of f32 are handed over as the orders they negate.
macro_rules! for_comparison {
    ($value:expr, $f:ident) => {
        match $value {
            crate::code::Compare::Eq => $f!(super::lanes::op::Eq),
            crate::code::Compare::Ne => $f!(super::lanes::op::Ne),
            crate::code::Compare::LtU => $f!(super::lanes::op::LtU),
            crate::code::Compare::LeU => $f!(super::lanes::op::LeU),
            crate::code::Compare::LtI => $f!(super::lanes::op::LtI),
            crate::code::Compare::LeI => $f!(super::lanes::op::LeI),
            crate::code::Compare::EqF => $f!(super::lanes::op::EqF),
            crate::code::Compare::NeF => $f!(super::lanes::op::NeF),
            crate::code::Compare::LtF | crate::code::Compare::NotLtF => $f!(super::lanes::op::LtF),
            crate::code::Compare::LeF | crate::code::Compare::NotLeF => $f!(super::lanes::op::LeF),
        }
    };
}
pub(super) use for_comparison;

const FIVE_BITS: u32 = 31;

lanes! {
    Add(s, a, b) s.add_u32x16(a, b);
    Sub(s, a, b) s.sub_u32x16(a, b);
    Mul(s, a, b) s.mul_u32x16(a, b);
    MulHigh(s, a, b) high_product(s, a, b);
    MulHighI(s, a, b) {
        // A negative factor counts as itself plus 2^32, so the other is once too much in the high word.
        let (a_part, b_part) = (s.shr_i32x16(signed(a), 31).bitcast(), s.shr_i32x16(signed(b), 31).bitcast());
        let excess = s.add_u32x16(s.and_u32x16(a_part, b), s.and_u32x16(b_part, a));
        s.sub_u32x16(high_product(s, a, b), excess)
    };
    And(s, a, b) s.and_u32x16(a, b);
    Or(s, a, b) s.or_u32x16(a, b);
    Xor(s, a, b) s.xor_u32x16(a, b);
    Shl(s, a, b) s.shlv_u32x16(a, amount(s, b)), by s.shl_u32x16(a, b & FIVE_BITS);
    ShrU(s, a, b) s.shrv_u32x16(a, amount(s, b)), by s.shr_u32x16(a, b & FIVE_BITS);
    ShrI(s, a, b) s.shrv_i32x16(signed(a), signed(amount(s, b))).bitcast(),
        by s.shr_i32x16(signed(a), b & FIVE_BITS).bitcast();
    DivU(s, a, b) quotient(s, a, b);
    RemU(s, a, b) {
        let rest = s.sub_u32x16(a, s.mul_u32x16(quotient(s, a, b), b));
        s.and_u32x16(rest, truth(s, s.simd_ne_u32x16(b, s.splat_u32x16(0))))
    };
    MinU(s, a, b) s.min_u32x16(a, b);
    MaxU(s, a, b) s.max_u32x16(a, b);
    MinI(s, a, b) s.min_i32x16(signed(a), signed(b)).bitcast();
    MaxI(s, a, b) s.max_i32x16(signed(a), signed(b)).bitcast();
    Eq(s, a, b) truth(s, s.simd_eq_u32x16(a, b));
    Ne(s, a, b) truth(s, s.simd_ne_u32x16(a, b));
    LtU(s, a, b) truth(s, s.simd_lt_u32x16(a, b));
    LeU(s, a, b) truth(s, s.simd_le_u32x16(a, b));
    LtI(s, a, b) truth(s, s.simd_lt_i32x16(signed(a), signed(b)));
    LeI(s, a, b) truth(s, s.simd_le_i32x16(signed(a), signed(b)));
    AddF(s, a, b) s.add_f32x16(float(a), float(b)).bitcast();
    SubF(s, a, b) s.sub_f32x16(float(a), float(b)).bitcast();
    MulF(s, a, b) s.mul_f32x16(float(a), float(b)).bitcast();
    DivF(s, a, b) s.div_f32x16(float(a), float(b)).bitcast();
    MinF(s, a, b) {
        let second = s.simd_lt_f32x16(float(b), float(a)) | s.simd_ne_f32x16(float(a), float(a));
        s.select_u32x16(second, b, a)
    };
    MaxF(s, a, b) {
        let second = s.simd_lt_f32x16(float(a), float(b)) | s.simd_ne_f32x16(float(a), float(a));
        s.select_u32x16(second, b, a)
    };
    EqF(s, a, b) truth(s, s.simd_eq_f32x16(float(a), float(b)));
    NeF(s, a, b) truth(s, s.simd_ne_f32x16(float(a), float(b)));
    LtF(s, a, b) truth(s, s.simd_lt_f32x16(float(a), float(b)));
    LeF(s, a, b) truth(s, s.simd_le_f32x16(float(a), float(b)));
}

#[inline(always)]
pub(super) fn truth<S: Simd>(s: S, mask: mask32x16<S>) -> u32x16<S> {
    s.to_vector_mask32x16(mask).bitcast()
}

#[inline(always)]
pub(super) fn float<S: Simd>(a: u32x16<S>) -> f32x16<S> {
    a.bitcast()
}

#[inline(always)]
pub(super) fn signed<S: Simd>(a: u32x16<S>) -> i32x16<S> {
    a.bitcast()
}

/// An operation on each lane by its scalar meaning.
#[inline(always)]
pub(super) fn each<S: Simd>(a: u32x16<S>, f: impl Fn(u32) -> u32) -> u32x16<S> {
    let words: [u32; CHUNK] = a.into();
    u32x16::simd_from(a.simd, words.map(f))
}

/// A binary operation on each lane by its scalar meaning.
#[inline(always)]
pub(super) fn each2<S: Simd>(a: u32x16<S>, b: u32x16<S>, op: crate::code::BinOp) -> u32x16<S> {
    let (x, y): ([u32; CHUNK], [u32; CHUNK]) = (a.into(), b.into());
    u32x16::simd_from(a.simd, std::array::from_fn(|i| semantics::binary(op, x[i], y[i])))
}

#[inline(always)]
fn amount<S: Simd>(s: S, b: u32x16<S>) -> u32x16<S> {
    s.and_u32x16(b, s.splat_u32x16(FIVE_BITS))
}

/// High words of products: of even and odd lanes apart, so that neither needs to be widened.
#[inline(always)]
fn high_product<S: Simd>(s: S, a: u32x16<S>, b: u32x16<S>) -> u32x16<S> {
    let (a, b): (u64x8<S>, u64x8<S>) = (a.bitcast(), b.bitcast());
    let low = s.splat_u64x8(u64::from(u32::MAX));
    let even = s.mul_u64x8(s.and_u64x8(a, low), s.and_u64x8(b, low));
    let odd = s.mul_u64x8(s.shr_u64x8(a, 32), s.shr_u64x8(b, 32));
    s.or_u64x8(s.shr_u64x8(even, 32), s.and_u64x8(odd, s.not_u64x8(low))).bitcast()
}

/// ⌊a / b⌋, a where b = 0.
///
/// Words are exact in binary64. A quotient that is no integer lies at least 1 / b below the next one, which is more
/// than half a unit in its last place (a 2^−53 < 1), so its rounding does not reach the integer and the floor is exact.
#[inline(always)]
fn quotient<S: Simd>(s: S, a: u32x16<S>, b: u32x16<S>) -> u32x16<S> {
    let ((a_low, a_high), (b_low, b_high)) = (wide(s, a), wide(s, b));
    let part = |a, b| {
        let floor = s.floor_f64x8(s.div_f64x8(a, b));
        let bits: u64x8<S> = s.add_f64x8(floor, s.splat_f64x8(TWO_52)).bitcast();
        bits
    };
    let whole = s.narrow_u64x8(part(a_low, b_low), part(a_high, b_high));
    s.select_u32x16(s.simd_eq_u32x16(b, s.splat_u32x16(0)), a, whole)
}

/// The binary64 number whose last place is 1: its low word plus an integer is that integer.
const TWO_52: f64 = 4_503_599_627_370_496.0;

/// Words as binary64.
#[inline(always)]
fn wide<S: Simd>(s: S, a: u32x16<S>) -> (f64x8<S>, f64x8<S>) {
    let (low, high) = s.widen_u32x16(a);
    let number = |bits: u64x8<S>| {
        let shifted: f64x8<S> = s.or_u64x8(bits, s.splat_u64x8(TWO_52.to_bits())).bitcast();
        s.sub_f64x8(shifted, s.splat_f64x8(TWO_52))
    };
    (number(low), number(high))
}

/// The place of the highest set bit; −127 for 0.
///
/// The exponent of the word as f32 tells it: without the bit below the highest, the word cannot round up to the next
/// power of two.
#[inline(always)]
pub(super) fn leading_bit<S: Simd>(s: S, a: u32x16<S>) -> u32x16<S> {
    let thin = s.and_u32x16(a, s.not_u32x16(s.shr_u32x16(a, 1)));
    let bits: u32x16<S> = s.cvt_f32_u32x16(thin).bitcast();
    s.sub_u32x16(s.shr_u32x16(bits, 23), s.splat_u32x16(127))
}

/// The lowest set bit alone.
#[inline(always)]
pub(super) fn lowest<S: Simd>(s: S, a: u32x16<S>) -> u32x16<S> {
    s.and_u32x16(a, s.sub_u32x16(s.splat_u32x16(0), a))
}

/// The place of a bit as WGSL tells it: −1 where there is none.
#[inline(always)]
pub(super) fn place<S: Simd>(s: S, bit: u32x16<S>) -> u32x16<S> {
    s.max_i32x16(signed(bit), s.splat_i32x16(-1)).bitcast()
}

/// 1 / √x, rounded once; NaN as [`math::NAN`].
///
/// y = 1 / √x in f32 is off by less than 2^−22 of itself. In binary64 x y is exact, and so is 1 − (x y) y but for the
/// rounding of the last product; two terms of the series of (1 − r)^(−1/2) then leave an error of some 2^−52, as the
/// quotient in binary64 has that defines the operation. The tests compare both for every significand.
#[inline(always)]
pub(super) fn inverse_sqrt<S: Simd>(s: S, x: u32x16<S>) -> u32x16<S> {
    let x = float(x);
    let first = s.div_f32x16(s.splat_f32x16(1.0), s.sqrt_f32x16(x));
    let ((x_low, x_high), (y_low, y_high)) = (s.widen_f32x16(x), s.widen_f32x16(first));
    let better = s.narrow_f64x8(refined(s, x_low, y_low), refined(s, x_high, y_high));
    // 0 and infinity have no residual, and their first quotients are right.
    let root = s.select_f32x16(s.simd_eq_f32x16(better, better), better, first);
    s.select_f32x16(s.simd_eq_f32x16(root, root), root, s.splat_f32x16(math::NAN)).bitcast()
}

/// y (1 − r)^(−1/2) of r = 1 − x y².
#[inline(always)]
fn refined<S: Simd>(s: S, x: f64x8<S>, y: f64x8<S>) -> f64x8<S> {
    let r = s.sub_f64x8(s.splat_f64x8(1.0), s.mul_f64x8(s.mul_f64x8(x, y), y));
    let series = s.add_f64x8(s.splat_f64x8(0.5), s.mul_f64x8(s.splat_f64x8(0.375), r));
    s.add_f64x8(y, s.mul_f64x8(y, s.mul_f64x8(r, series)))
}

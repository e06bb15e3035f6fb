//! Arithmetic on rows of lanes, in explicit SIMD for what is common.
//!
//! Nothing here looks at masks except [`blend`]: a row's inactive lanes may hold anything. Every form computes what
//! [`crate::semantics`] says; the tests compare them on every SIMD level. Functions that are inlined expect a caller
//! that has entered the SIMD level.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x16, mask32x16, u32x16};

use super::fused;
use super::lanes::{each as lanewise, each2, float, for_operation, inverse_sqrt, leading_bit, lowest, place, signed};
use super::mask::{CHUNK, Exec};
use super::rows::{Operand, Row, Rows, load, operands, pass, store};
use crate::code::{BinOp, Reg, TernOp, UnOp};
use crate::semantics;

/// The same word in every lane.
#[inline(always)]
fn fill<S: Simd>(s: S, dst: Row<'_>, word: u32) {
    let value = u32x16::splat(s, word);
    pass(
        dst,
        #[inline(always)]
        |_| value,
    );
}

/// The lesser of each lane and a limit; NaN stays.
#[inline(always)]
fn at_most<S: Simd>(s: S, a: f32x16<S>, limit: f32) -> f32x16<S> {
    let limit = s.splat_f32x16(limit);
    s.select_f32x16(s.simd_gt_f32x16(a, limit), limit, a)
}

/// `dst = op a`, on a vector register.
pub(super) fn unary<S: Simd>(s: S, r: &Rows<'_>, op: UnOp, dst: Reg, a: Reg) {
    s.vectorize(
        #[inline(always)]
        move || {
            let dst = r.operand(dst);
            if a.is_scalar() {
                fill(s, dst, semantics::unary(op, r.scalar(a)));
            } else {
                unary_row(s, op, dst, r.operand(a));
            }
        },
    );
}

#[inline(always)]
fn unary_row<S: Simd>(s: S, op: UnOp, dst: Row<'_>, row: Row<'_>) {
    macro_rules! each {
        (|$a:ident| $form:expr) => {
            pass(
                dst,
                #[inline(always)]
                |at| {
                    let $a = row.at(s, at);
                    $form
                },
            )
        };
    }
    match op {
        UnOp::Move => each!(|a| a),
        UnOp::Not => each!(|a| s.not_u32x16(a)),
        UnOp::NegI => each!(|a| s.sub_u32x16(s.splat_u32x16(0), a)),
        UnOp::NegF => each!(|a| s.xor_u32x16(a, s.splat_u32x16(0x8000_0000))),
        UnOp::AbsF => each!(|a| s.and_u32x16(a, s.splat_u32x16(0x7fff_ffff))),
        UnOp::AbsI => each!(|a| s.abs_i32x16(signed(a)).bitcast()),
        UnOp::Floor => each!(|a| s.floor_f32x16(float(a)).bitcast()),
        UnOp::Ceil => each!(|a| s.ceil_f32x16(float(a)).bitcast()),
        UnOp::Trunc => each!(|a| s.trunc_f32x16(float(a)).bitcast()),
        UnOp::Round => each!(|a| s.round_ties_even_f32x16(float(a)).bitcast()),
        UnOp::Sqrt => each!(|a| s.sqrt_f32x16(float(a)).bitcast()),
        UnOp::IntToFloat => each!(|a| s.cvt_f32_i32x16(signed(a)).bitcast()),
        UnOp::UintToFloat => each!(|a| s.cvt_f32_u32x16(a).bitcast()),
        UnOp::FloatToInt => {
            each!(|a| s.cvt_i32_precise_f32x16(at_most(s, float(a), 2_147_483_520.0)).bitcast())
        }
        UnOp::FloatToUint => each!(|a| s.cvt_u32_precise_f32x16(at_most(s, float(a), 4_294_967_040.0))),
        UnOp::CountOneBits => each!(|a| s.count_ones_u32x16(a)),
        UnOp::InverseSqrt => each!(|a| inverse_sqrt(s, a)),
        UnOp::CountLeadingZeros => {
            each!(|a| s.min_u32x16(s.sub_u32x16(s.splat_u32x16(31), leading_bit(s, a)), s.splat_u32x16(32)))
        }
        UnOp::CountTrailingZeros => each!(|a| s.min_u32x16(leading_bit(s, lowest(s, a)), s.splat_u32x16(32))),
        UnOp::FirstLeadingBitU => each!(|a| place(s, leading_bit(s, a))),
        UnOp::FirstTrailingBit => each!(|a| place(s, leading_bit(s, lowest(s, a)))),
        UnOp::ReverseBits => each!(|a| lanewise(a, u32::reverse_bits)),
        other => each!(|a| lanewise(a, |word| semantics::unary(other, word))),
    }
}

/// `dst = a op b`, on a vector register.
pub(super) fn binary<S: Simd>(s: S, r: &Rows<'_>, op: BinOp, dst: Reg, a: Reg, b: Reg) {
    s.vectorize(
        #[inline(always)]
        move || {
            let dst = r.operand(dst);
            if !b.is_scalar() {
                let b = r.operand(b);
                operands!(r, [a] => binary_row(s, op, dst, a, b));
            } else if a.is_scalar() {
                fill(s, dst, semantics::binary(op, r.scalar(a), r.scalar(b)));
            } else {
                binary_row(s, op, dst, r.operand(a), r.word(b));
            }
        },
    );
}

#[inline(always)]
fn binary_row<S: Simd>(s: S, op: BinOp, dst: Row<'_>, a: impl Operand<S>, b: impl Operand<S>) {
    macro_rules! passes {
        ($op:ty) => {
            pass(
                dst,
                #[inline(always)]
                |at| b.after::<$op>(s, a.at(s, at), at),
            )
        };
    }
    for_operation!(op, passes, other => pass(
        dst,
        #[inline(always)]
        |at| each2(a.at(s, at), b.at(s, at), other),
    ));
}

/// `dst = op(a, b, c)`, on a vector register.
pub(super) fn ternary<S: Simd>(s: S, r: &Rows<'_>, op: TernOp, dst: Reg, [a, b, c]: [Reg; 3]) {
    match op {
        TernOp::Select if a.is_scalar() => {
            let from = if r.scalar(a) != 0 { b } else { c };
            unary(s, r, UnOp::Move, dst, from);
        }
        TernOp::Select => fused::select(s, r, dst, a, [b, c]),
        TernOp::Fma => s.vectorize(
            #[inline(always)]
            move || {
                let dst = r.operand(dst);
                operands!(r, [a, b, c] => pass(
                    dst,
                    #[inline(always)]
                    |at| s.mul_add_precise_f32x16(float(a.at(s, at)), float(b.at(s, at)), float(c.at(s, at))).bitcast(),
                ));
            },
        ),
    }
}

/// Copies active lanes of `a` to `dst`.
pub(super) fn blend<S: Simd>(s: S, r: &Rows<'_>, exec: &Exec, dst: Reg, a: Reg) {
    if exec.full {
        return unary(s, r, UnOp::Move, dst, a);
    }
    let r = r.aligned();
    s.vectorize(
        #[inline(always)]
        move || {
            let dst = r.operand(dst);
            operands!(r, [a] => pass(
                dst,
                #[inline(always)]
                |at| {
                    let (word, place) = r.lanes(at);
                    let active = mask32x16::from_bitmask(s, exec.mask.word(word) >> place & 0xffff);
                    s.select_u32x16(active, a.at(s, at), dst.at(s, at))
                },
            ));
        },
    );
}

/// `dst = min(index, length - 1)`; the first active lane whose index is out of range.
pub(super) fn check<S: Simd>(
    s: S,
    r: &Rows<'_>,
    exec: &Exec,
    dst: Reg,
    index: Reg,
    length: u32,
) -> Option<(usize, u32)> {
    let last = length.wrapping_sub(1);
    let mut wrong = None;
    s.vectorize(
        #[inline(always)]
        || {
            let limit = s.splat_u32x16(last);
            let (to, from) = (r.row(dst), r.row(index));
            let mut greatest = s.splat_u32x16(0);
            for x in from {
                greatest = s.max_u32x16(greatest, load(s, x));
            }
            if s.any_true_mask32x16(s.simd_gt_u32x16(greatest, limit)) {
                let outside = |lane: &usize| exec.mask.has(*lane) && r.lane(index, *lane) > last;
                let first = (exec.low * CHUNK..exec.high * CHUNK).find(outside);
                wrong = first.map(|lane| (lane, r.lane(index, lane)));
            }
            for (d, x) in to.iter().zip(from) {
                store(d, s.min_u32x16(load(s, x), limit));
            }
        },
    );
    wrong
}

/// What a row of addresses looks like: its first one where they count up by one from lane to lane, and whether all of
/// them are below a limit once an offset is added.
pub(super) fn survey<S: Simd>(s: S, r: &Rows<'_>, addr: Reg, offset: u32, limit: usize) -> (Option<u32>, bool) {
    let row = r.row(addr);
    let base = row.first().map_or(0, |chunk| chunk.get().0[0]);
    let Some(last) = u32::try_from(limit).unwrap_or(u32::MAX).checked_sub(1) else { return (None, false) };
    let (mut same, mut inside) = (true, true);
    s.vectorize(
        #[inline(always)]
        || {
            let steps = u32x16::simd_from(s, std::array::from_fn(|i| i as u32));
            let offset = s.splat_u32x16(offset);
            let (mut difference, mut greatest) = (s.splat_u32x16(0), s.splat_u32x16(0));
            let mut expected = s.add_u32x16(s.splat_u32x16(base), steps);
            for cell in row {
                let addr = load(s, cell);
                difference = s.or_u32x16(difference, s.xor_u32x16(addr, expected));
                expected = s.add_u32x16(expected, s.splat_u32x16(CHUNK as u32));
                greatest = s.max_u32x16(greatest, s.add_u32x16(addr, offset));
            }
            same = !s.any_true_mask32x16(s.simd_ne_u32x16(difference, s.splat_u32x16(0)));
            inside = !s.any_true_mask32x16(s.simd_gt_u32x16(greatest, s.splat_u32x16(last)));
        },
    );
    (same.then_some(base), inside)
}

//! Arithmetic on rows of lanes: loops over 16-lane chunks, in explicit SIMD for what is common.
//!
//! Nothing here looks at masks except [`blend`]: a row's inactive lanes may hold anything. Every form computes what
//! [`crate::semantics`] says; the tests compare them on every SIMD level. Functions that are inlined expect a caller that
//! has entered the SIMD level, as the interpreter's loop has.

use std::cell::Cell;

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x16, mask32x16, u32x16};

use super::fused;
use super::lanes::{Lanes, each, each2, float, for_operation, inverse_sqrt, leading_bit, lowest, place, signed};
use super::mask::{CHUNK, Exec};
use crate::code::{BinOp, Reg, TernOp, UnOp};
use crate::semantics;

/// Sixteen lanes of a register.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(super) struct Chunk(pub(super) [u32; CHUNK]);

/// The register files, and which chunks to work on.
#[derive(Clone, Copy)]
pub(super) struct Rows<'a> {
    pub(super) vectors: &'a [Cell<Chunk>],
    pub(super) scalars: &'a [Cell<u32>],
    /// Chunks of one row.
    pub(super) chunks: usize,
    pub(super) low: usize,
    pub(super) high: usize,
}

impl<'a> Rows<'a> {
    /// The chunks of a vector register that are worked on.
    #[inline(always)]
    pub(super) fn row(&self, register: Reg) -> &'a [Cell<Chunk>] {
        let start = register.index() * self.chunks;
        &self.vectors[start + self.low..start + self.high]
    }

    #[inline(always)]
    pub(super) fn scalar(&self, register: Reg) -> u32 {
        self.scalars[register.index()].get()
    }

    /// One lane of an operand.
    pub(super) fn lane(&self, register: Reg, lane: usize) -> u32 {
        if register.is_scalar() {
            return self.scalar(register);
        }
        self.vectors[register.index() * self.chunks + lane / CHUNK].get().0[lane % CHUNK]
    }

    /// Writes one lane of a vector register.
    pub(super) fn set_lane(&self, register: Reg, lane: usize, word: u32) {
        let cell = &self.vectors[register.index() * self.chunks + lane / CHUNK];
        let mut chunk = cell.get();
        chunk.0[lane % CHUNK] = word;
        cell.set(chunk);
    }
}

#[inline(always)]
pub(super) fn load<S: Simd>(s: S, cell: &Cell<Chunk>) -> u32x16<S> {
    u32x16::simd_from(s, cell.get().0)
}

#[inline(always)]
pub(super) fn store<S: Simd>(cell: &Cell<Chunk>, value: u32x16<S>) {
    cell.set(Chunk(value.into()));
}

#[inline(always)]
fn map<S: Simd>(s: S, r: Rows<'_>, dst: Reg, a: Reg, f: impl Fn(u32x16<S>) -> u32x16<S>) {
    for (d, a) in r.row(dst).iter().zip(r.row(a)) {
        store(d, f(load(s, a)));
    }
}

/// `dst = a op b`, at least one of the operands a row.
#[inline(always)]
fn zip<S: Simd, O: Lanes>(s: S, r: Rows<'_>, _: O, dst: Reg, a: Reg, b: Reg) {
    let d = r.row(dst);
    if b.is_scalar() {
        let b = r.scalar(b);
        for (d, a) in d.iter().zip(r.row(a)) {
            store(d, O::by(s, load(s, a), b));
        }
    } else if a.is_scalar() {
        let a = u32x16::splat(s, r.scalar(a));
        for (d, b) in d.iter().zip(r.row(b)) {
            store(d, O::apply(s, a, load(s, b)));
        }
    } else {
        let (a, b) = (&r.row(a)[..d.len()], &r.row(b)[..d.len()]);
        for i in 0..d.len() {
            store(&d[i], O::apply(s, load(s, &a[i]), load(s, &b[i])));
        }
    }
}

/// The same word in every lane.
#[inline(always)]
fn fill<S: Simd>(s: S, r: Rows<'_>, dst: Reg, word: u32) {
    let value = u32x16::splat(s, word);
    for d in r.row(dst) {
        store(d, value);
    }
}

/// The lesser of each lane and a limit; NaN stays.
#[inline(always)]
fn at_most<S: Simd>(s: S, a: f32x16<S>, limit: f32) -> f32x16<S> {
    let limit = s.splat_f32x16(limit);
    s.select_f32x16(s.simd_gt_f32x16(a, limit), limit, a)
}

/// `dst = op a`, on a vector register.
pub(super) fn unary<S: Simd>(s: S, r: Rows<'_>, op: UnOp, dst: Reg, a: Reg) {
    s.vectorize(
        #[inline(always)]
        || {
            if a.is_scalar() {
                fill(s, r, dst, semantics::unary(op, r.scalar(a)));
            } else {
                unary_row(s, r, op, dst, a);
            }
        },
    );
}

#[inline(always)]
fn unary_row<S: Simd>(s: S, r: Rows<'_>, op: UnOp, dst: Reg, a: Reg) {
    match op {
        UnOp::Move => map(s, r, dst, a, |a| a),
        UnOp::Not => map(s, r, dst, a, |a| s.not_u32x16(a)),
        UnOp::NegI => map(s, r, dst, a, |a| s.sub_u32x16(s.splat_u32x16(0), a)),
        UnOp::NegF => map(s, r, dst, a, |a| s.xor_u32x16(a, s.splat_u32x16(0x8000_0000))),
        UnOp::AbsF => map(s, r, dst, a, |a| s.and_u32x16(a, s.splat_u32x16(0x7fff_ffff))),
        UnOp::AbsI => map(s, r, dst, a, |a| s.abs_i32x16(signed(a)).bitcast()),
        UnOp::Floor => map(s, r, dst, a, |a| s.floor_f32x16(float(a)).bitcast()),
        UnOp::Ceil => map(s, r, dst, a, |a| s.ceil_f32x16(float(a)).bitcast()),
        UnOp::Trunc => map(s, r, dst, a, |a| s.trunc_f32x16(float(a)).bitcast()),
        UnOp::Round => map(s, r, dst, a, |a| s.round_ties_even_f32x16(float(a)).bitcast()),
        UnOp::Sqrt => map(s, r, dst, a, |a| s.sqrt_f32x16(float(a)).bitcast()),
        UnOp::IntToFloat => map(s, r, dst, a, |a| s.cvt_f32_i32x16(signed(a)).bitcast()),
        UnOp::UintToFloat => map(s, r, dst, a, |a| s.cvt_f32_u32x16(a).bitcast()),
        UnOp::FloatToInt => map(s, r, dst, a, |a| {
            let a = at_most(s, float(a), 2_147_483_520.0);
            s.cvt_i32_precise_f32x16(a).bitcast()
        }),
        UnOp::FloatToUint => map(s, r, dst, a, |a| s.cvt_u32_precise_f32x16(at_most(s, float(a), 4_294_967_040.0))),
        UnOp::CountOneBits => map(s, r, dst, a, |a| s.count_ones_u32x16(a)),
        UnOp::InverseSqrt => map(s, r, dst, a, |a| inverse_sqrt(s, a)),
        UnOp::CountLeadingZeros => {
            map(s, r, dst, a, |a| s.min_u32x16(s.sub_u32x16(s.splat_u32x16(31), leading_bit(s, a)), s.splat_u32x16(32)))
        }
        UnOp::CountTrailingZeros => {
            map(s, r, dst, a, |a| s.min_u32x16(leading_bit(s, lowest(s, a)), s.splat_u32x16(32)))
        }
        UnOp::FirstLeadingBitU => map(s, r, dst, a, |a| place(s, leading_bit(s, a))),
        UnOp::FirstTrailingBit => map(s, r, dst, a, |a| place(s, leading_bit(s, lowest(s, a)))),
        UnOp::ReverseBits => map(s, r, dst, a, |a| each(a, u32::reverse_bits)),
        other => map(s, r, dst, a, |a| each(a, |word| semantics::unary(other, word))),
    }
}

/// `dst = a op b`, on a vector register.
#[inline(always)]
pub(super) fn binary<S: Simd>(s: S, r: Rows<'_>, op: BinOp, dst: Reg, a: Reg, b: Reg) {
    if a.is_scalar() && b.is_scalar() {
        return fill(s, r, dst, semantics::binary(op, r.scalar(a), r.scalar(b)));
    }
    macro_rules! loops {
        ($op:expr) => {
            zip(s, r, $op, dst, a, b)
        };
    }
    for_operation!(op, loops, other => {
        for (i, d) in r.row(dst).iter().enumerate() {
            store(d, each2(fetch(s, &r, a, i), fetch(s, &r, b, i), other));
        }
    });
}

/// Chunk `i` of an operand of either kind.
#[inline(always)]
fn fetch<S: Simd>(s: S, r: &Rows<'_>, register: Reg, i: usize) -> u32x16<S> {
    if register.is_scalar() { s.splat_u32x16(r.scalar(register)) } else { load(s, &r.row(register)[i]) }
}

/// `dst = op(a, b, c)`, on a vector register.
pub(super) fn ternary<S: Simd>(s: S, r: Rows<'_>, op: TernOp, dst: Reg, [a, b, c]: [Reg; 3]) {
    match op {
        TernOp::Select if a.is_scalar() => {
            let from = if r.scalar(a) != 0 { b } else { c };
            unary(s, r, UnOp::Move, dst, from);
        }
        TernOp::Select => fused::select(s, r, dst, a, [b, c]),
        TernOp::Fma => s.vectorize(
            #[inline(always)]
            || {
                for (i, d) in r.row(dst).iter().enumerate() {
                    let (a, b, c) = (fetch(s, &r, a, i), fetch(s, &r, b, i), fetch(s, &r, c, i));
                    store(d, s.mul_add_precise_f32x16(float(a), float(b), float(c)).bitcast());
                }
            },
        ),
    }
}

/// Copies active lanes of `a` to `dst`.
pub(super) fn blend<S: Simd>(s: S, r: Rows<'_>, exec: &Exec, dst: Reg, a: Reg) {
    if exec.full {
        return unary(s, r, UnOp::Move, dst, a);
    }
    s.vectorize(
        #[inline(always)]
        || {
            for (i, d) in r.row(dst).iter().enumerate() {
                let mask = mask32x16::from_bitmask(s, u64::from(exec.mask.chunk(r.low + i)));
                store(d, s.select_u32x16(mask, fetch(s, &r, a, i), load(s, d)));
            }
        },
    );
}

/// `dst = min(index, length - 1)`; the first active lane whose index is out of range.
pub(super) fn check<S: Simd>(
    s: S,
    r: Rows<'_>,
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

/// What a row of addresses looks like: its first one where they count up by one from lane to lane, and whether all of them
/// are below a limit once an offset is added.
pub(super) fn survey<S: Simd>(s: S, r: Rows<'_>, addr: Reg, offset: u32, limit: usize) -> (Option<u32>, bool) {
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

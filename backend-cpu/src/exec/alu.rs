//! Arithmetic on rows of lanes: loops over 16-lane chunks, in explicit SIMD for what is common.
//!
//! Nothing here looks at masks except [`blend`]: a row's inactive lanes may hold anything. Every form computes what
//! [`crate::semantics`] says; the tests compare them on every SIMD level.

use std::cell::Cell;

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x16, i32x16, mask32x16, u32x16};

use super::mask::{CHUNK, Exec, Mask};
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
fn store<S: Simd>(cell: &Cell<Chunk>, value: u32x16<S>) {
    cell.set(Chunk(value.into()));
}

#[inline(always)]
fn map<S: Simd>(s: S, r: Rows<'_>, dst: Reg, a: Reg, f: impl Fn(u32x16<S>) -> u32x16<S>) {
    let d = r.row(dst);
    if a.is_scalar() {
        let value = f(u32x16::splat(s, r.scalar(a)));
        d.iter().for_each(|d| store(d, value));
    } else {
        for (d, a) in d.iter().zip(r.row(a)) {
            store(d, f(load(s, a)));
        }
    }
}

#[inline(always)]
fn zip<S: Simd>(s: S, r: Rows<'_>, dst: Reg, a: Reg, b: Reg, f: impl Fn(u32x16<S>, u32x16<S>) -> u32x16<S>) {
    let d = r.row(dst);
    match (a.is_scalar(), b.is_scalar()) {
        (false, false) => {
            let (a, b) = (&r.row(a)[..d.len()], &r.row(b)[..d.len()]);
            for i in 0..d.len() {
                store(&d[i], f(load(s, &a[i]), load(s, &b[i])));
            }
        }
        (false, true) => {
            let b = u32x16::splat(s, r.scalar(b));
            for (d, a) in d.iter().zip(r.row(a)) {
                store(d, f(load(s, a), b));
            }
        }
        (true, false) => {
            let a = u32x16::splat(s, r.scalar(a));
            for (d, b) in d.iter().zip(r.row(b)) {
                store(d, f(a, load(s, b)));
            }
        }
        (true, true) => {
            let value = f(u32x16::splat(s, r.scalar(a)), u32x16::splat(s, r.scalar(b)));
            d.iter().for_each(|d| store(d, value));
        }
    }
}

#[inline(always)]
fn truth<S: Simd>(s: S, mask: mask32x16<S>) -> u32x16<S> {
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

/// The lesser of each lane and a limit; NaN stays.
#[inline(always)]
fn at_most<S: Simd>(s: S, a: f32x16<S>, limit: f32) -> f32x16<S> {
    let limit = s.splat_f32x16(limit);
    s.select_f32x16(s.simd_gt_f32x16(a, limit), limit, a)
}

#[inline(always)]
fn each<S: Simd>(a: u32x16<S>, f: impl Fn(u32) -> u32) -> u32x16<S> {
    let words: [u32; CHUNK] = a.into();
    u32x16::simd_from(a.simd, words.map(f))
}

#[inline(always)]
fn each2<S: Simd>(a: u32x16<S>, b: u32x16<S>, f: impl Fn(u32, u32) -> u32) -> u32x16<S> {
    let (x, y): ([u32; CHUNK], [u32; CHUNK]) = (a.into(), b.into());
    u32x16::simd_from(a.simd, std::array::from_fn(|i| f(x[i], y[i])))
}

/// `dst = op a`, on a vector register.
pub(super) fn unary<S: Simd>(s: S, r: Rows<'_>, op: UnOp, dst: Reg, a: Reg) {
    s.vectorize(
        #[inline(always)]
        || match op {
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
            UnOp::CountLeadingZeros => map(s, r, dst, a, |a| each(a, u32::leading_zeros)),
            UnOp::CountTrailingZeros => map(s, r, dst, a, |a| each(a, u32::trailing_zeros)),
            UnOp::ReverseBits => map(s, r, dst, a, |a| each(a, u32::reverse_bits)),
            other => map(s, r, dst, a, |a| each(a, |word| semantics::unary(other, word))),
        },
    );
}

/// `dst = a op b`, on a vector register.
pub(super) fn binary<S: Simd>(s: S, r: Rows<'_>, op: BinOp, dst: Reg, a: Reg, b: Reg) {
    let five = 31;
    s.vectorize(
        #[inline(always)]
        || match op {
            BinOp::Add => zip(s, r, dst, a, b, |a, b| s.add_u32x16(a, b)),
            BinOp::Sub => zip(s, r, dst, a, b, |a, b| s.sub_u32x16(a, b)),
            BinOp::Mul => zip(s, r, dst, a, b, |a, b| s.mul_u32x16(a, b)),
            BinOp::MulHigh => zip(s, r, dst, a, b, |a, b| {
                let (low, high) = s.widening_mul_u32x16(a, b);
                s.narrow_u64x8(s.shr_u64x8(low, 32), s.shr_u64x8(high, 32))
            }),
            BinOp::And => zip(s, r, dst, a, b, |a, b| s.and_u32x16(a, b)),
            BinOp::Or => zip(s, r, dst, a, b, |a, b| s.or_u32x16(a, b)),
            BinOp::Xor => zip(s, r, dst, a, b, |a, b| s.xor_u32x16(a, b)),
            BinOp::Shl if b.is_scalar() => {
                let n = r.scalar(b) & five;
                map(s, r, dst, a, |a| s.shl_u32x16(a, n));
            }
            BinOp::ShrU if b.is_scalar() => {
                let n = r.scalar(b) & five;
                map(s, r, dst, a, |a| s.shr_u32x16(a, n));
            }
            BinOp::ShrI if b.is_scalar() => {
                let n = r.scalar(b) & five;
                map(s, r, dst, a, |a| s.shr_i32x16(signed(a), n).bitcast());
            }
            BinOp::Shl => zip(s, r, dst, a, b, |a, b| s.shlv_u32x16(a, s.and_u32x16(b, s.splat_u32x16(five)))),
            BinOp::ShrU => zip(s, r, dst, a, b, |a, b| s.shrv_u32x16(a, s.and_u32x16(b, s.splat_u32x16(five)))),
            BinOp::ShrI => zip(s, r, dst, a, b, |a, b| {
                let b = s.and_u32x16(b, s.splat_u32x16(five));
                s.shrv_i32x16(signed(a), signed(b)).bitcast()
            }),
            BinOp::MinU => zip(s, r, dst, a, b, |a, b| s.min_u32x16(a, b)),
            BinOp::MaxU => zip(s, r, dst, a, b, |a, b| s.max_u32x16(a, b)),
            BinOp::MinI => zip(s, r, dst, a, b, |a, b| s.min_i32x16(signed(a), signed(b)).bitcast()),
            BinOp::MaxI => zip(s, r, dst, a, b, |a, b| s.max_i32x16(signed(a), signed(b)).bitcast()),
            BinOp::Eq => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_eq_u32x16(a, b))),
            BinOp::Ne => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_ne_u32x16(a, b))),
            BinOp::LtU => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_lt_u32x16(a, b))),
            BinOp::LeU => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_le_u32x16(a, b))),
            BinOp::LtI => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_lt_i32x16(signed(a), signed(b)))),
            BinOp::LeI => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_le_i32x16(signed(a), signed(b)))),
            BinOp::AddF => zip(s, r, dst, a, b, |a, b| s.add_f32x16(float(a), float(b)).bitcast()),
            BinOp::SubF => zip(s, r, dst, a, b, |a, b| s.sub_f32x16(float(a), float(b)).bitcast()),
            BinOp::MulF => zip(s, r, dst, a, b, |a, b| s.mul_f32x16(float(a), float(b)).bitcast()),
            BinOp::DivF => zip(s, r, dst, a, b, |a, b| s.div_f32x16(float(a), float(b)).bitcast()),
            BinOp::MinF => zip(s, r, dst, a, b, |a, b| {
                let second = s.simd_lt_f32x16(float(b), float(a)) | s.simd_ne_f32x16(float(a), float(a));
                s.select_u32x16(second, b, a)
            }),
            BinOp::MaxF => zip(s, r, dst, a, b, |a, b| {
                let second = s.simd_lt_f32x16(float(a), float(b)) | s.simd_ne_f32x16(float(a), float(a));
                s.select_u32x16(second, b, a)
            }),
            BinOp::EqF => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_eq_f32x16(float(a), float(b)))),
            BinOp::NeF => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_ne_f32x16(float(a), float(b)))),
            BinOp::LtF => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_lt_f32x16(float(a), float(b)))),
            BinOp::LeF => zip(s, r, dst, a, b, |a, b| truth(s, s.simd_le_f32x16(float(a), float(b)))),
            BinOp::DivU => zip(s, r, dst, a, b, |a, b| each2(a, b, |a, b| semantics::binary(BinOp::DivU, a, b))),
            BinOp::RemU => zip(s, r, dst, a, b, |a, b| each2(a, b, |a, b| semantics::binary(BinOp::RemU, a, b))),
            other => zip(s, r, dst, a, b, |a, b| each2(a, b, |a, b| semantics::binary(other, a, b))),
        },
    );
}

/// `dst = op(a, b, c)`, on a vector register.
pub(super) fn ternary<S: Simd>(s: S, r: Rows<'_>, op: TernOp, dst: Reg, [a, b, c]: [Reg; 3]) {
    s.vectorize(
        #[inline(always)]
        || {
            let fetch = |register: Reg, i: usize| {
                if register.is_scalar() { u32x16::splat(s, r.scalar(register)) } else { load(s, &r.row(register)[i]) }
            };
            let zero = s.splat_u32x16(0);
            let d = r.row(dst);
            match op {
                TernOp::Select if a.is_scalar() => {
                    let from = if r.scalar(a) != 0 { b } else { c };
                    map(s, r, dst, from, |x| x);
                }
                TernOp::Select if b.is_scalar() || c.is_scalar() => {
                    for (i, d) in d.iter().enumerate() {
                        let cond = s.simd_ne_u32x16(load(s, &r.row(a)[i]), zero);
                        store(d, s.select_u32x16(cond, fetch(b, i), fetch(c, i)));
                    }
                }
                TernOp::Select => {
                    let (a, b, c) = (&r.row(a)[..d.len()], &r.row(b)[..d.len()], &r.row(c)[..d.len()]);
                    for i in 0..d.len() {
                        let cond = s.simd_ne_u32x16(load(s, &a[i]), zero);
                        store(&d[i], s.select_u32x16(cond, load(s, &b[i]), load(s, &c[i])));
                    }
                }
                TernOp::Fma => {
                    for (i, d) in d.iter().enumerate() {
                        let (a, b, c) = (fetch(a, i), fetch(b, i), fetch(c, i));
                        store(d, s.mul_add_precise_f32x16(float(a), float(b), float(c)).bitcast());
                    }
                }
            }
        },
    );
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
                let value = if a.is_scalar() { u32x16::splat(s, r.scalar(a)) } else { load(s, &r.row(a)[i]) };
                let mask = mask32x16::from_bitmask(s, u64::from(exec.mask.chunk(exec.low + i)));
                store(d, s.select_u32x16(mask, value, load(s, d)));
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
    let mut outside = Mask::default();
    let mut wrong = None;
    s.vectorize(
        #[inline(always)]
        || {
            let limit = s.splat_u32x16(last);
            for (i, (d, x)) in r.row(dst).iter().zip(r.row(index)).enumerate() {
                let x = load(s, x);
                let bits = s.to_bitmask_mask32x16(s.simd_gt_u32x16(x, limit)) as u16;
                if bits & exec.mask.chunk(exec.low + i) != 0 && wrong.is_none() {
                    outside.set_chunk(exec.low + i, bits & exec.mask.chunk(exec.low + i));
                    let words: [u32; CHUNK] = x.into();
                    wrong = outside.first_lane().map(|lane| (lane, words[lane % CHUNK]));
                }
                store(d, s.min_u32x16(x, limit));
            }
        },
    );
    wrong
}

/// First word of a row whose active chunks count up by one from lane to lane.
pub(super) fn contiguous<S: Simd>(s: S, r: Rows<'_>, addr: Reg) -> Option<u32> {
    let row = r.row(addr);
    let base = row.first()?.get().0[0];
    let mut same = true;
    s.vectorize(
        #[inline(always)]
        || {
            let steps = u32x16::simd_from(s, std::array::from_fn(|i| i as u32));
            let mut difference = s.splat_u32x16(0);
            let mut expected = s.add_u32x16(s.splat_u32x16(base), steps);
            for cell in row {
                difference = s.or_u32x16(difference, s.xor_u32x16(load(s, cell), expected));
                expected = s.add_u32x16(expected, s.splat_u32x16(CHUNK as u32));
            }
            same = !s.any_true_mask32x16(s.simd_ne_u32x16(difference, s.splat_u32x16(0)));
        },
    );
    same.then_some(base)
}

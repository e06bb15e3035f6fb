//! Tests of control flow on rows of lanes: a comparison gives the mask of the active lanes that pass.
//!
//! The result never leaves registers: no row of truth words is written for control flow to read again.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, mask32x16, u32x16};

use super::alu::{Rows, load};
use super::lanes::{float, signed};
use super::mask::{Exec, Mask};
use crate::code::{Compare, Test};

/// The active lanes that pass.
pub(super) fn passing<S: Simd>(s: S, r: Rows<'_>, exec: &Exec, test: Test) -> Mask {
    s.vectorize(
        #[inline(always)]
        || match test.op {
            Compare::Eq => fold(s, r, exec, test, |a, b| s.simd_eq_u32x16(a, b)),
            Compare::Ne => fold(s, r, exec, test, |a, b| s.simd_ne_u32x16(a, b)),
            Compare::LtU => fold(s, r, exec, test, |a, b| s.simd_lt_u32x16(a, b)),
            Compare::LeU => fold(s, r, exec, test, |a, b| s.simd_le_u32x16(a, b)),
            Compare::LtI => fold(s, r, exec, test, |a, b| s.simd_lt_i32x16(signed(a), signed(b))),
            Compare::LeI => fold(s, r, exec, test, |a, b| s.simd_le_i32x16(signed(a), signed(b))),
            Compare::EqF => fold(s, r, exec, test, |a, b| s.simd_eq_f32x16(float(a), float(b))),
            Compare::NeF => fold(s, r, exec, test, |a, b| s.simd_ne_f32x16(float(a), float(b))),
            Compare::LtF => fold(s, r, exec, test, |a, b| s.simd_lt_f32x16(float(a), float(b))),
            Compare::LeF => fold(s, r, exec, test, |a, b| s.simd_le_f32x16(float(a), float(b))),
            Compare::NotLtF => fold(s, r, exec, test, |a, b| s.not_mask32x16(s.simd_lt_f32x16(float(a), float(b)))),
            Compare::NotLeF => fold(s, r, exec, test, |a, b| s.not_mask32x16(s.simd_le_f32x16(float(a), float(b)))),
        },
    )
}

#[inline(always)]
fn fold<S: Simd>(
    s: S,
    r: Rows<'_>,
    exec: &Exec,
    test: Test,
    holds: impl Fn(u32x16<S>, u32x16<S>) -> mask32x16<S>,
) -> Mask {
    let mut lanes = Mask::default();
    // Plain loops: a closure of an iterator would not be compiled for this SIMD level.
    match (test.a.is_scalar(), test.b.is_scalar()) {
        (false, false) => {
            for (i, (a, b)) in r.row(test.a).iter().zip(r.row(test.b)).enumerate() {
                lanes.set_chunk(exec.low + i, bits(s, holds(load(s, a), load(s, b))));
            }
        }
        (false, true) => {
            let b = u32x16::splat(s, r.scalar(test.b));
            for (i, a) in r.row(test.a).iter().enumerate() {
                lanes.set_chunk(exec.low + i, bits(s, holds(load(s, a), b)));
            }
        }
        (true, false) => {
            let a = u32x16::splat(s, r.scalar(test.a));
            for (i, b) in r.row(test.b).iter().enumerate() {
                lanes.set_chunk(exec.low + i, bits(s, holds(a, load(s, b))));
            }
        }
        (true, true) => {
            let mask = bits(s, holds(u32x16::splat(s, r.scalar(test.a)), u32x16::splat(s, r.scalar(test.b))));
            for i in exec.low..exec.high {
                lanes.set_chunk(i, mask);
            }
        }
    }
    lanes.and(exec.mask)
}

#[inline(always)]
fn bits<S: Simd>(s: S, mask: mask32x16<S>) -> u16 {
    s.to_bitmask_mask32x16(mask) as u16
}

//! Tests of control flow on rows of lanes: a comparison gives the mask of the active lanes that pass.
//!
//! The result never leaves registers: no row of truth words is written for control flow to read again.

use fearless_simd::Simd;

use super::lanes::{Lanes, for_comparison};
use super::mask::{CHUNK, Exec, Mask};
use super::rows::{At, BLOCK, Operand, Rows, operands};
use crate::code::{Compare, Test};

/// The active lanes that pass.
pub(super) fn passing<S: Simd>(s: S, r: &Rows<'_>, exec: &Exec, test: Test) -> Mask {
    let Test { op, a, b } = test;
    let r = r.aligned();
    let holds = s.vectorize(
        #[inline(always)]
        move || operands!(r, [a, b] => holding(s, &r, op, a, b)),
    );
    match op {
        Compare::NotLtF | Compare::NotLeF => exec.mask.and_not(holds),
        _ => holds.and(exec.mask),
    }
}

/// The lanes where a comparison holds; where the order that it negates does, for negated orders.
#[inline(always)]
fn holding<S: Simd>(s: S, r: &Rows<'_>, op: Compare, a: impl Operand<S>, b: impl Operand<S>) -> Mask {
    let mut lanes = Mask::default();
    macro_rules! passes {
        ($test:ty) => {{
            for block in 0..r.len() / BLOCK {
                let mut word = 0;
                for chunk in 0..BLOCK {
                    word |= bits::<S, $test>(s, a, b, At::Block(block, chunk)) << (chunk * CHUNK);
                }
                lanes.set_word(r.low / BLOCK + block, word);
            }
            let mut word = 0;
            for chunk in 0..r.len() % BLOCK {
                word |= bits::<S, $test>(s, a, b, At::Rest(chunk)) << (chunk * CHUNK);
            }
            if word != 0 {
                lanes.set_word(r.high / BLOCK, word);
            }
        }};
    }
    for_comparison!(op, passes);
    lanes
}

/// The lanes of one chunk where `a op b`.
#[inline(always)]
fn bits<S: Simd, O: Lanes>(s: S, a: impl Operand<S>, b: impl Operand<S>, at: At) -> u64 {
    s.to_bitmask_mask32x16(s.simd_ne_u32x16(b.after::<O>(s, a.at(s, at), at), s.splat_u32x16(0)))
}

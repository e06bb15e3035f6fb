//! Idioms: long ways round WGSL's lack of an operation that machines have.
//!
//! The high word of a 32 × 32-bit product is written in 16-bit halves, since WGSL has no wider type:
//!
//! ```text
//! t = ah * bl + ((al * bl) >> 16),  u = al * bh + (t & 0xffff),  ah * bh + (t >> 16) + (u >> 16)
//! ```
//!
//! None of these sums exceeds 32 bits, so the whole is ⌊a b / 2^32⌋ for all words a and b, and one operation computes
//! it. A half may be a constant. Invariant: an idiom is replaced only by an operation with the same value for every
//! input.

use super::fold;
use super::tree::{Op, Tree, Val};
use crate::code::BinOp;

/// A factor of a product in halves.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Factor {
    Val(Val),
    Word(u32),
}

/// The operands of the high word of a product, if `op` is the last sum of one.
pub(super) fn high_product(tree: &Tree, op: Op) -> Option<(Factor, Factor)> {
    let (first, u) = sum_with_high(tree, op)?;
    let (top, t) = sum_with_high(tree, tree.op(first))?;
    let (ah, bh) = product(tree, top)?;
    let Op::Bin(BinOp::Add, cross, carry) = tree.op(u) else { return None };
    let masked = match tree.op(carry) {
        Op::Bin(BinOp::And, masked, mask) if tree.constant(mask) == Some(0xffff) => masked,
        // No mask is left where it would take nothing away.
        _ if fold::greatest(tree, carry, fold::DEPTH) <= 0xffff => carry,
        _ => return None,
    };
    let (al, same_bh) = product(tree, cross)?;
    let (other, low) = sum_with_high(tree, tree.op(t))?;
    let (same_ah, bl) = product(tree, other)?;
    let (same_al, same_bl) = product(tree, low)?;
    let same = (same_ah, same_al, same_bh, same_bl) == (ah, al, bh, bl);
    (masked == t && same).then(|| Some((whole(tree, ah, al)?, whole(tree, bh, bl)?))).flatten()
}

/// x and y of `x + (y >> 16)`.
fn sum_with_high(tree: &Tree, op: Op) -> Option<(Val, Val)> {
    let Op::Bin(BinOp::Add, x, shifted) = op else { return None };
    match tree.op(shifted) {
        Op::Bin(BinOp::ShrU, y, by) if tree.constant(by) == Some(16) => Some((x, y)),
        _ => None,
    }
}

fn product(tree: &Tree, val: Val) -> Option<(Val, Val)> {
    match tree.op(val) {
        Op::Bin(BinOp::Mul, a, b) => Some((a, b)),
        _ => None,
    }
}

/// The word whose halves these are.
fn whole(tree: &Tree, high: Val, low: Val) -> Option<Factor> {
    if let (Some(high), Some(low)) = (tree.constant(high), tree.constant(low)) {
        return (high <= 0xffff && low <= 0xffff).then_some(Factor::Word(high << 16 | low));
    }
    match (tree.op(high), tree.op(low)) {
        // A word without an upper half is its lower one.
        (Op::Bin(BinOp::ShrU, a, by), _) if a == low => {
            let halves = tree.constant(by) == Some(16) && fold::greatest(tree, a, fold::DEPTH) <= 0xffff;
            halves.then_some(Factor::Val(a))
        }
        (Op::Bin(BinOp::ShrU, a, by), Op::Bin(BinOp::And, b, mask)) => {
            let halves = tree.constant(by) == Some(16) && tree.constant(mask) == Some(0xffff);
            (a == b && halves).then_some(Factor::Val(a))
        }
        _ => None,
    }
}

//! Constant folding and the few algebraic rules that inlining makes worth while. Integers only: no rule changes a bit.

use super::tree::{Op, Tree, Val};
use crate::code::{BinOp, TernOp, UnOp};
use crate::semantics;

/// What became of an operation.
pub(super) enum Folded {
    Word(u32),
    Same(Val),
    No,
}

/// Folds an operation whose operands are known, or whose result is one of them.
pub(super) fn simplify(tree: &Tree, op: Op) -> Folded {
    let word = |val: Val| tree.constant(val);
    match op {
        Op::Const(value) => Folded::Word(value),
        Op::Un(UnOp::Move, a) => Folded::Same(a),
        Op::Un(un, a) => word(a).map_or(Folded::No, |a| Folded::Word(semantics::unary(un, a))),
        Op::Bin(bin, a, b) => match (word(a), word(b)) {
            (Some(a), Some(b)) => Folded::Word(semantics::binary(bin, a, b)),
            (None, Some(b)) => right(bin, a, b),
            (Some(a), None) => left(bin, a, b),
            _ => Folded::No,
        },
        Op::Tern(TernOp::Select, cond, accept, reject) => match word(cond) {
            Some(0) => Folded::Same(reject),
            Some(_) => Folded::Same(accept),
            None if accept == reject => Folded::Same(accept),
            None => Folded::No,
        },
        Op::Tern(tern, a, b, c) => match (word(a), word(b), word(c)) {
            (Some(a), Some(b), Some(c)) => Folded::Word(semantics::ternary(tern, a, b, c)),
            _ => Folded::No,
        },
        Op::Check { index, length, .. } => match (word(index), word(length)) {
            (Some(i), Some(n)) if i < n => Folded::Same(index),
            (None, Some(n)) if bounded(tree, index, n) => Folded::Same(index),
            _ => Folded::No,
        },
        _ => Folded::No,
    }
}

fn right(op: BinOp, a: Val, b: u32) -> Folded {
    match (op, b) {
        (BinOp::Add | BinOp::Sub | BinOp::Or | BinOp::Xor | BinOp::Shl | BinOp::ShrU | BinOp::ShrI, 0) => {
            Folded::Same(a)
        }
        (BinOp::Mul | BinOp::DivU, 1) | (BinOp::And, u32::MAX) => Folded::Same(a),
        (BinOp::Mul | BinOp::And, 0) => Folded::Word(0),
        _ => Folded::No,
    }
}

fn left(op: BinOp, a: u32, b: Val) -> Folded {
    match (op, a) {
        (BinOp::Add | BinOp::Or | BinOp::Xor, 0) | (BinOp::Mul, 1) | (BinOp::And, u32::MAX) => Folded::Same(b),
        (BinOp::Mul | BinOp::And, 0) => Folded::Word(0),
        _ => Folded::No,
    }
}

/// Whether an index is below `length` whatever its operands are.
fn bounded(tree: &Tree, index: Val, length: u32) -> bool {
    let below = |val: Val| tree.constant(val).is_some_and(|word| word < length);
    match tree.op(index) {
        Op::Bin(BinOp::And | BinOp::MinU, a, b) => below(a) || below(b),
        Op::Bin(BinOp::RemU, _, b) => tree.constant(b).is_some_and(|word| word != 0 && word <= length),
        Op::Bin(BinOp::ShrU, _, b) => tree.constant(b).is_some_and(|s| u32::MAX.wrapping_shr(s) < length),
        Op::Un(UnOp::CountOneBits | UnOp::CountLeadingZeros | UnOp::CountTrailingZeros, _) => length > 32,
        _ => false,
    }
}

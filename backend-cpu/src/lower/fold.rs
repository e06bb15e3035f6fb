//! Constant folding and the few algebraic rules that inlining makes worth while. Integers only: no rule changes a bit.

use super::tree::{Builtin, Op, Tree, Val};
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
            (None, Some(b)) => right(tree, bin, a, b),
            (Some(a), None) => left(tree, bin, a, b),
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
            (None, Some(n)) if greatest(tree, index, DEPTH) < n => Folded::Same(index),
            _ => Folded::No,
        },
        _ => Folded::No,
    }
}

fn right(tree: &Tree, op: BinOp, a: Val, b: u32) -> Folded {
    let most = || greatest(tree, a, DEPTH);
    match (op, b) {
        (BinOp::Add | BinOp::Sub | BinOp::Or | BinOp::Xor | BinOp::Shl | BinOp::ShrU | BinOp::ShrI, 0) => {
            Folded::Same(a)
        }
        (BinOp::Mul | BinOp::DivU, 1) | (BinOp::And, u32::MAX) => Folded::Same(a),
        (BinOp::Mul | BinOp::And, 0) => Folded::Word(0),
        (BinOp::LeU, _) if most() <= b => Folded::Word(u32::MAX),
        (BinOp::LtU, _) if most() < b => Folded::Word(u32::MAX),
        // A mask of low bits that the word does not exceed.
        (BinOp::And, _) if b & b.wrapping_add(1) == 0 && most() <= b => Folded::Same(a),
        (BinOp::MinU, _) if most() <= b => Folded::Same(a),
        (BinOp::RemU, _) if most() < b => Folded::Same(a),
        _ => Folded::No,
    }
}

fn left(tree: &Tree, op: BinOp, a: u32, b: Val) -> Folded {
    match (op, a) {
        (BinOp::Add | BinOp::Or | BinOp::Xor, 0) | (BinOp::Mul, 1) | (BinOp::And, u32::MAX) => Folded::Same(b),
        (BinOp::Mul | BinOp::And | BinOp::Shl | BinOp::ShrU | BinOp::ShrI, 0) => Folded::Word(0),
        (BinOp::LeU, _) if greatest(tree, b, DEPTH) < a => Folded::Word(0),
        (BinOp::LtU, _) if greatest(tree, b, DEPTH) <= a => Folded::Word(0),
        _ => Folded::No,
    }
}

/// How deep bounds are looked for.
pub(super) const DEPTH: u32 = 4;

/// A word that a value does not exceed, whatever its operands are.
pub(super) fn greatest(tree: &Tree, val: Val, depth: u32) -> u32 {
    if depth == 0 {
        return tree.constant(val).unwrap_or(u32::MAX);
    }
    let of = |val: Val| greatest(tree, val, depth - 1);
    let shift = |val: Val| tree.constant(val).filter(|by| *by < 32);
    match tree.op(val) {
        Op::Const(word) => word,
        Op::Builtin(Builtin::LocalId(axis)) => tree.workgroup_size[axis as usize].saturating_sub(1),
        Op::Builtin(Builtin::LocalIndex) => tree.workgroup_size.iter().product::<u32>().saturating_sub(1),
        Op::Check { index, length, .. } => of(index).min(of(length).saturating_sub(1)),
        Op::Bin(BinOp::And | BinOp::MinU, a, b) => of(a).min(of(b)),
        Op::Bin(BinOp::MaxU, a, b) | Op::Tern(TernOp::Select, _, a, b) => of(a).max(of(b)),
        // All bits below the highest that either can have.
        Op::Bin(BinOp::Or | BinOp::Xor, a, b) => u32::MAX.checked_shr((of(a) | of(b)).leading_zeros()).unwrap_or(0),
        Op::Bin(BinOp::Add, a, b) => of(a).saturating_add(of(b)),
        Op::Bin(BinOp::Mul, a, b) => of(a).saturating_mul(of(b)),
        Op::Bin(BinOp::RemU, a, b) => match tree.constant(b) {
            Some(word) if word != 0 => of(a).min(word - 1),
            _ => u32::MAX,
        },
        Op::Bin(BinOp::ShrU, a, by) => shift(by).map_or_else(|| of(a), |by| of(a) >> by),
        Op::Bin(BinOp::Shl, a, by) => shift(by).and_then(|by| of(a).checked_mul(1 << by)).unwrap_or(u32::MAX),
        Op::Un(UnOp::CountOneBits | UnOp::CountLeadingZeros | UnOp::CountTrailingZeros, _) => 32,
        _ => u32::MAX,
    }
}

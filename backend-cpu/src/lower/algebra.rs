//! Algebra: rules on integers and truth values, applied as values are defined.
//!
//! WGSL has no carry, no signed high product and no arithmetic on truth values, so exact arithmetic is written in
//! `select`s. A truth value is a word of zeros or ones, the integer 0 or −1; with that, `x + select(0, 1, c)` is
//! `x - c`, and so on. Invariant: every rule holds for all words, and none makes more operations than it takes away.

use super::build::Builder;
use super::tree::{Op, Val};
use crate::code::{BinOp, TernOp, UnOp};

const ONES: u32 = u32::MAX;
const SIGN: u32 = 1 << 31;

/// How deep a truth value is looked for.
const DEPTH: u32 = 4;

impl Builder<'_> {
    /// A simpler value for an operation, if a rule has one.
    pub(super) fn rewrite(&mut self, op: Op) -> Option<Val> {
        match op {
            Op::Un(UnOp::Not, a) => self.not(a),
            Op::Bin(op, a, b) => match self.tree.constant(b) {
                Some(word) => self.with_constant(op, a, word),
                None if self.tree.constant(a).is_some() => self.after_constant(op, a, b),
                None => self.with_truth(op, a, b),
            },
            Op::Tern(TernOp::Select, cond, accept, reject) => self.choose(cond, accept, reject),
            _ => None,
        }
    }

    /// A value as another plus a constant.
    pub(super) fn split_sum(&mut self, sum: Val) -> (Val, u32) {
        match self.tree.op(sum) {
            Op::Const(word) => (self.constant(0), word),
            Op::Bin(BinOp::Add, base, more) => self.tree.constant(more).map_or((sum, 0), |more| (base, more)),
            _ => (sum, 0),
        }
    }

    fn not(&mut self, a: Val) -> Option<Val> {
        match self.tree.op(a) {
            Op::Un(UnOp::Not, x) => Some(x),
            Op::Bin(op, x, y) => opposite(op, x, y).map(|op| self.define(op)),
            _ => None,
        }
    }

    /// `a op word`.
    fn with_constant(&mut self, op: BinOp, a: Val, word: u32) -> Option<Val> {
        let inner = match self.tree.op(a) {
            Op::Bin(inner, x, y) => Some((inner, x, self.tree.constant(y))),
            _ => None,
        };
        let (op, x, word) = match (op, inner) {
            (BinOp::Sub, _) => (BinOp::Add, a, word.wrapping_neg()),
            (BinOp::Add, Some((BinOp::Add, x, Some(first)))) => (BinOp::Add, x, first.wrapping_add(word)),
            (BinOp::And, Some((BinOp::And, x, Some(first)))) => (BinOp::And, x, first & word),
            (BinOp::Shl | BinOp::ShrU, Some((same, x, Some(first)))) if same == op && (first | word) < 32 => {
                if first + word >= 32 {
                    return Some(self.constant(0));
                }
                (op, x, first + word)
            }
            // The mask keeps all that the shift leaves.
            (BinOp::And, Some((BinOp::ShrU, _, Some(by)))) if by < 32 && ONES >> by & !word == 0 => return Some(a),
            (BinOp::DivU, _) if word.is_power_of_two() => (BinOp::ShrU, a, word.trailing_zeros()),
            (BinOp::RemU, _) if word.is_power_of_two() => (BinOp::And, a, word - 1),
            (BinOp::Eq | BinOp::Ne, _) if word == 0 => return self.is_zero(a, op == BinOp::Eq),
            _ => return None,
        };
        let word = self.constant(word);
        Some(self.define(Op::Bin(op, x, word)))
    }

    /// `word op b`: constants stand on the right where they can.
    fn after_constant(&mut self, op: BinOp, a: Val, b: Val) -> Option<Val> {
        match op {
            BinOp::Sub if self.tree.constant(a) == Some(0) => Some(self.define(Op::Un(UnOp::NegI, b))),
            // Products keep their order: high products are found by it.
            op if op.is_commutative() && op != BinOp::Mul => Some(self.define(Op::Bin(op, b, a))),
            _ => None,
        }
    }

    /// `a = 0`, or `a ≠ 0`.
    fn is_zero(&mut self, a: Val, equal: bool) -> Option<Val> {
        let Op::Bin(op, x, y) = self.tree.op(a) else { return None };
        let negative = match (op, self.tree.constant(y)) {
            (BinOp::And, Some(1)) if self.is_truth(x, DEPTH) => x,
            (BinOp::ShrU, Some(31)) | (BinOp::And, Some(SIGN)) => {
                let zero = self.constant(0);
                self.define(Op::Bin(BinOp::LtI, x, zero))
            }
            _ => return None,
        };
        Some(if equal { self.define(Op::Un(UnOp::Not, negative)) } else { negative })
    }

    /// Sums with a truth value as 0 or 1, and signed high products.
    fn with_truth(&mut self, op: BinOp, a: Val, b: Val) -> Option<Val> {
        match op {
            BinOp::Add => {
                let found = self.bit(b).map(|t| (a, t)).or_else(|| self.bit(a).map(|t| (b, t)));
                if let Some((x, truth)) = found {
                    return Some(self.define(Op::Bin(BinOp::Sub, x, truth)));
                }
                let negated = self.negated(b).map(|n| (a, n)).or_else(|| self.negated(a).map(|n| (b, n)));
                negated.map(|(x, n)| self.define(Op::Bin(BinOp::Sub, x, n)))
            }
            BinOp::Sub => {
                if let Some(other) = self.bit(b).or_else(|| self.negated(b)) {
                    return Some(self.define(Op::Bin(BinOp::Add, a, other)));
                }
                let (x, y) = self.signed_product(a, b)?;
                Some(self.define(Op::Bin(BinOp::MulHighI, x, y)))
            }
            _ => None,
        }
    }

    /// x of `-x`.
    fn negated(&self, val: Val) -> Option<Val> {
        match self.tree.op(val) {
            Op::Un(UnOp::NegI, x) => Some(x),
            _ => None,
        }
    }

    /// The truth value of which this is the lowest bit.
    fn bit(&self, val: Val) -> Option<Val> {
        match self.tree.op(val) {
            Op::Bin(BinOp::And, truth, one) if self.tree.constant(one) == Some(1) => {
                self.is_truth(truth, DEPTH).then_some(truth)
            }
            _ => None,
        }
    }

    /// Whether a value is 0 or −1.
    fn is_truth(&self, val: Val, depth: u32) -> bool {
        let below = |x: Val| depth > 0 && self.is_truth(x, depth - 1);
        match self.tree.op(val) {
            Op::Const(word) => word == 0 || word == ONES,
            Op::Bin(BinOp::And | BinOp::Or | BinOp::Xor, a, b) => below(a) && below(b),
            Op::Bin(op, ..) => op.comparison().is_some(),
            Op::Un(UnOp::Not, a) => below(a),
            Op::Tern(TernOp::Select, _, a, b) => below(a) && below(b),
            _ => false,
        }
    }

    /// The factors x, y of a signed high product, the unsigned one less y where x < 0, and less x where y < 0.
    fn signed_product(&self, minuend: Val, last: Val) -> Option<(Val, Val)> {
        let factors = |val: Val| match self.tree.op(val) {
            Op::Bin(BinOp::MulHigh, x, y) => Some((x, y)),
            _ => None,
        };
        if let Some((x, y)) = factors(minuend) {
            let positive = self.tree.constant(y).is_some_and(|word| word < SIGN);
            return (positive && self.is_where_negative(last, x, y)).then_some((x, y));
        }
        let Op::Bin(BinOp::Sub, product, first) = self.tree.op(minuend) else { return None };
        let (x, y) = factors(product)?;
        let both = |p, q| self.is_where_negative(p, x, y) && self.is_where_negative(q, y, x);
        (both(first, last) || both(last, first)).then_some((x, y))
    }

    /// Whether a value is `other` where `sign` is negative, else 0.
    fn is_where_negative(&self, val: Val, sign: Val, other: Val) -> bool {
        let test = |t: Val| matches!(self.tree.op(t), Op::Bin(BinOp::LtI, x, zero) if x == sign && self.tree.constant(zero) == Some(0));
        match self.tree.op(val) {
            Op::Bin(BinOp::And, p, q) => (test(p) && q == other) || (test(q) && p == other),
            _ => false,
        }
    }

    /// `cond ? accept : reject`.
    fn choose(&mut self, cond: Val, accept: Val, reject: Val) -> Option<Val> {
        let (yes, no) = (self.tree.constant(accept), self.tree.constant(reject));
        if let Some(inverse) = self.inverse(cond) {
            return Some(self.select(inverse, reject, accept));
        }
        let op = match (yes, no) {
            (Some(ONES), Some(0)) => return Some(cond),
            (Some(0), Some(ONES)) => Op::Un(UnOp::Not, cond),
            (_, Some(0)) => Op::Bin(BinOp::And, cond, accept),
            (Some(ONES), _) => Op::Bin(BinOp::Or, cond, reject),
            (Some(0), Some(1)) => {
                let other = self.define(Op::Un(UnOp::Not, cond));
                Op::Bin(BinOp::And, other, reject)
            }
            _ => {
                let magnitude = self.negated(accept) == Some(reject) && self.is_negative(cond, reject);
                return magnitude.then(|| self.define(Op::Un(UnOp::AbsI, reject)));
            }
        };
        Some(self.define(op))
    }

    /// A simpler condition that holds where this one does not.
    fn inverse(&mut self, cond: Val) -> Option<Val> {
        match self.tree.op(cond) {
            Op::Un(UnOp::Not, x) => Some(x),
            // The opposite of an order has its operands exchanged, so the constant then stands on the right.
            Op::Bin(op @ (BinOp::LtU | BinOp::LeU | BinOp::LtI | BinOp::LeI), x, y)
                if self.tree.constant(x).is_some() =>
            {
                opposite(op, x, y).map(|op| self.define(op))
            }
            _ => None,
        }
    }

    /// Whether a condition is `x < 0`.
    fn is_negative(&self, cond: Val, x: Val) -> bool {
        match self.tree.op(cond) {
            Op::Bin(BinOp::LtI, y, zero) => x == y && self.tree.constant(zero) == Some(0),
            _ => false,
        }
    }
}

/// The comparison that holds where `x op y` does not. Order of f32 has none: both fail for NaN.
fn opposite(op: BinOp, x: Val, y: Val) -> Option<Op> {
    Some(match op {
        BinOp::Eq => Op::Bin(BinOp::Ne, x, y),
        BinOp::Ne => Op::Bin(BinOp::Eq, x, y),
        BinOp::LtU => Op::Bin(BinOp::LeU, y, x),
        BinOp::LeU => Op::Bin(BinOp::LtU, y, x),
        BinOp::LtI => Op::Bin(BinOp::LeI, y, x),
        BinOp::LeI => Op::Bin(BinOp::LtI, y, x),
        BinOp::EqF => Op::Bin(BinOp::NeF, x, y),
        BinOp::NeF => Op::Bin(BinOp::EqF, x, y),
        _ => return None,
    })
}

//! Fusion: an operation whose only reader is the next one joins it.
//!
//! A pass over the lanes costs the fetch of an instruction and loads and stores of rows, whatever it computes. So a
//! vector register that is written once and read once, in one straight run of code, disappears: its operation moves to
//! its reader, as a [`Pair`], an [`Inst::Choose`] or an [`Inst::Switch`]. Invariant: nothing between the two writes
//! what the first one reads, and both run with the same lanes active. Uniform work stays apart: it is done once and not
//! once a lane.

use std::collections::HashSet;

use super::emit::Linear;
use super::regs::Virtual;
use crate::code::{BinOp, Compare, Inst, Pair, Parts, QuadOp, TernOp, Test, UnOp};

/// How far back the first operation may be: its operands live until the second one.
const REACH: usize = 24;

/// How often registers are accessed.
#[derive(Clone, Copy, Default)]
struct Uses {
    writes: u32,
    reads: u32,
}

/// Fuses what can be fused.
pub(super) fn fuse(linear: &mut Linear) {
    let mut fusion = Fusion::new(linear);
    for at in 0..linear.insts.len() {
        // A pair may take a third operation.
        while fusion.join(linear, at) {}
    }
    let gone = fusion.gone;
    remove(linear, &gone);
}

struct Fusion {
    uses: Vec<Uses>,
    /// First instruction of the straight run that holds each instruction.
    runs: Vec<usize>,
    gone: Vec<bool>,
}

impl Fusion {
    fn new(linear: &mut Linear) -> Self {
        let mut uses = vec![Uses::default(); linear.homes.len()];
        for inst in &linear.insts {
            inst.registers(&linear.atomics, |register, write| {
                let uses = &mut uses[register.index as usize];
                *(if write { &mut uses.writes } else { &mut uses.reads }) += 1;
            });
        }
        for (_, register) in &linear.inputs {
            uses[register.index as usize].writes += 1;
        }
        let targets: HashSet<u32> = linear.insts.iter_mut().filter_map(|i| i.target_mut().copied()).collect();
        let (mut runs, mut start) = (Vec::new(), 0);
        for (at, inst) in linear.insts.iter_mut().enumerate() {
            if targets.contains(&(at as u32)) {
                start = at;
            }
            runs.push(start);
            if inst.target_mut().is_some() {
                start = at + 1;
            }
        }
        Fusion { uses, runs, gone: vec![false; linear.insts.len()] }
    }

    /// Joins the instruction with one that makes an operand of it; whether there was one.
    fn join(&mut self, linear: &mut Linear, at: usize) -> bool {
        let inst = linear.insts[at];
        if let Inst::Fused { op: Pair::ShrXor, dst, a, b, c } = inst
            && a == c
            && self.mix(linear, at, dst, a, b).is_some()
        {
            return true;
        }
        let mut operands = Vec::new();
        inst.registers(&linear.atomics, |register, write| operands.extend((!write).then_some(register)));
        for operand in operands {
            let uses = self.uses[operand.index as usize];
            if operand.scalar || uses.writes != 1 || !(uses.reads == 1 || uses.reads == 2) {
                continue;
            }
            let Some(from) = self.maker(linear, at, operand) else { continue };
            let Some(joined) = together(linear.insts[from], inst, operand) else { continue };
            let mut read_again = 0;
            joined.registers(&linear.atomics, |register, _| read_again += u32::from(register == operand));
            let mut reads = 0;
            inst.registers(&linear.atomics, |register, write| reads += u32::from(register == operand && !write));
            if read_again != 0 || reads != uses.reads || !self.unchanged(linear, from, at) {
                continue;
            }
            linear.insts[at] = joined;
            self.gone[from] = true;
            return true;
        }
        false
    }

    /// Joins the last step of a hash, `x ^ (x >> by)`, with the two before it.
    fn mix(&mut self, linear: &mut Linear, at: usize, dst: Virtual, x: Virtual, by: Virtual) -> Option<()> {
        let step = |at: usize, x: Virtual| {
            let uses = self.uses[x.index as usize];
            // Both by the step itself: it was two operations on x.
            let from = (uses.writes == 1 && uses.reads == 2).then(|| self.maker(linear, at, x)).flatten()?;
            match linear.insts[from] {
                Inst::Fused { op: Pair::XorShrMul, a, b, c, .. } => Some((from, a, [b, c])),
                _ => None,
            }
        };
        let (second, x, last) = step(at, x)?;
        let (first, a, start) = step(second, x)?;
        if !(self.unchanged(linear, first, at) && self.unchanged(linear, second, at)) {
            return None;
        }
        linear.insts[at] = Inst::Mix { dst, a, by: [start[0], start[1], last[0], last[1], by] };
        (self.gone[first], self.gone[second]) = (true, true);
        Some(())
    }

    /// The instruction of this run that writes an operand.
    fn maker(&self, linear: &Linear, at: usize, operand: Virtual) -> Option<usize> {
        let first = self.runs[at].max(at.saturating_sub(REACH));
        (first..at).rev().filter(|i| !self.gone[*i]).find(|i| destination(&linear.insts[*i]) == Some(operand))
    }

    /// Whether the operands of an instruction still hold at a later one.
    fn unchanged(&self, linear: &Linear, from: usize, at: usize) -> bool {
        let mut operands = Vec::new();
        linear.insts[from].registers(&linear.atomics, |register, write| operands.extend((!write).then_some(register)));
        let mut same = true;
        for inst in &linear.insts[from + 1..at] {
            inst.registers(&linear.atomics, |register, write| same &= !(write && operands.contains(&register)));
        }
        same
    }
}

fn destination(inst: &Inst<Virtual>) -> Option<Virtual> {
    match *inst {
        Inst::Bin { dst, .. } | Inst::Fused { dst, .. } | Inst::Quad { dst, .. } | Inst::Choose { dst, .. } => {
            Some(dst)
        }
        _ => None,
    }
}

/// One instruction for two, the first of which makes operand `t` of the second.
fn together(first: Inst<Virtual>, second: Inst<Virtual>, t: Virtual) -> Option<Inst<Virtual>> {
    match (first, second) {
        (Inst::Bin { op: first, a, b, .. }, Inst::Bin { op: second, dst, a: x, b: y }) if !dst.scalar => {
            let (a, b) = row_first(first, a, b)?;
            let left = x == t || second.is_commutative();
            let c = if x == t { y } else { x };
            let op = Pair::of(Parts { first, second, words: [b.scalar, c.scalar], left })?;
            Some(Inst::Fused { op, dst, a, b, c })
        }
        (Inst::Fused { op: Pair::ShrXor, a, b, c, .. }, Inst::Bin { op: BinOp::Mul, dst, a: x, b: y }) => {
            let factor = if x == t { y } else { x };
            (a == c && factor.scalar).then_some(Inst::Fused { op: Pair::XorShrMul, dst, a, b, c: factor })
        }
        (Inst::Bin { op, a, b, .. }, Inst::Fused { op: pair, dst, a: x, b: y, c }) if c == t && x != t && y != t => {
            let (op, [a, b, c, d]) = quad(op, [a, b], pair, [x, y])?;
            let (c, d) = if op.is_product() { row_first(BinOp::Mul, c, d)? } else { (c, d) };
            let (a, b) = if op.is_product() { row_first(BinOp::Mul, a, b)? } else { (a, b) };
            (!a.scalar && !c.scalar).then_some(Inst::Quad { op, dst, a, b, c, d })
        }
        (
            Inst::Quad { op: QuadOp::EqLtU, a, b, c, d, .. },
            Inst::Fused { op: Pair::LtUOr, dst, a: x, b: y, c: last },
        ) => {
            let same = (a, b) == (x, y) || (a, b) == (y, x);
            (same && last == t).then_some(Inst::Quad { op: QuadOp::LtWide, dst, a: x, b: y, c, d })
        }
        (Inst::Quad { op, a, b, c, d, .. }, Inst::Un { op: UnOp::Not, dst, .. }) => {
            let op = match op {
                QuadOp::LtWide => QuadOp::GeWide,
                QuadOp::GeWide => QuadOp::LtWide,
                _ => return None,
            };
            Some(Inst::Quad { op, dst, a, b, c, d })
        }
        (Inst::Bin { op: test, a, b, .. }, Inst::Tern { op: TernOp::Select, dst, a: cond, b: accept, c: reject }) => {
            let (a, b) = row_first(test, a, b).unwrap_or((a, b));
            let test = Test { op: test.comparison()?, a, b };
            let (test, [accept, reject]) =
                if a.scalar { (test.negated(), [reject, accept]) } else { (test, [accept, reject]) };
            let chosen = cond == t && !test.a.scalar && !dst.scalar;
            chosen.then_some(Inst::Choose { test, dst, accept, reject })
        }
        (
            Inst::Choose { test: inner, accept: second, reject, .. },
            Inst::Choose { test, dst, accept: first, reject: other },
        ) => {
            let same = test.a == inner.a && test.op == Compare::Eq && inner.op == Compare::Eq;
            let words = [test.b, inner.b];
            let switch = same && words.iter().all(|word| word.scalar) && other == t && first != t;
            switch.then_some(Inst::Switch { dst, a: test.a, words, arms: [first, second, reject] })
        }
        _ => None,
    }
}

/// The operation on four words that an operation on `a` and `b` and a pair are, whose third operand is the former's
/// result, and whose first two are `x` and `y`.
fn quad<R>(first: BinOp, [a, b]: [R; 2], pair: Pair, [x, y]: [R; 2]) -> Option<(QuadOp, [R; 4])> {
    Some(match (first, pair) {
        (BinOp::Mul, Pair::MulAdd | Pair::MulWordAdd) => (QuadOp::MulMulAdd, [x, y, a, b]),
        (BinOp::Mul, Pair::MulSub | Pair::MulWordSub) => (QuadOp::MulMulSub, [x, y, a, b]),
        (BinOp::Mul, Pair::MulRest | Pair::MulWordRest) => (QuadOp::MulMulSub, [a, b, x, y]),
        (BinOp::ShrU, Pair::ShlOr | Pair::ShlRowOr) => (QuadOp::ShlShrOr, [x, y, a, b]),
        (BinOp::Shl, Pair::ShrOr | Pair::ShrRowOr) => (QuadOp::ShlShrOr, [a, b, x, y]),
        // A truth value is −1.
        (BinOp::LtU, Pair::AddSub) => (QuadOp::AddCarry, [x, y, a, b]),
        (BinOp::LtU, Pair::SubAdd) => (QuadOp::SubBorrow, [x, y, a, b]),
        (BinOp::LtU, Pair::EqRowAnd | Pair::EqAnd) => (QuadOp::EqLtU, [x, y, a, b]),
        _ => return None,
    })
}

/// Operands in an order that puts a row first.
fn row_first(op: BinOp, a: Virtual, b: Virtual) -> Option<(Virtual, Virtual)> {
    match (a.scalar, b.scalar) {
        (false, _) => Some((a, b)),
        (true, false) if op.is_commutative() => Some((b, a)),
        _ => None,
    }
}

/// Removes instructions; whatever counts instructions follows.
pub(super) fn remove(linear: &mut Linear, gone: &[bool]) {
    let mut places = Vec::with_capacity(gone.len() + 1);
    let mut kept = 0;
    for gone in gone {
        places.push(kept);
        kept += u32::from(!gone);
    }
    places.push(kept);
    let place = |at: u32| places[at as usize];
    let mut index = 0;
    linear.insts.retain(|_| {
        index += 1;
        !gone[index - 1]
    });
    for inst in &mut linear.insts {
        if let Some(target) = inst.target_mut() {
            *target = place(*target);
        }
    }
    linear.homes.iter_mut().for_each(|home| *home = place(*home));
    linear.loops.iter_mut().for_each(|(from, to)| (*from, *to) = (place(*from), place(*to)));
}

//! Register code: instructions, operands and their disassembly.
//!
//! A vector register is a row of one 32-bit word a lane, a scalar register one word for the whole gang. Truth values
//! are 0 or all ones. Instructions are verified when they are built (registers, slots and targets in range), so
//! execution can index without further thought.

mod ops;

use std::fmt;

pub use ops::{AtomicOp, BinOp, Compare, Pair, QuadOp, TernOp, Test, UnOp};
pub(crate) use ops::{Parts, is_word, pairs};

/// Where a load, store or atomic goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mem {
    /// A bound buffer, by its place in the entry point's bindings.
    Buffer(u8),
    /// Workgroup memory.
    Workgroup,
    /// Private and function memory that is indexed at run time: one column a lane.
    Private,
}

/// An operand: a vector register, or a scalar register that every lane shares.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Reg(u16);

const SCALAR: u16 = 1 << 15;

impl Reg {
    /// Vector register `index`.
    pub const fn vector(index: u16) -> Self {
        Reg(index)
    }

    /// Scalar register `index`.
    pub const fn scalar(index: u16) -> Self {
        Reg(index | SCALAR)
    }

    /// Whether all lanes share it.
    #[inline(always)]
    pub const fn is_scalar(self) -> bool {
        self.0 & SCALAR != 0
    }

    /// Its number in its file.
    #[inline(always)]
    pub const fn index(self) -> usize {
        (self.0 & !SCALAR) as usize
    }
}

impl fmt::Debug for Reg {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", if self.is_scalar() { 's' } else { 'v' }, self.index())
    }
}

/// A saved mask.
pub type Slot = u8;

/// Index of an instruction.
pub type Target = u32;

/// One instruction. It works on all lanes of a gang; only those marked *masked* look at which are active.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "operands are named by their role")]
pub enum Inst<R = Reg> {
    Un {
        op: UnOp,
        dst: R,
        a: R,
    },
    Bin {
        op: BinOp,
        dst: R,
        a: R,
        b: R,
    },
    Tern {
        op: TernOp,
        dst: R,
        a: R,
        b: R,
        c: R,
    },
    /// Two binary operations in one pass.
    Fused {
        op: Pair,
        dst: R,
        a: R,
        b: R,
        c: R,
    },
    /// Several binary operations on four words in one pass.
    Quad {
        op: QuadOp,
        dst: R,
        a: R,
        b: R,
        c: R,
        d: R,
    },
    /// The end of many hashes: `x ^= x >> by[0]; x *= by[1]; x ^= x >> by[2]; x *= by[3]; dst = x ^ (x >> by[4])`,
    /// beginning with `a`.
    Mix {
        dst: R,
        a: R,
        by: [R; 5],
    },
    /// `dst = test ? accept : reject`.
    Choose {
        test: Test<R>,
        dst: R,
        accept: R,
        reject: R,
    },
    /// `dst = a == words[0] ? arms[0] : a == words[1] ? arms[1] : arms[2]`.
    Switch {
        dst: R,
        a: R,
        words: [R; 2],
        arms: [R; 3],
    },
    /// Masked copy.
    Blend {
        dst: R,
        a: R,
    },
    /// `dst = min(index, length - 1)`; trapping runs test active lanes.
    Check {
        dst: R,
        index: R,
        length: R,
        site: u32,
    },
    ArrayLength {
        dst: R,
        buffer: u8,
        offset: u32,
        stride: u32,
    },
    Load {
        dst: R,
        mem: Mem,
        addr: R,
        offset: u32,
        site: u32,
    },
    /// Masked.
    Store {
        mem: Mem,
        addr: R,
        value: R,
        offset: u32,
        site: u32,
    },
    /// Loads of four neighbouring words of each lane; the site of each is `step` behind the one before.
    LoadRecord {
        dst: [R; 4],
        mem: Mem,
        addr: R,
        offset: u32,
        site: u32,
        step: u8,
    },
    /// Masked: stores of four neighbouring words of each lane.
    StoreRecord {
        mem: Mem,
        addr: R,
        values: [R; 4],
        offset: u32,
        site: u32,
        step: u8,
    },
    /// Private memory only; not masked.
    Zero {
        offset: u32,
        count: u32,
    },
    /// Masked, lanes in order. `dst` and `compare` stand in a table of their own.
    Atomic {
        index: u32,
    },
    Barrier {
        site: u32,
    },
    Tally {
        index: u32,
    },
    Jump {
        to: Target,
    },
    /// A jump where a test on scalars passes.
    JumpIf {
        test: Test<R>,
        to: Target,
    },
    /// A back-edge: fuel, then a jump.
    Back {
        to: Target,
        site: u32,
    },
    /// A back-edge that is taken where a test on scalars passes.
    BackIf {
        test: Test<R>,
        to: Target,
        site: u32,
    },
    /// Lanes that fail wait in `slot`: `slot = exec; exec &= test`. When none passes: a jump, and `exec` stays.
    If {
        test: Test<R>,
        slot: Slot,
        to: Target,
    },
    /// As [`Inst::If`], with the lanes that fail in `slot + 1` as well. When none passes, they go on at `to`.
    Split {
        test: Test<R>,
        slot: Slot,
        to: Target,
    },
    /// `exec = slot + 1`, and a jump when that is empty.
    Else {
        slot: Slot,
        to: Target,
    },
    /// `exec = slot`, and a jump when that is empty.
    Restore {
        slot: Slot,
        to: Target,
    },
    /// `slot = exec`.
    Save {
        slot: Slot,
    },
    /// All active lanes leave: slots from `from` on lose them, `exec = 0`, then a jump.
    Leave {
        from: Slot,
        to: Target,
    },
    /// Lanes that pass leave: slots from `from` on and `exec` lose them; a jump when no lane is left.
    Exit {
        test: Test<R>,
        from: Slot,
        to: Target,
    },
    /// A back-edge of the lanes that pass; those that fail leave: slots from `from` on and `exec` lose them.
    Again {
        test: Test<R>,
        from: Slot,
        to: Target,
        site: u32,
    },
    End,
}

/// Operands of an [`Inst::Atomic`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AtomicArgs<R = Reg> {
    /// The operation.
    pub op: AtomicOp,
    /// The memory.
    pub mem: Mem,
    /// Word address.
    pub addr: R,
    /// Words added to it.
    pub offset: u32,
    /// Operand.
    pub value: R,
    /// Comparand.
    pub compare: Option<R>,
    /// Where the old value goes.
    pub dst: Option<R>,
    /// Source line.
    pub site: u32,
}

impl<R: Copy> Inst<R> {
    /// Calls `f` with each register, reads first; the flag is true for the one that is written.
    pub(crate) fn registers(&self, atomics: &[AtomicArgs<R>], mut f: impl FnMut(R, bool)) {
        if let Inst::Atomic { index } = self {
            let args = &atomics[*index as usize];
            f(args.addr, false);
            f(args.value, false);
            args.compare.into_iter().for_each(|r| f(r, false));
            args.dst.into_iter().for_each(|r| f(r, true));
        }
        let _ = self.map(&mut |r, write| f(r, write));
    }

    /// The same instruction on other registers. The operands of an atomic stand elsewhere and are left alone.
    pub(crate) fn map<Q>(&self, f: &mut impl FnMut(R, bool) -> Q) -> Inst<Q> {
        match *self {
            Inst::Un { op, dst, a } => {
                let a = f(a, false);
                Inst::Un { op, dst: f(dst, true), a }
            }
            Inst::Bin { op, dst, a, b } => {
                let (a, b) = (f(a, false), f(b, false));
                Inst::Bin { op, dst: f(dst, true), a, b }
            }
            Inst::Tern { op, dst, a, b, c } => {
                let (a, b, c) = (f(a, false), f(b, false), f(c, false));
                Inst::Tern { op, dst: f(dst, true), a, b, c }
            }
            Inst::Fused { op, dst, a, b, c } => {
                let (a, b, c) = (f(a, false), f(b, false), f(c, false));
                Inst::Fused { op, dst: f(dst, true), a, b, c }
            }
            Inst::Quad { op, dst, a, b, c, d } => {
                let (a, b, c, d) = (f(a, false), f(b, false), f(c, false), f(d, false));
                Inst::Quad { op, dst: f(dst, true), a, b, c, d }
            }
            Inst::Mix { dst, a, by } => {
                let (a, by) = (f(a, false), by.map(|r| f(r, false)));
                Inst::Mix { dst: f(dst, true), a, by }
            }
            Inst::Choose { test, dst, accept, reject } => {
                let (test, accept, reject) = (test.map(f), f(accept, false), f(reject, false));
                Inst::Choose { test, dst: f(dst, true), accept, reject }
            }
            Inst::Switch { dst, a, words, arms } => {
                let (a, words, arms) = (f(a, false), words.map(|r| f(r, false)), arms.map(|r| f(r, false)));
                Inst::Switch { dst: f(dst, true), a, words, arms }
            }
            Inst::Blend { dst, a } => {
                let a = f(a, false);
                Inst::Blend { dst: f(dst, true), a }
            }
            Inst::Check { dst, index, length, site } => {
                let (index, length) = (f(index, false), f(length, false));
                Inst::Check { dst: f(dst, true), index, length, site }
            }
            Inst::ArrayLength { dst, buffer, offset, stride } => {
                Inst::ArrayLength { dst: f(dst, true), buffer, offset, stride }
            }
            Inst::Load { dst, mem, addr, offset, site } => {
                let addr = f(addr, false);
                Inst::Load { dst: f(dst, true), mem, addr, offset, site }
            }
            Inst::Store { mem, addr, value, offset, site } => {
                Inst::Store { mem, addr: f(addr, false), value: f(value, false), offset, site }
            }
            Inst::LoadRecord { dst, mem, addr, offset, site, step } => {
                let addr = f(addr, false);
                Inst::LoadRecord { dst: dst.map(|r| f(r, true)), mem, addr, offset, site, step }
            }
            Inst::StoreRecord { mem, addr, values, offset, site, step } => {
                let (addr, values) = (f(addr, false), values.map(|r| f(r, false)));
                Inst::StoreRecord { mem, addr, values, offset, site, step }
            }
            Inst::Atomic { index } => Inst::Atomic { index },
            Inst::JumpIf { test, to } => Inst::JumpIf { test: test.map(f), to },
            Inst::BackIf { test, to, site } => Inst::BackIf { test: test.map(f), to, site },
            Inst::If { test, slot, to } => Inst::If { test: test.map(f), slot, to },
            Inst::Split { test, slot, to } => Inst::Split { test: test.map(f), slot, to },
            Inst::Exit { test, from, to } => Inst::Exit { test: test.map(f), from, to },
            Inst::Again { test, from, to, site } => Inst::Again { test: test.map(f), from, to, site },
            Inst::Else { slot, to } => Inst::Else { slot, to },
            Inst::Zero { offset, count } => Inst::Zero { offset, count },
            Inst::Barrier { site } => Inst::Barrier { site },
            Inst::Tally { index } => Inst::Tally { index },
            Inst::Jump { to } => Inst::Jump { to },
            Inst::Restore { slot, to } => Inst::Restore { slot, to },
            Inst::Save { slot } => Inst::Save { slot },
            Inst::Leave { from, to } => Inst::Leave { from, to },
            Inst::Back { to, site } => Inst::Back { to, site },
            Inst::End => Inst::End,
        }
    }

    /// Where a jump goes.
    pub(crate) fn target_mut(&mut self) -> Option<&mut Target> {
        match self {
            Inst::Jump { to }
            | Inst::JumpIf { to, .. }
            | Inst::Back { to, .. }
            | Inst::BackIf { to, .. }
            | Inst::If { to, .. }
            | Inst::Split { to, .. }
            | Inst::Else { to, .. }
            | Inst::Restore { to, .. }
            | Inst::Leave { to, .. }
            | Inst::Exit { to, .. }
            | Inst::Again { to, .. } => Some(to),
            _ => None,
        }
    }
}

/// A built-in that is written to a register before the first instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Input {
    pub(crate) builtin: crate::lower::Builtin,
    pub(crate) reg: Reg,
}

/// Executable code of one entry point with its overrides applied.
#[derive(Debug)]
pub struct Code {
    pub(crate) insts: Vec<Inst>,
    pub(crate) atomics: Vec<AtomicArgs>,
    pub(crate) inputs: Vec<Input>,
    /// Scalar registers that hold constants: they come first in the scalar file.
    pub(crate) constants: Vec<u32>,
    pub(crate) vectors: usize,
    pub(crate) scalars: usize,
    pub(crate) slots: usize,
    pub(crate) workgroup_size: [u32; 3],
    pub(crate) workgroup_words: u32,
    pub(crate) private_words: u32,
    /// Several workgroups may share a gang: there is no barrier and no workgroup memory.
    pub(crate) mergeable: bool,
    pub(crate) sites: Vec<naga::Span>,
    pub(crate) costs: Vec<crate::lower::Cost>,
}

impl Code {
    /// Number of instructions: the machine cost that snapshots keep.
    pub fn instructions(&self) -> usize {
        self.insts.len()
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.workgroup_size;
        writeln!(f, "; workgroup {x} x {y} x {z}, {} vector and {} scalar registers", self.vectors, self.scalars)?;
        if self.workgroup_words + self.private_words > 0 {
            writeln!(f, "; {} words of workgroup memory, {} private", self.workgroup_words, self.private_words)?;
        }
        for (index, value) in self.constants.iter().enumerate() {
            writeln!(f, "{:?} = {value:#x}", Reg::scalar(index as u16))?;
        }
        for input in &self.inputs {
            writeln!(f, "{:?} = {:?}", input.reg, input.builtin)?;
        }
        for (index, inst) in self.insts.iter().enumerate() {
            match inst {
                Inst::Atomic { index: args } => writeln!(f, "{index:5}  {:?}", self.atomics[*args as usize])?,
                _ => writeln!(f, "{index:5}  {inst:?}")?,
            }
        }
        Ok(())
    }
}

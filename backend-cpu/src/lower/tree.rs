//! The tree between naga IR and register code: scalar values, scalar variables, structured control flow.
//!
//! Calls are inlined and vectors, matrices and structs split into 32-bit scalars. A [`Val`] is defined once and is
//! visible in its block and the blocks inside it, as in naga; whatever outlives a block is a [`Var`] or memory. That is
//! the invariant that lets all arithmetic run unmasked: only [`Stmt::Set`], stores, atomics and exits consult masks.

use crate::code::{AtomicOp, BinOp, Mem, TernOp, UnOp};

/// A scalar value, defined once: index into [`Tree::vals`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Val(pub(crate) u32);

/// A mutable scalar, one of [`Tree::vars`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Var(pub(crate) u32);

/// An If, Loop or Region: index into tables of the later passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Construct(pub(crate) u32);

/// Index into [`Tree::sites`]: the source line of an access that may trap.
pub(crate) type Site = u32;

/// A built-in input of an invocation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Builtin {
    LocalId(u8),
    GlobalId(u8),
    GroupId(u8),
    NumGroups(u8),
    LocalIndex,
}

/// How a [`Val`] is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    Const(u32),
    Builtin(Builtin),
    Get(Var),
    Un(UnOp, Val),
    Bin(BinOp, Val, Val),
    Tern(TernOp, Val, Val, Val),
    /// `min(index, length - 1)`; a trap in trapping runs when the index is out of range.
    Check {
        index: Val,
        length: Val,
        site: Site,
    },
    /// Elements of a runtime-sized array: (words of the binding − `offset`) / `stride`.
    ArrayLength {
        buffer: u8,
        offset: u32,
        stride: u32,
    },
    /// The word at `addr + offset`.
    Load {
        mem: Mem,
        addr: Val,
        offset: u32,
        site: Site,
    },
    /// Defined by the [`Stmt::Atomic`] that names it.
    Atomic,
}

/// One read-modify-write.
#[derive(Clone, Debug)]
pub(crate) struct Atomic {
    pub(crate) op: AtomicOp,
    pub(crate) mem: Mem,
    pub(crate) addr: Val,
    pub(crate) offset: u32,
    pub(crate) value: Val,
    pub(crate) compare: Option<Val>,
    pub(crate) result: Option<Val>,
    pub(crate) site: Site,
}

/// A statement.
#[derive(Clone, Debug)]
pub(crate) enum Stmt {
    Def(Val),
    Set(Var, Val),
    /// The value a variable has before anything is set; sunk to where the variable is used.
    Init(Var, Val),
    Store {
        mem: Mem,
        addr: Val,
        offset: u32,
        value: Val,
        site: Site,
    },
    /// Sets `count` words of private memory from `offset` on to zero.
    Zero {
        offset: u32,
        count: u32,
    },
    Atomic(Atomic),
    Barrier(Site),
    Tally(u32),
    If {
        id: Construct,
        cond: Val,
        accept: Block,
        reject: Block,
    },
    Loop {
        id: Construct,
        body: Block,
        continuing: Block,
        break_if: Option<Val>,
        site: Site,
    },
    /// A block that [`Stmt::Break`] leaves: a switch, or an inlined call.
    Region {
        id: Construct,
        body: Block,
    },
    Break(Construct),
    Continue(Construct),
}

/// Statements in order.
pub(crate) type Block = Vec<Stmt>;

/// Static costs of a straight run of IR, multiplied by the invocations that execute it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cost {
    pub(crate) loads: u32,
    pub(crate) stores: u32,
    pub(crate) bytes: u32,
    pub(crate) atomics: u32,
    pub(crate) barriers: u32,
    /// Turns of loops that begin here.
    pub(crate) turns: u32,
}

/// A whole entry point.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    pub(crate) vals: Vec<Op>,
    pub(crate) vars: u32,
    pub(crate) body: Block,
    pub(crate) constructs: u32,
    pub(crate) sites: Vec<naga::Span>,
    pub(crate) costs: Vec<Cost>,
    /// Words of workgroup memory.
    pub(crate) workgroup_words: u32,
    /// Words of private memory of one invocation.
    pub(crate) private_words: u32,
    pub(crate) has_barrier: bool,
    pub(crate) workgroup_size: [u32; 3],
}

impl Tree {
    pub(crate) fn op(&self, val: Val) -> Op {
        self.vals[val.0 as usize]
    }

    pub(crate) fn constant(&self, val: Val) -> Option<u32> {
        match self.op(val) {
            Op::Const(c) => Some(c),
            _ => None,
        }
    }
}

impl Op {
    /// Calls `f` with each operand.
    pub(crate) fn operands(&self, mut f: impl FnMut(Val)) {
        match *self {
            Op::Const(_) | Op::Builtin(_) | Op::Get(_) | Op::ArrayLength { .. } | Op::Atomic => {}
            Op::Un(_, a) | Op::Load { addr: a, .. } => f(a),
            Op::Bin(_, a, b) | Op::Check { index: a, length: b, .. } => {
                f(a);
                f(b);
            }
            Op::Tern(_, a, b, c) => {
                f(a);
                f(b);
                f(c);
            }
        }
    }
}

impl Stmt {
    /// Calls `f` with each value that the statement itself reads (not those of blocks inside it).
    pub(crate) fn operands(&self, tree: &Tree, mut f: impl FnMut(Val)) {
        match self {
            Stmt::Def(val) => tree.op(*val).operands(f),
            Stmt::Set(_, val) | Stmt::Init(_, val) => f(*val),
            Stmt::Store { addr, value, .. } => {
                f(*addr);
                f(*value);
            }
            Stmt::Atomic(atomic) => {
                f(atomic.addr);
                f(atomic.value);
                atomic.compare.into_iter().for_each(f);
            }
            Stmt::If { cond, .. } => f(*cond),
            Stmt::Loop { break_if, .. } => break_if.iter().copied().for_each(f),
            _ => {}
        }
    }
}

//! Tree to linear code on virtual registers: where masks are needed, jumps where control is uniform.
//!
//! Invariant: code runs with at least one active lane. Whatever can leave no lane active jumps to the next place where
//! lanes wait ([`control`]).

mod control;

use std::collections::{HashMap, HashSet};

use control::Open;

use super::flow::{BlockId, Flow};
use super::regs::Virtual;
use super::tree::{Block, Builtin, Op, Stmt, Tree, Val, Var};
use crate::code::{AtomicArgs, Inst, UnOp};

/// Linear code before allocation.
pub(super) struct Linear {
    pub(super) insts: Vec<Inst<Virtual>>,
    pub(super) atomics: Vec<AtomicArgs<Virtual>>,
    pub(super) inputs: Vec<(Builtin, Virtual)>,
    /// Constant of each constant register.
    pub(super) constants: Vec<(Virtual, u32)>,
    /// For each virtual register the instruction where its lifetime can begin.
    pub(super) homes: Vec<u32>,
    pub(super) scalar: Vec<bool>,
    /// Instruction ranges of loops.
    pub(super) loops: Vec<(u32, u32)>,
    pub(super) slots: usize,
}

type Label = usize;

struct Emitter<'a> {
    tree: &'a Tree,
    flow: &'a Flow,
    out: Linear,
    places: Vec<Option<Virtual>>,
    vars: HashMap<Var, Virtual>,
    words: HashMap<u32, Virtual>,
    /// Values whose definition writes a variable's register directly.
    sunk: HashMap<Val, Var>,
    sunk_to: HashMap<Var, Vec<Val>>,
    skipped: HashSet<u32>,
    /// The value that each position's definition reads from a variable.
    reads: HashMap<u32, Val>,
    labels: Vec<u32>,
    open: Vec<Open>,
    block_starts: Vec<u32>,
    slots: usize,
    at: u32,
    block: BlockId,
    next_block: BlockId,
}

/// Emits a whole tree.
pub(super) fn emit(tree: &Tree, flow: &Flow) -> Linear {
    let out = Linear {
        insts: Vec::new(),
        atomics: Vec::new(),
        inputs: Vec::new(),
        constants: Vec::new(),
        homes: Vec::new(),
        scalar: Vec::new(),
        loops: Vec::new(),
        slots: 0,
    };
    let mut emitter = Emitter {
        tree,
        flow,
        out,
        places: vec![None; tree.vals.len()],
        vars: HashMap::new(),
        words: HashMap::new(),
        sunk: HashMap::new(),
        sunk_to: HashMap::new(),
        skipped: HashSet::new(),
        reads: reads(tree, flow),
        labels: Vec::new(),
        open: Vec::new(),
        block_starts: vec![0; flow.blocks.len()],
        slots: 0,
        at: 0,
        block: 0,
        next_block: 1,
    };
    let end = emitter.label();
    emitter.open.push(Open::program(end));
    emitter.block(&tree.body, 0, 0);
    emitter.bind(end);
    emitter.out.insts.push(Inst::End);
    emitter.finish()
}

impl Emitter<'_> {
    fn finish(mut self) -> Linear {
        for inst in &mut self.out.insts {
            if let Some(target) = inst.target_mut() {
                *target = self.labels[*target as usize];
            }
        }
        for (var, register) in &self.vars {
            self.out.homes[register.index as usize] = self.block_starts[self.flow.homes[var.0 as usize]];
        }
        self.out
    }

    fn label(&mut self) -> Label {
        self.labels.push(u32::MAX);
        self.labels.len() - 1
    }

    fn bind(&mut self, label: Label) {
        self.labels[label] = self.out.insts.len() as u32;
    }

    fn push(&mut self, inst: Inst<Virtual>) {
        self.out.insts.push(inst);
    }

    fn register(&mut self, scalar: bool) -> Virtual {
        self.out.homes.push(self.out.insts.len() as u32);
        self.out.scalar.push(scalar);
        Virtual { index: self.out.homes.len() as u32 - 1, scalar }
    }

    fn word(&mut self, word: u32) -> Virtual {
        if let Some(register) = self.words.get(&word) {
            return *register;
        }
        let register = self.register(true);
        self.words.insert(word, register);
        self.out.constants.push((register, word));
        register
    }

    fn variable(&mut self, var: Var) -> Virtual {
        if let Some(register) = self.vars.get(&var) {
            return *register;
        }
        let register = self.register(self.flow.is_uniform_var(var));
        self.vars.insert(var, register);
        register
    }

    fn place(&mut self, val: Val) -> Virtual {
        if let Some(word) = self.tree.constant(val) {
            return self.word(word);
        }
        self.places[val.0 as usize].expect("a value is defined before it is used")
    }

    /// Emits a block; `head` is how many statements stand before the head of the loop that it is the body of.
    fn block(&mut self, block: &Block, id: BlockId, head: usize) {
        let outer = std::mem::replace(&mut self.block, id);
        self.block_starts[id] = self.out.insts.len() as u32;
        self.find_sinks(block);
        for (index, stmt) in block.iter().enumerate() {
            if index == head {
                self.block_starts[id] = self.out.insts.len() as u32;
            }
            let at = self.at;
            self.at += 1;
            self.stmt(stmt, at);
            if matches!(stmt, Stmt::Break(_) | Stmt::Continue(_)) {
                break;
            }
        }
        self.block = outer;
    }

    fn child(&mut self, block: &Block) {
        self.body(block, 0);
    }

    /// Emits a block inside a construct.
    fn body(&mut self, block: &Block, head: usize) {
        let (at, next_block) = (self.at, self.next_block);
        self.next_block += 1;
        self.block(block, next_block, head);
        // Unreachable statements keep their numbers.
        (self.at, self.next_block) = (at, next_block);
        self.pass(block);
    }

    /// Counts the statements and blocks of a block that is not emitted, or was.
    fn pass(&mut self, block: &Block) {
        let (stmts, blocks) = count(block);
        self.at += stmts;
        self.next_block += blocks + 1;
    }

    /// Finds values that can be computed straight into the variable they are stored to.
    fn find_sinks(&mut self, block: &Block) {
        let mut at = self.at;
        let mut run_start = at;
        for stmt in block {
            let here = at;
            let (stmts, _) = count_stmt(stmt);
            at += stmts;
            match stmt {
                Stmt::Set(var, val) if self.can_sink(*var, *val, here, run_start) => {
                    self.sunk.insert(*val, *var);
                    self.sunk_to.entry(*var).or_default().push(*val);
                    self.skipped.insert(here);
                }
                Stmt::If { .. } | Stmt::Loop { .. } | Stmt::Region { .. } | Stmt::Break(_) | Stmt::Continue(_) => {
                    run_start = at;
                }
                _ => {}
            }
        }
    }

    fn can_sink(&self, var: Var, val: Val, set: u32, run_start: u32) -> bool {
        let span = self.flow.spans[val.0 as usize];
        let plain = !matches!(self.tree.op(val), Op::Const(_) | Op::Get(_) | Op::Atomic | Op::Builtin(_));
        let same_file = self.flow.is_uniform(val) == self.flow.is_uniform_var(var);
        if !(plain && same_file && self.flow.is_quiet(set) && span.at >= run_start) || self.sunk.contains_key(&val) {
            return false;
        }
        if span.block != self.block {
            return false;
        }
        let others = self.sunk_to.get(&var).into_iter().flatten().map(|other| self.flow.spans[other.0 as usize]);
        for other in others {
            let (first, second) = if other.at < span.at { (other, span) } else { (span, other) };
            if first.end > second.at {
                return false;
            }
        }
        self.flow.accesses[var.0 as usize].iter().all(|access| {
            if access.at == set {
                return true;
            }
            if access.is_set {
                return !(span.at < access.at && access.at <= span.end.max(set));
            }
            // A read that stays an alias of the variable must be over before the definition writes.
            let read = self.read_end(access.at);
            let overlaps = access.at < set && read > span.at;
            !overlaps
        })
    }

    /// Last use of the value that reads a variable at this position.
    fn read_end(&self, at: u32) -> u32 {
        self.reads.get(&at).map_or(u32::MAX, |val| self.flow.spans[val.0 as usize].end)
    }

    fn stmt(&mut self, stmt: &Stmt, at: u32) {
        match stmt {
            Stmt::Def(val) => self.define(*val, at),
            Stmt::Set(var, val) | Stmt::Init(var, val) => self.set(*var, *val, at),
            Stmt::Store { mem, addr, offset, value, site } => {
                let (addr, value) = (self.place(*addr), self.place(*value));
                self.push(Inst::Store { mem: *mem, addr, value, offset: *offset, site: *site });
            }
            Stmt::Zero { offset, count } => self.push(Inst::Zero { offset: *offset, count: *count }),
            Stmt::Atomic(atomic) => {
                let (addr, value) = (self.place(atomic.addr), self.place(atomic.value));
                let compare = atomic.compare.map(|val| self.place(val));
                let dst = atomic.result.map(|val| {
                    let register = self.register(false);
                    self.places[val.0 as usize] = Some(register);
                    register
                });
                let index = self.out.atomics.len() as u32;
                let (op, mem, offset, site) = (atomic.op, atomic.mem, atomic.offset, atomic.site);
                self.out.atomics.push(AtomicArgs { op, mem, addr, offset, value, compare, dst, site });
                self.push(Inst::Atomic { index });
            }
            Stmt::Barrier(site) => self.push(Inst::Barrier { site: *site }),
            Stmt::Tally(index) => self.push(Inst::Tally { index: *index }),
            Stmt::If { id, cond, accept, reject } => self.branch(*id, *cond, accept, reject),
            Stmt::Loop { id, body, continuing, break_if, site } => self.repeat(*id, body, continuing, *break_if, *site),
            Stmt::Region { id, body } => self.region(*id, body),
            Stmt::Break(target) => self.leave(*target, false),
            Stmt::Continue(target) => self.leave(*target, true),
        }
    }

    fn define(&mut self, val: Val, at: u32) {
        if self.flow.is_fused(val) {
            return;
        }
        let op = self.tree.op(val);
        let uniform = self.flow.is_uniform(val);
        if let Op::Get(var) = op {
            let register = self.variable(var);
            let end = self.flow.spans[val.0 as usize].end;
            let overwritten = self.flow.accesses[var.0 as usize].iter().any(|a| a.is_set && at < a.at && a.at <= end);
            let place = if overwritten {
                let copy = self.register(uniform);
                self.push(Inst::Un { op: UnOp::Move, dst: copy, a: register });
                copy
            } else {
                register
            };
            self.places[val.0 as usize] = Some(place);
            return;
        }
        let args = self.operands(op);
        let dst = match self.sunk.get(&val) {
            Some(var) => self.variable(*var),
            None => self.register(uniform),
        };
        self.places[val.0 as usize] = Some(dst);
        let inst = match op {
            Op::Const(_) | Op::Get(_) | Op::Atomic => return,
            Op::Builtin(builtin) => {
                self.out.inputs.push((builtin, dst));
                self.out.homes[dst.index as usize] = 0;
                return;
            }
            Op::Un(op, _) => Inst::Un { op, dst, a: args[0] },
            Op::Bin(op, ..) => Inst::Bin { op, dst, a: args[0], b: args[1] },
            Op::Tern(op, ..) => Inst::Tern { op, dst, a: args[0], b: args[1], c: args[2] },
            Op::Check { site, .. } => Inst::Check { dst, index: args[0], length: args[1], site },
            Op::ArrayLength { buffer, offset, stride } => Inst::ArrayLength { dst, buffer, offset, stride },
            Op::Load { mem, offset, site, .. } => Inst::Load { dst, mem, addr: args[0], offset, site },
        };
        self.push(inst);
    }

    fn operands(&mut self, op: Op) -> Vec<Virtual> {
        let mut vals = Vec::new();
        op.operands(|val| vals.push(val));
        vals.into_iter().map(|val| self.place(val)).collect()
    }

    fn set(&mut self, var: Var, val: Val, at: u32) {
        if self.skipped.contains(&at) {
            return;
        }
        let (dst, a) = (self.variable(var), self.place(val));
        if dst == a {
            return;
        }
        if self.flow.is_quiet(at) {
            self.push(Inst::Un { op: UnOp::Move, dst, a });
        } else {
            self.push(Inst::Blend { dst, a });
        }
    }
}

fn reads(tree: &Tree, flow: &Flow) -> HashMap<u32, Val> {
    let gets = tree.vals.iter().enumerate().filter(|(_, op)| matches!(op, Op::Get(_)));
    gets.map(|(index, _)| (flow.spans[index].at, Val(index as u32))).collect()
}

/// Number of statements and of blocks in a block, as positions count them.
fn count(block: &Block) -> (u32, usize) {
    block.iter().map(count_stmt).fold((0, 0), |sum, n| (sum.0 + n.0, sum.1 + n.1))
}

fn count_stmt(stmt: &Stmt) -> (u32, usize) {
    let mut stmts = 1 + u32::from(matches!(stmt, Stmt::Loop { .. }));
    let mut blocks = 0;
    for inner in super::prune::inner_blocks(stmt) {
        let (inner_stmts, inner_blocks) = count(inner);
        stmts += inner_stmts;
        blocks += inner_blocks + 1;
    }
    (stmts, blocks)
}

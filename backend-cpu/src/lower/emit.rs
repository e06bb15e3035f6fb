//! Tree to linear code on virtual registers: where masks are needed, jumps where control is uniform.
//!
//! Invariant: code runs with at least one active lane. Whatever can leave no lane active jumps to the next place where
//! lanes wait (the *skip* label of the innermost divergent construct).

use std::collections::{HashMap, HashSet};

use super::flow::{BlockId, Flow};
use super::regs::Virtual;
use super::tree::{Block, Builtin, Construct, Op, Site, Stmt, Tree, Val, Var};
use crate::code::{AtomicArgs, Inst, Slot, UnOp};

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

/// A divergent construct or a loop around the code being emitted.
#[derive(Clone, Copy)]
enum Open {
    If { slot: Slot, skip: Label },
    Loop { id: Construct, masks: Option<(Slot, Slot)>, next: Label, exit: Label, skip: Label },
    Region { id: Construct, slot: Option<Slot>, exit: Label },
}

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
    emitter.open.push(Open::Region { id: Construct(u32::MAX), slot: None, exit: end });
    emitter.block(&tree.body, 0);
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

    fn slot(&mut self) -> Slot {
        self.slots += 1;
        self.out.slots = self.out.slots.max(self.slots);
        (self.slots - 1) as Slot
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

    /// Where lanes wait that have nothing to do here.
    fn skip(&self) -> Label {
        for open in self.open.iter().rev() {
            match *open {
                Open::If { skip, .. } => return skip,
                Open::Loop { masks: Some(_), skip, .. } => return skip,
                Open::Region { slot: Some(_), exit, .. } => return exit,
                Open::Region { id: Construct(u32::MAX), exit, .. } => return exit,
                _ => {}
            }
        }
        unreachable!("the whole program is a region")
    }

    fn block(&mut self, block: &Block, id: BlockId) {
        let outer = std::mem::replace(&mut self.block, id);
        self.block_starts[id] = self.out.insts.len() as u32;
        self.find_sinks(block);
        for stmt in block {
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
        let id = self.next_block;
        self.next_block += 1;
        let count = count(block);
        let (end, blocks) = (self.at + count.0, self.next_block + count.1);
        self.block(block, id);
        // Unreachable statements keep their numbers.
        self.at = end;
        self.next_block = blocks;
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

    fn branch(&mut self, id: Construct, cond: Val, accept: &Block, reject: &Block) {
        if self.loop_test(cond, accept, reject) {
            return;
        }
        let varying = self.flow.constructs[id.0 as usize].varying;
        let cond = self.place(cond);
        let (other, end) = (self.label(), self.label());
        if !varying {
            self.push(Inst::JumpIf { cond, is: false, to: other as u32 });
            self.child(accept);
            if !reject.is_empty() {
                self.push(Inst::Jump { to: end as u32 });
            }
            self.bind(other);
            self.child(reject);
            self.bind(end);
            return;
        }
        let skip = self.skip();
        let slot = self.slot();
        if accept.is_empty() {
            self.push(Inst::Save { slot });
            self.child(accept);
        } else {
            self.push(Inst::If { cond, slot, to: if reject.is_empty() { end } else { other } as u32 });
            self.open.push(Open::If { slot, skip: if reject.is_empty() { end } else { other } });
            self.child(accept);
            self.open.pop();
        }
        self.bind(other);
        if !reject.is_empty() {
            self.push(Inst::Else { cond, slot, to: end as u32 });
            self.open.push(Open::If { slot, skip: end });
        }
        self.child(reject);
        if !reject.is_empty() {
            self.open.pop();
        }
        self.bind(end);
        self.push(Inst::Restore { slot, to: skip as u32 });
        self.slots -= 1;
    }

    /// `if cond { break }` at the top of a divergent loop's body needs no mask of its own.
    fn loop_test(&mut self, cond: Val, accept: &Block, reject: &Block) -> bool {
        let (target, is) = match (&accept[..], &reject[..]) {
            ([Stmt::Break(target)], []) => (*target, true),
            ([], [Stmt::Break(target)]) => (*target, false),
            _ => return false,
        };
        let Some(Open::Loop { id, masks: Some((live, _)), skip, .. }) = self.open.last().copied() else { return false };
        if id != target || self.flow.is_uniform(cond) {
            return false;
        }
        let cond = self.place(cond);
        self.push(Inst::Exit { cond, is, live, to: skip as u32 });
        self.at += 1;
        self.next_block += 2;
        true
    }

    fn repeat(&mut self, id: Construct, body: &Block, continuing: &Block, break_if: Option<Val>, site: Site) {
        let info = self.flow.constructs[id.0 as usize];
        let divergent = info.leaves || info.continues;
        let outer_skip = self.skip();
        let (head, next, exit) = (self.label(), self.label(), self.label());
        let masks = divergent.then(|| (self.slot(), self.slot()));
        if let Some((live, outer)) = masks {
            self.push(Inst::Save { slot: outer });
            self.push(Inst::Save { slot: live });
        }
        if self.out.insts.len() as u32 == self.block_starts[self.block] {
            // A lifetime that begins with the block must begin before the loop.
            self.push(Inst::Jump { to: head as u32 });
        }
        let start = self.out.insts.len() as u32;
        self.bind(head);
        self.open.push(Open::Loop { id, masks, next, exit, skip: next });
        self.child(body);
        self.bind(next);
        if let Some((live, _)) = masks {
            self.push(Inst::Restore { slot: live, to: exit as u32 });
        }
        self.open.pop();
        self.open.push(Open::Loop { id, masks, next, exit, skip: exit });
        self.child(continuing);
        if let Some(test) = break_if {
            let cond = self.place(test);
            match masks {
                Some((live, _)) if !cond.scalar => self.push(Inst::Exit { cond, is: true, live, to: exit as u32 }),
                _ => self.push(Inst::JumpIf { cond, is: true, to: exit as u32 }),
            }
        }
        self.at += 1;
        self.open.pop();
        self.push(Inst::Back { to: head as u32, site });
        self.bind(exit);
        self.out.loops.push((start, self.out.insts.len() as u32));
        if let Some((_, outer)) = masks {
            self.push(Inst::Restore { slot: outer, to: outer_skip as u32 });
            self.slots -= 2;
        }
    }

    fn region(&mut self, id: Construct, body: &Block) {
        let outer_skip = self.skip();
        let exit = self.label();
        let slot = self.flow.constructs[id.0 as usize].leaves.then(|| self.slot());
        if let Some(slot) = slot {
            self.push(Inst::Save { slot });
        }
        self.open.push(Open::Region { id, slot, exit });
        self.child(body);
        self.open.pop();
        self.bind(exit);
        if let Some(slot) = slot {
            self.push(Inst::Restore { slot, to: outer_skip as u32 });
            self.slots -= 1;
        }
    }

    /// All active lanes go to the end, or to the continuing block, of a construct.
    fn leave(&mut self, target: Construct, is_continue: bool) {
        let mut drops = Vec::new();
        let mut wait = None;
        for open in self.open.clone().into_iter().rev() {
            match open {
                Open::If { slot, skip } => {
                    drops.push(slot);
                    wait.get_or_insert(skip);
                }
                Open::Loop { id, masks, next, exit, .. } if id == target => {
                    let Some((live, _)) = masks else {
                        self.push(Inst::Jump { to: if is_continue { next } else { exit } as u32 });
                        return;
                    };
                    if !is_continue {
                        drops.push(live);
                    }
                    wait.get_or_insert(next);
                    break;
                }
                Open::Region { id, slot, exit } if id == target => {
                    if slot.is_none() {
                        self.push(Inst::Jump { to: exit as u32 });
                        return;
                    }
                    wait.get_or_insert(exit);
                    break;
                }
                Open::Loop { masks: Some((live, outer)), skip, .. } => {
                    drops.extend([live, outer]);
                    wait.get_or_insert(skip);
                }
                Open::Region { slot: Some(slot), exit, .. } => {
                    drops.push(slot);
                    wait.get_or_insert(exit);
                }
                Open::Loop { .. } | Open::Region { .. } => {}
            }
        }
        for slot in drops {
            self.push(Inst::Drop { slot });
        }
        let to = wait.unwrap_or(0) as u32;
        self.push(Inst::Leave { to });
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

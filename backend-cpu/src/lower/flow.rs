//! Positions, accesses and uniformity.
//!
//! A value is *uniform* when all active lanes of a gang share it; it is then computed once, in a scalar register. A set
//! of a variable is *quiet* when no lane that is inactive at it can observe the variable before it is set again. A
//! variable is uniform iff every set of it is quiet and stores a uniform value; a quiet set of a varying variable needs
//! no mask. Both are the greatest solution of one system, found by iteration from "everything is uniform".
//!
//! Quietness is judged from the variable's *home*, the innermost block that holds all its accesses, begins by setting
//! it (or is entered once), and so ends every lifetime that begins in it. Walking out from a set to the home, a varying
//! If hides lanes that will read later; a loop that lanes leave hides lanes that read after it; a loop that lanes
//! continue hides lanes until its continuing block.

use std::collections::{HashMap, HashSet};

use super::tree::{Block, Builtin, Construct, Op, Stmt, Tree, Val, Var};
use crate::code::Mem;

/// Number of a block; 0 is the body of the entry point.
pub(super) type BlockId = usize;

/// The place of a block in the tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockInfo {
    /// Its construct, and the block that holds that construct; `None` for the whole body.
    pub(super) parent: Option<(Construct, BlockId)>,
    pub(super) is_continuing: bool,
    pub(super) start: u32,
}

/// What a construct is, and how lanes part in it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ConstructInfo {
    pub(super) is_if: bool,
    pub(super) is_loop: bool,
    pub(super) start: u32,
    pub(super) end: u32,
    /// An If on a varying condition.
    pub(super) varying: bool,
    /// Some lanes leave a loop or region while others stay.
    pub(super) leaves: bool,
    /// Some lanes continue a loop while others go on.
    pub(super) continues: bool,
}

impl ConstructInfo {
    /// Whether the construct needs masks.
    pub(super) fn divergent(&self) -> bool {
        self.varying || self.leaves || self.continues
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct AccessInfo {
    pub(super) at: u32,
    pub(super) block: BlockId,
    pub(super) is_set: bool,
}

/// A set of a variable.
#[derive(Clone, Copy, Debug)]
struct SetInfo {
    var: Var,
    val: Val,
    at: u32,
    block: BlockId,
}

#[derive(Clone, Copy, Debug)]
struct LeaveInfo {
    target: Construct,
    is_continue: bool,
    block: BlockId,
}

/// Where a value is defined and last used.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Span {
    pub(super) at: u32,
    pub(super) block: BlockId,
    pub(super) end: u32,
}

/// Everything emission asks about the tree.
pub(super) struct Flow {
    pub(super) blocks: Vec<BlockInfo>,
    pub(super) constructs: Vec<ConstructInfo>,
    pub(super) accesses: Vec<Vec<AccessInfo>>,
    pub(super) spans: Vec<Span>,
    pub(super) homes: Vec<BlockId>,
    uniform_vals: Vec<bool>,
    uniform_vars: Vec<bool>,
    quiet: HashMap<u32, bool>,
    /// Comparisons that nothing but one test of control flow reads: the test makes them.
    fused: HashSet<Val>,
    sets: Vec<SetInfo>,
    leaves: Vec<LeaveInfo>,
    uses: Vec<(Val, u32, BlockId)>,
}

/// Whether workgroups that share a gang go the ways that one goes alone: no lanes part and no addresses of loads differ
/// only between workgroups.
pub(super) fn workgroups_go_together(tree: &Tree) -> bool {
    let (alone, merged) = (Flow::new(tree, false), Flow::new(tree, true));
    let ways = alone.constructs.iter().zip(&merged.constructs).all(|(a, b)| a.divergent() == b.divergent());
    let loads = tree.vals.iter().zip(alone.uniform_vals.iter().zip(&merged.uniform_vals));
    ways && loads.filter(|(op, _)| matches!(op, Op::Load { .. })).all(|(_, (a, b))| a == b)
}

impl Flow {
    /// Analyses a tree. In a merged gang the workgroup's id differs between lanes.
    pub(super) fn new(tree: &Tree, merged: bool) -> Self {
        let mut flow = Flow {
            blocks: vec![BlockInfo { parent: None, is_continuing: false, start: 0 }],
            constructs: vec![ConstructInfo::default(); tree.constructs as usize],
            accesses: vec![Vec::new(); tree.vars as usize],
            spans: vec![Span::default(); tree.vals.len()],
            homes: Vec::new(),
            uniform_vals: vec![true; tree.vals.len()],
            uniform_vars: vec![true; tree.vars as usize],
            quiet: HashMap::new(),
            fused: fused(tree),
            sets: Vec::new(),
            leaves: Vec::new(),
            uses: Vec::new(),
        };
        let mut at = 0;
        flow.number(tree, &tree.body, 0, &mut at);
        flow.extend_spans();
        flow.homes = (0..tree.vars as usize).map(|var| flow.home(var)).collect();
        while flow.step(tree, merged) {}
        flow
    }

    pub(super) fn is_uniform(&self, val: Val) -> bool {
        self.uniform_vals[val.0 as usize]
    }

    pub(super) fn is_uniform_var(&self, var: Var) -> bool {
        self.uniform_vars[var.0 as usize]
    }

    /// Whether the set at this position needs no mask.
    pub(super) fn is_quiet(&self, at: u32) -> bool {
        self.quiet.get(&at).copied().unwrap_or(false)
    }

    /// Whether a comparison is made by the test that reads it.
    pub(super) fn is_fused(&self, val: Val) -> bool {
        self.fused.contains(&val)
    }

    /// A test reads a value, or the operands of the comparison that it makes itself.
    fn test(&mut self, tree: &Tree, cond: Val, at: u32, block: BlockId) {
        if self.is_fused(cond) {
            tree.op(cond).operands(|val| self.uses.push((val, at, block)));
        } else {
            self.uses.push((cond, at, block));
        }
    }

    /// Numbers statements in order; emission walks the same way and counts along.
    fn number(&mut self, tree: &Tree, block: &Block, id: BlockId, at: &mut u32) {
        self.blocks[id].start = *at;
        for stmt in block {
            let here = *at;
            *at += 1;
            if !matches!(stmt, Stmt::If { .. } | Stmt::Loop { .. }) {
                stmt.operands(tree, |val| self.uses.push((val, here, id)));
            }
            match stmt {
                Stmt::Def(val) => {
                    self.spans[val.0 as usize] = Span { at: here, block: id, end: here };
                    if let Op::Get(var) = tree.op(*val) {
                        self.access(var, here, id, false);
                    }
                }
                Stmt::Atomic(atomic) => {
                    if let Some(val) = atomic.result {
                        self.spans[val.0 as usize] = Span { at: here, block: id, end: here };
                    }
                }
                Stmt::Set(var, val) | Stmt::Init(var, val) => {
                    self.access(*var, here, id, true);
                    self.sets.push(SetInfo { var: *var, val: *val, at: here, block: id });
                }
                Stmt::If { id: construct, cond, accept, reject } => {
                    self.test(tree, *cond, here, id);
                    self.open(*construct, here, true, false);
                    self.child(tree, accept, *construct, id, false, at);
                    self.child(tree, reject, *construct, id, false, at);
                    self.constructs[construct.0 as usize].end = *at;
                }
                Stmt::Loop { id: construct, body, continuing, break_if, .. } => {
                    self.open(*construct, here, false, true);
                    self.child(tree, body, *construct, id, false, at);
                    let tail = self.child(tree, continuing, *construct, id, true, at);
                    if let Some(test) = break_if {
                        self.test(tree, *test, *at, tail);
                    }
                    *at += 1;
                    self.constructs[construct.0 as usize].end = *at;
                }
                Stmt::Region { id: construct, body } => {
                    self.open(*construct, here, false, false);
                    self.child(tree, body, *construct, id, false, at);
                    self.constructs[construct.0 as usize].end = *at;
                }
                Stmt::Break(target) => self.leaves.push(LeaveInfo { target: *target, is_continue: false, block: id }),
                Stmt::Continue(target) => self.leaves.push(LeaveInfo { target: *target, is_continue: true, block: id }),
                _ => {}
            }
        }
    }

    fn open(&mut self, construct: Construct, start: u32, is_if: bool, is_loop: bool) {
        let info = &mut self.constructs[construct.0 as usize];
        *info = ConstructInfo { is_if, is_loop, start, ..ConstructInfo::default() };
    }

    fn child(
        &mut self,
        tree: &Tree,
        block: &Block,
        construct: Construct,
        parent: BlockId,
        is_continuing: bool,
        at: &mut u32,
    ) -> BlockId {
        let id = self.blocks.len();
        self.blocks.push(BlockInfo { parent: Some((construct, parent)), is_continuing, start: *at });
        self.number(tree, block, id, at);
        id
    }

    fn access(&mut self, var: Var, at: u32, block: BlockId, is_set: bool) {
        self.accesses[var.0 as usize].push(AccessInfo { at, block, is_set });
    }

    fn info(&self, construct: Construct) -> &ConstructInfo {
        &self.constructs[construct.0 as usize]
    }

    /// The constructs from a block outward, up to but not including those that hold `outer`.
    fn path(&self, mut block: BlockId, outer: BlockId) -> Vec<(Construct, BlockId)> {
        let mut path = Vec::new();
        while block != outer {
            let Some((construct, parent)) = self.blocks[block].parent else { break };
            path.push((construct, block));
            block = parent;
        }
        path
    }

    /// Extends each value's span to the end of every loop that uses it but does not define it.
    fn extend_spans(&mut self) {
        for (val, at, block) in std::mem::take(&mut self.uses) {
            let home = self.spans[val.0 as usize].block;
            let mut end = at;
            for (construct, _) in self.path(block, home) {
                let info = self.info(construct);
                if info.is_loop {
                    end = end.max(info.end);
                }
            }
            let span = &mut self.spans[val.0 as usize];
            span.end = span.end.max(end);
        }
    }

    fn home(&self, var: usize) -> BlockId {
        let accesses = &self.accesses[var];
        let Some(first) = accesses.first() else { return 0 };
        let mut home = first.block;
        for access in &accesses[1..] {
            let mut ancestors = vec![home];
            ancestors.extend(self.path(home, 0).iter().filter_map(|(_, b)| Some(self.blocks[*b].parent?.1)));
            let mut block = access.block;
            while !ancestors.contains(&block) {
                block = self.blocks[block].parent.map_or(0, |(_, parent)| parent);
            }
            home = block;
        }
        while !(first.is_set && first.block == home) {
            // A value from an earlier round could be read: the lifetime is that of the enclosing loop's block.
            let Some(at) = self.path(home, 0).iter().position(|(c, _)| self.info(*c).is_loop) else { break };
            let (_, block) = self.path(home, 0)[at];
            home = self.blocks[block].parent.map_or(0, |(_, parent)| parent);
        }
        home
    }

    /// One round of the iteration; whether anything changed.
    fn step(&mut self, tree: &Tree, merged: bool) -> bool {
        let mut changed = self.step_vals(tree, &tree.body, merged);
        for index in 0..self.leaves.len() {
            changed |= self.step_leave(self.leaves[index]);
        }
        for index in 0..self.sets.len() {
            let set = self.sets[index];
            let quiet = self.judge(set);
            changed |= self.quiet.insert(set.at, quiet) != Some(quiet);
            if self.uniform_vars[set.var.0 as usize] && !(quiet && self.is_uniform(set.val)) {
                self.uniform_vars[set.var.0 as usize] = false;
                changed = true;
            }
        }
        changed
    }

    fn step_vals(&mut self, tree: &Tree, block: &Block, merged: bool) -> bool {
        let mut changed = false;
        for stmt in block {
            match stmt {
                Stmt::Def(val) => changed |= self.lower_val(*val, self.value_is_uniform(tree, *val, merged)),
                Stmt::Atomic(atomic) => {
                    if let Some(val) = atomic.result {
                        changed |= self.lower_val(val, false);
                    }
                }
                Stmt::If { id, cond, .. } => {
                    let varying = !self.is_uniform(*cond);
                    let info = &mut self.constructs[id.0 as usize];
                    changed |= varying && !info.varying;
                    info.varying |= varying;
                }
                Stmt::Loop { id, break_if: Some(test), .. } => {
                    let leaves = !self.is_uniform(*test);
                    let info = &mut self.constructs[id.0 as usize];
                    changed |= leaves && !info.leaves;
                    info.leaves |= leaves;
                }
                _ => {}
            }
            for inner in super::prune::inner_blocks(stmt) {
                changed |= self.step_vals(tree, inner, merged);
            }
        }
        changed
    }

    fn lower_val(&mut self, val: Val, uniform: bool) -> bool {
        let known = &mut self.uniform_vals[val.0 as usize];
        let changed = *known && !uniform;
        *known &= uniform;
        changed
    }

    fn value_is_uniform(&self, tree: &Tree, val: Val, merged: bool) -> bool {
        let op = tree.op(val);
        let mut uniform = match op {
            Op::Builtin(Builtin::LocalId(_) | Builtin::GlobalId(_) | Builtin::LocalIndex) | Op::Atomic => false,
            Op::Builtin(Builtin::GroupId(axis)) => !(merged && axis == 0),
            Op::Get(var) => self.is_uniform_var(var),
            Op::Load { mem: Mem::Private, .. } => false,
            _ => true,
        };
        op.operands(|operand| uniform &= self.is_uniform(operand));
        uniform
    }

    /// Lanes that leave while others stay make every loop and region on their way divergent.
    fn step_leave(&mut self, leave: LeaveInfo) -> bool {
        let mut path = Vec::new();
        let mut parts = false;
        let mut block = leave.block;
        while let Some((construct, parent)) = self.blocks[block].parent {
            if construct == leave.target {
                break;
            }
            path.push(construct);
            parts |= self.info(construct).divergent();
            block = parent;
        }
        let target = *self.info(leave.target);
        parts |= target.divergent();
        if !parts {
            return false;
        }
        let mut changed = false;
        if path.iter().any(|c| self.info(*c).divergent()) {
            for construct in path {
                let info = &mut self.constructs[construct.0 as usize];
                if !info.is_if {
                    changed |= !info.leaves;
                    info.leaves = true;
                }
            }
        }
        let info = &mut self.constructs[leave.target.0 as usize];
        let flag = if leave.is_continue { &mut info.continues } else { &mut info.leaves };
        changed |= !*flag;
        *flag = true;
        changed
    }

    fn judge(&self, set: SetInfo) -> bool {
        let home = self.homes[set.var.0 as usize];
        let path = self.path(set.block, home);
        let accesses = &self.accesses[set.var.0 as usize];
        for (index, &(construct, arm)) in path.iter().enumerate() {
            let info = self.info(construct);
            if info.varying {
                return false;
            }
            let in_loop = || path[index + 1..].iter().any(|(c, _)| self.info(*c).is_loop);
            let outside = |a: &AccessInfo| a.at >= info.end || (a.at < info.start && in_loop());
            if info.leaves && accesses.iter().any(outside) {
                return false;
            }
            if info.continues && !self.blocks[arm].is_continuing {
                return false;
            }
        }
        true
    }
}

/// Comparisons that are read once, by a test of control flow.
fn fused(tree: &Tree) -> HashSet<Val> {
    let (mut tests, mut reads) = (Vec::new(), vec![0u32; tree.vals.len()]);
    count_reads(tree, &tree.body, &mut tests, &mut reads);
    let is_comparison = |val: Val| matches!(tree.op(val), Op::Bin(op, ..) if op.comparison().is_some());
    tests.into_iter().filter(|&val| reads[val.0 as usize] == 1 && is_comparison(val)).collect()
}

fn count_reads(tree: &Tree, block: &Block, tests: &mut Vec<Val>, reads: &mut [u32]) {
    for stmt in block {
        stmt.operands(tree, |val| reads[val.0 as usize] += 1);
        if let Stmt::If { cond: test, .. } | Stmt::Loop { break_if: Some(test), .. } = stmt {
            tests.push(*test);
        }
        for inner in super::prune::inner_blocks(stmt) {
            count_reads(tree, inner, tests, reads);
        }
    }
}

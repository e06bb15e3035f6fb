//! Removes what nothing observes, and sinks the initial values of variables to where the variables are used.
//!
//! Sinking matters for uniformity: a loop counter that is initialised at the head of a function but lives in one branch
//! is uniform there, whatever made the branch diverge.

use std::collections::{HashMap, HashSet};

use super::tree::{Block, Op, Stmt, Tree, Val, Var};

/// Removes values and variables without observers.
pub(super) fn dead(tree: &mut Tree) {
    let body = std::mem::take(&mut tree.body);
    let mut live = Live { tree, vals: HashSet::new(), vars: HashSet::new(), sets: HashMap::new(), work: Vec::new() };
    live.collect(&body);
    live.run();
    let (vals, vars) = (live.vals, live.vars);
    tree.body = sweep(body, &vals, &vars);
}

struct Live<'a> {
    tree: &'a Tree,
    vals: HashSet<Val>,
    vars: HashSet<Var>,
    sets: HashMap<Var, Vec<Val>>,
    work: Vec<Val>,
}

impl Live<'_> {
    fn collect(&mut self, block: &Block) {
        for stmt in block {
            match stmt {
                Stmt::Def(_) => {}
                Stmt::Set(var, val) | Stmt::Init(var, val) => self.sets.entry(*var).or_default().push(*val),
                _ => stmt.operands(self.tree, |val| self.work.push(val)),
            }
            for inner in inner_blocks(stmt) {
                self.collect(inner);
            }
        }
    }

    fn run(&mut self) {
        while let Some(val) = self.work.pop() {
            if !self.vals.insert(val) {
                continue;
            }
            let op = self.tree.op(val);
            op.operands(|operand| self.work.push(operand));
            if let Op::Get(var) = op
                && self.vars.insert(var)
            {
                self.work.extend(self.sets.get(&var).into_iter().flatten());
            }
        }
    }
}

fn sweep(block: Block, vals: &HashSet<Val>, vars: &HashSet<Var>) -> Block {
    block
        .into_iter()
        .filter_map(|stmt| match stmt {
            Stmt::Def(val) => vals.contains(&val).then_some(stmt),
            Stmt::Set(var, _) | Stmt::Init(var, _) => vars.contains(&var).then_some(stmt),
            Stmt::If { id, cond, accept, reject } => {
                let (accept, reject) = (sweep(accept, vals, vars), sweep(reject, vals, vars));
                let empty = accept.is_empty() && reject.is_empty();
                (!empty).then_some(Stmt::If { id, cond, accept, reject })
            }
            Stmt::Loop { id, body, continuing, break_if, site } => {
                let (body, continuing) = (sweep(body, vals, vars), sweep(continuing, vals, vars));
                Some(Stmt::Loop { id, body, continuing, break_if, site })
            }
            Stmt::Region { id, body } => Some(Stmt::Region { id, body: sweep(body, vals, vars) }),
            Stmt::Atomic(mut atomic) => {
                atomic.result = atomic.result.filter(|val| vals.contains(val));
                Some(Stmt::Atomic(atomic))
            }
            other => Some(other),
        })
        .collect()
}

/// Removes leaving a construct where that is where control goes anyway.
pub(super) fn tails(tree: &mut Tree) {
    tail(&mut tree.body, &[]);
}

/// `ends` are the constructs whose end, or continuing block, follows this block.
fn tail(block: &mut Block, ends: &[Stmt]) {
    let falls = |stmt: &Stmt, ends: &[Stmt]| match stmt {
        Stmt::Break(target) => ends.iter().any(|end| matches!(end, Stmt::Break(at) if at == target)),
        Stmt::Continue(target) => ends.iter().any(|end| matches!(end, Stmt::Continue(at) if at == target)),
        _ => false,
    };
    while block.last().is_some_and(|stmt| falls(stmt, ends)) {
        block.pop();
    }
    let last = block.len().wrapping_sub(1);
    for (index, stmt) in block.iter_mut().enumerate() {
        let mut inner = if index == last { ends.to_vec() } else { Vec::new() };
        match stmt {
            Stmt::If { accept, reject, .. } => {
                tail(accept, &inner);
                tail(reject, &inner);
            }
            Stmt::Region { id, body } => {
                inner.push(Stmt::Break(*id));
                tail(body, &inner);
            }
            Stmt::Loop { id, body, continuing, .. } => {
                tail(body, &[Stmt::Continue(*id)]);
                tail(continuing, &[]);
            }
            _ => {}
        }
    }
}

/// The blocks directly inside a statement.
pub(super) fn inner_blocks(stmt: &Stmt) -> Vec<&Block> {
    match stmt {
        Stmt::If { accept, reject, .. } => vec![accept, reject],
        Stmt::Loop { body, continuing, .. } => vec![body, continuing],
        Stmt::Region { body, .. } => vec![body],
        _ => Vec::new(),
    }
}

/// Moves every [`Stmt::Init`] down to the first use of its variable.
pub(super) fn sink(tree: &mut Tree) {
    let mut body = std::mem::take(&mut tree.body);
    sink_block(tree, &mut body, Vec::new());
    tree.body = body;
}

fn sink_block(tree: &mut Tree, block: &mut Block, mut inits: Vec<(Var, Val)>) {
    let mut out = Vec::with_capacity(block.len());
    let last = last_accesses(tree, block);
    for (index, mut stmt) in std::mem::take(block).into_iter().enumerate() {
        if let Stmt::Init(var, val) = stmt {
            inits.push((var, val));
            continue;
        }
        let mut inside = Vec::new();
        if !inits.is_empty() {
            let touched = accesses(tree, &stmt);
            let mut kept = Vec::new();
            for (var, val) in inits {
                if !touched.contains(&var) {
                    kept.push((var, val));
                } else if matches!(stmt, Stmt::Set(..)) {
                    // Set before anything reads it: the initial value is never seen.
                } else if matches!(stmt, Stmt::If { .. } | Stmt::Region { .. }) && last.get(&var) == Some(&index) {
                    inside.push((var, val));
                } else {
                    out.push(Stmt::Init(var, val));
                }
            }
            inits = kept;
        }
        match &mut stmt {
            Stmt::If { accept, reject, .. } => {
                let renamed = split(tree, &inside, accept, reject);
                sink_block(tree, accept, inside);
                sink_block(tree, reject, renamed);
            }
            Stmt::Region { body, .. } => sink_block(tree, body, inside),
            Stmt::Loop { body, continuing, .. } => {
                sink_block(tree, body, Vec::new());
                sink_block(tree, continuing, Vec::new());
            }
            _ => {}
        }
        out.push(stmt);
    }
    *block = out;
}

/// Gives the second branch variables of its own; the result is their initial values.
fn split(tree: &mut Tree, inits: &[(Var, Val)], accept: &Block, reject: &mut Block) -> Vec<(Var, Val)> {
    let first = block_accesses(tree, accept);
    let mut names = HashMap::new();
    let mut renamed = Vec::new();
    for &(var, val) in inits {
        if first.contains(&var) {
            names.insert(var, Var(tree.vars));
            renamed.push((Var(tree.vars), val));
            tree.vars += 1;
        } else {
            renamed.push((var, val));
        }
    }
    if !names.is_empty() {
        rename(tree, reject, &names);
    }
    renamed
}

pub(super) fn rename(tree: &mut Tree, block: &mut Block, names: &HashMap<Var, Var>) {
    for stmt in block {
        match stmt {
            Stmt::Def(val) => {
                if let Op::Get(var) = &mut tree.vals[val.0 as usize]
                    && let Some(name) = names.get(var)
                {
                    *var = *name;
                }
            }
            Stmt::Set(var, _) | Stmt::Init(var, _) => {
                if let Some(name) = names.get(var) {
                    *var = *name;
                }
            }
            Stmt::If { accept, reject, .. } => {
                rename(tree, accept, names);
                rename(tree, reject, names);
            }
            Stmt::Loop { body, continuing, .. } => {
                rename(tree, body, names);
                rename(tree, continuing, names);
            }
            Stmt::Region { body, .. } => rename(tree, body, names),
            _ => {}
        }
    }
}

/// For each variable of a block the last statement that accesses it.
fn last_accesses(tree: &Tree, block: &Block) -> HashMap<Var, usize> {
    let mut last = HashMap::new();
    for (index, stmt) in block.iter().enumerate() {
        last.extend(accesses(tree, stmt).into_iter().map(|var| (var, index)));
    }
    last
}

fn accesses(tree: &Tree, stmt: &Stmt) -> HashSet<Var> {
    let mut vars = HashSet::new();
    visit(tree, stmt, &mut vars);
    vars
}

fn block_accesses(tree: &Tree, block: &Block) -> HashSet<Var> {
    let mut vars = HashSet::new();
    block.iter().for_each(|stmt| visit(tree, stmt, &mut vars));
    vars
}

fn visit(tree: &Tree, stmt: &Stmt, vars: &mut HashSet<Var>) {
    match stmt {
        Stmt::Def(val) => {
            if let Op::Get(var) = tree.op(*val) {
                vars.insert(var);
            }
        }
        Stmt::Set(var, _) | Stmt::Init(var, _) => drop(vars.insert(*var)),
        _ => inner_blocks(stmt).into_iter().flatten().for_each(|inner| visit(tree, inner, vars)),
    }
}

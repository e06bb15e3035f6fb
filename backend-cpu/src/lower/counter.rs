//! Counters: variables on which all lanes inside a loop agree, though lanes that left it do not.
//!
//! Lanes leave a loop in different rounds, so a counter that is read behind the loop differs between lanes there, and
//! must be kept by lane. Inside, the lanes that are still there agree on it. Such a variable gets a *twin* that lives
//! inside the loop only: it is set before the loop, stands for the variable inside, and lanes that leave copy it back.
//! The twin is uniform, so a round costs no masked set, and a test of it is a jump.
//!
//! Whether a twin is uniform is what [`Flow`] says of the tree that has it: all candidates are tried together, and
//! those that fail are dropped until none does. Invariant: the tree with twins computes what the tree without computes.

use std::collections::{BTreeSet, HashMap, HashSet};

use super::flow::Flow;
use super::prune::{inner_blocks, rename};
use super::tree::{Block, Construct, Op, Stmt, Tree, Val, Var};

/// Most twins of one entry point.
const TWINS: usize = 16;

/// Most places where lanes leave a loop that has a twin: each copies it back.
const EXITS: usize = 8;

/// How many statements before a loop are searched for the value of a variable.
const REACH: usize = 256;

/// A variable that may have a twin in a loop, and the value that it has before it.
#[derive(Clone, Copy)]
struct Candidate {
    at: Construct,
    var: Var,
    before: Val,
}

/// Gives twins to the variables that gain by them; the analysis of the tree that results.
pub(super) fn split(tree: &mut Tree, merged: bool) -> Flow {
    let flow = Flow::new(tree, merged);
    let mut found = Vec::new();
    look(&tree.body, &flow, &HashSet::new(), &mut found);
    while !found.is_empty() {
        let mut trial = tree.clone();
        let first = trial.vars;
        trial.vars += found.len() as u32;
        let mut body = std::mem::take(&mut trial.body);
        place(&mut trial, &mut body, &found, first);
        trial.body = body;
        let flow = Flow::new(&trial, merged);
        let mut twins = first..;
        let before = found.len();
        found.retain(|_| twins.next().is_some_and(|twin| flow.is_uniform_var(Var(twin))));
        if found.len() == before {
            *tree = trial;
            return flow;
        }
    }
    flow
}

/// Finds candidates, outermost loops first; `taken` have one in a loop around this block.
fn look(block: &Block, flow: &Flow, taken: &HashSet<Var>, found: &mut Vec<Candidate>) {
    for (index, stmt) in block.iter().enumerate() {
        let mut taken = taken.clone();
        if let Stmt::Loop { id, break_if: None, .. } = stmt
            && exits(stmt, *id) <= EXITS
        {
            let gains = |var: &Var| !flow.is_uniform_var(*var) && is_read_outside(flow, *id, *var);
            for var in sets(stmt).into_iter().filter(gains) {
                let before = reaching(&block[..index], var).filter(|val| flow.is_uniform(*val));
                if let Some(before) = before
                    && found.len() < TWINS
                    && taken.insert(var)
                {
                    found.push(Candidate { at: *id, var, before });
                }
            }
        }
        for inner in inner_blocks(stmt) {
            look(inner, flow, &taken, found);
        }
    }
}

fn is_read_outside(flow: &Flow, id: Construct, var: Var) -> bool {
    let info = flow.constructs[id.0 as usize];
    let mut reads = flow.accesses[var.0 as usize].iter().filter(|access| !access.is_set);
    reads.any(|access| access.at < info.start || access.at >= info.end)
}

/// The value that a variable has at the end of these statements, where they tell.
fn reaching(block: &[Stmt], var: Var) -> Option<Val> {
    for stmt in block.iter().rev().take(REACH) {
        match stmt {
            Stmt::Set(at, val) | Stmt::Init(at, val) if *at == var => return Some(*val),
            _ if sets(stmt).contains(&var) => return None,
            _ => {}
        }
    }
    None
}

/// Variables that a statement sets.
fn sets(stmt: &Stmt) -> BTreeSet<Var> {
    match stmt {
        Stmt::Set(var, _) | Stmt::Init(var, _) => BTreeSet::from([*var]),
        _ => inner_blocks(stmt).into_iter().flatten().flat_map(sets).collect(),
    }
}

/// How often control leaves a loop.
fn exits(stmt: &Stmt, id: Construct) -> usize {
    let inner = constructs(stmt);
    count_exits(stmt, id, &inner)
}

fn count_exits(stmt: &Stmt, id: Construct, inner: &HashSet<Construct>) -> usize {
    let below = inner_blocks(stmt).into_iter().flatten().map(|stmt| count_exits(stmt, id, inner)).sum::<usize>();
    below + usize::from(is_exit(stmt, id, inner))
}

/// Whether a statement inside a loop leaves it, `inner` being the constructs inside.
fn is_exit(stmt: &Stmt, id: Construct, inner: &HashSet<Construct>) -> bool {
    match stmt {
        Stmt::Break(target) => *target == id || !inner.contains(target),
        Stmt::Continue(target) => *target != id && !inner.contains(target),
        _ => false,
    }
}

/// The constructs inside a statement, its own included.
fn constructs(stmt: &Stmt) -> HashSet<Construct> {
    let own = match stmt {
        Stmt::If { id, .. } | Stmt::Loop { id, .. } | Stmt::Region { id, .. } => Some(*id),
        _ => None,
    };
    own.into_iter().chain(inner_blocks(stmt).into_iter().flatten().flat_map(constructs)).collect()
}

/// Puts the twins in: that of candidate i is variable `first` + i.
fn place(tree: &mut Tree, block: &mut Block, found: &[Candidate], first: u32) {
    let mut out = Vec::with_capacity(block.len());
    for mut stmt in std::mem::take(block) {
        let inner = constructs(&stmt);
        if let Stmt::Loop { id, body, continuing, .. } = &mut stmt {
            let here: Vec<(Candidate, Var)> =
                found.iter().zip(first..).filter(|(c, _)| c.at == *id).map(|(c, twin)| (*c, Var(twin))).collect();
            if !here.is_empty() {
                let names: HashMap<Var, Var> = here.iter().map(|(c, twin)| (c.var, *twin)).collect();
                for block in [body, continuing] {
                    rename(tree, block, &names);
                    copy_back(tree, block, *id, &inner, &here);
                }
                out.extend(here.iter().map(|(c, twin)| Stmt::Set(*twin, c.before)));
            }
        }
        for inner in inner_blocks_mut(&mut stmt) {
            place(tree, inner, found, first);
        }
        out.push(stmt);
    }
    *block = out;
}

/// Lets lanes that leave a loop copy its twins back.
fn copy_back(
    tree: &mut Tree,
    block: &mut Block,
    id: Construct,
    inner: &HashSet<Construct>,
    twins: &[(Candidate, Var)],
) {
    let mut out = Vec::with_capacity(block.len());
    for mut stmt in std::mem::take(block) {
        if is_exit(&stmt, id, inner) {
            for (candidate, twin) in twins {
                let val = Val(tree.vals.len() as u32);
                tree.vals.push(Op::Get(*twin));
                out.extend([Stmt::Def(val), Stmt::Set(candidate.var, val)]);
            }
        }
        for block in inner_blocks_mut(&mut stmt) {
            copy_back(tree, block, id, inner, twins);
        }
        out.push(stmt);
    }
    *block = out;
}

/// The blocks directly inside a statement.
fn inner_blocks_mut(stmt: &mut Stmt) -> Vec<&mut Block> {
    match stmt {
        Stmt::If { accept, reject, .. } => vec![accept, reject],
        Stmt::Loop { body, continuing, .. } => vec![body, continuing],
        Stmt::Region { body, .. } => vec![body],
        _ => Vec::new(),
    }
}

//! naga IR to register code, once for each pipeline.
//!
//! overrides applied → calls inlined, types split into words ([`build`]) → dead code removed, initial values sunk
//! ([`prune`]) → positions, uniformity, quiet sets ([`flow`]) → linear code with masks and jumps ([`emit`]) →
//! operations joined ([`fuse`]) → accesses of neighbouring words joined ([`group`]) → registers ([`regs`]).

mod algebra;
mod build;
mod builtins;
mod constant;
mod counter;
mod emit;
mod entry;
mod expr;
mod flow;
mod fold;
mod fuse;
mod group;
mod idiom;
mod place;
mod prune;
mod regs;
mod scan;
mod scope;
mod stmt;
#[cfg(test)]
mod tests;
mod tree;
mod unroll;

use std::collections::HashMap;

use std::thread;

use sightlines_backend::{Error, ErrorKind, Program, Result};

pub(crate) use tree::{Builtin, Cost};

use crate::CodeLimits;
use crate::code::{Code, Input, Reg, Slot};
use regs::Virtual;

/// Workgroups of fewer lanes are merged; larger ones only where they go together.
const MERGED_LANES: u32 = 256;

/// Masks that a gang can keep.
const MAX_SLOTS: usize = Slot::MAX as usize + 1;

/// What lowering depends on beside the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Options {
    /// Insert tallies of semantic costs.
    pub(crate) count: bool,
    pub(crate) limits: CodeLimits,
}

/// Stack for each level of nesting, more than a level takes in any pass (measured: about 2 KiB), and for all else.
const STACK: [usize; 2] = [16 << 10, 4 << 20];

/// Lowers one entry point with its overrides applied, on a thread whose stack serves the deepest program allowed.
pub(crate) fn lower(program: &Program, entry: &str, overrides: &[(String, f64)], options: Options) -> Result<Code> {
    let stack = STACK[0] * options.limits.depth as usize + STACK[1];
    thread::scope(|scope| {
        let lower = || lower_here(program, entry, overrides, options);
        match thread::Builder::new().name("lowering".into()).stack_size(stack).spawn_scoped(scope, lower) {
            Ok(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            Err(e) => Err(Error::refused(format!("no thread of {stack} bytes of stack: {e}"), "lower `depth`")),
        }
    })
}

fn lower_here(program: &Program, entry: &str, overrides: &[(String, f64)], options: Options) -> Result<Code> {
    let (module, info) = program.specialise(entry, overrides)?;
    let index = module.entry_points.iter().position(|e| e.name == entry).ok_or_else(|| {
        Error::refused(format!("`{}` has no entry point `{entry}`", program.label()), "name one that it has")
    })?;
    let reflected = program.entry(entry).map(|e| e.bindings.clone()).unwrap_or_default();
    let bindings = reflected.iter().map(|&i| &program.bindings()[i]);
    let slots: Vec<(u32, u32)> = bindings.map(|b| (b.group, b.binding)).collect();
    // Some code that the front end makes has no place of its own; the entry point has one.
    let mut places = module.entry_points[index].function.body.span_iter().filter_map(|(_, span)| program.locate(*span));
    let start = places.next();
    let fail = |fail: build::Fail| {
        let location = fail.span.and_then(|span| program.locate(span)).or_else(|| start.clone());
        match fail.reason {
            build::Reason::Unsupported(feature) => {
                let remedy = "use buffers, 32-bit types and the constructs that docs/wgsl-support.md lists".into();
                ErrorKind::Unsupported { backend: "cpu", feature, location, remedy }
            }
            build::Reason::Limit(what, limit) => {
                let what = format!("`{entry}` has more {what} than the interpreter is set to take");
                let remedy = "split the kernel, or raise the limit in `Config::limits`".into();
                ErrorKind::Limit { what, limit, location, remedy }
            }
        }
    };
    let mut tree = build::Builder::build(&module, &info, index, &slots, options).map_err(fail)?;
    prune::dead(&mut tree);
    prune::tails(&mut tree);
    prune::sink(&mut tree);
    prune::dead(&mut tree);
    let workgroup_size = module.entry_points[index].workgroup_size;
    let lanes: u32 = workgroup_size.iter().product();
    let mergeable =
        !tree.has_barrier && tree.workgroup_words == 0 && (lanes < MERGED_LANES || flow::workgroups_go_together(&tree));
    let flow = counter::split(&mut tree, mergeable);
    let mut linear = emit::emit(&tree, &flow);
    let limit = |what: String, limit: u64, remedy: &str| {
        Error::from(ErrorKind::Limit { what, limit, location: start.clone(), remedy: remedy.into() })
    };
    if linear.slots > MAX_SLOTS {
        let what = format!("lanes of `{entry}` part at {} places at once", linear.slots);
        return Err(limit(what, MAX_SLOTS as u64, "nest divergent control flow less deeply, calls included"));
    }
    fuse::fuse(&mut linear);
    group::group(&mut linear);
    assemble(&tree, linear, workgroup_size, mergeable).ok_or_else(|| {
        let what = format!("`{entry}` keeps more values or constants alive than there are registers");
        limit(what, 0x7fff, "keep fewer values alive, or split the kernel")
    })
}

fn assemble(tree: &tree::Tree, mut linear: emit::Linear, workgroup_size: [u32; 3], mergeable: bool) -> Option<Code> {
    let inputs: Vec<u32> = linear.inputs.iter().map(|(_, register)| register.index).collect();
    let intervals = regs::intervals(&linear.insts, &linear.atomics, &linear.homes, &inputs, &linear.loops);
    // Constants are live everywhere and never written: they keep scalar registers of their own, before all others.
    let constants: HashMap<Virtual, Reg> =
        linear.constants.iter().enumerate().map(|(i, (r, _))| (*r, Reg::scalar(i as u16))).collect();
    if constants.len() >= 0x4000 {
        return None;
    }
    let mut free = intervals;
    for (register, _) in &linear.constants {
        free[register.index as usize] = None;
    }
    let words = linear.constants.iter().map(|(_, word)| *word).collect();
    let used: Vec<(Builtin, Virtual)> =
        linear.inputs.drain(..).filter(|(_, register)| free[register.index as usize].is_some()).collect();
    let allocated = regs::allocate(&linear, &free, &constants)?;
    let inputs = used.into_iter().map(|(builtin, r)| Input { builtin, reg: allocated.registers[r.index as usize] });
    Some(Code {
        inputs: inputs.collect(),
        insts: allocated.insts,
        atomics: allocated.atomics,
        constants: words,
        vectors: allocated.vectors,
        scalars: allocated.scalars,
        slots: linear.slots,
        workgroup_size,
        workgroup_words: tree.workgroup_words,
        private_words: tree.private_words,
        mergeable,
        sites: tree.sites.clone(),
        costs: tree.costs.clone(),
    })
}

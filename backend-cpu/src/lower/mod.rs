//! naga IR to register code, once for each pipeline.
//!
//! overrides applied → calls inlined, types split into words ([`build`]) → dead code removed, initial values sunk
//! ([`prune`]) → positions, uniformity, quiet sets ([`flow`]) → linear code with masks and jumps ([`emit`]) → registers
//! ([`regs`]).

mod build;
mod builtins;
mod emit;
mod expr;
mod flow;
mod fold;
mod idiom;
mod place;
mod prune;
mod regs;
mod scan;
mod stmt;
mod tree;

use std::collections::HashMap;

use sightlines_backend::{Error, ErrorKind, Program, Result};

pub(crate) use tree::{Builtin, Cost};

use crate::code::{Code, Input, Reg, Slot};
use regs::Virtual;

/// Lanes that a gang of merged workgroups aims at.
const MERGED_LANES: u32 = 256;

/// Masks that a gang can keep.
const MAX_SLOTS: usize = Slot::MAX as usize + 1;

/// What lowering depends on beside the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Options {
    /// Insert tallies of semantic costs.
    pub(crate) count: bool,
}

/// Lowers one entry point with its overrides applied.
pub(crate) fn lower(program: &Program, entry: &str, overrides: &[(String, f64)], options: Options) -> Result<Code> {
    let (module, info) = program.specialise(entry, overrides)?;
    let index = module.entry_points.iter().position(|e| e.name == entry).ok_or_else(|| {
        Error::refused(format!("`{}` has no entry point `{entry}`", program.label()), "name one that it has")
    })?;
    let reflected = program.entry(entry).map(|e| e.bindings.clone()).unwrap_or_default();
    let bindings = reflected.iter().map(|&i| &program.bindings()[i]);
    let slots: Vec<(u32, u32)> = bindings.map(|b| (b.group, b.binding)).collect();
    let fail = |fail: build::Fail| ErrorKind::Unsupported {
        backend: "cpu",
        feature: fail.feature,
        location: fail.span.and_then(|span| program.locate(span)),
        remedy: "use buffers, 32-bit types and the constructs that docs/wgsl-support.md lists".into(),
    };
    let mut tree = build::Builder::build(&module, &info, index, &slots, options.count).map_err(fail)?;
    prune::dead(&mut tree);
    prune::sink(&mut tree);
    prune::dead(&mut tree);
    let workgroup_size = module.entry_points[index].workgroup_size;
    let lanes: u32 = workgroup_size.iter().product();
    let mergeable = !tree.has_barrier && tree.workgroup_words == 0 && lanes < MERGED_LANES;
    let flow = flow::Flow::new(&tree, mergeable);
    let linear = emit::emit(&tree, &flow);
    if linear.slots > MAX_SLOTS {
        let feature = format!("an entry point (`{entry}`) whose lanes part at more than {MAX_SLOTS} places at once");
        let remedy = "nest control flow less deeply, calls included".into();
        return Err(ErrorKind::Unsupported { backend: "cpu", feature, location: None, remedy }.into());
    }
    assemble(&tree, linear, workgroup_size, mergeable).ok_or_else(|| {
        let feature = format!("an entry point (`{entry}`) that keeps more than 32,767 values alive");
        let remedy = "keep fewer values alive, or split the kernel".into();
        ErrorKind::Unsupported { backend: "cpu", feature, location: None, remedy }.into()
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

//! A self-test of the exact functions of `shared/`, for any device: `cargo xtask conformance --filter exact`.
//!
//! Every function runs on all pairs of a table of edges, with whole results, and on ten million inputs of many shapes,
//! near-ties and near-collinear ones among them, with a digest a block of 4,096. Inputs are made on the device from a
//! counter; [`Inputs`] makes the same on the host, and [`oracle`] answers them from each function's definition.
//! `docs/numerics.md` lists the functions with their domains, bounds and costs.
//!
//! Invariant: an entry point calls the text that kernels import, never a copy of it.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Job, Kernel, Program, Result, Sources, bindings, host};

use crate::pieces;

mod answers;
mod cases;
mod inputs;
pub mod oracle;

pub use answers::{Function, functions};
pub use inputs::{BLOCK, Edges, Inputs};

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "exact",
    summary: "self-test of the exact arithmetic: each function on edges and on ten million inputs",
    citation: "guess and residual as in Markstein, IA-64 and Elementary Functions, 2000; proofs in docs/numerics.md",
    programs: || PARTS.iter().map(|part| compile(part, &crate::source)).collect(),
    cases: cases::all,
};

/// The texts that hold entry points, one program each.
pub const PARTS: [&str; 6] = ["angle", "divide", "float", "line", "plane", "wide"];

/// Words of one input's result.
pub const WORDS: u32 = 4;

/// Work of one input, in words of memory that would take as long.
const WORK: u64 = 8;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Block of the first workgroup.
        pub first: u32,
        /// 1 for whole results of the table of edges, 0 for digests.
        pub whole: u32,
    }
}

bindings! {
    /// What every entry point is given.
    pub struct Test {
        uniform params @ 0: Params,
        read edges @ 1: [u32; 64],
        write output @ 2: [u32],
    }
}

/// Links and compiles one of [`PARTS`] from texts of the caller's choice.
pub fn compile(part: &str, sources: &Sources) -> Result<Arc<Program>> {
    let program = Program::new(&format!("exact.{part}"), &format!("exact/{part}.wgsl"), sources, &[])?;
    for function in functions().filter(|function| function.part == part) {
        Test::check(&program, &function.entry())?;
    }
    Ok(program)
}

/// What is kept of a test's results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Volume {
    /// Four words for each pair of the table of edges.
    Edges,
    /// One digest for each of so many blocks.
    Blocks(u32),
}

/// Records the test of a function whose part is compiled to `program`; returns its output.
pub fn record(job: &mut Job, program: &Arc<Program>, function: &Function, volume: Volume) -> Buffer<[u32]> {
    let id = job.program(program);
    let edges = job.value("edges", function.edges.table());
    let (whole, blocks, words) = match volume {
        Volume::Edges => (1, 1, BLOCK * WORDS),
        Volume::Blocks(blocks) => (0, blocks, blocks),
    };
    let output = job.zeroed("output", u64::from(words));
    pieces::record(job, blocks, u64::from(BLOCK) * WORK, |job, piece| {
        let params = job.value("exact params", &Params { first: piece.start, whole });
        job.launch(id, &function.entry(), &Test { params, edges, output }, [piece.len() as u32, 1, 1]);
    });
    output
}

//! A kernel for people and for the conformance suite: programs, named cases, and an oracle's answer for each.
//!
//! A case is typed at the edge and bytes in the middle: [`Case::job`] yields plain data that any backend runs, and
//! [`Case::expected`] yields what an oracle, written from the paper and never from the WGSL, says the outputs are.

use crate::{Job, Outputs, Program, Result};
use std::sync::Arc;

/// One kernel of a registry.
pub struct Kernel {
    /// Name, equal to its folder's.
    pub name: &'static str,
    /// What it computes, in one line.
    pub summary: &'static str,
    /// The work it is taken from.
    pub citation: &'static str,
    /// Every program (variant) of it.
    pub programs: fn() -> Result<Vec<Arc<Program>>>,
    /// Its cases, from degenerate to real size.
    pub cases: fn() -> Vec<Case>,
}

/// How much work a case is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Size {
    /// Runs in milliseconds; degenerate and edge inputs.
    Small,
    /// The size at which the kernel is used; left out by `--quick` and used by the benchmarks.
    Real,
}

/// Builds the work of a case.
pub type MakeJob = Box<dyn Fn() -> Result<Job> + Send + Sync>;

/// Computes what the outputs must be. It is given the outputs of the run only to *choose* where to look (a seeded
/// sample that favours the interesting part), never to compute the answer.
pub type Oracle = Box<dyn Fn(&Outputs) -> Vec<Expected> + Send + Sync>;

/// One named input with its oracle.
pub struct Case {
    /// Name, unique in its kernel: lower case, digits and `_`.
    pub name: String,
    /// How much work it is.
    pub size: Size,
    /// The work.
    pub job: MakeJob,
    /// The answer: one [`Expected`] for each read of the job, in order.
    pub expected: Oracle,
    /// Words of each output that the snapshot shows, beside its digest.
    pub probes: Vec<u32>,
}

/// What one output must hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expected {
    /// Every word.
    Whole(Vec<u32>),
    /// Some words, for outputs whose whole oracle would take too long.
    Sample {
        /// Pairs of word index and value.
        words: Vec<(u32, u32)>,
        /// Seed of the sample, reported with it.
        seed: u64,
    },
}

impl Case {
    /// A case whose oracle knows every word of every output.
    pub fn new(
        name: impl Into<String>,
        size: Size,
        job: impl Fn() -> Result<Job> + Send + Sync + 'static,
        expected: impl Fn(&Outputs) -> Vec<Expected> + Send + Sync + 'static,
    ) -> Self {
        Case { name: name.into(), size, job: Box::new(job), expected: Box::new(expected), probes: Vec::new() }
    }

    /// Chooses the words that the snapshot shows.
    #[must_use]
    pub fn probes(mut self, probes: impl IntoIterator<Item = u32>) -> Self {
        self.probes = probes.into_iter().collect();
        self
    }
}

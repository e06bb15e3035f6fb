//! Every function under test: its inputs on the host, and what its definition says of them.
//!
//! Inputs are made in the same steps as in the WGSL of the part, in Rust's own wide integers. Invariant: a function
//! here has an entry point of its name, and the other way round.

use super::{BLOCK, Edges, Inputs};

mod angle;
mod divide;
mod float;
mod line;
mod plane;
mod wide;

/// A function under test.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Name, as in `shared/`; of a test of several, what they have in common.
    pub name: &'static str,
    /// The text that holds its entry point.
    pub part: &'static str,
    /// Its table of edges.
    pub edges: Edges,
    /// The result words of input `i`.
    pub answer: fn(&Inputs, u32) -> [u32; 4],
}

impl Function {
    /// Name of its entry point.
    pub fn entry(&self) -> String {
        format!("test_{}", self.name)
    }

    /// The digest of a block of inputs.
    pub fn digest(&self, block: u32) -> u32 {
        let inputs = Inputs::shapes(self.edges);
        let first = block * BLOCK;
        let hash = |i| super::inputs::digest(i, (self.answer)(&inputs, i));
        (first..first + BLOCK).map(hash).fold(0, u32::wrapping_add)
    }

    /// The result words of all pairs of the table of edges.
    pub fn whole(&self) -> Vec<u32> {
        let inputs = Inputs::edges(self.edges);
        (0..BLOCK).flat_map(|i| (self.answer)(&inputs, i)).collect()
    }
}

/// All of them, part by part.
pub fn functions() -> impl Iterator<Item = &'static Function> {
    [&angle::ALL[..], &divide::ALL, &float::ALL, &line::ALL, &plane::ALL, &wide::ALL].into_iter().flatten()
}

/// Low and high word.
fn split(x: u64) -> [u32; 2] {
    [x as u32, (x >> 32) as u32]
}

/// 64 bits from low and high word.
fn join(low: u32, high: u32) -> u64 {
    u64::from(high) << 32 | u64::from(low)
}

fn one(x: u32) -> [u32; 4] {
    [x, 0, 0, 0]
}

fn two(x: u32, y: u32) -> [u32; 4] {
    [x, y, 0, 0]
}

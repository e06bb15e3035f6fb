//! Bit counts: how many light samples each receiver sees.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 8 and figure 4. The masks of hidden
//! samples become the two numbers that a soft shadow needs. `kernel.wgsl` states the layout and both outputs exactly.
//! Invariant: the four methods give the same words.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "popcount",
    summary: "number of hidden and of visible light samples of every receiver, from its bit mask",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, section 8 and figure 4",
    programs: || Ok(vec![Popcount::new()?.program]),
    cases: cases::all,
};

/// Most words of a mask: 1024 samples of 32 bits a word.
pub const MAX_WORDS: u32 = 32;

/// Invocations a workgroup, one for each receiver.
const GROUP: u32 = 256;

/// How bits are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Fields that double in five steps, as figure 4 draws it.
    Logarithmic,
    /// One bit after the other.
    BitLoop,
    /// A look-up for each byte.
    Table,
    /// WGSL's `countOneBits`.
    Builtin,
}

impl Method {
    /// All four.
    pub const ALL: [Method; 4] = [Method::Logarithmic, Method::BitLoop, Method::Table, Method::Builtin];

    /// Name of its entry point.
    pub fn entry(self) -> &'static str {
        match self {
            Method::Logarithmic => "logarithmic",
            Method::BitLoop => "bit_loop",
            Method::Table => "table",
            Method::Builtin => "builtin",
        }
    }
}

/// Size of a set of masks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Number of receivers.
    pub receivers: u32,
    /// Samples a receiver, at least 1.
    pub samples: u32,
    /// Samples a word, 1 to 32.
    pub bits: u32,
}

impl Shape {
    /// Words a receiver.
    pub fn words(&self) -> u32 {
        self.samples.div_ceil(self.bits)
    }

    fn check(&self, masks: u64, outputs: u64) -> Result<()> {
        let Shape { receivers, samples, bits } = *self;
        if !(1..=32).contains(&bits) || !(1..=MAX_WORDS).contains(&self.words()) {
            let what = format!("masks of {samples} samples, {bits} a word");
            return Err(Error::refused(
                what,
                format!("use 1 to 32 samples a word and 1 to {MAX_WORDS} words a receiver"),
            ));
        }
        let (receivers, words) = (u64::from(receivers), u64::from(self.words()));
        if masks < receivers * words || outputs < receivers {
            let what =
                format!("{masks} words of masks and {outputs} of output for {receivers} receivers of {words} words");
            return Err(Error::refused(what, "give every receiver its words, and one word of each output"));
        }
        Ok(())
    }
}

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of receivers.
        pub receivers: u32,
        /// Words a receiver.
        pub words: u32,
        /// Samples a receiver.
        pub samples: u32,
        /// Samples a word.
        pub bits: u32,
        /// Receiver of the first invocation.
        pub first: u32,
    }
}

bindings! {
    /// What every method but the table is given.
    pub struct Count {
        uniform params @ 0: Params,
        read masks @ 1: [u32],
        write hidden @ 2: [u32],
        write visible @ 3: [u32],
    }

    /// What [`Method::Table`] is given.
    pub struct CountByTable {
        uniform params @ 0: Params,
        read masks @ 1: [u32],
        write hidden @ 2: [u32],
        write visible @ 3: [u32],
        read byte_counts @ 4: [u32; 256],
    }
}

/// The compiled kernel.
pub struct Popcount {
    program: Arc<Program>,
}

impl Popcount {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("popcount", "", &[])?;
        for method in [Method::Logarithmic, Method::BitLoop, Method::Builtin] {
            Count::check(&program, method.entry())?;
        }
        CountByTable::check(&program, Method::Table.entry())?;
        Ok(Popcount { program })
    }

    /// Counts the masks of `shape` into one word a receiver of `hidden` and of `visible`.
    pub fn record(
        &self,
        job: &mut Job,
        method: Method,
        shape: Shape,
        masks: Buffer<[u32]>,
        hidden: Buffer<[u32]>,
        visible: Buffer<[u32]>,
    ) -> Result<()> {
        shape.check(masks.len(), hidden.len().min(visible.len()))?;
        let Shape { receivers, samples, bits } = shape;
        let words = shape.words();
        let program = job.program(&self.program);
        let byte_counts = (method == Method::Table).then(|| job.value("bits of every byte", &byte_counts()));
        pieces::record(job, receivers.div_ceil(GROUP), u64::from(GROUP * (words + 2)), |job, piece| {
            let first = piece.start * GROUP;
            let params = job.value("popcount params", &Params { receivers, words, samples, bits, first });
            let groups = [piece.len() as u32, 1, 1];
            match byte_counts {
                None => job.launch(program, method.entry(), &Count { params, masks, hidden, visible }, groups),
                Some(byte_counts) => {
                    let bound = CountByTable { params, masks, hidden, visible, byte_counts };
                    job.launch(program, method.entry(), &bound, groups);
                }
            }
        });
        Ok(())
    }
}

/// Number of set bits of every byte, each from that of half of it.
fn byte_counts() -> [u32; 256] {
    let mut counts = [0; 256];
    for byte in 1..256 {
        counts[byte] = counts[byte / 2] + byte as u32 % 2;
    }
    counts
}

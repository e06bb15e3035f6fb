//! Prefix sums of u32, inclusive and exclusive, modulo 2³².
//!
//! Merrill and Grimshaw's reduce-then-scan over tiles of 4096 words, level upon level, without forward progress between
//! workgroups. Uses: stream compaction, offsets of lists made from counts, ranges of a histogram. `kernel.wgsl` states
//! the output exactly. Invariant: sums wrap, so any order of additions gives the same words.

use std::sync::Arc;

use glam::UVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "scan",
    summary: "inclusive and exclusive prefix sums of up to 2^25 words",
    citation: "Merrill and Grimshaw, Parallel Scan for Stream Architectures, 2009",
    programs: || {
        let Scan { inclusive, exclusive } = Scan::new()?;
        Ok(vec![inclusive, exclusive])
    },
    cases: cases::all,
};

/// Most words: they fill a binding of 128 MiB.
pub const MAX_COUNT: u32 = 1 << 25;

/// Words a workgroup.
const TILE: u32 = 4096;

/// Whether a word's sum holds the word itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// It does.
    Inclusive,
    /// It holds only what comes before.
    Exclusive,
}

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of words.
        pub count: u32,
        /// Tile of the first workgroup.
        pub first: u32,
    }
}

bindings! {
    /// What `reduce` is given.
    pub struct Reduce {
        uniform params @ 0: Params,
        write sums @ 2: [u32],
        read words @ 5: [u32],
    }

    /// What `scan` is given.
    pub struct ScanTiles {
        uniform params @ 0: Params,
        read input @ 1: [UVec4],
        read carries @ 3: [u32],
        write output @ 4: [UVec4],
    }
}

/// The compiled kernel.
pub struct Scan {
    inclusive: Arc<Program>,
    exclusive: Arc<Program>,
}

impl Scan {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let variant = |name: &str, inclusive: bool| {
            let program = crate::program("scan", name, &[Define::new("INCLUSIVE", inclusive)])?;
            Reduce::check(&program, "reduce")?;
            ScanTiles::check(&program, "scan")?;
            Ok::<_, Error>(program)
        };
        Ok(Scan { inclusive: variant("inclusive", true)?, exclusive: variant("exclusive", false)? })
    }

    /// Scans the first `count` words of `input` into `output`.
    ///
    /// Both buffers hold a multiple of four words, and at least `count` and four; they must not overlap.
    pub fn record(
        &self,
        job: &mut Job,
        kind: Kind,
        count: u32,
        input: Buffer<[u32]>,
        output: Buffer<[u32]>,
    ) -> Result<()> {
        let wanted = u64::from(count.max(1).next_multiple_of(4));
        for (name, words) in [("input", input.len()), ("output", output.len())] {
            if count > MAX_COUNT || words < wanted || !words.is_multiple_of(4) {
                let what = format!("a scan of {count} words with an {name} of {words}");
                let remedy = format!("scan at most {MAX_COUNT} words, in buffers of a multiple of four");
                return Err(Error::refused(what, remedy));
            }
        }
        self.level(job, kind, count, input, output);
        Ok(())
    }

    /// Scans one level, and the sums of its tiles one level up.
    fn level(&self, job: &mut Job, kind: Kind, count: u32, input: Buffer<[u32]>, output: Buffer<[u32]>) {
        let tiles = count.div_ceil(TILE).max(1);
        let carries = job.zeroed("scan carries", u64::from(tiles.next_multiple_of(4)));
        if tiles > 1 {
            let sums = job.zeroed("scan sums", carries.len());
            let program = job.program(&self.exclusive);
            pieces::record(job, tiles, u64::from(TILE), |job, piece| {
                let params = job.value("scan params", &Params { count, first: piece.start });
                let bound = Reduce { params, sums, words: input };
                job.launch(program, "reduce", &bound, [piece.len() as u32, 1, 1]);
            });
            self.level(job, Kind::Exclusive, tiles, sums, carries);
        }
        let program = job.program(match kind {
            Kind::Inclusive => &self.inclusive,
            Kind::Exclusive => &self.exclusive,
        });
        pieces::record(job, tiles, u64::from(2 * TILE), |job, piece| {
            let params = job.value("scan params", &Params { count, first: piece.start });
            let bound = ScanTiles { params, input: fours(input), carries, output: fours(output) };
            job.launch(program, "scan", &bound, [piece.len() as u32, 1, 1]);
        });
    }
}

/// The same words, four at a time.
fn fours(words: Buffer<[u32]>) -> Buffer<[UVec4]> {
    let slot = words.slot(0, 0);
    Buffer::from_raw(slot.buffer, slot.offset, slot.size)
}

//! Tile lists: which triangles can hide anything from the receivers of each tile, sorted on the device.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 3, gives each triangle a region; the
//! sort is a count, a scan and a scatter. `kernel.wgsl` states the outputs exactly. Buffers are fixed before a device
//! has counted, so [`TileLists::record_tally`] first tells how many entries there will be. Invariant: the lists are
//! those of [`Tiles::new`](crate::tiles::Tiles::new), in the same order on every machine.

use std::iter::Sum;
use std::sync::Arc;

use glam::IVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;
use crate::scan::{Kind, MAX_COUNT, Scan};

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "tile_lists",
    summary: "triangles sorted into tiles of receivers by their influence regions",
    citation: "Satish, Harris and Garland, Designing Efficient Sorting Algorithms for Manycore GPUs, 2009; \
               Eisemann and Décoret 2007, section 3",
    programs: || Ok(vec![TileLists::new()?.program]),
    cases: cases::all,
};

/// Triangles of a block.
pub const BLOCK: u32 = 1024;

/// Tiles of a window.
const WINDOW: u32 = 1024;

/// Most tiles in a row, so that no invocation's loops turn as often as some devices bear: 16 steps of three walks over
/// at most 513 tiles and ends of rows (docs/adding-a-kernel.md).
const MAX_TILES_X: u32 = 512;

/// Words of a block's tally.
const TALLY: u32 = 8;

const LANES: u32 = 256;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of triangles.
        pub triangles: u32,
        /// Blocks of triangles.
        pub blocks: u32,
        /// Block of the first workgroup.
        pub first: u32,
        /// Logarithm of a tile's receivers along x.
        pub shift_x: u32,
        /// Logarithm of a tile's receivers along y.
        pub shift_y: u32,
        /// Tiles along x.
        pub tiles_x: u32,
        /// Tiles along y.
        pub tiles_y: u32,
        /// Rows of tiles in a window.
        pub window: u32,
    }
}

bindings! {
    /// What `tally` is given.
    pub struct TallyBlocks {
        uniform params @ 0: Params,
        read regions @ 1: [IVec4],
        write tallies @ 2: [u32],
    }

    /// What `count` is given.
    pub struct Count {
        uniform params @ 0: Params,
        read regions @ 1: [IVec4],
        write counts @ 3: [u32],
    }

    /// What `start` is given.
    pub struct Start {
        uniform params @ 0: Params,
        read offsets @ 4: [u32],
        write starts @ 5: [u32],
    }

    /// What `scatter` is given.
    pub struct Scatter {
        uniform params @ 0: Params,
        read regions @ 1: [IVec4],
        read offsets @ 4: [u32],
        write entries @ 6: [u32],
    }
}

/// What some triangles come to, before they are sorted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Entries of their lists in tiles of 1, 2, 4 and 8 times the rows asked for.
    pub entries: [u64; 4],
    /// How many have a region.
    pub triangles: u64,
    /// Rows of all regions.
    pub rows: u64,
    /// Receivers of all regions.
    pub pairs: u64,
}

impl Tally {
    /// The tallies of all blocks, from the words that the device wrote.
    pub fn blocks(words: &[u32]) -> impl Iterator<Item = Tally> {
        words.as_chunks().0.iter().map(|words: &[u32; TALLY as usize]| {
            let [a, b, c, d, triangles, rows, low, high] = words.map(u64::from);
            Tally { entries: [a, b, c, d], triangles, rows, pairs: low + (high << 16) }
        })
    }
}

impl Sum for Tally {
    fn sum<I: Iterator<Item = Tally>>(tallies: I) -> Tally {
        tallies.fold(Tally::default(), |sum, more| Tally {
            entries: std::array::from_fn(|k| sum.entries[k] + more.entries[k]),
            triangles: sum.triangles + more.triangles,
            rows: sum.rows + more.rows,
            pairs: sum.pairs + more.pairs,
        })
    }
}

/// A field of receivers in tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grid {
    /// Receivers of a tile along x and y: powers of two.
    pub size: [u32; 2],
    /// Receivers along x and y.
    pub receivers: [u32; 2],
}

impl Grid {
    /// Tiles along x and y.
    pub fn tiles(&self) -> [u32; 2] {
        [0, 1].map(|axis| self.receivers[axis].div_ceil(self.size[axis]))
    }

    /// Words that sorting so many triangles takes beside regions and entries.
    pub fn words(&self, triangles: u64) -> u64 {
        let [x, y] = self.tiles();
        2 * u64::from(x) * u64::from(y) * triangles.div_ceil(u64::from(BLOCK)).max(1)
    }

    fn check(&self, triangles: u32) -> Result<()> {
        let [x, y] = self.tiles();
        let fits = self.size.iter().all(|side| side.is_power_of_two()) && x <= MAX_TILES_X && x > 0 && y > 0;
        if !fits || self.words(triangles.into()) / 2 >= u64::from(MAX_COUNT) {
            let what = format!("{triangles} triangles in {x} by {y} tiles of {:?} receivers", self.size);
            let remedy =
                format!("use sides of powers of two, at most {MAX_TILES_X} tiles in a row, and tiles times blocks");
            return Err(Error::refused(what, format!("{remedy} of {BLOCK} triangles below {MAX_COUNT}")));
        }
        Ok(())
    }

    fn params(&self, triangles: u32, first: u32) -> Params {
        let [tiles_x, tiles_y] = self.tiles();
        let [shift_x, shift_y] = self.size.map(u32::ilog2);
        let window = (WINDOW / tiles_x).min(tiles_y);
        Params { triangles, blocks: blocks(triangles), first, shift_x, shift_y, tiles_x, tiles_y, window }
    }
}

/// Blocks of so many triangles; one even if there are none, so that empty lists are written too.
fn blocks(triangles: u32) -> u32 {
    triangles.div_ceil(BLOCK).max(1)
}

/// The compiled kernel.
pub struct TileLists {
    program: Arc<Program>,
    scan: Scan,
}

impl TileLists {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let defines = [("BLOCK", BLOCK), ("WINDOW", WINDOW)].map(|(name, n)| Define::new(name, format!("{n}u")));
        let program = crate::program("tile_lists", "", &defines)?;
        TallyBlocks::check(&program, "tally")?;
        Count::check(&program, "count")?;
        Start::check(&program, "start")?;
        Scatter::check(&program, "scatter")?;
        Ok(TileLists { program, scan: Scan::new()? })
    }

    /// Tallies triangles by their regions, four words each; the answer is read by [`Tally::blocks`].
    pub fn record_tally(&self, job: &mut Job, grid: Grid, regions: Buffer<[i32]>) -> Result<Buffer<[u32]>> {
        let (triangles, regions) = fours(regions)?;
        grid.check(0)?;
        let tallies = job.zeroed("tallies", u64::from(TALLY * blocks(triangles)));
        let program = job.program(&self.program);
        pieces::record(job, blocks(triangles), u64::from(4 * BLOCK + 2 * TALLY * LANES), |job, piece| {
            let params = job.value("tally params", &grid.params(triangles, piece.start));
            job.launch(program, "tally", &TallyBlocks { params, regions, tallies }, [piece.len() as u32, 1, 1]);
        });
        Ok(tallies)
    }

    /// Sorts triangles into lists by their regions, four words each. `entries` holds as many words as there will be;
    /// the answer is where the list of each tile begins, and where the last ends.
    pub fn record(
        &self,
        job: &mut Job,
        grid: Grid,
        regions: Buffer<[i32]>,
        entries: Buffer<[u32]>,
    ) -> Result<Buffer<[u32]>> {
        let (triangles, regions) = fours(regions)?;
        grid.check(triangles)?;
        let [x, y] = grid.tiles();
        // One more, whose offset is the number of all entries.
        let words = x * y * blocks(triangles) + 1;
        let [counts, offsets] =
            ["tile counts", "tile offsets"].map(|name| job.zeroed(name, words.next_multiple_of(4).into()));
        let starts = job.zeroed("tile starts", u64::from(x * y + 1));
        let program = job.program(&self.program);
        let windows = y.div_ceil(grid.params(triangles, 0).window);
        let each = u64::from(windows * (16 * BLOCK + 4 * WINDOW));
        pieces::record(job, blocks(triangles), each, |job, piece| {
            let params = job.value("count params", &grid.params(triangles, piece.start));
            job.launch(program, "count", &Count { params, regions, counts }, [piece.len() as u32, windows, 1]);
        });
        self.scan.record(job, Kind::Exclusive, words, counts, offsets)?;
        pieces::record(job, (x * y + 1).div_ceil(LANES), u64::from(2 * LANES), |job, piece| {
            let params = job.value("start params", &grid.params(triangles, piece.start));
            job.launch(program, "start", &Start { params, offsets, starts }, [piece.len() as u32, 1, 1]);
        });
        pieces::record(job, blocks(triangles), 4 * each, |job, piece| {
            let params = job.value("scatter params", &grid.params(triangles, piece.start));
            let bound = Scatter { params, regions, offsets, entries };
            job.launch(program, "scatter", &bound, [piece.len() as u32, windows, 1]);
        });
        Ok(starts)
    }
}

/// Number of triangles of `regions`, and the same words four at a time.
fn fours(regions: Buffer<[i32]>) -> Result<(u32, Buffer<[IVec4]>)> {
    let triangles = regions.len() / 4;
    if !regions.len().is_multiple_of(4) || triangles == 0 || triangles > u64::from(MAX_COUNT / 4) {
        let what = format!("{} words of regions", regions.len());
        return Err(Error::refused(what, format!("give four words a triangle, and 1 to {} triangles", MAX_COUNT / 4)));
    }
    let slot = regions.slot(0, 0);
    Ok((triangles as u32, Buffer::from_raw(slot.buffer, slot.offset, slot.size)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tallies_add_up_beyond_a_word() {
        let words = [1, 2, 3, 4, 5, 6, u32::MAX, 1 << 20];
        let sum: Tally = Tally::blocks(&[words, words].concat()).sum();
        let pairs = 2 * (u64::from(u32::MAX) + (1 << 36));
        assert_eq!(sum, Tally { entries: [2, 4, 6, 8], triangles: 10, rows: 12, pairs });
    }
}

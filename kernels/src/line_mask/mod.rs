//! Line masks: the masks of any pattern of samples by a table over the space of lines.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 5 and 6. `build.wgsl` states what a
//! table holds, `kernel.wgsl` what is made of it. Invariant: with an exact table the masks are those of
//! [`crate::grid::hidden`], bit for bit, on every machine and whatever the resolution; with the paper's they are equal
//! on every machine, and as wrong as its resolution makes them.

use std::sync::Arc;

use glam::{IVec2, IVec4};
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::field::Field;
use crate::grid::{Faces, Triangle};
use crate::pattern::Pattern;
use crate::pieces;
use crate::row_span::Scene;
use crate::tiles::{Launch, Tiles};

mod axes;
mod cases;
pub mod oracle;

pub use axes::{AXIS, axes};

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "line_mask",
    summary: "samples of any pattern that triangles hide, by a table of lines: exact, or the paper's",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, sections 5 and 6",
    programs: || {
        let [exact, front] = [Faces::Both, Faces::Front].map(|faces| program(Space::Exact, faces));
        Ok(vec![builder()?, differ()?, exact?, program(Space::Sampled, Faces::Both)?, front?])
    },
    cases: cases::all,
};

/// Workgroups times list entries of one recording.
const PAIRS: u64 = 1 << 16;

/// Entries of a tile's list that one launch takes: even if every sample is in doubt an invocation's loops turn at most
/// 36,000 times, and some devices end all at 65,535 (docs/adding-a-kernel.md).
const LIST: u32 = 1 << 8;

const GROUP: u32 = 256;

/// Bytes that one binding may have.
const MAX_TABLE: u64 = 128 << 20;

host! {
    /// Mirrors `struct Params` of `build.wgsl`.
    pub struct BuildParams {
        /// Cell of the first invocation.
        pub first: u32,
        /// Cells of the table.
        pub cells: u32,
        /// Samples lie in the square of half side 2^h.
        pub h: u32,
        /// log2 of the number of directions, or of angles.
        pub k: u32,
        /// Number of samples.
        pub samples: u32,
        /// Samples of a word.
        pub bits: u32,
        /// Words of a mask.
        pub words: u32,
    }

    /// Mirrors `struct Params` of `differ.wgsl`.
    pub struct DifferParams {
        /// Word of the first invocation.
        pub first: u32,
        /// Words of a map.
        pub words: u32,
        /// Where the counts begin.
        pub slot: u32,
    }

    /// Mirrors `struct Params` of `kernel.wgsl`.
    pub struct Params {
        /// Receiver row of the first workgroup row.
        pub first_row: u32,
        /// Receiver rows that share a tile list.
        pub tile_rows: u32,
        /// Tiles along x.
        pub tiles: u32,
        /// x of the centre of the pattern.
        pub centre_x: i32,
        /// y of the centre of the pattern.
        pub centre_y: i32,
        /// Samples lie in the square of half side 2^h about the centre.
        pub h: u32,
        /// log2 of the table's directions, or angles.
        pub k: u32,
        /// Number of samples.
        pub samples: u32,
        /// Samples of a word.
        pub bits: u32,
        /// Words of a mask.
        pub words: u32,
        /// Where the words of the cell without samples begin.
        pub empty: u32,
        /// Entries of each list that earlier launches have taken.
        pub skip: u32,
        /// Receivers along x.
        pub columns: u32,
        /// Receivers along y.
        pub rows: u32,
    }
}

bindings! {
    /// What `build_exact` is given.
    pub struct BuildExact {
        uniform params @ 0: BuildParams,
        read samples @ 1: [IVec2],
        write table @ 3: [u32],
    }

    /// What `build_sampled` is given.
    pub struct BuildSampled {
        uniform params @ 0: BuildParams,
        read samples @ 1: [IVec2],
        read axes @ 2: [IVec4],
        write table @ 3: [u32],
    }

    /// What `differ` is given.
    pub struct Differ {
        uniform params @ 0: DifferParams,
        read found @ 1: [u32],
        read truth @ 2: [u32],
        write counts @ 3: [u32],
    }

    /// What `line_mask` is given.
    pub struct Lookups {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        read starts @ 2: [u32],
        read entries @ 3: [u32],
        read samples @ 4: [IVec2],
        read table @ 5: [u32],
        write hidden @ 6: [u32],
        read receivers @ 7: [IVec4],
    }
}

/// A space of oriented lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// L1 directions and offsets; a cell knows what is certain, and what is not is decided by signs. 2^k directions in
    /// each of two quadrants by 2^(k + 1) offsets, two masks a cell.
    Exact,
    /// The paper's angles and distances, 2^k of each; a texel's mask is that of its centre.
    Sampled,
}

/// A space cut into cells: `bits` is the k of [`Space`], 1 to 10.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    /// The space.
    pub space: Space,
    /// log2 of its directions or angles.
    pub bits: u32,
}

impl Resolution {
    /// An exact table in which a cell leaves few samples to be decided: 64 directions up to 128 samples, else 128.
    pub fn exact(pattern: &Pattern) -> Self {
        Resolution { space: Space::Exact, bits: if pattern.count() <= 128 { 6 } else { 7 } }
    }

    /// Cells of the table.
    pub fn cells(self) -> u32 {
        match self.space {
            Space::Exact => 1 << (2 * self.bits + 2),
            Space::Sampled => 1 << (2 * self.bits),
        }
    }

    /// Words of a cell whose masks have `words` words.
    fn cell_words(self, words: u32) -> u64 {
        match self.space {
            Space::Exact => 2 * u64::from(words),
            Space::Sampled => u64::from(words),
        }
    }
}

/// A pattern's table on a device.
#[derive(Clone, Copy)]
pub struct Table {
    /// The samples, relative to the pattern's centre.
    pub samples: Buffer<[IVec2]>,
    /// The masks of its cells, and an empty one.
    pub cells: Buffer<[u32]>,
}

/// Adds to a job all that makes the masks of `triangles` in `tiles`, which are [`TILE`] receivers large or a multiple
/// of it in height: scene, table and look-ups. Returns the masks: sample s of receiver r in bit `s % bits` of word `(s
/// / bits) * receivers + r`.
pub fn record_masks(
    job: &mut Job,
    pattern: &Pattern,
    resolution: Resolution,
    field: &Field,
    tiles: &Tiles,
    triangles: &[Triangle],
) -> Result<Buffer<[u32]>> {
    record_masks_by(job, &LineMask::new(pattern, resolution)?, field, tiles, triangles)
}

/// [`record_masks`] by a compiled kernel.
pub fn record_masks_by(
    job: &mut Job,
    kernel: &LineMask,
    field: &Field,
    tiles: &Tiles,
    triangles: &[Triangle],
) -> Result<Buffer<[u32]>> {
    let words = triangles.as_flattened().as_flattened();
    // A binding holds at least one element.
    let vertices = job.slice("vertices", if words.is_empty() { &[0] } else { words });
    let starts = job.slice("starts", &tiles.starts);
    let entries = job.slice("entries", if tiles.entries.is_empty() { &[0] } else { &tiles.entries[..] });
    let hidden = job.zeroed("hidden", u64::from(field.count()) * u64::from(kernel.pattern.words()));
    let table = kernel.record_table(job);
    kernel.record(job, field, tiles, table, Scene { vertices, starts, entries, hidden })?;
    Ok(hidden)
}

fn builder() -> Result<Arc<Program>> {
    let program = Program::new("line_mask.build", "line_mask/build.wgsl", &crate::source, &[])?;
    BuildExact::check(&program, "build_exact")?;
    BuildSampled::check(&program, "build_sampled")?;
    Ok(program)
}

fn differ() -> Result<Arc<Program>> {
    let program = Program::new("line_mask.differ", "line_mask/differ.wgsl", &crate::source, &[])?;
    Differ::check(&program, "differ")?;
    Ok(program)
}

/// Adds to `counts[slot]` the bits that of two hidden-samples maps only `found` has, and to `counts[slot + 1]` those
/// that only `truth` has: how wrong a table is.
pub fn record_differ(
    job: &mut Job,
    found: Buffer<[u32]>,
    truth: Buffer<[u32]>,
    slot: u32,
    counts: Buffer<[u32]>,
) -> Result<()> {
    if found.len() != truth.len() || found.len() > u64::from(u32::MAX) || counts.len() < u64::from(slot) + 2 {
        let what = format!("maps of {} and {} words, {} counts", found.len(), truth.len(), counts.len());
        return Err(Error::refused(what, "compare maps of equal size, and give two counts at the slot"));
    }
    let words = found.len() as u32;
    let program = job.program(&differ()?);
    pieces::record(job, words.div_ceil(256), 2 * 256, |job, piece| {
        let params = job.value("differ params", &DifferParams { first: piece.start * 256, words, slot });
        job.launch(program, "differ", &Differ { params, found, truth, counts }, [piece.len() as u32, 1, 1]);
    });
    Ok(())
}

fn program(space: Space, faces: Faces) -> Result<Arc<Program>> {
    let mut defines = vec![Define::new("EXACT", space == Space::Exact), Define::new("LIST", format!("{LIST}u"))];
    let mut variant = match space {
        Space::Exact => "exact",
        Space::Sampled => "sampled",
    }
    .to_owned();
    if faces == Faces::Front {
        defines.push(Define::new("ONE_SIDED", true));
        variant += "-front";
    }
    let program = crate::program("line_mask", &variant, &defines)?;
    Lookups::check(&program, "line_mask")?;
    Ok(program)
}

/// Receivers of one workgroup along x and y: a tile is as wide, and as high or a multiple of it.
pub const TILE: [u32; 2] = [4, 4];

/// The compiled kernel, for one pattern.
pub struct LineMask {
    builder: Arc<Program>,
    program: Arc<Program>,
    pattern: Pattern,
    resolution: Resolution,
}

impl LineMask {
    /// Compiles it for a pattern, a resolution of its table, and triangles that hide by either face.
    pub fn new(pattern: &Pattern, resolution: Resolution) -> Result<Self> {
        Self::with_faces(pattern, resolution, Faces::Both)
    }

    /// Compiles it for triangles that hide by some faces.
    pub fn with_faces(pattern: &Pattern, resolution: Resolution, faces: Faces) -> Result<Self> {
        let bytes = 4 * resolution.cell_words(pattern.words()) * u64::from(resolution.cells() + 1);
        if !(1..=10).contains(&resolution.bits) || bytes > MAX_TABLE {
            let what = format!("a table of {bytes} bytes: {} bits of direction", resolution.bits);
            return Err(Error::refused(what, format!("use 1 to 10 bits, and at most {MAX_TABLE} bytes")));
        }
        let pattern = pattern.clone();
        Ok(LineMask { builder: builder()?, program: program(resolution.space, faces)?, pattern, resolution })
    }

    /// Builds the table, in recordings of bounded cost.
    pub fn record_table(&self, job: &mut Job) -> Table {
        let words = self.pattern.words();
        let centre = IVec2::from_array(self.pattern.centre());
        let points: Vec<IVec2> = self.pattern.points().iter().map(|p| IVec2::from_array(*p) - centre).collect();
        let samples = job.slice("samples", &points);
        let cells = self.resolution.cells();
        let table = job.zeroed("table", self.table_words());
        let program = job.program(&self.builder);
        let axes = match self.resolution.space {
            Space::Exact => None,
            Space::Sampled => Some(job.slice("axes", &axes(self.pattern.half_side_bits(), self.resolution.bits))),
        };
        pieces::record(job, cells.div_ceil(GROUP), u64::from(GROUP * words * self.pattern.bits()), |job, piece| {
            let params = job.value("table params", &self.build_params(piece.start * GROUP));
            let groups = [piece.len() as u32, words, 1];
            match axes {
                None => job.launch(program, "build_exact", &BuildExact { params, samples, table }, groups),
                Some(axes) => {
                    job.launch(program, "build_sampled", &BuildSampled { params, samples, axes, table }, groups);
                }
            }
        });
        Table { samples, cells: table }
    }

    /// Adds the samples that the tiles' triangles hide to `hidden`, in recordings of bounded cost. `table` is this
    /// pattern's, and triangles may lie anywhere on the grid.
    pub fn record(&self, job: &mut Job, field: &Field, tiles: &Tiles, table: Table, scene: Scene) -> Result<()> {
        field.check(&self.pattern)?;
        let words = u64::from(field.count()) * u64::from(self.pattern.words());
        let [width, height] = TILE;
        if tiles.size[0] != width || !tiles.size[1].is_multiple_of(height) || scene.hidden.len() < words {
            let what = format!("tiles of {:?} receivers and {} words of masks", tiles.size, scene.hidden.len());
            let remedy = format!("use tiles {width} wide and a multiple of {height} high, and {words} words");
            return Err(Error::refused(what, remedy));
        }
        if table.cells.len() != self.table_words() || table.samples.len() != u64::from(self.pattern.count()) {
            let what = format!("a table of {} words for {} samples", table.cells.len(), table.samples.len());
            return Err(Error::refused(what, "record the table of this pattern and resolution"));
        }
        let program = job.program(&self.program);
        let receivers = field.upload(job);
        for Launch { rows, skip } in tiles.launches(field.rows(), height, PAIRS, LIST) {
            pieces::cut(job);
            let params = job.value("line mask params", &self.params(field, tiles, rows.start, skip));
            let Scene { vertices, starts, entries, hidden } = scene;
            let Table { samples, cells: table } = table;
            let bound = Lookups { params, vertices, starts, entries, samples, table, hidden, receivers };
            let groups = [tiles.count[0], (rows.len() as u32).div_ceil(height), 1];
            job.launch(program, "line_mask", &bound, groups);
        }
        Ok(())
    }

    /// Words of all cells, and of one more that stays empty.
    fn table_words(&self) -> u64 {
        self.resolution.cell_words(self.pattern.words()) * u64::from(self.resolution.cells() + 1)
    }

    fn build_params(&self, first: u32) -> BuildParams {
        BuildParams {
            first,
            cells: self.resolution.cells(),
            h: self.pattern.half_side_bits(),
            k: self.resolution.bits,
            samples: self.pattern.count(),
            bits: self.pattern.bits(),
            words: self.pattern.words(),
        }
    }

    fn params(&self, field: &Field, tiles: &Tiles, first_row: u32, skip: u32) -> Params {
        let [centre_x, centre_y] = self.pattern.centre();
        Params {
            first_row,
            tile_rows: tiles.size[1],
            tiles: tiles.count[0],
            centre_x,
            centre_y,
            h: self.pattern.half_side_bits(),
            k: self.resolution.bits,
            samples: self.pattern.count(),
            bits: self.pattern.bits(),
            words: self.pattern.words(),
            empty: (self.table_words() - self.resolution.cell_words(self.pattern.words())) as u32,
            skip,
            columns: field.columns(),
            rows: field.rows(),
        }
    }
}

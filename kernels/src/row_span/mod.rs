//! Row spans: the exact masks of a regular light, without a table.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 4 and 5. `kernel.wgsl` states the
//! output and the facts it rests on. Invariant: the masks are those of [`crate::grid::hidden`], bit for bit, on every
//! machine.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Command, Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::grid::{Faces, Receivers, Samples, Triangle, View};
use crate::pieces;
use crate::tiles::{Launch, Tiles};

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "row_span",
    summary: "samples of a regular light that triangles hide from each receiver, row by row and exactly",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, sections 4 and 5",
    programs: || {
        let lights = [(32, 32), (16, 16), (8, 8), (8, 4)];
        let both = [Faces::Both, Faces::Front].into_iter();
        both.flat_map(|faces| lights.map(|(columns, rows)| program(columns, rows, faces))).collect()
    },
    cases: cases::all,
};

/// Receivers of one workgroup along x, and so the width of a tile.
pub const WIDTH: u32 = 16;

/// Receivers of one workgroup along y: the rows of a tile are a multiple of them.
pub const HEIGHT: u32 = 4;

/// Most triangles: their numbers share a word with two rows.
const MAX_TRIANGLES: u64 = 1 << 25;

/// Workgroups times list entries of one recording: a second or two on the slowest software device.
const PAIRS: u64 = 1 << 17;

/// Entries of a tile's list that one launch takes, so that no invocation's loops turn as often as some devices bear
/// (docs/numerics.md).
const LIST: u32 = 1 << 12;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Receiver row of the first workgroup row.
        pub first_row: u32,
        /// Receiver rows that share a tile list: a multiple of [`HEIGHT`].
        pub tile_rows: u32,
        /// Tiles along x.
        pub tiles: u32,
        /// Entries of each list that earlier launches have taken.
        pub skip: u32,
        /// Light and receivers.
        pub view: View,
    }
}

bindings! {
    /// What the entry point is given.
    pub struct Spans {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        read starts @ 2: [u32],
        read entries @ 3: [u32],
        write hidden @ 4: [u32],
    }
}

/// Whether a triangle is one that this kernel takes: strictly between source and receivers.
pub fn is_between(triangle: &Triangle, height: i32) -> bool {
    triangle.iter().all(|v| (1..height).contains(&v[2]))
}

fn program(columns: u32, rows: u32, faces: Faces) -> Result<Arc<Program>> {
    let values = [("COLUMNS", columns), ("ROWS", rows), ("LIST", LIST), ("WIDTH", WIDTH), ("HEIGHT", HEIGHT)];
    let mut defines = values.map(|(name, value)| Define::new(name, format!("{value}u"))).to_vec();
    let mut variant = format!("{columns}x{rows}");
    if faces == Faces::Front {
        defines.push(Define::new("ONE_SIDED", true));
        variant += "-front";
    }
    let program = crate::program("row_span", &variant, &defines)?;
    Spans::check(&program, "row_span")?;
    Ok(program)
}

/// Buffers that stay the same from one recording to the next.
#[derive(Clone, Copy)]
pub struct Scene {
    /// Nine coordinates a triangle, all strictly between the planes.
    pub vertices: Buffer<[i32]>,
    /// [`Tiles::starts`].
    pub starts: Buffer<[u32]>,
    /// [`Tiles::entries`]; one word if there are none.
    pub entries: Buffer<[u32]>,
    /// Words of the masks: `(s / 32) * receivers + r`.
    pub hidden: Buffer<[u32]>,
}

/// The compiled kernel, for one shape of light.
pub struct RowSpan {
    program: Arc<Program>,
    samples: Samples,
}

impl RowSpan {
    /// Compiles it for as many columns and rows as `samples` has, and triangles that hide by either face.
    pub fn new(samples: &Samples) -> Result<Self> {
        Self::with_faces(samples, Faces::Both)
    }

    /// Compiles it for triangles that hide by some faces.
    pub fn with_faces(samples: &Samples, faces: Faces) -> Result<Self> {
        samples.check()?;
        Ok(RowSpan { program: program(samples.columns, samples.rows, faces)?, samples: *samples })
    }

    /// Adds the samples that the tiles' triangles hide to `hidden`, in recordings of bounded cost.
    pub fn record(&self, job: &mut Job, receivers: &Receivers, tiles: &Tiles, scene: Scene) -> Result<()> {
        self.launches(job, receivers, tiles, scene, |job, params| job.value("row span params", params))
    }

    /// All that [`launch`](Self::launch) adds to a job's tables.
    pub fn room(&self, job: &mut Job) -> Buffer<Params> {
        job.program(&self.program);
        let id = job.buffer("row span params", size_of::<Params>() as u64);
        Buffer::from_raw(id, 0, job.size(id))
    }

    /// [`record`](Self::record) without a further program or buffer, so that it fits a session that is open already and
    /// has sorted the lists itself: of `tiles` the starts matter.
    pub fn launch(
        &self,
        job: &mut Job,
        receivers: &Receivers,
        tiles: &Tiles,
        scene: Scene,
        room: Buffer<Params>,
    ) -> Result<()> {
        self.launches(job, receivers, tiles, scene, |job, params| {
            let bytes = bytemuck::bytes_of(params).to_vec();
            job.record(Command::Upload { buffer: room.id(), offset: 0, bytes });
            room
        })
    }

    /// Launches with parameters where `hold` puts them.
    fn launches(
        &self,
        job: &mut Job,
        receivers: &Receivers,
        tiles: &Tiles,
        scene: Scene,
        hold: impl Fn(&mut Job, &Params) -> Buffer<Params>,
    ) -> Result<()> {
        receivers.check()?;
        let words = u64::from(receivers.count()) * u64::from(self.samples.words());
        let triangles = scene.vertices.len() / 9;
        let is_tiled = tiles.size[0] == WIDTH && tiles.size[1].is_multiple_of(HEIGHT);
        if !is_tiled || scene.hidden.len() < words || triangles > MAX_TRIANGLES {
            let what = format!("tiles of {:?} receivers, {} words of masks", tiles.size, scene.hidden.len());
            let what = format!("{what} and {triangles} triangles");
            let remedy = format!("use tiles {WIDTH} receivers wide and a multiple of {HEIGHT} high, {words} words");
            let remedy = format!("{remedy}, and at most {MAX_TRIANGLES} triangles at a time");
            return Err(Error::refused(what, remedy));
        }
        let program = job.program(&self.program);
        for Launch { rows, skip } in tiles.launches(receivers.rows, HEIGHT, PAIRS, LIST) {
            pieces::cut(job);
            let params = hold(job, &self.params(receivers, tiles, rows.start, skip));
            let Scene { vertices, starts, entries, hidden } = scene;
            let bound = Spans { params, vertices, starts, entries, hidden };
            job.launch(program, "row_span", &bound, [tiles.count[0], (rows.len() as u32).div_ceil(HEIGHT), 1]);
        }
        Ok(())
    }

    fn params(&self, receivers: &Receivers, tiles: &Tiles, first_row: u32, skip: u32) -> Params {
        let view = View::new(&self.samples, receivers);
        Params { first_row, tile_rows: tiles.size[1], tiles: tiles.count[0], skip, view }
    }
}

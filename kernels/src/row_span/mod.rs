//! Row spans: the exact masks of a regular light, without a table.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 4 and 5. `kernel.wgsl` states the output and
//! the facts it rests on. Invariant: the masks are those of [`crate::grid::hidden`], bit for bit, on every machine.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::grid::{Receivers, Samples, Triangle, View};
use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "row_span",
    summary: "samples of a regular light that triangles hide from each receiver, row by row and exactly",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, sections 4 and 5",
    programs: || [(32, 32), (16, 16), (8, 8), (8, 4)].map(|(c, r)| program(c, r)).into_iter().collect(),
    cases: cases::all,
};

/// Workgroups times list entries of one recording: a second or two on the slowest software device.
const PAIRS: u64 = 1 << 17;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Receiver row of the first workgroup row.
        pub first_row: u32,
        /// Receiver rows that share a tile list.
        pub tile_rows: u32,
        /// Tiles along x.
        pub tiles: u32,
        /// WGSL places structs of a uniform at multiples of 16 bytes.
        pub _pad: u32,
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

/// Lists of triangles, one for each tile of receivers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tiles {
    /// Receivers of a tile along x and y.
    pub size: [u32; 2],
    /// Tiles along x and y.
    pub count: [u32; 2],
    /// First entry of each tile, and one past the last entry.
    pub starts: Vec<u32>,
    /// Triangle numbers, ascending within a tile.
    pub entries: Vec<u32>,
}

impl Tiles {
    /// Sorts triangles into tiles by their regions (first and last column, first and last row, as
    /// [`crate::influence_region`] writes them).
    pub fn new(size: [u32; 2], receivers: &Receivers, regions: &[[i32; 4]]) -> Self {
        let count = [receivers.columns.div_ceil(size[0]), receivers.rows.div_ceil(size[1])];
        let tiles = |[x0, x1, y0, y1]: [i32; 4]| {
            let empty = x0 > x1 || y0 > y1;
            let range = |first: i32, last: i32, size: u32| {
                if empty { 0..0 } else { first as u32 / size..last as u32 / size + 1 }
            };
            let columns = range(x0, x1, size[0]);
            range(y0, y1, size[1]).flat_map(move |y| columns.clone().map(move |x| (y * count[0] + x) as usize))
        };
        let mut starts = vec![0u32; (count[0] * count[1]) as usize + 1];
        regions.iter().flat_map(|region| tiles(*region)).for_each(|tile| starts[tile + 1] += 1);
        (1..starts.len()).for_each(|tile| starts[tile] += starts[tile - 1]);
        let mut next = starts.clone();
        let mut entries = vec![0; starts[starts.len() - 1] as usize];
        for (triangle, region) in regions.iter().enumerate() {
            for tile in tiles(*region) {
                entries[next[tile] as usize] = triangle as u32;
                next[tile] += 1;
            }
        }
        Tiles { size, count, starts, entries }
    }

    /// Tiles that have one triangle each, in order: what each of them hides shows by itself.
    pub fn solo(size: [u32; 2], receivers: &Receivers) -> Self {
        let count = [receivers.columns.div_ceil(size[0]), receivers.rows.div_ceil(size[1])];
        let tiles = count[0] * count[1];
        Tiles { size, count, starts: (0..=tiles).collect(), entries: (0..tiles).collect() }
    }

    /// The triangles of the tile that holds receiver (x, y).
    pub fn list(&self, x: u32, y: u32) -> &[u32] {
        let tile = (y / self.size[1] * self.count[0] + x / self.size[0]) as usize;
        &self.entries[self.starts[tile] as usize..self.starts[tile + 1] as usize]
    }

    /// Receiver rows from `row` on that one recording takes, up to `rows` and in steps of `step`: the first that brings the
    /// workgroups' list entries to `pairs` ends it.
    pub fn rows_within(&self, rows: u32, row: u32, step: u32, pairs: u64) -> u32 {
        let mut cost = 0;
        let mut end = row;
        while end < rows && cost < pairs {
            cost += self.row_entries(end / self.size[1]) + u64::from(self.count[0]);
            end += step;
        }
        end.min(rows)
    }

    /// Entries of the tiles in a row of tiles.
    fn row_entries(&self, row: u32) -> u64 {
        let first = (row * self.count[0]) as usize;
        u64::from(self.starts[first + self.count[0] as usize] - self.starts[first])
    }
}

/// Receivers of one workgroup, and so the width of a tile.
pub fn tile_width(samples: &Samples) -> u32 {
    256 / samples.rows
}

/// Whether a triangle is one that this kernel takes: strictly between source and receivers.
pub fn is_between(triangle: &Triangle, height: i32) -> bool {
    triangle.iter().all(|v| (1..height).contains(&v[2]))
}

fn program(columns: u32, rows: u32) -> Result<Arc<Program>> {
    let defines = [Define::new("COLUMNS", format!("{columns}u")), Define::new("ROWS", format!("{rows}u"))];
    let program = crate::program("row_span", &format!("{columns}x{rows}"), &defines)?;
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
    /// Compiles it for as many columns and rows as `samples` has.
    pub fn new(samples: &Samples) -> Result<Self> {
        samples.check()?;
        Ok(RowSpan { program: program(samples.columns, samples.rows)?, samples: *samples })
    }

    /// Adds the samples that the tiles' triangles hide to `hidden`, in recordings of bounded cost.
    pub fn record(&self, job: &mut Job, receivers: &Receivers, tiles: &Tiles, scene: Scene) -> Result<()> {
        receivers.check()?;
        let words = u64::from(receivers.count()) * u64::from(self.samples.words());
        if tiles.size[0] != tile_width(&self.samples) || scene.hidden.len() < words {
            let what = format!("tiles of {:?} receivers and {} words of masks", tiles.size, scene.hidden.len());
            let remedy = format!("use tiles {} receivers wide, and {words} words", tile_width(&self.samples));
            return Err(Error::refused(what, remedy));
        }
        let program = job.program(&self.program);
        let mut row = 0;
        while row < receivers.rows {
            let end = tiles.rows_within(receivers.rows, row, 1, PAIRS);
            pieces::cut(job);
            let params = job.value("row span params", &self.params(receivers, tiles, row));
            let Scene { vertices, starts, entries, hidden } = scene;
            let bound = Spans { params, vertices, starts, entries, hidden };
            job.launch(program, "row_span", &bound, [tiles.count[0], end - row, 1]);
            row = end;
        }
        Ok(())
    }

    fn params(&self, receivers: &Receivers, tiles: &Tiles, first_row: u32) -> Params {
        let view = View::new(&self.samples, receivers);
        Params { first_row, tile_rows: tiles.size[1], tiles: tiles.count[0], _pad: 0, view }
    }
}

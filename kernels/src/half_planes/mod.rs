//! Half-planes: the exact masks of a regular light for any triangle, those that cross either plane included.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 4, 5 and 10. `kernel.wgsl` states the
//! output and the rule of ties. Invariant: the masks are those of [`crate::grid::hidden`], bit for bit, on every
//! machine.

use std::ops::Range;
use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::grid::{Faces, Receivers, Samples, View};
use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "half_planes",
    summary: "samples of a regular light that triangles hide, also where they cross the source or the receivers' plane",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, sections 4, 5 and 10",
    programs: || {
        let lights = [(32, 32), (16, 16), (8, 8), (8, 4)];
        let both = [Faces::Both, Faces::Front].into_iter();
        both.flat_map(|faces| lights.map(|(columns, rows)| program(columns, rows, faces))).collect()
    },
    cases: cases::all,
};

/// Workgroups times triangles of one recording.
const PAIRS: u32 = 1 << 14;

/// Triangles of one launch: each takes at most 29 turns of an invocation's loops, of which some devices end all at
/// 65,535 (docs/adding-a-kernel.md).
const LIST: u32 = 1 << 11;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Receiver row of the first workgroup row.
        pub first_row: u32,
        /// First triangle.
        pub first: u32,
        /// One past the last triangle.
        pub end: u32,
        /// WGSL places structs of a uniform at multiples of 16 bytes.
        pub _pad: u32,
        /// Light and receivers.
        pub view: View,
    }
}

bindings! {
    /// What the entry point is given.
    pub struct Cuts {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        write hidden @ 2: [u32],
    }
}

fn program(columns: u32, rows: u32, faces: Faces) -> Result<Arc<Program>> {
    let mut defines = vec![Define::new("COLUMNS", format!("{columns}u")), Define::new("ROWS", format!("{rows}u"))];
    let mut variant = format!("{columns}x{rows}");
    if faces == Faces::Front {
        defines.push(Define::new("ONE_SIDED", true));
        variant += "-front";
    }
    let program = crate::program("half_planes", &variant, &defines)?;
    Cuts::check(&program, "half_planes")?;
    Ok(program)
}

/// The compiled kernel, for one shape of light.
pub struct HalfPlanes {
    program: Arc<Program>,
    samples: Samples,
}

impl HalfPlanes {
    /// Compiles it for as many columns and rows as `samples` has, and triangles that hide by either face.
    pub fn new(samples: &Samples) -> Result<Self> {
        Self::with_faces(samples, Faces::Both)
    }

    /// Compiles it for triangles that hide by some faces.
    pub fn with_faces(samples: &Samples, faces: Faces) -> Result<Self> {
        samples.check()?;
        Ok(HalfPlanes { program: program(samples.columns, samples.rows, faces)?, samples: *samples })
    }

    /// Adds the samples that `triangles` of `vertices` (nine coordinates each) hide to `hidden`, whose word
    /// `(s / 32) * receivers + r` holds sample s of receiver r, in recordings of bounded cost.
    pub fn record(
        &self,
        job: &mut Job,
        receivers: &Receivers,
        vertices: Buffer<[i32]>,
        triangles: Range<u32>,
        hidden: Buffer<[u32]>,
    ) -> Result<()> {
        receivers.check()?;
        let words = u64::from(receivers.count()) * u64::from(self.samples.words());
        if hidden.len() < words || vertices.len() < 9 * u64::from(triangles.end) {
            let what = format!("{} words of masks and {} coordinates", hidden.len(), vertices.len());
            return Err(Error::refused(what, format!("give {words} words, and nine coordinates a triangle")));
        }
        let program = job.program(&self.program);
        let tiles = receivers.columns.div_ceil(256 / self.samples.rows);
        let rows = (PAIRS / tiles).clamp(1, receivers.rows);
        let batch = (PAIRS / (tiles * rows)).clamp(1, LIST);
        let mut first = triangles.start;
        loop {
            let end = triangles.end.min(first.saturating_add(batch));
            for first_row in (0..receivers.rows).step_by(rows as usize) {
                pieces::cut(job);
                let params = job.value("half-plane params", &self.params(receivers, first_row, first..end));
                let height = rows.min(receivers.rows - first_row);
                job.launch(program, "half_planes", &Cuts { params, vertices, hidden }, [tiles, height, 1]);
            }
            // No triangles are launched too, and shown to write nothing.
            first = end;
            if first >= triangles.end {
                break;
            }
        }
        Ok(())
    }

    fn params(&self, receivers: &Receivers, first_row: u32, triangles: Range<u32>) -> Params {
        let view = View::new(&self.samples, receivers);
        Params { first_row, first: triangles.start, end: triangles.end, _pad: 0, view }
    }
}

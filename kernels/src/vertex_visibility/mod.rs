//! Vertex visibility: every vertex of a mesh against directional lights, all bits kept.
//!
//! Sattler et al. 2004, sections 3.1 to 3.3, with an irregular z-buffer instead of a depth map:
//! the result is exact, and `oracle.rs` defines it. `kernel.wgsl` states the output exactly. A batch of up to 16 pairs
//! of directions makes one word of every vertex: count vertices a bin, scan, place them, and let each triangle test
//! those under it: f32 leaves out what is beside the triangle, integers decide the rest. Invariant: bits are set by OR,
//! so neither the order of vertices in their bins nor that of triangles can show.

use std::ops::Range;
use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Command, Error, Groups, Job, Kernel, Program, ProgramId, Result, bindings, host};

use crate::light_sphere::oracle::Direction;
use crate::pieces;
use crate::scan::{Kind, Scan};

mod cases;
mod frame;
mod mesh;
pub mod oracle;
mod resident;
mod shapes;

pub use frame::{Frame, MAX_LENGTH};
pub use mesh::{MAX_TRIANGLES, MAX_VERTICES, Mesh};
pub use resident::Resident;
pub use shapes::{bumpy, octasphere};

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "vertex_visibility",
    summary: "which vertices of a mesh are occluded towards which directions",
    citation: "Sattler et al., Hardware-Accelerated Ambient Occlusion Computation, 2004, sections 3.1 to 3.3; \
        Johnson et al., The Irregular Z-Buffer, 2005",
    programs: || Ok(vec![VertexVisibility::new()?.program]),
    cases: cases::all,
};

/// Vertices of a workgroup of `count` and `place`.
const VERTICES: u32 = 256;

/// Parts of triangles of a workgroup of `occlude`.
const PARTS: u32 = 256;

/// Most vertices that one launch tests with a part.
const MOST: u32 = 8192;

/// Most pairs of directions at a time: they fill a word.
const BATCH: u32 = 16;

/// Columns for each row of bins, as a logarithm: more rows cost time for each triangle, more columns only memory.
const COLUMNS_PER_ROW: u32 = 1;

/// Farthest bias: the size of the grid.
pub const MAX_BIAS: u32 = 1 << 15;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of vertices.
        pub vertices: u32,
        /// Number of parts of triangles.
        pub parts: u32,
        /// Logarithm of the number of bins along X.
        pub column_bits: u32,
        /// Logarithm of the number of bins.
        pub bin_bits: u32,
        /// Frame of the first pair.
        pub pair: u32,
        /// Workgroups of a pair.
        pub groups: u32,
        /// Number of the first workgroup.
        pub first: u32,
        /// Cells that an occluder must be farther away than.
        pub bias: u32,
        /// Word of the first vertex.
        pub row: u32,
        /// Rows of bins of a part.
        pub rows: u32,
        /// Words of a plane of `placed`.
        pub plane: u32,
    }
}

bindings! {
    /// What `count` is given.
    pub struct Count {
        uniform params @ 0: Params,
        read frames @ 1: [Frame],
        read vertices @ 2: [i32],
        write counts @ 3: [u32],
    }

    /// What `place` is given.
    pub struct Place {
        uniform params @ 0: Params,
        read frames @ 1: [Frame],
        read vertices @ 2: [i32],
        write cursors @ 4: [u32],
        write placed @ 5: [u32],
    }

    /// What `occlude` is given.
    pub struct Occlude {
        uniform params @ 0: Params,
        read frames @ 1: [Frame],
        read vertices @ 2: [i32],
        read corners @ 6: [i32],
        read starts @ 7: [u32],
        read points @ 8: [u32],
        write occluded @ 9: [u32],
        read numbers @ 10: [u32],
        write more @ 11: [u32],
    }

    /// What `occlude_rest` is given.
    pub struct OccludeRest {
        uniform params @ 0: Params,
        read frames @ 1: [Frame],
        read vertices @ 2: [i32],
        read corners @ 6: [i32],
        read starts @ 7: [u32],
        read points @ 8: [u32],
        write occluded @ 9: [u32],
        read numbers @ 10: [u32],
    }
}

/// Words of the bit matrix of so many directions: 32 directions a word, a row of all vertices for each word.
pub fn words(vertices: u32, directions: u32) -> u64 {
    u64::from(vertices) * u64::from(directions.div_ceil(32))
}

/// Bins and batches of one recording.
#[derive(Clone, Copy, Debug)]
struct Plan {
    vertices: u32,
    parts: u32,
    rows: u32,
    column_bits: u32,
    bin_bits: u32,
    /// Pairs at a time: a power of two up to [`BATCH`].
    batch: u32,
    bias: u32,
    /// Words of memory that a workgroup of `occlude` may touch.
    work: u64,
}

impl Plan {
    fn new(mesh: &Resident, bias: u32) -> Self {
        let Resident { positions: vertices, parts, rows, row_bits, .. } = *mesh;
        let bin_bits = 2 * row_bits + COLUMNS_PER_ROW;
        let most = (MAX_VERTICES / vertices.max(1)).min((1 << 24) >> bin_bits).clamp(1, BATCH);
        // Boxes are larger where the view is oblique: twice the average over the axes.
        let under = 2.0 * mesh.coverage * f64::from(vertices);
        let work = u64::from(PARTS) * (32 + 8 * under as u64);
        let column_bits = row_bits + COLUMNS_PER_ROW;
        Plan { vertices, parts, rows, column_bits, bin_bits, batch: 1 << most.ilog2(), bias, work }
    }

    /// Words of a plane of placed vertices.
    fn plane(&self) -> u32 {
        self.batch * self.vertices.max(1)
    }

    /// Parameters of a batch that begins with frame `pair` and sets words from `row` on.
    fn params(&self, (pair, row): (u32, u32), groups: u32, piece: &Range<u32>) -> Params {
        let Plan { vertices, parts, rows, column_bits, bin_bits, bias, .. } = *self;
        let (first, plane) = (piece.start, self.plane());
        Params { vertices, parts, column_bits, bin_bits, pair, groups, first, bias, row, rows, plane }
    }
}

/// The compiled kernel.
pub struct VertexVisibility {
    program: Arc<Program>,
    scan: Scan,
}

impl VertexVisibility {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("vertex_visibility", "", &[])?;
        Count::check(&program, "count")?;
        Place::check(&program, "place")?;
        Occlude::check(&program, "occlude")?;
        OccludeRest::check(&program, "occlude_rest")?;
        Ok(VertexVisibility { program, scan: Scan::new()? })
    }

    /// Sets the bits of a block of directions, which are opposite in pairs and numbered from `first` on: bit i % 32 of
    /// word i / 32 * vertices + v if vertex v is occluded towards direction i, beyond `bias` cells. Other bits of
    /// `occluded` stay; it holds the [`words`] of all directions up to the block's last.
    pub fn record(
        &self,
        job: &mut Job,
        mesh: &Resident,
        (first, directions): (u32, &[Direction]),
        bias: u32,
        occluded: Buffer<[u32]>,
    ) -> Result<()> {
        frame::check(first, directions)?;
        let wanted = words(mesh.vertices(), first + directions.len() as u32);
        if bias > MAX_BIAS || occluded.len() < wanted || occluded.len() > 1 << 25 {
            let what = format!("bias {bias} and {} words of bits, of which {wanted} are set", occluded.len());
            let remedy = "keep the bias within 2^15 cells and the bits within 2^25 words; take directions in blocks";
            return Err(Error::refused(what, remedy));
        }
        if directions.is_empty() {
            return Ok(());
        }
        let plan = Plan::new(mesh, bias);
        let row_bits = mesh.row_bits;
        let frame = |(pair, d): (u32, &[Direction])| Frame::new(pair, d[0], mesh.bounds, plan.column_bits, row_bits);
        let first_pair = first / 2;
        let frames: Vec<Frame> = (first_pair..).zip(directions.chunks(2)).map(frame).collect();
        let work = Work {
            frames: job.slice("frames", &frames),
            // The scan takes multiples of four words.
            bins: [(); 2].map(|()| job.zeroed("bins", (u64::from(plan.batch) << plan.bin_bits) + 4)),
            points: job.zeroed("binned vertices", 4 * u64::from(plan.plane())),
            occluded,
        };
        let (mut pair, end) = (first_pair, first_pair + frames.len() as u32);
        while pair < end {
            // A batch stays within a word.
            let next = end.min((pair / plan.batch + 1) * plan.batch);
            self.record_batch(job, mesh, plan, (first_pair, pair..next), &work)?;
            pair = next;
        }
        Ok(())
    }

    /// Records the pairs of a word, or a part of it; the first frame is that of pair `first`.
    fn record_batch(
        &self,
        job: &mut Job,
        mesh: &Resident,
        plan: Plan,
        (first, pairs): (u32, Range<u32>),
        work: &Work,
    ) -> Result<()> {
        let Work { frames, bins: [counts, starts], points, .. } = *work;
        let Resident { vertices, .. } = *mesh;
        let program = job.program(&self.program);
        let (batch, row) = (pairs.len() as u32, pairs.start / BATCH * plan.vertices);
        let place = (pairs.start - first, row);
        job.record(Command::Clear { buffer: counts.id(), offset: 0, size: counts.len() * 4 });
        let groups = plan.vertices.div_ceil(VERTICES).max(1);
        pieces::record(job, batch * groups, u64::from(8 * VERTICES), |job, piece| {
            let params = job.value("count params", &plan.params(place, groups, &piece));
            job.launch(program, "count", &Count { params, frames, vertices, counts }, [piece.len() as u32, 1, 1]);
        });
        self.scan.record(job, Kind::Exclusive, (batch << plan.bin_bits) + 1, counts, starts)?;
        pieces::record(job, batch * groups, u64::from(16 * VERTICES), |job, piece| {
            let params = job.value("place params", &plan.params(place, groups, &piece));
            let bound = Place { params, frames, vertices, cursors: starts, placed: points };
            job.launch(program, "place", &bound, [piece.len() as u32, 1, 1]);
        });
        let groups = plan.parts.div_ceil(PARTS).max(1);
        pieces::record(job, batch * groups, plan.work, |job, piece| {
            record_occlude(job, program, mesh, plan, work, (place, groups, piece));
        });
        Ok(())
    }
}

/// Buffers of one recording.
struct Work {
    frames: Buffer<[Frame]>,
    /// Counts of vertices, and where bins start.
    bins: [Buffer<[u32]>; 2],
    points: Buffer<[u32]>,
    occluded: Buffer<[u32]>,
}

/// A launch of `occlude`, and one that takes what it leaves: without a workgroup where that is nothing.
fn record_occlude(
    job: &mut Job,
    program: ProgramId,
    mesh: &Resident,
    plan: Plan,
    work: &Work,
    (place, groups, piece): ((u32, u32), u32, Range<u32>),
) {
    let Resident { vertices, corners, numbers, .. } = *mesh;
    let Work { frames, bins: [_, starts], points, occluded } = *work;
    let launch = piece.len() as u32;
    let more = job.slice("groups of the rest", &[launch, 0, 1]);
    let params = job.value("occlude params", &plan.params(place, groups, &piece));
    let bound = Occlude { params, frames, vertices, corners, starts, points, occluded, numbers, more };
    job.launch(program, "occlude", &bound, [launch, 1, 1]);
    if plan.vertices <= MOST {
        return;
    }
    let bound = OccludeRest { params, frames, vertices, corners, starts, points, occluded, numbers };
    job.launch_with(program, "occlude_rest", &bound, &[], Groups::Indirect { buffer: more.id(), offset: 0 });
}

//! Vertex visibility: every vertex of a mesh against directional lights, all bits kept.
//!
//! "Ambient occlusion by occlusion queries", sections 3.1 to 3.3, with an irregular z-buffer instead of a depth map: the
//! result is exact, and `oracle.rs` defines it. `kernel.wgsl` states the output exactly. A batch of up to 16 pairs of
//! directions makes one word of every vertex: count vertices a bin, scan, place them, and let each triangle test those
//! under it. Invariant: bits are set by OR, so neither the order of vertices in their bins nor that of triangles can show.

use std::sync::Arc;

use glam::IVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Command, Error, Job, Kernel, Program, Result, bindings, host};

use crate::light_sphere::oracle::Direction;
use crate::pieces;
use crate::scan::{Kind, Scan};

mod cases;
mod frame;
mod mesh;
pub mod oracle;
mod shapes;

pub use frame::{Frame, MAX_LENGTH};
pub use mesh::{MAX_TRIANGLES, MAX_VERTICES, Mesh};
pub use shapes::octasphere;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "vertex_visibility",
    summary: "which vertices of a mesh are occluded towards which directions",
    citation: "Ambient occlusion by occlusion queries, sections 3.1 to 3.3; Johnson et al., The Irregular Z-Buffer, 2005",
    programs: || Ok(vec![VertexVisibility::new()?.program]),
    cases: cases::all,
};

/// Vertices of a workgroup of `count` and `place`.
const VERTICES: u32 = 256;

/// Triangles of a workgroup of `occlude`.
const TRIANGLES: u32 = 64;

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
        /// Number of triangles.
        pub triangles: u32,
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
        write placed @ 5: [IVec4],
    }

    /// What `occlude` is given.
    pub struct Occlude {
        uniform params @ 0: Params,
        read frames @ 1: [Frame],
        read vertices @ 2: [i32],
        read corners @ 6: [i32],
        read ends @ 7: [u32],
        read points @ 8: [IVec4],
        write occluded @ 9: [u32],
        read numbers @ 10: [u32],
    }
}

/// A mesh on the device.
#[derive(Clone, Copy, Debug)]
pub struct Resident {
    vertices: Buffer<[i32]>,
    corners: Buffer<[i32]>,
    numbers: Buffer<[u32]>,
    counts: [u32; 2],
    bounds: [oracle::Point; 2],
    coverage: f64,
}

impl Resident {
    /// Uploads a mesh.
    pub fn upload(job: &mut Job, mesh: &Mesh) -> Result<Self> {
        let all: Vec<u32> = (0..mesh.vertices.len() as u32).collect();
        Self::upload_some(job, mesh, &all)
    }

    /// Uploads a mesh of which only the vertices `chosen`, each at most once, are asked about, in that order: vertex v of
    /// the bits is vertex `chosen[v]` of the mesh. All triangles occlude.
    pub fn upload_some(job: &mut Job, mesh: &Mesh, chosen: &[u32]) -> Result<Self> {
        mesh.check()?;
        // A corner that is not asked about has a number that no vertex has.
        let mut number = vec![u32::MAX; mesh.vertices.len()];
        for (place, &vertex) in (0..).zip(chosen) {
            match number.get_mut(vertex as usize) {
                Some(free) if *free == u32::MAX => *free = place,
                _ => {
                    let what = format!("vertex {vertex} of {} is asked about", mesh.vertices.len());
                    return Err(Error::refused(what, "choose vertices that are there, each at most once"));
                }
            }
        }
        let points: Vec<oracle::Point> = chosen.iter().map(|&vertex| mesh.vertices[vertex as usize]).collect();
        let axes = |points: &[oracle::Point]| -> Vec<i32> {
            (0..3).flat_map(|axis| points.iter().map(move |p| p[axis])).collect()
        };
        let corner =
            |k: usize| -> Vec<oracle::Point> { mesh.triangles.iter().map(|t| mesh.vertices[t[k] as usize]).collect() };
        // A binding holds at least one element.
        let or_zero = |words: Vec<i32>| if words.is_empty() { vec![0] } else { words };
        let vertices = or_zero(axes(&points));
        let corners = or_zero((0..3).flat_map(|k| axes(&corner(k))).collect());
        let number = &number;
        let numbers: Vec<u32> =
            (0..3).flat_map(|k| mesh.triangles.iter().map(move |t| number[t[k] as usize])).collect();
        Ok(Resident {
            vertices: job.slice("vertices", &vertices),
            corners: job.slice("corners", &corners),
            numbers: job.slice("corner numbers", if numbers.is_empty() { &[0] } else { &numbers[..] }),
            counts: [chosen.len() as u32, mesh.triangles.len() as u32],
            bounds: mesh.bounds(),
            coverage: mesh.coverage(),
        })
    }

    /// Number of vertices.
    pub fn vertices(&self) -> u32 {
        self.counts[0]
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
    triangles: u32,
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
        let [vertices, triangles] = mesh.counts;
        let row_bits = vertices.max(4).ilog2() / 2 + 1;
        let bin_bits = 2 * row_bits + COLUMNS_PER_ROW;
        let most = (MAX_VERTICES / vertices.max(1)).min((1 << 25) >> bin_bits).clamp(1, BATCH);
        // Boxes are larger where the view is oblique: twice the average over the axes.
        let under = 2.0 * mesh.coverage * f64::from(vertices);
        let work = u64::from(TRIANGLES) * (24 + 8 * under as u64);
        let batch = 1 << most.ilog2();
        Plan { vertices, triangles, column_bits: row_bits + COLUMNS_PER_ROW, bin_bits, batch, bias, work }
    }

    fn params(&self, pair: u32, groups: u32, first: u32) -> Params {
        let Plan { vertices, triangles, column_bits, bin_bits, bias, .. } = *self;
        Params { vertices, triangles, column_bits, bin_bits, pair, groups, first, bias, row: pair / BATCH * vertices }
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
        Ok(VertexVisibility { program, scan: Scan::new()? })
    }

    /// Sets the bits of a block of directions, which are opposite in pairs: bit i % 32 of word i / 32 * vertices + v if vertex
    /// v is occluded towards direction i, beyond `bias` cells. Other bits of `occluded` stay; it holds [`words`] words.
    pub fn record(
        &self,
        job: &mut Job,
        mesh: &Resident,
        directions: &[Direction],
        bias: u32,
        occluded: Buffer<[u32]>,
    ) -> Result<()> {
        frame::check(directions)?;
        let wanted = words(mesh.vertices(), directions.len() as u32);
        if bias > MAX_BIAS || occluded.len() < wanted || occluded.len() > 1 << 25 {
            let what = format!("bias {bias} and {} words of bits, of which {wanted} are set", occluded.len());
            let remedy = "keep the bias within 2^15 cells and the bits within 2^25 words; take directions in blocks";
            return Err(Error::refused(what, remedy));
        }
        if directions.is_empty() {
            return Ok(());
        }
        let plan = Plan::new(mesh, bias);
        let row_bits = plan.bin_bits - plan.column_bits;
        let frame = |(pair, d): (u32, &[Direction])| Frame::new(pair, d[0], mesh.bounds, plan.column_bits, row_bits);
        let frames: Vec<Frame> = (0..).zip(directions.chunks(2)).map(frame).collect();
        let frames = (frames.len() as u32, job.slice("frames", &frames));
        self.record_batches(job, mesh, plan, frames, occluded)
    }

    fn record_batches(
        &self,
        job: &mut Job,
        mesh: &Resident,
        plan: Plan,
        (pairs, frames): (u32, Buffer<[Frame]>),
        occluded: Buffer<[u32]>,
    ) -> Result<()> {
        let counts = job.zeroed("bin counts", u64::from(plan.batch) << plan.bin_bits);
        let ends = job.zeroed("bin ends", counts.len());
        let points = job.zeroed("binned vertices", u64::from(plan.batch) * u64::from(plan.vertices.max(1)));
        let program = job.program(&self.program);
        let vertices = mesh.vertices;
        for pair in (0..pairs).step_by(plan.batch as usize) {
            let batch = plan.batch.min(pairs - pair);
            let bins = batch << plan.bin_bits;
            if pair > 0 {
                job.record(Command::Clear { buffer: counts.id(), offset: 0, size: counts.len() * 4 });
            }
            let groups = plan.vertices.div_ceil(VERTICES).max(1);
            pieces::record(job, batch * groups, u64::from(8 * VERTICES), |job, piece| {
                let params = job.value("count params", &plan.params(pair, groups, piece.start));
                job.launch(program, "count", &Count { params, frames, vertices, counts }, [piece.len() as u32, 1, 1]);
            });
            self.scan.record(job, Kind::Exclusive, bins, counts, ends)?;
            pieces::record(job, batch * groups, u64::from(16 * VERTICES), |job, piece| {
                let params = job.value("place params", &plan.params(pair, groups, piece.start));
                let bound = Place { params, frames, vertices, cursors: ends, placed: points };
                job.launch(program, "place", &bound, [piece.len() as u32, 1, 1]);
            });
            let groups = plan.triangles.div_ceil(TRIANGLES).max(1);
            pieces::record(job, batch * groups, plan.work, |job, piece| {
                let params = job.value("occlude params", &plan.params(pair, groups, piece.start));
                let Resident { corners, numbers, .. } = *mesh;
                let bound = Occlude { params, frames, vertices, corners, ends, points, occluded, numbers };
                job.launch(program, "occlude", &bound, [piece.len() as u32, 1, 1]);
            });
        }
        Ok(())
    }
}

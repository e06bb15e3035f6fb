//! Vertex visibility by depth maps: the approximate way of the paper, beside the exact one of
//! [`crate::vertex_visibility`].
//!
//! Sattler et al. 2004, sections 3.1 and 3.2: an orthographic depth map for each light, then every
//! vertex as a point against it, with an offset in integers. Maps and points are [`crate::raster`]'s, so the result is
//! equal on every machine; it depends on the resolution, and [`DepthMap::record_differ`] counts by how much.
//! `kernel.wgsl` states the outputs exactly. Invariant: a result is a matrix of the same layout as the exact one.

use std::sync::Arc;

use glam::IVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Command, Error, Job, Kernel, Program, Result, bindings, host};

use crate::light_sphere::oracle::Direction;
use crate::pieces;
use crate::raster::{self, Faces, Projected, Raster};
use crate::vertex_visibility::{Mesh, words};

mod cases;
pub mod oracle;
mod view;

pub use view::{MAX_BIAS, MapView};

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "depth_map",
    summary: "which vertices of a mesh are occluded, by depth maps, and how many bits that gets wrong",
    citation: "Sattler et al., Hardware-Accelerated Ambient Occlusion Computation, 2004, sections 3.1 and 3.2",
    programs: || Ok(vec![DepthMap::new()?.program]),
    cases: cases::all,
};

const GROUP: u32 = 256;

/// Directions of a word of the matrix.
const BATCH: usize = 32;

/// Words that rows of bits are padded to: bindings start at multiples of 256 bytes.
const ROW: u32 = 64;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Vertices, or words.
        pub count: u32,
        /// Directions.
        pub rows: u32,
        /// Words from one direction's bits to the next one's.
        pub stride: u32,
        /// Word of the first vertex.
        pub row: u32,
        /// Vertex or word of the first invocation.
        pub first: u32,
    }
}

bindings! {
    /// What `collect` is given.
    pub struct Collect {
        uniform params @ 0: Params,
        read seen @ 1: [u32],
        write occluded @ 2: [u32],
    }

    /// What `differ` is given.
    pub struct Differ {
        uniform params @ 0: Params,
        read one @ 3: [u32],
        read other @ 4: [u32],
        write differing @ 5: [u32],
    }
}

/// How maps are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Maps {
    /// Pixels a side, 1 to 4096.
    pub side: u32,
    /// How far a vertex may be behind its pixel and still be seen, in 1/256 of the width of a pixel: a surface that
    /// rises by as much over a pixel does not shadow itself.
    pub bias: u32,
}

/// The compiled kernel and the raster.
pub struct DepthMap {
    program: Arc<Program>,
    raster: Raster,
}

impl DepthMap {
    /// Compiles both.
    pub fn new() -> Result<Self> {
        let program = crate::program("depth_map", "", &[])?;
        Collect::check(&program, "collect")?;
        Differ::check(&program, "differ")?;
        Ok(DepthMap { program, raster: Raster::new()? })
    }

    /// Sets the bits of a block of directions: bit i % 32 of word i / 32 * vertices + v if vertex v is not seen in the
    /// map of direction i. Other bits of `occluded` stay; it holds [`words`] words.
    pub fn record(
        &self,
        job: &mut Job,
        mesh: &Mesh,
        directions: &[Direction],
        maps: Maps,
        occluded: Buffer<[u32]>,
    ) -> Result<()> {
        mesh.check()?;
        let views = directions.iter().map(|&d| MapView::new(mesh.bounds(), d, maps)).collect::<Result<Vec<_>>>()?;
        let wanted = words(mesh.vertices.len() as u32, directions.len() as u32);
        if occluded.len() < wanted {
            let what = format!("{} words of bits, of which {wanted} are set", occluded.len());
            return Err(Error::refused(what, "give one word for each vertex and 32 directions"));
        }
        let Some(first) = views.first() else { return Ok(()) };
        let picture = first.view.picture;
        let depth = job.zeroed("depth map", u64::from(picture.pixels()));
        let count = mesh.vertices.len() as u32;
        let stride = count.div_ceil(32).max(1).next_multiple_of(ROW);
        let seen = job.zeroed("seen", u64::from(stride) * BATCH as u64);
        let uploaded = upload(job, mesh, first);
        let mut projected = self.raster.project(job, first.view, uploaded)?;
        for (batch, views) in (0..).zip(views.chunks(BATCH)) {
            job.record(Command::Clear { buffer: seen.id(), offset: 0, size: seen.size() });
            for (place, view) in (0..).zip(views) {
                let bits = seen.elements(place * u64::from(stride)..(place + 1) * u64::from(stride));
                self.record_map(job, view, &mut projected, depth, bits)?;
            }
            let row = batch * count;
            let params = Params { count, rows: views.len() as u32, stride, row, first: 0 };
            self.record_collect(job, params, seen, occluded);
        }
        Ok(())
    }

    fn record_map(
        &self,
        job: &mut Job,
        view: &MapView,
        projected: &mut Projected,
        depth: Buffer<[u32]>,
        seen: Buffer<[u32]>,
    ) -> Result<()> {
        self.raster.record_clear(job, view.view.picture, depth)?;
        let rows = job.slice("rows", &view.rows);
        self.raster.project_again(job, projected, view.view.near, rows)?;
        self.raster.record_depth(job, projected, Faces::All, depth)?;
        self.raster.record_points(job, projected, view.bias, depth, seen)
    }

    fn record_collect(&self, job: &mut Job, params: Params, seen: Buffer<[u32]>, occluded: Buffer<[u32]>) {
        let program = job.program(&self.program);
        pieces::record(job, params.count.div_ceil(GROUP), u64::from(34 * GROUP), |job, piece| {
            let params = job.value("collect params", &Params { first: piece.start * GROUP, ..params });
            job.launch(program, "collect", &Collect { params, seen, occluded }, [piece.len() as u32, 1, 1]);
        });
    }

    /// Adds to the first word of `differing` how many bits of the first `count` words of two matrices differ.
    pub fn record_differ(
        &self,
        job: &mut Job,
        count: u32,
        [one, other]: [Buffer<[u32]>; 2],
        differing: Buffer<[u32]>,
    ) -> Result<()> {
        let least = one.len().min(other.len());
        if least < u64::from(count) || count > 1 << 25 || differing.is_empty() {
            let what = format!("a comparison of {count} words of {least}");
            return Err(Error::refused(what, "give both matrices whole, at most 2^25 words, and a word for the count"));
        }
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(3 * GROUP), |job, piece| {
            let params = Params { count, rows: 0, stride: 0, row: 0, first: piece.start * GROUP };
            let params = job.value("differ params", &params);
            job.launch(program, "differ", &Differ { params, one, other, differing }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

/// The mesh as the raster takes it, placed for the first view.
fn upload(job: &mut Job, mesh: &Mesh, first: &MapView) -> raster::Mesh {
    // A binding holds at least one element.
    let indices = if mesh.triangles.is_empty() { &[0; 3] } else { mesh.triangles.as_flattened() };
    let vertices = if mesh.vertices.is_empty() { &[0; 3] } else { mesh.vertices.as_flattened() };
    raster::Mesh {
        vertices: job.slice("map vertices", vertices),
        vertex_count: mesh.vertices.len() as u32,
        indices: job.slice("map indices", indices),
        triangle_count: mesh.triangles.len() as u32,
        rows: job.slice::<IVec4>("rows", &first.rows),
        instance_count: 1,
    }
}

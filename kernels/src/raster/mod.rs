//! Depth and item buffers of indexed triangles, instance by instance: an exact integer raster.
//!
//! Laine and Karras, "High-Performance Software Rasterization on GPUs", section 3, for the pipeline; Engelhardt and
//! Dachsbacher, "Granular Visibility Queries on the GPU", section 3, for what it is drawn for. `docs/numerics.md`, "The
//! raster", states the outputs exactly. A picture is made in steps: [`Raster::record_clear`], then for every mesh
//! [`Raster::project`] and [`Raster::record_depth`], then, where items are wanted, [`Raster::record_items`] for every
//! mesh. Invariant: both buffers hold minima, so neither the order of meshes and triangles nor that of lanes can show.

use std::sync::Arc;

use bytemuck::Zeroable;
use glam::IVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod meshes;
pub mod oracle;
mod view;

pub use view::{CLIP, Picture, Placement, View};

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "raster",
    summary: "depth and item buffers of instances of triangle meshes, orthographic or in perspective; points against them",
    citation: "Laine and Karras, High-Performance Software Rasterization on GPUs, 2011, section 3; Engelhardt and \
               Dachsbacher, Granular Visibility Queries on the GPU, 2009, section 3",
    programs: || {
        let Raster { depth, items } = Raster::new()?;
        Ok(vec![depth, items])
    },
    cases: cases::all,
};

/// Depth of a pixel that nothing covers; every drawn depth is below 2^24.
pub const FAR: u32 = u32::MAX;

/// Item of a pixel that nothing covers.
pub const NOTHING: u32 = u32::MAX;

/// Most vertices of all instances of a mesh: they fill a binding of 128 MiB.
pub const MAX_POINTS: u32 = 1 << 23;

/// Most triangles of all instances of a mesh.
pub const MAX_TRIANGLES: u32 = 1 << 30;

/// Items a workgroup.
const GROUP: u32 = 256;

/// Triangles of one workgroup of `large`.
const LARGE: u32 = 32;

/// Most turns of the loops over tiles that a triangle takes in a band of rows. Each of `LARGE` triangles, or of twice
/// as many where the near plane cuts them in two, takes these and 181 for its slopes: 49,473 turns at most with what
/// is around them (docs/numerics.md, Turns of loops).
const TILE_TURNS: u32 = 590;

/// Words that a triangle drawn by one lane may touch: its vertices, and a depth and an item for each of its pixels.
const SMALL_WORDS: u32 = 15 + 2 * 256;

/// Which sides of triangles are drawn. Clockwise is as the viewer sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Faces {
    /// Both.
    All = 3,
    /// Triangles that turn clockwise.
    Clockwise = 1,
    /// Triangles that turn counter-clockwise.
    CounterClockwise = 2,
}

/// Item ids of a mesh: `base + instance * step + (triangle >> shift)`, modulo 2^32. `shift` is at most 31.
///
/// With `step` 1 and `shift` 31 an item is an instance; with a smaller `shift`, a cluster of 2^shift triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ids {
    /// Id of the first instance.
    pub base: u32,
    /// Ids from one instance to the next.
    pub step: u32,
    /// Logarithm of the triangles of a cluster.
    pub shift: u32,
}

/// A mesh and its instances, on the device.
#[derive(Clone, Copy, Debug)]
pub struct Mesh {
    /// Three coordinates a vertex, each in [-2^15, 2^15).
    pub vertices: Buffer<[i32]>,
    /// Number of vertices.
    pub vertex_count: u32,
    /// Three vertices a triangle; a triangle with a vertex that does not exist is not drawn.
    pub indices: Buffer<[u32]>,
    /// Number of triangles.
    pub triangle_count: u32,
    /// Four rows an instance, as [`Placement::rows`] has them.
    pub rows: Buffer<[IVec4]>,
    /// Number of instances.
    pub instance_count: u32,
}

/// A mesh whose vertices are on the screen.
#[derive(Clone, Copy, Debug)]
pub struct Projected {
    mesh: Mesh,
    view: View,
    screen: Buffer<[IVec4]>,
    marks: Buffer<[u32]>,
    /// Bound in place of an item buffer where depths alone are drawn.
    no_items: Buffer<[u32]>,
}

impl Projected {
    /// x and y in 1/16 pixel, depth, and 1 in front of the near plane or 0 behind it: vertex v of instance n stands at
    /// `n * vertex_count + v`.
    pub fn screen(&self) -> Buffer<[IVec4]> {
        self.screen
    }

    fn params(&self) -> Params {
        let View { picture: Picture { width, height }, near } = self.view;
        let Mesh { vertex_count, triangle_count, instance_count, .. } = self.mesh;
        Params {
            width,
            height,
            near,
            vertices: vertex_count,
            triangles: triangle_count,
            instances: instance_count,
            band: self.view.picture.band(),
            ..Params::zeroed()
        }
    }
}

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Columns of the picture.
        pub width: u32,
        /// Rows of the picture.
        pub height: u32,
        /// Least divisor of the perspective division.
        pub near: i32,
        /// Vertices of the mesh.
        pub vertices: u32,
        /// Triangles of the mesh.
        pub triangles: u32,
        /// Instances of the mesh.
        pub instances: u32,
        /// Bits of [`Faces`].
        pub faces: u32,
        /// Id of the first instance.
        pub id_base: u32,
        /// Ids from one instance to the next.
        pub id_step: u32,
        /// Logarithm of the triangles of a cluster.
        pub id_shift: u32,
        /// Rows of a band.
        pub band: u32,
        /// Added to the depth that a point is compared with.
        pub bias: u32,
        /// Number of the first workgroup.
        pub first: u32,
    }
}

bindings! {
    /// What `clear` is given.
    pub struct Clear {
        uniform params @ 0: Params,
        write depth @ 8: [u32],
    }

    /// What `project` is given.
    pub struct Project {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        read rows @ 3: [IVec4],
        write projected @ 4: [IVec4],
    }

    /// What `small` is given.
    pub struct Small {
        uniform params @ 0: Params,
        read indices @ 2: [u32],
        read screen @ 5: [IVec4],
        write marks @ 6: [u32],
        write depth @ 8: [u32],
        write items @ 9: [u32],
    }

    /// What `large` is given.
    pub struct Large {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        read indices @ 2: [u32],
        read rows @ 3: [IVec4],
        read screen @ 5: [IVec4],
        read marked @ 7: [u32],
        write depth @ 8: [u32],
        write items @ 9: [u32],
    }

    /// What `points` is given.
    pub struct Points {
        uniform params @ 0: Params,
        read screen @ 5: [IVec4],
        write depth @ 8: [u32],
        write seen @ 10: [u32],
    }
}

/// The compiled kernel: one program for each pass.
pub struct Raster {
    depth: Arc<Program>,
    items: Arc<Program>,
}

impl Raster {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let variant = |name: &str, items: bool| {
            let program = crate::program("raster", name, &[Define::new("ITEMS", items)])?;
            Clear::check(&program, "clear")?;
            Project::check(&program, "project")?;
            Small::check(&program, "small")?;
            Large::check(&program, "large")?;
            Points::check(&program, "points")?;
            Ok::<_, Error>(program)
        };
        Ok(Raster { depth: variant("depth", false)?, items: variant("items", true)? })
    }

    /// Sets the words of a depth buffer to [`FAR`], or those of an item buffer to [`NOTHING`], which are the same.
    pub fn record_clear(&self, job: &mut Job, picture: Picture, buffer: Buffer<[u32]>) -> Result<()> {
        picture.check(buffer.len())?;
        let program = job.program(&self.depth);
        let params = Params { width: picture.width, height: picture.height, ..Params::zeroed() };
        pieces::record(job, picture.pixels().div_ceil(GROUP), u64::from(GROUP), |job, piece| {
            let params = job.value("raster params", &Params { first: piece.start, ..params });
            job.launch(program, "clear", &Clear { params, depth: buffer }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }

    /// Puts the vertices of all instances on the screen.
    pub fn project(&self, job: &mut Job, view: View, mesh: Mesh) -> Result<Projected> {
        view.check()?;
        mesh.check()?;
        let screen = job.zeroed("raster screen", u64::from(mesh.points()).max(1));
        let marks = job.zeroed("raster marks", u64::from(mesh.triangles().div_ceil(32)).max(1));
        let projected = Projected { mesh, view, screen, marks, no_items: job.zeroed("no items", 1) };
        let program = job.program(&self.depth);
        // Three coordinates, four rows and four words written, at most.
        pieces::record(job, mesh.points().div_ceil(GROUP), u64::from(23 * GROUP), |job, piece| {
            let params = job.value("raster params", &Params { first: piece.start, ..projected.params() });
            let bound = Project { params, vertices: mesh.vertices, rows: mesh.rows, projected: screen };
            job.launch(program, "project", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(projected)
    }

    /// Takes the depths of a mesh into the minimum: `depth` has a word a pixel.
    pub fn record_depth(&self, job: &mut Job, projected: &Projected, faces: Faces, depth: Buffer<[u32]>) -> Result<()> {
        projected.view.picture.check(depth.len())?;
        let params = Params { faces: faces as u32, ..projected.params() };
        self.draw(job, &self.depth, projected, params, [depth, projected.no_items]);
        Ok(())
    }

    /// Takes the ids of a mesh into the minimum, wherever it has the depth that `depth` holds. The depths of all meshes
    /// must be there before; `faces` is what they were drawn with.
    pub fn record_items(
        &self,
        job: &mut Job,
        projected: &Projected,
        faces: Faces,
        ids: Ids,
        [depth, items]: [Buffer<[u32]>; 2],
    ) -> Result<()> {
        projected.view.picture.check(depth.len().min(items.len()))?;
        if ids.shift > 31 {
            return Err(Error::refused(format!("clusters of 2^{} triangles", ids.shift), "use a shift of at most 31"));
        }
        let params = Params {
            faces: faces as u32,
            id_base: ids.base,
            id_step: ids.step,
            id_shift: ids.shift,
            ..projected.params()
        };
        self.draw(job, &self.items, projected, params, [depth, items]);
        Ok(())
    }

    fn draw(
        &self,
        job: &mut Job,
        program: &Arc<Program>,
        projected: &Projected,
        params: Params,
        [depth, items]: [Buffer<[u32]>; 2],
    ) {
        let Projected { mesh, screen, marks, .. } = *projected;
        let Mesh { vertices, indices, rows, .. } = mesh;
        let program = job.program(program);
        let groups = mesh.triangles().div_ceil(GROUP);
        pieces::record(job, groups, u64::from(SMALL_WORDS * GROUP), |job, piece| {
            let params = job.value("raster params", &Params { first: piece.start, ..params });
            let bound = Small { params, indices, screen, marks, depth, items };
            job.launch(program, "small", &bound, [piece.len() as u32, 1, 1]);
        });
        let bands = params.height.div_ceil(params.band);
        let words = (projected.view.picture.pixels() / 32).max(GROUP);
        pieces::record(job, mesh.triangles().div_ceil(LARGE), u64::from(words), |job, piece| {
            let params = job.value("raster params", &Params { first: piece.start, ..params });
            let bound = Large { params, vertices, indices, rows, screen, marked: marks, depth, items };
            job.launch(program, "large", &bound, [piece.len() as u32, bands, 1]);
        });
    }

    /// Sets bit `p % 32` of word `p / 32` of `seen` for every projected vertex p that is in front, in the picture and
    /// not behind: its depth is at most that of its pixel and `bias`.
    pub fn record_points(
        &self,
        job: &mut Job,
        projected: &Projected,
        bias: u32,
        depth: Buffer<[u32]>,
        seen: Buffer<[u32]>,
    ) -> Result<()> {
        projected.view.picture.check(depth.len())?;
        let points = projected.mesh.points();
        if seen.len() < u64::from(points.div_ceil(32)) {
            let what = format!("{points} points into {} words", seen.len());
            return Err(Error::refused(what, "give one bit for each vertex of each instance"));
        }
        let program = job.program(&self.depth);
        let screen = projected.screen;
        pieces::record(job, points.div_ceil(GROUP), u64::from(6 * GROUP), |job, piece| {
            let params = job.value("raster params", &Params { first: piece.start, bias, ..projected.params() });
            job.launch(program, "points", &Points { params, screen, depth, seen }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

impl Mesh {
    /// Vertices of all instances.
    pub fn points(&self) -> u32 {
        self.vertex_count.saturating_mul(self.instance_count)
    }

    /// Triangles of all instances.
    pub fn triangles(&self) -> u32 {
        self.triangle_count.saturating_mul(self.instance_count)
    }

    fn check(&self) -> Result<()> {
        let Mesh { vertex_count, triangle_count, instance_count, .. } = *self;
        if self.points() > MAX_POINTS || self.triangles() > MAX_TRIANGLES {
            let what = format!("{instance_count} instances of {vertex_count} vertices and {triangle_count} triangles");
            let remedy = format!(
                "draw them in several meshes, each of at most {MAX_POINTS} vertices and {MAX_TRIANGLES} triangles of all \
                 instances"
            );
            return Err(Error::refused(what, remedy));
        }
        let needs = [
            ("coordinates", self.vertices.len(), 3 * u64::from(vertex_count)),
            ("indices", self.indices.len(), 3 * u64::from(triangle_count)),
            ("rows", self.rows.len(), 4 * u64::from(instance_count)),
        ];
        let short = needs.iter().find(|(_, have, need)| have < need);
        short.map_or(Ok(()), |(name, have, need)| {
            Err(Error::refused(format!("a mesh with {have} {name}"), format!("give {need} {name}")))
        })
    }
}

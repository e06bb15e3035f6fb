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
use sightlines_backend::{Define, Error, Groups, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;
use crate::scan::{Kind, Scan};

mod cases;
mod mesh;
pub mod meshes;
pub mod oracle;
mod view;

pub use mesh::{Faces, Ids, MAX_POINTS, MAX_TRIANGLES, Mesh};
pub use view::{CLIP, Picture, Placement, View};

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "raster",
    summary: "depth and item buffers of instances of triangle meshes, orthographic or in perspective; points against them",
    citation: "Laine and Karras, High-Performance Software Rasterization on GPUs, 2011, section 3; Engelhardt and \
               Dachsbacher, Granular Visibility Queries on the GPU, 2009, section 3",
    programs: || {
        let Raster { depth, items, .. } = Raster::new()?;
        Ok(vec![depth, items])
    },
    cases: cases::all,
};

/// Depth of a pixel that nothing covers; every drawn depth is below 2^24.
pub const FAR: u32 = u32::MAX;

/// Item of a pixel that nothing covers.
pub const NOTHING: u32 = u32::MAX;

/// Items a workgroup.
const GROUP: u32 = 256;

/// Words that a triangle drawn by one lane may touch: its vertices, and a depth and an item for each of its pixels.
const SMALL_WORDS: u32 = 15 + 2 * 256;

/// A mesh whose vertices are on the screen.
#[derive(Clone, Copy, Debug)]
pub struct Projected {
    mesh: Mesh,
    view: View,
    screen: Buffer<[IVec4]>,
    /// The triangles that `large` draws.
    list: Buffer<[u32]>,
    /// How many workgroups take them, piece by piece.
    workgroups: Buffer<[u32]>,
    /// Which triangles those are, and how many of them come before each.
    marks: [Buffer<[u32]>; 2],
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
            piece: self.mesh.large_piece(self.view.picture),
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
        /// Most listed triangles of a launch of `large`.
        pub piece: u32,
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

    /// What `sort` is given.
    pub struct Sort {
        uniform params @ 0: Params,
        read indices @ 2: [u32],
        read screen @ 5: [IVec4],
        write marks @ 6: [u32],
    }

    /// What `list` is given.
    pub struct List {
        uniform params @ 0: Params,
        read known_marks @ 11: [u32],
        read marks_before @ 12: [u32],
        write large_list @ 13: [u32],
    }

    /// What `arguments` is given.
    pub struct Arguments {
        uniform params @ 0: Params,
        read known_marks @ 11: [u32],
        read marks_before @ 12: [u32],
        write workgroups @ 14: [u32],
    }

    /// What `small` is given.
    pub struct Small {
        uniform params @ 0: Params,
        read indices @ 2: [u32],
        read screen @ 5: [IVec4],
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
        read listed @ 7: [u32],
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
    scan: Scan,
}

impl Raster {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let variant = |name: &str, items: bool| {
            let program = crate::program("raster", name, &[Define::new("ITEMS", items)])?;
            Clear::check(&program, "clear")?;
            Project::check(&program, "project")?;
            Sort::check(&program, "sort")?;
            List::check(&program, "list")?;
            Arguments::check(&program, "arguments")?;
            Small::check(&program, "small")?;
            Large::check(&program, "large")?;
            Points::check(&program, "points")?;
            Ok::<_, Error>(program)
        };
        Ok(Raster { depth: variant("depth", false)?, items: variant("items", true)?, scan: Scan::new()? })
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

    /// Puts the vertices of all instances on the screen, and lists the triangles that are more than a few pixels wide.
    pub fn project(&self, job: &mut Job, view: View, mesh: Mesh) -> Result<Projected> {
        view.check()?;
        mesh.check()?;
        let pieces = mesh.triangles().max(1).div_ceil(mesh.large_piece(view.picture));
        let projected = Projected {
            mesh,
            view,
            screen: job.zeroed("raster screen", u64::from(mesh.points()).max(1)),
            list: job.zeroed("raster list", mesh.places()),
            workgroups: job.zeroed("raster workgroups", 3 * u64::from(pieces)),
            marks: ["raster marks", "marks before"].map(|name| job.zeroed(name, mesh.places())),
            no_items: job.zeroed("no items", 1),
        };
        self.record_project(job, &projected)?;
        Ok(projected)
    }

    /// Puts the same vertices on the screen with other rows and another near plane, in the place of what was projected.
    pub fn project_again(
        &self,
        job: &mut Job,
        projected: &mut Projected,
        near: i32,
        rows: Buffer<[IVec4]>,
    ) -> Result<()> {
        let (view, mesh) = (View { near, ..projected.view }, Mesh { rows, ..projected.mesh });
        view.check()?;
        mesh.check()?;
        (projected.view, projected.mesh) = (view, mesh);
        self.record_project(job, projected)
    }

    fn record_project(&self, job: &mut Job, projected: &Projected) -> Result<()> {
        let mesh = projected.mesh;
        let program = job.program(&self.depth);
        // Three coordinates, four rows and four words written, at most.
        pieces::record(job, mesh.points().div_ceil(GROUP), u64::from(23 * GROUP), |job, piece| {
            let params = job.value("raster params", &Params { first: piece.start, ..projected.params() });
            let Projected { mesh: Mesh { vertices, rows, .. }, screen, .. } = *projected;
            let bound = Project { params, vertices, rows, projected: screen };
            job.launch(program, "project", &bound, [piece.len() as u32, 1, 1]);
        });
        self.sort(job, projected)
    }

    fn sort(&self, job: &mut Job, projected: &Projected) -> Result<()> {
        let Projected { mesh, screen, list, workgroups, marks: [marks, before], .. } = *projected;
        let program = job.program(&self.depth);
        let groups = mesh.triangles().div_ceil(GROUP);
        let params = |job: &mut Job, first| job.value("raster params", &Params { first, ..projected.params() });
        pieces::record(job, groups, u64::from(16 * GROUP), |job, piece| {
            let bound = Sort { params: params(job, piece.start), indices: mesh.indices, screen, marks };
            job.launch(program, "sort", &bound, [piece.len() as u32, 1, 1]);
        });
        self.scan.record(job, Kind::Exclusive, mesh.triangles(), marks, before)?;
        pieces::record(job, groups, u64::from(3 * GROUP), |job, piece| {
            let params = params(job, piece.start);
            let bound = List { params, known_marks: marks, marks_before: before, large_list: list };
            job.launch(program, "list", &bound, [piece.len() as u32, 1, 1]);
        });
        let bound = Arguments { params: params(job, 0), known_marks: marks, marks_before: before, workgroups };
        job.launch(program, "arguments", &bound, [(workgroups.len() as u32).div_ceil(3 * 64), 1, 1]);
        Ok(())
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
        let Projected { mesh, screen, list, workgroups, .. } = *projected;
        let Mesh { vertices, indices, rows, .. } = mesh;
        let program = job.program(program);
        let groups = mesh.triangles().div_ceil(GROUP);
        pieces::record(job, groups, u64::from(SMALL_WORDS * GROUP), |job, piece| {
            let params = job.value("raster params", &Params { first: piece.start, ..params });
            let bound = Small { params, indices, screen, depth, items };
            job.launch(program, "small", &bound, [piece.len() as u32, 1, 1]);
        });
        pieces::record(job, mesh.triangles(), Mesh::large_words(projected.view.picture), |job, piece| {
            let offset = 12 * u64::from(piece.start / params.piece);
            let params = job.value("raster params", &Params { first: piece.start, ..params });
            let bound = Large { params, vertices, indices, rows, screen, listed: list, depth, items };
            let groups = Groups::Indirect { buffer: workgroups.id(), offset };
            job.launch_with(program, "large", &bound, &[], groups);
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

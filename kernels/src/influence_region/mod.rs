//! Influence regions: which receivers a triangle can hide any sample from, as an exact rectangle.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 3. `kernel.wgsl` states the output
//! exactly for receivers on a plane parallel to the source, in 32 bits; `tilted.wgsl` for a lattice of receivers on any
//! plane. Invariant: a receiver outside a triangle's region is hidden from no sample by it.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::grid::{Faces, Receivers, Samples};
use crate::pieces;

mod cases;
pub mod oracle;
mod tilted;

pub use tilted::{Corner, TiltedParams, TiltedRegion, TiltedRegions};

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "influence_region",
    summary: "rectangle of receivers that each triangle can hide any light sample from",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, section 3, equation 3",
    programs: || {
        let both = [Faces::Both, Faces::Front].map(|faces| Ok(InfluenceRegion::with_faces(faces)?.program));
        both.into_iter().chain([Ok(TiltedRegion::new()?.program)]).collect()
    },
    cases: cases::all,
};

const GROUP: u32 = 64;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of triangles.
        pub triangles: u32,
        /// z of the receivers.
        pub height: i32,
        /// Receivers along x.
        pub columns: u32,
        /// Receivers along y.
        pub rows: u32,
        /// x of the first receiver.
        pub receiver_x: i32,
        /// y of the first receiver.
        pub receiver_y: i32,
        /// Distance of receivers along x.
        pub receiver_step_x: u32,
        /// Distance of receivers along y.
        pub receiver_step_y: u32,
        /// x of the first sample.
        pub sample_first_x: i32,
        /// x of the last sample.
        pub sample_last_x: i32,
        /// y of the first sample.
        pub sample_first_y: i32,
        /// y of the last sample.
        pub sample_last_y: i32,
        /// Triangle of the first invocation.
        pub first: u32,
        /// Distance of samples along x.
        pub sample_step_x: i32,
        /// Distance of samples along y.
        pub sample_step_y: i32,
        /// Samples along x.
        pub sample_columns: u32,
        /// Samples along y.
        pub sample_rows: u32,
    }
}

bindings! {
    /// What the entry point is given.
    pub struct Regions {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        write regions @ 2: [i32],
    }
}

/// The compiled kernel.
pub struct InfluenceRegion {
    program: Arc<Program>,
}

impl InfluenceRegion {
    /// Compiles it for triangles that hide by either face.
    pub fn new() -> Result<Self> {
        Self::with_faces(Faces::Both)
    }

    /// Compiles it for triangles that hide by some faces.
    pub fn with_faces(faces: Faces) -> Result<Self> {
        let program = match faces {
            Faces::Both => crate::program("influence_region", "", &[])?,
            Faces::Front => crate::program("influence_region", "front", &[Define::new("ONE_SIDED", true)])?,
        };
        Regions::check(&program, "influence_region")?;
        Ok(InfluenceRegion { program })
    }

    /// Writes four words a triangle to `regions`; `vertices` holds nine coordinates a triangle, all on the grid.
    pub fn record(
        &self,
        job: &mut Job,
        samples: &Samples,
        receivers: &Receivers,
        vertices: Buffer<[i32]>,
        regions: Buffer<[i32]>,
    ) -> Result<()> {
        samples.check()?;
        receivers.check()?;
        let triangles = triangles(vertices, regions)?;
        let program = job.program(&self.program);
        let [first, .., last] = samples.corners();
        pieces::record(job, triangles.div_ceil(GROUP), u64::from(13 * GROUP), |job, piece| {
            let params = Params {
                triangles,
                height: receivers.height,
                columns: receivers.columns,
                rows: receivers.rows,
                receiver_x: receivers.origin[0],
                receiver_y: receivers.origin[1],
                receiver_step_x: receivers.step[0] as u32,
                receiver_step_y: receivers.step[1] as u32,
                sample_first_x: first[0],
                sample_last_x: last[0],
                sample_first_y: first[1],
                sample_last_y: last[1],
                first: piece.start * GROUP,
                sample_step_x: samples.step[0],
                sample_step_y: samples.step[1],
                sample_columns: samples.columns,
                sample_rows: samples.rows,
            };
            let params = job.value("influence params", &params);
            job.launch(program, "influence_region", &Regions { params, vertices, regions }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

/// Number of triangles of `vertices`; refuses regions that are too short for them.
fn triangles(vertices: Buffer<[i32]>, regions: Buffer<[i32]>) -> Result<u32> {
    let triangles = vertices.len() / 9;
    if regions.len() < 4 * triangles || triangles > u64::from(u32::MAX / 9) {
        let what = format!("{} words of regions for {triangles} triangles", regions.len());
        return Err(Error::refused(what, "give every triangle four words"));
    }
    Ok(triangles as u32)
}

//! Influence regions on a lattice of receivers: `tilted.wgsl`, its bindings and its matrices.
//!
//! Invariants: as those of the parallel case; the light lies strictly on one side of the receivers' plane.

use std::sync::Arc;

use glam::IVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Program, Result, bindings, host};

use super::{GROUP, triangles};
use crate::grid::{Lattice, Point, Samples, cross, dot, minus};
use crate::pieces;

/// Words of memory that take as long as a triangle: twelve projections by 64-bit products and quotients.
const WORK: u64 = 256;

host! {
    /// Mirrors `struct Corner`.
    pub struct Corner {
        /// Where it stands.
        pub sample: IVec4,
        /// Numerator of a projection's column.
        pub column: IVec4,
        /// Numerator of a projection's row.
        pub row: IVec4,
    }
}

host! {
    /// Mirrors `struct Params` of `tilted.wgsl`.
    pub struct TiltedParams {
        /// Number of triangles.
        pub triangles: u32,
        /// Triangle of the first invocation.
        pub first: u32,
        /// Receivers along the first axis.
        pub columns: u32,
        /// Receivers along the second axis.
        pub rows: u32,
        /// Receiver (0, 0).
        pub origin: IVec4,
        /// Normal of the receivers' plane, pointing away from the source.
        pub normal: IVec4,
        /// Corners of the source.
        pub corners: [Corner; 4],
    }
}

bindings! {
    /// What the entry point is given.
    pub struct TiltedRegions {
        uniform params @ 0: TiltedParams,
        read vertices @ 1: [i32],
        write regions @ 2: [i32],
    }
}

/// The compiled kernel for receivers on any plane.
pub struct TiltedRegion {
    pub(super) program: Arc<Program>,
}

impl TiltedRegion {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = Program::new("influence_region.tilted", "influence_region/tilted.wgsl", &crate::source, &[])?;
        TiltedRegions::check(&program, "tilted_region")?;
        Ok(TiltedRegion { program })
    }

    /// Writes four words a triangle to `regions`; `vertices` holds nine coordinates a triangle, all on the grid.
    ///
    /// # Errors
    ///
    /// Samples or receivers beside the grid, a light that does not lie strictly on one side of the receivers' plane,
    /// and regions that are too short.
    pub fn record(
        &self,
        job: &mut Job,
        samples: &Samples,
        receivers: &Lattice,
        vertices: Buffer<[i32]>,
        regions: Buffer<[i32]>,
    ) -> Result<()> {
        let params = params(samples, receivers)?;
        let triangles = triangles(vertices, regions)?;
        let program = job.program(&self.program);
        pieces::record(job, triangles.div_ceil(GROUP), WORK * u64::from(GROUP), |job, piece| {
            let params = TiltedParams { triangles, first: piece.start * GROUP, ..params };
            let params = job.value("tilted influence params", &params);
            let bound = TiltedRegions { params, vertices, regions };
            job.launch(program, "tilted_region", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

/// The matrices of a light's corners, for no triangle yet.
fn params(samples: &Samples, receivers: &Lattice) -> Result<TiltedParams> {
    samples.check()?;
    receivers.check()?;
    let corners = samples.corners();
    let normal = receivers.normal();
    let sides = corners.map(|sample| dot(normal.map(i128::from), minus(sample, receivers.origin)));
    let away = if sides.iter().all(|side| *side < 0) {
        1
    } else if sides.iter().all(|side| *side > 0) {
        -1
    } else {
        let what = format!("a light {samples:?} that reaches the plane of its receivers {receivers:?}");
        return Err(Error::refused(what, "move the light, or the receivers, clear of each other's plane"));
    };
    let vector = |v: Point| IVec4::new(v[0], v[1], v[2], 0);
    let turned = |v: Point| vector(v) * away;
    let corner = |sample: Point| {
        let m = std::array::from_fn(|axis| sample[axis] - receivers.origin[axis]);
        let [u, v] = receivers.axes;
        Corner { sample: vector(sample), column: turned(cross(m, v)), row: turned(cross(u, m)) }
    };
    Ok(TiltedParams {
        triangles: 0,
        first: 0,
        columns: receivers.columns,
        rows: receivers.rows,
        origin: vector(receivers.origin),
        normal: turned(normal),
        corners: corners.map(corner),
    })
}

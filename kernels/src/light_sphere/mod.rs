//! Light spheres: sets of directional lights, in levels that refine each other, and their rotation.
//!
//! The octahedron of Sattler et al. 2004, section 3.4, on its integer lattice: 6, 18, 66, 258,
//! 1026, 4098 and 16,386 directions, each level a prefix of the next; [`weights()`] makes sums over them integrals, and
//! [`healpix()`] is the alternative of equal areas. `kernel.wgsl` states the numbering and both outputs exactly.
//! Invariant: directions 2p and 2p + 1 are opposite.
//!
//! The paper projects midpoints to the sphere after every subdivision; here the octahedron's flat faces are subdivided.
//! Number, nesting and symmetries of the directions are the same, no direction is more than 4.1 degrees from the
//! paper's, and all are exact.

use std::sync::Arc;

use glam::IVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
mod healpix;
pub mod oracle;
mod weights;

pub use healpix::{MAX_ORDER, healpix};
pub use weights::weights;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "light_sphere",
    summary: "directions of the subdivided octahedron, level by level, and their rotation",
    citation: "Sattler et al., Hardware-Accelerated Ambient Occlusion Computation, 2004, sections 3.4 and 5",
    programs: || Ok(vec![LightSphere::new()?.program]),
    cases: cases::all,
};

/// Finest level: 16,386 directions.
pub const MAX_LEVEL: u32 = 6;

const GROUP: u32 = 256;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Directions in all.
        pub count: u32,
        /// Direction of the first invocation.
        pub first: u32,
    }

    /// Mirrors `struct Turn`.
    pub struct Turn {
        /// First row of the rotation, in units of 2^-14.
        pub x: IVec4,
        /// Second row.
        pub y: IVec4,
        /// Third row.
        pub z: IVec4,
        /// Directions in all.
        pub count: u32,
        /// Direction of the first invocation.
        pub first: u32,
        /// Padding.
        pub _pad: [u32; 2],
    }
}

bindings! {
    /// What `octahedron` is given.
    pub struct Octahedron {
        uniform params @ 0: Params,
        write directions @ 1: [IVec4],
    }

    /// What `turn` is given.
    pub struct TurnAll {
        uniform rotation @ 2: Turn,
        read given @ 3: [IVec4],
        write turned @ 4: [IVec4],
    }
}

/// Directions of a level: 2 + 4^(level + 1).
pub fn count(level: u32) -> u32 {
    2 + (4 << (2 * level))
}

/// All directions of a level with their own level's 2^s, made on the host from the definition.
///
/// # Panics
///
/// Where the level is above [`MAX_LEVEL`].
pub fn directions(level: u32) -> Vec<[i32; 4]> {
    assert!(level <= MAX_LEVEL, "level {level} is above {MAX_LEVEL}");
    oracle::octahedron(level).into_iter().map(|([x, y, z], n)| [x, y, z, n]).collect()
}

/// A rotation in units of 2^-14.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rotation([[i32; 3]; 3]);

impl Rotation {
    /// Leaves directions where they are.
    pub const IDENTITY: Rotation = Rotation([[1 << 14, 0, 0], [0, 1 << 14, 0], [0, 0, 1 << 14]]);

    /// The rotation with these rows, rounded to the nearest units. Rows must be orthonormal within 2^-10 and
    /// right-handed.
    pub fn new(rows: [[f64; 3]; 3]) -> Result<Self> {
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let [x, y, z] = rows;
        let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
        let near = |value: f64, wanted: f64| (value - wanted).abs() <= 1.0 / 1024.0;
        let unit = rows.iter().all(|row| near(dot(*row, *row), 1.0));
        if !(unit && near(dot(x, y), 0.0) && near(dot(cross, z), 1.0)) {
            let remedy = "give three rows of length one at right angles, the third the cross product of the others";
            return Err(Error::refused(format!("the rotation {rows:?}"), remedy));
        }
        let units = |c: f64| (libm::rint(c * 16_384.0) as i32).clamp(-(1 << 14), 1 << 14);
        Ok(Rotation(rows.map(|row| row.map(units))))
    }

    /// Its rows in units of 2^-14.
    pub fn rows(self) -> [[i32; 3]; 3] {
        self.0
    }
}

/// The compiled kernel.
pub struct LightSphere {
    program: Arc<Program>,
}

impl LightSphere {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("light_sphere", "", &[])?;
        Octahedron::check(&program, "octahedron")?;
        TurnAll::check(&program, "turn")?;
        Ok(LightSphere { program })
    }

    /// Writes the directions of a level: (x, y, z, 2^s) each.
    pub fn record_level(&self, job: &mut Job, level: u32, directions: Buffer<[IVec4]>) -> Result<()> {
        if level > MAX_LEVEL || directions.len() < u64::from(count(level)) {
            let what = format!("level {level} of the light sphere in {} directions", directions.len());
            return Err(Error::refused(what, format!("use levels 0 to {MAX_LEVEL}, and one element a direction")));
        }
        let count = count(level);
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(4 * GROUP), |job, piece| {
            let params = job.value("sphere params", &Params { count, first: piece.start * GROUP });
            job.launch(program, "octahedron", &Octahedron { params, directions }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }

    /// Turns the first `count` directions, whose components are within [-2^15, 2^15] and not all 0, as the environment
    /// is turned; results have a length of about 2^15.
    pub fn record_turn(
        &self,
        job: &mut Job,
        rotation: Rotation,
        count: u32,
        given: Buffer<[IVec4]>,
        turned: Buffer<[IVec4]>,
    ) -> Result<()> {
        if given.len() < u64::from(count) || turned.len() < u64::from(count) {
            let what = format!("a rotation of {count} directions from {} to {}", given.len(), turned.len());
            return Err(Error::refused(what, "give one element a direction"));
        }
        let [x, y, z] = rotation.rows().map(|[a, b, c]| IVec4::new(a, b, c, 0));
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(64 * GROUP), |job, piece| {
            let turn = Turn { x, y, z, count, first: piece.start * GROUP, _pad: [0; 2] };
            let rotation = job.value("turn", &turn);
            job.launch(program, "turn", &TurnAll { rotation, given, turned }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

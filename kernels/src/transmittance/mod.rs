//! What transparent surfaces let through to a picture behind them.
//!
//! Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU", section 5. `kernel.wgsl` states the output
//! exactly. Invariant: a weight never grows, and smaller weights stay smaller or become equal.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "transmittance",
    summary: "weights of pixels behind transparent surfaces",
    citation: "Engelhardt and Dachsbacher, Granular Visibility Queries on the GPU, 2009, section 5",
    programs: || Ok(vec![Transmittance::new()?.program]),
    cases: cases::all,
};

/// The factor of a blocker that lets all through.
pub const ALL: u32 = 256;

/// The greatest weight.
pub const MAX_WEIGHT: u32 = (1 << 16) - 1;

/// Invocations a workgroup.
const GROUP: u32 = 256;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of pixels.
        pub pixels: u32,
        /// Number of blockers.
        pub count: u32,
        /// Number of the first workgroup.
        pub first: u32,
    }
}

bindings! {
    /// What `attenuate` is given.
    pub struct Attenuate {
        uniform params @ 0: Params,
        read depths @ 1: [u32],
        read blocker_depths @ 2: [u32],
        read blockers @ 3: [u32],
        read through @ 4: [u32],
        write weights @ 5: [u32],
    }
}

/// Pictures of blockers and of what may be behind them, a word a pixel each.
#[derive(Clone, Copy, Debug)]
pub struct Pictures {
    /// Number of pixels.
    pub pixels: u32,
    /// Depth of what is looked at.
    pub depths: Buffer<[u32]>,
    /// Depth of the nearest blocker.
    pub blocker_depths: Buffer<[u32]>,
    /// Number of the nearest blocker, or any number that is none of them.
    pub blockers: Buffer<[u32]>,
}

/// The compiled kernel.
pub struct Transmittance {
    program: Arc<Program>,
}

impl Transmittance {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("transmittance", "", &[])?;
        Attenuate::check(&program, "attenuate")?;
        Ok(Transmittance { program })
    }

    /// Multiplies the weights of pixels, at most [`MAX_WEIGHT`], by what the blockers before them let through:
    /// `through` has a factor a blocker, [`ALL`] where it is all.
    pub fn record(
        &self,
        job: &mut Job,
        pictures: Pictures,
        (count, through): (u32, Buffer<[u32]>),
        weights: Buffer<[u32]>,
    ) -> Result<()> {
        let Pictures { pixels, depths, blocker_depths, blockers } = pictures;
        let words = depths.len().min(blocker_depths.len()).min(blockers.len()).min(weights.len());
        if words < u64::from(pixels) || through.len() < u64::from(count) {
            let what = format!("{words} words of {pixels} pixels, and {} factors of {count} blockers", through.len());
            return Err(Error::refused(what, "give every picture a word a pixel, and every blocker a factor"));
        }
        let program = job.program(&self.program);
        pieces::record(job, pixels.div_ceil(GROUP), u64::from(6 * GROUP), |job, piece| {
            let params = job.value("transmittance params", &Params { pixels, count, first: piece.start });
            let bound = Attenuate { params, depths, blocker_depths, blockers, through, weights };
            job.launch(program, "attenuate", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

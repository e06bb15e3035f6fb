//! One projection for each sample of a light: what the masks are compared with.
//!
//! Heckbert and Herf draw all occluders once from each sample of a light; Eisemann and Décoret, "Visibility Sampling on
//! GPU and Applications", section 10, compare with that, and in section 8 with soft shadow volumes, which add up what
//! the silhouettes seen from the light's centre hide. Both are this kernel. Invariant: the masks are those of
//! [`crate::grid::hidden`], bit for bit, for triangles strictly between source and receivers.

use std::ops::Range;
use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Define, Error, Job, Kernel, Program, Result, bindings, host};

use crate::grid::{Receivers, Samples, View};
use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "sample_planes",
    summary: "masks by one projection for each sample of a light, and the additive counts of silhouette volumes",
    citation: "Heckbert and Herf, Simulating Soft Shadows with Graphics Hardware, 1997; Eisemann and Décoret, Visibility \
               Sampling on GPU and Applications, 2007, sections 8 and 10",
    programs: || {
        let SamplePlanes { masks, additive } = SamplePlanes::new()?;
        Ok(vec![masks, additive])
    },
    cases: cases::all,
};

/// Samples a workgroup.
const GROUP: u32 = 64;

/// Receivers that an invocation looks at, at most; each is a turn of a loop.
const TURNS: u32 = 49_152;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Samples along x.
        pub sample_columns: u32,
        /// Number of samples.
        pub samples: u32,
        /// Receiver rows of a band.
        pub band: u32,
        /// First triangle.
        pub first: u32,
        /// One past the last triangle.
        pub end: u32,
        /// x of the point that silhouettes are seen from.
        pub from_x: i32,
        /// Its y.
        pub from_y: i32,
        /// WGSL places structs of a uniform at multiples of 16 bytes.
        pub _pad: u32,
        /// Light and receivers.
        pub view: View,
    }
}

bindings! {
    /// What `planes` is given.
    pub struct Planes {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        write hidden @ 2: [u32],
    }
}

/// The compiled kernel.
pub struct SamplePlanes {
    masks: Arc<Program>,
    additive: Arc<Program>,
}

/// A light, its receivers, and triangles strictly between the two, nine coordinates each.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// The light.
    pub samples: Samples,
    /// The receivers.
    pub receivers: Receivers,
    /// Coordinates of the triangles.
    pub vertices: Buffer<[i32]>,
    /// Number of triangles.
    pub triangles: u32,
}

/// The grid point next to the centre of a light, from which silhouettes are seen.
pub fn centre(samples: &Samples) -> [i32; 2] {
    let [first, .., last] = samples.corners();
    [0, 1].map(|axis| (first[axis] + last[axis]).div_euclid(2))
}

impl SamplePlanes {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let variant = |name: &str, additive: bool| {
            let program = crate::program("sample_planes", name, &[Define::new("ADDITIVE", additive)])?;
            Planes::check(&program, "planes")?;
            Ok::<_, Error>(program)
        };
        Ok(SamplePlanes { masks: variant("masks", false)?, additive: variant("additive", true)? })
    }

    /// Adds what the triangles hide to `hidden`, whose word `(s / 32) * receivers + r` holds sample s of receiver r.
    pub fn record(&self, job: &mut Job, scene: Scene, hidden: Buffer<[u32]>) -> Result<()> {
        scene.check(scene.samples.words(), hidden.len())?;
        scene.launch(job, &self.masks, hidden);
        Ok(())
    }

    /// Adds to `counts`, a word a receiver, what silhouette volumes hide of the light: the sum, over the triangles that
    /// face its [`centre`] and over all samples that they hide, of 1 where they face the sample too, else of -1. This
    /// is the number of hidden samples for closed meshes, counter-clockwise outside, that show all samples the sides
    /// that they show the centre and of which none hides what another hides.
    pub fn record_additive(&self, job: &mut Job, scene: Scene, counts: Buffer<[u32]>) -> Result<()> {
        scene.check(1, counts.len())?;
        scene.launch(job, &self.additive, counts);
        Ok(())
    }
}

impl Scene {
    fn check(&self, words: u32, given: u64) -> Result<()> {
        self.samples.check()?;
        self.receivers.check()?;
        let wanted = u64::from(self.receivers.count()) * u64::from(words);
        if given < wanted || self.vertices.len() < 9 * u64::from(self.triangles) {
            let what = format!("{given} words of results and {} coordinates", self.vertices.len());
            return Err(Error::refused(what, format!("give {wanted} words, and nine coordinates a triangle")));
        }
        Ok(())
    }

    fn launch(&self, job: &mut Job, program: &Arc<Program>, hidden: Buffer<[u32]>) {
        let Scene { samples, receivers, vertices, triangles } = *self;
        let program = job.program(program);
        // A row of the box takes a turn more to find its end.
        let band = (TURNS / (receivers.columns + 1)).clamp(1, receivers.rows);
        let groups = [samples.count().div_ceil(GROUP), receivers.rows.div_ceil(band)];
        // A shadow is reckoned to cover a 64th of the receivers.
        let words = u64::from((receivers.count() / 64).max(64)) * u64::from(samples.count());
        pieces::record(job, triangles, words, |job, piece| {
            let params = job.value("plane params", &self.params(band, piece.clone()));
            let bound = Planes { params, vertices, hidden };
            job.launch(program, "planes", &bound, [piece.len() as u32, groups[0], groups[1]]);
        });
    }

    fn params(&self, band: u32, piece: Range<u32>) -> Params {
        let [from_x, from_y] = centre(&self.samples);
        Params {
            sample_columns: self.samples.columns,
            samples: self.samples.count(),
            band,
            first: piece.start,
            end: piece.end.min(self.triangles),
            from_x,
            from_y,
            _pad: 0,
            view: View::new(&self.samples, &self.receivers),
        }
    }
}

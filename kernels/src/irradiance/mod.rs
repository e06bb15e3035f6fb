//! Irradiance: how many samples of each group of a light a receiver sees, and how much light they send.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 8. `kernel.wgsl` states both outputs
//! and their bit budget. Invariant: sums of weights are exact integers, equal in any order and on every machine.

use std::sync::Arc;

use glam::{IVec2, IVec4};
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::field::Field;
use crate::grid::XY;
use crate::pattern::Pattern;
use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "irradiance",
    summary: "samples that each receiver sees and the light they send, by groups of samples",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, section 8",
    programs: || Ok(vec![Irradiance::new()?.program]),
    cases: cases::all,
};

/// Bits behind the point of a sum of weights.
pub const FRACTION: u32 = 48;

/// Length of a unit normal.
pub const UNIT: i32 = 1 << 15;

/// Most groups: as many as samples.
pub const MAX_GROUPS: usize = 1024;

const GROUP: u32 = 64;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of receivers.
        pub receivers: u32,
        /// Words of a mask.
        pub words: u32,
        /// Number of samples.
        pub samples: u32,
        /// Samples of a word.
        pub bits: u32,
        /// Receiver of the first invocation.
        pub first: u32,
    }
}

bindings! {
    /// What `count_groups` is given.
    pub struct Counts {
        uniform params @ 0: Params,
        read masks @ 1: [u32],
        read receivers @ 2: [IVec4],
        read groups @ 3: [u32],
        write visible @ 6: [u32],
    }

    /// What `irradiance` is given.
    pub struct Sums {
        uniform params @ 0: Params,
        read masks @ 1: [u32],
        read receivers @ 2: [IVec4],
        read groups @ 3: [u32],
        read normals @ 4: [IVec4],
        read samples @ 5: [IVec2],
        write light @ 7: [u32],
    }
}

/// The samples of a pattern by groups, which may overlap; each has a word a word of the pattern's masks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Groups {
    masks: Vec<u32>,
    count: u32,
}

impl Groups {
    /// One group of all samples.
    pub fn all(pattern: &Pattern) -> Self {
        Groups { masks: vec![u32::MAX; pattern.words() as usize], count: 1 }
    }

    /// Group g holds the samples s with `of[s] == g`; groups up to the greatest number are made.
    pub fn new(pattern: &Pattern, of: &[u32]) -> Result<Self> {
        let count = of.iter().max().map_or(0, |most| *most as usize + 1);
        if of.len() != pattern.count() as usize || count > MAX_GROUPS {
            let what = format!("{} samples in {count} groups, and a pattern of {}", of.len(), pattern.count());
            return Err(Error::refused(what, format!("number every sample's group, from 0 to {}", MAX_GROUPS - 1)));
        }
        let words = pattern.words() as usize;
        let mut masks = vec![0; count * words];
        for (sample, group) in (0..).zip(of) {
            masks[*group as usize * words + (sample / pattern.bits()) as usize] |= 1 << (sample % pattern.bits());
        }
        Ok(Groups { masks, count: count as u32 })
    }

    /// Number of groups.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Whether group g holds a sample of a pattern.
    pub fn holds(&self, pattern: &Pattern, group: u32, sample: u32) -> bool {
        self.masks[(group * pattern.words() + sample / pattern.bits()) as usize] >> (sample % pattern.bits()) & 1 != 0
    }
}

/// What a light's masks are read with: buffers that both results use.
pub struct Seen<'a> {
    /// The light.
    pub pattern: &'a Pattern,
    /// Its groups.
    pub groups: &'a Groups,
    /// The receivers.
    pub field: &'a Field,
    /// Hidden samples: word w of receiver r at `w * receivers + r`.
    pub masks: Buffer<[u32]>,
}

/// The compiled kernel.
pub struct Irradiance {
    program: Arc<Program>,
}

impl Irradiance {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("irradiance", "", &[])?;
        Counts::check(&program, "count_groups")?;
        Sums::check(&program, "irradiance")?;
        Ok(Irradiance { program })
    }

    /// Counts the samples of each group that each receiver sees: group g, receiver r at `g * receivers + r`.
    pub fn record_counts(&self, job: &mut Job, seen: &Seen<'_>) -> Result<Buffer<[u32]>> {
        seen.check()?;
        let (masks, receivers) = (seen.masks, seen.field.upload(job));
        let groups = job.slice("groups", &seen.groups.masks);
        let visible = job.zeroed("visible by group", seen.outputs());
        let program = job.program(&self.program);
        let cost = u64::from(GROUP * seen.groups.count * (2 * seen.pattern.words() + 2));
        pieces::record(job, seen.field.count().div_ceil(GROUP), cost, |job, piece| {
            let params = job.value("count params", &seen.params(piece.start * GROUP));
            let bound = Counts { params, masks, receivers, groups, visible };
            job.launch(program, "count_groups", &bound, [piece.len() as u32, seen.groups.count, 1]);
        });
        Ok(visible)
    }

    /// Sums the weights of the samples of each group that each receiver sees; `normals` have length [`UNIT`] or less.
    /// The sum of group g and receiver r, in units of 2^-[`FRACTION`] a square cell, has its low and its high word at
    /// `2 * (g * receivers + r)`.
    pub fn record(&self, job: &mut Job, seen: &Seen<'_>, normals: &[[i32; 3]]) -> Result<Buffer<[u32]>> {
        seen.check()?;
        seen.check_light(normals)?;
        let (masks, receivers) = (seen.masks, seen.field.upload(job));
        let groups = job.slice("groups", &seen.groups.masks);
        let normals: Vec<IVec4> = normals.iter().map(|[x, y, z]| IVec4::new(*x, *y, *z, 0)).collect();
        let normals = job.slice("normals", &normals);
        let points: Vec<IVec2> = seen.pattern.points().iter().map(|p| IVec2::from_array(*p)).collect();
        let samples = job.slice("samples", &points);
        let light = job.zeroed("light by group", 2 * seen.outputs());
        let program = job.program(&self.program);
        // A weight costs about as much as touching 16 words.
        let cost = u64::from(GROUP) * u64::from(16 * seen.pattern.count() + seen.groups.count * seen.pattern.words());
        pieces::record(job, seen.field.count().div_ceil(GROUP), cost, |job, piece| {
            let params = job.value("irradiance params", &seen.params(piece.start * GROUP));
            let bound = Sums { params, masks, receivers, groups, normals, samples, light };
            job.launch(program, "irradiance", &bound, [piece.len() as u32, seen.groups.count, 1]);
        });
        Ok(light)
    }
}

impl Seen<'_> {
    fn outputs(&self) -> u64 {
        u64::from(self.groups.count) * u64::from(self.field.count())
    }

    fn params(&self, first: u32) -> Params {
        Params {
            receivers: self.field.count(),
            words: self.pattern.words(),
            samples: self.pattern.count(),
            bits: self.pattern.bits(),
            first,
        }
    }

    fn check(&self) -> Result<()> {
        let words = u64::from(self.pattern.words());
        let masks = words * u64::from(self.field.count());
        let groups = words * u64::from(self.groups.count);
        if self.masks.len() < masks || self.groups.masks.len() as u64 != groups {
            let what = format!("{} words of masks and {} of groups", self.masks.len(), self.groups.masks.len());
            return Err(Error::refused(what, format!("give {masks} and {groups} words: the pattern's")));
        }
        Ok(())
    }

    fn check_light(&self, normals: &[[i32; 3]]) -> Result<()> {
        let square = |n: &[i32; 3]| n.iter().map(|c| i64::from(*c).pow(2)).sum::<i64>();
        let long = |n: &&[i32; 3]| n.iter().any(|c| c.unsigned_abs() > 1 << 15) || square(n) > 1 << 30;
        if normals.len() != self.field.count() as usize {
            let what = format!("{} normals for {} receivers", normals.len(), self.field.count());
            return Err(Error::refused(what, "give each receiver its normal"));
        }
        if let Some(bad) = normals.iter().find(long) {
            return Err(Error::refused(format!("a normal {bad:?}"), "scale normals to length 2^15"));
        }
        let [least, greatest] = self.pattern.bounds();
        let off = |shift: [i32; 2]| (0..2).any(|i| least[i] + shift[i] < -XY || greatest[i] + shift[i] >= XY);
        match self.field.receivers().iter().find(|r| off(r.shift)) {
            None => Ok(()),
            Some(bad) => Err(Error::refused(
                format!("samples from {least:?} to {greatest:?} shifted by {:?}", bad.shift),
                "keep shifted samples within [-16384, 16384)",
            )),
        }
    }
}

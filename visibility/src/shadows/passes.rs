//! A pass of an exposure: up to 1024 samples of a light, in one frame, on bands of receivers.
//!
//! Bands are as high as their masks and tile lists let them be. Kernels: `line_mask` over lists by shafts, then `irradiance`
//! for counts and light by groups of one colour; what they give is added to the results.

use sightlines_backend::{Backend, Job};
use sightlines_kernels::field::Field;
use sightlines_kernels::grid::Triangle;
use sightlines_kernels::irradiance::{Groups, Irradiance, Seen};
use sightlines_kernels::line_mask::{LineMask, Resolution, TILE};
use sightlines_kernels::pattern::Pattern;
use sightlines_kernels::row_span::Scene;
use sightlines_kernels::tiles::Tiles;

use super::compose::run;
use super::expose::{Exposed, Exposure, Prepared};
use super::lists;
use crate::error::Result;

/// Words of the masks of one band.
const BAND_WORDS: u32 = 1 << 24;

/// Entries of a band's tile lists, 64 MiB.
const BAND_ENTRIES: usize = 1 << 24;

/// Some of the samples.
pub(super) struct Pass<'a> {
    pub(super) prepared: &'a Prepared,
    /// Of one frame.
    pub(super) triangles: &'a [Triangle],
    pub(super) pattern: &'a Pattern,
    /// The colour of each.
    pub(super) colours: &'a [u32],
    /// Where their words begin in a set.
    pub(super) first_word: u32,
}

impl Pass<'_> {
    /// Works through the receivers in bands, as many rows at a time as fit.
    pub(super) fn run(
        &self,
        backend: &dyn Backend,
        exposure: &Exposure,
        out: &mut Exposed,
        progress: &mut dyn FnMut(f32),
    ) -> Result<()> {
        let field = &self.prepared.field;
        let most = BAND_WORDS / (self.pattern.words() * field.columns()) / TILE[1] * TILE[1];
        let mut height = most.clamp(TILE[1], field.rows().next_multiple_of(TILE[1]));
        let mut row = 0;
        while row < field.rows() {
            let end = (row + height).min(field.rows());
            let band = field.band(row..end);
            let tiles = lists::tiles(TILE, &band, self.pattern.bounds(), self.triangles);
            if tiles.entries.len() > BAND_ENTRIES && height > TILE[1] {
                height = (height / 2).next_multiple_of(TILE[1]);
                continue;
            }
            out.work.pairs += lists::pairs(&tiles, &band);
            let mut part = |share: f32| progress((row as f32 + share * (end - row) as f32) / field.rows() as f32);
            self.band(backend, exposure, Band { row, field: band, tiles }, out, &mut part)?;
            row = end;
        }
        Ok(())
    }

    fn band(
        &self,
        backend: &dyn Backend,
        exposure: &Exposure,
        band: Band,
        out: &mut Exposed,
        progress: &mut dyn FnMut(f32),
    ) -> Result<()> {
        let Band { row, field, tiles } = &band;
        let mut job = Job::new();
        let hidden = job.zeroed("hidden", u64::from(field.count()) * u64::from(self.pattern.words()));
        if !tiles.entries.is_empty() {
            let vertices = job.slice("vertices", self.triangles.as_flattened().as_flattened());
            let starts = job.slice("tile starts", &tiles.starts);
            let entries = job.slice("tile entries", &tiles.entries);
            let kernel = LineMask::new(self.pattern, Resolution::exact(self.pattern))?;
            let table = kernel.record_table(&mut job);
            kernel.record(&mut job, field, tiles, table, Scene { vertices, starts, entries, hidden })?;
        }
        let groups = Groups::new(self.pattern, self.colours)?;
        let seen = Seen { pattern: self.pattern, groups: &groups, field, masks: hidden };
        let kernel = Irradiance::new()?;
        let visible = kernel.record_counts(&mut job, &seen)?;
        job.read("hidden", hidden.id());
        job.read("visible", visible.id());
        let first = (row * field.columns()) as usize;
        if exposure.light_sums {
            let normals = &self.prepared.normals[first..first + field.count() as usize];
            let light = kernel.record(&mut job, &seen, normals)?;
            job.read("light", light.id());
        }
        let [masks, visible, light] = run(backend, &job, &mut out.work, progress)?;
        self.add(out, first, field.count() as usize, &masks, &visible, &light);
        Ok(())
    }

    /// Adds what a band's kernels gave, whose first texel is `first`, to the results.
    fn add(&self, out: &mut Exposed, first: usize, count: usize, masks: &[u32], visible: &[u32], light: &[u32]) {
        let texels = out.sets.texels();
        let words = out.sets.words as usize;
        for (word, plane) in masks.chunks(count).enumerate() {
            let at = self.first_word as usize + word;
            plane.iter().enumerate().for_each(|(texel, mask)| out.sets.masks[(first + texel) * words + at] |= mask);
        }
        for (colour, seen) in visible.chunks(count).enumerate() {
            let sums = &mut out.visible[colour * texels + first..][..count];
            sums.iter_mut().zip(seen).for_each(|(sum, seen)| *sum += seen);
        }
        for (colour, sent) in light.chunks(2 * count).enumerate() {
            let sums = &mut out.light[colour * texels + first..][..count];
            let sent = sent.as_chunks::<2>().0.iter().map(|[low, high]| u64::from(*high) << 32 | u64::from(*low));
            sums.iter_mut().zip(sent).for_each(|(sum, sent)| *sum = sum.saturating_add(sent));
        }
    }
}

/// Some rows of receivers and their lists.
struct Band {
    row: u32,
    field: Field,
    tiles: Tiles,
}

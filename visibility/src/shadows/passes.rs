//! A pass of an exposure: up to 1024 samples of a light, in one frame, on bands of receivers.
//!
//! Bands are as high as their masks and tile lists let them be; where the lists of the lowest are still too long,
//! triangles are taken in turns. Kernels: `line_mask` over lists by shafts, then `irradiance` for counts and light by
//! groups of one colour; what they give is added to the results.

use sightlines_backend::host::Buffer;
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
            let band = Band { first: (row * field.columns()) as usize, field: field.band(row..end) };
            let tiles = self.lists(&band, self.triangles);
            if tiles.entries.len() as u64 > exposure.effort.entries() && height > TILE[1] {
                height = (height / 2).next_multiple_of(TILE[1]);
                continue;
            }
            let mut part = |share: f32| progress((row as f32 + share * (end - row) as f32) / field.rows() as f32);
            self.band(backend, exposure, &band, tiles, out, &mut part)?;
            row = end;
        }
        Ok(())
    }

    fn lists(&self, band: &Band, triangles: &[Triangle]) -> Tiles {
        lists::tiles(TILE, &band.field, self.pattern.bounds(), triangles, self.prepared.faces)
    }

    /// A band with the lists of all triangles: in turns, halved until their lists are short enough.
    fn band(
        &self,
        backend: &dyn Backend,
        exposure: &Exposure,
        band: &Band,
        tiles: Tiles,
        out: &mut Exposed,
        progress: &mut dyn FnMut(f32),
    ) -> Result<()> {
        let mut masks = None;
        let mut turns = vec![(self.triangles, Some(tiles))];
        while let Some((triangles, tiles)) = turns.pop() {
            let tiles = tiles.unwrap_or_else(|| self.lists(band, triangles));
            if tiles.entries.len() as u64 > exposure.effort.entries() && triangles.len() > 1 {
                let (first, last) = triangles.split_at(triangles.len() / 2);
                turns.extend([(last, None), (first, None)]);
                continue;
            }
            out.work.pairs += lists::pairs(&tiles, &band.field);
            let (mut job, hidden) = self.turn(band, triangles, &tiles, masks.take())?;
            let left: usize = turns.iter().map(|(triangles, _)| triangles.len()).sum();
            let done = |left: usize| 1.0 - left as f32 / self.triangles.len().max(1) as f32;
            let (from, to) = (done(left + triangles.len()), done(left));
            let mut part = |share: f32| progress(from + share * (to - from));
            if turns.is_empty() {
                self.count(exposure, band, &mut job, hidden)?;
                let [masks, visible, light] = run(backend, &job, &mut out.work, &mut part)?;
                self.add(out, band, &masks, &visible, &light);
            } else {
                let [words] = run(backend, &job, &mut out.work, &mut part)?;
                masks = Some(words);
            }
        }
        Ok(())
    }

    /// A job that adds what some triangles hide to masks, and reads them.
    fn turn(
        &self,
        band: &Band,
        triangles: &[Triangle],
        tiles: &Tiles,
        masks: Option<Vec<u32>>,
    ) -> Result<(Job, Buffer<[u32]>)> {
        let mut job = Job::new();
        let words = u64::from(band.field.count()) * u64::from(self.pattern.words());
        let hidden = match masks {
            Some(masks) => job.slice("hidden", &masks),
            None => job.zeroed("hidden", words),
        };
        if !tiles.entries.is_empty() {
            let vertices = job.slice("vertices", triangles.as_flattened().as_flattened());
            let starts = job.slice("tile starts", &tiles.starts);
            let entries = job.slice("tile entries", &tiles.entries);
            let kernel = LineMask::with_faces(self.pattern, Resolution::exact(self.pattern), self.prepared.faces)?;
            let table = kernel.record_table(&mut job);
            kernel.record(&mut job, &band.field, tiles, table, Scene { vertices, starts, entries, hidden })?;
        }
        job.read("hidden", hidden.id());
        Ok((job, hidden))
    }

    /// Records what receivers see of each colour and the light that they get, and reads it.
    fn count(&self, exposure: &Exposure, band: &Band, job: &mut Job, masks: Buffer<[u32]>) -> Result<()> {
        let Band { first, field } = band;
        let groups = Groups::new(self.pattern, self.colours)?;
        let seen = Seen { pattern: self.pattern, groups: &groups, field, masks };
        let kernel = Irradiance::new()?;
        let visible = kernel.record_counts(job, &seen)?;
        job.read("visible", visible.id());
        if exposure.light_sums {
            let normals = &self.prepared.normals[*first..first + field.count() as usize];
            let light = kernel.record(job, &seen, normals)?;
            job.read("light", light.id());
        }
        Ok(())
    }

    /// Adds what a band's kernels gave to the results.
    fn add(&self, out: &mut Exposed, band: &Band, masks: &[u32], visible: &[u32], light: &[u32]) {
        let (first, count) = (band.first, band.field.count() as usize);
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

/// Some rows of receivers.
struct Band {
    /// Its first texel.
    first: usize,
    field: Field,
}

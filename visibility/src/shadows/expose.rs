//! Any light on any receivers: patterns, forms and colours of lights, planes, height fields and lightmaps.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 6 and 8. Where [`bake`](super::bake)
//! takes a white rectangle with a regular grid of samples and a parallel plane, this takes the rest, with the same
//! definition on a grid of the same kind: on what both can do their sets are equal. Lights of more samples than a pass
//! holds take several passes.

use sightlines_backend::Backend;
use sightlines_kernels::field::{Field, Receiver};
use sightlines_kernels::grid::{self, Triangle};
use sightlines_kernels::irradiance::FRACTION;
use sightlines_kernels::pattern::Pattern;
use sightlines_kernels::random;

use super::cull::{Crowd, Culled, cull};
use super::fit::{Fitted, fit};
use super::light::{Colour, Light, Palette, WHITE};
use super::passes::Pass;
use super::placement::{Placement, Point};
use super::snap::{Frame, is_aligned};
use super::surface::Surface;
use super::{Bake, Effort, Faces, MAX_WORDS, Request, SAMPLES, Sets, Work, bake_with};
use crate::error::{Place, Result};
use crate::vector::{Vector, add, length};

/// Groups of colours, by default: the paper's number.
pub const COLOURS: usize = 24;

/// What to expose to a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Exposure {
    /// Everything that casts a shadow, in scene units.
    pub triangles: Vec<[[f64; 3]; 3]>,
    /// Which faces of it hide.
    pub faces: Faces,
    /// The light.
    pub light: Light,
    /// What receives.
    pub surface: Surface,
    /// Texels a side.
    pub resolution: u32,
    /// Samples of the light.
    pub sampling: Sampling,
    /// Whether light is summed, or samples counted alone.
    pub light_sums: bool,
    /// What moves.
    pub motion: Option<Motion>,
    /// What it may take.
    pub effort: Effort,
}

/// Casters that move: the light is accumulated over frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    /// What moves, where it is at first.
    pub triangles: Vec<[[f64; 3]; 3]>,
    /// How far it has moved in each frame.
    pub offsets: Vec<[f64; 3]>,
}

impl Exposure {
    /// Whether nothing moves.
    pub(super) fn is_at_rest(&self) -> bool {
        self.motion.is_none()
    }

    /// What casts shadows in each frame: what rests, and what moves where it is then.
    pub(super) fn frames(&self) -> Result<impl Iterator<Item = impl Iterator<Item = [Vector; 3]>>> {
        let own = self.surface.casters(&self.light.rect)?;
        let rest = || Motion { triangles: Vec::new(), offsets: vec![[0.0; 3]] };
        let Motion { triangles: moving, offsets } = self.motion.clone().unwrap_or_else(rest);
        Ok(offsets.into_iter().map(move |offset| {
            let moved: Vec<[Vector; 3]> = moving.iter().map(|t| t.map(|p| add(p, offset))).chain(own.clone()).collect();
            self.triangles.iter().copied().chain(moved)
        }))
    }

    /// The request of [`bake`](super::bake), where that can do it: its kernels are faster.
    fn plain(&self) -> Option<Request> {
        let Exposure { light, surface: Surface::Plane(receiver), resolution, sampling, .. } = self else { return None };
        let plain = Sampling { colours: sampling.colours, seed: sampling.seed, ..Sampling::new(sampling.count) };
        let frame = Frame::new(&light.rect).ok()?;
        let is_plain = self.is_at_rest() && !self.light_sums && light.is_plain() && *sampling == plain;
        (is_plain && SAMPLES.contains(&sampling.count) && is_aligned(&frame, receiver)).then(|| Request {
            triangles: self.triangles.clone(),
            faces: self.faces,
            light: light.rect,
            receiver: *receiver,
            resolution: *resolution,
            samples: sampling.count,
        })
    }
}

/// How a light is sampled.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampling {
    /// Samples, 1 to [`MAX_SAMPLES`](super::placement::MAX_SAMPLES).
    pub count: u32,
    /// Where they are.
    pub placement: Placement,
    /// Of all that is random.
    pub seed: u32,
    /// Whether each receiver has the pattern shifted by a random part of a sample's distance to the next.
    pub decorrelated: bool,
    /// Samples a word of the sets: 32, or 31 as on machines whose integers lack one value.
    pub bits: u32,
    /// Most groups of colours.
    pub colours: usize,
}

impl Sampling {
    /// A grid of `count` samples.
    pub fn new(count: u32) -> Self {
        let placement = Placement::default();
        Sampling { count, placement, seed: 1, decorrelated: false, bits: 32, colours: COLOURS }
    }

    /// Samples of one pass.
    fn pass(&self) -> usize {
        32 * self.bits as usize
    }
}

/// What a light leaves of its receivers.
#[derive(Clone, Debug, PartialEq)]
pub struct Exposed {
    /// Which samples are hidden from each texel, in any frame; all where there is no receiver, or it is behind the
    /// light.
    pub sets: Sets,
    /// Whether a texel has a receiver.
    pub is_there: Vec<bool>,
    /// The colours of the light.
    pub colours: Vec<Colour>,
    /// The colour of each sample.
    pub of: Vec<u32>,
    /// Samples of each colour, in all frames together.
    pub samples: Vec<u32>,
    /// Samples that each texel sees, colour after colour, row after row.
    pub visible: Vec<u32>,
    /// Sums of cos a cos b / d² over those samples, in units of 2^-48 a square cell, in the same order; empty if not
    /// asked for.
    pub light: Vec<u64>,
    /// The lit area, in square scene units.
    pub area: f64,
    /// What it took.
    pub work: Work,
}

impl Exposed {
    /// The light of each texel in the light's own colours, where white that sees all of it is 1.
    pub fn picture(&self) -> Vec<[f64; 3]> {
        let total: u32 = self.samples.iter().sum();
        let texels = 0..self.sets.texels();
        let mixed = |texel| self.mixed(|c, at| f64::from(self.visible[c * self.sets.texels() + at]), texel);
        texels.map(|texel| mixed(texel).map(|sum| sum / f64::from(total))).collect()
    }

    /// Irradiance of each texel under a light of radiance 1 times its colour, in units of that radiance.
    pub fn irradiance(&self) -> Vec<[f64; 3]> {
        let total: u32 = self.samples.iter().sum();
        let unit = self.area / f64::from(total) / (self.sets.cell * self.sets.cell) / (1u64 << FRACTION) as f64;
        let texels = 0..self.sets.texels();
        let mixed = |texel| self.mixed(|c, at| self.light[c * self.sets.texels() + at] as f64, texel);
        texels.map(|texel| mixed(texel).map(|sum| sum * unit)).collect()
    }

    /// The sum over colours of each times an amount that depends on its number and the texel.
    fn mixed(&self, amount: impl Fn(usize, usize) -> f64, texel: usize) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (number, colour) in self.colours.iter().enumerate() {
            let amount = amount(number, texel);
            (0..3).for_each(|i| sum[i] += colour[i] * amount);
        }
        sum
    }
}

/// A light and its receivers on the grid, and the samples in passes.
#[derive(Clone, Debug, PartialEq)]
pub struct Prepared {
    /// Receivers in the order of the image, with their shifts.
    pub field: Field,
    /// Unit normals of length 2^15, of each receiver.
    pub normals: Vec<[i32; 3]>,
    /// What casts shadows, frame after frame.
    pub frames: Vec<Vec<Triangle>>,
    /// Which faces of that hide.
    pub faces: grid::Faces,
    /// The samples, pass after pass.
    pub passes: Vec<Pattern>,
    /// The colours of the light, and which of them each sample has.
    pub palette: Palette,
    /// Side of a cell, in scene units.
    pub cell: f64,
}

impl Prepared {
    /// Leaves out what other faces of closed surfaces make redundant, in every frame by itself.
    fn cull(&mut self) -> Work {
        let corners = self.corners();
        let crowd = Crowd::new(&self.field);
        let mut work = Work::default();
        for triangles in &mut self.frames {
            let Culled { kept, closed, dropped } = cull(&corners, &|extent| crowd.is_clear(extent), triangles);
            *triangles = kept;
            work += Work { closed, culled: dropped, ..Work::default() };
        }
        work
    }

    /// The corners of a rectangle that holds the samples of all passes, however they are shifted.
    fn corners(&self) -> [grid::Point; 4] {
        let receivers = || self.field.receivers().iter().filter(|receiver| receiver.is_there());
        let fold = |end: usize, axis: usize, pick: fn(i32, i32) -> i32| {
            let samples = self.passes.iter().map(|pass| pass.bounds()[end][axis]).reduce(pick).unwrap_or(0);
            samples + receivers().map(|receiver| receiver.shift[axis]).reduce(pick).unwrap_or(0)
        };
        let [x, y] = [0, 1].map(|axis| [fold(0, axis, i32::min), fold(1, axis, i32::max)]);
        [[x[0], y[0], 0], [x[1], y[0], 0], [x[0], y[1], 0], [x[1], y[1], 0]]
    }
}

/// Brings scene, light and receivers to the grid.
///
/// # Errors
///
/// A light, receivers or samples that make no sense or do not fit.
pub fn prepare(exposure: &Exposure) -> Result<Prepared> {
    let Exposure { light, resolution, sampling, .. } = exposure;
    if !matches!(sampling.bits, 31 | 32) {
        let what = format!("{} samples a word", sampling.bits);
        return Err(Place::default().element("word bits").error(what, "choose 31 or 32"));
    }
    let is_lit = |point: Point| light.at(point).is_some();
    let points = sampling.placement.points(sampling.count, sampling.seed, &is_lit)?;
    let words = points.len().div_ceil(sampling.bits as usize) as u64;
    if words * u64::from(*resolution).pow(2) > MAX_WORDS {
        let what = format!("{} samples for {resolution}² texels are too much", points.len());
        let remedy = format!("choose fewer samples or texels: at most {} MiB of sets fit", MAX_WORDS >> 18);
        return Err(Place::default().element("samples").error(what, remedy));
    }
    let Fitted { receivers, normals, frames, light: [corner, size], regular, cell } = fit(exposure)?;
    let along = |axis: usize, x: u32| corner[axis] + ((u64::from(x) * size[axis] as u64) >> 16) as i32;
    let stand = |p: &Point| [along(0, p[0]), along(1, p[1])];
    let samples = match regular {
        // The same grid as the one that row spans take.
        Some(regular) => (0..regular.count()).map(|s| [regular.at(s)[0], regular.at(s)[1]]).collect::<Vec<_>>(),
        None => points.iter().map(stand).collect(),
    };
    let passes = samples
        .chunks(sampling.pass())
        .map(|pass| Pattern::new(pass.to_vec(), sampling.bits))
        .collect::<Result<_, _>>()?;
    let colours: Vec<Colour> = points.iter().filter_map(|point| light.at(*point)).collect();
    let apart = ((size[0] as u64 * size[1] as u64) / points.len() as u64).isqrt().max(1) as u32;
    let shift = |receiver: u32| {
        let along = |axis: u32| random::below(apart, sampling.seed, 2 * receiver + axis) as i32 - apart as i32 / 2;
        if sampling.decorrelated { [along(0), along(1)] } else { [0, 0] }
    };
    let stands = |(index, at): (u32, &[i32; 3])| Receiver { at: *at, shift: shift(index) };
    let field = Field::new(*resolution, (0..).zip(&receivers).map(stands).collect())?;
    let palette = Palette::new(&colours, sampling.colours);
    let faces = exposure.faces.of_kernels();
    Ok(Prepared { field, normals, frames, faces, passes, palette, cell })
}

/// Exposes receivers to a light on `backend`; `progress` is called with the share of the work that is done, from 0 to
/// 1.
///
/// # Errors
///
/// What [`prepare`] refuses, and whatever the backend refuses.
pub fn expose(backend: &dyn Backend, exposure: &Exposure, progress: &mut dyn FnMut(f32)) -> Result<Exposed> {
    if let Some(request) = exposure.plain() {
        return Ok(plain(bake_with(backend, &request, &exposure.effort, progress)?, exposure));
    }
    let mut prepared = prepare(exposure)?;
    let mut exposed = empty(exposure, &prepared);
    if exposure.effort.cull && exposure.faces == Faces::Both {
        exposed.work += prepared.cull();
    }
    let runs = prepared.frames.len() * prepared.passes.len();
    for (number, triangles) in prepared.frames.iter().enumerate() {
        let mut first = 0;
        for (index, pattern) in prepared.passes.iter().enumerate() {
            let done = number * prepared.passes.len() + index;
            let mut part = |share: f32| progress((done as f32 + share) / runs as f32);
            let colours = &prepared.palette.of[first..first + pattern.count() as usize];
            let pass =
                Pass { prepared: &prepared, triangles, pattern, colours, first_word: first as u32 / pattern.bits() };
            pass.run(backend, exposure, &mut exposed, &mut part)?;
            first += pattern.count() as usize;
        }
    }
    conceal(&mut exposed);
    progress(1.0);
    Ok(exposed)
}

/// What [`bake`](super::bake) gives, as an exposure.
fn plain(baked: Bake, exposure: &Exposure) -> Exposed {
    let Bake { sets, visible, work } = baked;
    let [u, v] = [exposure.light.rect.u, exposure.light.rect.v].map(length);
    Exposed {
        is_there: vec![true; sets.texels()],
        colours: vec![WHITE],
        of: vec![0; sets.samples as usize],
        samples: vec![sets.samples],
        visible,
        light: Vec::new(),
        area: u * v,
        sets,
        work,
    }
}

/// Results that nothing has been added to.
fn empty(exposure: &Exposure, prepared: &Prepared) -> Exposed {
    let Prepared { field, passes, palette, cell, .. } = prepared;
    let (texels, colours) = (field.count() as usize, palette.colours.len());
    let mut samples = vec![0; colours];
    palette.of.iter().for_each(|colour| samples[*colour as usize] += prepared.frames.len() as u32);
    let words = passes.iter().map(Pattern::words).sum();
    let light = &exposure.light;
    let [u, v] = [light.rect.u, light.rect.v].map(length);
    Exposed {
        sets: Sets {
            resolution: exposure.resolution,
            samples: palette.of.len() as u32,
            bits: exposure.sampling.bits,
            words,
            masks: vec![0; texels * words as usize],
            samples_uv: passes.iter().flat_map(|pass| pass.points().iter().copied()).collect(),
            cell: *cell,
        },
        is_there: field.receivers().iter().map(Receiver::is_there).collect(),
        colours: palette.colours.clone(),
        of: palette.of.clone(),
        samples,
        visible: vec![0; colours * texels],
        light: vec![0; if exposure.light_sums { colours * texels } else { 0 }],
        area: u * v * light.lit_share(),
        work: Work::default(),
    }
}

/// From a texel without a receiver every sample is hidden.
fn conceal(exposed: &mut Exposed) {
    let Sets { samples, bits, words, masks, .. } = &mut exposed.sets;
    let all = |word: u32| u32::MAX >> (32 - (*samples - word * *bits).min(*bits));
    for (set, _) in masks.chunks_mut(*words as usize).zip(&exposed.is_there).filter(|(_, there)| !**there) {
        set.iter_mut().zip(0..).for_each(|(mask, word)| *mask = all(word));
    }
}

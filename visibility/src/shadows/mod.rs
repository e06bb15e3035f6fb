//! Soft shadows of area lights: for each texel of a receiver, the set of light samples that the scene hides from it.
//!
//! A [`Request`] is geometry and numbers, nothing of files or defaults; a [`Bake`] is the answer, its [`Sets`] exact on
//! the quantised scene. Bit `i % 32` of word `i / 32` of a texel is set iff sample `i` is hidden from it. A request is
//! of a white rectangle and a parallel plane; an [`Exposure`](expose::Exposure) is of any light and any receivers.

mod blue_noise;
pub(crate) mod compose;
pub mod cull;
pub mod expose;
pub mod filter;
mod fit;
pub mod light;
pub mod lightmap;
mod lists;
mod passes;
pub mod placement;
pub mod reading;
pub mod snap;
pub mod surface;

use std::ops::AddAssign;

use serde::Deserialize;
use sightlines_backend::{Backend, Counts};
use sightlines_kernels::grid;

use crate::error::Result;
use compose::Composed;
use snap::Snapped;

/// Numbers of light samples that can be baked.
pub const SAMPLES: [u32; 6] = [32, 64, 128, 256, 512, 1024];

/// Most texels a side.
pub const MAX_RESOLUTION: u32 = 8192;

/// Most words of all sets together: 2 GiB.
pub const MAX_WORDS: u64 = 1 << 29;

/// Bytes of the triangles' lists at a time, unless told otherwise.
pub const MEMORY: u64 = 64 << 20;

/// Most entries of the triangles' lists at a time: 128 MiB, which a binding holds.
const MOST_ENTRIES: u64 = 1 << 25;

/// A rectangle in space: `corner + s u + t v` for s and t in [0, 1], with u and v at right angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// The point s = t = 0.
    pub corner: [f64; 3],
    /// First side. On a receiver it is the direction of the columns of the image.
    pub u: [f64; 3],
    /// Second side. On a receiver it is the direction of the rows of the image.
    pub v: [f64; 3],
}

/// Which faces of the casters hide. The front of a triangle is where its vertices are seen counter-clockwise; a sample
/// that does not see a face that counts is not hidden by it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Faces {
    /// Either.
    #[default]
    Both,
    /// Fronts alone.
    Front,
    /// Backs alone.
    Back,
}

impl Faces {
    /// As kernels know them, which have triangles by [`Faces::turned`].
    pub(crate) fn of_kernels(self) -> grid::Faces {
        if self == Faces::Both { grid::Faces::Both } else { grid::Faces::Front }
    }

    /// A triangle whose front is the face that counts.
    fn turned<T>(self, [a, b, c]: [T; 3]) -> [T; 3] {
        if self == Faces::Back { [a, c, b] } else { [a, b, c] }
    }
}

/// What to bake.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Everything that casts a shadow, in scene units.
    pub triangles: Vec<[[f64; 3]; 3]>,
    /// Which faces of it hide.
    pub faces: Faces,
    /// The light; it shines along u × v.
    pub light: Rect,
    /// The receiver, sampled at the centres of `resolution` × `resolution` texels.
    pub receiver: Rect,
    /// Texels a side of the receiver.
    pub resolution: u32,
    /// Samples of the light: one of [`SAMPLES`].
    pub samples: u32,
}

/// How to bake. Whatever it says, the sets are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Leave out faces of closed surfaces that others make redundant.
    pub cull: bool,
    /// Bytes of the triangles' lists at a time; more triangles are taken in turns.
    pub memory: u64,
}

impl Effort {
    /// Entries of lists at a time.
    fn entries(&self) -> u64 {
        (self.memory / 4).clamp(1, MOST_ENTRIES)
    }
}

impl Default for Effort {
    fn default() -> Self {
        Effort { cull: true, memory: MEMORY }
    }
}

/// The hidden-sample sets of a receiver.
#[derive(Clone, Debug, PartialEq)]
pub struct Sets {
    /// Texels a side.
    pub resolution: u32,
    /// Samples of the light.
    pub samples: u32,
    /// Samples of a word: sample i is bit `i % bits` of word `i / bits`.
    pub bits: u32,
    /// Words of one texel's set.
    pub words: u32,
    /// The sets, row after row; `words` words a texel.
    pub masks: Vec<u32>,
    /// Where the samples stand, in grid cells in the frame of the light.
    pub samples_uv: Vec<[i32; 2]>,
    /// Side of a cell of the grid, in scene units.
    pub cell: f64,
}

impl Sets {
    /// Number of texels.
    pub fn texels(&self) -> usize {
        self.resolution as usize * self.resolution as usize
    }

    /// Whether a sample is hidden from a texel.
    pub fn is_hidden(&self, texel: usize, sample: u32) -> bool {
        let word = self.masks[texel * self.words as usize + (sample / self.bits) as usize];
        word >> (sample % self.bits) & 1 != 0
    }
}

/// What a light leaves of a receiver: the sets, their sizes, and the work that they took.
#[derive(Clone, Debug, PartialEq)]
pub struct Bake {
    /// Which samples are hidden from each texel.
    pub sets: Sets,
    /// Samples that each texel sees, row after row, as the device counts them.
    pub visible: Vec<u32>,
    /// What it took.
    pub work: Work,
}

/// The work of a bake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    /// Pairs of a triangle and a receiver in its influence region; a triangle that crosses the receivers' plane is
    /// paired with all of them. The same on every machine.
    pub pairs: u64,
    /// Triangles of closed surfaces.
    pub closed: u64,
    /// Triangles of closed surfaces that were left out.
    pub culled: u64,
    /// Bytes of all buffers of the session that has most. The same on every machine.
    pub bytes: u64,
    /// Lane-operations ([`Session::lane_ops`](sightlines_backend::Session::lane_ops)), from the interpreter.
    pub lane_ops: Option<u64>,
    /// Semantic costs of all kernels, from machines that are told to count them.
    pub counts: Option<Counts>,
}

impl Default for Work {
    /// No work, all of it counted.
    fn default() -> Self {
        Work { pairs: 0, closed: 0, culled: 0, bytes: 0, lane_ops: Some(0), counts: Some(Counts::default()) }
    }
}

impl AddAssign for Work {
    /// What one of the two did not count stays uncounted.
    fn add_assign(&mut self, more: Work) {
        self.pairs += more.pairs;
        self.closed += more.closed;
        self.culled += more.culled;
        self.bytes = self.bytes.max(more.bytes);
        self.lane_ops = self.lane_ops.zip(more.lane_ops).map(|(sum, more)| sum + more);
        self.counts = self.counts.zip(more.counts).map(|(mut sum, more)| {
            sum += more;
            sum
        });
    }
}

/// Bakes the sets on `backend`; `progress` is called with the share of the work that is done, from 0 to 1.
///
/// # Errors
///
/// A request whose geometry does not fit the grid ([`snap::snap`] lists why), and whatever the backend refuses.
pub fn bake(backend: &dyn Backend, request: &Request, progress: &mut dyn FnMut(f32)) -> Result<Bake> {
    bake_with(backend, request, &Effort::default(), progress)
}

/// [`bake`], as `effort` says.
///
/// # Errors
///
/// As of [`bake`].
pub fn bake_with(
    backend: &dyn Backend,
    request: &Request,
    effort: &Effort,
    progress: &mut dyn FnMut(f32),
) -> Result<Bake> {
    let mut scene = snap::snap(request)?;
    let mut work = Work::default();
    // What makes a face redundant is another that hides from its other side.
    if effort.cull && request.faces == Faces::Both {
        // Receivers are farther from the light than all that is between.
        let culled = cull::cull(&scene.samples.corners(), &|_| true, &scene.between);
        let cull::Culled { kept, closed, dropped } = culled;
        scene.between = kept;
        work += Work { closed, culled: dropped, ..Work::default() };
    }
    let mut composed = compose::bake(backend, &scene, effort.entries(), progress)?;
    composed.work += work;
    Ok(assemble(request, &scene, composed))
}

/// What the kernels give, in the order of the image.
pub(crate) fn assemble(request: &Request, scene: &Snapped, composed: Composed) -> Bake {
    let Composed { masks, visible, work } = composed;
    let (words, resolution) = (scene.samples.words(), request.resolution);
    let samples_uv = (0..request.samples).map(|sample| scene.samples.at(sample)).map(|[x, y, _]| [x, y]).collect();
    let upright = |words, planes| upright(planes, words as usize, resolution as usize, scene.mirrored);
    let masks = upright(words, masks);
    let sets = Sets { resolution, samples: request.samples, bits: 32, words, masks, samples_uv, cell: scene.cell };
    Bake { sets, visible: upright(1, visible), work }
}

/// The sets in the order of the image, whose columns and rows may run against the grid's axes.
pub(crate) fn upright(mut sets: Vec<u32>, words: usize, side: usize, [columns, rows]: [bool; 2]) -> Vec<u32> {
    for row in sets.chunks_mut(words * side).filter(|_| columns) {
        for column in 0..side / 2 {
            let (left, right) = row.split_at_mut((side - 1 - column) * words);
            left[column * words..(column + 1) * words].swap_with_slice(&mut right[..words]);
        }
    }
    for row in (0..side / 2).filter(|_| rows) {
        let (upper, lower) = sets.split_at_mut((side - 1 - row) * side * words);
        upper[row * side * words..(row + 1) * side * words].swap_with_slice(&mut lower[..side * words]);
    }
    sets
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mirrored_axes_are_turned() {
        // Two words a texel, three texels a side: texel (column, row) holds 10 row + column, twice.
        let sets: Vec<u32> = (0..9).flat_map(|i| [10 * (i / 3) + i % 3; 2]).collect();
        let at = |sets: &[u32], column: usize, row: usize| sets[2 * (3 * row + column)];
        let turned = upright(sets.clone(), 2, 3, [true, true]);
        assert_eq!((at(&turned, 0, 0), at(&turned, 2, 0), at(&turned, 1, 1), at(&turned, 0, 2)), (22, 20, 11, 2));
        assert_eq!(upright(sets.clone(), 2, 3, [false, false]), sets);
        let columns = upright(sets.clone(), 2, 3, [true, false]);
        assert_eq!((at(&columns, 0, 0), at(&columns, 2, 2)), (2, 20));
    }
}

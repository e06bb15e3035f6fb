//! What the kernel must give, from definitions alone: the masks by [`Pattern::hidden_set`], the cells of an exact table
//! by the extremes of all half-planes in them as fractions, and the paper's table by its texels.

use glam::IVec4;

use crate::backprojection::oracle::backproject;
use crate::exact::oracle::angle::atan2_bam;
use crate::exact::oracle::line::{Line, half_plane};
use crate::field::{Field, Receiver};
use crate::grid::{Faces, Point, Receivers, Triangle};
use crate::pattern::Pattern;
use crate::tiles::Tiles;

use super::axes;

/// Masks of all receivers by the definition: word w of receiver r at `w * receivers + r`.
pub fn sets(pattern: &Pattern, receivers: &Receivers, triangles: &[Triangle]) -> Vec<u32> {
    pattern.sets(receivers.count(), |receiver| pattern.hidden_set(receivers.at(receiver), triangles))
}

/// The same where a receiver has the triangles of its tile's list alone.
pub fn tile_sets(pattern: &Pattern, field: &Field, tiles: &Tiles, triangles: &[Triangle]) -> Vec<u32> {
    tile_sets_by(Faces::Both, pattern, field, tiles, triangles)
}

/// The same of triangles that hide by `faces`.
pub fn tile_sets_by(faces: Faces, pattern: &Pattern, field: &Field, tiles: &Tiles, triangles: &[Triangle]) -> Vec<u32> {
    pattern.sets(field.count(), |receiver| {
        let list = tiles.list(receiver % field.columns(), receiver / field.columns());
        field.hidden_set_by(faces, receiver, pattern, list.iter().map(|triangle| &triangles[*triangle as usize]))
    })
}

/// A mask of the samples for which `is_in` holds, about the pattern's centre.
fn mask(pattern: &Pattern, is_in: impl Fn(i32, i32) -> bool) -> Vec<u32> {
    let [x, y] = pattern.centre();
    let mut words = vec![0; pattern.words() as usize];
    for (sample, point) in (0..).zip(pattern.points()) {
        words[(sample / pattern.bits()) as usize] |=
            u32::from(is_in(point[0] - x, point[1] - y)) << (sample % pattern.bits());
    }
    words
}

/// The words of a cell of the exact table: samples strictly inside all its half-planes, then samples not outside all.
///
/// A half-plane of the cell is (1 - t) u + t v + o, with v negated in the second quadrant, for t in `directions` and o
/// in `offsets`, both in units of 2^-16 and widened by 2^-10 of a cell or by 2^-16, whichever is more.
pub fn cell(pattern: &Pattern, k: u32, cell: u32) -> Vec<u32> {
    const UNIT: i128 = 1 << 16;
    let slack = UNIT >> (k + 10).min(16);
    let width = UNIT >> k;
    let ends = |index: u32| {
        let low = i128::from(index) * width;
        [low - slack, low + width + slack]
    };
    let offsets = ends(cell & ((2 << k) - 1)).map(|o| (o - UNIT) << pattern.half_side_bits());
    let directions = ends(cell >> (k + 1) & ((1 << k) - 1));
    let is_mirrored = cell >> (2 * k + 1) != 0;
    let corners = move |u: i32, v: i32| {
        let (u, v) = (i128::from(u), i128::from(if is_mirrored { -v } else { v }));
        directions.map(|t| offsets.map(|o| (UNIT - t) * u + t * v + o)).into_iter().flatten().collect::<Vec<_>>()
    };
    let certain = mask(pattern, |u, v| corners(u, v).iter().all(|value| *value > 0));
    let possible = mask(pattern, |u, v| corners(u, v).iter().any(|value| *value >= 0));
    [certain, possible].concat()
}

/// The words of a texel of the paper's table with the given [`axes`]: the samples inside the half-plane of its centre.
pub fn texel(pattern: &Pattern, axes: &[IVec4], angle: usize, distance: usize) -> Vec<u32> {
    let line = Line { a: axes[angle].x, b: axes[angle].y, c: axes[distance].z.into() };
    mask(pattern, |u, v| half_plane(line, u, v))
}

/// The paper's mask of a half-plane of the centred pattern: all, none, or the one of the line's texel.
fn sampled(pattern: &Pattern, axes: &[IVec4], line: Line) -> Vec<u32> {
    let k = axes.len().ilog2();
    let (a, b, c) = (i128::from(line.a), i128::from(line.b), i128::from(line.c));
    let reach = (2 * (a * a + b * b)).isqrt() << pattern.half_side_bits();
    if c.abs() >= reach {
        return mask(pattern, |_, _| c >= 0);
    }
    let part = ((c.abs() << (k - 1)) / reach) as usize;
    let half = axes.len() / 2;
    let angle = atan2_bam(line.b, line.a) >> (32 - k);
    texel(pattern, axes, angle as usize, if c < 0 { half - 1 - part } else { half + part })
}

/// The mask that the paper's table with the given [`axes`] gives for one receiver.
pub fn sampled_set<'a>(
    pattern: &Pattern,
    axes: &[IVec4],
    receiver: &Receiver,
    triangles: impl IntoIterator<Item = &'a Triangle>,
) -> Vec<u32> {
    let ([x, y], shift) = (pattern.centre(), receiver.shift);
    let centred = |p: Point| [p[0] - x - shift[0], p[1] - y - shift[1], p[2]];
    let mut words = vec![0; pattern.words() as usize];
    for triangle in triangles.into_iter().filter(|_| receiver.is_there()) {
        let Some(found) = backproject(centred(receiver.at), &triangle.map(centred)) else { continue };
        let touches = triangle.iter().any(|v| v[2] <= 0);
        let in_source = touches && (found.own.a, found.own.b, found.own.c) == (0, 0, 0);
        let mut all = mask(pattern, |_, _| !in_source);
        for line in found.edges.into_iter().chain(touches.then_some(found.own)) {
            let inside = sampled(pattern, axes, line);
            all.iter_mut().zip(inside).for_each(|(word, inside)| *word &= inside);
        }
        words.iter_mut().zip(all).for_each(|(word, all)| *word |= all);
    }
    words
}

/// Masks of all receivers by the paper's table of 2^k angles and distances. A table that errs can take a triangle to
/// hide what it is too far from, so it matters which triangles a receiver is tried with: those of its tile's list.
pub fn sampled_sets(pattern: &Pattern, k: u32, field: &Field, tiles: &Tiles, triangles: &[Triangle]) -> Vec<u32> {
    let axes = axes(pattern.half_side_bits(), k);
    pattern.sets(field.count(), |receiver| {
        let list = tiles.list(receiver % field.columns(), receiver / field.columns());
        let list = list.iter().map(|triangle| &triangles[*triangle as usize]);
        sampled_set(pattern, &axes, &field.receivers()[receiver as usize], list)
    })
}

/// Bits that only the first of two maps has, and bits that only the second has.
pub fn differ(found: &[u32], truth: &[u32]) -> [u32; 2] {
    let only = |a: &[u32], b: &[u32]| a.iter().zip(b).map(|(a, b)| (a & !b).count_ones()).sum();
    [only(found, truth), only(truth, found)]
}

//! Where items are on the screen: rectangles of pixels and convex outlines, from the raster's own projection.
//!
//! A pixel is covered only if its centre lies among the vertices of a triangle on the screen, so bounds of projected
//! vertices, as the raster rounds them, hold every covered pixel exactly. Invariant: an item with a vertex behind the
//! near plane is bounded by the whole picture, since cut edges project elsewhere.

use glam::{IVec2, IVec4, UVec4};
use sightlines_kernels::raster::{CLIP, Picture, Placement, View};
use sightlines_kernels::region_sets::CORNERS;

use super::stage::{Batch, Stage};

/// Outlines are octagons where they are within this of the picture, else rectangles.
const REACH: i64 = 8192;

/// Bounds of an item's pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// First column and row, and one past the last of each; all 0 where no pixel is covered.
    pub rectangle: UVec4,
    /// Corners of a convex polygon around the pixels, in pixels from the top left.
    pub outline: [IVec2; CORNERS as usize],
    /// Least depth that a pixel may have.
    pub nearest: u32,
}

/// The bounds of every instance of a stage whose items are instances.
pub fn of(stage: &Stage) -> Vec<Bounds> {
    let bounds = |batch: &Batch| {
        let each = batch.placements.iter().map(|placement| of_instance(stage.frame.view, placement, &batch.vertices));
        each.collect::<Vec<_>>()
    };
    stage.batches.iter().flat_map(bounds).collect()
}

/// Least and greatest of the points on the screen, in 1/16 pixel, along x, y, x + y and x - y, and the least depth;
/// none where no vertex is in front.
pub(super) struct Extent {
    low: [i64; 4],
    high: [i64; 4],
    nearest: i64,
    crosses: bool,
}

/// The bounds of the vertices of one instance.
pub fn of_instance(view: View, placement: &Placement, vertices: &[[i32; 3]]) -> Bounds {
    let mut all = Extent { low: [i64::MAX; 4], high: [i64::MIN; 4], nearest: i64::MAX, crosses: false };
    let mut in_front = false;
    for vertex in vertices {
        match on_screen(view, &placement.rows, *vertex) {
            None => all.crosses = true,
            Some([x, y, depth]) => {
                in_front = true;
                let along = [x, y, x + y, x - y];
                all.low = [0, 1, 2, 3].map(|i| all.low[i].min(along[i]));
                all.high = [0, 1, 2, 3].map(|i| all.high[i].max(along[i]));
                all.nearest = all.nearest.min(depth);
            }
        }
    }
    match (in_front, all.crosses) {
        (false, _) => Bounds::EMPTY,
        (true, false) => all.bounds(view),
        (true, true) => Bounds::whole(view.picture),
    }
}

/// Steps 1 and 3 of the raster: x and y in 1/16 pixel and the depth of a vertex that is in front.
pub(super) fn on_screen(view: View, rows: &[IVec4; 4], v: [i32; 3]) -> Option<[i64; 3]> {
    let [x, y, z, w] = rows.map(|row| {
        let sum: i64 = (0..3).map(|i| i64::from(row[i]) * i64::from(v[i])).sum();
        ((sum >> 16) + i64::from(row.w)).clamp(-i64::from(CLIP), i64::from(CLIP))
    });
    let w = w.max(i64::from(view.near));
    let round = |n: i64| (2 * n + w).div_euclid(2 * w);
    let [width, height] = [view.picture.width, view.picture.height].map(i64::from);
    let depth = ((z << 24).div_euclid(w)).min((1 << 24) - 1);
    (z >= 0).then(|| [8 * width + round(8 * width * x), 8 * height + round(-8 * height * y), depth])
}

impl Bounds {
    /// Of nothing.
    pub const EMPTY: Bounds =
        Bounds { rectangle: UVec4::ZERO, outline: [IVec2::ZERO; CORNERS as usize], nearest: u32::MAX };

    /// Of anything in the picture.
    pub fn whole(Picture { width, height }: Picture) -> Self {
        Bounds {
            rectangle: UVec4::new(0, 0, width, height),
            outline: box_outline([0, 0, i64::from(width), i64::from(height)]),
            nearest: 0,
        }
    }

    /// Whether no pixel of the picture can be covered.
    pub fn is_empty(&self) -> bool {
        let UVec4 { x, y, z, w } = self.rectangle;
        x >= z || y >= w
    }
}

fn box_outline([x0, y0, x1, y1]: [i64; 4]) -> [IVec2; CORNERS as usize] {
    let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    [0, 0, 1, 1, 2, 2, 3, 3].map(|i: usize| IVec2::from(corners[i].map(|c| c as i32)))
}

impl Extent {
    fn bounds(&self, view: View) -> Bounds {
        // Pixel i has its centre at 16 i + 8.
        let first = |low: i64| (low + 7).div_euclid(16);
        let end = |high: i64| (high - 8).div_euclid(16) + 1;
        let [x0, y0] = [first(self.low[0]), first(self.low[1])];
        let [x1, y1] = [end(self.high[0]), end(self.high[1])];
        let cut = |at: i64, side: u32| at.clamp(0, i64::from(side));
        let [width, height] = [view.picture.width, view.picture.height];
        let shown = [cut(x0, width), cut(y0, height), cut(x1, width), cut(y1, height)];
        if shown[0] >= shown[2] || shown[1] >= shown[3] {
            return Bounds::EMPTY;
        }
        let rectangle = UVec4::from(shown.map(|edge| edge as u32));
        let near = [x0, y0, x1, y1].iter().all(|edge| edge.abs() < REACH);
        let outline = if near { self.octagon([x0, y0, x1, y1]) } else { box_outline(shown) };
        Bounds { rectangle, outline, nearest: self.nearest as u32 }
    }

    /// The rectangle with its corners cut off. A pixel's corners are within 1 of its centre along both diagonals.
    fn octagon(&self, [x0, y0, x1, y1]: [i64; 4]) -> [IVec2; CORNERS as usize] {
        let [least_sum, least_difference] = [2, 3].map(|i| self.low[i].div_euclid(16) - 1);
        let [most_sum, most_difference] = [2, 3].map(|i| (self.high[i] + 15).div_euclid(16) + 1);
        let corners = [
            [x0.max(least_sum - y0), y0],
            [x1.min(most_difference + y0), y0],
            [x1, y0.max(x1 - most_difference)],
            [x1, y1.min(most_sum - x1)],
            [x1.min(most_sum - y1), y1],
            [x0.max(least_difference + y1), y1],
            [x0, y1.min(x0 - least_difference)],
            [x0, y0.max(least_sum - x0)],
        ];
        corners.map(|corner| IVec2::from(corner.map(|c| c as i32)))
    }
}

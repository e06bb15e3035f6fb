//! Soft shadow maps: what the light's centre sees, as little patches whose backprojections on the light are added up.
//!
//! L. Atty, N. Holzschuch, M. Lapierre, J.-M. Hasenfratz, C. Hansen and F. Sillion, "Soft shadow maps: efficient
//! sampling of light source visibility" (2006), with which Eisemann and Décoret compare (section 8): rectangular
//! lights, planar receivers. A map of the casters' depths is drawn from the light's centre. Each texel that holds a
//! caster is a rectangle at that depth, parallel to the light; from a receiver it hides a rectangle of the light, and
//! what all patches hide is added. Wrong where patches overlap or leave gaps as seen from elsewhere than the centre,
//! where one caster is behind another as seen from it, and by the size of a texel. A plain baseline in f64, whose
//! result is not that of a kernel.

use sightlines_kernels::grid::{Receivers, Triangle};

use super::{Added, snapped};
use crate::error::Result;
use crate::shadows::snap::Snapped;
use crate::shadows::{Request, Work, upright};

/// A map of as many texels a side as there are receivers, by texels on the receivers' plane.
struct Map {
    side: u32,
    /// Where texel (0, 0) begins, and how large one is.
    origin: [f64; 2],
    texel: [f64; 2],
    /// The caster nearest to the light in each texel's centre, by its z; infinite where there is none.
    depths: Vec<f64>,
}

/// The light's rectangle on the grid.
struct Light {
    low: [f64; 2],
    high: [f64; 2],
    middle: [f64; 2],
}

impl Light {
    /// The rectangle of which the samples are the centres of the cells.
    fn new(scene: &Snapped) -> Self {
        let samples = &scene.samples;
        let size = [samples.columns, samples.rows];
        let low = [0, 1].map(|axis| f64::from(samples.origin[axis]) - f64::from(samples.step[axis]) / 2.0);
        let high = [0, 1].map(|axis| low[axis] + f64::from(samples.step[axis]) * f64::from(size[axis]));
        Light { low, high, middle: [0, 1].map(|axis| (low[axis] + high[axis]) / 2.0) }
    }

    fn area(&self) -> f64 {
        (self.high[0] - self.low[0]) * (self.high[1] - self.low[1])
    }
}

/// Counts by soft shadow maps: the samples that the part of the light that is left amounts to, rounded. Pairs are those
/// of a patch and a receiver that it hides something from.
///
/// # Errors
///
/// As [`projections`](super::projections).
pub fn maps(request: &Request, progress: &mut dyn FnMut(f32)) -> Result<Added> {
    let scene = snapped(request)?;
    let light = Light::new(&scene);
    let map = Map::draw(&scene, &light);
    let receivers = &scene.receivers;
    let mut hidden = vec![0.0; receivers.count() as usize];
    let mut pairs = 0;
    for row in 0..map.side {
        for column in 0..map.side {
            let z = map.depths[(row * map.side + column) as usize];
            if z.is_finite() {
                pairs += splat(receivers, &light, map.patch(column, row, z, &light, receivers), z, &mut hidden);
            }
        }
        progress((row + 1) as f32 / map.side as f32);
    }
    let samples = f64::from(request.samples);
    let left = |hidden: &f64| (samples * (1.0 - hidden / light.area()).max(0.0)).round() as u32;
    let visible = upright(hidden.iter().map(left).collect(), 1, request.resolution as usize, scene.mirrored);
    Ok(Added { visible, work: Work { pairs, lane_ops: None, counts: None, ..Work::default() } })
}

impl Map {
    fn draw(scene: &Snapped, light: &Light) -> Self {
        let receivers = &scene.receivers;
        let projected: Vec<[[f64; 3]; 3]> = scene.between.iter().map(|t| project(t, light, receivers)).collect();
        let side = receivers.columns;
        let bound = |axis: usize| {
            let along = || projected.iter().flatten().map(move |p| p[axis]);
            let size = [receivers.columns, receivers.rows][axis];
            let first = f64::from(receivers.origin[axis]);
            let width = f64::from(receivers.step[axis]) * f64::from(size);
            // Casters beside the receivers have penumbrae on them; what is farther away than they are wide has none to
            // speak of.
            let low = along().fold(f64::INFINITY, f64::min).max(first - width);
            [low, along().fold(f64::NEG_INFINITY, f64::max).min(first + 2.0 * width).max(low)]
        };
        let bounds = [bound(0), bound(1)];
        let texel = bounds.map(|[low, high]| (high - low).max(1.0) / f64::from(side));
        let origin = bounds.map(|[low, _]| low);
        let mut map = Map { side, origin, texel, depths: vec![f64::INFINITY; (side * side) as usize] };
        projected.iter().for_each(|triangle| map.fill(triangle));
        map
    }

    /// Keeps a triangle's depth in the texels whose centres it covers, where it is the nearest.
    fn fill(&mut self, [a, b, c]: &[[f64; 3]; 3]) {
        let edge = |p: &[f64; 3], q: &[f64; 3], x: f64, y: f64| (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
        let area = edge(a, b, c[0], c[1]);
        if area == 0.0 {
            return;
        }
        let range = |axis: usize| {
            let at = |x: f64| ((x - self.origin[axis]) / self.texel[axis]).clamp(0.0, f64::from(self.side)) as u32;
            at(a[axis].min(b[axis]).min(c[axis]))..(at(a[axis].max(b[axis]).max(c[axis])) + 1).min(self.side)
        };
        let (columns, rows) = (range(0), range(1));
        for row in rows {
            for column in columns.clone() {
                let [x, y] = self.corner(column, row, 0.5);
                let weights = [edge(b, c, x, y) / area, edge(c, a, x, y) / area, edge(a, b, x, y) / area];
                if weights.iter().all(|w| *w >= 0.0) {
                    // 1/z is what is linear on the receivers' plane.
                    let z = 1.0 / (weights[0] / a[2] + weights[1] / b[2] + weights[2] / c[2]);
                    let depth = &mut self.depths[(row * self.side + column) as usize];
                    *depth = depth.min(z);
                }
            }
        }
    }

    /// A point of a texel, `part` of its sides from its corner.
    fn corner(&self, column: u32, row: u32, part: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.origin[axis] + self.texel[axis] * (f64::from([column, row][axis]) + part))
    }

    /// The rectangle of a texel at depth z.
    fn patch(&self, column: u32, row: u32, z: f64, light: &Light, receivers: &Receivers) -> [[f64; 2]; 2] {
        let part = z / f64::from(receivers.height);
        let lifted = |p: [f64; 2]| [0, 1].map(|axis| light.middle[axis] + (p[axis] - light.middle[axis]) * part);
        [lifted(self.corner(column, row, 0.0)), lifted(self.corner(column, row, 1.0))]
    }
}

/// A triangle on the receivers' plane as the light's centre sees it, with its depths.
fn project(triangle: &Triangle, light: &Light, receivers: &Receivers) -> [[f64; 3]; 3] {
    triangle.map(|vertex| {
        let z = f64::from(vertex[2]);
        let grown = f64::from(receivers.height) / z;
        let [x, y] = [0, 1].map(|axis| light.middle[axis] + (f64::from(vertex[axis]) - light.middle[axis]) * grown);
        [x, y, z]
    })
}

/// Adds the area of the light that a patch hides from each receiver, and gives the number of those that it hides any
/// from.
fn splat(receivers: &Receivers, light: &Light, patch: [[f64; 2]; 2], z: f64, hidden: &mut [f64]) -> u64 {
    let height = f64::from(receivers.height);
    let below = height - z;
    // Along an axis: the receivers that see the patch before the light, and by how much of it.
    let along = |axis: usize| -> Vec<(u32, f64)> {
        let count = [receivers.columns, receivers.rows][axis];
        let (first, step) = (f64::from(receivers.origin[axis]), f64::from(receivers.step[axis]));
        let reach = |p: f64, s: f64| (((p * height - s * below) / z - first) / step).clamp(-1.0, f64::from(count));
        let low = reach(patch[0][axis], light.high[axis]).ceil().max(0.0) as u32;
        let high = reach(patch[1][axis], light.low[axis]).floor() + 1.0;
        (low..high.clamp(0.0, f64::from(count)) as u32)
            .map(|index| {
                let at = first + step * f64::from(index);
                let seen = |p: f64| (p * height - at * z) / below;
                let part = seen(patch[1][axis]).min(light.high[axis]) - seen(patch[0][axis]).max(light.low[axis]);
                (index, part.max(0.0))
            })
            .collect()
    };
    let (columns, rows) = (along(0), along(1));
    for (row, high) in &rows {
        for (column, wide) in &columns {
            hidden[(row * receivers.columns + column) as usize] += wide * high;
        }
    }
    columns.len() as u64 * rows.len() as u64
}

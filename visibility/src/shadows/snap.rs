//! From scene units to the grid: the one place where a scene is rounded.
//!
//! Axes follow the light: x along its first side, y along its second, z where it shines, the light at z = 0. The side
//! of a cell is the distance of two texel centres divided by the largest whole number that lets everything fit, so
//! receivers are exact. Triangles are cut at the light's plane, vertices go to the nearest grid point; the samples'
//! distance and the receivers' height become whole cells. After this only integers decide ([`sightlines_kernels::grid`]
//! has the definition).

use sightlines_kernels::grid::{Faces, Receivers, Samples, Triangle, XY, Z};

use super::{Rect, Request, SAMPLES};
use crate::error::{Place, Result};
use crate::vector::{Vector, cross, dot, length, scale, sub};

/// A scene on the grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapped {
    /// The light's samples.
    pub samples: Samples,
    /// The light's rectangle: its corner and its size, in cells.
    pub light: [[i32; 2]; 2],
    /// The receivers, in ascending x and y.
    pub receivers: Receivers,
    /// Whether columns of the image run against x, and rows against y.
    pub mirrored: [bool; 2],
    /// Triangles strictly between light and receivers.
    pub between: Vec<Triangle>,
    /// Triangles that reach one of the two planes and stand between them in part.
    pub crossing: Vec<Triangle>,
    /// Which faces of them hide.
    pub faces: Faces,
    /// Side of a cell, in scene units.
    pub cell: f64,
}

pub(super) fn refuse<T>(what: impl Into<String>, remedy: &str) -> Result<T> {
    Err(Place::default().error(what, remedy))
}

/// The frame of a light.
pub(super) struct Frame {
    corner: Vector,
    axes: [Vector; 3],
}

impl Frame {
    pub(super) fn new(light: &Rect) -> Result<Self> {
        let (u, v) = (length(light.u), length(light.v));
        let normal = cross(light.u, light.v);
        let area = length(normal);
        let usable = [u, v, area].iter().all(|x| x.is_finite() && *x > 0.0);
        if !usable || dot(light.u, light.v).abs() > 1e-9 * u * v {
            return refuse(
                format!("a light with sides {:?} and {:?}", light.u, light.v),
                "give it two sides at right angles",
            );
        }
        let axes = [scale(light.u, 1.0 / u), scale(light.v, 1.0 / v), scale(normal, 1.0 / area)];
        Ok(Frame { corner: light.corner, axes })
    }

    pub(super) fn point(&self, p: Vector) -> Vector {
        let p = sub(p, self.corner);
        self.axes.map(|axis| dot(axis, p))
    }

    pub(super) fn direction(&self, d: Vector) -> Vector {
        self.axes.map(|axis| dot(axis, d))
    }
}

/// An axis of the receivers in the frame: smallest texel centre, distance of texels, and whether columns run against
/// it.
struct Axis {
    first: f64,
    pitch: f64,
    mirrored: bool,
}

impl Axis {
    fn new(start: f64, side: f64, count: u32) -> Self {
        let pitch = side.abs() / f64::from(count);
        Axis { first: start.min(start + side) + pitch / 2.0, pitch, mirrored: side < 0.0 }
    }

    fn last(&self, count: u32) -> f64 {
        self.first + self.pitch * f64::from(count - 1)
    }
}

/// Columns and rows of a light's samples.
fn shape(samples: u32) -> (u32, u32) {
    let columns = 1 << samples.ilog2().div_ceil(2);
    // 32 samples are 8 by 4.
    (columns, samples / columns)
}

/// Snaps a request's scene.
///
/// # Errors
///
/// A light or receiver without area, a receiver that is not parallel to the light or lies behind it, and a scene that
/// does not fit the grid at this resolution.
pub fn snap(request: &Request) -> Result<Snapped> {
    if !SAMPLES.contains(&request.samples) {
        let what = format!("{} samples cannot be baked by row spans", request.samples);
        return refuse(what, "choose one of 32, 64, 128, 256, 512 and 1024");
    }
    let frame = Frame::new(&request.light)?;
    let Request { resolution, receiver, light, .. } = request;
    let start = frame.point(receiver.corner);
    let (u, v) = (frame.direction(receiver.u), frame.direction(receiver.v));
    let height = start[2];
    if !is_aligned(&frame, receiver) {
        return refuse(
            "the receiver is not aligned with the light",
            "make its sides parallel to the light's sides, in order",
        );
    }
    if height.is_nan() || height <= 0.0 {
        return refuse(
            "the receiver does not lie in front of the light",
            "move the light, or turn it: it shines along u x v",
        );
    }
    let axes = [Axis::new(start[0], u[0], *resolution), Axis::new(start[1], v[1], *resolution)];
    let sides = [length(light.u), length(light.v)];
    let lows: [f64; 2] = std::array::from_fn(|i| axes[i].first.min(0.0));
    let highs: [f64; 2] = std::array::from_fn(|i| axes[i].last(*resolution).max(sides[i]));
    let relevant = |t: &[Vector; 3]| {
        let reaches = |i: usize| t.iter().any(|p| p[i] <= highs[i]) && t.iter().any(|p| p[i] >= lows[i]);
        reaches(0) && reaches(1) && t.iter().any(|p| p[2] > 0.0) && t.iter().any(|p| p[2] < height)
    };
    let framed = request.triangles.iter().map(|t| request.faces.turned(t.map(|p| frame.point(p))));
    let triangles: Vec<[Vector; 3]> = framed.flat_map(cut).filter(relevant).collect();
    let fit = Fit::new(&axes, *resolution, [lows, highs], height, &triangles)?;
    fit.scene(request, &axes, sides, height, &triangles)
}

/// Whether a receiver's sides run along those of a light, in order.
pub(super) fn is_aligned(frame: &Frame, receiver: &Rect) -> bool {
    let (u, v) = (frame.direction(receiver.u), frame.direction(receiver.v));
    let tolerance = 1e-9 * (length(u) + length(v));
    [u[1], u[2], v[0], v[2]].iter().all(|x| x.abs() <= tolerance) && u[0] != 0.0 && v[1] != 0.0
}

/// Cells of the grid in the frame: where its origin is and how large a cell.
struct Fit {
    cell: f64,
    /// Texel distance along x, in cells.
    step: i32,
    /// Frame coordinates and cell of texel 0.
    anchor: [f64; 2],
    at: [i32; 2],
}

impl Fit {
    fn new(
        axes: &[Axis; 2],
        resolution: u32,
        [lows, highs]: [[f64; 2]; 2],
        height: f64,
        triangles: &[[Vector; 3]],
    ) -> Result<Self> {
        let points = || triangles.iter().flatten();
        let low: [f64; 2] = std::array::from_fn(|i| points().fold(lows[i], |m, p| m.min(p[i])));
        let high: [f64; 2] = std::array::from_fn(|i| points().fold(highs[i], |m, p| m.max(p[i])));
        let deep = points().fold(height, |m, p| m.max(p[2]));
        // Two cells are left for rounding at either end.
        let cell = ((high[0] - low[0]).max(high[1] - low[1]) / f64::from(2 * XY - 4)).max(deep / f64::from(Z - 2));
        // A single texel has no neighbour that whole cells must reach.
        let steps = if resolution == 1 { 1.0 } else { (axes[0].pitch / cell).floor() };
        if steps < 1.0 {
            let what = format!("a scene of {:.6} by {:.6} by {deep:.6} units", high[0] - low[0], high[1] - low[1]);
            let what =
                format!("{what} has cells of {cell:.6} units on the grid, and texels are {:.6} apart", axes[0].pitch);
            return refuse(what, "lower the resolution, or bring receiver, light and casters closer together");
        }
        let cell = if resolution == 1 { cell } else { axes[0].pitch / steps };
        let anchor = [axes[0].first, axes[1].first];
        let middle: [f64; 2] = std::array::from_fn(|i| (low[i] + high[i]) / 2.0);
        let at = std::array::from_fn(|i| ((anchor[i] - middle[i]) / cell).round() as i32);
        Ok(Fit { cell, step: steps as i32, anchor, at })
    }

    fn xy(&self, axis: usize, coordinate: f64) -> i32 {
        self.at[axis] + ((coordinate - self.anchor[axis]) / self.cell).round() as i32
    }

    fn point(&self, p: Vector) -> [i32; 3] {
        [self.xy(0, p[0]), self.xy(1, p[1]), (p[2] / self.cell).round() as i32]
    }

    fn scene(
        &self,
        request: &Request,
        axes: &[Axis; 2],
        sides: [f64; 2],
        height: f64,
        triangles: &[[Vector; 3]],
    ) -> Result<Snapped> {
        let whole = |length: f64| ((length / self.cell).round() as i32).max(1);
        let (columns, rows) = shape(request.samples);
        let apart = [sides[0] / f64::from(columns), sides[1] / f64::from(rows)];
        if apart.iter().any(|apart| apart / self.cell < 0.5) {
            let [x, y] = apart;
            let what = format!("light samples {x:.3e} by {y:.3e} units apart, and cells of {:.3e} units", self.cell);
            return refuse(what, "enlarge the light, take fewer samples, or bring receiver and casters closer to it");
        }
        let step = apart.map(whole);
        let first = |i: usize, count: u32| self.xy(i, sides[i] / 2.0) - step[i] * (count as i32 - 1) / 2;
        let samples = Samples { origin: [first(0, columns), first(1, rows)], step, columns, rows };
        let receivers = Receivers {
            origin: self.at,
            step: [self.step, if request.resolution == 1 { 1 } else { whole(axes[1].pitch) }],
            height: whole(height),
            columns: request.resolution,
            rows: request.resolution,
        };
        samples.check()?;
        receivers.check()?;
        let corner = [self.xy(0, 0.0), self.xy(1, 0.0)];
        let light = [corner, std::array::from_fn(|i| self.xy(i, sides[i]) - corner[i])];
        let mut snapped = Snapped {
            samples,
            light,
            receivers,
            mirrored: [axes[0].mirrored, axes[1].mirrored],
            between: Vec::new(),
            crossing: Vec::new(),
            faces: request.faces.of_kernels(),
            cell: self.cell,
        };
        for triangle in triangles {
            snapped.add(triangle.map(|p| self.point(p)));
        }
        Ok(snapped)
    }
}

impl Snapped {
    fn add(&mut self, triangle: Triangle) {
        let height = self.receivers.height;
        let z = triangle.map(|p| p[2]);
        if z.iter().all(|z| *z <= 0) || z.iter().all(|z| *z >= height) {
            return;
        }
        let between = z.iter().all(|z| (1..height).contains(z));
        if between { self.between.push(triangle) } else { self.crossing.push(triangle) }
    }
}

/// The part of a triangle in front of the light's plane, as none, one or two triangles, in the frame of the light.
/// Triangles that share an edge are cut at one point of it, so that no gap opens between them.
pub(super) fn cut(triangle: [Vector; 3]) -> impl Iterator<Item = [Vector; 3]> {
    let edges = [0, 1, 2].map(|i| (triangle[i], triangle[(i + 1) % 3]));
    let meet = |front: Vector, back: Vector| {
        let part = front[2] / (front[2] - back[2]);
        let [x, y] = [0, 1].map(|i| front[i] + (back[i] - front[i]) * part);
        [x, y, 0.0]
    };
    let corners: Vec<Vector> = edges
        .into_iter()
        .flat_map(|(a, b)| match (a[2] >= 0.0, b[2] >= 0.0) {
            (true, true) => [Some(a), None],
            (true, false) => [Some(a), Some(meet(a, b))],
            (false, true) => [None, Some(meet(b, a))],
            (false, false) => [None, None],
        })
        .flatten()
        .collect();
    (2..corners.len()).map(move |i| [corners[0], corners[i - 1], corners[i]])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(triangles: Vec<[Vector; 3]>) -> Request {
        Request {
            triangles,
            faces: Default::default(),
            light: Rect { corner: [-0.2, 3.0, -0.2], u: [0.4, 0.0, 0.0], v: [0.0, 0.0, 0.4] },
            receiver: Rect { corner: [-2.0, 0.0, 2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, -4.0] },
            resolution: 512,
            samples: 1024,
        }
    }

    #[test]
    fn the_default_arrangement_fills_the_grid() {
        let snapped = snap(&request(vec![[[0.0, 1.0, 0.0], [0.1, 1.0, 0.0], [0.0, 1.0, 0.1]]])).unwrap();
        assert_eq!(snapped.receivers.step, [64, 64]);
        assert_eq!(snapped.receivers.height, 24_576);
        assert_eq!(snapped.mirrored, [false, true]);
        assert_eq!((snapped.between.len(), snapped.crossing.len()), (1, 0));
        // The light's samples stand symmetrically over the receivers, up to a cell.
        let (s, r) = (snapped.samples, snapped.receivers);
        for axis in 0..2 {
            let light = 2 * s.origin[axis] + 31 * s.step[axis];
            let floor = 2 * r.origin[axis] + 511 * r.step[axis];
            assert!((light - floor).abs() <= 2, "{light} and {floor}");
        }
    }

    #[test]
    fn one_texel_and_two_fit_the_grid_too() {
        let casts = [[0.0, 1.0, 0.0], [0.1, 1.0, 0.0], [0.0, 1.0, 0.1]];
        let snapped = |resolution, v| {
            let receiver = Rect { v, ..request(vec![]).receiver };
            snap(&Request { resolution, receiver, ..request(vec![casts]) }).unwrap()
        };
        assert_eq!(snapped(1, [0.0, 0.0, -4.0]).receivers.step, [1, 1]);
        assert_eq!(snapped(1, [0.0, 0.0, -40.0]).receivers.step, [1, 1]);
        let two = snapped(2, [0.0, 0.0, -4.0]);
        assert_eq!((two.receivers.step, two.between.len()), ([21844, 21844], 1));
        let last = two.receivers.at(3);
        assert_eq!([last[0] - two.receivers.origin[0], last[1] - two.receivers.origin[1]], [21844; 2]);
    }

    #[test]
    fn a_light_smaller_than_the_grid_can_show_is_refused() {
        let small = |side: f64| {
            let light = Rect { u: [side, 0.0, 0.0], ..request(vec![]).light };
            snap(&Request { light, ..request(vec![]) })
        };
        let message = small(1e-6).unwrap_err().to_string();
        assert!(message.contains("3.125e-8 by") && message.contains("enlarge the light"), "{message}");
        assert_eq!(small(0.02).unwrap().samples.step[0], 5);
    }

    #[test]
    fn what_cannot_hide_anything_is_left_out() {
        let below = [[0.0, -1.0, 0.0], [0.1, -1.0, 0.0], [0.0, -1.0, 0.1]];
        let above = [[0.0, 4.0, 0.0], [0.1, 4.0, 0.0], [0.0, 4.0, 0.1]];
        let aside = [[9.0, 1.0, 0.0], [9.1, 1.0, 0.0], [9.0, 1.0, 0.1]];
        let snapped = snap(&request(vec![below, above, aside])).unwrap();
        assert_eq!((snapped.between.len(), snapped.crossing.len()), (0, 0));
    }

    #[test]
    fn geometry_through_either_plane() {
        let floor = [[0.0, 1.0, 0.0], [0.1, -0.5, 0.0], [0.0, 1.0, 0.1]];
        assert_eq!(snap(&request(vec![floor])).unwrap().crossing.len(), 1);
        // What reaches through the light's plane is cut there: a corner behind leaves two triangles, two leave one.
        for (behind, left) in [([3.0 + 0.5, 1.0, 1.0], 2), ([3.5, 1.0, 4.0], 1), ([3.5, 3.1, 4.0], 0)] {
            let light = [[0.0, behind[0], 0.0], [0.1, behind[1], 0.0], [0.0, behind[2], 0.1]];
            let snapped = snap(&request(vec![light])).unwrap();
            assert_eq!(snapped.crossing.len(), left, "{behind:?}");
            assert!(snapped.crossing.as_flattened().iter().all(|p| (0..Z).contains(&p[2])));
        }
    }

    #[test]
    fn triangles_that_share_an_edge_are_cut_at_one_point_of_it() {
        let (a, b) = ([0.1, 0.7, 0.9], [5.3, -1.1, -0.3]);
        let cuts = [[a, b, [3.0, 2.0, 1.0]], [b, a, [-3.0, 2.0, 1.0]], [[1.0, 1.0, -4.0], a, b]].map(|t| {
            let corners: Vec<Vector> = cut(t).flatten().filter(|p| p[2] == 0.0).collect();
            corners
        });
        assert!(cuts[1..].iter().all(|corners| corners.iter().any(|p| cuts[0].contains(p))), "{cuts:?}");
    }

    #[test]
    fn arrangements_that_make_no_sense_are_refused() {
        let turned = Request {
            light: Rect { u: [0.0, 0.0, 0.4], v: [0.4, 0.0, 0.0], ..request(vec![]).light },
            ..request(vec![])
        };
        assert!(snap(&turned).unwrap_err().to_string().contains("remedy"));
        let odd = snap(&Request { samples: 37, ..request(vec![]) }).unwrap_err().to_string();
        assert!(odd.contains("37 samples cannot be baked by row spans"), "{odd}");
        let tilted = Request { receiver: Rect { v: [0.0, 0.5, -4.0], ..request(vec![]).receiver }, ..request(vec![]) };
        assert!(snap(&tilted).unwrap_err().to_string().contains("aligned"));
        let flat = Request { light: Rect { v: [0.4, 0.0, 0.0], ..request(vec![]).light }, ..request(vec![]) };
        assert!(snap(&flat).unwrap_err().to_string().contains("right angles"));
    }

    #[test]
    fn shapes_of_lights() {
        assert_eq!([32, 64, 128, 256, 512, 1024].map(shape), [(8, 4), (8, 8), (16, 8), (16, 16), (32, 16), (32, 32)]);
    }
}

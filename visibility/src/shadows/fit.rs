//! Any receivers on the grid of a light: the one place where such a scene is rounded.
//!
//! A plane along the light is [`snap`](super::snap)'s, whose receivers fall on the grid exactly. Else the cell is the
//! least that lets light, receivers and casters fit, and all go to the nearest grid point; receivers of a lightmap or a
//! relief are moved by their bias first. Receivers that are not in front of the light are none. Triangles are cut at
//! the light's plane before they are rounded.

use sightlines_kernels::grid::{Samples, Triangle, XY, Z};
use sightlines_kernels::irradiance::UNIT;

use super::expose::Exposure;
use super::light::Form;
use super::lightmap::BIAS;
use super::placement::Placement;
use super::snap::{Frame, cut, is_aligned, refuse, snap};
use super::surface::{Spot, Surface, check_area};
use super::{Rect, Request, SAMPLES};
use crate::error::Result;
use crate::vector::{Vector, add, length, scale};

/// Cells left for rounding and bias at either end.
const MARGIN: f64 = 4.0;

/// An exposure on the grid.
pub(super) struct Fitted {
    /// Receivers in the order of the image; z = 0 where there is none.
    pub(super) receivers: Vec<[i32; 3]>,
    /// Normals of length 2^15, towards the side that receives.
    pub(super) normals: Vec<[i32; 3]>,
    /// What casts shadows, frame after frame.
    pub(super) frames: Vec<Vec<Triangle>>,
    /// The light's corner and size.
    pub(super) light: [[i32; 2]; 2],
    /// The samples, where row spans would take them so.
    pub(super) regular: Option<Samples>,
    /// Side of a cell, in scene units.
    pub(super) cell: f64,
}

pub(super) fn fit(exposure: &Exposure) -> Result<Fitted> {
    let frame = Frame::new(&exposure.light.rect)?;
    match &exposure.surface {
        Surface::Plane(rect)
            if exposure.is_at_rest() && is_aligned(&frame, rect) && !exposure.sampling.decorrelated =>
        {
            parallel(exposure, rect)
        }
        Surface::Plane(rect) | Surface::Heights(rect, _) | Surface::Relief(rect, _) | Surface::View(rect, _) => {
            check_area(rect, "receiver")?;
            nearest(exposure, &frame)
        }
        Surface::Lightmap(_) => nearest(exposure, &frame),
    }
}

fn parallel(exposure: &Exposure, receiver: &Rect) -> Result<Fitted> {
    let Exposure { triangles, faces, light, resolution, sampling, .. } = exposure;
    let is_regular =
        SAMPLES.contains(&sampling.count) && sampling.placement == Placement::Grid && light.form == Form::Whole;
    let samples = if is_regular { sampling.count } else { SAMPLES[0] };
    let request = Request {
        triangles: triangles.clone(),
        faces: *faces,
        light: light.rect,
        receiver: *receiver,
        resolution: *resolution,
        samples,
    };
    let mut snapped = snap(&request)?;
    let side = snapped.receivers.columns;
    let turned = |at: u32, mirrored: bool| if mirrored { side - 1 - at } else { at };
    let at = |texel: u32| {
        let (column, row) = (turned(texel % side, snapped.mirrored[0]), turned(texel / side, snapped.mirrored[1]));
        snapped.receivers.at(row * side + column)
    };
    let receivers: Vec<[i32; 3]> = (0..side * side).map(at).collect();
    snapped.between.append(&mut snapped.crossing);
    Ok(Fitted {
        normals: vec![[0, 0, -UNIT]; receivers.len()],
        receivers,
        frames: vec![snapped.between],
        light: snapped.light,
        regular: is_regular.then_some(snapped.samples),
        cell: snapped.cell,
    })
}

/// Least and greatest of points and of triangles that can matter to them, in the frame of the light.
struct Extent {
    low: Vector,
    high: Vector,
}

impl Extent {
    fn hold(&mut self, p: Vector) {
        self.low = std::array::from_fn(|axis| self.low[axis].min(p[axis]));
        self.high = std::array::from_fn(|axis| self.high[axis].max(p[axis]));
    }

    /// Whether a triangle may come between points of it.
    fn meets(&self, t: &[Vector; 3]) -> bool {
        let reaches =
            |axis: usize| t.iter().any(|p| p[axis] <= self.high[axis]) && t.iter().any(|p| p[axis] >= self.low[axis]);
        reaches(0) && reaches(1) && t.iter().any(|p| p[2] > 0.0) && t.iter().any(|p| p[2] < self.high[2])
    }
}

fn nearest(exposure: &Exposure, frame: &Frame) -> Result<Fitted> {
    let Exposure { light, sampling, .. } = exposure;
    let sides = [length(light.rect.u), length(light.rect.v)];
    // Half of what one sample is from the next, and so as far as a pattern is shifted.
    let apart = (sides[0] * sides[1] / f64::from(sampling.count)).sqrt();
    let reach = if sampling.decorrelated { apart } else { 0.0 };
    let spots = exposure.surface.spots(exposure.resolution, &light.rect)?;
    let seen = |spot: &Spot| Spot { at: frame.point(spot.at), normal: frame.direction(spot.normal) };
    let spots: Vec<Option<Spot>> =
        spots.iter().map(|spot| spot.as_ref().map(seen).filter(|spot| spot.at[2] > 0.0)).collect();
    let mut extent = Extent { low: [-reach, -reach, 0.0], high: [sides[0] + reach, sides[1] + reach, 0.0] };
    spots.iter().flatten().for_each(|spot| extent.hold(spot.at));
    if extent.high[2] <= 0.0 {
        return refuse("no receiver lies in front of the light", "move the light, or turn it: it shines along u x v");
    }
    let frames: Vec<Vec<[Vector; 3]>> = exposure
        .frames()?
        .map(|triangles| triangles.map(|t| exposure.faces.turned(t.map(|p| frame.point(p)))))
        .map(|triangles| triangles.flat_map(cut).filter(|t| extent.meets(t)).collect())
        .collect();
    frames.iter().flatten().flatten().for_each(|p| extent.hold(*p));
    let size = |axis: usize| extent.high[axis] - extent.low[axis];
    let cell =
        (size(0).max(size(1)) / (f64::from(2 * XY) - 2.0 * MARGIN)).max(extent.high[2] / (f64::from(Z) - MARGIN));
    if apart / cell < 0.5 {
        let what = format!("light samples {apart:.3e} units apart, and cells of {cell:.3e} units");
        return refuse(what, "enlarge the light, take fewer samples, or bring receiver and casters closer to it");
    }
    let middle = [0, 1].map(|axis| (extent.low[axis] + extent.high[axis]) / 2.0);
    let xy = |axis: usize, x: f64| ((x - middle[axis]) / cell).round() as i32;
    let point = |p: Vector| [xy(0, p[0]), xy(1, p[1]), (p[2] / cell).round() as i32];
    let is_biased = matches!(exposure.surface, Surface::Lightmap(_) | Surface::Relief(..));
    let bias = if is_biased { BIAS * cell } else { 0.0 };
    let stand = |spot: &Option<Spot>| match spot {
        Some(Spot { at, normal }) => point(add(*at, scale(*normal, bias))),
        None => [0; 3],
    };
    let mut receivers: Vec<[i32; 3]> = spots.iter().map(stand).collect();
    receivers.iter_mut().filter(|at| at[2] <= 0).for_each(|at| *at = [0; 3]);
    let normal = |spot: &Option<Spot>| spot.map_or([0; 3], |spot| spot.normal.map(|n| (n * f64::from(UNIT)) as i32));
    let corner = [xy(0, 0.0), xy(1, 0.0)];
    let hides = |t: &Triangle| t.iter().any(|p| p[2] > 0);
    Ok(Fitted {
        normals: spots.iter().map(normal).collect(),
        receivers,
        frames: frames.iter().map(|frame| frame.iter().map(|t| t.map(point)).filter(hides).collect()).collect(),
        light: [corner, [0, 1].map(|axis| (xy(axis, sides[axis]) - corner[axis]).max(1))],
        regular: None,
        cell,
    })
}

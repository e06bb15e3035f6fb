//! Light from far away: a latitude–longitude map of an environment, and what of it each direction brings.
//!
//! "Ambient occlusion by occlusion queries", section 5: the map is filtered with a Gaussian and looked up at the
//! light's directions; turning the environment turns the look-ups, and no visibility changes. Maps follow the usual
//! convention: seen from inside, the middle column looks along −z with +x to its right and +y up, where y is up. Maps
//! are brought to at most 512 columns by averaging areas before they go to the device. Invariant: what reaches the
//! device is integers, made in IEEE f64 and `libm` from finite texels that are not negative.

use glam::{IVec4, UVec4};
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job};
use sightlines_kernels::illumination::{
    Fixed, Illumination, MAX_RADIUS, Shape, colour_shift, gaussian_taps, scaled_weights,
};
use sightlines_kernels::light_sphere::{LightSphere, Rotation};

use super::sphere::{Sphere, Weighting};
use crate::error::{Place, Result};
use crate::setup::Up;
use crate::vector::Vector;

/// Columns that a map is brought down to.
const COLUMNS: u32 = 512;

/// A latitude–longitude map.
#[derive(Clone, Debug, PartialEq)]
pub struct Environment {
    /// Columns.
    pub width: u32,
    /// Rows, the zenith first.
    pub height: u32,
    /// Linear red, green and blue, row after row.
    pub texels: Vec<[f32; 3]>,
}

/// How an environment is applied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lighting {
    /// The axis of the scene that points up.
    pub up: Up,
    /// Degrees by which the environment is turned about that axis, counter-clockwise as seen from above.
    pub turn: f64,
    /// Standard deviation of the Gaussian, in degrees; 0 for none. Nothing: half the spacing of the directions.
    pub blur: Option<f64>,
    /// How directions are weighed.
    pub weighting: Weighting,
}

/// What each direction of a sphere brings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Intensities {
    /// The directions, of length 2^15.
    pub units: Vec<[i32; 3]>,
    /// Red, green and blue in fixed point; the fourth word is 0.
    pub values: Vec<[u32; 4]>,
    /// Shift of each channel of the colours that they make.
    pub shift: [i32; 3],
    /// For each channel, texels that are not black and became so in fixed point.
    pub lost: [u32; 3],
}

impl Intensities {
    /// Nothing from `count` directions.
    pub(super) fn dark(count: usize) -> Self {
        Intensities { units: vec![[0; 3]; count], values: vec![[0; 4]; count], shift: [0; 3], lost: [0; 3] }
    }
}

impl Environment {
    /// One everywhere: what is left of it is plain ambient occlusion.
    pub fn white() -> Self {
        Environment { width: 1, height: 1, texels: vec![[1.0; 3]] }
    }

    /// A clear sky with a low sun over a brown ground.
    pub fn sky() -> Self {
        let (width, height) = (256, 128);
        let texel = |i: u32| {
            let (row, column) = (i / width, i % width);
            let d = direction_at([column, row], [width, height]);
            // The sun is 14 degrees wide, 35 degrees up, to the right of the middle.
            let sun = [0.656, 0.574, -0.490];
            let towards = (0..3).map(|axis| d[axis] * sun[axis]).sum::<f64>();
            let glow = if towards > 0.9925 { 90.0 } else { (towards.max(0.0) * towards.max(0.0)) * 0.25 };
            let high = d[1].max(0.0);
            let base = if d[1] < 0.0 { [0.16, 0.12, 0.09] } else { [0.75 - 0.55 * high, 0.85 - 0.45 * high, 1.0] };
            [base[0] + glow, base[1] + 0.85 * glow, base[2] + 0.6 * glow].map(|c| c as f32)
        };
        Environment { width, height, texels: (0..width * height).map(texel).collect() }
    }

    /// The mean over the sphere of each channel.
    pub fn mean(&self) -> [f64; 3] {
        let (mut sum, mut whole) = ([0.0; 3], 0.0);
        for (row, texels) in self.texels.chunks(self.width as usize).enumerate() {
            let share = libm::sin(std::f64::consts::PI * (row as f64 + 0.5) / f64::from(self.height));
            whole += share * texels.len() as f64;
            texels.iter().for_each(|t| (0..3).for_each(|c| sum[c] += share * f64::from(t[c])));
        }
        sum.map(|c| c / whole)
    }

    /// The map with at most so many columns, and half as many rows; each texel is the mean of those that it covers.
    fn reduced(&self, columns: u32) -> Environment {
        if self.width <= columns {
            return self.clone();
        }
        let (width, height) = (columns, (columns / 2).min(self.height).max(1));
        let part = |i: u32, of: u32, side: u32| {
            let at = |i: u32| (u64::from(i) * u64::from(side) / u64::from(of)) as u32;
            at(i)..at(i + 1).max(at(i) + 1)
        };
        let texel = |i: u32| {
            let (rows, columns) = (part(i / width, height, self.height), part(i % width, width, self.width));
            let count = (rows.len() * columns.len()) as f64;
            let mut sum = [0.0; 3];
            for row in rows {
                for column in columns.clone() {
                    let texel = self.texels[(row * self.width + column) as usize];
                    (0..3).for_each(|c| sum[c] += f64::from(texel[c]));
                }
            }
            sum.map(|c| (c / count) as f32)
        };
        Environment { width, height, texels: (0..width * height).map(texel).collect() }
    }

    /// Looks the directions of `sphere` up on `backend`.
    ///
    /// # Errors
    ///
    /// Texels that no fixed point holds, and whatever the backend refuses.
    pub fn look_up(&self, backend: &dyn Backend, sphere: Sphere, lighting: &Lighting) -> Result<Intensities> {
        let map = self.reduced(COLUMNS);
        // The kernel's columns run the other way round.
        let mirrored: Vec<[f32; 3]> =
            map.texels.chunks(map.width as usize).flat_map(|row| row.iter().rev()).copied().collect();
        let fixed = Fixed::new(&mirrored)?;
        let (weights, up) = scaled_weights(&sphere.weights(lighting.weighting));
        let mut job = Job::new();
        let texels: Vec<UVec4> = fixed.values.iter().copied().map(UVec4::from_array).collect();
        let texels = job.slice("texels", &texels);
        let texels = map.record_blur(&mut job, texels, lighting.sigma(sphere, map.width))?;
        let [units, values] = map.record_look_up(&mut job, texels, sphere, &lighting.rotation()?, &weights)?;
        job.read("units", units);
        job.read("intensities", values);
        let read = backend.run(&job)?;
        let words = |bytes: &[u8]| -> Vec<[u32; 4]> {
            let words: Vec<u32> = bytes.as_chunks().0.iter().map(|b| u32::from_le_bytes(*b)).collect();
            words.as_chunks().0.to_vec()
        };
        let units = words(&read[0]).into_iter().map(|[x, y, z, _]| [x, y, z].map(|c| c as i32)).collect();
        let shift = fixed.shifts.map(|shift| colour_shift(shift, up));
        Ok(Intensities { units, values: words(&read[1]), shift, lost: fixed.lost })
    }

    fn record_blur(&self, job: &mut Job, texels: Buffer<[UVec4]>, sigma: f64) -> Result<Buffer<[UVec4]>> {
        if sigma < 0.05 {
            return Ok(texels);
        }
        let radius = (libm::ceil(3.0 * sigma) as u32).min(MAX_RADIUS).min(self.width);
        let taps = job.slice("taps", &gaussian_taps(sigma, radius)?);
        let [rows, both] = ["blurred along rows", "blurred"].map(|name| job.zeroed(name, texels.len()));
        let (kernel, size) = (Illumination::new()?, (self.width, self.height));
        kernel.record_blur(job, size, taps, false, texels, rows)?;
        kernel.record_blur(job, size, taps, true, rows, both)?;
        Ok(both)
    }

    /// Unit directions, and intensities.
    fn record_look_up(
        &self,
        job: &mut Job,
        texels: Buffer<[UVec4]>,
        sphere: Sphere,
        rotation: &Rotation,
        weights: &[u32],
    ) -> Result<[sightlines_backend::BufferId; 2]> {
        let count = sphere.count();
        let directions: Vec<IVec4> = sphere.directions().into_iter().map(|[x, y, z]| IVec4::new(x, y, z, 0)).collect();
        let directions = job.slice("directions", &directions);
        let [units, turned] = ["units", "turned"].map(|name| job.zeroed(name, u64::from(count)));
        let turn = LightSphere::new()?;
        turn.record_turn(job, Rotation::IDENTITY, count, directions, units)?;
        turn.record_turn(job, *rotation, count, directions, turned)?;
        let weights = job.slice("weights", weights);
        let values = job.zeroed("intensities", u64::from(count));
        let shape = Shape::LatitudeLongitude { width: self.width, height: self.height };
        Illumination::new()?.record_look_up(job, (shape, texels), count, turned, weights, values)?;
        Ok([units.id(), values.id()])
    }
}

impl Lighting {
    /// From directions of the scene to those of the kernel's map, whose zenith is z and whose first column is x.
    fn rotation(&self) -> Result<Rotation> {
        if !self.turn.is_finite() || self.turn.abs() > 1e6 {
            let what = format!("{:?} degrees", self.turn);
            return Err(Place::default().element("turn").error(what, "choose degrees within a million"));
        }
        // An environment turned one way is looked up turned the other way.
        let (s, c) = libm::sincos(-self.turn * std::f64::consts::PI / 180.0);
        let turn = |[x, y, z]: Vector| [c * x - s * y, s * x + c * y, z];
        // Columns: where x, y and z of the scene point in the map.
        let axes: [Vector; 3] = match self.up {
            Up::Y => [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
            Up::Z => [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        };
        let columns = axes.map(turn);
        Ok(Rotation::new([0, 1, 2].map(|row| columns.map(|column| column[row])))?)
    }

    /// The Gaussian's standard deviation in texels of a map of so many columns.
    fn sigma(&self, sphere: Sphere, columns: u32) -> f64 {
        let radians = self.blur.map_or(0.5 * sphere.spacing(), |degrees| degrees * std::f64::consts::PI / 180.0);
        let texels = radians * f64::from(columns) / (2.0 * std::f64::consts::PI);
        if columns == 1 { 0.0 } else { texels.min(f64::from(MAX_RADIUS)) }
    }
}

/// The direction of a texel's middle, where y is up.
pub(super) fn direction_at([column, row]: [u32; 2], [width, height]: [u32; 2]) -> Vector {
    let (from_top, around) = (
        std::f64::consts::PI * (f64::from(row) + 0.5) / f64::from(height),
        std::f64::consts::TAU * ((f64::from(column) + 0.5) / f64::from(width) - 0.5),
    );
    let level = libm::sin(from_top);
    [level * libm::sin(around), libm::cos(from_top), -level * libm::cos(around)]
}

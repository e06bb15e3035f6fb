//! Light from far away: a latitude–longitude map of an environment, and what of it each direction brings.
//!
//! Sattler et al. 2004, section 5: the map is filtered with a Gaussian and looked up at the
//! light's directions; turning the environment turns the look-ups, and no visibility changes. The Gaussian is the
//! sphere's ([`Filter::Sphere`]) or, as in the paper, the map's. Maps follow the usual convention: seen from inside,
//! the middle column looks along −z with +x to its right and +y up, where y is up. Maps are brought to at most 512
//! columns by averaging solid angles first. Invariant: what reaches the device is integers, made in IEEE f64 and `libm`
//! from finite texels that are not negative.

use glam::{IVec4, UVec4};
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job};
use sightlines_kernels::illumination::{
    Fixed, Illumination, MAX_RADIUS, Shape, colour_shift, gaussian_taps, scaled_weights,
};
use sightlines_kernels::light_sphere::{LightSphere, Rotation};

use super::blur::{self, Sky};
use super::sphere::{Sphere, Weighting};
use super::turn::Turn;
use crate::error::{Place, Result};
use crate::setup::Up;
use crate::vector::{Vector, normalize};

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
    /// How the scene itself has turned since its matrix was made.
    pub pose: Turn,
    /// Standard deviation of the Gaussian, in degrees; 0 for none. Nothing: half the spacing of the directions.
    pub blur: Option<f64>,
    /// Where the Gaussian is one.
    pub filter: Filter,
    /// How directions are weighed.
    pub weighting: Weighting,
}

/// Where a Gaussian filters an environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// On the sphere, by the angle from a direction: light is neither gained nor lost, wherever it stands.
    Sphere,
    /// In the map, by texels, as in the paper: towards the poles too narrow along rows, with too much light.
    Map,
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
        for (row, texels) in (0..).zip(self.texels.chunks(self.width as usize)) {
            let share = self.share(row);
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
            let (mut sum, mut whole) = ([0.0; 3], 0.0);
            for row in rows {
                let share = self.share(row);
                for column in columns.clone() {
                    let texel = self.texels[(row * self.width + column) as usize];
                    (0..3).for_each(|c| sum[c] += share * f64::from(texel[c]));
                    whole += share;
                }
            }
            sum.map(|c| (c / whole) as f32)
        };
        Environment { width, height, texels: (0..width * height).map(texel).collect() }
    }

    /// The solid angle of a texel of a row, by that of the sphere in rows.
    fn share(&self, row: u32) -> f64 {
        let bound = |row: u32| libm::cos(std::f64::consts::PI * f64::from(row) / f64::from(self.height));
        0.5 * (bound(row) - bound(row + 1))
    }

    /// Looks the directions of `sphere` up on `backend`.
    ///
    /// # Errors
    ///
    /// Texels that no fixed point holds, and whatever the backend refuses.
    pub fn look_up(&self, backend: &dyn Backend, sphere: Sphere, lighting: &Lighting) -> Result<Intensities> {
        let sigma = lighting.sigma(sphere);
        // A filter that no texel beside another one feels is none.
        let felt = sigma > 0.5 * std::f64::consts::PI / f64::from(self.height.min(COLUMNS / 2));
        match lighting.filter {
            Filter::Sphere if felt => self.look_around(backend, sphere, lighting),
            Filter::Sphere => self.look_up_in_map(backend, sphere, lighting, 0.0),
            Filter::Map => self.look_up_in_map(backend, sphere, lighting, sigma),
        }
    }

    /// The means around the directions.
    fn look_around(&self, backend: &dyn Backend, sphere: Sphere, lighting: &Lighting) -> Result<Intensities> {
        let (rows, sigma) = (lighting.rows()?, lighting.sigma(sphere));
        let map = self.reduced(COLUMNS.min(blur::columns(sigma)));
        let fixed = Fixed::new(&map.texels)?;
        let sky = Sky::new(&map, &fixed.values);
        let (weights, up) = scaled_weights(&sphere.weights(lighting.weighting));
        let intensity = |(direction, weight): ([i32; 3], &u32)| {
            let d = normalize(direction.map(f64::from));
            // The kernel's zenith is z and its first column x.
            let [z, x, y] = rows.map(|row| row[0] * d[0] + row[1] * d[1] + row[2] * d[2]);
            let [red, green, blue] =
                sky.around([x, y, z], sigma).map(|mean| ((u64::from(mean) * u64::from(*weight)) >> 32) as u32);
            [red, green, blue, 0]
        };
        let values = sphere.directions().into_iter().zip(&weights).map(intensity).collect();
        let mut job = Job::new();
        let units = record_turn(&mut job, sphere, Rotation::IDENTITY)?;
        job.read("units", units.id());
        let shift = fixed.shifts.map(|shift| colour_shift(shift, up));
        Ok(Intensities { units: units_of(&backend.run(&job)?[0]), values, shift, lost: fixed.lost })
    }

    /// The texels that the directions meet in the map, filtered with a Gaussian of so many radians.
    fn look_up_in_map(
        &self,
        backend: &dyn Backend,
        sphere: Sphere,
        lighting: &Lighting,
        sigma: f64,
    ) -> Result<Intensities> {
        let map = self.reduced(COLUMNS);
        // The kernel's columns run the other way round.
        let mirrored: Vec<[f32; 3]> =
            map.texels.chunks(map.width as usize).flat_map(|row| row.iter().rev()).copied().collect();
        let fixed = Fixed::new(&mirrored)?;
        let (weights, up) = scaled_weights(&sphere.weights(lighting.weighting));
        let mut job = Job::new();
        let texels: Vec<UVec4> = fixed.values.iter().copied().map(UVec4::from_array).collect();
        let texels = job.slice("texels", &texels);
        let texels = map.record_blur(&mut job, texels, sigma)?;
        let units = record_turn(&mut job, sphere, Rotation::IDENTITY)?;
        let turned = record_turn(&mut job, sphere, Rotation::new(lighting.rows()?)?)?;
        let weights = job.slice("weights", &weights);
        let count = sphere.count();
        let values = job.zeroed("intensities", u64::from(count));
        let shape = Shape::LatitudeLongitude { width: map.width, height: map.height };
        Illumination::new()?.record_look_up(&mut job, (shape, texels), count, turned, weights, values)?;
        job.read("units", units.id());
        job.read("intensities", values.id());
        let read = backend.run(&job)?;
        let shift = fixed.shifts.map(|shift| colour_shift(shift, up));
        Ok(Intensities { units: units_of(&read[0]), values: words_of(&read[1]), shift, lost: fixed.lost })
    }

    /// The filter of the map, by a standard deviation in radians.
    fn record_blur(&self, job: &mut Job, texels: Buffer<[UVec4]>, sigma: f64) -> Result<Buffer<[UVec4]>> {
        let sigma = (sigma * f64::from(self.width) / std::f64::consts::TAU).min(f64::from(MAX_RADIUS));
        if sigma < 0.05 || self.width == 1 {
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
}

/// The directions, turned, of length 2^15.
fn record_turn(job: &mut Job, sphere: Sphere, rotation: Rotation) -> Result<Buffer<[IVec4]>> {
    let directions: Vec<IVec4> = sphere.directions().into_iter().map(|[x, y, z]| IVec4::new(x, y, z, 0)).collect();
    let directions = job.slice("directions", &directions);
    let turned = job.zeroed("turned", u64::from(sphere.count()));
    LightSphere::new()?.record_turn(job, rotation, sphere.count(), directions, turned)?;
    Ok(turned)
}

fn units_of(bytes: &[u8]) -> Vec<[i32; 3]> {
    words_of(bytes).into_iter().map(|[x, y, z, _]| [x, y, z].map(|c| c as i32)).collect()
}

fn words_of(bytes: &[u8]) -> Vec<[u32; 4]> {
    let words: Vec<u32> = bytes.as_chunks().0.iter().map(|b| u32::from_le_bytes(*b)).collect();
    words.as_chunks().0.to_vec()
}

impl Lighting {
    /// Nothing is turned, y is up, and the sum is an integral over the sphere.
    pub const DEFAULT: Lighting = Lighting {
        up: Up::Y,
        turn: 0.0,
        pose: Turn::NONE,
        blur: None,
        filter: Filter::Sphere,
        weighting: Weighting::SolidAngle,
    };

    /// The rotation from directions of the matrix to those of the kernel's map, whose zenith is z and whose first
    /// column is x.
    fn rows(&self) -> Result<[Vector; 3]> {
        if !self.turn.is_finite() || self.turn.abs() > 1e6 {
            let what = format!("{:?} degrees", self.turn);
            return Err(Place::default().element("turn").error(what, "choose degrees within a million"));
        }
        // An environment turned one way is looked up turned the other way.
        let (s, c) = libm::sincos(-self.turn * std::f64::consts::PI / 180.0);
        let column = |axis: Vector| {
            let [x, y, z] = self.pose.apply(axis);
            let [x, y, z] = if self.up == Up::Y { [z, x, y] } else { [-y, x, z] };
            [c * x - s * y, s * x + c * y, z]
        };
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(column);
        Ok([0, 1, 2].map(|row| columns.map(|column| column[row])))
    }

    /// The Gaussian's standard deviation in radians.
    fn sigma(&self, sphere: Sphere) -> f64 {
        self.blur.map_or(0.5 * sphere.spacing(), |degrees| degrees * std::f64::consts::PI / 180.0)
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

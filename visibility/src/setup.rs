//! Where light and receiver stand: by defaults that suit any mesh, or as a scene file says.
//!
//! # Defaults
//!
//! Let R be the radius of the scene's bounding sphere, and *up* the y or z axis (y unless told). Then
//!
//! * the receiver is a horizontal square of side 4 R, centred below the scene, 0.02 R under its lowest point;
//! * the light is a horizontal square 3 R above the receiver, centred, of side 0.4 R, and shines down;
//! * the image is the receiver seen from above: columns run along x; rows run along z where y is up, and along −y
//!   where z is up, so that no image is mirrored.
//!
//! A setup that [`Setup::new`] or [`Setup::load`] gives is sound: rectangles have right angles and area, the light's
//! front faces the whole receiver, nothing touches, and some of the scene lies between the two.

mod file;

use std::fmt;
use std::path::Path;

use crate::error::{Place, Result};
use crate::scene::{MAX_COORDINATE, Scene};
use crate::shadows::{MAX_RESOLUTION, MAX_WORDS, Rect, Request, SAMPLES};
use crate::vector::{Vector, add, cross, dot, length, scale, sub};

/// Side of the default light, in radii of the scene.
pub const LIGHT_SIZE: f64 = 0.4;
/// Largest side of the default light, in radii of the scene.
pub const MAX_LIGHT_SIZE: f64 = 16.0;
/// Texels a side, by default.
pub const RESOLUTION: u32 = 512;
/// Samples of a light, by default.
pub const SAMPLE_COUNT: u32 = 1024;
/// Most lights of one setup.
pub const MAX_LIGHTS: usize = 64;

const LIGHT_HEIGHT: f64 = 3.0;
const RECEIVER_SIDE: f64 = 4.0;
const RECEIVER_GAP: f64 = 0.02;
/// Two sides are at right angles, and a point is on a plane, up to this share of the lengths involved.
const TOLERANCE: f64 = 1e-9;

/// The axis that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// As glTF and most OBJ files have it.
    #[default]
    Y,
    /// As most CAD programs have it.
    Z,
}

impl Up {
    /// The axis of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "y" => Some(Up::Y),
            "z" => Some(Up::Z),
            _ => None,
        }
    }

    fn axis(self) -> usize {
        match self {
            Up::Y => 1,
            Up::Z => 2,
        }
    }

    /// Columns and rows of the image; columns × rows points down.
    fn image(self) -> [Vector; 2] {
        match self {
            Up::Y => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
            Up::Z => [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0]],
        }
    }
}

impl fmt::Display for Up {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Up::Y => "y",
            Up::Z => "z",
        })
    }
}

/// What a caller may choose; the rest is a scene file's or the default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// The axis that points up.
    pub up: Option<Up>,
    /// Side of the default light in radii of the scene.
    pub light_size: Option<f64>,
    /// Texels a side of the receiver.
    pub resolution: Option<u32>,
    /// Samples of each light.
    pub samples: Option<u32>,
}

/// A scene with lights, receiver and sampling.
#[derive(Clone, Debug)]
pub struct Setup {
    /// What casts the shadows.
    pub scene: Scene,
    /// The axis that points up.
    pub up: Up,
    /// One or more lights, each baked by itself.
    pub lights: Vec<Rect>,
    /// Where the shadows fall.
    pub receiver: Rect,
    /// Texels a side of the receiver.
    pub resolution: u32,
    /// Samples of each light.
    pub samples: u32,
}

impl Setup {
    /// The default light and receiver around `scene`.
    ///
    /// # Errors
    ///
    /// A setting out of its range.
    pub fn new(scene: Scene, settings: &Settings) -> Result<Self> {
        let place = |key: &str| Place::default().element(key);
        let up = settings.up.unwrap_or_default();
        let size = checked_light_size(place("light size"), settings.light_size.unwrap_or(LIGHT_SIZE))?;
        let resolution = checked_resolution(place("resolution"), settings.resolution.unwrap_or(RESOLUTION))?;
        let samples = checked_samples(place("samples"), settings.samples.unwrap_or(SAMPLE_COUNT), resolution)?;
        let (light, receiver) = surround(&scene, up, size);
        Ok(Setup { scene, up, lights: vec![light], receiver, resolution, samples })
    }

    /// Reads a scene file; `settings` go before what it says. Its model is looked for beside it.
    ///
    /// # Errors
    ///
    /// A file that is missing, does not parse, or asks for what makes no sense, with its line.
    pub fn load(path: &Path, settings: &Settings) -> Result<Self> {
        file::load(path, settings)
    }

    /// The request of the first light; the others differ in [`Request::light`] alone.
    pub fn request(&self) -> Request {
        Request {
            triangles: self.scene.triangles(),
            light: self.lights[0],
            receiver: self.receiver,
            resolution: self.resolution,
            samples: self.samples,
        }
    }
}

/// Light and receiver by the defaults that the head of this file states.
fn surround(scene: &Scene, up: Up, light_size: f64) -> (Rect, Rect) {
    let bounds = scene.bounds();
    let (radius, axis) = (bounds.radius, up.axis());
    let mut foot = bounds.centre;
    foot[axis] = bounds.min[axis] - RECEIVER_GAP * radius;
    let mut lamp = foot;
    lamp[axis] += LIGHT_HEIGHT * radius;
    (square(up, lamp, light_size * radius), square(up, foot, RECEIVER_SIDE * radius))
}

fn square(up: Up, centre: Vector, side: f64) -> Rect {
    let [u, v] = up.image().map(|direction| scale(direction, side));
    Rect { corner: sub(centre, scale(add(u, v), 0.5)), u, v }
}

fn checked_light_size(place: Place, size: f64) -> Result<f64> {
    if size > 0.0 && size <= MAX_LIGHT_SIZE {
        return Ok(size);
    }
    let remedy =
        format!("choose a number above 0, at most {MAX_LIGHT_SIZE}: it is the light's side over the scene's radius");
    Err(place.error(format!("{size:?} is out of range"), remedy))
}

fn checked_resolution(place: Place, resolution: u32) -> Result<u32> {
    if (1..=MAX_RESOLUTION).contains(&resolution) {
        return Ok(resolution);
    }
    Err(place.error(format!("{resolution} texels a side are out of range"), format!("choose 1 to {MAX_RESOLUTION}")))
}

fn checked_samples(place: Place, samples: u32, resolution: u32) -> Result<u32> {
    if !SAMPLES.contains(&samples) {
        let choice = SAMPLES.map(|n| n.to_string()).join(", ");
        return Err(place.error(format!("{samples} samples cannot be baked"), format!("choose one of {choice}")));
    }
    let words = u64::from(resolution) * u64::from(resolution) * u64::from(samples / 32);
    if words > MAX_WORDS {
        let what = format!("{samples} samples for {resolution}² texels are {} MiB of sets", words >> 18);
        return Err(place.error(what, format!("choose fewer samples or texels: at most {} MiB fit", MAX_WORDS >> 18)));
    }
    Ok(samples)
}

/// Refuses a rectangle without area, with skewed sides or with absurd coordinates.
fn check_rect(place: &Place, rect: &Rect) -> Result<()> {
    let bad = |what: &str, remedy: &str| Err(place.clone().error(what, remedy));
    if [rect.corner, rect.u, rect.v].as_flattened().iter().any(|c| !c.is_finite() || c.abs() > MAX_COORDINATE) {
        return bad("a coordinate is not finite, or beyond 1e12", "choose other units");
    }
    let (u, v) = (length(rect.u), length(rect.v));
    if u == 0.0 || v == 0.0 {
        return bad("a side has no length", "give `u` and `v` their lengths");
    }
    if dot(rect.u, rect.v).abs() > TOLERANCE * u * v {
        return bad("the sides are not at right angles", "make `u` and `v` perpendicular");
    }
    Ok(())
}

/// Refuses a light that does not face the receiver, or that has nothing of the scene between them.
fn check_light(place: &Place, light: &Rect, receiver: &Rect, scene: &Scene) -> Result<()> {
    let bad = |what: &str, remedy: &str| Err(place.clone().error(what, remedy));
    let [low, high] = heights(receiver, corners(light));
    if low <= 0.0 && high >= 0.0 {
        return bad("the light is inside the receiver's plane", "move the light away from the receiver");
    }
    let [nearest, farthest] = heights(light, corners(receiver));
    if farthest <= 0.0 {
        return bad("the receiver is behind the light", "swap the light's `u` and `v`: it shines along u × v");
    }
    if nearest <= 0.0 {
        return bad(
            "the receiver crosses the plane of the light",
            "move or turn the light so that it sees all of the receiver",
        );
    }
    let vertices = scene.parts.iter().flat_map(|part| part.vertices.iter().copied());
    let [lowest, highest] = heights(receiver, vertices.clone());
    let same_side = if low > 0.0 { highest > 0.0 } else { lowest < 0.0 };
    if !same_side {
        return bad(
            "the light is behind the receiver: the scene is on the other side",
            "move the light to the scene's side",
        );
    }
    if heights(light, vertices)[1] <= 0.0 {
        return bad("the whole scene is behind the light", "move the light beyond the scene, or swap its `u` and `v`");
    }
    Ok(())
}

fn corners(rect: &Rect) -> [Vector; 4] {
    let [a, b] = [rect.corner, add(rect.corner, rect.u)];
    [a, b, add(b, rect.v), add(a, rect.v)]
}

/// Least and greatest distance of points from the plane of `rect`, along u × v; distances within the tolerance are
/// zero.
fn heights(rect: &Rect, points: impl IntoIterator<Item = Vector>) -> [f64; 2] {
    let normal = cross(rect.u, rect.v);
    let normal = scale(normal, 1.0 / length(normal));
    let height = |point: Vector| {
        let from = sub(point, rect.corner);
        let height = dot(normal, from);
        if height.abs() <= TOLERANCE * length(from) { 0.0 } else { height }
    };
    let bounds = [f64::INFINITY, f64::NEG_INFINITY];
    points.into_iter().map(height).fold(bounds, |[low, high], h| [low.min(h), high.max(h)])
}

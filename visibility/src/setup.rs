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
mod lights;

use std::fmt;
use std::path::Path;

use sightlines_kernels::irradiance::MAX_GROUPS;

use crate::error::{Place, Result};
use crate::scene::{Camera, MAX_COORDINATE, Scene};
use crate::shadows::expose::{self, Exposure, Motion, Sampling};
use crate::shadows::light::Light;
use crate::shadows::lightmap::Atlas;
use crate::shadows::placement::{MAX_SAMPLES, Placement};
use crate::shadows::surface::{HeightMap, Surface};
use crate::shadows::{Effort, Faces, MAX_RESOLUTION, MAX_WORDS, Rect, Request};
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
/// Most frames of a motion.
pub const MAX_FRAMES: u32 = 256;

/// Most colours of a light that are told apart, by default.
pub const COLOURS: u32 = expose::COLOURS as u32;

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
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// The axis that points up.
    pub up: Option<Up>,
    /// Side of the default light in radii of the scene.
    pub light_size: Option<f64>,
    /// Which faces of the scene hide.
    pub faces: Option<Faces>,
    /// Texels a side of the receiver.
    pub resolution: Option<u32>,
    /// Samples of each light.
    pub samples: Option<u32>,
    /// Where samples are.
    pub placement: Option<Placement>,
    /// Of all that is random.
    pub seed: Option<u32>,
    /// Whether each receiver has the pattern shifted at random.
    pub decorrelated: Option<bool>,
    /// Samples a word of the sets.
    pub word_bits: Option<u32>,
    /// Most groups of colours.
    pub colours: Option<u32>,
    /// Heights of the receiver.
    pub heights: Option<HeightMap>,
    /// Whether they cast shadows on themselves.
    pub self_shadow: Option<bool>,
    /// Whether the scene's own surface receives.
    pub lightmap: Option<bool>,
    /// The camera in whose view the receiver is shown.
    pub camera: Option<Camera>,
    /// How far the scene moves.
    pub motion: Option<[f64; 3]>,
    /// Frames of the motion.
    pub frames: Option<u32>,
}

/// A scene with lights, receiver and sampling.
#[derive(Clone, Debug)]
pub struct Setup {
    /// What casts the shadows.
    pub scene: Scene,
    /// Which faces of it hide.
    pub faces: Faces,
    /// The axis that points up.
    pub up: Up,
    /// One or more lights, each baked by itself.
    pub lights: Vec<Light>,
    /// The receiver's rectangle.
    pub receiver: Rect,
    /// Where the shadows fall: on that rectangle, moved by heights or not, or on the scene itself.
    pub surface: Surface,
    /// Texels a side of the receiver.
    pub resolution: u32,
    /// How each light is sampled.
    pub sampling: Sampling,
    /// What moves, and how far in each frame.
    pub motion: Option<Moves>,
}

/// A motion of some parts of a scene along a line.
#[derive(Clone, Debug, PartialEq)]
pub struct Moves {
    /// How far they have come in the last frame.
    pub offset: [f64; 3],
    /// Frames, at even distances.
    pub frames: u32,
    /// The name of the parts that move; all of them where there is none.
    pub part: Option<String>,
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
        let colours = checked_colours(place("colours"), settings.colours.unwrap_or(COLOURS))?;
        let (light, receiver) = surround(&scene, up, size);
        let sampling = Sampling { colours, ..sampling(settings, samples) };
        let motion = moves(&place("motion"), settings.motion, settings.frames, None, &scene)?;
        let surface = surface(settings, receiver, &scene)?;
        let faces = settings.faces.unwrap_or_default();
        Ok(Setup { scene, faces, up, lights: vec![light.into()], receiver, surface, resolution, sampling, motion })
    }

    /// Reads a scene file; `settings` go before what it says. Its model is looked for beside it.
    ///
    /// # Errors
    ///
    /// A file that is missing, does not parse, or asks for what makes no sense, with its line.
    pub fn load(path: &Path, settings: &Settings) -> Result<Self> {
        file::load(path, settings)
    }

    /// The request of the first light, as a white rectangle with a grid of samples over a plane.
    pub fn request(&self) -> Request {
        Request {
            triangles: self.scene.triangles(),
            faces: self.faces,
            light: self.lights[0].rect,
            receiver: self.receiver,
            resolution: self.resolution,
            samples: self.sampling.count,
        }
    }

    /// The exposure to one of the lights; `light_sums` asks for irradiance.
    pub fn exposure(&self, light: usize, light_sums: bool) -> Exposure {
        let part = self.motion.as_ref().and_then(|moves| moves.part.as_deref());
        let moves = |name: &str| self.motion.is_some() && part.is_none_or(|part| part == name);
        let (moving, resting): (Vec<_>, Vec<_>) = self.scene.parts.iter().cloned().partition(|p| moves(&p.name));
        let triangles = |parts| Scene { parts, ..self.scene.clone() }.triangles();
        let motion = self.motion.as_ref().map(|Moves { offset, frames, .. }| {
            let part = |frame: u32| f64::from(frame) / f64::from((frames - 1).max(1));
            Motion { triangles: triangles(moving), offsets: (0..*frames).map(|f| scale(*offset, part(f))).collect() }
        });
        Exposure {
            triangles: triangles(resting),
            faces: self.faces,
            light: self.lights[light].clone(),
            surface: self.surface.clone(),
            resolution: self.resolution,
            sampling: self.sampling.clone(),
            light_sums,
            motion,
            effort: Effort::default(),
        }
    }
}

/// The sampling that settings ask for, but for its colours.
fn sampling(settings: &Settings, samples: u32) -> Sampling {
    let plain = Sampling::new(samples);
    Sampling {
        placement: settings.placement.clone().unwrap_or(plain.placement),
        seed: settings.seed.unwrap_or(plain.seed),
        decorrelated: settings.decorrelated.unwrap_or(plain.decorrelated),
        bits: settings.word_bits.unwrap_or(plain.bits),
        ..plain
    }
}

/// What receives: a rectangle, with heights if there are any, or the scene itself.
fn surface(settings: &Settings, receiver: Rect, scene: &Scene) -> Result<Surface> {
    let (heights, camera) = (settings.heights.clone(), settings.camera.clone());
    let own = settings.self_shadow.unwrap_or(false);
    if own && heights.is_none() {
        let what = "only heights can be told to cast shadows on themselves";
        return Err(Place::default().element("self").error(what, "give heights, or leave it out"));
    }
    match (settings.lightmap.unwrap_or(false), heights, camera) {
        (true, None, None) => Ok(Surface::Lightmap(Atlas::new(scene)?)),
        (false, Some(heights), None) if own => Ok(Surface::Relief(receiver, heights)),
        (false, Some(heights), None) => Ok(Surface::Heights(receiver, heights)),
        (false, None, Some(camera)) => Ok(Surface::View(receiver, camera)),
        (false, None, None) => Ok(Surface::Plane(receiver)),
        _ => {
            let what = "heights, a lightmap and a camera's view are three kinds of receivers";
            Err(Place::default().element("receiver").error(what, "keep one of them"))
        }
    }
}

/// The motion that is asked for, if any.
fn moves(
    place: &Place,
    offset: Option<Vector>,
    frames: Option<u32>,
    part: Option<String>,
    scene: &Scene,
) -> Result<Option<Moves>> {
    let bad = |what: String, remedy: &str| Err(place.clone().error(what, remedy));
    let (offset, frames) = match (offset, frames) {
        (None, None) => return Ok(None),
        (Some(offset), Some(frames)) => (offset, frames),
        _ => return bad("a motion has an offset and frames".to_owned(), "give both, or leave out both"),
    };
    if !(2..=MAX_FRAMES).contains(&frames) {
        return bad(format!("{frames} frames"), "choose 2 to 256");
    }
    if offset.iter().any(|c| !c.is_finite() || c.abs() > MAX_COORDINATE) {
        return bad(format!("an offset of {offset:?}"), "choose finite numbers up to 1e12");
    }
    if let Some(name) = part.as_ref().filter(|name| scene.parts.iter().all(|p| p.name != **name)) {
        let names: Vec<&str> = scene.parts.iter().map(|part| part.name.as_str()).take(8).collect();
        return bad(format!("there is no part `{name}`"), &format!("choose one of {}", names.join(", ")));
    }
    Ok(Some(Moves { offset, frames, part }))
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
    if !(1..=MAX_SAMPLES).contains(&samples) {
        let remedy = format!("choose 1 to {MAX_SAMPLES}");
        return Err(place.error(format!("{samples} samples cannot be baked"), remedy));
    }
    let words = u64::from(resolution) * u64::from(resolution) * u64::from(samples.div_ceil(32));
    if words > MAX_WORDS {
        let what = format!("{samples} samples for {resolution}² texels are {} MiB of sets", words >> 18);
        return Err(place.error(what, format!("choose fewer samples or texels: at most {} MiB fit", MAX_WORDS >> 18)));
    }
    Ok(samples)
}

fn checked_colours(place: Place, colours: u32) -> Result<usize> {
    if (1..=MAX_GROUPS as u32).contains(&colours) {
        return Ok(colours as usize);
    }
    let remedy = format!("choose 1 to {MAX_GROUPS}; the samples of each colour are counted by themselves");
    Err(place.error(format!("{colours} colours are out of range"), remedy))
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

//! Scene files, in TOML.
//!
//! ```toml
//! model = "model.glb"        # beside this file; or: generator = "palms"
//! up = "y"                   # or "z"
//! light_size = 0.4           # side of the default light in radii of the scene, where no light is given
//! faces = "front"            # which faces hide: "both", "front" or "back"
//! resolution = 512           # texels a side of the receiver
//! samples = 1024             # of each light, 1 to 65536
//! pattern = "halton"         # "grid", "jittered", "halton", "blue-noise", or a file of points beside this one
//! seed = 1                   # of what is random in it
//! decorrelated = true        # each receiver has the pattern shifted by a random part of a sample's distance
//! word_bits = 32             # samples a word of the sets, or 31
//! colours = 24               # most colours of a light that are told apart
//! lightmap = true            # the receiver is the surface of the model, which has texture coordinates
//!
//! [[light]]                  # any number; each shines along u × v
//! corner = [-1.0, 6.0, -1.0]
//! u = [2.0, 0.0, 0.0]
//! v = [0.0, 0.0, 2.0]
//! colour = [1.0, 0.9, 0.8]   # what its colours are multiplied by
//! image = "window.png"       # where it shines and how; or `tubes`, or `polygons`, all in parts of u and v:
//! # tubes = { count = 5, width = 0.2, colours = [[1.0, 0.2, 0.2], [0.2, 0.4, 1.0]] }
//! # polygons = [{ corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]], colour = [1.0, 0.0, 0.0] }]
//!
//! [receiver]
//! corner = [-4.0, 0.0, -4.0]
//! u = [8.0, 0.0, 0.0]        # columns of the image
//! v = [0.0, 0.0, 8.0]        # rows of the image
//! heights = "ground.png"     # moves it towards the light: white is height_scale; or "bumps"
//! height_scale = 0.5
//! self = true                # the heights cast shadows on themselves
//!
//! [motion]                   # light is accumulated over frames
//! offset = [1.0, 0.0, 0.0]
//! frames = 8
//! part = "door"              # what moves; all where it is left out
//! ```
//!
//! Everything but the model or generator may be left out.

use std::path::Path;

use serde::Deserialize;
use toml::Spanned;

use super::lights;
use super::{
    COLOURS, LIGHT_SIZE, MAX_LIGHTS, RESOLUTION, SAMPLE_COUNT, Settings, Setup, Up, check_light, check_rect,
    checked_colours, checked_light_size, checked_resolution, checked_samples, moves, sampling, surface, surround,
};
use crate::error::{Place, Result};
use crate::input;
use crate::scene::{self, Generator, Scene, limit};
use crate::shadows::expose::Sampling;
use crate::shadows::placement::Placement;
use crate::shadows::surface::{HeightMap, Surface};
use crate::shadows::{Faces, Rect};

/// Largest scene file, in bytes: it holds a few numbers.
const MAX_BYTES: u64 = 1 << 20;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    model: Option<Spanned<String>>,
    generator: Option<Spanned<String>>,
    up: Option<Spanned<String>>,
    light_size: Option<Spanned<f64>>,
    resolution: Option<Spanned<u32>>,
    samples: Option<Spanned<u32>>,
    pattern: Option<Spanned<String>>,
    seed: Option<u32>,
    decorrelated: Option<bool>,
    faces: Option<Faces>,
    word_bits: Option<u32>,
    colours: Option<Spanned<u32>>,
    lightmap: Option<bool>,
    #[serde(default)]
    light: Vec<Spanned<lights::Entry>>,
    receiver: Option<Spanned<Receiver>>,
    motion: Option<Spanned<MotionEntry>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Receiver {
    corner: [f64; 3],
    u: [f64; 3],
    v: [f64; 3],
    heights: Option<String>,
    height_scale: Option<f64>,
    #[serde(rename = "self")]
    own: Option<bool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MotionEntry {
    offset: [f64; 3],
    frames: u32,
    part: Option<String>,
}

impl Receiver {
    fn rect(&self) -> Rect {
        Rect { corner: self.corner, u: self.u, v: self.v }
    }
}

/// A file's text, for lines.
pub(super) struct Source<'a> {
    pub(super) path: &'a Path,
    text: &'a str,
}

impl Source<'_> {
    fn line(&self, offset: usize) -> Place {
        let before = &self.text.as_bytes()[..offset.min(self.text.len())];
        Place::line(self.path, 1 + before.iter().filter(|&&b| b == b'\n').count())
    }

    /// Where a value stands, called by its key.
    pub(super) fn at<T>(&self, key: &str, value: &Spanned<T>) -> Place {
        self.line(value.span().start).element(key)
    }

    /// A file that is named by one beside it.
    pub(super) fn beside(&self, name: &str) -> std::path::PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(name)
    }

    /// The place and value of a setting: a caller's goes before the file's, the file's before the default.
    fn setting<T: Copy>(&self, key: &str, caller: Option<T>, file: &Option<Spanned<T>>, default: T) -> (Place, T) {
        match (caller, file) {
            (None, Some(value)) => (self.at(key, value), *value.get_ref()),
            (None, None) => (Place::file(self.path).element(key), default),
            (Some(value), _) => (Place::default().element(key), value),
        }
    }
}

pub(super) fn load(path: &Path, settings: &Settings) -> Result<Setup> {
    let text = input::read_text(path, MAX_BYTES, "name the mesh as the model, in a scene file of its own")?;
    let source = Source { path, text: &text };
    let file: File = toml::from_str(&text).map_err(|e| {
        let place = e.span().map_or_else(|| Place::file(path), |span| source.line(span.start));
        place.error(e.message(), "`sightlines shadows --help` shows a scene file")
    })?;
    let (place, resolution) = source.setting("resolution", settings.resolution, &file.resolution, RESOLUTION);
    let resolution = checked_resolution(place, resolution)?;
    let (place, samples) = source.setting("samples", settings.samples, &file.samples, SAMPLE_COUNT);
    let samples = checked_samples(place, samples, resolution)?;
    let (place, colours) = source.setting("colours", settings.colours, &file.colours, COLOURS);
    let colours = checked_colours(place, colours)?;
    let up = up(&source, settings, &file)?;
    let light_size = light_size(&source, settings, &file)?;
    let scene = model(&source, &file)?;
    let settings = merged(&source, settings, &file)?;
    let (light, receiver) = surround(&scene, up, light_size);
    let sampling = Sampling { colours, ..sampling(&settings, samples) };
    let place = file.motion.as_ref().map_or_else(|| Place::file(path), |motion| source.at("motion", motion));
    let part = file.motion.as_ref().and_then(|motion| motion.get_ref().part.clone());
    let motion = moves(&place, settings.motion, settings.frames, part, &scene)?;
    let surface = Surface::Plane(receiver);
    let faces = settings.faces.unwrap_or_default();
    let lights = vec![light.into()];
    let mut setup = Setup { scene, faces, up, lights, receiver, surface, resolution, sampling, motion };
    place_rects(&source, &file, &settings, &mut setup)?;
    Ok(setup)
}

/// What a caller asks for, and the file's where it does not.
fn merged(source: &Source<'_>, settings: &Settings, file: &File) -> Result<Settings> {
    let motion = file.motion.as_ref().map(Spanned::get_ref);
    let placement = match (&settings.placement, &file.pattern) {
        (Some(placement), _) => Some(placement.clone()),
        (None, Some(name)) => Some(match Placement::from_name(name.get_ref()) {
            Some(known) => known,
            None => Placement::load(&source.beside(name.get_ref()))?,
        }),
        (None, None) => None,
    };
    let receiver = file.receiver.as_ref().map(Spanned::get_ref);
    let heights = match (&settings.heights, receiver) {
        (None, Some(Receiver { heights: Some(name), height_scale, .. })) => {
            Some(HeightMap::named(&source.beside(name), name, height_scale.unwrap_or(1.0))?)
        }
        (heights, _) => heights.clone(),
    };
    Ok(Settings {
        placement,
        heights,
        self_shadow: settings.self_shadow.or(receiver.and_then(|receiver| receiver.own)),
        seed: settings.seed.or(file.seed),
        decorrelated: settings.decorrelated.or(file.decorrelated),
        faces: settings.faces.or(file.faces),
        word_bits: settings.word_bits.or(file.word_bits),
        lightmap: settings.lightmap.or(file.lightmap),
        motion: settings.motion.or(motion.map(|motion| motion.offset)),
        frames: settings.frames.or(motion.map(|motion| motion.frames)),
        ..settings.clone()
    })
}

fn up(source: &Source<'_>, settings: &Settings, file: &File) -> Result<Up> {
    match (settings.up, &file.up) {
        (Some(up), _) => Ok(up),
        (None, None) => Ok(Up::default()),
        (None, Some(name)) => Up::from_name(name.get_ref()).ok_or_else(|| {
            source.at("up", name).error(format!("`{}` is no axis", name.get_ref()), "write \"y\" or \"z\"")
        }),
    }
}

fn light_size(source: &Source<'_>, settings: &Settings, file: &File) -> Result<f64> {
    let (place, size) = source.setting("light_size", settings.light_size, &file.light_size, LIGHT_SIZE);
    let size = checked_light_size(place.clone(), size)?;
    if !file.light.is_empty() && (settings.light_size.is_some() || file.light_size.is_some()) {
        return Err(place.error("the lights are given, with their own sizes", "leave out the size, or the lights"));
    }
    Ok(size)
}

fn model(source: &Source<'_>, file: &File) -> Result<Scene> {
    match (&file.model, &file.generator) {
        (Some(model), None) => scene::load(&source.beside(model.get_ref())),
        (None, Some(name)) => {
            let names = Generator::ALL.map(Generator::name).join(", ");
            let known = Generator::from_name(name.get_ref());
            known.map(scene::generate).ok_or_else(|| {
                let what = format!("there is no `{}`", name.get_ref());
                source.at("generator", name).error(what, format!("write one of {names}"))
            })
        }
        (Some(_), Some(name)) => {
            Err(source.at("generator", name).error("there is a model already", "leave out one of the two"))
        }
        (None, None) => {
            let remedy = "add `model = \"FILE\"` or `generator = \"palms\"` at its top";
            Err(Place::file(source.path).error("it names no scene", remedy))
        }
    }
}

/// Puts the file's lights and receiver in place of the default ones, and checks them all.
fn place_rects(source: &Source<'_>, file: &File, settings: &Settings, setup: &mut Setup) -> Result<()> {
    let whole = || Place::file(source.path);
    limit(whole(), "lights", file.light.len(), MAX_LIGHTS)?;
    if let Some(given) = &file.receiver {
        setup.receiver = given.get_ref().rect();
        check_rect(&source.at("receiver", given), &setup.receiver)?;
    }
    setup.surface = surface(settings, setup.receiver, &setup.scene)?;
    if !file.light.is_empty() {
        setup.lights = file.light.iter().map(|light| lights::light(source, light)).collect::<Result<_>>()?;
    }
    for (index, light) in setup.lights.iter().enumerate() {
        let place = match (file.light.get(index), &file.receiver) {
            (Some(light), _) => source.at("light", light),
            (None, Some(receiver)) => source.at("receiver", receiver),
            (None, None) => whole(),
        };
        check_rect(&place, &light.rect)?;
        if !matches!(setup.surface, Surface::Lightmap(_)) {
            check_light(&place, &light.rect, &setup.receiver, &setup.scene)?;
        }
    }
    Ok(())
}

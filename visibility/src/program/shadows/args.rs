//! The arguments of `sightlines shadows`, and what they ask of the library.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use sightlines_visibility::Result;
use sightlines_visibility::error::Place;
use sightlines_visibility::scene::Camera;
use sightlines_visibility::setup::Settings;
use sightlines_visibility::shadows::Faces;
use sightlines_visibility::shadows::placement::Placement;
use sightlines_visibility::shadows::reading::Reading as Sets;
use sightlines_visibility::shadows::surface::HeightMap;
use sightlines_visibility::simplify::Target;

use crate::program::cli::{Axis, Bits, MachineArgs, Source};
use crate::program::effort::EffortArgs;

/// What `--help` says after the options.
pub(crate) const SHADOWS_HELP: &str = "\
By default the receiver is a horizontal square of side 4 R just below the scene, R being the radius of its bounding
sphere, and the light is a horizontal square of side 0.4 R, 3 R above the receiver. The image is the receiver seen from
above. Lights and receivers of your own stand in a scene file:

  model = \"model.glb\"        # beside the scene file; or: generator = \"palms\"
  up = \"y\"                   # or \"z\"
  faces = \"both\"             # which faces cast shadows: \"both\", \"front\" or \"back\"
  resolution = 512
  samples = 1024
  pattern = \"halton\"         # as --pattern; also seed, decorrelated, word_bits, colours, lightmap
  [[light]]                  # any number; each shines along u x v
  corner = [-1.0, 6.0, -1.0]
  u = [2.0, 0.0, 0.0]
  v = [0.0, 0.0, 2.0]
  colour = [1.0, 0.9, 0.8]   # linear red, green and blue
  image = \"window.png\"       # where it shines, and in which colours; or one of
  # tubes = { count = 5, width = 0.2, colours = [[1.0, 0.2, 0.2], [0.2, 0.4, 1.0]] }
  # polygons = [{ corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0]], colour = [1.0, 0.0, 0.0] }]
  [receiver]                 # on any plane in front of the lights
  corner = [-4.0, 0.0, -4.0]
  u = [8.0, 0.0, 0.0]        # columns of the image
  v = [0.0, 0.0, 8.0]        # rows of the image
  heights = \"ground.png\"     # moves it towards the light: white is height_scale; or \"bumps\"
  height_scale = 0.5
  self = true                # the heights cast shadows on themselves
  [motion]                   # light is accumulated over frames
  offset = [1.0, 0.0, 0.0]
  frames = 8
  part = \"door\"              # what moves; all where it is left out

Everything but the model or generator may be left out; options go before what the file says. The manual is
docs/shadows.md.";

/// Arguments of `sightlines shadows`.
#[derive(Args, Debug)]
pub(crate) struct ShadowsArgs {
    /// What casts the shadow.
    #[command(flatten)]
    pub(crate) source: Source,
    /// Picture of the result [default: shadow.png, where no other output is asked for].
    #[arg(short, long, value_name = "FILE.png")]
    pub(crate) output: Option<PathBuf>,
    /// Bits of a channel of the PNG.
    #[arg(long, value_enum, value_name = "8|16", default_value = "8")]
    pub(crate) bits: Bits,
    /// The result as OpenEXR, in f32: one channel, or three where there is colour.
    #[arg(long, value_name = "FILE.exr")]
    pub(crate) exr: Option<PathBuf>,
    /// The hidden-sample sets; with several lights, one file each (FILE.0.sets, FILE.1.sets, …).
    #[arg(long, value_name = "FILE.sets")]
    pub(crate) sets: Option<PathBuf>,
    /// What the pictures show.
    #[arg(long, value_enum, default_value = "share")]
    pub(crate) result: ResultName,
    /// Side of the default light, in radii of the scene [default: 0.4].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) light_size: Option<f64>,
    /// Texels a side of the receiver [default: 512].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(crate) resolution: Option<u32>,
    /// Samples of the light, 1 to 65536; each 1024 are a pass [default: 1024].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(crate) samples: Option<u32>,
    /// Where samples are: grid, jittered, halton, blue-noise, or a text file of points, u and v from 0 to 1 [default:
    /// grid].
    #[arg(long, value_name = "NAME|FILE")]
    pub(crate) pattern: Option<String>,
    /// Of what is random in a pattern and in shifts [default: 1].
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u32>,
    /// Which faces of the casters hide: a front is where vertices are seen counter-clockwise [default: both].
    #[arg(long, value_enum)]
    pub(crate) faces: Option<FacesName>,
    /// Cast shadows by a simplified mesh: a share of its triangles, `error=` a distance in scene units, or `auto`, as
    /// far as the light does not show it.
    #[arg(long, value_name = "TARGET", value_parser = Target::parse)]
    pub(crate) simplify: Option<Target>,
    /// Shift each receiver's pattern by a random part of a sample's distance to the next: noise for bands.
    #[arg(long)]
    pub(crate) decorrelate: bool,
    /// Samples a word of the sets: 32, or 31, with which a pass has 992.
    #[arg(long, value_name = "31|32")]
    pub(crate) word_bits: Option<u32>,
    /// Most colours of a light that are told apart [default: 24].
    #[arg(long, value_name = "N")]
    pub(crate) colours: Option<u32>,
    /// Move the receiver's points towards the light by a PNG of heights, or by `bumps`.
    #[arg(long, value_name = "FILE.png|bumps")]
    pub(crate) heights: Option<PathBuf>,
    /// What white is in heights, in scene units [default: 1].
    #[arg(long, value_name = "X", allow_negative_numbers = true, requires = "heights")]
    pub(crate) height_scale: Option<f64>,
    /// Let the heights cast shadows on themselves.
    #[arg(long = "self")]
    pub(crate) self_shadow: bool,
    /// Bake the texels of the scene's own surface, by its texture coordinates.
    #[arg(long)]
    pub(crate) lightmap: bool,
    /// Show the receiver in a camera's view, EYE/TARGET or EYE/TARGET/LENS: points as x,y,z, a lens as an angle in
    /// degrees or height=H; texels are then its pixels.
    #[arg(long, value_name = "CAMERA", allow_hyphen_values = true)]
    pub(crate) camera: Option<String>,
    /// Look a map of so many texels a side up in the camera's view, filtered: the picture has three panels, counted in
    /// the view, looked up, and how far they are apart.
    #[arg(long, value_name = "N", requires = "camera")]
    pub(crate) map: Option<u32>,
    /// Texels by which a lightmap's charts are widened.
    #[arg(long, value_name = "N", default_value = "4", value_parser = clap::value_parser!(u32).range(0..=64))]
    pub(crate) gutter: u32,
    /// Which samples count as hidden from a texel: those hidden from its centre, from all its neighbours too, or from
    /// any.
    #[arg(long, value_enum, default_value = "centre")]
    pub(crate) reading: ReadingName,
    /// Show which texels see one sample of the light, by its number.
    #[arg(long, value_name = "SAMPLE")]
    pub(crate) seen_from: Option<u32>,
    /// Move the scene by so much over the frames, and accumulate the light.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true, requires = "frames")]
    pub(crate) motion: Option<[f64; 3]>,
    /// Frames of the motion, 2 to 256.
    #[arg(long, value_name = "N")]
    pub(crate) frames: Option<u32>,
    /// The axis that points up [default: y].
    #[arg(long, value_enum)]
    pub(crate) up: Option<Axis>,
    /// Report pairs of triangle and receiver, and, on the interpreter, lane-operations and memory accesses.
    #[arg(long)]
    pub(crate) counts: bool,
    /// What it may take.
    #[command(flatten)]
    pub(crate) effort: EffortArgs,
    /// Where the machine is chosen.
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
}

/// Which faces of casters hide.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FacesName {
    /// Either.
    Both,
    /// Fronts alone.
    Front,
    /// Backs alone.
    Back,
}

impl From<FacesName> for Faces {
    fn from(name: FacesName) -> Self {
        match name {
            FacesName::Both => Faces::Both,
            FacesName::Front => Faces::Front,
            FacesName::Back => Faces::Back,
        }
    }
}

/// What pictures show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ResultName {
    /// The part of the light that is seen, in its colours.
    Share,
    /// The light that arrives, for a radiance of 1 times the light's colour; in the PNG the brightest is white.
    Irradiance,
}

/// Which samples count as hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReadingName {
    /// Those hidden from the texel's centre.
    Centre,
    /// Those hidden from it and all its neighbours.
    Conservative,
    /// Those hidden from it or any of its neighbours.
    Aggressive,
}

impl From<ReadingName> for Sets {
    fn from(name: ReadingName) -> Self {
        match name {
            ReadingName::Centre => Sets::Centre,
            ReadingName::Conservative => Sets::Conservative,
            ReadingName::Aggressive => Sets::Aggressive,
        }
    }
}

impl ShadowsArgs {
    /// What is asked for, with the files that it names.
    pub(crate) fn settings(&self) -> Result<Settings> {
        let placement = self.pattern.as_ref().map(|name| match Placement::from_name(name) {
            Some(known) => Ok(known),
            None => Placement::load(Path::new(name)),
        });
        let heights = |path: &PathBuf| {
            let name = path.to_string_lossy();
            HeightMap::named(path, &name, self.height_scale.unwrap_or(1.0))
        };
        let camera = |words: &String| {
            let up = if matches!(self.up, Some(Axis::Z)) { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] };
            Camera::parse(words, up)?.ok_or_else(|| {
                let remedy = "write EYE/TARGET or EYE/TARGET/LENS, as 4,3,6/0,1,0/45";
                Place::default().element("--camera").error(format!("`{words}` is no camera"), remedy)
            })
        };
        Ok(Settings {
            up: self.up.map(Into::into),
            light_size: self.light_size,
            resolution: self.resolution,
            samples: self.samples,
            placement: placement.transpose()?,
            seed: self.seed,
            decorrelated: self.decorrelate.then_some(true),
            faces: self.faces.map(Into::into),
            word_bits: self.word_bits,
            colours: self.colours,
            heights: self.heights.as_ref().map(heights).transpose()?,
            self_shadow: self.self_shadow.then_some(true),
            lightmap: self.lightmap.then_some(true),
            camera: self.camera.as_ref().map(camera).transpose()?,
            motion: self.motion,
            frames: self.frames,
        })
    }

    /// Refuses results that cannot be had together.
    pub(crate) fn check(&self, lights: usize, moves: bool) -> Result<()> {
        let clash = |option: &str, what: &str, remedy: &str| Err(Place::default().element(option).error(what, remedy));
        let reads = self.reading != ReadingName::Centre;
        let sums = self.result == ResultName::Irradiance;
        if self.seen_from.is_some() && (sums || lights > 1) {
            return clash(
                "--seen-from",
                "it is the view of one sample of one light",
                "give one light, and no --result",
            );
        }
        if reads && sums {
            let remedy = "leave out one of the two: light is summed at the centres of texels";
            return clash("--reading", "irradiance has no readings", remedy);
        }
        let others = sums || reads || self.seen_from.is_some() || self.exr.is_some() || self.sets.is_some();
        if self.map.is_some() && others {
            let remedy = "give it an -o and none of --result, --reading, --seen-from, --exr and --sets";
            return clash("--map", "a map that is looked up gives a picture of shares", remedy);
        }
        if reads && moves {
            return clash("--reading", "the scene moves, and a reading is of one frame", "leave out one of the two");
        }
        Ok(())
    }
}

fn vector(text: &str) -> Result<[f64; 3], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
    let numbers = numbers.map_err(|e| format!("{e}: write three numbers, as 1,0,-0.5"))?;
    numbers.try_into().map_err(|_| "write three numbers, as 1,0,-0.5".to_owned())
}

//! Arguments of `sightlines ambient`.

use std::path::PathBuf;

use clap::Args;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::ambient::{Environment, Filter, Lighting, Sphere, Weighting};
use sightlines_visibility::error::{Place, Result};
use sightlines_visibility::scene::{Motion, World};
use sightlines_visibility::setup::Up;

use crate::program::cli::{Axis, MachineArgs};
use crate::program::queries::{size, world};

/// What the long help says beyond the arguments.
pub(crate) const HELP: &str = "\
Every vertex is tested against directional lights all around, exactly, and shaded with what it sees of an environment:
white by default, which is plain ambient occlusion. With --matrix the visibility is kept in a file as it is computed;
after an interruption, or to refine it, --resume goes on from there. Seen from inside, the middle of an environment looks
along -z, with +x to its right and +y up, where y is up.

Each level has about four times as many directions as the one before: 6, 18, 66, 258, 1026, 4098, 16,386.";

/// Arguments of `sightlines ambient`.
#[derive(Args, Debug)]
pub(crate) struct AmbientArgs {
    /// What is shaded.
    #[command(flatten)]
    pub(crate) source: Source,
    /// The shaded scene: .glb or .ply; may be given several times [default: ambient.glb].
    #[arg(short, long, value_name = "FILE.glb|FILE.ply")]
    pub(crate) output: Vec<PathBuf>,
    /// The visibility matrix, written as it grows.
    #[arg(long, value_name = "FILE")]
    pub(crate) matrix: Option<PathBuf>,
    /// Pictures by the raster, one for each camera; with an orbit numbered before the extension.
    #[arg(long, value_name = "FILE.png")]
    pub(crate) picture: Option<PathBuf>,
    /// Where pictures are taken from: EYE/TARGET or EYE/TARGET/DEGREES, points as x,y,z [default: from above, in
    /// front].
    #[arg(long, value_name = "WORDS", requires = "picture", allow_hyphen_values = true)]
    pub(crate) camera: Option<String>,
    /// So many pictures on a circle around the scene.
    #[arg(long, value_name = "N", requires = "picture", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) orbit: Option<u32>,
    /// Columns and rows of pictures.
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "800x600")]
    pub(crate) size: Picture,
    /// Evaluate only what pictures come to show.
    #[arg(long, requires = "picture", conflicts_with_all = ["output", "matrix"])]
    pub(crate) lazy: bool,
    /// With fewer unseen triangles than this, --lazy evaluates the rest [default: a twentieth of all].
    #[arg(long, value_name = "N", requires = "lazy")]
    pub(crate) threshold: Option<usize>,
    /// So many frames of a motion, one picture each: of --motion, or of the first animation of a glTF model.
    #[arg(long, value_name = "N", requires = "picture", conflicts_with_all = ["output", "matrix", "lazy"],
        value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) frames: Option<u32>,
    /// Cost that a frame may have, in millions of a direction times a position or a triangle; the level follows from
    /// it.
    #[arg(long, value_name = "N", requires = "frames")]
    pub(crate) budget: Option<u64>,
    /// Go on with the matrix in the file, if there is one.
    #[arg(long, requires = "matrix")]
    pub(crate) resume: bool,
    /// Level of the light sphere, 0 to 6.
    #[arg(long, value_name = "N", default_value = "4", value_parser = clap::value_parser!(u8).range(0..=6))]
    pub(crate) level: u8,
    /// HEALPix directions of this order, 0 to 6, in place of the octahedron's.
    #[arg(long, value_name = "N", conflicts_with = "level", value_parser = clap::value_parser!(u8).range(0..=6))]
    pub(crate) healpix: Option<u8>,
    /// Light from all around: `white`, `sky`, or a map in Radiance HDR or OpenEXR.
    #[arg(long, value_name = "NAME|FILE", default_value = "white")]
    pub(crate) environment: PathBuf,
    /// Degrees by which the environment is turned, counter-clockwise as seen from above.
    #[arg(long, value_name = "DEGREES", default_value = "0", allow_negative_numbers = true)]
    pub(crate) rotate: f64,
    /// Standard deviation of the environment's filter in degrees [default: half the spacing of the directions].
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    pub(crate) blur: Option<f64>,
    /// Where that filter is one.
    #[arg(long, value_enum, default_value = "sphere")]
    pub(crate) filter: FilterName,
    /// How directions are weighed in the sum.
    #[arg(long, value_enum, default_value = "solid-angle")]
    pub(crate) weights: Weights,
    /// Cells of the grid that an occluder must be farther away than.
    #[arg(long, value_name = "CELLS", default_value = "1", value_parser = clap::value_parser!(u32).range(0..=32_768))]
    pub(crate) bias: u32,
    /// Colour that becomes one [default: 1 under a white environment, else what 98 % of the vertices stay below].
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    pub(crate) white: Option<f64>,
    /// Gamma of bytes in PLY files and pictures.
    #[arg(long, value_name = "X", default_value = "2.2", allow_negative_numbers = true)]
    pub(crate) gamma: f64,
    /// The axis that points up.
    #[arg(long, value_enum, default_value = "y")]
    pub(crate) up: Axis,
    /// Report what the work cost in numbers that do not depend on the machine.
    #[arg(long)]
    pub(crate) counts: bool,
    /// Where the machine is chosen.
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
}

/// What is shaded.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct Source {
    /// A mesh: OBJ, glTF (.gltf, .glb) or PLY.
    pub(crate) model: Option<PathBuf>,
    /// A generated scene, such as palms, trio or bumpy-70000.
    #[arg(long, value_name = "NAME", value_parser = world)]
    pub(crate) scene: Option<World>,
    /// A generated scene that moves: `skeleton` or `cloth`.
    #[arg(long, value_name = "NAME", value_parser = motion)]
    pub(crate) motion: Option<Motion>,
}

fn motion(name: &str) -> Result<Motion, String> {
    Motion::from_name(name).ok_or_else(|| "choose skeleton or cloth".to_owned())
}

/// Where the environment is filtered.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(crate) enum FilterName {
    /// On the sphere, by angle.
    Sphere,
    /// In the map, by texels, as in the paper.
    Map,
}

/// How directions are weighed.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub(crate) enum Weights {
    /// By solid angle.
    SolidAngle,
    /// All the same.
    Equal,
}

impl AmbientArgs {
    pub(crate) fn sphere(&self) -> Sphere {
        match self.healpix {
            Some(order) => Sphere::Healpix { order: order.into() },
            None => Sphere::Octahedron { level: self.level.into() },
        }
    }

    pub(crate) fn up(&self) -> Up {
        self.up.into()
    }

    /// The environment, and whether it is all one.
    pub(crate) fn environment(&self) -> Result<(Environment, bool)> {
        match self.environment.to_str() {
            Some("white") => Ok((Environment::white(), true)),
            Some("sky") => Ok((Environment::sky(), false)),
            _ => Ok((Environment::load(&self.environment)?, false)),
        }
    }

    pub(crate) fn lighting(&self) -> Lighting {
        let weighting = match self.weights {
            Weights::SolidAngle => Weighting::SolidAngle,
            Weights::Equal => Weighting::Equal,
        };
        let filter = match self.filter {
            FilterName::Sphere => Filter::Sphere,
            FilterName::Map => Filter::Map,
        };
        Lighting { up: self.up(), turn: self.rotate, blur: self.blur, filter, weighting, ..Lighting::DEFAULT }
    }

    /// Refuses numbers that make no sense, before any work.
    pub(crate) fn check(&self) -> Result<()> {
        let refuse = |option: &str, value: f64, remedy: &str| {
            Err(Place::default().element(option).error(format!("{value:?} is out of range"), remedy))
        };
        if !self.rotate.is_finite() || self.rotate.abs() > 1e6 {
            return refuse("--rotate", self.rotate, "choose degrees within a million");
        }
        if let Some(blur) = self.blur.filter(|blur| !(0.0..=90.0).contains(blur)) {
            return refuse("--blur", blur, "choose 0 to 90 degrees");
        }
        if let Some(white) = self.white.filter(|white| !(1e-6..=1e9).contains(white)) {
            return refuse("--white", white, "choose 1e-6 to 1e9");
        }
        if !(0.1..=10.0).contains(&self.gamma) {
            return refuse("--gamma", self.gamma, "choose 0.1 to 10");
        }
        Ok(())
    }
}

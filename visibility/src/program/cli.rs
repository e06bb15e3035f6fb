//! The command line, and nothing but the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use sightlines_visibility::image::Depth;
use sightlines_visibility::scene::Generator;
use sightlines_visibility::setup::Up;

use super::ambient::{self, args::AmbientArgs};
use super::compare::{self, CompareArgs};
use super::cull::{self, CullArgs};
use super::queries::{QUERIES_HELP, QueriesArgs};
use super::shadows::args::{SHADOWS_HELP, ShadowsArgs};

const AFTER_HELP: &str = "\
Exit codes:
  0  done
  1  the work failed, or a result could not be written
  2  the command line, the model or the scene file is wrong
  3  the backend or adapter asked for is missing";

/// Who sees whom, how much, and which rays: exact visibility, the same bits on a GPU and without one.
#[derive(Debug, Parser)]
#[command(name = "sightlines", version, after_help = AFTER_HELP, disable_help_subcommand = true)]
pub(crate) struct Cli {
    /// What to compute.
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to compute.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Bake what receivers see of area lights: soft shadows, irradiance, lightmaps.
    #[command(after_help = AFTER_HELP, after_long_help = format!("{SHADOWS_HELP}\n\n{AFTER_HELP}"))]
    Shadows(ShadowsArgs),
    /// Bake one soft shadow by several methods, and compare.
    #[command(after_help = AFTER_HELP, after_long_help = format!("{}\n\n{AFTER_HELP}", compare::HELP))]
    Compare(CompareArgs),
    /// Count the pixels that are seen of every instance, and where.
    #[command(after_help = AFTER_HELP, after_long_help = format!("{QUERIES_HELP}\n\n{AFTER_HELP}"))]
    Queries(QueriesArgs),
    /// Cull by such counts: shadow volumes, prisms, detail, what veils hide.
    #[command(after_help = AFTER_HELP, after_long_help = format!("{}\n\n{AFTER_HELP}", cull::HELP))]
    Cull(CullArgs),
    /// Shade a scene by what its vertices see of an environment.
    #[command(after_help = AFTER_HELP, after_long_help = format!("{}\n\n{AFTER_HELP}", ambient::args::HELP))]
    Ambient(AmbientArgs),
}

/// What casts the shadow.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub(crate) struct Source {
    /// A mesh: OBJ, glTF (.gltf, .glb) or PLY.
    pub(crate) model: Option<PathBuf>,
    /// A generated scene.
    #[arg(long, value_name = "NAME", value_parser = generator)]
    pub(crate) scene: Option<Generator>,
    /// A scene file: model or generator, lights, receiver, resolution, samples.
    #[arg(long, value_name = "FILE.toml")]
    pub(crate) scene_file: Option<PathBuf>,
}

/// Which machine runs the kernels.
#[derive(Args, Debug)]
pub(crate) struct MachineArgs {
    /// The interpreter, a GPU through wgpu, or a GPU if there is one.
    #[arg(long, value_enum, default_value = "auto")]
    pub(crate) backend: BackendName,
    /// Adapter of the wgpu backend, by part of its name or driver; software adapters run only when named.
    #[arg(long, value_name = "NAME")]
    pub(crate) adapter: Option<String>,
    /// Threads of the interpreter, which `auto` then takes [default: all cores].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,
}

/// A backend by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum BackendName {
    /// The interpreter.
    Cpu,
    /// The GPU backend.
    Wgpu,
    /// The GPU backend where there is a GPU, else the interpreter.
    Auto,
}

/// Bits of a pixel.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Bits {
    /// 256 greys.
    #[value(name = "8")]
    Eight,
    /// 65,536 greys.
    #[value(name = "16")]
    Sixteen,
}

impl From<Bits> for Depth {
    fn from(bits: Bits) -> Self {
        match bits {
            Bits::Eight => Depth::Eight,
            Bits::Sixteen => Depth::Sixteen,
        }
    }
}

/// An axis.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Axis {
    /// As glTF and most OBJ files have it.
    Y,
    /// As most CAD programs have it.
    Z,
}

impl Axis {
    /// One unit along it.
    pub(crate) fn vector(self) -> [f64; 3] {
        match self {
            Axis::Y => [0.0, 1.0, 0.0],
            Axis::Z => [0.0, 0.0, 1.0],
        }
    }
}

impl From<Axis> for Up {
    fn from(axis: Axis) -> Self {
        match axis {
            Axis::Y => Up::Y,
            Axis::Z => Up::Z,
        }
    }
}

/// A generated scene by name.
pub(crate) fn generator(name: &str) -> Result<Generator, String> {
    let names = || Generator::ALL.map(Generator::name).join(", ");
    Generator::from_name(name).ok_or_else(|| format!("choose one of {}", names()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn command_lines_are_taken_and_refused() {
        let parse = |line: &str| Cli::try_parse_from(["sightlines"].into_iter().chain(line.split_whitespace()));
        for good in [
            "shadows a.obj -o a.png --exr a.exr --sets a.sets --light-size 1 --resolution 64 --samples 32 --up z",
            "shadows --scene palms --backend cpu --threads 2 --bits 16 --counts",
            "shadows --scene-file a.toml --backend wgpu --adapter llvmpipe",
            "compare --scene palms --light-size 0.1,0.4 --samples 32,64 --resolution 64 -o a.png --csv a.csv",
            "queries a.glb --camera front --camera 1,2,3/0,0,0/60 --tiles 3 --json a.json --heat a.png",
            "queries --scene crowd-100 --method sat --channels 8 --size 640x480 --path a.txt --seen a.seen",
            "queries --scene hall --camera -1,2,-3/0,0,0 --orbit 8 --clusters 4 --csv a.csv --backend cpu",
            "cull volumes --scene crowd-100 --light 9,9,0/0,0,0 --picture a.png --size 320x240 --method sat",
            "cull veils a.glb --veil glass*=0.5 --veil smoke=0.1 --least 4 --camera Front",
            "ambient a.ply -o a.glb -o b.ply --matrix a.occl --resume --level 6 --environment sky.hdr --rotate -30 --blur 2",
            "ambient a.glb --picture a.png --camera -4,3,6/0,1,0/60 --orbit 12 --size 320x200 --lazy --threshold 100",
            "ambient --motion skeleton --picture a.png --frames 24 --budget 100",
            "ambient --scene palms --healpix 3 --bias 4 --weights equal --white 2 --gamma 1 --up z --counts",
        ] {
            assert!(parse(good).is_ok(), "{good}");
        }
        for bad in [
            "",
            "shadows",
            "shadows a.obj --scene palms",
            "shadows --scene forest",
            "shadows a.obj --backend gpu",
            "shadows a.obj --threads 0",
            "shadows a.obj --up x",
            "shadows a.obj --resolution many",
            "compare a.obj --samples few",
            "compare --no-projections",
            "queries",
            "queries a.obj --method zbuffer",
            "queries a.obj --size 640",
            "queries a.obj --size 0x4",
            "queries --scene crowd-0",
            "queries a.obj --tiles 9",
            "cull",
            "cull teapots",
            "cull detail a.obj --scene crowd-20",
            "ambient a.obj --level 7",
            "ambient a.obj --level 2 --healpix 2",
            "ambient a.obj --resume",
            "ambient a.obj --bias -1",
            "ambient a.obj --orbit 3",
            "ambient a.obj --picture a.png --lazy --matrix a.occl",
            "ambient a.obj --picture a.png --budget 3",
            "ambient --motion dance",
            "ambient a.obj --frames 3",
        ] {
            assert!(parse(bad).is_err(), "{bad}");
        }
    }
}

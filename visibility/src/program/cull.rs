//! `sightlines cull`: what visibility queries are for. Each application culls by counts, shows that no pixel was lost,
//! and draws what it culled.

mod applications;

use std::io::Write;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use sightlines_kernels::raster::Picture;
use sightlines_visibility::error::{Place, Result};
use sightlines_visibility::queries::Method;
use sightlines_visibility::queries::files::write_rgb;
use sightlines_visibility::queries::picture::{Pixels, beside};
use sightlines_visibility::scene::{Camera, World, creature_in_hall, crowd, load_world};

use super::cli::{Axis, MachineArgs};
use super::queries::{MethodName, camera, size, world};
use super::{Failure, machine, targets};

/// Printed behind the options.
pub(crate) const HELP: &str = "\
What is culled:
  volumes  shadow volumes of instances that the light (--light) does not see
  prisms   prisms of a displaced creature whose hull is not seen: the scene `hall` alone
  detail   instances that are not seen; in the scenes crowd-N balls that show few pixels are coarser, too
  veils    instances of which nothing is seen through transparent ones (--veil)

Pictures (--picture) have two panels. Orange is kept, blue is culled.
  volumes  from the camera, and from the light, which sees none that is blue
  prisms   from the camera, and from above
  detail   from the camera as it was drawn, and from above: orange, yellow and green are levels from fine to coarse
  veils    through the veils, and without them";

/// Arguments of `sightlines cull`.
#[derive(Args, Debug)]
pub(crate) struct CullArgs {
    /// What is culled.
    #[arg(value_enum)]
    what: What,
    /// A scene: OBJ, glTF (.gltf, .glb) or PLY.
    model: Option<PathBuf>,
    /// A generated scene [default: hall for prisms, else crowd-200].
    #[arg(long, value_name = "NAME", value_parser = world, conflicts_with = "model")]
    scene: Option<World>,
    /// Where from [default: the scene's first camera; for prisms `partial`].
    #[arg(long, value_name = "CAMERA", allow_hyphen_values = true)]
    camera: Option<String>,
    /// The light's view (volumes) [default: the scene's camera `light`].
    #[arg(long, value_name = "CAMERA", allow_hyphen_values = true)]
    light: Option<String>,
    /// Instances that let a share of light through, from 0 to 1, by their names, all that begin so where a * ends it
    /// (veils); may be repeated.
    #[arg(long, value_name = "NAME=SHARE")]
    veil: Vec<String>,
    /// Least that must be seen of an instance, in whole pixels; 0 keeps all of which anything is seen (veils).
    #[arg(long, value_name = "PIXELS", default_value = "0", value_parser = clap::value_parser!(u32).range(..=1 << 24))]
    least: u32,
    /// Columns and rows of the picture.
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "512x512")]
    size: Picture,
    /// How pixels are counted.
    #[arg(long, value_enum, default_value = "hib")]
    method: MethodName,
    /// Count in 2^T by 2^T tiles (prisms, hib).
    #[arg(long, value_name = "T", default_value = "5", value_parser = clap::value_parser!(u32).range(0..=8))]
    tiles: u32,
    /// The two panels.
    #[arg(long, value_name = "FILE.png")]
    picture: Option<PathBuf>,
    /// The axis that points up.
    #[arg(long, value_enum, default_value = "y")]
    up: Axis,
    /// Where the machine is chosen.
    #[command(flatten)]
    machine: MachineArgs,
}

/// An application.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum What {
    /// Shadow volumes.
    Volumes,
    /// Prisms of displacement.
    Prisms,
    /// Levels of detail.
    Detail,
    /// What is behind transparent instances.
    Veils,
}

impl CullArgs {
    fn method(&self) -> Method {
        match self.method {
            MethodName::Hib => Method::HIB,
            MethodName::Sat => Method::SAT,
        }
    }

    fn world(&self) -> Result<World> {
        let refused =
            |element: &str, what: &str, remedy: &str| Err(Place::default().element(element).error(what, remedy));
        if self.what != What::Veils && (!self.veil.is_empty() || self.least > 0) {
            return refused("--veil", "veils and what is seen through them belong to `cull veils`", "leave them out");
        }
        if self.what != What::Volumes && self.light.is_some() {
            return refused("--light", "a light belongs to `cull volumes`", "leave it out");
        }
        match (self.what, &self.model, &self.scene) {
            (What::Prisms, None, None) => Ok(creature_in_hall()),
            (What::Prisms, None, Some(scene)) if scene.name == "hall" => Ok(scene.clone()),
            (What::Prisms, ..) => refused("scene", "prisms are those of the scene `hall`", "leave the scene out"),
            (_, Some(model), _) => load_world(model),
            (_, None, Some(scene)) => Ok(scene.clone()),
            (_, None, None) => Ok(crowd(200)),
        }
    }

    /// A camera from its words, or the one of a name, or the first.
    fn view(&self, words: Option<&String>, otherwise: Option<&str>, world: &World, option: &str) -> Result<Camera> {
        let place = || Place::default().element(option);
        let first = || world.cameras.first().map(|camera| camera.name.clone());
        let Some(words) = words.cloned().or_else(|| otherwise.map(str::to_owned)).or_else(first) else {
            let what = format!("scene `{}` has no camera", world.name);
            return Err(place().error(what, "give one, as 4,3,6/0,1,0 or 4,3,6/0,1,0/60"));
        };
        camera(&words, world, self.up.vector(), place)
    }
}

/// What an application found: lines of the report, and two panels if they were asked for.
struct Found {
    lines: Vec<(&'static str, String)>,
    panels: Vec<Pixels>,
}

/// Culls, reports and writes.
pub(crate) fn run(args: &CullArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let world = args.world()?;
    targets::check(args.picture.as_deref())?;
    let backend = machine::open(&args.machine, false)?;
    writeln!(out, "scene      {}: {} triangles", world.name, world.triangle_count())?;
    let reading = if args.method().is_exact() { "exact" } else { "never fewer than are visible" };
    writeln!(out, "method     {}, {reading}", args.method().name())?;
    out.flush()?;
    let found = match args.what {
        What::Volumes => applications::volumes(args, &*backend, &world),
        What::Prisms => applications::prisms(args, &*backend, &world),
        What::Detail => applications::detail(args, &*backend, world),
        What::Veils => applications::veils(args, &*backend, &world),
    }?;
    for (name, line) in &found.lines {
        writeln!(out, "{name:<10} {line}")?;
    }
    if let Some(path) = &args.picture {
        let (size, bytes) = beside([args.size.width, args.size.height], &found.panels);
        write_rgb(path, size, &bytes)?;
        writeln!(out, "wrote      {}", path.display())?;
    }
    Ok(writeln!(out, "backend    {}", machine::describe(&backend.info()))?)
}

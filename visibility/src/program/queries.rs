//! `sightlines queries`: a scene and cameras in, counts of pixels out, as a table and in files.

mod report;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use sightlines_backend::Backend;
use sightlines_kernels::item_histogram::Order;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::error::{Place, Result};
use sightlines_visibility::queries::files::{View, write_csv, write_heat_map, write_json, write_seen};
use sightlines_visibility::queries::{Granularity, Method, Stage, query, share};
use sightlines_visibility::scene::frame::Frame;
use sightlines_visibility::scene::{Camera, Generator, World, generate_world, load_world};

use super::cli::{Axis, MachineArgs};
use super::progress::Progress;
use super::{Failure, machine, targets};

/// Most words of pixels and tiles that are held until the files are written.
const MAX_WORDS: usize = 1 << 28;

/// Printed behind the options.
pub(crate) const QUERIES_HELP: &str = "\
A camera is the name of one in the scene, or EYE/TARGET or EYE/TARGET/LENS: points as x,y,z, a lens as the angle from
bottom to top in degrees (45 by default) or, without perspective, as the height of the picture (height=8). A path is a
text file with a camera a line; what follows # is not read. Without any, the scene's first camera is taken.

Methods:
  hib  item buffer and histogram: exact counts, of instances or clusters of triangles
  sat  summed-area tables of colour channels: never fewer than are visible; up to 2,000 instances";

/// Arguments of `sightlines queries`.
#[derive(Args, Debug)]
pub(crate) struct QueriesArgs {
    /// What is seen.
    #[command(flatten)]
    source: Source,
    /// Where from; may be repeated.
    #[arg(long, value_name = "CAMERA", allow_hyphen_values = true)]
    camera: Vec<String>,
    /// A file of cameras, one a line; they come after those of --camera.
    #[arg(long, value_name = "FILE.txt")]
    path: Option<PathBuf>,
    /// So many cameras on a circle through the last one, about the scene's middle, in its place.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    orbit: Option<u32>,
    /// Columns and rows of the picture.
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "1024x1024")]
    size: Picture,
    /// How pixels are counted.
    #[arg(long, value_enum, default_value = "hib")]
    method: MethodName,
    /// Count in 2^T by 2^T tiles too.
    #[arg(long, value_name = "T", default_value = "0", value_parser = clap::value_parser!(u32).range(0..=8))]
    tiles: u32,
    /// Count clusters of 2^N neighbouring triangles, not instances.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=30))]
    clusters: Option<u32>,
    /// Take pixels in a scattered order (hib): the same counts, fewer collisions.
    #[arg(long)]
    scattered: bool,
    /// Colour channels (sat) [default: 4].
    #[arg(long, value_name = "N")]
    channels: Option<u32>,
    /// Most rectangles an instance is divided into (sat) [default: what the number of instances allows].
    #[arg(long, value_name = "N")]
    regions: Option<u32>,
    /// Counts as JSON.
    #[arg(long, value_name = "FILE.json")]
    json: Option<PathBuf>,
    /// Counts as CSV.
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Picture of the visible share of each instance; with several cameras, one file each (FILE.0.png, …).
    #[arg(long, value_name = "FILE.png")]
    heat: Option<PathBuf>,
    /// The visible sets of all cameras.
    #[arg(long, value_name = "FILE.seen")]
    seen: Option<PathBuf>,
    /// Leave out what instances would cover with nothing in front, for which they are drawn again in layers.
    #[arg(long, conflicts_with = "heat")]
    no_shares: bool,
    /// The axis that points up.
    #[arg(long, value_enum, default_value = "y")]
    up: Axis,
    /// Report what it took.
    #[arg(long)]
    counts: bool,
    /// Where the machine is chosen.
    #[command(flatten)]
    machine: MachineArgs,
}

/// What is seen.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
struct Source {
    /// A scene: OBJ, glTF (.gltf, .glb) or PLY.
    model: Option<PathBuf>,
    /// A generated scene: crowd-1 to crowd-2000, hall, palms, box, quads, colonnade.
    #[arg(long, value_name = "NAME", value_parser = world)]
    scene: Option<World>,
}

/// A method by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MethodName {
    /// The hierarchical item buffer.
    Hib,
    /// Summed-area tables.
    Sat,
}

/// A generated world by name.
pub(crate) fn world(name: &str) -> Result<World, String> {
    let more = || Generator::ALL.map(Generator::name).join(", ");
    let names = || format!("choose crowd-1 to crowd-2000, bumpy-24 to bumpy-2000000, hall, trio, {}", more());
    generate_world(name).ok_or_else(names)
}

pub(crate) fn size(words: &str) -> Result<Picture, String> {
    let sides = words.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let fits = |side: u32| (1..=Picture::MAX_SIDE).contains(&side);
    let (width, height) = sides
        .filter(|(w, h)| fits(*w) && fits(*h))
        .ok_or_else(|| format!("give columns and rows, as 640x480, each 1 to {}", Picture::MAX_SIDE))?;
    Ok(Picture { width, height })
}

impl QueriesArgs {
    fn method(&self) -> Result<Method> {
        let only = |given: bool, option: &str, method: &str| {
            let place = Place::default().element(option);
            let what = format!("it belongs to the method {method}");
            if given { Err(place.error(what, format!("leave it out, or choose --method {method}"))) } else { Ok(()) }
        };
        match self.method {
            MethodName::Hib => {
                only(self.channels.is_some(), "--channels", "sat")?;
                only(self.regions.is_some(), "--regions", "sat")?;
                Ok(Method::Hib { order: if self.scattered { Order::Scattered } else { Order::Memory } })
            }
            MethodName::Sat => {
                only(self.scattered, "--scattered", "hib")?;
                only(self.clusters.is_some(), "--clusters", "hib")?;
                Ok(Method::Sat { channels: self.channels.unwrap_or(4), limit: self.regions })
            }
        }
    }

    /// The cameras in order: those named, those of the path, or the scene's first.
    fn cameras(&self, world: &World) -> Result<Vec<Camera>> {
        let mut cameras = Vec::new();
        for words in &self.camera {
            cameras.push(camera(words, world, self.up.vector(), || Place::default().element("--camera"))?);
        }
        if let Some(path) = &self.path {
            cameras.extend(read_path(path, world, self.up.vector())?);
        }
        if cameras.is_empty() {
            let Some(first) = world.cameras.first() else {
                let what = format!("scene `{}` has no camera", world.name);
                return Err(Place::default()
                    .element("--camera")
                    .error(what, "give one, as 4,3,6/0,1,0 or 4,3,6/0,1,0/60"));
            };
            cameras.push(first.clone());
        }
        if let Some(count) = self.orbit
            && let Some(last) = cameras.pop()
        {
            let middle = extents(world).map(|[low, high]| 0.5 * low + 0.5 * high);
            cameras.extend(last.orbit(middle, self.up.vector(), count)?);
        }
        Ok(cameras)
    }

    /// What of a view is needed until the files are written; refused where that of all cameras is too much to hold.
    fn kept(&self, mut view: View, cameras: usize) -> Result<View> {
        view.answer.depths = Vec::new();
        if self.heat.is_none() {
            view.answer.shown = Vec::new();
        }
        let words = (view.answer.shown.len() + view.answer.tiles.len()) * cameras;
        if words > MAX_WORDS {
            let what = format!("the answers of {cameras} cameras have {} MiB", words >> 18);
            let remedy = format!("at most {} MiB are held: ask for fewer cameras, pixels or tiles", MAX_WORDS >> 18);
            return Err(Place::default().element("--size").error(what, remedy));
        }
        Ok(view)
    }

    fn targets(&self, cameras: usize) -> Vec<PathBuf> {
        let heat = self.heat.iter().flat_map(|path| (0..cameras).map(move |n| targets::numbered(path, n, cameras)));
        heat.chain(self.json.clone()).chain(self.csv.clone()).chain(self.seen.clone()).collect()
    }
}

/// Least and greatest coordinates of the scene's box along each axis.
pub(crate) fn extents(world: &World) -> [[f64; 2]; 3] {
    let corners = world.corners();
    let range = |axis: usize| {
        let along = || corners.as_flattened().iter().map(|corner| corner[axis]);
        [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
    };
    [0, 1, 2].map(range)
}

/// A camera of the scene by name, or from its words.
pub(crate) fn camera(words: &str, world: &World, up: [f64; 3], place: impl Fn() -> Place) -> Result<Camera> {
    if let Some(known) = world.cameras.iter().find(|camera| camera.name == words) {
        return Ok(known.clone());
    }
    Camera::parse(words, up)?.ok_or_else(|| {
        let names: Vec<&str> = world.cameras.iter().map(|camera| &*camera.name).collect();
        let has = if names.is_empty() { "has none".to_owned() } else { format!("has {}", names.join(", ")) };
        let what = format!("there is no camera `{words}`: scene `{}` {has}", world.name);
        place().error(what, "name one of the scene, or give EYE/TARGET, as 4,3,6/0,1,0")
    })
}

/// A camera a line.
fn read_path(path: &Path, world: &World, up: [f64; 3]) -> Result<Vec<Camera>> {
    let text = sightlines_visibility::scene::read_text(path)?;
    let mut cameras = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let words = line.split('#').next().unwrap_or_default().trim();
        let place = || Place::line(path, number + 1);
        if !words.is_empty() {
            cameras.push(camera(words, world, up, place).map_err(|error| error.at(place()))?);
        }
    }
    if cameras.is_empty() {
        return Err(Place::file(path).error("there is no camera in it", "write one a line, as 4,3,6/0,1,0"));
    }
    Ok(cameras)
}

/// Counts, writes and reports.
pub(crate) fn run(args: &QueriesArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let method = args.method()?;
    let world = match (&args.source.model, &args.source.scene) {
        (Some(model), _) => load_world(model)?,
        (None, Some(scene)) => scene.clone(),
        (None, None) => return Ok(()),
    };
    let cameras = args.cameras(&world)?;
    let targets = args.targets(cameras.len());
    targets::check(targets.iter().map(PathBuf::as_path))?;
    let backend = machine::open(&args.machine, args.counts)?;
    report::scene(&world, out)?;
    let mut views = Vec::with_capacity(cameras.len());
    for camera in &cameras {
        let frame = Frame::new(camera, args.size, world.corners().as_flattened())?;
        let view = view(args, &*backend, &world, camera, frame, method)?;
        report::view(&view, &world, frame.near, args.counts, out)?;
        views.push(args.kept(view, cameras.len())?);
    }
    write(args, &world, &views)?;
    report::backend(&backend.info(), out)?;
    targets.iter().try_for_each(|path| writeln!(out, "wrote      {}", path.display()))?;
    Ok(())
}

/// One camera's counts.
fn view(
    args: &QueriesArgs,
    backend: &dyn Backend,
    world: &World,
    camera: &Camera,
    frame: Frame,
    method: Method,
) -> Result<View> {
    let granularity = args.clusters.map_or(Granularity::Instances, |shift| Granularity::Clusters { shift });
    let all: Vec<usize> = (0..world.instances.len()).collect();
    let stage = Stage::new(world, frame, &all, granularity)?;
    let progress = Progress::new(format!("camera {}", camera.name));
    let answer = query(backend, &stage, method, args.tiles, &mut |share| progress.show(0.5 * share))?;
    if answer.visible() == 0 {
        let what = format!("camera `{}` sees nothing of the scene", camera.name);
        return Err(Place::default().element("camera").error(what, "turn it to the scene, or move it"));
    }
    let mut covered = vec![None; answer.items.len()];
    if granularity == Granularity::Instances && !args.no_shares {
        let seen: Vec<usize> = (0..covered.len()).filter(|item| answer.totals[*item] > 0).collect();
        let found = share::covered(backend, &stage, &seen, &mut |done| progress.show(0.5 + 0.5 * done))?;
        seen.into_iter().zip(found).for_each(|(item, pixels)| covered[item] = Some(pixels));
    }
    let Picture { width, height } = args.size;
    Ok(View { camera: camera.name.clone(), size: [width, height], answer, covered })
}

fn write(args: &QueriesArgs, world: &World, views: &[View]) -> Result<()> {
    if let Some(path) = &args.heat {
        for (number, view) in views.iter().enumerate() {
            write_heat_map(&targets::numbered(path, number, views.len()), view)?;
        }
    }
    args.json.as_ref().map_or(Ok(()), |path| write_json(path, world, views))?;
    args.csv.as_ref().map_or(Ok(()), |path| write_csv(path, world, views))?;
    args.seen.as_ref().map_or(Ok(()), |path| write_seen(path, world, views))
}

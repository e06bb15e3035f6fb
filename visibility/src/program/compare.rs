//! `sightlines compare`: one soft shadow by several methods, their differences, work and times.

mod curves;
mod methods;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use sightlines_visibility::compare::write_csv;
use sightlines_visibility::image::write_panels;
use sightlines_visibility::scene;
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::Request;
use sightlines_visibility::simplify::Target;

use super::cli::{Axis, MachineArgs, Source};
use super::{Failure, machine, targets};
use methods::{Methods, coarser, light_side};

/// Printed behind the options.
pub(crate) const HELP: &str = "\
Methods:
  sampling     visibility sampling, as `sightlines shadows`: the triangles once, all samples of a receiver together
  projections  Heckbert and Herf: the triangles once for each sample, a bit plane each; the same bits, or exit code 1
  tables       the order of the paper: regions, three look-ups in a table of 512 angles and distances; wrong by its texels
  volumes      soft shadow volumes: what silhouettes seen from the light's centre hide, added up; of closed meshes
  maps         soft shadow maps: what texels of a depth map from the light's centre hide, added up, without a kernel
  simplified   visibility sampling of a simplified mesh, for each target of --simplify

Several light sizes, resolutions or numbers of samples, separated by commas, make a run each. `differ` is the part of all
samples of all receivers that is not as sampling has it, `error` the mean difference of the shares of the light. A picture has
five panels: sampling, volumes and how far they are off, maps and how far they are off.";

/// Arguments of `sightlines compare`.
#[derive(Args, Debug)]
pub(crate) struct CompareArgs {
    /// What casts the shadow.
    #[command(flatten)]
    source: Source,
    /// Sides of the light, in radii of the scene [default: 0.4].
    #[arg(long, value_name = "X,…", value_delimiter = ',', allow_hyphen_values = true)]
    light_size: Vec<f64>,
    /// Texels a side of the receiver [default: 256].
    #[arg(long, value_name = "N,…", value_delimiter = ',')]
    resolution: Vec<u32>,
    /// Samples of the light: 32, 64, 128, 256, 512 or 1024 [default: 256].
    #[arg(long, value_name = "N,…", value_delimiter = ',')]
    samples: Vec<u32>,
    /// The axis that points up [default: y].
    #[arg(long, value_enum)]
    up: Option<Axis>,
    /// Simplify the mesh too: to a share of its triangles, `error=` a distance in scene units, or `auto`, by the
    /// light's size.
    #[arg(long, value_name = "TARGET,…", value_delimiter = ',', value_parser = Target::parse)]
    simplify: Vec<Target>,
    /// Leave out the projections, whose work grows with the samples.
    #[arg(long)]
    no_projections: bool,
    /// Pictures; of several runs, one file each (FILE.0.png, …).
    #[arg(short, long, value_name = "FILE.png")]
    output: Option<PathBuf>,
    /// A row for every run and method.
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
    /// Lane-operations of all runs as curves, from the interpreter.
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// Where the machine is chosen.
    #[command(flatten)]
    machine: MachineArgs,
}

/// Runs all methods on all settings, writes and reports.
pub(crate) fn run(args: &CompareArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let settings = args.all_settings();
    let pictures: Vec<PathBuf> = args
        .output
        .iter()
        .flat_map(|path| (0..settings.len()).map(|number| targets::numbered(path, number, settings.len())))
        .collect();
    let setups = settings.iter().map(|settings| args.setup(settings)).collect::<Result<Vec<_>, _>>()?;
    targets::check(pictures.iter().chain(&args.csv).chain(&args.plot).map(PathBuf::as_path))?;
    let coarse = setups.iter().map(|setup| coarser(args, setup)).collect::<Result<Vec<_>, _>>()?;
    let backend = machine::open(&args.machine, false)?;
    writeln!(out, "backend    {}", machine::describe(&backend.info()))?;
    let (mut runs, mut differ) = (Vec::new(), 0);
    for (number, (setup, coarse)) in setups.iter().zip(&coarse).enumerate() {
        let request = setup.request();
        let light = light_side(&request);
        let Request { resolution, samples, .. } = request;
        writeln!(out, "\n{resolution} x {resolution} receivers, {samples} samples, a light {light:.4} units wide")?;
        let methods = Methods::run(&*backend, args, setup, coarse, out)?;
        methods.report(args, out)?;
        differ += methods.bits;
        runs.extend(methods.rows);
        if let Some(path) = pictures.get(number) {
            write_panels(path, &methods.panels)?;
            writeln!(out, "wrote      {}", path.display())?;
        }
    }
    if let Some(path) = &args.csv {
        write_csv(path, &runs)?;
        writeln!(out, "wrote      {}", path.display())?;
    }
    if let Some(path) = &args.plot {
        curves::plot(&runs, &setups[0].scene.name).write(path)?;
        writeln!(out, "wrote      {}", path.display())?;
    }
    if differ > 0 { Err(Failure::Differ(differ)) } else { Ok(()) }
}

impl CompareArgs {
    /// One for each combination.
    fn all_settings(&self) -> Vec<Settings> {
        let or = |given: &[u32], other: u32| if given.is_empty() { vec![other] } else { given.to_vec() };
        let sizes: Vec<Option<f64>> = self.light_size.iter().map(|size| Some(*size)).collect();
        let sizes = if sizes.is_empty() { vec![None] } else { sizes };
        let (resolutions, samples) = (or(&self.resolution, 256), or(&self.samples, 256));
        let up = self.up.map(Into::into);
        let of = |light_size, resolution, samples| Settings {
            up,
            light_size,
            resolution: Some(resolution),
            samples: Some(samples),
            ..Settings::default()
        };
        let pairs = sizes.iter().flat_map(|size| resolutions.iter().map(move |resolution| (*size, *resolution)));
        pairs.flat_map(|(size, resolution)| samples.iter().map(move |n| of(size, resolution, *n))).collect()
    }

    fn setup(&self, settings: &Settings) -> sightlines_visibility::Result<Setup> {
        match (&self.source.scene_file, &self.source.model, self.source.scene) {
            (Some(file), ..) => Setup::load(file, settings),
            (None, Some(model), _) => Setup::new(scene::load(model)?, settings),
            (None, None, generator) => {
                Setup::new(scene::generate(generator.unwrap_or(scene::Generator::Palms)), settings)
            }
        }
    }
}

//! `sightlines compare`: one soft shadow by several methods, their differences, work and times.

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use sightlines_backend::Backend;
use sightlines_visibility::compare::{Run, projections, volumes, write_csv};
use sightlines_visibility::image::{Share, write_panels};
use sightlines_visibility::scene;
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::{Bake, Request, Work, bake};

use super::cli::{Axis, MachineArgs, Source};
use super::progress::Progress;
use super::{Failure, machine, targets};

/// Printed behind the options.
pub(crate) const HELP: &str = "\
Methods:
  sampling     visibility sampling, as `sightlines shadows`: the triangles once, all samples of a receiver together
  projections  Heckbert and Herf: the triangles once for each sample, a bit plane each; the same bits, or exit code 1
  volumes      soft shadow volumes: what silhouettes seen from the light's centre hide, added up; of closed meshes

Several light sizes, resolutions or numbers of samples, separated by commas, make a run each. A picture has three panels:
sampling, volumes, and how far they differ.";

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
    /// Leave out the projections, whose work grows with the samples.
    #[arg(long)]
    no_projections: bool,
    /// Pictures; of several runs, one file each (FILE.0.png, …).
    #[arg(short, long, value_name = "FILE.png")]
    output: Option<PathBuf>,
    /// A row for every run and method.
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,
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
    targets::check(pictures.iter().chain(&args.csv).map(PathBuf::as_path))?;
    let backend = machine::open(&args.machine, false)?;
    writeln!(out, "backend    {}", machine::describe(&backend.info()))?;
    let (mut runs, mut differ) = (Vec::new(), 0);
    for (number, setup) in setups.iter().enumerate() {
        let request = setup.request();
        let light = light_side(&request);
        let Request { resolution, samples, .. } = request;
        writeln!(out, "\n{resolution} x {resolution} receivers, {samples} samples, a light {light:.4} units wide")?;
        let (rows, panels, bits) = methods(&*backend, &request, args.no_projections, out)?;
        differ += bits;
        runs.extend(rows);
        if let Some(path) = pictures.get(number) {
            write_panels(path, &panels)?;
            writeln!(out, "wrote      {}", path.display())?;
        }
    }
    if let Some(path) = &args.csv {
        write_csv(path, &runs)?;
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

/// Runs the methods on one request; also its panels, and the bits in which sampling and projections differ.
fn methods(
    backend: &dyn Backend,
    request: &Request,
    no_projections: bool,
    out: &mut dyn Write,
) -> Result<(Vec<Run>, [Share; 3], u64), Failure> {
    let (ours, row) = timed("sampling", request, |progress| bake(backend, request, progress))?;
    let mut rows = vec![Run { work: ours.work, ..row }];
    let mut bits = 0;
    if !no_projections {
        let (theirs, row) = timed("projections", request, |progress| projections(backend, request, progress))?;
        rows.push(Run { work: theirs.work, ..row });
        bits = differing(&ours, &theirs);
    }
    let (added, row) = timed("volumes", request, |progress| volumes(backend, request, progress))?;
    rows.push(Run { work: added.work, ..row });
    writeln!(out, "{:<12} {:>14} {:>16} {:>10}", "method", "pairs", "lane-ops", "time")?;
    for Run { method, work, seconds, .. } in &rows {
        let ops = work.lane_ops.map_or_else(|| "-".to_owned(), |ops| ops.to_string());
        writeln!(out, "{method:<12} {:>14} {ops:>16} {seconds:>8.3} s", work.pairs)?;
    }
    if !no_projections {
        writeln!(out, "projections differ in {bits} of {} bits", 32 * ours.sets.masks.len())?;
    }
    let panel = |visible: Vec<u32>| Share { resolution: request.resolution, samples: request.samples, visible };
    let apart: Vec<u32> = ours.visible.iter().zip(&added.visible).map(|(a, b)| a.abs_diff(*b)).collect();
    let darker = ours.visible.iter().zip(&added.visible).filter(|(ours, theirs)| theirs < ours).count();
    let lighter = ours.visible.iter().zip(&added.visible).filter(|(ours, theirs)| theirs > ours).count();
    let most = apart.iter().max().copied().unwrap_or(0);
    let panels = [panel(ours.visible), panel(added.visible), panel(apart)];
    writeln!(
        out,
        "volumes are too dark at {darker} texels and too light at {lighter}, by {:.6} of the light in the mean and \
         {most} samples at most",
        panels[2].mean()
    )?;
    out.flush()?;
    Ok((rows, panels, bits))
}

/// Bits that are not the same.
fn differing(a: &Bake, b: &Bake) -> u64 {
    a.sets.masks.iter().zip(&b.sets.masks).map(|(a, b)| u64::from((a ^ b).count_ones())).sum()
}

/// Length of the light's first side.
fn light_side(request: &Request) -> f64 {
    request.light.u.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// A method's result, and a row with its time and still without its work.
fn timed<T>(
    method: &'static str,
    request: &Request,
    work: impl FnOnce(&mut dyn FnMut(f32)) -> sightlines_visibility::Result<T>,
) -> Result<(T, Run), Failure> {
    let progress = Progress::new(method.to_owned());
    let start = Instant::now();
    let result = work(&mut |share| progress.show(share))?;
    let run = Run {
        resolution: request.resolution,
        samples: request.samples,
        light_side: light_side(request),
        triangles: request.triangles.len(),
        method,
        work: Work::default(),
        seconds: start.elapsed().as_secs_f64(),
    };
    Ok((result, run))
}

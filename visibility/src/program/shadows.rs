//! `sightlines shadows`: a scene in, a picture of the visible share and its sets out, and a short report.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use sightlines_backend::{BackendInfo, Counts};
use sightlines_visibility::image::{Share, write_exr, write_png};
use sightlines_visibility::setup::Setup;
use sightlines_visibility::shadows::{Work, bake_with};
use sightlines_visibility::{scene, sets};

use super::cli::ShadowsArgs;
use super::progress::Progress;
use super::{Failure, machine, targets};

/// Where the results go.
struct Outputs {
    png: Option<PathBuf>,
    exr: Option<PathBuf>,
    /// One for each light.
    sets: Vec<PathBuf>,
}

impl Outputs {
    fn new(args: &ShadowsArgs, lights: usize) -> Self {
        let nothing = args.output.is_none() && args.exr.is_none() && args.sets.is_none();
        let sets =
            args.sets.iter().flat_map(|path| (0..lights).map(move |light| targets::numbered(path, light, lights)));
        Outputs {
            png: args.output.clone().or_else(|| nothing.then(|| "shadow.png".into())),
            exr: args.exr.clone(),
            sets: sets.collect(),
        }
    }

    fn check(&self, args: &ShadowsArgs) -> sightlines_visibility::Result<()> {
        let named: Vec<PathBuf> = args.source.scene_file.iter().flat_map(|file| targets::named_in(file)).collect();
        let read = args.source.model.iter().chain(&args.source.scene_file).chain(&named);
        targets::check(read.map(PathBuf::as_path), self.paths())
    }

    fn paths(&self) -> impl Iterator<Item = &Path> {
        self.png.iter().chain(&self.exr).chain(&self.sets).map(PathBuf::as_path)
    }
}

/// Bakes, writes and reports.
pub(crate) fn run(args: &ShadowsArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let setup = setup(args)?;
    let outputs = Outputs::new(args, setup.lights.len());
    outputs.check(args)?;
    let backend = machine::open(&args.machine, args.counts)?;
    describe(&setup, out)?;
    let mut time = Duration::ZERO;
    let mut request = setup.request();
    let mut total: Option<(Share, f64)> = None;
    let mut work = Work::default();
    for (number, &light) in setup.lights.iter().enumerate() {
        request.light = light;
        let progress = Progress::new(format!("light {} of {}", number + 1, setup.lights.len()));
        let start = Instant::now();
        let baked = bake_with(&*backend, &request, &args.effort.effort(), &mut |share| progress.show(share))?;
        time += start.elapsed();
        drop(progress);
        if let Some(path) = outputs.sets.get(number) {
            sets::write(path, &baked.sets)?;
        }
        work += baked.work;
        let share = Share::of(&baked);
        match &mut total {
            Some((sum, cell)) => {
                sum.add(&share);
                *cell = cell.max(baked.sets.cell);
            }
            None => total = Some((share, baked.sets.cell)),
        }
    }
    // A setup has a light.
    let Some((share, cell)) = total else { return Ok(()) };
    if let Some(path) = &outputs.png {
        write_png(path, &share, args.bits.into())?;
    }
    if let Some(path) = &outputs.exr {
        write_exr(path, &share)?;
    }
    conclude(&backend.info(), &setup, &share, cell, time, out)?;
    if args.counts {
        count(&work, &setup, out)?;
    }
    outputs.paths().try_for_each(|path| writeln!(out, "wrote      {}", path.display()))?;
    Ok(())
}

fn setup(args: &ShadowsArgs) -> sightlines_visibility::Result<Setup> {
    let settings = args.settings();
    match (&args.source.scene_file, &args.source.model, args.source.scene) {
        (Some(file), ..) => Setup::load(file, &settings),
        (None, Some(model), _) => Setup::new(scene::load(model)?, &settings),
        (None, None, generator) => Setup::new(scene::generate(generator.unwrap_or(scene::Generator::Palms)), &settings),
    }
}

fn describe(setup: &Setup, out: &mut dyn Write) -> Result<(), Failure> {
    let scene = &setup.scene;
    let (parts, triangles) = (scene.parts.len(), scene.triangle_count());
    let degenerate = scene.degenerate_count();
    let (parts, triangles) = (counted(parts, "part"), counted(triangles, "triangle"));
    writeln!(out, "scene      {}: {triangles} in {parts}, {degenerate} degenerate", scene.name)?;
    writeln!(out, "units      {}, {} up", scene.units, setup.up)?;
    writeln!(out, "bounds     {}", scene.bounds())?;
    Ok(out.flush()?)
}

fn conclude(
    info: &BackendInfo,
    setup: &Setup,
    share: &Share,
    cell: f64,
    time: Duration,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let (lights, side) = (setup.lights.len(), share.resolution);
    writeln!(out, "receivers  {side} x {side}, {} samples on {}", setup.samples, counted(lights, "light"))?;
    writeln!(out, "grid       cells of {cell:.3e} scene units")?;
    writeln!(out, "backend    {}", machine::describe(info))?;
    writeln!(out, "time       {:.3} s", time.as_secs_f64())?;
    Ok(writeln!(out, "visible    {:.6} of the light in the mean", share.mean())?)
}

/// The work in numbers that do not depend on how fast the machine is.
fn count(work: &Work, setup: &Setup, out: &mut dyn Write) -> Result<(), Failure> {
    let receivers = u64::from(setup.resolution).pow(2) * setup.lights.len() as u64;
    let each = work.pairs as f64 / receivers as f64;
    writeln!(out, "pairs      {} of a triangle and a receiver in its region, {each:.1} a receiver", work.pairs)?;
    writeln!(out, "culled     {} of {} triangles of closed surfaces", work.culled, work.closed)?;
    match work.lane_ops {
        Some(ops) => writeln!(out, "lane-ops   {ops}, {:.1} a pair", ops as f64 / work.pairs.max(1) as f64)?,
        None => writeln!(out, "lane-ops   not counted: only the interpreter has them")?,
    }
    if let Some(counts) = work.counts {
        let Counts { invocations, loads, stores, bytes, atomics, barriers, .. } = counts;
        writeln!(out, "work       {invocations} invocations, {barriers} barriers")?;
        writeln!(out, "memory     {loads} loads, {stores} stores, {atomics} atomics, {bytes} bytes")?;
    }
    Ok(())
}

/// A number of things.
fn counted(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}

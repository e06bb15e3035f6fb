//! `sightlines shadows`: a scene in, pictures of what receivers see of its lights and their sets out, and a short
//! report.

pub(crate) mod args;
mod filtered;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use sightlines_backend::{Backend, BackendInfo, Counts};
use sightlines_visibility::error::Place;
use sightlines_visibility::image::{Depth, Picture, Share, write_exr, write_picture_exr, write_picture_png, write_png};
use sightlines_visibility::setup::Setup;
use sightlines_visibility::shadows::Work;
use sightlines_visibility::shadows::expose::{Exposed, Exposure, expose};
use sightlines_visibility::shadows::lightmap::dilate;
use sightlines_visibility::shadows::reading::Reading;
use sightlines_visibility::shadows::surface::Surface;
use sightlines_visibility::simplify::{Simplified, Target, simplify, tolerance};
use sightlines_visibility::{scene, sets};

use self::args::{ResultName, ShadowsArgs};
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

    fn paths(&self) -> impl Iterator<Item = &Path> {
        self.png.iter().chain(&self.exr).chain(&self.sets).map(PathBuf::as_path)
    }
}

/// What all lights together leave of the receivers.
#[derive(Default)]
struct Total {
    lights: u32,
    samples: u32,
    /// Samples that each texel sees.
    visible: Vec<u32>,
    is_there: Vec<bool>,
    /// Their light, by channel.
    pixels: Vec<[f64; 3]>,
    /// Whether all of it is white.
    is_white: bool,
    cell: f64,
    work: Work,
}

impl Total {
    fn add(&mut self, exposed: &Exposed, result: ResultName) {
        let texels = exposed.sets.texels();
        if self.lights == 0 {
            (self.visible, self.pixels) = (vec![0; texels], vec![[0.0; 3]; texels]);
            (self.is_there, self.is_white) = (vec![false; texels], true);
        }
        for seen in exposed.visible.chunks(texels) {
            self.visible.iter_mut().zip(seen).for_each(|(sum, seen)| *sum += seen);
        }
        let pixels = match result {
            ResultName::Share => exposed.picture(),
            ResultName::Irradiance => exposed.irradiance(),
        };
        for (sum, pixel) in self.pixels.iter_mut().zip(pixels) {
            (0..3).for_each(|i| sum[i] += pixel[i]);
        }
        self.is_there.iter_mut().zip(&exposed.is_there).for_each(|(any, there)| *any |= there);
        self.is_white &= exposed.colours == [[1.0; 3]];
        self.samples += exposed.samples.iter().sum::<u32>();
        self.lights += 1;
        self.cell = self.cell.max(exposed.sets.cell);
        self.work += exposed.work;
    }

    fn share(&self, resolution: u32) -> Share {
        Share { resolution, samples: self.samples, visible: self.visible.clone() }
    }

    /// The mean of the lights where their parts are shown, else their sum; with gutters where texels have no surface.
    fn picture(&self, resolution: u32, result: ResultName, gutter: u32) -> Picture {
        let lights = if result == ResultName::Share { f64::from(self.lights) } else { 1.0 };
        let pixels = self.pixels.iter().zip(&self.is_there);
        let mut pixels: Vec<Option<[f64; 3]>> =
            pixels.map(|(pixel, there)| there.then(|| pixel.map(|c| c / lights))).collect();
        dilate(resolution as usize, &mut pixels, gutter);
        Picture { resolution, pixels: pixels.into_iter().map(|pixel| pixel.unwrap_or([0.0; 3])).collect() }
    }
}

/// Bakes, writes and reports.
pub(crate) fn run(args: &ShadowsArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut setup = setup(args)?;
    let simplified = args.simplify.map(|target| simplified(&mut setup, target)).transpose()?;
    args.check(setup.lights.len(), setup.motion.is_some())?;
    let outputs = Outputs::new(args, setup.lights.len());
    targets::check(outputs.paths())?;
    let backend = machine::open(&args.machine, args.counts)?;
    describe(&setup, out)?;
    if let Some(Simplified { before, moved, hash, .. }) = &simplified {
        let after = setup.scene.triangle_count();
        writeln!(out, "simplified {before} to {after} triangles, moved by {moved:.3e} units at most")?;
        writeln!(out, "           {hash}")?;
    }
    let mut time = Duration::ZERO;
    let mut total = Total::default();
    for number in 0..setup.lights.len() {
        let start = Instant::now();
        let exposed = one_light(args, &setup, number, &*backend)?;
        time += start.elapsed();
        if let Some(path) = outputs.sets.get(number) {
            sets::write(path, &exposed.sets)?;
        }
        total.add(&exposed, args.result);
    }
    let peak = match args.map {
        Some(side) => filtered::write(args, &setup, &outputs, &total, &*backend, side, out).map(|()| None)?,
        None => write(args, &setup, &outputs, &total)?,
    };
    conclude(&backend.info(), &setup, &total, time, out)?;
    if let Some(peak) = peak {
        writeln!(out, "white      {peak:.6e} of a radiance of 1")?;
    }
    if args.counts {
        count(&total.work, &setup, out)?;
    }
    outputs.paths().try_for_each(|path| writeln!(out, "wrote      {}", path.display()))?;
    Ok(())
}

/// Exposes the receivers to one light, and reads the sets as asked for.
fn one_light(args: &ShadowsArgs, setup: &Setup, number: usize, backend: &dyn Backend) -> Result<Exposed, Failure> {
    let progress = Progress::new(format!("light {} of {}", number + 1, setup.lights.len()));
    let effort = args.effort.effort();
    let exposure = Exposure { effort, ..setup.exposure(number, args.result == ResultName::Irradiance) };
    let mut exposed = expose(backend, &exposure, &mut |share| progress.show(share))?;
    let reading = Reading::from(args.reading);
    if reading != Reading::Centre {
        exposed.sets = exposed.sets.read(reading, &exposed.is_there);
        exposed.visible = exposed.sets.count(&exposed.of, exposed.colours.len());
    }
    if let Some(sample) = args.seen_from {
        if sample >= exposed.sets.samples {
            let what = format!("there is no sample {sample}");
            let remedy = format!("choose 0 to {}", exposed.sets.samples - 1);
            return Err(Failure::Work(Place::default().element("--seen-from").error(what, remedy)));
        }
        exposed.visible = exposed.sets.seen_from(sample).into_iter().map(u32::from).collect();
        (exposed.samples, exposed.colours) = (vec![1], vec![[1.0; 3]]);
    }
    Ok(exposed)
}

/// Writes the pictures; the answer is what white is in the PNG, where that is not the whole light.
fn write(args: &ShadowsArgs, setup: &Setup, outputs: &Outputs, total: &Total) -> Result<Option<f64>, Failure> {
    let is_lightmap = matches!(setup.surface, Surface::Lightmap(_));
    let depth: Depth = args.bits.into();
    if args.result == ResultName::Share && total.is_white && !is_lightmap {
        let share = total.share(setup.resolution);
        outputs.png.as_ref().map(|path| write_png(path, &share, depth)).transpose()?;
        outputs.exr.as_ref().map(|path| write_exr(path, &share)).transpose()?;
        return Ok(None);
    }
    let picture = total.picture(setup.resolution, args.result, if is_lightmap { args.gutter } else { 0 });
    let white = if args.result == ResultName::Share { 1.0 } else { picture.peak() };
    outputs.png.as_ref().map(|path| write_picture_png(path, &picture, white, depth)).transpose()?;
    outputs.exr.as_ref().map(|path| write_picture_exr(path, &picture)).transpose()?;
    Ok((args.result == ResultName::Irradiance).then_some(white))
}

fn setup(args: &ShadowsArgs) -> sightlines_visibility::Result<Setup> {
    let settings = args.settings()?;
    match (&args.source.scene_file, &args.source.model, args.source.scene) {
        (Some(file), ..) => Setup::load(file, &settings),
        (None, Some(model), _) => Setup::new(scene::load(model)?, &settings),
        (None, None, generator) => Setup::new(scene::generate(generator.unwrap_or(scene::Generator::Palms)), &settings),
    }
}

/// Puts a simplified scene in the place of a setup's, whose light and receiver stay.
fn simplified(setup: &mut Setup, target: Target) -> sightlines_visibility::Result<Simplified> {
    if matches!(setup.surface, Surface::Lightmap(_)) {
        let remedy = "leave out one of the two: receivers on the full mesh would be hidden by the coarse one";
        return Err(Place::default()
            .element("--simplify")
            .error("a lightmap is of the mesh that is simplified", remedy));
    }
    let limit = tolerance(&setup.scene, &setup.lights[0].rect, setup.sampling.count, &setup.receiver);
    let simplified = simplify(&setup.scene, target, limit)?;
    setup.scene = simplified.scene.clone();
    Ok(simplified)
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
    total: &Total,
    time: Duration,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let (lights, side) = (setup.lights.len(), setup.resolution);
    writeln!(out, "receivers  {side} x {side}, {} samples on {}", setup.sampling.count, counted(lights, "light"))?;
    writeln!(out, "grid       cells of {:.3e} scene units", total.cell)?;
    writeln!(out, "backend    {}", machine::describe(info))?;
    writeln!(out, "time       {:.3} s", time.as_secs_f64())?;
    Ok(writeln!(out, "visible    {:.6} of the light in the mean", total.share(side).mean())?)
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

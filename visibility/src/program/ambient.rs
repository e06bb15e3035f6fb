//! `sightlines ambient`: a scene in, the same scene shaded by what its vertices see of an environment out.

pub(crate) mod args;
mod frames;
mod pictures;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use sightlines_backend::{Backend, Counts};
use sightlines_kernels::illumination::gamma_table;
use sightlines_visibility::ambient::file::Stored;
use sightlines_visibility::ambient::matrix::Work;
use sightlines_visibility::ambient::{Colours, Environment, Matrix, Surface, View, export};
use sightlines_visibility::error::Place;
use sightlines_visibility::scene::Scene;
use sightlines_visibility::{Result, scene};

use self::args::AmbientArgs;
use self::frames::Frames;
use super::progress::Progress;
use super::{Failure, machine, targets};

/// Time after which a matrix on the way is written.
const PAUSE: Duration = Duration::from_secs(10);

/// How many times longer the work goes on than its writing takes.
const SHARE: u32 = 20;

/// Bakes, writes and reports.
pub(crate) fn run(args: &AmbientArgs, out: &mut dyn Write) -> Result<(), Failure> {
    args.check()?;
    let outputs = outputs(args)?;
    let frames = Frames::new(args)?;
    let scene = frames.as_ref().map_or_else(|| load(args), |frames| frames.at(0))?;
    let environment = args.environment()?;
    let light = (&environment.0, environment.1);
    let surface = Surface::new(&scene)?;
    let cameras = pictures::cameras(args, &scene.bounds())?;
    let pictures = cameras.iter().map(|(_, path)| path);
    targets::check(outputs.iter().chain(&args.matrix).chain(pictures).map(PathBuf::as_path))?;
    let backend = machine::open(&args.machine, args.counts)?;
    describe(&scene, &surface, out)?;
    writeln!(out, "lights     {}, a bias of {} cells", args.sphere(), args.bias)?;
    writeln!(out, "grid       cells of {:.3e} scene units", surface.cell)?;
    writeln!(out, "backend    {}", machine::describe(&backend.info()))?;
    out.flush()?;
    if let Some(frames) = frames {
        return frames.run(args, &*backend, &cameras, light, out);
    }
    if args.lazy {
        return pictures::lazily(args, &*backend, &surface, &cameras, light, out);
    }
    let start = Instant::now();
    let mut matrix = Matrix::open(&*backend, &surface, args.sphere(), args.bias)?;
    let resumed = compute(args, &surface, &mut matrix)?;
    let time = start.elapsed();
    let shaded = shade(args, &*backend, &mut matrix, light)?;
    for path in &outputs {
        match extension(path).as_deref() {
            Some("ply") => export::write_ply(path, &surface, &shaded.bytes)?,
            _ => export::write_glb(path, &surface, &shaded.colours, shaded.white)?,
        }
    }
    for (camera, path) in &cameras {
        let view = View::new(&*backend, &surface, camera, args.size)?;
        pictures::write(args, (&view, path), &surface, (&shaded.colours, shaded.white))?;
    }
    if resumed > 0 {
        writeln!(out, "resumed    {resumed} of {} directions were there", args.sphere().count())?;
    }
    writeln!(out, "time       {:.3} s for the visibility", time.as_secs_f64())?;
    conclude(&shaded, out)?;
    if args.counts {
        let pairs = u64::from(surface.positions()) * u64::from(args.sphere().count());
        count(&matrix.work(), pairs, out)?;
    }
    let paths = outputs.iter().chain(&args.matrix).chain(cameras.iter().map(|(_, path)| path));
    paths.into_iter().try_for_each(|path| writeln!(out, "wrote      {}", path.display()))?;
    Ok(())
}

fn load(args: &AmbientArgs) -> Result<Scene> {
    match (&args.source.model, &args.source.motion, &args.source.scene) {
        (Some(model), ..) => scene::load(model),
        (None, Some(motion), _) => motion.at(0.0),
        (None, None, Some(world)) => Ok(world.flatten()),
        (None, None, None) => unreachable!("the command line asks for one of the three"),
    }
}

fn extension(path: &Path) -> Option<String> {
    path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase())
}

/// The shaded scenes to write. Names must say what is in their files, and so must that of pictures.
fn outputs(args: &AmbientArgs) -> Result<Vec<PathBuf>> {
    let mut outputs = args.output.clone();
    if outputs.is_empty() && args.matrix.is_none() && args.picture.is_none() {
        outputs.push("ambient.glb".into());
    }
    let is_one = |path: &Path, of: &[&str]| extension(path).is_some_and(|extension| of.contains(&extension.as_str()));
    let wrong = |path: &Path, what| Err(Place::file(path).error(what, "name a file with such an extension"));
    if let Some(path) = outputs.iter().find(|path| !is_one(path, &["glb", "ply"])) {
        return wrong(path, "neither .glb nor .ply");
    }
    match args.picture.as_ref().filter(|path| !is_one(path, &["png"])) {
        Some(path) => wrong(path, "not .png, as pictures are"),
        None => Ok(outputs),
    }
}

/// Brings the matrix to its last direction, by way of the file; the answer is how many directions were there.
fn compute(args: &AmbientArgs, surface: &Surface, matrix: &mut Matrix<'_>) -> Result<u32> {
    let sphere = args.sphere();
    if let Some(path) = args.matrix.as_ref().filter(|path| args.resume && path.exists()) {
        let stored = Stored::read(path)?;
        stored.check(path, surface, sphere, args.bias)?;
        matrix.restore(stored.done, &stored.words)?;
    }
    let resumed = matrix.done();
    let progress = Progress::new(format!("{} directions", sphere.count()));
    let mut saved = Checkpoint { last: Instant::now(), cost: Duration::ZERO };
    for target in sphere.refinements() {
        let mut grown = false;
        while matrix.advance(target)? {
            grown = true;
            progress.show(matrix.done() as f32 / sphere.count() as f32);
            if saved.is_old() {
                saved.save(args, surface, matrix)?;
            }
        }
        if grown || target == sphere {
            saved.save(args, surface, matrix)?;
        }
    }
    Ok(resumed)
}

/// The last time that a matrix on the way was written, and how long that took.
struct Checkpoint {
    last: Instant,
    cost: Duration,
}

impl Checkpoint {
    fn is_old(&self) -> bool {
        is_old(self.last.elapsed(), self.cost)
    }

    /// Writes the matrix, if the command line asks for its file.
    fn save(&mut self, args: &AmbientArgs, surface: &Surface, matrix: &mut Matrix<'_>) -> Result<()> {
        let Some(path) = &args.matrix else { return Ok(()) };
        let start = Instant::now();
        Stored::of(matrix, surface, args.sphere(), args.bias)?.write(path)?;
        *self = Checkpoint { last: Instant::now(), cost: start.elapsed() };
        Ok(())
    }
}

fn is_old(elapsed: Duration, cost: Duration) -> bool {
    elapsed >= PAUSE.max(SHARE * cost)
}

/// Colours of all vertices.
struct Shaded {
    colours: Colours,
    bytes: Vec<[u8; 3]>,
    white: f64,
    lost: [u32; 3],
}

fn shade(
    args: &AmbientArgs,
    backend: &dyn Backend,
    matrix: &mut Matrix<'_>,
    (environment, is_white): (&Environment, bool),
) -> Result<Shaded> {
    let intensities = environment.look_up(backend, args.sphere(), &args.lighting())?;
    let (mut colours, mut bytes) = (Colours::new(), Vec::new());
    matrix.light(&intensities, &mut colours)?;
    let white = args.white.unwrap_or_else(|| if is_white { 1.0 } else { exposure(&colours) });
    matrix.encode(&gamma_table(args.gamma, white)?, &mut bytes)?;
    Ok(Shaded { colours, bytes, white, lost: intensities.lost })
}

/// What 98 of 100 vertices stay below.
fn exposure(colours: &Colours) -> f64 {
    let mut brightest: Vec<f32> = colours.iter().map(|c| c[0].max(c[1]).max(c[2])).collect();
    brightest.sort_unstable_by(f32::total_cmp);
    let at = brightest.len().saturating_sub(1) * 98 / 100;
    brightest.get(at).map_or(1.0, |&white| if white > 1e-6 { f64::from(white) } else { 1.0 })
}

fn describe(scene: &Scene, surface: &Surface, out: &mut dyn Write) -> Result<(), Failure> {
    let (parts, triangles) = (scene.parts.len(), scene.triangle_count());
    writeln!(out, "scene      {}: {triangles} triangles in {parts} parts", scene.name)?;
    let (vertices, positions) = (surface.vertices.len(), surface.positions());
    writeln!(out, "mesh       {vertices} vertices at {positions} positions, {} flat triangles", surface.findings.flat)?;
    let computed = surface.findings.computed_normals;
    let source = match computed {
        0 => "from the file".to_owned(),
        _ if computed == vertices => "computed, as the file has none".to_owned(),
        _ => format!("from the file, but computed for {computed} vertices"),
    };
    writeln!(out, "normals    {source}")?;
    if surface.findings.open_edges > 0 {
        let edges = surface.findings.open_edges;
        writeln!(out, "open       {edges} edges have no triangle on one side: light passes there")?;
    }
    Ok(out.flush()?)
}

fn conclude(shaded: &Shaded, out: &mut dyn Write) -> Result<(), Failure> {
    let count = shaded.colours.len().max(1) as f64;
    let sum = |channel: usize| shaded.colours.iter().map(|colour| f64::from(colour[channel])).sum::<f64>();
    let [red, green, blue] = [0, 1, 2].map(|channel| sum(channel) / count);
    writeln!(out, "colour     ({red:.6}, {green:.6}, {blue:.6}) in the mean, {:.6} is white", shaded.white)?;
    if shaded.lost != [0; 3] {
        let [red, green, blue] = shaded.lost;
        writeln!(out, "range      {red} red, {green} green, {blue} blue texels are too dark beside the brightest")?;
    }
    Ok(())
}

/// The work in numbers that do not depend on how fast the machine is.
fn count(work: &Work, pairs: u64, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "pairs      {pairs} of a position and a direction")?;
    match work.lane_ops {
        Some(ops) => writeln!(out, "lane-ops   {ops}, {:.1} a pair", ops as f64 / pairs.max(1) as f64)?,
        None => writeln!(out, "lane-ops   not counted: only the interpreter has them")?,
    }
    if let Some(counts) = work.counts {
        let Counts { invocations, loads, stores, bytes, atomics, barriers, .. } = counts;
        writeln!(out, "work       {invocations} invocations, {barriers} barriers")?;
        writeln!(out, "memory     {loads} loads, {stores} stores, {atomics} atomics, {bytes} bytes")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_written_now_and_then_and_its_writing_stays_a_small_part_of_the_time() {
        let seconds = Duration::from_secs;
        assert!(!is_old(seconds(9), seconds(0)) && is_old(seconds(10), seconds(0)));
        assert!(!is_old(seconds(59), seconds(3)) && is_old(seconds(60), seconds(3)));
    }
}

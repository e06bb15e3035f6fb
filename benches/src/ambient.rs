//! Ambient occlusion of a generated closed mesh: `cargo xtask bench ambient`.
//!
//! Each engine in each thread setting is a child process, so that its peak memory is its own. What is timed is a whole
//! visibility matrix, from the first block of directions until its bits are read: by CPU time on one thread, by wall
//! time on all. Each run opens a session of its own, beforehand, and that is timed apart, as Embree's structure is. The
//! interpreter on one thread then goes through the levels step by step, which is counted in lane-operations, and on
//! request [`rays`] traces the same rays by Embree. Invariant: whatever is timed has given the same bits as everything
//! else.

pub mod rays;
mod tables;

use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::Path;

use criterion::measurement::Measurement;
use serde::{Deserialize, Serialize};
use sightlines_backend::Backend;
use sightlines_kernels::vertex_visibility::bumpy;
use sightlines_visibility::ambient::{Matrix, Sphere, Surface};
use sightlines_visibility::scene::{Mesh, Scene};

use crate::children::{self, Measured};
use crate::clock::Clock;
use crate::embree;
use crate::engine::{self, Engine, INSTALL_LAVAPIPE, Threads};
use crate::error::{Error, Result};
use crate::measure::peak_bytes;
use crate::run::core_to_pin;
use crate::statistics::median;
use crate::worker::{command, discover};

/// Cells that an occluder must be farther away than.
const BIAS: u32 = 1;

/// How much is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Size {
    /// Subdivision n of the mesh, which has 4 n² + 2 vertices.
    pub subdivision: u16,
    /// Level of the octahedron's directions.
    pub level: u32,
    /// Runs after the warm-up; with 0 the first run counts.
    pub runs: usize,
}

impl Size {
    /// For numbers that are kept: 35,346 vertices, 1026 directions.
    pub const FULL: Size = Size { subdivision: 94, level: 4, runs: 3 };
    /// For a look: 258 directions.
    pub const QUICK: Size = Size { subdivision: 94, level: 3, runs: 1 };

    fn sphere(self) -> Sphere {
        Sphere::Octahedron { level: self.level }
    }

    fn surface(self) -> Result<Surface> {
        let mesh = bumpy(self.subdivision.into());
        let vertices = mesh.vertices.iter().map(|point| point.map(f64::from)).collect();
        let parts = vec![Mesh { vertices, triangles: mesh.triangles, ..Mesh::default() }];
        Surface::new(&Scene { name: "bumpy".to_owned(), units: "cells", parts }).map_err(failed)
    }
}

/// One engine in one thread setting.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Case {
    /// How much is computed.
    #[serde(flatten)]
    pub size: Size,
    /// The engine.
    pub engine: Engine,
    /// Its threads.
    pub threads: Threads,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}", self.engine, self.threads)
    }
}

impl Case {
    /// Whether this is the engine whose work is counted and held against Embree's.
    fn is_reference(&self) -> bool {
        matches!(self.engine, Engine::Cpu { .. }) && self.threads == Threads::One
    }
}

/// What a case took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The case.
    #[serde(flatten)]
    pub case: Case,
    /// What the times are of.
    pub clock: Clock,
    /// Vertices of the mesh, all positions different.
    pub vertices: u32,
    /// Its triangles.
    pub triangles: usize,
    /// Directions.
    pub directions: u32,
    /// Median time of opening a session: programs, the mesh on the device, memory.
    pub open_ns: f64,
    /// Median of [`Row::runs_ns`].
    pub median_ns: f64,
    /// Time of each run, of all bits.
    pub runs_ns: Vec<f64>,
    /// `median_ns` for each vertex and direction.
    pub ns_per_bit: f64,
    /// Lane-operations of the first run. On one thread they are the same in all; on more, the order in which vertices
    /// are placed in their bins varies, and by a few in a million also which lanes work together.
    pub lane_ops: Option<u64>,
    /// `median_ns / lane_ops`.
    pub ns_per_lane_op: Option<f64>,
    /// Bytes of the matrix.
    pub matrix_bytes: u64,
    /// The process' greatest resident memory in bytes, where the system tells.
    pub peak_bytes: Option<u64>,
    /// Share of the bits that are set.
    pub occluded: f64,
    /// Hash of the bits, the same in every process of one build.
    pub digest: u64,
    /// The levels one after the other, by the interpreter on one thread.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub refinement: Option<Refinement>,
    /// The same rays by Embree, if asked for: all of them, and those above the tangent plane.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub embree: Vec<rays::Traced>,
}

/// Work of all levels one after the other, beside that of the last one alone.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Refinement {
    /// What stands after each level.
    pub steps: Vec<Step>,
    /// Lane-operations of the last level alone.
    pub alone: u64,
    /// Those of all steps over `alone`.
    pub ratio: f64,
}

/// A level on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Step {
    /// Directions that are done.
    pub directions: u32,
    /// Lane-operations up to here.
    pub lane_ops: u64,
}

fn failed(e: sightlines_visibility::Error) -> Error {
    Error::Measurement(e.to_string())
}

/// One run.
struct Run {
    open_ns: f64,
    ns: f64,
    lane_ops: Option<u64>,
    words: Vec<u32>,
}

impl Run {
    fn digest(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.words.hash(&mut hasher);
        hasher.finish()
    }
}

fn run_once(backend: &dyn Backend, surface: &Surface, sphere: Sphere, clock: Clock) -> Result<Run> {
    let start = clock.start();
    let mut matrix = Matrix::open(backend, surface, sphere, BIAS).map_err(failed)?;
    let open_ns = clock.to_f64(&clock.end(start));
    let start = clock.start();
    while matrix.advance(sphere).map_err(failed)? {}
    let words = matrix.words().map_err(failed)?;
    let ns = clock.to_f64(&clock.end(start));
    Ok(Run { open_ns, ns, lane_ops: matrix.work().lane_ops, words })
}

/// The child: computes a case and writes what it took. `tracer` is Embree's program; its files go beside it.
pub fn serve(case: &str, tracer: Option<&Path>, out: &mut impl Write) -> Result<()> {
    children::serve::<Row>(case, tracer, out)
}

impl Measured for Row {
    type Case = Case;
    const COMMAND: &'static str = "occlusion";

    fn measure(case: Case, tracer: Option<&Path>) -> Result<Self> {
        measure(case, tracer)
    }

    fn median_ns(&self) -> f64 {
        self.median_ns
    }
}

fn measure(case: Case, tracer: Option<&Path>) -> Result<Row> {
    let (size, surface, sphere) = (case.size, case.size.surface()?, case.size.sphere());
    let backend = case.engine.open(case.threads)?;
    let clock = Clock::of(case.threads);
    let first = run_once(&*backend, &surface, sphere, clock)?;
    let digest = first.digest();
    let (mut opens_ns, mut runs_ns) = (Vec::new(), Vec::new());
    for _ in 0..size.runs {
        let run = run_once(&*backend, &surface, sphere, clock)?;
        if run.digest() != digest {
            return Err(Error::Measurement("a run gave other bits than the first".to_owned()));
        }
        if case.is_reference() && run.lane_ops != first.lane_ops {
            return Err(Error::Measurement("a run did other work than the first".to_owned()));
        }
        opens_ns.push(run.open_ns);
        runs_ns.push(run.ns);
    }
    if size.runs == 0 {
        opens_ns.push(first.open_ns);
        runs_ns.push(first.ns);
    }
    let peak_bytes = peak_bytes();
    let none = || Error::Measurement("no run".to_owned());
    let median_ns = median(&runs_ns).ok_or_else(none)?;
    let (vertices, directions) = (surface.positions(), sphere.count());
    let bits = f64::from(vertices) * f64::from(directions);
    let set: u64 = first.words.iter().map(|word| u64::from(word.count_ones())).sum();
    let refinement = match first.lane_ops {
        Some(alone) if case.is_reference() => Some(refine(&*backend, &surface, sphere, (alone, &first.words))?),
        _ => None,
    };
    let trace = |tracer: &Path| -> Result<Vec<rays::Traced>> {
        let trace = |above| rays::trace(tracer, (&surface, sphere, BIAS), &first.words, above, size.runs);
        [false, true].into_iter().map(trace).collect()
    };
    Ok(Row {
        clock,
        vertices,
        triangles: surface.mesh.triangles.len(),
        directions,
        open_ns: median(&opens_ns).ok_or_else(none)?,
        median_ns,
        runs_ns,
        ns_per_bit: median_ns / bits,
        lane_ops: first.lane_ops,
        ns_per_lane_op: first.lane_ops.filter(|ops| *ops > 0).map(|ops| median_ns / ops as f64),
        matrix_bytes: 4 * first.words.len() as u64,
        peak_bytes,
        occluded: set as f64 / bits,
        digest,
        refinement,
        embree: tracer.filter(|_| case.is_reference()).map(trace).transpose()?.unwrap_or_default(),
        case,
    })
}

/// Goes through the levels; they must end with the bits of the last level alone.
fn refine(
    backend: &dyn Backend,
    surface: &Surface,
    sphere: Sphere,
    (alone, words): (u64, &[u32]),
) -> Result<Refinement> {
    let mut matrix = Matrix::open(backend, surface, sphere, BIAS).map_err(failed)?;
    let mut steps = Vec::new();
    for target in sphere.refinements() {
        while matrix.advance(target).map_err(failed)? {}
        let lane_ops = matrix.work().lane_ops.unwrap_or_default();
        steps.push(Step { directions: matrix.done(), lane_ops });
    }
    if matrix.words().map_err(failed)? != words {
        return Err(Error::Measurement("level by level the bits are not those of the last level alone".to_owned()));
    }
    let all = steps.last().map_or(0, |step| step.lane_ops);
    Ok(Refinement { steps, alone, ratio: all as f64 / alone as f64 })
}

/// The engines, the interpreter first: beside it the adapters that are named, or lavapipe. What is missing is said, or
/// an error where it is named.
pub fn engines(exe: &Path, names: &[String], out: &mut impl Write) -> Result<Vec<Engine>> {
    let found = discover(exe);
    let chosen = engine::choose(found.as_deref().unwrap_or_default(), names)?;
    let mut engines = engine::interpreters(&[])?;
    let adapters = chosen.into_iter().map(Engine::Wgpu);
    engines.extend(adapters.filter(|adapter| !names.is_empty() || adapter.is_lavapipe()));
    if !engines.iter().any(Engine::is_lavapipe) {
        let reason = found.err().map_or_else(String::new, |trouble| format!(" ({trouble})"));
        writeln!(out, "note: no lavapipe adapter{reason}\n  remedy: {INSTALL_LAVAPIPE}")?;
    }
    Ok(engines)
}

/// Runs every engine on one thread and on all in child processes of `exe`, tells each to `progress` as it ends, prints
/// the tables to `out` and writes `ambient.json` into the folder. The answer is the exit code.
pub fn run(
    exe: &Path,
    (size, engines): (Size, &[Engine]),
    with_embree: bool,
    folder: &Path,
    out: &mut impl Write,
    progress: &mut impl Write,
) -> Result<u8> {
    let tracer = if with_embree { Some(embree::build(folder)?) } else { None };
    let core = core_to_pin();
    let of =
        |engine: &Engine| [Threads::One, Threads::All].map(|threads| Case { size, engine: engine.clone(), threads });
    let cases: Vec<Case> = engines.iter().flat_map(of).collect();
    let start = |case: &Case| command(exe, case.threads, core.as_deref());
    let (rows, mut failures) = children::measure_all::<Row>(&cases, start, tracer.as_deref(), progress)?;
    failures.extend(
        rows.iter()
            .skip(1)
            .filter(|row| row.digest != rows[0].digest)
            .map(|row| format!("{} gave other bits than {}", row.case, rows[0].case)),
    );
    failures.extend(rows.iter().flat_map(|row| &row.embree).filter_map(rays::Traced::unexplained));
    out.write_all(tables::render(&rows).as_bytes())?;
    children::finish(&rows, &failures, &folder.join("ambient.json"), out)
}

//! Soft shadows of generated meshes: `cargo xtask bench shadows`.
//!
//! Each mesh and light is a child process with one thread, so that its peak memory is its own. What is timed is a whole
//! bake of the interpreter, by CPU time: snapping, binning and every kernel, one warm-up and then the runs. Rays are
//! pairs of a receiver and a sample, whether or not a triangle is near them. On request [`embree`] traces them too.

use std::fmt;
use std::io::Write;
use std::path::Path;
use std::process::Command;

use criterion::measurement::Measurement;
use regex::Regex;
use serde::{Deserialize, Serialize};
use sightlines_backend_cpu::{Config, CpuBackend};
use sightlines_visibility::scene::{Generator, Scene, bumpy_sphere, generate};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::snap::snap;
use sightlines_visibility::shadows::{Bake, bake};

use crate::children::{self, Measured};
use crate::clock::Clock;
use crate::embree::{self, Traced};
use crate::engine::Threads;
use crate::error::{Error, Result};
use crate::measure::peak_bytes;
use crate::statistics::median;
use crate::table::{Columns, cell};

/// Sides of the light, in radii of the scene.
pub const LIGHTS: [f64; 3] = [0.1, 0.4, 1.0];

/// Meshes by size.
pub const MESHES: [&str; 5] = ["bumpy-12000", "palms", "bumpy-70000", "bumpy-200000", "bumpy-870000"];

/// Meshes that show how work grows with the number of triangles.
pub const SCALE: [&str; 6] = ["bumpy-10", "bumpy-100", "bumpy-1000", "bumpy-10000", "bumpy-100000", "bumpy-1000000"];

/// Cells of the grid within which a ray passes an edge where Embree's rounding may decide.
const AT_AN_EDGE: f64 = 0.5;

/// How much is baked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Size {
    /// Receivers a side.
    pub resolution: u32,
    /// Samples of the light.
    pub samples: u32,
    /// Runs after the warm-up.
    pub runs: usize,
}

impl Size {
    /// For numbers that are kept.
    pub const FULL: Size = Size { resolution: 512, samples: 1024, runs: 3 };
    /// For a look.
    pub const QUICK: Size = Size { resolution: 128, samples: 256, runs: 1 };
}

/// One mesh under one light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Case {
    /// `palms`, or `bumpy-` and a number of triangles.
    pub mesh: String,
    /// Side of the light, in radii of the scene.
    pub light: f64,
    /// How much is baked.
    pub size: Size,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.mesh, self.light)
    }
}

/// What a case took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Baked {
    /// The case.
    #[serde(flatten)]
    pub case: Case,
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Median of [`Baked::runs_ns`].
    pub median_ns: f64,
    /// CPU time of each run.
    pub runs_ns: Vec<f64>,
    /// Pairs of a triangle and a receiver in its influence region.
    pub pairs: u64,
    /// Lane-operations of one bake.
    pub lane_ops: Option<u64>,
    /// `median_ns / lane_ops`.
    pub ns_per_lane_op: Option<f64>,
    /// Receivers times samples, a second.
    pub rays_per_second: f64,
    /// Share of the rays that are hidden.
    pub hidden: f64,
    /// BLAKE3 of all hidden-sample sets: the same on every machine, and before and after what may change no bit.
    pub sets: String,
    /// Bytes of all buffers of the session that has most.
    pub buffer_bytes: u64,
    /// The process' greatest resident memory in bytes, where the system tells.
    pub peak_bytes: Option<u64>,
    /// The same rays by Embree, if asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub embree: Option<Traced>,
}

impl Baked {
    /// Our time over Embree's packets, its structure built beforehand; below 1 we are ahead.
    pub fn ratio(&self) -> Option<f64> {
        self.embree.as_ref().map(|traced| self.median_ns / traced.times.trace_ns)
    }
}

/// Meshes under every light.
pub fn cases(size: Size, meshes: &[&str], filter: Option<&Regex>) -> Vec<Case> {
    let cases = meshes.iter().flat_map(|mesh| LIGHTS.map(|light| Case { mesh: (*mesh).to_owned(), light, size }));
    cases.filter(|case| filter.is_none_or(|filter| filter.is_match(&case.to_string()))).collect()
}

fn scene(mesh: &str) -> Result<Scene> {
    if let Some(generator) = Generator::from_name(mesh) {
        return Ok(generate(generator));
    }
    let triangles = mesh.strip_prefix("bumpy-").and_then(|n| n.parse().ok());
    triangles.map(bumpy_sphere).ok_or_else(|| Error::Usage(format!("no mesh is called `{mesh}`")))
}

/// The child: bakes a case and writes what it took. `tracer` is Embree's program; its files go beside it.
pub fn serve(case: &str, tracer: Option<&Path>, out: &mut impl Write) -> Result<()> {
    children::serve::<Baked>(case, tracer, out)
}

impl Measured for Baked {
    type Case = Case;
    const COMMAND: &'static str = "shadow";

    fn measure(case: Case, tracer: Option<&Path>) -> Result<Self> {
        measure(case, tracer)
    }

    fn median_ns(&self) -> f64 {
        self.median_ns
    }
}

fn measure(case: Case, tracer: Option<&Path>) -> Result<Baked> {
    let scene = scene(&case.mesh)?;
    let Size { resolution, samples, runs } = case.size;
    let settings = Settings {
        light_size: Some(case.light),
        resolution: Some(resolution),
        samples: Some(samples),
        ..Settings::default()
    };
    let failed = |e: sightlines_visibility::Error| Error::Measurement(format!("{case}: {e}"));
    let request = Setup::new(scene, &settings).map_err(failed)?.request();
    let backend = CpuBackend::new(Config { threads: 1, ..Config::default() });
    let clock = Clock::of(Threads::One);
    let run = || {
        let start = clock.start();
        let bake = bake(&backend, &request, &mut |_| ()).map_err(failed)?;
        Ok((clock.to_f64(&clock.end(start)), bake))
    };
    let (warm_up, first) = run()?;
    let mut runs_ns = (0..runs).map(|_| run().map(|(ns, _)| ns)).collect::<Result<Vec<f64>>>()?;
    if runs == 0 {
        runs_ns.push(warm_up);
    }
    let peak_bytes = peak_bytes();
    let trace = |tracer: &Path| {
        let folder = tracer.parent().unwrap_or(Path::new("."));
        embree::trace(tracer, folder, &snap(&request).map_err(failed)?, &first, runs)
    };
    let median_ns = median(&runs_ns).ok_or_else(|| Error::Measurement("no run".to_owned()))?;
    let rays = f64::from(resolution) * f64::from(resolution) * f64::from(samples);
    let visible: f64 = first.visible.iter().map(|seen| f64::from(*seen)).sum();
    Ok(Baked {
        triangles: request.triangles.len(),
        pairs: first.work.pairs,
        lane_ops: first.work.lane_ops,
        ns_per_lane_op: first.work.lane_ops.filter(|ops| *ops > 0).map(|ops| median_ns / ops as f64),
        rays_per_second: rays / (median_ns / 1e9),
        hidden: 1.0 - visible / rays,
        sets: digest(&first),
        buffer_bytes: first.work.bytes,
        peak_bytes,
        embree: tracer.map(trace).transpose()?,
        median_ns,
        runs_ns,
        case,
    })
}

/// BLAKE3 of the words of all sets.
fn digest(bake: &Bake) -> String {
    let mut hasher = blake3::Hasher::new();
    bake.sets.masks.iter().for_each(|word| {
        hasher.update(&word.to_le_bytes());
    });
    hasher.finalize().to_string()
}

/// Runs the cases in child processes of `exe`, tells each to `progress` as it ends, prints the table to `out` and
/// writes `shadows.json` into the folder. The answer is the exit code.
pub fn run(
    exe: &Path,
    cases: &[Case],
    with_embree: bool,
    folder: &Path,
    out: &mut impl Write,
    progress: &mut impl Write,
) -> Result<u8> {
    if cases.is_empty() {
        return Err(Error::Usage(
            "no shadow matches; a mesh and a light read `palms/0.4` or `bumpy-12000/1`".to_owned(),
        ));
    }
    let tracer = if with_embree { Some(embree::build(folder)?) } else { None };
    let (all, mut failures) =
        children::measure_all::<Baked>(cases, |_| Command::new(exe), tracer.as_deref(), progress)?;
    out.write_all(table(&all).as_bytes())?;
    if with_embree {
        out.write_all(embree_table(&all).as_bytes())?;
        failures.extend(all.iter().filter_map(unequal));
    }
    children::finish(&all, &failures, &folder.join("shadows.json"), out)
}

/// A differing ray that the definition answers against us, or that is not at an edge.
fn unequal(baked: &Baked) -> Option<String> {
    let differing = &baked.embree.as_ref()?.differing;
    let explained = differing.ours_right == differing.judged && differing.farthest_cells <= AT_AN_EDGE;
    (!explained).then(|| format!("{}: Embree's answers differ beyond the edges: {differing:?}", baked.case))
}

fn table(all: &[Baked]) -> String {
    let head = [
        "mesh",
        "triangles",
        "light",
        "s",
        "Mpairs",
        "Mlane-ops",
        "ns/lane-op",
        "Mrays/s",
        "hidden",
        "MiB",
        "peak MiB",
    ];
    let mut lines = vec![head.map(str::to_owned).to_vec()];
    lines.extend(all.iter().map(|baked| {
        vec![
            baked.case.mesh.clone(),
            baked.triangles.to_string(),
            baked.case.light.to_string(),
            cell(Some(baked.median_ns / 1e9), 2),
            cell(Some(baked.pairs as f64 / 1e6), 2),
            cell(baked.lane_ops.map(|ops| ops as f64 / 1e6), 1),
            cell(baked.ns_per_lane_op, 3),
            cell(Some(baked.rays_per_second / 1e6), 1),
            cell(Some(baked.hidden), 4),
            cell(Some(mebibytes(baked.buffer_bytes)), 1),
            cell(baked.peak_bytes.map(mebibytes), 0),
        ]
    }));
    let mut text = String::new();
    Columns { left: 1, lines }.render(&mut text);
    text
}

fn mebibytes(bytes: u64) -> f64 {
    bytes as f64 / f64::from(1 << 20)
}

fn embree_table(all: &[Baked]) -> String {
    let head =
        ["mesh", "light", "build s", "trace s", "robust s", "Mrays", "differing", "share", "cells", "ours/trace"];
    let mut lines = vec![head.map(str::to_owned).to_vec()];
    for (baked, traced) in all.iter().filter_map(|baked| Some((baked, baked.embree.as_ref()?))) {
        lines.push(vec![
            baked.case.mesh.clone(),
            baked.case.light.to_string(),
            cell(Some(traced.times.build_ns / 1e9), 3),
            cell(Some(traced.times.trace_ns / 1e9), 2),
            cell(Some(traced.times.robust_ns / 1e9), 2),
            cell(Some(traced.times.rays as f64 / 1e6), 1),
            traced.differing.rays.to_string(),
            format!("{:.1e}", traced.differing.share),
            cell(Some(traced.differing.farthest_cells), 4),
            cell(baked.ratio(), 2),
        ]);
    }
    let mut text = "\nEmbree, packets of 16 rays, receivers in the shadow's box\n".to_owned();
    Columns { left: 1, lines }.render(&mut text);
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases_are_every_mesh_under_every_light_and_can_be_selected() {
        assert_eq!(cases(Size::FULL, &MESHES, None).len(), 15);
        let palms = cases(Size::FULL, &MESHES, Some(&Regex::new("^palms/0").unwrap()));
        assert_eq!(palms.iter().map(|case| case.light).collect::<Vec<_>>(), [0.1, 0.4]);
    }

    #[test]
    fn a_child_bakes_its_case_and_the_table_has_it() {
        let size = Size { resolution: 32, samples: 32, runs: 2 };
        let case = Case { mesh: "bumpy-1000".to_owned(), light: 0.4, size };
        let mut out = Vec::new();
        serve(&serde_json::to_string(&case).unwrap(), None, &mut out).unwrap();
        let baked: Baked = serde_json::from_slice(&out).unwrap();
        assert_eq!((baked.case.clone(), baked.runs_ns.len()), (case, 2));
        assert!(baked.pairs > 0 && baked.lane_ops > Some(0) && baked.rays_per_second > 0.0);
        assert_eq!(baked.sets.len(), 64);
        // 32 words of masks at least.
        assert!(baked.buffer_bytes >= 4 * 32 * 32, "{} bytes", baked.buffer_bytes);
        assert!(baked.hidden > 0.0 && baked.hidden < 1.0, "{}", baked.hidden);
        assert!(table(&[baked]).contains("bumpy-1000"));
        assert!(serve("{}", None, &mut Vec::new()).is_err());
        assert!(matches!(scene("moon"), Err(Error::Usage(_))));
    }
}

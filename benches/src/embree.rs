//! The same rays by Embree, in the same run: `cargo xtask bench shadows --embree`, `cargo xtask bench ambient
//! --embree`.
//!
//! `benches/embree` is a C++ program that is built here, on demand, and traces quantised triangles in packets of 16
//! rays. Its fast mode is timed; the answers of its watertight mode are held against ours, bit for bit. Here are the
//! program, its times and the rays of shadows, from the receivers in the shadow's box alone: those that differ are
//! judged by the definition and by how near they pass to an edge. `ambient::rays` has the others.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::{Deserialize, Serialize};
use sightlines_kernels::grid::{Point, Triangle, hidden};
use sightlines_visibility::shadows::Bake;
use sightlines_visibility::shadows::snap::Snapped;

use crate::error::{Error, Result};
use crate::statistics::median;

/// Differing rays that are judged, evenly spread over all of them.
pub(crate) const JUDGED: usize = 256;

/// What Embree took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// Median CPU time of the acceleration structure.
    pub build_ns: f64,
    /// Median CPU time of all its rays.
    pub trace_ns: f64,
    /// CPU time of each run's rays.
    pub runs_ns: Vec<f64>,
    /// The same in the watertight mode, once.
    pub robust_ns: f64,
    /// Rays that were traced.
    pub rays: u64,
    /// Whether this build of Embree traces 16 rays at a time.
    pub packets16: bool,
}

/// What the rays of a shadow took, and how Embree's answers compare.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Traced {
    /// Times; rays from outside the shadow's box are free.
    #[serde(flatten)]
    pub times: Times,
    /// How the watertight answers differ from ours.
    pub differing: Differing,
}

/// Rays that Embree answers differently.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Differing {
    /// Their number.
    pub rays: u64,
    /// Their share of all pairs of a receiver and a sample.
    pub share: f64,
    /// How many were judged.
    pub judged: u64,
    /// How many of those the definition answers as we do: all, or we are wrong.
    pub ours_right: u64,
    /// Greatest distance of a judged ray from the nearest edge, in cells of the grid.
    pub farthest_cells: f64,
}

/// What the program prints.
#[derive(Deserialize)]
struct Report {
    build_ns: f64,
    trace_ns: f64,
    rays: u64,
    packets16: bool,
}

/// Builds the program in `folder`.
pub fn build(folder: &Path) -> Result<PathBuf> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("embree");
    let folder = std::path::absolute(folder.join("embree")).map_err(|e| Error::file(folder, e))?;
    let remedy =
        "install make, a C++17 compiler and Embree, on Debian and Ubuntu: apt-get install make g++ libembree-dev";
    let missing =
        |what: String| Error::Missing(format!("the Embree tracer cannot be built: {what}\n  remedy: {remedy}"));
    let mut make = Command::new("make");
    make.arg("-C").arg(&source).arg(format!("OUT={}", folder.display()));
    let output = make.stdin(Stdio::null()).output().map_err(|e| missing(format!("make: {e}")))?;
    if !output.status.success() {
        return Err(missing(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    Ok(folder.join("trace"))
}

/// Traces a bake's rays `runs` times with `program`, its files in `folder`, and compares the answers with its sets.
pub fn trace(program: &Path, folder: &Path, scene: &Snapped, bake: &Bake, runs: usize) -> Result<Traced> {
    let (times, theirs) = time(program, folder, &words(scene), runs)?;
    Ok(Traced { times, differing: compare(scene, bake, &theirs)? })
}

/// Traces a file `runs` times after a warm-up, and once in the watertight mode, whose answers it gives.
pub(crate) fn time(program: &Path, folder: &Path, words: &[u32], runs: usize) -> Result<(Times, Vec<u32>)> {
    let [file, answers] = ["trace.rays", "trace.sets"].map(|name| folder.join(name));
    fs::write(&file, bytes(words)).map_err(|e| Error::file(&file, e))?;
    let run = |mode: &[&str]| -> Result<Report> {
        let output = Command::new(program).arg(&file).arg(&answers).args(mode).stdin(Stdio::null()).output();
        let output = output.map_err(|e| Error::Worker(format!("{}: {e}", program.display())))?;
        if !output.status.success() {
            return Err(Error::Worker(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
        }
        serde_json::from_slice(&output.stdout).map_err(|e| Error::Worker(format!("{}: {e}", program.display())))
    };
    run(&[])?;
    let reports = (0..runs.max(1)).map(|_| run(&[])).collect::<Result<Vec<_>>>()?;
    let robust = run(&["--robust"])?;
    let theirs = fs::read(&answers).map_err(|e| Error::file(&answers, e))?;
    let runs_ns: Vec<f64> = reports.iter().map(|report| report.trace_ns).collect();
    let builds: Vec<f64> = reports.iter().map(|report| report.build_ns).collect();
    let nothing = || Error::Measurement("no run".to_owned());
    let times = Times {
        build_ns: median(&builds).ok_or_else(nothing)?,
        trace_ns: median(&runs_ns).ok_or_else(nothing)?,
        runs_ns,
        robust_ns: robust.trace_ns,
        rays: robust.rays,
        packets16: robust.packets16,
    };
    Ok((times, theirs.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect()))
}

/// The first words of a trace file of a kind, to the last triangle, as `benches/embree/trace.h` describes them.
pub(crate) fn head(kind: u32, triangles: &[Triangle]) -> Vec<u32> {
    let mut words = vec![u32::from_le_bytes(*b"SIGH"), u32::from_le_bytes(*b"TRAY"), kind, triangles.len() as u32];
    words.extend(triangles.iter().flatten().flatten().map(|c| *c as u32));
    words
}

/// The trace file of shadows, as `benches/embree/shadows.cpp` describes it.
fn words(scene: &Snapped) -> Vec<u32> {
    let (receivers, samples) = (&scene.receivers, &scene.samples);
    let mut words = head(0, &[&scene.between[..], &scene.crossing].concat());
    words
        .extend([receivers.origin, receivers.step].as_flattened().iter().chain([&receivers.height]).map(|c| *c as u32));
    words.extend([receivers.columns, receivers.rows]);
    words.extend([samples.origin, samples.step].as_flattened().iter().map(|c| *c as u32));
    words.extend([samples.columns, samples.rows]);
    words
}

fn bytes(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// Counts and judges the rays of which the two answers differ; `theirs` is in the order of the grid.
fn compare(scene: &Snapped, bake: &Bake, theirs: &[u32]) -> Result<Differing> {
    let (sets, receivers) = (&bake.sets, scene.receivers);
    let words = sets.words as usize;
    if theirs.len() != sets.masks.len() {
        return Err(Error::Measurement(format!("{} words of answers, expected {}", theirs.len(), sets.masks.len())));
    }
    // The image's columns and rows may run against the grid's.
    let turned = |index: u32, count: u32, mirrored: bool| if mirrored { count - 1 - index } else { index };
    let mut rays = Vec::new();
    for receiver in 0..receivers.count() {
        let column = turned(receiver % receivers.columns, receivers.columns, scene.mirrored[0]);
        let row = turned(receiver / receivers.columns, receivers.rows, scene.mirrored[1]);
        let ours = &sets.masks[(row * receivers.columns + column) as usize * words..][..words];
        let theirs = &theirs[receiver as usize * words..][..words];
        for (word, (ours, theirs)) in ours.iter().zip(theirs).enumerate().filter(|(_, (a, b))| a != b) {
            let bits = (0..32).filter(|bit| (ours ^ theirs) >> bit & 1 == 1);
            rays.extend(bits.map(|bit| (receiver, 32 * word as u32 + bit, ours >> bit & 1 == 1)));
        }
    }
    let mut differing = Differing {
        rays: rays.len() as u64,
        share: rays.len() as f64 / (f64::from(receivers.count()) * f64::from(sets.samples)),
        ..Differing::default()
    };
    for &(receiver, sample, ours) in rays.iter().step_by(rays.len().div_ceil(JUDGED).max(1)) {
        let (r, s) = (receivers.at(receiver), scene.samples.at(sample));
        let mut is_hidden = false;
        let mut distance = f64::INFINITY;
        for triangle in scene.between.iter().chain(&scene.crossing).filter(|t| is_near(r, s, t)) {
            is_hidden |= hidden(r, s, triangle);
            distance = distance.min(edge_distance(r, s, triangle));
        }
        differing.judged += 1;
        differing.ours_right += u64::from(is_hidden == ours);
        differing.farthest_cells = differing.farthest_cells.max(distance);
    }
    Ok(differing)
}

/// Cells by which boxes are widened, far more than any rounding in f64.
const MARGIN: f64 = 4.0;

/// Whether the segment from r to a sample s at z = 0 comes near to a triangle's box.
fn is_near(r: Point, s: Point, triangle: &Triangle) -> bool {
    let range = |axis: usize| {
        let [a, b, c] = triangle.map(|v| f64::from(v[axis]));
        (a.min(b).min(c), a.max(b).max(c))
    };
    let (low, high) = range(2);
    let share = [low, high].map(|z| (z / f64::from(r[2])).clamp(0.0, 1.0));
    (0..2).all(|axis| {
        let (s, r) = (f64::from(s[axis]), f64::from(r[axis]));
        let [p, q] = share.map(|share| s + (r - s) * share);
        let (least, most) = range(axis);
        p.min(q) <= most + MARGIN && p.max(q) >= least - MARGIN
    })
}

/// Least distance of the line through r and s from an edge.
fn edge_distance(r: Point, s: Point, triangle: &Triangle) -> f64 {
    let minus = |a: Point, b: Point| -> [f64; 3] { std::array::from_fn(|i| f64::from(a[i] - b[i])) };
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let ray = minus(r, s);
    let across = |v: [f64; 3]| -> [f64; 3] {
        let along = dot(v, ray) / dot(ray, ray);
        std::array::from_fn(|i| v[i] - along * ray[i])
    };
    let distance = |a: Point, b: Point| {
        let (from, edge) = (across(minus(a, s)), across(minus(b, a)));
        let length = dot(edge, edge);
        let share = if length > 0.0 { (-dot(from, edge) / length).clamp(0.0, 1.0) } else { 0.0 };
        let nearest: [f64; 3] = std::array::from_fn(|i| from[i] + share * edge[i]);
        dot(nearest, nearest).sqrt()
    };
    let [a, b, c] = *triangle;
    distance(a, b).min(distance(b, c)).min(distance(c, a))
}

#[cfg(test)]
mod tests {
    use sightlines_kernels::grid::{Receivers, Samples};
    use sightlines_visibility::shadows::{Sets, Work};

    use super::*;

    const CASTER: Triangle = [[0, 0, 50], [40, 0, 50], [0, 40, 50]];

    fn scene() -> Snapped {
        Snapped {
            samples: Samples { origin: [-16, -16], step: [4, 8], columns: 8, rows: 4 },
            light: [[-18, -20], [32, 32]],
            receivers: Receivers { origin: [-10, -10], step: [10, 10], height: 100, columns: 4, rows: 4 },
            mirrored: [false, true],
            between: vec![CASTER],
            crossing: Vec::new(),
            faces: Default::default(),
            cell: 1.0,
        }
    }

    /// By the definition, in the order of the grid.
    fn answers(scene: &Snapped) -> Vec<u32> {
        let set =
            |r| (0..32).map(|s| u32::from(hidden(scene.receivers.at(r), scene.samples.at(s), &CASTER)) << s).sum();
        (0..16).map(set).collect()
    }

    fn bake(scene: &Snapped) -> Bake {
        let masks = answers(scene).chunks(4).rev().flatten().copied().collect();
        let sets = Sets { resolution: 4, samples: 32, bits: 32, words: 1, masks, samples_uv: Vec::new(), cell: 1.0 };
        Bake { sets, visible: Vec::new(), work: Work::default() }
    }

    #[test]
    fn equal_answers_differ_nowhere_and_a_flipped_bit_is_found_and_judged() {
        let scene = scene();
        let bake = bake(&scene);
        let mut theirs = answers(&scene);
        assert_eq!(compare(&scene, &bake, &theirs).unwrap(), Differing::default());
        theirs[6] ^= 1 << 9;
        let one = compare(&scene, &bake, &theirs).unwrap();
        assert_eq!((one.rays, one.judged, one.ours_right), (1, 1, 1));
        let (r, s) = (scene.receivers.at(6), scene.samples.at(9));
        assert!((one.farthest_cells - edge_distance(r, s, &CASTER)).abs() < 1e-9);
        assert!(compare(&scene, &bake, &theirs[1..]).is_err());
    }

    #[test]
    fn a_set_of_ours_that_is_wrong_shows() {
        let scene = scene();
        let mut bake = bake(&scene);
        bake.sets.masks[0] ^= 1;
        let one = compare(&scene, &bake, &answers(&scene)).unwrap();
        assert_eq!((one.rays, one.judged, one.ours_right), (1, 1, 0));
    }

    #[test]
    fn distances_are_those_of_lines_and_edges() {
        // The line x = 10, y = 10 passes the edge x + y = 40 at 20 / sqrt 2, the others at 10.
        assert!((edge_distance([10, 10, 100], [10, 10, 0], &CASTER) - 10.0).abs() < 1e-9);
        assert!((edge_distance([-3, -4, 100], [-3, -4, 0], &CASTER) - 5.0).abs() < 1e-9);
        assert!(is_near([-3, -4, 100], [-3, -4, 0], &CASTER) && !is_near([-3, -5, 100], [-3, -5, 0], &CASTER));
    }
}

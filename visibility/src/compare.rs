//! Other methods for the soft shadow that [`crate::shadows`] bakes, on the same grid, machine and scene.
//!
//! [`projections`] draws all triangles once from each sample of the light, as Heckbert and Herf do (1997); what it
//! gives must equal what `bake` gives, bit for bit. [`volumes`] adds up what silhouettes seen from the light's centre
//! hide, as soft shadow volumes do (Assarsson et al. 2003): too dark where casters stand behind each other, and wrong
//! where another point of the light sees another silhouette. [`maps`] adds up what patches of a depth map hide, as soft
//! shadow maps do, and [`tables`] is the order of the paper itself, with its table of angles and distances. Eisemann
//! and Décoret, *Visibility Sampling on GPU and Applications*, sections 8 and 10, compare with the first three.

mod maps;
mod tables;

use std::path::Path;

use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job};
use sightlines_kernels::popcount::{Method, Popcount, Shape};
use sightlines_kernels::sample_planes::{SamplePlanes, Scene};

use crate::error::{Place, Result};
use crate::output;
use crate::shadows::compose::{Composed, run};
use crate::shadows::snap::{Snapped, snap};
pub use maps::maps;
pub use tables::{TABLE_BITS, tables};

use crate::shadows::{Bake, Faces, Request, Work, assemble, upright};

/// Most words of all sets together: 128 MiB, what a binding holds.
pub const MAX_WORDS: u64 = 1 << 25;

/// What a method that adds up leaves of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Added {
    /// Samples that each texel is said to see, row after row: those that there are less those that are added up, at
    /// least none and at most all.
    pub visible: Vec<u32>,
    /// What it took.
    pub work: Work,
}

/// One method on one request, for a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Texels a side.
    pub resolution: u32,
    /// Samples of the light.
    pub samples: u32,
    /// First side of the light, in scene units.
    pub light_side: f64,
    /// Triangles of the scene.
    pub triangles: usize,
    /// Name of the method.
    pub method: &'static str,
    /// What it took.
    pub work: Work,
    /// Part of all samples of all receivers that it has other than sampling; none where it has no sets.
    pub differ: Option<f64>,
    /// How far its shares of the light are from those of sampling, in the mean.
    pub error: f64,
    /// How long it took.
    pub seconds: f64,
}

/// Writes a row for every run; lane-operations that were not counted are left empty.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_csv(path: &Path, runs: &[Run]) -> Result<()> {
    output::write(path, |out| {
        writeln!(out, "resolution,samples,light_side,triangles,method,pairs,lane_ops,differ,error,seconds")?;
        runs.iter().try_for_each(|run| {
            let Run { resolution, samples, light_side, triangles, method, work, differ, error, seconds } = run;
            let ops = work.lane_ops.map_or_else(String::new, |ops| ops.to_string());
            let differ = differ.map_or_else(String::new, |differ| format!("{differ:.9}"));
            write!(out, "{resolution},{samples},{light_side},{triangles},{method},{},{ops},", work.pairs)?;
            writeln!(out, "{differ},{error:.9},{seconds:.6}")
        })
    })
}

/// Bakes the sets by a projection for each sample. The pairs of its work are projections of a triangle.
///
/// # Errors
///
/// As [`crate::shadows::bake`]; and triangles that reach the receivers' plane, and more sets than [`MAX_WORDS`].
pub fn projections(backend: &dyn Backend, request: &Request, progress: &mut dyn FnMut(f32)) -> Result<Bake> {
    let scene = snapped(request)?;
    let (words, receivers) = (scene.samples.words() as usize, scene.receivers.count());
    let mut job = Job::new();
    let given = upload(&mut job, &scene);
    let hidden = job.zeroed("hidden", u64::from(receivers) * words as u64);
    if given.triangles > 0 {
        SamplePlanes::new()?.record(&mut job, given, hidden)?;
    }
    let shape = Shape { receivers, samples: scene.samples.count(), bits: 32 };
    let counts = ["hidden counts", "visible counts"].map(|name| job.zeroed(name, u64::from(receivers)));
    Popcount::new()?.record(&mut job, Method::Builtin, shape, hidden, counts[0], counts[1])?;
    job.read("hidden", hidden.id());
    job.read("visible", counts[1].id());
    let mut work = Work { pairs: pairs(&scene), ..Work::default() };
    let [planes, visible] = run(backend, &job, &mut work, progress)?;
    let masks = interleaved(&planes, receivers as usize, words);
    progress(1.0);
    Ok(assemble(request, &scene, Composed { masks, visible, work }))
}

/// Counts by silhouette volumes, whose pairs are projections of a triangle. Meshes are taken as closed,
/// counter-clockwise as seen from outside.
///
/// # Errors
///
/// As [`projections`].
pub fn volumes(backend: &dyn Backend, request: &Request, progress: &mut dyn FnMut(f32)) -> Result<Added> {
    let scene = snapped(request)?;
    let mut job = Job::new();
    let given = upload(&mut job, &scene);
    let counts: Buffer<[u32]> = job.zeroed("added up", u64::from(scene.receivers.count()));
    if given.triangles > 0 {
        SamplePlanes::new()?.record_additive(&mut job, given, counts)?;
    }
    job.read("added up", counts.id());
    let mut work = Work { pairs: pairs(&scene), ..Work::default() };
    let [sums] = run(backend, &job, &mut work, progress)?;
    let samples = request.samples as i32;
    let visible = sums.into_iter().map(|sum| (samples - (sum as i32).clamp(0, samples)) as u32).collect();
    progress(1.0);
    Ok(Added { visible: upright(visible, 1, request.resolution as usize, scene.mirrored), work })
}

/// Masks of `count` receivers, whose words come plane by plane, side by side.
fn interleaved(planes: &[u32], count: usize, words: usize) -> Vec<u32> {
    (0..count).flat_map(|r| (0..words).map(move |w| (w, r))).map(|(w, r)| planes[w * count + r]).collect()
}

/// Projections of a triangle.
fn pairs(scene: &Snapped) -> u64 {
    scene.between.len() as u64 * u64::from(scene.samples.count())
}

fn snapped(request: &Request) -> Result<Snapped> {
    let scene = snap(request)?;
    let refuse = |what: String, remedy: &str| Err(Place::default().element("comparison").error(what, remedy));
    if !scene.crossing.is_empty() {
        let what = format!("{} triangles reach the receiver's or the light's plane", scene.crossing.len());
        return refuse(what, "compare scenes that stand between light and receiver: move the receiver");
    }
    if request.faces != Faces::Both {
        return refuse("one-sided casters".to_owned(), "compare casters that hide from either side");
    }
    let words = u64::from(scene.receivers.count()) * u64::from(scene.samples.words());
    if words > MAX_WORDS {
        let what = format!("{} MiB of sets at once, at most {} MiB fit a binding", words >> 18, MAX_WORDS >> 18);
        return refuse(what, "compare fewer samples or texels");
    }
    Ok(scene)
}

fn upload(job: &mut Job, scene: &Snapped) -> Scene {
    let words = scene.between.as_flattened().as_flattened();
    // A binding holds at least one element.
    let vertices = job.slice("vertices", if words.is_empty() { &[0] } else { words });
    let triangles = scene.between.len() as u32;
    Scene { samples: scene.samples, receivers: scene.receivers, vertices, triangles }
}

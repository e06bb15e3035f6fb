//! The kernels in order: influence regions, tile lists, row spans, half-planes.
//!
//! Receivers are worked on in bands whose sets fit one binding. Within a band every recording is of bounded cost, and
//! progress is told after each.

use sightlines_backend::{Backend, Job, Read, Session};
use sightlines_kernels::grid::{Receivers, Triangle};
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::InfluenceRegion;
use sightlines_kernels::row_span::{RowSpan, Scene, Tiles, tile_width};

use super::snap::Snapped;
use crate::error::Result;

/// Words of the sets of one band: 64 MiB, half of what a binding holds.
const BAND_WORDS: u64 = 1 << 24;

/// Receiver rows that share a list of triangles.
const TILE_ROWS: u32 = 8;

/// The sets of all receivers, `words` a receiver, in ascending x and y.
pub(super) fn sets(backend: &dyn Backend, scene: &Snapped, progress: &mut dyn FnMut(f32)) -> Result<Vec<u32>> {
    let words = scene.samples.words();
    let receivers = scene.receivers;
    let most = BAND_WORDS / u64::from(words * receivers.columns);
    let rows = (most as u32 / TILE_ROWS * TILE_ROWS).clamp(TILE_ROWS, receivers.rows.max(TILE_ROWS));
    let bands: Vec<Receivers> = (0..receivers.rows)
        .step_by(rows as usize)
        .map(|first| Receivers {
            origin: [receivers.origin[0], receivers.origin[1] + receivers.step[1] * first as i32],
            rows: rows.min(receivers.rows - first),
            ..receivers
        })
        .collect();
    let mut sets = Vec::with_capacity(receivers.count() as usize * words as usize);
    for (index, band) in bands.iter().enumerate() {
        let mut part = |share: f32| progress((index as f32 + share) / bands.len() as f32);
        let planes = band_sets(backend, scene, band, &mut part)?;
        let count = band.count() as usize;
        sets.extend(
            (0..count).flat_map(|r| (0..words as usize).map(move |w| (w, r))).map(|(w, r)| planes[w * count + r]),
        );
    }
    progress(1.0);
    Ok(sets)
}

/// The sets of a band: one plane a word.
fn band_sets(
    backend: &dyn Backend,
    scene: &Snapped,
    band: &Receivers,
    progress: &mut dyn FnMut(f32),
) -> Result<Vec<u32>> {
    let regions = regions(backend, scene, band)?;
    let tiles = Tiles::new([tile_width(&scene.samples), TILE_ROWS], band, &regions);
    let mut job = Job::new();
    let hidden = job.zeroed("hidden", u64::from(band.count()) * u64::from(scene.samples.words()));
    if !scene.between.is_empty() && !tiles.entries.is_empty() {
        let vertices = job.slice("vertices between", scene.between.as_flattened().as_flattened());
        let starts = job.slice("tile starts", &tiles.starts);
        let entries = job.slice("tile entries", &tiles.entries);
        let buffers = Scene { vertices, starts, entries, hidden };
        RowSpan::new(&scene.samples)?.record(&mut job, band, &tiles, buffers)?;
    }
    if !scene.crossing.is_empty() {
        let vertices = job.slice("vertices crossing", scene.crossing.as_flattened().as_flattened());
        let all = 0..scene.crossing.len() as u32;
        HalfPlanes::new(&scene.samples)?.record(&mut job, band, vertices, all, hidden)?;
    }
    job.read("hidden", hidden.id());
    let mut session = open(backend, &job)?;
    for (index, recording) in job.recordings.iter().enumerate() {
        session.submit(recording)?;
        progress(index as f32 / job.recordings.len() as f32);
    }
    Ok(words(&session.read(&job.reads[0])?))
}

/// The influence regions of the triangles between, on a band.
fn regions(backend: &dyn Backend, scene: &Snapped, band: &Receivers) -> Result<Vec<[i32; 4]>> {
    let triangles: &[Triangle] = &scene.between;
    if triangles.is_empty() {
        return Ok(Vec::new());
    }
    let mut job = Job::new();
    let vertices = job.slice("vertices", triangles.as_flattened().as_flattened());
    let regions = job.zeroed("regions", 4 * triangles.len() as u64);
    InfluenceRegion::new()?.record(&mut job, &scene.samples, band, vertices, regions)?;
    let read = Read { name: "regions".into(), buffer: regions.id(), offset: 0, size: regions.size() };
    let mut session = open(backend, &job)?;
    for recording in &job.recordings {
        session.submit(recording)?;
    }
    let words = words(&session.read(&read)?);
    Ok(words.as_chunks().0.iter().map(|region: &[u32; 4]| region.map(|word| word as i32)).collect())
}

fn open<'a>(backend: &'a dyn Backend, job: &Job) -> Result<Box<dyn Session + 'a>> {
    sightlines_backend::check::job(job)?;
    Ok(backend.open(&job.programs, &job.buffers)?)
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect()
}

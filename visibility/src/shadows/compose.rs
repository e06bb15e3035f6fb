//! The kernels in order: influence regions, tile lists, row spans, half-planes, bit counts.
//!
//! Receivers are worked on in bands whose sets fit one binding. Within a band every recording is of bounded cost, and
//! progress is told after each.

use sightlines_backend::{Backend, Job};
use sightlines_kernels::grid::{Receivers, Triangle};
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::InfluenceRegion;
use sightlines_kernels::popcount::{Method, Popcount, Shape};
use sightlines_kernels::row_span::{RowSpan, Scene, WIDTH};
use sightlines_kernels::tiles::Tiles;

use super::Work;
use super::snap::Snapped;
use crate::error::Result;

/// Words of the sets of one band: 64 MiB, half of what a binding holds.
const BAND_WORDS: u64 = 1 << 24;

/// Receiver rows that share a list of triangles.
const TILE_ROWS: u32 = 8;

/// What the kernels give for all receivers, in ascending x and y.
pub(super) struct Composed {
    /// The sets, words of a receiver side by side.
    pub(super) masks: Vec<u32>,
    /// Visible samples of each receiver.
    pub(super) visible: Vec<u32>,
    /// What it took.
    pub(super) work: Work,
}

/// Runs the kernels, band after band.
pub(super) fn bake(backend: &dyn Backend, scene: &Snapped, progress: &mut dyn FnMut(f32)) -> Result<Composed> {
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
    let mut all = Composed {
        masks: Vec::with_capacity(receivers.count() as usize * words as usize),
        visible: Vec::with_capacity(receivers.count() as usize),
        work: Work::default(),
    };
    for (index, band) in bands.iter().enumerate() {
        let mut part = |share: f32| progress((index as f32 + share) / bands.len() as f32);
        let Composed { masks, visible, work } = bake_band(backend, scene, band, &mut part)?;
        let count = band.count() as usize;
        all.masks.extend(
            (0..count).flat_map(|r| (0..words as usize).map(move |w| (w, r))).map(|(w, r)| masks[w * count + r]),
        );
        all.visible.extend(visible);
        all.work += work;
    }
    progress(1.0);
    Ok(all)
}

/// A band, its masks one plane a word.
fn bake_band(
    backend: &dyn Backend,
    scene: &Snapped,
    band: &Receivers,
    progress: &mut dyn FnMut(f32),
) -> Result<Composed> {
    let (regions, mut work) = regions(backend, scene, band)?;
    let tiles = Tiles::new([WIDTH, TILE_ROWS], band, &regions);
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
        work.pairs += u64::from(band.count()) * scene.crossing.len() as u64;
    }
    let shape = Shape { receivers: band.count(), samples: scene.samples.count(), bits: 32 };
    let [hidden_counts, visible] =
        ["hidden counts", "visible counts"].map(|name| job.zeroed(name, shape.receivers.into()));
    Popcount::new()?.record(&mut job, Method::Builtin, shape, hidden, hidden_counts, visible)?;
    job.read("hidden", hidden.id());
    job.read("visible", visible.id());
    let [masks, visible] = run(backend, &job, &mut work, progress)?;
    Ok(Composed { masks, visible, work })
}

/// The influence regions of the triangles between, on a band, and the work of them and of the pairs that they make.
fn regions(backend: &dyn Backend, scene: &Snapped, band: &Receivers) -> Result<(Vec<[i32; 4]>, Work)> {
    let mut work = Work::default();
    let triangles: &[Triangle] = &scene.between;
    if triangles.is_empty() {
        return Ok((Vec::new(), work));
    }
    let mut job = Job::new();
    let vertices = job.slice("vertices", triangles.as_flattened().as_flattened());
    let regions = job.zeroed("regions", 4 * triangles.len() as u64);
    InfluenceRegion::new()?.record(&mut job, &scene.samples, band, vertices, regions)?;
    job.read("regions", regions.id());
    let [words] = run(backend, &job, &mut work, &mut |_| ())?;
    let regions: Vec<_> = words.as_chunks().0.iter().map(|region: &[u32; 4]| region.map(|word| word as i32)).collect();
    let side = |first: i32, last: i32| (i64::from(last) - i64::from(first) + 1).max(0) as u64;
    work.pairs = regions.iter().map(|[x0, x1, y0, y1]| side(*x0, *x1) * side(*y0, *y1)).sum();
    Ok((regions, work))
}

/// Runs a job, adds its costs to `work` and gives the words of its `N` reads.
fn run<const N: usize>(
    backend: &dyn Backend,
    job: &Job,
    work: &mut Work,
    progress: &mut dyn FnMut(f32),
) -> Result<[Vec<u32>; N]> {
    sightlines_backend::check::job(job)?;
    let mut session = backend.open(&job.programs, &job.buffers)?;
    for (index, recording) in job.recordings.iter().enumerate() {
        session.submit(recording)?;
        progress(index as f32 / job.recordings.len() as f32);
    }
    *work += Work { pairs: 0, lane_ops: session.lane_ops(), counts: session.counts() };
    let mut outputs: [Vec<u32>; N] = std::array::from_fn(|_| Vec::new());
    for (output, read) in outputs.iter_mut().zip(&job.reads) {
        let bytes = session.read(read)?;
        *output = bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
    }
    Ok(outputs)
}

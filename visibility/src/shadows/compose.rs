//! The kernels in order: influence regions, tile lists, row spans, half-planes, bit counts.
//!
//! Receivers are worked on in bands whose sets fit one binding. Within a band every recording is of bounded cost, and
//! progress is told after each.

use std::ops::Range;

use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job};
use sightlines_kernels::grid::Receivers;
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::InfluenceRegion;
use sightlines_kernels::popcount::{Method, Popcount, Shape};
use sightlines_kernels::row_span::{RowSpan, Scene, WIDTH};
use sightlines_kernels::tiles::{self, Tiles};

use super::Work;
use super::snap::Snapped;
use crate::error::Result;

/// Words of the sets of one band: 64 MiB, half of what a binding holds.
const BAND_WORDS: u64 = 1 << 24;

/// Receiver rows that share a list of triangles, at least.
const TILE_ROWS: u32 = 8;

/// Most triangles at a time: 72 MiB of vertices are within a binding.
const MOST_TRIANGLES: usize = 1 << 21;

/// What the kernels give for all receivers, in ascending x and y.
pub(crate) struct Composed {
    /// The sets, words of a receiver side by side.
    pub(crate) masks: Vec<u32>,
    /// Visible samples of each receiver.
    pub(crate) visible: Vec<u32>,
    /// What it took.
    pub(crate) work: Work,
}

/// Runs the kernels, band after band.
///
/// Triangles are taken in batches whose lists have at most `entries` entries.
pub(super) fn bake(
    backend: &dyn Backend,
    scene: &Snapped,
    entries: u64,
    progress: &mut dyn FnMut(f32),
) -> Result<Composed> {
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
        let Composed { masks, visible, work } = bake_band(backend, scene, band, entries, &mut part)?;
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
    entries: u64,
    progress: &mut dyn FnMut(f32),
) -> Result<Composed> {
    let mut work = Work::default();
    let regions = regions(backend, scene, band, &mut work)?;
    let size = [WIDTH, tile_rows(&regions)];
    let batches = tiles::batches(size, &regions, entries, MOST_TRIANGLES);
    let mut masks = None;
    for (index, batch) in batches.iter().enumerate() {
        let mut part = |share: f32| progress(0.9 * (index as f32 + share) / batches.len() as f32);
        let mut job = Job::new();
        let hidden = upload(&mut job, masks, scene, band);
        between(&mut job, scene, band, batch.clone(), &Tiles::new(size, band, &regions[batch.clone()]), hidden)?;
        job.read("hidden", hidden.id());
        let [words] = run(backend, &job, &mut work, &mut part)?;
        masks = Some(words);
    }
    let mut job = Job::new();
    let hidden = upload(&mut job, masks, scene, band);
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
    let [masks, visible] = run(backend, &job, &mut work, &mut |share| progress(0.9 + 0.1 * share))?;
    Ok(Composed { masks, visible, work })
}

/// The masks of a band: as they stand, or nothing hidden yet.
fn upload(job: &mut Job, masks: Option<Vec<u32>>, scene: &Snapped, band: &Receivers) -> Buffer<[u32]> {
    match masks {
        Some(masks) => job.slice("hidden", &masks),
        None => job.zeroed("hidden", u64::from(band.count()) * u64::from(scene.samples.words())),
    }
}

/// Records what a batch of the triangles between hides.
fn between(
    job: &mut Job,
    scene: &Snapped,
    band: &Receivers,
    batch: Range<usize>,
    tiles: &Tiles,
    hidden: Buffer<[u32]>,
) -> Result<()> {
    if tiles.entries.is_empty() {
        return Ok(());
    }
    let vertices = job.slice("vertices between", scene.between[batch].as_flattened().as_flattened());
    let starts = job.slice("tile starts", &tiles.starts);
    let entries = job.slice("tile entries", &tiles.entries);
    RowSpan::new(&scene.samples)?.record(job, band, tiles, Scene { vertices, starts, entries, hidden })?;
    Ok(())
}

/// Rows of a tile: a quarter of what the triangles' regions have in the mean, so that lists are short and few receivers are
/// looked at in vain.
fn tile_rows(regions: &[[i32; 4]]) -> u32 {
    let heights = regions.iter().filter(|[x0, x1, ..]| x0 <= x1).map(|[.., y0, y1]| (y1 - y0 + 1).max(0) as u64);
    let (count, sum) = heights.filter(|height| *height > 0).fold((0, 0), |(n, sum), height| (n + 1, sum + height));
    let mean: u64 = sum.checked_div(count).unwrap_or(0);
    ((mean / 4).next_power_of_two() as u32).clamp(TILE_ROWS, 8 * TILE_ROWS)
}

/// The influence regions of the triangles between, on a band; their work and the pairs that they make are added to `work`.
fn regions(backend: &dyn Backend, scene: &Snapped, band: &Receivers, work: &mut Work) -> Result<Vec<[i32; 4]>> {
    let mut regions = Vec::with_capacity(scene.between.len());
    let kernel = InfluenceRegion::new()?;
    for triangles in scene.between.chunks(MOST_TRIANGLES) {
        let mut job = Job::new();
        let vertices = job.slice("vertices", triangles.as_flattened().as_flattened());
        let words = job.zeroed("regions", 4 * triangles.len() as u64);
        kernel.record(&mut job, &scene.samples, band, vertices, words)?;
        job.read("regions", words.id());
        let [words] = run(backend, &job, work, &mut |_| ())?;
        regions.extend(words.as_chunks().0.iter().map(|region: &[u32; 4]| region.map(|word| word as i32)));
    }
    let side = |first: i32, last: i32| (i64::from(last) - i64::from(first) + 1).max(0) as u64;
    work.pairs += regions.iter().map(|[x0, x1, y0, y1]| side(*x0, *x1) * side(*y0, *y1)).sum::<u64>();
    Ok(regions)
}

/// Runs a job, adds its costs to `work` and gives the words of its `N` reads.
pub(crate) fn run<const N: usize>(
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
    *work += Work { lane_ops: session.lane_ops(), counts: session.counts(), ..Work::default() };
    let mut outputs: [Vec<u32>; N] = std::array::from_fn(|_| Vec::new());
    for (output, read) in outputs.iter_mut().zip(&job.reads) {
        let bytes = session.read(read)?;
        *output = bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
    }
    Ok(outputs)
}

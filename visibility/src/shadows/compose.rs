//! The kernels in order: influence regions, tile lists, row spans, half-planes, bit counts.
//!
//! Receivers are worked on in bands whose sets fit one binding. Within a band every recording is of bounded cost, and
//! progress is told after each. A session's buffers are fixed when it is opened: a first one finds the regions and
//! tells how many entries their lists have, a second sorts and bakes. What crosses to the host of the lists is where
//! they begin.

use std::ops::Range;

use sightlines_backend::host::{Buffer, Host};
use sightlines_backend::{Backend, Job, Read, Session, check};
use sightlines_kernels::grid::{Receivers, Triangle};
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::InfluenceRegion;
use sightlines_kernels::popcount::{Method, Popcount, Shape};
use sightlines_kernels::row_span::{self, RowSpan, Scene, WIDTH};
use sightlines_kernels::tile_lists::{Grid, Tally, TileLists};
use sightlines_kernels::tiles::{Batch, Tiles, batches};

use super::Work;
use super::snap::Snapped;
use crate::error::Result;

/// Words of the sets of one band: 64 MiB, half of what a binding holds.
const BAND_WORDS: u64 = 1 << 24;

/// Tiles of one band: each takes two words for every thousand triangles that are sorted.
const BAND_TILES: u32 = 1 << 13;

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
/// Triangles are taken in batches whose lists take at most `words` words, with what sorting them takes.
pub(super) fn bake(
    backend: &dyn Backend,
    scene: &Snapped,
    words: u64,
    progress: &mut dyn FnMut(f32),
) -> Result<Composed> {
    let receivers = scene.receivers;
    let set = scene.samples.words();
    let most = (BAND_WORDS / u64::from(set * receivers.columns)) as u32;
    let most = most.min(BAND_TILES / receivers.columns.div_ceil(WIDTH) * TILE_ROWS);
    let rows = (most / TILE_ROWS * TILE_ROWS).clamp(TILE_ROWS, receivers.rows.max(TILE_ROWS));
    let bands: Vec<Receivers> = (0..receivers.rows)
        .step_by(rows as usize)
        .map(|first| Receivers {
            origin: [receivers.origin[0], receivers.origin[1] + receivers.step[1] * first as i32],
            rows: rows.min(receivers.rows - first),
            ..receivers
        })
        .collect();
    let mut all = Composed {
        masks: vec![0; receivers.count() as usize * set as usize],
        visible: Vec::with_capacity(receivers.count() as usize),
        work: Work::default(),
    };
    let mut rest = &mut all.masks[..];
    for (index, receivers) in bands.iter().enumerate() {
        let mut part = |share: f32| progress((index as f32 + share) / bands.len() as f32);
        let band = Band { backend, scene, receivers };
        let (planes, visible) = band.bake(words, &mut all.work, &mut part)?;
        let (masks, after) = rest.split_at_mut(planes.len() / 4);
        interleave(&planes, set as usize, masks);
        all.visible.extend(visible);
        rest = after;
    }
    progress(1.0);
    Ok(all)
}

/// Puts the words of a receiver side by side that come one plane a word.
fn interleave(planes: &[u8], words: usize, masks: &mut [u32]) {
    // Planes are powers of two apart: so few receivers at a time share their cache lines.
    const RECEIVERS: usize = 16;
    let planes = planes.as_chunks::<4>().0;
    let count = planes.len() / words;
    for (block, masks) in masks.chunks_mut(RECEIVERS * words).enumerate() {
        for word in 0..words {
            let plane = &planes[word * count + block * RECEIVERS..][..masks.len() / words];
            masks[word..].iter_mut().step_by(words).zip(plane).for_each(|(to, from)| *to = u32::from_le_bytes(*from));
        }
    }
}

/// Some rows of receivers.
struct Band<'a> {
    backend: &'a dyn Backend,
    scene: &'a Snapped,
    receivers: &'a Receivers,
}

/// Triangles whose lists are sorted together.
struct Turn {
    triangles: Range<usize>,
    entries: u64,
    grid: Grid,
}

/// What a session needs to know to go on when it has sorted a turn's lists.
struct Sorted {
    kernel: RowSpan,
    grid: Grid,
    scene: Scene,
    room: Buffer<row_span::Params>,
}

impl Band<'_> {
    /// The sets, one plane a word, as bytes, and the counts.
    fn bake(&self, words: u64, work: &mut Work, progress: &mut dyn FnMut(f32)) -> Result<(Vec<u8>, Vec<u32>)> {
        let turns = self.turns(words, work)?;
        let (last, before) = turns.split_last().map_or((None, &[][..]), |(last, before)| (Some(last), before));
        let runs = before.len() as f32 + 1.0;
        let mut planes = None;
        for (index, turn) in before.iter().enumerate() {
            let mut job = Job::new();
            let hidden = self.masks(&mut job, planes);
            let sorted = self.sort(&mut job, turn, hidden)?;
            let mut run = Run::open(self.backend, &job)?;
            let mut part = |share: f32| progress((index as f32 + share) / runs);
            run.spans(&job, &sorted, self.receivers, &mut part)?;
            planes = Some(run.read(hidden)?);
            run.end(work);
        }
        self.finish(last, planes, work, &mut |share| progress((runs - 1.0 + share) / runs))
    }

    /// The last turn, what crosses the receivers' plane, and the counts.
    fn finish(
        &self,
        turn: Option<&Turn>,
        planes: Option<Vec<u8>>,
        work: &mut Work,
        progress: &mut dyn FnMut(f32),
    ) -> Result<(Vec<u8>, Vec<u32>)> {
        let mut job = Job::new();
        let hidden = self.masks(&mut job, planes);
        let sorted = turn.map(|turn| self.sort(&mut job, turn, hidden)).transpose()?;
        let mut tail = after(&job);
        let visible = self.count(&mut tail, hidden, work)?;
        let mut run = Run::open(self.backend, &tail)?;
        match sorted {
            Some(sorted) => run.spans(&job, &sorted, self.receivers, &mut |share| progress(0.9 * share))?,
            None => run.submit(&job, &mut |_| ())?,
        }
        run.submit(&tail, &mut |share| progress(0.9 + 0.1 * share))?;
        let read = (run.read(hidden)?, words_of(&run.read(visible)?));
        run.end(work);
        Ok(read)
    }

    /// The masks of the band: as they stand, or nothing hidden yet.
    fn masks(&self, job: &mut Job, planes: Option<Vec<u8>>) -> Buffer<[u32]> {
        match planes {
            Some(planes) => job.slice("hidden", &words_of(&planes)),
            None => job.zeroed("hidden", u64::from(self.receivers.count()) * u64::from(self.scene.samples.words())),
        }
    }

    /// The triangles between in turns, and their pairs.
    fn turns(&self, words: u64, work: &mut Work) -> Result<Vec<Turn>> {
        let mut turns = Vec::new();
        let mut first = 0;
        for triangles in self.scene.between.chunks(MOST_TRIANGLES) {
            turns.extend(self.measured(first, triangles, words, work)?);
            first += triangles.len();
        }
        Ok(turns)
    }

    /// One turn for all of some triangles, if their lists fit; none if these are empty.
    fn measured(&self, first: usize, triangles: &[Triangle], words: u64, work: &mut Work) -> Result<Vec<Turn>> {
        let mut job = Job::new();
        let [_, regions] = self.regions(&mut job, triangles)?;
        let tallies = TileLists::new()?.record_tally(&mut job, self.grid(TILE_ROWS), regions)?;
        let mut run = Run::open(self.backend, &job)?;
        run.submit(&job, &mut |_| ())?;
        let tally: Tally = Tally::blocks(&words_of(&run.read(tallies)?)).sum();
        work.pairs += tally.pairs;
        let rows = tile_rows(&tally);
        let grid = self.grid(rows);
        let entries = tally.entries[(rows / TILE_ROWS).ilog2() as usize];
        let fits = |triangles: u64, entries: u64| entries + grid.words(triangles) <= words;
        let whole = Batch { triangles: 0..triangles.len(), entries };
        let found = if fits(triangles.len() as u64, entries) {
            vec![whole]
        } else {
            let regions: Vec<i32> = words_of(&run.read(regions)?).into_iter().map(|word| word as i32).collect();
            batches(grid.size, regions.as_chunks().0, fits)
        };
        run.end(work);
        let turn = |Batch { triangles: Range { start, end }, entries }| Turn {
            triangles: first + start..first + end,
            entries,
            grid,
        };
        Ok(found.into_iter().filter(|batch| batch.entries > 0).map(turn).collect())
    }

    fn grid(&self, rows: u32) -> Grid {
        Grid { size: [WIDTH, rows], receivers: [self.receivers.columns, self.receivers.rows] }
    }

    /// Records the influence regions of triangles.
    fn regions(&self, job: &mut Job, triangles: &[Triangle]) -> Result<[Buffer<[i32]>; 2]> {
        let vertices = job.slice("vertices between", triangles.as_flattened().as_flattened());
        let regions = job.zeroed("regions", 4 * triangles.len() as u64);
        InfluenceRegion::with_faces(self.scene.faces)?.record(
            job,
            &self.scene.samples,
            self.receivers,
            vertices,
            regions,
        )?;
        Ok([vertices, regions])
    }

    /// Records the lists of a turn, and makes room for the spans.
    fn sort(&self, job: &mut Job, turn: &Turn, hidden: Buffer<[u32]>) -> Result<Sorted> {
        let Turn { triangles, entries, grid } = turn;
        let [vertices, regions] = self.regions(job, &self.scene.between[triangles.clone()])?;
        let entries = job.zeroed("tile entries", *entries);
        let starts = TileLists::new()?.record(job, *grid, regions, entries)?;
        let kernel = RowSpan::with_faces(&self.scene.samples, self.scene.faces)?;
        let room = kernel.room(job);
        Ok(Sorted { kernel, grid: *grid, scene: Scene { vertices, starts, entries, hidden }, room })
    }

    /// Records what triangles across the receivers' plane hide, and the samples that are left.
    fn count(&self, job: &mut Job, hidden: Buffer<[u32]>, work: &mut Work) -> Result<Buffer<[u32]>> {
        let Snapped { samples, crossing, .. } = self.scene;
        if !crossing.is_empty() {
            let vertices = job.slice("vertices crossing", crossing.as_flattened().as_flattened());
            let all = 0..crossing.len() as u32;
            HalfPlanes::with_faces(samples, self.scene.faces)?.record(job, self.receivers, vertices, all, hidden)?;
            work.pairs += u64::from(self.receivers.count()) * crossing.len() as u64;
        }
        let shape = Shape { receivers: self.receivers.count(), samples: samples.count(), bits: 32 };
        let [hidden_counts, visible] =
            ["hidden counts", "visible counts"].map(|name| job.zeroed(name, shape.receivers.into()));
        Popcount::new()?.record(job, Method::Builtin, shape, hidden, hidden_counts, visible)?;
        Ok(visible)
    }
}

/// Rows of a tile: a quarter of what the triangles' regions have in the mean, so that lists are short and few receivers
/// are looked at in vain.
fn tile_rows(tally: &Tally) -> u32 {
    let mean = tally.rows.checked_div(tally.triangles).unwrap_or(0);
    ((mean / 4).next_power_of_two() as u32).clamp(TILE_ROWS, 8 * TILE_ROWS)
}

/// The tables of a job, without its recordings: what else is recorded fits the same session.
fn after(job: &Job) -> Job {
    Job { programs: job.programs.clone(), buffers: job.buffers.clone(), ..Job::default() }
}

/// A session and the tables that it was opened for.
struct Run<'a> {
    session: Box<dyn Session + 'a>,
    table: Job,
}

impl<'a> Run<'a> {
    fn open(backend: &'a dyn Backend, job: &Job) -> Result<Self> {
        check::job(job)?;
        Ok(Run { session: backend.open(&job.programs, &job.buffers)?, table: after(job) })
    }

    fn submit(&mut self, job: &Job, progress: &mut dyn FnMut(f32)) -> Result<()> {
        for (index, recording) in job.recordings.iter().enumerate() {
            self.session.submit(recording)?;
            progress(index as f32 / job.recordings.len() as f32);
        }
        Ok(())
    }

    /// Sorts a turn's lists, then adds what its triangles hide.
    fn spans(
        &mut self,
        sort: &Job,
        sorted: &Sorted,
        receivers: &Receivers,
        progress: &mut dyn FnMut(f32),
    ) -> Result<()> {
        self.submit(sort, &mut |_| ())?;
        let Sorted { kernel, grid, scene, room } = sorted;
        let starts = words_of(&self.read(scene.starts)?);
        let tiles = Tiles { size: grid.size, count: grid.tiles(), starts, entries: Vec::new() };
        let mut job = after(&self.table);
        kernel.launch(&mut job, receivers, &tiles, *scene, *room)?;
        self.submit(&job, progress)
    }

    /// The bytes of a buffer.
    fn read<T: Host>(&mut self, buffer: Buffer<[T]>) -> Result<Vec<u8>> {
        let slot = buffer.slot(0, 0);
        let read = Read { name: String::new(), buffer: slot.buffer, offset: slot.offset, size: slot.size };
        Ok(self.session.read(&read)?)
    }

    /// Adds what it took.
    fn end(self, work: &mut Work) {
        let bytes = self.table.buffers.iter().map(|buffer| buffer.size).sum();
        *work += Work { bytes, lane_ops: self.session.lane_ops(), counts: self.session.counts(), ..Work::default() };
    }
}

/// Runs a job, adds its costs to `work` and gives the words of its `N` reads.
pub(crate) fn run<const N: usize>(
    backend: &dyn Backend,
    job: &Job,
    work: &mut Work,
    progress: &mut dyn FnMut(f32),
) -> Result<[Vec<u32>; N]> {
    let mut run = Run::open(backend, job)?;
    run.submit(job, progress)?;
    let mut outputs: [Vec<u32>; N] = std::array::from_fn(|_| Vec::new());
    for (output, read) in outputs.iter_mut().zip(&job.reads) {
        *output = words_of(&run.session.read(read)?);
    }
    run.end(work);
    Ok(outputs)
}

/// Words from the bytes that a session gives.
fn words_of(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_of_a_receiver_come_together() {
        // Three words a receiver, 37 receivers: word w of receiver r is 100 w + r.
        let planes: Vec<u8> =
            (0..3).flat_map(|w| (0..37).flat_map(move |r: u32| (100 * w + r).to_le_bytes())).collect();
        let mut masks = vec![0; 3 * 37];
        interleave(&planes, 3, &mut masks);
        assert!(masks.chunks(3).zip(0..).all(|(set, r)| set == [r, 100 + r, 200 + r]));
    }
}

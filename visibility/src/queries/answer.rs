//! Running a query to its end and reading it back, with what it cost.

use std::ops::AddAssign;

use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job, Session};

use super::{Counts, Drawn, Item, Method, Queries, Stage};
use crate::error::Result;

/// Work of some recordings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spent {
    /// Dispatches.
    pub dispatches: usize,
    /// Lane-operations, from the interpreter.
    pub lane_ops: Option<u64>,
    /// Semantic costs, from machines that are told to count them.
    pub counts: Option<sightlines_backend::Counts>,
}

impl AddAssign for Spent {
    /// What one of the two did not count stays uncounted.
    fn add_assign(&mut self, more: Spent) {
        self.dispatches += more.dispatches;
        self.lane_ops = self.lane_ops.zip(more.lane_ops).map(|(sum, more)| sum + more);
        self.counts = self.counts.zip(more.counts).map(|(mut sum, more)| {
            sum += more;
            sum
        });
    }
}

/// What a query cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Drawing the stage.
    pub draw: Spent,
    /// Counting its pixels.
    pub count: Spent,
    /// Bytes of all buffers on the device.
    pub bytes: u64,
}

/// Counts on the host.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// How pixels were counted.
    pub method: Method,
    /// The items, by number.
    pub items: Vec<Item>,
    /// Pixels of each item in the picture.
    pub totals: Vec<u32>,
    /// Logarithm of the tiles a side.
    pub depth: u32,
    /// Pixels of each item in each tile, item after item, rows of tiles from the top.
    pub tiles: Vec<u32>,
    /// Item of every pixel, row after row, or [`sightlines_kernels::raster::NOTHING`].
    pub shown: Vec<u32>,
    /// Depth of every pixel, or [`sightlines_kernels::raster::FAR`].
    pub depths: Vec<u32>,
    /// What it cost.
    pub cost: Cost,
}

impl Answer {
    /// Tiles of one item, rows from the top.
    pub fn tiles_of(&self, item: usize) -> &[u32] {
        let each = 1 << (2 * self.depth);
        &self.tiles[item * each..(item + 1) * each]
    }

    /// Items of which at least one pixel was counted.
    pub fn visible(&self) -> usize {
        self.totals.iter().filter(|pixels| **pixels > 0).count()
    }
}

/// Draws a stage and counts its items by `method` in the picture and in 2^depth by 2^depth tiles; `progress` is called
/// with the share of the work that is done, from 0 to 1.
///
/// # Errors
///
/// Those of [`Queries::record`], and whatever the backend refuses.
pub fn query(
    backend: &dyn Backend,
    stage: &Stage,
    method: Method,
    depth: u32,
    progress: &mut dyn FnMut(f32),
) -> Result<Answer> {
    let queries = Queries::new()?;
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job)?;
    job.cut();
    let boundary = job.recordings.len() - 1;
    let counts = queries.record(&mut job, stage, &drawn, method, depth)?;
    let mut run = Run::open(backend, &job)?;
    let all = job.recordings.len() as f32;
    let draw = run.submit(&job, 0..boundary, &mut |done| progress(done as f32 / all))?;
    let count = run.submit(&job, boundary..job.recordings.len(), &mut |done| progress(done as f32 / all))?;
    let bytes = job.buffers.iter().map(|buffer| buffer.size).sum();
    run.answer(stage, &drawn, &counts, method, Cost { draw, count, bytes })
}

/// A picture of a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Painted {
    /// Depth of every pixel.
    pub depths: Vec<u32>,
    /// The instance that every pixel shows, by its place in the world.
    pub instances: Vec<Option<usize>>,
    /// What it took.
    pub draw: Spent,
}

/// Draws a stage and reads its picture.
///
/// # Errors
///
/// Whatever the backend refuses.
pub fn draw(backend: &dyn Backend, stage: &Stage) -> Result<Painted> {
    let mut job = Job::new();
    let drawn = stage.record(&Queries::new()?.raster, &mut job)?;
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, 0..job.recordings.len(), &mut |_| ())?;
    let instance = |word: u32| stage.items.get(drawn.item(word) as usize).map(|item| item.instance);
    let instances = run.read(drawn.words)?.into_iter().map(instance).collect();
    Ok(Painted { depths: run.read(drawn.depth)?, instances, draw })
}

/// A job on a machine, submitted in parts.
pub(super) struct Run<'a> {
    session: Box<dyn Session + 'a>,
}

impl<'a> Run<'a> {
    pub(super) fn open(backend: &'a dyn Backend, job: &Job) -> Result<Self> {
        sightlines_backend::check::job(job)?;
        Ok(Run { session: backend.open(&job.programs, &job.buffers)? })
    }

    /// Submits some of the job's recordings, and tells what they took.
    pub(super) fn submit(
        &mut self,
        job: &Job,
        recordings: std::ops::Range<usize>,
        progress: &mut dyn FnMut(usize),
    ) -> Result<Spent> {
        let (ops, before) = (self.session.lane_ops(), self.session.counts());
        let mut dispatches = 0;
        for number in recordings {
            let recording = &job.recordings[number];
            self.session.submit(recording)?;
            dispatches +=
                recording.commands.iter().filter(|c| matches!(c, sightlines_backend::Command::Dispatch(_))).count();
            progress(number + 1);
        }
        let lane_ops = self.session.lane_ops().zip(ops).map(|(after, before)| after - before);
        let counts = self.session.counts().zip(before).map(|(after, before)| difference(after, before));
        Ok(Spent { dispatches, lane_ops, counts })
    }

    /// The words of a buffer.
    pub(super) fn read(&mut self, buffer: Buffer<[u32]>) -> Result<Vec<u32>> {
        let slot = buffer.slot(0, 0);
        let (buffer, offset, size) = (slot.buffer, slot.offset, slot.size);
        let bytes = self.session.read(&sightlines_backend::Read { name: String::new(), buffer, offset, size })?;
        Ok(bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect())
    }

    /// The picture of a stage in buffers of depths and of item numbers.
    pub(super) fn painted(
        &mut self,
        stage: &Stage,
        [depth, items]: [Buffer<[u32]>; 2],
        draw: Spent,
    ) -> Result<Painted> {
        let instance = |item: u32| stage.items.get(item as usize).map(|item| item.instance);
        let instances = self.read(items)?.into_iter().map(instance).collect();
        Ok(Painted { depths: self.read(depth)?, instances, draw })
    }

    /// What was counted.
    pub(super) fn answer(
        mut self,
        stage: &Stage,
        drawn: &Drawn,
        counts: &Counts,
        method: Method,
        cost: Cost,
    ) -> Result<Answer> {
        let items = stage.items.len();
        let mut totals = self.read(counts.totals)?;
        totals.truncate(items);
        let words = self.read(counts.tiles)?;
        let each = 1_usize << (2 * counts.depth);
        let at = |item: usize, tile: usize| item * counts.item_step as usize + tile * counts.tile_step as usize;
        let tiles = (0..items).flat_map(|item| (0..each).map(move |tile| at(item, tile))).map(|at| words[at]).collect();
        let shown = self.read(drawn.words)?.into_iter().map(|word| drawn.item(word)).collect();
        let depths = self.read(drawn.depth)?;
        let (items, depth) = (stage.items.clone(), counts.depth);
        Ok(Answer { method, items, totals, depth, tiles, shown, depths, cost })
    }
}

impl Drawn {
    /// The number of the item that a pixel's word names, or [`sightlines_kernels::raster::NOTHING`].
    pub fn item(&self, word: u32) -> u32 {
        let first = self.firsts.get((word >> 16) as usize);
        first.map_or(sightlines_kernels::raster::NOTHING, |first| first + (word & 0xFFFF))
    }
}

fn difference(after: sightlines_backend::Counts, before: sightlines_backend::Counts) -> sightlines_backend::Counts {
    sightlines_backend::Counts {
        invocations: after.invocations - before.invocations,
        loads: after.loads - before.loads,
        stores: after.stores - before.stores,
        bytes: after.bytes - before.bytes,
        atomics: after.atomics - before.atomics,
        barriers: after.barriers - before.barriers,
        turns: after.turns,
    }
}

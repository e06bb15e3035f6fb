//! Execution: a dispatch cut into gangs, gangs spread over threads.
//!
//! A gang is one workgroup, or several neighbours along x when a kernel has no barrier and no workgroup memory. Results
//! do not depend on how many threads there are: gangs share only buffers, which WGSL lets them race on only through
//! atomics, and of several traps the one of the first gang is reported.

mod access;
mod alu;
mod atomic;
mod compare;
mod control;
mod fused;
mod gang;
mod lanes;
mod mask;
mod memory;
mod record;
mod rows;
#[cfg(test)]
mod tests;

use std::cell::Cell;
use std::sync::atomic::AtomicU32;

use fearless_simd::{Level, Simd, dispatch};
use rayon::prelude::*;
use sightlines_backend::{Counts, Program, Trap, TrapKind};
use zerocopy::{FromBytes, IntoBytes};

use crate::code::Code;
use crate::lower::Builtin;
use gang::{Launch, Stop, Tally, View, Worker};
pub(crate) use mask::{CHUNK, MAX_LANES};
use memory::SharedWord;

/// Vector registers of a gang should fit in this many bytes. Twice a first-level cache is the least time: what was
/// written last is read next, and a pass over more lanes is the cheaper.
const REGISTER_BYTES: usize = 64 << 10;

/// One bound range of a dispatch: buffer, first word, words, and whether any binding of the dispatch writes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Range {
    pub(crate) buffer: usize,
    pub(crate) start: usize,
    pub(crate) words: usize,
    pub(crate) write: bool,
}

/// How a dispatch runs.
pub(crate) struct Settings<'a> {
    pub(crate) level: Level,
    pub(crate) pool: Option<&'a rayon::ThreadPool>,
    pub(crate) trap: bool,
    pub(crate) fuel: u64,
    /// Lanes of a merged gang; `None` lets the register count decide.
    pub(crate) lanes: Option<u32>,
    /// Bytes that are allocated already, and bytes that may be.
    pub(crate) allocated: u64,
    pub(crate) memory: u64,
}

/// Runs a dispatch on buffers of words: its semantic costs, and its lane-operations.
pub(crate) fn run(
    code: &Code,
    program: &Program,
    buffers: &mut [Vec<u32>],
    ranges: &[Range],
    groups: [u32; 3],
    settings: &Settings<'_>,
) -> Result<(Counts, u64), Trap> {
    if groups.contains(&0) {
        return Ok((Counts::default(), 0));
    }
    let grid = Grid::new(code, groups, settings);
    let workers = settings.pool.map_or(1, |pool| grid.gangs().min(pool.current_num_threads() as u64));
    let wanted = settings.allocated.saturating_add(workers * Worker::bytes(code, grid.lanes));
    if wanted > settings.memory {
        let kind = TrapKind::OutOfMemory { wanted, limit: settings.memory };
        return Err(Trap { kind, location: None, invocation: None });
    }
    let work = match settings.pool {
        Some(pool) if grid.gangs() > 1 => {
            let views = views(buffers, ranges, |words| {
                <[AtomicU32]>::mut_from_bytes(words.as_mut_bytes()).map_or(&[][..], |words| &*words)
            });
            let launch = grid.launch(code, views, settings);
            pool.install(|| grid.parallel(&launch, settings.level))
        }
        _ => {
            let views = views(buffers, ranges, |words| Cell::from_mut(words).as_slice_of_cells());
            let launch = grid.launch(code, views, settings);
            grid.sequential(&launch, settings.level)
        }
    };
    match work {
        Ok(work) => Ok((counts(code, groups, &work), work.chunk_ops * CHUNK as u64)),
        Err((stop, first)) => Err(grid.trap(code, program, stop, first, settings.fuel)),
    }
}

/// Views of the bound ranges; a buffer that any binding writes is shared as words of type `W`. The work is that of the
/// bound buffers, however many others a session has.
fn views<'a, W>(
    mut buffers: &'a mut [Vec<u32>],
    ranges: &[Range],
    share: impl Fn(&'a mut [u32]) -> &'a [W],
) -> Vec<View<'a, W>> {
    let mut bound: Vec<usize> = ranges.iter().map(|range| range.buffer).collect();
    bound.sort_unstable();
    bound.dedup();
    let mut whole = Vec::with_capacity(bound.len());
    let mut next = 0;
    for &index in &bound {
        let rest = std::mem::take(&mut buffers).split_at_mut(index - next).1;
        let Some((words, rest)) = rest.split_first_mut() else { break };
        let written = ranges.iter().any(|range| range.buffer == index && range.write);
        whole.push(if written { View::Write(share(words)) } else { View::Read(words) });
        (buffers, next) = (rest, index + 1);
    }
    let cut = |range: &Range| match whole[bound.partition_point(|index| *index < range.buffer)] {
        View::Read(words) => View::Read(&words[range.start..range.start + range.words]),
        View::Write(words) => View::Write(&words[range.start..range.start + range.words]),
    };
    ranges.iter().map(cut).collect()
}

struct Grid {
    groups: [u32; 3],
    size: [u32; 3],
    merged: u32,
    lanes: usize,
    /// Gangs along x.
    columns: u64,
}

/// What gangs did.
struct Work {
    tallies: Vec<Tally>,
    chunk_ops: u64,
    /// Most turns of loops of one invocation.
    longest: u32,
}

impl Work {
    fn of(worker: Worker) -> Self {
        Work { tallies: worker.tallies, chunk_ops: worker.chunk_ops, longest: worker.longest }
    }

    fn plus(&self, other: &Self) -> Self {
        let tallies = self.tallies.iter().zip(&other.tallies).map(|(a, b)| a.plus(*b)).collect();
        Work { tallies, chunk_ops: self.chunk_ops + other.chunk_ops, longest: self.longest.max(other.longest) }
    }
}

type Stopped = (Stop, [u32; 3]);

impl Grid {
    fn new(code: &Code, groups: [u32; 3], settings: &Settings<'_>) -> Self {
        let size = code.workgroup_size;
        let lanes: u32 = size.iter().product();
        let fitting = (REGISTER_BYTES / 4 / code.vectors.max(1)).clamp(64, MAX_LANES) as u32;
        let wanted = settings.lanes.unwrap_or(fitting).clamp(1, MAX_LANES as u32);
        let merged = if code.mergeable { (wanted / lanes).clamp(1, groups[0]) } else { 1 };
        let lanes = ((merged * lanes) as usize).next_multiple_of(CHUNK);
        Grid { groups, size, merged, lanes, columns: u64::from(groups[0].div_ceil(merged)) }
    }

    fn gangs(&self) -> u64 {
        self.columns * u64::from(self.groups[1]) * u64::from(self.groups[2])
    }

    /// First workgroup of a gang.
    fn first(&self, gang: u64) -> [u32; 3] {
        let row = gang / self.columns;
        let height = u64::from(self.groups[1]);
        [(gang % self.columns) as u32 * self.merged, (row % height) as u32, (row / height) as u32]
    }

    fn launch<'a, W>(&self, code: &'a Code, views: Vec<View<'a, W>>, settings: &Settings<'_>) -> Launch<'a, W> {
        let tables = code.inputs.iter().map(|input| self.table(input.builtin)).collect();
        Launch {
            code,
            views,
            groups: self.groups,
            merged: self.merged,
            lanes: self.lanes,
            trap: settings.trap,
            fuel: settings.fuel,
            tables,
        }
    }

    /// The part of an input that depends on the lane only.
    fn table(&self, builtin: Builtin) -> Vec<u32> {
        let size: u32 = self.size.iter().product();
        let word = |lane: u32| {
            let (group, local) = (lane / size, lane % size);
            let id = self.local(local);
            match builtin {
                Builtin::LocalId(axis) => id[axis as usize],
                Builtin::GlobalId(0) => group * self.size[0] + id[0],
                Builtin::GlobalId(axis) => id[axis as usize],
                Builtin::GroupId(0) => group,
                Builtin::GroupId(_) | Builtin::NumGroups(_) => 0,
                Builtin::LocalIndex => local,
            }
        };
        (0..self.lanes as u32).map(word).collect()
    }

    fn local(&self, index: u32) -> [u32; 3] {
        let [x, y, _] = self.size;
        [index % x, index / x % y, index / (x * y)]
    }

    fn sequential<W: SharedWord>(&self, launch: &Launch<'_, W>, level: Level) -> Result<Work, Stopped> {
        let mut worker = Worker::new(launch.code, launch.lanes);
        dispatch!(level, simd => self.all(simd, &mut worker, launch))?;
        Ok(Work::of(worker))
    }

    #[inline(always)]
    fn all<S: Simd, W: SharedWord>(&self, simd: S, worker: &mut Worker, launch: &Launch<'_, W>) -> Result<(), Stopped> {
        for gang in 0..self.gangs() {
            let first = self.first(gang);
            worker.run(simd, launch, first).map_err(|stop| (stop, first))?;
        }
        Ok(())
    }

    fn parallel(&self, launch: &Launch<'_, AtomicU32>, level: Level) -> Result<Work, Stopped> {
        let batch = (self.gangs() / (rayon::current_num_threads() as u64 * 16)).clamp(1, 1024);
        let batches = self.gangs().div_ceil(batch);
        let run = |index: u64| {
            let mut worker = Worker::new(launch.code, launch.lanes);
            for gang in index * batch..((index + 1) * batch).min(self.gangs()) {
                let first = self.first(gang);
                let result = dispatch!(level, simd => worker.run(simd, launch, first));
                result.map_err(|stop| (index, (stop, first)))?;
            }
            Ok(Work::of(worker))
        };
        let merge = |a: Result<Work, (u64, Stopped)>, b: Result<Work, (u64, Stopped)>| match (a, b) {
            (Ok(a), Ok(b)) => Ok(a.plus(&b)),
            (Err(a), Err(b)) => Err(if a.0 <= b.0 { a } else { b }),
            (Err(e), Ok(_)) | (Ok(_), Err(e)) => Err(e),
        };
        let none = || Ok(Work { tallies: vec![Tally::default(); launch.code.costs.len()], chunk_ops: 0, longest: 0 });
        (0..batches).into_par_iter().map(run).reduce(none, merge).map_err(|(_, stopped)| stopped)
    }

    fn trap(&self, code: &Code, program: &Program, stop: Stop, first: [u32; 3], limit: u64) -> Trap {
        let (kind, site, lane) = match stop {
            Stop::Outside { at, site } => {
                (TrapKind::OutOfBounds { index: at.index, length: at.length }, Some(site), Some(at.lane))
            }
            Stop::OutOfFuel { site } => (TrapKind::OutOfFuel { limit }, Some(site), None),
            Stop::Barrier { site } => (TrapKind::NonUniformBarrier, Some(site), None),
        };
        let invocation = lane.map(|lane| {
            let size: u32 = self.size.iter().product();
            let id = self.local(lane as u32 % size);
            let group = [first[0] + lane as u32 / size, first[1], first[2]];
            std::array::from_fn(|axis| group[axis].wrapping_mul(self.size[axis]).wrapping_add(id[axis]))
        });
        let location = site.and_then(|site| program.locate(code.sites[site as usize]));
        Trap { kind, location, invocation }
    }
}

fn counts(code: &Code, groups: [u32; 3], work: &Work) -> Counts {
    let workgroups: u64 = groups.iter().map(|g| u64::from(*g)).product();
    let size: u64 = code.workgroup_size.iter().map(|s| u64::from(*s)).product();
    let (invocations, turns) = (workgroups * size, u64::from(work.longest));
    let mut total = Counts { invocations, turns, ..Counts::default() };
    for (cost, tally) in code.costs.iter().zip(&work.tallies) {
        total.loads += u64::from(cost.loads) * tally.invocations;
        total.stores += u64::from(cost.stores) * tally.invocations;
        total.bytes += u64::from(cost.bytes) * tally.invocations;
        total.atomics += u64::from(cost.atomics) * tally.invocations;
        // A barrier counts once a workgroup, all else once an invocation.
        total.barriers += u64::from(cost.barriers) * tally.workgroups;
    }
    total
}

//! Words of memory, loads and stores: buffers, workgroup memory, private memory.
//!
//! Every access is in range or handled: clamped to the last word, as naga's `Restrict` policy does, or reported, when
//! the run traps. One worker uses plain cells, several use relaxed atomics on the same words.

use std::cell::Cell;
use std::sync::atomic::{AtomicU32, Ordering};

use fearless_simd::Simd;

use super::alu;
use super::mask::{CHUNK, Exec};
use super::rows::{Chunk, Rows};
use crate::code::{AtomicOp, Reg};
use crate::semantics;

/// A word of memory that can be read.
pub(crate) trait Word {
    fn load(&self) -> u32;
}

/// A word of memory that can be written.
pub(crate) trait SharedWord: Word {
    fn store(&self, word: u32);

    /// Applies an operation; the old value.
    fn update(&self, op: AtomicOp, value: u32) -> u32;

    /// Stores `value` if the word is `compare`; the old value.
    fn compare_exchange(&self, compare: u32, value: u32) -> u32;
}

impl Word for u32 {
    #[inline(always)]
    fn load(&self) -> u32 {
        *self
    }
}

impl Word for Cell<u32> {
    #[inline(always)]
    fn load(&self) -> u32 {
        self.get()
    }
}

impl SharedWord for Cell<u32> {
    #[inline(always)]
    fn store(&self, word: u32) {
        self.set(word);
    }

    #[inline(always)]
    fn update(&self, op: AtomicOp, value: u32) -> u32 {
        let old = self.get();
        self.set(semantics::atomic(op, old, value));
        old
    }

    fn compare_exchange(&self, compare: u32, value: u32) -> u32 {
        let old = self.get();
        if old == compare {
            self.set(value);
        }
        old
    }
}

impl Word for AtomicU32 {
    #[inline(always)]
    fn load(&self) -> u32 {
        self.load(Ordering::Relaxed)
    }
}

impl SharedWord for AtomicU32 {
    #[inline(always)]
    fn store(&self, word: u32) {
        self.store(word, Ordering::Relaxed);
    }

    #[inline(always)]
    fn update(&self, op: AtomicOp, value: u32) -> u32 {
        match op {
            AtomicOp::Add => self.fetch_add(value, Ordering::Relaxed),
            AtomicOp::Sub => self.fetch_sub(value, Ordering::Relaxed),
            AtomicOp::And => self.fetch_and(value, Ordering::Relaxed),
            AtomicOp::Or => self.fetch_or(value, Ordering::Relaxed),
            AtomicOp::Xor => self.fetch_xor(value, Ordering::Relaxed),
            AtomicOp::MinU => self.fetch_min(value, Ordering::Relaxed),
            AtomicOp::MaxU => self.fetch_max(value, Ordering::Relaxed),
            AtomicOp::Exchange => self.swap(value, Ordering::Relaxed),
            AtomicOp::MinI | AtomicOp::MaxI | AtomicOp::CompareExchange => {
                let change = |old| Some(semantics::atomic(op, old, value));
                self.fetch_update(Ordering::Relaxed, Ordering::Relaxed, change).unwrap_or_else(|old| old)
            }
        }
    }

    fn compare_exchange(&self, compare: u32, value: u32) -> u32 {
        self.compare_exchange(compare, value, Ordering::Relaxed, Ordering::Relaxed).unwrap_or_else(|old| old)
    }
}

/// An access past the end: the lane, its index and the length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Outside {
    pub(super) lane: usize,
    pub(super) index: u32,
    pub(super) length: u32,
}

/// Reads one word, the last one where the index is past the end.
pub(super) fn read<T: Word>(words: &[T], index: u32) -> u32 {
    words.get(index as usize).or(words.last()).map_or(0, Word::load)
}

/// Loads one word a lane.
pub(super) fn load<S: Simd, T: Word>(
    s: S,
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    dst: Reg,
    addr: Reg,
    offset: u32,
) -> Option<Outside> {
    let row = r.row(dst);
    let (base, inside) = alu::survey(s, &r, addr, offset, words.len());
    if let Some(base) = base {
        let start = base.wrapping_add(offset) as usize;
        if let Some(run) = words.get(start..).and_then(|w| w.get(..row.len() * CHUNK)) {
            for (cell, run) in row.iter().zip(run.chunks_exact(CHUNK)) {
                cell.set(Chunk(std::array::from_fn(|i| run[i].load())));
            }
            return None;
        }
    }
    if !inside {
        return load_clamped(r, exec, words, dst, addr, offset);
    }
    for (cell, addr) in row.iter().zip(r.row(addr)) {
        let addr = addr.get().0;
        let word = |lane: usize| words.get(addr[lane].wrapping_add(offset) as usize).map_or(0, Word::load);
        cell.set(Chunk(std::array::from_fn(word)));
    }
    None
}

/// Loads where some address is past the end; the first one of an active lane.
#[cold]
fn load_clamped<T: Word>(r: Rows<'_>, exec: &Exec, words: &[T], dst: Reg, addr: Reg, offset: u32) -> Option<Outside> {
    let mut outside = None;
    for (i, (cell, addr)) in r.row(dst).iter().zip(r.row(addr)).enumerate() {
        let addr = addr.get().0;
        let words = std::array::from_fn(|lane| {
            let index = addr[lane].wrapping_add(offset);
            let lane = (exec.low + i) * CHUNK + lane;
            if index as usize >= words.len() && outside.is_none() && exec.mask.has(lane) {
                outside = Some(Outside { lane, index, length: words.len() as u32 });
            }
            read(words, index)
        });
        cell.set(Chunk(words));
    }
    outside
}

/// Stores the word of each active lane, in the order of lanes.
pub(super) fn store<S: Simd, T: SharedWord>(
    s: S,
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    addr: Reg,
    value: Reg,
    offset: u32,
) -> Option<Outside> {
    if addr.is_scalar() {
        let lane = exec.mask.last_lane()?;
        return store_lane(words, r.scalar(addr).wrapping_add(offset), r.lane(value, lane), lane);
    }
    let (base, inside) = alu::survey(s, &r, addr, offset, words.len());
    if exec.full
        && let Some(base) = base
    {
        let count = exec.mask.count() as usize;
        let start = base.wrapping_add(offset) as usize;
        if let Some(run) = words.get(start..).and_then(|w| w.get(..count)) {
            s.vectorize(
                #[inline(always)]
                || store_run(r, run, value),
            );
            return None;
        }
    }
    let mut outside = None;
    for (i, addr) in r.row(addr).iter().enumerate() {
        let bits = exec.mask.chunk(exec.low + i);
        if bits == 0 {
            continue;
        }
        let mut places = addr.get().0;
        places.iter_mut().for_each(|place| *place = place.wrapping_add(offset));
        let values = r.chunk(value, exec.low + i);
        if inside {
            store_chunk(words, places, values, bits);
            continue;
        }
        for lane in (0..CHUNK).filter(|lane| bits >> lane & 1 != 0) {
            let place = (exec.low + i) * CHUNK + lane;
            let wrong = store_lane(words, places[lane], values[lane], place);
            outside = outside.or(wrong);
        }
    }
    outside
}

/// Stores the words of a chunk whose places all exist.
#[inline(always)]
fn store_chunk<T: SharedWord>(words: &[T], places: [u32; CHUNK], values: [u32; CHUNK], mut bits: u16) {
    if bits == u16::MAX {
        for (place, value) in places.into_iter().zip(values) {
            if let Some(word) = words.get(place as usize) {
                word.store(value);
            }
        }
        return;
    }
    while bits != 0 {
        let lane = bits.trailing_zeros() as usize % CHUNK;
        bits &= bits - 1;
        if let Some(word) = words.get(places[lane] as usize) {
            word.store(values[lane]);
        }
    }
}

#[inline(always)]
fn store_run<T: SharedWord>(r: Rows<'_>, run: &[T], value: Reg) {
    if value.is_scalar() {
        let word = r.scalar(value);
        run.iter().for_each(|to| to.store(word));
        return;
    }
    let full = run.chunks_exact(CHUNK);
    let rest = full.remainder();
    let row = r.row(value);
    for (to, cell) in full.zip(row) {
        let words = cell.get().0;
        for (to, word) in to.iter().zip(words) {
            to.store(word);
        }
    }
    if let (false, Some(cell)) = (rest.is_empty(), row.last()) {
        rest.iter().zip(cell.get().0).for_each(|(to, word)| to.store(word));
    }
}

fn store_lane<T: SharedWord>(words: &[T], index: u32, value: u32, lane: usize) -> Option<Outside> {
    if let Some(word) = words.get(index as usize) {
        word.store(value);
        return None;
    }
    if let Some(last) = words.last() {
        last.store(value);
    }
    Some(Outside { lane, index, length: words.len() as u32 })
}

/// Private memory: word `e` of lane `l` stands at `e * lanes + l`.
#[derive(Clone, Copy)]
pub(super) struct Private<'a> {
    pub(super) words: &'a [Cell<u32>],
    pub(super) lanes: usize,
}

impl Private<'_> {
    /// Loads word `addr + offset` of each lane.
    pub(super) fn load(&self, r: Rows<'_>, dst: Reg, addr: Reg, offset: u32) {
        if addr.is_scalar() {
            return self.load_row(r, dst, r.scalar(addr).wrapping_add(offset));
        }
        for (i, cell) in r.row(dst).iter().enumerate() {
            let first = (r.low + i) * CHUNK;
            let addr = r.row(addr)[i].get().0;
            cell.set(Chunk(std::array::from_fn(|lane| {
                let place = self.place(addr[lane].wrapping_add(offset), first + lane);
                place.map_or(0, Cell::get)
            })));
        }
    }

    /// Loads the same word of each lane: they stand side by side.
    fn load_row(&self, r: Rows<'_>, dst: Reg, word: u32) {
        let row = r.row(dst);
        let first = (word as usize).saturating_mul(self.lanes) + r.low * CHUNK;
        let run = self.words.get(first..).and_then(|words| words.get(..row.len() * CHUNK));
        for (i, cell) in row.iter().enumerate() {
            let chunk = run.and_then(|run| run[i * CHUNK..].first_chunk::<CHUNK>());
            cell.set(Chunk(chunk.map_or([0; CHUNK], |words| words.each_ref().map(Cell::get))));
        }
    }

    /// Stores word `addr + offset` of each active lane.
    pub(super) fn store(&self, r: Rows<'_>, exec: &Exec, addr: Reg, value: Reg, offset: u32) {
        for i in exec.low..exec.high {
            let mut bits = exec.mask.chunk(i);
            while bits != 0 {
                let lane = i * CHUNK + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                if let Some(place) = self.place(r.lane(addr, lane).wrapping_add(offset), lane) {
                    place.set(r.lane(value, lane));
                }
            }
        }
    }

    /// Sets `count` words from `offset` on to zero, for every lane.
    pub(super) fn zero(&self, offset: u32, count: u32) {
        let start = offset as usize * self.lanes;
        if let Some(run) = self.words.get(start..start + count as usize * self.lanes) {
            run.iter().for_each(|word| word.set(0));
        }
    }

    #[inline(always)]
    fn place(&self, word: u32, lane: usize) -> Option<&Cell<u32>> {
        self.words.get(word as usize * self.lanes + lane)
    }
}

//! Loads, stores and atomics: buffers, workgroup memory, private memory.
//!
//! Every access is in range or handled: clamped to the last word, as naga's `Restrict` policy does, or reported, when the
//! run traps. One worker uses plain cells, several use relaxed atomics on the same words.

use std::cell::Cell;
use std::sync::atomic::{AtomicU32, Ordering};

use fearless_simd::prelude::*;
use fearless_simd::{Simd, u32x16};

use super::alu::{self, Chunk, Rows};
use super::mask::{CHUNK, Exec};
use crate::code::{AtomicArgs, AtomicOp, Reg};
use crate::semantics;

/// A word of memory that can be read.
pub(crate) trait Word {
    /// Whether neighbouring words can be read at once.
    const PLAIN: bool = true;

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
    const PLAIN: bool = false;

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
    s.vectorize(
        #[inline(always)]
        || {
            let row = r.row(dst);
            let run = alu::affine(s, r, addr).and_then(|even| Run::new(words, even, offset, row.len() * CHUNK));
            match run {
                Some(run) => run.load(s, row),
                None => return gather(s, r, exec, words, dst, addr, offset),
            }
            None
        },
    )
}

/// Words an even step apart, all in range.
struct Run<'a, T> {
    words: &'a [T],
    step: usize,
}

impl<'a, T: Word> Run<'a, T> {
    #[inline(always)]
    fn new(words: &'a [T], (base, step): (u32, u32), offset: u32, count: usize) -> Option<Self> {
        let last = (step as usize).checked_mul(count.checked_sub(1)?)?;
        let words = words.get(base.wrapping_add(offset) as usize..)?;
        (last < words.len()).then_some(Run { words, step: step as usize })
    }

    #[inline(always)]
    fn load<S: Simd>(&self, s: S, row: &[Cell<Chunk>]) {
        for (i, cell) in row.iter().enumerate() {
            let words = &self.words[i * CHUNK * self.step..];
            let even = || words.chunks(self.step.max(1)).map(|group| group[0].load());
            let chunk = match self.step {
                0 => s.splat_u32x16(words[0].load()),
                1 if words.len() >= CHUNK => vector(s, words),
                2 if T::PLAIN && words.len() >= 2 * CHUNK => {
                    s.unzip_low_u32x16(vector(s, words), vector(s, &words[CHUNK..]))
                }
                4 if T::PLAIN && words.len() >= 4 * CHUNK => {
                    let low = s.unzip_low_u32x16(vector(s, words), vector(s, &words[CHUNK..]));
                    let high = s.unzip_low_u32x16(vector(s, &words[2 * CHUNK..]), vector(s, &words[3 * CHUNK..]));
                    s.unzip_low_u32x16(low, high)
                }
                _ => {
                    let mut chunk = [0; CHUNK];
                    chunk.iter_mut().zip(even()).for_each(|(to, word)| *to = word);
                    u32x16::simd_from(s, chunk)
                }
            };
            alu::store(cell, chunk);
        }
    }
}

/// The first words, one a lane.
#[inline(always)]
fn vector<S: Simd, T: Word>(s: S, words: &[T]) -> u32x16<S> {
    let words = &words[..CHUNK];
    u32x16::simd_from(s, std::array::from_fn(|i| words[i].load()))
}

/// Loads words from anywhere.
#[inline(always)]
fn gather<S: Simd, T: Word>(
    s: S,
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    dst: Reg,
    addr: Reg,
    offset: u32,
) -> Option<Outside> {
    let length = words.len() as u32;
    let last = length.wrapping_sub(1);
    let mut greatest = s.splat_u32x16(0);
    for (cell, addr) in r.row(dst).iter().zip(r.row(addr)) {
        let index = s.add_u32x16(alu::load(s, addr), s.splat_u32x16(offset));
        greatest = s.max_u32x16(greatest, index);
        let index: [u32; CHUNK] = s.min_u32x16(index, s.splat_u32x16(last)).into();
        cell.set(Chunk(index.map(|index| words.get(index as usize).map_or(0, Word::load))));
    }
    let past = s.any_true_mask32x16(s.simd_gt_u32x16(greatest, s.splat_u32x16(last))) || words.is_empty();
    past.then(|| first_outside(r, exec, addr, offset, length)).flatten()
}

/// The first active lane that is past the end.
#[cold]
fn first_outside(r: Rows<'_>, exec: &Exec, addr: Reg, offset: u32, length: u32) -> Option<Outside> {
    let lanes = (exec.low * CHUNK..exec.high * CHUNK).filter(|lane| exec.mask.has(*lane));
    let mut places = lanes.map(|lane| Outside { lane, index: r.lane(addr, lane).wrapping_add(offset), length });
    places.find(|place| place.index >= length)
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
    s.vectorize(
        #[inline(always)]
        || {
            let even = if exec.full { alu::affine(s, r, addr) } else { None };
            let count = exec.mask.count() as usize;
            match even.and_then(|even| Run::new(words, even, offset, count)) {
                Some(run) => run.store(r, count, value),
                None => return scatter(r, exec, words, addr, value, offset),
            }
            None
        },
    )
}

impl<T: SharedWord> Run<'_, T> {
    /// Stores the first `count` lanes of an operand.
    #[inline(always)]
    fn store(&self, r: Rows<'_>, count: usize, value: Reg) {
        let chunks = (0..count.div_ceil(CHUNK)).map(|i| {
            let rest = &self.words[i * CHUNK * self.step..];
            let words = if value.is_scalar() { [r.scalar(value); CHUNK] } else { r.row(value)[i].get().0 };
            (rest, words, (count - i * CHUNK).min(CHUNK))
        });
        for (to, words, lanes) in chunks {
            match self.step {
                0 => to[0].store(words[lanes - 1]),
                1 if lanes == CHUNK => to[..CHUNK].iter().zip(words).for_each(|(to, word)| to.store(word)),
                4 => to.chunks(4).zip(&words[..lanes]).for_each(|(to, word)| to[0].store(*word)),
                step => to.chunks(step).zip(&words[..lanes]).for_each(|(to, word)| to[0].store(*word)),
            }
        }
    }
}

/// Stores words to anywhere.
#[inline(always)]
fn scatter<T: SharedWord>(
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    addr: Reg,
    value: Reg,
    offset: u32,
) -> Option<Outside> {
    let mut outside = None;
    for (i, addr) in r.row(addr).iter().enumerate() {
        let mut bits = exec.mask.chunk(exec.low + i);
        let addr = addr.get().0;
        let values = if value.is_scalar() { [r.scalar(value); CHUNK] } else { r.row(value)[i].get().0 };
        while bits != 0 {
            let lane = bits.trailing_zeros() as usize % CHUNK;
            bits &= bits - 1;
            let place = (exec.low + i) * CHUNK + lane;
            outside = outside.or(store_lane(words, addr[lane].wrapping_add(offset), values[lane], place));
        }
    }
    outside
}

#[inline(always)]
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

/// Applies an atomic operation for each active lane, in the order of lanes.
pub(super) fn atomic<T: SharedWord>(r: Rows<'_>, exec: &Exec, words: &[T], args: &AtomicArgs) -> Option<Outside> {
    let mut outside = None;
    if args.addr.is_scalar() && args.dst.is_none() && args.op != AtomicOp::CompareExchange {
        let index = r.scalar(args.addr).wrapping_add(args.offset);
        let lane = exec.mask.first_lane()?;
        let place = words.get(index as usize).or(words.last());
        if let (Some(place), Some(value)) = (place, combine(r, exec, args)) {
            place.update(args.op, value);
            let inside = (index as usize) < words.len();
            return (!inside).then_some(Outside { lane, index, length: words.len() as u32 });
        }
    }
    for i in exec.low..exec.high {
        let mut bits = exec.mask.chunk(i);
        while bits != 0 {
            let lane = i * CHUNK + bits.trailing_zeros() as usize;
            bits &= bits - 1;
            let index = r.lane(args.addr, lane).wrapping_add(args.offset);
            let place = match words.get(index as usize) {
                Some(place) => Some(place),
                None => {
                    outside = outside.or(Some(Outside { lane, index, length: words.len() as u32 }));
                    words.last()
                }
            };
            let value = r.lane(args.value, lane);
            let old = match (place, args.compare) {
                (Some(place), Some(compare)) => place.compare_exchange(r.lane(compare, lane), value),
                (Some(place), None) => place.update(args.op, value),
                (None, _) => 0,
            };
            if let Some(dst) = args.dst {
                r.set_lane(dst, lane, old);
            }
        }
    }
    outside
}

/// One operand that does to a word what the operands of all active lanes do, in order.
fn combine(r: Rows<'_>, exec: &Exec, args: &AtomicArgs) -> Option<u32> {
    let op = match args.op {
        // A difference of many is the difference of their sum.
        AtomicOp::Sub => AtomicOp::Add,
        AtomicOp::CompareExchange => return None,
        op => op,
    };
    let mut total = None;
    for lane in exec.low * CHUNK..exec.high * CHUNK {
        if exec.mask.has(lane) {
            let value = r.lane(args.value, lane);
            total = Some(total.map_or(value, |sum| semantics::atomic(op, sum, value)));
        }
    }
    total
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
        for (i, cell) in r.row(dst).iter().enumerate() {
            let first = (r.low + i) * CHUNK;
            let addr = if addr.is_scalar() { [r.scalar(addr); CHUNK] } else { r.row(addr)[i].get().0 };
            cell.set(Chunk(std::array::from_fn(|lane| {
                let place = self.place(addr[lane].wrapping_add(offset), first + lane);
                place.map_or(0, Cell::get)
            })));
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

//! Records: four neighbouring words of each lane, loaded or stored at once.
//!
//! Lanes' records lie side by side in memory and their words side by side in registers, so a chunk is transposed on the
//! way. Invariant: memory, results and the access that is reported are those of four accesses, word after word. Records
//! are stored lane after lane only where no two overlap without being the same: the last lane's words stay either way.

use fearless_simd::{Simd, prelude::*, u32x16};

use super::mask::{CHUNK, Exec};
use super::memory::{self, Outside, SharedWord, Word};
use super::rows::{self, Rows};
use crate::code::Reg;

/// Words of a record.
const WORDS: usize = 4;

/// What a row of addresses of records looks like.
struct Survey {
    /// The first one, where each is a record further than the one before.
    base: Option<u32>,
    /// No word of any record is past the end.
    inside: bool,
    /// All are multiples of a record.
    aligned: bool,
}

#[inline(always)]
fn survey<S: Simd>(s: S, r: Rows<'_>, addr: Reg, offset: u32, limit: usize) -> Survey {
    let row = r.row(addr);
    let base = row.first().map_or(0, |chunk| chunk.get().0[0]);
    let Some(last) = u32::try_from(limit).unwrap_or(u32::MAX).checked_sub(WORDS as u32) else {
        return Survey { base: None, inside: false, aligned: false };
    };
    let steps = u32x16::simd_from(s, std::array::from_fn(|i| (WORDS * i) as u32));
    let (offset, zero) = (s.splat_u32x16(offset), s.splat_u32x16(0));
    let (mut difference, mut greatest, mut bits) = (zero, zero, zero);
    let mut expected = s.add_u32x16(s.splat_u32x16(base), steps);
    for cell in row {
        let addr = rows::load(s, cell);
        let place = s.add_u32x16(addr, offset);
        difference = s.or_u32x16(difference, s.xor_u32x16(addr, expected));
        expected = s.add_u32x16(expected, s.splat_u32x16((WORDS * CHUNK) as u32));
        greatest = s.max_u32x16(greatest, place);
        bits = s.or_u32x16(bits, place);
    }
    let none = |words| !s.any_true_mask32x16(s.simd_ne_u32x16(words, zero));
    Survey {
        base: none(difference).then_some(base),
        inside: !s.any_true_mask32x16(s.simd_gt_u32x16(greatest, s.splat_u32x16(last))),
        aligned: none(s.and_u32x16(bits, s.splat_u32x16(WORDS as u32 - 1))),
    }
}

/// Loads a record of each lane; the access past the end and its word, if there is one.
pub(super) fn load<S: Simd, T: Word>(
    s: S,
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    dst: [Reg; WORDS],
    (addr, offset): (Reg, u32),
) -> Option<(Outside, usize)> {
    s.vectorize(
        #[inline(always)]
        || {
            let found = survey(s, r, addr, offset, words.len());
            if !found.inside {
                return load_clamped(r, exec, words, dst, (addr, offset));
            }
            let start = found.base.map(|base| base.wrapping_add(offset) as usize);
            let run = start.and_then(|start| words.get(start..)?.get(..(r.high - r.low) * CHUNK * WORDS));
            for i in r.low..r.high {
                let mut records = [[0; CHUNK]; WORDS];
                if let Some(run) = run {
                    let run = run[(i - r.low) * CHUNK * WORDS..].chunks_exact(CHUNK);
                    for (row, run) in records.iter_mut().zip(run) {
                        *row = std::array::from_fn(|lane| run[lane].load());
                    }
                } else {
                    let places = r.chunk(addr, i);
                    for (record, place) in records.as_flattened_mut().chunks_exact_mut(WORDS).zip(places) {
                        let place = place.wrapping_add(offset) as usize;
                        if let Some(from) = words.get(place..).and_then(|words| words.first_chunk::<WORDS>()) {
                            record.copy_from_slice(&from.each_ref().map(Word::load));
                        }
                    }
                }
                let [a, b, c, d] = records.map(|row| u32x16::simd_from(s, row));
                let (low, high) = (s.unzip_low_u32x16(a, b), s.unzip_low_u32x16(c, d));
                let (odd_low, odd_high) = (s.unzip_high_u32x16(a, b), s.unzip_high_u32x16(c, d));
                let columns = [
                    s.unzip_low_u32x16(low, high),
                    s.unzip_low_u32x16(odd_low, odd_high),
                    s.unzip_high_u32x16(low, high),
                    s.unzip_high_u32x16(odd_low, odd_high),
                ];
                for (dst, column) in dst.into_iter().zip(columns) {
                    r.set_chunk(dst, i, column.into());
                }
            }
            None
        },
    )
}

/// Loads where some word is past the end. A result may stand where the addresses do.
#[cold]
#[inline(never)]
fn load_clamped<T: Word>(
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    dst: [Reg; WORDS],
    (addr, offset): (Reg, u32),
) -> Option<(Outside, usize)> {
    let places: Vec<_> = (r.low..r.high).map(|i| r.chunk(addr, i)).collect();
    let mut outside = None;
    for (word, dst) in dst.into_iter().enumerate() {
        for (i, places) in (r.low..).zip(&places) {
            let index = |lane: usize| places[lane].wrapping_add(offset).wrapping_add(word as u32);
            let wrong = |lane: &usize| index(*lane) as usize >= words.len() && exec.mask.has(i * CHUNK + lane);
            if outside.is_none()
                && let Some(lane) = (0..CHUNK).find(wrong)
            {
                let at = Outside { lane: i * CHUNK + lane, index: index(lane), length: words.len() as u32 };
                outside = Some((at, word));
            }
            r.set_chunk(dst, i, std::array::from_fn(|lane| memory::read(words, index(lane))));
        }
    }
    outside
}

/// Stores a record of each active lane; `None` where that has to be done word after word.
pub(super) fn store<S: Simd, T: SharedWord>(
    s: S,
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    (addr, offset): (Reg, u32),
    values: [Reg; WORDS],
) -> Option<()> {
    s.vectorize(
        #[inline(always)]
        || {
            let found = survey(s, r, addr, offset, words.len());
            if !(found.inside && found.aligned) {
                return None;
            }
            let start = found.base.filter(|_| exec.full).map(|base| base.wrapping_add(offset) as usize);
            let run = start.and_then(|start| words.get(start..)?.get(..exec.mask.count() as usize * WORDS));
            for i in r.low..r.high {
                let [a, b, c, d] = values.map(|value| u32x16::simd_from(s, r.chunk(value, i)));
                let (even_low, odd_low) = (s.zip_low_u32x16(a, c), s.zip_low_u32x16(b, d));
                let (even_high, odd_high) = (s.zip_high_u32x16(a, c), s.zip_high_u32x16(b, d));
                let rows: [[u32; CHUNK]; WORDS] = [
                    s.zip_low_u32x16(even_low, odd_low).into(),
                    s.zip_high_u32x16(even_low, odd_low).into(),
                    s.zip_low_u32x16(even_high, odd_high).into(),
                    s.zip_high_u32x16(even_high, odd_high).into(),
                ];
                if let Some(run) = run {
                    store_run(&run[(i - r.low) * CHUNK * WORDS..], rows.as_flattened());
                    continue;
                }
                let bits = exec.mask.chunk(i);
                let places = r.chunk(addr, i);
                for (lane, record) in rows.as_flattened().chunks_exact(WORDS).enumerate() {
                    let place = places[lane].wrapping_add(offset) as usize;
                    if bits >> lane & 1 != 0
                        && let Some(to) = words.get(place..place + WORDS)
                    {
                        to.iter().zip(record).for_each(|(to, word)| to.store(*word));
                    }
                }
            }
            Some(())
        },
    )
}

/// Stores a chunk's records, or as many as there are lanes.
#[inline(always)]
fn store_run<T: SharedWord>(run: &[T], records: &[u32]) {
    let run = run.get(..records.len()).unwrap_or(run);
    run.iter().zip(records).for_each(|(to, word)| to.store(*word));
}

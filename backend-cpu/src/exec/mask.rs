//! Which lanes are active: one bit a lane, and the 16-lane chunks that hold them.

/// Lanes of one chunk.
pub(crate) const CHUNK: usize = 16;

/// Most lanes of a gang.
pub(crate) const MAX_LANES: usize = 512;

/// The highest lane of each chunk of a word.
const HIGHEST: u64 = 0x8000_8000_8000_8000;

/// A set of lanes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Mask([u64; MAX_LANES / 64]);

impl PartialEq for Mask {
    fn eq(&self, other: &Self) -> bool {
        // Without a branch, which derived code would make a call.
        self.0.iter().zip(&other.0).fold(0, |differing, (a, b)| differing | (a ^ b)) == 0
    }
}

impl Mask {
    /// The first `count` lanes.
    pub(super) fn first(count: usize) -> Self {
        let mut bits = [0; MAX_LANES / 64];
        for (index, word) in bits.iter_mut().enumerate() {
            let here = count.saturating_sub(index * 64).min(64);
            *word = if here == 64 { u64::MAX } else { (1 << here) - 1 };
        }
        Mask(bits)
    }

    pub(super) fn and(self, other: Self) -> Self {
        Mask(std::array::from_fn(|i| self.0[i] & other.0[i]))
    }

    pub(super) fn and_not(self, other: Self) -> Self {
        Mask(std::array::from_fn(|i| self.0[i] & !other.0[i]))
    }

    pub(super) fn is_empty(self) -> bool {
        self.0 == [0; MAX_LANES / 64]
    }

    pub(super) fn count(self) -> u32 {
        self.0.iter().map(|word| word.count_ones()).sum()
    }

    /// The bits of one chunk.
    #[inline(always)]
    pub(super) fn chunk(self, index: usize) -> u16 {
        (self.0[index / 4] >> (index % 4 * CHUNK)) as u16
    }

    /// The lanes of one word.
    #[inline(always)]
    pub(super) fn word(self, index: usize) -> u64 {
        self.0[index]
    }

    /// Sets the lanes of one word.
    #[inline(always)]
    pub(super) fn set_word(&mut self, index: usize, bits: u64) {
        self.0[index] = bits;
    }

    pub(super) fn has(self, lane: usize) -> bool {
        self.0[lane / 64] >> (lane % 64) & 1 != 0
    }

    /// The chunks that hold a lane of the set.
    fn chunks(self) -> u64 {
        let mut chunks = 0;
        for (index, word) in self.0.into_iter().enumerate() {
            // The highest bit of a chunk, where one of the others is set or it is.
            let some = (((word & !HIGHEST) + !HIGHEST) | word) & HIGHEST;
            chunks |= ((some >> 15 | some >> 30 | some >> 45 | some >> 60) & 15) << (index * 4);
        }
        chunks
    }

    /// First lane of the set.
    pub(super) fn first_lane(self) -> Option<usize> {
        self.0.iter().position(|word| *word != 0).map(|i| i * 64 + self.0[i].trailing_zeros() as usize)
    }

    /// Last lane of the set.
    pub(super) fn last_lane(self) -> Option<usize> {
        self.0.iter().rposition(|word| *word != 0).map(|i| i * 64 + 63 - self.0[i].leading_zeros() as usize)
    }
}

/// The active lanes of a gang.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exec {
    pub(super) mask: Mask,
    /// All lanes that the gang has.
    pub(super) all: Mask,
    /// Whether `mask` is `all`.
    pub(super) full: bool,
    /// Chunks from `low` up to `high` hold all active lanes.
    pub(super) low: usize,
    pub(super) high: usize,
    /// The chunks of that range worth working on: all but long gaps without an active lane.
    live: u64,
    /// Whether these are all of the range.
    pub(super) solid: bool,
}

impl Exec {
    pub(super) fn new(lanes: usize) -> Self {
        let all = Mask::first(lanes);
        let high = lanes.div_ceil(CHUNK);
        Exec { mask: all, all, full: true, low: 0, high, live: range(0, high), solid: true }
    }

    pub(super) fn set(&mut self, mask: Mask) {
        if mask == self.mask {
            return;
        }
        self.mask = mask;
        self.full = mask == self.all;
        let chunks = mask.chunks();
        self.low = if chunks == 0 { 0 } else { chunks.trailing_zeros() as usize };
        self.high = 64 - chunks.leading_zeros() as usize;
        let all = range(self.low, self.high);
        self.live = all & closed(chunks);
        self.solid = self.live == all;
    }

    /// Runs of chunks to work on, from the first to the last: each from its first chunk up to its second.
    #[inline(always)]
    pub(super) fn runs(&self) -> Runs {
        Runs(self.live)
    }
}

/// Runs of set bits that are still to come.
pub(super) struct Runs(u64);

impl Iterator for Runs {
    type Item = (usize, usize);

    #[inline(always)]
    fn next(&mut self) -> Option<(usize, usize)> {
        if self.0 == 0 {
            return None;
        }
        let low = self.0.trailing_zeros() as usize;
        let high = low + (self.0 >> low).trailing_ones() as usize;
        self.0 &= !range(low, high);
        Some((low, high))
    }
}

/// The bits from `low` up to `high`, which is at most 64.
#[inline(always)]
fn range(low: usize, high: usize) -> u64 {
    let below = |end: usize| if end >= 64 { u64::MAX } else { (1 << end) - 1 };
    below(high) & !below(low)
}

/// A set of chunks with its gaps of fewer than four filled: a run costs as much as a few chunks.
fn closed(chunks: u64) -> u64 {
    let wide = chunks | chunks << 1;
    let wide = wide | wide << 2;
    // What the shift lost at the top must not be eaten from there.
    let thin = wide & (wide >> 1 | 1 << 63);
    thin & (thin >> 2 | 3 << 62) | chunks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chunks_and_ranges_agree_with_lanes() {
        let mask = Mask::first(100).and_not(Mask::first(33));
        assert_eq!((mask.first_lane(), mask.last_lane(), mask.count()), (Some(33), Some(99), 67));
        assert_eq!((mask.chunk(2), mask.chunk(6), mask.chunk(7)), (0xfffe, 0x000f, 0));
        let mut exec = Exec::new(100);
        exec.set(mask);
        assert_eq!((exec.low, exec.high, exec.full), (2, 7, false));
        assert_eq!(exec.runs().collect::<Vec<_>>(), [(2, 7)]);
        let mut copy = Mask::default();
        (0..2).for_each(|i| copy.set_word(i, mask.0[i]));
        assert_eq!(copy, mask);
    }

    #[test]
    fn runs_hold_every_active_lane_and_no_long_gap() {
        let chunks = MAX_LANES / CHUNK;
        for seed in 0..2000u64 {
            let noise = |lane: u64| (seed * 977 + lane).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
            let mut mask = Mask::default();
            for chunk in (0..chunks).filter(|chunk| noise(*chunk as u64) % (1 + seed % 9) == 0) {
                mask.0[chunk / 4] |= 1 << (chunk % 4 * CHUNK) << (noise(chunk as u64 + 99) % 16);
            }
            let mut exec = Exec::new(MAX_LANES);
            exec.set(mask);
            let runs: Vec<_> = exec.runs().collect();
            let worked = |chunk: usize| runs.iter().any(|(low, high)| (*low..*high).contains(&chunk));
            assert!((0..chunks).all(|chunk| mask.chunk(chunk) == 0 || worked(chunk)), "{runs:?}");
            assert!(runs.windows(2).all(|pair| pair[1].0 - pair[0].1 >= 4), "{runs:?}");
            let ends = (runs.first().map(|run| run.0), runs.last().map(|run| run.1));
            let bounds = (!mask.is_empty()).then_some((exec.low, exec.high));
            assert_eq!(ends, (bounds.map(|b| b.0), bounds.map(|b| b.1)));
            assert_eq!(exec.solid, runs.len() < 2, "{runs:?}");
        }
    }
}

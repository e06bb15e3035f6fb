//! Which lanes are active: one bit a lane, and the range of 16-lane chunks that holds them.

/// Lanes of one chunk.
pub(crate) const CHUNK: usize = 16;

/// Most lanes of a gang.
pub(crate) const MAX_LANES: usize = 256;

/// A set of lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) struct Mask([u64; MAX_LANES / 64]);

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

    /// Sets the bits of one chunk, which are clear.
    #[inline(always)]
    pub(super) fn set_chunk(&mut self, index: usize, bits: u16) {
        self.0[index / 4] |= u64::from(bits) << (index % 4 * CHUNK);
    }

    pub(super) fn has(self, lane: usize) -> bool {
        self.0[lane / 64] >> (lane % 64) & 1 != 0
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
}

impl Exec {
    pub(super) fn new(lanes: usize) -> Self {
        let all = Mask::first(lanes);
        Exec { mask: all, all, full: true, low: 0, high: lanes.div_ceil(CHUNK) }
    }

    pub(super) fn set(&mut self, mask: Mask) {
        if mask == self.mask {
            return;
        }
        self.mask = mask;
        self.full = mask == self.all;
        self.low = mask.first_lane().map_or(0, |lane| lane / CHUNK);
        self.high = mask.last_lane().map_or(0, |lane| lane / CHUNK + 1);
    }
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
        let mut copy = Mask::default();
        (0..16).for_each(|i| copy.set_chunk(i, mask.chunk(i)));
        assert_eq!(copy, mask);
    }
}

//! Choices of the generator, taken from bytes.

use arbitrary::Unstructured;

/// Bytes that a seed stands for: more than a program takes.
const SEEDED_BYTES: usize = 64 << 10;

/// A source of choices. When its bytes are used up every choice is the first, and programs end soon.
pub(crate) struct Random<'a>(Unstructured<'a>);

impl<'a> Random<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Random(Unstructured::new(bytes))
    }

    /// A number below `n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0.int_in_range(0..=n - 1).unwrap_or(0)
    }

    /// True `percent` times in a hundred.
    pub(crate) fn chance(&mut self, percent: u8) -> bool {
        self.0.ratio(percent, 100).unwrap_or(true)
    }

    pub(crate) fn pick<'b, T>(&mut self, items: &'b [T]) -> &'b T {
        &items[self.below(items.len())]
    }

    /// A word: small, near a limit, a power of two, or anything.
    pub(crate) fn word(&mut self) -> u32 {
        match self.below(6) {
            0 => self.below(10) as u32,
            1 => (self.below(10) as u32).wrapping_neg(),
            2 => 1 << self.below(32),
            3 => 0x7fff_fffe_u32.wrapping_add(self.below(4) as u32),
            4 => self.below(300) as u32,
            _ => self.0.arbitrary().unwrap_or(0),
        }
    }
}

/// Bytes that look random, the same for the same seed (SplitMix64).
pub fn seeded(seed: u64) -> Vec<u8> {
    let mut state = seed;
    let next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ z >> 31).to_le_bytes()
    };
    std::iter::repeat_with(next).take(SEEDED_BYTES / 8).flatten().collect()
}

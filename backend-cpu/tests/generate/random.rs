//! A small deterministic generator of random numbers (SplitMix64).

pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Random(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// A number below `n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// True `percent` times in a hundred.
    pub(crate) fn chance(&mut self, percent: u64) -> bool {
        self.next() % 100 < percent
    }

    pub(crate) fn pick<'a, T>(&mut self, items: &'a [T]) -> &'a T {
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
            _ => self.next() as u32,
        }
    }
}

//! The inputs of the self-test on the host: the twin of the generator in `kernel.wgsl`.
//!
//! Word k of input i is a function of both, so any block can be made anywhere. Invariant: it uses none of the functions
//! under test.

/// Inputs a block, and pairs of a table of edges.
pub const BLOCK: u32 = 4096;

/// Which table of edges a function takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// Integers around which carries, signs and roundings change.
    Integers,
    /// Patterns of f32: zeros, subnormals, powers of two, ties, infinities, NaNs.
    Floats,
}

impl Edges {
    /// The table.
    pub fn table(self) -> &'static [u32; 64] {
        match self {
            Edges::Integers => &INTEGERS,
            Edges::Floats => &FLOATS,
        }
    }
}

#[rustfmt::skip]
static INTEGERS: [u32; 64] = [
    0, 1, 2, 3, 4, 5, 7, 8, 10, 15, 16, 17, 31, 32, 33, 100,
    127, 128, 255, 256, 257, 1000, 4095, 4096, 0x3fff, 0x4000, 0x4001, 0x7ffe, 0x7fff, 0x8000, 0x8001, 0xfffe,
    0xffff, 0x1_0000, 0x1_0001, 0x7f_ffff, 0x80_0000, 0xff_ffff, 0x100_0000, 0x100_0001, 0x1fff_ffff, 0x2000_0000, 0x3fff_ffff, 0x4000_0000,
    0x4000_0001, 0x5555_5555, 0x5a82_7999, 0x7fff_fffe, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, 0xaaaa_aaaa, 0xb504_f333, 0xb504_f334, 0xc000_0000, 0xffff_0000,
    0xffff_0001, 0xffff_8000, 0xffff_8001, 0xffff_ff00, 0xffff_ff80, 0xffff_fffd, 0xffff_fffe, 0xffff_ffff,
];

#[rustfmt::skip]
static FLOATS: [u32; 64] = [
    // Zeros, subnormals, the least normals.
    0, 0x8000_0000, 1, 2, 3, 0x8000_0001, 0x3f_ffff, 0x40_0000, 0x40_0001, 0x7f_ffff, 0x807f_ffff, 0x80_0000, 0x80_0001, 0x8080_0000, 0x100_0000, 0xff_ffff,
    // Around 1, ties of 1 with what follows, and simple fractions.
    0x3f80_0000, 0x3f80_0001, 0x3f7f_ffff, 0xbf80_0000, 0xbf80_0001, 0x3300_0000, 0x3380_0000, 0x3380_0001, 0xb300_0000, 0xb380_0000, 0x3f00_0000, 0x3fc0_0000, 0x4000_0000, 0xc000_0000, 0x4040_0000, 0x3eaa_aaab,
    // Roots next to ties, tenths, the largest exact integers.
    0x3fb5_04f3, 0x3fb5_04f4, 0x4080_0000, 0x4110_0000, 0x3dcc_cccd, 0x4b00_0000, 0x4b7f_ffff, 0x4b80_0000, 0x4b80_0001, 0xcb80_0000, 0x4effffff, 0x4f00_0000, 0xcf00_0000, 0xcf00_0001, 0x4f7f_ffff, 0x4f80_0000,
    // Extreme exponents, infinities, NaNs.
    0x1a00_0000, 0x2000_0000, 0x2080_0000, 0x5f00_0000, 0x5f80_0000, 0x7e80_0000, 0x7f00_0000, 0x7f7f_fffe, 0x7f7f_ffff, 0xff7f_ffff, 0x7f80_0000, 0xff80_0000, 0x7f80_0001, 0x7fc0_0000, 0xffc0_0001, 0xffff_ffff,
];

/// Where the words of inputs come from.
#[derive(Clone, Copy, Debug)]
pub struct Inputs {
    edges: &'static [u32; 64],
    whole: bool,
}

impl Inputs {
    /// Pairs of the table of edges.
    pub fn edges(edges: Edges) -> Self {
        Inputs { edges: edges.table(), whole: true }
    }

    /// Words of many shapes, entries of the table among them.
    pub fn shapes(edges: Edges) -> Self {
        Inputs { edges: edges.table(), whole: false }
    }

    /// Uniform random word `k` < 8 of input `i`.
    pub fn noise(&self, i: u32, k: u32) -> u32 {
        scramble(i.wrapping_mul(16).wrapping_add(8 + k).wrapping_add(0x9e37_79b9))
    }

    /// Word `k` < 16 of input `i`.
    pub fn raw(&self, i: u32, k: u32) -> u32 {
        if !self.whole {
            return self.shaped(scramble(i.wrapping_mul(16).wrapping_add(k)));
        }
        let (row, column) = (i % 64, i / 64);
        let place = match k {
            0 => row,
            1 => column,
            _ => row * (2 * k + 1) + column * (4 * k - 1) + k,
        };
        self.edges[place as usize % 64]
    }

    fn shaped(&self, r: u32) -> u32 {
        let s = scramble(r ^ 0x5bd1_e995);
        let t = s.wrapping_mul(0x9e37_79b1);
        let k = t >> 24 & 31;
        let thin = r & s & s.rotate_right(13);
        let power = (1_u32 << k).wrapping_add(t >> 22 & 3).wrapping_sub(1);
        // An index is faster than a branch that no processor can predict.
        let shapes = [r, r, thin, !thin, power, r >> k, (r >> k).wrapping_neg(), self.edges[r as usize % 64]];
        shapes[(t >> 29) as usize]
    }
}

/// Wellons's lowbias32.
fn scramble(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// What the result of input `i` adds to the digest of its block.
pub(super) fn digest(i: u32, words: [u32; 4]) -> u32 {
    words.iter().fold(scramble(i), |hash, word| {
        let h = (hash ^ word).wrapping_mul(0x9e37_79b1);
        h ^ (h >> 15)
    })
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn tables_have_no_word_twice() {
        for edges in [Edges::Integers, Edges::Floats] {
            assert_eq!(edges.table().iter().collect::<HashSet<_>>().len(), 64, "{edges:?}");
        }
    }

    #[test]
    fn the_first_two_words_of_edges_take_every_pair() {
        let inputs = Inputs::edges(Edges::Integers);
        let pairs: HashSet<_> = (0..BLOCK).map(|i| (inputs.raw(i, 0), inputs.raw(i, 1))).collect();
        assert_eq!(pairs.len(), BLOCK as usize);
        let others: HashSet<_> = (0..BLOCK).map(|i| (inputs.raw(i, 2), inputs.raw(i, 3))).collect();
        assert!(others.len() >= 1024, "{} pairs of the third and fourth word", others.len());
    }

    #[test]
    fn shapes_are_many() {
        let inputs = Inputs::shapes(Edges::Integers);
        let words: Vec<u32> = (0..100_000).map(|i| inputs.raw(i, 0)).collect();
        let share = |is: fn(u32) -> bool| words.iter().filter(|word| is(**word)).count();
        assert!(share(|w| w.is_power_of_two()) > 3_000);
        assert!(share(|w| w.wrapping_add(1).is_power_of_two()) > 3_000);
        assert!(share(|w| w.count_ones() < 8) > 10_000);
        assert!(share(|w| w.count_ones() > 24) > 10_000);
        assert!(share(|w| w < 0x1_0000) > 10_000);
        assert!(share(|w| w == 0) > 100 && share(|w| w == u32::MAX) > 100);
    }

    #[test]
    fn a_digest_tells_words_and_places_apart() {
        let seen: HashSet<u32> = (0..64)
            .flat_map(|i| {
                [[0; 4], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]].map(|words| digest(i, words))
            })
            .collect();
        assert_eq!(seen.len(), 64 * 5);
    }
}

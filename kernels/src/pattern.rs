//! Patterns: light samples at any integer points of the source plane, in any order.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 6: samples may be placed regularly or
//! not, and a mask word may have fewer usable bits than it has (section 6.1: 31 of 32, so 124 samples in four words and
//! 992 in 32). Invariant: a pattern has 1 to [`MAX_SAMPLES`] samples, all on the grid, in at most [`MAX_WORDS`] words.

use sightlines_backend::{Error, Result};

use crate::grid::{Point, Samples, Triangle, XY, hidden};
use crate::random;

/// Most samples of a pattern.
pub const MAX_SAMPLES: usize = 1024;

/// Most words of a mask.
pub const MAX_WORDS: u32 = 32;

/// Light samples on the source plane; sample s has bit `s % bits` of word `s / bits` of a mask.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    points: Vec<[i32; 2]>,
    bits: u32,
}

impl Pattern {
    /// Samples at `points`, `bits` of them in a word, which is 32 or less.
    pub fn new(points: Vec<[i32; 2]>, bits: u32) -> Result<Self> {
        let count = points.len();
        let remedy = format!("give 1 to {MAX_SAMPLES} samples in at most {MAX_WORDS} words of 1 to 32 bits");
        if !(1..=MAX_SAMPLES).contains(&count)
            || !(1..=32).contains(&bits)
            || count.div_ceil(bits as usize) > MAX_WORDS as usize
        {
            return Err(Error::refused(format!("a pattern of {count} samples, {bits} bits a word"), remedy));
        }
        if let Some(point) = points.iter().find(|point| !point.iter().all(|x| (-XY..XY).contains(x))) {
            return Err(Error::refused(format!("a sample at {point:?}"), "keep x and y in [-16384, 16384)"));
        }
        Ok(Pattern { points, bits })
    }

    /// The samples of a regular grid, in its order.
    pub fn regular(samples: &Samples) -> Result<Self> {
        samples.check()?;
        let point = |s| [samples.at(s)[0], samples.at(s)[1]];
        Self::new((0..samples.count()).map(point).collect(), 32)
    }

    /// One sample at a random place of each cell of a grid of `columns` times `rows` cells, `step` apart from `origin`.
    pub fn jittered(origin: [i32; 2], step: [i32; 2], columns: u32, rows: u32, seed: u32) -> Result<Self> {
        let place = |axis: usize, cell: u32, sample: u32| {
            let within = random::below(step[axis].max(1) as u32, seed, 2 * sample + axis as u32);
            origin[axis] + step[axis] * cell as i32 + within as i32
        };
        let points = (0..columns * rows).map(|s| [place(0, s % columns, s), place(1, s / columns, s)]);
        Self::new(points.collect(), 32)
    }

    /// The first `count` points of Halton's sequence in bases 2 and 3 over the rectangle of `size` from `corner`,
    /// rounded down to the grid.
    pub fn halton(corner: [i32; 2], size: [u32; 2], count: u32) -> Result<Self> {
        let place = |axis: usize, index: u32| corner[axis] + radical_inverse([2, 3][axis], index, size[axis]) as i32;
        Self::new((1..=count).map(|index| [place(0, index), place(1, index)]).collect(), 32)
    }

    /// Samples from words: x in the low 16 bits of each, y in the high 16, in two's complement.
    pub fn from_words(words: &[u32]) -> Result<Self> {
        let point = |word: &u32| [i32::from(*word as i16), i32::from((word >> 16) as i16)];
        Self::new(words.iter().map(point).collect(), 32)
    }

    /// The same samples with another number of bits a word.
    pub fn with_bits(self, bits: u32) -> Result<Self> {
        Self::new(self.points, bits)
    }

    /// Where the samples stand.
    pub fn points(&self) -> &[[i32; 2]] {
        &self.points
    }

    /// Number of samples.
    pub fn count(&self) -> u32 {
        self.points.len() as u32
    }

    /// Samples of a word.
    pub fn bits(&self) -> u32 {
        self.bits
    }

    /// Words of a mask.
    pub fn words(&self) -> u32 {
        self.count().div_ceil(self.bits)
    }

    /// Where a sample stands.
    pub fn at(&self, sample: u32) -> Point {
        let [x, y] = self.points[sample as usize];
        [x, y, 0]
    }

    /// Least and greatest coordinates.
    pub fn bounds(&self) -> [[i32; 2]; 2] {
        let fold = |f: fn(i32, i32) -> i32| {
            self.points.iter().copied().reduce(|a, b| [f(a[0], b[0]), f(a[1], b[1])]).expect("a pattern has a sample")
        };
        [fold(i32::min), fold(i32::max)]
    }

    /// The middle of the bounding rectangle, rounded down.
    pub fn centre(&self) -> [i32; 2] {
        let [least, greatest] = self.bounds();
        [0, 1].map(|axis| (least[axis] + greatest[axis]).div_euclid(2))
    }

    /// The least h for which all samples lie in the square of half side 2^h about the centre; at most 14.
    pub fn half_side_bits(&self) -> u32 {
        let centre = self.centre();
        let reach = self.points.iter().flat_map(|p| [0, 1].map(|axis| p[axis].abs_diff(centre[axis]))).max();
        reach.expect("a pattern has a sample").next_power_of_two().ilog2()
    }

    /// A regular grid whose outermost samples enclose the pattern: what can hide none of its samples, as
    /// [`crate::influence_region`] finds it, can hide none of the pattern's.
    pub fn enclosing(&self) -> Samples {
        let [least, greatest] = self.bounds();
        let step = [0, 1].map(|axis| (greatest[axis] - least[axis] + 30).div_euclid(31).max(1));
        // 31 divides the width of the grid, so there is room.
        let origin = [0, 1].map(|axis| least[axis].min(XY - 1 - 31 * step[axis]));
        Samples { origin, step, columns: 32, rows: 32 }
    }

    /// The mask of samples that any of `triangles` hides from `receiver`, by [`hidden`] alone.
    pub fn hidden_set<'a>(&self, receiver: Point, triangles: impl IntoIterator<Item = &'a Triangle>) -> Vec<u32> {
        let mut mask = vec![0; self.words() as usize];
        for triangle in triangles {
            for sample in 0..self.count() {
                let bit = u32::from(hidden(receiver, self.at(sample), triangle));
                mask[(sample / self.bits) as usize] |= bit << (sample % self.bits);
            }
        }
        mask
    }

    /// The masks of `receivers` receivers, each found by `mask`: word w of receiver r at `w * receivers + r`.
    pub fn sets(&self, receivers: u32, mask: impl Fn(u32) -> Vec<u32>) -> Vec<u32> {
        let count = receivers as usize;
        let mut words = vec![0; count * self.words() as usize];
        for receiver in 0..receivers {
            let words = words.iter_mut().skip(receiver as usize).step_by(count);
            words.zip(mask(receiver)).for_each(|(word, found)| *word = found);
        }
        words
    }
}

/// floor(size * the digits of `index` in `base`, mirrored at the point).
fn radical_inverse(base: u32, mut index: u32, size: u32) -> u32 {
    let (mut mirrored, mut unit) = (0u64, 1u64);
    while index > 0 {
        mirrored = mirrored * u64::from(base) + u64::from(index % base);
        unit *= u64::from(base);
        index /= base;
    }
    (u64::from(size) * mirrored / unit) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::hidden_set;

    const TRIANGLE: Triangle = [[-500, -450, 9000], [-100, -500, 8000], [100, 200, 7000]];

    #[test]
    fn a_regular_pattern_has_the_masks_of_its_grid() {
        let samples = Samples { origin: [-1000, -900], step: [63, 58], columns: 16, rows: 8 };
        let pattern = Pattern::regular(&samples).expect("it is on the grid");
        let mask = hidden_set([10, 20, 20_000], &samples, [&TRIANGLE]);
        assert_eq!(pattern.hidden_set([10, 20, 20_000], [&TRIANGLE]), mask);
        assert!(mask.iter().any(|word| *word != 0));
    }

    #[test]
    fn words_of_31_bits_hold_the_same_set() {
        let full = Pattern::halton([-500, -500], [1000, 900], 992).expect("it is on the grid");
        let short = full.clone().with_bits(31).expect("992 = 32 * 31");
        let [a, b] = [&full, &short].map(|p| p.hidden_set([10, 20, 20_000], [&TRIANGLE]));
        assert_eq!((full.words(), short.words()), (31, 32));
        assert!((1..992).contains(&a.iter().map(|word| word.count_ones()).sum::<u32>()), "{a:?}");
        for s in 0..992 {
            assert_eq!(a[s / 32] >> (s % 32) & 1, b[s / 31] >> (s % 31) & 1);
        }
    }

    #[test]
    fn halton_points_are_those_of_the_sequence() {
        let pattern = Pattern::halton([0, 0], [16, 27], 4).expect("it is on the grid");
        assert_eq!(pattern.points(), [[8, 9], [4, 18], [12, 3], [2, 12]]);
    }

    #[test]
    fn a_square_holds_every_sample_and_the_enclosing_grid_too() {
        let corners = [[-XY, -XY], [XY - 1, XY - 1]];
        let patterns = [vec![[5, 7]], vec![[-3, 2], [4, 9]], corners.to_vec(), vec![[XY - 1, XY - 1], [XY - 2, 0]]];
        for points in patterns {
            let pattern = Pattern::new(points, 32).expect("they are on the grid");
            let (centre, half) = (pattern.centre(), 1 << pattern.half_side_bits());
            let samples = pattern.enclosing();
            assert!(pattern.half_side_bits() <= 14);
            samples.check().expect("a grid of samples");
            let last = samples.at(samples.count() - 1);
            for point in pattern.points() {
                assert!((0..2).all(|axis| (point[axis] - centre[axis]).abs() <= half), "{point:?}");
                assert!((0..2).all(|axis| (samples.origin[axis]..=last[axis]).contains(&point[axis])), "{point:?}");
            }
        }
    }

    #[test]
    fn patterns_that_do_not_fit_are_refused() {
        let refused = |points: Vec<[i32; 2]>, bits| Pattern::new(points, bits).expect_err("refused").to_string();
        assert!(refused(Vec::new(), 32).contains("0 samples"));
        assert!(refused(vec![[0, 0]; 1025], 32).contains("1025"));
        assert!(refused(vec![[0, 0]; 993], 31).contains("31 bits"));
        assert!(refused(vec![[0, XY]], 32).contains("16384"));
        assert_eq!(
            Pattern::from_words(&[0xffff_0001, 0xc000_3fff]).expect("on the grid").points(),
            [[1, -1], [16383, -XY]]
        );
    }
}

//! Readings of the sets: from the other side, and on the safe side.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 1 and 6. The sets say which samples a
//! receiver does not see; inverted, they say which receivers a sample sees. Between the points that are looked at
//! anything may happen; what is said of a texel as a whole is read from it and its neighbours: *conservative* keeps as
//! visible what any of them sees, so that nothing visible at one of these points is left out; *aggressive* keeps what
//! all of them see.

use super::Sets;

/// Which of the samples count as hidden from a texel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reading {
    /// Those hidden from its centre.
    #[default]
    Centre,
    /// Those hidden from it and all its eight neighbours: visibility is over-estimated.
    Conservative,
    /// Those hidden from it or any of its eight neighbours: visibility is under-estimated.
    Aggressive,
}

impl Sets {
    /// The opposite query: whether each texel sees a sample, row after row.
    pub fn seen_from(&self, sample: u32) -> Vec<bool> {
        (0..self.texels()).map(|texel| !self.is_hidden(texel, sample)).collect()
    }

    /// The sets as a reading has them. Texels without a receiver are nobody's neighbours.
    pub fn read(&self, reading: Reading, is_there: &[bool]) -> Sets {
        let combine: fn(u32, u32) -> u32 = match reading {
            Reading::Centre => return self.clone(),
            Reading::Conservative => |a, b| a & b,
            Reading::Aggressive => |a, b| a | b,
        };
        let (side, words) = (self.resolution as usize, self.words as usize);
        let set = |texel: usize| &self.masks[texel * words..(texel + 1) * words];
        let mut masks = self.masks.clone();
        for (texel, mask) in masks.chunks_mut(words).enumerate().filter(|(texel, _)| is_there[*texel]) {
            let (x, y) = (texel % side, texel / side);
            let rows = y.saturating_sub(1)..(y + 2).min(side);
            let near = rows.flat_map(|row| (x.saturating_sub(1)..(x + 2).min(side)).map(move |c| row * side + c));
            for neighbour in near.filter(|at| is_there[*at]) {
                mask.iter_mut().zip(set(neighbour)).for_each(|(word, other)| *word = combine(*word, *other));
            }
        }
        Sets { masks, ..self.clone() }
    }

    /// How many of the samples each texel sees whose colour, by `of`, has each of `colours` numbers: colour after
    /// colour.
    pub fn count(&self, of: &[u32], colours: usize) -> Vec<u32> {
        let mut visible = vec![0; colours * self.texels()];
        for texel in 0..self.texels() {
            for (sample, colour) in (0..).zip(of) {
                visible[*colour as usize * self.texels() + texel] += u32::from(!self.is_hidden(texel, sample));
            }
        }
        visible
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three texels a side; the texel in the middle hides sample 0, the one in the corner all.
    fn sets() -> Sets {
        let masks = vec![7, 0, 0, 0, 1, 0, 0, 0, 0];
        Sets { resolution: 3, samples: 3, bits: 32, words: 1, masks, samples_uv: vec![[0, 0]; 3], cell: 1.0 }
    }

    #[test]
    fn a_sample_sees_the_texels_that_see_it() {
        let dark = |sample: u32| (0..9).filter(|t| !sets().seen_from(sample)[*t]).collect::<Vec<_>>();
        assert_eq!((dark(0), dark(2)), (vec![0, 4], vec![0]));
    }

    #[test]
    fn readings_bound_the_sets_from_both_sides() {
        let (sets, all) = (sets(), [true; 9]);
        let [low, mid, high] =
            [Reading::Conservative, Reading::Centre, Reading::Aggressive].map(|r| sets.read(r, &all).masks);
        assert_eq!(low, [0; 9]);
        assert_eq!(mid, sets.masks);
        assert_eq!(high, [7, 7, 1, 7, 7, 1, 1, 1, 1]);
        let mut some = all;
        some[0] = false;
        assert_eq!(sets.read(Reading::Aggressive, &some).masks, [7, 1, 1, 1, 1, 1, 1, 1, 1]);
    }

    #[test]
    fn counts_are_by_colour() {
        assert_eq!(sets().count(&[0, 1, 0], 2), [0, 2, 2, 2, 1, 2, 2, 2, 2, 0, 1, 1, 1, 1, 1, 1, 1, 1]);
    }
}

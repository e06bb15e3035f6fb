//! Frames: the plane across a pair of opposite directions, cut into bins that the whole mesh fits.
//!
//! Invariant: bins are numbered by integers alone, monotone in X and in Y, so that a vertex under a triangle's box is
//! in a bin of that box on every device.

use sightlines_backend::{Error, Result, host};

use super::oracle::Point;
use crate::light_sphere::oracle::Direction;

/// Most of |x| + |y| + |z| of a direction.
pub const MAX_LENGTH: i32 = 1 << 14;

host! {
    /// Mirrors `struct Frame`.
    pub struct Frame {
        /// Axis that u is.
        pub axis: u32,
        /// 1 if forward is the second direction of the pair.
        pub flip: u32,
        /// u of the forward direction.
        pub u: i32,
        /// v of the forward direction.
        pub v: i32,
        /// w of the forward direction, its largest component.
        pub w: i32,
        /// Least X.
        pub x: i32,
        /// Least Y.
        pub y: i32,
        /// Bins a unit of X, in 2^-32.
        pub x_scale: u32,
        /// Bins a unit of Y, in 2^-32.
        pub y_scale: u32,
        /// More than the sides of a bin.
        pub reach: u32,
        /// Twice the error of a difference of two X or Y that were rounded to f32.
        pub blur: u32,
        /// Place of the first bit.
        pub bit: u32,
    }
}

impl Frame {
    /// The frame of pair number `pair`, whose first direction is given, over a box.
    pub fn new(pair: u32, first: Direction, [low, high]: [Point; 2], column_bits: u32, row_bits: u32) -> Self {
        let longest = (0..3).max_by_key(|&axis| first[axis].abs()).unwrap_or(2);
        let flip = first[longest] < 0;
        let d = if flip { first.map(|c| -c) } else { first };
        let [a, b] = [(longest + 1) % 3, (longest + 2) % 3];
        // X = u d.w - w d.u is least and greatest at corners of the box.
        let extent = |axis: usize| {
            let corner = |[p, q]: [Point; 2]| p[axis] * d[longest] - q[longest] * d[axis];
            let corners = [[low, low], [low, high], [high, low], [high, high]].map(corner);
            (corners.into_iter().min().unwrap_or(0), corners.into_iter().max().unwrap_or(0))
        };
        let [(x, x_last), (y, y_last)] = [extent(a), extent(b)];
        let scale = |bits: u32, first: i32, last: i32| {
            let scale = (1_u64 << (32 + bits)) / u64::from((last - first) as u32 + 1);
            u32::try_from(scale).unwrap_or(u32::MAX)
        };
        let (x_scale, y_scale) = (scale(column_bits, x, x_last), scale(row_bits, y, y_last));
        let reach = (u32::MAX / x_scale.min(y_scale)).saturating_add(2).min(1 << 30);
        // X and Y below 2^24 are exact in f32, others below 2^28 and so off by less than 2^5.
        let is_exact = [x, x_last, y, y_last].iter().all(|c| c.abs() <= 1 << 24);
        let blur = if is_exact { 0 } else { 1 << 7 };
        let bit = 2 * pair % 32;
        Frame {
            axis: a as u32,
            flip: u32::from(flip),
            u: d[a],
            v: d[b],
            w: d[longest],
            x,
            y,
            x_scale,
            y_scale,
            reach,
            blur,
            bit,
        }
    }
}

/// Refuses directions that are not opposite in pairs, too long, or zero, and a first number that begins no pair.
pub(super) fn check(first: u32, directions: &[Direction]) -> Result<()> {
    let remedy = "give pairs of opposite directions with 0 < |x| + |y| + |z| <= 2^14";
    let fits = |d: &Direction| {
        let length: i64 = d.iter().map(|&c| i64::from(c).abs()).sum();
        (1..=i64::from(MAX_LENGTH)).contains(&length)
    };
    if !first.is_multiple_of(2) {
        return Err(Error::refused(format!("directions from number {first} on"), "begin with the first of a pair"));
    }
    for (number, pair) in directions.chunks(2).enumerate() {
        if pair.len() != 2 || !pair.iter().all(fits) || pair[1] != pair[0].map(|c| -c) {
            return Err(Error::refused(format!("pair {number} of the directions, {pair:?}"), remedy));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random;

    #[test]
    fn every_point_of_the_box_is_in_a_bin_and_bins_are_narrower_than_their_reach() {
        let directions = [[1, 0, 0], [0, -1, 0], [3, -7, 6], [-1, -1, -1], [5461, 5461, -5462], [1, 16_000, 2]];
        let boxes = [[[-16_384; 3], [16_383; 3]], [[5; 3], [5; 3]], [[-3, 0, 7], [4, 0, 9]]];
        for (k, direction) in (0..).zip(directions) {
            for bounds in boxes {
                let f = Frame::new(k, direction, bounds, 5, 3);
                let bin = |value: i32, scale: u32| (u64::from(value as u32) * u64::from(scale)) >> 32;
                let mut seen: Vec<(i32, u64)> = (0..2000)
                    .map(|i| {
                        let p = [0, 1, 2].map(|axis| {
                            let size = (bounds[1][axis] - bounds[0][axis] + 1) as u32;
                            bounds[0][axis] + random::below(size, k, 3 * i + axis as u32) as i32
                        });
                        let (u, w) = (p[f.axis as usize], p[(f.axis as usize + 2) % 3]);
                        let x = u * f.w - w * f.u - f.x;
                        assert!(x >= 0 && bin(x, f.x_scale) < 32, "{direction:?}: {p:?}");
                        (x, bin(x, f.x_scale))
                    })
                    .collect();
                seen.sort_unstable();
                assert!(seen.is_sorted_by_key(|(_, bin)| *bin));
                let wide = seen.chunk_by(|a, b| a.1 == b.1).map(|bin| bin[bin.len() - 1].0 - bin[0].0).max();
                assert!(wide < Some(f.reach as i32), "{direction:?}: {wide:?} in bins of {}", f.reach);
            }
        }
    }

    #[test]
    fn forward_is_the_direction_with_the_largest_component_up() {
        let f = Frame::new(17, [1, -3, 2], [[0; 3], [9; 3]], 4, 4);
        assert_eq!((f.axis, f.flip, f.u, f.v, f.w, f.bit), (2, 1, -2, -1, 3, 2));
    }
}

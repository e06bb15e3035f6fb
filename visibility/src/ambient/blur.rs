//! The Gaussian of the sphere: what an environment brings around a direction, filtered by angle and not by texel.
//!
//! A latitude–longitude map has texels of one size in the map and of ever smaller size towards its poles; a filter of
//! so many texels (Sattler et al. 2004, section 5) spreads light there over too small an angle
//! along rows and counts it too often along columns. Here a texel counts by its solid angle times exp(-c² / 2σ²), where
//! c is the chord between it and the direction on the unit sphere, and the sum is divided by that of the weights.
//! Invariants: weights and sums are integers, so a constant stays what it is to the bit; weights are made in f64 and
//! `libm`.

use super::environment::Environment;
use crate::vector::Vector;

/// Chords of more standard deviations do not count.
const REACH: f64 = 4.0;

/// Weight of a texel of the largest solid angle at a chord of 0.
const ONE: f64 = (1 << 30) as f64;

/// A map as the filter sees it.
pub(super) struct Sky<'a> {
    width: usize,
    rows: Vec<Row>,
    /// Sine and cosine of the middle of each column, from the middle of the map.
    columns: Vec<(f64, f64)>,
    /// Texels in fixed point.
    texels: &'a [[u32; 4]],
}

struct Row {
    /// Angle from the zenith of its middle, with sine and cosine.
    angle: f64,
    level: f64,
    height: f64,
    /// Solid angle of its texels, of the largest in the map.
    share: f64,
}

impl<'a> Sky<'a> {
    pub(super) fn new(map: &Environment, texels: &'a [[u32; 4]]) -> Self {
        let step = std::f64::consts::PI / f64::from(map.height);
        let bounds = |row: u32| libm::cos(step * f64::from(row)) - libm::cos(step * f64::from(row + 1));
        let largest = bounds(map.height / 2);
        let row = |row: u32| {
            let angle = step * (f64::from(row) + 0.5);
            let (level, height) = libm::sincos(angle);
            Row { angle, level, height, share: bounds(row) / largest }
        };
        let column = |column: u32| {
            libm::sincos(std::f64::consts::TAU * ((f64::from(column) + 0.5) / f64::from(map.width) - 0.5))
        };
        Sky {
            width: map.width as usize,
            rows: (0..map.height).map(row).collect(),
            columns: (0..map.width).map(column).collect(),
            texels,
        }
    }

    /// The mean around a direction of length one, where y is up, of each channel, rounded down.
    pub(super) fn around(&self, [x, y, z]: Vector, sigma: f64) -> [u32; 3] {
        let sharpness = 1.0 / (sigma * sigma);
        // The square of a chord is 2 - 2 cos.
        let least = 1.0 - 0.5 * REACH * REACH * sigma * sigma;
        let (angle, reach) = (libm::acos(y.clamp(-1.0, 1.0)), libm::acos(least.max(-1.0)));
        let (mut sums, mut whole) = ([0_u128; 3], 0_u64);
        for (row, texels) in self.rows.iter().zip(self.texels.chunks(self.width)) {
            if (row.angle - angle).abs() > reach {
                continue;
            }
            for ((sine, cosine), texel) in self.columns.iter().zip(texels) {
                let near = y * row.height + row.level * (x * sine - z * cosine);
                if near < least {
                    continue;
                }
                let weight = (ONE * row.share * libm::exp((near - 1.0) * sharpness)) as u64;
                whole += weight;
                (0..3).for_each(|c| sums[c] += u128::from(weight) * u128::from(texel[c]));
            }
        }
        sums.map(|sum| (sum / u128::from(whole.max(1))) as u32)
    }
}

/// Columns of a map that a filter of that standard deviation, in radians, cannot tell from a finer one: its texels are
/// a quarter of it.
pub(super) fn columns(sigma: f64) -> u32 {
    let columns = libm::ceil(4.0 * std::f64::consts::TAU / sigma).clamp(1.0, 4096.0) as u32;
    columns.next_power_of_two()
}

#[cfg(test)]
mod tests {
    use sightlines_kernels::illumination::Fixed;

    use super::*;
    use crate::ambient::Sphere;
    use crate::ambient::environment::direction_at;
    use crate::vector::{dot, normalize};

    fn directions(order: u32) -> Vec<Vector> {
        Sphere::Healpix { order }.directions().into_iter().map(|d| normalize(d.map(f64::from))).collect()
    }

    /// Black but for a spot of ten degrees around a direction.
    fn spot(towards: Vector) -> Environment {
        let lit = |i: u32| dot(direction_at([i % 256, i / 256], [256, 128]), towards) > 0.985;
        Environment {
            width: 256,
            height: 128,
            texels: (0..256 * 128).map(|i| if lit(i) { [1.0; 3] } else { [0.0; 3] }).collect(),
        }
    }

    #[test]
    fn a_constant_stays_what_it_is_to_the_bit() {
        for (width, height) in [(2, 1), (16, 8), (60, 30)] {
            let texels = vec![[0.3, 1.0, 7e5]; (width * height) as usize];
            let map = Environment { width, height, texels };
            let fixed = Fixed::new(&map.texels).unwrap();
            let sky = Sky::new(&map, &fixed.values);
            for sigma in [3.0 / f64::from(width), 0.3, 1.5] {
                for direction in directions(1) {
                    let found = sky.around(direction, sigma.max(1.6 / f64::from(height)));
                    assert_eq!(found, [0, 1, 2].map(|c| fixed.values[0][c]), "{width}, {sigma}: {direction:?}");
                }
            }
        }
    }

    #[test]
    fn energy_is_kept_wherever_the_light_stands() {
        let around = directions(3);
        for towards in [[0.0, 1.0, 0.0], [0.6, 0.0, -0.8], [0.1, 0.99, 0.09]] {
            let map = spot(normalize(towards));
            let fixed = Fixed::new(&map.texels).unwrap();
            let sky = Sky::new(&map, &fixed.values);
            for sigma in [0.1, 0.5] {
                let sum: f64 = around.iter().map(|d| f64::from(sky.around(*d, sigma)[0])).sum();
                let found = libm::scalbn(sum / around.len() as f64, -fixed.shifts[0]);
                let share = found / map.mean()[0];
                assert!((share - 1.0).abs() < 0.01, "{towards:?}, {sigma}: {share}");
            }
        }
    }

    #[test]
    fn a_spot_fades_with_the_angle_alone() {
        for towards in [[0.0, 1.0, 0.0], [0.6, 0.0, -0.8], [0.36, 0.8, 0.48]] {
            let map = spot(towards);
            let fixed = Fixed::new(&map.texels).unwrap();
            let sky = Sky::new(&map, &fixed.values);
            // At right angles to it.
            let aside = normalize([towards[2], 0.0, if towards[0] == 0.0 { 1.0 } else { -towards[0] }]);
            // By numerical integration; the spot of texels is not quite as large as the spot.
            let size = map.mean()[0] / (0.5 * (1.0 - 0.985));
            for (degrees, expected) in [(0.0, 0.12813), (20.0, 0.07692), (45.0, 0.01040)] {
                let (s, c) = libm::sincos(f64::to_radians(degrees));
                let at = [0, 1, 2].map(|i| c * towards[i] + s * aside[i]);
                let found = libm::scalbn(f64::from(sky.around(at, 0.33)[0]), -fixed.shifts[0]);
                assert!((found / (size * expected) - 1.0).abs() < 0.03, "{towards:?}, {degrees}: {found}");
            }
        }
    }
}

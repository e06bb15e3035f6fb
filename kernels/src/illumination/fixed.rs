//! Fixed point with one exponent a channel, and what its range loses; gamma tables and Gaussian taps.
//!
//! Host code under the numerics contract: f64 and the pinned `libm` only. Invariant: the largest value of a channel
//! uses all 32 bits, so every value is within half a unit, 2^-33 of the largest to within a factor of two.

use sightlines_backend::{Error, Result};

/// Largest shift: sums of any number of lights then stay within what `u64_to_f` takes.
const MAX_SHIFT: i32 = 48;

/// Three channels in fixed point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fixed {
    /// Values times 2^shift of their channel, rounded to nearest; the fourth word is 0.
    pub values: Vec<[u32; 4]>,
    /// Shift of every channel.
    pub shifts: [i32; 3],
    /// For every channel, how many values that are not 0 became 0.
    pub lost: [u32; 3],
}

impl Fixed {
    /// Colours, such as the texels of an environment or the intensities of lights. They must be finite and not
    /// negative.
    pub fn new(colours: &[[f32; 3]]) -> Result<Self> {
        let bad = |c: &f32| !c.is_finite() || *c < 0.0;
        if let Some((number, colour)) = (0..).zip(colours).find(|(_, colour)| colour.iter().any(bad)) {
            let remedy = "give finite values that are not negative";
            return Err(Error::refused(format!("value {number}, {colour:?}, of an environment"), remedy));
        }
        let shifts = [0, 1, 2].map(|c| shift_of(colours.iter().map(|colour| colour[c]).fold(0.0, f32::max)));
        if let Some(c) = (0..3).find(|&c| shifts[c].abs() > MAX_SHIFT) {
            let what = format!("channel {c} of an environment, whose largest value needs a shift of {}", shifts[c]);
            return Err(Error::refused(what, "scale it: largest values from 2^-16 to 2^79 are taken"));
        }
        let mut lost = [0; 3];
        let mut fixed = |colour: &[f32; 3]| {
            let [r, g, b] = [0, 1, 2].map(|c| {
                let value = libm::rint(libm::scalbn(f64::from(colour[c]), shifts[c])).min(f64::from(u32::MAX)) as u32;
                lost[c] += u32::from(value == 0 && colour[c] > 0.0);
                value
            });
            [r, g, b, 0]
        };
        let values = colours.iter().map(&mut fixed).collect();
        Ok(Fixed { values, shifts, lost })
    }
}

/// The shift that brings `most` to [2^31, 2^32); 0 for 0.
fn shift_of(most: f32) -> i32 {
    if most > 0.0 { 31 - libm::ilogb(f64::from(most)) } else { 0 }
}

/// Weights of lights as kernels take them: shares of the sphere in units of 2^-32, all shifted as far up as the largest
/// allows; and by how much.
pub fn scaled_weights(weights: &[u32]) -> (Vec<u32>, u32) {
    let up = weights.iter().max().map_or(0, |most| most.leading_zeros().min(31));
    (weights.iter().map(|w| w << up).collect(), up)
}

/// f32 bits of the 255 least values that are encoded as 1 to 255: a value v is encoded as 255 (v / white)^(1 / gamma),
/// rounded to the nearest.
pub fn gamma_table(gamma: f64, white: f64) -> Result<Vec<u32>> {
    if !(0.1..=10.0).contains(&gamma) || !(1e-30..=1e30).contains(&white) {
        let what = format!("gamma {gamma} with white at {white}");
        return Err(Error::refused(what, "use a gamma from 0.1 to 10 and a white from 1e-30 to 1e30"));
    }
    let least = |code: u32| (white * libm::pow((f64::from(code) - 0.5) / 255.0, gamma)) as f32;
    Ok((1..=255).map(|code| least(code).max(f32::MIN_POSITIVE).to_bits()).collect())
}

/// Taps of a Gaussian of standard deviation `sigma` texels over 2 `radius` + 1 texels, in units of 2^-16; they sum to
/// 2^16.
pub fn gaussian_taps(sigma: f64, radius: u32) -> Result<Vec<u32>> {
    if !(0.05..=64.0).contains(&sigma) || radius > super::MAX_RADIUS {
        let what = format!("a Gaussian of {sigma} texels over {radius} on either side");
        let remedy = format!("use 0.05 to 64 texels, and at most {} on either side", super::MAX_RADIUS);
        return Err(Error::refused(what, remedy));
    }
    let bell = |i: u32| libm::exp(-f64::from(i * i) / (2.0 * sigma * sigma));
    let sum = 1.0 + 2.0 * (1..=radius).map(bell).sum::<f64>();
    let side: Vec<u32> = (1..=radius).map(|i| libm::rint(bell(i) / sum * 65_536.0) as u32).collect();
    // The middle takes what rounding leaves.
    let middle = 65_536 - 2 * side.iter().sum::<u32>().min(32_768);
    Ok(side.iter().rev().copied().chain([middle]).chain(side.iter().copied()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_value_uses_all_bits_and_losses_are_counted() {
        let fixed = Fixed::new(&[[1.0, 3e-9, 0.0], [0.25, 60_000.0, 0.0], [1e-12, 1e-30, 0.0]]).expect("finite");
        assert_eq!(fixed.shifts, [31, 16, 0]);
        assert_eq!(fixed.values[0], [1 << 31, 0, 0, 0]);
        assert_eq!(fixed.values[1], [1 << 29, 60_000 << 16, 0, 0]);
        assert_eq!(fixed.lost, [1, 2, 0]);
        for bad in [f32::NAN, f32::INFINITY, -1.0, 1e38, 1e-30] {
            assert!(Fixed::new(&[[bad; 3]]).is_err(), "{bad}");
        }
    }

    #[test]
    fn thresholds_ascend_and_the_middle_of_a_code_is_encoded_as_it() {
        for (gamma, white) in [(2.2, 1.0), (1.0, 4.0), (0.4, 0.01), (10.0, 1.0)] {
            let table = gamma_table(gamma, white).expect("in range");
            assert!(table.is_sorted(), "gamma {gamma}");
            for code in 20..255_u32 {
                let value = (white * libm::pow(f64::from(code) / 255.0, gamma)) as f32;
                assert_eq!(
                    table.iter().filter(|t| f32::from_bits(**t) <= value).count(),
                    code as usize,
                    "gamma {gamma}"
                );
            }
        }
        assert!(gamma_table(0.0, 1.0).is_err() && gamma_table(2.2, 0.0).is_err());
    }

    #[test]
    fn taps_are_a_symmetric_partition_of_one() {
        for (sigma, radius) in [(0.05, 0), (0.5, 2), (2.0, 6), (64.0, 64), (1.0, 64)] {
            let taps = gaussian_taps(sigma, radius).expect("in range");
            assert_eq!((taps.len() as u32, taps.iter().sum::<u32>()), (2 * radius + 1, 65_536), "sigma {sigma}");
            assert!(
                taps.iter().eq(taps.iter().rev()) && taps[..=radius as usize].is_sorted(),
                "sigma {sigma}: {taps:?}"
            );
        }
        assert!(gaussian_taps(0.0, 3).is_err() && gaussian_taps(2.0, 65).is_err());
    }
}

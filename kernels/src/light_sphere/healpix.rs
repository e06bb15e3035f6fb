//! Equal-area directions: the pixel centres of HEALPix in nested order.
//!
//! Górski et al., "HEALPix: A Framework for High-Resolution Discretization and Fast Analysis of Data Distributed on the
//! Sphere" (ApJ 622, 2005), sections 4 and 5: twelve faces of 4^order pixels of equal area. The opposite of a centre is
//! a centre, of face f + 8 or so for the polar faces and of f + 2 for the equatorial ones, so faces 0 to 5 in nested
//! order name all pairs: pair p is nested pixel p and its negation. Invariants: opposites are exact negations;
//! components are rounded once, from f64 and the pinned `libm`, to units of 2^-13.

use std::f64::consts::FRAC_PI_2;

use super::oracle::Direction;

/// Highest order: 49,152 directions.
pub const MAX_ORDER: u32 = 6;

/// Units of one: |x| + |y| + |z| stays below 2^14.
const SCALE: f64 = 8192.0;

/// The directions of `order`, `12 * 4^order` of them, opposites next to each other.
///
/// # Panics
///
/// Where the order is above [`MAX_ORDER`].
pub fn healpix(order: u32) -> Vec<Direction> {
    assert!(order <= MAX_ORDER, "order {order} is above {MAX_ORDER}");
    let pairs = 6_u32 << (2 * order);
    (0..pairs).flat_map(|pixel| [centre(order, pixel), centre(order, pixel).map(|c| -c)]).collect()
}

/// Every second bit of `word`, from bit 0.
fn compact(word: u32) -> i32 {
    (0..16).map(|bit| (word >> (2 * bit) & 1) << bit).sum::<u32>() as i32
}

fn centre(order: u32, pixel: u32) -> Direction {
    let side = 1_i32 << order;
    let (face, place) = ((pixel >> (2 * order)) as i32, pixel & ((1 << (2 * order)) - 1));
    let (x, y) = (compact(place), compact(place >> 1));
    // Ring counted from the north pole; pixels of a quarter of the ring; whether its pixels begin half a pixel late.
    let (row, meridian) = if face < 4 { (2, 2 * face + 1) } else { (3, 2 * (face - 4)) };
    let ring = row * side - x - y - 1;
    let (quarter, z, half) = if ring < side {
        (ring, 1.0 - f64::from(ring * ring) / f64::from(3 * side * side), 1)
    } else {
        (side, f64::from(2 * (2 * side - ring)) / f64::from(3 * side), (ring - side + 1) & 1)
    };
    // Twice the pixel's place on its ring, in pixels from longitude 0.
    let twice = meridian * quarter + x - y;
    debug_assert_eq!((twice + half).rem_euclid(2), 0, "pixel {pixel} of order {order}");
    let longitude = f64::from(twice) * 0.5 * FRAC_PI_2 / f64::from(quarter);
    let radius = (1.0 - z * z).sqrt();
    [radius * libm::cos(longitude), radius * libm::sin(longitude), z].map(|c| libm::rint(c * SCALE) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    /// Pixel centres ring by ring: equations 4 and 5 (polar cap), 8 and 9 (belt), and the mirror image.
    fn rings(side: i32) -> HashSet<Direction> {
        let mut centres = HashSet::new();
        let mut put = |z: f64, quarters: f64| {
            let radius = (1.0 - z * z).sqrt();
            let v = [radius * libm::cos(quarters * FRAC_PI_2), radius * libm::sin(quarters * FRAC_PI_2), z];
            centres.insert(v.map(|c| libm::rint(c * SCALE) as i32));
        };
        for i in 1..side {
            for j in 1..=4 * i {
                let z = 1.0 - f64::from(i * i) / f64::from(3 * side * side);
                let quarters = (f64::from(j) - 0.5) / f64::from(i);
                put(z, quarters);
                put(-z, quarters);
            }
        }
        for i in side..=3 * side {
            for j in 1..=4 * side {
                let shift = f64::from((i - side + 1) % 2);
                put(4.0 / 3.0 - f64::from(2 * i) / f64::from(3 * side), (f64::from(j) - shift / 2.0) / f64::from(side));
            }
        }
        centres
    }

    #[test]
    fn nested_pairs_are_the_centres_of_all_rings() {
        for order in 0..=4 {
            let nested = healpix(order);
            let set: HashSet<Direction> = nested.iter().copied().collect();
            assert_eq!((nested.len(), set.len()), (12 << (2 * order), 12 << (2 * order)), "order {order}");
            let rings = rings(1 << order);
            assert_eq!(rings.len(), set.len(), "order {order}");
            // Roundings of the two formulas may differ by a unit.
            let near = |d: &Direction| {
                let by = -1..=1;
                by.clone()
                    .any(|x| by.clone().any(|y| by.clone().any(|z| rings.contains(&[d[0] + x, d[1] + y, d[2] + z]))))
            };
            assert!(set.iter().all(near), "order {order}");
        }
    }

    #[test]
    fn directions_fit_the_budget_and_integrate_squares() {
        let all = healpix(MAX_ORDER);
        assert!(all.iter().all(|d| d.iter().map(|c| c.abs()).sum::<i32>() <= 1 << 14));
        assert!(all.chunks(2).all(|pair| pair[0] == pair[1].map(|c| -c)));
        // Second moments of equal areas are a third each.
        for axis in 0..3 {
            let moment: f64 = all.iter().map(|d| (f64::from(d[axis]) / SCALE) * (f64::from(d[axis]) / SCALE)).sum();
            assert!((moment / all.len() as f64 - 1.0 / 3.0).abs() < 3e-5, "axis {axis}: {moment}");
        }
    }
}

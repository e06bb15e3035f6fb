//! Angles and directions: the stated formulas in wide integers.

/// The polynomial that defines the binary angle, every floor as stated in `shared/angle.wgsl`.
pub fn atan2_bam(y: i32, x: i32) -> u32 {
    const COEFFICIENTS: [i128; 5] = [207_245_891, 374_658_932, 545_657_482, 911_383_810, 2_734_260_801];
    let (ax, ay) = (i128::from(x).abs(), i128::from(y).abs());
    let larger = ax.max(ay);
    if larger == 0 {
        return 0;
    }
    let s = (larger as u32).leading_zeros();
    let (d, n) = (larger << s >> 3, ax.min(ay) << s >> 3);
    let folded = 5 * n > 2 * d;
    let (n, d) = if folded { (d - n, d + n) } else { (n, d) };
    let q = 4 * ((n << 30) / d);
    let z = (q * q) >> 32;
    let p = COEFFICIENTS[1..].iter().fold(COEFFICIENTS[0], |p, coefficient| coefficient - ((p * z) >> 32));
    let mut turn = (((p * q) >> 32) + 2) >> 2;
    if folded {
        turn = (1 << 29) - turn;
    }
    if ay > ax {
        turn = (1 << 30) - turn;
    }
    if x < 0 {
        turn = (1 << 31) - turn;
    }
    (if y < 0 { -turn } else { turn }) as u32
}

/// floor(2^20 |y| / (|x| + |y|)), mirrored into the quadrants; 2^22 to the turn.
pub fn diamond_angle(y: i32, x: i32) -> u32 {
    let (ax, ay) = (u64::from(x.unsigned_abs()), u64::from(y.unsigned_abs()));
    let quarter = (ay << 20).checked_div(ax + ay).unwrap_or(0);
    let half = if x < 0 { (2 << 20) - quarter } else { quarter };
    (if y < 0 { (4 << 20) - half } else { half }) as u32 % (4 << 20)
}

/// floor(2^15 |v| / |(x, y, z)|) with the sign of each component v.
pub fn normalize3_q15(v: [i32; 3]) -> [i32; 3] {
    let squares = v.map(|c| (i64::from(c) * i64::from(c)) as u64);
    let length: u64 = squares.iter().sum();
    // The floor of a root of a quotient is the root of its floor.
    [0, 1, 2].map(|axis| ((squares[axis] << 30) / length).isqrt() as i32 * v[axis].signum())
}

/// The point (i, j) of [0, 2n]^2 on the octahedron: outside the inner diamond each corner folds under.
pub fn oct_dir(i: i32, j: i32, n: i32) -> [i32; 3] {
    let (u, v) = (i - n, j - n);
    let z = n - u.abs() - v.abs();
    let sign = |c: i32| if c < 0 { -1 } else { 1 };
    if z < 0 { [sign(u) * (n - v.abs()), sign(v) * (n - u.abs()), z] } else { [u, v, z] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random;

    const TURN: f64 = 4_294_967_296.0;

    /// The largest distance of `atan2_bam` from the true angle, in units of 2^-32 turn.
    fn worst(halvings: u32, count: u32) -> f64 {
        let distance = |i| {
            let word = |k| (random::word(k, i) as i32) >> halvings;
            let scale = random::word(9, i) % 28;
            let (y, x) = (word(1) >> (scale * (i & 1)), word(2) >> (scale * (i >> 1 & 1)));
            let truth = libm::atan2(y.into(), x.into()) / std::f64::consts::TAU * TURN;
            let difference = (f64::from(atan2_bam(y, x)) - truth).rem_euclid(TURN);
            if (x, y) == (0, 0) { 0.0 } else { difference.min(TURN - difference) }
        };
        (0..count).map(distance).fold(0.0, f64::max)
    }

    #[test]
    fn the_binary_angle_is_within_its_bounds() {
        let (short, long) = (worst(3, 2_000_000), worst(0, 2_000_000));
        assert!(short <= 5.0, "{short} units for components below 2^29");
        assert!(long <= 8.0, "{long} units for any components");
        assert!(short > 1.0 && long > 1.0, "the test sees the error of the polynomial");
    }

    #[test]
    fn the_binary_angle_of_axes_and_its_oddness() {
        assert_eq!((atan2_bam(0, 7), atan2_bam(0, -7)), (0, 1 << 31));
        assert_eq!((atan2_bam(7, 0), atan2_bam(-7, 0)), (1 << 30, 3 << 30));
        assert_eq!(atan2_bam(i32::MIN, i32::MIN), 5 << 29);
        for i in 0..100_000 {
            let (y, x) = (random::word(3, i) as i32 >> 1, random::word(4, i) as i32);
            assert_eq!(atan2_bam(-y, x), atan2_bam(y, x).wrapping_neg(), "{y} {x}");
        }
    }

    #[test]
    fn the_diamond_angle_grows_with_the_angle() {
        let angles = (0..400).map(|i| libm::sincos(f64::from(i) / 400.0 * std::f64::consts::TAU));
        let diamonds: Vec<u32> = angles.map(|(s, c)| diamond_angle((s * 5e8) as i32, (c * 5e8) as i32)).collect();
        assert!(diamonds.is_sorted_by(|a, b| a < b));
        assert_eq!((diamond_angle(1, 0), diamond_angle(0, -1), diamond_angle(-1, 0)), (1 << 20, 2 << 20, 3 << 20));
        assert_eq!(diamond_angle(0, 0), 0);
    }

    #[test]
    fn directions_have_their_length() {
        assert_eq!(normalize3_q15([3, 0, -4]), [19_660, 0, -26_214]);
        assert_eq!(normalize3_q15([-(1 << 15), 0, 0]), [-(1 << 15), 0, 0]);
        for (i, j) in (0..=14).flat_map(|i| (0..=14).map(move |j| (i, j))) {
            let direction = oct_dir(i, j, 7);
            assert_eq!(direction.iter().map(|c| c.abs()).sum::<i32>(), 7, "{i} {j}");
            assert_eq!(oct_dir(14 - i, 14 - j, 7)[2], direction[2]);
        }
        assert_eq!((oct_dir(7, 7, 7), oct_dir(0, 14, 7)), ([0, 0, 7], [0, 0, -7]));
    }
}

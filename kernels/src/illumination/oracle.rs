//! The definitions, in wide integers: texel of a direction, blur, matrix times intensities, thresholds reached.

use crate::exact::oracle::angle::atan2_bam;
use crate::exact::oracle::float::u64_to_f;

/// A map of an environment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Rows from +z to -z, columns from +x towards +y.
    LatitudeLongitude {
        /// Texels a row.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// Six square faces, as OpenGL numbers and turns them.
    Cube {
        /// Texels a side.
        side: u32,
    },
}

/// The texel that holds a direction.
pub fn texel_of(shape: Shape, [x, y, z]: [i32; 3]) -> u32 {
    match shape {
        Shape::LatitudeLongitude { width, height } => {
            let radius = (i64::from(x) * i64::from(x) + i64::from(y) * i64::from(y)).isqrt() as i32;
            let (from_pole, around) = (u64::from(atan2_bam(radius, z)), u64::from(atan2_bam(y, x)));
            let row = ((from_pole * u64::from(height)) >> 31).min(u64::from(height) - 1);
            let column = (around * u64::from(width)) >> 32;
            (row * u64::from(width) + column) as u32
        }
        Shape::Cube { side } => {
            let (a, b, c) = (x.abs(), y.abs(), z.abs());
            let (face, major, s, t) = if a >= b && a >= c {
                if x >= 0 { (0, a, -z, -y) } else { (1, a, z, -y) }
            } else if b >= c {
                if y >= 0 { (2, b, x, z) } else { (3, b, x, -z) }
            } else if z >= 0 {
                (4, c, x, -y)
            } else {
                (5, c, -x, -y)
            };
            let (side, major) = (i64::from(side), i64::from(major.max(1)));
            let texel = |at: i32| ((i64::from(at) + major) * side / (2 * major)).min(side - 1);
            ((face * side + texel(t)) * side + texel(s)) as u32
        }
    }
}

/// One pass of a blur: taps around every texel, along rows, which close, or along columns, whose ends are repeated.
pub fn blurred(width: u32, texels: &[[u32; 4]], taps: &[u32], along_columns: bool) -> Vec<[u32; 4]> {
    let (width, radius) = (i64::from(width), taps.len() as i64 / 2);
    let height = texels.len() as i64 / width;
    let texel = |row: i64, column: i64, channel: usize| -> u32 {
        let sum: u128 = (-radius..)
            .zip(taps)
            .map(|(by, &tap)| {
                let (row, column) = if along_columns {
                    ((row + by).clamp(0, height - 1), column)
                } else {
                    (row, (column + by).rem_euclid(width))
                };
                u128::from(texels[(row * width + column) as usize][channel]) * u128::from(tap)
            })
            .sum();
        (sum >> 16) as u32
    };
    (0..height)
        .flat_map(|row| (0..width).map(move |column| (row, column)))
        .map(|(row, column)| [texel(row, column, 0), texel(row, column, 1), texel(row, column, 2), 0])
        .collect()
}

/// An entry of the matrix: the cosine of normal and light in units of 2^-15, 0 where it is negative or the light
/// occluded.
pub fn entry(normal: [i32; 3], light: [i32; 3], is_occluded: bool) -> u32 {
    let dot: i64 = normal.iter().zip(light).map(|(&n, l)| i64::from(n) * i64::from(l)).sum();
    if is_occluded { 0 } else { (dot >> 15).max(0) as u32 }
}

/// The colour of one vertex: entries times intensities, and the rounding.
pub fn colour(entries: &[u32], intensities: &[[u32; 4]], shifts: [i32; 3]) -> [u32; 3] {
    [0, 1, 2].map(|channel| {
        let terms = entries.iter().zip(intensities);
        let sum: u128 = terms.map(|(&m, i)| u128::from(m) * u128::from(i[channel])).sum();
        u64_to_f(sum as u64, shifts[channel])
    })
}

/// The three bytes of a colour and 255.
pub fn encoded(colour: [u32; 3], thresholds: &[u32]) -> u32 {
    let code = |c: u32| thresholds.iter().filter(|t| f32::from_bits(c) >= f32::from_bits(**t)).count() as u32;
    u32::from_le_bytes([code(colour[0]) as u8, code(colour[1]) as u8, code(colour[2]) as u8, 255])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random;
    use std::f64::consts::PI;

    fn direction(i: u32) -> [i32; 3] {
        [0, 1, 2].map(|axis| random::below(65_537, 5, 3 * i + axis) as i32 - 32_768)
    }

    #[test]
    fn latitude_and_longitude_are_the_angles() {
        let (width, height) = (1024, 512);
        let shape = Shape::LatitudeLongitude { width, height };
        for d in (0..20_000).map(direction) {
            let [x, y, z] = d.map(f64::from);
            let row = libm::atan2((x * x + y * y).sqrt(), z) / PI * f64::from(height);
            let column = (libm::atan2(y, x) / (2.0 * PI)).rem_euclid(1.0) * f64::from(width);
            let texel = texel_of(shape, d);
            // The radius is rounded to a unit, which turns short vectors.
            let near = (x * x + y * y + z * z).sqrt() > 3000.0;
            let off = |value: f64, found: u32| (value - f64::from(found) - 0.5).abs();
            assert!(!near || off(row, texel / width) < 0.58, "{d:?}: row {row}");
            assert!(!near || off(column, texel % width) < 0.501, "{d:?}: column {column}");
        }
        let at = |d| (texel_of(shape, d) / width, texel_of(shape, d) % width);
        assert_eq!((at([0, 0, 9]), at([0, 0, -9])), ((0, 0), (height - 1, 0)));
        assert_eq!((at([9, 0, 0]), at([0, -9, 0])), ((height / 2, 0), (height / 2, 3 * width / 4)));
    }

    #[test]
    fn faces_of_the_cube_meet_at_their_edges() {
        let shape = Shape::Cube { side: 8 };
        let place = |d| (texel_of(shape, d) / 64, texel_of(shape, d) / 8 % 8, texel_of(shape, d) % 8);
        assert_eq!(place([5, 0, 0]), (0, 4, 4));
        assert_eq!(place([5, 4, 4]), (0, 0, 0), "+x: t falls with y, s with z");
        assert_eq!(place([-5, 4, 4]), (1, 0, 7));
        assert_eq!(place([0, 5, -4]), (2, 0, 4));
        assert_eq!(place([0, -5, -4]), (3, 7, 4));
        assert_eq!(place([4, 4, 5]), (4, 0, 7));
        assert_eq!(place([4, 4, -5]), (5, 0, 0));
        assert!((0..5000).map(direction).all(|d| texel_of(shape, d) < 6 * 64));
    }

    #[test]
    fn a_white_sky_over_everything_is_one() {
        // Over all directions of level 4 with their solid angles, 4 times the mean of the positive cosines is 1.
        let weights = crate::light_sphere::weights(4);
        let lights = crate::light_sphere::oracle::octahedron(4);
        let normal = [11_585, 20_000, 23_200];
        let sum: f64 = (lights.iter().zip(&weights))
            .map(|((d, _), &w)| {
                let unit = crate::exact::oracle::angle::normalize3_q15(*d);
                f64::from(entry(normal, unit, false)) / 32_768.0 * f64::from(w) / 4_294_967_296.0
            })
            .sum();
        let length = normal.iter().map(|&c| f64::from(c) * f64::from(c)).sum::<f64>().sqrt() / 32_768.0;
        assert!((4.0 * sum / length - 1.0).abs() < 2e-3, "{}", 4.0 * sum / length);
    }

    #[test]
    fn a_blur_keeps_what_is_constant() {
        let texels = vec![[7, 1 << 20, u32::MAX, 0]; 12];
        for along_columns in [false, true] {
            assert_eq!(blurred(4, &texels, &[1 << 14, 1 << 15, 1 << 14], along_columns), texels);
        }
        let one = [[0; 4], [4, 0, 0, 0], [0; 4], [0; 4]];
        let reds = |width, along| {
            blurred(width, &one, &[1 << 14, 1 << 15, 1 << 14], along).iter().map(|t| t[0]).collect::<Vec<_>>()
        };
        assert_eq!(reds(4, false), [1, 2, 1, 0]);
        assert_eq!(reds(1, true), [1, 2, 1, 0]);
    }
}

//! Solid angles of the octahedron's directions: lattice points are denser around the face centres' rims than at the
//! corners, so a sum over directions becomes an integral over the sphere only with weights.
//!
//! A direction's weight is a third of the spherical triangles of the level's mesh around it (Van Oosterom and Strackee,
//! "The Solid Angle of a Plane Triangle", 1983), as a fraction of the sphere in units of 2^-32. It is computed for one
//! of the up to 48 directions that the octahedron's symmetries exchange, in f64 and the pinned `libm`, so that equal
//! directions have equal weights on every host. Weights belong to a level: a finer one divides the sphere anew.

use std::f64::consts::PI;

use super::oracle::Direction;

/// Weights of all `2 + 4^(level + 1)` directions of a level, in their order; they sum to 2^32 but for rounding, half a
/// unit a direction.
///
/// # Panics
///
/// Where the level is above [`super::MAX_LEVEL`].
pub fn weights(level: u32) -> Vec<u32> {
    let n = 1 << level;
    super::directions(level).into_iter().map(|[x, y, z, scale]| weight([x, y, z].map(|c| c * (n / scale)), n)).collect()
}

/// The weight of a lattice point with |x| + |y| + |z| = n.
fn weight(point: Direction, n: i32) -> u32 {
    let mut point = point.map(i32::abs);
    point.sort_unstable();
    let share = faces_around(point, n).into_iter().map(|[a, b, c]| solid_angle(a, b, c) / 3.0).sum::<f64>();
    libm::rint(share / (4.0 * PI) * 4_294_967_296.0).min(f64::from(u32::MAX)) as u32
}

/// The triangles of the level's mesh that have `point` as a corner.
fn faces_around(point: Direction, n: i32) -> Vec<[Direction; 3]> {
    let near = [-1, 0, 1];
    let on = |p: &Direction| p.iter().map(|c| c.abs()).sum::<i32>() == n;
    let mut neighbours = Vec::new();
    for x in near {
        for y in near {
            neighbours.extend(near.map(|z| [point[0] + x, point[1] + y, point[2] + z]).into_iter().filter(on));
        }
    }
    neighbours.retain(|p| is_edge(point, *p));
    let mut faces = Vec::new();
    for (i, &b) in neighbours.iter().enumerate() {
        for &c in neighbours[i + 1..].iter().filter(|&&c| is_edge(b, c) && in_one_octant([point, b, c])) {
            faces.push([point, b, c]);
        }
    }
    faces
}

/// Whether two lattice points are one edge apart on a face: one coordinate steps up and another one down.
fn is_edge(a: Direction, b: Direction) -> bool {
    in_one_octant([a, b, b]) && (0..3).map(|i| (a[i].abs() - b[i].abs()).abs()).sum::<i32>() == 2
}

fn in_one_octant(points: [Direction; 3]) -> bool {
    (0..3).all(|axis| points.iter().all(|p| p[axis] >= 0) || points.iter().all(|p| p[axis] <= 0))
}

/// tan(Ω / 2) = |a · (b × c)| / (|a||b||c| + (a · b)|c| + (b · c)|a| + (c · a)|b|).
fn solid_angle(a: Direction, b: Direction, c: Direction) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| p.map(f64::from));
    let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let length = |p: [f64; 3]| dot(p, p).sqrt();
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    let below =
        length(a) * length(b) * length(c) + dot(a, b) * length(c) + dot(b, c) * length(a) + dot(c, a) * length(b);
    2.0 * libm::atan2(dot(a, cross).abs(), below)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_six_corners_share_the_sphere() {
        assert_eq!(weights(0), [715_827_883; 6]);
    }

    #[test]
    fn weights_sum_to_the_sphere_and_integrate_squares() {
        for level in 0..=super::super::MAX_LEVEL {
            let weights = weights(level);
            let sum: u64 = weights.iter().map(|&w| u64::from(w)).sum();
            assert!(sum.abs_diff(1 << 32) <= weights.len() as u64 / 2, "level {level}: {sum}");
            if level >= 3 {
                // The integral of x⁴ is a fifth of the sphere.
                let fourth = |&[x, y, z, _]: &[i32; 4]| {
                    let [x, y, z] = [x, y, z].map(f64::from);
                    (x * x / (x * x + y * y + z * z)) * (x * x / (x * x + y * y + z * z))
                };
                let terms = super::super::directions(level);
                let mean: f64 = terms.iter().zip(&weights).map(|(d, &w)| fourth(d) * f64::from(w)).sum();
                let error = (mean / 4_294_967_296.0 - 0.2).abs();
                assert!(error < 2.0 / f64::from(1 << (2 * level)), "level {level}: {error}");
            }
        }
    }

    #[test]
    fn symmetric_directions_weigh_the_same() {
        let (weights, all) = (weights(4), super::super::directions(4));
        let key = |d: &[i32; 4]| {
            let mut key = [d[0], d[1], d[2]].map(|c| c.abs() * (16 / d[3]));
            key.sort_unstable();
            key
        };
        let mut seen = std::collections::HashMap::new();
        for (d, w) in all.iter().zip(&weights) {
            assert_eq!(seen.entry(key(d)).or_insert(w), &w, "{d:?}");
        }
        let (least, most) = (weights.iter().min(), weights.iter().max());
        assert!(most > least, "directions of the lattice are not of equal area");
    }
}

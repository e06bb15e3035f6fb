//! The definition: every lattice point of the octahedron, sorted as the numbering says; and a rotation in wide
//! integers.

use crate::exact::oracle::angle::normalize3_q15;

/// A direction.
pub type Direction = [i32; 3];

/// Lattice points with |x| + |y| + |z| = n.
fn lattice(n: i32) -> Vec<Direction> {
    let within = |x: i32, y: i32| (x.abs() + y.abs() <= n).then_some(n - x.abs() - y.abs());
    let mut points = Vec::new();
    for x in -n..=n {
        for y in -n..=n {
            if let Some(z) = within(x, y) {
                points.push([x, y, z]);
                if z > 0 {
                    points.push([x, y, -z]);
                }
            }
        }
    }
    points
}

/// First directions of the pairs that level `s` adds, in order.
fn added(s: u32) -> Vec<Direction> {
    if s == 0 {
        return vec![[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    }
    let even_axis = |p: &Direction| (0..3).find(|&axis| p[axis] % 2 == 0).unwrap_or(0);
    let parts = |p: &Direction| {
        let e = even_axis(p);
        (e, p[e], p[(e + 1) % 3], p[(e + 2) % 3])
    };
    let mut points = lattice(1 << s);
    points.retain(|p| p.iter().any(|c| c % 2 != 0) && parts(p).2 > 0);
    points.sort_by_key(|p| {
        let (axis, e, _, b) = parts(p);
        (axis, b + e, b - e)
    });
    points
}

/// All directions up to level `s`, each with its level's 2^s.
pub fn octahedron(s: u32) -> Vec<(Direction, i32)> {
    let both = |d: Direction| [d, d.map(|c| -c)];
    (0..=s).flat_map(|s| added(s).into_iter().flat_map(both).map(move |d| (d, 1 << s))).collect()
}

/// `direction` at length 2^15, rounded towards 0, turned by rows in units of 2^-14 and rounded down.
pub fn turned(direction: Direction, rows: [[i32; 3]; 3]) -> Direction {
    let unit = normalize3_q15(direction);
    rows.map(|row| {
        let sum: i64 = row.iter().zip(unit).map(|(&r, u)| i64::from(r) * i64::from(u)).sum();
        (sum >> 14) as i32
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    /// Midpoint subdivision of the octahedron's faces as the paper draws it, in units of 2^-s.
    fn subdivided(s: u32) -> HashSet<Direction> {
        let n = 1 << s;
        let signs = [-n, n];
        let mut faces: Vec<[Direction; 3]> = Vec::new();
        for x in signs {
            for y in signs {
                faces.extend(signs.map(|z| [[x, 0, 0], [0, y, 0], [0, 0, z]]));
            }
        }
        for _ in 0..s {
            let middle = |a: Direction, b: Direction| [0, 1, 2].map(|i| (a[i] + b[i]) / 2);
            let cut = |[a, b, c]: [Direction; 3]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            };
            faces = faces.into_iter().flat_map(cut).collect();
        }
        assert_eq!(faces.len(), 2 << (2 * (s + 1)), "faces of level {s}");
        faces.into_iter().flatten().collect()
    }

    #[test]
    fn levels_are_the_vertices_of_the_subdivided_octahedron() {
        for (s, count) in [6, 18, 66, 258, 1026, 4098, 16_386].into_iter().enumerate() {
            let s = s as u32;
            let directions = octahedron(s);
            let scaled: HashSet<Direction> = directions.iter().map(|(d, n)| d.map(|c| c * ((1 << s) / n))).collect();
            assert_eq!((directions.len(), scaled.len()), (count, count), "level {s}");
            assert_eq!(scaled, subdivided(s), "level {s}");
        }
    }

    /// Largest angle in degrees between a lattice direction and the same vertex where, as the paper has it, every
    /// midpoint is projected to the sphere before the next subdivision.
    fn departure(s: u32) -> f64 {
        type Vertex = (Direction, [f64; 3]);
        let unit = |v: [f64; 3]| {
            let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
            v.map(|c| c / length)
        };
        let middle = |a: Vertex, b: Vertex| -> Vertex {
            ([0, 1, 2].map(|i| (a.0[i] + b.0[i]) / 2), unit([0, 1, 2].map(|i| a.1[i] + b.1[i])))
        };
        let n = 1 << s;
        let corner =
            |axis: usize| ([0, 1, 2].map(|i| n * i32::from(i == axis)), [0, 1, 2].map(|i| f64::from(i == axis)));
        let mut faces: Vec<[Vertex; 3]> = vec![[corner(0), corner(1), corner(2)]];
        for _ in 0..s {
            let cut = |[a, b, c]: [Vertex; 3]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            };
            faces = faces.into_iter().flat_map(cut).collect();
        }
        let angle = |(flat, round): Vertex| {
            let flat = unit(flat.map(f64::from));
            let cosine = [0, 1, 2].map(|i| flat[i] * round[i]).iter().sum::<f64>();
            libm::acos(cosine.min(1.0)).to_degrees()
        };
        faces.into_iter().flatten().map(angle).fold(0.0, f64::max)
    }

    #[test]
    fn flat_subdivision_stays_near_the_papers() {
        let departures = [1, 2, 3, 4, 5, 6].map(departure);
        assert!(departures[0] < 1e-5 && departures.is_sorted(), "{departures:?}");
        assert!(departures[1] > 4.0 && departures[5] < 4.1, "{departures:?}");
    }

    #[test]
    fn a_level_is_a_prefix_of_the_next_and_pairs_are_opposite() {
        let all = octahedron(6);
        for s in 0..6 {
            let level = octahedron(s);
            assert_eq!(level, all[..level.len()], "level {s}");
        }
        assert!(all.chunks(2).all(|pair| pair[0].0 == pair[1].0.map(|c| -c)));
    }

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let rows = [[0, -(1 << 14), 0], [1 << 14, 0, 0], [0, 0, 1 << 14]];
        assert_eq!(turned([7, 0, 0], rows), [0, 1 << 15, 0]);
        assert_eq!(turned([0, 5, 0], rows), [-(1 << 15), 0, 0]);
        assert_eq!(turned([1, 1, 1], rows), [-18_918, 18_918, 18_918]);
    }
}

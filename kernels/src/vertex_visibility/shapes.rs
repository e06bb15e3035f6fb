//! Closed meshes to test and measure with: an octahedron's lattice, blown up to any radius.

use std::collections::HashMap;

use super::mesh::Mesh;
use super::oracle::Point;
use crate::grid::XY;

/// A closed mesh of `4 n² + 2` vertices and `8 n²` triangles: the lattice |x| + |y| + |z| = n, each point at `radius`
/// of its unit vector from the centre, rounded to the grid. Radii are below 2^14.
///
/// # Panics
///
/// Where `n` is 0 or a radius leaves the grid.
pub fn octasphere(n: i32, radius: impl Fn([f64; 3]) -> f64) -> Mesh {
    let mut vertices = Vec::new();
    let mut number: HashMap<Point, u32> = HashMap::new();
    let mut triangles = Vec::new();
    let mut vertex = |p: Point| {
        *number.entry(p).or_insert_with(|| {
            let d = p.map(f64::from);
            let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            let unit = d.map(|c| c / length);
            let r = radius(unit);
            let point = unit.map(|c| libm::rint(c * r) as i32);
            assert!(point.iter().all(|c| (-XY..XY).contains(c)), "radius {r} leaves the grid");
            vertices.push(point);
            vertices.len() as u32 - 1
        })
    };
    for octant in 0..8_u32 {
        let sign = [0, 1, 2].map(|axis| 1 - 2 * (octant >> axis & 1) as i32);
        let mut at = |x: i32, y: i32| vertex([x * sign[0], y * sign[1], (n - x - y) * sign[2]]);
        let mirrored = sign[0] * sign[1] * sign[2] < 0;
        let mut face = |[a, b, c]: [u32; 3]| triangles.push(if mirrored { [a, c, b] } else { [a, b, c] });
        for x in 0..n {
            for y in 0..n - x {
                face([at(x, y), at(x + 1, y), at(x, y + 1)]);
                if x + y < n - 1 {
                    face([at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
                }
            }
        }
    }
    Mesh { vertices, triangles }
}

/// An [`octasphere`] with bumps deep enough to hide one another.
///
/// # Panics
///
/// Where `n` is 0.
pub fn bumpy(n: i32) -> Mesh {
    octasphere(n, |[x, y, z]| {
        let waves = libm::sin(9.0 * x + 2.0 * y) + libm::sin(8.0 * y - 3.0 * z) + libm::sin(7.0 * z + 4.0 * x);
        11_000.0 + 1500.0 * waves
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_closed_and_faces_outwards() {
        for n in 1..=6 {
            let mesh = octasphere(n, |_| 10_000.0);
            assert_eq!(mesh.vertices.len() as i32, 4 * n * n + 2);
            assert_eq!(mesh.triangles.len() as i32, 8 * n * n);
            let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
            for [a, b, c] in &mesh.triangles {
                for edge in [(*a, *b), (*b, *c), (*c, *a)] {
                    *edges.entry(edge).or_default() += 1;
                }
                let [p, q, r] = [a, b, c].map(|&v| mesh.vertices[v as usize].map(i64::from));
                let normal = [0, 1, 2].map(|i: usize| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    (q[j] - p[j]) * (r[k] - p[k]) - (q[k] - p[k]) * (r[j] - p[j])
                });
                assert!((0..3).map(|i| normal[i] * p[i]).sum::<i64>() > 0, "n {n}: {p:?}, {q:?}, {r:?}");
            }
            assert!(edges.iter().all(|(&(a, b), &count)| count == 1 && edges.contains_key(&(b, a))), "n {n}");
        }
    }
}

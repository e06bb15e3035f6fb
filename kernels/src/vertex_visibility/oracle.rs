//! The definition: what it means that a triangle occludes a vertex towards a direction.
//!
//! Vertices are integer points with x, y and z in [−2^14, 2^14), directions are integer vectors. **Vertex V is occluded
//! towards direction d by triangle T iff T has no corner at V and the line V + t d meets T beyond the bias**:
//!
//! * it meets T if V, moved by (ε, ε², ε³) for an infinitesimal ε, is strictly on the same side of the three planes
//!   through d and an edge of T. So a vertex on the plane of an edge belongs to one side of it only, and the triangles
//!   of a closed mesh leave no gap and cover no vertex twice. A triangle that is seen edge-on, or has no area, is never
//!   met;
//! * the meeting point is more than `bias` cells from V along the axis on which d is longest: t max|d_i| > bias, told
//!   for V itself.
//!
//! Everything here is the determinants of those statements in i128, for every triangle in turn.

use super::Mesh;
use crate::light_sphere::oracle::Direction;

/// An integer point.
pub type Point = [i32; 3];

type Wide = [i128; 3];

fn minus(a: Point, b: Point) -> Wide {
    std::array::from_fn(|i| i128::from(a[i]) - i128::from(b[i]))
}

fn cross(a: Wide, b: Wide) -> Wide {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: Wide, b: Wide) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Sign of det(d, p − V′, q − V′) for V′ = V + (ε, ε², ε³): a polynomial in ε, whose first coefficient that is not 0
/// decides.
fn side(v: Point, d: Wide, p: Point, q: Point) -> i128 {
    let constant = dot(d, cross(minus(p, v), minus(q, v)));
    let [x, y, z] = cross(d, minus(q, p));
    [constant, x, y, z].into_iter().find(|&coefficient| coefficient != 0).unwrap_or(0).signum()
}

/// Whether `triangle` occludes the vertex `v` towards `direction`.
pub fn occludes(v: Point, direction: Direction, [a, b, c]: [Point; 3], bias: u32) -> bool {
    let d = direction.map(i128::from);
    let first = side(v, d, a, b);
    if [a, b, c].contains(&v) || first == 0 || side(v, d, b, c) != first || side(v, d, c, a) != first {
        return false;
    }
    // t = n · (a − V) / n · d.
    let normal = cross(minus(b, a), minus(c, a));
    let (above, below) = (dot(normal, minus(a, v)), dot(normal, d));
    let longest = d.into_iter().map(i128::abs).max().unwrap_or(0);
    above * below.signum() * longest > i128::from(bias) * below.abs()
}

/// Whether anything occludes a vertex of `mesh` towards `direction`.
pub fn is_occluded(mesh: &Mesh, vertex: u32, direction: Direction, bias: u32) -> bool {
    let v = mesh.vertices[vertex as usize];
    let corners = |t: &[u32; 3]| t.map(|corner| mesh.vertices[corner as usize]);
    mesh.triangles.iter().any(|t| occludes(v, direction, corners(t), bias))
}

/// Bits of one vertex for up to 32 directions, the first one lowest.
pub fn word(mesh: &Mesh, vertex: u32, directions: &[Direction], bias: u32) -> u32 {
    let bit = |(place, &d): (usize, &Direction)| u32::from(is_occluded(mesh, vertex, d, bias)) << place;
    directions.iter().enumerate().map(bit).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Direction = [0, 0, 1];

    #[test]
    fn what_is_ahead_and_beyond_the_bias_occludes() {
        let at = |z: i32| [[-10, -10, z], [10, -10, z], [0, 10, z]];
        let v = [0, 0, 100];
        for (z, bias, expected) in [(101, 0, true), (101, 1, false), (102, 1, true), (100, 0, false), (90, 0, false)] {
            assert_eq!(occludes(v, UP, at(z), bias), expected, "z {z}, bias {bias}");
            let [a, b, c] = at(z);
            assert_eq!(occludes(v, [0, 0, 7], [a, c, b], bias), expected, "either side, any length: z {z}");
        }
        assert!(!occludes([20, 0, 0], UP, at(101), 0), "beside it");
        assert!(occludes(v, [0, 0, -1], at(90), 9) && !occludes(v, [0, 0, -1], at(90), 10));
    }

    #[test]
    fn neither_corners_nor_edge_on_triangles_occlude() {
        let v = [3, 4, 5];
        assert!(!occludes(v, UP, [v, [10, 4, 50], [3, 10, 60]], 0), "a corner");
        assert!(!occludes(v, UP, [[3, 4, 10], [3, 4, 20], [9, 4, 15]], 0), "edge-on");
        assert!(!occludes(v, UP, [[3, 4, 10], [3, 4, 10], [9, 9, 15]], 0), "no area");
    }

    #[test]
    fn a_fan_covers_its_centre_and_its_edges_once() {
        // Eight triangles around an apex; vertices under the apex, under edges and inside.
        let rim = [[8, 0], [8, 8], [0, 8], [-8, 8], [-8, 0], [-8, -8], [0, -8], [8, -8]];
        let fan: Vec<[Point; 3]> = (0..8)
            .map(|i| (rim[i], rim[(i + 1) % 8]))
            .map(|(p, q)| [[0, 0, 40], [p[0], p[1], 30], [q[0], q[1], 30]])
            .collect();
        for x in -8..=8 {
            for y in -8..=8 {
                let hits = fan.iter().filter(|t| occludes([x, y, 0], UP, **t, 0)).count();
                // The outer rim belongs to the fan on one side only.
                let inside = (-8..8).contains(&x) && (-8..8).contains(&y);
                assert_eq!(hits, usize::from(inside), "({x}, {y})");
            }
        }
    }
}

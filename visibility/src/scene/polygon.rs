//! Polygons into triangles, by cutting ears; convex ones become fans around their first corner.
//!
//! A polygon of n ≥ 3 corners always gives n − 2 triangles over those corners, so nothing is lost or invented; where it
//! is not simple (crossing or collapsed), the rest becomes a fan.

use crate::error::{Place, Result};
use crate::vector::{Vector, add, cross, sub};

/// Most corners of a polygon that is not convex.
const MAX_CONCAVE: usize = 1024;

/// Appends the triangles of the polygon `corners`, whose indices are in range of `vertices`.
pub(super) fn triangulate(
    place: impl Fn() -> Place,
    vertices: &[Vector],
    corners: &[u32],
    out: &mut Vec<[u32; 3]>,
) -> Result<()> {
    match *corners {
        [] | [_] | [_, _] => return Ok(()),
        [a, b, c] => {
            out.push([a, b, c]);
            return Ok(());
        }
        _ => {}
    }
    let points = project(vertices, corners);
    let mut left: Vec<usize> = (0..corners.len()).collect();
    if !is_convex(&points) {
        super::limit(place(), "corners of a polygon that is not convex", corners.len(), MAX_CONCAVE)?;
        while let Some(ear) = find_ear(&points, &left) {
            let (before, after) = neighbours(&left, ear);
            out.push([corners[before], corners[left[ear]], corners[after]]);
            left.remove(ear);
        }
    }
    for pair in left[1..].windows(2) {
        out.push([corners[left[0]], corners[pair[0]], corners[pair[1]]]);
    }
    Ok(())
}

/// The polygon in the coordinate plane that it faces most, counter-clockwise.
fn project(vertices: &[Vector], corners: &[u32]) -> Vec<[f64; 2]> {
    let at = |k: usize| sub(vertices[corners[k] as usize], vertices[corners[0] as usize]);
    let n = (1..corners.len() - 1).fold([0.0; 3], |n, k| add(n, cross(at(k), at(k + 1))));
    let [x, y, z] = n.map(f64::abs);
    let axis = if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    };
    let (s, t) = ((axis + 1) % 3, (axis + 2) % 3);
    let (s, t) = if n[axis] < 0.0 { (t, s) } else { (s, t) };
    (0..corners.len()).map(|k| [at(k)[s], at(k)[t]]).collect()
}

/// Twice the signed area.
fn area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether the fan around the first corner covers the polygon once: it never turns back, and turns around only once.
fn is_convex(points: &[[f64; 2]]) -> bool {
    let n = points.len();
    let turns = (0..n).all(|i| area(points[i], points[(i + 1) % n], points[(i + 2) % n]) >= 0.0);
    turns && (1..n - 1).all(|i| area(points[0], points[i], points[i + 1]) >= 0.0)
}

fn neighbours(left: &[usize], i: usize) -> (usize, usize) {
    (left[(i + left.len() - 1) % left.len()], left[(i + 1) % left.len()])
}

/// A convex corner whose triangle holds no other; none where three corners are left, or where the polygon is not
/// simple.
fn find_ear(points: &[[f64; 2]], left: &[usize]) -> Option<usize> {
    (0..left.len()).filter(|_| left.len() > 3).find(|&i| {
        let (before, after) = neighbours(left, i);
        let [a, b, c] = [before, left[i], after].map(|k| points[k]);
        let inside = |p: [f64; 2]| area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0;
        let other = |p: [f64; 2]| p != a && p != b && p != c;
        area(a, b, c) > 0.0 && !left.iter().any(|&k| other(points[k]) && inside(points[k]))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(vertices: &[Vector]) -> Vec<[u32; 3]> {
        let corners: Vec<u32> = (0..vertices.len() as u32).collect();
        let mut out = Vec::new();
        triangulate(Place::default, vertices, &corners, &mut out).unwrap();
        out
    }

    fn areas(vertices: &[Vector], triangles: &[[u32; 3]]) -> Vec<f64> {
        let flat = |i: u32| [vertices[i as usize][0], vertices[i as usize][1]];
        triangles.iter().map(|t| area(flat(t[0]), flat(t[1]), flat(t[2]))).collect()
    }

    #[test]
    fn a_convex_polygon_is_a_fan() {
        let square = [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [1.0, 1.0, 5.0], [0.0, 1.0, 5.0]];
        assert_eq!(cut(&square), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn a_concave_polygon_is_covered_once_whichever_corner_is_first_and_whichever_way_it_turns() {
        let arrow = [[0.0, 0.0, 0.0], [2.0, 1.0, 0.0], [4.0, 0.0, 0.0], [2.0, 5.0, 0.0]];
        for turn in 0..4 {
            let mut vertices = arrow;
            vertices.rotate_left(turn);
            let parts = areas(&vertices, &cut(&vertices));
            assert_eq!((parts.len(), parts.iter().sum::<f64>()), (2, 16.0));
            assert!(parts.iter().all(|&a| a > 0.0), "{turn}: {parts:?}");
            vertices.reverse();
            assert!(areas(&vertices, &cut(&vertices)).iter().all(|&a| a < 0.0), "reversed {turn}");
        }
    }

    #[test]
    fn a_comb_keeps_its_area() {
        let teeth = (0..40).flat_map(|i| [[f64::from(2 * i), 0.5, 0.0], [f64::from(2 * i + 1), 9.0, 0.0]]);
        let mut comb = vec![[79.0, -1.0, 0.0], [0.0, -1.0, 0.0]];
        comb.extend(teeth);
        let parts = areas(&comb, &cut(&comb));
        let outline: f64 = (1..comb.len() - 1).map(|i| areas(&comb, &[[0, i as u32, i as u32 + 1]])[0]).sum();
        assert_eq!(parts.len(), comb.len() - 2);
        assert!((parts.iter().sum::<f64>() - outline).abs() < 1e-9);
        assert!(parts.iter().all(|&a| a <= 0.0), "one orientation");
    }

    #[test]
    fn a_polygon_that_is_not_simple_still_gives_its_triangles() {
        let bow = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        assert_eq!(cut(&bow).len(), 2);
        assert_eq!(cut(&[[1.0, 2.0, 3.0]; 6]).len(), 4);
    }

    #[test]
    fn a_huge_concave_polygon_is_refused() {
        let mut star: Vec<Vector> = (0..1500).map(|i| [f64::from(i), f64::from(i % 2), 0.0]).collect();
        star.push([0.0, 9.0, 0.0]);
        let corners: Vec<u32> = (0..star.len() as u32).collect();
        let error = triangulate(Place::default, &star, &corners, &mut Vec::new()).unwrap_err();
        assert!(error.to_string().contains("1501 corners of a polygon"), "{error}");
    }
}

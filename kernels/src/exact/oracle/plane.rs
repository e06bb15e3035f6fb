//! Predicates of the plane in wide integers.

/// A point.
pub type Point = [i32; 2];

/// (b - a) x (c - a).
fn cross(a: Point, b: Point, c: Point) -> i128 {
    let d = |p: Point, axis: usize| i128::from(p[axis]) - i128::from(a[axis]);
    d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0)
}

/// 1 where a, b, c turn counter-clockwise, -1 where they turn clockwise, 0 where they are collinear.
pub fn orient2d(a: Point, b: Point, c: Point) -> i32 {
    cross(a, b, c).signum() as i32
}

/// The cross product, less 1 where points of the edge are not its own: an edge owns them that runs down, or level and
/// to the right.
pub fn edge15(a: Point, b: Point, p: Point) -> i32 {
    let owns = b[1] < a[1] || b[1] == a[1] && b[0] > a[0];
    (cross(a, b, p) - i128::from(!owns)) as i32
}

/// floor((w · z) / area).
pub fn depth_at(w: [u32; 3], z: [u32; 3], area: u32) -> u32 {
    let sum: u128 = w.iter().zip(z).map(|(w, z)| u128::from(*w) * u128::from(z)).sum();
    (sum / u128::from(area)) as u32
}

/// First and last column of z = hz that lines from [-s, s] through (v, vz) reach.
pub fn influence_1d(v: i32, vz: i32, hz: i32, s: i32, t: u32) -> [i32; 2] {
    // A line from (e, 0) through (v, vz) meets z = hz at (v hz - e (hz - vz)) / vz.
    let column = |e: i64| {
        let numerator = i64::from(v) * i64::from(hz) - e * i64::from(hz - vz);
        numerator.div_euclid(i64::from(vz) << t) as i32
    };
    [column(s.into()), column(-i64::from(s))]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_sides_and_columns() {
        assert_eq!(orient2d([0, 0], [1, 0], [0, 1]), 1);
        assert_eq!(orient2d([-(1 << 30), -(1 << 30)], [0, 0], [(1 << 30) - 1, (1 << 30) - 1]), 0);
        assert_eq!(depth_at([1, 1, 1], [3, 3, 4], 3), 3);
        // Through the middle of a light at half the height: the mirror image of the light.
        assert_eq!(influence_1d(0, 50, 100, 8, 0), [-8, 8]);
        assert_eq!(influence_1d(0, 50, 100, 8, 4), [-1, 0]);
    }

    #[test]
    fn two_triangles_share_a_square_without_hole_or_overlap() {
        let (a, b, c, d) = ([2, 3], [9, 5], [11, 12], [1, 10]);
        let inside = |t: [Point; 3], p| (0..3).all(|i| edge15(t[i], t[(i + 1) % 3], p) >= 0);
        let mut on_diagonal = 0;
        for p in (0..16).flat_map(|x| (0..16).map(move |y| [x, y])) {
            let (first, second) = (inside([a, b, c], p), inside([a, c, d], p));
            assert!(!(first && second), "{p:?} is in both");
            let strictly = [[a, b], [b, c], [c, d], [d, a]].iter().all(|[e, f]| orient2d(*e, *f, p) > 0);
            assert!(!strictly || first || second, "{p:?} is in neither");
            on_diagonal += i32::from(strictly && orient2d(a, c, p) == 0);
        }
        assert!(on_diagonal > 0);
    }
}

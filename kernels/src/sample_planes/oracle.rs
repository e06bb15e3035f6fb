//! The masks are those of [`crate::row_span`]'s definition; the additive counts are summed pair by pair.

use super::centre;
use crate::grid::{Point, Receivers, Samples, Triangle, hidden};

pub use crate::row_span::oracle::sets;

/// On which side of a triangle a point is: positive where it sees the triangle turn counter-clockwise.
fn side(point: Point, [a, b, c]: Triangle) -> i128 {
    let minus = |p: Point, q: Point| -> [i128; 3] { std::array::from_fn(|i| i128::from(p[i]) - i128::from(q[i])) };
    let (u, v, w) = (minus(b, a), minus(c, a), minus(point, a));
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    (0..3).map(|i| normal[i] * w[i]).sum()
}

/// What silhouette volumes seen from the light's centre add up to, for every receiver.
pub fn additive(samples: &Samples, receivers: &Receivers, triangles: &[Triangle]) -> Vec<i32> {
    let [x, y] = centre(samples);
    let facing: Vec<&Triangle> = triangles.iter().filter(|t| side([x, y, 0], **t) > 0).collect();
    let of = |receiver: u32| {
        let pairs = facing.iter().flat_map(|t| (0..samples.count()).map(move |sample| (*t, samples.at(sample))));
        let hides = pairs.filter(|(t, sample)| hidden(receivers.at(receiver), *sample, t));
        hides.map(|(t, sample)| if side(sample, *t) > 0 { 1 } else { -1 }).sum()
    };
    (0..receivers.count()).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::hidden_set;
    use crate::triangles::Family;

    const LIGHT: Samples = Samples { origin: [-1000, -900], step: [250, 560], columns: 8, rows: 4 };
    const FLOOR: Receivers =
        Receivers { origin: [-1500, -1100], step: [290, 370], height: 20_000, columns: 11, rows: 7 };

    /// A tetrahedron, each triangle counter-clockwise from outside.
    fn outwards(mesh: &[Triangle]) -> Vec<Triangle> {
        let points: Vec<Point> = mesh.iter().flatten().copied().collect();
        let turned = |&[a, b, c]: &Triangle| {
            let inside = points.iter().any(|p| side(*p, [a, b, c]) > 0);
            if inside { [a, c, b] } else { [a, b, c] }
        };
        mesh.iter().map(turned).collect()
    }

    #[test]
    fn one_convex_caster_is_counted_exactly() {
        for mesh in Family::Closed.triangles(24, &LIGHT, &FLOOR, 8).chunks(4) {
            let mesh = outwards(mesh);
            let counts = additive(&LIGHT, &FLOOR, &mesh);
            for receiver in 0..FLOOR.count() {
                let exact: u32 = hidden_set(FLOOR.at(receiver), &LIGHT, &mesh).iter().map(|w| w.count_ones()).sum();
                assert_eq!(counts[receiver as usize], exact as i32, "receiver {receiver}");
            }
        }
    }

    #[test]
    fn casters_behind_each_other_are_counted_twice() {
        let low = outwards(&Family::Closed.triangles(4, &LIGHT, &FLOOR, 8));
        let twice = [low.clone(), low.clone()].concat();
        let (one, two) = (additive(&LIGHT, &FLOOR, &low), additive(&LIGHT, &FLOOR, &twice));
        assert!(one.iter().zip(&two).all(|(one, two)| *two == 2 * one));
        assert!(two.iter().any(|count| *count > 0), "the caster casts a shadow");
    }
}

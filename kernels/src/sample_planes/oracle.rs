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

    const LIGHT: Samples = Samples { origin: [-1000, -900], step: [250, 560], columns: 8, rows: 4 };
    const FLOOR: Receivers =
        Receivers { origin: [-1500, -1100], step: [290, 370], height: 20_000, columns: 11, rows: 7 };

    /// A low pyramid that points at the light, counter-clockwise from outside: every sample sees its three sides alone.
    fn pyramid() -> [Triangle; 4] {
        let [a, b, c, top] = [[-3000, -3000, 12_000], [3000, -3000, 12_000], [0, 3000, 12_000], [0, -500, 11_900]];
        [[a, b, c], [top, b, a], [top, c, b], [top, a, c]]
    }

    #[test]
    fn one_caster_whose_silhouette_is_the_same_from_all_samples_is_counted_exactly() {
        let mesh = pyramid();
        let seen = |point: Point| mesh.map(|triangle| side(point, triangle) > 0);
        assert!((0..LIGHT.count()).all(|sample| seen(LIGHT.at(sample)) == [false, true, true, true]));
        let counts = additive(&LIGHT, &FLOOR, &mesh);
        let exact = |receiver: u32| hidden_set(FLOOR.at(receiver), &LIGHT, &mesh);
        let exact: Vec<i32> =
            (0..FLOOR.count()).map(|r| exact(r).iter().map(|word| word.count_ones() as i32).sum()).collect();
        assert_eq!(counts, exact);
        assert!(exact.iter().any(|count| (1..32).contains(count)), "there is a penumbra");
    }

    #[test]
    fn casters_behind_each_other_are_counted_twice() {
        let twice = [pyramid(), pyramid()].concat();
        let (one, two) = (additive(&LIGHT, &FLOOR, &pyramid()), additive(&LIGHT, &FLOOR, &twice));
        assert!(one.iter().zip(&two).all(|(one, two)| *two == 2 * one));
        assert!(two.iter().any(|count| *count > 0), "the caster casts a shadow");
    }
}

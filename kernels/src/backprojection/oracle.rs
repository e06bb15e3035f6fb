//! Backprojections from the grid's definition, in i128: a line is the function that a determinant is of its last point,
//! and its coefficients are what that function takes at three samples.

use crate::exact::oracle::line::{Line, half_plane};
use crate::grid::{Point, Triangle};

/// What a triangle hides from a receiver on the source plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Backprojection {
    /// Lines of the edges, positive inside.
    pub edges: [Line; 3],
    /// Line of the triangle's own plane, positive on the other side than the receiver.
    pub own: Line,
}

/// a, b and c of a linear function of the source plane.
fn line(value: impl Fn(Point) -> i128) -> Line {
    let c = value([0, 0, 0]);
    let narrow = |x: i128| i32::try_from(x).expect("|a|, |b| < 2^31");
    let wide = i64::try_from(c).expect("|c| < 2^48");
    assert!(wide.abs() < 1 << 48, "|c| < 2^48");
    Line { a: narrow(value([1, 0, 0]) - c), b: narrow(value([0, 1, 0]) - c), c: wide }
}

/// The determinant of three points seen from a fourth.
fn determinant(from: Point, points: [Point; 3]) -> i128 {
    let [d, e, f] = points.map(|p| [0, 1, 2].map(|axis| i128::from(p[axis]) - i128::from(from[axis])));
    d[0] * (e[1] * f[2] - e[2] * f[1]) + d[1] * (e[2] * f[0] - e[0] * f[2]) + d[2] * (e[0] * f[1] - e[1] * f[0])
}

/// The lines of a pair, or none where the triangle's plane holds the receiver.
pub fn backproject(receiver: Point, triangle: &Triangle) -> Option<Backprojection> {
    let [a, mut b, mut c] = *triangle;
    let orientation = determinant(receiver, [a, b, c]);
    if orientation == 0 {
        return None;
    }
    if orientation < 0 {
        (b, c) = (c, b);
    }
    let edge = |p, q| line(|sample| determinant(receiver, [p, q, sample]));
    Some(Backprojection {
        edges: [edge(a, b), edge(b, c), edge(c, a)],
        // A sample beyond the triangle sees it in the other order than the receiver does.
        own: line(|sample| -determinant(sample, [a, b, c])),
    })
}

impl Backprojection {
    /// Whether a sample lies in all of the half-planes.
    pub fn hides(&self, [u, v, _]: Point) -> bool {
        let Line { a, b, c } = self.own;
        let beyond = i128::from(a) * i128::from(u) + i128::from(b) * i128::from(v) + i128::from(c) > 0;
        beyond && self.edges.iter().all(|line| half_plane(*line, u, v))
    }
}

/// Sixteen words of a pair, as the kernel writes them.
pub fn words(receiver: Point, triangle: &Triangle) -> [u32; 16] {
    let empty = Line { a: 0, b: 0, c: -1 };
    let lines = backproject(receiver, triangle).map_or([empty; 4], |found| {
        let [first, second, third] = found.edges;
        [first, second, third, found.own]
    });
    let four = lines.map(|line| [line.a as u32, line.b as u32, line.c as u32, (line.c >> 32) as u32]);
    std::array::from_fn(|word| four[word / 4][word % 4])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Receivers, Samples, hidden};
    use crate::triangles::{Family, crossing, levels};

    #[test]
    fn the_half_planes_together_are_the_definition() {
        let samples = Samples { origin: [-1000, -900], step: [63, 58], columns: 32, rows: 32 };
        let receivers = Receivers { origin: [-1500, -1100], step: [290, 370], height: 20_000, columns: 11, rows: 7 };
        let mut triangles = levels(receivers.height);
        triangles.extend(crossing(40, &samples, &receivers));
        triangles.extend(Family::ALL.iter().flat_map(|f| f.triangles(20, &samples, &receivers, 1)));
        let mut bits = [0, 0];
        for triangle in &triangles {
            for receiver in (0..receivers.count()).step_by(5).map(|r| receivers.at(r)) {
                let found = backproject(receiver, triangle);
                for sample in (0..samples.count()).step_by(7).map(|s| samples.at(s)) {
                    let is_hidden = hidden(receiver, sample, triangle);
                    assert_eq!(
                        found.is_some_and(|f| f.hides(sample)),
                        is_hidden,
                        "{receiver:?} {sample:?} {triangle:?}"
                    );
                    bits[usize::from(is_hidden)] += 1;
                }
            }
        }
        assert!(bits.iter().all(|n| *n > 10_000), "{bits:?}");
    }

    #[test]
    fn the_backprojection_of_a_half_way_square_is_twice_as_large() {
        let found = backproject([0, 0, 100], &[[10, -10, 50], [10, 10, 50], [-10, 10, 50]]).expect("it is seen");
        assert!(found.hides([19, 0, 0]) && !found.hides([21, 0, 0]) && !found.hides([-10, -15, 0]));
        assert_eq!(backproject([0, 0, 100], &[[1, 0, 50], [2, 0, 40], [3, 0, 50]]), None, "edge-on");
    }
}

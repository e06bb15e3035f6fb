//! The region of a triangle from the projections of its vertices, as fractions in i128: a column belongs to it iff it
//! lies between the least and the greatest.

use crate::grid::{Faces, Lattice, Point, Receivers, Samples, Triangle, cross, dot, is_front, minus};

/// (first column, last column, first row, last row), as the kernel writes them.
pub fn region(triangle: &Triangle, samples: &Samples, receivers: &Receivers) -> [i32; 4] {
    region_by(Faces::Both, triangle, samples, receivers)
}

/// The same of a triangle that hides by `faces`: projected from the samples that see them.
pub fn region_by(faces: Faces, triangle: &Triangle, samples: &Samples, receivers: &Receivers) -> [i32; 4] {
    let z = triangle.map(|v| v[2]);
    if z.iter().all(|z| *z <= 0) || z.iter().all(|z| *z >= receivers.height) {
        return [0, -1, 0, -1];
    }
    let (columns, rows) = (receivers.columns as i32, receivers.rows as i32);
    if z.iter().any(|z| *z <= 0) {
        return [0, columns - 1, 0, rows - 1];
    }
    let seen = (0..samples.count()).map(|s| samples.at(s)).filter(|s| faces == Faces::Both || is_front(*s, triangle));
    let seen: Vec<Point> = seen.collect();
    if seen.is_empty() {
        return [0, -1, 0, -1];
    }
    let [x0, x1] = span(triangle, &seen, receivers, 0, columns);
    let [y0, y1] = span(triangle, &seen, receivers, 1, rows);
    [x0, x1, y0, y1]
}

/// First and last index along one axis, unclamped bounds outside `0..count` brought to where the kernel clamps them.
fn span(triangle: &Triangle, samples: &[Point], receivers: &Receivers, axis: usize, count: i32) -> [i32; 2] {
    // A projection is the farther aside the farther aside the sample is.
    let along = || samples.iter().map(|sample| sample[axis]);
    let ends = [along().fold(i32::MAX, i32::min), along().fold(i32::MIN, i32::max)];
    let height = i128::from(receivers.height);
    let mut points = Vec::new();
    for vertex in triangle {
        for s in ends {
            let (v, z) = (i128::from(vertex[axis]), i128::from(vertex[2]));
            points.push((v * height - i128::from(s) * (height - z), z));
        }
    }
    let at = |index: i64| i128::from(receivers.origin[axis]) + i128::from(receivers.step[axis]) * i128::from(index);
    let reaches = |index: i64| points.iter().any(|(n, d)| at(index) * d <= *n);
    let reached = |index: i64| points.iter().any(|(n, d)| *n <= at(index) * d);
    // Both tests are monotone, so the ends can be searched for far outside the receivers.
    let far = 1i64 << 40;
    let last = partition(-far, far, reaches) - 1;
    let first = partition(-far, far, |index| !reached(index));
    [first.clamp(0, i64::from(i32::MAX)) as i32, last.clamp(i64::from(i32::MIN), i64::from(count - 1)) as i32]
}

/// First index in `low..high` for which `holds` is false, where it is true before and false after.
fn partition(mut low: i64, mut high: i64, holds: impl Fn(i64) -> bool) -> i64 {
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}

/// (first column, last column, first row, last row) on a lattice, as the kernel of any plane writes them.
pub fn tilted(triangle: &Triangle, samples: &Samples, receivers: &Lattice) -> [i32; 4] {
    let normal = receivers.normal().map(i128::from);
    let height = |p: Point| dot(normal, minus(p, receivers.origin));
    let towards = -height(samples.at(0)).signum();
    let (columns, rows) = (receivers.columns as i32, receivers.rows as i32);
    let mut points = Vec::new();
    for vertex in triangle {
        for corner in samples.corners() {
            let (near, far) = (towards * height(*vertex), towards * height(corner));
            // The line meets the plane beyond the vertex, if that is nearer to it: at (near s - far v) / (near - far).
            if near > far {
                points.push((project(*vertex, corner, near, far, receivers), near - far));
            }
        }
    }
    let hides = triangle.iter().any(|v| towards * height(*v) < 0) && triangle.iter().any(|v| v[2] > 0);
    if points.is_empty() || !hides {
        return [0, -1, 0, -1];
    }
    if points.len() < 12 {
        return [0, columns - 1, 0, rows - 1];
    }
    let side = |axis: usize, count: i32| {
        let along = || points.iter().map(move |(numerators, weight)| (numerators[axis], weight * dot(normal, normal)));
        let first = along().map(|(n, d)| -(-n).div_euclid(d)).min().unwrap_or(0);
        let last = along().map(|(n, d)| n.div_euclid(d)).max().unwrap_or(-1);
        [first.clamp(0, i128::from(count)) as i32, last.clamp(-1, i128::from(count - 1)) as i32]
    };
    let ([x0, x1], [y0, y1]) = (side(0, columns), side(1, rows));
    [x0, x1, y0, y1]
}

/// Column and row of a projection, both times (near - far) n . n, by the dual axes V x n and n x U of the lattice.
fn project(vertex: Point, sample: Point, near: i128, far: i128, receivers: &Lattice) -> [i128; 2] {
    let (s, v) = (minus(sample, receivers.origin), minus(vertex, receivers.origin));
    let point: [i128; 3] = std::array::from_fn(|k| near * s[k] - far * v[k]);
    let ([across, down], normal) = (receivers.axes.map(|a| a.map(i128::from)), receivers.normal().map(i128::from));
    [dot(point, cross(down, normal)), dot(point, cross(normal, across))]
}

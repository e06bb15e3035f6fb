//! The region of a triangle by trying every receiver: a column belongs to it iff it lies between the least and the greatest
//! projection, compared as fractions in i128.

use crate::grid::{Receivers, Samples, Triangle};

/// (first column, last column, first row, last row), as the kernel writes them.
pub fn region(triangle: &Triangle, samples: &Samples, receivers: &Receivers) -> [i32; 4] {
    let z = triangle.map(|v| v[2]);
    if z.iter().all(|z| *z <= 0) || z.iter().all(|z| *z >= receivers.height) {
        return [0, -1, 0, -1];
    }
    let (columns, rows) = (receivers.columns as i32, receivers.rows as i32);
    if z.iter().any(|z| *z <= 0 || *z >= receivers.height) {
        return [0, columns - 1, 0, rows - 1];
    }
    let [x0, x1] = span(triangle, samples, receivers, 0, columns);
    let [y0, y1] = span(triangle, samples, receivers, 1, rows);
    [x0, x1, y0, y1]
}

/// First and last index along one axis, unclamped bounds outside `0..count` brought to where the kernel clamps them.
fn span(triangle: &Triangle, samples: &Samples, receivers: &Receivers, axis: usize, count: i32) -> [i32; 2] {
    let size = [samples.columns, samples.rows][axis] as i32;
    let ends = [samples.origin[axis], samples.origin[axis] + samples.step[axis] * (size - 1)];
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

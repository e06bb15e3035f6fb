//! The view of a depth map: orthographic, along a direction, over the box of a mesh.
//!
//! Host code under the numerics contract: f64 with + - * / and the square root alone. Invariant: the box is inside the
//! picture by a pixel on every side, and its depths are within the raster's.

use glam::IVec4;
use sightlines_backend::{Error, Result};

use super::Maps;
use crate::light_sphere::oracle::Direction;
use crate::raster::{CLIP, Picture, Placement, View};
use crate::vertex_visibility::oracle::Point;

/// Largest bias, in 1/256 of a pixel.
pub const MAX_BIAS: u32 = 1 << 16;

/// What the raster needs for one map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapView {
    /// Picture and near plane, whose W all points have.
    pub view: View,
    /// Rows of X, Y, Z and W.
    pub rows: [IVec4; 4],
    /// Bias in depths of the raster.
    pub bias: u32,
}

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|c| c / length)
}

impl MapView {
    /// The view towards a box from the side that `direction` points to.
    pub fn new([low, high]: [Point; 2], direction: Direction, maps: Maps) -> Result<Self> {
        let side = maps.side;
        if direction == [0; 3] || !(4..=Picture::MAX_SIDE).contains(&side) || maps.bias > MAX_BIAS {
            let what =
                format!("a map of {side} pixels a side towards {direction:?} with a bias of {} / 256", maps.bias);
            let remedy = "use 4 to 4096 pixels a side, a direction that is not 0, and a bias of at most 256 pixels";
            return Err(Error::refused(what, remedy));
        }
        let towards = unit(direction.map(f64::from));
        let least =
            (0..3).fold(0, |least, axis| if direction[axis].abs() < direction[least].abs() { axis } else { least });
        let right = unit(cross([0, 1, 2].map(|axis| f64::from(u8::from(axis == least))), towards));
        let up = cross(towards, right);
        let centre = [0, 1, 2].map(|axis| f64::from(low[axis] + high[axis]) / 2.0);
        let size = [0, 1, 2].map(|axis| f64::from(high[axis] - low[axis]) / 2.0);
        let half = |along: Vector| dot(along.map(f64::abs), size);
        // Half the picture's width in cells; a pixel is left free on every side.
        let width = half(right).max(half(up)).max(0.5) * f64::from(side) / f64::from(side - 2);
        let depth = 2.0 * half(towards).max(width) + 2.0;
        // Factors of the rows stay below 2^14, and W is no less than the picture's side.
        let w = (8192.0 * width).min(f64::from(CLIP / 2)).floor();
        let row = |along: Vector, scale: f64, middle: f64| {
            let [x, y, z] = along.map(|c| c * scale);
            [x, y, z, middle - dot(along, centre) * scale]
        };
        let matrix = [
            row(right, w / width, 0.0),
            row(up, w / width, 0.0),
            row(towards, -w / depth, w / 2.0),
            [0.0, 0.0, 0.0, w],
        ];
        let pixel = 2.0 * width / f64::from(side);
        let bias = (f64::from(maps.bias) / 256.0 * pixel / depth * 16_777_216.0).min(16_777_215.0) as u32;
        let view = View { picture: Picture { width: side, height: side }, near: w as i32 };
        Ok(MapView { view, rows: Placement::new(matrix)?.rows, bias })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_box_is_in_the_picture_whatever_the_direction() {
        let boxes = [[[-16_384; 3], [16_383; 3]], [[5; 3], [5; 3]], [[-3, 0, 7], [4, 0, 9]], [[0, 0, 16_000]; 2]];
        for direction in [[1, 0, 0], [0, -1, 0], [3, -7, 6], [-1, -1, -1], [1, 60, 2]] {
            for bounds in boxes {
                for side in [4, 100, 4096] {
                    let map = MapView::new(bounds, direction, Maps { side, bias: 512 }).expect("a view");
                    let w = i64::from(map.view.near);
                    for corner in 0..8_usize {
                        let p = [0, 1, 2].map(|axis| i64::from(bounds[corner >> axis & 1][axis]));
                        let clip = map.rows.map(|row| {
                            ((0..3).map(|i| i64::from(row[i]) * p[i]).sum::<i64>() >> 16) + i64::from(row[3])
                        });
                        assert!(clip[0].abs() < w && clip[1].abs() < w, "{direction:?} {bounds:?} {side}: {clip:?}");
                        assert!(0 < clip[2] && clip[2] < w && clip[3] == w, "{direction:?} {bounds:?}: {clip:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn odd_maps_are_refused() {
        let bounds = [[0; 3], [9; 3]];
        for (direction, side, bias) in
            [([0; 3], 64, 0), ([1, 0, 0], 3, 0), ([1, 0, 0], 5000, 0), ([1, 0, 0], 64, 1 << 17)]
        {
            assert!(MapView::new(bounds, direction, Maps { side, bias }).is_err(), "{direction:?}, {side}, {bias}");
        }
    }
}

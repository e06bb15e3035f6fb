//! From a camera to the integers of the raster: clip units, a near plane, and the placement of every instance.
//!
//! Clip units are as fine as the raster's range allows for all of the scene, so nothing is clamped: a vertex far
//! behind the camera projects as exactly as one in the middle. Each mesh has a grid of its own, 2^16 cells across its
//! longest side. Invariant: what [`Frame::placement`] gives for an instance within the points that the frame was made
//! for stays within the raster's bit budget.

use sightlines_kernels::raster::{CLIP, Picture, Placement, View};

use super::world::extent;
use super::{Affine, Camera, Lens, Mesh};
use crate::error::{Place, Result};
use crate::vector::{Vector, dot, scale, sub};

/// Greatest magnitude of a vertex on the grid of its mesh.
const GRID: f64 = 32_767.0;

/// How much farther than the near plane the farthest point may be, where the camera does not say.
const DEPTH: f64 = 4096.0;

/// How far before what is nearest an orthographic picture begins, as a share of its depth: what is flush with it must
/// not be cut where a grid rounds.
const MARGIN: f64 = 1e-3;

/// A camera and a picture, in clip units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The picture and its near plane.
    pub view: View,
    /// Distance of the near plane from the eye, in scene units; an orthographic picture begins just before what is
    /// nearest.
    pub near: f64,
    /// Rows of X, Y, Z and W over points of the scene: three factors and a sum, in clip units.
    rows: [(Vector, f64); 4],
}

impl Frame {
    /// The view of a camera on `points`, which hold all that is drawn: boxes will do.
    ///
    /// # Errors
    ///
    /// No point in front of the camera, or a lens so narrow or wide that f64 does not hold its picture.
    pub fn new(camera: &Camera, picture: Picture, points: &[Vector]) -> Result<Self> {
        let row = |axis: Vector, size: f64| (scale(axis, size), -dot(axis, camera.eye) * size);
        let along = |(axis, sum): (Vector, f64), point: &Vector| dot(axis, *point) + sum;
        let depth = row(camera.forward, 1.0);
        let range = points.iter().map(|p| along(depth, p));
        let (nearest, farthest) = range.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), d| (a.min(d), b.max(d)));
        let aspect = f64::from(picture.width) / f64::from(picture.height.max(1));
        let longest = f64::from(picture.width.max(picture.height));
        // Axes of X, Y, Z and W before clip units; Z is W less the near plane's where there is perspective.
        let (half, near) = match camera.lens {
            Lens::Perspective { slope, near } => {
                if farthest.is_nan() || farthest <= 0.0 {
                    let what = format!("nothing is in front of camera `{}`", camera.name);
                    return Err(Place::default().element("camera").error(what, "turn it, or move it back"));
                }
                (slope, near.unwrap_or((0.999 * nearest).max(farthest / DEPTH)))
            }
            Lens::Orthographic { height } => (height / 2.0, nearest - MARGIN * (farthest - nearest)),
        };
        let (x, y) = (row(camera.right, 1.0 / (half * aspect)), row(camera.up, 1.0 / half));
        let most = |row| points.iter().map(|p| along(row, p).abs()).fold(0.0, f64::max);
        let whole = f64::from(CLIP - 4096);
        let clip = |(axis, sum): (Vector, f64), by: f64| (scale(axis, by), sum * by);
        let frame = match camera.lens {
            Lens::Perspective { .. } => {
                let by = whole / most(x).max(most(y)).max(most(depth)).max(near);
                let steps = (near * by).floor().max(longest);
                let (axis, sum) = clip(depth, by);
                let rows = [clip(x, by), clip(y, by), (axis, sum - steps), (axis, sum)];
                Frame { view: View { picture, near: steps as i32 }, near: steps / by, rows }
            }
            Lens::Orthographic { .. } => {
                // W is 1 where X and Y are 1 at the sides of the picture.
                let by = (whole / most(x).max(most(y)).max(1.0)).floor().max(longest);
                let deep = by * (1.0 - 1e-6) / (farthest - near).max(f64::MIN_POSITIVE);
                let deep = if farthest > nearest { deep } else { 0.0 };
                let z = (scale(camera.forward, deep), (depth.1 - near) * deep);
                let rows = [clip(x, by), clip(y, by), z, ([0.0; 3], by)];
                Frame { view: View { picture, near: by as i32 }, near, rows }
            }
        };
        let numbers = frame.rows.iter().flat_map(|(axis, sum)| axis.iter().chain([sum])).chain([&frame.near]);
        if numbers.into_iter().any(|n| !n.is_finite()) {
            let what =
                format!("the place or the lens of camera `{}` is out of all proportion to the scene", camera.name);
            return Err(Place::default().element("camera").error(what, "bring both to the scale of the scene"));
        }
        Ok(frame)
    }

    /// How vertices that `to_scene` takes into the scene become clip coordinates.
    ///
    /// # Errors
    ///
    /// A transform that leaves the points which the frame was made for, by far.
    pub fn placement(&self, to_scene: &Affine) -> Result<Placement> {
        let [a, b, c, origin] = to_scene.0;
        let row = |(axis, sum): (Vector, f64)| [dot(axis, a), dot(axis, b), dot(axis, c), dot(axis, origin) + sum];
        Ok(Placement::new(self.rows.map(row))?)
    }
}

/// A mesh on its own grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapped {
    /// Vertices in cells, within 2^15.
    pub vertices: Vec<[i32; 3]>,
    /// From cells to the coordinates of the mesh.
    pub to_mesh: Affine,
}

impl Snapped {
    /// Rounds the vertices of a mesh to its grid, each to the nearest cell.
    pub fn of(mesh: &Mesh) -> Self {
        let [low, high] = extent(mesh).unwrap_or([[0.0; 3]; 2]);
        let centre = [0, 1, 2].map(|axis| 0.5 * low[axis] + 0.5 * high[axis]);
        let longest = sub(high, centre).into_iter().fold(0.0, f64::max);
        // A mesh without extent has cells without extent, so that no scene is too small for it.
        let cell = longest / GRID;
        let cells = |v: &Vector| match cell > 0.0 {
            true => sub(*v, centre).map(|d| (d / cell + 0.5).floor().clamp(-GRID, GRID) as i32),
            false => [0; 3],
        };
        Snapped { vertices: mesh.vertices.iter().map(cells).collect(), to_mesh: Affine::placed(cell, centre) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vector = [0.0, 1.0, 0.0];
    const PICTURE: Picture = Picture { width: 640, height: 480 };

    /// Pixel and depth of a point, as the raster's steps 1 and 3 have them.
    fn project(frame: &Frame, point: Vector) -> [f64; 3] {
        let rows = frame.placement(&Affine::placed(1e-9, point)).unwrap().rows;
        let [x, y, z, w] = rows.map(|row| f64::from(row.w));
        let Picture { width, height } = frame.view.picture;
        [(x / w + 1.0) * f64::from(width) / 2.0, (1.0 - y / w) * f64::from(height) / 2.0, z / w]
    }

    #[test]
    fn points_come_where_a_lens_puts_them() {
        let camera = Camera::parse("0,1,10/0,1,0/90", UP).unwrap().unwrap();
        let frame = Frame::new(&camera, PICTURE, &[[-50.0, -50.0, -90.0], [50.0, 50.0, 9.0]]).unwrap();
        // Half the picture's height is as far up as the distance.
        for (point, expected) in [
            ([0.0, 1.0, 0.0], [320.0, 240.0]),
            ([0.0, 11.0, 0.0], [320.0, 0.0]),
            ([5.0, 1.0, 0.0], [440.0, 240.0]),
            ([-20.0, -19.0, -10.0], [80.0, 480.0]),
        ] {
            let found = project(&frame, point);
            assert!((found[0] - expected[0]).abs() < 0.01 && (found[1] - expected[1]).abs() < 0.01, "{found:?}");
        }
        assert!((frame.near - 0.999).abs() < 1e-3, "{}", frame.near);
        let depths = [9.0, 0.0, -90.0].map(|z| project(&frame, [0.0, 1.0, z])[2]);
        assert!(depths[0] < depths[1] && depths[1] < depths[2] && depths[0] >= 0.0 && depths[2] < 1.0, "{depths:?}");
    }

    #[test]
    fn an_orthographic_picture_is_as_high_as_its_lens_says_and_begins_with_the_nearest() {
        let camera = Camera::parse("0,0,10/0,0,0/height=4", UP).unwrap().unwrap();
        let frame = Frame::new(&camera, PICTURE, &[[-5.0, -5.0, -7.0], [5.0, 5.0, 20.0]]).unwrap();
        let found = project(&frame, [1.0, 2.0, 3.0]);
        assert!((found[0] - 440.0).abs() < 0.01 && found[1].abs() < 0.01, "{found:?}");
        let first = project(&frame, [0.0, 0.0, 20.0])[2];
        assert!(first > 0.0 && first < 0.002, "{first}");
        let last = project(&frame, [0.0, 0.0, -7.0])[2];
        assert!(last < 1.0 && last > 0.999, "{last}");
    }

    #[test]
    fn nothing_leaves_the_range_of_clip_units() {
        let narrow = Camera::parse("0,0,0/0,0,-1/0.5", UP).unwrap().unwrap();
        let far = [[1e6, 1e6, 1e6], [-1e6, -1e6, -1e6], [0.0, 0.0, -1e-3]];
        let frame = Frame::new(&narrow, PICTURE, &far).unwrap();
        for point in far {
            let rows = frame.placement(&Affine::placed(1e-9, point)).unwrap().rows;
            assert!(rows.iter().all(|row| row.w.abs() <= CLIP), "{rows:?}");
        }
        assert!(frame.view.near >= 640);
        let behind = Frame::new(&narrow, PICTURE, &[[0.0, 0.0, 5.0]]).unwrap_err().to_string();
        assert!(behind.contains("nothing is in front of camera") && behind.contains("turn it"), "{behind}");
    }

    #[test]
    fn a_lens_out_of_proportion_is_refused_and_a_point_is_placed() {
        let points = [[0.0; 3], [1.0; 3]];
        for height in [1e-308, f64::MIN_POSITIVE / 8.0] {
            let camera = Camera::look_at("far", [9.0; 3], [0.0; 3], UP, Lens::Orthographic { height }).unwrap();
            let message = Frame::new(&camera, PICTURE, &points).unwrap_err().to_string();
            assert!(message.contains("camera `far` is out of all proportion"), "{message}");
        }
        let camera = Camera::look_at("near", [9e-9; 3], [0.0; 3], UP, Lens::angle(45.0).unwrap()).unwrap();
        let frame = Frame::new(&camera, PICTURE, &[[0.0; 3], [1e-9; 3]]).unwrap();
        let Snapped { vertices, to_mesh } =
            Snapped::of(&Mesh { vertices: vec![[1e-9; 3]; 3], triangles: vec![[0, 1, 2]], ..Mesh::default() });
        assert_eq!((&*vertices, to_mesh.apply([0.0; 3])), (&[[0; 3]; 3][..], [1e-9; 3]));
        frame.placement(&to_mesh).unwrap();
    }

    #[test]
    fn a_snapped_mesh_is_within_half_a_cell() {
        let vertices = vec![[1.0, 2.0, 3.0], [4.0, 2.5, 3.0], [1.1, 2.2, 3.3]];
        let mesh = Mesh { vertices, triangles: vec![[0, 1, 2]], ..Mesh::default() };
        let Snapped { vertices, to_mesh } = Snapped::of(&mesh);
        for (cells, point) in vertices.iter().zip(&mesh.vertices) {
            let back = to_mesh.apply(cells.map(f64::from));
            assert!(sub(back, *point).iter().all(|d| d.abs() <= 0.51 * to_mesh.0[0][0]), "{back:?} {point:?}");
        }
        assert_eq!(Snapped::of(&Mesh::default()).vertices, [[0; 3]; 0]);
    }
}

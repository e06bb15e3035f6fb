//! The grid and the definition: what it means that a triangle hides a sample from a receiver.
//!
//! One grid a source. Its axes follow the source's rectangle, the source plane is z = 0, and vertices, receivers and
//! samples are integer points of it, with x and y in [−2^14, 2^14) and z in [0, 2^15). **Sample S is hidden from
//! receiver R by triangle T iff the segment R S meets T**, told by the signs of determinants of those integer points:
//!
//! * the three planes through R and an edge of T have S on their inner side, where inner is the side of T's third
//!   vertex, and a sample *on* such a plane belongs to the side of larger x, or of larger y where the plane is
//!   x-parallel at z = 0 (an antisymmetric rule: of two triangles that share an edge from opposite sides exactly one
//!   owns the sample);
//! * S and R lie strictly on opposite sides of T's own plane.
//!
//! A triangle whose plane holds R hides nothing. Of a one-sided triangle ([`Faces::Front`]) the front counts alone: S
//! must see its vertices counter-clockwise. Kernels only *evaluate* this; nothing is clipped or snapped again.
//! [`hidden`] is the definition in i128, without any thought of speed: it is the oracle of every kernel that makes
//! masks.

use std::ops::{Mul, Sub};

use sightlines_backend::{Error, Result, host};

/// x and y lie in [−XY, XY).
pub const XY: i32 = 1 << 14;

/// z lies in [0, Z).
pub const Z: i32 = 1 << 15;

/// An integer point of the grid.
pub type Point = [i32; 3];

/// Three vertices.
pub type Triangle = [Point; 3];

/// A regular grid of light samples on the source plane: sample (k, j) stands at `origin + step·(k, j)`.
///
/// As a set it is numbered row by row, `j·columns + k`; a mask holds sample s in bit `s % 32` of word `s / 32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Samples {
    /// x and y of sample (0, 0).
    pub origin: [i32; 2],
    /// Distances along x and y, from 1 to 2^15 - 1.
    pub step: [i32; 2],
    /// Samples along x: a power of two up to 32.
    pub columns: u32,
    /// Samples along y: a power of two up to 32.
    pub rows: u32,
}

/// A regular grid of receivers on a plane parallel to the source: receiver (i, r) stands at `origin + step·(i, r)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Receivers {
    /// x and y of receiver (0, 0).
    pub origin: [i32; 2],
    /// Distances along x and y, from 1 to 2^15 - 1.
    pub step: [i32; 2],
    /// z of all receivers.
    pub height: i32,
    /// Receivers along x.
    pub columns: u32,
    /// Receivers along y.
    pub rows: u32,
}

/// A regular grid of receivers on any plane: receiver (i, r) stands at `origin + i·axes[0] + r·axes[1]`.
///
/// Floors and walls, the texels of a lightmap and the cells of a height field are lattices; [`Receivers`] are those
/// whose plane is parallel to the source and whose axes are its axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    /// Receiver (0, 0).
    pub origin: Point,
    /// Steps from a receiver to the next of its row, and to the next of its column.
    pub axes: [Point; 2],
    /// Receivers along the first axis.
    pub columns: u32,
    /// Receivers along the second axis.
    pub rows: u32,
}

host! {
    /// A light and its receivers as kernels are given them. Mirrors `struct View` of `shared/view.wgsl`.
    pub struct View {
        /// x of the first receiver.
        pub receiver_x: i32,
        /// y of the first receiver.
        pub receiver_y: i32,
        /// Distance of receivers along x.
        pub receiver_step_x: i32,
        /// Distance of receivers along y.
        pub receiver_step_y: i32,
        /// z of the receivers.
        pub height: i32,
        /// Receivers along x.
        pub columns: u32,
        /// Receivers along y.
        pub rows: u32,
        /// x of the first sample.
        pub sample_x: i32,
        /// y of the first sample.
        pub sample_y: i32,
        /// Distance of samples along x.
        pub sample_step_x: i32,
        /// Distance of samples along y.
        pub sample_step_y: i32,
    }
}

impl View {
    /// The view of `receivers` on `samples`.
    pub fn new(samples: &Samples, receivers: &Receivers) -> Self {
        View {
            sample_x: samples.origin[0],
            sample_y: samples.origin[1],
            sample_step_x: samples.step[0],
            sample_step_y: samples.step[1],
            ..View::of(receivers)
        }
    }

    /// The view of `receivers` on a light whose samples stand elsewhere: as one that has all of them at 0.
    pub fn of(receivers: &Receivers) -> Self {
        View {
            receiver_x: receivers.origin[0],
            receiver_y: receivers.origin[1],
            receiver_step_x: receivers.step[0],
            receiver_step_y: receivers.step[1],
            height: receivers.height,
            columns: receivers.columns,
            rows: receivers.rows,
            sample_x: 0,
            sample_y: 0,
            sample_step_x: 0,
            sample_step_y: 0,
        }
    }
}

fn refuse(what: String) -> Result<()> {
    let remedy = "keep x and y in [-16384, 16384) and z in [0, 32768), steps from 1 to 32767, columns and rows of samples \
                  powers of two up to 32 that make whole words";
    Err(Error::refused(what, remedy))
}

fn along(origin: i32, step: i32, count: u32) -> Option<i32> {
    let last = i64::from(origin) + i64::from(step) * i64::from(count.max(1) - 1);
    i32::try_from(last).ok()
}

fn inside(origin: [i32; 2], step: [i32; 2], columns: u32, rows: u32) -> bool {
    let fits = |axis: usize, count| {
        let last = along(origin[axis], step[axis], count);
        origin[axis] >= -XY && last.is_some_and(|last| last < XY)
    };
    fits(0, columns) && fits(1, rows)
}

impl Samples {
    /// Number of samples.
    pub fn count(&self) -> u32 {
        self.columns * self.rows
    }

    /// Words of a mask.
    pub fn words(&self) -> u32 {
        self.count().div_ceil(32)
    }

    /// Where a sample stands, by its number in the set.
    pub fn at(&self, sample: u32) -> Point {
        let (k, j) = ((sample % self.columns) as i32, (sample / self.columns) as i32);
        [self.origin[0] + self.step[0] * k, self.origin[1] + self.step[1] * j, 0]
    }

    /// The outermost samples, in the order of their numbers.
    pub fn corners(&self) -> [Point; 4] {
        let last = self.count() - 1;
        [0, self.columns - 1, last - (self.columns - 1), last].map(|sample| self.at(sample))
    }

    /// Refuses what is not on the grid.
    pub fn check(&self) -> Result<()> {
        let steps = self.step.iter().all(|s| (1..Z).contains(s));
        let sizes = [self.columns, self.rows].iter().all(|n| n.is_power_of_two() && *n <= 32);
        if !(steps
            && sizes
            && self.count().is_multiple_of(32)
            && inside(self.origin, self.step, self.columns, self.rows))
        {
            return refuse(format!("light samples {self:?}"));
        }
        Ok(())
    }
}

impl Receivers {
    /// Number of receivers.
    pub fn count(&self) -> u32 {
        self.columns * self.rows
    }

    /// Where a receiver stands, by its number, row by row.
    pub fn at(&self, receiver: u32) -> Point {
        let (i, r) = ((receiver % self.columns) as i32, (receiver / self.columns) as i32);
        [self.origin[0] + self.step[0] * i, self.origin[1] + self.step[1] * r, self.height]
    }

    /// Refuses what is not on the grid.
    pub fn check(&self) -> Result<()> {
        let steps = self.step.iter().all(|s| (1..Z).contains(s));
        let sizes = (1..=8192).contains(&self.columns) && (1..=8192).contains(&self.rows);
        let high = (1..Z).contains(&self.height);
        if !(steps && sizes && high && inside(self.origin, self.step, self.columns, self.rows)) {
            return refuse(format!("receivers {self:?}"));
        }
        Ok(())
    }
}

impl From<&Receivers> for Lattice {
    fn from(receivers: &Receivers) -> Self {
        let Receivers { origin: [x, y], step: [across, down], height, columns, rows } = *receivers;
        Lattice { origin: [x, y, height], axes: [[across, 0, 0], [0, down, 0]], columns, rows }
    }
}

impl Lattice {
    /// Number of receivers.
    pub fn count(&self) -> u32 {
        self.columns * self.rows
    }

    /// Where a receiver stands, by its number, row by row.
    pub fn at(&self, receiver: u32) -> Point {
        let (i, r) = ((receiver % self.columns) as i32, (receiver / self.columns) as i32);
        std::array::from_fn(|axis| self.origin[axis] + self.axes[0][axis] * i + self.axes[1][axis] * r)
    }

    /// Normal of the plane, the cross product of the axes; it fits 32 bits where the axes are shorter than 2^15.
    pub fn normal(&self) -> Point {
        cross(self.axes[0], self.axes[1])
    }

    /// Refuses what is not on the grid, and axes that span no plane.
    pub fn check(&self) -> Result<()> {
        let sizes = (1..=8192).contains(&self.columns) && (1..=8192).contains(&self.rows);
        let short = self.axes.as_flattened().iter().all(|c| c.unsigned_abs() < Z as u32);
        let plane = || self.normal() != [0; 3];
        // All receivers lie between the four outermost.
        let corner = |i: u32, r: u32| -> [i64; 3] {
            let along = |axis: usize, steps: u32, k: usize| i64::from(self.axes[axis][k]) * i64::from(steps - 1);
            std::array::from_fn(|k| i64::from(self.origin[k]) + along(0, i, k) + along(1, r, k))
        };
        let stands = |[x, y, z]: [i64; 3]| {
            let across = -i64::from(XY)..i64::from(XY);
            across.contains(&x) && across.contains(&y) && (1..i64::from(Z)).contains(&z)
        };
        let inside = || [(1, 1), (self.columns, 1), (1, self.rows), (self.columns, self.rows)];
        if !(sizes && short && plane() && inside().into_iter().all(|(i, r)| stands(corner(i, r)))) {
            let remedy = "give it 1 to 8192 columns and rows, axes that span a plane, and receivers with x and y in \
                          [-16384, 16384) and z in [1, 32768)";
            return Err(Error::refused(format!("a lattice of receivers {self:?}"), remedy));
        }
        Ok(())
    }
}

/// Whether a point lies on the grid.
pub fn is_on_grid([x, y, z]: Point) -> bool {
    (-XY..XY).contains(&x) && (-XY..XY).contains(&y) && (0..Z).contains(&z)
}

pub(crate) fn minus(a: Point, b: Point) -> [i128; 3] {
    std::array::from_fn(|i| i128::from(a[i]) - i128::from(b[i]))
}

pub(crate) fn cross<T: Copy + Mul<Output = T> + Sub<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn dot(a: [i128; 3], b: [i128; 3]) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The definition: whether `triangle` hides `sample`, a point of the plane z = 0, from `receiver`.
pub fn hidden(receiver: Point, sample: Point, triangle: &Triangle) -> bool {
    let to: [[i128; 3]; 3] = triangle.map(|vertex| minus(vertex, receiver));
    let ray = minus(sample, receiver);
    let orientation = dot(cross(to[0], to[1]), to[2]);
    if orientation == 0 {
        return false;
    }
    let inner = [(0, 1), (1, 2), (2, 0)].into_iter().all(|(i, j)| {
        let normal = cross(to[i], to[j]).map(|n| n * orientation.signum());
        let side = dot(normal, ray);
        side > 0 || side == 0 && (normal[0] > 0 || normal[0] == 0 && normal[1] > 0)
    });
    let plane = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
    let receiver_side = dot(plane, minus(receiver, triangle[0])).signum();
    let sample_side = dot(plane, minus(sample, triangle[0])).signum();
    inner && receiver_side * sample_side < 0
}

/// Which faces of a triangle hide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Faces {
    /// Either face.
    #[default]
    Both,
    /// The one from which its vertices are seen counter-clockwise.
    Front,
}

impl Faces {
    /// The definition of triangles that count from these faces: whether `triangle` hides `sample` from `receiver`.
    pub fn hide(self, receiver: Point, sample: Point, triangle: &Triangle) -> bool {
        hidden(receiver, sample, triangle) && (self == Faces::Both || is_front(sample, triangle))
    }
}

/// Whether the vertices of `triangle` are seen counter-clockwise from a point.
pub fn is_front(from: Point, triangle: &Triangle) -> bool {
    let normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
    dot(normal, minus(from, triangle[0])) > 0
}

/// The mask of samples that any of `triangles` hides from `receiver`, by [`hidden`] alone.
pub fn hidden_set<'a>(
    receiver: Point,
    samples: &Samples,
    triangles: impl IntoIterator<Item = &'a Triangle>,
) -> Vec<u32> {
    hidden_set_by(Faces::Both, receiver, samples, triangles)
}

/// The mask of samples that `faces` of any of `triangles` hide from `receiver`, by [`Faces::hide`] alone.
pub fn hidden_set_by<'a>(
    faces: Faces,
    receiver: Point,
    samples: &Samples,
    triangles: impl IntoIterator<Item = &'a Triangle>,
) -> Vec<u32> {
    let mut mask = vec![0; samples.words() as usize];
    for triangle in triangles {
        for sample in 0..samples.count() {
            let bit = u32::from(faces.hide(receiver, samples.at(sample), triangle));
            mask[sample as usize / 32] |= bit << (sample % 32);
        }
    }
    mask
}

#[cfg(test)]
mod tests {
    use super::*;

    const R: Point = [0, 0, 100];

    #[test]
    fn a_sample_behind_a_triangle_is_hidden_and_one_beside_it_is_not() {
        let triangle = [[-10, -10, 50], [10, -10, 50], [0, 10, 50]];
        assert!(hidden(R, [0, 0, 0], &triangle));
        assert!(!hidden(R, [100, 0, 0], &triangle));
        let [a, b, c] = triangle;
        assert!(hidden(R, [0, 0, 0], &[a, c, b]), "either side of a triangle hides");
        let hides = |triangle| Faces::Front.hide(R, [0, 0, 0], &triangle);
        assert_eq!((hides([a, b, c]), hides([a, c, b])), (false, true), "of a one-sided triangle the front alone");
        assert!(!Faces::Front.hide(R, [100, 0, 0], &[a, c, b]), "and only what stands behind it");
    }

    #[test]
    fn only_what_stands_between_hides() {
        let at = |z: i32| [[-10, -10, z], [10, -10, z], [0, 10, z]];
        assert!(!hidden(R, [0, 0, 0], &at(100)), "in the receiver's plane");
        assert!(!hidden(R, [0, 0, 0], &at(101)), "behind the receiver");
        assert!(!hidden(R, [0, 0, 0], &at(0)), "in the source plane");
        assert!(hidden(R, [0, 0, 0], &[[-10, -10, 120], [10, -10, 120], [0, 10, 20]]), "through the receiver's plane");
    }

    #[test]
    fn parallel_receivers_are_a_lattice() {
        let receivers = Receivers { origin: [-70, 9], step: [3, 5], height: 40, columns: 4, rows: 3 };
        let lattice = Lattice::from(&receivers);
        assert_eq!((lattice.count(), lattice.normal()), (12, [0, 0, 15]));
        assert!((0..12).all(|receiver| lattice.at(receiver) == receivers.at(receiver)));
    }

    #[test]
    fn a_step_that_no_receiver_takes_is_held_to_the_grid_too() {
        let one = Receivers { origin: [0, 0], step: [1, Z - 1], height: 9, columns: 1, rows: 1 };
        one.check().expect("a step of 2^15 - 1");
        assert!(Receivers { step: [1, Z], ..one }.check().is_err());
        let light = Samples { origin: [0, 0], step: [Z, 1], columns: 1, rows: 32 };
        assert!(light.check().is_err());
    }

    #[test]
    fn lattices_beside_the_grid_or_without_a_plane_are_refused() {
        let good = Lattice { origin: [0, 0, 1], axes: [[4, 0, 3], [0, 1, 0]], columns: 4096, rows: 9 };
        good.check().expect("its last column has x = 16380");
        let axes = good.axes;
        for bad in [
            Lattice { columns: 4097, ..good },
            Lattice { columns: 0, ..good },
            Lattice { rows: 8193, ..good },
            Lattice { origin: [0, 0, 0], ..good },
            Lattice { axes: [axes[0], axes[0]], ..good },
            Lattice { axes: [axes[0], [0; 3]], ..good },
            Lattice { axes: [axes[0], [0, 1 << 15, 0]], rows: 1, ..good },
            Lattice { axes: [[i32::MAX, 0, i32::MAX], axes[1]], ..good },
        ] {
            assert!(bad.check().is_err(), "{bad:?}");
        }
    }

    #[test]
    fn a_shared_edge_neither_leaks_nor_covers_twice() {
        let (a, b) = ([-20, 0, 50], [20, 0, 50]);
        let (left, right) = ([a, b, [0, 30, 50]], [b, a, [0, -30, 50]]);
        for x in -30..30 {
            let sample = [x, 0, 0];
            let both = (hidden(R, sample, &left), hidden(R, sample, &right));
            assert!(both != (true, true), "{sample:?} is covered twice");
            assert_eq!(both.0 || both.1, (-40..40).contains(&x), "{sample:?}");
        }
    }
}

//! Triangles that are hard to get right: slivers, ties on samples, shared edges, vertices next to either plane.
//!
//! Everything is made by counter ([`random`]), so a case's name and seed fix its input.

use crate::grid::{Lattice, Point, Receivers, Samples, Triangle, XY, Z};
use crate::random;

/// A family of triangles between a light and its receivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Anywhere on the grid, of any size.
    Anywhere,
    /// About as large as the light, in the middle.
    LightSized,
    /// Two vertices one unit apart, the third far away.
    Slivers,
    /// Every vertex on a line from a receiver to a sample.
    OnSampleRays,
    /// Tetrahedra: four triangles that share all their edges.
    Closed,
    /// One vertex one unit from the source, one a unit from the receivers.
    NearPlanes,
    /// Edges parallel to the rows and columns of samples.
    AxisParallel,
    /// In a plane that holds a receiver.
    EdgeOn,
    /// A few units long, strewn over the light's view.
    Small,
    /// As leaves over a floor: up to 200 units long, within a quarter of the way from the receivers to the light.
    Leaves,
}

impl Family {
    /// All families.
    pub const ALL: [Family; 10] = [
        Family::Anywhere,
        Family::LightSized,
        Family::Slivers,
        Family::OnSampleRays,
        Family::Closed,
        Family::NearPlanes,
        Family::AxisParallel,
        Family::EdgeOn,
        Family::Small,
        Family::Leaves,
    ];

    /// Its name in cases.
    pub fn name(self) -> &'static str {
        match self {
            Family::Anywhere => "anywhere",
            Family::LightSized => "light_sized",
            Family::Slivers => "slivers",
            Family::OnSampleRays => "on_sample_rays",
            Family::Closed => "closed",
            Family::NearPlanes => "near_planes",
            Family::AxisParallel => "axis_parallel",
            Family::EdgeOn => "edge_on",
            Family::Small => "small",
            Family::Leaves => "leaves",
        }
    }

    /// `count` triangles strictly between the source and the farthest of the receivers.
    pub fn triangles<R>(self, count: u32, samples: &Samples, receivers: R, seed: u32) -> Vec<Triangle>
    where
        R: Into<Lattice>,
    {
        let receivers = receivers.into();
        let [across, down] = [receivers.columns, receivers.rows].map(|n| n - 1);
        let corners = [0, across, down * receivers.columns, down * receivers.columns + across];
        let height = corners.into_iter().map(|corner| receivers.at(corner)[2]).fold(0, i32::max);
        let mut maker = Maker { samples, receivers, height, seed, next: 0 };
        let mut triangles = Vec::new();
        while triangles.len() < count as usize {
            self.make(&mut maker, &mut triangles);
        }
        triangles.truncate(count as usize);
        triangles
    }

    fn make(self, m: &mut Maker<'_>, out: &mut Vec<Triangle>) {
        match self {
            Family::Anywhere => out.push(std::array::from_fn(|_| m.anywhere())),
            Family::LightSized => out.push(std::array::from_fn(|_| m.in_light())),
            Family::Slivers => {
                let (a, b) = (m.in_light(), m.in_light());
                out.push([a, b, m.near(b, 1)]);
            }
            Family::OnSampleRays => out.push(std::array::from_fn(|_| m.on_ray())),
            Family::Closed => {
                let [a, b, c, d] = std::array::from_fn(|_| m.in_light());
                out.extend([[a, b, c], [a, c, d], [a, d, b], [b, d, c]]);
            }
            Family::NearPlanes => {
                let [mut a, mut b, c] = std::array::from_fn(|_| m.in_light());
                a[2] = 1;
                b[2] = m.height - 1;
                out.push([a, b, c]);
            }
            Family::AxisParallel => {
                let (a, b) = (m.on_ray(), m.in_light());
                out.push([a, [b[0], a[1], a[2]], [a[0], b[1], a[2]]]);
            }
            Family::EdgeOn => {
                let receiver = m.receiver();
                let (a, b) = (m.in_light(), m.in_light());
                let c = std::array::from_fn(|i| (receiver[i] + 3 * a[i]) / 4);
                out.push([a, b, m.between(c)]);
            }
            Family::Small => {
                let a = m.in_light();
                let size = 1 + m.below(60);
                out.push([a, m.near(a, size), m.near(a, size)]);
            }
            Family::Leaves => {
                let a = m.leaf();
                out.push([a, m.near(a, 200), m.near(a, 200)]);
            }
        }
    }
}

/// Every combination of heights on, next to and far from both planes.
pub fn levels(height: i32) -> Vec<Triangle> {
    let levels = [0, 1, height / 2, height, Z - 1];
    let mut triangles = Vec::new();
    for a in levels {
        for b in levels {
            triangles.extend(levels.map(|c| [[-500, 40, a], [900, -60, b], [10, 700, c]]));
        }
    }
    triangles
}

/// Triangles with one vertex outside, on the source plane or on or above the receivers'.
pub fn crossing(count: u32, samples: &Samples, receivers: &Receivers) -> Vec<Triangle> {
    let mut triangles = Family::LightSized.triangles(count, samples, receivers, 11);
    for (index, triangle) in triangles.iter_mut().enumerate() {
        let beyond = random::below((Z - receivers.height) as u32, 12, index as u32) as i32;
        triangle[index % 3][2] = if index % 2 == 0 { 0 } else { receivers.height + beyond };
    }
    triangles
}

/// Triangles between corners of the grid, next to the source and next to the receivers.
pub fn corners(count: u32, receivers: &Receivers) -> Vec<Triangle> {
    let ends = |i: u32, low: i32, high: i32| if random::word(9, i) >> 31 == 0 { low } else { high };
    let corner =
        |i: u32| [ends(3 * i, -XY, XY - 1), ends(3 * i + 1, -XY, XY - 1), ends(3 * i + 2, 1, receivers.height - 1)];
    (0..count).map(|i| [corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)]).collect()
}

/// For the first receiver of each tile in turn, a triangle of a few units right below it: lines with small
/// coefficients.
pub fn contacts(tile: [u32; 2], receivers: &Receivers) -> Vec<Triangle> {
    let corners = (0..receivers.rows).step_by(tile[1] as usize).flat_map(|y| {
        (0..receivers.columns).step_by(tile[0] as usize).map(move |x| receivers.at(y * receivers.columns + x))
    });
    let near = |[x, y, z]: Point, i: u32| {
        let by = |axis: u32, reach: u32| random::below(reach, 31, 3 * i + axis) as i32;
        [x + by(0, 13) - 6, y + by(1, 13) - 6, z - 1 - by(2, 6)]
    };
    (0..).zip(corners).map(|(i, r)| [near(r, 3 * i), near(r, 3 * i + 1), near(r, 3 * i + 2)]).collect()
}

struct Maker<'a> {
    samples: &'a Samples,
    receivers: Lattice,
    /// z of the farthest receiver.
    height: i32,
    seed: u32,
    next: u32,
}

impl Maker<'_> {
    fn below(&mut self, bound: u32) -> i32 {
        self.next += 1;
        random::below(bound, self.seed, self.next) as i32
    }

    fn between(&self, [x, y, z]: Point) -> Point {
        [x.clamp(-XY, XY - 1), y.clamp(-XY, XY - 1), z.clamp(1, self.height - 1)]
    }

    fn anywhere(&mut self) -> Point {
        let xy = 2 * XY as u32;
        let height = self.height as u32;
        [self.below(xy) - XY, self.below(xy) - XY, 1 + self.below(height - 1)]
    }

    fn leaf(&mut self) -> Point {
        let (receiver, sample) = (self.receiver(), self.sample());
        let part = 4 + self.below(24);
        self.between(std::array::from_fn(|i| receiver[i] + (sample[i] - receiver[i]) / part))
    }

    fn receiver(&mut self) -> Point {
        let receiver = self.below(self.receivers.count());
        self.receivers.at(receiver as u32)
    }

    fn sample(&mut self) -> Point {
        let sample = self.below(self.samples.count());
        self.samples.at(sample as u32)
    }

    /// On or near a line from a receiver to a sample.
    fn in_light(&mut self) -> Point {
        let ray = self.on_ray();
        let spread = (self.samples.step[0] * self.samples.columns as i32).max(4);
        self.near(ray, spread / 2)
    }

    /// On a line from a receiver to a sample, exactly where the grid allows: half-way, a quarter, or rounded.
    fn on_ray(&mut self) -> Point {
        let (receiver, sample) = (self.receiver(), self.sample());
        let part = [2, 4, 8, 3][self.below(4) as usize];
        let point = std::array::from_fn(|i| sample[i] + (receiver[i] - sample[i]) / part);
        self.between(point)
    }

    fn near(&mut self, point: Point, distance: i32) -> Point {
        let moved = point.map(|c| {
            let by = self.below(2 * distance as u32 + 1);
            c + by - distance
        });
        self.between(moved)
    }
}

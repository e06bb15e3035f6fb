//! Meshes that are hard to draw right, in sub-pixels of a picture, and those of real size.
//!
//! Everything is made by counter ([`random`]), so a case's name and seed fix its input.

use std::f64::consts::PI;

use glam::IVec4;
use sightlines_backend::Job;

use super::oracle::Scene;
use super::{Faces, Ids, Mesh, Picture, Placement};
use crate::random;

/// Vertices and triangles.
#[derive(Clone, Debug, Default)]
pub struct Shape {
    /// Vertices.
    pub vertices: Vec<[i32; 3]>,
    /// Three vertices each.
    pub triangles: Vec<[u32; 3]>,
}

impl Shape {
    fn push(&mut self, corners: [[i32; 3]; 3]) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(corners);
        self.triangles.push([first, first + 1, first + 2]);
    }

    /// One instance, every triangle an item, both sides drawn.
    pub fn drawn(self, placements: &[Placement]) -> Scene {
        Scene {
            ids: Ids { base: 0, step: self.triangles.len() as u32, shift: 0 },
            vertices: self.vertices,
            triangles: self.triangles,
            instances: placements.iter().map(|p| p.rows).collect(),
            faces: Faces::All,
        }
    }
}

/// A family of triangles whose vertices are sub-pixels of a picture about its centre, z in [0, 2^15).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Any size up to twice the picture.
    Anywhere,
    /// A few sub-pixels.
    Tiny,
    /// Up to 14 pixels: what one lane draws.
    Small,
    /// Two vertices one sub-pixel apart, the third far away.
    Slivers,
    /// Vertices and edges on pixel centres.
    OnCentres,
    /// Around common vertices, with common edges: fans that close.
    Fans,
    /// Points and lines.
    Degenerate,
    /// Outside the picture, some touching its border.
    OffScreen,
    /// Up to 2^15 sub-pixels from the centre: extents that no longer fit 15 bits.
    Huge,
    /// Coplanar pairs: equal depths, where the least id decides.
    Twins,
}

impl Family {
    /// All families.
    pub const ALL: [Family; 10] = [
        Family::Anywhere,
        Family::Tiny,
        Family::Small,
        Family::Slivers,
        Family::OnCentres,
        Family::Fans,
        Family::Degenerate,
        Family::OffScreen,
        Family::Huge,
        Family::Twins,
    ];

    /// Its name in cases.
    pub fn name(self) -> &'static str {
        match self {
            Family::Anywhere => "anywhere",
            Family::Tiny => "tiny",
            Family::Small => "small",
            Family::Slivers => "slivers",
            Family::OnCentres => "on_centres",
            Family::Fans => "fans",
            Family::Degenerate => "degenerate",
            Family::OffScreen => "off_screen",
            Family::Huge => "huge",
            Family::Twins => "twins",
        }
    }

    /// At least `count` triangles.
    pub fn shape(self, count: usize, picture: Picture, seed: u32) -> Shape {
        let mut maker = Maker { half: [8 * picture.width as i32, 8 * picture.height as i32], seed, next: 0 };
        let mut shape = Shape::default();
        while shape.triangles.len() < count {
            self.make(&mut maker, &mut shape);
        }
        shape
    }

    fn make(self, m: &mut Maker, out: &mut Shape) {
        let [half_x, half_y] = m.half;
        match self {
            Family::Anywhere => out.push([(); 3].map(|()| m.within(2 * half_x, 2 * half_y))),
            Family::Tiny => {
                let a = m.within(half_x, half_y);
                out.push([a, m.near(a, 24), m.near(a, 24)]);
            }
            Family::Small => {
                let a = m.within(half_x, half_y);
                out.push([a, m.near(a, 110), m.near(a, 110)]);
            }
            Family::Slivers => {
                let (a, b) = (m.within(half_x, half_y), m.within(half_x, half_y));
                out.push([a, b, m.near(b, 1)]);
            }
            Family::OnCentres => out.push([(); 3].map(|()| {
                let [x, y, z] = m.within(half_x, half_y);
                [x & !15 | 8, y & !15 | 8, z]
            })),
            Family::Fans => m.fan(out),
            Family::Degenerate => {
                let (a, b) = (m.within(half_x, half_y), m.within(half_x, half_y));
                let middle = [0, 1, 2].map(|i| (a[i] + b[i]) / 2);
                let line = [a, [2 * middle[0] - a[0], 2 * middle[1] - a[1], b[2]], middle];
                out.push(line);
                out.push([a, a, b]);
                out.push([b, b, b]);
            }
            Family::OffScreen => {
                let [x, y, z] = m.within(half_x, half_y);
                let a = if m.below(2) == 0 { [x.signum() * half_x, y, z] } else { [x, y.signum() * half_y, z] };
                let out_by = |v: i32, half: i32| if v.abs() == half { v.signum() * (half + 8) } else { v };
                let b = [out_by(a[0], half_x), out_by(a[1], half_y), z];
                out.push([a, b, m.near([2 * b[0], 2 * b[1], z], 200)]);
            }
            Family::Huge => {
                let size = i32::from(i16::MAX);
                let near = m.within(half_x, half_y);
                out.push([m.within(size, size), m.within(size, size), near]);
                out.push([m.within(size, size), m.near(near, 3), near]);
            }
            Family::Twins => {
                let [a, b, c] = [(); 3].map(|()| m.within(half_x, half_y));
                // The fourth corner of a parallelogram, in the same plane.
                let d = [0, 1, 2].map(|i| a[i] + c[i] - b[i]);
                if (0..1 << 15).contains(&d[2]) {
                    out.push([a, d, c]);
                    out.push([c, b, a]);
                    out.push([b, c, a]);
                }
            }
        }
    }
}

struct Maker {
    half: [i32; 2],
    seed: u32,
    next: u32,
}

impl Maker {
    fn below(&mut self, bound: u32) -> i32 {
        self.next += 1;
        random::below(bound, self.seed, self.next) as i32
    }

    fn within(&mut self, x: i32, y: i32) -> [i32; 3] {
        [self.below(2 * x as u32 + 1) - x, self.below(2 * y as u32 + 1) - y, self.below(1 << 15)]
    }

    fn near(&mut self, p: [i32; 3], distance: u32) -> [i32; 3] {
        let mut by = || self.below(2 * distance + 1) - distance as i32;
        let [x, y] = [p[0] + by(), p[1] + by()];
        [x.clamp(-32_768, 32_767), y.clamp(-32_768, 32_767), (p[2] + by()).clamp(0, (1 << 15) - 1)]
    }

    /// A convex polygon around a point, cut into triangles at that point.
    fn fan(&mut self, out: &mut Shape) {
        let centre = self.within(self.half[0], self.half[1]);
        let size = 1 + self.below(200);
        let mut ring = Vec::new();
        for [x, y] in [[2, 0], [2, 1], [1, 2], [0, 2], [-1, 2], [-2, 1], [-2, -1], [-1, -2], [1, -2], [2, -1]] {
            ring.push([centre[0] + size * x, centre[1] + size * y, centre[2]]);
        }
        let first = out.vertices.len() as u32;
        let count = ring.len() as u32;
        out.vertices.push(centre);
        out.vertices.extend(ring);
        out.triangles.extend((0..count).map(|i| [first, first + 1 + i, first + 1 + (i + 1) % count]));
    }
}

/// The placement of a shape whose x and y are sub-pixels about the picture's centre, y downwards, and z its depth over
/// 512.
pub fn flat(picture: Picture) -> Placement {
    // As many clip units a sub-pixel as a factor holds, on the shorter side.
    let w = f64::from((picture.width.min(picture.height) << 16).min(1 << 22));
    let [x, y] = [picture.width, picture.height].map(|side| w / (8.0 * f64::from(side)));
    let matrix = [[x, 0.0, 0.0, 0.0], [0.0, -y, 0.0, 0.0], [0.0, 0.0, w / 32_768.0, 0.0], [0.0, 0.0, 0.0, w]];
    Placement::new(matrix).expect("the entries are small")
}

/// A camera at the origin that looks along z, with a view of 90 degrees across: x to the right, y up, `scale` clip
/// units to the unit, near plane at `near` units. `at` and `size` place a mesh, turned by the `seed`-th rotation.
pub fn seen_from_origin(scale: f64, near: f64, at: [f64; 3], size: f64, seed: u32) -> Placement {
    let q = [0, 1, 2, 3].map(|i| f64::from(random::below(2001, seed, i)) - 1000.0);
    let length = q.iter().map(|c| c * c).sum::<f64>().sqrt().max(1.0);
    let [w, x, y, z] = if seed == 0 { [1.0, 0.0, 0.0, 0.0] } else { q.map(|c| c / length) };
    let turn = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)],
        [2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)],
        [2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)],
    ];
    let row = |axis: usize, minus: f64| {
        let [a, b, c] = turn[axis].map(|f| f * size * scale);
        [a, b, c, (at[axis] - minus) * scale]
    };
    Placement::new([row(0, 0.0), row(1, 0.0), row(2, near), row(2, 0.0)]).expect("the entries are small")
}

/// A bumpy ball of 606 triangles and 305 vertices: 15 rings of 20 vertices and two poles, three triangles divided at a
/// point. The paper's shadow casters have as many triangles.
pub fn ball() -> Shape {
    let mut shape = Shape::default();
    for (ring, step) in (0..15).flat_map(|ring| (0..20).map(move |step| (ring, step))) {
        let (s, c) = libm::sincos(f64::from(ring + 1) * PI / 16.0);
        let (y, x) = libm::sincos(f64::from(step) * PI / 10.0);
        let radius = if (ring + step) % 2 == 0 { 16_000.0 } else { 15_000.0 };
        shape.vertices.push([s * x, s * y, -c].map(|v| (v * radius).floor() as i32));
    }
    let [low, high] = [300, 301];
    shape.vertices.extend([[0, 0, -16_000], [0, 0, 16_000]]);
    for step in 0..20 {
        let next = (step + 1) % 20;
        shape.triangles.push([low, next, step]);
        for ring in 0..14 {
            let [a, b, c, d] = [20 * ring + step, 20 * ring + next, 20 * ring + 20 + next, 20 * ring + 20 + step];
            shape.triangles.extend([[a, b, c], [a, c, d]]);
        }
        shape.triangles.push([high, 280 + step, 280 + next]);
    }
    for divided in 0..3 {
        let [a, b, c] = shape.triangles[divided * 100];
        let sum = |i: usize| [a, b, c].iter().map(|&v| shape.vertices[v as usize][i]).sum::<i32>();
        let middle = [0, 1, 2].map(|i| sum(i) / 3);
        let new = shape.vertices.len() as u32;
        shape.vertices.push(middle);
        shape.triangles[divided * 100] = [a, b, new];
        shape.triangles.extend([[b, c, new], [c, a, new]]);
    }
    shape
}

/// Brings a scene to the device. A binding holds at least one element, so what is empty has one of zeros.
pub fn upload(job: &mut Job, scene: &Scene) -> Mesh {
    let or_one = |words: Vec<u32>| if words.is_empty() { vec![0] } else { words };
    let vertices: Vec<i32> = scene.vertices.iter().flatten().copied().collect();
    let rows: Vec<IVec4> = scene.instances.iter().flatten().copied().collect();
    Mesh {
        vertices: job.slice("vertices", if vertices.is_empty() { &[0] } else { &vertices[..] }),
        vertex_count: scene.vertices.len() as u32,
        indices: job.slice("indices", &or_one(scene.triangles.iter().flatten().copied().collect())),
        triangle_count: scene.triangles.len() as u32,
        rows: job.slice("rows", if rows.is_empty() { &[IVec4::ZERO] } else { &rows[..] }),
        instance_count: scene.instances.len() as u32,
    }
}

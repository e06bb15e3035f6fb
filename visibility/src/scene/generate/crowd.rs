//! Scenes for visibility queries: a crowd of equal balls, and a displaced creature in a hall, as large as the papers'.
//!
//! Engelhardt and Dachsbacher, *Granular Visibility Queries on the GPU*: table 1 has 100 to 500 randomly placed objects
//! of 606 triangles, table 3 a displaced mesh of 7,132 triangles in a static scene of 134,414.

use std::f64::consts::{PI, TAU};

use sightlines_kernels::random;
use sightlines_kernels::raster::meshes::ball;

use super::super::{Affine, Camera, Instance, Lens, Mesh, World};
use crate::vector::{Vector, add, cross, normalize, scale, sub};

/// Most balls of a crowd.
pub const MAX_BALLS: u32 = 2000;

/// Half the side of the crowd's floor.
const FLOOR: f64 = 12.0;

/// So many balls of 606 triangles over a floor, at places and of sizes from a hash, with a camera `view` and a light
/// `light` above: instance 0 is the floor.
pub fn crowd(balls: u32) -> World {
    let shape = ball();
    let ball = Mesh {
        name: "ball".to_owned(),
        vertices: shape.vertices.iter().map(|v| v.map(|c| f64::from(c) / 16_000.0)).collect(),
        triangles: shape.triangles,
        ..Mesh::default()
    };
    let mut floor = Mesh::named("floor");
    floor.vertices([[-FLOOR, 0.0, -FLOOR], [-FLOOR, 0.0, FLOOR], [FLOOR, 0.0, FLOOR], [FLOOR, 0.0, -FLOOR]]);
    floor.quad([0, 1, 2, 3]);
    let unit = |i: u32, which: u32| f64::from(random::word(0xC20D + which, i)) / f64::from(u32::MAX);
    let instance = |i: u32| {
        let size = 0.3 + 0.3 * unit(i, 0);
        let spread = FLOOR - 1.0;
        let at = [spread * (2.0 * unit(i, 1) - 1.0), size + 3.0 * unit(i, 2), spread * (2.0 * unit(i, 3) - 1.0)];
        Instance { name: format!("ball {i}"), mesh: 1, transform: Affine::placed(size, at) }
    };
    let ground = Instance { name: "floor".to_owned(), mesh: 0, transform: Affine::IDENTITY };
    World {
        name: format!("crowd-{balls}"),
        units: "metres",
        meshes: vec![floor, ball],
        instances: std::iter::once(ground).chain((0..balls).map(instance)).collect(),
        cameras: cameras([("view", [0.0, 4.0, 22.0], [0.0, 1.0, 0.0]), ("light", [26.0, 9.0, 3.0], [0.0, 1.0, 0.0])]),
    }
}

fn cameras<const N: usize>(stands: [(&str, Vector, Vector); N]) -> Vec<Camera> {
    let lens = Lens::Perspective { slope: libm::tan(PI / 8.0), near: None };
    let stand = |(name, eye, target): (&str, Vector, Vector)| Camera::look_at(name, eye, target, [0.0, 1.0, 0.0], lens);
    stands.into_iter().filter_map(|s| stand(s).ok()).collect()
}

/// Coarser balls for those of a [`crowd`]: 168 and 48 triangles.
pub fn ball_levels() -> [Mesh; 2] {
    [(7, 12), (3, 8)].map(|(rings, sides)| {
        let mut mesh = Mesh::named(format!("ball of {} triangles", 2 * rings * sides));
        for ring in 0..rings {
            let (s, c) = libm::sincos(PI * f64::from(ring + 1) / f64::from(rings + 1));
            mesh.vertices((0..sides).map(|i| {
                let (y, x) = libm::sincos(TAU * f64::from(i) / f64::from(sides));
                [0.97 * s * x, 0.97 * s * y, -0.97 * c]
            }));
        }
        let [low, high] = [-1.0, 1.0].map(|z| mesh.vertices([[0.0, 0.0, z]]));
        let at = |ring: u32, i: u32| ring * sides + i % sides;
        for i in 0..sides {
            for ring in 0..rings - 1 {
                mesh.quad([at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)]);
            }
            mesh.triangles.extend([[low, at(0, i + 1), at(0, i)], [high, at(rings - 1, i), at(rings - 1, i + 1)]]);
        }
        mesh
    })
}

/// The height field of the creature's skin: waves along all axes, from 0 to 1.
pub fn creature_field([x, y, z]: [f64; 3]) -> f64 {
    0.5 + 0.5 * libm::sin(23.0 * x) * libm::sin(29.0 * y + 1.0) * libm::sin(31.0 * z + 2.0)
}

/// Rings of the creature and vertices of a ring: 2 * 36 * 98 + 2 * 36 triangles.
const RINGS: u32 = 99;
const SIDES: u32 = 36;

/// A creature of 7,128 triangles on the floor of a hall of 134,400, instance 0. Cameras `full`, `partial` and
/// `occluded` see it wholly, between pillars, and from behind a wall.
pub fn creature_in_hall() -> World {
    let mut meshes = vec![creature(), wall(), pillar()];
    meshes[1].name = "wall".to_owned();
    let one = |mesh: usize, name: &str, transform: Affine| Instance { name: name.to_owned(), mesh, transform };
    let turned = |x: Vector, y: Vector, at: Vector| Affine([x, y, cross(x, y), at]);
    let mut instances = vec![one(0, "creature", Affine::placed(1.0, [0.0, 0.45, 0.0]))];
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let back = |v: Vector| scale(v, -1.0);
    // Walls lie in x and y of their own, 20 by 20, with the relief along z, and face inwards.
    instances.push(one(1, "floor", turned(x, back(z), [0.0, 0.0, 0.0])));
    instances.push(one(1, "north", turned(x, y, [0.0, 8.0, -10.0])));
    instances.push(one(1, "south", turned(back(x), y, [0.0, 8.0, 10.0])));
    instances.push(one(1, "west", turned(back(z), y, [-10.0, 8.0, 0.0])));
    instances.push(one(1, "east", turned(z, y, [10.0, 8.0, 0.0])));
    for number in 0..12 {
        let at = [f64::from(number % 6) * 1.5 - 3.75, 0.0, if number < 6 { 3.0 } else { -4.0 }];
        instances.push(one(2, &format!("pillar {number}"), Affine::placed(1.0, at)));
    }
    World {
        name: "hall".to_owned(),
        units: "metres",
        meshes,
        instances,
        cameras: cameras([
            ("full", [0.0, 5.2, 1.2], [0.0, 0.4, 0.0]),
            ("partial", [1.0, 1.6, 7.5], [0.0, 0.5, 0.0]),
            ("occluded", [0.0, 2.0, 14.0], [0.0, 0.5, 0.0]),
        ]),
    }
}

/// A closed tube along a bent line, thick in the middle, pointed at both ends.
fn creature() -> Mesh {
    let mut mesh = Mesh::named("creature");
    let spine = |t: f64| [3.6 * (t - 0.5), 0.12 * libm::sin(3.0 * PI * t), 0.55 * libm::sin(TAU * t)];
    let girth = |t: f64| 0.03 + 0.30 * libm::sin(PI * t) * (0.75 + 0.25 * libm::cos(5.0 * t));
    for ring in 0..RINGS {
        let t = f64::from(ring) / f64::from(RINGS - 1);
        let along = normalize(sub(spine(t + 0.01), spine(t - 0.01)));
        let side = normalize(cross(along, [0.0, 1.0, 0.0]));
        let above = cross(side, along);
        mesh.vertices((0..SIDES).map(|i| {
            let (s, c) = libm::sincos(TAU * f64::from(i) / f64::from(SIDES));
            add(spine(t), add(scale(side, c * girth(t)), scale(above, s * girth(t))))
        }));
    }
    let [tail, head] = [0.0, 1.0].map(|t| mesh.vertices([spine(t)]));
    let at = |ring: u32, i: u32| ring * SIDES + i % SIDES;
    for i in 0..SIDES {
        for ring in 0..RINGS - 1 {
            mesh.quad([at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)]);
        }
        mesh.triangles.push([tail, at(0, i), at(0, i + 1)]);
        mesh.triangles.push([head, at(RINGS - 1, i + 1), at(RINGS - 1, i)]);
    }
    mesh
}

/// Cells of a wall a side: 18,432 triangles.
const CELLS: u32 = 96;

/// A square of 20 by 20 about the origin, with a low relief.
fn wall() -> Mesh {
    let mut mesh = Mesh::named("wall");
    let place = |i: u32| 20.0 * f64::from(i) / f64::from(CELLS) - 10.0;
    let relief = |i: u32, j: u32| f64::from(random::word(j, i) >> 24) * 2e-4;
    mesh.vertices((0..=CELLS).flat_map(|j| (0..=CELLS).map(move |i| [place(i), place(j), relief(i, j)])));
    for (j, i) in (0..CELLS).flat_map(|j| (0..CELLS).map(move |i| (j, i))) {
        let low = j * (CELLS + 1) + i;
        mesh.quad([low, low + 1, low + CELLS + 2, low + CELLS + 1]);
    }
    mesh
}

/// A round column with flutes: 3,520 triangles.
fn pillar() -> Mesh {
    let mut mesh = Mesh::named("pillar");
    let (rings, sides) = (45, 40);
    for ring in 0..rings {
        let y = 5.0 * f64::from(ring) / f64::from(rings - 1);
        mesh.vertices((0..sides).map(|i| {
            let (s, c) = libm::sincos(TAU * f64::from(i) / f64::from(sides));
            let radius = if i % 2 == 0 { 0.34 } else { 0.31 };
            [radius * c, y, radius * s]
        }));
    }
    for (ring, i) in (0..rings - 1).flat_map(|ring| (0..sides).map(move |i| (ring, i))) {
        let at = |ring: u32, i: u32| ring * sides + i % sides;
        mesh.quad([at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)]);
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_as_large_as_the_papers() {
        let hall = creature_in_hall();
        let count = |mesh: usize| hall.meshes[mesh].triangles.len();
        assert_eq!((count(0), hall.triangle_count() - count(0)), (7128, 134_400));
        assert_eq!(hall.cameras.len(), 3);
        let crowd = crowd(500);
        assert_eq!((crowd.instances.len(), crowd.triangle_count()), (501, 500 * 606 + 2));
        assert_eq!(crowd.cameras.len(), 2);
    }
}

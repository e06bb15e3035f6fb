//! Small scenes: boxes, crossing quads, columns.

use crate::scene::Mesh;

const COLUMNS: u32 = 6;
/// Corners of a column's outline: a full turn, one every 22.5 degrees.
const SIDES: u32 = 16;

pub(super) fn cuboid(name: &str, min: [f64; 3], max: [f64; 3]) -> Mesh {
    let mut mesh = Mesh::named(name);
    let side = |bit: usize, axis: usize| if bit >> axis & 1 == 0 { min[axis] } else { max[axis] };
    mesh.vertices((0..8).map(|corner| [side(corner, 0), side(corner, 1), side(corner, 2)]));
    // Bit 0 of a corner is x, bit 1 is y, bit 2 is z; faces turn counter-clockwise as seen from outside.
    for face in [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]] {
        mesh.quad(face);
    }
    mesh
}

pub(super) fn quads() -> Vec<Mesh> {
    let upright = |name: &str, x: f64, z: f64| {
        let mut mesh = Mesh::named(name);
        mesh.vertices([[-x, 0.25, -z], [x, 0.25, z], [x, 1.75, z], [-x, 1.75, -z]]);
        mesh.quad([0, 1, 2, 3]);
        mesh
    };
    vec![upright("along x", 0.75, 0.0), upright("along z", 0.0, 0.75)]
}

pub(super) fn colonnade() -> Vec<Mesh> {
    let length = 2.0 * f64::from(COLUMNS);
    let mut parts = Vec::new();
    for (name, z) in [("front", -1.5), ("back", 1.5)] {
        for number in 0..COLUMNS {
            let x = 2.0 * f64::from(number) + 1.0 - 0.5 * length;
            parts.push(column(&format!("{name} column {}", number + 1), x, z));
        }
        let (left, right) = ([-0.5 * length, 4.0, z - 0.4], [0.5 * length, 4.5, z + 0.4]);
        parts.push(cuboid(&format!("{name} beam"), left, right));
    }
    parts
}

/// A prism from the ground to the beam, closed at both ends.
fn column(name: &str, x: f64, z: f64) -> Mesh {
    let mut mesh = Mesh::named(name);
    let ring = |y: f64| {
        (0..SIDES).map(move |i| {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(SIDES);
            [x + 0.35 * libm::cos(angle), y, z + 0.35 * libm::sin(angle)]
        })
    };
    let (foot, head) = (mesh.vertices(ring(0.0)), mesh.vertices(ring(4.0)));
    for i in 0..SIDES {
        let next = (i + 1) % SIDES;
        mesh.quad([foot + i, head + i, head + next, foot + next]);
    }
    for i in 1..SIDES - 1 {
        mesh.triangles.extend([[foot, foot + i, foot + i + 1], [head, head + i + 1, head + i]]);
    }
    mesh
}

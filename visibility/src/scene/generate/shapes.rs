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

/// Hills and hollows on a square of 8 metres, its texture coordinates those of a map seen from above.
pub(super) fn ground() -> Mesh {
    const CELLS: u32 = 64;
    let mut mesh = Mesh::named("ground");
    let place = |i: u32| f64::from(i) / f64::from(CELLS);
    let height = |x: f64, z: f64| {
        let hills = libm::sin(9.0 * x + 1.0) * libm::sin(11.0 * z) + 0.5 * libm::sin(23.0 * x + 17.0 * z);
        0.55 + 0.35 * hills
    };
    let corners = || (0..=CELLS).flat_map(|row| (0..=CELLS).map(move |column| (place(column), place(row))));
    mesh.vertices(corners().map(|(x, z)| [8.0 * x - 4.0, height(x, z), 8.0 * z - 4.0]));
    let map: Vec<[f64; 2]> = corners().map(|(x, z)| [x, 1.0 - z]).collect();
    for row in 0..CELLS {
        for column in 0..CELLS {
            let first = row * (CELLS + 1) + column;
            mesh.quad([first, first + CELLS + 1, first + CELLS + 2, first + 1]);
        }
    }
    mesh.uvs = mesh.triangles.iter().map(|t| t.map(|vertex| map[vertex as usize])).collect();
    mesh
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

//! An office: desks in rows, as many triangles as the office that papers measure, about 1,700.

use super::shapes::cuboid;
use crate::scene::Mesh;

const ROWS: u32 = 3;
const DESKS: u32 = 4;

/// Least and greatest corners of what a desk and its chair are made of, relative to the middle of the desk on the
/// floor.
const PIECES: [(&str, [f64; 3], [f64; 3]); 12] = [
    ("top", [-0.7, 0.70, -0.35], [0.7, 0.74, 0.35]),
    ("leg", [-0.68, 0.0, -0.33], [-0.63, 0.70, -0.28]),
    ("leg", [0.63, 0.0, -0.33], [0.68, 0.70, -0.28]),
    ("leg", [-0.68, 0.0, 0.28], [-0.63, 0.70, 0.33]),
    ("leg", [0.63, 0.0, 0.28], [0.68, 0.70, 0.33]),
    ("drawers", [0.25, 0.15, -0.30], [0.60, 0.70, 0.30]),
    ("stand", [-0.05, 0.74, -0.18], [0.05, 0.90, -0.14]),
    ("screen", [-0.35, 0.90, -0.18], [0.35, 1.32, -0.14]),
    ("keyboard", [-0.25, 0.74, 0.05], [0.20, 0.76, 0.20]),
    ("seat", [-0.25, 0.44, 0.50], [0.25, 0.50, 0.98]),
    ("back", [-0.24, 0.55, 0.95], [0.24, 1.05, 1.0]),
    ("foot", [-0.04, 0.0, 0.70], [0.04, 0.44, 0.78]),
];

/// Desks side by side, in rows one behind the other.
pub(super) fn desks() -> Vec<Mesh> {
    let desks = (0..ROWS).flat_map(|row| (0..DESKS).map(move |desk| (row, desk)));
    desks
        .flat_map(|(row, desk)| {
            let middle = [2.0 * f64::from(desk) - 3.0, 0.0, 2.2 * f64::from(row) - 2.2];
            PIECES.map(|(name, min, max)| {
                let moved = |corner: [f64; 3]| [0, 1, 2].map(|axis| corner[axis] + middle[axis]);
                cuboid(&format!("desk {} {name}", row * DESKS + desk + 1), moved(min), moved(max))
            })
        })
        .collect()
}

//! A closed mesh of any size: a sphere of rings whose radius waves with the direction.

use crate::scene::{Mesh, Scene};

/// Bumps of two sizes: height, then waves along each axis.
const BUMPS: [(f64, [f64; 3]); 2] = [(0.08, [7.0, 9.0, 8.0]), (0.02, [31.0, 29.0, 37.0])];

/// Most triangles of a bumpy sphere that is asked for by name.
pub const MAX_BUMPY: usize = 2_000_000;

/// A bumpy sphere of about so many triangles (at least 24), its centre two metres above the ground. Every edge belongs
/// to two triangles that run through it in opposite directions.
pub fn bumpy_sphere(triangles: usize) -> Scene {
    // Twice as many segments as rings give 4 r (r - 1) triangles.
    let rings = (2.0_f64.max((0.5 + (0.25 + triangles as f64 / 4.0).sqrt()).round())) as u32;
    let segments = 2 * rings;
    let mut mesh = Mesh::named("bumpy sphere");
    let top = mesh.vertices([point(0.0, 0.0)]);
    let angle = |part: u32, of: u32, turn: f64| turn * f64::from(part) / f64::from(of);
    let half = std::f64::consts::PI;
    for ring in 1..rings {
        mesh.vertices((0..segments).map(|s| point(angle(ring, rings, half), angle(s, segments, 2.0 * half))));
    }
    let bottom = mesh.vertices([point(half, 0.0)]);
    let at = |ring: u32, segment: u32| top + 1 + (ring - 1) * segments + segment % segments;
    for s in 0..segments {
        mesh.triangles.extend([[top, at(1, s + 1), at(1, s)], [bottom, at(rings - 1, s), at(rings - 1, s + 1)]]);
        for ring in 1..rings - 1 {
            mesh.quad([at(ring, s), at(ring, s + 1), at(ring + 1, s + 1), at(ring + 1, s)]);
        }
    }
    Scene { name: "bumpy sphere".to_owned(), units: "metres", parts: vec![mesh] }
}

/// A small ball between two large ones, which do not touch it: all three are bumpy.
pub fn trio() -> Scene {
    let ball = |name: &str, triangles: usize, size: f64, x: f64| {
        let mut mesh = bumpy_sphere(triangles).parts.remove(0);
        mesh.name = name.to_owned();
        mesh.vertices.iter_mut().for_each(|v| *v = [x + size * v[0], size * (v[1] - 2.0), size * v[2]]);
        mesh
    };
    let parts = vec![ball("small", 6000, 0.4, 0.0), ball("left", 12_000, 1.0, -1.6), ball("right", 12_000, 1.0, 1.6)];
    Scene { name: "trio".to_owned(), units: "metres", parts }
}

/// The vertex at an angle from the upward axis and one around it.
fn point(from_top: f64, around: f64) -> [f64; 3] {
    let level = libm::sin(from_top);
    let direction = [level * libm::cos(around), libm::cos(from_top), level * libm::sin(around)];
    let wave = |(height, waves): (f64, [f64; 3])| {
        height * (0..3).map(|axis| libm::sin(waves[axis] * direction[axis] + axis as f64)).product::<f64>()
    };
    let radius = 1.0 + BUMPS.map(wave).iter().sum::<f64>();
    [radius * direction[0], 2.0 + radius * direction[1], radius * direction[2]]
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn the_mesh_is_closed_and_of_the_size_asked_for() {
        for wanted in [24, 12_000, 70_000] {
            let mesh = bumpy_sphere(wanted).parts.remove(0);
            assert!(mesh.triangles.len().abs_diff(wanted) * 50 <= wanted, "{} of {wanted}", mesh.triangles.len());
            let edges = mesh.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
            let directed: HashSet<(u32, u32)> = edges.collect();
            assert_eq!(directed.len(), 3 * mesh.triangles.len(), "an edge runs twice in one direction");
            assert!(directed.iter().all(|&(a, b)| directed.contains(&(b, a))), "an edge is open");
        }
    }

    #[test]
    fn triangles_turn_counter_clockwise_as_seen_from_outside() {
        let mesh = bumpy_sphere(12_000).parts.remove(0);
        let corner = |i: u32| mesh.vertices[i as usize];
        // Six times the signed volume of the cones from the centre.
        let volume = mesh.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|i| {
                let [x, y, z] = corner(i);
                [x, y - 2.0, z]
            });
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        });
        let sphere = 8.0 * std::f64::consts::PI;
        assert!((volume.sum::<f64>() / sphere - 1.0).abs() < 0.05);
    }
}

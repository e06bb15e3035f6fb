//! What light falls on: a scene's vertices with unit normals, and its triangles on the grid.
//!
//! The longest side of the scene's box becomes 32,766 cells of the grid; vertices are rounded to it once, here, and
//! those that fall on one cell share a position, and so their visibility. Normals come from the file or, where it has
//! none, from the triangles around a position, weighted by area. Invariants: every vertex is a corner of a triangle,
//! every normal has a length of at most 2^15 units, and all of it is made in integers and IEEE f64.

use std::collections::HashMap;
use std::ops::Range;

use sightlines_kernels::vertex_visibility::Mesh;

use crate::error::{Place, Result};
use crate::scene::Scene;
use crate::vector::{self, Vector, add, cross, scale, sub};

/// Cells of the longest side of a scene.
const CELLS: f64 = 32_766.0;

/// Units of one in a normal.
const UNIT: f64 = 32_768.0;

/// A scene made ready for ambient occlusion.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Every position once, and triangles of positions.
    pub mesh: Mesh,
    /// Vertices in scene units: those that a triangle uses, part after part.
    pub vertices: Vec<[f64; 3]>,
    /// Normals of the vertices in units of 2^-15.
    pub normals: Vec<[i32; 3]>,
    /// Position of each vertex.
    pub position_of: Vec<u32>,
    /// The scene's parts.
    pub parts: Vec<Part>,
    /// Side of a cell of the grid, in scene units.
    pub cell: f64,
    /// The point of the scene at the origin of the grid.
    pub centre: [f64; 3],
    /// What was found.
    pub findings: Findings,
}

/// A part of the scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its name in the file, or an empty one.
    pub name: String,
    /// Its vertices among the surface's.
    pub vertices: Range<u32>,
    /// Triangles of the surface's vertices.
    pub triangles: Vec<[u32; 3]>,
}

/// What a user should know of a mesh before trusting its shading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Findings {
    /// Vertices without a normal in the file, for which one was computed.
    pub computed_normals: usize,
    /// Edges that do not have as many triangles on one side as on the other: the mesh has a rim or holes there.
    pub open_edges: usize,
    /// Triangles without area on the grid; they hide nothing.
    pub flat: usize,
}

impl Surface {
    /// Snaps a scene to the grid.
    ///
    /// # Errors
    ///
    /// A scene that is a single point.
    pub fn new(scene: &Scene) -> Result<Self> {
        let bounds = scene.bounds();
        let longest = (0..3).map(|axis| bounds.max[axis] - bounds.min[axis]).fold(0.0, f64::max);
        if longest <= 0.0 {
            let remedy = "check the scale of the export";
            return Err(Place::default().element(&*scene.name).error("all its vertices coincide", remedy));
        }
        let cell = longest / CELLS;
        let Gathered { vertices, given, parts } = gather(scene);
        let point = |p: &Vector| sub(*p, bounds.centre).map(|c| libm::rint(c / cell) as i32);
        let points: Vec<[i32; 3]> = vertices.iter().map(point).collect();
        let triangles: Vec<[u32; 3]> = parts.iter().flat_map(|part| part.triangles.iter().copied()).collect();
        let (mesh, position_of) = Mesh::weld(&points, &triangles);
        let around = normals_of_positions(&mesh);
        let computed_normals = given.iter().filter(|n| **n == [0.0; 3]).count();
        let normal = |(given, position): (&Vector, &u32)| {
            let own = *given != [0.0; 3];
            unit(if own { *given } else { around[*position as usize] })
        };
        let normals = given.iter().zip(&position_of).map(normal).collect();
        let findings = Findings { computed_normals, open_edges: open_edges(&mesh), flat: flat(&mesh) };
        Ok(Surface { mesh, vertices, normals, position_of, parts, cell, centre: bounds.centre, findings })
    }

    /// Number of positions.
    pub fn positions(&self) -> u32 {
        self.mesh.vertices.len() as u32
    }

    /// What a direction costs, in a count that is the same on every machine: it visits all positions and triangles.
    pub fn visits(&self) -> u64 {
        u64::from(self.positions()) + self.mesh.triangles.len() as u64
    }

    /// Corners of the box of all positions, in scene units.
    pub fn corners(&self) -> [[f64; 3]; 8] {
        let points = || self.mesh.vertices.iter();
        let range = |axis: usize| [points().map(|p| p[axis]).min(), points().map(|p| p[axis]).max()];
        let sides = [0, 1, 2].map(|axis| range(axis).map(|side| f64::from(side.unwrap_or(0))));
        let corner = |bits: usize| [0, 1, 2].map(|axis| self.centre[axis] + self.cell * sides[axis][bits >> axis & 1]);
        [0, 1, 2, 3, 4, 5, 6, 7].map(corner)
    }

    /// What the occlusion of this surface depends on: positions and triangles.
    pub fn digest(&self) -> [u8; 32] {
        let mut hasher = blake3::Hasher::new();
        hasher.update(&self.positions().to_le_bytes());
        for point in self.mesh.vertices.as_flattened() {
            hasher.update(&point.to_le_bytes());
        }
        for corner in self.mesh.triangles.as_flattened() {
            hasher.update(&corner.to_le_bytes());
        }
        *hasher.finalize().as_bytes()
    }
}

struct Gathered {
    vertices: Vec<Vector>,
    given: Vec<Vector>,
    parts: Vec<Part>,
}

/// The vertices that triangles use, with their parts' normals, or zero.
fn gather(scene: &Scene) -> Gathered {
    let mut all = Gathered { vertices: Vec::new(), given: Vec::new(), parts: Vec::new() };
    for part in &scene.parts {
        let first = all.vertices.len() as u32;
        let mut number = vec![u32::MAX; part.vertices.len()];
        let mut used = |corner: u32| {
            let corner = corner as usize;
            if number[corner] == u32::MAX {
                number[corner] = all.vertices.len() as u32;
                all.vertices.push(part.vertices[corner]);
                all.given.push(part.normals.get(corner).copied().unwrap_or_default());
            }
            number[corner]
        };
        let triangles = part.triangles.iter().map(|t| t.map(&mut used)).collect();
        let vertices = first..all.vertices.len() as u32;
        all.parts.push(Part { name: part.name.clone(), vertices, triangles });
    }
    all
}

/// Sums of the triangles' normals around each position, each as long as twice the triangle's area.
fn normals_of_positions(mesh: &Mesh) -> Vec<Vector> {
    let mut sums = vec![[0.0; 3]; mesh.vertices.len()];
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|corner| mesh.vertices[corner as usize].map(f64::from));
        let normal = cross(sub(b, a), sub(c, a));
        triangle.iter().for_each(|&corner| sums[corner as usize] = add(sums[corner as usize], normal));
    }
    sums
}

/// A normal in units, rounded towards zero so that it does not grow; one along z for a vertex that has none.
fn unit(normal: Vector) -> [i32; 3] {
    let longest = normal.iter().fold(0.0, |most: f64, c| most.max(c.abs()));
    if longest == 0.0 {
        return [0, 0, UNIT as i32];
    }
    // First to a length that neither overflows nor vanishes when it is squared.
    let near_one = scale(normal, 1.0 / longest);
    scale(vector::normalize(near_one), UNIT).map(|c| c as i32)
}

fn open_edges(mesh: &Mesh) -> usize {
    let mut balance: HashMap<(u32, u32), i32> = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for (from, to) in [(a, b), (b, c), (c, a)].into_iter().filter(|(from, to)| from != to) {
            *balance.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
        }
    }
    balance.values().filter(|&&sides| sides != 0).count()
}

fn flat(mesh: &Mesh) -> usize {
    let is_flat = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|corner| mesh.vertices[corner as usize].map(f64::from));
        cross(sub(b, a), sub(c, a)) == [0.0; 3]
    };
    mesh.triangles.iter().filter(is_flat).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene;

    fn tetrahedron() -> scene::Mesh {
        scene::Mesh {
            vertices: vec![[0.0; 3], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [9e9, 0.0, 0.0]],
            triangles: vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
            ..scene::Mesh::default()
        }
    }

    fn scene_of(parts: Vec<scene::Mesh>) -> Scene {
        Scene { name: "test".into(), units: "metres", parts }
    }

    #[test]
    fn the_longest_side_fills_the_grid_and_unused_vertices_are_left_out() {
        let surface = Surface::new(&scene_of(vec![tetrahedron()])).unwrap();
        assert_eq!(surface.vertices.len(), 4);
        assert_eq!(surface.mesh.vertices[0], [-16_383, -8192, -8192]);
        assert_eq!(surface.mesh.vertices[2], [16_383, -8192, -8192]);
        assert_eq!(surface.findings, Findings { computed_normals: 4, open_edges: 0, flat: 0 });
        let length = |n: &[i32; 3]| n.iter().map(|&c| f64::from(c) * f64::from(c)).sum::<f64>().sqrt();
        assert!(surface.normals.iter().all(|n| (32_760.0..=32_768.0).contains(&length(n))));
        assert!(surface.normals[0].iter().all(|&c| c < 0), "outwards at the corner: {:?}", surface.normals[0]);
    }

    #[test]
    fn normals_of_the_file_stand_and_parts_are_welded_to_each_other() {
        let mut with = tetrahedron();
        with.normals = vec![[0.0, 0.0, -3.0]; 5];
        with.normals[1] = [0.0; 3];
        let surface = Surface::new(&scene_of(vec![with, tetrahedron()])).unwrap();
        assert_eq!((surface.vertices.len(), surface.positions(), surface.parts.len()), (8, 4, 2));
        assert_eq!(surface.normals[0], [0, 0, -32_768]);
        assert_eq!(surface.findings.computed_normals, 5);
        assert_eq!(surface.position_of[..4], surface.position_of[4..]);
    }

    #[test]
    fn open_and_flat_triangles_are_counted() {
        let mut open = tetrahedron();
        open.triangles.truncate(3);
        open.triangles.push([0, 1, 1]);
        let findings = Surface::new(&scene_of(vec![open])).unwrap().findings;
        assert_eq!((findings.open_edges, findings.flat), (3, 1));
    }
}

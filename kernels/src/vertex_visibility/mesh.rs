//! Meshes on the grid: vertices welded by position, triangles by number.
//!
//! Invariant: a [`Mesh`] made by [`Mesh::weld`] has every position once, so that vertices that differ in their normals
//! or colours alone share their visibility.

use std::collections::HashMap;

use sightlines_backend::{Error, Result};

use super::oracle::Point;
use crate::grid::XY;

/// Most vertices: coordinates and numbers of all of them in one binding.
pub const MAX_VERTICES: u32 = 1 << 23;

/// Most triangles: nine coordinates of all of them in one binding.
pub const MAX_TRIANGLES: u32 = (1 << 25) / 9;

/// Points of the grid, x, y and z in [-2^14, 2^14), and triangles of them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mesh {
    /// Vertices.
    pub vertices: Vec<Point>,
    /// Corners of every triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A mesh with every position once, in order of their first appearance, and for each of `points` its vertex.
    ///
    /// # Panics
    ///
    /// Where a triangle names a point that is not there.
    pub fn weld(points: &[Point], triangles: &[[u32; 3]]) -> (Mesh, Vec<u32>) {
        let mut known = HashMap::with_capacity(points.len());
        let mut vertices = Vec::new();
        let vertex_of: Vec<u32> = points
            .iter()
            .map(|&point| {
                *known.entry(point).or_insert_with(|| {
                    vertices.push(point);
                    vertices.len() as u32 - 1
                })
            })
            .collect();
        let triangles = triangles.iter().map(|t| t.map(|corner| vertex_of[corner as usize])).collect();
        (Mesh { vertices, triangles }, vertex_of)
    }

    /// Refuses what is not on the grid, names no vertex or is too large.
    pub fn check(&self) -> Result<()> {
        let refuse = |what: String, remedy: &str| Err(Error::refused(what, remedy));
        let count = self.vertices.len();
        if count > MAX_VERTICES as usize || self.triangles.len() > MAX_TRIANGLES as usize {
            let what = format!("a mesh of {count} vertices and {} triangles", self.triangles.len());
            return refuse(what, "use at most 2^23 vertices and 3,728,270 triangles");
        }
        if let Some(point) = self.vertices.iter().find(|p| !p.iter().all(|c| (-XY..XY).contains(c))) {
            return refuse(format!("the vertex {point:?}"), "keep x, y and z in [-16384, 16384)");
        }
        if let Some(t) = self.triangles.iter().find(|t| t.iter().any(|&corner| corner as usize >= count)) {
            return refuse(format!("the triangle {t:?} of {count} vertices"), "name vertices that are there");
        }
        Ok(())
    }

    /// Least and greatest coordinates; the origin without vertices.
    pub fn bounds(&self) -> [Point; 2] {
        let first = self.vertices.first().copied().unwrap_or_default();
        self.vertices.iter().fold([first; 2], |[low, high], p| {
            [[0, 1, 2].map(|i| low[i].min(p[i])), [0, 1, 2].map(|i| high[i].max(p[i]))]
        })
    }

    /// The average share of the mesh's own box that a triangle's box covers, seen along x, y and z.
    pub(super) fn coverage(&self) -> f64 {
        let [low, high] = self.bounds();
        let size = |axis: usize| f64::from((high[axis] - low[axis]).max(1));
        let share = |t: &[u32; 3]| {
            let side = |axis: usize| {
                let c = t.map(|corner| self.vertices[corner as usize][axis]);
                f64::from(c[0].max(c[1]).max(c[2]) - c[0].min(c[1]).min(c[2])) / size(axis)
            };
            let [x, y, z] = [side(0), side(1), side(2)];
            (x * y + y * z + z * x) / 3.0
        };
        self.triangles.iter().map(share).sum::<f64>() / self.triangles.len().max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_positions_become_one_vertex() {
        let points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]];
        let (mesh, vertex_of) = Mesh::weld(&points, &[[0, 1, 2], [3, 5, 4]]);
        assert_eq!(mesh.vertices, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]);
        assert_eq!(mesh.triangles, [[0, 1, 2], [1, 3, 2]]);
        assert_eq!(vertex_of, [0, 1, 2, 1, 2, 3]);
    }

    #[test]
    fn coverage_is_a_share_of_the_box() {
        let mesh = Mesh { vertices: vec![[0, 0, 0], [10, 0, 0], [0, 10, 0], [0, 0, 10]], triangles: vec![[0, 1, 2]] };
        assert!((mesh.coverage() - 1.0 / 3.0).abs() < 1e-12);
        assert_eq!(Mesh::default().coverage(), 0.0);
    }
}

//! The definition: a vertex is occluded iff it is not seen in the map of a direction.
//!
//! The map is a picture by the raster's own oracle, of all triangles from both sides; a vertex is a point of it.

use super::{MapView, Maps};
use crate::light_sphere::oracle::Direction;
use crate::raster::oracle::{Scene, pictures, seen};
use crate::raster::{Faces, Ids};
use crate::vertex_visibility::Mesh;

/// Bits of every vertex for up to 32 directions, the first one lowest.
///
/// # Panics
///
/// Where a map cannot be made.
pub fn words(mesh: &Mesh, directions: &[Direction], maps: Maps) -> Vec<u32> {
    let mut words = vec![0; mesh.vertices.len()];
    for (place, &direction) in directions.iter().enumerate() {
        let map = MapView::new(mesh.bounds(), direction, maps).expect("a map that can be made");
        let scene = Scene {
            vertices: mesh.vertices.clone(),
            triangles: mesh.triangles.clone(),
            instances: vec![map.rows],
            faces: Faces::All,
            ids: Ids { base: 0, step: 1, shift: 31 },
        };
        let [depths, _] = pictures(map.view, std::slice::from_ref(&scene));
        let bits = seen(map.view, &scene, &depths, map.bias);
        for (vertex, word) in words.iter_mut().enumerate() {
            *word |= (bits[vertex / 32] >> (vertex % 32) & 1 ^ 1) << place;
        }
    }
    words
}

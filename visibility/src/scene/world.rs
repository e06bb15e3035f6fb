//! Scenes whose meshes are shared: each mesh once, its instances as transforms, and the cameras of the file.
//!
//! Invariant of a [`World`] that [`load_world`](super::load_world) or a generator gives: every instance has a mesh of
//! the list, transforms and coordinates are finite, and [`World::flatten`] keeps the invariant of scenes.

use std::path::Path;

use super::{Affine, Camera, MAX_COORDINATE, MAX_TRIANGLES, MAX_VERTICES, Mesh, Scene, limit};
use crate::error::{Place, Result};
use crate::vector::Vector;

/// One use of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Name of its node, or of its mesh, or an empty one.
    pub name: String,
    /// The mesh, by its place in the list.
    pub mesh: usize,
    /// From the coordinates of the mesh to those of the scene.
    pub transform: Affine,
}

/// Meshes, their instances, and cameras.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// File name or name of the generator.
    pub name: String,
    /// What a coordinate of 1 means: `metres` where the format says so, else `units of the file`.
    pub units: &'static str,
    /// Every mesh once.
    pub meshes: Vec<Mesh>,
    /// Every use of one.
    pub instances: Vec<Instance>,
    /// The cameras of the file.
    pub cameras: Vec<Camera>,
}

impl World {
    /// Every part of a scene as a mesh of one instance.
    pub fn of(scene: Scene) -> Self {
        let instance =
            |(mesh, part): (usize, &Mesh)| Instance { name: part.name.clone(), mesh, transform: Affine::IDENTITY };
        World {
            name: scene.name,
            units: scene.units,
            instances: scene.parts.iter().enumerate().map(instance).collect(),
            meshes: scene.parts,
            cameras: Vec::new(),
        }
    }

    /// A copy of its mesh for every instance, in the coordinates of the scene; where a transform mirrors, triangles are
    /// turned round, so that their fronts stay in front.
    pub fn flatten(&self) -> Scene {
        let part = |Instance { name, mesh, transform }: &Instance| Mesh {
            name: name.clone(),
            ..self.meshes[*mesh].moved(transform)
        };
        Scene { name: self.name.clone(), units: self.units, parts: self.instances.iter().map(part).collect() }
    }

    /// Number of triangles, instances counted each.
    pub fn triangle_count(&self) -> usize {
        self.instances.iter().map(|i| self.meshes[i.mesh].triangles.len()).sum()
    }

    /// Number of vertices, instances counted each.
    pub fn vertex_count(&self) -> usize {
        self.instances.iter().map(|i| self.meshes[i.mesh].vertices.len()).sum()
    }

    /// The corners of the box of every instance that has a vertex: all of the scene is within them.
    pub fn corners(&self) -> Vec<[Vector; 8]> {
        let boxes: Vec<Option<[Vector; 2]>> = self.meshes.iter().map(extent).collect();
        let corners = |instance: &Instance| {
            let sides = boxes[instance.mesh]?;
            let corner = |bits: usize| [0, 1, 2].map(|axis| sides[bits >> axis & 1][axis]);
            Some([0, 1, 2, 3, 4, 5, 6, 7].map(|bits| instance.transform.apply(corner(bits))))
        };
        self.instances.iter().filter_map(corners).collect()
    }

    /// Holds a world to the invariant of this module, without copies of its meshes.
    pub(crate) fn check(self, path: &Path) -> Result<Self> {
        limit(Place::file(path), "vertices", self.vertex_count(), MAX_VERTICES)?;
        limit(Place::file(path), "triangles", self.triangle_count(), MAX_TRIANGLES)?;
        self.meshes.iter().try_for_each(|mesh| super::check_part(mesh, path))?;
        if self.triangle_count() == 0 {
            return Err(Place::file(path).error("there is no triangle in it", "export a mesh with faces"));
        }
        let far = |corner: &Vector| corner.iter().any(|c| c.is_nan() || c.abs() > MAX_COORDINATE);
        let corners = self.corners();
        if let Some(at) = corners.iter().position(|corners| corners.iter().any(far)) {
            let what = format!("it reaches beyond {MAX_COORDINATE:e}, or its transform is not finite");
            let place = Place::file(path).element(format!("instance {at}"));
            return Err(place.error(what, "choose larger units, or move the mesh to the origin"));
        }
        if corners.as_flattened().windows(2).all(|pair| pair[0] == pair[1]) {
            return Err(Place::file(path).error("all its vertices coincide", "check the scale of the export"));
        }
        Ok(self)
    }
}

/// Least and greatest coordinates of the vertices of a mesh.
pub(crate) fn extent(mesh: &Mesh) -> Option<[Vector; 2]> {
    let first = *mesh.vertices.first()?;
    Some(mesh.vertices.iter().fold([first; 2], |[low, high], v| {
        [[0, 1, 2].map(|axis| low[axis].min(v[axis])), [0, 1, 2].map(|axis| high[axis].max(v[axis]))]
    }))
}

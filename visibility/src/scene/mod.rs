//! Scenes: triangles in named parts, in scene units, from files or from generators.
//!
//! Invariant of every [`Scene`] that [`load()`] or [`generate()`] gives: it has a triangle, every index is in range,
//! every coordinate is finite and within [`MAX_COORDINATE`], and its vertices do not all coincide or all but.
//! Degenerate triangles are kept, for they hide nothing and cost little, and counted, for they hint at a broken export.

mod affine;
pub mod camera;
pub mod frame;
mod generate;
mod gltf;
mod load;
mod motion;
mod obj;
mod ply;
mod polygon;
mod world;

use std::fmt;
use std::path::Path;

use crate::error::{Place, Result};
use crate::vector::{self, Vector, add, cross, scale, sub};

pub use affine::Affine;
pub use camera::{Camera, Lens};
pub use generate::{
    Generator, MAX_BALLS, MAX_BUMPY, ball_levels, bumpy_sphere, creature_field, creature_in_hall, crowd, generate,
    generate_world, trio,
};
pub use gltf::Animated;
pub use load::{load, load_world, read_text};
pub use motion::Motion;
pub use world::{Instance, World};

/// Largest file that is read, in bytes.
pub const MAX_FILE_BYTES: u64 = 2 << 30;
/// Most vertices of a scene, instances counted each.
pub const MAX_VERTICES: usize = 1 << 24;
/// Most triangles of a scene, instances counted each.
pub const MAX_TRIANGLES: usize = 1 << 23;
/// Largest magnitude of a coordinate. Squares and cubes of it are far from overflow.
pub const MAX_COORDINATE: f64 = 1e12;
/// Texture coordinates of a triangle that has none, of a mesh where others have: outside any map.
pub const UNMAPPED: [[f64; 2]; 3] = [[-1.0; 2]; 3];
/// Least radius of a scene, as a share of its distance from the origin.
pub const LEAST_RADIUS: f64 = 1e-9;

/// A named part of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The name that the file gives the part, or an empty one.
    pub name: String,
    /// Corners, in scene units.
    pub vertices: Vec<[f64; 3]>,
    /// A normal of any length for each vertex, zero where the file has none for it; none at all where it has none for
    /// any.
    pub normals: Vec<[f64; 3]>,
    /// Where each triangle's corners are on a texture, u and v; empty if the mesh has no texture coordinates, and
    /// [`UNMAPPED`] for a triangle that has none.
    pub uvs: Vec<[[f64; 2]; 3]>,
    /// Three vertices each.
    pub triangles: Vec<[u32; 3]>,
}

/// The corners of a triangle, the other way round if asked for.
fn turned<T>([a, b, c]: [T; 3], around: bool) -> [T; 3] {
    if around { [a, c, b] } else { [a, b, c] }
}

impl Mesh {
    /// The mesh in other coordinates. Where the map mirrors, triangles are turned round, so that fronts stay in front.
    pub(crate) fn moved(&self, by: &Affine) -> Mesh {
        let mirrors = by.mirrors();
        Mesh {
            name: self.name.clone(),
            vertices: self.vertices.iter().map(|v| by.apply(*v)).collect(),
            triangles: self.triangles.iter().map(|t| turned(*t, mirrors)).collect(),
            normals: self.normals.iter().map(|n| by.normal(*n)).collect(),
            uvs: self.uvs.iter().map(|t| turned(*t, mirrors)).collect(),
        }
    }
}

/// What casts shadows.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// File name or name of the generator.
    pub name: String,
    /// What a coordinate of 1 means: `metres` where the format says so, else `units of the file`.
    pub units: &'static str,
    /// Its parts.
    pub parts: Vec<Mesh>,
}

/// An axis-aligned box with its bounding sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least coordinates.
    pub min: [f64; 3],
    /// Greatest coordinates.
    pub max: [f64; 3],
    /// Centre of the box and of the sphere.
    pub centre: [f64; 3],
    /// Radius of the smallest sphere around the centre that holds every vertex.
    pub radius: f64,
}

impl Scene {
    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.parts.iter().map(|part| part.vertices.len()).sum()
    }

    /// Number of triangles, degenerate ones included.
    pub fn triangle_count(&self) -> usize {
        self.parts.iter().map(|part| part.triangles.len()).sum()
    }

    /// Number of triangles without area.
    pub fn degenerate_count(&self) -> usize {
        self.corners().filter(|&[a, b, c]| cross(sub(b, a), sub(c, a)) == [0.0; 3]).count()
    }

    /// Every triangle by its corners, part after part.
    pub fn triangles(&self) -> Vec<[[f64; 3]; 3]> {
        self.corners().collect()
    }

    /// The box of all vertices that a triangle uses. The scene keeps the invariant of this module.
    pub fn bounds(&self) -> Bounds {
        let (mut min, mut max) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for vertex in self.corners().flatten() {
            for axis in 0..3 {
                min[axis] = min[axis].min(vertex[axis]);
                max[axis] = max[axis].max(vertex[axis]);
            }
        }
        let centre = scale(add(min, max), 0.5);
        let radius = self.corners().flatten().map(|v| vector::length(sub(v, centre))).fold(0.0, f64::max);
        Bounds { min, max, centre, radius }
    }

    fn corners(&self) -> impl Iterator<Item = [Vector; 3]> {
        let corner = |part: &Mesh, index: u32| part.vertices[index as usize];
        self.parts.iter().flat_map(move |part| part.triangles.iter().map(move |t| t.map(|index| corner(part, index))))
    }

    /// Holds a scene to the invariant of this module.
    pub(crate) fn check(self, path: &Path) -> Result<Self> {
        let place = || Place::file(path);
        limit(place(), "vertices", self.vertex_count(), MAX_VERTICES)?;
        limit(place(), "triangles", self.triangle_count(), MAX_TRIANGLES)?;
        self.parts.iter().try_for_each(|part| check_part(part, path))?;
        if self.triangle_count() == 0 {
            return Err(place().error("there is no triangle in it", "export a mesh with faces"));
        }
        let Bounds { min, max, radius, .. } = self.bounds();
        if radius == 0.0 {
            return Err(place().error("all its vertices coincide", "check the scale of the export"));
        }
        let farthest = min.iter().chain(&max).map(|c| c.abs()).fold(0.0, f64::max);
        if radius < LEAST_RADIUS * farthest {
            let what =
                format!("its radius is {radius:e}, and it is {farthest:e} from the origin: rounding has its shape");
            return Err(place().error(what, "move the mesh to the origin, and export it again"));
        }
        Ok(self)
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The shortest digits of f32 are enough to look at.
        let [a, b] = [self.min, self.max].map(|corner| corner.map(|c| c as f32));
        write!(
            f,
            "({:?}, {:?}, {:?}) to ({:?}, {:?}, {:?}), radius {:?}",
            a[0], a[1], a[2], b[0], b[1], b[2], self.radius as f32
        )
    }
}

/// Refuses more than `most` of something.
pub(crate) fn limit(place: Place, what: &str, count: usize, most: usize) -> Result<()> {
    if count <= most {
        return Ok(());
    }
    Err(place.error(format!("{count} {what}, at most {most} are taken"), "simplify the mesh, or split it"))
}

fn check_part(part: &Mesh, path: &Path) -> Result<()> {
    let mesh = if part.name.is_empty() { "mesh".to_owned() } else { format!("mesh `{}`", part.name) };
    let place = |what: &str, index: usize| Place::file(path).element(format!("{mesh}, {what} {}", index + 1));
    for (index, vertex) in part.vertices.iter().enumerate() {
        let [x, y, z] = vertex;
        if vertex.iter().any(|c| !c.is_finite()) {
            let what = format!("the coordinates ({x:?}, {y:?}, {z:?}) are not finite");
            return Err(place("vertex", index).error(what, "repair the mesh where it was made, and export it again"));
        }
        if vertex.iter().any(|c| c.abs() > MAX_COORDINATE) {
            let what = format!("the coordinates ({x:?}, {y:?}, {z:?}) are beyond {MAX_COORDINATE:e}");
            return Err(place("vertex", index).error(what, "choose larger units, or move the mesh to the origin"));
        }
    }
    if !part.normals.is_empty() && part.normals.len() != part.vertices.len() {
        let what = format!("{} normals for {} vertices", part.normals.len(), part.vertices.len());
        return Err(Place::file(path).element(mesh).error(what, "give each vertex a normal, or none"));
    }
    if let Some(index) = part.normals.iter().position(|n| n.iter().any(|c| !c.is_finite() || c.abs() > MAX_COORDINATE))
    {
        let what = format!("the normal {:?} is not finite, or absurdly long", part.normals[index]);
        return Err(place("vertex", index).error(what, "leave the normals out: they are then computed"));
    }
    for (index, triangle) in part.triangles.iter().enumerate() {
        if let Some(bad) = triangle.iter().find(|&&i| i as usize >= part.vertices.len()) {
            let what = format!("vertex {bad} (from 0) is used, and there are {}", part.vertices.len());
            return Err(place("triangle", index).error(what, "the file is damaged: export it again"));
        }
    }
    Ok(())
}

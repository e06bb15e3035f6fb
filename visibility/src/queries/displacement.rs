//! Displacement culling: prisms of a displaced mesh that show no pixel are not extruded.
//!
//! Engelhardt and Dachsbacher, section 4.2 and table 3. Every triangle of the mesh spans a prism up to `height` along
//! the normals of its vertices, and the displaced surface lies in the prisms. A first pass draws a hull that encloses
//! it, the mesh with its vertices moved out by somewhat more than `height`; a prism is extruded where a pixel of the
//! hull is seen within its rectangle on the screen, by a table, or in a tile that the rectangle meets, by the item
//! buffer.

use glam::UVec4;
use sightlines_backend::{Backend, Job};

use super::answer::Run;
use super::{Method, Queries, Spent, Stage, bounds};
use crate::error::Result;
use crate::scene::frame::{Frame, Snapped};
use crate::scene::{Mesh, World};
use crate::vector::{Vector, add, cross, length, scale, sub};

/// How far the hull is out, in heights of the prisms.
const HULL: f64 = 1.1;

/// A mesh to be displaced.
#[derive(Clone, Debug)]
pub struct Displaced {
    /// What the first pass draws.
    pub hull: Mesh,
    /// The displaced surface: `pieces` triangles of each prism after those of the one before.
    pub surface: Mesh,
    /// Triangles of a prism's surface.
    pub pieces: usize,
    /// The six corners of every prism.
    pub prisms: Vec<[[f64; 3]; 6]>,
}

/// Displaces a mesh along its normals by `height` times what `field` says of a point of it, from 0 to 1; each side of a
/// triangle is divided in `steps`.
pub fn displace(mesh: &Mesh, height: f64, steps: u32, field: impl Fn([f64; 3]) -> f64) -> Displaced {
    let normals = normals(mesh);
    let out = |i: u32, by: f64| add(mesh.vertices[i as usize], scale(normals[i as usize], by));
    let hull =
        Mesh { vertices: (0..mesh.vertices.len() as u32).map(|i| out(i, HULL * height)).collect(), ..mesh.clone() };
    let mut surface = Mesh { name: mesh.name.clone(), ..Mesh::default() };
    for triangle in &mesh.triangles {
        let first = surface.vertices.len() as u32;
        for (i, j) in (0..=steps).flat_map(|i| (0..=steps - i).map(move |j| (i, j))) {
            let parts = [steps - i - j, i, j].map(|part| f64::from(part) / f64::from(steps));
            let mix =
                |of: &[Vector]| (0..3).fold([0.0; 3], |sum, k| add(sum, scale(of[triangle[k] as usize], parts[k])));
            let base = mix(&mesh.vertices);
            surface.vertices.push(add(base, scale(mix(&normals), height * field(base).clamp(0.0, 1.0))));
        }
        // Row i has steps + 1 - i vertices.
        let at = |i: u32, j: u32| first + i * (steps + 1) - i * i.saturating_sub(1) / 2 + j;
        for (i, j) in (0..steps).flat_map(|i| (0..steps - i).map(move |j| (i, j))) {
            surface.triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
            if i + j + 1 < steps {
                surface.triangles.push([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    let prism = |t: &[u32; 3]| [0, 1, 2, 3, 4, 5].map(|k| out(t[k % 3], if k < 3 { 0.0 } else { height }));
    let prisms = mesh.triangles.iter().map(prism).collect();
    Displaced { hull, surface, pieces: (steps * steps) as usize, prisms }
}

/// Unit normals of vertices, weighted by the areas around them.
fn normals(mesh: &Mesh) -> Vec<Vector> {
    let mut sums = vec![[0.0; 3]; mesh.vertices.len()];
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|i| mesh.vertices[i as usize]);
        let normal = cross(sub(b, a), sub(c, a));
        t.iter().for_each(|i| sums[*i as usize] = add(sums[*i as usize], normal));
    }
    sums.into_iter().map(|n| if length(n) > 0.0 { scale(n, 1.0 / length(n)) } else { n }).collect()
}

/// A scene in which one instance is displaced.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The scene with the hull in place of the mesh.
    pub hulled: World,
    /// The scene with the displaced surface.
    pub full: World,
    /// The displaced mesh.
    pub displaced: Displaced,
    /// The instance.
    pub instance: usize,
}

/// Which prisms are extruded, and what finding that took.
#[derive(Clone, Debug)]
pub struct Culled {
    /// Whether each prism is extruded.
    pub kept: Vec<bool>,
    /// Drawing the first pass.
    pub draw: Spent,
    /// Counting.
    pub count: Spent,
}

impl Scene {
    /// Displaces the mesh of one instance, which no other uses.
    pub fn new(world: &World, instance: usize, displaced: Displaced) -> Self {
        let with = |mesh: &Mesh| {
            let mut world = world.clone();
            world.meshes[world.instances[instance].mesh] = mesh.clone();
            world
        };
        Scene { hulled: with(&displaced.hull), full: with(&displaced.surface), displaced, instance }
    }

    /// Points around all that either pass draws.
    pub fn points(&self) -> Vec<[f64; 3]> {
        [self.hulled.corners(), self.full.corners()].concat().into_flattened()
    }

    /// The scene with the surface of the kept prisms alone. Vertices stay, so that their grid does.
    pub fn extruded(&self, kept: &[bool]) -> World {
        let mut world = self.full.clone();
        let surface = &mut world.meshes[self.full.instances[self.instance].mesh];
        let pieces = surface.triangles.chunks(self.displaced.pieces).zip(kept).filter(|(_, kept)| **kept);
        surface.triangles = pieces.flat_map(|(triangles, _)| triangles.iter().copied()).collect();
        world
    }

    /// Culls prisms by the counts of `method`, in 2^depth by 2^depth tiles where it is the item buffer.
    ///
    /// # Errors
    ///
    /// Those of a query.
    pub fn cull(&self, backend: &dyn Backend, frame: Frame, method: Method, depth: u32) -> Result<Culled> {
        let queries = Queries::new()?;
        let stage = Stage::of(&self.hulled, frame)?;
        let Some(item) = stage.items.iter().position(|item| item.instance == self.instance) else {
            let kept = vec![false; self.displaced.prisms.len()];
            return Ok(Culled { kept, draw: Spent::default(), count: Spent::default() });
        };
        let rectangles = self.rectangles(frame)?;
        let mut job = Job::new();
        let drawn = stage.record(&queries.raster, &mut job)?;
        job.cut();
        let boundary = job.recordings.len() - 1;
        let words = match method {
            Method::Sat { .. } => queries.record_rectangles(&mut job, &drawn, item as u32, &rectangles)?,
            Method::Hib { .. } => queries.record(&mut job, &stage, &drawn, method, depth)?.tiles,
        };
        let mut run = Run::open(backend, &job)?;
        let draw = run.submit(&job, 0..boundary, &mut |_| ())?;
        let count = run.submit(&job, boundary..job.recordings.len(), &mut |_| ())?;
        let words = run.read(words)?;
        let side = 1_u32 << depth;
        let [width, height] = [frame.view.picture.width, frame.view.picture.height];
        let tiles = |r: &UVec4| {
            let rows = r.y * side / height..=(r.w - 1) * side / height;
            let columns = r.x * side / width..=(r.z - 1) * side / width;
            rows.flat_map(move |y| columns.clone().map(move |x| (y * side + x) as usize))
        };
        let first = item << (2 * depth);
        let kept = |(number, r): (usize, &UVec4)| match method {
            _ if r.x >= r.z || r.y >= r.w => false,
            Method::Sat { .. } => words[number] > 0,
            Method::Hib { .. } => tiles(r).any(|tile| words[first + tile] > 0),
        };
        Ok(Culled { kept: rectangles.iter().enumerate().map(kept).collect(), draw, count })
    }

    /// The rectangle of every prism on the screen, a pixel wider on each side for what the grids round.
    fn rectangles(&self, frame: Frame) -> Result<Vec<UVec4>> {
        let transform = self.full.instances[self.instance].transform;
        let corners = self.displaced.prisms.as_flattened().to_vec();
        let Snapped { vertices, to_mesh } = Snapped::of(&Mesh { vertices: corners, ..Mesh::default() });
        let placement = frame.placement(&transform.then(&to_mesh))?;
        let picture = frame.view.picture;
        let wider = |r: UVec4| {
            UVec4::new(
                r.x.saturating_sub(1),
                r.y.saturating_sub(1),
                (r.z + 1).min(picture.width),
                (r.w + 1).min(picture.height),
            )
        };
        let rectangle = |prism: &[[i32; 3]]| {
            let found = bounds::of_instance(frame.view, &placement, prism);
            if found.is_empty() { found.rectangle } else { wider(found.rectangle) }
        };
        Ok(vertices.chunks(6).map(rectangle).collect())
    }
}

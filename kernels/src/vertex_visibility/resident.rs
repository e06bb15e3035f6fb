//! A mesh on the device: vertices axis by axis, and triangles cut into parts of few rows of bins.
//!
//! Invariant: whatever the direction, the parts of a triangle cover every row of bins that its box meets, each row
//! once, and none has more than [`Resident::rows`] rows.

use sightlines_backend::host::Buffer;
use sightlines_backend::{Error, Job, Result};

use super::mesh::{MAX_TRIANGLES, Mesh};
use super::oracle::Point;

/// Rows of a part, unless parts would then be far more than triangles.
const ROWS: u32 = 16;

/// Most rows of bins, as a logarithm: bins fill no more than a quarter of a binding.
const MAX_ROW_BITS: u32 = 11;

/// A mesh on the device.
#[derive(Clone, Copy, Debug)]
pub struct Resident {
    pub(super) vertices: Buffer<[i32]>,
    pub(super) corners: Buffer<[i32]>,
    pub(super) numbers: Buffer<[u32]>,
    /// Number of vertices.
    pub(super) positions: u32,
    /// Number of parts.
    pub(super) parts: u32,
    /// Rows of bins, as a logarithm.
    pub(super) row_bits: u32,
    /// Most rows of a part.
    pub(super) rows: u32,
    pub(super) bounds: [Point; 2],
    pub(super) coverage: f64,
}

impl Resident {
    /// Uploads a mesh.
    pub fn upload(job: &mut Job, mesh: &Mesh) -> Result<Self> {
        let all: Vec<u32> = (0..mesh.vertices.len() as u32).collect();
        Self::upload_some(job, mesh, &all)
    }

    /// Uploads a mesh of which only the vertices `chosen`, each at most once, are asked about, in that order: vertex v
    /// of the bits is vertex `chosen[v]` of the mesh. All triangles occlude.
    pub fn upload_some(job: &mut Job, mesh: &Mesh, chosen: &[u32]) -> Result<Self> {
        mesh.check()?;
        let places = places(mesh, chosen)?;
        let row_bits = (chosen.len().max(4).ilog2() / 2 + 1).min(MAX_ROW_BITS);
        let (rows, parts) = parts(mesh, 1 << row_bits);
        let points: Vec<Point> = chosen.iter().map(|&vertex| mesh.vertices[vertex as usize]).collect();
        let triangle = |part: &(u32, u32)| mesh.triangles[part.0 as usize];
        let corner =
            |k: usize| -> Vec<Point> { parts.iter().map(|p| mesh.vertices[triangle(p)[k] as usize]).collect() };
        let corners: Vec<i32> = (0..3).flat_map(|k| axes(&corner(k))).collect();
        let corner_places = |part: &(u32, u32)| triangle(part).map(|corner| places[corner as usize]);
        let numbers: Vec<u32> = (0..3)
            .flat_map(|k| parts.iter().map(move |part| corner_places(part)[k]))
            .chain(parts.iter().map(|part| part.1))
            .collect();
        Ok(Resident {
            vertices: job.slice("vertices", &or_zero(axes(&points))),
            corners: job.slice("corners", &or_zero(corners)),
            numbers: job.slice("corner numbers", &or_zero(numbers)),
            positions: chosen.len() as u32,
            parts: parts.len() as u32,
            row_bits,
            rows,
            bounds: mesh.bounds(),
            coverage: mesh.coverage(),
        })
    }

    /// Number of vertices.
    pub fn vertices(&self) -> u32 {
        self.positions
    }
}

/// For each vertex its place among the chosen ones; `u32::MAX`, a number that no vertex has, where it is not among
/// them.
fn places(mesh: &Mesh, chosen: &[u32]) -> Result<Vec<u32>> {
    let mut places = vec![u32::MAX; mesh.vertices.len()];
    for (place, &vertex) in (0..).zip(chosen) {
        match places.get_mut(vertex as usize) {
            Some(free) if *free == u32::MAX => *free = place,
            _ => {
                let what = format!("vertex {vertex} of {} is asked about", mesh.vertices.len());
                return Err(Error::refused(what, "choose vertices that are there, each at most once"));
            }
        }
    }
    Ok(places)
}

/// All x, then all y, then all z.
fn axes(points: &[Point]) -> Vec<i32> {
    (0..3).flat_map(|axis| points.iter().map(move |p| p[axis])).collect()
}

/// A binding holds at least one element.
fn or_zero<T: Default>(words: Vec<T>) -> Vec<T> {
    if words.is_empty() { vec![T::default()] } else { words }
}

/// Rows of a part, and the parts: triangle, and number within it.
fn parts(mesh: &Mesh, all_rows: u32) -> (u32, Vec<(u32, u32)>) {
    let box_of_all = mesh.bounds();
    let bounds: Vec<u32> = mesh.triangles.iter().map(|t| most_rows(mesh, box_of_all, t, all_rows)).collect();
    let most = (2 * bounds.len() + 4096).min(MAX_TRIANGLES as usize);
    let mut rows = ROWS;
    while bounds.iter().map(|bound| bound.div_ceil(rows) as usize).sum::<usize>() > most {
        rows *= 2;
    }
    let parts =
        (0..).zip(&bounds).flat_map(|(triangle, &bound)| (0..bound.div_ceil(rows)).map(move |part| (triangle, part)));
    (rows, parts.collect())
}

/// Rows of bins that a triangle's box meets at most, towards any direction. Along Y = v w' - w v' for a direction (u',
/// v', w') the box has w' dv + |v'| dw, and the mesh the same of its own box; so the share of the rows is at most the
/// larger of the shares of dv and dw.
fn most_rows(mesh: &Mesh, [low, high]: [Point; 2], triangle: &[u32; 3], all_rows: u32) -> u32 {
    let share = |axis: usize| {
        let c = triangle.map(|corner| mesh.vertices[corner as usize][axis]);
        let size = (c[0].max(c[1]).max(c[2]) - c[0].min(c[1]).min(c[2])) as u32;
        u64::from(all_rows * size).div_ceil(u64::from((high[axis] - low[axis]).max(1) as u32))
    };
    2 + share(0).max(share(1)).max(share(2)) as u32
}

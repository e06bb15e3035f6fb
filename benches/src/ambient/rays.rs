//! The rays of ambient occlusion by Embree: from every vertex towards every direction, or those above its tangent
//! plane.
//!
//! Embree has no rule against self-hits: that a triangle at its own vertex does not count is left to the bias, and f32
//! decides near edges and near the bias. So answers differ in few rays, and each that is looked at is judged by the
//! definition.

use std::path::Path;

use serde::{Deserialize, Serialize};
use sightlines_kernels::light_sphere::oracle::Direction;
use sightlines_kernels::vertex_visibility::oracle::is_occluded;
use sightlines_visibility::ambient::{Sphere, Surface};

use crate::embree::{self, JUDGED, Times};
use crate::error::{Error, Result};

/// What Embree took, and how its answers compare.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Traced {
    /// Whether only rays above the tangent plane were traced: those that light a vertex.
    pub above: bool,
    /// Times.
    #[serde(flatten)]
    pub times: Times,
    /// Differing rays.
    pub differing: Differing,
}

/// Rays that Embree answers differently.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Differing {
    /// Their number.
    pub rays: u64,
    /// Their share of all that were traced.
    pub share: f64,
    /// How many were judged, evenly spread over all of them.
    pub judged: u64,
    /// How many of those the definition answers as we do: all, or we are wrong.
    pub ours_right: u64,
}

impl Traced {
    /// What is wrong with our bits, if anything is.
    pub fn unexplained(&self) -> Option<String> {
        let Differing { judged, ours_right, .. } = self.differing;
        let wrong = judged - ours_right;
        (wrong > 0).then(|| format!("{wrong} of {judged} rays that Embree answers differently are wrong in our matrix"))
    }
}

/// Traces the rays of a surface `runs` times with `program`, its files beside it, and holds the answers against the
/// `ours`.
pub fn trace(
    program: &Path,
    (surface, sphere, bias): (&Surface, Sphere, u32),
    ours: &[u32],
    above: bool,
    runs: usize,
) -> Result<Traced> {
    let rays = Rays { surface, normals: normals(surface), directions: sphere.directions(), above, bias };
    let folder = program.parent().unwrap_or(Path::new("."));
    let (times, theirs) = embree::time(program, folder, &rays.words(), runs)?;
    let differing = rays.compare(ours, &theirs)?;
    if rays.count() != times.rays {
        return Err(Error::Measurement(format!("Embree traced {} rays, expected {}", times.rays, rays.count())));
    }
    Ok(Traced { above, times, differing })
}

/// Normals of the positions.
fn normals(surface: &Surface) -> Vec<[i32; 3]> {
    let mut normals = vec![[0; 3]; surface.mesh.vertices.len()];
    for (position, normal) in surface.position_of.iter().zip(&surface.normals) {
        normals[*position as usize] = *normal;
    }
    normals
}

struct Rays<'a> {
    surface: &'a Surface,
    normals: Vec<[i32; 3]>,
    directions: Vec<Direction>,
    above: bool,
    bias: u32,
}

impl Rays<'_> {
    /// The trace file, as `benches/embree/ambient.cpp` describes it.
    fn words(&self) -> Vec<u32> {
        let mesh = &self.surface.mesh;
        let corners = |t: &[u32; 3]| t.map(|corner| mesh.vertices[corner as usize]);
        let mut words = embree::head(1, &mesh.triangles.iter().map(corners).collect::<Vec<_>>());
        words.extend([self.above.into(), self.bias, mesh.vertices.len() as u32]);
        let vertices = mesh.vertices.iter().zip(&self.normals);
        words.extend(vertices.flat_map(|(point, normal)| [*point, *normal]).flatten().map(|c| c as u32));
        words.push(self.directions.len() as u32);
        words.extend(self.directions.iter().flatten().map(|c| *c as u32));
        words
    }

    fn is_traced(&self, vertex: usize, direction: Direction) -> bool {
        let normal = self.normals[vertex];
        let cosine: i64 = (0..3).map(|axis| i64::from(normal[axis]) * i64::from(direction[axis])).sum();
        !self.above || cosine > 0
    }

    /// Bits of the rays that are traced: directions `32 row` and on, from one vertex.
    fn traced(&self, row: usize, vertex: usize) -> u32 {
        let directions = self.directions.iter().skip(32 * row).take(32).enumerate();
        directions.map(|(bit, &direction)| u32::from(self.is_traced(vertex, direction)) << bit).sum()
    }

    fn count(&self) -> u64 {
        let (rows, vertices) = (self.directions.len().div_ceil(32), self.normals.len());
        let word = |row: usize| (0..vertices).map(move |vertex| u64::from(self.traced(row, vertex).count_ones()));
        (0..rows).flat_map(word).sum()
    }

    /// Counts and judges the traced rays of which the two answers differ.
    fn compare(&self, ours: &[u32], theirs: &[u32]) -> Result<Differing> {
        let vertices = self.normals.len();
        if theirs.len() != ours.len() {
            return Err(Error::Measurement(format!("{} words of answers, expected {}", theirs.len(), ours.len())));
        }
        let mut rays = Vec::new();
        for (at, (ours, theirs)) in ours.iter().zip(theirs).enumerate().filter(|(_, (a, b))| a != b) {
            let (row, vertex) = (at / vertices, at % vertices);
            let differing = (ours ^ theirs) & self.traced(row, vertex);
            let bits = (0..32).filter(|bit| differing >> bit & 1 == 1);
            rays.extend(bits.map(|bit| (vertex as u32, 32 * row + bit, ours >> bit & 1 == 1)));
        }
        let count = rays.len() as u64;
        let mut differing =
            Differing { rays: count, share: count as f64 / self.count() as f64, ..Differing::default() };
        for &(vertex, direction, ours) in rays.iter().step_by(rays.len().div_ceil(JUDGED).max(1)) {
            let right = is_occluded(&self.surface.mesh, vertex, self.directions[direction], self.bias) == ours;
            differing.judged += 1;
            differing.ours_right += u64::from(right);
        }
        Ok(differing)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Size;
    use super::*;

    /// Bits of every vertex, by the definition, and the rays.
    fn defined(surface: &Surface, above: bool) -> (Rays<'_>, Vec<u32>) {
        let directions = Sphere::Octahedron { level: 1 }.directions();
        let rays = Rays { surface, normals: normals(surface), directions, above, bias: 1 };
        let set = |vertex: usize| {
            let directions = rays.directions.iter().enumerate();
            let bit =
                |(bit, &d): (usize, &Direction)| u32::from(is_occluded(&surface.mesh, vertex as u32, d, 1)) << bit;
            directions.map(bit).sum()
        };
        let words = (0..surface.mesh.vertices.len()).map(set).collect();
        (rays, words)
    }

    #[test]
    fn equal_answers_differ_nowhere_and_a_flipped_bit_is_found_and_judged() {
        let surface = Size { subdivision: 4, level: 1, runs: 0 }.surface().unwrap();
        let (rays, ours) = defined(&surface, false);
        assert_eq!((rays.count(), ours.len()), (66 * 18, 66));
        assert_eq!(rays.compare(&ours, &ours).unwrap(), Differing::default());
        let mut theirs = ours.clone();
        theirs[20] ^= 1 << 7;
        let share = 1.0 / (66.0 * 18.0);
        let one = Differing { rays: 1, share, judged: 1, ours_right: 1 };
        assert_eq!(rays.compare(&ours, &theirs).unwrap(), one);
        assert_eq!(rays.compare(&theirs, &ours).unwrap(), Differing { ours_right: 0, ..one }, "ours is wrong");
        assert!(rays.compare(&ours, &theirs[1..]).is_err());
    }

    #[test]
    fn below_the_tangent_plane_nothing_is_traced() {
        let surface = Size { subdivision: 4, level: 1, runs: 0 }.surface().unwrap();
        let (rays, ours) = defined(&surface, true);
        assert!((66 * 18 * 2 / 5..=66 * 18 / 2).contains(&rays.count()), "{}", rays.count());
        let inverted: Vec<u32> = ours.iter().map(|word| !word).collect();
        let differing = rays.compare(&ours, &inverted).unwrap();
        assert_eq!((differing.rays, differing.judged), (rays.count(), differing.ours_right));
        assert_eq!(rays.words().len(), 4 + 9 * surface.mesh.triangles.len() + 3 + 6 * 66 + 1 + 3 * 18);
    }
}

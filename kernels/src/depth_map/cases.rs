//! Maps of closed meshes, of vertices alone and of more than a word of directions; errors against the exact answer,
//! which fall as the maps grow.

use rayon::prelude::*;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{DepthMap, Maps, oracle};
use crate::light_sphere::oracle::{Direction, octahedron};
use crate::vertex_visibility::{Mesh, Resident, VertexVisibility, octasphere, oracle as exact, words};

/// Two pixels: surfaces of up to 63 degrees do not shadow themselves.
const BIAS: u32 = 512;

pub(super) fn all() -> Vec<Case> {
    vec![
        bits("nothing", Mesh::default, level(0), 16),
        bits("vertices_alone", || Mesh { triangles: Vec::new(), ..bumpy(3) }, level(0), 16),
        bits("one_word", || bumpy(6), level(1), 33),
        bits("three_words", || bumpy(5), level(2), 24),
        errors("errors_of_64_to_512", measured, some(), &SIDES),
    ]
}

fn level(level: u32) -> Vec<Direction> {
    octahedron(level).into_iter().map(|(d, _)| d).collect()
}

/// A closed mesh with hills that hide one another.
fn bumpy(n: i32) -> Mesh {
    octasphere(n, |[x, y, z]| 10_000.0 + 3000.0 * (libm::sin(5.0 * x + y) + libm::sin(4.0 * y - 2.0 * z) * z))
}

/// What errors are counted of: 786 vertices, six directions, four sizes of maps.
const SIDES: [u32; 4] = [64, 128, 256, 512];

fn measured() -> Mesh {
    bumpy(14)
}

fn some() -> Vec<Direction> {
    level(1).split_off(12)
}

fn rows(directions: &[Direction], row: impl Fn(&[Direction]) -> Vec<u32> + Sync + Send) -> Vec<u32> {
    directions.par_chunks(32).flat_map_iter(row).collect()
}

fn bits(name: &str, mesh: fn() -> Mesh, directions: Vec<Direction>, side: u32) -> Case {
    let maps = Maps { side, bias: BIAS };
    let lights = directions.clone();
    let job = move || {
        let (mut job, mesh) = (Job::new(), mesh());
        let words = words(mesh.vertices.len() as u32, lights.len() as u32);
        // One word past the bits shows that nothing is written there.
        let occluded = job.zeroed("occluded", words + 1);
        DepthMap::new()?.record(&mut job, &mesh, &lights, maps, occluded)?;
        job.read("occluded", occluded.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let mesh = mesh();
        let bits = rows(&directions, |row| oracle::words(&mesh, row, maps));
        vec![Expected::Whole(bits.into_iter().chain([0]).collect())]
    };
    Case::new(name, Size::Small, job, expected).probes([0])
}

fn errors_job(mesh: &Mesh, directions: &[Direction], sides: &[u32]) -> Result<Job> {
    let mut job = Job::new();
    let (exact, maps) = (VertexVisibility::new()?, DepthMap::new()?);
    let count = words(mesh.vertices.len() as u32, directions.len() as u32);
    let resident = Resident::upload(&mut job, mesh)?;
    let truth = job.zeroed("exact bits", count);
    exact.record(&mut job, &resident, (0, directions), 0, truth)?;
    for &side in sides {
        let occluded = job.zeroed(format!("bits of {side}"), count);
        maps.record(&mut job, mesh, directions, Maps { side, bias: BIAS }, occluded)?;
        let differing = job.zeroed("differing bits", 1);
        maps.record_differ(&mut job, count as u32, [truth, occluded], differing)?;
        job.read(format!("differing_{side}"), differing.id());
    }
    Ok(job)
}

fn errors(name: &str, mesh: fn() -> Mesh, directions: Vec<Direction>, sides: &'static [u32]) -> Case {
    let lights = directions.clone();
    let job = move || errors_job(&mesh(), &lights, sides);
    let expected =
        move |_: &_| differing(&mesh(), &directions, sides).into_iter().map(|n| Expected::Whole(vec![n])).collect();
    Case::new(name, Size::Real, job, expected).probes([0])
}

/// Bits that maps of each side get wrong, by both oracles.
fn differing(mesh: &Mesh, directions: &[Direction], sides: &[u32]) -> Vec<u32> {
    let vertices = 0..mesh.vertices.len() as u32;
    let truth = rows(directions, |row| vertices.clone().map(|v| exact::word(mesh, v, row, 0)).collect());
    let wrong = |&side: &u32| {
        let bits = rows(directions, |row| oracle::words(mesh, row, Maps { side, bias: BIAS }));
        bits.iter().zip(&truth).map(|(a, b)| (a ^ b).count_ones()).sum()
    };
    sides.iter().map(wrong).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_fall_as_maps_grow() {
        let mesh = measured();
        let wrong = differing(&mesh, &some(), &SIDES);
        assert!(wrong.is_sorted_by(|a, b| a > b), "{wrong:?}");
        let share = f64::from(wrong[3]) / (mesh.vertices.len() as f64 * 6.0);
        assert!(wrong[3] > 0 && share < 0.02, "{wrong:?}: {share}");
    }
}

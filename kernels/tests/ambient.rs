//! Vertex visibility against what is known otherwise: the occlusion of a wall, blocks of directions; and what is
//! refused.

use glam::{IVec4, UVec4};
use sightlines_backend::{Backend, ErrorKind, Job, Result};
use sightlines_backend_cpu::CpuBackend;
use sightlines_kernels::depth_map::{DepthMap, Maps};
use sightlines_kernels::illumination::{Illumination, Surface};
use sightlines_kernels::light_sphere::oracle::{Direction, octahedron};
use sightlines_kernels::light_sphere::{MAX_LEVEL, count, weights};
use sightlines_kernels::vertex_visibility::{Mesh, Resident, VertexVisibility, octasphere, words};

fn lights(level: u32) -> Vec<Direction> {
    octahedron(level).into_iter().map(|(d, _)| d).collect()
}

fn words_of(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
}

/// The bits of a mesh, recorded in blocks of so many directions.
fn bits(mesh: &Mesh, directions: &[Direction], block: usize) -> Vec<u32> {
    let mut job = Job::new();
    let kernel = VertexVisibility::new().expect("it compiles");
    let resident = Resident::upload(&mut job, mesh).expect("a mesh of the grid");
    let occluded = job.zeroed("occluded", words(resident.vertices(), directions.len() as u32));
    for (number, block_of) in (0..).zip(directions.chunks(block)) {
        let numbered = (number * block as u32, block_of);
        kernel.record(&mut job, &resident, numbered, 0, occluded).expect("a block that fits");
    }
    job.read("occluded", occluded.id());
    let outputs = CpuBackend::new(sightlines_backend_cpu::Config::default()).run(&job).expect("it runs");
    words_of(&outputs[0])
}

/// Before an endless wall of height h, at distance d, a floor loses A = (1 - 1 / sqrt(1 + k^2)) / 2 of its light, k = h
/// / d. The directions of level s are 90 / 2^s degrees apart, so the wall's upper edge is off by half of that at most,
/// all along.
#[test]
fn a_wall_takes_its_share_of_the_light_at_every_level() {
    const HEIGHT: i32 = 96;
    let far = 16_383;
    // x is odd to the lattice, so that no direction runs along the wall.
    let wall = [[0, -far, -1], [0, far, -1], [0, far, HEIGHT], [0, -far, HEIGHT]];
    let distances = [24, 48, 96, 192, 384, 768];
    let vertices = wall.into_iter().chain(distances.map(|d| [-d, 1, 0])).collect();
    let mesh = Mesh { vertices, triangles: vec![[0, 1, 2], [0, 2, 3]] };
    let (all, stride) = (lights(MAX_LEVEL), mesh.vertices.len());
    let occluded = bits(&mesh, &all, all.len());
    for level in 0..=MAX_LEVEL {
        let weights = weights(level);
        for (place, distance) in distances.into_iter().enumerate() {
            let (mut hidden, mut whole) = (0.0, 0.0);
            for (j, direction) in all[..count(level) as usize].iter().enumerate() {
                let d = direction.map(f64::from);
                let cosine = d[2].max(0.0) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
                let light = cosine * f64::from(weights[j]);
                let bit = occluded[j / 32 * stride + 4 + place] >> (j % 32) & 1;
                whole += light;
                hidden += light * f64::from(bit);
            }
            let k = f64::from(HEIGHT) / f64::from(distance);
            let wanted = 0.5 * (1.0 - 1.0 / (1.0 + k * k).sqrt());
            let bound = 0.5 * std::f64::consts::FRAC_PI_4 / f64::from(1 << level);
            assert!((hidden / whole - wanted).abs() < bound, "level {level}, k {k}: {}, not {wanted}", hidden / whole);
        }
    }
}

#[test]
fn blocks_of_directions_have_the_bits_of_the_whole() {
    let mesh = octasphere(9, |[x, y, z]| 8000.0 + 3000.0 * (x * y - z * x));
    let all = lights(3);
    let whole = bits(&mesh, &all, all.len());
    assert!(whole.iter().any(|word| !matches!(word.count_ones(), 0 | 32)));
    for block in [2, 6, 32, 46, 96, 256] {
        assert_eq!(bits(&mesh, &all, block), whole, "blocks of {block}");
    }
}

#[track_caller]
fn refused<T>(result: Result<T>, number: &str) {
    match result.err().expect("it must be refused").kind() {
        ErrorKind::Refused { what, remedy } => {
            assert!(what.contains(number), "`{what}` does not name {number}");
            assert!(!remedy.is_empty());
        }
        other => panic!("not a refusal: {other}"),
    }
}

#[test]
fn meshes_off_the_grid_or_without_their_corners() {
    let mut job = Job::new();
    let mut upload = |vertices: Vec<[i32; 3]>, triangles: Vec<[u32; 3]>| {
        Resident::upload(&mut job, &Mesh { vertices, triangles }).map(|_| ())
    };
    refused(upload(vec![[0, 0, 16_384]], Vec::new()), "16384");
    refused(upload(vec![[0, -16_385, 0]], Vec::new()), "-16385");
    refused(upload(vec![[0; 3]; 3], vec![[0, 1, 3]]), "[0, 1, 3] of 3");
    upload(vec![[-16_384; 3], [16_383; 3]], vec![[0, 1, 1]]).expect("the corners of the grid");
    let mesh = Mesh { vertices: vec![[0; 3]; 3], triangles: Vec::new() };
    for chosen in [vec![3], vec![1, 0, 1]] {
        let last = chosen[chosen.len() - 1].to_string();
        refused(Resident::upload_some(&mut job, &mesh, &chosen), &format!("vertex {last} of 3"));
    }
}

#[test]
fn directions_and_bits_that_do_not_fit() {
    let mut job = Job::new();
    let kernel = VertexVisibility::new().expect("it compiles");
    let mesh = octasphere(1, |_| 100.0);
    let resident = Resident::upload(&mut job, &mesh).expect("a mesh of the grid");
    let occluded = job.zeroed("occluded", 6);
    let mut record =
        |directions: &[Direction], bias: u32| kernel.record(&mut job, &resident, (0, directions), bias, occluded);
    refused(record(&[[1, 0, 0]], 0), "pair 0");
    refused(record(&[[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, 1, 0]], 0), "pair 1");
    refused(record(&[[0; 3], [0; 3]], 0), "pair 0");
    refused(record(&[[8192, 8192, 1], [-8192, -8192, -1]], 0), "8192");
    refused(record(&lights(0), 32_769), "32769");
    refused(record(&lights(2), 0), "18 are set");
    record(&lights(1), 32_768).expect("a word a vertex");
    refused(kernel.record(&mut job, &resident, (7, &lights(0)), 0, occluded), "number 7");
    refused(kernel.record(&mut job, &resident, (28, &lights(0)), 0, occluded), "12 are set");
    let maps = DepthMap::new().expect("it compiles");
    refused(maps.record(&mut job, &mesh, &lights(2), Maps { side: 64, bias: 0 }, occluded), "18 are set");
    refused(maps.record(&mut job, &mesh, &lights(0), Maps { side: 4097, bias: 0 }, occluded), "4097");
    let count = job.zeroed("differing", 1);
    refused(maps.record_differ(&mut job, 7, [occluded; 2], count), "7 words of 6");
}

#[test]
fn sums_and_colours_that_do_not_fit() {
    let mut job = Job::new();
    let kernel = Illumination::new().expect("it compiles");
    let surface = Surface {
        normals: job.zeroed("normals", 30),
        position_of: job.zeroed("positions", 10),
        positions: 10,
        occluded: job.zeroed("occluded", 20),
    };
    let (units, intensities) = (job.zeroed::<IVec4>("units", 65), job.zeroed::<UVec4>("intensities", 65));
    let [sums, short] = [60, 59].map(|len| job.zeroed::<u32>("sums", len));
    refused(kernel.record_block(&mut job, &surface, (65, units, intensities), sums), "20 of 30");
    refused(kernel.record_block(&mut job, &surface, (66, units, intensities), sums), "66 of 65");
    refused(kernel.record_block(&mut job, &surface, (64, units, intensities), short), "59 words");
    refused(kernel.record_resolve(&mut job, 10, short, [0; 3], sums), "59 words");
    refused(kernel.record_resolve(&mut job, 10, sums, [0, 97, 0], sums), "97");
    kernel.record_block(&mut job, &surface, (64, units, intensities), sums).expect("all fits");
}

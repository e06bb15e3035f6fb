//! From no vertex to a closed mesh of 35,346 vertices, and the inputs that are hard to get right: ties of all kinds,
//! faces seen edge-on, corners on other triangles, faces without area, vertices to weld, faces over everything.

use rayon::prelude::*;
use sightlines_backend::{Case, Expected, Job, Outputs, Size};

use super::oracle::{self, Point};
use super::{Mesh, Resident, VertexVisibility, bumpy, octasphere, words};
use crate::light_sphere::{healpix, oracle::Direction};
use crate::random;

pub(super) fn all() -> Vec<Case> {
    let mut cases = vec![
        small("nothing", || (Mesh::default(), level(0)), 0),
        small("vertices_alone", || (Mesh { vertices: cloud(300, 1, 16_384), triangles: Vec::new() }, level(1)), 0),
        small("one_triangle", || (soup(1, 2, 16_384, 40), level(2)), 0),
        small("anywhere", || (soup(150, 3, 16_384, 300), level(2)), 0),
        small("small_and_near", || (soup(200, 4, 24, 300), level(2)), 0),
        small("ties_of_a_lattice", || (on_lattice(120, 5, 3, 4096), level(3)), 0),
        small("ties_of_a_fine_lattice", || (on_lattice(150, 6, 8, 1), level(2)), 0),
        small("corners_of_the_grid", || (corners(100, 7), level(2)), 0),
        small("coplanar", || (coplanar(), level(2)), 0),
        small("box_edge_on", || (walls(), level(3)), 0),
        small("corners_on_edges", || (t_junctions(), level(2)), 0),
        small("no_area", || (flat_triangles(), level(2)), 0),
        small("equal_areas", || (soup(120, 8, 12_000, 200), healpix(1)), 0),
        small("floor_below", || (over_a_floor(), level(2)), 1),
        small("closed", || (octasphere(7, |d| 9000.0 + 4000.0 * d[0] * d[1]), level(2)), 1),
        small("closed_on_small_grid", || (octasphere(8, |_| 20.0), level(2)), 1),
        welded("welded", 120, 9),
    ];
    cases.extend([0, 1, 40, 32_768].map(|bias| small(&format!("bias_{bias}"), || (layers(), level(2)), bias)));
    cases.push(checked("crowd_in_a_bin", Size::Real, || (crowd(), level(0)), 0));
    cases.push(checked("crowd_over_rows", Size::Real, || (tall_crowd(), level(0)), 0));
    cases.push(real("bumpy_35346", || bumpy(94), level(2), 1));
    cases
}

fn level(level: u32) -> Vec<Direction> {
    crate::light_sphere::oracle::octahedron(level).into_iter().map(|(d, _)| d).collect()
}

/// Points with coordinates within ±`size`.
fn cloud(count: u32, seed: u32, size: i32) -> Vec<Point> {
    let coordinate = |i: u32| random::below(2 * size as u32, seed, i) as i32 - size;
    (0..count).map(|i| [0, 1, 2].map(|axis| coordinate(3 * i + axis))).collect()
}

/// Triangles of any three of `vertices` points.
fn soup(triangles: u32, seed: u32, size: i32, vertices: u32) -> Mesh {
    let pick = |i: u32| random::below(vertices, seed + 100, i);
    let triangles = (0..triangles).map(|t| [0, 1, 2].map(|corner| pick(3 * t + corner))).collect();
    Mesh { vertices: cloud(vertices, seed, size), triangles }
}

/// Points of a lattice so coarse that most directions from one meet others.
fn on_lattice(triangles: u32, seed: u32, side: i32, step: i32) -> Mesh {
    let points: Vec<Point> = (-side..=side)
        .flat_map(|x| (-side..=side).flat_map(move |y| (-side..=side).map(move |z| [x, y, z])))
        .map(|p| p.map(|c| c * step))
        .collect();
    let count = points.len() as u32;
    let chosen: Vec<Point> = (0..350).map(|i| points[random::below(count, seed, i) as usize]).collect();
    let pick = |i: u32| random::below(chosen.len() as u32, seed + 50, i);
    let triangles: Vec<[u32; 3]> = (0..triangles).map(|t| [0, 1, 2].map(|k| pick(3 * t + k))).collect();
    Mesh::weld(&chosen, &triangles).0
}

/// The largest triangles that there are.
fn corners(triangles: u32, seed: u32) -> Mesh {
    let vertices: Vec<Point> =
        (0..27).map(|i| [i % 3, i / 3 % 3, i / 9].map(|c| [-16_384, 0, 16_383][c as usize])).collect();
    let pick = |i: u32| random::below(27, seed, i);
    Mesh { vertices, triangles: (0..triangles).map(|t| [0, 1, 2].map(|k| pick(3 * t + k))).collect() }
}

/// A plane of triangles over each other, and one a cell above it.
fn coplanar() -> Mesh {
    let mut mesh = soup(80, 10, 900, 160);
    for (i, p) in mesh.vertices.iter_mut().enumerate() {
        p[2] = i32::from(i % 4 == 0);
    }
    mesh
}

/// A box with its faces along the axes, and points on its faces, edges and inside.
fn walls() -> Mesh {
    let mut mesh = octasphere(1, |_| 1.0);
    let corner = |i: u32| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -512 } else { 512 });
    mesh.vertices = (0..8).map(corner).collect();
    mesh.triangles = vec![
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ];
    let steps = [-512, -256, 0, 256, 512];
    mesh.vertices.extend(steps.iter().flat_map(|&x| steps.iter().flat_map(move |&y| steps.map(|z| [x, y, z]))));
    Mesh::weld(&mesh.vertices, &mesh.triangles).0
}

/// Triangles whose corners are middles of edges of others, level upon level.
fn t_junctions() -> Mesh {
    let mut points = vec![[-4096, -4096, 0], [4096, -4096, 1024], [0, 4096, -2048]];
    let mut triangles = vec![[0, 1, 2]];
    for t in 0..60 {
        let [a, b, c]: [u32; 3] = triangles[t];
        let middle = |p: u32, q: u32| [0, 1, 2].map(|i| (points[p as usize][i] + points[q as usize][i]) / 2);
        let new = [middle(a, b), middle(b, c), middle(c, a)];
        let first = points.len() as u32;
        points.extend(new);
        triangles.push([first, first + 1, first + 2]);
        triangles.push([a, first, first + 2]);
    }
    Mesh::weld(&points, &triangles).0
}

/// Points, segments and slivers among ordinary triangles.
fn flat_triangles() -> Mesh {
    let mut mesh = soup(60, 11, 4000, 200);
    for t in 0..mesh.triangles.len() {
        let [a, b, c] = mesh.triangles[t];
        match t % 4 {
            0 => mesh.triangles[t] = [a, a, a],
            1 => mesh.triangles[t] = [a, b, a],
            2 => {
                let [p, q] = [a, b].map(|v| mesh.vertices[v as usize]);
                mesh.vertices[c as usize] = [0, 1, 2].map(|i| (p[i] + q[i]) / 2);
            }
            _ => {}
        }
    }
    Mesh::weld(&mesh.vertices.clone(), &mesh.triangles).0
}

/// Many vertices over two triangles: all lanes of a workgroup share each.
fn over_a_floor() -> Mesh {
    let mut vertices = cloud(900, 12, 8000);
    let first = vertices.len() as u32;
    vertices.extend([
        [-16_384, -16_384, -9000],
        [16_383, -16_384, -9000],
        [16_383, 16_383, -9000],
        [-16_384, 16_383, -9000],
    ]);
    Mesh {
        vertices,
        triangles: vec![[first, first + 1, first + 2], [first, first + 2, first + 3], [0, 1, 2], [3, 4, 5]],
    }
}

/// Sheets 1, 2, 40 and 41 cells apart.
fn layers() -> Mesh {
    let mut mesh = soup(90, 13, 3000, 270);
    let heights = [0, 1, 2, 40, 41, 81];
    for (t, triangle) in mesh.triangles.iter_mut().enumerate() {
        *triangle = [0, 1, 2].map(|k| 3 * t as u32 + k);
    }
    for (i, p) in mesh.vertices.iter_mut().enumerate() {
        p[2] = heights[i / 3 % heights.len()];
    }
    mesh
}

/// More vertices in one bin than a launch tests with a triangle, most of them behind two triangles.
fn crowd() -> Mesh {
    let far = 16_000;
    let mut vertices = vec![[-far, -far, 900], [far, -far, 1000], [-far, far, 800], [-far, 7, -far], [far, 30, -far]];
    vertices.push([60, 20, far]);
    vertices.extend((0..64_000).map(|i| [i % 40, i / 40 % 40, i / 1600]));
    Mesh { vertices, triangles: vec![[0, 1, 2], [3, 4, 5]] }
}

/// The same over several rows of bins, so that a later launch begins within rows.
fn tall_crowd() -> Mesh {
    let mut mesh = crowd();
    mesh.vertices.truncate(6);
    mesh.vertices.extend((0..30_000).map(|i| [4 * (i % 25), 4 * (i / 25 % 300), i / 7500]));
    mesh
}

/// Every triangle with corners of its own, many at equal positions.
fn unwelded(triangles: u32, seed: u32) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mesh = soup(triangles, seed, 5000, 90);
    let points = mesh.triangles.iter().flatten().map(|&v| mesh.vertices[v as usize]).collect();
    (points, (0..triangles).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect())
}

/// The job: one word past the bits shows that nothing is written there.
fn job(mesh: &Mesh, directions: &[Direction], bias: u32) -> sightlines_backend::Result<Job> {
    let mut job = Job::new();
    let kernel = VertexVisibility::new()?;
    let resident = Resident::upload(&mut job, mesh)?;
    let bits = words(resident.vertices(), directions.len() as u32);
    let occluded = job.zeroed("occluded", bits + 1);
    kernel.record(&mut job, &resident, (0, directions), bias, occluded)?;
    job.read("occluded", occluded.id());
    Ok(job)
}

fn whole(mesh: &Mesh, directions: &[Direction], bias: u32) -> Vec<u32> {
    let rows = directions.chunks(32);
    let row = |row: &[Direction]| -> Vec<u32> {
        (0..mesh.vertices.len() as u32).into_par_iter().map(|v| oracle::word(mesh, v, row, bias)).collect()
    };
    rows.flat_map(row).chain([0]).collect()
}

fn small(name: &str, make: fn() -> (Mesh, Vec<Direction>), bias: u32) -> Case {
    checked(name, Size::Small, make, bias)
}

/// Every word is held to the oracle.
fn checked(name: &str, size: Size, make: fn() -> (Mesh, Vec<Direction>), bias: u32) -> Case {
    let run = move || {
        let (mesh, directions) = make();
        job(&mesh, &directions, bias)
    };
    let expected = move |_: &_| {
        let (mesh, directions) = make();
        vec![Expected::Whole(whole(&mesh, &directions, bias))]
    };
    let (mesh, directions) = make();
    let last = words(mesh.vertices.len() as u32, directions.len() as u32) as u32;
    let mut probes = vec![0, last / 3, last / 2, last];
    probes.dedup();
    Case::new(name, size, run, expected).probes(probes)
}

/// Corners of their own give every position the bits of the welded mesh.
fn welded(name: &str, triangles: u32, seed: u32) -> Case {
    let run = move || {
        let (vertices, triangles) = unwelded(triangles, seed);
        job(&Mesh { vertices, triangles }, &level(2), 0)
    };
    let expected = move |_: &_| {
        let (points, triangles) = unwelded(triangles, seed);
        let (mesh, vertex_of) = Mesh::weld(&points, &triangles);
        let bits = whole(&mesh, &level(2), 0);
        let rows = bits.chunks_exact(mesh.vertices.len());
        vec![Expected::Whole(rows.flat_map(|row| vertex_of.iter().map(|&v| row[v as usize])).chain([0]).collect())]
    };
    Case::new(name, Size::Small, run, expected).probes([0, 1, 2, 3])
}

/// Words of the sample at real size: 32 directions of a vertex each.
const SAMPLE: u32 = 20;

fn real(name: &str, make: fn() -> Mesh, directions: Vec<Direction>, bias: u32) -> Case {
    let lights = directions.clone();
    let run = move || job(&make(), &lights, bias);
    let expected = move |outputs: &Outputs| {
        let mesh = make();
        let vertices = mesh.vertices.len() as u32;
        let bits = words(vertices, directions.len() as u32) as u32;
        let found = |word: u32| {
            let bytes = outputs.first().and_then(|bytes| bytes.get(4 * word as usize..4 * word as usize + 4));
            bytes.map_or(0, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        };
        // Words that are neither all open nor all occluded, as far as the first tries find them.
        let tries: Vec<u32> = (0..16 * SAMPLE).map(|i| random::below(bits, 21, i)).collect();
        let (mixed, plain): (Vec<u32>, Vec<u32>) =
            tries.into_iter().partition(|&word| !matches!(found(word).count_ones(), 0 | 32));
        let chosen: Vec<u32> = mixed.into_iter().chain(plain).take(SAMPLE as usize).collect();
        let answer = |&word: &u32| {
            let row = directions.chunks(32).nth((word / vertices) as usize).unwrap_or_default();
            (word, oracle::word(&mesh, word % vertices, row, bias))
        };
        vec![Expected::Sample { words: chosen.par_iter().map(answer).collect(), seed: 21 }]
    };
    Case::new(name, Size::Real, run, expected).probes([0, 1, 2, 3])
}

//! Beside other ways: diffuse shading without occlusion, and rays cast at random in f64.
//!
//! Sattler et al. 2004, figure 9, compares with a ray tracer of 500 samples; so do these.

use sightlines_kernels::random;
use sightlines_visibility::ambient::{Colours, Environment, Lighting, Matrix, Sphere, Surface};
use sightlines_visibility::scene::{Generator, generate, generate_world};

use super::{finish, machine};

const RAYS: u32 = 500;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Ambient occlusion of every vertex at a level, under a white sky.
fn occlusion(surface: &Surface, level: u32, bias: u32) -> Vec<f64> {
    let (machine, sphere) = (machine(), Sphere::Octahedron { level });
    let mut matrix = Matrix::open(&machine, surface, sphere, bias).unwrap();
    finish(&mut matrix, sphere);
    let mut colours = Colours::new();
    let light = Environment::white().look_up(&machine, sphere, &Lighting::DEFAULT).unwrap();
    matrix.light(&light, &mut colours).unwrap();
    colours.iter().map(|colour| f64::from(colour[0])).collect()
}

/// Whether a ray from a vertex meets a triangle of which it is no corner.
fn is_hit(surface: &Surface, position: u32, direction: Vector) -> bool {
    let points = &surface.mesh.vertices;
    let at = |i: u32| points[i as usize].map(f64::from);
    let origin = at(position);
    surface.mesh.triangles.iter().filter(|corners| !corners.contains(&position)).any(|corners| {
        let [a, b, c] = corners.map(at);
        let (to_b, to_c, from_a) = (sub(b, a), sub(c, a), sub(origin, a));
        let normal = cross(direction, to_c);
        let whole = dot(to_b, normal);
        let (u, q) = (dot(from_a, normal) / whole, cross(from_a, to_b));
        let v = dot(direction, q) / whole;
        u >= 0.0 && v >= 0.0 && u + v <= 1.0 && dot(to_c, q) / whole > 1.0
    })
}

/// Ambient occlusion of every vertex by rays in directions from a hash.
fn cast(surface: &Surface) -> Vec<f64> {
    let vertex = |vertex: usize| {
        let normal = surface.normals[vertex].map(|c| f64::from(c) / 32_768.0);
        let ray = |i: u32| {
            // A point in the ball, which gives an even direction.
            let unit =
                |seed: u32| (0..3).map(move |axis| f64::from(random::word(seed, (i * 500 + vertex as u32) * 3 + axis)));
            let point = |seed: u32| -> Vector {
                let mut c = unit(seed).map(|word| word / 2_147_483_648.0 - 1.0);
                [0; 3].map(|_| c.next().unwrap_or(0.0))
            };
            let inside = (0..).map(point).find(|p| (1e-6..1.0).contains(&dot(*p, *p))).unwrap_or([1.0, 0.0, 0.0]);
            let length = dot(inside, inside).sqrt();
            let direction = inside.map(|c| c / length);
            let cosine = dot(direction, normal);
            if cosine > 0.0 && !is_hit(surface, surface.position_of[vertex], direction) { 4.0 * cosine } else { 0.0 }
        };
        (0..RAYS).map(ray).sum::<f64>() / f64::from(RAYS)
    };
    (0..surface.vertices.len()).map(vertex).collect()
}

/// The root of the mean square difference.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    (a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / a.len() as f64).sqrt()
}

#[test]
fn levels_approach_rays_where_diffuse_shading_alone_is_far_off() {
    let surface = Surface::new(&generate(Generator::Colonnade)).unwrap();
    let rays = cast(&surface);
    let levels = [0, 1, 2, 3, 4].map(|level| difference(&occlusion(&surface, level, 1), &rays));
    let alone = difference(&occlusion(&surface, 4, 32_768), &rays);
    let figures = format!("levels 0 to 4: {levels:.4?}; without occlusion: {alone:.4}");
    // 500 rays err by about 0.05 themselves.
    assert!(levels[3] < 0.08 && levels[4] < 0.07 && levels[0] > levels[2], "{figures}");
    assert!(alone > 4.0 * levels[4], "{figures}");
    // What levels differ by among themselves falls with every level.
    let finest = occlusion(&surface, 5, 1);
    let steps = [1, 2, 3, 4].map(|level| difference(&occlusion(&surface, level, 1), &finest));
    assert!(steps.windows(2).all(|pair| pair[1] < pair[0]), "{steps:.4?}");
}

#[test]
fn a_ball_between_others_is_darker_than_alone() {
    let trio = generate_world("trio").unwrap().flatten();
    let mut alone = trio.clone();
    alone.parts.truncate(1);
    let mean = |scene, count: usize| {
        let surface = Surface::new(scene).unwrap();
        let shares = occlusion(&surface, 1, 1);
        shares[..count].iter().sum::<f64>() / count as f64
    };
    let count = trio.parts[0].vertices.len();
    let (between, alone) = (mean(&trio, count), mean(&alone, count));
    assert!(between < 0.87 * alone && between > 0.5 * alone, "{between} between two others, {alone} alone");
}

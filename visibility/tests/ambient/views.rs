//! Pictures, lazy evaluation along them, and the level that a budget allows.

use sightlines_kernels::illumination::gamma_table;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::ambient::{Colours, Environment, Lazy, Lighting, Matrix, Sphere, Surface, View};
use sightlines_visibility::scene::{Camera, Generator, generate};

use super::{bumpy, finish, machine};

const SPHERE: Sphere = Sphere::Octahedron { level: 1 };
const SIZE: Picture = Picture { width: 160, height: 120 };
fn orbit(count: u32) -> Vec<Camera> {
    let first = Camera::parse("3,3.2,2.5/0,2,0/45", [0.0, 1.0, 0.0]).unwrap().unwrap();
    first.orbit([0.0, 2.0, 0.0], [0.0, 1.0, 0.0], count).unwrap()
}

#[test]
fn what_a_lazy_matrix_has_seen_is_what_the_whole_has() {
    let (surface, machine) = (bumpy(3000), machine());
    let light = Environment::sky().look_up(&machine, SPHERE, &Lighting::DEFAULT).unwrap();
    let mut whole = Matrix::open(&machine, &surface, SPHERE, 1).unwrap();
    finish(&mut whole, SPHERE);
    let mut full = Colours::new();
    whole.light(&light, &mut full).unwrap();
    let table = gamma_table(2.2, 1.0).unwrap();
    let all = surface.mesh.triangles.len();
    let mut lazy = Lazy::new(&machine, &surface, SPHERE, 1, all / 3);
    let (mut seen, mut positions, mut left) = (0, 0, all);
    for (number, camera) in orbit(6).iter().chain(&orbit(2)).enumerate() {
        let view = View::new(&machine, &surface, camera, SIZE).unwrap();
        let look = lazy.look(&view).unwrap();
        (seen, positions) = (seen + look.todo, positions + look.positions);
        assert_eq!(look.unseen + seen, all, "every triangle is on one list: look {number}");
        assert!(look.todo > 0 || number > 0);
        assert!(look.unseen < left || look.todo == 0);
        left = look.unseen;
        let colours = lazy.light(&light).unwrap();
        for (vertex, (found, expected)) in (0..).zip(colours.iter().zip(&full)) {
            let expected = if lazy.knows(vertex) { expected } else { &[0.0; 3] };
            assert_eq!(found, expected, "look {number}, vertex {vertex}");
        }
        assert!(view.shade(&surface, &colours, &table) == view.shade(&surface, &full, &table), "look {number}");
    }
    // The cameras look from above: what is left below is less than a third, and done at once.
    assert_eq!((left, positions), (0, surface.positions() as usize));
}

#[test]
fn without_a_threshold_what_nobody_sees_is_never_done() {
    let (surface, machine) = (bumpy(3000), machine());
    let mut lazy = Lazy::new(&machine, &surface, SPHERE, 1, 0);
    let view = View::new(&machine, &surface, &orbit(1)[0], SIZE).unwrap();
    let first = lazy.look(&view).unwrap();
    assert_eq!(first.todo, view.seen().len());
    assert!(first.unseen > 1000, "the far side: {first:?}");
    let again = lazy.look(&view).unwrap();
    assert_eq!((again.unseen, again.todo, again.positions), (first.unseen, 0, 0));
}

#[test]
fn a_picture_shows_the_colours_of_the_vertices() {
    let machine = machine();
    let surface = Surface::new(&generate(Generator::Quads)).unwrap();
    let camera = Camera::parse("0,1,9/0,1,0/height=3", [0.0, 1.0, 0.0]).unwrap().unwrap();
    let view = View::new(&machine, &surface, &camera, SIZE).unwrap();
    assert_eq!(view.size(), [160, 120]);
    assert!(!view.seen().is_empty());
    // Red grows with x, green with y, from 0 to 1 over the box.
    let corners = surface.corners();
    let share =
        |v: &[f64; 3], axis: usize| ((v[axis] - corners[0][axis]) / (corners[7][axis] - corners[0][axis])) as f32;
    let colours: Colours = surface.vertices.iter().map(|v| [share(v, 0), share(v, 1), 0.25]).collect();
    let linear: Vec<u32> = (1..=255).map(|code| ((code as f32 - 0.5) / 255.0).to_bits()).collect();
    let pixels = view.shade(&surface, &colours, &linear);
    let mut shown = 0;
    for (at, pixel) in pixels.as_chunks::<3>().0.iter().enumerate().filter(|(_, pixel)| pixel[2] == 64) {
        let point = |axis: usize| {
            let middle =
                [(at % 160) as f64 + 0.5 - 80.0, 60.0 - (at / 160) as f64 - 0.5][axis] * 3.0 / 120.0 + [0.0, 1.0][axis];
            (middle - corners[0][axis]) / (corners[7][axis] - corners[0][axis]) * 255.0
        };
        let near = |axis: usize| (f64::from(pixel[axis]) - point(axis)).abs() < 4.0;
        assert!(near(1), "pixel {at}: {pixel:?}, {}", point(1));
        shown += usize::from(near(0));
    }
    assert!(shown > 500, "{shown}");
}

#[test]
fn a_budget_chooses_the_same_level_for_the_same_mesh() {
    let surface = bumpy(3000);
    let cost = |level: u32| {
        u64::from(Sphere::Octahedron { level }.count())
            * (surface.positions() as usize + surface.mesh.triangles.len()) as u64
    };
    let sphere = Sphere::Octahedron { level: 3 };
    for level in 0..=3 {
        assert_eq!(sphere.within(cost(level), surface.visits()), Sphere::Octahedron { level });
        assert_eq!(sphere.within(cost(level + 1) - 1, surface.visits()), Sphere::Octahedron { level });
    }
    assert_eq!(sphere.within(0, surface.visits()), Sphere::Octahedron { level: 0 });
    assert_eq!(sphere.within(u64::MAX, surface.visits()), sphere);
}

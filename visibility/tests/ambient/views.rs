//! Pictures, lazy evaluation along them, and motions.

use sightlines_kernels::illumination::gamma_table;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::ambient::{Colours, Environment, Lazy, Lighting, Matrix, Sphere, Surface, View, Weighting};
use sightlines_visibility::scene::{Camera, Generator, Motion, generate};
use sightlines_visibility::setup::Up;

use super::{bumpy, finish, machine};

const SPHERE: Sphere = Sphere::Octahedron { level: 1 };
const SIZE: Picture = Picture { width: 160, height: 120 };
const LIGHTING: Lighting = Lighting { up: Up::Y, turn: 0.0, blur: None, weighting: Weighting::SolidAngle };

fn orbit(count: u32) -> Vec<Camera> {
    let first = Camera::parse("3,3.2,2.5/0,2,0/45", [0.0, 1.0, 0.0]).unwrap().unwrap();
    first.orbit([0.0, 2.0, 0.0], [0.0, 1.0, 0.0], count).unwrap()
}

#[test]
fn what_a_lazy_matrix_has_seen_is_what_the_whole_has() {
    let (surface, machine) = (bumpy(3000), machine());
    let light = Environment::sky().look_up(&machine, SPHERE, &LIGHTING).unwrap();
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
        let each = u64::from(surface.positions()) + surface.mesh.triangles.len() as u64;
        u64::from(Sphere::Octahedron { level }.count()) * each
    };
    let sphere = Sphere::Octahedron { level: 3 };
    for level in 0..=3 {
        assert_eq!(sphere.within(cost(level), &surface), Sphere::Octahedron { level });
        assert_eq!(sphere.within(cost(level + 1) - 1, &surface), Sphere::Octahedron { level });
    }
    assert_eq!(sphere.within(0, &surface), Sphere::Octahedron { level: 0 });
    assert_eq!(sphere.within(u64::MAX, &surface), sphere);
}

/// Two joints, a quarter turn between keys 0 and 1 s, and a triangle whose third corner follows the second joint.
fn animated() -> (String, Vec<u8>) {
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let floats: Vec<f32> = [
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0][..],
        &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0],
        &[0.0, 1.0],
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half],
        &[0.0, 0.0, 0.0, 4.0, 0.0, 0.0],
    ]
    .concat();
    let joints: [u8; 12] = [0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0];
    let bytes = [floats.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>(), joints.to_vec()].concat();
    let json = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 3]}],
        "nodes": [{"name": "skin", "mesh": 0, "skin": 0}, {"children": [2]}, {}, {"name": "rigid", "mesh": 1}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "WEIGHTS_0": 1, "JOINTS_0": 2}}]},
                   {"primitives": [{"attributes": {"POSITION": 0}}]}],
        "skins": [{"joints": [1, 2]}],
        "animations": [{"channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}},
                                     {"sampler": 1, "target": {"node": 3, "path": "translation"}}],
            "samplers": [{"input": 3, "output": 4, "interpolation": "LINEAR"}, {"input": 3, "output": 5, "interpolation": "STEP"}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 2, 0]},
            {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC4"},
            {"bufferView": 0, "byteOffset": 148, "componentType": 5121, "count": 3, "type": "VEC4"},
            {"bufferView": 0, "byteOffset": 84, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
            {"bufferView": 0, "byteOffset": 92, "componentType": 5126, "count": 2, "type": "VEC4"},
            {"bufferView": 0, "byteOffset": 124, "componentType": 5126, "count": 2, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 160}],
        "buffers": [{"uri": "a.bin", "byteLength": 160}]}"#;
    (json.to_owned(), bytes)
}

#[test]
fn nodes_and_skins_of_a_file_move_between_their_keys() {
    let folder = tempfile::tempdir().unwrap();
    let (json, bytes) = animated();
    std::fs::write(folder.path().join("a.bin"), &bytes).unwrap();
    let path = folder.path().join("a.gltf");
    std::fs::write(&path, &json).unwrap();
    let motion = Motion::load(&path).unwrap();
    assert_eq!(motion.duration(), 1.0);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    for (time, third, moved) in [
        (0.0, [0.0, 2.0, 0.0], 0.0),
        // An eighth of a turn: half of the corner stays, half turns about z.
        (0.5, [-half, 1.0 + half, 0.0], 0.0),
        (1.0, [-1.0, 1.0, 0.0], 4.0),
        (9.0, [-1.0, 1.0, 0.0], 4.0),
    ] {
        let scene = motion.at(time).unwrap();
        let [skin, rigid] = scene.parts.as_slice() else { panic!("{} parts", scene.parts.len()) };
        assert_eq!((skin.name.as_str(), rigid.name.as_str()), ("skin", "rigid"));
        // The weights (0.5, 0.5) of the third corner name joints 1 and 0.
        assert!((0..3).all(|axis| (skin.vertices[2][axis] - third[axis]).abs() < 1e-6), "{time}: {:?}", skin.vertices);
        assert_eq!(skin.vertices[1], [1.0, 0.0, 0.0]);
        assert_eq!(rigid.vertices[0], [moved, 0.0, 0.0], "steps hold: {time}");
    }
    for (from, to, expected) in [
        ("\"LINEAR\"", "\"CUBICSPLINE\"", "cubic splines"),
        ("\"animations\"", "\"unknown\"", "it has no animation"),
        ("\"input\": 3, \"output\": 4", "\"input\": 3, \"output\": 5", "Vec3"),
        ("[{\"joints\": [1, 2]}]", "[{\"joints\": [1]}]", "follows joint 1, and the skin has 1"),
    ] {
        std::fs::write(&path, json.replace(from, to)).unwrap();
        let error = Motion::load(&path).unwrap_err();
        assert!(error.is_bad_input() && error.to_string().contains(expected), "{to}: {error}");
    }
}

//! Motions: the animations of files, frames that keep their matrix, and what a budget leaves for each.

use std::path::PathBuf;

use serde_json::{Value, json};
use sightlines_backend_cpu::CpuBackend;
use sightlines_visibility::ambient::{Colours, Environment, Lighting, Matrix, Moving, Sphere, Step, Surface, Turn};
use sightlines_visibility::scene::{Generator, Motion, Scene, bumpy_sphere, generate};

use super::{finish, machine};

const LEVEL_2: Sphere = Sphere::Octahedron { level: 2 };

/// Keys of a node: 0 holds all, 1 and 2 are the halves of a colonnade.
pub(crate) struct Keys {
    pub(crate) node: usize,
    pub(crate) path: &'static str,
    pub(crate) interpolation: &'static str,
    pub(crate) times: &'static [f32],
    pub(crate) values: Vec<f32>,
}

/// The files of a colonnade in two halves, which move by these keys.
pub(crate) fn colonnade(keys: &[Keys]) -> [(&'static str, Vec<u8>); 2] {
    let mut data: Vec<u8> = Vec::new();
    let (mut views, mut accessors): (Vec<Value>, Vec<Value>) = (Vec::new(), Vec::new());
    let mut put = |bytes: Vec<u8>, of: Value| {
        let mut accessor = of;
        accessor["bufferView"] = json!(views.len());
        views.push(json!({"buffer": 0, "byteOffset": data.len(), "byteLength": bytes.len()}));
        data.extend(bytes);
        accessors.push(accessor);
        accessors.len() - 1
    };
    let float = |count: usize, kind: &str| json!({"componentType": 5126, "count": count, "type": kind});
    let floats = |values: &[f32]| values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
    let scene = generate(Generator::Colonnade);
    let half = scene.parts.len() / 2;
    let meshes = [&scene.parts[..half], &scene.parts[half..]].map(|parts| {
        let primitives = parts.iter().map(|part| {
            let points: Vec<f32> = part.vertices.as_flattened().iter().map(|c| *c as f32).collect();
            let mut accessor = float(part.vertices.len(), "VEC3");
            (accessor["min"], accessor["max"]) = (json!([-99, -99, -99]), json!([99, 99, 99]));
            let points = put(floats(&points), accessor);
            let corners: Vec<u8> = part.triangles.as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect();
            let count = corners.len() / 4;
            let corners = put(corners, json!({"componentType": 5125, "count": count, "type": "SCALAR"}));
            json!({"attributes": {"POSITION": points}, "indices": corners})
        });
        json!({"primitives": primitives.collect::<Vec<_>>()})
    });
    let (mut channels, mut samplers) = (Vec::new(), Vec::new());
    for (number, Keys { node, path, interpolation, times, values }) in keys.iter().enumerate() {
        let mut input = float(times.len(), "SCALAR");
        (input["min"], input["max"]) = (json!([times[0]]), json!([times[times.len() - 1]]));
        let input = put(floats(times), input);
        let (width, kind) = if *path == "rotation" { (4, "VEC4") } else { (3, "VEC3") };
        let output = put(floats(values), float(values.len() / width, kind));
        channels.push(json!({"sampler": number, "target": {"node": node, "path": path}}));
        samplers.push(json!({"input": input, "output": output, "interpolation": interpolation}));
    }
    let file = json!({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "meshes": meshes,
        "nodes": [{"children": [1, 2]}, {"mesh": 0}, {"mesh": 1}],
        "animations": [{"channels": channels, "samplers": samplers}],
        "accessors": accessors, "bufferViews": views, "buffers": [{"uri": "a.bin", "byteLength": data.len()}],
    });
    [("a.gltf", file.to_string().into_bytes()), ("a.bin", data)]
}

fn load(files: [(&str, Vec<u8>); 2]) -> (tempfile::TempDir, PathBuf, Motion) {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in files {
        std::fs::write(folder.path().join(name), bytes).unwrap();
    }
    let path = folder.path().join("a.gltf");
    let motion = Motion::load(&path).unwrap();
    (folder, path, motion)
}

/// About y, after so many quarters of a right angle.
fn about_y(quarters: f64) -> [f32; 4] {
    let (s, c) = libm::sincos(quarters * std::f64::consts::PI / 16.0);
    [0.0, s as f32, 0.0, c as f32]
}

/// Half a turn about y in four seconds, with a shift to somewhere else.
pub(crate) fn turning(node: usize) -> [Keys; 2] {
    let rotation = [about_y(0.0), about_y(8.0)].concat();
    let times = &[0.0, 4.0];
    let interpolation = "LINEAR";
    [
        Keys { node, path: "rotation", interpolation, times, values: rotation },
        Keys { node, path: "translation", interpolation, times, values: vec![0.0, 0.0, 0.0, 8.0, -3.0, 1.0] },
    ]
}

/// The first frames of a motion, one a second.
fn frames(motion: &Motion, count: u32) -> Vec<(Scene, Surface)> {
    let scene = |frame: u32| motion.at(f64::from(frame)).unwrap();
    (0..count).map(scene).map(|scene| (scene.clone(), Surface::new(&scene).unwrap())).collect()
}

fn steps(moving: &mut Moving<'_>, frames: &[(Scene, Surface)]) -> Vec<Step> {
    frames.iter().map(|(scene, surface)| moving.step(scene, surface).unwrap()).collect()
}

/// A matrix of a surface alone, lit.
fn colours(machine: &CpuBackend, surface: &Surface, sphere: Sphere, lighting: &Lighting) -> Colours {
    let mut matrix = Matrix::open(machine, surface, sphere, 1).unwrap();
    finish(&mut matrix, sphere);
    let mut colours = Colours::new();
    matrix.light(&Environment::sky().look_up(machine, sphere, lighting).unwrap(), &mut colours).unwrap();
    colours
}

#[test]
fn what_turns_as_a_whole_keeps_its_matrix_and_its_environment_turns_the_other_way() {
    let (_folder, _, motion) = load(colonnade(&turning(0)));
    let (machine, frames) = (machine(), frames(&motion, 4));
    let mut moving = Moving::new(&machine, LEVEL_2, 1, None);
    let mut found = Vec::new();
    for (number, (scene, surface)) in (0..).zip(&frames) {
        let step = moving.step(scene, surface).unwrap();
        let first = number == 0;
        assert_eq!((step.sphere, step.matrix_of, step.pose == Turn::NONE), (LEVEL_2, 0, first), "frame {number}");
        assert_eq!(step.pairs, if first { 66 * u64::from(surface.positions()) } else { 0 }, "frame {number}");
        assert!((step.pose.degrees() - 45.0 * f64::from(number)).abs() < 1e-4, "{}", step.pose.degrees());
        let lighting = Lighting { pose: step.pose, ..Lighting::DEFAULT };
        let mut shaded = Colours::new();
        let light = Environment::sky().look_up(&machine, LEVEL_2, &lighting).unwrap();
        moving.light(&light, &mut shaded).unwrap();
        // The definition: the first frame's matrix, lit by what its turned directions meet.
        assert!(shaded == colours(&machine, &frames[0].1, LEVEL_2, &lighting), "frame {number}");
        found.push((shaded, light));
    }
    let work = moving.work();
    let mut alone = Moving::new(&machine, LEVEL_2, 1, None);
    steps(&mut alone, &frames[..1]);
    assert!(work.lane_ops.unwrap() < alone.work().lane_ops.unwrap() * 11 / 10, "light is all that three frames cost");
    // A scene that turns one way sees the environment turn the other way.
    let back = Lighting { turn: -135.0, ..Lighting::DEFAULT };
    let other = Environment::sky().look_up(&machine, LEVEL_2, &back).unwrap();
    for (a, b) in found[3].1.values.iter().zip(&other.values) {
        assert!((0..3).all(|c| a[c].abs_diff(b[c]) <= a[c] >> 16), "{a:?} and {b:?}");
    }
}

/// Root of the mean square difference.
fn apart(a: &Colours, b: &Colours) -> f64 {
    let squares = a.iter().zip(b).flat_map(|(a, b)| (0..3).map(move |c| f64::from(a[c] - b[c])));
    let (sum, count) = squares.fold((0.0, 0.0), |(sum, count), d| (sum + d * d, count + 1.0));
    (sum / count).sqrt()
}

#[test]
fn a_matrix_that_was_kept_is_as_good_as_one_made_anew() {
    let machine = machine();
    let from = bumpy_sphere(1500);
    let turned = |degrees: f64| {
        let (s, c) = libm::sincos(degrees * std::f64::consts::PI / 180.0);
        let mut scene = from.clone();
        scene.parts[0].vertices.iter_mut().for_each(|[x, _, z]| (*x, *z) = (c * *x + s * *z, c * *z - s * *x));
        scene
    };
    let at_rest = Surface::new(&from).unwrap();
    let level = |level| Sphere::Octahedron { level };
    let kept = |to: &Scene, sphere| {
        let pose = Turn::between(&from, to, 1e-6).unwrap();
        colours(&machine, &at_rest, sphere, &Lighting { pose, ..Lighting::DEFAULT })
    };
    let anew = |to, sphere| colours(&machine, &Surface::new(to).unwrap(), sphere, &Lighting::DEFAULT);
    // The octahedron's directions are their own image after a right angle: little but the grid's rounding differs.
    let to = turned(90.0);
    let right_angle = apart(&kept(&to, level(2)), &anew(&to, level(2)));
    // After less of it they are between each other, and what differs is the error of the level.
    let to = turned(30.0);
    let [coarse, middle, fine] = [1, 2, 3].map(|l| apart(&kept(&to, level(l)), &anew(&to, level(l))));
    let sampling = apart(&anew(&from, level(2)), &anew(&from, level(4)));
    assert!(
        right_angle < 0.1 * middle && fine < middle && middle < coarse,
        "{right_angle}: {coarse}, {middle}, {fine}"
    );
    assert!(middle < 2.0 * sampling, "{middle} and {sampling}");
}

#[test]
fn what_moves_against_something_else_has_a_new_matrix_at_each_frame() {
    let (_folder, _, motion) = load(colonnade(&turning(1)));
    let (machine, frames) = (machine(), frames(&motion, 3));
    let mut moving = Moving::new(&machine, LEVEL_2, 1, None);
    for (number, step) in (0..).zip(steps(&mut moving, &frames)) {
        let pairs = 66 * u64::from(frames[number as usize].1.positions());
        assert_eq!(step, Step { sphere: LEVEL_2, matrix_of: number, pose: Turn::NONE, pairs });
    }
    // It rests after its last key.
    let at_rest = [4.0, 5.0].map(|time| motion.at(time).unwrap()).map(|s| (s.clone(), Surface::new(&s).unwrap()));
    let steps = steps(&mut moving, &at_rest);
    assert_eq!((steps[0].matrix_of, steps[1].matrix_of, steps[1].pairs), (3, 3, 0));
}

#[test]
fn frames_that_keep_their_matrix_spend_their_budget_on_refining_it() {
    let (_folder, _, motion) = load(colonnade(&turning(0)));
    let (machine, frames) = (machine(), frames(&motion, 4));
    let surface = &frames[0].1;
    let sphere = Sphere::Octahedron { level: 3 };
    // A hundred directions a frame: level 2 at once, level 3 when 258 have come together.
    let mut moving = Moving::new(&machine, sphere, 1, Some(100 * surface.visits()));
    let steps = steps(&mut moving, &frames);
    let levels = steps.iter().map(|step| step.sphere);
    assert!(levels.eq([2, 2, 3, 3].map(|level| Sphere::Octahedron { level })), "{steps:?}");
    // Whole blocks: 66 of 100 directions, 192 of 200, all 258 of 300.
    let directions: Vec<u64> = steps.iter().map(|step| step.pairs / u64::from(surface.positions())).collect();
    assert_eq!(directions, [66, 126, 66, 0]);
    let mut lit = Colours::new();
    let lighting = Lighting { pose: steps[3].pose, ..Lighting::DEFAULT };
    moving.light(&Environment::sky().look_up(&machine, sphere, &lighting).unwrap(), &mut lit).unwrap();
    assert!(lit == colours(&machine, surface, sphere, &lighting), "refined is what it would have been at once");
    let mut poor = Moving::new(&machine, sphere, 1, Some(0));
    let steps: Vec<Step> = frames.iter().map(|(scene, surface)| poor.step(scene, surface).unwrap()).collect();
    assert!(steps.iter().all(|step| step.sphere == Sphere::Octahedron { level: 0 }));
}

#[test]
fn nodes_follow_their_cubic_splines() {
    // Into, value and out of two keys; computed by hand in the middle and at a quarter.
    let values = vec![9.0, 9.0, 9.0, 2.0, 0.0, -1.0, 4.0, 0.0, 1.0, -2.0, 0.0, 1.0, 6.0, 4.0, 1.0, 9.0, 9.0, 9.0];
    let spline = Keys { node: 1, path: "translation", interpolation: "CUBICSPLINE", times: &[1.0, 3.0], values };
    // A quarter turn about y whose tangents are 0, and whose second key has length 2.
    let (rest, quarter, none) = (about_y(0.0), about_y(4.0).map(|c| 2.0 * c), [0.0; 4]);
    let values = [none, rest, none, none, quarter, none].concat();
    let turn = Keys { node: 2, path: "rotation", interpolation: "CUBICSPLINE", times: &[0.0, 2.0], values };
    let (_folder, path, motion) = load(colonnade(&[spline, turn]));
    let rest = motion.at(0.0).unwrap().parts[0].vertices[0];
    for (time, expected) in [(1.0, [0.0, 0.0, 0.0]), (1.5, [1.9375, 0.625, 0.5]), (2.0, [3.5, 2.0, 1.0])] {
        let now = motion.at(time).unwrap().parts[0].vertices[0];
        assert!((0..3).all(|axis| (now[axis] - rest[axis] - expected[axis]).abs() < 1e-6), "{time}: {now:?}");
    }
    let second = |time: f64| motion.at(time).unwrap().parts[1].vertices[0];
    let (before, middle, end) = (second(0.0), second(1.0), second(2.0));
    assert!((end[0] - before[2]).abs() < 1e-6 && (end[2] + before[0]).abs() < 1e-6, "x goes to -z: {end:?}");
    // Half of each key, (0, 0.7071, 0, 1.2071) at length 1: an angle of 2 atan(0.7071 / 1.2071).
    let (s, c) =
        libm::sincos(2.0 * libm::atan(std::f64::consts::FRAC_1_SQRT_2 / (0.5 + std::f64::consts::FRAC_1_SQRT_2)));
    let expected = [c * before[0] + s * before[2], before[1], c * before[2] - s * before[0]];
    assert!((0..3).all(|axis| (middle[axis] - expected[axis]).abs() < 1e-6), "{middle:?}, not {expected:?}");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, text.replacen("CUBICSPLINE", "LINEAR", 1)).unwrap();
    let error = Motion::load(&path).unwrap_err().to_string();
    assert!(error.contains("channel 0 of the animation: 2 keys and 6 values, where each key has 1"), "{error}");
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
    let (json, bytes) = animated();
    let (_folder, path, motion) = load([("a.gltf", json.clone().into_bytes()), ("a.bin", bytes)]);
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
    let still = ["rotation", "translation"].iter().fold(json.clone(), |json, path| json.replace(path, "weights"));
    std::fs::write(&path, still).unwrap();
    assert!(Motion::load(&path).unwrap_err().to_string().contains("its first animation moves no node of the scene"));
    for (from, to, expected) in [
        ("\"LINEAR\"", "\"CUBICSPLINE\"", "channel 0 of the animation: 2 keys and 2 values, where each key has 3"),
        ("\"animations\"", "\"unknown\"", "it has no animation"),
        ("\"input\": 3, \"output\": 4", "\"input\": 3, \"output\": 5", "Vec3"),
        ("[{\"joints\": [1, 2]}]", "[{\"joints\": [1]}]", "follows joint 1, and the skin has 1"),
    ] {
        std::fs::write(&path, json.replace(from, to)).unwrap();
        let error = Motion::load(&path).unwrap_err();
        assert!(error.is_bad_input() && error.to_string().contains(expected), "{to}: {error}");
    }
}

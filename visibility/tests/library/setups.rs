//! Defaults and scene files: where things stand, and what is refused.

use sightlines_visibility::scene::{Generator, Mesh, Scene, generate};
use sightlines_visibility::setup::{Settings, Setup, Up};
use sightlines_visibility::shadows::Rect;

use super::{Folder, refusal};

/// A scene of one triangle.
fn triangle(corners: [[f64; 3]; 3]) -> Scene {
    let part = Mesh { vertices: corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() };
    Scene { name: "triangle".into(), units: "metres", parts: vec![part] }
}

fn close(found: [f64; 3], expected: [f64; 3]) {
    for axis in 0..3 {
        assert!((found[axis] - expected[axis]).abs() < 1e-12, "{found:?}, not {expected:?}");
    }
}

fn is(rect: Rect, corner: [f64; 3], u: [f64; 3], v: [f64; 3]) {
    close(rect.corner, corner);
    close(rect.u, u);
    close(rect.v, v);
}

#[test]
fn the_defaults_stand_around_the_scene() {
    // Its box is 2 × 0 × 2 around (5, 1, 5), so R is √2; the lowest point is y = 1.
    let flat = triangle([[4.0, 1.0, 4.0], [6.0, 1.0, 4.0], [4.0, 1.0, 6.0]]);
    let setup = Setup::new(flat, &Settings::default()).unwrap();
    let r = 2.0_f64.sqrt();
    let ground = 1.0 - 0.02 * r;
    is(setup.receiver, [5.0 - 2.0 * r, ground, 5.0 - 2.0 * r], [4.0 * r, 0.0, 0.0], [0.0, 0.0, 4.0 * r]);
    let light = [5.0 - 0.2 * r, ground + 3.0 * r, 5.0 - 0.2 * r];
    is(setup.lights[0].rect, light, [0.4 * r, 0.0, 0.0], [0.0, 0.0, 0.4 * r]);
    assert_eq!((setup.lights.len(), setup.resolution, setup.sampling.count, setup.up), (1, 512, 1024, Up::Y));
}

#[test]
fn settings_replace_the_defaults() {
    let upright = triangle([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]]);
    let settings = Settings {
        up: Some(Up::Z),
        light_size: Some(1.0),
        resolution: Some(7),
        samples: Some(32),
        ..Settings::default()
    };
    let setup = Setup::new(upright, &settings).unwrap();
    let r = 2.0_f64.sqrt();
    is(setup.receiver, [1.0 - 2.0 * r, 2.0 * r, -0.02 * r], [4.0 * r, 0.0, 0.0], [0.0, -4.0 * r, 0.0]);
    is(setup.lights[0].rect, [1.0 - 0.5 * r, 0.5 * r, 2.98 * r], [r, 0.0, 0.0], [0.0, -r, 0.0]);
    let request = setup.request();
    assert_eq!((request.resolution, request.samples, request.triangles.len()), (7, 32, 1));
    assert_eq!((request.light, request.receiver), (setup.lights[0].rect, setup.receiver));
}

#[test]
fn settings_out_of_range_are_refused() {
    let refused = |settings: Settings, element: &str| {
        let message = refusal(Setup::new(generate(Generator::Box), &settings), element);
        assert!(message.contains("choose"), "{message}");
    };
    for resolution in [0, 8193, u32::MAX] {
        refused(Settings { resolution: Some(resolution), ..Settings::default() }, "resolution: ");
    }
    for samples in [0, 65_537, u32::MAX] {
        refused(Settings { samples: Some(samples), ..Settings::default() }, "samples: ");
    }
    refused(Settings { resolution: Some(8192), samples: Some(1024), ..Settings::default() }, "samples: ");
    for size in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, 16.5] {
        refused(Settings { light_size: Some(size), ..Settings::default() }, "light size: ");
    }
    let largest =
        Settings { resolution: Some(8192), samples: Some(256), light_size: Some(16.0), ..Settings::default() };
    assert!(Setup::new(generate(Generator::Box), &largest).is_ok());
}

const FILE: &str = r#"generator = "box"
resolution = 64
samples = 128

[[light]]
corner = [-1.0, 6.0, -1.0]
u = [2.0, 0.0, 0.0]
v = [0.0, 0.0, 2.0]

[[light]]
corner = [3.0, 6.0, -1.0]
u = [2.0, 0.0, 0.0]
v = [0.0, 0.0, 2.0]

[receiver]
corner = [-4.0, 0.0, -4.0]
u = [8.0, 0.0, 0.0]
v = [0.0, 0.0, 8.0]
"#;

fn load(text: &str, settings: &Settings) -> sightlines_visibility::Result<Setup> {
    Setup::load(&Folder::new().put("a.toml", text), settings)
}

#[test]
fn a_scene_file_places_lights_and_receiver() {
    let setup = load(FILE, &Settings::default()).unwrap();
    assert_eq!((setup.resolution, setup.sampling.count, setup.scene.triangle_count()), (64, 128, 12));
    is(setup.receiver, [-4.0, 0.0, -4.0], [8.0, 0.0, 0.0], [0.0, 0.0, 8.0]);
    is(setup.lights[0].rect, [-1.0, 6.0, -1.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]);
    is(setup.lights[1].rect, [3.0, 6.0, -1.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]);
}

#[test]
fn a_scene_file_may_leave_out_everything_but_the_scene() {
    let setup = load("generator = \"palms\"\nup = \"y\"\nlight_size = 0.5\n", &Settings::default()).unwrap();
    let settings = Settings { light_size: Some(0.5), ..Settings::default() };
    let expected = Setup::new(generate(Generator::Palms), &settings).unwrap();
    assert_eq!((setup.lights, setup.receiver), (expected.lights, expected.receiver));
    assert_eq!((setup.resolution, setup.sampling.count), (512, 1024));
}

#[test]
fn settings_go_before_the_file() {
    let settings = Settings { resolution: Some(9), samples: Some(32), up: Some(Up::Z), ..Settings::default() };
    let setup = load(&FILE.replace("resolution = 64", "resolution = 0"), &settings).unwrap();
    assert_eq!((setup.resolution, setup.sampling.count, setup.up), (9, 32, Up::Z));
}

#[test]
fn a_model_is_looked_for_beside_the_scene_file() {
    let folder = Folder::new();
    folder.put("mesh.obj", "v 0 1 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n");
    let setup = Setup::load(&folder.put("a.toml", "model = \"mesh.obj\"\n"), &Settings::default()).unwrap();
    assert_eq!(setup.scene.triangle_count(), 1);
    let missing = Setup::load(&folder.put("b.toml", "model = \"none.obj\"\n"), &Settings::default());
    assert!(refusal(missing, "none.obj").contains("cannot be read"));
}

#[test]
fn broken_scene_files_are_refused_with_their_line() {
    let cases = [
        ("generator = \"box\"", "generator = ", "a.toml:1:"),
        ("generator = \"box\"", "generator = \"forest\"", "a.toml:1: generator: there is no `forest`"),
        ("generator = \"box\"", "", "a.toml: it names no scene"),
        ("generator = \"box\"", "model = \"a\"\ngenerator = \"box\"", "a.toml:2: generator: there is a model already"),
        ("generator = \"box\"", "generator = \"box\"\nup = \"x\"", "a.toml:2: up: `x` is no axis"),
        ("generator = \"box\"", "generator = \"box\"\nlight_size = 1.0", "a.toml:2: light_size: the lights are given"),
        ("resolution = 64", "resolution = -1", "a.toml:2:"),
        ("resolution = 64", "resolution = 0", "a.toml:2: resolution: 0 texels a side are out of range"),
        ("resolution = 64", "resolution = 8193", "a.toml:2: resolution: 8193 texels"),
        ("samples = 128", "samples = 0", "a.toml:3: samples: 0 samples cannot be baked"),
        ("samples = 128", "sample = 128", "a.toml:3: unknown field `sample`"),
        ("v = [0.0, 0.0, 2.0]", "v = [0.0, 2.0]", "a.toml:8:"),
        ("v = [0.0, 0.0, 2.0]\n", "", "a.toml:5: missing field `v`"),
        ("v = [0.0, 0.0, 2.0]", "v = [0.0, 0.0, 0.0]", "a.toml:5: light: a side has no length"),
        ("v = [0.0, 0.0, 2.0]", "v = [1.0, 0.0, 2.0]", "a.toml:5: light: the sides are not at right angles"),
        ("v = [0.0, 0.0, 2.0]", "v = [0.0, 0.0, nan]", "a.toml:5: light: a coordinate is not finite"),
        ("u = [8.0, 0.0, 0.0]", "u = [inf, 0.0, 0.0]", "a.toml:15: receiver: a coordinate is not finite"),
        ("u = [8.0, 0.0, 0.0]", "u = [0.0, 0.0, 0.0]", "a.toml:15: receiver: a side has no length"),
        ("v = [0.0, 0.0, 2.0]", "v = [0.0, 0.0, -2.0]", "a.toml:5: light: the receiver is behind the light"),
        ("corner = [-1.0, 6.0, -1.0]", "corner = [-1.0, 0.0, -1.0]", "the light is inside the receiver's plane"),
        ("v = [0.0, 0.0, 2.0]", "v = [0.0, 2.0, 0.1]", "a.toml:5: light: the receiver crosses the plane of the light"),
        ("corner = [3.0, 6.0, -1.0]", "corner = [3.0, 0.2, -1.0]", "a.toml:10: light: the whole scene is behind"),
        ("corner = [-4.0, 0.0, -4.0]", "corner = [-4.0, 2.0, -4.0]", "the light is behind the receiver"),
    ];
    for (old, new, expected) in cases {
        assert!(FILE.contains(old));
        let message = refusal(load(&FILE.replacen(old, new, 1), &Settings::default()), "a.toml");
        assert!(message.contains(expected), "{new}: {message}");
    }
}

#[test]
fn a_light_that_cuts_the_receivers_plane_is_refused() {
    // It stands beside the receiver, upright, reaches below it, and faces it.
    let upright = "corner = [9.0, -1.0, -1.0]\nu = [0.0, 0.0, 2.0]\nv = [0.0, 4.0, 0.0]";
    let flat = "corner = [-1.0, 6.0, -1.0]\nu = [2.0, 0.0, 0.0]\nv = [0.0, 0.0, 2.0]";
    let message = refusal(load(&FILE.replacen(flat, upright, 1), &Settings::default()), "a.toml");
    assert!(message.contains("a.toml:5: light: the light is inside the receiver's plane"), "{message}");
}

#[test]
fn a_scene_file_that_is_none_is_refused() {
    let folder = Folder::new();
    let huge = folder.put("huge.toml", vec![b'#'; (1 << 20) + 1]);
    assert!(
        refusal(Setup::load(&huge, &Settings::default()), "huge.toml")
            .contains("1048577 bytes, at most 1048576 are read")
    );
    let binary = folder.put("binary.toml", [0xFF, 0xFE]);
    assert!(refusal(Setup::load(&binary, &Settings::default()), "binary.toml").contains("save the file as UTF-8"));
    refusal(Setup::load(&folder.path("none.toml"), &Settings::default()), "none.toml");
    let many = format!("generator = \"box\"\n{}", "[[light]]\ncorner=[0,9,0]\nu=[1,0,0]\nv=[0,0,1]\n".repeat(65));
    assert!(refusal(load(&many, &Settings::default()), "a.toml").contains("65 lights, at most 64 are taken"));
}

//! What is written: shaded scenes and matrices; and what is read of environments.

use std::path::Path;

use exr::prelude::{WritableImage, write_rgb_file};
use sightlines_visibility::ambient::export::{write_glb, write_ply};
use sightlines_visibility::ambient::file::Stored;
use sightlines_visibility::ambient::{Environment, Matrix, Sphere};
use sightlines_visibility::scene::{Generator, load};

use super::{finish, machine, surface};

const SPHERE: Sphere = Sphere::Octahedron { level: 1 };

#[test]
fn shaded_scenes_are_read_again_as_they_were() {
    let folder = tempfile::tempdir().unwrap();
    let surface = surface(Generator::Colonnade);
    let colours = vec![[0.25, 1.0, 7.0]; surface.vertices.len()];
    let bytes = vec![[10, 20, 30]; surface.vertices.len()];
    let [glb, ply] = ["a.glb", "a.ply"].map(|name| folder.path().join(name));
    write_glb(&glb, &surface, &colours, 2.0).unwrap();
    write_ply(&ply, &surface, &bytes).unwrap();
    let (glb_scene, ply_scene) = (load(&glb).unwrap(), load(&ply).unwrap());
    let parts: Vec<usize> = glb_scene.parts.iter().map(|part| part.triangles.len()).collect();
    assert_eq!(parts, surface.parts.iter().map(|part| part.triangles.len()).collect::<Vec<_>>());
    assert_eq!(glb_scene.parts[3].name, surface.parts[3].name);
    assert_eq!(glb_scene.triangles(), ply_scene.triangles());
    let near = |a: f64, b: f64| (a - b).abs() < 1e-4;
    let vertices = glb_scene.parts.iter().flat_map(|part| part.vertices.iter().zip(&part.normals));
    for (at, (vertex, normal)) in vertices.enumerate() {
        assert!((0..3).all(|axis| near(vertex[axis], surface.vertices[at][axis])), "vertex {at}");
        assert!((0..3).all(|axis| near(normal[axis], f64::from(surface.normals[at][axis]) / 32_768.0)), "normal {at}");
    }
    // Colours: 16 bits of white 2, clamped; and bytes behind each vertex's 24 bytes.
    let document = gltf::Gltf::open(&glb).unwrap();
    let colour =
        document.meshes().next().unwrap().primitives().next().unwrap().get(&gltf::Semantic::Colors(0)).unwrap();
    let strides: Vec<Option<usize>> = document.views().map(|view| view.stride()).collect();
    assert_eq!(strides, [Some(12), Some(12), Some(8), None], "accessors that share a view need a stride");
    assert!(colour.normalized() && colour.data_type() == gltf::accessor::DataType::U16);
    let at = colour.view().unwrap().offset() + colour.offset();
    let blob = document.blob.as_ref().unwrap();
    let word = |i: usize| u16::from_le_bytes([blob[at + 2 * i], blob[at + 2 * i + 1]]);
    assert_eq!([word(0), word(1), word(2), word(3)], [8192, 32_768, 65_535, 65_535]);
    let text = std::fs::read(&ply).unwrap();
    let body = text.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    assert_eq!(text[body + 24..body + 27], [10, 20, 30]);
}

fn stored() -> Stored {
    let surface = surface(Generator::Box);
    let machine = machine();
    let mut matrix = Matrix::open(&machine, &surface, SPHERE, 1).unwrap();
    finish(&mut matrix, SPHERE);
    Stored::of(&mut matrix, &surface, SPHERE, 1).unwrap()
}

#[test]
fn a_matrix_is_read_again_and_every_damage_is_noticed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.occl");
    let stored = stored();
    stored.write(&path).unwrap();
    assert_eq!(Stored::read(&path).unwrap(), stored);
    assert_eq!((stored.done, stored.positions, stored.words.len()), (18, 8, 8));
    let bytes = std::fs::read(&path).unwrap();
    for at in 0..bytes.len() {
        let mut broken = bytes.clone();
        broken[at] ^= 1 << (at % 8);
        for damaged in [&broken, &bytes[..at]] {
            std::fs::write(&path, damaged).unwrap();
            let error = Stored::read(&path).unwrap_err();
            assert!(error.is_bad_input() && error.to_string().contains("a.occl"), "byte {at}: {error}");
        }
    }
}

#[test]
fn only_the_same_mesh_bias_and_kind_of_sphere_go_on() {
    let path = Path::new("a.occl");
    let (stored, same, other) = (stored(), surface(Generator::Box), surface(Generator::Quads));
    let refused =
        |stored: &Stored, surface, sphere, bias| stored.check(path, surface, sphere, bias).unwrap_err().to_string();
    stored.check(path, &same, Sphere::Octahedron { level: 4 }, 1).unwrap();
    assert!(refused(&stored, &other, SPHERE, 1).contains("another mesh"));
    assert!(refused(&stored, &same, SPHERE, 2).contains("a bias of 1 cells, not 2"));
    assert!(refused(&stored, &same, Sphere::Healpix { order: 1 }, 1).contains("octahedron level 1"));
    assert!(refused(&stored, &same, Sphere::Octahedron { level: 0 }, 1).contains("18 directions, more than"));
}

/// A small map whose texels tell their places.
fn texel(column: usize, row: usize) -> [f32; 3] {
    [column as f32, row as f32, 0.5]
}

#[test]
fn environments_are_read_from_both_formats() {
    let folder = tempfile::tempdir().unwrap();
    let [hdr, exr] = ["a.hdr", "a.exr"].map(|name| folder.path().join(name));
    write_rgb_file(&exr, 8, 4, |x, y| {
        let [r, g, b] = texel(x, y);
        (r, g, b)
    })
    .unwrap();
    // Mantissa times 2^(exponent - 136).
    let rgbe = |i: usize| [(i % 8) as u8 * 2, (i / 8) as u8 * 2, 1, 135];
    let body: Vec<u8> = (0..32).flat_map(rgbe).collect();
    let header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n";
    std::fs::write(&hdr, [header.as_bytes(), &body].concat()).unwrap();
    let expected: Vec<[f32; 3]> = (0..32).map(|i| texel(i % 8, i / 8)).collect();
    for path in [hdr, exr] {
        let map = Environment::load(&path).unwrap();
        assert_eq!((map.width, map.height, &map.texels), (8, 4, &expected), "{}", path.display());
    }
}

#[test]
fn bad_environments_are_refused_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str| Environment::load(&folder.path().join(name)).unwrap_err();
    let put = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    put("a.png", b"\x89PNG\r\n");
    put("cut.hdr", b"#?RADIANCE\n\n-Y 4 +X 8\nabcd");
    put("cut.exr", &[0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0, 0]);
    let exr = |name: &str, size: [usize; 2], value: f32| {
        let pixel = |x: usize, y: usize| (if [x, y] == [1, 2] { value } else { 1.0 }, 1.0_f32, 1.0_f32);
        write_rgb_file(folder.path().join(name), size[0], size[1], pixel).unwrap();
    };
    exr("negative.exr", [8, 4], -0.5);
    exr("nan.exr", [8, 4], f32::NAN);
    exr("square.exr", [4, 4], 1.0);
    for (name, expected) in [
        ("none.hdr", "cannot be read"),
        ("a.png", "neither Radiance HDR nor OpenEXR"),
        ("cut.hdr", "scanline 1: the file ends before it does"),
        ("cut.exr", "cut.exr: "),
        ("negative.exr", "texel in row 3, column 2: it is [-0.5, 1.0, 1.0]"),
        ("nan.exr", "texel in row 3, column 2: it is [NaN, 1.0, 1.0]"),
        ("square.exr", "4 by 4 texels: neither a latitude–longitude map nor a cross"),
    ] {
        let error = refused(name);
        let message = error.to_string();
        assert!(
            error.is_bad_input() && message.contains(expected) && message.contains("remedy: "),
            "{name}: {message}"
        );
    }
    // A layer of another colour model.
    let channels = exr::prelude::SpecificChannels::build().with_channel("Y").with_pixel_fn(|_| (1.0_f32,));
    let image = exr::prelude::Image::from_channels((8, 4), channels);
    image.write().to_file(folder.path().join("grey.exr")).unwrap();
    assert!(refused("grey.exr").is_bad_input());
}

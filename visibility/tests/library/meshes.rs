//! OBJ and PLY: what is read, and every way in which it is refused.

use sightlines_visibility::scene::load_world;

use super::{Folder, load_bytes, refusal};

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn obj_parts_polygons_relative_indices_and_everything_that_is_left_out() {
    let text = "# a comment in Latin-1: \u{e9}\nmtllib none.mtl\no first part\n\
                v 0 0 0 0.5 0.5 0.5\nv 1 0 0\nv 1 1 0\nv 0 2 0 2\nvt 0.5\nvn 0 0\n\
                usemtl red\ns off\nf 1/1/1 2//1 3/7 4\nl 1 2 3\np 1\n\
                g\nf -4 -3 \\\n -2\nf 1 1 2\n";
    let mut bytes = text.as_bytes().to_vec();
    let at = bytes.iter().position(|&b| b == 0xC3).unwrap();
    bytes.remove(at);
    let scene = load_bytes("mesh.obj", bytes).unwrap();
    assert_eq!((scene.name.as_str(), scene.units, scene.parts.len()), ("mesh.obj", "units of the file", 2));
    assert_eq!(scene.parts[0].name, "first part");
    assert_eq!((scene.triangle_count(), scene.degenerate_count()), (4, 1));
    let corners = scene.triangles();
    let [a, b, c, d] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(corners, [[a, b, c], [a, c, d], [a, b, c], [a, a, b]], "a weight divides, a line may continue");
    let bounds = scene.bounds();
    assert_eq!((bounds.min, bounds.max, bounds.centre), (a, c, [0.5, 0.5, 0.0]));
    assert_eq!(bounds.radius, 0.5_f64.sqrt());
}

#[test]
fn obj_coordinates_keep_their_f64() {
    let scene = load_bytes("mesh.obj", "v 0.1 1e-9 123456789.125\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    assert_eq!(scene.triangles()[0][0], [0.1, 1e-9, 123456789.125]);
}

#[test]
fn a_concave_polygon_is_not_covered_beyond_its_outline() {
    let text = "v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 5 0\nf 1 2 3 4\n";
    let notch = [2.0, 1.0, 0.0];
    let scene = load_bytes("mesh.obj", text).unwrap();
    assert!(scene.triangles().iter().all(|t| t.contains(&notch)), "the cut goes through the notch");
}

#[test]
fn broken_obj_files_are_refused_with_their_line() {
    let cases = [
        ("v 0 0\n", ":1: `v 0 0`: it is no vertex of three numbers"),
        ("v 0 0 0\nv 0 zero 0\n", ":2: `v 0 zero 0`: it is no vertex of three numbers"),
        ("v 0 0 0\nv 0 0 0\0\n", ":2: it has a zero byte, so it is no text"),
        ("v 0 0 0 0\n", ":1: `v 0 0 0 0`: scaling (w) by zero"),
        ("f 1 2 x\n", ":5: `f 1 2 x`: it is no face of whole numbers"),
        ("f 1 2 5\n", ":5: the face uses vertex 5, and the file has 4 vertices"),
        ("f 0 1 2\n", ":5: the face uses vertex 0"),
        ("f 1 2 3\n\nf -5 1 2\n", ":7: the face uses vertex -5"),
        ("f 1 2 9223372036854775807\n", ":5: the face uses vertex 9223372036854775807"),
        ("f 1 2 3 -9223372036854775808\n", ":5: the face uses vertex -9223372036854775808"),
    ];
    for (text, expected) in cases {
        let text = if text.starts_with('f') { format!("{SQUARE}{text}") } else { text.to_owned() };
        let message = refusal(load_bytes("mesh.obj", &text), "mesh.obj");
        assert!(message.contains(expected), "{text:?}: {message}");
    }
}

#[test]
fn a_mark_of_utf8_hides_no_vertex_and_a_thousand_continued_lines_are_one() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let plain = load_bytes("mesh.obj", corners).unwrap();
    assert_eq!(load_bytes("mesh.obj", format!("\u{feff}{corners}")).unwrap(), plain);
    assert_eq!(load_bytes("mesh.obj", corners.replace("v 1", &format!("v {}1", "\\\n".repeat(1000)))).unwrap(), plain);
}

#[test]
fn a_world_is_held_to_what_a_scene_is() {
    let folder = Folder::new();
    let point = folder.put("point.obj", "v 1 2 3\nv 1 2 3\nf 1 2 1\n");
    let message = refusal(load_world(&point), "point.obj");
    assert!(message.contains("all its vertices coincide"), "{message}");
}

#[test]
fn ply_elements_of_nothing_are_refused_before_they_are_counted() {
    let head = "ply\nformat binary_little_endian 1.0\nelement nothing 16777216\nelement vertex 3\n";
    let rest = "property float x\nproperty float y\nproperty float z\nelement face 1\n\
        property list uchar int vertex_indices\nend_header\n";
    let message = refusal(load_bytes("mesh.ply", format!("{head}{rest}")), "mesh.ply");
    assert!(message.contains("element `nothing`: it has no property"), "{message}");
}

#[test]
fn what_is_not_a_shape_is_refused() {
    let cases = [
        ("", "the file is empty"),
        ("v 0 0 0\nv 1 0 0\nl 1 2\nf\nf 1 2\n", "there is no triangle in it"),
        ("v 1 2 3\nf 1 1 1\n", "all its vertices coincide"),
        ("v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "vertex 2: the coordinates (1.0, NaN, 0.0) are not finite"),
        (
            "o cloud\nv 0 0 0\nv 1 0 0\nv 0 -inf 0\nf 1 2 3\n",
            "mesh `cloud`, vertex 3: the coordinates (0.0, -inf, 0.0)",
        ),
        ("v 0 0 0\nv 1 0 0\nv 0 1e400 0\nf 1 2 3\n", "are not finite"),
        ("v 0 0 0\nv 1 0 0\nv 0 2e12 0\nf 1 2 3\n", "are beyond 1e12"),
        ("v 1e11 0 0\nv 1e11 0 1\nv 1e11 1 0\nf 1 2 3\n", "and it is 1e11 from the origin"),
    ];
    for (text, expected) in cases {
        let message = refusal(load_bytes("mesh.obj", text), "mesh.obj");
        assert!(message.contains(expected), "{text:?}: {message}");
    }
}

#[test]
fn an_object_may_not_use_what_comes_after_it() {
    let text = format!("{SQUARE}f 1 2 6\no next\nv 5 5 5\nv 6 6 6\nf 1 2 6\n");
    let message = refusal(load_bytes("mesh.obj", text), "mesh.obj");
    assert!(message.contains("a vertex that comes after its object"), "{message}");
}

const PLY: &str = "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty double y\n\
                   property int z\nproperty uchar red\nelement mark 1\nproperty float weight\nelement face 2\n\
                   property list uchar int vertex_indices\nproperty float quality\nend_header\n\
                   0 0 0 255\n1 0 0 255\n1 1 0 255\n0 1 0 255\n0.5\n4 0 1 2 3 0.5\n3 0 0 1 0.5\n";

#[test]
fn ply_ascii() {
    // The content says that it is PLY, whatever the name says.
    let scene = load_bytes("mesh.obj", PLY).unwrap();
    assert_eq!((scene.triangle_count(), scene.degenerate_count()), (3, 1));
    assert_eq!(scene.parts[0].triangles, [[0, 1, 2], [0, 2, 3], [0, 0, 1]]);
    assert_eq!(scene.parts[0].vertices[2], [1.0, 1.0, 0.0]);
}

/// A triangle as binary PLY.
fn binary(order: &str, word: fn(u32) -> [u8; 4]) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_{order}_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
         property float z\nelement face 1\nproperty list uchar uint vertex_index\nend_header\n"
    )
    .into_bytes();
    for coordinate in [0.0_f32, 0.0, 0.0, 1.5, 0.0, 0.0, 0.0, 0.0, -2.25] {
        bytes.extend(word(coordinate.to_bits()));
    }
    bytes.push(3);
    (0..3).for_each(|index| bytes.extend(word(index)));
    bytes
}

#[test]
fn ply_binary_of_both_byte_orders() {
    for bytes in [binary("little", u32::to_le_bytes), binary("big", u32::to_be_bytes)] {
        let scene = load_bytes("mesh.ply", &bytes).unwrap();
        assert_eq!(scene.triangles(), [[[0.0; 3], [1.5, 0.0, 0.0], [0.0, 0.0, -2.25]]]);
        let message = refusal(load_bytes("mesh.ply", &bytes[..bytes.len() - 1]), "mesh.ply");
        assert!(message.starts_with("mesh.ply: Unexpected end of file"), "no line in binary data: {message}");
    }
}

#[test]
fn ply_coordinates_that_are_not_finite_are_refused() {
    let mut bytes = binary("little", u32::to_le_bytes);
    let last = bytes.len() - 13;
    bytes[last - 4..last].copy_from_slice(&f32::NAN.to_le_bytes());
    let message = refusal(load_bytes("mesh.ply", bytes), "mesh.ply");
    assert!(message.contains("mesh, vertex 3: the coordinates (0.0, 0.0, NaN) are not finite"), "{message}");
}

#[test]
fn broken_ply_files_are_refused() {
    let cases = [
        (PLY.replace("format ascii 1.0\n", ""), "No format line found"),
        (PLY.replace("property float x", "property float"), "mesh.ply:5: Couldn't parse line"),
        (PLY.replace("end_header\n", ""), "mesh.ply:14: Couldn't parse line"),
        (PLY.replace("1 1 0 255", "1 one 0 255"), "mesh.ply:17: Couldn't read element line"),
        (PLY.replace("3 0 0 1 0.5\n", ""), "Unexpected end of file"),
        (PLY.replace("4 0 1 2 3", "4 0 1 2 4"), "face 1: vertex 4 (from 0) is used, and there are 4"),
        (PLY.replace("3 0 0 1", "3 0 -1 1"), "face 2: vertex -1 (from 0) is used"),
        (PLY.replace("float x", "float u"), "its vertices have no property `x`"),
        (PLY.replace("vertex_indices", "corners"), "no element `face` with a list `vertex_indices`"),
        (PLY.replace("list uchar int", "list uchar float"), "mesh.ply:20: Couldn't read element line"),
        (PLY.replace("vertex 4", "vertex 4000000000"), "4000000000 elements `vertex`, at most 16777216 are taken"),
        (PLY.replace("mark 1", "mark 18446744073709551615"), "18446744073709551615 elements `mark`"),
        (PLY.replace("face 2", "face 99999999"), "99999999 elements `face`, at most 8388608 are taken"),
        (PLY.replace("1 1 0 255", "1 nan 0 255"), "mesh.ply:17: Couldn't read element line"),
        ("ply\n".to_owned(), "Unexpected end of file"),
    ];
    for (text, expected) in cases {
        let message = refusal(load_bytes("mesh.ply", &text), "mesh.ply");
        assert!(message.contains(expected), "{expected}: {message}");
    }
}

#[test]
fn no_cut_and_no_flipped_byte_panics() {
    let files = [
        ("mesh.obj", format!("{SQUARE}f 1/1/1 2//2 3 4\no next\nf -1 -2 -3\n").into_bytes()),
        ("mesh.ply", PLY.as_bytes().to_vec()),
        ("mesh.ply", binary("little", u32::to_le_bytes)),
        ("mesh.glb", super::gltf::glb(&super::gltf::TRIANGLE.replace("URI", ""), &super::gltf::points())),
    ];
    for (name, bytes) in files {
        assert!(load_bytes(name, &bytes).is_ok(), "{name}");
        for at in 0..bytes.len() {
            let mut broken = bytes.clone();
            broken[at] ^= 1 << (at % 8);
            let answers = [load_bytes(name, &broken), load_bytes(name, &bytes[..at])];
            for error in answers.into_iter().filter_map(Result::err) {
                assert!(error.is_bad_input() && error.to_string().contains(name), "byte {at}: {error}");
            }
        }
    }
}

#[test]
fn ply_normals_are_read_where_all_three_are_there() {
    let text = |properties: &str, rest: &str| {
        let vertex = |p: &str| format!("{p} {rest}\n");
        let vertices = ["0 0 0", "1 0 0", "0 1 0"].map(vertex).concat();
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n{properties}\
             element face 1\nproperty list uchar int vertex_index\nend_header\n{vertices}3 0 1 2\n"
        )
    };
    let normal = "property float nx\nproperty float ny\nproperty float nz\n";
    let scene = load_bytes("mesh.ply", text(normal, "0 0.5 -2")).unwrap();
    assert_eq!(scene.parts[0].normals, [[0.0, 0.5, -2.0]; 3]);
    let scene = load_bytes("mesh.ply", text(&normal.replace("nz", "curvature"), "0 0.5 -2")).unwrap();
    assert!(scene.parts[0].normals.is_empty());
}

#[test]
fn obj_normals_are_read_where_every_corner_has_one() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 2\nvn 1 0 0\nf 1//1 2//1 3/9/1\nf 1//-1 3//-1 4//-1\n";
    let part = load_bytes("mesh.obj", text).unwrap().parts.remove(0);
    // Vertices 1 and 3 have a normal in each face.
    assert_eq!(part.vertices.len(), 6);
    assert_eq!(part.triangles, [[0, 1, 2], [3, 4, 5]]);
    assert_eq!((part.normals[2], part.normals[4]), ([0.0, 0.0, 2.0], [1.0, 0.0, 0.0]));
    assert_eq!(part.vertices[2], part.vertices[4]);
    for lacking in [text.replace("f 1//1", "f 1"), text.replace("f 1//-1", "f 1//3"), text.replace("vn", "#")] {
        let part = load_bytes("mesh.obj", lacking).unwrap().parts.remove(0);
        assert_eq!((part.vertices.len(), part.normals.len()), (4, 0));
    }
}

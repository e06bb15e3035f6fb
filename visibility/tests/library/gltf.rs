//! glTF: nodes, transforms, instances, every kind of buffer and primitive, and refusals.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sightlines_visibility::scene::{Lens, Scene, load, load_world};

use super::{Folder, load_bytes, refusal};

/// One triangle in one node. `URI` stands for the buffer's address.
pub(crate) const TRIANGLE: &str = r#"{
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"name": "leaf", "mesh": 0}],
"meshes": [{"name": "blade", "primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,1,0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{URI"byteLength": 36}]
}"#;

/// The corners (0, 0, 0), (1, 0, 0) and (0, 1, 0).
pub(crate) fn points() -> Vec<u8> {
    [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|c| c.to_le_bytes()).collect()
}

pub(crate) fn glb(json: &str, binary: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], with: u8| [bytes, &vec![with; bytes.len().wrapping_neg() % 4]].concat();
    let chunks = [(b"JSON", padded(json.as_bytes(), b' ')), (b"BIN\0", padded(binary, 0))];
    let body: Vec<u8> = chunks
        .iter()
        .flat_map(|(kind, data)| [&(data.len() as u32).to_le_bytes()[..], &kind[..], data].concat())
        .collect();
    [&b"glTF"[..], &2_u32.to_le_bytes(), &(12 + body.len() as u32).to_le_bytes(), &body].concat()
}

fn embedded(json: &str, binary: &[u8]) -> String {
    let uri = format!(r#""uri": "data:application/octet-stream;base64,{}", "#, BASE64_STANDARD.encode(binary));
    json.replace("URI", &uri)
}

fn triangle(edit: impl Fn(String) -> String) -> sightlines_visibility::Result<Scene> {
    load_bytes("a.gltf", embedded(&edit(TRIANGLE.to_owned()), &points()))
}

const CORNERS: [[f64; 3]; 3] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

#[test]
fn buffers_in_the_file_beside_it_and_in_a_glb() {
    let folder = Folder::new();
    folder.put("the points.bin", points());
    let beside = TRIANGLE.replace("URI", r#""uri": "the%20points.bin", "#);
    let scenes = [
        load(&folder.put("a.gltf", beside)).unwrap(),
        load_bytes("a.gltf", embedded(TRIANGLE, &points())).unwrap(),
        load_bytes("a.glb", glb(&TRIANGLE.replace("URI", ""), &points())).unwrap(),
    ];
    for scene in scenes {
        assert_eq!((scene.units, scene.parts[0].name.as_str()), ("metres", "leaf"));
        assert_eq!(scene.triangles(), [CORNERS]);
    }
}

#[test]
fn instances_and_nested_transforms() {
    let nodes = r#""nodes": [
        {"children": [1, 2], "translation": [10, 0, 0]},
        {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 1, 1]},
        {"mesh": 0, "matrix": [1,0,0,0, 0,0,1,0, 0,-1,0,0, 0,5,0,1]}],"#;
    let scene = triangle(|text| text.replace(r#""nodes": [{"name": "leaf", "mesh": 0}],"#, nodes)).unwrap();
    assert_eq!(scene.parts.iter().map(|part| part.name.as_str()).collect::<Vec<_>>(), ["blade", "blade"]);
    let expected = [
        // Twice as long, then a quarter turn about z, then moved.
        [[10.0, 0.0, 0.0], [10.0, 2.0, 0.0], [9.0, 0.0, 0.0]],
        // y becomes z.
        [[10.0, 5.0, 0.0], [11.0, 5.0, 0.0], [10.0, 5.0, 1.0]],
    ];
    for (found, expected) in scene.triangles().as_flattened().iter().zip(expected.as_flattened()) {
        for axis in 0..3 {
            assert!((found[axis] - expected[axis]).abs() < 1e-6, "{found:?} {expected:?}");
        }
    }
}

#[test]
fn a_mesh_is_kept_once_and_cameras_stand_where_their_nodes_do() {
    let nodes = r#""nodes": [
        {"children": [1, 2], "translation": [10, 0, 0]},
        {"mesh": 0, "scale": [2, 1, 1]},
        {"name": "side", "camera": 0, "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]},
        {"name": "leaf", "mesh": 0, "translation": [0, 5, 0]},
        {"camera": 1, "translation": [0, 0, 7]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1.5707963267948966, "znear": 0.25}},
                    {"name": "map", "type": "orthographic", "orthographic": {"xmag": 9, "ymag": 4, "znear": 1, "zfar": 9}}],"#;
    let text = TRIANGLE
        .replace(r#""nodes": [{"name": "leaf", "mesh": 0}],"#, nodes)
        .replace(r#""scenes": [{"nodes": [0]}]"#, r#""scenes": [{"nodes": [0, 3, 4]}]"#);
    let folder = Folder::new();
    let path = folder.put("a.gltf", embedded(&text, &points()));
    let world = load_world(&path).unwrap();
    assert_eq!((world.meshes.len(), world.triangle_count(), &*world.meshes[0].name), (1, 2, "blade"));
    assert_eq!(world.instances.iter().map(|i| (&*i.name, i.mesh)).collect::<Vec<_>>(), [("blade", 0), ("leaf", 0)]);
    assert_eq!(world.flatten(), load(&path).unwrap());
    let [side, map] = &world.cameras[..] else { panic!("{:?}", world.cameras) };
    assert_eq!((&*side.name, &*map.name), ("side", "map"));
    assert!((side.forward[0] + 1.0).abs() < 1e-6 && side.eye == [10.0, 0.0, 0.0], "{side:?}");
    let Lens::Perspective { slope, near } = side.lens else { panic!("{:?}", side.lens) };
    assert!((slope - 1.0).abs() < 1e-6 && near == Some(0.25));
    assert_eq!((map.lens, map.eye, map.up), (Lens::Orthographic { height: 8.0 }, [0.0, 0.0, 7.0], [0.0, 1.0, 0.0]));
    let flat = text.replace("\"yfov\": 1.5707963267948966", "\"yfov\": 0.0");
    let path = folder.put("a.gltf", embedded(&flat, &points()));
    assert!(refusal(load_world(&path), "a.gltf").contains("node 2: camera 0 has a lens or a transform without extent"));
}

#[test]
fn a_file_without_scenes_shows_every_root() {
    let scene = triangle(|text| {
        text.replace(r#""scene": 0, "scenes": [{"nodes": [0]}],"#, "")
            .replace(r#""nodes": [{"#, r#""nodes": [{"children": [1]}, {"#)
    });
    assert_eq!(scene.unwrap().triangle_count(), 1);
}

/// Four corners of a square and their indices, of a type and a mode.
fn square(mode: u32, indices: &[u8], kind: u32, count: usize) -> Scene {
    let corners = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    let mut binary: Vec<u8> = corners.as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect();
    binary.extend(indices);
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "mode": {mode}}}]}}],
        "accessors": [
            {{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0,0,0], "max": [1,1,0]}},
            {{"bufferView": 1, "componentType": {kind}, "count": {count}, "type": "SCALAR"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 48}},
            {{"buffer": 0, "byteOffset": 48, "byteLength": {}}}],
        "buffers": [{{URI"byteLength": {}}}]}}"#,
        indices.len(),
        binary.len()
    );
    load_bytes("a.gltf", embedded(&json, &binary)).unwrap()
}

#[test]
fn lists_strips_and_fans_with_every_type_of_index() {
    let list = square(4, &[0, 1, 2, 2, 1, 3], 5121, 6);
    assert_eq!(list.parts[0].triangles, [[0, 1, 2], [2, 1, 3]]);
    let words: Vec<u8> = [0_u16, 1, 2, 3].iter().flat_map(|i| i.to_le_bytes()).collect();
    assert_eq!(square(5, &words, 5123, 4).parts[0].triangles, [[0, 1, 2], [2, 1, 3]]);
    let words: Vec<u8> = [0_u32, 1, 3, 2].iter().flat_map(|i| i.to_le_bytes()).collect();
    assert_eq!(square(6, &words, 5125, 4).parts[0].triangles, [[0, 1, 3], [0, 3, 2]]);
}

#[test]
fn quantised_and_sparse_positions() {
    let quantised = r#"{"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_mesh_quantization"],
        "extensionsUsed": ["KHR_mesh_quantization"], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC3",
            "min": [-127,0,0], "max": [127,127,0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 12, "byteStride": 4}], "buffers": [{URI"byteLength": 12}]}"#;
    let bytes = [0, 0, 0, 9, 127, 0, 0, 9, 128, 127, 0, 9];
    let scene = load_bytes("a.gltf", embedded(quantised, &bytes)).unwrap();
    assert_eq!(scene.triangles(), [[[0.0; 3], [1.0, 0.0, 0.0], [-1.0, 1.0, 0.0]]]);

    let sparse = |index: u8| {
        let text = TRIANGLE.replace(
            r#""max": [1,1,0]}"#,
            r#""max": [1,1,7], "sparse": {"count": 1,
            "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 2}}}"#,
        );
        let views = r#""byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 1},
            {"buffer": 0, "byteOffset": 40, "byteLength": 12}],"#;
        let text = text
            .replacen(r#""byteLength": 36}],"#, views, 1)
            .replace(r#"URI"byteLength": 36"#, r#"URI"byteLength": 52"#);
        let seven: Vec<u8> = [0.0_f32, 0.0, 7.0].iter().flat_map(|c| c.to_le_bytes()).collect();
        load_bytes("a.gltf", embedded(&text, &[points(), vec![index, 0, 0, 0], seven].concat()))
    };
    assert_eq!(sparse(2).unwrap().triangles(), [[CORNERS[0], CORNERS[1], [0.0, 0.0, 7.0]]]);
    assert!(refusal(sparse(3), "a.gltf").contains("accessor 0: sparse index 3 is beyond the 3 elements"));
}

#[test]
fn broken_gltf_files_are_refused() {
    let cases: [(&str, &str, &str); 17] = [
        (r#""scene": 0,"#, r#""scene": 0,,"#, "a.gltf:2: key must be a string"),
        (r#""mesh": 0}"#, r#""mesh": 7}"#, "nodes[0].mesh: Index out of bounds"),
        (r#""type": "VEC3""#, r#""type": "VEC9""#, "accessors[0].type: Invalid value"),
        (r#""type": "VEC3""#, r#""type": "VEC2""#, "accessor 0: positions cannot be Vec2 of F32"),
        (r#""count": 3"#, r#""count": 4"#, "accessor 0: its 4 elements reach beyond buffer view 0"),
        (r#""count": 3"#, r#""count": 18446744073709551615"#, "primitive 0: 18446744073709551615 vertices"),
        (r#""byteLength": 36}],"#, r#""byteLength": 37}],"#, "accessor 0: its 3 elements reach beyond"),
        (r#"URI"byteLength": 36"#, r#"URI"byteLength": 40"#, "buffer 0: 40 bytes are promised, 36 are there"),
        ("URI", r#""uri": "none.bin", "#, "buffer 0: its file `none.bin` cannot be read"),
        ("URI", r#""uri": "a%00b", "#, "buffer 0: its file `a\u{fffd}b` cannot be read"),
        ("URI", r#""uri": "", "#, "buffer 0: its file `` cannot be read"),
        ("URI", r#""uri": "https://host/a.bin", "#, "buffer 0: `https://host/a.bin` is not on this machine"),
        ("URI", r#""uri": "data:;base64,????", "#, "buffer 0: its base64"),
        ("URI", "", "buffer 0: the file has no binary chunk"),
        (r#""POSITION": 0"#, r#""POSITION": 8"#, "meshes[0]: an accessor's index is out of bounds"),
        (r#""POSITION": 0"#, r#""NORMAL": 0"#, "meshes[0].primitives[0].attributes[\"POSITION\"]: Missing data"),
        (r#"{"POSITION": 0}"#, r#"{"POSITION": 0}, "mode": 1"#, "there is no triangle in it"),
    ];
    for (old, new, expected) in cases {
        let message = refusal(triangle(|text| text.replacen(old, new, 1)), "a.gltf");
        assert!(message.contains(expected), "{new}: {message}");
    }
}

#[test]
fn a_hierarchy_that_is_no_forest_is_refused() {
    let nodes = |nodes: &str| triangle(|text| text.replace(r#"{"name": "leaf", "mesh": 0}"#, nodes));
    for bad in [
        r#"{"children": [0]}"#,
        r#"{"children": [1]}, {"children": [0], "mesh": 0}"#,
        r#"{"children": [1, 2]}, {"children": [3]}, {"children": [3]}, {"mesh": 0}"#,
        r#"{"children": [1, 1]}, {"mesh": 0}"#,
    ] {
        let message = refusal(nodes(bad), "a.gltf");
        assert!(message.contains("the node is reached twice"), "{bad}: {message}");
    }
    // A chain as deep as any: it is walked without recursion.
    let chain: Vec<String> = (1..20_000).map(|child| format!(r#"{{"children": [{child}]}}"#)).collect();
    let deep = nodes(&format!(r#"{}, {{"mesh": 0}}"#, chain.join(", "))).unwrap();
    assert_eq!(deep.triangles(), [CORNERS]);
}

#[test]
fn indices_stay_within_their_own_primitive() {
    let two = r#"{"attributes": {"POSITION": 0}, "indices": 1}, {"attributes": {"POSITION": 0}}"#;
    let text = TRIANGLE
        .replace(r#"{"attributes": {"POSITION": 0}}"#, two)
        .replace(
            r#""max": [1,1,0]}"#,
            r#""max": [1,1,0]}, {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}"#,
        )
        .replace(r#""byteLength": 36}],"#, r#""byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 3}],"#)
        .replace(r#"URI"byteLength": 36"#, r#"URI"byteLength": 39"#);
    let with = |last: u8| load_bytes("a.gltf", embedded(&text, &[points(), vec![0, 1, last]].concat()));
    assert_eq!(with(2).unwrap().triangles(), [CORNERS, CORNERS]);
    assert!(refusal(with(3), "a.gltf").contains("mesh 0, primitive 0: vertex 3 (from 0) is used, and there are 3"));
}

#[test]
fn extensions_that_change_the_shape_are_refused_and_others_are_not() {
    let with = |name: &str| {
        let lists = format!(r#"{{"extensionsUsed": ["{name}"], "extensionsRequired": ["{name}"],"#);
        triangle(|text| text.replacen('{', &lists, 1))
    };
    assert!(with("KHR_texture_basisu").is_ok());
    for name in ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"] {
        assert!(refusal(with(name), "a.gltf").contains(&format!("it uses {name}, which is not read")));
    }
}

#[test]
fn a_glb_that_is_cut_off_is_refused() {
    let whole = glb(&TRIANGLE.replace("URI", ""), &points());
    for length in [4, 8, 11, 12, 19, 20, 100, whole.len() - 1] {
        refusal(load_bytes("a.glb", &whole[..length]), "a.glb");
    }
    let mut short = whole;
    short[8..12].copy_from_slice(&4_u32.to_le_bytes());
    assert!(refusal(load_bytes("a.glb", short), "a.glb").contains("its header is cut off"));
}

#[test]
fn normals_follow_their_node_and_mirrored_triangles_are_turned_round() {
    let node = |scale: &str| {
        let json = TRIANGLE
            .replace("URI", "")
            .replace(r#""mesh": 0}"#, &format!(r#""mesh": 0, "scale": {scale}}}"#))
            .replace(r#"{"POSITION": 0}"#, r#"{"POSITION": 0, "NORMAL": 1}"#)
            .replace("\"bufferViews\"", "\"bufferViews_\"")
            .replace(r#""max": [1,1,0]}]"#, r#""max": [1,1,0]},
                {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}]"#)
            .replace(
                r#""bufferViews_": [{"buffer": 0, "byteLength": 36}]"#,
                r#""bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36}]"#,
            )
            .replace(r#""buffers": [{"byteLength": 36}]"#, r#""buffers": [{"byteLength": 72}]"#);
        let normals = [1.0_f32, 0.0, 1.0].repeat(3).iter().flat_map(|c| c.to_le_bytes()).collect::<Vec<u8>>();
        load_bytes("a.glb", glb(&json, &[points(), normals].concat())).unwrap().parts.remove(0)
    };
    let part = node("[2, 1, 1]");
    assert_eq!((part.triangles[0], part.normals[0]), ([0, 1, 2], [1.0, 0.0, 2.0]), "steeper along the axis that grew");
    let part = node("[1, 1, -1]");
    assert_eq!((part.triangles[0], part.normals[0]), ([0, 2, 1], [1.0, 0.0, -1.0]));
}

/// The triangle with texture coordinates (0, 0), (1, 0.2) and (0.2, 1), in the component type of a number of glTF's.
fn mapped(kind: u32, map: &[u8], is_normalized: bool) -> sightlines_visibility::Result<Scene> {
    let uvs = format!(
        r#","max": [1,1,0]}}, {{"bufferView": 1, "componentType": {kind}, "normalized": {is_normalized}, "count": {}, "type": "VEC2"}}],"#,
        if map.len() == 4 { 2 } else { 3 }
    );
    let text = TRIANGLE
        .replace(r#"{"POSITION": 0}"#, r#"{"POSITION": 0, "TEXCOORD_0": 1}"#)
        .replace(r#", "max": [1,1,0]}],"#, &uvs)
        .replace(
            r#""byteLength": 36}],
"buffers""#,
            &format!(
                r#""byteLength": 36}}, {{"buffer": 0, "byteOffset": 36, "byteLength": {}}}], "buffers""#,
                map.len()
            ),
        )
        .replace(r#"{URI"byteLength": 36}"#, &format!(r#"{{URI"byteLength": {}}}"#, 36 + map.len()));
    load_bytes("a.gltf", embedded(&text, &[&points()[..], map].concat()))
}

#[test]
fn texture_coordinates_of_every_component_type() {
    let floats: Vec<u8> = [0.0_f32, 0.0, 1.0, 0.2, 0.2, 1.0].iter().flat_map(|c| c.to_le_bytes()).collect();
    let bytes = [0, 0, 255, 51, 51, 255];
    let shorts: Vec<u8> = [0u16, 0, 65_535, 13_107, 13_107, 65_535].iter().flat_map(|c| c.to_le_bytes()).collect();
    for (kind, map, is_normalized) in [(5126, &floats[..], false), (5121, &bytes[..], true), (5123, &shorts, true)] {
        let scene = mapped(kind, map, is_normalized).unwrap();
        let found = scene.parts[0].uvs[0];
        // v counts upwards here.
        for (found, expected) in found.iter().zip([[0.0, 1.0], [1.0, 0.8], [0.2, 0.0]]) {
            assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 1e-7), "{kind}: {found:?} for {expected:?}");
        }
    }
    let whole = mapped(5121, &[0, 0, 1, 0, 0, 1], false).unwrap();
    assert_eq!(whole.parts[0].uvs, [[[0.0, 1.0], [1.0, 1.0], [0.0, 0.0]]], "integers as they are, unless normalised");
    // A vertex beyond the map has no place on it.
    assert_eq!(mapped(5121, &[0, 0, 255, 0], true).unwrap().parts[0].uvs.len(), 1);
    let message = mapped(5125, &[0; 24], false).unwrap_err().to_string();
    assert!(message.contains("texture coordinates cannot be Vec2 of U32"), "{message}");
}

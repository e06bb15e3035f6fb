//! Small valid files of every kind, made here: what is damaged next.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use exr::prelude::{
    Compression, Encoding, Image, Layer, LayerAttributes, LineOrder, SpecificChannels, Vec2, WritableImage,
};
use sightlines_backend::CONTRACT_VERSION;
use sightlines_visibility::ambient::Sphere;
use sightlines_visibility::ambient::file::Stored;
use sightlines_visibility::sets;
use sightlines_visibility::shadows::Sets;

use super::every::mend_digest;

/// Every seed with its kind.
pub(crate) fn all() -> Vec<(&'static str, Vec<u8>)> {
    let text = |text: &str| text.as_bytes().to_vec();
    let mut seeds = vec![
        ("obj", text(OBJ)),
        ("ply", text(PLY)),
        ("ply", binary_ply()),
        ("gltf", text(&GLTF.replace("URI", &uri()))),
        ("glb", glb()),
        ("hdr", [HDR.as_bytes(), &[130, 90, 20, 129].repeat(8)].concat()),
        (
            "hdr",
            [HDR.replace("2 +X 4", "4 +X 8").as_bytes(), &[2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 129].repeat(4)]
                .concat(),
        ),
        ("toml", text(TOML)),
        ("txt", text("4,3,6/0,1,0\n0,1,0/0,1,-1/60 # a lens\n1,2,3/0,0,0/height=8\n")),
        ("sets", sets_of_two_texels()),
        ("occl", matrix()),
        ("seen", seen()),
    ];
    seeds.extend(EXR.map(|compression| ("exr", exr_file(compression))));
    seeds
}

const OBJ: &str = "o first\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 2 0 2\nv 0.4 0.6 0\nvn 0 0 1\nf 1//1 2//1 3//1 5//1 4//1\n\
    g second\nv 0 0 1\nf -1 -3 \\\n -2\nl 1 2\n";

const PLY: &str = "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty double y\n\
    property float z\nproperty uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0 255\n1 0 0 128\n1 1 0.5 0\n0 1 0 7\n4 0 1 2 3\n3 0 1 2\n";

fn binary_ply() -> Vec<u8> {
    let head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
        property float z\nproperty float nx\nproperty float ny\nproperty float nz\nelement face 1\n\
        property list uint uint vertex_index\nend_header\n";
    let floats =
        [[0.0_f32, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]];
    let words = floats.as_flattened().iter().map(|c| c.to_bits()).chain([3, 0, 1, 2]);
    head.bytes().chain(words.flat_map(u32::to_le_bytes)).collect()
}

/// Two instances of a mesh with normals, indices and joints, a sparse accessor, a camera, a skin and an animation.
const GLTF: &str = r#"{
"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
"nodes": [{"name": "leaf", "mesh": 0, "children": [1], "rotation": [0, 0.6, 0, 0.8]},
  {"mesh": 0, "translation": [1, 2, 3], "scale": [2, 2, -1], "skin": 0}, {"camera": 0, "translation": [0, 1, 9]}],
"cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1, "aspectRatio": 1.5}}],
"meshes": [{"name": "blade", "primitives": [{"attributes":
  {"POSITION": 0, "NORMAL": 1, "JOINTS_0": 4, "WEIGHTS_0": 5}, "indices": 2, "mode": 5}]}],
"skins": [{"joints": [0, 2, 1], "inverseBindMatrices": 6}],
"animations": [{"channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}},
  {"sampler": 1, "target": {"node": 0, "path": "rotation"}}],
  "samplers": [{"input": 3, "output": 1, "interpolation": "LINEAR"}, {"input": 3, "output": 5, "interpolation": "STEP"}]}],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,1,1],
   "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 1}}},
  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
  {"bufferView": 2, "byteOffset": 2, "componentType": 5123, "count": 3, "type": "SCALAR"},
  {"bufferView": 3, "componentType": 5126, "count": 3, "type": "SCALAR", "min": [0], "max": [2]},
  {"bufferView": 2, "componentType": 5121, "count": 3, "type": "VEC4"},
  {"bufferView": 4, "componentType": 5126, "count": 3, "type": "VEC4"},
  {"bufferView": 4, "componentType": 5126, "count": 3, "type": "MAT4"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36},
  {"buffer": 0, "byteOffset": 72, "byteLength": 12}, {"buffer": 0, "byteOffset": 84, "byteLength": 12},
  {"buffer": 0, "byteOffset": 96, "byteLength": 192}],
"buffers": [{URI"byteLength": 288}]
}"#;

fn buffer() -> Vec<u8> {
    let corners = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let normals = [0.0_f32, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0];
    let bytes = |floats: &[f32]| floats.iter().flat_map(|c| c.to_le_bytes()).collect::<Vec<_>>();
    // Indices, which are joints too; times; matrices, which are weights and rotations too.
    let small = [1_u16, 0, 1, 2, 0, 0].into_iter().flat_map(u16::to_le_bytes).collect();
    let identity: Vec<f32> = (0..16).map(|i| f32::from(u8::from(i % 5 == 0))).collect();
    [bytes(&corners), bytes(&normals), small, bytes(&[0.0, 1.0, 2.0]), bytes(&identity.repeat(3))].concat()
}

fn uri() -> String {
    format!(r#""uri": "data:application/octet-stream;base64,{}", "#, BASE64_STANDARD.encode(buffer()))
}

fn glb() -> Vec<u8> {
    let mut json = GLTF.replace("URI", "").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let binary = buffer();
    let word = |n: usize| (n as u32).to_le_bytes();
    let head = [*b"glTF", word(2), word(28 + json.len() + binary.len()), word(json.len()), *b"JSON"];
    [head.as_flattened(), &json, &word(binary.len()), b"BIN\0", &binary].concat()
}

const HDR: &str = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1.0\n\n-Y 2 +X 4\n";

const EXR: [Compression; 5] =
    [Compression::Uncompressed, Compression::RLE, Compression::ZIP16, Compression::PIZ, Compression::PXR24];

fn exr_file(compression: Compression) -> Vec<u8> {
    let channels = SpecificChannels::rgb(|at: Vec2<usize>| (at.x() as f32 * 0.1, at.y() as f32 * 0.2, 0.5_f32));
    let encoding = Encoding { compression, line_order: LineOrder::Increasing, ..Encoding::UNCOMPRESSED };
    let layer = Layer::new((16, 8), LayerAttributes::named("main"), encoding, channels);
    let mut bytes = Vec::new();
    Image::from_layer(layer).write().non_parallel().to_buffered(std::io::Cursor::new(&mut bytes)).unwrap();
    bytes
}

const TOML: &str = "generator = \"box\"\nup = \"y\"\nresolution = 64\nsamples = 32\n\n[[light]]\n\
    corner = [-0.2, 4.0, -0.2]\nu = [0.4, 0.0, 0.0]\nv = [0.0, 0.0, 0.4]\n\n[receiver]\n\
    corner = [-2.0, -0.6, -2.0]\nu = [4.0, 0.0, 0.0]\nv = [0.0, 0.0, 4.0]\n";

/// What a writer of the crate puts into a file.
fn written(write: impl FnOnce(&std::path::Path)) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a");
    write(&path);
    std::fs::read(path).unwrap()
}

fn sets_of_two_texels() -> Vec<u8> {
    let sets = Sets {
        resolution: 2,
        samples: 32,
        bits: 32,
        words: 1,
        masks: vec![0, 1, 2, u32::MAX],
        samples_uv: vec![[-5, 5]; 32],
        cell: 0.125,
    };
    written(|path| sets::write(path, &sets).unwrap())
}

fn matrix() -> Vec<u8> {
    let stored = Stored {
        sphere: Sphere::Octahedron { level: 1 },
        done: 18,
        positions: 3,
        bias: 1,
        cell: 0.5,
        mesh: [7; 32],
        position_of: vec![0, 1, 2, 1],
        words: vec![1, 2, 3],
    };
    written(|path| stored.write(path).unwrap())
}

/// The sets of two views of 40 instances, by the layout that the module's head states.
fn seen() -> Vec<u8> {
    let words = [1, CONTRACT_VERSION, 40, 2, 0b101, 0, u32::MAX, 0xff];
    let mut bytes = [&b"sightlines seen\n"[..], &words.map(u32::to_le_bytes).concat(), &[0; 32]].concat();
    mend_digest(&mut bytes);
    bytes
}

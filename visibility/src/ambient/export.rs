//! Shaded scenes as files: binary glTF and PLY, with a colour at every vertex.
//!
//! glTF has linear colours of 16 bits and an unlit material, so viewers show what was baked; PLY has the bytes that
//! gamma encodes, as its viewers expect. Both hold the scene's own vertices, normals and parts. Invariant: equal
//! colours give equal bytes.

use std::io;
use std::path::Path;

use serde_json::{Value, json};

use super::matrix::Colours;
use super::surface::{Part, Surface};
use crate::error::Result;
use crate::output;

/// Writes a binary glTF file; a colour of `white` or more is one.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_glb(path: &Path, surface: &Surface, colours: &Colours, white: f64) -> Result<()> {
    let positions = floats(surface.vertices.iter().map(|v| v.map(|c| c as f32)));
    let normals = floats(surface.normals.iter().map(|n| n.map(|c| c as f32 / 32_768.0)));
    let linear = |c: f32| (libm::rint((f64::from(c) / white).clamp(0.0, 1.0) * 65_535.0) as u16).to_le_bytes();
    let colour = |[r, g, b]: &[f32; 3]| [linear(*r), linear(*g), linear(*b), [0xff, 0xff]].concat();
    let colours: Vec<u8> = colours.iter().flat_map(colour).collect();
    let own = |part: &Part, corner: u32| (corner - part.vertices.start).to_le_bytes();
    let corners = surface.parts.iter().flat_map(|part| part.triangles.as_flattened().iter().map(|c| own(part, *c)));
    let indices: Vec<u8> = corners.flatten().collect();
    let chunks = [positions, normals, colours, indices];
    let text = describe(surface, chunks.each_ref().map(Vec::len));
    let mut text = serde_json::to_vec(&text).map_err(|e| crate::Error::write(path, e.into()))?;
    text.resize(text.len().next_multiple_of(4), b' ');
    let data: usize = chunks.iter().map(Vec::len).sum();
    output::write(path, |out| {
        let word = |word: usize| -> io::Result<[u8; 4]> {
            let word = u32::try_from(word).map_err(|_| io::Error::new(io::ErrorKind::FileTooLarge, "over 4 GiB"))?;
            Ok(word.to_le_bytes())
        };
        let header = [word(28 + text.len() + data)?, word(text.len())?, word(data)?];
        out.write_all(&[&b"glTF"[..], &2_u32.to_le_bytes(), &header[0], &header[1], b"JSON"].concat())?;
        out.write_all(&text)?;
        out.write_all(&[&header[2][..], b"BIN\0"].concat())?;
        chunks.iter().try_for_each(|chunk| out.write_all(chunk))
    })
}

fn floats(values: impl Iterator<Item = [f32; 3]>) -> Vec<u8> {
    values.flatten().flat_map(f32::to_le_bytes).collect()
}

/// The file's JSON: a node and a mesh for each part that has triangles, over four views of one buffer.
fn describe(surface: &Surface, sizes: [usize; 4]) -> Value {
    let mut offset = 0;
    // Bytes of a vertex; indices have no stride.
    let views = [Some(12), Some(12), Some(8), None].into_iter().zip(sizes).map(|(stride, size)| {
        let mut view = json!({"buffer": 0, "byteOffset": offset, "byteLength": size});
        view["target"] = json!(if stride.is_some() { 34_962 } else { 34_963 });
        if let Some(stride) = stride {
            view["byteStride"] = json!(stride);
        }
        offset += size;
        view
    });
    let views: Vec<Value> = views.collect();
    let (mut accessors, mut meshes, mut nodes) = (Vec::new(), Vec::new(), Vec::new());
    let mut corner = 0;
    for part in surface.parts.iter().filter(|part| !part.triangles.is_empty()) {
        let first = accessors.len();
        let (start, count) = (part.vertices.start as usize, part.vertices.len());
        let [min, max] = extremes(&surface.vertices[start..start + count]);
        accessors.extend([
            json!({"bufferView": 0, "byteOffset": 12 * start, "componentType": 5126, "count": count, "type": "VEC3",
                "min": min, "max": max}),
            json!({"bufferView": 1, "byteOffset": 12 * start, "componentType": 5126, "count": count, "type": "VEC3"}),
            json!({"bufferView": 2, "byteOffset": 8 * start, "componentType": 5123, "count": count, "type": "VEC4",
                "normalized": true}),
            json!({"bufferView": 3, "byteOffset": 4 * corner, "componentType": 5125, "count": 3 * part.triangles.len(),
                "type": "SCALAR"}),
        ]);
        corner += 3 * part.triangles.len();
        let attributes = json!({"POSITION": first, "NORMAL": first + 1, "COLOR_0": first + 2});
        let primitive = json!({"attributes": attributes, "indices": first + 3, "material": 0});
        nodes.push(json!({"name": part.name, "mesh": meshes.len()}));
        meshes.push(json!({"primitives": [primitive]}));
    }
    json!({
        "asset": {"version": "2.0", "generator": "sightlines"},
        "extensionsUsed": ["KHR_materials_unlit"],
        "scene": 0,
        "scenes": [{"nodes": (0..nodes.len()).collect::<Vec<_>>()}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": [{
            "pbrMetallicRoughness": {"metallicFactor": 0.0},
            "extensions": {"KHR_materials_unlit": {}},
            "doubleSided": surface.findings.open_edges > 0,
        }],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": offset}],
    })
}

fn extremes(points: &[[f64; 3]]) -> [[f32; 3]; 2] {
    let axis = |axis: usize| points.iter().map(move |p| p[axis] as f32);
    let least = [0, 1, 2].map(|i| axis(i).fold(f32::INFINITY, f32::min));
    [least, [0, 1, 2].map(|i| axis(i).fold(f32::NEG_INFINITY, f32::max))]
}

/// Writes a binary PLY file, the parts as one mesh; `bytes` are the encoded colours of all vertices.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_ply(path: &Path, surface: &Surface, bytes: &[[u8; 3]]) -> Result<()> {
    let triangles = || surface.parts.iter().flat_map(|part| &part.triangles);
    output::write(path, |out| {
        write!(out, "ply\nformat binary_little_endian 1.0\nelement vertex {}\n", surface.vertices.len())?;
        for property in ["x", "y", "z", "nx", "ny", "nz"] {
            writeln!(out, "property float {property}")?;
        }
        for property in ["red", "green", "blue"] {
            writeln!(out, "property uchar {property}")?;
        }
        let faces = triangles().count();
        write!(out, "element face {faces}\nproperty list uchar uint vertex_indices\nend_header\n")?;
        for ((vertex, normal), colour) in surface.vertices.iter().zip(&surface.normals).zip(bytes) {
            out.write_all(vertex.map(|c| (c as f32).to_le_bytes()).as_flattened())?;
            out.write_all(normal.map(|c| (c as f32 / 32_768.0).to_le_bytes()).as_flattened())?;
            out.write_all(colour)?;
        }
        for triangle in triangles() {
            out.write_all(&[3])?;
            out.write_all(triangle.map(u32::to_le_bytes).as_flattened())?;
        }
        Ok(())
    })
}

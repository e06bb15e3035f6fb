//! PLY, ascii and binary of either byte order, through `ply-rs-bw`: the elements `vertex` and `face`.

use std::path::Path;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{Encoding, Header, Property, PropertyAccess, PropertyAccessResult};

use super::{MAX_TRIANGLES, MAX_VERTICES, Mesh, Scene, limit, load, polygon};
use crate::error::{Error, Place, Result};

const REMEDY: &str = "mend the file, or export the mesh again";

pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Scene> {
    let mut reader = Reader::new(bytes);
    let header = Parser::<Skipped>::new().read_header(&mut reader).map_err(|e| refused(path, true, &e))?;
    check(path, &header)?;
    let refused = |e| refused(path, header.encoding == Encoding::Ascii, &e);
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => {
                vertices = Parser::new().read_payload_for_element(&mut reader, element, &header).map_err(refused)?
            }
            "face" => faces = Parser::new().read_payload_for_element(&mut reader, element, &header).map_err(refused)?,
            _ => drop(
                Parser::<Skipped>::new().read_payload_for_element(&mut reader, element, &header).map_err(refused)?,
            ),
        }
    }
    let has_normals = header.elements.iter().any(|(name, element)| {
        let has = |axis: &str| element.properties.iter().any(|(property, _)| property == axis);
        name == "vertex" && NORMAL.into_iter().all(has)
    });
    let normals = vertices.iter().filter(|_| has_normals).map(|v: &Vertex| v.normal).collect();
    let vertices: Vec<[f64; 3]> = vertices.into_iter().map(|v| v.position).collect();
    let triangles = Vec::with_capacity(faces.len());
    let mut mesh = Mesh { triangles, vertices, normals, ..Mesh::default() };
    for (number, Face(corners)) in faces.iter().enumerate() {
        add_face(|| Place::file(path).element(format!("face {}", number + 1)), corners, &mut mesh)?;
    }
    Ok(Scene { name: load::name(path), units: "units of the file", parts: vec![mesh] })
}

/// Refuses a header that promises too much, or not what is needed.
fn check(path: &Path, header: &Header) -> Result<()> {
    for (name, element) in &header.elements {
        let most = if name == "face" { MAX_TRIANGLES } else { MAX_VERTICES };
        limit(Place::file(path), &format!("elements `{name}`"), element.count, most)?;
        if element.properties.is_empty() {
            let place = Place::file(path).element(format!("element `{name}`"));
            return Err(place.error("it has no property", REMEDY));
        }
    }
    let has = |element: &str, property: &str| {
        header.elements.iter().any(|(name, e)| name == element && e.properties.iter().any(|(name, _)| name == property))
    };
    if let Some(missing) = POSITION.into_iter().find(|axis| !has("vertex", axis)) {
        return Err(Place::file(path).error(format!("its vertices have no property `{missing}`"), REMEDY));
    }
    if !INDICES.iter().any(|name| has("face", name)) {
        let what = format!("it has no element `face` with a list `{}` or `{}`", INDICES[0], INDICES[1]);
        return Err(Place::file(path).error(what, "export a mesh with faces, not a cloud of points or strips"));
    }
    Ok(())
}

fn add_face(place: impl Fn() -> Place, corners: &[i64], mesh: &mut Mesh) -> Result<()> {
    let count = mesh.vertices.len();
    if let Some(bad) = corners.iter().find(|&&i| i < 0 || i >= count as i64) {
        let what = format!("vertex {bad} (from 0) is used, and there are {count}");
        return Err(place().error(what, REMEDY));
    }
    let corners: Vec<u32> = corners.iter().map(|&i| i as u32).collect();
    polygon::triangulate(place, &mesh.vertices, &corners, &mut mesh.triangles)
}

/// The parser's words in one line. It counts lines in binary data too, where they say nothing.
fn refused(path: &Path, ascii: bool, error: &ParseError) -> Error {
    let place = error.line().filter(|_| ascii).map_or_else(|| Place::file(path), |line| Place::line(path, line));
    let message = error.to_string();
    let message = message.split_once(": ").filter(|_| error.line().is_some()).map_or(&*message, |(_, rest)| rest);
    place.error(message.split_whitespace().collect::<Vec<_>>().join(" "), REMEDY)
}

/// Names of the list of a face's corners.
const INDICES: [&str; 2] = ["vertex_indices", "vertex_index"];

const POSITION: [&str; 3] = ["x", "y", "z"];
const NORMAL: [&str; 3] = ["nx", "ny", "nz"];

#[derive(Default)]
struct Vertex {
    position: [f64; 3],
    normal: [f64; 3],
}

impl Vertex {
    fn coordinate(&mut self, name: &str) -> Option<&mut f64> {
        let axis_of = |names: [&str; 3]| names.into_iter().position(|axis| axis == name);
        match (axis_of(POSITION), axis_of(NORMAL)) {
            (Some(axis), _) => Some(&mut self.position[axis]),
            (_, Some(axis)) => Some(&mut self.normal[axis]),
            _ => None,
        }
    }
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Vertex::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let Some(coordinate) = self.coordinate(name) else {
            return PropertyAccessResult::Ignored;
        };
        *coordinate = match property {
            Property::Char(v) => v.into(),
            Property::UChar(v) => v.into(),
            Property::Short(v) => v.into(),
            Property::UShort(v) => v.into(),
            Property::Int(v) => v.into(),
            Property::UInt(v) => v.into(),
            Property::Float(v) => v.into(),
            Property::Double(v) => v,
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

struct Face(Vec<i64>);

impl PropertyAccess for Face {
    fn new() -> Self {
        Face(Vec::new())
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if !INDICES.contains(&name) {
            return PropertyAccessResult::Ignored;
        }
        self.0 = match property {
            Property::ListChar(v) => v.into_iter().map(i64::from).collect(),
            Property::ListUChar(v) => v.into_iter().map(i64::from).collect(),
            Property::ListShort(v) => v.into_iter().map(i64::from).collect(),
            Property::ListUShort(v) => v.into_iter().map(i64::from).collect(),
            Property::ListInt(v) => v.into_iter().map(i64::from).collect(),
            Property::ListUInt(v) => v.into_iter().map(i64::from).collect(),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// An element that says nothing about the shape.
struct Skipped;

impl PropertyAccess for Skipped {
    fn new() -> Self {
        Skipped
    }
}

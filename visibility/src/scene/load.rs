//! Mesh files: which format a file has, and reading it whole.
//!
//! The content decides where it says what it is (PLY and GLB have a magic, glTF is a JSON object), else the extension.

use std::ffi::OsStr;
use std::path::Path;

use super::{MAX_FILE_BYTES, Scene, World, gltf, obj, ply};
use crate::error::{Place, Result};
use crate::input;

/// Largest text file beside a scene, in bytes.
const MAX_TEXT_BYTES: u64 = 16 << 20;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Obj,
    Gltf,
    Ply,
}

/// Reads a mesh file: Wavefront OBJ, glTF 2.0 (`.gltf` or `.glb`, buffers embedded or beside it), or PLY (ascii or
/// binary).
///
/// Polygons become triangles; points, lines, materials, skins and animations are left out; glTF instances are copies.
///
/// # Errors
///
/// A file that is missing, broken, empty or too large, with the line or the element that is to blame.
pub fn load(path: &Path) -> Result<Scene> {
    let bytes = read(path)?;
    let scene = match format(path, &bytes)? {
        Format::Obj => obj::read(path, &bytes)?,
        Format::Gltf => gltf::read(path, &bytes)?.flatten(),
        Format::Ply => ply::read(path, &bytes)?,
    };
    scene.check(path)
}

/// Reads what [`load`] reads, with every mesh once, glTF nodes as its instances, and the cameras of glTF.
///
/// # Errors
///
/// Those of [`load`].
pub fn load_world(path: &Path) -> Result<World> {
    let bytes = read(path)?;
    let world = match format(path, &bytes)? {
        Format::Obj => World::of(obj::read(path, &bytes)?),
        Format::Gltf => gltf::read(path, &bytes)?,
        Format::Ply => World::of(ply::read(path, &bytes)?),
    };
    world.check(path)
}

/// Reads a small text file whole, such as a path of cameras.
///
/// # Errors
///
/// A file that is missing, too large or not UTF-8.
pub fn read_text(path: &Path) -> Result<String> {
    input::read_text(path, MAX_TEXT_BYTES, "split it, or write fewer lines")
}

/// A file's bytes, if there are not too many.
pub(super) fn read(path: &Path) -> Result<Vec<u8>> {
    input::read(path, MAX_FILE_BYTES, "simplify the mesh, or split it")
}

/// The file's own name, which is how a scene is called.
pub(super) fn name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

/// Refuses files of the formats that have no animations.
pub(super) fn check_moving(path: &Path, bytes: &[u8]) -> Result<()> {
    match format(path, bytes)? {
        Format::Gltf => Ok(()),
        Format::Obj | Format::Ply => {
            let remedy = "give a glTF file with an animation, or leave out --frames";
            Err(Place::file(path).error("OBJ and PLY files have no animations", remedy))
        }
    }
}

fn format(path: &Path, bytes: &[u8]) -> Result<Format> {
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes).trim_ascii_start();
    if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r\n") {
        return Ok(Format::Ply);
    }
    if bytes.starts_with(b"glTF") || text.starts_with(b"{") {
        return Ok(Format::Gltf);
    }
    match path.extension().and_then(OsStr::to_str).map(str::to_ascii_lowercase).as_deref() {
        Some("obj") => Ok(Format::Obj),
        Some("gltf") => Ok(Format::Gltf),
        Some("glb") => Err(Place::file(path).error("it is no GLB, which begins with `glTF`", "export the scene again")),
        Some("ply") => Ok(Format::Ply),
        _ => Err(Place::file(path).error("neither OBJ, glTF nor PLY", "export the mesh in one of these formats")),
    }
}

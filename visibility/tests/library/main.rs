//! Tests of the library through its public face: scenes, setups and outputs. Files are made in a folder of each test.

mod generators;
mod gltf;
mod meshes;
mod outputs;
mod setups;

use std::path::{Path, PathBuf};

use sightlines_visibility::scene::{Scene, load};
use sightlines_visibility::{Error, Result};

/// A folder that lasts as long as its test.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Folder(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }

    fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

fn load_bytes(name: &str, bytes: impl AsRef<[u8]>) -> Result<Scene> {
    load(&Folder::new().put(name, bytes))
}

/// The message of an error of the caller's making. It names the file and has a remedy.
fn refusal<T: std::fmt::Debug>(result: Result<T>, file: &str) -> String {
    let error = result.unwrap_err();
    assert!(error.is_bad_input(), "{error}");
    let message = error.to_string();
    let remedy = message.split_once("\n  remedy: ").map(|(_, remedy)| remedy);
    assert!(remedy.is_some_and(|remedy| remedy.len() > 5), "{message}");
    let (_, rest) = message.split_once(file).unwrap_or_else(|| panic!("`{file}` is not in: {message}"));
    format!("{file}{rest}")
}

#[test]
fn a_missing_file_is_named() {
    let message = refusal(load(Path::new("no/such/mesh.obj")), "no/such/mesh.obj");
    assert!(message.contains("cannot be read") && message.contains("check the path"), "{message}");
    assert!(matches!(load(Path::new("no/such/mesh.obj")), Err(Error::Read { .. })));
}

#[test]
fn a_folder_is_no_mesh() {
    let folder = Folder::new();
    let message = refusal(load(&folder.path("")), &folder.path("").display().to_string());
    assert!(message.contains("cannot be read"), "{message}");
}

#[test]
fn a_file_of_another_kind_is_refused() {
    let message = refusal(load_bytes("mesh.stl", "solid"), "mesh.stl");
    assert!(message.starts_with("mesh.stl: neither OBJ, glTF nor PLY"), "{message}");
    refusal(load_bytes("mesh", ""), "mesh");
}

#[cfg(unix)]
#[test]
fn a_file_of_absurd_size_is_refused_before_it_is_read() {
    let folder = Folder::new();
    let file = std::fs::File::create(folder.path("huge.obj")).unwrap();
    file.set_len(sightlines_visibility::scene::MAX_FILE_BYTES + 1).unwrap();
    let message = refusal(load(&folder.path("huge.obj")), "huge.obj");
    assert!(message.contains("2147483649 bytes"), "{message}");
}

//! Every loader of the crate by one door: a file of a kind, read and taken as far as a command takes it before the
//! work.
//!
//! A fuzz target shares this file. Invariant that it holds loaders to: whatever the bytes, there is no panic, and an
//! error is the caller's, with a file and a remedy.

use std::path::Path;

use sightlines_kernels::raster::Picture;
use sightlines_visibility::ambient::file::Stored;
use sightlines_visibility::ambient::{Environment, Surface};
use sightlines_visibility::queries::{Stage, files};
use sightlines_visibility::scene::frame::Frame;
use sightlines_visibility::scene::{Camera, Lens, Motion, World, load, load_world, read_text};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::{Error, Result, sets};

/// Kinds of files, by their extensions.
pub(crate) const KINDS: [&str; 11] = ["obj", "ply", "gltf", "glb", "hdr", "exr", "toml", "txt", "sets", "occl", "seen"];

/// Length of the digest that ends the files of the last three kinds.
const DIGEST: usize = blake3::OUT_LEN;

const UP: [f64; 3] = [0.0, 1.0, 0.0];

/// Puts bytes into `folder` as a file of a kind, and reads it.
pub(crate) fn check(folder: &Path, kind: &str, bytes: &[u8]) {
    let path = folder.join("a").with_extension(kind);
    // A file made anew need not wait for the disk, as one cut to nothing must.
    let _ = std::fs::remove_file(&path);
    std::fs::write(&path, bytes).unwrap();
    let Err(error) = read(kind, &path) else { return };
    let message = error.to_string();
    let placed = match &error {
        Error::Read { .. } => true,
        Error::Input { place, .. } => place.file.is_some(),
        _ => false,
    };
    assert!(error.is_bad_input() && placed, "no file: {message}");
    assert!(message.contains("\n  remedy: ") && message.len() < 2000, "{message}");
}

/// The digest of what stands before it, put right: what loaders check behind it is then reached.
pub(crate) fn mend_digest(bytes: &mut [u8]) {
    if let Some((body, digest)) = bytes.len().checked_sub(DIGEST).map(|at| bytes.split_at_mut(at)) {
        digest.copy_from_slice(blake3::hash(body).as_bytes());
    }
}

/// Reads a file of a kind, and prepares what is in it.
pub(crate) fn read(kind: &str, path: &Path) -> Result<()> {
    match kind {
        "hdr" | "exr" => drop(Environment::load(path)?.mean()),
        "toml" => drop(Setup::load(path, &Settings::default())?.request()),
        "txt" => cameras(path)?,
        "sets" => drop(sets::read(path)?),
        "occl" => drop(Stored::read(path)?),
        "seen" => drop(files::read_seen(path)?),
        _ => {
            // Either may refuse what the other takes: a mesh too far from the origin, a camera without extent.
            let (scene, world) = (load(path), load_world(path));
            prepare(&world?);
            if ["gltf", "glb"].contains(&kind) {
                let motion = Motion::load(path)?;
                motion.at(0.5 * motion.duration())?;
            }
            let scene = scene?;
            Surface::new(&scene)?;
            Setup::new(scene, &Settings::default())?;
        }
    }
    Ok(())
}

/// Frames of every camera and of one before the scene. Where a camera does not fit the scene, no file is to blame.
fn prepare(world: &World) {
    let corners = world.corners();
    let [eye, target] = [[3.0, 4.0, 5.0], corners[0][0]];
    let before = Camera::look_at("before", eye, target, UP, Lens::Orthographic { height: 2.0 });
    for camera in world.cameras.iter().chain(before.as_ref().ok()) {
        let frame = Frame::new(camera, Picture { width: 640, height: 480 }, corners.as_flattened());
        let stage = frame.and_then(|frame| Stage::of(world, frame));
        assert!(stage.as_ref().err().is_none_or(Error::is_bad_input), "{camera:?}: {:?}", stage.err());
    }
}

fn cameras(path: &Path) -> Result<()> {
    for words in read_text(path)?.lines() {
        let parsed = Camera::parse(words, UP);
        assert!(parsed.as_ref().err().is_none_or(Error::is_bad_input), "{words}: {:?}", parsed.err());
    }
    Ok(())
}

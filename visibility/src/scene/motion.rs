//! Scenes that move: generated ones, and the animations of glTF files.
//!
//! Invariant: a scene at a time has the parts, vertices and triangles of every other time, only positions and normals
//! differ; and it is the same bits on every host.

use std::path::Path;

use super::gltf::Animated;
use super::{Scene, generate, load};
use crate::error::Result;

/// A scene that moves.
#[derive(Clone, Debug)]
pub enum Motion {
    /// A skeleton of 8,316 vertices that walks on the spot.
    Skeleton,
    /// A cloth of 3,249 vertices that waves.
    Cloth,
    /// The first animation of a glTF file.
    Gltf(Box<Animated>),
}

impl Motion {
    /// A generated motion by name.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "skeleton" => Some(Motion::Skeleton),
            "cloth" => Some(Motion::Cloth),
            _ => None,
        }
    }

    /// The first animation of a glTF file: of nodes and of skins.
    ///
    /// # Errors
    ///
    /// A file that [`load`](super::load()) refuses, that is no glTF, or that has no animation of nodes, or a broken
    /// one.
    pub fn load(path: &Path) -> Result<Self> {
        let bytes = load::read(path)?;
        load::check_moving(path, &bytes)?;
        Ok(Motion::Gltf(Box::new(Animated::read(path, &bytes)?)))
    }

    /// How long it takes, in seconds; generated ones repeat after it.
    pub fn duration(&self) -> f64 {
        match self {
            Motion::Skeleton | Motion::Cloth => 1.0,
            Motion::Gltf(animated) => animated.duration(),
        }
    }

    /// The scene at a time in seconds.
    ///
    /// # Errors
    ///
    /// A pose whose coordinates are not finite or far out.
    pub fn at(&self, time: f64) -> Result<Scene> {
        match self {
            Motion::Skeleton => Ok(generate::skeleton(time)),
            Motion::Cloth => Ok(generate::cloth(time)),
            Motion::Gltf(animated) => animated.at(time),
        }
    }
}

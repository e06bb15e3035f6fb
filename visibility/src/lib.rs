//! Visibility systems composed of compute kernels: who sees whom, how much, and which rays.
//!
//! | module | what |
//! |---|---|
//! | [`scene`] | meshes from OBJ, glTF and PLY files, and generated ones |
//! | [`setup`] | where light and receiver stand: defaults, and scene files |
//! | [`ambient`] | ambient occlusion and light from an environment, at vertices |
//! | [`shadows`] | soft shadows of area lights: hidden-sample sets |
//! | [`compare`] | other methods for the same soft shadow, in the same run |
//! | [`plot`] | curves of such runs as SVG |
//! | [`simplify`] | coarser meshes for large lights, with the feature of that name |
//! | [`queries`] | granular visibility queries: pixels seen of every instance, in every tile |
//! | [`image`] | the visible share as PNG and EXR |
//! | [`sets`] | the sets in a file |
//! | [`input`], [`output`] | the doors by which files are read and written |
//!
//! Systems are generic over [`Backend`](sightlines_backend::Backend) and have no path of their own on the CPU. What
//! reaches an output is computed in integers, or in f64 with + − × ÷ √ and `libm`: the same bits on every host.
//!
//! The program `sightlines` is this crate's `main.rs`, behind the feature `cli` (on by default); the library needs
//! neither a backend nor a command line.

pub mod ambient;
pub mod compare;
pub mod error;
pub mod image;
pub mod input;
pub mod output;
pub mod plot;
pub mod queries;
pub mod scene;
pub mod sets;
pub mod setup;
pub mod shadows;
pub mod simplify;
mod vector;

pub use error::{Error, Result};

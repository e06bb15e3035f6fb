//! The machines that every test runs on: the reference, and the interpreter at each setting that must not show.

use sightlines_backend::Backend;

#[path = "../reference/mod.rs"]
mod reference;

pub use reference::Reference;

/// A named machine.
pub struct Engine {
    pub name: String,
    pub backend: Box<dyn Backend>,
    /// Whether an access out of bounds stops it.
    pub traps: bool,
}

/// The reference and the interpreter at its settings.
pub fn engines() -> Vec<Engine> {
    vec![Engine { name: "reference".into(), backend: Box::new(Reference), traps: false }]
}

//! The oracle of the interpreter: a scalar evaluator of naga IR, written plainly from the IR's definition.
//!
//! It walks trees, one invocation at a time, and shares with the interpreter only the scalar functions of
//! `sightlines_backend_cpu::math`. An invocation is a future: a barrier is where it returns `Pending`, so a workgroup
//! runs barrier by barrier with the invocations in index order, on one thread, always the same way.
//!
//! Invariant: for a program without races its outputs are what WGSL defines, with out-of-range indices clamped to the
//! last element.

mod builtin;
mod dispatch;
mod expression;
mod invocation;
mod memory;
mod session;
mod value;

pub use session::Reference;

use sightlines_backend::{ErrorKind, Result};

fn unsupported<T>(feature: impl Into<String>) -> Result<T> {
    let remedy = "run it on another backend".to_owned();
    Err(ErrorKind::Unsupported { backend: "reference", feature: feature.into(), location: None, remedy }.into())
}

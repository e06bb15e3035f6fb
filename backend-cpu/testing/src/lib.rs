//! What the tests and the fuzz targets of the interpreter share.
//!
//! * [`generate`]: random WGSL programs that are valid, end and have no race, from bytes or from a seed.
//! * [`reference`]: a scalar evaluator of naga IR, written apart from the interpreter, as its oracle.
//! * [`operators`]: operators and builtin functions as files of run lines.
//! * [`script`]: programs as files that say what to run and what must come out.
//! * [`engines`]: the machines that every test runs on.
//! * [`differential`]: one program on all machines, and what to do with one that differs.
//! * [`fuzz`]: the fuzz targets' work, as functions of bytes.
//!
//! Invariant: nothing here is part of the product. The interpreter does not know this crate; its tests do.

pub mod differential;
pub mod engines;
pub mod fuzz;
pub mod generate;
pub mod operators;
pub mod reference;
pub mod script;

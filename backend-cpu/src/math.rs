//! The scalar arithmetic of WGSL, pinned once: what every operation gives, on every host.
//!
//! WGSL leaves much of f32 open: rounding, fusion, subnormals, transcendentals within an error bound, everything about
//! NaN. The interpreter closes each of these with one choice and this module is the one place that states them. The
//! lane-parallel code may compute the same values another way, never other values; the tests hold it to these
//! functions.
//!
//! The choices:
//!
//! * `+ − × ÷ √` are IEEE 754 binary32, rounded to nearest even, in source order, unfused, subnormals kept. They need
//!   no function here: Rust's operators are exactly that.
//! * What WGSL defines by a formula (`fract`, `mix`, `smoothstep`, `degrees` …) is that formula, operation by
//!   operation.
//! * Transcendentals are the `libm` crate's binary64 functions, rounded once to binary32. `libm` is pure Rust over
//!   exact operations, so they do not depend on the host. Their error is below 0.51 ULP of the f32 result.
//! * A NaN *made by a function of this module from a call into `libm`* is [`NAN`]. The payload and sign of a NaN made
//!   by a basic operation are the host's, as in IEEE 754: no result should depend on them.
//! * Integers wrap; division, shifts and conversions are total, as WGSL says.
//!
//! Invariant: every function is pure and total. No input panics.

mod float;
mod integer;
mod pack;
mod vector;

pub use float::*;
pub use integer::*;
pub use pack::*;
pub use vector::*;

//! The exact functions by definition: wide integers, and IEEE arithmetic where that is the definition.
//!
//! Nothing here is made from the WGSL. Domains are those of the functions in `shared/`.

pub mod angle;
pub mod divide;
pub mod float;
pub mod line;
pub mod plane;
pub mod wide;

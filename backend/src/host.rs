//! Rust structs whose bytes are WGSL bytes, checked against naga's `Layouter`.

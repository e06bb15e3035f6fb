//! `cargo xtask bench`: the program of the `benches` crate, in the one profile.

use crate::run::{cargo, finish};

/// Builds and runs the benchmark program with the arguments as they are; file names stay relative to the current
/// folder.
pub(crate) fn run(args: &[String]) -> u8 {
    let mut cargo = cargo("run");
    cargo.args(["--quiet", "--release", "--package", "sightlines-benches", "--bin", "sightlines-bench", "--"]);
    finish(cargo.args(args).status())
}

//! Arguments that change what a bake takes, and no bit of it.

use clap::{Args, ValueEnum};
use sightlines_visibility::shadows::{Effort, MEMORY};

/// How to bake.
#[derive(Args, Debug)]
pub(crate) struct EffortArgs {
    /// Leave out faces of closed surfaces that face all of the light: the back faces hide the same. Surfaces that are
    /// not closed stay whole.
    #[arg(long, value_enum, value_name = "auto|off", default_value = "auto")]
    cull: Cull,
    /// MiB for lists of triangles at a time; more are taken in turns.
    #[arg(long, value_name = "MIB", default_value_t = MEMORY >> 20, value_parser = clap::value_parser!(u64).range(1..=128))]
    memory: u64,
}

/// Whether to cull.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Cull {
    /// Where surfaces are found to be closed.
    Auto,
    /// Never.
    Off,
}

impl EffortArgs {
    /// As a bake takes it.
    pub(crate) fn effort(&self) -> Effort {
        Effort { cull: self.cull == Cull::Auto, memory: self.memory << 20 }
    }
}

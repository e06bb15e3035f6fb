//! What the program does beside the library: its command line, the choice of a machine, progress and reports.

pub(crate) mod ambient;
pub(crate) mod cli;
mod machine;
mod progress;
pub(crate) mod queries;
pub(crate) mod shadows;
mod targets;

use std::io;

/// Why the program stops.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// A scene, a setting, a file, or the machine.
    #[error("{0}")]
    Work(#[from] sightlines_visibility::Error),
    /// The report could not be written.
    #[error("standard output: {0}")]
    Output(#[from] io::Error),
}

impl From<sightlines_backend::Error> for Failure {
    fn from(error: sightlines_backend::Error) -> Self {
        Failure::Work(error.into())
    }
}

impl Failure {
    /// The exit code that the help of the command line states.
    pub(crate) fn exit_code(&self) -> u8 {
        match self {
            Failure::Work(error) if error.is_missing_backend() => 3,
            Failure::Work(error) if error.is_bad_input() => 2,
            Failure::Work(_) | Failure::Output(_) => 1,
        }
    }

    /// Whether whoever reads the report has stopped reading.
    pub(crate) fn is_closed_pipe(&self) -> bool {
        matches!(self, Failure::Output(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }
}

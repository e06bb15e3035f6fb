//! What the program does beside the library: its command line, the choice of a machine, progress and reports.

pub(crate) mod ambient;
pub(crate) mod cli;
pub(crate) mod compare;
pub(crate) mod cull;
mod effort;
mod machine;
mod progress;
pub(crate) mod queries;
pub(crate) mod shadows;
mod targets;

use std::io::{self, Write};

/// Why the program stops.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// A scene, a setting, a file, or the machine.
    #[error("{0}")]
    Work(#[from] sightlines_visibility::Error),
    /// Two methods that must agree do not.
    #[error("the methods differ in {0} bits, and should in none\n  remedy: report it, with the scene and the machine")]
    Differ(u64),
    /// Culling changed a picture that it must not change.
    #[error(
        "{0} words of a picture change without what was culled, and should not\n  remedy: report it, with the scene and the machine"
    )]
    Lost(u64),
    /// The report could not be written.
    #[error("standard output: {0}\n  remedy: name another place for the report; files named under `wrote` are whole")]
    Output(#[from] io::Error),
}

/// Standard output for the report. Where nobody reads it any more, the work goes on: its results are files.
pub(crate) struct Report(io::StdoutLock<'static>);

impl Report {
    pub(crate) fn new() -> Self {
        Report(io::stdout().lock())
    }
}

impl Write for Report {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        unless_closed(self.0.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        unless_closed(self.0.flush(), ())
    }
}

fn unless_closed<T>(done: io::Result<T>, otherwise: T) -> io::Result<T> {
    match done {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(otherwise),
        done => done,
    }
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
            Failure::Work(_) | Failure::Differ(_) | Failure::Lost(_) | Failure::Output(_) => 1,
        }
    }
}

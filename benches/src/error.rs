//! Why a benchmark run could not do what it was asked, and the exit code that says so.
//!
//! A subject that fails on one engine is no error of the run: it is reported, the rest is measured, and the exit
//! code is [`EXIT_FAILED`].

use std::path::{Path, PathBuf};

/// Everything was measured.
pub const EXIT_OK: u8 = 0;
/// A subject failed on an engine, engines gave different bits, or a file could not be written.
pub const EXIT_FAILED: u8 = 1;
/// The command line is wrong.
pub const EXIT_USAGE: u8 = 2;
/// A required adapter or SIMD level is missing.
pub const EXIT_MISSING: u8 = 3;
/// The filter selects nothing.
pub const EXIT_NOTHING: u8 = 4;

/// An error of a run.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The command line, or a file named on it, is wrong.
    #[error("{0}")]
    Usage(String),
    /// A required adapter or SIMD level is missing.
    #[error("{0}")]
    Missing(String),
    /// The filter selects nothing.
    #[error("no benchmark matches `{0}`\n  remedy: `--list` shows all ids")]
    Nothing(String),
    /// A file could not be read or written.
    #[error("{}: {source}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// Standard output could not be written.
    #[error("standard output: {0}")]
    Output(#[from] std::io::Error),
    /// A child process could not be started, died or did not answer.
    #[error("worker process: {0}")]
    Worker(String),
    /// Criterion left no estimate, or a micro-kernel gave a wrong answer.
    #[error("{0}")]
    Measurement(String),
    /// A program or job was refused, or failed.
    #[error("{0}")]
    Backend(#[from] sightlines_backend::Error),
}

/// A `Result` with the run's error.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// The process exit code of this error.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Usage(_) => EXIT_USAGE,
            Error::Missing(_) => EXIT_MISSING,
            Error::Nothing(_) => EXIT_NOTHING,
            Error::File { .. } | Error::Output(_) | Error::Worker(_) | Error::Measurement(_) | Error::Backend(_) => {
                EXIT_FAILED
            }
        }
    }

    pub(crate) fn file(path: &Path, source: std::io::Error) -> Self {
        Error::File { path: path.to_owned(), source }
    }
}

//! Why the suite could not do what it was asked, and the exit code that says so.
//!
//! A failing case is not an error: it is a result. Errors are what stands in the way of results.

use std::path::{Path, PathBuf};

/// Every result as expected.
pub const EXIT_OK: u8 = 0;
/// A case failed, passed unexpectedly, trapped or ran out of time, or the report could not be written.
pub const EXIT_FAILED: u8 = 1;
/// The command line or a file named on it is wrong.
pub const EXIT_USAGE: u8 = 2;
/// A required backend or adapter is missing.
pub const EXIT_MISSING: u8 = 3;
/// No case was selected.
pub const EXIT_NOTHING: u8 = 4;

/// An error of the suite.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The command line, or a file named on it, is wrong.
    #[error("{0}")]
    Usage(String),
    /// A required backend or adapter is missing.
    #[error("{0}")]
    Missing(String),
    /// No case is left after selection.
    #[error("no case is selected: {0}")]
    Nothing(String),
    /// A file that was named on the command line could not be read.
    #[error("{}: {source}", .path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// A result could not be written.
    #[error("{}: {source}", .path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
    /// Standard output could not be written.
    #[error("standard output: {0}")]
    Output(#[from] std::io::Error),
    /// A worker process could not be started or did not answer.
    #[error("worker process: {0}")]
    Worker(String),
    /// A program or job was refused.
    #[error("{0}")]
    Backend(#[from] sightlines_backend::Error),
}

/// A `Result` with the suite's error.
pub type Result<T, E = Error> = std::result::Result<T, E>;

impl Error {
    /// The process exit code of this error.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Usage(_) | Error::Read { .. } | Error::Backend(_) => EXIT_USAGE,
            Error::Missing(_) => EXIT_MISSING,
            Error::Nothing(_) => EXIT_NOTHING,
            Error::Write { .. } | Error::Output(_) | Error::Worker(_) => EXIT_FAILED,
        }
    }

    pub(crate) fn read(path: &Path, source: std::io::Error) -> Self {
        Error::Read { path: path.to_owned(), source }
    }

    pub(crate) fn write(path: &Path, source: std::io::Error) -> Self {
        Error::Write { path: path.to_owned(), source }
    }
}

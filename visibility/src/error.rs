//! What can go wrong, told so that it can be mended: the file, the place in it, and a remedy.
//!
//! Whose fault it is decides the exit code of the program: [`Error::Read`], [`Error::Input`] and work that no device
//! would take are the caller's, a [`Error::Backend`] without an adapter is the machine's, and the rest are failures of
//! the work itself.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use sightlines_backend::{DeviceError, ErrorKind};

/// An error of scenes, settings, outputs or the machine that bakes.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file that could not be read.
    #[error("{}: cannot be read: {source}\n  remedy: {}", .path.display(), read_remedy(.source))]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// A file that could not be written. Nothing of it is left behind.
    #[error("{}: cannot be written: {source}\n  remedy: {}", .path.display(), write_remedy(.source))]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// A scene, a setting or a file that makes no sense.
    #[error("{place}{what}\n  remedy: {remedy}")]
    Input {
        /// Where it stands.
        place: Place,
        /// What is wrong, with the numbers.
        what: String,
        /// What the caller can do.
        remedy: String,
    },
    /// A backend refused or failed.
    #[error("{0}")]
    Backend(#[from] sightlines_backend::Error),
}

/// A `Result` with this crate's error.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Where bad input stands: nowhere in particular (a command line), in a file, on a line of it, or in a named element.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub file: Option<PathBuf>,
    /// Line, from 1.
    pub line: Option<usize>,
    /// A mesh, node, vertex, face or key of it.
    pub element: Option<String>,
}

impl Place {
    /// A file as a whole.
    pub fn file(path: &Path) -> Self {
        Place { file: Some(path.to_owned()), ..Place::default() }
    }

    /// A line of a file.
    pub fn line(path: &Path, line: usize) -> Self {
        Place { line: Some(line), ..Place::file(path) }
    }

    /// The same place, closer: an element of it.
    #[must_use]
    pub fn element(mut self, element: impl Into<String>) -> Self {
        self.element = Some(plain(&element.into()));
        self
    }

    /// The error that stands here.
    pub fn error(self, what: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::Input { place: self, what: plain(&what.into()), remedy: remedy.into() }
    }
}

/// Most characters of an element's name, and of what is wrong with it.
const MOST: usize = 400;

/// One line of bounded length that no terminal obeys: names and excerpts of files may hold anything.
fn plain(text: &str) -> String {
    let shown = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
    let rest = if text.chars().nth(MOST).is_some() { "…" } else { "" };
    text.chars().take(MOST).map(shown).chain(rest.chars()).collect()
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(file) = &self.file {
            write!(f, "{}:", file.display())?;
            if let Some(line) = self.line {
                write!(f, "{line}:")?;
            }
            f.write_str(" ")?;
        }
        self.element.as_ref().map_or(Ok(()), |element| write!(f, "{element}: "))
    }
}

fn read_remedy(source: &io::Error) -> &'static str {
    match source.kind() {
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory | io::ErrorKind::InvalidFilename => "check the path",
        io::ErrorKind::PermissionDenied => "change the file's permissions, or copy it",
        io::ErrorKind::IsADirectory => "name a file, not a folder",
        io::ErrorKind::InvalidData => "save the file as UTF-8 text",
        _ => "check the file and its disk",
    }
}

fn write_remedy(source: &io::Error) -> &'static str {
    match source.kind() {
        io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => "make its folder, or name a file in another one",
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "change the permissions, or name a file in another folder"
        }
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded | io::ErrorKind::FileTooLarge => {
            "make room, or name a file on another disk"
        }
        io::ErrorKind::IsADirectory | io::ErrorKind::InvalidInput | io::ErrorKind::InvalidFilename => "name a file",
        _ => "name a file in another folder, or on another disk",
    }
}

impl Error {
    /// Whether no adapter could be had.
    pub fn is_missing_backend(&self) -> bool {
        matches!(self, Error::Backend(e) if matches!(e.kind(), ErrorKind::Device(DeviceError::NoAdapter { .. })))
    }

    /// Whether the caller gave something that makes no sense.
    pub fn is_bad_input(&self) -> bool {
        match self {
            Error::Read { .. } | Error::Input { .. } => true,
            Error::Backend(e) => matches!(e.kind(), ErrorKind::Refused { .. }),
            Error::Write { .. } => false,
        }
    }

    /// The same error of bad input, in a file and line that its maker did not know.
    #[must_use]
    pub fn at(self, outer: Place) -> Self {
        match self {
            Error::Input { place: Place { file: None, element, .. }, what, remedy } => {
                Error::Input { place: Place { element, ..outer }, what, remedy }
            }
            other => other,
        }
    }

    pub(crate) fn read(path: &Path, source: io::Error) -> Self {
        Error::Read { path: path.to_owned(), source }
    }

    pub(crate) fn write(path: &Path, source: io::Error) -> Self {
        Error::Write { path: path.to_owned(), source }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_reads_from_the_file_inwards() {
        let path = Path::new("a.obj");
        assert_eq!(Place::default().to_string(), "");
        assert_eq!(Place::file(path).to_string(), "a.obj: ");
        assert_eq!(Place::line(path, 3).to_string(), "a.obj:3: ");
        assert_eq!(Place::file(path).element("vertex 7").to_string(), "a.obj: vertex 7: ");
        assert_eq!(Place::line(path, 3).error("no", "yes").to_string(), "a.obj:3: no\n  remedy: yes");
    }

    #[test]
    fn what_a_file_says_neither_floods_a_terminal_nor_commands_it() {
        let message = Place::default().element("a\x1b[2J\nb").error("x".repeat(5000), "mend it").to_string();
        assert_eq!(message, format!("a\u{fffd}[2J\u{fffd}b: {}…\n  remedy: mend it", "x".repeat(400)));
    }

    #[test]
    fn a_missing_adapter_is_told_from_other_failures() {
        let adapter = DeviceError::NoAdapter { wanted: None, reason: "none".into() };
        assert!(Error::from(sightlines_backend::Error::from(adapter)).is_missing_backend());
        let lost = Error::from(sightlines_backend::Error::from(DeviceError::Lost("gone".into())));
        assert!(!lost.is_missing_backend() && !lost.is_bad_input());
        let large = sightlines_backend::Error::refused("too large", "make it smaller");
        assert!(Error::from(large).is_bad_input());
    }
}

//! Typed errors of the whole workspace.
//!
//! One opaque, boxed [`Error`] keeps results small; [`ErrorKind`] says what went wrong. Whatever speaks of WGSL carries
//! the author's file, line and column, never a position in linked text.

use std::fmt;

/// An error of a program, a recording or a machine.
#[derive(Debug)]
pub struct Error {
    kind: Box<ErrorKind>,
}

/// A place in an author's WGSL file; lines and columns count from 1.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Location {
    /// Path of the file as it was given to the linker.
    pub file: String,
    /// Line, from 1.
    pub line: u32,
    /// Column in bytes, from 1.
    pub column: u32,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// What went wrong.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ErrorKind {
    /// WGSL that does not link, parse, validate or pass the lints; the text is rendered with source lines.
    #[error("{rendered}")]
    Wgsl {
        /// Which stage refused: `link`, `parse`, `validate` or `lint`.
        stage: &'static str,
        /// First place the message speaks of.
        location: Option<Location>,
        /// The whole message, in the form that naga gives its own.
        rendered: String,
    },
    /// A Rust struct or binding that does not match its WGSL declaration.
    #[error("layout of `{name}` differs from the WGSL: {detail}")]
    Layout {
        /// The struct or binding.
        name: String,
        /// What differs, with both offsets or sizes.
        detail: String,
    },
    /// Work that a device would refuse.
    #[error("refused: {what}\n  remedy: {remedy}")]
    Refused {
        /// The rule that was broken, with the numbers.
        what: String,
        /// What the caller can do.
        remedy: String,
    },
    /// WGSL that is valid but that this backend does not run.
    #[error("{}{feature} is not supported by the {backend} backend\n  remedy: {remedy}", at(.location))]
    Unsupported {
        /// Name of the backend.
        backend: &'static str,
        /// The construct.
        feature: String,
        /// Where it stands.
        location: Option<Location>,
        /// What the author can do.
        remedy: String,
    },
    /// A program that is valid, and larger than a limit that the caller can set.
    #[error("{}{what}, the limit is {limit}\n  remedy: {remedy}", at(.location))]
    Limit {
        /// What exceeds the limit.
        what: String,
        /// The limit.
        limit: u64,
        /// Where the program exceeds it.
        location: Option<Location>,
        /// What the author can do, and the argument that raises the limit.
        remedy: String,
    },
    /// A run that WGSL calls a dynamic error, stopped at its source line.
    #[error("{0}")]
    Trap(Trap),
    /// The device or its driver failed.
    #[error("{0}")]
    Device(#[from] DeviceError),
    /// Bytes that are not a job, or a job of another version.
    #[error("not a job file of this version: {0}")]
    Format(String),
    /// A file that could not be read or written.
    #[error("{path}: {source}")]
    Io {
        /// The file.
        path: String,
        /// The system's reason.
        source: std::io::Error,
    },
}

fn at(location: &Option<Location>) -> String {
    location.as_ref().map_or_else(String::new, |l| format!("{l}: "))
}

/// A dynamic error of a running kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trap {
    /// What happened.
    pub kind: TrapKind,
    /// The source line that did it.
    pub location: Option<Location>,
    /// Global invocation id of the first lane that did it, where one lane did.
    pub invocation: Option<[u32; 3]>,
}

/// Kinds of [`Trap`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TrapKind {
    /// An access past the end of an array, vector, matrix or buffer.
    OutOfBounds {
        /// The index used.
        index: u32,
        /// Number of elements.
        length: u32,
    },
    /// The run used up its fuel: a loop that does not end, or more work than the limit allows.
    OutOfFuel {
        /// Back-edges that were allowed for one gang of invocations.
        limit: u64,
    },
    /// A barrier in control flow that not all invocations of the workgroup took.
    NonUniformBarrier,
    /// More memory than the limit allows.
    OutOfMemory {
        /// Bytes wanted.
        wanted: u64,
        /// Bytes allowed.
        limit: u64,
    },
}

impl fmt::Display for Trap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&at(&self.location))?;
        match &self.kind {
            TrapKind::OutOfBounds { index, length } => {
                write!(f, "index {index} is out of bounds of length {length}")?;
            }
            TrapKind::OutOfFuel { limit } => {
                write!(f, "no end after {limit} loop iterations of one gang; bound the loop or raise the fuel")?;
            }
            TrapKind::NonUniformBarrier => f.write_str("barrier in control flow that is not uniform")?,
            TrapKind::OutOfMemory { wanted, limit } => {
                write!(f, "{wanted} bytes of memory are wanted, {limit} are allowed")?;
            }
        }
        if let Some([x, y, z]) = self.invocation {
            write!(f, " (invocation {x}, {y}, {z})")?;
        }
        Ok(())
    }
}

/// Failures of a device or its driver.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DeviceError {
    /// No adapter of the wanted name or kind.
    #[error("no adapter{}: {reason}", .wanted.as_ref().map_or_else(String::new, |w| format!(" matching `{w}`")))]
    NoAdapter {
        /// The name asked for.
        wanted: Option<String>,
        /// What was found instead, and how to install a device.
        reason: String,
    },
    /// The device was lost while it worked.
    #[error("device lost: {0}")]
    Lost(String),
    /// The device has no memory left.
    #[error("out of device memory: {0}")]
    OutOfMemory(String),
    /// The driver could not compile a pipeline.
    #[error("the driver could not compile `{entry}`: {reason}")]
    Compile {
        /// Entry point.
        entry: String,
        /// The driver's words.
        reason: String,
    },
    /// A validation error of the device: a rule that [`crate::check`] should have caught.
    #[error("the device refused the work: {0}")]
    Validation(String),
    /// The work did not end within the limit.
    #[error("the device did not finish within {seconds} s")]
    Timeout {
        /// The limit.
        seconds: u64,
    },
}

impl Error {
    /// What went wrong.
    pub fn kind(&self) -> &ErrorKind {
        &self.kind
    }

    /// A refusal with its remedy.
    pub fn refused(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        ErrorKind::Refused { what: what.into(), remedy: remedy.into() }.into()
    }
}

impl<K: Into<ErrorKind>> From<K> for Error {
    fn from(kind: K) -> Self {
        Error { kind: Box::new(kind.into()) }
    }
}

impl From<Trap> for ErrorKind {
    fn from(trap: Trap) -> Self {
        ErrorKind::Trap(trap)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.kind.fmt(f)
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        std::error::Error::source(&*self.kind)
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn an_error_is_one_pointer() {
        assert_eq!(size_of::<super::Error>(), size_of::<usize>());
    }
}

//! The contract between compute kernels and the machines that run them.
//!
//! A kernel is written once, in WGSL. This crate turns it into a [`Program`] (linked, parsed, validated, linted and
//! reflected exactly once) and describes work as plain data: a [`Job`] of buffers, programs, [`Recording`]s and the
//! ranges to read back. A [`Backend`] runs jobs. Nothing here knows a GPU or an interpreter.
//!
//! Invariants that everything above relies on:
//!
//! * every backend receives the *same* [`naga::Module`], so two machines cannot disagree about what the text says;
//! * a job is owned, serialisable data: the file that dumps a failure is the file that replays it;
//! * what one device would refuse, [`check`] refuses for all of them, before any of them runs.

pub mod backend;
pub mod check;
pub mod error;
mod front;
pub mod host;
pub mod kernel;
pub mod link;
pub mod lint;
pub mod program;
pub mod recording;
mod text;

pub use backend::{Backend, BackendInfo, Counts, Outputs, Session};
pub use error::{DeviceError, Error, ErrorKind, Location, Trap, TrapKind};
pub use front::CompileLimits;
pub use kernel::{Case, Expected, Kernel, Size};
pub use link::{Define, File, Linked, Sources};
pub use program::{Access, Binding, Entry, Opaque, Program, Specialised};
pub use recording::{
    BufferDesc, BufferId, Command, Dispatch, Groups, Job, ProgramId, RECORD_MARK, Read, Recording, Slot,
};

/// Version of the numerics contract. It is printed in every snapshot and changes whenever an output bit may change.
pub const CONTRACT_VERSION: u32 = 1;

/// A `Result` whose error is the contract's [`Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

//! What passes between the suite and the processes that run kernels.
//!
//! A worker writes [`Reply::Ready`] when its machine is open, then one [`Reply::Ran`] or [`Reply::Failed`] for each
//! job file that it reads. A frame is its length (u64, little endian) and that many bytes. Whatever ends a worker
//! before its reply is the failure of one case and of nothing else.

use std::fmt;
use std::io::{self, Read, Write};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_bytes::ByteBuf;
use sightlines_backend::{BackendInfo, Counts, DeviceError, Error, ErrorKind};

/// Who ran the work, as it crosses a process boundary and as reports show it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    /// `cpu` or `wgpu`.
    pub backend: String,
    /// The adapter's own name, or the interpreter's SIMD level.
    pub adapter: String,
    /// Driver name and version, where there is one.
    pub driver: String,
    /// Threads that run kernels, where the backend knows.
    pub threads: Option<usize>,
}

impl From<BackendInfo> for Identity {
    fn from(info: BackendInfo) -> Self {
        let BackendInfo { backend, adapter, driver, threads } = info;
        Identity { backend: backend.to_owned(), adapter, driver, threads }
    }
}

impl Identity {
    /// Whether both are the same device with the same driver; threads may differ.
    pub fn same_device(&self, other: &Identity) -> bool {
        (&self.backend, &self.adapter, &self.driver) == (&other.backend, &other.adapter, &other.driver)
    }
}

impl fmt::Display for Identity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on {}", self.backend, self.adapter)?;
        if !self.driver.is_empty() {
            write!(f, ", {}", self.driver)?;
        }
        Ok(())
    }
}

/// Semantic costs of a run: [`Counts`] as they cross a process boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Costs {
    /// Invocations launched.
    pub invocations: u64,
    /// Loads from storage, uniform and workgroup memory.
    pub loads: u64,
    /// Stores to storage and workgroup memory.
    pub stores: u64,
    /// Bytes that loads, stores and atomics touch.
    pub bytes: u64,
    /// Atomic operations.
    pub atomics: u64,
    /// Barriers passed, one for each workgroup.
    pub barriers: u64,
    /// Turns of loops of the invocation that has most of them.
    pub turns: u64,
}

impl From<Counts> for Costs {
    fn from(counts: Counts) -> Self {
        let Counts { invocations, loads, stores, bytes, atomics, barriers, turns } = counts;
        Costs { invocations, loads, stores, bytes, atomics, barriers, turns }
    }
}

/// One run of a job on one machine in one setting.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Pass {
    /// The setting: `1 thread`, `all threads`; empty for machines that have one.
    pub setting: String,
    /// Who really ran it.
    pub identity: Identity,
    /// One entry for each read of the job.
    pub outputs: Vec<ByteBuf>,
    /// Semantic costs, from machines that count.
    pub costs: Option<Costs>,
    /// Time of the run in the worker, without transport.
    pub nanos: u64,
}

/// Why a job gave no outputs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// What kind of failure.
    pub kind: FailureKind,
    /// The message for people.
    pub message: String,
}

/// Kinds of [`Failure`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FailureKind {
    /// A dynamic error of the kernel: out of bounds, out of fuel, a barrier in non-uniform flow.
    Trap,
    /// The work did not end in time.
    Timeout,
    /// The process died.
    Crash,
    /// Anything else: a program or job that was refused, a device that failed.
    Error,
}

impl Failure {
    /// A failure of a kind.
    pub fn new(kind: FailureKind, message: impl Into<String>) -> Self {
        Failure { kind, message: message.into() }
    }
}

impl From<&Error> for Failure {
    fn from(error: &Error) -> Self {
        let kind = match error.kind() {
            ErrorKind::Trap(_) => FailureKind::Trap,
            ErrorKind::Device(DeviceError::Timeout { .. }) => FailureKind::Timeout,
            _ => FailureKind::Error,
        };
        Failure::new(kind, error.to_string())
    }
}

/// A worker's message.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Reply {
    /// The machine is open.
    Ready,
    /// The passes of a job.
    Ran(Vec<Pass>),
    /// The job, or the opening of the machine, failed.
    Failed(Failure),
}

/// Writes one frame of raw bytes.
pub fn write_frame(out: &mut impl Write, bytes: &[u8]) -> io::Result<()> {
    out.write_all(&(bytes.len() as u64).to_le_bytes())?;
    out.write_all(bytes)?;
    out.flush()
}

/// Reads one frame; `None` when the other side has closed the stream between frames.
pub fn read_frame(input: &mut impl Read) -> io::Result<Option<Vec<u8>>> {
    let mut length = [0; 8];
    if input.read(&mut length[..1])? == 0 {
        return Ok(None);
    }
    input.read_exact(&mut length[1..])?;
    let length = u64::from_le_bytes(length);
    let mut bytes = Vec::new();
    if input.take(length).read_to_end(&mut bytes)? as u64 != length {
        return Err(io::ErrorKind::UnexpectedEof.into());
    }
    Ok(Some(bytes))
}

/// Writes one message.
pub fn send<T: Serialize>(out: &mut impl Write, message: &T) -> io::Result<()> {
    let mut bytes = Vec::new();
    ciborium::into_writer(message, &mut bytes).map_err(io::Error::other)?;
    write_frame(out, &bytes)
}

/// Reads one message; `None` at the end of the stream.
pub fn receive<T: DeserializeOwned>(input: &mut impl Read) -> io::Result<Option<T>> {
    let Some(bytes) = read_frame(input)? else { return Ok(None) };
    ciborium::from_reader(bytes.as_slice()).map(Some).map_err(io::Error::other)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_survive_the_pipe_and_torn_frames_are_errors() {
        let reply = Reply::Failed(Failure::new(FailureKind::Trap, "index 9 is out of bounds of length 4"));
        let mut pipe = Vec::new();
        send(&mut pipe, &reply).unwrap();
        let Some(Reply::Failed(failure)) = receive(&mut pipe.as_slice()).unwrap() else { panic!("not a failure") };
        assert_eq!(failure.kind, FailureKind::Trap);
        assert!(receive::<Reply>(&mut &pipe[..0]).unwrap().is_none());
        for cut in 1..pipe.len() {
            assert!(receive::<Reply>(&mut &pipe[..cut]).is_err(), "a frame cut at {cut} was accepted");
        }
    }
}

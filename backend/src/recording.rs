//! Work as plain data: buffers, programs, commands and what to read back.
//!
//! A [`Job`] owns everything it needs, so one file is a failure's dump, its replay and what a browser page runs. A
//! [`Recording`] is one submission of bounded cost; memory lives on from one recording of a job to the next. Ids are
//! indices into the job's tables; [`crate::check`] refuses ids, ranges and sizes that do not exist.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::error::ErrorKind;
use crate::{Program, Result};

/// Index of a program in its job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct ProgramId(pub u32);

/// Index of a buffer in its job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub struct BufferId(pub u32);

/// A buffer: zero until something is written to it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct BufferDesc {
    /// Name for people.
    pub label: String,
    /// Size in bytes, a multiple of 4.
    pub size: u64,
}

/// One bound buffer range of a dispatch.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Slot {
    /// `@group`.
    pub group: u32,
    /// `@binding`.
    pub binding: u32,
    /// The buffer.
    pub buffer: BufferId,
    /// First byte, a multiple of 256.
    pub offset: u64,
    /// Bytes, a multiple of 4.
    pub size: u64,
}

/// Where the number of workgroups comes from.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Groups {
    /// From the host.
    Direct([u32; 3]),
    /// From three words of a buffer at a byte offset that is a multiple of 4.
    Indirect {
        /// The buffer.
        buffer: BufferId,
        /// First byte of the three words.
        offset: u64,
    },
}

/// One launch of an entry point.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Dispatch {
    /// The program.
    pub program: ProgramId,
    /// Name of the entry point.
    pub entry: String,
    /// Values of `override` declarations, by name or by `@id`.
    pub overrides: Vec<(String, f64)>,
    /// One slot for each binding that the entry point uses.
    pub slots: Vec<Slot>,
    /// Number of workgroups.
    pub groups: Groups,
}

/// One step of a recording.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Command {
    /// Write bytes to a buffer.
    Upload {
        /// The buffer.
        buffer: BufferId,
        /// First byte, a multiple of 4.
        offset: u64,
        /// The bytes; their number is a multiple of 4.
        #[serde(with = "serde_bytes")]
        bytes: Vec<u8>,
    },
    /// Set bytes of a buffer to zero.
    Clear {
        /// The buffer.
        buffer: BufferId,
        /// First byte, a multiple of 4.
        offset: u64,
        /// Bytes, a multiple of 4.
        size: u64,
    },
    /// Copy bytes between two different buffers.
    Copy {
        /// Source.
        from: BufferId,
        /// First byte of the source, a multiple of 4.
        from_offset: u64,
        /// Destination.
        to: BufferId,
        /// First byte of the destination, a multiple of 4.
        to_offset: u64,
        /// Bytes, a multiple of 4.
        size: u64,
    },
    /// Run a kernel.
    Dispatch(Dispatch),
}

/// One submission: commands that run in order, each seeing the writes of those before it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Recording {
    /// The commands.
    pub commands: Vec<Command>,
}

/// A range of a buffer that a job reads back when all its recordings have run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Read {
    /// Name of the output.
    pub name: String,
    /// The buffer.
    pub buffer: BufferId,
    /// First byte, a multiple of 4.
    pub offset: u64,
    /// Bytes, a multiple of 4.
    pub size: u64,
}

/// A whole piece of work.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Job {
    /// Programs, by [`ProgramId`].
    pub programs: Vec<Arc<Program>>,
    /// Buffers, by [`BufferId`].
    pub buffers: Vec<BufferDesc>,
    /// Submissions, in order.
    pub recordings: Vec<Recording>,
    /// What to read at the end.
    pub reads: Vec<Read>,
}

const MAGIC: &[u8] = b"sightlines job 1\n";

/// Stands behind the job in the dump of a failure, before the record of what was expected.
pub const RECORD_MARK: &[u8] = b"\nsightlines record\n";

impl Job {
    /// An empty job.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a program; the same program (by [`Program::id`]) is kept once.
    pub fn program(&mut self, program: &Arc<Program>) -> ProgramId {
        let index = self.programs.iter().position(|p| p.id() == program.id()).unwrap_or_else(|| {
            self.programs.push(Arc::clone(program));
            self.programs.len() - 1
        });
        ProgramId(index as u32)
    }

    /// Adds a buffer of `size` bytes, all zero.
    pub fn buffer(&mut self, label: impl Into<String>, size: u64) -> BufferId {
        self.buffers.push(BufferDesc { label: label.into(), size });
        BufferId(self.buffers.len() as u32 - 1)
    }

    /// Adds a buffer that holds `data`, uploaded by the current recording.
    pub fn upload<T: bytemuck::NoUninit>(&mut self, label: impl Into<String>, data: &[T]) -> BufferId {
        let bytes = bytemuck::cast_slice::<T, u8>(data).to_vec();
        let id = self.buffer(label, bytes.len() as u64);
        if !bytes.is_empty() {
            self.record(Command::Upload { buffer: id, offset: 0, bytes });
        }
        id
    }

    /// Size of a buffer in bytes.
    ///
    /// # Panics
    ///
    /// Where the buffer is not this job's.
    pub fn size(&self, buffer: BufferId) -> u64 {
        self.buffers[buffer.0 as usize].size
    }

    /// The whole of a buffer of this job, bound to `@group(0) @binding(binding)`.
    pub fn slot(&self, binding: u32, buffer: BufferId) -> Slot {
        Slot { group: 0, binding, buffer, offset: 0, size: self.size(buffer) }
    }

    /// Appends a command to the current recording.
    pub fn record(&mut self, command: Command) {
        if self.recordings.is_empty() {
            self.cut();
        }
        let last = self.recordings.len() - 1;
        self.recordings[last].commands.push(command);
    }

    /// Appends a dispatch of `groups` workgroups with whole buffers bound to group 0, by binding number.
    pub fn dispatch(&mut self, program: ProgramId, entry: &str, bind: &[(u32, BufferId)], groups: [u32; 3]) {
        let slots = bind.iter().map(|&(binding, buffer)| self.slot(binding, buffer)).collect();
        let groups = Groups::Direct(groups);
        self.record(Command::Dispatch(Dispatch { program, entry: entry.into(), overrides: Vec::new(), slots, groups }));
    }

    /// Begins a new recording: what follows is a submission of its own.
    pub fn cut(&mut self) {
        self.recordings.push(Recording::default());
    }

    /// Reads a whole buffer at the end.
    pub fn read(&mut self, name: impl Into<String>, buffer: BufferId) {
        let size = self.size(buffer);
        self.reads.push(Read { name: name.into(), buffer, offset: 0, size });
    }

    /// The job as a file: a magic line, then CBOR.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        ciborium::into_writer(self, &mut bytes).expect("writing CBOR to memory cannot fail");
        bytes
    }

    /// Reads what [`Job::to_bytes`] wrote. Programs are compiled again from their text, under the same limits, and the
    /// job is checked: any bytes give a job that a backend may run, or an error. What follows [`RECORD_MARK`] is not
    /// read.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        let mut body =
            bytes.strip_prefix(MAGIC).ok_or_else(|| ErrorKind::Format("the first line is not its magic".into()))?;
        let job: Job = ciborium::from_reader(&mut body).map_err(|e| ErrorKind::Format(e.to_string()))?;
        if !body.is_empty() && !body.starts_with(RECORD_MARK) {
            return Err(ErrorKind::Format(format!("{} bytes follow the job", body.len())).into());
        }
        crate::check::job(&job)?;
        Ok(job)
    }
}

//! What a machine must do: say who it is, open a session, run recordings, read buffers.

use std::ops::AddAssign;
use std::sync::Arc;

use crate::{BufferDesc, Job, Program, Read, Recording, Result};

/// Who ran the work. It is recorded with every result, so that a fallback cannot pass for the device asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BackendInfo {
    /// `cpu` or `wgpu`.
    pub backend: &'static str,
    /// The adapter's own name, or the interpreter's SIMD level.
    pub adapter: String,
    /// Driver name and version, where there is one.
    pub driver: String,
    /// Threads that run kernels, where the backend knows.
    pub threads: Option<usize>,
}

/// Semantic costs of a run, counted on the IR: the same for any lane count, SIMD level and number of threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Invocations launched.
    pub invocations: u64,
    /// Loads from storage, uniform and workgroup memory, one for each executed IR load and invocation.
    pub loads: u64,
    /// Stores to storage and workgroup memory.
    pub stores: u64,
    /// Bytes that those loads, stores and atomics touch.
    pub bytes: u64,
    /// Atomic operations.
    pub atomics: u64,
    /// Barriers, one for each workgroup that passes one.
    pub barriers: u64,
    /// Turns of loops of the invocation that has most of them in one dispatch, the turn that ends a loop included.
    pub turns: u64,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, more: Counts) {
        let Counts { invocations, loads, stores, bytes, atomics, barriers, turns } = self;
        *invocations += more.invocations;
        *loads += more.loads;
        *stores += more.stores;
        *bytes += more.bytes;
        *atomics += more.atomics;
        *barriers += more.barriers;
        *turns = (*turns).max(more.turns);
    }
}

/// One entry for each [`Job::reads`], in its order.
pub type Outputs = Vec<Vec<u8>>;

/// A machine that runs kernels.
pub trait Backend: Send + Sync {
    /// Who runs the work.
    fn info(&self) -> BackendInfo;

    /// Compiles `programs` and allocates `buffers`, all zero. Commands of the session's recordings index both.
    fn open(&self, programs: &[Arc<Program>], buffers: &[BufferDesc]) -> Result<Box<dyn Session + '_>>;

    /// Checks and runs a whole job.
    fn run(&self, job: &Job) -> Result<Outputs> {
        crate::check::job(job)?;
        let mut session = self.open(&job.programs, &job.buffers)?;
        for recording in &job.recordings {
            session.submit(recording)?;
        }
        job.reads.iter().map(|read| session.read(read)).collect()
    }
}

/// Memory and programs on one machine.
pub trait Session {
    /// Runs one recording to its end. After an error the buffers keep what was written before it.
    fn submit(&mut self, recording: &Recording) -> Result<()>;

    /// Reads a range of a buffer.
    fn read(&mut self, read: &Read) -> Result<Vec<u8>>;

    /// Semantic costs since the session was opened, from backends that count.
    fn counts(&self) -> Option<Counts> {
        None
    }

    /// Lane-operations since the session was opened, from interpreters: for each vector instruction executed the lanes
    /// of the 16-lane chunks it worked on. A machine cost: it changes with lowering and with the lanes of a gang.
    fn lane_ops(&self) -> Option<u64> {
        None
    }
}

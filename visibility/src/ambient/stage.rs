//! Recordings that are run again and again over the memory of one session.
//!
//! A session's buffers are fixed when it is opened, and kernels allocate as they record. A [`Stage`] makes the two
//! meet: recording the same kernels from the same table of buffers allocates the same buffers, so a later recording
//! fits the session that an earlier one was measured for. What varies is only how much of each buffer is used.
//! Invariants: a stage's own buffers are zero when it begins, as they would be in a new session; every recording is
//! checked against the session's table before it runs.

use sightlines_backend::{Command, Error, Job, Recording, Result};

/// A table of programs and buffers that recordings start from.
#[derive(Clone, Debug, Default)]
pub(super) struct Stage {
    job: Job,
}

impl Stage {
    /// The table of a job, without its recordings.
    pub(super) fn after(job: &Job) -> Self {
        let Job { programs, buffers, .. } = job;
        Stage { job: Job { programs: programs.clone(), buffers: buffers.clone(), ..Job::default() } }
    }

    /// What `record` adds, with its own buffers cleared first, and what it answers.
    pub(super) fn record<T>(&self, record: impl FnOnce(&mut Job) -> Result<T>) -> Result<(Job, T)> {
        let mut job = self.job.clone();
        let recorded = record(&mut job)?;
        let uploads =
            job.recordings.iter().flat_map(|recording| &recording.commands).filter_map(|command| match command {
                Command::Upload { buffer, .. } => Some(buffer.0 as usize),
                _ => None,
            });
        let mut is_filled = vec![false; job.buffers.len()];
        uploads.for_each(|buffer| is_filled[buffer] = true);
        let own = (self.job.buffers.len()..job.buffers.len()).filter(|&buffer| !is_filled[buffer]);
        let clear = |buffer: usize| Command::Clear {
            buffer: sightlines_backend::BufferId(buffer as u32),
            offset: 0,
            size: job.buffers[buffer].size,
        };
        let commands = own.map(clear).collect();
        job.recordings.insert(0, Recording { commands });
        Ok((job, recorded))
    }

    /// The table that holds each of several jobs of this stage.
    pub(super) fn widest(&self, jobs: &[Job]) -> Stage {
        let mut widest = self.clone();
        for job in jobs {
            let table = &mut widest.job;
            table.programs.extend_from_slice(&job.programs[table.programs.len().min(job.programs.len())..]);
            for (at, buffer) in job.buffers.iter().enumerate() {
                match table.buffers.get_mut(at) {
                    Some(known) => known.size = known.size.max(buffer.size),
                    None => table.buffers.push(buffer.clone()),
                }
            }
        }
        widest
    }

    /// The table itself.
    pub(super) fn table(&self) -> &Job {
        &self.job
    }

    /// Refuses a job that this table does not hold.
    pub(super) fn holds(&self, job: &Job) -> Result<()> {
        let Job { programs, buffers, .. } = &self.job;
        let same =
            programs.len() >= job.programs.len() && job.programs.iter().zip(programs).all(|(a, b)| a.id() == b.id());
        let fits = buffers.len() >= job.buffers.len() && job.buffers.iter().zip(buffers).all(|(a, b)| a.size <= b.size);
        if same && fits {
            return Ok(());
        }
        Err(Error::refused("work that the session was not opened for", "open a session for it"))
    }
}

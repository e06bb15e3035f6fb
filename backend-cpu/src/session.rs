//! A session: buffers as words of plain memory, commands in order.

use std::sync::Arc;

use sightlines_backend::check;
use sightlines_backend::{
    Access, BufferDesc, BufferId, Command, Counts, Dispatch, Error, Groups, Program, Read, Recording, Result, Session,
    Trap, TrapKind,
};

use crate::exec::{self, Range, Settings};
use crate::{Bounds, CpuBackend};

/// Memory and programs on the interpreter.
pub(crate) struct CpuSession<'a> {
    backend: &'a CpuBackend,
    programs: Vec<Arc<Program>>,
    descs: Vec<BufferDesc>,
    buffers: Vec<Vec<u32>>,
    /// Bytes of all buffers.
    allocated: u64,
    counts: Counts,
    lane_ops: u64,
}

impl<'a> CpuSession<'a> {
    pub(crate) fn open(backend: &'a CpuBackend, programs: &[Arc<Program>], buffers: &[BufferDesc]) -> Result<Self> {
        check::buffers(buffers)?;
        let wanted = buffers.iter().fold(0u64, |sum, buffer| sum.saturating_add(buffer.size));
        let limit = backend.config.memory;
        if wanted > limit {
            let kind = TrapKind::OutOfMemory { wanted, limit };
            return Err(Error::from(Trap { kind, location: None, invocation: None }));
        }
        let (programs, descs) = (programs.to_vec(), buffers.to_vec());
        let buffers = buffers.iter().map(|buffer| vec![0; (buffer.size / 4) as usize]).collect();
        Ok(CpuSession { backend, programs, descs, buffers, allocated: wanted, counts: Counts::default(), lane_ops: 0 })
    }

    fn range(&mut self, buffer: BufferId, offset: u64, size: u64) -> Result<&mut [u32]> {
        let (start, end) = ((offset / 4) as usize, (offset.saturating_add(size) / 4) as usize);
        let words = self.buffers.get_mut(buffer.0 as usize).and_then(|words| words.get_mut(start..end));
        words.ok_or_else(|| {
            let what = format!("bytes {offset}..{} of buffer {}", offset.saturating_add(size), buffer.0);
            Error::refused(format!("{what} do not exist"), "check the job before it is submitted")
        })
    }

    fn dispatch(&mut self, dispatch: &Dispatch) -> Result<()> {
        let program = self.programs.get(dispatch.program.0 as usize).cloned().ok_or_else(|| {
            Error::refused(format!("program {} does not exist", dispatch.program.0), "add it to the job")
        })?;
        let code = self.backend.code(&program, &dispatch.entry, &dispatch.overrides)?;
        let groups = match dispatch.groups {
            Groups::Direct(groups) => groups,
            Groups::Indirect { buffer, offset } => {
                let words = self.range(buffer, offset, 12)?;
                check::indirect_groups([words[0], words[1], words[2]])
            }
        };
        let ranges = self.ranges(&program, dispatch)?;
        let settings = Settings {
            level: self.backend.level,
            pool: self.backend.pool.as_ref(),
            trap: self.backend.config.bounds == Bounds::Trap,
            fuel: self.backend.config.fuel,
            lanes: self.backend.config.lanes,
            allocated: self.allocated,
            memory: self.backend.config.memory,
        };
        let (counts, lane_ops) =
            exec::run(&code, &program, &mut self.buffers, &ranges, groups, &settings).map_err(Error::from)?;
        self.lane_ops += lane_ops;
        if self.backend.config.count {
            self.counts += counts;
        }
        Ok(())
    }

    /// The bound ranges in the order of the entry point's bindings.
    fn ranges(&mut self, program: &Program, dispatch: &Dispatch) -> Result<Vec<Range>> {
        let entry = program.entry(&dispatch.entry);
        let mut ranges = Vec::new();
        for &index in entry.iter().flat_map(|entry| &entry.bindings) {
            let binding = &program.bindings()[index];
            let place = (binding.group, binding.binding);
            let slot = dispatch.slots.iter().find(|s| (s.group, s.binding) == place).ok_or_else(|| {
                Error::refused(format!("binding {place:?} (`{}`) is not bound", binding.name), "bind a buffer to it")
            })?;
            self.range(slot.buffer, slot.offset, slot.size)?;
            ranges.push(Range {
                buffer: slot.buffer.0 as usize,
                start: (slot.offset / 4) as usize,
                words: (slot.size / 4) as usize,
                write: binding.access == Access::ReadWrite,
            });
        }
        Ok(ranges)
    }
}

impl Session for CpuSession<'_> {
    fn submit(&mut self, recording: &Recording) -> Result<()> {
        check::recording(&self.descs, &self.programs, recording)?;
        for command in &recording.commands {
            match command {
                Command::Upload { buffer, offset, bytes } => {
                    let words = self.range(*buffer, *offset, bytes.len() as u64)?;
                    for (word, bytes) in words.iter_mut().zip(bytes.as_chunks().0) {
                        *word = u32::from_le_bytes(*bytes);
                    }
                }
                Command::Clear { buffer, offset, size } => self.range(*buffer, *offset, *size)?.fill(0),
                Command::Copy { from, from_offset, to, to_offset, size } => {
                    let words = self.range(*from, *from_offset, *size)?.to_vec();
                    self.range(*to, *to_offset, *size)?.copy_from_slice(&words);
                }
                Command::Dispatch(dispatch) => self.dispatch(dispatch)?,
            }
        }
        Ok(())
    }

    fn read(&mut self, read: &Read) -> Result<Vec<u8>> {
        check::read(&self.descs, read)?;
        let words = self.range(read.buffer, read.offset, read.size)?;
        let mut bytes = vec![0; words.len() * 4];
        bytes.as_chunks_mut().0.iter_mut().zip(words).for_each(|(bytes, word)| *bytes = word.to_le_bytes());
        Ok(bytes)
    }

    fn counts(&self) -> Option<Counts> {
        self.backend.config.count.then_some(self.counts)
    }

    fn lane_ops(&self) -> Option<u64> {
        Some(self.lane_ops)
    }
}

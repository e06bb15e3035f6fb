//! The evaluator as a [`Backend`], so that the jobs of the interpreter run here unchanged.

use std::cell::RefCell;
use std::sync::Arc;

use sightlines_backend::{
    Backend, BackendInfo, BufferDesc, BufferId, Command, Counts, Groups, Program, Read, Recording, Result, Session,
};

use super::dispatch::dispatch;

/// The scalar evaluator.
pub struct Reference;

struct Memory {
    programs: Vec<Arc<Program>>,
    buffers: Vec<RefCell<Vec<u32>>>,
    counts: Counts,
}

impl Backend for Reference {
    fn info(&self) -> BackendInfo {
        let (adapter, driver) = ("scalar evaluator".to_owned(), String::new());
        BackendInfo { backend: "reference", adapter, driver, threads: Some(1) }
    }

    fn open(&self, programs: &[Arc<Program>], buffers: &[BufferDesc]) -> Result<Box<dyn Session + '_>> {
        let buffers = buffers.iter().map(|b| RefCell::new(vec![0; b.size as usize / 4])).collect();
        Ok(Box::new(Memory { programs: programs.to_vec(), buffers, counts: Counts::default() }))
    }
}

impl Memory {
    fn words(&self, buffer: BufferId, offset: u64, size: u64) -> Vec<u32> {
        self.buffers[buffer.0 as usize].borrow()[offset as usize / 4..][..size as usize / 4].to_vec()
    }

    fn write(&self, buffer: BufferId, offset: u64, words: &[u32]) {
        self.buffers[buffer.0 as usize].borrow_mut()[offset as usize / 4..][..words.len()].copy_from_slice(words);
    }
}

impl Session for Memory {
    fn submit(&mut self, recording: &Recording) -> Result<()> {
        for command in &recording.commands {
            match command {
                Command::Upload { buffer, offset, bytes } => {
                    let word = |b: &[u8]| u32::from_le_bytes([b[0], b[1], b[2], b[3]]);
                    self.write(*buffer, *offset, &bytes.chunks_exact(4).map(word).collect::<Vec<_>>());
                }
                Command::Clear { buffer, offset, size } => self.write(*buffer, *offset, &vec![0; *size as usize / 4]),
                Command::Copy { from, from_offset, to, to_offset, size } => {
                    self.write(*to, *to_offset, &self.words(*from, *from_offset, *size));
                }
                Command::Dispatch(command) => {
                    let groups = match command.groups {
                        Groups::Direct(groups) => groups,
                        Groups::Indirect { buffer, offset } => {
                            let words = self.words(buffer, offset, 12);
                            [words[0], words[1], words[2]]
                        }
                    };
                    let program = &self.programs[command.program.0 as usize];
                    let cost = dispatch(program, command, groups, &self.buffers)?;
                    self.counts.invocations += cost.invocations;
                    self.counts.loads += cost.loads;
                    self.counts.stores += cost.stores;
                    self.counts.bytes += cost.bytes;
                    self.counts.atomics += cost.atomics;
                    self.counts.barriers += cost.barriers;
                }
            }
        }
        Ok(())
    }

    fn read(&mut self, read: &Read) -> Result<Vec<u8>> {
        Ok(self.words(read.buffer, read.offset, read.size).iter().flat_map(|w| w.to_le_bytes()).collect())
    }

    fn counts(&self) -> Option<Counts> {
        Some(self.counts)
    }
}

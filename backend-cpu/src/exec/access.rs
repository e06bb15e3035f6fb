//! What a gang's instructions do to memory: which words they mean, and where a run stops.

use fearless_simd::Simd;

use super::atomic;
use super::gang::{Gang, Stop, View};
use super::memory::{self, Outside, SharedWord};
use super::record;
use crate::code::{AtomicArgs, Mem, Reg};

impl<S: Simd, W: SharedWord> Gang<'_, S, W> {
    pub(super) fn stop(&self, outside: Option<Outside>, site: u32) -> Result<(), Stop> {
        match outside {
            Some(at) if self.launch.trap => Err(Stop::Outside { at, site }),
            _ => Ok(()),
        }
    }

    pub(super) fn load(&self, dst: Reg, mem: Mem, addr: Reg, offset: u32, site: u32) -> Result<(), Stop> {
        let outside = match mem {
            Mem::Buffer(slot) => match self.launch.views[slot as usize] {
                View::Read(words) => self.load_from(words, dst, addr, offset),
                View::Write(words) => self.load_from(words, dst, addr, offset),
            },
            Mem::Workgroup => self.load_from(self.workgroup, dst, addr, offset),
            Mem::Private => {
                self.private.load(self.work(), dst, addr, offset);
                None
            }
        };
        self.stop(outside, site)
    }

    fn load_from<T: memory::Word>(&self, words: &[T], dst: Reg, addr: Reg, offset: u32) -> Option<Outside> {
        if !dst.is_scalar() {
            return memory::load(self.s, self.work(), &self.exec, words, dst, addr, offset);
        }
        let index = self.scalar(addr).wrapping_add(offset);
        self.set_scalar(dst, memory::read(words, index));
        let length = words.len() as u32;
        (index >= length).then(|| Outside { lane: self.first_lane(), index, length })
    }

    pub(super) fn store(&self, mem: Mem, addr: Reg, value: Reg, offset: u32, site: u32) -> Result<(), Stop> {
        let (rows, exec) = (self.work(), &self.exec);
        let outside = match mem {
            Mem::Buffer(slot) => match self.launch.views[slot as usize] {
                // The validator refuses stores to what is bound for reading.
                View::Read(_) => None,
                View::Write(words) => memory::store(self.s, rows, exec, words, addr, value, offset),
            },
            Mem::Workgroup => memory::store(self.s, rows, exec, self.workgroup, addr, value, offset),
            Mem::Private => {
                self.private.store(rows, exec, addr, value, offset);
                None
            }
        };
        self.stop(outside, site)
    }

    /// Loads a record of each lane; the line of its words is `site`, and `step` more for each.
    pub(super) fn load_record(
        &self,
        dst: [Reg; 4],
        mem: Mem,
        at: (Reg, u32),
        (site, step): (u32, u8),
    ) -> Result<(), Stop> {
        let (rows, exec) = (self.rows, &self.exec);
        self.count_chunks(4 * rows.len());
        let outside = match mem {
            Mem::Buffer(slot) => match self.launch.views[slot as usize] {
                View::Read(words) => record::load(self.s, rows, exec, words, dst, at),
                View::Write(words) => record::load(self.s, rows, exec, words, dst, at),
            },
            Mem::Workgroup => record::load(self.s, rows, exec, self.workgroup, dst, at),
            // Words of private memory stand a row apart: lowering makes no records of them.
            Mem::Private => None,
        };
        outside.map_or(Ok(()), |(outside, word)| self.stop(Some(outside), site + u32::from(step) * word as u32))
    }

    /// Stores a record of each active lane.
    pub(super) fn store_record(
        &self,
        mem: Mem,
        (addr, offset): (Reg, u32),
        values: [Reg; 4],
        (site, step): (u32, u8),
    ) -> Result<(), Stop> {
        let (rows, exec) = (self.rows, &self.exec);
        let done = match mem {
            Mem::Buffer(slot) => match self.launch.views[slot as usize] {
                View::Read(_) => Some(()),
                View::Write(words) => record::store(self.s, rows, exec, words, (addr, offset), values),
            },
            Mem::Workgroup => record::store(self.s, rows, exec, self.workgroup, (addr, offset), values),
            Mem::Private => None,
        };
        if done.is_some() {
            self.count_chunks(4 * rows.len());
            return Ok(());
        }
        for (word, value) in (0..).zip(values) {
            self.store(mem, addr, value, offset.wrapping_add(word), site + u32::from(step) * word)?;
        }
        Ok(())
    }

    pub(super) fn atomic(&self, args: &AtomicArgs) -> Result<(), Stop> {
        let (rows, exec) = (self.work(), &self.exec);
        let outside = match args.mem {
            Mem::Buffer(slot) => match self.launch.views[slot as usize] {
                View::Read(_) => None,
                View::Write(words) => atomic::atomic(self.s, rows, exec, words, args),
            },
            Mem::Workgroup => atomic::atomic(self.s, rows, exec, self.workgroup, args),
            Mem::Private => None,
        };
        self.stop(outside, args.site)
    }
}

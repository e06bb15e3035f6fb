//! Runs the code of one gang: fetch, match, work on all lanes.

use std::cell::Cell;

use fearless_simd::Simd;

use super::alu;
use super::fused;
use super::mask::{CHUNK, Exec, Mask};
use super::memory::{Outside, Private, SharedWord};
use super::rows::{Chunk, Rows};
use crate::code::{Code, Inst, Reg};
use crate::lower::Builtin;
use crate::semantics;

/// A bound buffer range.
#[derive(Clone, Copy)]
pub(super) enum View<'a, W> {
    /// Read by this dispatch and written by none of its bindings.
    Read(&'a [u32]),
    /// Written.
    Write(&'a [W]),
}

impl<W> View<'_, W> {
    fn len(&self) -> u32 {
        match self {
            View::Read(words) => words.len() as u32,
            View::Write(words) => words.len() as u32,
        }
    }
}

/// What a whole dispatch shares.
pub(super) struct Launch<'a, W> {
    pub(super) code: &'a Code,
    pub(super) views: Vec<View<'a, W>>,
    pub(super) groups: [u32; 3],
    /// Workgroups of one gang.
    pub(super) merged: u32,
    /// Lanes of one gang, a multiple of 16.
    pub(super) lanes: usize,
    pub(super) trap: bool,
    pub(super) fuel: u64,
    /// For each input the part that depends on the lane only.
    pub(super) tables: Vec<Vec<u32>>,
}

/// Why a gang stopped.
#[derive(Clone, Copy, Debug)]
pub(super) enum Stop {
    Outside { at: Outside, site: u32 },
    OutOfFuel { site: u32 },
    Barrier { site: u32 },
}

/// How often a straight run of code was executed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    pub(super) invocations: u64,
    pub(super) workgroups: u64,
}

impl Tally {
    pub(super) fn plus(self, other: Self) -> Self {
        Tally { invocations: self.invocations + other.invocations, workgroups: self.workgroups + other.workgroups }
    }
}

/// One thread's registers and memory, used for one gang after the other.
pub(super) struct Worker {
    vectors: Vec<Chunk>,
    scalars: Vec<u32>,
    slots: Vec<Mask>,
    workgroup: Vec<u32>,
    private: Vec<u32>,
    pub(super) tallies: Vec<Tally>,
    /// Turns of loops of each lane of the gang, where they are counted.
    turns: Vec<u32>,
    /// Most turns of one invocation so far.
    pub(super) longest: u32,
    /// Chunks worked on, one for each vector instruction and chunk.
    pub(super) chunk_ops: u64,
}

impl Worker {
    pub(super) fn new(code: &Code, lanes: usize) -> Self {
        let mut scalars = code.constants.clone();
        scalars.resize(code.scalars.max(scalars.len()), 0);
        Worker {
            vectors: vec![Chunk::default(); code.vectors * lanes / CHUNK],
            scalars,
            slots: vec![Mask::default(); code.slots],
            workgroup: vec![0; code.workgroup_words as usize],
            private: vec![0; code.private_words as usize * lanes],
            tallies: vec![Tally::default(); code.costs.len()],
            turns: vec![0; if code.costs.iter().any(|cost| cost.turns > 0) { lanes } else { 0 }],
            longest: 0,
            chunk_ops: 0,
        }
    }

    /// Bytes of registers and memory that a worker allocates.
    pub(super) fn bytes(code: &Code, lanes: usize) -> u64 {
        let rows = code.vectors as u64 + u64::from(code.private_words);
        4 * (rows * lanes as u64 + code.scalars as u64 + u64::from(code.workgroup_words))
    }

    /// Runs the workgroups from `first` on, as many as a gang holds and the grid has.
    pub(super) fn run<S: Simd, W: SharedWord>(
        &mut self,
        s: S,
        launch: &Launch<'_, W>,
        first: [u32; 3],
    ) -> Result<(), Stop> {
        let count = launch.merged.min(launch.groups[0] - first[0]);
        let size: u32 = launch.code.workgroup_size.iter().product();
        self.workgroup.fill(0);
        self.turns.fill(0);
        let exec = Exec::new((count * size) as usize);
        let rows = Rows {
            vectors: Cell::from_mut(&mut self.vectors[..]).as_slice_of_cells(),
            scalars: Cell::from_mut(&mut self.scalars[..]).as_slice_of_cells(),
            chunks: launch.lanes / CHUNK,
            low: exec.low,
            high: exec.high,
        };
        let mut gang = Gang {
            s,
            launch,
            rows,
            slots: &mut self.slots,
            workgroup: Cell::from_mut(&mut self.workgroup[..]).as_slice_of_cells(),
            private: Private { words: Cell::from_mut(&mut self.private[..]).as_slice_of_cells(), lanes: launch.lanes },
            tallies: &mut self.tallies,
            turns: &mut self.turns,
            exec,
            fuel: launch.fuel,
            groups: count,
            chunk_ops: Cell::from_mut(&mut self.chunk_ops),
        };
        gang.inputs(first);
        let result = s.vectorize(
            #[inline(always)]
            || gang.run(),
        );
        self.longest = self.turns.iter().fold(self.longest, |most, turns| most.max(*turns));
        result
    }
}

pub(super) struct Gang<'a, S, W> {
    pub(super) s: S,
    pub(super) launch: &'a Launch<'a, W>,
    /// The registers, and the chunks that hold active lanes.
    pub(super) rows: Rows<'a>,
    pub(super) slots: &'a mut [Mask],
    pub(super) workgroup: &'a [Cell<u32>],
    pub(super) private: Private<'a>,
    tallies: &'a mut [Tally],
    turns: &'a mut [u32],
    pub(super) exec: Exec,
    pub(super) fuel: u64,
    /// Workgroups in this gang.
    groups: u32,
    chunk_ops: &'a Cell<u64>,
}

impl<S: Simd, W: SharedWord> Gang<'_, S, W> {
    /// Changes which lanes are active.
    pub(super) fn activate(&mut self, lanes: Mask) {
        self.exec.set(lanes);
        (self.rows.low, self.rows.high) = (self.exec.low, self.exec.high);
    }

    #[inline(always)]
    pub(super) fn count_chunks(&self, chunks: usize) {
        self.chunk_ops.set(self.chunk_ops.get() + chunks as u64);
    }

    /// The rows for an instruction on lanes, which is counted.
    #[inline(always)]
    pub(super) fn work(&self) -> Rows<'_> {
        self.count_chunks(self.rows.len());
        self.rows
    }

    /// An instruction that computes, on each run of chunks that hold active lanes.
    #[inline(always)]
    fn each(&self, pass: impl Fn(&Rows<'_>)) {
        if self.exec.solid {
            self.count_chunks(self.rows.len());
            return pass(&self.rows);
        }
        for (low, high) in self.exec.runs() {
            self.count_chunks(high - low);
            pass(&Rows { low, high, ..self.rows });
        }
    }

    #[inline(always)]
    pub(super) fn scalar(&self, register: Reg) -> u32 {
        self.rows.scalars[register.index()].get()
    }

    #[inline(always)]
    pub(super) fn set_scalar(&self, register: Reg, word: u32) {
        self.rows.scalars[register.index()].set(word);
    }

    fn inputs(&self, first: [u32; 3]) {
        let code = self.launch.code;
        for (input, table) in code.inputs.iter().zip(&self.launch.tables) {
            let base = match input.builtin {
                Builtin::LocalId(_) | Builtin::LocalIndex => 0,
                Builtin::GroupId(axis) => first[axis as usize],
                Builtin::NumGroups(axis) => self.launch.groups[axis as usize],
                Builtin::GlobalId(axis) => first[axis as usize].wrapping_mul(code.workgroup_size[axis as usize]),
            };
            if input.reg.is_scalar() {
                self.set_scalar(input.reg, base);
                continue;
            }
            for (cell, table) in self.rows.row(input.reg).iter().zip(table.chunks_exact(CHUNK)) {
                cell.set(Chunk(std::array::from_fn(|i| table[i].wrapping_add(base))));
            }
        }
    }

    #[inline(always)]
    fn run(&mut self) -> Result<(), Stop> {
        let code = self.launch.code;
        let mut pc = 0usize;
        loop {
            let inst = code.insts[pc];
            pc += 1;
            match inst {
                Inst::Un { op, dst, a } if dst.is_scalar() => {
                    self.set_scalar(dst, semantics::unary(op, self.scalar(a)));
                }
                Inst::Un { op, dst, a } => self.each(
                    #[inline(always)]
                    |rows| alu::unary(self.s, rows, op, dst, a),
                ),
                Inst::Bin { op, dst, a, b } if dst.is_scalar() => {
                    self.set_scalar(dst, semantics::binary(op, self.scalar(a), self.scalar(b)));
                }
                Inst::Bin { op, dst, a, b } => self.each(
                    #[inline(always)]
                    |rows| alu::binary(self.s, rows, op, dst, a, b),
                ),
                Inst::Tern { op, dst, a, b, c } if dst.is_scalar() => {
                    self.set_scalar(dst, semantics::ternary(op, self.scalar(a), self.scalar(b), self.scalar(c)));
                }
                Inst::Tern { op, dst, a, b, c } => self.each(
                    #[inline(always)]
                    |rows| alu::ternary(self.s, rows, op, dst, [a, b, c]),
                ),
                Inst::Fused { op, dst, a, b, c } => self.each(
                    #[inline(always)]
                    |rows| fused::pair(self.s, rows, op, dst, [a, b, c]),
                ),
                Inst::Quad { op, dst, a, b, c, d } => self.each(
                    #[inline(always)]
                    |rows| fused::quad(self.s, rows, op, dst, [a, b, c, d]),
                ),
                Inst::Mix { dst, a, by } => self.each(
                    #[inline(always)]
                    |rows| fused::mix(self.s, rows, dst, a, by),
                ),
                Inst::Choose { test, dst, accept, reject } => self.each(
                    #[inline(always)]
                    |rows| fused::choose(self.s, rows, test, dst, [accept, reject]),
                ),
                Inst::Switch { dst, a, words, arms } => self.each(
                    #[inline(always)]
                    |rows| fused::switch(self.s, rows, dst, a, words, arms),
                ),
                Inst::Blend { dst, a } => self.each(
                    #[inline(always)]
                    |rows| alu::blend(self.s, rows, &self.exec, dst, a),
                ),
                Inst::Check { dst, index, length, site } => self.check(dst, index, length, site)?,
                Inst::ArrayLength { dst, buffer, offset, stride } => {
                    let words = self.launch.views[buffer as usize].len();
                    self.set_scalar(dst, words.saturating_sub(offset) / stride.max(1));
                }
                Inst::Load { dst, mem, addr, offset, site } => self.load(dst, mem, addr, offset, site)?,
                Inst::Store { mem, addr, value, offset, site } => self.store(mem, addr, value, offset, site)?,
                Inst::LoadRecord { dst, mem, addr, offset, site, step } => {
                    self.load_record(dst, mem, (addr, offset), (site, step))?;
                }
                Inst::StoreRecord { mem, addr, values, offset, site, step } => {
                    self.store_record(mem, (addr, offset), values, (site, step))?;
                }
                Inst::Zero { offset, count } => self.private.zero(offset, count),
                Inst::Atomic { index } => self.atomic(&code.atomics[index as usize])?,
                Inst::Barrier { site } => {
                    if !self.exec.full {
                        return Err(Stop::Barrier { site });
                    }
                }
                Inst::Tally { index } => self.tally(index as usize),
                Inst::Jump { to } => pc = to as usize,
                Inst::JumpIf { test, to } => {
                    if self.holds(test) {
                        pc = to as usize;
                    }
                }
                Inst::Back { to, site } => {
                    self.burn(site)?;
                    pc = to as usize;
                }
                Inst::BackIf { test, to, site } => {
                    if self.holds(test) {
                        self.burn(site)?;
                        pc = to as usize;
                    }
                }
                Inst::Again { test, from, to, site } => {
                    if self.again(test, from) {
                        self.burn(site)?;
                        pc = to as usize;
                    }
                }
                Inst::End => return Ok(()),
                parting => {
                    if let Some(to) = self.part(parting) {
                        pc = to;
                    }
                }
            }
        }
    }

    pub(super) fn first_lane(&self) -> usize {
        self.exec.mask.first_lane().unwrap_or(0)
    }

    fn check(&self, dst: Reg, index: Reg, length: Reg, site: u32) -> Result<(), Stop> {
        let length = self.scalar(length);
        let outside = if dst.is_scalar() {
            let index = self.scalar(index);
            self.set_scalar(dst, index.min(length.wrapping_sub(1)));
            (index >= length).then(|| Outside { lane: self.first_lane(), index, length })
        } else {
            let wrong = alu::check(self.s, &self.work(), &self.exec, dst, index, length);
            wrong.map(|(lane, index)| Outside { lane, index, length })
        };
        self.stop(outside, site)
    }

    fn tally(&mut self, index: usize) {
        self.tallies[index].invocations += u64::from(self.exec.mask.count());
        self.tallies[index].workgroups += u64::from(self.groups);
        let more = self.launch.code.costs[index].turns;
        if more > 0 {
            let mask = self.exec.mask;
            let active = self.turns.iter_mut().enumerate().filter(|(lane, _)| mask.has(*lane));
            active.for_each(|(_, turns)| *turns = turns.saturating_add(more));
        }
    }
}

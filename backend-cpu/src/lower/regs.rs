//! Register allocation: linear scan over intervals that are already extended over loops.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use super::emit::Linear;
use crate::code::{AtomicArgs, Inst, Reg};

/// A virtual register: a number, and whether it is scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Virtual {
    pub(super) index: u32,
    pub(super) scalar: bool,
}

/// The instructions between which a virtual register is occupied, both included. They count from 1 here: inputs are
/// written at 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    pub(super) from: u32,
    pub(super) to: u32,
}

/// Allocated code.
pub(super) struct Allocated {
    pub(super) insts: Vec<Inst>,
    pub(super) atomics: Vec<AtomicArgs>,
    pub(super) registers: Vec<Reg>,
    pub(super) vectors: usize,
    pub(super) scalars: usize,
}

/// Intervals of all virtual registers: from the first to the last access, extended over each loop (as instruction
/// ranges) that lies inside the register's home and contains an access.
pub(super) fn intervals(
    insts: &[Inst<Virtual>],
    atomics: &[AtomicArgs<Virtual>],
    homes: &[u32],
    inputs: &[u32],
    loops: &[(u32, u32)],
) -> Vec<Option<Interval>> {
    let mut found: Vec<Option<Interval>> = vec![None; homes.len()];
    let mut outermost_first = loops.to_vec();
    outermost_first.sort_by_key(|&(from, to)| (from, Reverse(to)));
    let mut next = outermost_first.into_iter().peekable();
    let mut open: Vec<(u32, u32)> = Vec::new();
    for (at, inst) in insts.iter().enumerate() {
        open.retain(|&(_, to)| (at as u32) < to);
        while let Some(begun) = next.next_if(|&(from, _)| from as usize <= at) {
            open.push(begun);
        }
        inst.registers(atomics, |register, _| {
            let home = homes[register.index as usize];
            let mut range = Interval { from: at as u32 + 1, to: at as u32 + 1 };
            // The outermost loop that does not hold the home holds all others.
            if let Some(&(from, to)) = open.iter().find(|&&(from, _)| from > home) {
                range.from = range.from.min(from + 1);
                range.to = range.to.max(to);
            }
            let slot = &mut found[register.index as usize];
            *slot = Some(match *slot {
                Some(old) => Interval { from: old.from.min(range.from), to: old.to.max(range.to) },
                None => range,
            });
        });
    }
    for input in inputs {
        if let Some(interval) = &mut found[*input as usize] {
            interval.from = 0;
        }
    }
    found
}

/// Gives each interval a register of its file; constants have theirs already, the first of the scalar file.
pub(super) fn allocate(
    linear: &Linear,
    intervals: &[Option<Interval>],
    constants: &HashMap<Virtual, Reg>,
) -> Option<Allocated> {
    let (insts, atomics) = (&linear.insts, &linear.atomics);
    let mut order: Vec<usize> = (0..intervals.len()).filter(|&i| intervals[i].is_some()).collect();
    order.sort_by_key(|&i| intervals[i].map(|r| r.from));
    let mut files = [File::new(0), File::new(constants.len())];
    let mut registers = vec![Reg::vector(0); intervals.len()];
    for (register, place) in constants {
        registers[register.index as usize] = *place;
    }
    for index in order {
        let Some(interval) = intervals[index] else { continue };
        let scalar = linear.scalar[index];
        let number = files[usize::from(scalar)].take(interval)?;
        registers[index] = if scalar { Reg::scalar(number) } else { Reg::vector(number) };
    }
    let mut out = Vec::with_capacity(insts.len());
    let mut mapped = Vec::with_capacity(atomics.len());
    for args in atomics {
        let to = |r: Virtual| registers[r.index as usize];
        mapped.push(AtomicArgs {
            op: args.op,
            mem: args.mem,
            addr: to(args.addr),
            offset: args.offset,
            value: to(args.value),
            compare: args.compare.map(to),
            dst: args.dst.map(to),
            site: args.site,
        });
    }
    for inst in insts {
        out.push(inst.map(&mut |r: Virtual, _| registers[r.index as usize]));
    }
    let [vectors, scalars] = files.map(|file| file.next as usize);
    Some(Allocated { insts: out, atomics: mapped, registers, vectors, scalars })
}

struct File {
    next: u16,
    free: BinaryHeap<Reverse<u16>>,
    busy: BinaryHeap<Reverse<(u32, u16)>>,
}

impl File {
    fn new(reserved: usize) -> Self {
        File { next: reserved as u16, free: BinaryHeap::new(), busy: BinaryHeap::new() }
    }

    fn take(&mut self, interval: Interval) -> Option<u16> {
        // A register whose last read is the instruction that writes the new one can be that one's: instructions read a
        // lane before they write it.
        while let Some(&Reverse((end, register))) = self.busy.peek() {
            if end > interval.from {
                break;
            }
            self.busy.pop();
            self.free.push(Reverse(register));
        }
        let register = match self.free.pop() {
            Some(Reverse(register)) => register,
            None if self.next < 0x7fff => {
                self.next += 1;
                self.next - 1
            }
            None => return None,
        };
        self.busy.push(Reverse((interval.to, register)));
        Some(register)
    }
}

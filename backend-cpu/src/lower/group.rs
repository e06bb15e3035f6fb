//! Records: accesses of four neighbouring words of one base become one instruction.
//!
//! A load or store of a vector, or of a struct's or array's neighbouring words, looks at the same addresses once for
//! each word. Invariant: what stands between the accesses computes and does nothing else, all run with the same lanes
//! active, and neither the addresses nor the words that are stored change on the way.

use std::collections::HashSet;

use super::emit::Linear;
use super::fuse::remove;
use super::regs::Virtual;
use crate::code::{Inst, Mem};

/// Instructions that stand between the first and the last access at most.
const REACH: usize = 16;

/// One access of a word.
#[derive(Clone, Copy)]
struct Access {
    is_load: bool,
    mem: Mem,
    addr: Virtual,
    offset: u32,
    word: Virtual,
    site: u32,
}

impl Access {
    fn of(inst: &Inst<Virtual>) -> Option<Self> {
        let (access, row) = match *inst {
            Inst::Load { dst: word, mem, addr, offset, site } => {
                (Access { is_load: true, mem, addr, offset, word, site }, !word.scalar)
            }
            Inst::Store { mem, addr, value: word, offset, site } => {
                (Access { is_load: false, mem, addr, offset, word, site }, true)
            }
            _ => return None,
        };
        (row && !access.addr.scalar && access.mem != Mem::Private).then_some(access)
    }

    /// Whether it accesses the word `after` words behind another's.
    fn follows(&self, first: &Access, after: usize) -> bool {
        (self.is_load, self.mem, self.addr) == (first.is_load, first.mem, first.addr)
            && self.offset == first.offset.wrapping_add(after as u32)
    }
}

/// Groups accesses to records.
pub(super) fn group(linear: &mut Linear) {
    let targets: HashSet<u32> = linear.insts.iter_mut().filter_map(|inst| inst.target_mut().copied()).collect();
    let mut gone = vec![false; linear.insts.len()];
    for first in 0..linear.insts.len() {
        if gone[first] {
            continue;
        }
        if let Some((places, record)) = record(linear, &targets, first) {
            let kept = places[if matches!(record, Inst::LoadRecord { .. }) { 0 } else { 3 }];
            places.iter().for_each(|at| gone[*at] = *at != kept);
            linear.insts[kept] = record;
        }
    }
    remove(linear, &gone);
}

/// The record whose first word an instruction accesses, and its four instructions.
fn record(linear: &Linear, targets: &HashSet<u32>, first: usize) -> Option<([usize; 4], Inst<Virtual>)> {
    let access = Access::of(&linear.insts[first])?;
    let (mut places, mut words) = ([first; 4], [access.word; 4]);
    let mut step = 0;
    let mut next = 1;
    for at in first + 1..linear.insts.len().min(first + REACH) {
        let inst = &linear.insts[at];
        if targets.contains(&(at as u32)) {
            return None;
        }
        match Access::of(inst) {
            Some(found) if found.follows(&access, next) => {
                step = if next == 1 { found.site.checked_sub(access.site)? } else { step };
                if found.site != access.site + step * next as u32 || found.is_load && at != first + next {
                    return None;
                }
                (places[next], words[next]) = (at, found.word);
                next += 1;
            }
            None if !access.is_load && computes(inst) => {
                let mut kept = true;
                inst.registers(&linear.atomics, |register, write| {
                    kept &= !(write && (register == access.addr || words[..next].contains(&register)));
                });
                kept.then_some(())?;
            }
            _ => return None,
        }
        if next == 4 {
            let step = u8::try_from(step).ok()?;
            let Access { is_load, mem, addr, offset, site, .. } = access;
            if !is_load {
                return Some((places, Inst::StoreRecord { mem, addr, values: words, offset, site, step }));
            }
            let distinct = (0..4).all(|i| !words[..i].contains(&words[i]) && (i == 3 || words[i] != addr));
            return distinct.then_some((places, Inst::LoadRecord { dst: words, mem, addr, offset, site, step }));
        }
    }
    None
}

/// Whether an instruction does nothing but to compute a register.
fn computes(inst: &Inst<Virtual>) -> bool {
    matches!(
        inst,
        Inst::Un { .. }
            | Inst::Bin { .. }
            | Inst::Tern { .. }
            | Inst::Fused { .. }
            | Inst::Quad { .. }
            | Inst::Mix { .. }
            | Inst::Choose { .. }
    )
}

//! Control flow of a gang: tests, which lanes part and meet, fuel.
//!
//! Invariant: an instruction that leaves no lane active jumps to where lanes wait, so code always runs for somebody.

use fearless_simd::Simd;

use super::compare;
use super::gang::{Gang, Stop};
use super::mask::Mask;
use super::memory::SharedWord;
use crate::code::{Inst, Slot, Test};
use crate::semantics;

impl<S: Simd, W: SharedWord> Gang<'_, S, W> {
    /// Whether a test on scalars passes.
    #[inline(always)]
    pub(super) fn holds(&self, test: Test) -> bool {
        semantics::compare(test.op, self.scalar(test.a), self.scalar(test.b))
    }

    /// Pays for a back-edge.
    #[inline(always)]
    pub(super) fn burn(&mut self, site: u32) -> Result<(), Stop> {
        self.fuel = self.fuel.checked_sub(1).ok_or(Stop::OutOfFuel { site })?;
        Ok(())
    }

    fn passing(&self, test: Test) -> Mask {
        compare::passing(self.s, &self.rows, &self.exec, test)
    }

    /// Lanes leave the constructs whose slots begin at `from`.
    fn leave(&mut self, lanes: Mask, from: Slot) {
        for slot in &mut self.slots[from as usize..] {
            *slot = slot.and_not(lanes);
        }
        self.activate(self.exec.mask.and_not(lanes));
    }

    /// Lanes that fail leave a loop; whether any is left.
    pub(super) fn again(&mut self, test: Test, from: Slot) -> bool {
        let staying = self.passing(test);
        if staying != self.exec.mask {
            self.leave(self.exec.mask.and_not(staying), from);
        }
        !staying.is_empty()
    }

    /// Changes the active lanes; where to go when none is left for what follows.
    pub(super) fn part(&mut self, inst: Inst) -> Option<usize> {
        let to = match inst {
            Inst::If { test, slot, to } => {
                let lanes = self.passing(test);
                if lanes.is_empty() {
                    return Some(to as usize);
                }
                self.slots[slot as usize] = self.exec.mask;
                self.activate(lanes);
                return None;
            }
            Inst::Split { test, slot, to } => {
                let lanes = self.passing(test);
                self.slots[slot as usize] = self.exec.mask;
                self.slots[slot as usize + 1] = self.exec.mask.and_not(lanes);
                if lanes.is_empty() {
                    return Some(to as usize);
                }
                self.activate(lanes);
                return None;
            }
            Inst::Else { slot, to } => {
                self.activate(self.slots[slot as usize + 1]);
                to
            }
            Inst::Restore { slot, to } => {
                self.activate(self.slots[slot as usize]);
                to
            }
            Inst::Save { slot } => {
                self.slots[slot as usize] = self.exec.mask;
                return None;
            }
            Inst::Leave { from, to } => {
                self.leave(self.exec.mask, from);
                to
            }
            Inst::Exit { test, from, to } => {
                let lanes = self.passing(test);
                if lanes.is_empty() {
                    return None;
                }
                self.leave(lanes, from);
                to
            }
            _ => return None,
        };
        self.exec.mask.is_empty().then_some(to as usize)
    }
}

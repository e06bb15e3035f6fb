//! Control flow to jumps where it is uniform, to masks where lanes part.
//!
//! Lanes that part from others wait: those that fail an If at its end, those that leave a loop or region behind it. The
//! waiting lanes of a construct stand in its *slot*. Slots are a stack, so lanes that leave a construct leave all slots
//! above its own, and one instruction says so. Code that may be left without a lane jumps to the *skip* label of the
//! innermost construct where lanes part: there some may wait.

use super::{Emitter, Label};
use crate::code::{Compare, Inst, Slot, Test};
use crate::lower::regs::Virtual;
use crate::lower::tree::{Block, Construct, Op, Site, Stmt, Val};

/// Most statements before the test of a loop that are emitted twice: before the loop and at its end.
const HEADER: usize = 8;

/// A construct around the code being emitted.
#[derive(Clone, Copy)]
pub(super) enum Open {
    /// An If whose lanes part.
    If { skip: Label },
    /// `inside` is the first slot above those of the lanes that wait behind the loop; `None` where lanes do not part.
    Loop { id: Construct, inside: Option<usize>, next: Label, exit: Label, skip: Label },
    /// `inside` as above.
    Region { id: Construct, inside: Option<usize>, exit: Label },
}

impl Open {
    /// The whole program.
    pub(super) fn program(end: Label) -> Self {
        Open::Region { id: Construct(u32::MAX), inside: None, exit: end }
    }

    /// Where lanes wait that have nothing to do here.
    fn skip(self) -> Option<Label> {
        match self {
            Open::If { skip } | Open::Loop { inside: Some(_), skip, .. } => Some(skip),
            Open::Region { id, inside, exit } => (inside.is_some() || id == Construct(u32::MAX)).then_some(exit),
            Open::Loop { .. } => None,
        }
    }
}

/// How all active lanes go to the end, or to the continuing block, of a construct.
#[derive(Clone, Copy)]
enum Way {
    Jump(Label),
    /// They leave the slots from `from` on, and the code goes on where others wait.
    Leave {
        from: usize,
        to: Label,
    },
}

impl Emitter<'_> {
    fn slot(&mut self) -> Slot {
        self.slots += 1;
        self.out.slots = self.out.slots.max(self.slots);
        (self.slots - 1) as Slot
    }

    fn skip(&self) -> Label {
        let skip = self.open.iter().rev().find_map(|open| open.skip());
        skip.expect("the whole program is a region")
    }

    fn test(&mut self, cond: Val) -> Test<Virtual> {
        if let Op::Bin(op, a, b) = self.tree.op(cond)
            && let Some(op) = op.comparison()
            && self.flow.is_fused(cond)
        {
            return Test { op, a: self.place(a), b: self.place(b) };
        }
        Test { op: Compare::Ne, a: self.place(cond), b: self.word(0) }
    }

    pub(super) fn branch(&mut self, id: Construct, cond: Val, accept: &Block, reject: &Block) {
        let varying = self.flow.constructs[id.0 as usize].varying;
        let test = self.test(cond);
        if self.exit(accept, test, varying) {
            self.pass(accept);
            self.child(reject);
        } else if self.exit(reject, test.negated(), varying) {
            self.child(accept);
            self.pass(reject);
        } else if !varying {
            self.uniform(test, accept, reject);
        } else if accept.is_empty() || reject.is_empty() {
            self.part(if accept.is_empty() { test.negated() } else { test }, accept, reject);
        } else {
            self.split(test, accept, reject);
        }
    }

    fn uniform(&mut self, test: Test<Virtual>, accept: &Block, reject: &Block) {
        let (other, end) = (self.label(), self.label());
        if accept.is_empty() {
            self.push(Inst::JumpIf { test, to: end as u32 });
        } else {
            self.push(Inst::JumpIf { test: test.negated(), to: other as u32 });
        }
        self.child(accept);
        if !accept.is_empty() && !reject.is_empty() {
            self.push(Inst::Jump { to: end as u32 });
        }
        self.bind(other);
        self.child(reject);
        self.bind(end);
    }

    /// A branch that the lanes that pass take; the others wait.
    fn part(&mut self, test: Test<Virtual>, accept: &Block, reject: &Block) {
        let skip = self.skip();
        let slot = self.slot();
        let (meet, end) = (self.label(), self.label());
        self.push(Inst::If { test, slot, to: end as u32 });
        self.open.push(Open::If { skip: meet });
        self.child(accept);
        self.child(reject);
        self.open.pop();
        self.bind(meet);
        self.push(Inst::Restore { slot, to: skip as u32 });
        self.bind(end);
        self.slots -= 1;
    }

    fn split(&mut self, test: Test<Virtual>, accept: &Block, reject: &Block) {
        let skip = self.skip();
        let slot = self.slot();
        self.slot();
        let (other, rejected, meet) = (self.label(), self.label(), self.label());
        self.push(Inst::Split { test, slot, to: rejected as u32 });
        self.open.push(Open::If { skip: other });
        self.child(accept);
        self.open.pop();
        self.bind(other);
        self.push(Inst::Else { slot, to: meet as u32 });
        self.bind(rejected);
        self.open.push(Open::If { skip: meet });
        self.child(reject);
        self.open.pop();
        self.bind(meet);
        self.push(Inst::Restore { slot, to: skip as u32 });
        self.slots -= 2;
    }

    /// Makes a branch that does nothing but leave a jump or an exit of the lanes that pass.
    fn exit(&mut self, arm: &Block, test: Test<Virtual>, varying: bool) -> bool {
        let way = match arm[..] {
            [Stmt::Break(target)] => self.way(target, false),
            [Stmt::Continue(target)] => self.way(target, true),
            _ => return false,
        };
        match way {
            Way::Jump(to) if !varying => self.push(Inst::JumpIf { test, to: to as u32 }),
            Way::Leave { from, to } if varying => self.push(Inst::Exit { test, from: from as Slot, to: to as u32 }),
            _ => return false,
        }
        true
    }

    pub(super) fn repeat(
        &mut self,
        id: Construct,
        body: &Block,
        continuing: &Block,
        break_if: Option<Val>,
        site: Site,
    ) {
        let info = self.flow.constructs[id.0 as usize];
        let outer_skip = self.skip();
        let (next, exit) = (self.label(), self.label());
        let slots = self.slots;
        let outer = info.divergent().then(|| self.slot());
        let inside = outer.map(|slot| slot as usize + 1);
        // Only lanes that continue wait inside the loop.
        let live = (outer.is_some() && info.continues).then(|| self.slot());
        for slot in outer.into_iter().chain(live) {
            self.push(Inst::Save { slot });
        }
        let skip = if live.is_some() { next } else { exit };
        self.open.push(Open::Loop { id, inside, next, exit, skip });
        let header = if break_if.is_none() { self.header(id, body) } else { 0 };
        if header == 0 && self.out.insts.len() as u32 == self.block_starts[self.block] {
            // A lifetime that begins with the block must begin before the loop.
            let to = self.label();
            self.push(Inst::Jump { to: to as u32 });
            self.bind(to);
        }
        let first = self.out.insts.len();
        let at_body = self.next_block;
        self.body(body, header);
        let head = self.block_starts[at_body];
        self.bind(next);
        if let Some(slot) = live {
            self.push(Inst::Restore { slot, to: exit as u32 });
        }
        self.open.pop();
        self.open.push(Open::Loop { id, inside, next, exit, skip: exit });
        self.child(continuing);
        self.at += 1;
        self.open.pop();
        let test = break_if.map(|cond| (self.test(cond).negated(), !self.flow.is_uniform(cond)));
        let test = test.or_else(|| self.again(first, head as usize));
        let to = self.label();
        self.labels[to] = head;
        let to = to as u32;
        self.push(match test {
            None => Inst::Back { to, site },
            Some((test, true)) => Inst::Again { test, from: inside.unwrap_or(self.slots) as Slot, to, site },
            Some((test, false)) => Inst::BackIf { test, to, site },
        });
        self.bind(exit);
        self.out.loops.push((head, self.out.insts.len() as u32));
        if let Some(slot) = outer {
            self.push(Inst::Restore { slot, to: outer_skip as u32 });
        }
        self.slots = slots;
    }

    /// How many statements come up to the test that begins a loop's rounds, where that can stand at their end:
    /// computing and nothing else, then `if … { break }`. 0 where that is not so.
    fn header(&self, id: Construct, body: &Block) -> usize {
        let is_plain = |stmt: &Stmt| matches!(stmt, Stmt::Def(_) | Stmt::Tally(_));
        let plain = body.iter().take_while(|stmt| is_plain(stmt)).count();
        let leaves = |arm: &Block| matches!(arm[..], [Stmt::Break(target)] if target == id);
        match body.get(plain) {
            Some(Stmt::If { id: test, accept, reject, .. })
                if plain <= HEADER
                    && (leaves(accept) && reject.is_empty() || accept.is_empty() && leaves(reject))
                    && self.flow.constructs[test.0 as usize].varying
                        == self.flow.constructs[id.0 as usize].divergent() =>
            {
                plain + 1
            }
            _ => 0,
        }
    }

    /// Emits a loop's header, which stands from `first` up to `head`, once more; the test for another round, and
    /// whether lanes part at it.
    fn again(&mut self, first: usize, head: usize) -> Option<(Test<Virtual>, bool)> {
        let (last, plain) = self.out.insts[first..head].split_last()?;
        let test = match *last {
            Inst::JumpIf { test, .. } => (test.negated(), false),
            Inst::Exit { test, .. } => (test.negated(), true),
            _ => return None,
        };
        let plain = plain.to_vec();
        self.out.insts.extend(plain);
        Some(test)
    }

    pub(super) fn region(&mut self, id: Construct, body: &Block) {
        let outer_skip = self.skip();
        let exit = self.label();
        let slot = self.flow.constructs[id.0 as usize].leaves.then(|| self.slot());
        if let Some(slot) = slot {
            self.push(Inst::Save { slot });
        }
        self.open.push(Open::Region { id, inside: slot.map(|slot| slot as usize + 1), exit });
        self.child(body);
        self.open.pop();
        self.bind(exit);
        if let Some(slot) = slot {
            self.push(Inst::Restore { slot, to: outer_skip as u32 });
            self.slots -= 1;
        }
    }

    /// All active lanes go to the end, or to the continuing block, of a construct.
    pub(super) fn leave(&mut self, target: Construct, is_continue: bool) {
        self.push(match self.way(target, is_continue) {
            Way::Jump(to) => Inst::Jump { to: to as u32 },
            Way::Leave { from, to } => Inst::Leave { from: from as Slot, to: to as u32 },
        });
    }

    fn way(&self, target: Construct, is_continue: bool) -> Way {
        let mut wait = None;
        for open in self.open.iter().rev() {
            wait = wait.or(open.skip());
            let (inside, end) = match *open {
                // Who continues stays in the slot of those who wait inside the loop.
                Open::Loop { id, inside, next, exit, .. } if id == target => {
                    (inside.map(|slot| slot + usize::from(is_continue)), if is_continue { next } else { exit })
                }
                Open::Region { id, inside, exit } if id == target => (inside, exit),
                _ => continue,
            };
            return match (inside, wait) {
                (Some(from), Some(to)) => Way::Leave { from, to },
                _ => Way::Jump(end),
            };
        }
        unreachable!("what is left is open")
    }
}

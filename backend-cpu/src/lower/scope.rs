//! Blocks while they are built: which values can be used again, what variables are known to hold, and the limits.
//!
//! Invariant: a value is used again only where it is visible, and a variable is known only where every way to the place
//! has set it so.

use std::collections::HashMap;

use super::build::{Builder, Fail};
use super::tree::{Block, Op, Stmt, Val, Var};

/// What a block knows of variables.
#[derive(Default)]
pub(super) struct Known {
    /// `None` where the value of an outer block does not hold any more.
    values: HashMap<Var, Option<Val>>,
    /// Whether outer blocks tell nothing.
    opaque: bool,
}

impl Builder<'_> {
    /// Builds a block of its own; variables it sets are not known afterwards.
    pub(super) fn nested(&mut self, f: impl FnOnce(&mut Self) -> Result<(), Fail>) -> Result<Block, Fail> {
        self.enter()?;
        let outer = std::mem::take(&mut self.block);
        let mark = self.sets.len();
        self.scopes.push(HashMap::new());
        self.known.push(Known::default());
        let result = f(self);
        self.flush();
        self.scopes.pop();
        self.known.pop();
        for index in mark..self.sets.len() {
            self.learn(self.sets[index], None);
        }
        result?;
        Ok(std::mem::replace(&mut self.block, outer))
    }

    /// Builds into the open block, and takes all of it back unless `f` says that it stands.
    pub(super) fn attempt(&mut self, f: impl FnOnce(&mut Self) -> Result<bool, Fail>) -> Result<bool, Fail> {
        let (statements, sets, pending) = (self.block.len(), self.sets.len(), self.pending);
        self.known.push(Known::default());
        self.scopes.push(HashMap::new());
        let stands = f(self);
        let (known, numbered) = (self.known.pop(), self.scopes.pop());
        if !stands? {
            self.block.truncate(statements);
            self.sets.truncate(sets);
            self.pending = pending;
            return Ok(false);
        }
        known.into_iter().flat_map(|known| known.values).for_each(|(var, val)| self.learn(var, val));
        if let Some(scope) = self.scopes.last_mut() {
            scope.extend(numbered.into_iter().flatten());
        }
        Ok(true)
    }

    /// Whether one more block or call stands within the limit of nesting.
    pub(super) fn enter(&self) -> Result<(), Fail> {
        let limit = self.options.limits.depth;
        if self.scopes.len() + self.frames.len() > limit as usize {
            return Err(Fail::limit("levels of control flow and calls after inlining", limit));
        }
        Ok(())
    }

    /// Forgets what variables hold: the head of a loop can be reached from its end.
    pub(super) fn forget(&mut self) {
        if let Some(known) = self.known.last_mut() {
            *known = Known { values: HashMap::new(), opaque: true };
        }
    }

    /// What the open block knows of a variable from here on.
    pub(super) fn learn(&mut self, var: Var, val: Option<Val>) {
        if let Some(known) = self.known.last_mut() {
            known.values.insert(var, val);
        }
    }

    /// The value that a variable is known to hold.
    fn known(&self, var: Var) -> Option<Val> {
        for known in self.known.iter().rev() {
            if let Some(val) = known.values.get(&var) {
                return *val;
            }
            if known.opaque {
                return None;
            }
        }
        None
    }

    /// Accounts for `words` operations that are about to be built.
    pub(super) fn spend(&mut self, words: u32) -> Result<(), Fail> {
        self.spent += u64::from(words);
        let limit = self.options.limits.operations;
        if self.spent > u64::from(limit) {
            return Err(Fail::limit("operations after inlining and splitting into words", limit));
        }
        Ok(())
    }

    /// Forgets the values that the innermost block has numbered, until [`Builder::show_numbered`].
    pub(super) fn hide_numbered(&mut self) -> HashMap<Op, Val> {
        self.scopes.last_mut().map(std::mem::take).unwrap_or_default()
    }

    pub(super) fn show_numbered(&mut self, numbered: HashMap<Op, Val>) {
        if let Some(scope) = self.scopes.last_mut() {
            *scope = numbered;
        }
    }

    pub(super) fn get(&mut self, var: Var) -> Val {
        if let Some(val) = self.known(var) {
            return val;
        }
        let val = self.define(Op::Get(var));
        self.learn(var, Some(val));
        val
    }

    pub(super) fn set(&mut self, var: Var, val: Val) {
        if self.known(var) == Some(val) {
            return;
        }
        self.push(Stmt::Set(var, val));
        self.learn(var, Some(val));
        self.sets.push(var);
    }
}

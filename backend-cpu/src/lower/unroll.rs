//! Short loops whose rounds are known when they are built: their statements once a round.
//!
//! The builder knows which constants variables hold. Where that decides a loop's own test in every round, the loop is a
//! sequence: its counter folds away, and so does what is computed from it. Where it does not, what the attempt built is
//! taken back, and the loop is built as one.

use naga::{Block, Statement};

use super::build::{Builder, Fail};
use super::scan::{for_each_block, straight_loop};

/// Most rounds of a loop that becomes a sequence.
const ROUNDS: usize = 64;

/// Most values that all rounds but the last may define.
const VALUES: usize = 256;

impl<'m> Builder<'m> {
    /// Builds a loop as a sequence; false, and nothing is built, where it must stay a loop.
    pub(super) fn unroll(&mut self, body: &'m Block, continuing: &'m Block) -> Result<bool, Fail> {
        let Some(header) = straight_loop(body, continuing) else { return Ok(false) };
        let stands = self.attempt(|b| b.rounds(body, header, continuing));
        self.unevaluate(body);
        self.unevaluate(continuing);
        stands
    }

    /// Builds round after round, as long as the test is a constant; whether it ended the loop.
    fn rounds(&mut self, body: &'m Block, header: usize, continuing: &'m Block) -> Result<bool, Fail> {
        let Statement::If { condition, .. } = &body[header] else { return Ok(false) };
        let first = self.tree.vals.len();
        for _ in 0..=ROUNDS {
            self.unevaluate(body);
            self.unevaluate(continuing);
            self.count_turn();
            self.statements(body, 0..header)?;
            let test = self.word(*condition)?;
            match self.tree.constant(test) {
                Some(0) => return Ok(true),
                Some(_) if self.tree.vals.len() - first <= VALUES => {}
                _ => return Ok(false),
            }
            self.statements(body, header + 1..body.len())?;
            self.block(continuing)?;
        }
        Ok(false)
    }

    /// Forgets the values of a block's expressions: another round evaluates them anew.
    fn unevaluate(&mut self, block: &Block) {
        for statement in block {
            if let Statement::Emit(range) = statement {
                let values = &mut self.frame_mut().values;
                range.clone().for_each(|handle| values[handle.index()] = None);
            }
            for_each_block(statement, &mut |inner| self.unevaluate(inner));
        }
    }
}

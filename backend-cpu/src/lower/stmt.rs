//! Statements: control flow to constructs, calls inlined, effects in order.

use std::ops::Range;

use naga::{AtomicFunction, Block, Expression, Handle, ScalarKind, Statement, SwitchValue, TypeInner};

use super::build::{Builder, Fail, Target, Value};
use super::place::Root;
use super::scan::breaks_early;
use super::tree::{Atomic, Op, Stmt, Val};
use crate::code::{AtomicOp, BinOp, Mem};

impl<'m> Builder<'m> {
    /// Builds the statements of a block into the block that is open.
    pub(super) fn block(&mut self, block: &'m Block) -> Result<(), Fail> {
        self.statements(block, 0..block.len())
    }

    pub(super) fn statements(&mut self, block: &'m Block, range: Range<usize>) -> Result<(), Fail> {
        for (statement, span) in block.span_iter().take(range.end).skip(range.start) {
            self.spend(1).map_err(|e| e.at(*span))?;
            self.statement(statement, *span).map_err(|e| e.at(*span))?;
            if matches!(statement, Statement::Return { .. } | Statement::Break | Statement::Continue) {
                break;
            }
        }
        Ok(())
    }

    fn statement(&mut self, statement: &'m Statement, span: naga::Span) -> Result<(), Fail> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    self.value(handle)?;
                }
            }
            Statement::Block(block) => self.block(block)?,
            Statement::If { condition, accept, reject } => {
                let cond = self.word(*condition)?;
                if let Some(word) = self.tree.constant(cond) {
                    return self.block(if word != 0 { accept } else { reject });
                }
                self.flush();
                let id = self.construct();
                let accept = self.nested(|b| b.block(accept))?;
                let reject = self.nested(|b| b.block(reject))?;
                self.push(Stmt::If { id, cond, accept, reject });
            }
            Statement::Switch { selector, cases } => self.switch(*selector, cases)?,
            Statement::Loop { body, continuing, break_if } => self.repeat(body, continuing, *break_if, span)?,
            Statement::Break => {
                self.flush();
                match self.targets.last() {
                    Some(Target::Loop(id) | Target::Switch(id)) => self.push(Stmt::Break(*id)),
                    None => return Err(Fail::unsupported("a break outside a loop", Some(span))),
                }
            }
            Statement::Continue => {
                self.flush();
                let target = self.targets.iter().rev().find_map(|t| match t {
                    Target::Loop(id) => Some(*id),
                    Target::Switch(_) => None,
                });
                let id = target.ok_or_else(|| Fail::unsupported("a continue outside a loop", Some(span)))?;
                self.push(Stmt::Continue(id));
            }
            Statement::Return { value } => self.leave(*value)?,
            Statement::ControlBarrier(_) => self.barrier(span),
            Statement::MemoryBarrier(_) => {}
            Statement::Store { pointer, value } => {
                let values = self.words(*value)?;
                let place = self.place(*pointer)?;
                self.store(&place, &values, span)?;
            }
            Statement::Atomic { pointer, fun, value, result } => self.atomic(*pointer, fun, *value, *result, span)?,
            Statement::WorkGroupUniformLoad { pointer, result } => {
                let place = self.place(*pointer)?;
                self.barrier(span);
                let words = self.load(&place, span)?;
                self.barrier(span);
                self.frame_mut().values[result.index()] = Some(Value::Words(words.into()));
            }
            Statement::Call { function, arguments, result } => self.call(*function, arguments, *result)?,
            Statement::Kill => return Err(Fail::unsupported("discard", Some(span))),
            other => {
                let name = format!("{other:?}");
                let name = name.split([' ', '(', '{']).next().unwrap_or("this").to_owned();
                return Err(Fail::unsupported(format!("the statement {name}"), Some(span)));
            }
        }
        Ok(())
    }

    fn barrier(&mut self, span: naga::Span) {
        self.count_barrier();
        self.flush();
        self.tree.has_barrier = true;
        let site = self.site(span);
        self.push(Stmt::Barrier(site));
    }

    fn leave(&mut self, value: Option<Handle<Expression>>) -> Result<(), Fail> {
        let words = match value {
            Some(value) => Some(self.words(value)?),
            None => None,
        };
        let Some((id, vars)) = self.frame_mut().exit.clone() else {
            self.frame_mut().result = words;
            return Ok(());
        };
        for (var, &word) in vars.into_iter().zip(words.iter().flat_map(|w| w.iter())) {
            self.set(var, word);
        }
        self.flush();
        self.push(Stmt::Break(id));
        Ok(())
    }

    fn call(
        &mut self,
        function: Handle<naga::Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
    ) -> Result<(), Fail> {
        let mut values = Vec::with_capacity(arguments.len());
        for argument in arguments {
            values.push(self.value(*argument)?);
        }
        let callee = &self.module.functions[function];
        let frame = self.frame(callee, &self.info[function], values, result.is_some())?;
        // A callee's own loops and switches hide the caller's.
        let targets = std::mem::take(&mut self.targets);
        let words = self.inline(frame);
        self.targets = targets;
        if let (Some(result), Some(words)) = (result, words?) {
            self.frame_mut().values[result.index()] = Some(Value::Words(words));
        }
        Ok(())
    }

    fn repeat(
        &mut self,
        body: &'m Block,
        continuing: &'m Block,
        break_if: Option<Handle<Expression>>,
        span: naga::Span,
    ) -> Result<(), Fail> {
        if break_if.is_none() && self.unroll(body, continuing)? {
            return Ok(());
        }
        self.flush();
        let site = self.site(span);
        let id = self.construct();
        self.targets.push(Target::Loop(id));
        let mut tail = Vec::new();
        let mut test = None;
        let body = self.nested(|b| {
            b.forget();
            b.count_turn();
            b.block(body)?;
            b.flush();
            // `continue` skips statements: neither what variables hold nor what the body numbered is known here. What
            // the text itself uses again is in scope, as WGSL forbids a `continue` in between.
            let numbered = b.hide_numbered();
            tail = b.nested(|b| {
                b.forget();
                b.block(continuing)?;
                test = break_if.map(|test| b.word(test)).transpose()?;
                Ok(())
            })?;
            b.show_numbered(numbered);
            Ok(())
        });
        self.targets.pop();
        self.push(Stmt::Loop { id, body: body?, continuing: tail, break_if: test, site });
        Ok(())
    }

    fn switch(&mut self, selector: Handle<Expression>, cases: &'m [naga::SwitchCase]) -> Result<(), Fail> {
        let selector = self.word(selector)?;
        self.flush();
        let mut groups: Vec<(Vec<SwitchValue>, &'m Block, usize)> = Vec::new();
        let mut values = Vec::new();
        for case in cases {
            values.push(case.value);
            if case.fall_through {
                if !case.body.is_empty() {
                    return Err(Fail::unsupported("a switch case that falls through", None));
                }
                continue;
            }
            let count = case.body.len() - usize::from(matches!(case.body.last(), Some(Statement::Break)));
            groups.push((std::mem::take(&mut values), &case.body, count));
        }
        let region = groups.iter().any(|(_, body, count)| breaks_early(&body[..*count]));
        let id = self.construct();
        self.targets.push(Target::Switch(id));
        let result = if region {
            self.nested(|b| b.chain(selector, &groups)).map(|body| self.push(Stmt::Region { id, body }))
        } else {
            self.chain(selector, &groups)
        };
        self.targets.pop();
        result
    }

    /// The cases of a switch as nested Ifs, the default innermost.
    fn chain(&mut self, selector: Val, groups: &[(Vec<SwitchValue>, &'m Block, usize)]) -> Result<(), Fail> {
        let is_default = |values: &[SwitchValue]| values.contains(&SwitchValue::Default);
        let Some(index) = groups.iter().position(|(values, ..)| !is_default(values)) else {
            return match groups.first() {
                Some((_, body, count)) => self.statements(body, 0..*count),
                None => Ok(()),
            };
        };
        let (values, body, count) = &groups[index];
        let mut cond = self.constant(0);
        for value in values {
            let word = match value {
                SwitchValue::I32(value) => *value as u32,
                SwitchValue::U32(value) => *value,
                SwitchValue::Default => continue,
            };
            let word = self.constant(word);
            let equal = self.bin(BinOp::Eq, selector, word);
            cond = self.bin(BinOp::Or, cond, equal);
        }
        let rest: Vec<_> = groups.iter().enumerate().filter(|(i, _)| *i != index).map(|(_, g)| g.clone()).collect();
        let id = self.construct();
        let accept = self.nested(|b| b.statements(body, 0..*count))?;
        let reject = self.nested(|b| b.chain(selector, &rest))?;
        self.push(Stmt::If { id, cond, accept, reject });
        Ok(())
    }

    fn atomic(
        &mut self,
        pointer: Handle<Expression>,
        fun: &AtomicFunction,
        value: Handle<Expression>,
        result: Option<Handle<Expression>>,
        span: naga::Span,
    ) -> Result<(), Fail> {
        let place = self.place(pointer)?;
        let signed = matches!(place.ty, TypeInner::Atomic(scalar) if scalar.kind == ScalarKind::Sint);
        if matches!(place.ty, TypeInner::Atomic(scalar) if scalar.kind == ScalarKind::Float) {
            return Err(Fail::unsupported("an atomic f32", Some(span)));
        }
        let op = match fun {
            AtomicFunction::Add => AtomicOp::Add,
            AtomicFunction::Subtract => AtomicOp::Sub,
            AtomicFunction::And => AtomicOp::And,
            AtomicFunction::InclusiveOr => AtomicOp::Or,
            AtomicFunction::ExclusiveOr => AtomicOp::Xor,
            AtomicFunction::Min if signed => AtomicOp::MinI,
            AtomicFunction::Max if signed => AtomicOp::MaxI,
            AtomicFunction::Min => AtomicOp::MinU,
            AtomicFunction::Max => AtomicOp::MaxU,
            AtomicFunction::Exchange { compare: None } => AtomicOp::Exchange,
            AtomicFunction::Exchange { compare: Some(_) } => AtomicOp::CompareExchange,
        };
        let value = self.word(value)?;
        let compare = match fun {
            AtomicFunction::Exchange { compare: Some(compare) } => Some(self.word(*compare)?),
            _ => None,
        };
        debug_assert!(matches!(place.root, Root::Mem(..)), "atomics live in storage or workgroup memory");
        let Some((mem, addr, base)) = self.address(&place) else {
            return Err(Fail::unsupported("an atomic outside storage and workgroup memory", Some(span)));
        };
        debug_assert!(mem != Mem::Private);
        self.count_atomic();
        let old = result.map(|_| self.define(Op::Atomic));
        let site = self.site(span);
        let offset = base + place.offset;
        self.push(Stmt::Atomic(Atomic { op, mem, addr, offset, value, compare, result: old, site }));
        if let (Some(result), Some(old)) = (result, old) {
            let mut words = vec![old];
            if let Some(compare) = compare {
                words.push(self.bin(BinOp::Eq, old, compare));
            }
            self.frame_mut().values[result.index()] = Some(Value::Words(words.into()));
        }
        Ok(())
    }
}

//! Statements: one invocation walks a function's body and calls.

use std::cell::{Cell, RefCell};
use std::future::{Future, poll_fn};
use std::pin::Pin;
use std::task::Poll;

use naga::{AtomicFunction, Block, Expression, Function, Handle, Module, Span, Statement, SwitchCase, SwitchValue};
use sightlines_backend::{Counts, Result, Trap, TrapKind};

use super::memory::{self, Pointer, Root, Shape, Slot};
use super::unsupported;
use super::value::Value;

/// Loop iterations that one dispatch may take.
const FUEL: u64 = 1 << 20;

/// Memory and counters that the invocations of a dispatch share.
pub(crate) struct Shared<'a> {
    pub module: &'a Module,
    pub slots: Vec<Slot<'a>>,
    /// For each global variable, where it begins.
    pub globals: Vec<Option<Pointer>>,
    pub workgroup: RefCell<Vec<u32>>,
    pub counts: Cell<Counts>,
    pub fuel: Cell<u64>,
}

/// Where an invocation stands in the grid.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub local: [u32; 3],
    pub group: [u32; 3],
    pub groups: [u32; 3],
    pub size: [u32; 3],
}

/// One invocation.
pub(crate) struct Invocation<'a> {
    pub shared: &'a Shared<'a>,
    pub place: Place,
    pub private: RefCell<Vec<u32>>,
    /// Local variables of all active calls.
    pub stack: RefCell<Vec<u32>>,
    /// The barrier it waits at.
    pub waiting: Cell<Option<Span>>,
}

/// One active call.
pub(crate) struct Frame<'a> {
    pub function: &'a Function,
    pub arguments: Vec<Value>,
    /// First word of each local variable in the stack.
    pub locals: Vec<usize>,
    /// Values of emitted expressions and of results.
    pub values: RefCell<Vec<Option<Value>>>,
}

/// How a block ended.
enum Flow {
    Next,
    Break,
    Continue,
    Return(Option<Value>),
}

type Walk<'w, T> = Pin<Box<dyn Future<Output = Result<T>> + 'w>>;

impl<'a> Invocation<'a> {
    /// Runs a function to its end.
    pub(crate) fn call(&self, function: &'a Function, arguments: Vec<Value>) -> Walk<'_, Option<Value>> {
        Box::pin(async move {
            let base = self.stack.borrow().len();
            let frame = self.enter(function, arguments)?;
            let flow = self.block(&frame, &function.body).await?;
            self.stack.borrow_mut().truncate(base);
            Ok(if let Flow::Return(value) = flow { value } else { None })
        })
    }

    /// A frame with its local variables initialised.
    fn enter(&self, function: &'a Function, arguments: Vec<Value>) -> Result<Frame<'a>> {
        let module = self.shared.module;
        let values = RefCell::new(vec![None; function.expressions.len()]);
        let mut frame = Frame { function, arguments, locals: Vec::new(), values };
        for (_, local) in function.local_variables.iter() {
            let shape = Shape::Type(local.ty);
            let word = self.stack.borrow().len();
            let value = match local.init {
                Some(init) => self.evaluate(&frame, init)?,
                None => memory::zero(module, shape)?,
            };
            let mut stack = self.stack.borrow_mut();
            stack.resize(word + memory::size(module, shape, false)?, 0);
            memory::encode(module, shape, &value, &mut stack, word, false)?;
            frame.locals.push(word);
        }
        Ok(frame)
    }

    fn block<'w>(&'w self, frame: &'w Frame<'a>, block: &'a Block) -> Walk<'w, Flow> {
        Box::pin(async move {
            for (statement, &span) in block.span_iter() {
                match self.statement(frame, statement, span).await? {
                    Flow::Next => {}
                    leave => return Ok(leave),
                }
            }
            Ok(Flow::Next)
        })
    }

    async fn statement(&self, frame: &Frame<'a>, statement: &'a Statement, span: Span) -> Result<Flow> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    let value = self.compute(frame, handle)?;
                    frame.set(handle, value);
                }
            }
            Statement::Block(block) => return self.block(frame, block).await,
            Statement::If { condition, accept, reject } => {
                let taken = if self.evaluate(frame, *condition)?.bool() { accept } else { reject };
                return self.block(frame, taken).await;
            }
            Statement::Switch { selector, cases } => return self.switch(frame, *selector, cases).await,
            Statement::Loop { body, continuing, break_if } => {
                return self.repeat(frame, body, continuing, *break_if).await;
            }
            Statement::Break => return Ok(Flow::Break),
            Statement::Continue => return Ok(Flow::Continue),
            Statement::Return { value } => {
                return Ok(Flow::Return(value.map(|v| self.evaluate(frame, v)).transpose()?));
            }
            Statement::ControlBarrier(_) | Statement::MemoryBarrier(_) => self.barrier(span).await,
            Statement::Store { pointer, value } => {
                let value = self.evaluate(frame, *value)?;
                self.store(self.evaluate(frame, *pointer)?.pointer(), &value)?;
            }
            Statement::Atomic { pointer, fun, value, result } => {
                self.atomic(frame, *pointer, fun, *value, *result)?;
            }
            Statement::WorkGroupUniformLoad { pointer, result } => {
                self.barrier(span).await;
                let value = self.load(self.evaluate(frame, *pointer)?.pointer())?;
                self.barrier(span).await;
                frame.set(*result, value);
            }
            Statement::Call { function, arguments, result } => {
                let arguments = arguments.iter().map(|&a| self.evaluate(frame, a)).collect::<Result<_>>()?;
                let value = self.call(&self.shared.module.functions[*function], arguments).await?;
                if let (Some(result), Some(value)) = (result, value) {
                    frame.set(*result, value);
                }
            }
            other => return unsupported(format!("statement {other:?}")),
        }
        Ok(Flow::Next)
    }

    async fn switch(&self, frame: &Frame<'a>, selector: Handle<Expression>, cases: &'a [SwitchCase]) -> Result<Flow> {
        let selector = self.evaluate(frame, selector)?;
        let matches = |value: &SwitchValue| match value {
            SwitchValue::I32(x) => selector == Value::I32(*x),
            SwitchValue::U32(x) => selector == Value::U32(*x),
            SwitchValue::Default => false,
        };
        let chosen = cases.iter().position(|c| matches(&c.value));
        let default = || cases.iter().position(|c| c.value == SwitchValue::Default);
        let Some(first) = chosen.or_else(default) else { return Ok(Flow::Next) };
        for case in &cases[first..] {
            match self.block(frame, &case.body).await? {
                Flow::Next if case.fall_through => {}
                Flow::Next | Flow::Break => break,
                leave => return Ok(leave),
            }
        }
        Ok(Flow::Next)
    }

    async fn repeat(
        &self,
        frame: &Frame<'a>,
        body: &'a Block,
        continuing: &'a Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<Flow> {
        loop {
            self.burn()?;
            match self.block(frame, body).await? {
                Flow::Next | Flow::Continue => {}
                Flow::Break => return Ok(Flow::Next),
                leave @ Flow::Return(_) => return Ok(leave),
            }
            self.block(frame, continuing).await?;
            if let Some(condition) = break_if
                && self.evaluate(frame, condition)?.bool()
            {
                return Ok(Flow::Next);
            }
        }
    }

    fn burn(&self) -> Result<()> {
        let used = self.shared.fuel.get();
        if used == FUEL {
            let kind = TrapKind::OutOfFuel { limit: FUEL };
            return Err(sightlines_backend::ErrorKind::Trap(Trap { kind, location: None, invocation: None }).into());
        }
        self.shared.fuel.set(used + 1);
        Ok(())
    }

    /// Suspends the invocation once; the workgroup goes on when all have come here.
    async fn barrier(&self, span: Span) {
        let mut passed = false;
        poll_fn(|_| {
            if std::mem::replace(&mut passed, true) {
                return Poll::Ready(());
            }
            self.waiting.set(Some(span));
            Poll::Pending
        })
        .await;
    }

    fn with_memory<T>(&self, pointer: &Pointer, f: impl FnOnce(&mut [u32], bool) -> T) -> T {
        match pointer.root {
            Root::Slot(slot) => {
                let slot = &self.shared.slots[slot];
                f(&mut slot.memory.borrow_mut()[slot.first..slot.first + slot.words], true)
            }
            Root::Workgroup => f(&mut self.shared.workgroup.borrow_mut(), false),
            Root::Private => f(&mut self.private.borrow_mut(), false),
            Root::Function => f(&mut self.stack.borrow_mut(), false),
        }
    }

    pub(crate) fn load(&self, pointer: &Pointer) -> Result<Value> {
        self.count(pointer, |counts| counts.loads += 1)?;
        let module = self.shared.module;
        self.with_memory(pointer, |words, host| memory::decode(module, pointer.shape, words, pointer.word, host))
    }

    fn store(&self, pointer: &Pointer, value: &Value) -> Result<()> {
        self.count(pointer, |counts| counts.stores += 1)?;
        let module = self.shared.module;
        self.with_memory(pointer, |words, host| memory::encode(module, pointer.shape, value, words, pointer.word, host))
    }

    fn atomic(
        &self,
        frame: &Frame<'a>,
        pointer: Handle<Expression>,
        fun: &AtomicFunction,
        value: Handle<Expression>,
        result: Option<Handle<Expression>>,
    ) -> Result<()> {
        let pointer = self.evaluate(frame, pointer)?;
        let pointer = pointer.pointer();
        let value = self.evaluate(frame, value)?;
        let compare = match fun {
            AtomicFunction::Exchange { compare } => compare.map(|c| self.evaluate(frame, c)).transpose()?,
            _ => None,
        };
        self.count(pointer, |counts| counts.atomics += 1)?;
        let module = self.shared.module;
        let old =
            self.with_memory(pointer, |words, host| memory::decode(module, pointer.shape, words, pointer.word, host))?;
        let exchanged = compare.as_ref().is_none_or(|c| *c == old);
        if exchanged {
            let new = combine(fun, &old, &value);
            self.with_memory(pointer, |words, _| words[pointer.word] = new);
        }
        if let Some(result) = result {
            let value = if compare.is_some() { Value::Composite(vec![old, Value::Bool(exchanged)]) } else { old };
            frame.set(result, value);
        }
        Ok(())
    }

    /// Counts an access to memory that invocations share.
    fn count(&self, pointer: &Pointer, add: impl FnOnce(&mut Counts)) -> Result<()> {
        if matches!(pointer.root, Root::Slot(_) | Root::Workgroup) {
            let mut counts = self.shared.counts.get();
            add(&mut counts);
            counts.bytes += 4 * memory::scalars(self.shared.module, pointer.shape)? as u64;
            self.shared.counts.set(counts);
        }
        Ok(())
    }
}

impl Frame<'_> {
    fn set(&self, handle: Handle<Expression>, value: Value) {
        self.values.borrow_mut()[handle.index()] = Some(value);
    }
}

/// What an atomic operation leaves in memory.
fn combine(fun: &AtomicFunction, old: &Value, value: &Value) -> u32 {
    let signed = matches!(old, Value::I32(_));
    let (x, y) = (old.word(), value.word());
    match fun {
        AtomicFunction::Add => x.wrapping_add(y),
        AtomicFunction::Subtract => x.wrapping_sub(y),
        AtomicFunction::And => x & y,
        AtomicFunction::InclusiveOr => x | y,
        AtomicFunction::ExclusiveOr => x ^ y,
        AtomicFunction::Min if signed => (x as i32).min(y as i32) as u32,
        AtomicFunction::Max if signed => (x as i32).max(y as i32) as u32,
        AtomicFunction::Min => x.min(y),
        AtomicFunction::Max => x.max(y),
        AtomicFunction::Exchange { .. } => y,
    }
}

//! naga IR to [`Tree`]: inlines calls, splits values into words, numbers values, counts semantic costs.
//!
//! Follows the evaluation rules of `naga::ir`: an expression is evaluated when the `Emit` that covers it runs, the
//! results of calls and atomics when their statement runs, everything else (constants, arguments, variables) on use.

use std::collections::HashMap;
use std::rc::Rc;

use naga::{Handle, Span, TypeInner};

use super::place::Place;
use super::scan::Scan;
use super::scope::Known;
use super::tree::{Block, Construct, Cost, Op, Site, Stmt, Tree, Val, Var};
use super::{Options, fold, idiom};
use crate::code::{BinOp, Mem};

/// Why a program cannot be lowered.
#[derive(Debug)]
pub(crate) struct Fail {
    pub(crate) reason: Reason,
    pub(crate) span: Option<Span>,
}

#[derive(Debug)]
pub(crate) enum Reason {
    /// A feature that the interpreter lacks.
    Unsupported(String),
    /// What exceeds a limit of [`CodeLimits`](crate::CodeLimits), and the limit.
    Limit(&'static str, u64),
}

impl Fail {
    pub(super) fn unsupported(feature: impl Into<String>, span: Option<Span>) -> Self {
        Fail { reason: Reason::Unsupported(feature.into()), span }
    }

    pub(super) fn limit(what: &'static str, limit: u32) -> Self {
        Fail { reason: Reason::Limit(what, limit.into()), span: None }
    }

    /// Adds a place, where none is known yet.
    pub(super) fn at(mut self, span: Span) -> Self {
        if span.is_defined() {
            self.span.get_or_insert(span);
        }
        self
    }
}

/// What an expression evaluates to.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Words(Rc<[Val]>),
    Place(Place),
}

/// One inlined call.
pub(super) struct Frame<'m> {
    pub(super) function: &'m naga::Function,
    pub(super) info: &'m naga::valid::FunctionInfo,
    pub(super) values: Vec<Option<Value>>,
    pub(super) locals: Vec<Place>,
    pub(super) arguments: Vec<Value>,
    /// Where early returns go, and the variables of the result.
    pub(super) exit: Option<(Construct, Vec<Var>)>,
    /// The result of a return in last position.
    pub(super) result: Option<Rc<[Val]>>,
}

/// What `break` and `continue` mean here.
#[derive(Clone, Copy)]
pub(super) enum Target {
    Loop(Construct),
    Switch(Construct),
}

pub(crate) struct Builder<'m> {
    pub(super) module: &'m naga::Module,
    pub(super) info: &'m naga::valid::ModuleInfo,
    pub(super) scan: Scan,
    pub(super) tree: Tree,
    pub(super) frames: Vec<Frame<'m>>,
    pub(super) targets: Vec<Target>,
    pub(super) block: Block,
    pub(super) globals: HashMap<Handle<naga::GlobalVariable>, Place>,
    pub(super) readonly: Vec<bool>,
    pub(super) constants: HashMap<u32, Val>,
    /// Pure values that can be used again, innermost block last.
    pub(super) scopes: Vec<HashMap<Op, Val>>,
    /// Values that variables are known to hold, by block, innermost last; and every variable set so far.
    pub(super) known: Vec<Known>,
    pub(super) sets: Vec<Var>,
    pub(super) pending: Cost,
    pub(super) options: Options,
    /// Operations built so far.
    pub(super) spent: u64,
}

impl<'m> Builder<'m> {
    /// Lowers an entry point. `slots` are the (group, binding) pairs of its buffers, in order.
    pub(crate) fn build(
        module: &'m naga::Module,
        info: &'m naga::valid::ModuleInfo,
        entry: usize,
        slots: &[(u32, u32)],
        options: Options,
    ) -> Result<Tree, Fail> {
        let point = &module.entry_points[entry];
        let mut builder = Builder::new(module, info, point.workgroup_size, slots.len(), options);
        builder.place_globals(slots, info.get_entry_point(entry))?;
        let function = &point.function;
        let mut arguments = Vec::new();
        for argument in &function.arguments {
            arguments.push(builder.input(argument)?);
        }
        let frame = builder.frame(function, info.get_entry_point(entry), arguments, point.function.result.is_some())?;
        builder.inline(frame)?;
        builder.flush();
        builder.tree.body = std::mem::take(&mut builder.block);
        Ok(builder.tree)
    }

    /// A builder of nothing yet, for an entry point with so many buffers.
    pub(super) fn new(
        module: &'m naga::Module,
        info: &'m naga::valid::ModuleInfo,
        workgroup_size: [u32; 3],
        buffers: usize,
        options: Options,
    ) -> Self {
        Builder {
            module,
            info,
            scan: Scan::new(module),
            tree: Tree { workgroup_size, ..Tree::default() },
            frames: Vec::new(),
            targets: Vec::new(),
            block: Vec::new(),
            globals: HashMap::new(),
            readonly: vec![false; buffers],
            constants: HashMap::new(),
            scopes: vec![HashMap::new()],
            known: vec![Known::default()],
            sets: Vec::new(),
            pending: Cost::default(),
            options,
            spent: 0,
        }
    }

    pub(super) fn inner(&self, ty: Handle<naga::Type>) -> &'m TypeInner {
        &self.module.types[ty].inner
    }

    /// Prepares an inlined call: rooms for its variables, and an exit where it returns early.
    pub(super) fn frame(
        &mut self,
        function: &'m naga::Function,
        info: &'m naga::valid::FunctionInfo,
        arguments: Vec<Value>,
        has_result: bool,
    ) -> Result<Frame<'m>, Fail> {
        self.enter()?;
        // A call takes time for its expressions even where it returns before them.
        self.spend(function.expressions.len() as u32 / 16)?;
        let mut frame = Frame {
            function,
            info,
            values: vec![None; function.expressions.len()],
            locals: Vec::new(),
            arguments,
            exit: None,
            result: None,
        };
        let dynamic = self.scan.dynamic_locals(function);
        for (handle, local) in function.local_variables.iter() {
            let span = function.local_variables.get_span(handle);
            let ty = self.inner(local.ty).clone();
            let count = self.flat(&ty).map_err(|e| e.at(span))?;
            self.room(count, dynamic.contains(&handle), local.init.is_some()).map_err(|e| e.at(span))?;
            let init = match local.init {
                Some(init) => self.constant_words(&function.expressions, init).map_err(|e| e.at(span))?,
                None => vec![0; count as usize],
            };
            let root = self.private(dynamic.contains(&handle), count, &init, span);
            frame.locals.push(Place { root, ty, dynamic: None, offset: 0 });
        }
        if super::scan::returns_early(&function.body) {
            let mut vars = Vec::new();
            if has_result && let Some(result) = &function.result {
                let count = self.flat(self.inner(result.ty))?;
                self.spend(count)?;
                let base = self.variables(count);
                vars.extend((base..base + count).map(Var));
            }
            frame.exit = Some((self.construct(), vars));
        }
        Ok(frame)
    }

    /// Builds the body of a call; the result is its value.
    pub(super) fn inline(&mut self, frame: Frame<'m>) -> Result<Option<Rc<[Val]>>, Fail> {
        let body = &frame.function.body;
        let exit = frame.exit.clone();
        self.frames.push(frame);
        if let Some((id, vars)) = exit {
            // What comes before the first return is the caller's as well: later calls can use its values again.
            let calm = super::scan::before_return(body);
            self.statements(body, 0..calm)?;
            self.flush();
            let block = self.nested(|b| b.statements(body, calm..body.len()))?;
            self.frames.pop();
            self.push(Stmt::Region { id, body: block });
            let words: Vec<Val> = vars.into_iter().map(|var| self.get(var)).collect();
            return Ok(Some(words.into()));
        }
        self.block(body)?;
        Ok(self.frames.pop().and_then(|frame| frame.result))
    }

    pub(super) fn frame_mut(&mut self) -> &mut Frame<'m> {
        self.frames.last_mut().expect("a function is being built")
    }

    pub(super) fn construct(&mut self) -> Construct {
        self.tree.constructs += 1;
        Construct(self.tree.constructs - 1)
    }

    pub(super) fn push(&mut self, stmt: Stmt) {
        self.block.push(stmt);
    }

    pub(super) fn site(&mut self, span: Span) -> Site {
        if self.tree.sites.last() != Some(&span) {
            self.tree.sites.push(span);
        }
        self.tree.sites.len() as Site - 1
    }

    pub(super) fn constant(&mut self, word: u32) -> Val {
        *self.constants.entry(word).or_insert_with(|| {
            self.tree.vals.push(Op::Const(word));
            Val(self.tree.vals.len() as u32 - 1)
        })
    }

    /// A value for an operation: folded, or found in scope, or defined here.
    pub(super) fn define(&mut self, op: Op) -> Val {
        match fold::simplify(&self.tree, op) {
            fold::Folded::Word(word) => return self.constant(word),
            fold::Folded::Same(val) => return val,
            fold::Folded::No => {}
        }
        if let Some(val) = self.rewrite(op) {
            return val;
        }
        if let Some((a, b)) = idiom::high_product(&self.tree, op) {
            let [a, b] = [a, b].map(|factor| match factor {
                idiom::Factor::Val(val) => val,
                idiom::Factor::Word(word) => self.constant(word),
            });
            return self.define(Op::Bin(BinOp::MulHigh, a, b));
        }
        let pure = match op {
            Op::Get(_) | Op::Atomic => false,
            Op::Load { mem: Mem::Buffer(slot), .. } => self.readonly[slot as usize],
            Op::Load { .. } => false,
            _ => true,
        };
        if pure && let Some(val) = self.scopes.iter().rev().find_map(|scope| scope.get(&op)) {
            return *val;
        }
        let val = Val(self.tree.vals.len() as u32);
        self.tree.vals.push(op);
        if !matches!(op, Op::Atomic) {
            self.push(Stmt::Def(val));
        }
        if pure {
            self.scopes.last_mut().expect("a scope is open").insert(op, val);
        }
        val
    }

    fn counted(mem: Mem) -> bool {
        mem != Mem::Private
    }

    pub(super) fn count_load(&mut self, mem: Mem, words: usize) {
        if Self::counted(mem) {
            self.pending.loads += 1;
            self.pending.bytes += 4 * words as u32;
        }
    }

    pub(super) fn count_store(&mut self, mem: Mem, words: usize) {
        if Self::counted(mem) {
            self.pending.stores += 1;
            self.pending.bytes += 4 * words as u32;
        }
    }

    pub(super) fn count_atomic(&mut self) {
        self.pending.atomics += 1;
        self.pending.bytes += 4;
    }

    pub(super) fn count_barrier(&mut self) {
        self.pending.barriers += 1;
    }

    pub(super) fn count_turn(&mut self) {
        self.pending.turns += 1;
    }

    /// Records the costs of the straight run that ends here.
    pub(super) fn flush(&mut self) {
        let cost = std::mem::take(&mut self.pending);
        if self.options.count && cost != Cost::default() {
            self.tree.costs.push(cost);
            let index = self.tree.costs.len() as u32 - 1;
            self.push(Stmt::Tally(index));
        }
    }

    pub(super) fn global(&self, handle: Handle<naga::GlobalVariable>) -> Result<Place, Fail> {
        self.globals.get(&handle).cloned().ok_or_else(|| Fail::unsupported("this global variable", None))
    }
}

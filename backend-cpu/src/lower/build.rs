//! naga IR to [`Tree`]: inlines calls, splits values into words, numbers values, counts semantic costs.
//!
//! Follows the evaluation rules of `naga::ir`: an expression is evaluated when the `Emit` that covers it runs, the
//! results of calls and atomics when their statement runs, everything else (constants, arguments, variables) on use.

use std::collections::HashMap;
use std::rc::Rc;

use naga::{Arena, Expression, Handle, Span, TypeInner};

use super::place::{Place, Root};
use super::scan::Scan;
use super::tree::{Block, Builtin, Construct, Cost, Op, Site, Stmt, Tree, Val, Var};
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

    fn limit(what: &'static str, limit: u32) -> Self {
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
    pub(super) workgroup_size: [u32; 3],
    globals: HashMap<Handle<naga::GlobalVariable>, Place>,
    readonly: Vec<bool>,
    constants: HashMap<u32, Val>,
    /// Pure values that can be used again, innermost block last.
    scopes: Vec<HashMap<Op, Val>>,
    /// Values that variables are known to hold, by block, innermost last; and every variable set so far.
    known: Vec<Known>,
    sets: Vec<Var>,
    pending: Cost,
    options: Options,
    /// Operations built so far.
    spent: u64,
}

/// What a block knows of variables.
#[derive(Default)]
struct Known {
    /// `None` where the value of an outer block does not hold any more.
    values: HashMap<Var, Option<Val>>,
    /// Whether outer blocks tell nothing.
    opaque: bool,
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
        let mut builder = Builder {
            module,
            info,
            scan: Scan::new(module),
            tree: Tree::default(),
            frames: Vec::new(),
            targets: Vec::new(),
            block: Vec::new(),
            workgroup_size: point.workgroup_size,
            globals: HashMap::new(),
            readonly: vec![false; slots.len()],
            constants: HashMap::new(),
            scopes: vec![HashMap::new()],
            known: vec![Known::default()],
            sets: Vec::new(),
            pending: Cost::default(),
            options,
            spent: 0,
        };
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

    pub(super) fn inner(&self, ty: Handle<naga::Type>) -> &'m TypeInner {
        &self.module.types[ty].inner
    }

    fn place_globals(&mut self, slots: &[(u32, u32)], uses: &naga::valid::FunctionInfo) -> Result<(), Fail> {
        let module = self.module;
        for (handle, global) in module.global_variables.iter() {
            if uses[handle].is_empty() {
                continue;
            }
            let span = module.global_variables.get_span(handle);
            let ty = self.inner(global.ty).clone();
            let words = |b: &Self| b.flat(&ty).map_err(|e| e.at(span));
            let root = match global.space {
                naga::AddressSpace::Uniform | naga::AddressSpace::Storage { .. } => {
                    let pair = global.binding.map(|b| (b.group, b.binding));
                    let slot = slots.iter().position(|s| Some(*s) == pair);
                    let slot = slot.ok_or_else(|| Fail::unsupported("a buffer without a binding", Some(span)))?;
                    words(self)?;
                    self.readonly[slot] = match global.space {
                        naga::AddressSpace::Storage { access } => !access.contains(naga::StorageAccess::STORE),
                        _ => true,
                    };
                    Root::Mem(Mem::Buffer(slot as u8), 0)
                }
                naga::AddressSpace::WorkGroup => {
                    let base = self.tree.workgroup_words;
                    self.tree.workgroup_words = base.saturating_add(words(self)?);
                    Root::Mem(Mem::Workgroup, base)
                }
                naga::AddressSpace::Private => {
                    let count = words(self)?;
                    let dynamic = self.scan.private_is_dynamic(handle);
                    self.room(count, dynamic, global.init.is_some()).map_err(|e| e.at(span))?;
                    let init = global.init.map(|init| self.constant_words(&module.global_expressions, init));
                    let init = init.transpose()?.unwrap_or_else(|| vec![0; count as usize]);
                    self.private(dynamic, count, &init, span)
                }
                _ => return Err(Fail::unsupported("a resource that is not a buffer (texture, sampler)", Some(span))),
            };
            self.globals.insert(handle, Place { root, ty, dynamic: None, offset: 0 });
        }
        Ok(())
    }

    /// Whether a private or function variable of so many words is within the limits.
    fn room(&mut self, count: u32, dynamic: bool, has_init: bool) -> Result<(), Fail> {
        let limit = self.options.limits.private;
        if dynamic && (u64::from(self.tree.private_words) + u64::from(count)) * 4 > u64::from(limit) {
            return Err(Fail::limit("bytes of private memory of one invocation", limit));
        }
        self.spend(if dynamic && !has_init { 1 } else { count })
    }

    /// Room for a private or function variable: variables, or memory where it is indexed at run time.
    fn private(&mut self, dynamic: bool, count: u32, init: &[u32], span: Span) -> Root {
        if !dynamic {
            let base = self.variables(count);
            for (index, &word) in init.iter().enumerate() {
                let (var, val) = (Var(base + index as u32), self.constant(word));
                self.push(Stmt::Init(var, val));
                self.learn(var, Some(val));
                self.sets.push(var);
            }
            return Root::Vars(base);
        }
        let base = self.tree.private_words;
        self.tree.private_words += count;
        self.push(Stmt::Zero { offset: base, count });
        let addr = self.constant(0);
        let site = self.site(span);
        for (index, &word) in init.iter().enumerate().filter(|(_, word)| **word != 0) {
            let value = self.constant(word);
            self.push(Stmt::Store { mem: Mem::Private, addr, offset: base + index as u32, value, site });
        }
        Root::Mem(Mem::Private, base)
    }

    fn variables(&mut self, count: u32) -> u32 {
        self.tree.vars += count;
        self.tree.vars - count
    }

    fn input(&mut self, argument: &naga::FunctionArgument) -> Result<Value, Fail> {
        let mut words = Vec::new();
        match (&argument.binding, self.inner(argument.ty)) {
            (Some(binding), ty) => self.builtin(binding, ty, &mut words)?,
            (None, TypeInner::Struct { members, .. }) => {
                for member in members {
                    let binding = member.binding.as_ref().ok_or_else(|| Fail::unsupported("an input", None))?;
                    self.builtin(binding, self.inner(member.ty), &mut words)?;
                }
            }
            _ => return Err(Fail::unsupported("an input without a binding", None)),
        }
        Ok(Value::Words(words.into()))
    }

    fn builtin(&mut self, binding: &naga::Binding, ty: &TypeInner, words: &mut Vec<Val>) -> Result<(), Fail> {
        let naga::Binding::BuiltIn(builtin) = binding else {
            return Err(Fail::unsupported("an input that is not built in", None));
        };
        let axes = if matches!(ty, TypeInner::Vector { .. }) { 3 } else { 1 };
        for axis in 0..axes {
            let size = self.workgroup_size[axis as usize];
            let op = match builtin {
                naga::BuiltIn::LocalInvocationId if size == 1 => Op::Const(0),
                naga::BuiltIn::GlobalInvocationId if size == 1 => Op::Builtin(Builtin::GroupId(axis)),
                naga::BuiltIn::LocalInvocationId => Op::Builtin(Builtin::LocalId(axis)),
                naga::BuiltIn::GlobalInvocationId => Op::Builtin(Builtin::GlobalId(axis)),
                naga::BuiltIn::WorkGroupId => Op::Builtin(Builtin::GroupId(axis)),
                naga::BuiltIn::NumWorkGroups => Op::Builtin(Builtin::NumGroups(axis)),
                naga::BuiltIn::WorkGroupSize => Op::Const(size),
                naga::BuiltIn::LocalInvocationIndex => Op::Builtin(Builtin::LocalIndex),
                other => return Err(Fail::unsupported(format!("the built-in input {other:?}"), None)),
            };
            words.push(self.define(op));
        }
        Ok(())
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
            self.flush();
            let block = self.nested(|b| b.block(body))?;
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
    fn enter(&self) -> Result<(), Fail> {
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
    fn learn(&mut self, var: Var, val: Option<Val>) {
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

    /// Words of a constant expression.
    pub(super) fn constant_words(
        &self,
        arena: &'m Arena<Expression>,
        handle: Handle<Expression>,
    ) -> Result<Vec<u32>, Fail> {
        let fail = |what: &str| Err(Fail::unsupported(what.to_owned(), Some(arena.get_span(handle))));
        Ok(match &arena[handle] {
            Expression::Literal(literal) => vec![literal_word(*literal)?],
            Expression::Constant(constant) => {
                self.constant_words(&self.module.global_expressions, self.module.constants[*constant].init)?
            }
            Expression::Override(handle) => match self.module.overrides[*handle].init {
                Some(init) => self.constant_words(&self.module.global_expressions, init)?,
                None => return fail("an override without a value"),
            },
            Expression::ZeroValue(ty) => vec![0; self.flat(self.inner(*ty))? as usize],
            Expression::Compose { components, .. } => {
                let mut words = Vec::new();
                for component in components {
                    words.extend(self.constant_words(arena, *component)?);
                }
                words
            }
            Expression::Splat { size, value } => {
                let value = self.constant_words(arena, *value)?;
                value.repeat(*size as usize)
            }
            _ => return fail("this constant expression"),
        })
    }
}

/// The word of a literal.
pub(super) fn literal_word(literal: naga::Literal) -> Result<u32, Fail> {
    Ok(match literal {
        naga::Literal::F32(value) => value.to_bits(),
        naga::Literal::U32(value) => value,
        naga::Literal::I32(value) => value as u32,
        naga::Literal::Bool(value) => {
            if value {
                u32::MAX
            } else {
                0
            }
        }
        other => return Err(Fail::unsupported(format!("the literal {other:?}"), None)),
    })
}

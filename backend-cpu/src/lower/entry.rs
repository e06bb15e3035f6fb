//! What an entry point begins with: rooms for global variables, and the built-in inputs.

use naga::{Span, TypeInner};

use super::build::{Builder, Fail, Value};
use super::place::{Place, Root};
use super::tree::{Builtin, Op, Stmt, Val, Var};
use crate::code::Mem;

impl Builder<'_> {
    pub(super) fn place_globals(&mut self, slots: &[(u32, u32)], uses: &naga::valid::FunctionInfo) -> Result<(), Fail> {
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
    pub(super) fn room(&mut self, count: u32, dynamic: bool, has_init: bool) -> Result<(), Fail> {
        let limit = self.options.limits.private;
        if dynamic && (u64::from(self.tree.private_words) + u64::from(count)) * 4 > u64::from(limit) {
            return Err(Fail::limit("bytes of private memory of one invocation", limit));
        }
        self.spend(if dynamic && !has_init { 1 } else { count })
    }

    /// Room for a private or function variable: variables, or memory where it is indexed at run time.
    pub(super) fn private(&mut self, dynamic: bool, count: u32, init: &[u32], span: Span) -> Root {
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

    pub(super) fn variables(&mut self, count: u32) -> u32 {
        self.tree.vars += count;
        self.tree.vars - count
    }

    pub(super) fn input(&mut self, argument: &naga::FunctionArgument) -> Result<Value, Fail> {
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
            let size = self.tree.workgroup_size[axis as usize];
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
}

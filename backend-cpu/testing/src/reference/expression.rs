//! Expressions: values of the IR's expression arena in one frame, and robust access.
//!
//! An expression is computed when its `Emit` runs. What the IR lets stand outside every `Emit` (literals, constants,
//! pointers to variables, and what a constant expression is made of) is computed on use: it cannot change.

use naga::{Binding, BuiltIn, Expression, Function, Handle};
use sightlines_backend::Result;

use super::builtin;
use super::invocation::{Frame, Invocation, Place};
use super::memory::{self, Kind, Pointer, Root, Shape};
use super::unsupported;
use super::value::{self, Value};

impl<'a> Invocation<'a> {
    /// The value of an expression in scope.
    pub(crate) fn evaluate(&self, frame: &Frame<'a>, handle: Handle<Expression>) -> Result<Value> {
        if let Some(value) = &frame.values.borrow()[handle.index()] {
            return Ok(value.clone());
        }
        match frame.function.expressions[handle] {
            Expression::Load { .. } => panic!("load {handle:?} is used outside its scope"),
            _ => self.compute(frame, handle),
        }
    }

    pub(crate) fn compute(&self, frame: &Frame<'a>, handle: Handle<Expression>) -> Result<Value> {
        let get = |h: &Handle<Expression>| self.evaluate(frame, *h);
        match &frame.function.expressions[handle] {
            Expression::FunctionArgument(index) => Ok(frame.arguments[*index as usize].clone()),
            Expression::GlobalVariable(global) => match self.shared.globals[global.index()] {
                Some(pointer) => Ok(Value::Pointer(pointer)),
                None => unsupported(format!("global {:?}", self.shared.module.global_variables[*global].name)),
            },
            Expression::LocalVariable(local) => {
                let shape = Shape::Type(frame.function.local_variables[*local].ty);
                Ok(Value::Pointer(Pointer { root: Root::Function, word: frame.locals[local.index()], shape }))
            }
            Expression::Load { pointer } => self.load(get(pointer)?.pointer()),
            Expression::ArrayLength(pointer) => Ok(Value::U32(self.length(get(pointer)?.pointer())? as u32)),
            Expression::Access { base, index } => self.access(&get(base)?, get(index)?.word() as usize),
            Expression::AccessIndex { base, index } => self.access(&get(base)?, *index as usize),
            pure => constant(self.shared.module, pure, &get),
        }
    }

    /// A part of a value, or a pointer to a part; an index past the end means the last part.
    fn access(&self, base: &Value, index: usize) -> Result<Value> {
        let Value::Pointer(pointer) = base else {
            let parts = base.parts();
            return Ok(parts[index.min(parts.len() - 1)].clone());
        };
        let index = index.min(self.length(pointer)?.saturating_sub(1));
        let host = matches!(pointer.root, Root::Slot(_));
        let (offset, shape) = memory::part(self.shared.module, pointer.shape, index, host)?;
        Ok(Value::Pointer(Pointer { root: pointer.root, word: pointer.word + offset, shape }))
    }

    /// Number of parts of what a pointer points to; the binding decides for a runtime-sized array.
    fn length(&self, pointer: &Pointer) -> Result<usize> {
        match (memory::kind(self.shared.module, pointer.shape)?, pointer.root) {
            (Kind::Array(_, None, stride), Root::Slot(slot)) => {
                Ok((self.shared.slots[slot].words - pointer.word) / stride)
            }
            _ => memory::parts(self.shared.module, pointer.shape),
        }
    }
}

/// An expression that depends on its operands alone.
fn constant(
    module: &naga::Module,
    expression: &Expression,
    get: &dyn Fn(&Handle<Expression>) -> Result<Value>,
) -> Result<Value> {
    match expression {
        Expression::Literal(literal) => Value::literal(*literal),
        Expression::Constant(handle) => global(module, module.constants[*handle].init),
        Expression::ZeroValue(ty) => memory::zero(module, Shape::Type(*ty)),
        Expression::Compose { ty, components } => {
            let mut parts = Vec::new();
            for component in components {
                match (memory::kind(module, Shape::Type(*ty))?, get(component)?) {
                    (Kind::Vector(..), Value::Composite(more)) => parts.extend(more),
                    (_, part) => parts.push(part),
                }
            }
            Ok(Value::Composite(parts))
        }
        Expression::Access { base, index } => {
            let (base, index) = (get(base)?, get(index)?.word() as usize);
            Ok(base.parts()[index.min(base.parts().len() - 1)].clone())
        }
        Expression::AccessIndex { base, index } => Ok(get(base)?.parts()[*index as usize].clone()),
        Expression::Splat { size, value } => Ok(Value::Composite(vec![get(value)?; *size as usize])),
        Expression::Swizzle { size, vector, pattern } => {
            let vector = get(vector)?;
            let component = |c: &naga::SwizzleComponent| vector.parts()[*c as usize].clone();
            Ok(Value::Composite(pattern[..*size as usize].iter().map(component).collect()))
        }
        Expression::Unary { op, expr } => builtin::unary(*op, &get(expr)?),
        Expression::Binary { op, left, right } => builtin::binary(*op, &get(left)?, &get(right)?),
        Expression::Select { condition, accept, reject } => {
            Ok(builtin::select(&get(condition)?, &get(accept)?, &get(reject)?))
        }
        Expression::Relational { fun, argument } => builtin::relational(*fun, &get(argument)?),
        Expression::Math { fun, arg, arg1, arg2, arg3 } => {
            let args = [Some(arg), arg1.as_ref(), arg2.as_ref(), arg3.as_ref()];
            let args = args.into_iter().flatten().map(get).collect::<Result<Vec<_>>>()?;
            builtin::math(*fun, &args.iter().collect::<Vec<_>>())
        }
        Expression::As { expr, kind, convert } => value::cast(&get(expr)?, *kind, *convert),
        other => unsupported(format!("expression {other:?}")),
    }
}

/// The value of a module-scope constant expression.
pub(crate) fn global(module: &naga::Module, handle: Handle<Expression>) -> Result<Value> {
    constant(module, &module.global_expressions[handle], &|h| global(module, *h))
}

/// The arguments of an entry point: builtin values, or structures of them.
pub(crate) fn entry_arguments(module: &naga::Module, function: &Function, place: &Place) -> Result<Vec<Value>> {
    let argument = |ty, binding: &Option<Binding>| match (binding, memory::kind(module, Shape::Type(ty))?) {
        (Some(binding), _) => builtin_value(binding, place),
        (None, Kind::Struct(members, _)) => {
            let fields = members.iter().map(|m| match &m.binding {
                Some(binding) => builtin_value(binding, place),
                None => unsupported("entry point argument without a binding"),
            });
            fields.collect::<Result<_>>().map(Value::Composite)
        }
        _ => unsupported("entry point argument without a binding"),
    };
    function.arguments.iter().map(|a| argument(a.ty, &a.binding)).collect()
}

fn builtin_value(binding: &Binding, place: &Place) -> Result<Value> {
    let Place { local, group, groups, size } = *place;
    let vector = |v: [u32; 3]| Ok(Value::Composite(v.map(Value::U32).to_vec()));
    match binding {
        Binding::BuiltIn(BuiltIn::GlobalInvocationId) => {
            vector(std::array::from_fn(|i| group[i].wrapping_mul(size[i]).wrapping_add(local[i])))
        }
        Binding::BuiltIn(BuiltIn::LocalInvocationId) => vector(local),
        Binding::BuiltIn(BuiltIn::LocalInvocationIndex) => {
            Ok(Value::U32(local[0] + size[0] * (local[1] + size[1] * local[2])))
        }
        Binding::BuiltIn(BuiltIn::WorkGroupId) => vector(group),
        Binding::BuiltIn(BuiltIn::WorkGroupSize) => vector(size),
        Binding::BuiltIn(BuiltIn::NumWorkGroups) => vector(groups),
        other => unsupported(format!("builtin {other:?}")),
    }
}

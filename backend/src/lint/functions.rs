//! What functions do: f32 arithmetic, signed division, returned atomics, subgroups.

use std::ops::Range;

use naga::proc::TypeResolution;
use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{BinaryOperator, BuiltIn, Expression, Function, Handle, MathFunction, Module, ScalarKind, TypeInner};

use super::marks::Marks;
use super::{Source, Violation};

/// Finds violations in every function and entry point, used or not.
pub(super) fn check(
    module: &Module,
    info: &ModuleInfo,
    source: &Source<'_>,
    marks: &mut [Marks],
    found: &mut Vec<Violation>,
) {
    let mut visit = |function: &Function, info: &FunctionInfo, name: Option<&str>| {
        let Some(index) = name.and_then(|n| source.named("fn", n)) else { return };
        let fallback = source.items[index].name.clone();
        let mut scan = Scan { module, function, info, fallback, marks: &mut marks[index], found };
        for (handle, expression) in function.expressions.iter() {
            scan.expression(handle, expression);
        }
        scan.builtins();
    };
    for (handle, function) in module.functions.iter() {
        visit(function, &info[handle], function.name.as_deref());
    }
    for (index, entry) in module.entry_points.iter().enumerate() {
        visit(&entry.function, info.get_entry_point(index), Some(&entry.name));
    }
}

struct Scan<'a> {
    module: &'a Module,
    function: &'a Function,
    info: &'a FunctionInfo,
    /// Where a violation is placed whose expression has no span.
    fallback: Range<usize>,
    marks: &'a mut Marks,
    found: &'a mut Vec<Violation>,
}

impl Scan<'_> {
    fn expression(&mut self, at: Handle<Expression>, expression: &Expression) {
        match *expression {
            Expression::Binary { op, left, right } => self.binary(at, op, left, right),
            Expression::Unary { op: naga::UnaryOperator::Negate, expr } if self.is_float(expr) => {
                self.float(at, "negates an f32");
            }
            Expression::As { expr, convert: Some(_), .. } if self.is_float(expr) != self.is_float(at) => {
                self.float(at, "converts to or from f32");
            }
            Expression::Math { fun, arg, .. } if self.is_float(arg) || self.is_float(at) => self.math(at, fun),
            Expression::Relational { argument, .. } if self.is_float(argument) => self.float(at, "tests an f32"),
            Expression::AtomicResult { .. } if self.info[at].ref_count > 0 => {
                self.push("atomic-result", at, "the value that this returns is used");
            }
            Expression::SubgroupBallotResult | Expression::SubgroupOperationResult { .. } => {
                self.push("subgroup", at, "works on a subgroup");
            }
            _ => {}
        }
    }

    fn binary(
        &mut self,
        at: Handle<Expression>,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) {
        let division = matches!(op, BinaryOperator::Divide | BinaryOperator::Modulo);
        if self.is_float(left) || self.is_float(right) {
            self.float(at, "computes with f32");
            if op == BinaryOperator::Modulo {
                self.push("inexact-builtin", at, "the remainder of f32");
            } else if op == BinaryOperator::Multiply && (self.is_matrix(left) || self.is_matrix(right)) {
                self.push("inexact-builtin", at, "a matrix product");
            }
        } else if division && self.kind(left) == Some(ScalarKind::Sint) {
            self.push("signed-division", at, "divides i32");
        }
    }

    fn math(&mut self, at: Handle<Expression>, fun: MathFunction) {
        self.float(at, "computes with f32");
        if !is_exact(fun) {
            self.push("inexact-builtin", at, "devices differ in this function");
        }
    }

    /// Subgroup builtins among the arguments of an entry point, in structs too.
    fn builtins(&mut self) {
        let subgroup = |binding: &Option<naga::Binding>| {
            use BuiltIn::{NumSubgroups, SubgroupId, SubgroupInvocationId, SubgroupSize};
            let Some(naga::Binding::BuiltIn(builtin)) = binding else { return false };
            matches!(builtin, NumSubgroups | SubgroupId | SubgroupInvocationId | SubgroupSize)
        };
        for argument in &self.function.arguments {
            let members = match self.module.types[argument.ty].inner {
                TypeInner::Struct { ref members, .. } => members.as_slice(),
                _ => &[],
            };
            if subgroup(&argument.binding) || members.iter().any(|m| subgroup(&m.binding)) {
                let label = "takes a subgroup builtin".to_owned();
                self.found.push(Violation { lint: "subgroup", range: self.fallback.clone(), label });
            }
        }
    }

    fn float(&mut self, at: Handle<Expression>, label: &str) {
        if !self.marks.float_is_marked() {
            self.push("float-arithmetic", at, label);
        }
    }

    fn push(&mut self, lint: &'static str, at: Handle<Expression>, label: &str) {
        let span = self.function.expressions.get_span(at).to_range();
        let range = span.unwrap_or_else(|| self.fallback.clone());
        self.found.push(Violation { lint, range, label: label.to_owned() });
    }

    fn inner(&self, at: Handle<Expression>) -> &TypeInner {
        match self.info[at].ty {
            TypeResolution::Handle(handle) => &self.module.types[handle].inner,
            TypeResolution::Value(ref inner) => inner,
        }
    }

    fn kind(&self, at: Handle<Expression>) -> Option<ScalarKind> {
        match *self.inner(at) {
            TypeInner::Scalar(scalar) | TypeInner::Vector { scalar, .. } | TypeInner::Matrix { scalar, .. } => {
                Some(scalar.kind)
            }
            // `modf` and `frexp` return structs of their own.
            TypeInner::Struct { ref members, .. } => match self.module.types[members.first()?.ty].inner {
                TypeInner::Scalar(scalar) | TypeInner::Vector { scalar, .. } => Some(scalar.kind),
                _ => None,
            },
            _ => None,
        }
    }

    fn is_float(&self, at: Handle<Expression>) -> bool {
        self.kind(at) == Some(ScalarKind::Float)
    }

    fn is_matrix(&self, at: Handle<Expression>) -> bool {
        matches!(self.inner(at), TypeInner::Matrix { .. })
    }
}

/// Functions of f32 that are exact where their result is representable, or, like `inverseSqrt`, the accepted guess.
fn is_exact(fun: MathFunction) -> bool {
    use MathFunction as M;
    matches!(
        fun,
        M::Abs
            | M::Min
            | M::Max
            | M::Clamp
            | M::Saturate
            | M::Ceil
            | M::Floor
            | M::Round
            | M::Trunc
            | M::Modf
            | M::Frexp
            | M::Ldexp
            | M::Sign
            | M::Step
            | M::Transpose
            | M::InverseSqrt
    )
}

//! Which results WGSL permits for a run line: the function's IR, evaluated over [`Interval`]s.
//!
//! Integers, booleans and bits are exact, so functions without f32 have no latitude. A function with an operation that
//! has no entry here has none either: its results must be equal bit for bit.

use naga::proc::TypeResolution;
use naga::valid::{Capabilities, FunctionInfo, ModuleInfo, ValidationFlags, Validator};
use naga::{
    BinaryOperator, Expression, Function, Handle, Literal, Module, ScalarKind, Statement, TypeInner, UnaryOperator,
};

use crate::builtin::{math, relation};
use crate::interval::Interval;
use sightlines_testing::operators::File;

/// What one word may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Value {
    /// These bits: an integer or a boolean.
    Word(u32),
    /// An f32.
    Number(Interval),
    /// Anything.
    Any,
}

impl Value {
    pub(crate) fn number(self) -> Interval {
        if let Value::Number(interval) = self { interval } else { Interval::ANY }
    }

    fn holds(self, bits: u32) -> bool {
        match self {
            Value::Word(word) => word == bits,
            Value::Number(interval) => interval.holds(bits),
            Value::Any => true,
        }
    }
}

/// The scalars of a value, columns after one another, with the shape of its type.
#[derive(Clone, Debug)]
pub(crate) struct Values {
    pub scalars: Vec<Value>,
    pub columns: usize,
    pub rows: usize,
}

impl Values {
    pub(crate) fn vector(scalars: Vec<Value>) -> Self {
        Values { columns: 1, rows: scalars.len(), scalars }
    }

    pub(crate) fn numbers(numbers: impl IntoIterator<Item = Interval>) -> Self {
        Self::vector(numbers.into_iter().map(Value::Number).collect())
    }

    pub(crate) fn intervals(&self) -> Vec<Interval> {
        self.scalars.iter().map(|value| value.number()).collect()
    }

    /// The scalar at `i`, where a scalar stands for all.
    pub(crate) fn at(&self, i: usize) -> Value {
        self.scalars[if self.scalars.len() == 1 { 0 } else { i }]
    }
}

/// The functions of a file, ready to be evaluated.
pub(crate) struct Latitude<'a> {
    module: &'a Module,
    info: ModuleInfo,
}

/// Not in the table: no latitude.
type Known<T> = Option<T>;

impl<'a> Latitude<'a> {
    pub(crate) fn new(file: &'a File) -> Result<Self, String> {
        let module = file.module();
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::SHADER_FLOAT16_IN_FLOAT32);
        let info = validator.validate(module).map_err(|e| e.as_inner().to_string())?;
        Ok(Latitude { module, info })
    }

    /// Whether WGSL permits a function to return these words for these operands.
    pub(crate) fn permits(&self, name: &str, operands: &[u32], words: &[u32]) -> bool {
        let values = self.results(name, operands);
        values.is_some_and(|values| values.scalars.iter().zip(words).all(|(value, &word)| value.holds(word)))
    }

    fn results(&self, name: &str, operands: &[u32]) -> Known<Values> {
        let (handle, function) = self.module.functions.iter().find(|(_, f)| f.name.as_deref() == Some(name))?;
        let (mut rest, mut arguments) = (operands, Vec::new());
        for argument in &function.arguments {
            let (columns, rows, kind) = shape(&self.module.types[argument.ty].inner)?;
            let (own, after) = rest.split_at_checked(columns * rows)?;
            rest = after;
            let value = |&word| {
                if kind == ScalarKind::Float { Value::Number(Interval::of_bits(word)) } else { Value::Word(word) }
            };
            arguments.push(Values { scalars: own.iter().map(value).collect(), columns, rows });
        }
        let evaluation = Evaluation { module: self.module, info: &self.info[handle], function, arguments };
        let mut result = None;
        for statement in function.body.iter() {
            match statement {
                Statement::Emit(_) => {}
                Statement::Return { value: Some(value) } => result = Some(evaluation.value(*value)?),
                _ => return None,
            }
        }
        result
    }
}

/// Columns, rows and kind of scalars, vectors and matrices.
fn shape(inner: &TypeInner) -> Known<(usize, usize, ScalarKind)> {
    match *inner {
        TypeInner::Scalar(scalar) => Some((1, 1, scalar.kind)),
        TypeInner::Vector { size, scalar } => Some((1, size as usize, scalar.kind)),
        TypeInner::Matrix { columns, rows, scalar } => Some((columns as usize, rows as usize, scalar.kind)),
        _ => None,
    }
}

struct Evaluation<'a> {
    module: &'a Module,
    info: &'a FunctionInfo,
    function: &'a Function,
    arguments: Vec<Values>,
}

impl Evaluation<'_> {
    fn inner(&self, expression: Handle<Expression>) -> &TypeInner {
        match &self.info[expression].ty {
            TypeResolution::Handle(ty) => &self.module.types[*ty].inner,
            TypeResolution::Value(inner) => inner,
        }
    }

    fn is_float(&self, expression: Handle<Expression>) -> bool {
        shape(self.inner(expression)).is_some_and(|(_, _, kind)| kind == ScalarKind::Float)
    }

    fn value(&self, handle: Handle<Expression>) -> Known<Values> {
        match self.function.expressions[handle] {
            Expression::FunctionArgument(index) => self.arguments.get(index as usize).cloned(),
            Expression::Literal(literal) => Some(Values::vector(vec![constant(literal)?])),
            Expression::Compose { ref components, .. } => {
                let parts = components.iter().map(|&part| self.value(part)).collect::<Known<Vec<_>>>()?;
                self.shaped(handle, parts.into_iter().flat_map(|part| part.scalars).collect())
            }
            Expression::Splat { size, value } => {
                Some(Values::vector(vec![self.value(value)?.scalars[0]; size as usize]))
            }
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(vector)?;
                Some(Values::vector(pattern[..size as usize].iter().map(|&at| vector.scalars[at as usize]).collect()))
            }
            Expression::AccessIndex { base, index } => self.component(handle, base, index as usize),
            Expression::Unary { op: UnaryOperator::Negate, expr } if self.is_float(expr) => {
                let value = self.value(expr)?;
                self.shaped(handle, value.scalars.iter().map(|v| Value::Number(v.number().negated())).collect())
            }
            Expression::Unary { op: UnaryOperator::LogicalNot, expr } => {
                let not = |value: &Value| if let Value::Word(word) = value { Value::Word(1 - word) } else { *value };
                self.shaped(handle, self.value(expr)?.scalars.iter().map(not).collect())
            }
            Expression::Binary { op, left, right } if self.is_float(left) => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                self.binary(handle, op, &left, &right)
            }
            Expression::Select { condition, accept, reject } => {
                let (condition, accept, reject) = (self.value(condition)?, self.value(accept)?, self.value(reject)?);
                let pick = |i| match condition.at(i) {
                    Value::Word(0) => reject.scalars[i],
                    Value::Word(_) => accept.scalars[i],
                    _ => Value::Any,
                };
                self.shaped(handle, (0..accept.scalars.len()).map(pick).collect())
            }
            Expression::Math { fun, arg, arg1, arg2, .. } => {
                let arguments = [Some(arg), arg1, arg2].into_iter().flatten();
                math(fun, &arguments.map(|argument| self.value(argument)).collect::<Known<Vec<_>>>()?)
            }
            Expression::As { expr, kind, convert } => {
                let (_, _, from) = shape(self.inner(expr))?;
                let value = self.value(expr)?;
                let cast =
                    |&v: &Value| if convert.is_some() { converted(v, from, kind) } else { Some(recast(v, kind)) };
                let scalars = value.scalars.iter().map(cast).collect::<Known<Vec<_>>>()?;
                self.shaped(handle, scalars)
            }
            _ => None,
        }
    }

    /// Scalars with the shape of an expression's type.
    fn shaped(&self, handle: Handle<Expression>, scalars: Vec<Value>) -> Known<Values> {
        let (columns, rows, _) = shape(self.inner(handle))?;
        (columns * rows == scalars.len()).then_some(Values { scalars, columns, rows })
    }

    /// A component of a vector, a column of a matrix, or a member of what `modf` and `frexp` return: the first half of
    /// the scalars, or the second.
    fn component(&self, handle: Handle<Expression>, base: Handle<Expression>, index: usize) -> Known<Values> {
        let value = self.value(base)?;
        let (columns, rows, _) = shape(self.inner(handle))?;
        let size = columns * rows;
        self.shaped(handle, value.scalars.get(index * size..(index + 1) * size)?.to_vec())
    }

    fn binary(&self, handle: Handle<Expression>, op: BinaryOperator, left: &Values, right: &Values) -> Known<Values> {
        let (columns, rows, _) = shape(self.inner(handle))?;
        let product = op == BinaryOperator::Multiply && (left.columns > 1 || right.columns > 1);
        if product && left.scalars.len() > 1 && right.scalars.len() > 1 {
            return self.shaped(handle, matrix_product(left, right));
        }
        let scalar = |i| {
            let (a, b) = (left.at(i).number(), right.at(i).number());
            Some(match op {
                BinaryOperator::Add => Value::Number(a.plus(b)),
                BinaryOperator::Subtract => Value::Number(a.minus(b)),
                BinaryOperator::Multiply => Value::Number(a.times(b)),
                BinaryOperator::Divide => Value::Number(a.over(b)),
                // Inherited from x - y * trunc(x / y).
                BinaryOperator::Modulo => Value::Number(a.minus(b.times(a.over(b).monotone(f64::trunc)))),
                _ => relation(op, a, b)?,
            })
        };
        self.shaped(handle, (0..columns * rows).map(scalar).collect::<Known<Vec<_>>>()?)
    }
}

/// Sums of products, a vector on the left being a row.
fn matrix_product(left: &Values, right: &Values) -> Vec<Value> {
    let left_is_row = left.columns == 1;
    let (rows, inner) = if left_is_row { (1, left.rows) } else { (left.rows, left.columns) };
    let at = |i: usize, k: usize| left.scalars[k * rows + i].number();
    let mut product = Vec::new();
    for column in 0..right.columns {
        for i in 0..rows {
            let term = |k: usize| at(i, k).times(right.scalars[column * right.rows + k].number());
            product.push(Value::Number((1..inner).map(term).fold(term(0), Interval::plus)));
        }
    }
    product
}

fn constant(literal: Literal) -> Known<Value> {
    match literal {
        Literal::F32(x) => Some(Value::Number(Interval::of_bits(x.to_bits()))),
        Literal::U32(x) => Some(Value::Word(x)),
        Literal::I32(x) => Some(Value::Word(x as u32)),
        Literal::Bool(x) => Some(Value::Word(u32::from(x))),
        _ => None,
    }
}

/// A value conversion to or from f32.
fn converted(value: Value, from: ScalarKind, to: ScalarKind) -> Known<Value> {
    let whole = |f: &dyn Fn(f64) -> u32| {
        let Interval { low, high } = value.number();
        let same = !value.number().is_any() && f(low) == f(high);
        if same { Value::Word(f(low)) } else { Value::Any }
    };
    let near = |x: f64| Some(Value::Number(Interval::exactly(x).rounded()));
    match (from, to, value) {
        (ScalarKind::Float, ScalarKind::Float, _) => Some(value),
        // The bounds are the largest f32 below 2^31 and 2^32.
        (ScalarKind::Float, ScalarKind::Sint, _) => {
            Some(whole(&|x| x.clamp(f64::from(i32::MIN), 2_147_483_520.0) as i32 as u32))
        }
        (ScalarKind::Float, ScalarKind::Uint, _) => Some(whole(&|x| x.clamp(0.0, 4_294_967_040.0) as u32)),
        (ScalarKind::Float, ScalarKind::Bool, _) => {
            relation(BinaryOperator::NotEqual, value.number(), Interval::exactly(0.0))
        }
        (ScalarKind::Sint, ScalarKind::Float, Value::Word(word)) => near(f64::from(word as i32)),
        (ScalarKind::Uint, ScalarKind::Float, Value::Word(word)) => near(f64::from(word)),
        _ => None,
    }
}

/// A reinterpretation of bits: those of zero, of subnormal numbers and of NaN may change on the way.
fn recast(value: Value, to: ScalarKind) -> Value {
    match (value, to == ScalarKind::Float) {
        (Value::Word(word), true) => Value::Number(Interval::of_bits(word)),
        (Value::Number(x), false) if x.low == x.high && x.low != 0.0 => Value::Word((x.low as f32).to_bits()),
        (Value::Number(_), false) => Value::Any,
        _ => value,
    }
}

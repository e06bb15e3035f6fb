//! Expressions: to words, component by component, in the order naga's `Emit` asks for.

use std::rc::Rc;

use naga::{BinaryOperator, Expression, Handle, ScalarKind, TypeInner, UnaryOperator};

use super::build::{Builder, Fail, Value};
use super::constant::literal_word;
use super::place::Place;
use super::tree::{Op, Val};
use crate::code::{BinOp, TernOp, UnOp};

const ONE: u32 = 0x3f80_0000;

impl<'m> Builder<'m> {
    /// The type of an expression of the function being built.
    pub(super) fn type_of(&self, handle: Handle<Expression>) -> TypeInner {
        let frame = self.frames.last().expect("a function is being built");
        frame.info[handle].ty.inner_with(&self.module.types).clone()
    }

    /// Scalar kind of a value's words.
    pub(super) fn kind_of(&self, handle: Handle<Expression>) -> ScalarKind {
        self.type_of(handle).scalar_kind().unwrap_or(ScalarKind::Uint)
    }

    /// Words of a value.
    pub(super) fn words(&mut self, handle: Handle<Expression>) -> Result<Rc<[Val]>, Fail> {
        match self.value(handle)? {
            Value::Words(words) => Ok(words),
            Value::Place(_) => Err(Fail::unsupported("a pointer used as a value", None)),
        }
    }

    /// The only word of a scalar.
    pub(super) fn word(&mut self, handle: Handle<Expression>) -> Result<Val, Fail> {
        Ok(self.words(handle)?[0])
    }

    /// What a pointer points to.
    pub(super) fn place(&mut self, handle: Handle<Expression>) -> Result<Place, Fail> {
        match self.value(handle)? {
            Value::Place(place) => Ok(place),
            Value::Words(_) => Err(Fail::unsupported("a value used as a pointer", None)),
        }
    }

    /// The value of an expression, evaluated now if it was not before.
    pub(super) fn value(&mut self, handle: Handle<Expression>) -> Result<Value, Fail> {
        let frame = self.frame_mut();
        if let Some(value) = &frame.values[handle.index()] {
            return Ok(value.clone());
        }
        let span = frame.function.expressions.get_span(handle);
        let words = frame.info[handle].ty.inner_with(&self.module.types);
        let words = if words.pointer_space().is_some() { 1 } else { self.flat(words).unwrap_or(1) };
        self.spend(words).map_err(|e| e.at(span))?;
        let value = self.evaluate(handle, span).map_err(|e| e.at(span))?;
        self.frame_mut().values[handle.index()] = Some(value.clone());
        Ok(value)
    }

    fn evaluate(&mut self, handle: Handle<Expression>, span: naga::Span) -> Result<Value, Fail> {
        let frame = self.frame_mut();
        let function = frame.function;
        let words: Rc<[Val]> = match function.expressions[handle] {
            Expression::FunctionArgument(index) => return Ok(frame.arguments[index as usize].clone()),
            Expression::LocalVariable(local) => return Ok(Value::Place(frame.locals[local.index()].clone())),
            Expression::GlobalVariable(global) => return Ok(Value::Place(self.global(global)?)),
            Expression::Literal(literal) => {
                let word = literal_word(literal)?;
                [self.constant(word)].into()
            }
            Expression::Constant(_) | Expression::Override(_) | Expression::ZeroValue(_) => {
                let words = self.constant_words(&function.expressions, handle)?;
                words.into_iter().map(|word| self.constant(word)).collect()
            }
            Expression::Compose { ref components, .. } => {
                let mut words = Vec::new();
                for component in components {
                    words.extend_from_slice(&self.words(*component)?);
                }
                words.into()
            }
            Expression::Splat { size, value } => vec![self.word(value)?; size as usize].into(),
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.words(vector)?;
                pattern[..size as usize].iter().map(|c| vector[*c as usize]).collect()
            }
            Expression::Access { base, index } => {
                let index = self.word(index)?;
                match self.value(base)? {
                    Value::Place(place) => return Ok(Value::Place(self.at_dynamic(&place, index, span)?)),
                    Value::Words(words) => self.pick(base, &words, index, span)?,
                }
            }
            Expression::AccessIndex { base, index } => match self.value(base)? {
                Value::Place(place) => return Ok(Value::Place(self.at_constant(&place, index, span)?)),
                Value::Words(words) => {
                    let (start, size) = self.part(base, index)?;
                    words[start..start + size].into()
                }
            },
            Expression::Load { pointer } => {
                let place = self.place(pointer)?;
                self.load(&place, span)?.into()
            }
            Expression::Unary { op, expr } => {
                let op = unary_op(op, self.kind_of(expr));
                self.map(expr, |b, a| b.define(Op::Un(op, a)))?
            }
            Expression::Binary { op, left, right } => self.binary(op, left, right)?,
            Expression::Select { condition, accept, reject } => {
                let condition = self.words(condition)?;
                let (accept, reject) = (self.words(accept)?, self.words(reject)?);
                let pick = |i: usize| condition[i.min(condition.len() - 1)];
                let pairs = accept.iter().zip(reject.iter()).enumerate();
                pairs.map(|(i, (&a, &r))| self.define(Op::Tern(TernOp::Select, pick(i), a, r))).collect()
            }
            Expression::Relational { fun, argument } => self.relational(fun, argument)?,
            Expression::Math { fun, arg, arg1, arg2, arg3 } => self.math(fun, [Some(arg), arg1, arg2, arg3])?,
            Expression::As { expr, kind, convert } => self.convert(expr, kind, convert)?,
            Expression::ArrayLength(array) => {
                let place = self.place(array)?;
                [self.array_length(&place)?].into()
            }
            ref other => {
                let name = format!("{other:?}");
                let name = name.split([' ', '(', '{']).next().unwrap_or("this").to_owned();
                return Err(Fail::unsupported(format!("the expression {name}"), Some(span)));
            }
        };
        Ok(Value::Words(words))
    }

    /// Applies `f` to each word.
    pub(super) fn map(
        &mut self,
        handle: Handle<Expression>,
        mut f: impl FnMut(&mut Self, Val) -> Val,
    ) -> Result<Rc<[Val]>, Fail> {
        let words = self.words(handle)?;
        Ok(words.iter().map(|&word| f(self, word)).collect())
    }

    /// First word and number of words of a member of a value.
    fn part(&self, base: Handle<Expression>, index: u32) -> Result<(usize, usize), Fail> {
        let ty = self.type_of(base);
        let index = index as usize;
        Ok(match ty {
            TypeInner::Vector { .. } => (index, 1),
            TypeInner::Matrix { rows, .. } => (index * rows as usize, rows as usize),
            TypeInner::Array { base, .. } => {
                let each = self.flat(self.inner(base))? as usize;
                (index * each, each)
            }
            TypeInner::Struct { members, .. } => {
                let mut start = 0;
                for member in &members[..index] {
                    start += self.flat(self.inner(member.ty))? as usize;
                }
                (start, self.flat(self.inner(members[index].ty))? as usize)
            }
            _ => return Err(Fail::unsupported("a member of this type", None)),
        })
    }

    /// An element of a value at a run-time index: a chain of selects.
    fn pick(
        &mut self,
        base: Handle<Expression>,
        words: &[Val],
        index: Val,
        span: naga::Span,
    ) -> Result<Rc<[Val]>, Fail> {
        self.spend(words.len() as u32)?;
        let (_, each) = self.part(base, 0)?;
        let count = words.len() / each.max(1);
        let length = self.constant(count as u32);
        let site = self.site(span);
        let index = self.define(Op::Check { index, length, site });
        let mut result = words[..each].to_vec();
        for element in 1..count {
            let number = self.constant(element as u32);
            let here = self.define(Op::Bin(BinOp::Eq, index, number));
            for (word, &candidate) in result.iter_mut().zip(&words[element * each..]) {
                *word = self.define(Op::Tern(TernOp::Select, here, candidate, *word));
            }
        }
        Ok(result.into())
    }

    fn binary(
        &mut self,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Result<Rc<[Val]>, Fail> {
        let (ty, other) = (self.type_of(left), self.type_of(right));
        let (a, b) = (self.words(left)?, self.words(right)?);
        if op == BinaryOperator::Multiply {
            match (&ty, &other) {
                (TypeInner::Matrix { rows, .. }, TypeInner::Vector { .. }) => {
                    return Ok(self.matrix_vector(&a, &b, *rows as usize));
                }
                (TypeInner::Vector { .. }, TypeInner::Matrix { rows, .. }) => {
                    let rows = *rows as usize;
                    return Ok(b.chunks(rows).map(|column| self.dot_f(&a, column)).collect());
                }
                (TypeInner::Matrix { rows, .. }, TypeInner::Matrix { rows: inner, .. }) => {
                    let (rows, inner) = (*rows as usize, *inner as usize);
                    let columns: Vec<Rc<[Val]>> =
                        b.chunks(inner).map(|column| self.matrix_vector(&a, column, rows)).collect();
                    return Ok(columns.iter().flat_map(|c| c.iter().copied()).collect());
                }
                _ => {}
            }
        }
        let (bin, swap) = binary_op(op, ty.scalar_kind().unwrap_or(ScalarKind::Uint));
        let count = a.len().max(b.len());
        let at = |words: &[Val], i: usize| if words.len() == 1 { words[0] } else { words[i] };
        let mut result = Vec::with_capacity(count);
        for i in 0..count {
            let (x, y) = (at(&a, i), at(&b, i));
            let (x, y) = if swap { (y, x) } else { (x, y) };
            result.push(self.define(Op::Bin(bin, x, y)));
        }
        Ok(result.into())
    }

    fn matrix_vector(&mut self, matrix: &[Val], vector: &[Val], rows: usize) -> Rc<[Val]> {
        (0..rows)
            .map(|row| {
                let line: Vec<Val> = matrix.iter().skip(row).step_by(rows).copied().collect();
                self.dot_f(&line, vector)
            })
            .collect()
    }

    /// Sum of products from component 0 upward, each rounded.
    pub(super) fn dot_f(&mut self, a: &[Val], b: &[Val]) -> Val {
        self.dot_with(a, b, BinOp::MulF, BinOp::AddF)
    }

    pub(super) fn dot_with(&mut self, a: &[Val], b: &[Val], mul: BinOp, add: BinOp) -> Val {
        let mut sum = self.define(Op::Bin(mul, a[0], b[0]));
        for (&x, &y) in a[1..].iter().zip(&b[1..]) {
            let product = self.define(Op::Bin(mul, x, y));
            sum = self.define(Op::Bin(add, sum, product));
        }
        sum
    }

    fn relational(&mut self, fun: naga::RelationalFunction, argument: Handle<Expression>) -> Result<Rc<[Val]>, Fail> {
        let words = self.words(argument)?;
        let reduce = |b: &mut Self, op: BinOp| {
            let first = words[0];
            words[1..].iter().fold(first, |sum, &word| b.define(Op::Bin(op, sum, word)))
        };
        Ok(match fun {
            naga::RelationalFunction::All => [reduce(self, BinOp::And)].into(),
            naga::RelationalFunction::Any => [reduce(self, BinOp::Or)].into(),
            naga::RelationalFunction::IsNan => {
                words.iter().map(|&word| self.define(Op::Bin(BinOp::NeF, word, word))).collect()
            }
            naga::RelationalFunction::IsInf => {
                let infinity = self.constant(f32::INFINITY.to_bits());
                let test = |&word: &Val| {
                    let magnitude = self.define(Op::Un(UnOp::AbsF, word));
                    self.define(Op::Bin(BinOp::Eq, magnitude, infinity))
                };
                words.iter().map(test).collect()
            }
        })
    }

    fn convert(
        &mut self,
        expr: Handle<Expression>,
        to: ScalarKind,
        width: Option<naga::Bytes>,
    ) -> Result<Rc<[Val]>, Fail> {
        if width.is_some_and(|w| w != 4 && to != ScalarKind::Bool) {
            return Err(Fail::unsupported("a conversion to a type that is not 32 bits wide", None));
        }
        let from = self.kind_of(expr);
        if width.is_none() {
            return self.words(expr);
        }
        self.map(expr, |b, a| b.convert_word(a, from, to))
    }

    fn convert_word(&mut self, a: Val, from: ScalarKind, to: ScalarKind) -> Val {
        use ScalarKind::{Bool, Float, Sint, Uint};
        let op = match (from, to) {
            (Bool, Bool) | (Uint | Sint, Uint | Sint) | (Float, Float) => return a,
            (Bool, _) => {
                let one = self.constant(if to == Float { ONE } else { 1 });
                return self.define(Op::Bin(BinOp::And, a, one));
            }
            (_, Bool) => {
                let zero = self.constant(0);
                let op = if from == Float { BinOp::NeF } else { BinOp::Ne };
                return self.define(Op::Bin(op, a, zero));
            }
            (Float, Sint) => UnOp::FloatToInt,
            (Float, _) => UnOp::FloatToUint,
            (Sint, _) => UnOp::IntToFloat,
            _ => UnOp::UintToFloat,
        };
        self.define(Op::Un(op, a))
    }
}

fn unary_op(op: UnaryOperator, kind: ScalarKind) -> UnOp {
    match (op, kind) {
        (UnaryOperator::Negate, ScalarKind::Float) => UnOp::NegF,
        (UnaryOperator::Negate, _) => UnOp::NegI,
        _ => UnOp::Not,
    }
}

/// The operation on words, and whether its operands change places.
fn binary_op(op: BinaryOperator, kind: ScalarKind) -> (BinOp, bool) {
    let by = |float: BinOp, signed: BinOp, unsigned: BinOp| match kind {
        ScalarKind::Float => float,
        ScalarKind::Sint => signed,
        _ => unsigned,
    };
    let plain = match op {
        BinaryOperator::Add => by(BinOp::AddF, BinOp::Add, BinOp::Add),
        BinaryOperator::Subtract => by(BinOp::SubF, BinOp::Sub, BinOp::Sub),
        BinaryOperator::Multiply => by(BinOp::MulF, BinOp::Mul, BinOp::Mul),
        BinaryOperator::Divide => by(BinOp::DivF, BinOp::DivI, BinOp::DivU),
        BinaryOperator::Modulo => by(BinOp::RemF, BinOp::RemI, BinOp::RemU),
        BinaryOperator::Equal => by(BinOp::EqF, BinOp::Eq, BinOp::Eq),
        BinaryOperator::NotEqual => by(BinOp::NeF, BinOp::Ne, BinOp::Ne),
        BinaryOperator::Less | BinaryOperator::Greater => by(BinOp::LtF, BinOp::LtI, BinOp::LtU),
        BinaryOperator::LessEqual | BinaryOperator::GreaterEqual => by(BinOp::LeF, BinOp::LeI, BinOp::LeU),
        BinaryOperator::And | BinaryOperator::LogicalAnd => BinOp::And,
        BinaryOperator::InclusiveOr | BinaryOperator::LogicalOr => BinOp::Or,
        BinaryOperator::ExclusiveOr => BinOp::Xor,
        BinaryOperator::ShiftLeft => BinOp::Shl,
        BinaryOperator::ShiftRight => by(BinOp::ShrU, BinOp::ShrI, BinOp::ShrU),
    };
    (plain, matches!(op, BinaryOperator::Greater | BinaryOperator::GreaterEqual))
}

//! Operators and builtin functions on values, each through the pinned scalar functions.

use naga::{BinaryOperator as Op, MathFunction as Fun, RelationalFunction, UnaryOperator};
use sightlines_backend::Result;
use sightlines_backend_cpu::math as m;

use super::unsupported;
use super::value::Value::{self, Bool, Composite, F32, I32, U32};
use super::value::scalarwise;

pub(crate) fn unary(op: UnaryOperator, x: &Value) -> Result<Value> {
    scalarwise(&[x], &|x| match (op, x[0]) {
        (UnaryOperator::Negate, F32(x)) => Ok(F32(-x)),
        (UnaryOperator::Negate, I32(x)) => Ok(I32(x.wrapping_neg())),
        (UnaryOperator::LogicalNot, Bool(x)) => Ok(Bool(!x)),
        (UnaryOperator::BitwiseNot, I32(x)) => Ok(I32(!x)),
        (UnaryOperator::BitwiseNot, U32(x)) => Ok(U32(!x)),
        (op, x) => unsupported(format!("{op:?} of {x:?}")),
    })
}

pub(crate) fn binary(op: Op, x: &Value, y: &Value) -> Result<Value> {
    if op == Op::Multiply {
        match (x.is_matrix(), y.is_matrix(), y) {
            (true, true, Composite(columns)) => {
                return Ok(Composite(columns.iter().map(|column| matrix_times_vector(x, column)).collect()));
            }
            (true, false, Composite(_)) => return Ok(matrix_times_vector(x, y)),
            (false, true, Composite(columns)) if matches!(x, Composite(_)) => {
                return Ok(Value::vector(columns.iter().map(|column| m::dot(&x.floats(), &column.floats()))));
            }
            _ => {}
        }
    }
    scalarwise(&[x, y], &|args| match (args[0], args[1]) {
        (Bool(x), Bool(y)) => bools(op, *x, *y),
        (I32(x), I32(y)) => i32s(op, *x, *y),
        (U32(x), U32(y)) => u32s(op, *x, *y),
        (F32(x), F32(y)) => f32s(op, *x, *y),
        (I32(x), U32(y)) if op == Op::ShiftLeft => Ok(I32(m::shl(*x as u32, *y) as i32)),
        (I32(x), U32(y)) if op == Op::ShiftRight => Ok(I32(m::shr_i32(*x, *y))),
        (x, y) => unsupported(format!("{op:?} of {x:?} and {y:?}")),
    })
}

/// Row r of the product is the dot product of the matrix's row r and the vector.
fn matrix_times_vector(matrix: &Value, vector: &Value) -> Value {
    let columns: Vec<Vec<f32>> = matrix.parts().iter().map(Value::floats).collect();
    let row = |r| columns.iter().map(|c: &Vec<f32>| c[r]).collect::<Vec<_>>();
    Value::vector((0..columns[0].len()).map(|r| m::dot(&row(r), &vector.floats())))
}

/// Comparisons, the same for every ordered type.
fn compare<T: PartialOrd>(op: Op, x: T, y: T) -> Option<bool> {
    Some(match op {
        Op::Equal => x == y,
        Op::NotEqual => x != y,
        Op::Less => x < y,
        Op::LessEqual => x <= y,
        Op::Greater => x > y,
        Op::GreaterEqual => x >= y,
        _ => return None,
    })
}

fn bools(op: Op, x: bool, y: bool) -> Result<Value> {
    Ok(Bool(match op {
        Op::Equal => x == y,
        Op::NotEqual | Op::ExclusiveOr => x != y,
        Op::And | Op::LogicalAnd => x && y,
        Op::InclusiveOr | Op::LogicalOr => x || y,
        _ => return unsupported(format!("{op:?} of bool")),
    }))
}

fn i32s(op: Op, x: i32, y: i32) -> Result<Value> {
    if let Some(order) = compare(op, x, y) {
        return Ok(Bool(order));
    }
    Ok(I32(match op {
        Op::Add => x.wrapping_add(y),
        Op::Subtract => x.wrapping_sub(y),
        Op::Multiply => x.wrapping_mul(y),
        Op::Divide => m::div_i32(x, y),
        Op::Modulo => m::rem_i32(x, y),
        Op::And => x & y,
        Op::InclusiveOr => x | y,
        Op::ExclusiveOr => x ^ y,
        _ => return unsupported(format!("{op:?} of i32")),
    }))
}

fn u32s(op: Op, x: u32, y: u32) -> Result<Value> {
    if let Some(order) = compare(op, x, y) {
        return Ok(Bool(order));
    }
    Ok(U32(match op {
        Op::Add => x.wrapping_add(y),
        Op::Subtract => x.wrapping_sub(y),
        Op::Multiply => x.wrapping_mul(y),
        Op::Divide => m::div_u32(x, y),
        Op::Modulo => m::rem_u32(x, y),
        Op::And => x & y,
        Op::InclusiveOr => x | y,
        Op::ExclusiveOr => x ^ y,
        Op::ShiftLeft => m::shl(x, y),
        Op::ShiftRight => m::shr_u32(x, y),
        _ => return unsupported(format!("{op:?} of u32")),
    }))
}

fn f32s(op: Op, x: f32, y: f32) -> Result<Value> {
    if let Some(order) = compare(op, x, y) {
        return Ok(Bool(order));
    }
    Ok(F32(match op {
        Op::Add => x + y,
        Op::Subtract => x - y,
        Op::Multiply => x * y,
        Op::Divide => x / y,
        Op::Modulo => m::rem_f32(x, y),
        _ => return unsupported(format!("{op:?} of f32")),
    }))
}

pub(crate) fn select(condition: &Value, accept: &Value, reject: &Value) -> Value {
    match condition {
        Composite(conditions) => {
            let pick = |(i, c): (usize, &Value)| if c.bool() { &accept.parts()[i] } else { &reject.parts()[i] };
            Composite(conditions.iter().enumerate().map(|c| pick(c).clone()).collect())
        }
        scalar if scalar.bool() => accept.clone(),
        _ => reject.clone(),
    }
}

pub(crate) fn relational(fun: RelationalFunction, x: &Value) -> Result<Value> {
    match fun {
        RelationalFunction::All => Ok(Bool(x.parts().iter().all(Value::bool))),
        RelationalFunction::Any => Ok(Bool(x.parts().iter().any(Value::bool))),
        RelationalFunction::IsNan => scalarwise(&[x], &|x| Ok(Bool(x[0].f32().is_nan()))),
        RelationalFunction::IsInf => scalarwise(&[x], &|x| Ok(Bool(x[0].f32().is_infinite()))),
    }
}

pub(crate) fn math(fun: Fun, args: &[&Value]) -> Result<Value> {
    match whole(fun, args) {
        Some(value) => Ok(value),
        None => scalarwise(args, &|args| scalar(fun, args)),
    }
}

fn array<T: Copy, const N: usize>(items: &[T]) -> [T; N] {
    std::array::from_fn(|i| items[i])
}

/// Functions that look at more than one component at once.
fn whole(fun: Fun, args: &[&Value]) -> Option<Value> {
    let floats = |i: usize| args[i].floats();
    let word = |i: usize| args[i].word();
    Some(match fun {
        Fun::Dot => return Some(dot(args[0], args[1])),
        Fun::Cross => Value::vector(m::cross(array(&floats(0)), array(&floats(1)))),
        Fun::Length => F32(m::length(&floats(0))),
        Fun::Distance => F32(m::distance(&floats(0), &floats(1))),
        Fun::Normalize => Value::vector(m::normalize(&floats(0))),
        Fun::FaceForward => Value::vector(m::face_forward(&floats(0), &floats(1), &floats(2))),
        Fun::Reflect => Value::vector(m::reflect(&floats(0), &floats(1))),
        Fun::Refract => Value::vector(m::refract(&floats(0), &floats(1), args[2].f32())),
        Fun::Determinant => F32(m::determinant(&args[0].parts().iter().map(Value::floats).collect::<Vec<_>>())),
        Fun::Transpose => {
            let columns: Vec<Vec<f32>> = args[0].parts().iter().map(Value::floats).collect();
            let row = |r| Value::vector(columns.iter().map(|c: &Vec<f32>| c[r]));
            Composite((0..columns[0].len()).map(row).collect())
        }
        Fun::Modf | Fun::Frexp => return Some(split(fun, args[0])),
        Fun::Dot4I8Packed => I32(m::dot4_i8_packed(word(0), word(1))),
        Fun::Dot4U8Packed => U32(m::dot4_u8_packed(word(0), word(1))),
        Fun::Pack4x8snorm => U32(m::pack4x8_snorm(array(&floats(0)))),
        Fun::Pack4x8unorm => U32(m::pack4x8_unorm(array(&floats(0)))),
        Fun::Pack2x16snorm => U32(m::pack2x16_snorm(array(&floats(0)))),
        Fun::Pack2x16unorm => U32(m::pack2x16_unorm(array(&floats(0)))),
        Fun::Pack2x16float => U32(m::pack2x16_float(array(&floats(0)))),
        Fun::Pack4xI8 | Fun::Pack4xU8 => U32(m::pack4x_8(array(&args[0].words()))),
        Fun::Pack4xI8Clamp => U32(m::pack4x_i8_clamp(array::<u32, 4>(&args[0].words()).map(|x| x as i32))),
        Fun::Pack4xU8Clamp => U32(m::pack4x_u8_clamp(array(&args[0].words()))),
        Fun::Unpack4x8snorm => Value::vector(m::unpack4x8_snorm(word(0))),
        Fun::Unpack4x8unorm => Value::vector(m::unpack4x8_unorm(word(0))),
        Fun::Unpack2x16snorm => Value::vector(m::unpack2x16_snorm(word(0))),
        Fun::Unpack2x16unorm => Value::vector(m::unpack2x16_unorm(word(0))),
        Fun::Unpack2x16float => Value::vector(m::unpack2x16_float(word(0))),
        Fun::Unpack4xI8 => Composite(m::unpack4x_i8(word(0)).map(I32).to_vec()),
        Fun::Unpack4xU8 => Composite(m::unpack4x_u8(word(0)).map(U32).to_vec()),
        _ => return None,
    })
}

fn dot(x: &Value, y: &Value) -> Value {
    let pairs = || x.words().into_iter().zip(y.words()).map(|(x, y)| x.wrapping_mul(y));
    match &x.parts()[0] {
        I32(_) => I32(pairs().fold(0, u32::wrapping_add) as i32),
        U32(_) => U32(pairs().fold(0, u32::wrapping_add)),
        _ => F32(m::dot(&x.floats(), &y.floats())),
    }
}

/// `modf` and `frexp`: a structure of two scalars or two vectors.
fn split(fun: Fun, x: &Value) -> Value {
    let pair = |x: f32| match fun {
        Fun::Modf => (F32(m::modf(x).0), F32(m::modf(x).1)),
        _ => (F32(m::frexp(x).0), I32(m::frexp(x).1)),
    };
    let (first, second): (Vec<Value>, Vec<Value>) = x.floats().into_iter().map(pair).unzip();
    match x {
        Composite(_) => Composite(vec![Composite(first), Composite(second)]),
        _ => Composite(first.into_iter().chain(second).collect()),
    }
}

fn scalar(fun: Fun, args: &[&Value]) -> Result<Value> {
    match args {
        [F32(x)] => float1(fun, *x),
        [F32(x), F32(y)] => float2(fun, *x, *y),
        [F32(x), F32(y), F32(z)] => float3(fun, *x, *y, *z),
        [F32(x), I32(e)] if fun == Fun::Ldexp => Ok(F32(m::ldexp(*x, *e))),
        [I32(x), rest @ ..] => signed(fun, *x, rest),
        [U32(x), rest @ ..] => unsigned(fun, *x, rest),
        _ => unsupported(format!("{fun:?} of {args:?}")),
    }
}

fn float1(fun: Fun, x: f32) -> Result<Value> {
    Ok(F32(match fun {
        Fun::Abs => x.abs(),
        Fun::Saturate => m::saturate(x),
        Fun::Cos => m::cos(x),
        Fun::Cosh => m::cosh(x),
        Fun::Sin => m::sin(x),
        Fun::Sinh => m::sinh(x),
        Fun::Tan => m::tan(x),
        Fun::Tanh => m::tanh(x),
        Fun::Acos => m::acos(x),
        Fun::Asin => m::asin(x),
        Fun::Atan => m::atan(x),
        Fun::Asinh => m::asinh(x),
        Fun::Acosh => m::acosh(x),
        Fun::Atanh => m::atanh(x),
        Fun::Radians => m::radians(x),
        Fun::Degrees => m::degrees(x),
        Fun::Ceil => m::ceil(x),
        Fun::Floor => m::floor(x),
        Fun::Round => m::round(x),
        Fun::Fract => m::fract(x),
        Fun::Trunc => m::trunc(x),
        Fun::Exp => m::exp(x),
        Fun::Exp2 => m::exp2(x),
        Fun::Log => m::log(x),
        Fun::Log2 => m::log2(x),
        Fun::Sign => m::sign_f32(x),
        Fun::Sqrt => x.sqrt(),
        Fun::InverseSqrt => m::inverse_sqrt(x),
        Fun::QuantizeToF16 => m::quantize_to_f16(x),
        _ => return unsupported(format!("{fun:?} of one f32")),
    }))
}

fn float2(fun: Fun, x: f32, y: f32) -> Result<Value> {
    Ok(F32(match fun {
        Fun::Min => m::min_f32(x, y),
        Fun::Max => m::max_f32(x, y),
        Fun::Atan2 => m::atan2(x, y),
        Fun::Pow => m::pow(x, y),
        Fun::Step => m::step(x, y),
        _ => return unsupported(format!("{fun:?} of two f32")),
    }))
}

fn float3(fun: Fun, x: f32, y: f32, z: f32) -> Result<Value> {
    Ok(F32(match fun {
        Fun::Clamp => m::clamp_f32(x, y, z),
        Fun::Fma => m::fma(x, y, z),
        Fun::Mix => m::mix(x, y, z),
        Fun::SmoothStep => m::smoothstep(x, y, z),
        _ => return unsupported(format!("{fun:?} of three f32")),
    }))
}

fn signed(fun: Fun, x: i32, rest: &[&Value]) -> Result<Value> {
    let other = |i: usize| rest[i].word() as i32;
    Ok(I32(match fun {
        Fun::Abs => m::abs_i32(x),
        Fun::Sign => m::sign_i32(x),
        Fun::Min => x.min(other(0)),
        Fun::Max => x.max(other(0)),
        Fun::Clamp => m::clamp_i32(x, other(0), other(1)),
        Fun::FirstLeadingBit => m::first_leading_bit_i32(x),
        Fun::ExtractBits => m::extract_bits_i32(x, rest[0].word(), rest[1].word()),
        _ => return bits(fun, x as u32, rest).map(|x| I32(x as i32)),
    }))
}

fn unsigned(fun: Fun, x: u32, rest: &[&Value]) -> Result<Value> {
    let other = |i: usize| rest[i].word();
    Ok(U32(match fun {
        Fun::Abs => x,
        Fun::Min => x.min(other(0)),
        Fun::Max => x.max(other(0)),
        Fun::Clamp => m::clamp_u32(x, other(0), other(1)),
        Fun::FirstLeadingBit => m::first_leading_bit_u32(x),
        Fun::ExtractBits => m::extract_bits_u32(x, other(0), other(1)),
        _ => return bits(fun, x, rest).map(U32),
    }))
}

/// Functions that do not care about the sign.
fn bits(fun: Fun, x: u32, rest: &[&Value]) -> Result<u32> {
    Ok(match fun {
        Fun::CountTrailingZeros => m::count_trailing_zeros(x),
        Fun::CountLeadingZeros => m::count_leading_zeros(x),
        Fun::CountOneBits => m::count_one_bits(x),
        Fun::ReverseBits => m::reverse_bits(x),
        Fun::FirstTrailingBit => m::first_trailing_bit(x),
        Fun::InsertBits => m::insert_bits(x, rest[0].word(), rest[1].word(), rest[2].word()),
        _ => return unsupported(format!("{fun:?} of integers")),
    })
}

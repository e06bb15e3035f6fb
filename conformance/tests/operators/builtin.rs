//! The entries of WGSL's accuracy table for the builtin functions, and comparisons.

use std::f64::consts::{LN_2, PI};

use naga::{BinaryOperator, MathFunction as Fun};

use crate::interval::Interval;
use crate::latitude::{Value, Values};

/// A comparison: NaN and subnormal numbers leave it open.
pub(crate) fn relation(op: BinaryOperator, a: Interval, b: Interval) -> Option<Value> {
    let meets = |f: &dyn Fn(f64, f64) -> bool| {
        let known = !a.is_any() && !b.is_any();
        let answers = [f(a.low, b.low), f(a.low, b.high), f(a.high, b.low), f(a.high, b.high)];
        let same = known && answers.iter().all(|&answer| answer == answers[0]);
        if same { Value::Word(u32::from(answers[0])) } else { Value::Any }
    };
    Some(match op {
        BinaryOperator::Equal => meets(&|a, b| a == b),
        BinaryOperator::NotEqual => meets(&|a, b| a != b),
        BinaryOperator::Less => meets(&|a, b| a < b),
        BinaryOperator::LessEqual => meets(&|a, b| a <= b),
        BinaryOperator::Greater => meets(&|a, b| a > b),
        BinaryOperator::GreaterEqual => meets(&|a, b| a >= b),
        _ => return None,
    })
}

/// A builtin function; `None` where this table has no entry for it on f32.
pub(crate) fn math(fun: Fun, arguments: &[Values]) -> Option<Values> {
    if let Some(values) = whole(fun, arguments) {
        return Some(values);
    }
    let width = arguments.iter().map(|argument| argument.scalars.len()).max()?;
    let rows = (0..width).map(|i| {
        let row: Vec<Value> = arguments.iter().map(|argument| argument.at(i)).collect();
        scalar(fun, &row)
    });
    let rows = rows.collect::<Option<Vec<_>>>()?;
    // What returns two values returns all of the first, then all of the second.
    let each = rows.first()?.len();
    Some(Values::vector((0..each).flat_map(|part| rows.iter().map(move |row| row[part])).collect()))
}

/// Functions of one component.
fn scalar(fun: Fun, row: &[Value]) -> Option<Vec<Value>> {
    if !row.iter().any(|value| matches!(value, Value::Number(_))) {
        return None;
    }
    let x = row[0].number();
    let y = row.get(1).map_or(Interval::ANY, |value| value.number());
    let z = row.get(2).map_or(Interval::ANY, |value| value.number());
    let one = Interval::exactly(1.0);
    let number = match fun {
        Fun::Abs => x.abs(),
        Fun::Sign => x.monotone(|x| if x == 0.0 { 0.0 } else { x.signum() }),
        Fun::Floor => x.monotone(f64::floor),
        Fun::Ceil => x.monotone(f64::ceil),
        Fun::Trunc => x.monotone(f64::trunc),
        Fun::Round => x.monotone(f64::round_ties_even),
        Fun::Fract => fract(x),
        Fun::Min => x.monotone2(y, f64::min),
        Fun::Max => x.monotone2(y, f64::max),
        Fun::Clamp if y.low > z.high => Interval::ANY,
        Fun::Clamp => x.monotone2(y, f64::max).monotone2(z, f64::min),
        Fun::Saturate => x.monotone(|x| x.clamp(0.0, 1.0)),
        Fun::Step => match relation(BinaryOperator::LessEqual, x, y)? {
            Value::Word(word) => Interval::exactly(f64::from(word)),
            _ => Interval::ANY,
        },
        Fun::Mix => x.times(one.minus(z)).plus(y.times(z)).or(x.plus(y.minus(x).times(z))),
        Fun::SmoothStep => smooth_step(x, y, z),
        Fun::Fma => x.times(y).plus(z),
        Fun::Degrees => x.times(Interval::exactly(180.0 / PI).ulps(1.0)),
        Fun::Radians => x.times(Interval::exactly(PI / 180.0).ulps(1.0)),
        Fun::Sqrt => x.sqrt(),
        Fun::InverseSqrt => x.inverse_sqrt(),
        Fun::QuantizeToF16 => half(x),
        Fun::Exp => x.exp(libm::exp),
        Fun::Exp2 => x.exp(libm::exp2),
        Fun::Log => x.log(libm::log),
        Fun::Log2 => x.log(libm::log2),
        Fun::Pow => x.log(libm::log2).times(y).exp(libm::exp2),
        Fun::Modf => {
            let whole = x.monotone(f64::trunc);
            return Some(vec![Value::Number(x.minus(whole)), Value::Number(whole)]);
        }
        Fun::Frexp => return frexp(x),
        Fun::Ldexp => ldexp(x, row.get(1)?),
        _ => transcendental(fun, x, y)?,
    };
    Some(vec![Value::Number(number)])
}

fn transcendental(fun: Fun, x: Interval, y: Interval) -> Option<Interval> {
    let one = Interval::exactly(1.0);
    Some(match fun {
        Fun::Sin => x.wave(libm::sin),
        Fun::Cos => x.wave(libm::cos),
        Fun::Tan => x.wave(libm::sin).over(x.wave(libm::cos)),
        Fun::Asin | Fun::Acos if x.abs().high > 1.0 => Interval::ANY,
        Fun::Asin => x.monotone(libm::asin).within(6.77e-5).or(x.arc(libm::asin)),
        Fun::Acos => x.monotone(libm::acos).within(6.77e-5).or(x.arc(libm::acos)),
        Fun::Atan => x.arc(libm::atan),
        Fun::Atan2 if y.abs().low < f64::from(f32::MIN_POSITIVE) || y.abs().high > libm::exp2(126.0) => Interval::ANY,
        // A quotient that is subnormal may be flushed before the angle is taken.
        Fun::Atan2 => x.monotone2(y, libm::atan2).ulps(4096.0),
        Fun::Sinh => hyperbolic(x, Interval::minus),
        Fun::Cosh => hyperbolic(x, Interval::plus),
        Fun::Tanh => {
            let quotient = hyperbolic(x, Interval::minus).over(hyperbolic(x, Interval::plus));
            quotient.or(x.monotone(libm::tanh).within(1e-5))
        }
        Fun::Asinh => logarithm(x.plus(x.times(x).plus(one).sqrt())),
        Fun::Acosh => logarithm(x.plus(x.times(x).minus(one).sqrt())),
        Fun::Atanh => logarithm(one.plus(x).over(one.minus(x))).times(Interval::exactly(0.5)),
        _ => return None,
    })
}

/// Inherited from `(exp(x) ± exp(-x)) * 0.5`.
fn hyperbolic(x: Interval, join: impl Fn(Interval, Interval) -> Interval) -> Interval {
    join(x.exp(libm::exp), x.negated().exp(libm::exp)).times(Interval::exactly(0.5))
}

/// A natural logarithm, also as a multiple of the binary one.
fn logarithm(x: Interval) -> Interval {
    x.log(libm::log).or(x.log(libm::log2).times(Interval::exactly(LN_2).ulps(1.0)))
}

/// Inherited from `x - floor(x)`, which rounding may bring to 1.
fn fract(x: Interval) -> Interval {
    let floor = x.monotone(f64::floor);
    if floor.low == floor.high {
        x.minus(floor)
    } else if x.is_any() {
        x
    } else {
        Interval { low: 0.0, high: 1.0 }
    }
}

fn smooth_step(low: Interval, high: Interval, x: Interval) -> Interval {
    let t = x.minus(low).over(high.minus(low));
    if t.is_any() || low.low >= high.low {
        return Interval::ANY;
    }
    let t = t.clamped(0.0, 1.0);
    let curve = Interval::exactly(3.0).minus(Interval::exactly(2.0).times(t));
    t.times(t.times(curve))
}

/// Rounded to either neighbour among the binary16 numbers; subnormal ones may be flushed.
fn half(x: Interval) -> Interval {
    if x.abs().high > 65504.0 {
        return Interval::ANY;
    }
    let step = |x: f64| libm::exp2(f64::from(libm::ilogb(x.abs().max(libm::exp2(-14.0))) - 10));
    let near = |x: f64, f: fn(f64) -> f64| f(x / step(x)) * step(x);
    let rounded = Interval { low: near(x.low, f64::floor), high: near(x.high, f64::ceil) };
    let flushed = x.abs().low < libm::exp2(-14.0);
    if flushed { rounded.or(Interval::exactly(0.0)) } else { rounded }
}

fn frexp(x: Interval) -> Option<Vec<Value>> {
    if x.low != x.high || x.is_any() {
        return Some(vec![Value::Number(Interval::ANY), Value::Any]);
    }
    let (fraction, exponent) = libm::frexp(x.low);
    Some(vec![Value::Number(Interval::exactly(fraction)), Value::Word(exponent as u32)])
}

/// Rounded once; the table asks nothing of an exponent above 128, nor of one where 2^e is no normal number.
fn ldexp(x: Interval, exponent: &Value) -> Interval {
    let Value::Word(exponent) = *exponent else { return Interval::ANY };
    let exponent = exponent as i32;
    if exponent > 128 {
        return Interval::ANY;
    }
    let scaled = x.times(Interval::exactly(libm::exp2(f64::from(exponent.max(-1000)))));
    if exponent < -126 { scaled.or(Interval::exactly(0.0)) } else { scaled }
}

fn sum(terms: impl IntoIterator<Item = Interval>) -> Interval {
    terms.into_iter().reduce(Interval::plus).unwrap_or(Interval::exactly(0.0))
}

fn dot(a: &[Interval], b: &[Interval]) -> Interval {
    sum(a.iter().zip(b).map(|(a, b)| a.times(*b)))
}

fn length(a: &[Interval]) -> Interval {
    if a.len() == 1 { a[0].abs().or(dot(a, a).sqrt()) } else { dot(a, a).sqrt() }
}

/// Functions that look at all components.
fn whole(fun: Fun, arguments: &[Values]) -> Option<Values> {
    if !arguments.iter().flat_map(|argument| &argument.scalars).any(|value| matches!(value, Value::Number(_))) {
        return unpacked(fun, arguments.first()?);
    }
    let parts: Vec<Vec<Interval>> = arguments.iter().map(Values::intervals).collect();
    let each = |f: &dyn Fn(usize) -> Interval| Values::numbers((0..parts[0].len()).map(f));
    let scalar = |x: Interval| Values::numbers([x]);
    let a = parts.first()?;
    let b = || parts.get(1);
    Some(match fun {
        Fun::Dot => scalar(dot(a, b()?)),
        Fun::Length => scalar(length(a)),
        Fun::Distance => scalar(length(&a.iter().zip(b()?).map(|(a, b)| a.minus(*b)).collect::<Vec<_>>())),
        Fun::Normalize => {
            let length = length(a);
            each(&|i| a[i].over(length).or(a[i].times(dot(a, a).inverse_sqrt())))
        }
        Fun::Cross => {
            let b = b()?;
            each(&|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                a[j].times(b[k]).minus(a[k].times(b[j]))
            })
        }
        Fun::FaceForward => {
            let d = dot(b()?, parts.get(2)?);
            match relation(BinaryOperator::Less, d, Interval::exactly(0.0))? {
                Value::Word(1) => each(&|i| a[i]),
                Value::Word(_) => each(&|i| a[i].negated()),
                _ => each(&|i| a[i].or(a[i].negated())),
            }
        }
        Fun::Reflect => {
            let (b, two) = (b()?, Interval::exactly(2.0));
            let d = dot(a, b);
            each(&|i| a[i].minus(two.times(d).times(b[i])))
        }
        Fun::Refract => refract(a, b()?, *parts.get(2)?.first()?),
        // Its error has no bound.
        Fun::Determinant => scalar(Interval::ANY),
        Fun::Transpose => transposed(arguments.first()?),
        Fun::Pack4x8snorm | Fun::Pack4x8unorm | Fun::Pack2x16snorm | Fun::Pack2x16unorm | Fun::Pack2x16float => {
            // Rounding is the formula's, but NaN and infinity may become anything.
            Values::vector(vec![a.iter().any(|x| x.is_any()).then_some(Value::Any)?])
        }
        _ => return None,
    })
}

/// k = 1 - eta^2 (1 - d^2); zeros where k < 0, else eta a - (eta d + sqrt(k)) b.
fn refract(a: &[Interval], b: &[Interval], eta: Interval) -> Values {
    let one = Interval::exactly(1.0);
    let d = dot(a, b);
    let k = one.minus(eta.times(eta).times(one.minus(d.times(d))));
    let scale = eta.times(d).plus(k.sqrt());
    let bent = |i: usize| eta.times(a[i]).minus(scale.times(b[i]));
    match relation(BinaryOperator::Less, k, Interval::exactly(0.0)) {
        Some(Value::Word(1)) => Values::numbers(a.iter().map(|_| Interval::exactly(0.0))),
        Some(Value::Word(_)) => Values::numbers((0..a.len()).map(bent)),
        _ => Values::numbers(a.iter().map(|_| Interval::ANY)),
    }
}

fn transposed(matrix: &Values) -> Values {
    let (columns, rows) = (matrix.rows, matrix.columns);
    let scalars = (0..columns).flat_map(|c| (0..rows).map(move |r| matrix.scalars[r * columns + c])).collect();
    Values { scalars, columns, rows }
}

/// Numbers from packed words: 3 units; binary16 exactly.
fn unpacked(fun: Fun, word: &Values) -> Option<Values> {
    let Value::Word(word) = *word.scalars.first()? else { return None };
    let bytes = word.to_le_bytes();
    let halves = [word as u16, (word >> 16) as u16];
    let near = |x: f64| Interval::exactly(x).ulps(3.0);
    Some(match fun {
        Fun::Unpack4x8snorm => Values::numbers(bytes.map(|b| near((f64::from(b as i8) / 127.0).max(-1.0)))),
        Fun::Unpack4x8unorm => Values::numbers(bytes.map(|b| near(f64::from(b) / 255.0))),
        Fun::Unpack2x16snorm => Values::numbers(halves.map(|h| near((f64::from(h as i16) / 32767.0).max(-1.0)))),
        Fun::Unpack2x16unorm => Values::numbers(halves.map(|h| near(f64::from(h) / 65535.0))),
        Fun::Unpack2x16float => Values::numbers(halves.map(of_half)),
        _ => return None,
    })
}

fn of_half(bits: u16) -> Interval {
    let (exponent, fraction) = (i32::from(bits >> 10 & 31), f64::from(bits & 1023));
    let sign = if bits >> 15 == 0 { 1.0 } else { -1.0 };
    match exponent {
        31 => Interval::ANY,
        0 => Interval::exactly(sign * fraction * libm::exp2(-24.0)).or(Interval::exactly(0.0)),
        _ => Interval::exactly(sign * (1.0 + fraction / 1024.0) * libm::exp2(f64::from(exponent - 15))),
    }
}

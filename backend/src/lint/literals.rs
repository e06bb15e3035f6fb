//! Constants: literals that f32 does not hold, float expressions folded by the compiler, and -2147483648.
//!
//! naga folds const-expressions while it parses, so a literal of the module is compared with the text of its span.

use std::ops::Range;

use naga::{Arena, Expression, Literal, Module};

use super::{Source, Violation};
use crate::text::{self, Kind, Token};

/// Finds violations among literals of the text and of the module.
pub(super) fn check(module: &Module, source: &Source<'_>, found: &mut Vec<Violation>) {
    for token in text::tokens(source.text).filter(|t| t.kind == Kind::Number) {
        let number = &source.text[token.range.clone()];
        if is_float(number) && !is_exact(number) {
            let label = format!("f32 holds {:?}", value(number));
            found.push(Violation { lint: "inexact-literal", range: token.range, label });
        }
    }
    let functions = module.functions.iter().map(|(_, f)| &f.expressions);
    let entries = module.entry_points.iter().map(|e| &e.function.expressions);
    for expressions in functions.chain(entries).chain([&module.global_expressions]) {
        arena(expressions, source, found);
    }
}

fn arena(expressions: &Arena<Expression>, source: &Source<'_>, found: &mut Vec<Violation>) {
    for (handle, expression) in expressions.iter() {
        let Some(range) = expressions.get_span(handle).to_range() else { continue };
        match *expression {
            Expression::Literal(Literal::I32(i32::MIN)) => {
                found.push(Violation { lint: "int-min-literal", range, label: "is -2147483648".into() });
            }
            Expression::Literal(Literal::F32(value)) => float(value, range, source, found),
            _ => {}
        }
    }
}

/// Judges one f32 of the module by the text that it came from.
fn float(value: f32, range: Range<usize>, source: &Source<'_>, found: &mut Vec<Violation>) {
    let range = with_arguments(definition(range, source), source.text);
    let Some(text) = source.text.get(range.clone()) else { return };
    let tokens: Vec<Token> = text::tokens(text).collect();
    let has_float = tokens.iter().any(|t| t.kind == Kind::Number && is_float(&text[t.range.clone()]));
    if let [token] = tokens.as_slice()
        && token.kind == Kind::Number
        && !has_float
    {
        if !is_exact_integer(&text[token.range.clone()], value) {
            found.push(Violation { lint: "inexact-literal", range, label: format!("f32 holds {value:?}") });
        }
        return;
    }
    let integer = !has_float && value.fract() == 0.0 && value.abs() <= 16_777_216.0;
    if computes(text, &tokens) && !integer {
        found.push(Violation { lint: "folded-float", range, label: format!("is folded to {value:?}") });
    }
}

/// Follows the name of a `const` to its initialiser, and constants that only rename another.
fn definition(mut range: Range<usize>, source: &Source<'_>) -> Range<usize> {
    for _ in 0..source.items.len() {
        let Some(name) = source.text.get(range.clone()) else { break };
        let Some(item) = source.named("const", name).map(|index| &source.items[index]) else { break };
        let Some(equals) = source.text[item.name.end..item.range.end].find('=') else { break };
        let value = &source.text[item.name.end + equals + 1..item.range.end - 1];
        let start = item.range.end - 1 - value.trim_start().len();
        range = start..start + value.trim().len();
    }
    range
}

/// Extends the name of a called function, which is the span that naga gives a call, over its arguments.
fn with_arguments(range: Range<usize>, text: &str) -> Range<usize> {
    let (Some(name), Some(rest)) = (text.get(range.clone()), text.get(range.end..)) else { return range };
    if !name.chars().all(|c| c == '_' || c.is_alphanumeric()) || !rest.trim_start().starts_with(['(', '<']) {
        return range;
    }
    let mut depth = 0_u32;
    for token in text::tokens(rest) {
        match token.kind {
            Kind::Punct('(') => depth += 1,
            Kind::Punct(')') if depth == 1 => return range.start..range.end + token.range.end,
            Kind::Punct(')') => depth = depth.saturating_sub(1),
            Kind::Punct(';') => break,
            _ => {}
        }
    }
    range
}

/// Functions that are exact on values that f32 holds, and type constructors.
const EXACT: [&str; 16] = [
    "f32", "array", "abs", "min", "max", "clamp", "select", "floor", "ceil", "trunc", "round", "sign", "saturate",
    "step", "bitcast", "vec",
];

/// Whether the text has an operator or calls a function that may round.
fn computes(text: &str, tokens: &[Token]) -> bool {
    let word = |t: &Token| &text[t.range.clone()];
    tokens.iter().enumerate().any(|(index, token)| {
        let before = index.checked_sub(1).map(|i| &tokens[i]);
        match token.kind {
            Kind::Punct('+' | '*' | '/' | '%') => true,
            Kind::Punct('-') => before.is_some_and(|t| !matches!(t.kind, Kind::Punct(c) if c != ')' && c != ']')),
            Kind::Punct('(') => before.is_some_and(|t| {
                let exact = EXACT.contains(&word(t)) || ["vec", "mat"].iter().any(|p| word(t).starts_with(p));
                t.kind == Kind::Word && !exact
            }),
            _ => false,
        }
    })
}

fn is_hex(number: &str) -> bool {
    number.starts_with("0x") || number.starts_with("0X")
}

/// Whether a numeric literal is a float.
fn is_float(number: &str) -> bool {
    if is_hex(number) {
        return number.contains(['.', 'p', 'P']);
    }
    number.contains(['.', 'e', 'E', 'f', 'h'])
}

fn value(number: &str) -> f32 {
    let digits = number.trim_end_matches(['f', 'h']);
    if is_hex(number) {
        hex(digits).map_or(f32::NAN, |(m, e)| scaled(m, e))
    } else {
        digits.parse().unwrap_or(f32::NAN)
    }
}

/// Whether f32 holds a float literal exactly, as zero or as a normal number.
fn is_exact(number: &str) -> bool {
    let digits = number.trim_end_matches(['f', 'h']);
    let held = value(number);
    if !(held == 0.0 || held.is_normal()) {
        return false;
    }
    if is_hex(number) {
        return hex(digits)
            .is_some_and(|(mantissa, _)| 128 - mantissa.leading_zeros() <= 24 && (held != 0.0 || mantissa == 0));
    }
    // 112 significant digits hold any f32 exactly.
    decimal(digits).is_some_and(|text| decimal(&format!("{held:.120e}")) == Some(text))
}

/// A decimal number as its significant digits and the exponent of the last.
fn decimal(number: &str) -> Option<(String, i64)> {
    let (mantissa, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let significant = digits.trim_end_matches('0');
    let dropped = (digits.len() - significant.len()) as i64;
    let exponent = exponent.parse::<i64>().ok()?.checked_sub(fraction.len() as i64)?.checked_add(dropped)?;
    let significant = significant.trim_start_matches('0');
    Some((significant.to_owned(), if significant.is_empty() { 0 } else { exponent }))
}

/// A hexadecimal float as an odd mantissa, or 0, and a power of two; none where it has more than 124 bits.
fn hex(number: &str) -> Option<(u128, i64)> {
    let (mantissa, exponent) = number[2..].split_once(['p', 'P']).unwrap_or((&number[2..], "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_start_matches('0');
    if digits.is_empty() {
        return Some((0, 0));
    }
    let bits = if digits.len() <= 31 { u128::from_str_radix(digits, 16).ok()? } else { return None };
    let exponent = exponent.parse::<i64>().ok()?.checked_sub(4 * fraction.len() as i64)?;
    let zeros = bits.trailing_zeros();
    Some((bits >> zeros, exponent + i64::from(zeros)))
}

fn scaled(mantissa: u128, exponent: i64) -> f32 {
    let power = i32::try_from(exponent.clamp(-1000, 1000)).unwrap_or_default();
    (0..power.unsigned_abs()).fold(mantissa as f64, |v, _| if power < 0 { v / 2.0 } else { v * 2.0 }) as f32
}

/// Whether an integer literal became that f32 without loss.
fn is_exact_integer(number: &str, value: f32) -> bool {
    let digits = number.trim_end_matches(['i', 'u']);
    let integer = if is_hex(number) { i128::from_str_radix(&digits[2..], 16) } else { digits.parse() };
    integer.is_ok_and(|n| value as i128 == n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_literals_are_told_from_others() {
        for exact in ["0.0", "1.", ".5", "0.125f", "1e3", "4294967040.0", "16777216.0"] {
            assert!(is_exact(exact), "{exact}");
        }
        for exact in ["0x1p-126", "0x1.8p+4", "0x.8p0f", "0x0p0", "1.00000011920928955078125", "65504h", "0e9"] {
            assert!(is_exact(exact), "{exact}");
        }
        for inexact in
            ["0.1", "1.00001", "16777217.0", "1e39", "1e-40", "0x1.0000008p0", "0x1p-130", "0x1p-999", "1.5e-3"]
        {
            assert!(!is_exact(inexact), "{inexact}");
        }
    }

    #[test]
    fn floats_are_told_from_integers() {
        assert!(["1.0", "1e3", "1f", "0x1p3", ".5", "2h", "0x1.8"].iter().all(|n| is_float(n)));
        assert!(["1", "0x1f", "1u", "0xefu", "2i", "0xE"].iter().all(|n| !is_float(n)));
    }
}

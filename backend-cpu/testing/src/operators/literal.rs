//! Literals of run lines, as words: `3u`, `-1i`, `0x1.8p3`-free decimals, `true`, `inf`, `-inf`, `nan`,
//! `bitcast<f32>(0x7f800000u)`, and any constructor around them (`vec3<u32>(1u, 2u, 3u)`; one operand fills all).

use std::fmt;

use naga::ScalarKind;

use super::Signature;

/// What a result word must be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expected {
    /// These bits.
    Word(u32),
    /// Any NaN.
    Nan,
}

impl Expected {
    /// Whether a word is that.
    pub fn accepts(self, word: u32) -> bool {
        match self {
            Expected::Word(expected) => expected == word,
            Expected::Nan => f32::from_bits(word).is_nan(),
        }
    }

    /// The bits, where they are certain.
    pub fn word(self) -> Option<u32> {
        if let Expected::Word(word) = self { Some(word) } else { None }
    }
}

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Expected::Word(word) => write!(f, "{word:#010x}"),
            Expected::Nan => f.write_str("nan"),
        }
    }
}

/// Parts of a list at its outermost commas.
pub(crate) fn split(list: &str) -> Vec<&str> {
    let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
    for (at, c) in list.char_indices() {
        match c {
            '(' | '<' => depth += 1,
            ')' | '>' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(list[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    let last = list[start..].trim();
    if !last.is_empty() {
        parts.push(last);
    }
    parts
}

/// The words of a literal of a known type.
pub(crate) fn literal(text: &str, signature: &Signature) -> Result<Vec<Expected>, String> {
    let mut words = Vec::new();
    flatten(text.trim(), signature.scalar.kind, &mut words)?;
    match words.len() {
        1 => Ok(vec![words[0]; signature.words()]),
        n if n == signature.words() => Ok(words),
        n => Err(format!("`{text}` has {n} scalars, {} are wanted", signature.words())),
    }
}

fn flatten(text: &str, kind: ScalarKind, words: &mut Vec<Expected>) -> Result<(), String> {
    let constructor = text.strip_suffix(')').and_then(|t| t.split_once('('));
    match constructor {
        Some(("bitcast<f32>" | "bitcast<i32>", bits)) => words.push(scalar(bits, ScalarKind::Uint)?),
        Some((_, inner)) => {
            for part in split(inner) {
                flatten(part, kind, words)?;
            }
        }
        None => words.push(scalar(text, kind)?),
    }
    Ok(())
}

fn scalar(text: &str, kind: ScalarKind) -> Result<Expected, String> {
    let malformed = || format!("`{text}` is not a {}", super::kind_name(kind));
    let word = match kind {
        ScalarKind::Bool => u32::from(text.parse::<bool>().map_err(|_| malformed())?),
        ScalarKind::Float => {
            let number = text.strip_suffix('f').filter(|t| !t.ends_with("in")).unwrap_or(text);
            let value: f32 = number.parse().map_err(|_| malformed())?;
            if value.is_nan() {
                return Ok(Expected::Nan);
            }
            value.to_bits()
        }
        _ => integer(text.trim_end_matches(['u', 'i'])).ok_or_else(malformed)? as u32,
    };
    Ok(Expected::Word(word))
}

fn integer(text: &str) -> Option<i64> {
    let value = match text.strip_prefix("0x") {
        Some(hex) => i64::from_str_radix(hex, 16).ok()?,
        None => text.parse().ok()?,
    };
    (i64::from(i32::MIN)..=i64::from(u32::MAX)).contains(&value).then_some(value)
}

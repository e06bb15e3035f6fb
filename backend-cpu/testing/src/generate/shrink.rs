//! Makes a failing program smaller: statements go, blocks stand for their statements, operands for their expressions.

use std::time::{Duration, Instant};

use super::program::Generated;
use super::statement::Statement;

/// How long one program may be shrunk.
const TIME: Duration = Duration::from_secs(90);

/// The smallest program found for which `fails` holds.
pub fn shrink(mut program: Generated, fails: &dyn Fn(&Generated) -> bool) -> Generated {
    let start = Instant::now();
    for simpler in [dropped as Step, simplified] {
        loop {
            let before = program.render().len();
            for function in (0..program.functions.len()).rev() {
                let mut at = 0;
                while let Some(candidates) = replace(&program.functions[function].1, &mut { at }, simpler) {
                    let with = |body: Vec<Statement>| {
                        let mut candidate = program.clone();
                        candidate.functions[function].1 = body;
                        candidate
                    };
                    let in_time = |_: &Generated| start.elapsed() < TIME;
                    match candidates.into_iter().map(with).take_while(in_time).find(|c| fails(c)) {
                        Some(smaller) => program = smaller,
                        None => at += 1,
                    }
                }
            }
            if program.render().len() == before || start.elapsed() > TIME {
                break;
            }
        }
    }
    program
}

/// What may stand for a statement.
type Step = fn(&Statement) -> Vec<Vec<Statement>>;

/// Nothing, or one of its blocks.
fn dropped(statement: &Statement) -> Vec<Vec<Statement>> {
    if must_stay(&statement.tail) {
        return Vec::new();
    }
    std::iter::once(Vec::new()).chain(statement.blocks.iter().cloned()).collect()
}

/// The statement with one expression replaced by a part of it.
fn simplified(statement: &Statement) -> Vec<Vec<Statement>> {
    let mut candidates = Vec::new();
    for at in 0..=statement.heads.len() {
        let text = statement.heads.get(at).unwrap_or(&statement.tail);
        if must_stay(text) {
            continue;
        }
        for smaller in parts(text) {
            let mut candidate = statement.clone();
            *candidate.heads.get_mut(at).unwrap_or(&mut candidate.tail) = smaller;
            candidates.push(vec![candidate]);
        }
    }
    candidates
}

/// Whether the program might not end, or might race, without this text.
fn must_stay(text: &str) -> bool {
    let counts = text.starts_with('k') && text.ends_with("++;");
    counts
        || text.contains("lane_")
        || text.contains("&mine[")
        || ["break if", "while ", "for "].iter().any(|head| text.starts_with(head))
}

/// The text with one call, parenthesis or index replaced by something it contains, outermost first.
fn parts(text: &str) -> Vec<String> {
    let mut candidates = Vec::new();
    // The elements that an invocation may write are its own: they stay.
    let shared = ["out[", "ring[", "pond["].iter().any(|head| text.starts_with(head));
    let first = if shared { text.find("= ").unwrap_or(0) } else { 0 };
    for (open, c) in text.char_indices().filter(|&(at, c)| at >= first && (c == '(' || c == '[')) {
        let Some(close) = matching(text, open) else { continue };
        let inner = &text[open + 1..close];
        let name = |c: char| c.is_alphanumeric() || "_<>".contains(c);
        let start = if c == '(' { text[..open].trim_end_matches(name).len() } else { open + 1 };
        let end = if c == '(' { close + 1 } else { close };
        let mut replacements: Vec<String> = split(inner).iter().map(|p| p.trim().to_owned()).collect();
        replacements.extend(groups(inner).into_iter().map(str::to_owned));
        replacements.extend(match (c, inner) {
            ('[', "lane" | "own") => vec![],
            ('[', _) => vec!["0u".to_owned()],
            _ => vec!["lane".to_owned(), "true".to_owned()],
        });
        let shorter = |r: &String| r.len() < end - start;
        let whole = |r: String| format!("{}{r}{}", &text[..start], &text[end..]);
        candidates.extend(replacements.into_iter().filter(shorter).map(whole));
    }
    candidates
}

fn matching(text: &str, open: usize) -> Option<usize> {
    let mut depth = 0;
    for (at, c) in text[open..].char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' if depth == 1 => return Some(open + at),
            ')' | ']' => depth -= 1,
            _ => {}
        }
    }
    None
}

/// Parts at the outermost commas.
fn split(text: &str) -> Vec<&str> {
    let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&text[start..at]);
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&text[start..]);
    parts
}

/// The outermost parentheses.
fn groups(text: &str) -> Vec<&str> {
    let (mut at, mut groups) = (0, Vec::new());
    while let Some(open) = text[at..].find('(').map(|o| at + o) {
        let Some(close) = matching(text, open) else { break };
        groups.push(&text[open..=close]);
        at = close + 1;
    }
    groups
}

/// The bodies in which the statement number `at`, counted through all blocks, is replaced.
fn replace(body: &[Statement], at: &mut usize, step: Step) -> Option<Vec<Vec<Statement>>> {
    for (index, statement) in body.iter().enumerate() {
        let with = |new: &[Statement]| [&body[..index], new, &body[index + 1..]].concat();
        if *at == 0 {
            return Some(step(statement).iter().map(|new| with(new)).collect());
        }
        *at -= 1;
        for (inner, block) in statement.blocks.iter().enumerate() {
            if let Some(candidates) = replace(block, at, step) {
                let whole = |block: Vec<Statement>| {
                    let mut statement = statement.clone();
                    statement.blocks[inner] = block;
                    with(&[statement])
                };
                return Some(candidates.into_iter().map(whole).collect());
            }
        }
    }
    None
}

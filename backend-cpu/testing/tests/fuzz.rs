//! A short run of each fuzz target without a fuzzer: the same functions on seeds that never change.
//!
//! `cargo fuzz` runs them for longer and led by coverage (docs/testing.md). What this run is for: the targets work, and
//! a change that breaks them badly is seen at once.

use std::path::{Path, PathBuf};

use arbitrary::Unstructured;
use sightlines_testing::fuzz;
use sightlines_testing::generate::seeded;

/// Words that a mutation may put into a text.
const WORDS: [&str; 16] =
    ["(", ")", "{", "}", ";", "loop", "else if", "u32", "-1", "4294967295u", "[9u]", ".xyz", "&", "*", "/*", "break;"];

/// All WGSL files in the folders of the interpreter's tests.
fn texts() -> Vec<String> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests");
    let files = |folder: &str| std::fs::read_dir(tests.join(folder)).into_iter().flatten().flatten().map(|e| e.path());
    let mut paths: Vec<PathBuf> = ["ops", "shaders", "regressions"].into_iter().flat_map(files).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "wgsl"));
    paths.sort();
    paths
        .iter()
        .map(|path| std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display())))
        .collect()
}

/// A text cut at bytes, spliced with another, or with a word put in.
fn mutate(text: &str, other: &str, choices: &mut Unstructured<'_>) -> arbitrary::Result<Vec<u8>> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..=choices.int_in_range(0..=3)? {
        let at = choices.int_in_range(0..=bytes.len())?;
        let end = (at + choices.int_in_range(0..=40)?).min(bytes.len());
        match choices.int_in_range(0..=3)? {
            0 => drop(bytes.drain(at..end)),
            1 => drop(bytes.splice(at..end, choices.choose(&WORDS)?.bytes())),
            2 => {
                let from = choices.int_in_range(0..=other.len())?;
                let part = &other.as_bytes()[from..(from + end - at).min(other.len())];
                drop(bytes.splice(at..at, part.iter().copied()));
            }
            _ => bytes.iter_mut().skip(at).take(1).for_each(|byte| *byte ^= 1),
        }
    }
    Ok(bytes)
}

#[test]
fn translate() {
    let texts = texts();
    assert!(texts.len() > 40, "{} files", texts.len());
    let bytes: Vec<u8> = (0..8).flat_map(seeded).collect();
    let mut choices = Unstructured::new(&bytes);
    for (index, text) in texts.iter().enumerate() {
        fuzz::translate(text.as_bytes());
        for round in 1..=10 {
            let other = &texts[(index + round) % texts.len()];
            fuzz::translate(&mutate(text, other, &mut choices).unwrap_or_default());
        }
    }
}

#[test]
fn execute() {
    let ends: Vec<_> = (0..150).map(|seed| fuzz::execute(&seeded(seed)).unwrap_or("ran to its end".into())).collect();
    for end in ["ran to its end", "out of bounds", "no end after", "barrier in control flow"] {
        assert!(ends.iter().any(|message| message.contains(end)), "none of {} programs: {end}", ends.len());
    }
}

#[test]
fn differential() {
    (1000..1040).for_each(|seed| fuzz::differential(&seeded(seed)));
}

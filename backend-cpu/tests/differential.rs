//! Random programs on the reference and on the interpreter: every word of every buffer must agree.
//!
//! `SIGHTLINES_FUZZ_CASES` sets the number of programs (300 unless told), `SIGHTLINES_FUZZ_SEED` the first seed. A program
//! that differs is shrunk, statement by statement, and printed as a file for `tests/regressions`.

mod engines;
mod generate;
mod script;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use engines::{Engine, Reference};
use generate::{Generated, generate, shrink};
use libtest_mimic::{Arguments, Failed, Trial};
use script::{Buffers, Script};
use sightlines_backend::Backend;

/// Programs in one trial.
const BATCH: u64 = 25;

fn main() {
    let arguments = Arguments::from_args();
    let engines = Arc::new(engines::engines());
    let cases = setting("SIGHTLINES_FUZZ_CASES", 300);
    let first = setting("SIGHTLINES_FUZZ_SEED", 0);
    let batches = (0..cases.div_ceil(BATCH)).map(|batch| {
        let engines = Arc::clone(&engines);
        let start = first + batch * BATCH;
        let end = (start + BATCH).min(first + cases);
        Trial::test(format!("seeds_{start}_to_{}", end - 1), move || {
            for seed in start..end {
                check(seed, &engines)?;
            }
            Ok(())
        })
    });
    libtest_mimic::run(&arguments, batches.collect()).exit();
}

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(default)
}

/// Why a program is of interest.
#[derive(Clone, PartialEq)]
enum Difference {
    /// It is not valid, or the reference fails: a defect of the generator or the reference.
    Invalid(String),
    /// The named engine fails or gives other words.
    Engine(usize, String),
}

fn check(seed: u64, engines: &[Engine]) -> Result<(), Failed> {
    let program = generate(seed);
    let Some(found) = difference(&program, engines, None) else { return Ok(()) };
    let (message, program) = match &found {
        Difference::Invalid(message) => (format!("the reference fails: {message}"), program),
        Difference::Engine(index, message) => {
            let engine = &engines[*index];
            // A failure needs no reference, and the interpreter is the faster of the two.
            let panics = |p: &Generated| execute(&p.render(), engine.backend.as_ref()).is_err_and(|e| e == *message);
            let differs = |p: &Generated| matches!(difference(p, engines, Some(*index)), Some(Difference::Engine(..)));
            let fails: &dyn Fn(&Generated) -> bool = if message.contains("panicked") { &panics } else { &differs };
            (format!("{} differs: {message}", engine.name), shrink(program, fails))
        }
    };
    let expected = execute(&program.render(), &Reference).map(|buffers| expectations(&buffers)).unwrap_or_default();
    Err(format!("seed {seed}: {message}\n\n{expected}{}", program.render()).into())
}

/// Runs a program; a panic is a failure like any other.
fn execute(text: &str, backend: &dyn Backend) -> Result<Buffers, String> {
    let script = Script::parse("generated.wgsl", text.to_owned())?;
    catch_unwind(AssertUnwindSafe(|| script.execute(backend))).unwrap_or_else(|panic| {
        let words = panic.downcast_ref::<String>().map(String::as_str);
        Err(format!("panicked: {}", words.or(panic.downcast_ref().copied()).unwrap_or_default()))
    })
}

/// The first engine, of all or of one, that disagrees with the reference.
fn difference(program: &Generated, engines: &[Engine], only: Option<usize>) -> Option<Difference> {
    let text = program.render();
    let expected = match execute(&text, &Reference) {
        Ok(buffers) => buffers,
        Err(message) => return Some(Difference::Invalid(message)),
    };
    for (index, engine) in engines.iter().enumerate().filter(|&(i, _)| only.is_none_or(|o| o == i)) {
        match execute(&text, engine.backend.as_ref()) {
            Ok(got) if got == expected => {}
            Ok(got) => return Some(Difference::Engine(index, first_word(&expected, &got))),
            Err(message) => return Some(Difference::Engine(index, message)),
        }
    }
    None
}

fn first_word(expected: &Buffers, got: &Buffers) -> String {
    for (binding, expected) in expected {
        let got = &got[binding];
        if let Some(at) = (0..expected.len()).find(|&i| expected[i] != got[i]) {
            return format!("buffer {binding}, word {at}: expected {:#010x}, got {:#010x}", expected[at], got[at]);
        }
    }
    "no word".to_owned()
}

fn expectations(buffers: &Buffers) -> String {
    let line = |(binding, words): (&u32, &Vec<u32>)| {
        let words: Vec<String> = words.iter().map(u32::to_string).collect();
        format!("//! expect {binding}: u32 {}\n", words.join(" "))
    };
    buffers.iter().filter(|(binding, _)| **binding > 1).map(line).collect()
}

//! Random programs on the reference and on the interpreter: every word of every buffer must agree.
//!
//! `SIGHTLINES_FUZZ_CASES` sets the number of programs (200 unless told), `SIGHTLINES_FUZZ_SEED` the first seed. A program
//! that differs is shrunk, statement by statement, and printed as a file for `tests/regressions`.

mod engines;
mod generate;
mod script;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use engines::Engine;
use generate::{Generated, generate, shrink};
use libtest_mimic::{Arguments, Failed, Trial};
use script::{Buffers, Script};

/// Programs in one trial.
const BATCH: u64 = 25;

fn main() {
    let arguments = Arguments::from_args();
    // The reference first; programs index out of bounds on purpose.
    let engines: Arc<Vec<_>> = Arc::new(engines::engines().into_iter().filter(|e| !e.traps).collect());
    let cases = setting("SIGHTLINES_FUZZ_CASES", 200);
    let first = setting("SIGHTLINES_FUZZ_SEED", 0);
    let batches = (0..cases.div_ceil(BATCH)).map(|batch| {
        let engines = Arc::clone(&engines);
        let start = first + batch * BATCH;
        let end = (start + BATCH).min(first + cases);
        Trial::test(format!("seeds_{start}_to_{}", end - 1), move || {
            (start..end).try_for_each(|seed| check(seed, &engines[0], &engines[1..]))
        })
    });
    libtest_mimic::run(&arguments, batches.collect()).exit();
}

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|value| value.parse().ok()).unwrap_or(default)
}

fn check(seed: u64, reference: &Engine, engines: &[Engine]) -> Result<(), Failed> {
    let program = generate(seed);
    let expected = expected(&program, reference).map_err(|e| format!("seed {seed}: the reference fails: {e}"))?;
    for engine in engines {
        if let Err(message) = run(&expected, engine) {
            let smaller = shrink(program, &|p| fails(p, reference, engine, &message));
            let name = &engine.name;
            let shown = self::expected(&smaller, reference).unwrap_or_else(|e| e);
            return Err(format!("seed {seed}: {name}: {message}\nshrunk to\n\n{shown}").into());
        }
    }
    Ok(())
}

/// Whether a smaller program still fails in the same way.
fn fails(program: &Generated, reference: &Engine, engine: &Engine, message: &str) -> bool {
    if message.starts_with("panicked") {
        // A panic needs no reference, and the interpreter is the faster of the two.
        return run(&format!("//! expect 2: u32\n{}", program.render()), engine).is_err_and(|e| e == message);
    }
    expected(program, reference).is_ok_and(|text| run(&text, engine).is_err())
}

/// The program with what the reference makes of it as its expectations.
fn expected(program: &Generated, reference: &Engine) -> Result<String, String> {
    let text = program.render();
    let (buffers, counts) = Script::parse("generated.wgsl", text.clone())?.execute(reference.backend.as_ref())?;
    let counts = counts.unwrap_or_default().map(|c| c.to_string()).join(" ");
    Ok(format!("{}//! counts: {counts}\n{text}", expectations(&buffers)))
}

/// Runs a program; a panic is a failure like any other.
fn run(text: &str, engine: &Engine) -> Result<(), String> {
    let script = Script::parse("generated.wgsl", text.to_owned())?;
    catch_unwind(AssertUnwindSafe(|| script.run(engine))).unwrap_or_else(|panic| {
        let words = panic.downcast_ref::<String>().map(String::as_str);
        Err(format!("panicked: {}", words.or(panic.downcast_ref().copied()).unwrap_or_default()))
    })
}

/// All buffers but the read-only ones.
fn expectations(buffers: &Buffers) -> String {
    let line = |(binding, words): (&u32, &Vec<u32>)| {
        let words: Vec<String> = words.iter().map(u32::to_string).collect();
        format!("//! expect {binding}: u32 {}\n", words.join(" "))
    };
    buffers.iter().filter(|(binding, _)| **binding > 1).map(line).collect()
}

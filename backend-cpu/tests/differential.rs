//! Random programs on the reference and on the interpreter: every word of every buffer must agree.
//!
//! `SIGHTLINES_FUZZ_CASES` sets the number of programs (200 unless told), `SIGHTLINES_FUZZ_SEED` the first seed. A
//! program that differs is shrunk, statement by statement, and printed as a file for `tests/regressions`.

use std::sync::Arc;

use libtest_mimic::{Arguments, Failed, Trial};
use sightlines_testing::differential::compare;
use sightlines_testing::engines::{Engine, engines};
use sightlines_testing::generate::{generate, seeded};

/// Programs in one trial.
const BATCH: u64 = 25;

fn main() {
    let arguments = Arguments::from_args();
    // The reference first; programs index out of bounds on purpose.
    let engines: Arc<Vec<_>> = Arc::new(engines().into_iter().filter(|e| !e.traps).collect());
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
    compare(&generate(&seeded(seed)), reference, engines).map_err(|e| format!("seed {seed}: {e}").into())
}

//! Every subject under criterion, in one process, on the interpreter and on every adapter: ids `kernel/case/backend`.
//!
//! `cargo bench -p sightlines-benches` takes criterion's own options; `cargo xtask bench` makes the numbers that are
//! compared. Run as a test, the first case of each kernel and every micro-kernel run once, and their outputs are
//! compared between machines (conformance does it for every case); where an adapter that `SIGHTLINES_REQUIRE` names (a
//! comma-separated list) is missing, that is a failure.

use std::collections::{HashMap, HashSet};
use std::io::{self, Write};
use std::process::ExitCode;

use criterion::Criterion;
use sightlines_backend::Backend;
use sightlines_benches::engine::{INSTALL_LAVAPIPE, adapters_here, choose, interpreters, require};
use sightlines_benches::measure::benchmark;
use sightlines_benches::subject::MICRO;
use sightlines_benches::{Engine, Error, Prepared, Result, Subject, Threads, subjects};

fn main() -> ExitCode {
    let mut criterion = Criterion::default().configure_from_args();
    let result = all(&mut criterion);
    criterion.final_summary();
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => panic!("{error}"),
    }
}

fn all(criterion: &mut Criterion) -> Result<()> {
    let adapters = choose(&adapters_here(), &[])?;
    let required = std::env::var("SIGHTLINES_REQUIRE").unwrap_or_default();
    for name in required.split(',').map(str::trim).filter(|name| !name.is_empty() && *name != "cpu") {
        require(name, &adapters, None)?;
    }
    if adapters.is_empty() {
        writeln!(io::stderr(), "note: no adapter was found, so the interpreter runs alone; {INSTALL_LAVAPIPE}")?;
    }
    let mut engines = interpreters(&[])?;
    engines.extend(adapters.into_iter().map(Engine::Wgpu));
    let mut digests = HashMap::new();
    for engine in engines {
        let backend = engine.open(Threads::All)?;
        for subject in chosen() {
            let digest = measure(criterion, &subject, &engine, backend.as_ref())?;
            let first = *digests.entry(subject.to_string()).or_insert(digest);
            if subject.is_portable() && first != digest {
                return Err(Error::Measurement(format!("{subject}: {engine} gave other bits than the interpreter")));
            }
        }
    }
    Ok(())
}

/// Every subject, or, where criterion tests (cargo gives `--bench` to measure), those of a test.
fn chosen() -> Vec<Subject> {
    let given = |flag: &str| std::env::args().any(|argument| argument == flag);
    let mut subjects = subjects();
    if given("--test") || !given("--bench") {
        let mut met = HashSet::new();
        subjects.retain(|subject| subject.kernel == MICRO || met.insert(subject.kernel));
    }
    subjects
}

fn measure(criterion: &mut Criterion, subject: &Subject, engine: &Engine, backend: &dyn Backend) -> Result<u64> {
    let mut prepared = Prepared::new(backend, &(subject.job)()?)?;
    if let Some(wrong) = subject.first_error(engine.backend(), &prepared.outputs) {
        return Err(Error::Measurement(wrong));
    }
    benchmark(criterion, subject, engine.backend(), &mut prepared)?;
    Ok(prepared.digest())
}

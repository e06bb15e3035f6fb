//! The work of the fuzz targets, as functions of a fuzzer's bytes. Each panics on a finding.
//!
//! * [`translate`]: any text through every stage that comes before a run; errors are typed and name a line of the text.
//! * [`execute`]: a generated program within limits; the same end and the same buffers on every SIMD level.
//! * [`differential`]: a generated program on the reference and on one setting of the interpreter.

use std::sync::OnceLock;

use sightlines_backend::{Backend, CompileLimits, Error, ErrorKind, Job, Linked, Program};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend, Simd};

use crate::engines::{Engine, engines};
use crate::generate::{generate, generate_wild};
use crate::script::Script;

/// The file that [`translate`] reads its text from, and one that it can import.
const FILES: [(&str, &str); 2] = [("fuzz.wgsl", ""), ("shared/one.wgsl", "fn one() -> u32 { return 1u; }\n")];

/// Links, parses, validates, lints and lowers a text.
pub fn translate(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let own = text.to_owned();
    let sources = move |path: &str| match FILES.iter().position(|(name, _)| *name == path)? {
        0 => Some(own.clone()),
        index => Some(FILES[index].1.to_owned()),
    };
    let linked = match Linked::link(FILES[0].0, &sources, &[]) {
        Ok(linked) => linked,
        Err(error) => return inspect(&error, text),
    };
    for lint in [true, false] {
        match Program::with_limits("fuzz", linked.clone(), lint, &CompileLimits::default()) {
            Err(error) => inspect(&error, text),
            Ok(program) => {
                for entry in program.entries() {
                    if let Err(error) = CpuBackend::lowered(&program, &entry.name, &[]) {
                        inspect(&error, text);
                    }
                }
            }
        }
    }
}

/// An error must say something, and its place must be in a file.
fn inspect(error: &Error, text: &str) {
    assert!(!error.to_string().is_empty(), "an error without words: {error:?}");
    let location = match error.kind() {
        ErrorKind::Wgsl { location, .. }
        | ErrorKind::Unsupported { location, .. }
        | ErrorKind::Limit { location, .. } => location.as_ref(),
        ErrorKind::Refused { .. } => None,
        other => panic!("an error of another kind: {other:?}"),
    };
    let Some(place) = location else { return };
    let shown = FILES.iter().find(|(name, _)| *name == place.file).unwrap_or_else(|| panic!("no file {place}"));
    let text = if shown.0 == FILES[0].0 { text } else { shown.1 };
    let line = text.split('\n').nth(place.line as usize - 1).unwrap_or_else(|| panic!("no line {place}"));
    assert!(place.column as usize <= line.len() + 1, "no column {place} in a line of {} bytes", line.len());
}

/// How a run ended, and what every buffer then held.
type End = (Option<String>, Vec<Vec<u8>>);

/// Runs a generated program within limits, once on each SIMD level and twice on the best. The first byte says whether
/// accesses out of bounds end it. The result is the trap that ended it, if any.
pub fn execute(bytes: &[u8]) -> Option<String> {
    static MACHINES: [OnceLock<Vec<CpuBackend>>; 2] = [const { OnceLock::new() }; 2];
    let (&choice, bytes) = bytes.split_first()?;
    let trap = choice % 2 == 1;
    let machines = MACHINES[usize::from(trap)].get_or_init(|| {
        let bounds = if trap { Bounds::Trap } else { Bounds::Clamp };
        let config = Config { threads: 1, bounds, fuel: 1 << 10, memory: 1 << 20, ..Config::default() };
        let machine = |simd| CpuBackend::new(Config { simd: Some(simd), ..config });
        Simd::available().into_iter().map(machine).chain([CpuBackend::new(config)]).collect()
    });
    let text = generate_wild(bytes).render();
    let job = Script::parse(FILES[0].0, text.clone()).and_then(|script| script.job());
    let job = job.unwrap_or_else(|e| panic!("the generator made a program that is not valid: {e}\n{text}"));
    let ends: Vec<End> = machines.iter().map(|machine| end(machine, &job)).collect();
    for (machine, other) in machines.iter().zip(&ends) {
        assert!(*other == ends[0], "{} and {} differ\n{text}", machines[0].simd().name(), machine.simd().name());
    }
    ends.into_iter().next()?.0
}

/// Runs a job; buffers are read whether it succeeds or not, and only a trap may end it.
fn end(machine: &CpuBackend, job: &Job) -> End {
    let mut session = machine.open(&job.programs, &job.buffers).unwrap_or_else(|e| panic!("no session: {e}"));
    let error = job.recordings.iter().find_map(|recording| session.submit(recording).err());
    if let Some(error) = &error {
        assert!(matches!(error.kind(), ErrorKind::Trap(_)), "not a trap: {error}");
    }
    let read = |r| session.read(r).unwrap_or_else(|e| panic!("a buffer cannot be read: {e}"));
    (error.map(|e| e.to_string()), job.reads.iter().map(read).collect())
}

/// Compares a generated program on the reference and on the setting of the interpreter that the first byte chooses.
pub fn differential(bytes: &[u8]) {
    static ENGINES: OnceLock<Vec<Engine>> = OnceLock::new();
    let engines = ENGINES.get_or_init(|| engines().into_iter().filter(|e| !e.traps).collect());
    let Some((&choice, bytes)) = bytes.split_first() else { return };
    let (reference, others) = engines.split_at(1);
    let engine = usize::from(choice) % others.len();
    if let Err(message) = crate::differential::compare(&generate(bytes), &reference[0], &others[engine..=engine]) {
        panic!("{message}");
    }
}

/// Lets a panic that is caught pass: the fuzzer's own hook ends the process at every panic. One that no one catches
/// still ends it.
pub fn keep_caught_panics() {
    #[expect(clippy::print_stderr, reason = "a fuzzer shows its findings there")]
    std::panic::set_hook(Box::new(|panic| eprintln!("{panic}")));
}

//! The coordinator: engines, rounds, and what they come to.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::baseline::Baseline;
use crate::cli::{BenchArgs, Format, ThreadSetting};
use crate::clock::Clock;
use crate::engine::{self, Engine, INSTALL_LAVAPIPE, Threads};
use crate::error::{EXIT_FAILED, EXIT_OK, Error, Result};
use crate::measure::Sampling;
use crate::report::{Report, Row, write_whole};
use crate::statistics::median;
use crate::subject::{Subject, subjects};
use crate::worker::{Measured, Setting, Worker, discover};
use crate::{html, instructions, table};

/// Everything that a run is given.
struct Plan<'a> {
    exe: &'a Path,
    engines: Vec<Engine>,
    subjects: Vec<Subject>,
    rounds: usize,
    sampling: Sampling,
    folder: PathBuf,
    /// The core of one-thread children, where this system can pin.
    core: Option<String>,
}

/// Measures, prints the tables to `out` and progress to standard error, and writes the files.
pub fn run(exe: &Path, args: &BenchArgs, out: &mut impl Write) -> Result<u8> {
    let subjects = select(args)?;
    if args.list {
        subjects.iter().try_for_each(|subject| writeln!(out, "{subject}"))?;
        return Ok(EXIT_OK);
    }
    let folder = folder(args.out.as_deref())?;
    if args.callgrind {
        instructions::require()?;
    }
    let baseline = args.baseline.as_ref().map(|name| Baseline::read(&folder, name)).transpose()?;
    let engines = engines(exe, args, out)?;
    let sampling = if args.quick { Sampling::QUICK } else { Sampling::FULL };
    let rounds = args.rounds.map_or(if args.quick { 1 } else { 5 }, usize::from);
    let plan = Plan { exe, engines, subjects, rounds, sampling, folder, core: core_to_pin() };
    if plan.core.is_none() {
        writeln!(out, "note: this system has no `taskset`; one-thread children are not pinned to a core")?;
    }
    out.flush()?;
    let (mut rows, mut failures) = (Vec::new(), Vec::new());
    for threads in settings(&args.threads) {
        plan.setting(threads, &mut rows, &mut failures);
    }
    if args.callgrind {
        plan.count(&mut rows, &mut failures);
    }
    let lavapipe = plan.engines.iter().find(|e| e.is_lavapipe()).map(adapter_name);
    let report = Report::new(rows, plan.rounds, lavapipe, failures);
    finish(&plan, args, &report, baseline.as_ref(), out)
}

fn finish(
    plan: &Plan<'_>,
    args: &BenchArgs,
    report: &Report,
    baseline: Option<&Baseline>,
    out: &mut impl Write,
) -> Result<u8> {
    if args.format.contains(&Format::Text) {
        out.write_all(table::render(report, baseline).as_bytes())?;
    }
    let mut written = Vec::new();
    if args.format.contains(&Format::Json) {
        written.push(plan.folder.join("backends.json"));
        report.write(&plan.folder.join("backends.json"))?;
    }
    if args.format.contains(&Format::Html) {
        written.push(plan.folder.join("backends.html"));
        write_whole(&plan.folder.join("backends.html"), &html::render(report, baseline))?;
    }
    if let Some(name) = &args.save_baseline {
        Baseline::save(&plan.folder, name, report)?;
    }
    for failure in &report.summary.failures {
        writeln!(out, "FAILED: {failure}")?;
    }
    let (rows, failed) = (report.rows.len(), report.summary.failures.len());
    for path in written {
        writeln!(out, "written: {}", path.display())?;
    }
    writeln!(out, "{rows} rows, {failed} failed")?;
    Ok(if failed == 0 && rows > 0 { EXIT_OK } else { EXIT_FAILED })
}

fn select(args: &BenchArgs) -> Result<Vec<Subject>> {
    let Some(filter) = &args.filter else { return Ok(subjects()) };
    let chosen: Vec<Subject> = subjects().into_iter().filter(|s| filter.is_match(&s.to_string())).collect();
    if chosen.is_empty() { Err(Error::Nothing(filter.to_string())) } else { Ok(chosen) }
}

fn settings(asked: &[ThreadSetting]) -> Vec<Threads> {
    let mut settings: Vec<Threads> = Vec::new();
    for setting in asked {
        let threads = match setting {
            ThreadSetting::One => Threads::One,
            ThreadSetting::All => Threads::All,
        };
        // With one core, both settings would be the same rows.
        if !settings.iter().any(|s| s.count() == threads.count()) {
            settings.push(threads);
        }
    }
    settings
}

/// The engines, lavapipe first, the interpreter last; what is missing is said, or an error where it is required.
fn engines(exe: &Path, args: &BenchArgs, out: &mut impl Write) -> Result<Vec<Engine>> {
    let found = discover(exe);
    let trouble = found.as_ref().err().map(Error::to_string);
    let adapters = engine::choose(found.as_deref().unwrap_or_default(), &args.adapter)?;
    for required in &args.require {
        engine::require(required, &adapters, trouble.as_deref())?;
    }
    let mut engines: Vec<Engine> = adapters.into_iter().map(Engine::Wgpu).collect();
    if !engines.iter().any(Engine::is_lavapipe) {
        let reason = trouble.map_or_else(String::new, |trouble| format!(" ({trouble})"));
        let rows = if engines.is_empty() { "the rows are the interpreter's alone" } else { "no ratio is formed" };
        writeln!(out, "note: no lavapipe adapter{reason}: {rows}\n  remedy: {INSTALL_LAVAPIPE}")?;
    }
    engines.extend(engine::interpreters(&args.simd)?);
    Ok(engines)
}

impl Plan<'_> {
    /// Measures every subject on every engine in one thread setting.
    fn setting(&self, threads: Threads, rows: &mut Vec<Row>, failures: &mut Vec<String>) {
        let mut workers: Vec<Option<Worker>> = self.engines.iter().map(|_| None).collect();
        for (index, subject) in self.subjects.iter().enumerate() {
            progress(&format!("{threads}, {} of {}: {subject}", index + 1, self.subjects.len()));
            let series = self.subject(subject, threads, &mut workers, failures);
            if let Some(difference) = difference(subject, &self.engines, &series) {
                failures.push(difference);
            }
            rows.extend(self.rows(subject, threads, &series));
        }
    }

    /// One series an engine; an engine that fails has none. Rounds go forward and backward in turn.
    fn subject(
        &self,
        subject: &Subject,
        threads: Threads,
        workers: &mut [Option<Worker>],
        failures: &mut Vec<String>,
    ) -> Vec<Vec<Measured>> {
        let mut series = vec![Vec::new(); self.engines.len()];
        let mut failed = vec![false; self.engines.len()];
        for round in 0..self.rounds {
            let mut order: Vec<usize> = (0..self.engines.len()).collect();
            if round % 2 == 1 {
                order.reverse();
            }
            for engine in order.into_iter().filter(|&e| !failed[e]).collect::<Vec<_>>() {
                match self.measure(engine, subject, threads, &mut workers[engine]) {
                    Ok(measured) => series[engine].push(measured),
                    Err(error) => {
                        let place = format!("{subject} on {}, {threads}", self.engines[engine]);
                        failures.push(format!("{place}: {error}"));
                        failed[engine] = true;
                        series[engine].clear();
                        // What this child does next is not to be trusted; the next subject has a new one.
                        workers[engine] = None;
                    }
                }
            }
        }
        series
    }

    fn measure(
        &self,
        engine: usize,
        subject: &Subject,
        threads: Threads,
        worker: &mut Option<Worker>,
    ) -> Result<Measured> {
        let worker = match worker {
            Some(worker) => worker,
            None => {
                let folder = self.folder.join("criterion").join(format!("engine{engine}-{}", threads.count()));
                let engine = self.engines[engine].clone();
                let setting = Setting { engine, threads, sampling: self.sampling, folder };
                worker.insert(Worker::start(self.exe, &setting, self.core.as_deref())?)
            }
        };
        worker.measure(subject)
    }

    /// Counts the instructions of the interpreter's one-thread rows.
    fn count(&self, rows: &mut [Row], failures: &mut Vec<String>) {
        for row in rows.iter_mut().filter(|row| row.threads == 1) {
            let Some(simd) = &row.simd else { continue };
            let Some(subject) = self.subjects.iter().find(|subject| subject.to_string() == row.id()) else { continue };
            progress(&format!("instructions: {subject}, {simd}"));
            match instructions::count(self.exe, subject, simd, &self.folder) {
                Ok(count) => row.instructions = Some(count),
                Err(error) => failures.push(format!("instructions of {subject}, {simd}: {error}")),
            }
        }
    }

    fn rows(&self, subject: &Subject, threads: Threads, series: &[Vec<Measured>]) -> Vec<Row> {
        let lane_ops = series.iter().flatten().find_map(|measured| measured.lane_ops);
        let lavapipe = self.engines.iter().position(Engine::is_lavapipe);
        let reference = lavapipe.map_or(&[][..], |engine| &series[engine]);
        let engines = self.engines.iter().zip(series);
        engines.filter_map(|(engine, rounds)| row(subject, threads, engine, rounds, reference, lane_ops)).collect()
    }
}

fn row(
    subject: &Subject,
    threads: Threads,
    engine: &Engine,
    rounds: &[Measured],
    reference: &[Measured],
    lane_ops: Option<u64>,
) -> Option<Row> {
    let rounds_ns: Vec<f64> = rounds.iter().map(|measured| measured.median_ns).collect();
    let median_ns = median(&rounds_ns)?;
    let ratios: Vec<f64> = rounds.iter().zip(reference).map(|(own, other)| own.median_ns / other.median_ns).collect();
    let simd = match engine {
        Engine::Cpu { simd } => Some(simd.clone()),
        Engine::Wgpu(_) => None,
    };
    Some(Row {
        kernel: subject.kernel.to_owned(),
        case: subject.case.clone(),
        backend: engine.backend().to_owned(),
        adapter: adapter_name(engine),
        threads: threads.count(),
        ratio_to_lavapipe: simd.is_some().then(|| median(&ratios)).flatten(),
        simd,
        clock: Clock::of(threads),
        median_ns,
        rounds_ns,
        lane_ops,
        instructions: None,
        ns_per_lane_op: lane_ops.filter(|ops| *ops > 0).map(|ops| median_ns / ops as f64),
    })
}

fn adapter_name(engine: &Engine) -> String {
    match engine {
        Engine::Cpu { .. } => "interpreter".to_owned(),
        Engine::Wgpu(adapter) => adapter.name.clone(),
    }
}

/// Engines that gave other bits than the first one, or an interpreter whose work was not the same at each level.
fn difference(subject: &Subject, engines: &[Engine], series: &[Vec<Measured>]) -> Option<String> {
    let runs: Vec<(&Engine, &Measured)> =
        engines.iter().zip(series).filter_map(|(e, s)| Some((e, s.first()?))).collect();
    let (first, expected) = *runs.first()?;
    let other = runs.iter().find(|(_, measured)| subject.is_portable() && measured.digest != expected.digest);
    if let Some((engine, _)) = other {
        return Some(format!("{subject}: {engine} and {first} gave different bits"));
    }
    let mut counts = runs.iter().filter_map(|(_, measured)| measured.lane_ops);
    let first = counts.next()?;
    counts.find(|count| *count != first).map(|count| format!("{subject}: {first} and {count} lane-operations"))
}

/// The first core that this process may run on, where `taskset` can pin to it.
pub(crate) fn core_to_pin() -> Option<String> {
    let mut taskset = Command::new("taskset");
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let allowed = status.lines().find_map(|line| line.strip_prefix("Cpus_allowed_list:"))?.trim();
    let core: String = allowed.chars().take_while(char::is_ascii_digit).collect();
    let tried = taskset.args(["-c", &core, "true"]).stdout(Stdio::null()).stderr(Stdio::null()).status();
    tried.is_ok_and(|status| status.success()).then_some(core)
}

/// The folder of the results, by default `target/bench`.
pub fn folder(asked: Option<&Path>) -> Result<PathBuf> {
    let folder = asked.map_or_else(default_folder, Path::to_owned);
    std::path::absolute(&folder).map_err(|e| Error::file(&folder, e))
}

/// `target/bench` of the workspace, or of the folder that cargo was told to use.
fn default_folder() -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    target.unwrap_or_else(|| workspace.join("target")).join("bench")
}

fn progress(text: &str) {
    // Progress that nobody can see is no loss.
    let _ = writeln!(io::stderr(), "{text}");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::Adapter;

    fn measured(median_ns: f64, digest: u64, lane_ops: Option<u64>) -> Measured {
        Measured { median_ns, digest, lane_ops }
    }

    fn subject(id: &str) -> Subject {
        subjects().into_iter().find(|subject| subject.to_string() == id).unwrap()
    }

    fn lavapipe() -> Engine {
        let (name, driver) = ("llvmpipe (LLVM 15)".into(), "Mesa".into());
        Engine::Wgpu(Adapter { name, driver, api: "vulkan".into(), lacks: Vec::new() })
    }

    fn interpreter() -> Engine {
        Engine::Cpu { simd: "avx2".into() }
    }

    #[test]
    fn the_median_of_the_ratios_counts_not_the_ratio_of_the_medians() {
        let own = [measured(10.0, 0, None), measured(30.0, 0, None), measured(100.0, 0, None)];
        let other = [measured(100.0, 0, None), measured(10.0, 0, None), measured(50.0, 0, None)];
        let row = row(&subject("micro/gather"), Threads::One, &interpreter(), &own, &other, Some(60)).unwrap();
        assert_eq!((row.median_ns, row.ratio_to_lavapipe, row.ns_per_lane_op), (30.0, Some(2.0), Some(0.5)));
    }

    #[test]
    fn only_the_interpreter_has_a_ratio_and_an_engine_that_failed_has_no_row() {
        let subject = subject("micro/gather");
        let rounds = [measured(10.0, 0, None)];
        let of = |engine: &Engine, rounds: &[Measured]| row(&subject, Threads::One, engine, rounds, rounds, None);
        assert_eq!(of(&lavapipe(), &rounds).unwrap().ratio_to_lavapipe, None);
        assert_eq!(of(&interpreter(), &rounds).unwrap().ratio_to_lavapipe, Some(1.0));
        assert!(of(&interpreter(), &[]).is_none());
    }

    #[test]
    fn different_bits_are_a_failure_unless_the_driver_may_differ() {
        let engines = [lavapipe(), interpreter()];
        let series = |a, b| [vec![measured(1.0, a, None)], vec![measured(1.0, b, Some(3))]];
        assert_eq!(difference(&subject("micro/gather"), &engines, &series(1, 1)), None);
        assert!(difference(&subject("micro/gather"), &engines, &series(1, 2)).unwrap().contains("different bits"));
        assert_eq!(difference(&subject("micro/mandelbrot"), &engines, &series(1, 2)), None);
    }

    #[test]
    fn levels_that_count_differently_are_a_failure() {
        let engines = [interpreter(), Engine::Cpu { simd: "sse2".into() }];
        let series = [vec![measured(1.0, 1, Some(3))], vec![measured(1.0, 1, Some(4))]];
        assert!(difference(&subject("micro/gather"), &engines, &series).unwrap().contains("3 and 4 lane-operations"));
    }

    #[cfg(unix)]
    #[test]
    fn an_engine_whose_child_dies_is_a_failure_and_no_row() {
        let folder = std::env::temp_dir().join(format!("sightlines-plan-{}", std::process::id()));
        let plan = Plan {
            exe: Path::new("false"),
            engines: vec![interpreter()],
            subjects: vec![subject("micro/gather")],
            rounds: 3,
            sampling: Sampling::QUICK,
            folder: folder.clone(),
            core: None,
        };
        let (mut rows, mut failures) = (Vec::new(), Vec::new());
        plan.setting(Threads::All, &mut rows, &mut failures);
        assert!(rows.is_empty());
        assert_eq!(failures.len(), 1, "an engine that failed is not asked again: {failures:?}");
        assert!(failures[0].starts_with("micro/gather on interpreter avx2"), "{failures:?}");
        std::fs::remove_dir_all(folder).unwrap();
    }
}

//! What the binary does with its command line: find machines, plan, run, judge, report.

use std::io::{ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use sightlines_backend::{Kernel, Size};

use crate::cli::{BackendName, Format, RunArgs};
use crate::error::{EXIT_FAILED, EXIT_OK, Error, Result};
use crate::expect::{self, Expectations};
use crate::machine::{Asked, Fleet, INSTALL_VULKAN};
use crate::plan::{Plan, Selection};
use crate::report::{json, junit, text};
use crate::result::{Report, Taking};
use crate::run::{CaseRun, Rules};
use crate::suite::{self, Suite};
use crate::{bless, custom, files, replay, snapshot};

/// Runs the suite; the answer is the process exit code.
pub fn run(exe: &Path, kernels: &[Kernel], args: &RunArgs, out: &mut dyn Write) -> Result<u8> {
    let plan = plan(kernels, args)?;
    if args.list {
        for selected in &plan.selected {
            let size = if selected.case.size == Size::Real { "  (real size)" } else { "" };
            writeln!(out, "{}{size}", selected.name())?;
        }
        return Ok(EXIT_OK);
    }
    let fleet = Fleet::find(exe, &asked(args))?;
    if args.bless {
        bless::allowed(&fleet, |name| std::env::var(name).ok())?;
    }
    let suite = Suite { exe, fleet: &fleet, rules: rules(args)?, jobs: jobs(args), fail_fast: args.fail_fast };
    let progress = Progress::new(plan.selected.len());
    let runs = suite.run(&plan.selected, &|finished, name| progress.show(finished, name));
    progress.clear();
    let mut report = Report { notes: notes(args, &fleet, &plan), ..Report::default() };
    report.machines = fleet.machines.iter().map(Taking::from).collect();
    if args.bless {
        report.notes.push(blessed(exe, kernels, args, &plan, &runs)?);
    }
    report.results = runs.into_iter().flat_map(|r| r.results).collect();
    if args.replay.is_none() && args.kernel.is_none() {
        report.suite = suite::checks(kernels, &plan, &suite.rules.expectations, &snapshots(args));
    }
    write(&report, args, out)?;
    Ok(if report.is_success() { EXIT_OK } else { EXIT_FAILED })
}

fn plan(kernels: &[Kernel], args: &RunArgs) -> Result<Plan> {
    let one = match (&args.replay, &args.kernel, &args.case) {
        (Some(file), _, _) => replay::load(file)?,
        (_, Some(wgsl), Some(toml)) => custom::load(wgsl, toml, args.seed)?,
        _ => {
            let selection = Selection { filters: args.filter.clone(), quick: args.quick, shard: args.shard };
            return Plan::new(kernels, &selection);
        }
    };
    Ok(Plan { selected: vec![one], known: Vec::new(), left_out: 0 })
}

fn asked(args: &RunArgs) -> Asked {
    let takes = |name| args.backend.is_empty() || args.backend.contains(&name);
    let named = std::env::var("WGPU_ADAPTER_NAME").ok().filter(|n| !n.trim().is_empty());
    Asked {
        cpu: takes(BackendName::Cpu),
        wgpu: takes(BackendName::Wgpu),
        adapters: if args.adapter.is_empty() { named.into_iter().collect() } else { args.adapter.clone() },
        required: args.require.clone(),
    }
}

fn rules(args: &RunArgs) -> Result<Rules> {
    let mut command = String::from("cargo xtask conformance");
    if let Some(injection) = args.inject.as_ref().filter(|i| i.outlives_the_dump()) {
        command.push_str(&format!(" --timeout {} --inject {injection}", args.timeout));
    }
    command.push_str(" --replay");
    let expectations = args.expectations.clone().unwrap_or_else(expect::file);
    let single = args.replay.is_some() || args.kernel.is_some();
    Ok(Rules {
        dumps: args.replay.is_none().then(|| folder(args)),
        timeout: Duration::from_secs(args.timeout),
        snapshots: (!args.bless).then(|| snapshots(args)),
        expectations: if single { Expectations::default() } else { Expectations::read(&expectations)? },
        injection: args.inject.clone(),
        replay: command,
    })
}

fn folder(args: &RunArgs) -> PathBuf {
    args.out.clone().unwrap_or_else(|| files::workspace().join("target/conformance"))
}

fn snapshots(args: &RunArgs) -> PathBuf {
    args.snapshots.clone().unwrap_or_else(snapshot::folder)
}

fn jobs(args: &RunArgs) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, |n| n.get().min(4));
    args.jobs.map_or(cores, usize::from)
}

fn blessed(exe: &Path, kernels: &[Kernel], args: &RunArgs, plan: &Plan, runs: &[CaseRun]) -> Result<String> {
    let lines = bless::bless(exe, &snapshots(args), kernels, plan, runs)?;
    Ok(if lines.is_empty() { "no snapshot has changed".into() } else { lines.join("\n") })
}

/// What a reader must know to judge the result.
fn notes(args: &RunArgs, fleet: &Fleet, plan: &Plan) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(why) = &fleet.absent {
        notes.push(format!("wgpu was NOT tested: {why}\na software Vulkan device: {INSTALL_VULKAN}"));
    } else if !fleet.has_wgpu() {
        notes.push("wgpu was NOT tested: it was not asked for".into());
    }
    if plan.left_out > 0 {
        notes.push(format!("{} of real size left out (--quick)", files::count(plan.left_out as u64, "case")));
    }
    if args.kernel.is_some() {
        let oracle = plan.selected.iter().any(|s| s.has_oracle);
        let oracle = if oracle { "" } else { " and no expected words" };
        let machines = match fleet.machines.len() {
            1 => "one machine ran, so nothing was compared with another".to_owned(),
            n => format!("{n} machines were compared with each other"),
        };
        notes.push(format!("this kernel has no snapshot{oracle}; {machines}"));
    }
    if args.replay.is_some() && plan.selected.iter().any(|s| !s.has_oracle) {
        notes.push("the file says nothing of what is expected; the machines were compared with each other".into());
    }
    if let Some(injection) = &args.inject {
        notes.push(format!("a fault was injected: {injection}"));
    }
    notes
}

/// Files first, so that the totals are the last line whatever becomes of the files.
fn write(report: &Report, args: &RunArgs, out: &mut dyn Write) -> Result<()> {
    let files = write_files(report, args);
    let written =
        if args.format.contains(&Format::Text) { text::write(report, out) } else { text::totals(report, out) };
    match written.and_then(|()| out.flush()) {
        // Whoever has closed the pipe wants no more words; the verdict stands.
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(e.into()),
        _ => files,
    }
}

fn write_files(report: &Report, args: &RunArgs) -> Result<()> {
    let folder = folder(args);
    for format in &args.format {
        let (file, rendered) = match format {
            Format::Text => continue,
            Format::Json => ("conformance.json", json::render(report).map_err(|e| e.to_string())),
            Format::Junit => ("conformance.junit.xml", junit::render(report).map_err(|e| e.to_string())),
        };
        let path = folder.join(file);
        let rendered = rendered.map_err(|e| Error::write(&path, std::io::Error::other(e)))?;
        files::write_whole(&path, rendered.as_bytes())?;
    }
    Ok(())
}

/// A line on standard error that says how far the run is; only on a terminal, never where CI is set.
struct Progress {
    total: usize,
    shown: bool,
}

impl Progress {
    fn new(total: usize) -> Self {
        Progress { total, shown: std::io::stderr().is_terminal() && std::env::var_os("CI").is_none() }
    }

    fn show(&self, finished: usize, name: &str) {
        self.line(&format!("[{finished}/{}] {name}", self.total));
    }

    fn clear(&self) {
        self.line("");
    }

    fn line(&self, text: &str) {
        if self.shown {
            // Progress that cannot be shown is no reason to stop.
            let _ = write!(std::io::stderr().lock(), "\r\x1b[2K{text}");
        }
    }
}

//! Runs the cases of a plan on a fleet, several at a time, and checks what no single case can show.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use sightlines_backend::Kernel;

use crate::error::Result;
use crate::expect::Expectations;
use crate::fault::Injection;
use crate::machine::Fleet;
use crate::plan::{Plan, Selected};
use crate::pool::Worker;
use crate::result::{CaseResult, Check, Status, SuiteCheck};
use crate::run::{CaseRun, Rules, run_case};
use crate::{costs, snapshot};

/// Name of the machine that stands for a GPU that is not there.
pub const ABSENT: &str = "wgpu";

/// Name of the check of the interpreter's lowered code.
pub const MACHINE_COSTS: &str = "suite::machine_costs";

/// How a plan is run.
pub struct Suite<'a> {
    /// The worker program.
    pub exe: &'a Path,
    /// The machines.
    pub fleet: &'a Fleet,
    /// What cases are judged by.
    pub rules: Rules,
    /// Cases at a time.
    pub jobs: usize,
    /// Stop after the first failure.
    pub fail_fast: bool,
}

/// Called with the number of finished cases and the name of the one that begins.
pub type Progress<'a> = &'a (dyn Fn(usize, &str) + Sync);

impl Suite<'_> {
    /// One worker for each machine.
    pub fn workers(&self) -> Vec<Worker> {
        workers(self.exe, self.fleet, self.rules.injection.as_ref())
    }

    /// Runs the cases; the answer is in their order, whichever ended first.
    pub fn run(&self, cases: &[Selected], progress: Progress) -> Vec<CaseRun> {
        let (next, finished, stopped) = (AtomicUsize::new(0), AtomicUsize::new(0), AtomicBool::new(false));
        let runs: Mutex<Vec<Option<CaseRun>>> = Mutex::new(cases.iter().map(|_| None).collect());
        thread::scope(|scope| {
            for _ in 0..self.jobs.clamp(1, cases.len().max(1)) {
                scope.spawn(|| {
                    let mut workers = self.workers();
                    while !stopped.load(Ordering::Relaxed) {
                        let index = next.fetch_add(1, Ordering::Relaxed);
                        let Some(case) = cases.get(index) else { return };
                        progress(finished.load(Ordering::Relaxed), &case.name());
                        let run = run_case(&self.rules, case, &mut workers);
                        finished.fetch_add(1, Ordering::Relaxed);
                        if self.fail_fast && run.results.iter().any(|r| r.status.is_failure()) {
                            stopped.store(true, Ordering::Relaxed);
                        }
                        if let Ok(mut runs) = runs.lock() {
                            runs[index] = Some(run);
                        }
                    }
                });
            }
        });
        let runs = runs.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
        runs.into_iter().zip(cases).map(|(run, case)| self.complete(run, case)).collect()
    }

    /// Adds the skips: of a case that `--fail-fast` left, of a GPU that is not there.
    fn complete(&self, run: Option<CaseRun>, case: &Selected) -> CaseRun {
        let skip =
            |machine: &str, why: &str| CaseResult::new(&case.kernel, &case.case.name, machine, Status::Skip, why);
        let mut run = run.unwrap_or_else(|| {
            let left =
                self.fleet.machines.iter().map(|m| skip(&m.name, "not run: an earlier case failed (--fail-fast)"));
            CaseRun { results: left.collect(), snapshot: None }
        });
        if let Some(why) = &self.fleet.absent {
            run.results.push(skip(ABSENT, why));
        }
        run
    }
}

/// One worker for each machine of a fleet.
pub fn workers(exe: &Path, fleet: &Fleet, injection: Option<&Injection>) -> Vec<Worker> {
    let worker = |machine: &crate::machine::Machine| Worker::new(exe.to_owned(), machine.clone(), injection.cloned());
    fleet.machines.iter().map(worker).collect()
}

/// Checks of the suite itself: names, expectations, snapshots without a case, machine costs.
pub fn checks(kernels: &[Kernel], plan: &Plan, expectations: &Expectations, folder: &Path) -> Vec<SuiteCheck> {
    let known: Vec<String> = plan.known.iter().map(|(k, c)| format!("{k}::{c}")).collect();
    let name = |path: &PathBuf| path.strip_prefix(folder).unwrap_or(path).display().to_string();
    let orphans = match snapshot::orphans(folder, &known_paths(folder, plan)) {
        Ok(paths) => paths.iter().map(|p| format!("{}: no case has this snapshot", name(p))).collect(),
        Err(e) => vec![e.to_string()],
    };
    vec![
        check("suite::names", plan.bad_names()),
        check("suite::expectations", expectations.faults(&known)),
        check("suite::snapshots", orphans),
        check(MACHINE_COSTS, machine_costs(kernels, plan, folder)),
    ]
}

/// Every snapshot file that belongs to a case or to the suite.
pub fn known_paths(folder: &Path, plan: &Plan) -> BTreeSet<PathBuf> {
    let cases = plan.known.iter().map(|(kernel, case)| snapshot::path(folder, kernel, case));
    cases.chain([costs::path(folder)]).collect()
}

/// Machine costs of the kernels that take part.
fn machine_costs(kernels: &[Kernel], plan: &Plan, folder: &Path) -> Vec<String> {
    let takes_part = |line: &str| plan.selected.iter().any(|s| line.split(' ').next() == Some(s.kernel.as_str()));
    let of_these = |text: String| text.lines().filter(|l| takes_part(l)).map(|l| format!("{l}\n")).collect::<String>();
    let compared = || -> Result<Vec<String>> {
        let present = costs::render(kernels)?;
        let Some(stored) = snapshot::read(&costs::path(folder))? else {
            return Ok(vec!["there is no snapshot of them; remedy: `cargo xtask conformance --bless`".into()]);
        };
        let table = costs::compare(&of_these(stored), &of_these(present)).unwrap_or_default();
        let row = |r: &crate::diff::Row| format!("{}: {} instructions, were {}", r.buffer, r.got, r.expected);
        let mut lines: Vec<String> = table.rows.iter().map(row).collect();
        if table.total > lines.len() as u64 {
            lines.push(format!("… {} more", table.total - lines.len() as u64));
        }
        Ok(lines)
    };
    compared().unwrap_or_else(|e| vec![e.to_string()])
}

fn check(name: &str, faults: Vec<String>) -> SuiteCheck {
    let status = if faults.is_empty() { Status::Pass } else { Status::Fail };
    SuiteCheck { name: name.into(), status, message: faults.join("\n") }
}

/// Whether a case failed for another reason than its snapshot or what was expected of it.
pub fn is_unsound(result: &CaseResult) -> bool {
    result.status.is_failure() && !matches!(result.check, Some(Check::Snapshot | Check::Expectation))
}

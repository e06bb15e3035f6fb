//! Runs one case on all machines and judges it.
//!
//! The verdict is the first check that does not agree, in this order: the machine ran and was the one asked for; the
//! oracle agrees; one thread and all threads agree; all machines agree bit for bit; the stored snapshot agrees. The
//! machines are compared with the first of them that answered, which is the interpreter where it takes part.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::time::Duration;

use sightlines_backend::{Expected, Job, Outputs};

use crate::diff::{self, Row, Table};
use crate::dump::{self, Known, Record};
use crate::expect::Expectations;
use crate::fault::Injection;
use crate::files;
use crate::plan::{Selected, Stored};
use crate::pool::Worker;
use crate::protocol::{Costs, Failure, FailureKind, Pass};
use crate::result::{CaseResult, Check, Status, Timing, Verdict};
use crate::snapshot;

/// What holds for all cases of a run.
pub struct Rules {
    /// Where failing cases are dumped, if they are.
    pub dumps: Option<PathBuf>,
    /// Limit of one machine for one case.
    pub timeout: Duration,
    /// Folder of the snapshots; `None` leaves their comparison to the caller.
    pub snapshots: Option<PathBuf>,
    /// Failures that are known.
    pub expectations: Expectations,
    /// A deliberate fault.
    pub injection: Option<Injection>,
    /// The command that replays a dump, without the file.
    pub replay: String,
}

/// One case on all machines.
pub struct CaseRun {
    /// One result for each machine.
    pub results: Vec<CaseResult>,
    /// The snapshot of the interpreter's run, if it ran and the oracle, threads and machines agreed on it.
    pub snapshot: Option<String>,
}

type Outcome = Result<Vec<Pass>, Failure>;

/// Runs a case on every worker's machine.
pub fn run_case(rules: &Rules, selected: &Selected, workers: &mut [Worker]) -> CaseRun {
    let (kernel, case) = (selected.kernel.as_str(), selected.case.name.as_str());
    let job = match build(rules, selected) {
        Ok(job) => job,
        Err(message) => {
            let all = workers.iter().map(|w| {
                let mut result = CaseResult::new(kernel, case, &w.machine().name, Status::Fail, &message);
                result.check = Some(Check::Run);
                result
            });
            return CaseRun { results: all.collect(), snapshot: None };
        }
    };
    let bytes = job.to_bytes();
    let outcomes: Vec<Outcome> = workers.iter_mut().map(|w| w.run(&bytes, rules.timeout)).collect();
    let judge = Judge::new(rules, selected, &job, &outcomes);
    let mut results = Vec::new();
    for (worker, outcome) in workers.iter().zip(&outcomes) {
        let verdict = judge.verdict(worker, outcome);
        let mut result = record(selected, worker, outcome, verdict);
        rules.expectations.apply(&mut result);
        if result.status.is_failure() && result.table.is_some() {
            judge.dump(&bytes, &mut result);
        }
        results.push(result);
    }
    let sound = results.iter().all(|r| judge.sound_for_snapshot(r));
    CaseRun { snapshot: judge.rendered.filter(|_| sound), results }
}

fn build(rules: &Rules, selected: &Selected) -> Result<Job, String> {
    let built = catch_unwind(AssertUnwindSafe(|| (selected.case.job)()));
    let mut job = built
        .map_err(|_| "building the case's job panicked".to_owned())?
        .map_err(|e| format!("the case's job could not be built: {e}"))?;
    if let Some(injection) = &rules.injection {
        injection.job(&mut job).map_err(|e| format!("the injected fault does not compile: {e}"))?;
    }
    Ok(job)
}

fn record(selected: &Selected, worker: &Worker, outcome: &Outcome, verdict: Result<(), Verdict>) -> CaseResult {
    let mut result =
        CaseResult::new(&selected.kernel, &selected.case.name, &worker.machine().name, Status::Pass, String::new());
    if let Ok(passes) = outcome {
        result.identity = passes.first().map(|p| p.identity.clone());
        result.timings = passes.iter().map(|p| Timing { setting: p.setting.clone(), nanos: p.nanos }).collect();
        result.costs = passes.iter().find_map(|p| p.costs);
    }
    if let Err(verdict) = verdict {
        result.status = verdict.status;
        result.check = Some(verdict.check);
        result.message = verdict.message;
        result.table = verdict.table;
    }
    result
}

/// What the outcomes of a case are judged by.
struct Judge<'a> {
    rules: &'a Rules,
    selected: &'a Selected,
    job: &'a Job,
    /// First machine that answered, and its passes.
    reference: Option<&'a [Pass]>,
    /// The oracle's answer for the reference, or the reason why there is none.
    expected: Result<Vec<Expected>, String>,
    /// How the reference differs from it.
    reference_table: Option<Table>,
    /// The snapshot of the interpreter's run.
    rendered: Option<String>,
    /// The stored one.
    stored: Result<Option<String>, String>,
}

impl<'a> Judge<'a> {
    fn new(rules: &'a Rules, selected: &'a Selected, job: &'a Job, outcomes: &'a [Outcome]) -> Self {
        let reference = outcomes.iter().find_map(|o| o.as_deref().ok().filter(|p| !p.is_empty()));
        let outputs = reference.map(|passes| passes[0].outputs.as_slice());
        let expected = match outputs {
            Some(outputs) => ask(rules, selected, &outputs.iter().map(|o| o.to_vec()).collect()),
            None if selected.has_oracle => {
                ask(rules, selected, &job.reads.iter().map(|r| vec![0; r.size as usize]).collect())
            }
            None => Err("no machine gave an output".into()),
        };
        let reference_table = match (&expected, outputs) {
            (Ok(expected), Some(outputs)) => diff::oracle(&job.reads, expected, outputs),
            _ => None,
        };
        let mut passes = outcomes.iter().filter_map(|o| o.as_ref().ok()?.first());
        let counted = passes.find(|p| p.identity.backend == "cpu").filter(|_| selected.stored != Stored::Never);
        let rendered = counted.map(|pass| {
            let name = (selected.kernel.as_str(), selected.case.name.as_str());
            snapshot::render(name, job, &pass.outputs, &selected.case.probes, pass.costs.as_ref())
        });
        let stored = stored(rules, selected);
        Judge { rules, selected, job, reference, expected, reference_table, rendered, stored }
    }

    fn verdict(&self, worker: &Worker, outcome: &Outcome) -> Result<(), Verdict> {
        let passes = outcome.as_ref().map_err(|failure| self.failed(failure))?;
        let first = passes.first().ok_or_else(|| Verdict::fail(Check::Run, "the machine ran nothing", None))?;
        let asked = &worker.machine().identity;
        if let Some(other) = passes.iter().find(|p| !p.identity.same_device(asked)) {
            let message = format!("asked for {asked}; {} ran it", other.identity);
            let row = Row::text("(adapter)", "-", asked.to_string(), other.identity.to_string());
            return Err(Verdict::fail(Check::Identity, message, Some(Table::one(row))));
        }
        self.oracle(first)?;
        for pass in &passes[1..] {
            self.threads(first, pass)?;
        }
        turns(first)?;
        self.agreement(first)?;
        self.snapshot(first)
    }

    /// A machine without outputs: the table shows the first word that was due.
    fn failed(&self, failure: &Failure) -> Verdict {
        let (status, what) = match failure.kind {
            FailureKind::Trap => (Status::Trap, "trap"),
            FailureKind::Timeout => (Status::Timeout, "timeout"),
            FailureKind::Crash => (Status::Fail, "crash"),
            FailureKind::Error => (Status::Fail, "error"),
        };
        let first = self.job.reads.first().map(|read| {
            let due = self.expected.as_ref().ok().and_then(|e| match e.first()? {
                Expected::Whole(words) => words.first().map(|w| (0, *w)),
                Expected::Sample { words, .. } => words.first().copied(),
            });
            let (index, word) = due.map_or(("0".into(), "?".into()), |(i, w)| (i.to_string(), format!("{w:#010x}")));
            Table::one(Row::text(&read.name, &index, word, format!("none ({what})")))
        });
        Verdict { status, check: Check::Run, message: failure.message.clone(), table: first }
    }

    fn oracle(&self, pass: &Pass) -> Result<(), Verdict> {
        let expected = self.expected.as_ref().map_err(|e| Verdict::fail(Check::Oracle, e, None))?;
        let is_reference = self.reference.is_some_and(|r| r[0].outputs == pass.outputs);
        let table = if is_reference {
            self.reference_table.clone()
        } else {
            let whole = expected.iter().all(|e| matches!(e, Expected::Whole(_)));
            let outputs = || pass.outputs.iter().map(|o| o.to_vec()).collect();
            // A sample may depend on where the run says there is something to see.
            let own = if whole { None } else { ask(self.rules, self.selected, &outputs()).ok() };
            diff::oracle(&self.job.reads, own.as_ref().unwrap_or(expected), &pass.outputs)
        };
        match table {
            Some(table) if self.selected.has_oracle => {
                Err(Verdict::fail(Check::Oracle, differ(table.total, "word", "from the oracle"), Some(table)))
            }
            _ => Ok(()),
        }
    }

    fn threads(&self, one: &Pass, all: &Pass) -> Result<(), Verdict> {
        let between = format!("between {} and {}", one.setting, all.setting);
        if let Some(table) = diff::outputs(&self.job.reads, &one.outputs, &all.outputs) {
            return Err(Verdict::fail(Check::Threads, differ(table.total, "word", &between), Some(table)));
        }
        if one.costs != all.costs {
            let show = |costs: Option<Costs>| costs.map_or("none".into(), |c| format!("{c:?}"));
            let row = Row::text("(costs)", "-", show(one.costs), show(all.costs));
            return Err(Verdict::fail(Check::Threads, format!("costs differ {between}"), Some(Table::one(row))));
        }
        Ok(())
    }

    fn agreement(&self, pass: &Pass) -> Result<(), Verdict> {
        let Some(reference) = self.reference.map(|r| &r[0]) else { return Ok(()) };
        match diff::outputs(&self.job.reads, &reference.outputs, &pass.outputs) {
            None => Ok(()),
            Some(table) => {
                let message = differ(table.total, "word", &format!("from {}", reference.identity));
                Err(Verdict::fail(Check::Agreement, message, Some(table)))
            }
        }
    }

    fn snapshot(&self, pass: &Pass) -> Result<(), Verdict> {
        if self.selected.stored == Stored::Never || self.rules.snapshots.is_none() {
            return Ok(());
        }
        let stored = self.stored.as_ref().map_err(|e| Verdict::fail(Check::Snapshot, e, None))?;
        let Some(stored) = stored else {
            let message =
                "the case has no snapshot; remedy: look at its outputs, then `cargo xtask conformance --bless`";
            return Err(Verdict::fail(Check::Snapshot, message, None));
        };
        let name = (self.selected.kernel.as_str(), self.selected.case.name.as_str());
        let text = snapshot::render(name, self.job, &pass.outputs, &self.selected.case.probes, pass.costs.as_ref());
        let stored = if pass.costs.is_some() { stored } else { snapshot::without_costs(stored) };
        match snapshot::compare(stored, &text) {
            None => Ok(()),
            Some(table) => {
                let message = differ(table.total, "line", "from the stored snapshot");
                Err(Verdict::fail(Check::Snapshot, message, Some(table)))
            }
        }
    }

    /// Oracle, threads and machines agree on it, or it is a failure that is known.
    fn sound_for_snapshot(&self, result: &CaseResult) -> bool {
        match result.status {
            Status::Pass => true,
            Status::ExpectedFail => result.machine != "cpu",
            _ => matches!(result.check, Some(Check::Snapshot | Check::Expectation)),
        }
    }

    fn dump(&self, job: &[u8], result: &mut CaseResult) {
        let known = |e: &Vec<Expected>| e.iter().map(Known::from).collect();
        let record = Record {
            kernel: result.kernel.clone(),
            case: result.case.clone(),
            machine: result.machine.clone(),
            reason: result.message.clone(),
            expected: self.expected.as_ref().map(known).unwrap_or_default(),
            snapshot: self.stored.as_ref().ok().cloned().flatten(),
            probes: self.selected.case.probes.clone(),
        };
        let Some(folder) = &self.rules.dumps else { return };
        match dump::write(folder, job, &record) {
            Ok(path) => {
                result.replay = Some(format!("{} {}", self.rules.replay, files::quoted(&files::shown(&path))));
                result.dump = Some(path);
            }
            Err(e) => result.message.push_str(&format!("; and the job could not be dumped: {e}")),
        }
    }
}

/// Turns of loops at which Mesa's lavapipe ends all loops of an invocation, without a word.
const TURNS: u64 = 65_535;

/// Whether every invocation may take its turns on all devices; known of machines that count.
fn turns(pass: &Pass) -> Result<(), Verdict> {
    match pass.costs {
        Some(Costs { turns, .. }) if turns >= TURNS => {
            let message = format!(
                "an invocation takes {turns} turns of loops in one dispatch, and lavapipe ends all its loops at {TURNS} \
                 without an error; remedy: split the work over several dispatches, or over more invocations"
            );
            let row = Row::text("(turns)", "-", format!("fewer than {TURNS}"), turns.to_string());
            Err(Verdict::fail(Check::Turns, message, Some(Table::one(row))))
        }
        _ => Ok(()),
    }
}

fn differ(number: u64, noun: &str, whence: &str) -> String {
    format!("{} {} {whence}", files::count(number, noun), if number == 1 { "differs" } else { "differ" })
}

/// The stored snapshot that a case is compared with.
fn stored(rules: &Rules, selected: &Selected) -> Result<Option<String>, String> {
    let stored = match (&selected.stored, &rules.snapshots) {
        (Stored::Text(text), _) => Some(text.clone()),
        (Stored::File, Some(folder)) => {
            let path = snapshot::path(folder, &selected.kernel, &selected.case.name);
            snapshot::read(&path).map_err(|e| e.to_string())?
        }
        _ => None,
    };
    Ok(stored.map(|mut text| {
        if let Some(injection) = &rules.injection {
            injection.snapshot(&mut text);
        }
        text
    }))
}

/// Asks the oracle; its panic is a failed check, not the end of the suite.
fn ask(rules: &Rules, selected: &Selected, outputs: &Outputs) -> Result<Vec<Expected>, String> {
    let asked = catch_unwind(AssertUnwindSafe(|| (selected.case.expected)(outputs)));
    let mut expected = asked.map_err(|_| "the oracle panicked".to_owned())?;
    if let Some(injection) = &rules.injection {
        injection.oracle(&mut expected);
    }
    Ok(expected)
}

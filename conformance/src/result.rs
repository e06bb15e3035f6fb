//! What a run found out: one result for each case and machine, in a fixed order.

use std::fmt;
use std::path::PathBuf;

use serde::{Serialize, Serializer};

use crate::diff::Table;
use crate::machine::Machine;
use crate::protocol::{Costs, Identity};

/// Outcome of a case on a machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Status {
    /// Every check agreed.
    Pass,
    /// A check did not agree, or the machine failed.
    Fail,
    /// Not run, for a reason that is given.
    Skip,
    /// Failed, as the expectations file says.
    ExpectedFail,
    /// Passed although the expectations file says that it fails.
    UnexpectedPass,
    /// The kernel did what WGSL calls a dynamic error.
    Trap,
    /// The machine did not answer in time.
    Timeout,
}

impl Status {
    /// All of them, in the order of reports.
    pub const ALL: [Status; 7] = [
        Status::Pass,
        Status::ExpectedFail,
        Status::Skip,
        Status::UnexpectedPass,
        Status::Fail,
        Status::Trap,
        Status::Timeout,
    ];

    /// Whether it makes the run fail.
    pub fn is_failure(self) -> bool {
        matches!(self, Status::Fail | Status::UnexpectedPass | Status::Trap | Status::Timeout)
    }

    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Status::Pass => "pass",
            Status::Fail => "fail",
            Status::Skip => "skip",
            Status::ExpectedFail => "expected-fail",
            Status::UnexpectedPass => "unexpected-pass",
            Status::Trap => "trap",
            Status::Timeout => "timeout",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl Serialize for Status {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// Which check decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Check {
    /// The job could be built and run.
    Run,
    /// The machine asked for was the one that ran.
    Identity,
    /// The oracle agrees.
    Oracle,
    /// One thread and all threads agree, in outputs and in costs.
    Threads,
    /// No invocation's loops turn more often than all devices let them.
    Turns,
    /// All machines agree bit for bit.
    Agreement,
    /// The stored snapshot agrees.
    Snapshot,
    /// The expectations file agrees.
    Expectation,
}

impl Check {
    /// Its name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Check::Run => "run",
            Check::Identity => "identity",
            Check::Oracle => "oracle",
            Check::Threads => "threads",
            Check::Turns => "turns",
            Check::Agreement => "agreement",
            Check::Snapshot => "snapshot",
            Check::Expectation => "expectation",
        }
    }
}

/// Why a case did not pass on a machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// The status before expectations.
    pub status: Status,
    /// The first check that did not agree.
    pub check: Check,
    /// In words.
    pub message: String,
    /// In numbers.
    pub table: Option<Table>,
}

impl Verdict {
    /// A failed check.
    pub fn fail(check: Check, message: impl Into<String>, table: Option<Table>) -> Self {
        Verdict { status: Status::Fail, check, message: message.into(), table }
    }
}

/// Time of one setting of a machine.
#[derive(Clone, Debug, Serialize)]
pub struct Timing {
    /// The setting; empty for machines that have one.
    pub setting: String,
    /// Nanoseconds in the worker, compilation included.
    pub nanos: u64,
}

/// Outcome of one case on one machine.
#[derive(Clone, Debug, Serialize)]
pub struct CaseResult {
    /// The kernel.
    pub kernel: String,
    /// The case.
    pub case: String,
    /// The machine.
    pub machine: String,
    /// The outcome.
    pub status: Status,
    /// The first check that did not agree.
    pub check: Option<Check>,
    /// Why, in words; empty for a pass.
    pub message: String,
    /// Why, in numbers.
    pub table: Option<Table>,
    /// Who really ran it.
    pub identity: Option<Identity>,
    /// How long it took.
    pub timings: Vec<Timing>,
    /// Semantic costs, from machines that count.
    pub costs: Option<Costs>,
    /// The dumped job.
    pub dump: Option<PathBuf>,
    /// The command that replays it.
    pub replay: Option<String>,
}

impl CaseResult {
    /// A result without a run.
    pub fn new(kernel: &str, case: &str, machine: &str, status: Status, message: impl Into<String>) -> Self {
        CaseResult {
            kernel: kernel.into(),
            case: case.into(),
            machine: machine.into(),
            status,
            check: None,
            message: message.into(),
            table: None,
            identity: None,
            timings: Vec::new(),
            costs: None,
            dump: None,
            replay: None,
        }
    }

    /// `kernel::case::machine`, the name that tests and expectations use.
    pub fn name(&self) -> String {
        format!("{}::{}::{}", self.kernel, self.case, self.machine)
    }
}

/// A check of the suite itself, counted like a case.
#[derive(Clone, Debug, Serialize)]
pub struct SuiteCheck {
    /// Its name, `suite::…`.
    pub name: String,
    /// Pass, fail or skip.
    pub status: Status,
    /// Why, in words; empty for a pass.
    pub message: String,
}

/// A machine that takes part.
#[derive(Clone, Debug, Serialize)]
pub struct Taking {
    /// Its name in results.
    pub name: String,
    /// Who it is.
    pub identity: Identity,
}

impl From<&Machine> for Taking {
    fn from(machine: &Machine) -> Self {
        Taking { name: machine.name.clone(), identity: machine.identity.clone() }
    }
}

/// Everything a run found out.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Report {
    /// The machines.
    pub machines: Vec<Taking>,
    /// Results, by kernel, case and machine in the order of the registry.
    pub results: Vec<CaseResult>,
    /// Checks of the suite itself.
    pub suite: Vec<SuiteCheck>,
    /// What a reader must know to judge the result.
    pub notes: Vec<String>,
}

impl Report {
    /// Number of results and checks of a status.
    pub fn count(&self, status: Status) -> usize {
        let suite = self.suite.iter().filter(|c| c.status == status).count();
        self.results.iter().filter(|r| r.status == status).count() + suite
    }

    /// Passed, failed, skipped; a failure that was expected counts as passed.
    pub fn totals(&self) -> (usize, usize, usize) {
        let failed = Status::ALL.iter().filter(|s| s.is_failure()).map(|s| self.count(*s)).sum();
        (self.count(Status::Pass) + self.count(Status::ExpectedFail), failed, self.count(Status::Skip))
    }

    /// Whether nothing failed.
    pub fn is_success(&self) -> bool {
        self.totals().1 == 0
    }
}

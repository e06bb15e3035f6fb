//! One named test for each kernel, case and machine: `kernel::case::cpu`, `kernel::case::wgpu:llvmpipe`.
//!
//! A case runs once on all machines, whichever of its tests comes first, and each test looks up its own verdict. The
//! interpreter's snapshot is asserted through insta, so `INSTA_UPDATE` and `cargo insta review` work as everywhere. A
//! device that is not there is ignored with the reason, and fails where `SIGHTLINES_REQUIRE` (a comma-separated list of
//! `wgpu` or adapters) names it.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::{Arc, Mutex, OnceLock};
use std::time::Duration;

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use sightlines_conformance::error::Error;
use sightlines_conformance::expect::{self, Expectations};
use sightlines_conformance::files;
use sightlines_conformance::machine::{Asked, Fleet, INSTALL_VULKAN};
use sightlines_conformance::plan::{Plan, Selection};
use sightlines_conformance::pool::Worker;
use sightlines_conformance::report::text::describe;
use sightlines_conformance::result::{Status, SuiteCheck};
use sightlines_conformance::run::{CaseRun, Rules, run_case};
use sightlines_conformance::suite::{self, ABSENT, MACHINE_COSTS};
use sightlines_conformance::{costs, snapshot};
use sightlines_kernels::registry;

fn main() -> ExitCode {
    let args = Arguments::from_args();
    match trials() {
        Ok(trials) => libtest_mimic::run(&args, trials).exit_code(),
        Err(error) => {
            let failed = Trial::test("suite::starts", move || Err(error.to_string().into()));
            libtest_mimic::run(&args, vec![failed]).exit_code()
        }
    }
}

/// What all tests share.
struct Shared {
    exe: PathBuf,
    fleet: Fleet,
    rules: Rules,
    plan: Plan,
    runs: Vec<OnceLock<CaseRun>>,
    idle: Mutex<Vec<Vec<Worker>>>,
}

impl Shared {
    /// The case's run, made by the first test that asks.
    fn run(&self, index: usize) -> &CaseRun {
        self.runs[index].get_or_init(|| {
            let idle = self.idle.lock().ok().and_then(|mut idle| idle.pop());
            let mut workers = idle.unwrap_or_else(|| suite::workers(&self.exe, &self.fleet, None));
            let run = run_case(&self.rules, &self.plan.selected[index], &mut workers);
            if let Ok(mut idle) = self.idle.lock() {
                idle.push(workers);
            }
            run
        })
    }

    fn case(&self, index: usize, machine: usize) -> Result<(), Failed> {
        let run = self.run(index);
        let result = &run.results[machine];
        if result.status.is_failure() {
            return Err(describe(result, "").into());
        }
        if let Some(text) = run.snapshot.as_ref().filter(|_| result.machine == "cpu") {
            let selected = &self.plan.selected[index];
            snapshot::assert(&snapshot::path(&snapshot::folder(), &selected.kernel, &selected.case.name), text);
        }
        Ok(())
    }
}

fn required() -> Vec<String> {
    let list = std::env::var("SIGHTLINES_REQUIRE").unwrap_or_default();
    list.split(',').map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned).collect()
}

fn trials() -> Result<Vec<Trial>, Error> {
    let exe = PathBuf::from(env!("CARGO_BIN_EXE_sightlines-conformance"));
    let fleet = Fleet::find(&exe, &Asked { cpu: true, wgpu: true, ..Asked::default() })?;
    let plan = Plan::new(registry(), &Selection::default())?;
    let rules = Rules {
        dumps: Some(files::workspace().join("target/conformance")),
        timeout: Duration::from_secs(600),
        snapshots: None,
        expectations: Expectations::read(&expect::file())?,
        injection: None,
        replay: "cargo xtask conformance --replay".into(),
    };
    let runs = plan.selected.iter().map(|_| OnceLock::new()).collect();
    let shared = Arc::new(Shared { exe, fleet, rules, plan, runs, idle: Mutex::new(Vec::new()) });
    let mut trials = suite_trials(&shared);
    // Machine by machine: the tests of the first do the work, side by side; those of the others look it up.
    for (position, machine) in shared.fleet.machines.iter().enumerate() {
        for (index, selected) in shared.plan.selected.iter().enumerate() {
            let shared = Arc::clone(&shared);
            let name = format!("{}::{}", selected.name(), machine.name);
            trials.push(Trial::test(name, move || shared.case(index, position)));
        }
    }
    if let Some(why) = &shared.fleet.absent {
        trials.extend(shared.plan.selected.iter().map(|s| absent(format!("{}::{ABSENT}", s.name()), why.clone())));
    }
    Ok(trials)
}

/// A case on a GPU that is not there.
fn absent(name: String, why: String) -> Trial {
    Trial::ignorable_test(name, move || {
        let reason = format!("{why}; {INSTALL_VULKAN}");
        if required().is_empty() { Ok(Completion::ignored_with(reason)) } else { Err(reason.into()) }
    })
}

fn suite_trials(shared: &Arc<Shared>) -> Vec<Trial> {
    let checks = suite::checks(registry(), &shared.plan, &shared.rules.expectations, &snapshot::folder());
    let told = |check: SuiteCheck| {
        let SuiteCheck { name, status, message } = check;
        Trial::test(name, move || if status == Status::Pass { Ok(()) } else { Err(message.into()) })
    };
    let mut trials: Vec<Trial> = checks.into_iter().filter(|c| c.name != MACHINE_COSTS).map(told).collect();
    trials.push(Trial::test(MACHINE_COSTS, || {
        let text = costs::render(registry()).map_err(|e| e.to_string())?;
        snapshot::assert(&costs::path(&snapshot::folder()), &text);
        Ok(())
    }));
    for name in required() {
        let shared = Arc::clone(shared);
        trials.push(Trial::test(format!("suite::required::{name}"), move || {
            let asked = Asked { cpu: true, wgpu: true, required: vec![name], ..Asked::default() };
            Fleet::find(&shared.exe, &asked).map(|_| ()).map_err(|e| e.to_string().into())
        }));
    }
    trials
}

//! The operator and shader files of `backend-cpu/tests` on every GPU adapter: one corpus for all machines.
//!
//! Tests read `machine::file::mode`. Each runs a file's job in a child process of its own, so that a driver that
//! crashes or hangs costs one test. Results must be what the run line says, bit for bit, or within what WGSL permits
//! (`latitude.rs`). What is neither is a failure, unless `expectations.toml` names machine and function with a reason;
//! an entry whose function agrees is a failure too. A device that is not there is ignored with the reason, and fails
//! where `SIGHTLINES_REQUIRE` names it.

mod builtin;
mod interval;
mod latitude;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;

use latitude::Latitude;
use libtest_mimic::{Arguments, Completion, Trial};
use serde_bytes::ByteBuf;
use sightlines_backend::{Job, Outputs};
use sightlines_conformance::expect::Expectations;
use sightlines_conformance::machine::{Asked, Fleet, INSTALL_VULKAN, Machine};
use sightlines_conformance::pool::Worker;
use sightlines_conformance::result::{CaseResult, Status};
use sightlines_testing::operators::{File, Mode, Tested};
use sightlines_testing::script::Script;

/// Longest time of one file on one machine.
const LIMIT: Duration = Duration::from_secs(300);

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let trials = trials().unwrap_or_else(|e| vec![Trial::test("suite::starts", move || Err(e.into()))]);
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// What all tests share.
struct Shared {
    exe: PathBuf,
    expectations: Expectations,
}

fn trials() -> Result<Vec<Trial>, String> {
    let exe = PathBuf::from(env!("CARGO_BIN_EXE_sightlines-conformance"));
    let operators = files("ops", |path, _| File::read(path))?;
    let scripts = files("shaders", |path, text| Script::parse(&file_name(path), text))?;
    let known = known(&operators, &scripts);
    let shared = Arc::new(Shared { exe, expectations: expectations()? });
    let faults = shared.expectations.faults(&known);
    let mut trials = vec![Trial::test("suite::expectations", move || {
        if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
    })];
    trials.extend(required().into_iter().map(|name| requirement(&shared.exe, name)));
    // The interpreter runs the files in its own tests.
    let asked = Asked { cpu: true, wgpu: true, ..Asked::default() };
    let fleet = Fleet::find(&shared.exe, &asked).map_err(|e| e.to_string())?;
    for machine in fleet.machines.into_iter().filter(|machine| machine.identity.backend == "wgpu") {
        trials.extend(on_machine(&shared, &machine, &operators, &scripts));
    }
    if let Some(why) = fleet.absent {
        let reason = format!("{why}; {INSTALL_VULKAN}");
        trials.push(Trial::ignorable_test("wgpu::operators_and_shaders", move || Ok(Completion::ignored_with(reason))));
    }
    Ok(trials)
}

/// A file's stem and what was read of it.
type Named<T> = (String, Arc<T>);

fn files<T>(folder: &str, read: impl Fn(&Path, String) -> Result<T, String>) -> Result<Vec<Named<T>>, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../backend-cpu/tests").join(folder);
    let entries = std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "wgsl"));
    paths.sort();
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok((stem, Arc::new(read(&path, text)?)))
    };
    paths.into_iter().map(read).collect()
}

fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn expectations() -> Result<Expectations, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/operators/expectations.toml");
    Expectations::read(&path).map_err(|e| e.to_string())
}

/// Names that the expectations file may use.
fn known(operators: &[Named<File>], scripts: &[Named<Script>]) -> Vec<String> {
    let functions = operators.iter().flat_map(|(stem, file)| {
        Mode::ALL.into_iter().flat_map(move |mode| file.tested.iter().map(move |t| case(stem, &t.name, mode)))
    });
    functions.chain(scripts.iter().map(|(stem, _)| format!("shader::{stem}"))).collect()
}

/// `file::function::mode`.
fn case(file: &str, function: &str, mode: Mode) -> String {
    format!("{file}::{function}::{}", mode.name())
}

fn required() -> Vec<String> {
    let list = std::env::var("SIGHTLINES_REQUIRE").unwrap_or_default();
    list.split(',').map(str::trim).filter(|name| !name.is_empty() && *name != "cpu").map(str::to_owned).collect()
}

fn requirement(exe: &Path, name: String) -> Trial {
    let exe = exe.to_owned();
    Trial::test(format!("suite::required::{name}"), move || {
        let asked = Asked { cpu: true, wgpu: true, required: vec![name], ..Asked::default() };
        Fleet::find(&exe, &asked).map(|_| ()).map_err(|e| e.to_string().into())
    })
}

fn on_machine(
    shared: &Arc<Shared>,
    machine: &Machine,
    operators: &[Named<File>],
    scripts: &[Named<Script>],
) -> Vec<Trial> {
    let mut trials = Vec::new();
    for (stem, file) in operators {
        // To a GPU all loaded operands are alike.
        for mode in Mode::ALL.into_iter().filter(|mode| *mode != Mode::Uniform) {
            let (stem, file, shared, machine) = (stem.clone(), Arc::clone(file), Arc::clone(shared), machine.clone());
            let title = format!("{}::{stem}::{}", machine.name, mode.name());
            trials.push(Trial::test(title, move || Ok(shared.operators(&stem, &file, &machine, mode)?)));
        }
    }
    for (stem, script) in scripts {
        let (stem, script, shared, machine) = (stem.clone(), Arc::clone(script), Arc::clone(shared), machine.clone());
        let title = format!("{}::shader::{stem}", machine.name);
        trials.push(Trial::ignorable_test(title, move || {
            // Out of bounds, without end, a barrier that not all reach: a device may do anything, hang included.
            if script.errs() {
                return Ok(Completion::ignored_with("a dynamic error, which WGSL lets a device answer as it likes"));
            }
            shared.shader(&stem, &script, &machine)?;
            Ok(Completion::Completed)
        }));
    }
    trials
}

impl Shared {
    fn run(&self, machine: &Machine, job: &Job) -> Result<Outputs, String> {
        let mut worker = Worker::new(self.exe.clone(), machine.clone(), None);
        let passes = worker.run(&job.to_bytes(), LIMIT).map_err(|failure| failure.to_string())?;
        let pass = passes.into_iter().next().ok_or("the worker ran nothing")?;
        if !pass.identity.same_device(&machine.identity) {
            return Err(format!("{} answered instead of {}", pass.identity, machine.identity));
        }
        Ok(pass.outputs.into_iter().map(ByteBuf::into_vec).collect())
    }

    fn operators(&self, stem: &str, file: &File, machine: &Machine, mode: Mode) -> Result<(), String> {
        let outputs = self.run(machine, &file.job(mode)?)?;
        let latitude = Latitude::new(file)?;
        let judged = file.judge(&outputs[0], |tested, run, words| {
            run.is_met_by(words) || latitude.permits(&tested.name, &run.operands, words)
        });
        let verdict = |(tested, wrong): (&Tested, Vec<String>)| {
            let result = if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n")) };
            self.expected(&case(stem, &tested.name, mode), machine, result).err()
        };
        let failures: Vec<String> = judged.into_iter().filter_map(verdict).collect();
        if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
    }

    fn shader(&self, stem: &str, script: &Script, machine: &Machine) -> Result<(), String> {
        let outcome =
            script.job().and_then(|job| self.run(machine, &job)).map(|outputs| (script.words(&outputs), None));
        self.expected(&format!("shader::{stem}"), machine, script.judge(&outcome, false))
    }

    /// The result after the expectations file.
    fn expected(&self, case: &str, machine: &Machine, result: Result<(), String>) -> Result<(), String> {
        let (kernel, rest) = case.split_once("::").unwrap_or((case, ""));
        let status = if result.is_ok() { Status::Pass } else { Status::Fail };
        let mut verdict = CaseResult::new(kernel, rest, &machine.name, status, result.err().unwrap_or_default());
        self.expectations.apply(&mut verdict);
        let CaseResult { status, message, .. } = verdict;
        if status.is_failure() { Err(format!("{case}: {status}: {message}")) } else { Ok(()) }
    }
}

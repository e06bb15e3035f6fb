//! Operators and builtin functions, one file a family, in the manner of cranelift's file tests.
//!
//! A file of `tests/ops` holds ordinary WGSL functions, each followed by lines `// run: f(1u, 2u) == 3u`. Every line
//! runs three times on every machine: with literal operands, with operands loaded uniformly, and with operands that
//! differ between the invocations of a workgroup, because folding, scalar registers and vector registers are different
//! code. GPUs run the same files in `conformance/tests/operators`.
//!
//! Invariant: a function without a run line is a failure, and so is a builtin or operator that no file reaches, and
//! code that is not different where it should be.

mod coverage;
mod files;

use std::sync::Arc;

use libtest_mimic::{Arguments, Failed, Trial};
use sightlines_backend_cpu::CpuBackend;
use sightlines_testing::engines::{Engine, engines};
use sightlines_testing::operators::{File, Mode};

fn main() {
    let arguments = Arguments::from_args();
    let engines: Arc<Vec<_>> = Arc::new(engines().into_iter().filter(|e| !e.traps).collect());
    let mut trials = Vec::new();
    let mut files = Vec::new();
    for path in files::wgsl_files("ops") {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        match File::read(&path) {
            Ok(file) => files.push((name, Arc::new(file))),
            Err(message) => trials.push(Trial::test(name, move || Err(Failed::from(message)))),
        }
    }
    for (name, file) in &files {
        for (index, mode) in (0..engines.len()).flat_map(|i| Mode::ALL.map(|mode| (i, mode))) {
            let (file, engines) = (Arc::clone(file), Arc::clone(&engines));
            let title = format!("{name}::{}::{}", mode.name(), engines[index].name);
            trials.push(Trial::test(title, move || Ok(run(&file, mode, &engines[index])?)));
        }
    }
    for (name, file) in &files {
        let file = Arc::clone(file);
        trials.push(Trial::test(format!("{name}::modes_differ"), move || Ok(modes_differ(&file)?)));
    }
    let modules: Vec<Arc<File>> = files.into_iter().map(|(_, file)| file).collect();
    trials.push(Trial::test("every_operation_is_reached", move || Ok(coverage::coverage(&modules)?)));
    libtest_mimic::run(&arguments, trials).exit();
}

/// Runs every line and reports those whose result differs.
fn run(file: &File, mode: Mode, engine: &Engine) -> Result<(), String> {
    let outputs = engine.backend.run(&file.job(mode)?).map_err(|e| e.to_string())?;
    let judged = file.judge(&outputs[0], |_, run, words| run.is_met_by(words));
    let wrong: Vec<String> = judged.into_iter().flat_map(|(_, lines)| lines).collect();
    if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n")) }
}

/// Literal operands leave no load and little arithmetic, uniform ones fill scalar registers, varying ones vector
/// registers. What all modes have in common chooses the function, or hides a literal that WGSL refuses.
fn modes_differ(file: &File) -> Result<(), String> {
    let [constant, uniform, varying] = Mode::ALL.map(|mode| lowered(file, mode));
    let (constant, uniform, varying) = (constant?, uniform?, varying?);
    let folded = constant.scalar_loads == 0 && 2 * constant.scalar < uniform.scalar;
    let scalar = uniform.scalar_loads > 0 && uniform.vector == constant.vector;
    let vector = varying.scalar_loads == 0 && varying.vector > uniform.vector;
    if folded && scalar && vector {
        Ok(())
    } else {
        Err(format!("constant: {constant:?}\nuniform: {uniform:?}\nvarying: {varying:?}"))
    }
}

/// Instructions of lowered code by the registers that they write.
#[derive(Debug)]
struct Lowered {
    scalar: usize,
    vector: usize,
    scalar_loads: usize,
}

fn lowered(file: &File, mode: Mode) -> Result<Lowered, String> {
    let job = file.job(mode)?;
    let mut text = String::new();
    for entry in job.programs[0].entries() {
        let code = CpuBackend::lowered(&job.programs[0], &entry.name, &[]).map_err(|e| e.to_string())?;
        text.push_str(&code.to_string());
    }
    let count = |names: &[&str], register: &str| {
        text.lines().filter(|line| line.contains(register) && names.iter().any(|name| line.contains(name))).count()
    };
    let arithmetic = ["Un {", "Bin {", "Tern {"];
    Ok(Lowered {
        scalar: count(&arithmetic, "dst: s"),
        vector: count(&arithmetic, "dst: v"),
        scalar_loads: count(&["Load {"], "dst: s"),
    })
}

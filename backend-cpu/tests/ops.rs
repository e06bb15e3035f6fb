//! Operators and builtin functions, one file a family, in the manner of cranelift's file tests.
//!
//! A file of `tests/ops` holds ordinary WGSL functions, each followed by lines `// run: f(1u, 2u) == 3u`. Every line runs
//! three times on every machine: with literal operands, with operands loaded uniformly, and with operands that differ
//! between the invocations of a workgroup, because folding, scalar registers and vector registers are different code.
//!
//! Invariant: a function without a run line is a failure, and so is a builtin or operator that no file reaches.

mod files;
mod filetest;

use std::sync::Arc;

use filetest::{File, Mode};
use libtest_mimic::{Arguments, Failed, Trial};
use sightlines_testing::engines::engines;

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
            let title = format!("{name}::{mode:?}::{}", engines[index].name).to_lowercase();
            trials.push(Trial::test(title, move || Ok(file.run(mode, engines[index].backend.as_ref())?)));
        }
    }
    let modules: Vec<Arc<File>> = files.into_iter().map(|(_, file)| file).collect();
    trials.push(Trial::test("every_operation_is_reached", move || Ok(filetest::coverage(&modules)?)));
    libtest_mimic::run(&arguments, trials).exit();
}

//! Whole shaders: control flow, pointers, layout, initial values, atomics, barriers, robust access, overrides.
//!
//! Files of `tests/shaders`, and of `tests/regressions` for what once went wrong, in the form of [`Script`].

mod files;

use std::path::Path;
use std::sync::Arc;

use libtest_mimic::{Arguments, Failed, Trial};
use sightlines_testing::engines::engines;
use sightlines_testing::script::Script;

fn main() {
    let arguments = Arguments::from_args();
    let engines = Arc::new(engines());
    let mut trials = Vec::new();
    for path in ["shaders", "regressions"].into_iter().flat_map(files::wgsl_files) {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let script = match read(&path) {
            Ok(script) => Arc::new(script),
            Err(message) => {
                trials.push(Trial::test(name, move || Err(Failed::from(message))));
                continue;
            }
        };
        for index in 0..engines.len() {
            let (script, engines) = (Arc::clone(&script), Arc::clone(&engines));
            let title = format!("{name}::{}", engines[index].name);
            trials.push(Trial::test(title, move || Ok(script.run(&engines[index])?)));
        }
    }
    libtest_mimic::run(&arguments, trials).exit();
}

fn read(path: &Path) -> Result<Script, String> {
    let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    Script::parse(&path.file_name().unwrap_or_default().to_string_lossy(), text)
}

//! Whole shaders: control flow, pointers, layout, initial values, atomics, barriers, robust access, overrides.
//!
//! A file of `tests/shaders` is a WGSL module whose comments say what to run and what must come out:
//!
//! ```text
//! //! buffer 0: u32 1 2 3          a buffer at @group(0) @binding(0) with these words
//! //! buffer 1: zero 16            16 words of zero
//! //! override: N = 4              for the dispatches that follow
//! //! dispatch: main 2 1 1         entry point and workgroups
//! //! indirect: main 0 16          entry point, buffer and byte offset of the workgroup counts
//! //! expect 1: i32 3 -4 5 0*13    the buffer's words after all dispatches; v*n is n times v
//! //! trap: 12 out of bounds       with bounds that trap, line 12 must trap with a message that contains this text
//! //! fails: non-uniform           every machine must refuse with a message that contains this text
//! ```
//!
//! Invariant: a file that expects nothing is a failure.

mod engines;
mod script;

use std::path::Path;
use std::sync::Arc;

use engines::Engine;
use libtest_mimic::{Arguments, Failed, Trial};
use script::Script;

fn main() {
    let arguments = Arguments::from_args();
    let engines = Arc::new(all_engines());
    let mut trials = Vec::new();
    for folder in ["tests/shaders", "tests/regressions"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        for path in script::wgsl_files(&folder) {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let script = match Script::read(&path) {
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
    }
    libtest_mimic::run(&arguments, trials).exit();
}

fn all_engines() -> Vec<Engine> {
    let mut engines = vec![Engine::reference(), Engine::trapping(), Engine::counting()];
    engines.extend(engines::engines());
    engines
}

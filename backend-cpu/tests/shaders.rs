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
//! //! counts: 64 2 1 12 0 0        semantic costs: invocations, loads, stores, bytes, atomics, barriers
//! //! trap: 12 out of bounds       with bounds that trap, line 12 must trap with a message that contains this text
//! //! fails: non-uniform           every machine must refuse with a message that contains this text
//! ```
//!
//! Invariant: a file that expects nothing is a failure.

mod engines;
mod files;
mod script;

use std::path::Path;
use std::sync::Arc;

use libtest_mimic::{Arguments, Failed, Trial};
use script::Script;

fn main() {
    let arguments = Arguments::from_args();
    let engines = Arc::new(engines::engines());
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

//! One program on the reference and on another machine: every word of every buffer must agree, and the semantic costs.

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::engines::Engine;
use crate::generate::{Generated, shrink};
use crate::script::{Buffers, Script};

/// The file name that messages give a program.
const NAME: &str = "generated.wgsl";

/// What the reference makes of a program, as a file that expects it.
pub fn expected(program: &Generated, reference: &Engine) -> Result<String, String> {
    let text = program.render();
    let (buffers, counts) = Script::parse(NAME, text.clone())?.execute(reference.backend.as_ref())?;
    let counts = counts.unwrap_or_default().map(|c| c.to_string()).join(" ");
    Ok(format!("{}//! counts: {counts}\n{text}", expectations(&buffers)))
}

/// Compares `engines` with the reference. A program that differs is shrunk and shown, as a file of `tests/regressions`.
pub fn compare(program: &Generated, reference: &Engine, engines: &[Engine]) -> Result<(), String> {
    let text = expected(program, reference).map_err(|e| format!("the reference fails: {e}\n{}", program.render()))?;
    for engine in engines {
        if let Err(message) = run(&text, engine) {
            let smaller = shrink(program.clone(), &|p| fails(p, reference, engine, &message));
            let shown = expected(&smaller, reference).unwrap_or_else(|e| e);
            return Err(format!("{}: {message}\nshrunk to\n\n{shown}", engine.name));
        }
    }
    Ok(())
}

/// Whether a smaller program still fails in the same way.
fn fails(program: &Generated, reference: &Engine, engine: &Engine, message: &str) -> bool {
    if message.starts_with("panicked") {
        // A panic needs no reference, and the interpreter is the faster of the two.
        return run(&format!("//! expect 2: u32\n{}", program.render()), engine).is_err_and(|e| e == message);
    }
    expected(program, reference).is_ok_and(|text| run(&text, engine).is_err())
}

/// Runs a file; a panic is a failure like any other.
fn run(text: &str, engine: &Engine) -> Result<(), String> {
    let script = Script::parse(NAME, text.to_owned())?;
    catch_unwind(AssertUnwindSafe(|| script.run(engine))).unwrap_or_else(|panic| {
        let words = panic.downcast_ref::<String>().map(String::as_str);
        Err(format!("panicked: {}", words.or(panic.downcast_ref().copied()).unwrap_or_default()))
    })
}

/// All buffers but the read-only ones.
fn expectations(buffers: &Buffers) -> String {
    let line = |(binding, words): (&u32, &Vec<u32>)| {
        let words: Vec<String> = words.iter().map(u32::to_string).collect();
        format!("//! expect {binding}: u32 {}\n", words.join(" "))
    };
    buffers.iter().filter(|(binding, _)| **binding > 1).map(line).collect()
}

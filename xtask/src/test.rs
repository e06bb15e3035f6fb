//! `cargo xtask test`: all tests of the workspace in the release profile, with one total over all suites.
//!
//! The conformance cases are tests like all others (`conformance/tests/conformance.rs`): nothing runs twice.

use std::io::{self, BufRead, BufReader, Write};
use std::process::Stdio;

use crate::run::{cargo, finish, workspace};
use crate::{USAGE, say};

const HELP: &str = "\
Usage: cargo xtask test [--require NAME]… [-- ARGS]

Runs `cargo test --release --workspace --no-fail-fast ARGS`; the last line is the total over all suites.

  --require NAME  fail, rather than ignore, the tests of a device that is not there: `wgpu` or part of an adapter's name;
                  added to the list in SIGHTLINES_REQUIRE

Exit codes: 0 all passed; 1 a test failed or did not compile; 2 the command line is wrong";

const REQUIRE: &str = "SIGHTLINES_REQUIRE";

/// Runs the tests.
pub(crate) fn run(args: &[String]) -> u8 {
    let (own, forwarded) = match args.iter().position(|a| a == "--") {
        Some(at) => (&args[..at], &args[at + 1..]),
        None => (args, &[][..]),
    };
    let mut required: Vec<String> = std::env::var(REQUIRE).into_iter().filter(|v| !v.is_empty()).collect();
    let mut own = own.iter();
    while let Some(arg) = own.next() {
        match (arg.as_str(), arg.strip_prefix("--require=")) {
            ("--help" | "-h", _) => return say(io::stdout(), HELP, 0),
            (_, Some(name)) => required.push(name.to_owned()),
            ("--require", _) => match own.next() {
                Some(name) => required.push(name.clone()),
                None => return say(io::stderr(), &format!("error: --require needs a name\n\n{HELP}"), USAGE),
            },
            (other, _) => return say(io::stderr(), &format!("error: unexpected `{other}`\n\n{HELP}"), USAGE),
        }
    }
    spawn(&required.join(","), forwarded)
}

fn spawn(required: &str, forwarded: &[String]) -> u8 {
    let mut cargo = cargo("test");
    cargo.args(["--release", "--workspace", "--no-fail-fast"]).args(forwarded);
    cargo.current_dir(workspace()).stdout(Stdio::piped());
    if !required.is_empty() {
        cargo.env(REQUIRE, required);
    }
    let mut child = match cargo.spawn() {
        Ok(child) => child,
        Err(e) => return finish(Err(e)),
    };
    let mut totals = Totals::default();
    if let Some(output) = child.stdout.take() {
        for line in BufReader::new(output).lines() {
            let Ok(line) = line else { break };
            totals.add(&line);
            // A reader that has gone away does not end the tests.
            let _ = writeln!(io::stdout(), "{line}");
        }
    }
    let code = finish(child.wait());
    let code = if code == 0 && totals.failed == 0 && totals.passed > 0 { 0 } else { 1 };
    let Totals { passed, failed, skipped } = totals;
    say(io::stdout(), &format!("{passed} passed, {failed} failed, {skipped} skipped"), code)
}

/// Sums of the result lines of all suites.
#[derive(Debug, Default, PartialEq, Eq)]
struct Totals {
    passed: u64,
    failed: u64,
    skipped: u64,
}

impl Totals {
    /// Adds `test result: ok. 3 passed; 0 failed; 1 ignored; …`; other lines say nothing.
    fn add(&mut self, line: &str) {
        let Some((_, counts)) = line.strip_prefix("test result: ").and_then(|l| l.split_once(". ")) else { return };
        for part in counts.split(';') {
            let mut words = part.split_whitespace();
            let Some(Ok(count)) = words.next().map(str::parse::<u64>) else { continue };
            match words.next() {
                Some("passed") => self.passed += count,
                Some("failed") => self.failed += count,
                Some("ignored") => self.skipped += count,
                _ => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Totals;

    #[test]
    fn result_lines_are_summed_and_others_are_not() {
        let mut totals = Totals::default();
        for line in [
            "running 3 tests",
            "test result: ok. 3 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.00s",
            "test a::b ... ok",
            "test result: FAILED. 2 passed; 4 failed; 0 ignored; 0 measured; 9 filtered out; finished in 1.50s",
        ] {
            totals.add(line);
        }
        assert_eq!(totals, Totals { passed: 5, failed: 4, skipped: 1 });
    }
}

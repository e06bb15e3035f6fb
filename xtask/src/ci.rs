//! `cargo xtask ci`: what continuous integration runs once the devices are installed.

use std::io;

use crate::run::{cargo, finish, workspace};
use crate::{USAGE, say, test};

const HELP: &str = "\
Usage: cargo xtask ci [--require NAME]…

Runs `cargo xtask test --require NAME…`, the tests of the optional feature `simplify`, then `cargo fmt --check`, then
`cargo clippy` with warnings denied, also on the fuzz targets. All run, whichever fails; the exit code is the first that is not 0.";

/// Runs all steps.
pub(crate) fn run(args: &[String]) -> u8 {
    if args.iter().any(|a| a == "--help" || a == "-h") {
        return say(io::stdout(), HELP, 0);
    }
    let tests = test::run(args);
    if tests == USAGE {
        return tests;
    }
    // The fuzz targets are checked without a fuzzer to link.
    let step = |subcommand: &str, args: &[&str]| {
        let mut cargo = cargo(subcommand);
        cargo.args(args).env("CUSTOM_LIBFUZZER_PATH", "/nowhere/libnone.a").current_dir(workspace());
        finish(cargo.status())
    };
    let simplify = ["--release", "--workspace", "--features", "sightlines-visibility/simplify", "--test", "simplify"];
    let simplify = step("test", &simplify);
    let format = step("fmt", &["--all", "--check"]);
    let clippy = step("clippy", &["--release", "--workspace", "--all-targets", "--", "-D", "warnings"]);
    let fuzz = [
        "--release",
        "--locked",
        "--manifest-path",
        "fuzz/Cargo.toml",
        "--target-dir",
        "target",
        "--",
        "-D",
        "warnings",
    ];
    let fuzz = step("clippy", &fuzz);
    let steps = [("test", tests), ("simplify", simplify), ("fmt", format), ("clippy", clippy), ("fuzz targets", fuzz)];
    for (name, code) in steps {
        say(io::stdout(), &format!("{name}: {}", if code == 0 { "passed" } else { "FAILED" }), 0);
    }
    steps.into_iter().map(|(_, code)| code).find(|code| *code != 0).unwrap_or(0)
}

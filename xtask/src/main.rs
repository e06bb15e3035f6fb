//! `cargo xtask`: the workspace's commands.
//!
//! Every command spawns cargo in one profile, so that nothing is compiled twice. This program depends on no crate of
//! the workspace and on no other, so it builds in a second.

mod bench;
mod ci;
mod run;
mod test;

use std::io::{self, Write};
use std::process::ExitCode;

const HELP: &str = "\
Usage: cargo xtask COMMAND [OPTIONS]

Commands:
  conformance [OPTIONS]           run every case of every kernel on every backend and compare the bits
  test [--require NAME]… [-- ARGS]  all tests of the workspace, conformance included; fails where NAME
                                  (`wgpu` or an adapter) is missing; ARGS go to `cargo test`
  bench [FILTER] [OPTIONS]        measure the interpreter against lavapipe and other adapters on every kernel
  bench shadows [FILTER] [--embree]  measure soft shadows of generated meshes, and Embree beside us
  bench ambient [--embree]           measure ambient occlusion of a generated mesh, and Embree beside us
  bench queries                      measure visibility queries, beside the figures of their paper
  kernels list                    the kernels of the registry
  kernels show NAME [--emit wgsl|ir|code]
                                  one kernel as linked WGSL, naga IR or the interpreter's code
  doctor                          adapters, drivers, limits, variables, and what is missing
  ci                              what continuous integration runs: test, format, clippy

`cargo xtask COMMAND --help` says more.

Exit codes:
  0  as expected
  1  something failed
  2  the command line is wrong
  3  a required backend or adapter is missing
  4  no case is selected

Environment:
  SIGHTLINES_REQUIRE  as --require of `test`: a comma-separated list";

/// Exit code of a wrong command line.
const USAGE: u8 = 2;

fn main() -> ExitCode {
    let mut args = std::env::args().skip(1);
    let command = args.next().unwrap_or_default();
    let rest: Vec<String> = args.collect();
    let code = match command.as_str() {
        "conformance" => run::conformance(&[], &rest),
        "kernels" | "doctor" => run::conformance(&[&command], &rest),
        "test" => test::run(&rest),
        "bench" => bench::run(&rest),
        "ci" => ci::run(&rest),
        "help" | "--help" | "-h" => say(io::stdout(), HELP, 0),
        "" => say(io::stderr(), HELP, USAGE),
        other => say(io::stderr(), &format!("error: no command is called `{other}`\n\n{HELP}"), USAGE),
    };
    ExitCode::from(code)
}

/// Writes a text; a closed pipe is the reader's wish and no failure.
fn say(mut to: impl Write, text: &str, code: u8) -> u8 {
    match writeln!(to, "{text}") {
        Err(e) if e.kind() != io::ErrorKind::BrokenPipe => 1,
        _ => code,
    }
}

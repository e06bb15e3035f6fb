//! Spawning cargo: one profile, one place.

use std::io;
use std::path::Path;
use std::process::{Command, ExitStatus};

use crate::say;

/// Cargo in this workspace, whatever the current folder is.
pub(crate) fn cargo(subcommand: &str) -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.arg(subcommand);
    cargo
}

/// Root of the workspace.
pub(crate) fn workspace() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."))
}

/// Builds and runs the conformance program with the arguments as they are; file names stay relative to the current
/// folder.
pub(crate) fn conformance(command: &[&str], rest: &[String]) -> u8 {
    let mut cargo = cargo("run");
    cargo.args(["--quiet", "--release", "--package", "sightlines-conformance"]);
    cargo.args(["--bin", "sightlines-conformance", "--"]).args(command).args(rest);
    finish(cargo.status())
}

/// The exit code of a process that has ended, or that could not be started.
pub(crate) fn finish(status: io::Result<ExitStatus>) -> u8 {
    match status {
        Ok(status) => status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1),
        Err(e) => say(io::stderr(), &format!("error: cargo could not be started: {e}"), 1),
    }
}

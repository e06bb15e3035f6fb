//! Spawning cargo: one profile, one place.

use std::io;
use std::path::{Path, PathBuf};
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

/// Runs the conformance program with the arguments as they are; file names stay relative to the current folder.
pub(crate) fn conformance(command: &[&str], rest: &[String]) -> u8 {
    program("sightlines-conformance", command, rest)
}

/// Builds and runs a program of the workspace. It is built with the features that the whole workspace asks of its
/// dependencies, as the tests are, so that none of them is compiled twice.
fn program(name: &str, command: &[&str], rest: &[String]) -> u8 {
    let mut build = cargo("build");
    build.args(["--quiet", "--release", "--workspace", "--bin", name]).current_dir(workspace());
    match build.status() {
        Ok(status) if status.success() => {}
        Ok(_) => return 1,
        Err(e) => return finish(Err(e)),
    }
    match target_folder() {
        Ok(folder) => {
            let program = folder.join("release").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
            finish(Command::new(program).args(command).args(rest).status())
        }
        Err(e) => finish(Err(e)),
    }
}

/// Where cargo builds: this program is `debug/xtask` in it.
fn target_folder() -> io::Result<PathBuf> {
    let own = std::env::current_exe()?;
    let folder = own.parent().and_then(Path::parent);
    folder.map(Path::to_owned).ok_or_else(|| io::Error::other("xtask was not built by cargo"))
}

/// The exit code of a process that has ended, or that could not be started.
pub(crate) fn finish(status: io::Result<ExitStatus>) -> u8 {
    match status {
        Ok(status) => status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1),
        Err(e) => say(io::stderr(), &format!("error: a program could not be started: {e}"), 1),
    }
}

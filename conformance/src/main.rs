//! The program `sightlines-conformance`: `cargo xtask conformance`, `kernels` and `doctor`, and the worker processes.

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;
use sightlines_conformance::cli::{BackendName, Cli, Internal, Kernels};
use sightlines_conformance::error::{EXIT_OK, Error, Result};
use sightlines_conformance::machine::{self, Wanted};
use sightlines_conformance::{command, doctor, inspect, protocol, snapshot, worker};
use sightlines_kernels::registry;

fn main() -> ExitCode {
    match run(&Cli::parse()) {
        Ok(code) => ExitCode::from(code),
        // Whoever has closed the pipe wants no more words; a verdict is not lost this way.
        Err(Error::Output(e)) if e.kind() == ErrorKind::BrokenPipe => ExitCode::from(EXIT_OK),
        Err(error) => {
            let _ = writeln!(io::stderr(), "{}", labelled(&error.to_string()));
            ExitCode::from(error.exit_code())
        }
    }
}

/// What WGSL's front end says is labelled already.
fn labelled(message: &str) -> String {
    let message = message.trim_end();
    if message.starts_with("error") { message.to_owned() } else { format!("error: {message}") }
}

fn run(cli: &Cli) -> Result<u8> {
    let exe = std::env::current_exe().map_err(|e| Error::Worker(format!("this program's own path: {e}")))?;
    let mut out = io::BufWriter::new(io::stdout());
    let code = match &cli.command {
        None => command::run(&exe, registry(), &cli.run, &mut out)?,
        Some(Internal::Worker { backend, adapter, api, inject }) => {
            let wanted = match backend {
                BackendName::Cpu => Wanted::Cpu,
                BackendName::Wgpu => Wanted::Wgpu { adapter: adapter.clone(), api: api.clone() },
            };
            worker::serve(&wanted, inject.as_ref())?;
            EXIT_OK
        }
        Some(Internal::Adapters) => {
            protocol::send(&mut out, &machine::adapters_here())?;
            EXIT_OK
        }
        Some(Internal::WriteSnapshots) => {
            snapshot::write_here(io::stdin().lock())?;
            EXIT_OK
        }
        Some(Internal::Kernels(Kernels::List)) => {
            inspect::list(registry(), &mut out)?;
            EXIT_OK
        }
        Some(Internal::Kernels(Kernels::Show { name, emit })) => {
            inspect::show(registry(), name, *emit, &mut out)?;
            EXIT_OK
        }
        Some(Internal::Doctor) => doctor::report(&exe, &mut out)?,
    };
    out.flush()?;
    Ok(code)
}

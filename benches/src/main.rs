//! The program `sightlines-bench`: `cargo xtask bench`, and its worker processes.

use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

use clap::Parser;
use sightlines_benches::cli::{Cli, Internal};
use sightlines_benches::error::{EXIT_OK, Error, Result};
use sightlines_benches::{run, worker};

fn main() -> ExitCode {
    match start(&Cli::parse()) {
        Ok(code) => ExitCode::from(code),
        // Whoever has closed the pipe wants no more words.
        Err(Error::Output(e)) if e.kind() == ErrorKind::BrokenPipe => ExitCode::from(Error::Output(e).exit_code()),
        Err(error) => {
            let _ = writeln!(io::stderr(), "error: {}", error.to_string().trim_end());
            ExitCode::from(error.exit_code())
        }
    }
}

fn start(cli: &Cli) -> Result<u8> {
    match cli.command {
        None => {
            let exe = std::env::current_exe().map_err(|e| Error::Worker(format!("this program's own path: {e}")))?;
            run::run(&exe, &cli.bench, &mut io::stdout())
        }
        Some(Internal::Worker) => worker::serve(io::stdin().lock(), io::stdout()).map(|()| EXIT_OK),
        Some(Internal::Adapters) => worker::list_adapters(io::stdout()).map(|()| EXIT_OK),
    }
}

//! The program `sightlines`: visibility of your own scenes, on a GPU or without one.
//!
//! Results go to files, the report to standard output, progress and errors to standard error. Exit codes stand in the
//! help of the command line.

mod program;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use program::cli::{Cli, Command};

fn main() -> ExitCode {
    let Cli { command: Command::Shadows(args) } = Cli::parse();
    match program::shadows::run(&args, &mut io::stdout().lock()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !failure.is_closed_pipe() {
                let _ = writeln!(io::stderr(), "error: {}", failure.to_string().trim_end());
            }
            ExitCode::from(failure.exit_code())
        }
    }
}

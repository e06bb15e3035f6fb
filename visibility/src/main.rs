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
    let out = &mut program::Report::new();
    let done = match Cli::parse().command {
        Command::Shadows(args) => program::shadows::run(&args, out),
        Command::Compare(args) => program::compare::run(&args, out),
        Command::Queries(args) => program::queries::run(&args, out),
        Command::Cull(args) => program::cull::run(&args, out),
        Command::Ambient(args) => program::ambient::run(&args, out),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // Errors of kernels are rendered whole, this word included.
            let message = failure.to_string();
            let message = message.trim_end().trim_start_matches("error: ");
            let _ = writeln!(io::stderr(), "error: {message}");
            ExitCode::from(failure.exit_code())
        }
    }
}

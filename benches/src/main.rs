//! The program `sightlines-bench`: `cargo xtask bench`, and its worker processes.

use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use sightlines_benches::cli::{Cli, Work};
use sightlines_benches::error::{EXIT_OK, Error, Result};
use sightlines_benches::{ambient, instructions, queries, run, shadows, worker};

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
    match &cli.command {
        None => run::run(&own_path()?, &cli.bench, &mut io::stdout()),
        Some(Work::Shadows { filter, quick, scale, runs, embree, out }) => {
            let size = if *quick { shadows::Size::QUICK } else { shadows::Size::FULL };
            let size = shadows::Size { runs: runs.map_or(size.runs, usize::from), ..size };
            let (exe, folder) = (own_path()?, run::folder(out.as_deref())?);
            let cases =
                shadows::cases(size, if *scale { &shadows::SCALE[..] } else { &shadows::MESHES }, filter.as_ref());
            shadows::run(&exe, &cases, *embree, &folder, &mut io::stdout(), &mut io::stderr())
        }
        Some(Work::Ambient { quick, runs, embree, adapter, out }) => {
            let size = if *quick { ambient::Size::QUICK } else { ambient::Size::FULL };
            let size = ambient::Size { runs: runs.map_or(size.runs, usize::from), ..size };
            let (exe, folder) = (own_path()?, run::folder(out.as_deref())?);
            let engines = ambient::engines(&exe, adapter, &mut io::stdout())?;
            ambient::run(&exe, (size, &engines), *embree, &folder, &mut io::stdout(), &mut io::stderr())
        }
        Some(Work::Queries { quick, out }) => {
            let size = if *quick { queries::Size::QUICK } else { queries::Size::FULL };
            queries::run(size, &run::folder(out.as_deref())?, &mut io::stdout())
        }
        Some(Work::Shadow { case, tracer }) => {
            shadows::serve(case, tracer.as_deref(), &mut io::stdout()).map(|()| EXIT_OK)
        }
        Some(Work::Occlusion { case, tracer }) => {
            ambient::serve(case, tracer.as_deref(), &mut io::stdout()).map(|()| EXIT_OK)
        }
        Some(Work::Worker) => worker::serve(io::stdin().lock(), io::stdout()).map(|()| EXIT_OK),
        Some(Work::Repeat { simd, subject }) => {
            instructions::repeat(simd, subject, &mut io::stdout()).map(|()| EXIT_OK)
        }
        Some(Work::Adapters) => worker::list_adapters(io::stdout()).map(|()| EXIT_OK),
    }
}

fn own_path() -> Result<PathBuf> {
    std::env::current_exe().map_err(|e| Error::Worker(format!("this program's own path: {e}")))
}

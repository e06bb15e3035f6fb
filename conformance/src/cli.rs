//! The command line, and nothing but the command line.

use std::path::PathBuf;

use clap::builder::NonEmptyStringValueParser;
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::fault::Injection;
use crate::inspect::Emit;
use crate::plan::{Filter, Shard};

const AFTER_HELP: &str = "\
Exit codes:
  0  every result as expected
  1  a case failed, trapped, ran out of time or passed unexpectedly; or a report could not be written
  2  the command line, or a file named on it, is wrong
  3  a required backend or adapter is missing
  4  no case is selected

Environment:
  CI                 no progress; --bless is refused
  INSTA_UPDATE=no    --bless is refused
  WGPU_ADAPTER_NAME  as --adapter, where none is given
  WGPU_BACKEND       graphics interfaces to look at: vulkan, metal, dx12, gl
  VK_DRIVER_FILES    Vulkan drivers to load, by their JSON files

The last line on standard output is always `N passed, N failed, N skipped`.";

/// Runs every case of every kernel on every backend and compares the bits.
#[derive(Debug, Parser)]
#[command(name = "conformance", bin_name = "cargo xtask conformance", version, after_help = AFTER_HELP)]
#[command(override_usage = "cargo xtask conformance [OPTIONS]")]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true, disable_help_subcommand = true)]
pub struct Cli {
    /// What to do instead of running cases.
    #[command(subcommand)]
    pub command: Option<Internal>,
    /// Which cases run, where, and what is written.
    #[command(flatten)]
    pub run: RunArgs,
}

/// Which cases run, where, and what is written.
#[derive(Args, Debug)]
pub struct RunArgs {
    /// Backends to run [default: cpu,wgpu].
    #[arg(long, value_delimiter = ',', value_name = "NAME")]
    pub backend: Vec<BackendName>,
    /// Adapter by part of its name or driver; may be repeated [default: all Vulkan, Metal and DX12 adapters].
    #[arg(long, value_name = "NAME", value_parser = NonEmptyStringValueParser::new())]
    pub adapter: Vec<String>,
    /// Cases whose `kernel::case` matches; with `!` in front, those that do not; may be repeated.
    #[arg(long, value_name = "REGEX|!REGEX", allow_hyphen_values = true)]
    pub filter: Vec<Filter>,
    /// List the selected cases and stop.
    #[arg(long)]
    pub list: bool,
    /// Write the snapshots of the selected cases, where oracle and all machines agree.
    #[arg(long, conflicts_with_all = ["list", "replay", "kernel", "inject"])]
    pub bless: bool,
    /// Leave out cases of real size.
    #[arg(long)]
    pub quick: bool,
    /// End with code 3 unless this backend or adapter takes part; may be repeated.
    #[arg(long, value_name = "wgpu|ADAPTER", value_parser = NonEmptyStringValueParser::new())]
    pub require: Vec<String>,
    /// Reports to make.
    #[arg(long, value_delimiter = ',', default_value = "text", value_name = "FORMAT")]
    pub format: Vec<Format>,
    /// Folder of dumps and of reports that are files [default: target/conformance of the workspace].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Run one of N equal parts of the selected cases.
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// Run a dumped job on the wanted backends, and judge it by what was known when it was dumped.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["filter", "list", "quick", "shard", "kernel"])]
    pub replay: Option<PathBuf>,
    /// Cases at a time [default: one for each core, at most 4].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Seed of the random buffers of a `--case` file that names none.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Seconds that one machine may take for one case.
    #[arg(long, value_name = "S", default_value_t = 300, value_parser = clap::value_parser!(u64).range(1..))]
    pub timeout: u64,
    /// Stop after the first failure; what is left counts as skipped.
    #[arg(long)]
    pub fail_fast: bool,
    /// Run this kernel of yours; it has no snapshot, and all machines are compared.
    #[arg(long, value_name = "FILE.wgsl", requires = "case", conflicts_with_all = ["filter", "list", "quick", "shard"])]
    pub kernel: Option<PathBuf>,
    /// How to run it: entry point, workgroups and buffers.
    #[arg(long, value_name = "FILE.toml", requires = "kernel")]
    pub case: Option<PathBuf>,
    /// Make a deliberate fault; for the tests of the suite itself.
    #[arg(long, hide = true)]
    pub inject: Option<Injection>,
    /// Another folder of snapshots; for the tests of the suite itself.
    #[arg(long, hide = true)]
    pub snapshots: Option<PathBuf>,
    /// Another expectations file; for the tests of the suite itself.
    #[arg(long, hide = true)]
    pub expectations: Option<PathBuf>,
}

/// A backend by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BackendName {
    /// The interpreter.
    Cpu,
    /// The GPU backend.
    Wgpu,
}

/// A report's form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// On standard output.
    Text,
    /// `conformance.json` in the output folder.
    Json,
    /// `conformance.junit.xml` in the output folder.
    Junit,
}

/// What xtask and the suite itself call.
#[derive(Debug, Subcommand)]
pub enum Internal {
    /// Serve jobs over standard input and output.
    #[command(hide = true)]
    Worker {
        /// The backend.
        backend: BackendName,
        /// Name of the adapter.
        #[arg(long, default_value = "")]
        adapter: String,
        /// Its graphics interface.
        #[arg(long, default_value = "vulkan")]
        api: String,
        /// A deliberate fault.
        #[arg(long)]
        inject: Option<Injection>,
    },
    /// List the adapters, for the parent process.
    #[command(hide = true)]
    Adapters,
    /// Write snapshots that the parent process sends.
    #[command(hide = true)]
    WriteSnapshots,
    /// Kernels of the registry.
    #[command(hide = true, subcommand, bin_name = "cargo xtask kernels")]
    Kernels(Kernels),
    /// What this machine can run, and what is missing.
    #[command(hide = true, bin_name = "cargo xtask doctor")]
    Doctor,
}

/// Kernels of the registry.
#[derive(Debug, Subcommand)]
pub enum Kernels {
    /// One line a kernel.
    List,
    /// One kernel in full.
    Show {
        /// Its name.
        name: String,
        /// The form.
        #[arg(long, value_enum, default_value = "wgsl")]
        emit: Emit,
    },
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn options_that_contradict_each_other_are_refused() {
        let parse = |line: &str| Cli::try_parse_from(["conformance"].into_iter().chain(line.split(' ')));
        for good in ["--quick --filter !scan", "--backend cpu,wgpu --shard 1/2", "--kernel a.wgsl --case a.toml"] {
            assert!(parse(good).is_ok(), "{good}");
        }
        for bad in ["--kernel a.wgsl", "--bless --list", "--shard 2/1", "--jobs 0", "--backend gpu", "--filter ("] {
            assert!(parse(bad).is_err(), "{bad}");
        }
    }
}

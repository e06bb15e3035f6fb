//! The command line, and nothing but the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use regex::Regex;

use crate::baseline::parse_name;

const AFTER_HELP: &str = "\
Measured are the dispatches of a case, with memory resident on the device: CPU time of one thread on one core, wall time
of all cores. `ratio` is interpreter over lavapipe, the median of the rounds' ratios; below 1 the interpreter is faster.
Means are geometric: of a kernel's cases, then of the kernels. Results go to `backends.json` and `backends.html` in the
output folder.

Exit codes:
  0  everything was measured
  1  a subject failed on an engine, engines gave different bits, or a file could not be written
  2  the command line, or a baseline named on it, is wrong
  3  a required adapter, SIMD level or tool is missing
  4  the filter selects nothing

Environment:
  WGPU_BACKEND     graphics interfaces to look at: vulkan, metal, dx12, gl
  VK_DRIVER_FILES  Vulkan drivers to load, by their JSON files";

/// Measures the backends against each other on every kernel.
#[derive(Debug, Parser)]
#[command(name = "bench", bin_name = "cargo xtask bench", version, after_help = AFTER_HELP)]
#[command(args_conflicts_with_subcommands = true, disable_help_subcommand = true)]
pub struct Cli {
    /// Another measurement, or what the program's own children do.
    #[command(subcommand)]
    pub command: Option<Work>,
    /// What is measured, and where.
    #[command(flatten)]
    pub bench: BenchArgs,
}

/// What is measured, and where.
#[derive(Args, Clone, Debug)]
pub struct BenchArgs {
    /// Subjects whose `kernel/case` matches this regular expression [default: all].
    pub filter: Option<Regex>,
    /// List the ids of the selected subjects and stop.
    #[arg(long)]
    pub list: bool,
    /// Rounds, each of one measurement an engine [default: 5; 1 with --quick].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub rounds: Option<u16>,
    /// Thread settings.
    #[arg(long, value_delimiter = ',', value_name = "1,all", default_value = "1,all")]
    pub threads: Vec<ThreadSetting>,
    /// Adapter by part of its name or driver, beside lavapipe; may be repeated [default: all].
    #[arg(long, value_name = "NAME")]
    pub adapter: Vec<String>,
    /// SIMD level of the interpreter, or `all` that the machine has; may be repeated [default: the best].
    #[arg(long, value_name = "LEVEL", value_parser = ["all", "sse2", "neon", "baseline", "sse4.2", "avx2", "avx512"])]
    pub simd: Vec<String>,
    /// End with code 3 unless this adapter takes part; may be repeated.
    #[arg(long, value_name = "NAME")]
    pub require: Vec<String>,
    /// Count processor instructions too, with valgrind: slow, but no load on the machine changes them.
    #[arg(long)]
    pub callgrind: bool,
    /// What is written: tables to standard output, `backends.json`, `backends.html`.
    #[arg(long, value_delimiter = ',', value_name = "text,json,html", default_value = "text,json,html")]
    pub format: Vec<Format>,
    /// Folder of the results [default: target/bench of the workspace].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Keep the results under this name.
    #[arg(long, value_name = "NAME", value_parser = parse_name)]
    pub save_baseline: Option<String>,
    /// Compare with results that were kept.
    #[arg(long, value_name = "NAME", value_parser = parse_name)]
    pub baseline: Option<String>,
    /// Measure briefly: for a look, not for numbers that are kept.
    #[arg(long)]
    pub quick: bool,
}

/// A thread setting by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ThreadSetting {
    /// One thread, pinned to one core.
    #[value(name = "1")]
    One,
    /// A thread a core.
    All,
}

/// A form of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Tables.
    Text,
    /// One object, which baselines are made of.
    Json,
    /// One page that needs nothing else.
    Html,
}

/// Another measurement, or what the program's own children do.
#[derive(Debug, Subcommand)]
pub enum Work {
    /// Soft shadows of generated meshes on the interpreter, one thread.
    Shadows {
        /// Cases whose `mesh/light` matches this regular expression [default: all].
        filter: Option<Regex>,
        /// Bake little: for a look, not for numbers that are kept.
        #[arg(long)]
        quick: bool,
        /// Take meshes of 10 to 1,000,000 triangles, each ten times the one before.
        #[arg(long)]
        scale: bool,
        /// Runs after the warm-up; with 0 the first run counts [default: 3; 1 with --quick].
        #[arg(long, value_name = "N")]
        runs: Option<u8>,
        /// Trace the same rays with Embree, which is built on demand, and compare answers and times.
        #[arg(long)]
        embree: bool,
        /// Folder of the results [default: target/bench of the workspace].
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Ambient occlusion of a generated closed mesh on the interpreter and on lavapipe, one thread and all.
    Ambient {
        /// Take fewer directions: for a look, not for numbers that are kept.
        #[arg(long)]
        quick: bool,
        /// Runs after the warm-up; with 0 the first run counts [default: 3; 1 with --quick].
        #[arg(long, value_name = "N")]
        runs: Option<u8>,
        /// Trace the same rays with Embree, which is built on demand, and compare answers and times.
        #[arg(long)]
        embree: bool,
        /// Adapter by part of its name or driver, beside lavapipe; may be repeated.
        #[arg(long, value_name = "NAME")]
        adapter: Vec<String>,
        /// Folder of the results [default: target/bench of the workspace].
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Visibility queries: kernels, the tables of the paper, targets, baselines.
    Queries {
        /// Measure little: for a look, not for numbers that are kept.
        #[arg(long)]
        quick: bool,
        /// Folder of the results [default: target/bench of the workspace].
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Bake one case, for the parent process.
    #[command(hide = true)]
    Shadow {
        /// The case, as JSON.
        case: String,
        /// Embree's program.
        #[arg(long)]
        tracer: Option<PathBuf>,
    },
    /// Compute one visibility matrix, for the parent process.
    #[command(hide = true)]
    Occlusion {
        /// The case, as JSON.
        case: String,
        /// Embree's program.
        #[arg(long)]
        tracer: Option<PathBuf>,
    },
    /// Serve measurements over standard input and output.
    #[command(hide = true)]
    Worker,
    /// Repeat one subject once, for a parent that counts instructions.
    #[command(hide = true)]
    Repeat {
        /// SIMD level.
        simd: String,
        /// `kernel/case`.
        subject: String,
    },
    /// List the adapters, for the parent process.
    #[command(hide = true)]
    Adapters,
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
    fn command_lines_are_taken_and_refused() {
        let parse = |line: &str| Cli::try_parse_from(["bench"].into_iter().chain(line.split_whitespace()));
        let good =
            parse("scan --rounds 3 --threads all --simd avx2 --simd sse2 --save-baseline a --quick").unwrap().bench;
        assert_eq!(parse("--format json,html").unwrap().bench.format, [Format::Json, Format::Html]);
        assert_eq!((good.rounds, good.threads, good.simd.len()), (Some(3), vec![ThreadSetting::All], 2));
        let bare = parse("").unwrap().bench;
        assert_eq!(bare.threads, [ThreadSetting::One, ThreadSetting::All]);
        for bad in ["(", "--rounds 0", "--threads 7", "--simd mmx", "--baseline ../x", "a b"] {
            assert!(parse(bad).is_err(), "{bad}");
        }
        assert!(matches!(
            parse("shadows palms --quick --embree --runs 0").unwrap().command,
            Some(Work::Shadows { quick: true, embree: true, runs: Some(0), .. })
        ));
        assert!(matches!(
            parse("ambient --embree --runs 2 --adapter a --adapter b").unwrap().command,
            Some(Work::Ambient { quick: false, embree: true, runs: Some(2), adapter, .. }) if adapter == ["a", "b"]
        ));
        assert!(matches!(parse("queries --quick").unwrap().command, Some(Work::Queries { quick: true, .. })));
        assert!(matches!(parse("worker").unwrap().command, Some(Work::Worker)));
    }
}

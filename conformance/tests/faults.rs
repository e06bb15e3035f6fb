//! The suite catches what it is there to catch: each deliberate fault ends in exit code 1, with a table that names
//! kernel, case, machine, buffer, index and both words, and with a replay command that shows the same again.
//!
//! Every fault is tried on the interpreter and, where there is one, on a GPU.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use sightlines_conformance::machine::{Asked, Fleet, INSTALL_VULKAN};
use sightlines_conformance::snapshot;
use sightlines_kernels::registry;

const KERNEL: &str = "popcount";
const CASE: &str = "one_past_group";

/// A constant of the kernel; `5` becomes `4`.
const MASK: &str = "0x55555555u";

type Outcome = Result<(), String>;

/// Makes one fault and looks at what comes of it.
type Fault = fn(&Bench) -> Outcome;

fn main() -> ExitCode {
    let args = Arguments::from_args();
    let found = Fleet::find(exe(), &Asked { cpu: true, wgpu: true, ..Asked::default() });
    let gpu = found.ok().and_then(|f| f.machines.into_iter().find(|m| m.identity.backend == "wgpu")).map(|m| m.name);
    let faults: [(&str, Fault); 9] = [
        ("no_fault", no_fault),
        ("bit_of_the_wgsl", wgsl),
        ("bit_of_the_oracle", oracle),
        ("bit_of_the_snapshot", snapshot_bit),
        ("bit_of_an_output", output),
        ("another_adapter", adapter),
        ("crash", crash),
        ("hang", hang),
        ("endless_loop", endless_loop),
    ];
    let mut trials = Vec::new();
    for (name, fault) in faults {
        trials.push(Trial::test(format!("{name}::cpu"), move || tried("cpu", name, fault)));
        // The interpreter alone has fuel; a device without a watchdog would not come back.
        if name == "endless_loop" {
            continue;
        }
        let gpu = gpu.clone();
        trials.push(Trial::ignorable_test(format!("{name}::wgpu"), move || match gpu {
            Some(machine) => tried(&machine, name, fault).map(|()| Completion::Completed),
            None if std::env::var("SIGHTLINES_REQUIRE").is_ok_and(|list| !list.is_empty()) => {
                Err("there is no adapter".into())
            }
            None => Ok(Completion::ignored_with(format!("no adapter; {INSTALL_VULKAN}"))),
        }));
    }
    trials.extend(suite_faults());
    libtest_mimic::run(&args, trials).exit_code()
}

fn exe() -> &'static Path {
    Path::new(env!("CARGO_BIN_EXE_sightlines-conformance"))
}

fn tried(machine: &str, name: &str, fault: Fault) -> Result<(), Failed> {
    let bench = Bench::new(machine, name).map_err(|e| e.to_string())?;
    fault(&bench).map_err(Failed::from)
}

/// A folder of its own, removed at the end, and the machine to spoil.
struct Bench {
    machine: String,
    folder: PathBuf,
}

impl Drop for Bench {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// A run of the suite.
struct Run {
    code: i32,
    text: String,
}

impl Bench {
    fn new(machine: &str, name: &str) -> std::io::Result<Self> {
        let short = if machine == "cpu" { "cpu" } else { "wgpu" };
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("faults-{name}-{short}"));
        fs::create_dir_all(&folder)?;
        Ok(Bench { machine: machine.to_owned(), folder })
    }

    fn suite(&self, args: &[&str]) -> Run {
        let mut command = Command::new(exe());
        command.args(args).env_remove("SIGHTLINES_REQUIRE").current_dir(&self.folder);
        let output = command.output().expect("the program starts");
        let text = [output.stdout, output.stderr].map(|s| String::from_utf8_lossy(&s).into_owned()).concat();
        Run { code: output.status.code().unwrap_or(-1), text }
    }

    fn backends(&self) -> &'static str {
        if self.machine == "cpu" { "cpu" } else { "cpu,wgpu" }
    }

    /// Runs the one case with a fault on this machine.
    fn inject(&self, fault: &str) -> Run {
        let filter = format!("^{KERNEL}::{CASE}$");
        let fault = format!("{fault}@{}", self.machine);
        let snapshots = snapshot::folder().display().to_string();
        let common = ["--backend", self.backends(), "--filter", &filter, "--out", ".", "--timeout", "120"];
        self.suite(&[&common[..], &["--snapshots", &snapshots, "--inject", &fault]].concat())
    }

    /// The run failed, its table has a row for the case on this machine, and the replay command shows the row again.
    fn caught(&self, run: &Run, kernel: &str, case: &str) -> Result<Vec<String>, String> {
        let row = self.row(run, kernel, case)?;
        let command = run.text.lines().find_map(|l| l.trim().strip_prefix("replay: cargo xtask conformance "));
        let command = command.ok_or_else(|| format!("no replay command in\n{}", run.text))?;
        let mut args: Vec<&str> = command.split(' ').collect();
        args.extend(["--backend", self.backends()]);
        let again = self.suite(&args);
        let same = self.row(&again, kernel, case)?;
        if same == row { Ok(row) } else { Err(format!("{row:?} was replayed as {same:?}")) }
    }

    fn row(&self, run: &Run, kernel: &str, case: &str) -> Result<Vec<String>, String> {
        if run.code != 1 {
            return Err(format!("exit code {} and not 1\n{}", run.code, run.text));
        }
        let cells =
            |l: &str| l.trim().split("  ").map(str::trim).filter(|c| !c.is_empty()).map(str::to_owned).collect();
        let mut rows = run.text.lines().map(cells).filter(|c: &Vec<String>| c.len() >= 7);
        let row = rows.find(|c| c[..3] == [kernel.to_owned(), case.to_owned(), self.machine.clone()]);
        row.ok_or_else(|| format!("no row of {kernel} {case} {} in\n{}", self.machine, run.text))
    }

    /// Both words of a row, which must be one bit apart.
    fn one_bit_apart(&self, row: &[String]) -> Outcome {
        let word = |cell: &String| u32::from_str_radix(cell.trim_start_matches("0x"), 16).map_err(|e| e.to_string());
        let apart = (word(&row[5])? ^ word(&row[6])?).count_ones();
        let indexed = row[4].parse::<u64>().is_ok() && !row[3].is_empty();
        if apart == 1 && indexed { Ok(()) } else { Err(format!("not one bit of one word: {row:?}")) }
    }
}

fn says(run: &Run, words: &str) -> Outcome {
    if run.text.contains(words) { Ok(()) } else { Err(format!("`{words}` is not in\n{}", run.text)) }
}

/// Without a fault the same case passes: what the others catch is the fault alone.
fn no_fault(bench: &Bench) -> Outcome {
    let filter = format!("^{KERNEL}::{CASE}$");
    let run = bench.suite(&["--backend", bench.backends(), "--filter", &filter, "--out", "."]);
    if run.code == 0 { says(&run, "0 failed, 0 skipped") } else { Err(run.text) }
}

fn wgsl(bench: &Bench) -> Outcome {
    let kernel = registry().iter().find(|k| k.name == KERNEL).ok_or("the kernel is not in the registry")?;
    let program = (kernel.programs)().map_err(|e| e.to_string())?.remove(0);
    let at = program.linked().text.find(MASK).ok_or("the constant is not in the WGSL")? + MASK.len() - 2;
    let run = bench.inject(&format!("wgsl:{at}:0"));
    bench.caught(&run, KERNEL, CASE)?;
    says(&run, "[oracle]")
}

fn oracle(bench: &Bench) -> Outcome {
    let run = bench.inject("oracle");
    bench.one_bit_apart(&bench.caught(&run, KERNEL, CASE)?)?;
    says(&run, "[oracle]")
}

fn snapshot_bit(bench: &Bench) -> Outcome {
    let run = bench.inject("snapshot");
    bench.one_bit_apart(&bench.caught(&run, KERNEL, CASE)?)?;
    says(&run, "[snapshot]")
}

fn output(bench: &Bench) -> Outcome {
    let run = bench.inject("output");
    bench.one_bit_apart(&bench.caught(&run, KERNEL, CASE)?)?;
    says(&run, "[oracle]")
}

fn adapter(bench: &Bench) -> Outcome {
    let run = bench.inject("adapter");
    let row = bench.caught(&run, KERNEL, CASE)?;
    if !row[6].contains("not ") {
        return Err(format!("the adapter that ran is not named: {row:?}"));
    }
    says(&run, "[identity]")
}

fn crash(bench: &Bench) -> Outcome {
    let run = bench.inject("crash");
    let row = bench.caught(&run, KERNEL, CASE)?;
    if row[6] != "none (crash)" {
        return Err(format!("not a crash: {row:?}"));
    }
    says(&run, "the worker died: signal: 6")
}

fn hang(bench: &Bench) -> Outcome {
    let filter = format!("^{KERNEL}::{CASE}$");
    let fault = format!("hang@{}", bench.machine);
    let common = ["--backend", bench.backends(), "--filter", &filter, "--out", "."];
    let run = bench.suite(&[&common[..], &["--timeout", "2", "--inject", &fault]].concat());
    let row = bench.caught(&run, KERNEL, CASE)?;
    if row[6] == "none (timeout)" { says(&run, "timeout") } else { Err(format!("not a timeout: {row:?}")) }
}

const LOOP: &str = "@group(0) @binding(0) var<storage, read_write> words: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    var n = 1u;
    while (n != 0u) {
        n = (n + 2u) | 1u;
    }
    words[id.x] = n;
}
";

const LOOP_CASE: &str = "entry = \"main\"
[[buffer]]
name = \"words\"
zeros = 64
read = true
expected = [0]
";

/// A loop that does not end uses up its fuel and is a trap.
fn endless_loop(bench: &Bench) -> Outcome {
    fs::write(bench.folder.join("endless.wgsl"), LOOP).map_err(|e| e.to_string())?;
    fs::write(bench.folder.join("once.toml"), LOOP_CASE).map_err(|e| e.to_string())?;
    let run = bench.suite(&["--backend", "cpu", "--kernel", "endless.wgsl", "--case", "once.toml", "--out", "."]);
    let row = bench.caught(&run, "endless", "once")?;
    if row[6] != "none (trap)" {
        return Err(format!("not a trap: {row:?}"));
    }
    says(&run, "no end after")
}

/// Faults of the suite's own files: an orphan, a missing snapshot, a bad expectation.
fn suite_faults() -> Vec<Trial> {
    let faults: [(&str, Fault); 4] = [
        ("snapshot_without_a_case", orphan),
        ("case_without_a_snapshot", missing),
        ("unexpected_pass", unexpected_pass),
        ("expected_failure", expected_failure),
    ];
    let trial = |(name, fault): (&'static str, Fault)| Trial::test(name, move || tried("cpu", name, fault));
    faults.into_iter().map(trial).collect()
}

fn with(bench: &Bench, args: &[&str]) -> Run {
    let filter = format!("^{KERNEL}::{CASE}$");
    bench.suite(&[&["--backend", "cpu", "--filter", &filter, "--out", "."][..], args].concat())
}

fn orphan(bench: &Bench) -> Outcome {
    let folder = bench.folder.join("snapshots");
    copy(&snapshot::folder(), &folder).map_err(|e| e.to_string())?;
    fs::write(folder.join(KERNEL).join("moon.snap"), "---\n---\nmoon\n").map_err(|e| e.to_string())?;
    let run = with(bench, &["--snapshots", "snapshots"]);
    says(&run, "popcount/moon.snap: no case has this snapshot")?;
    if run.code == 1 { Ok(()) } else { Err(format!("exit code {}", run.code)) }
}

fn missing(bench: &Bench) -> Outcome {
    let run = with(bench, &["--snapshots", "nowhere"]);
    says(&run, "the case has no snapshot")?;
    if run.code == 1 { Ok(()) } else { Err(format!("exit code {}", run.code)) }
}

fn expect(bench: &Bench) -> Outcome {
    let entry = format!("[[expect]]\nbackend = \"cpu\"\ntest = \"{KERNEL}::{CASE}\"\nreason = \"a known fault\"\n");
    fs::write(bench.folder.join("expectations.toml"), entry).map_err(|e| e.to_string())
}

fn unexpected_pass(bench: &Bench) -> Outcome {
    expect(bench)?;
    let run = with(bench, &["--expectations", "expectations.toml"]);
    says(&run, "passes, but is expected to fail: a known fault")?;
    if run.code == 1 { Ok(()) } else { Err(format!("exit code {}", run.code)) }
}

fn expected_failure(bench: &Bench) -> Outcome {
    expect(bench)?;
    let run = with(bench, &["--expectations", "expectations.toml", "--inject", "output@cpu"]);
    says(&run, "expected-fail cpu")?;
    if run.code == 0 { Ok(()) } else { Err(format!("exit code {}\n{}", run.code, run.text)) }
}

fn copy(from: &Path, to: &Path) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let path = entry?.path();
        let target = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() { copy(&path, &target)? } else { fs::copy(&path, &target).map(|_| ())? }
    }
    Ok(())
}

//! The program from outside: exit codes, what is said without a GPU, reports, your own kernel, files that are wrong.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const ADD_ONE: &str = "@group(0) @binding(0) var<storage, read> input: array<u32>;
@group(0) @binding(1) var<storage, read_write> output: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x < arrayLength(&output)) {
        output[id.x] = input[id.x] + 1u;
    }
}
";

const ADD_ONE_CASE: &str = "entry = \"main\"
[[buffer]]
name = \"input\"
words = [1, 0xffffffff, -3]
[[buffer]]
name = \"output\"
zeros = 3
read = true
expected = [2, 0, -2]
";

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{name}"));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    fn with(self, file: &str, text: &str) -> Self {
        fs::write(self.0.join(file), text).unwrap();
        self
    }

    /// A run on a machine without drivers: exit code, standard output, standard error.
    fn run(&self, args: &[&str]) -> (i32, String, String) {
        let output = self.command(args).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (output.status.code().unwrap_or(-1), text(output.stdout), text(output.stderr))
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines-conformance"));
        command.args(args).current_dir(&self.0);
        command.env("VK_DRIVER_FILES", "/nowhere").env("VK_ICD_FILENAMES", "/nowhere").env("WGPU_BACKEND", "vulkan");
        for variable in ["CI", "INSTA_UPDATE", "WGPU_ADAPTER_NAME", "SIGHTLINES_REQUIRE"] {
            command.env_remove(variable);
        }
        command
    }

    /// A run of a kernel and a case in this folder.
    fn own(&self) -> (i32, String, String) {
        self.run(&["--backend", "cpu", "--kernel", "k.wgsl", "--case", "c.toml", "--out", "."])
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn last(text: &str) -> &str {
    text.lines().last().unwrap_or("")
}

#[test]
fn without_a_driver_the_interpreter_passes_and_the_report_says_what_was_not_tested() {
    let folder = Folder::new("no-driver");
    let (code, out, _) = folder.run(&["--filter", "^popcount::one_sample$", "--out", "."]);
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("pass cpu; skip wgpu"), "{out}");
    assert!(out.contains("wgpu was NOT tested") && out.contains("apt-get install mesa-vulkan-drivers"), "{out}");
    assert_eq!(last(&out), "5 passed, 0 failed, 1 skipped");
}

#[test]
fn what_is_required_and_missing_ends_in_3() {
    let folder = Folder::new("required");
    for args in [
        &["--require", "wgpu"][..],
        &["--require", "llvmpipe"],
        &["--adapter", "llvmpipe"],
        &["--backend", "wgpu"],
        &["--bless", "--filter", "^popcount::one_sample$"],
    ] {
        let (code, out, err) = folder.run(args);
        assert_eq!((code, out.as_str()), (3, ""), "{args:?}: {err}");
        assert!(err.contains("apt-get install mesa-vulkan-drivers"), "{args:?}: {err}");
    }
}

#[test]
fn nothing_selected_ends_in_4_and_a_wrong_command_line_in_2() {
    let folder = Folder::new("usage");
    assert_eq!(folder.run(&["--filter", "no such case"]).0, 4);
    assert_eq!(folder.run(&["--filter", "no such case", "--list"]).0, 4);
    for args in [&["--filter", "("][..], &["--shard", "3/2"], &["--nonsense"], &["--kernel", "k.wgsl"]] {
        assert_eq!(folder.run(args).0, 2, "{args:?}");
    }
    let (code, help, _) = folder.run(&["--help"]);
    assert_eq!(code, 0);
    assert!(help.contains("Exit codes:") && help.contains("Environment:") && !help.contains("--inject"), "{help}");
}

#[test]
fn shards_list_every_case_once() {
    let folder = Folder::new("shards");
    let list = |args: &[&str]| {
        let (code, out, err) = folder.run(&[&["--list"][..], args].concat());
        assert_eq!(code, 0, "{err}");
        out.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let mut parts = [list(&["--shard", "1/2"]), list(&["--shard", "2/2"])].concat();
    let mut all = list(&[]);
    assert!(all.iter().any(|name| name == "popcount::nothing"));
    parts.sort();
    all.sort();
    assert_eq!(parts, all);
}

#[test]
fn reports_are_files_and_the_last_line_stays() {
    let folder = Folder::new("reports");
    let args =
        ["--backend", "cpu", "--filter", "^scan::(one|three)$", "--format", "json,junit", "--out", "deep/report"];
    let (code, out, err) = folder.run(&args);
    assert_eq!((code, out.as_str()), (0, "6 passed, 0 failed, 0 skipped\n"), "{err}");
    let json = fs::read_to_string(folder.0.join("deep/report/conformance.json")).unwrap();
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!((&json["schema"], &json["passed"]), (&1.into(), &6.into()));
    assert_eq!(json["machines"][0]["identity"]["backend"], "cpu");
    assert!(json["results"][0]["costs"]["invocations"].as_u64().unwrap() > 0);
    let junit = fs::read_to_string(folder.0.join("deep/report/conformance.junit.xml")).unwrap();
    assert!(junit.contains(r#"<testcase name="one[cpu]" classname="scan""#), "{junit}");
    assert_eq!(fs::read_dir(folder.0.join("deep/report")).unwrap().count(), 2, "temporary files are left");
}

#[test]
fn a_folder_that_cannot_be_written_is_an_error_and_the_verdict_is_still_told() {
    let folder = Folder::new("unwritable").with("taken", "a file");
    let filter = ["--backend", "cpu", "--filter", "^scan::one$", "--format", "text,json"];
    let (code, out, err) = folder.run(&[&filter[..], &["--out", "taken"]].concat());
    assert_eq!((code, last(&out)), (1, "5 passed, 0 failed, 0 skipped"), "{out}{err}");
    assert!(err.contains("taken"), "{err}");
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let folder = Folder::new("pipe");
    for args in [&["--list"][..], &["kernels", "show", "scan", "--emit", "ir"], &["--backend", "cpu", "--quick"]] {
        let mut child = folder.command(args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let mut said = String::new();
        child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
        assert_eq!((child.wait().unwrap().code(), said.as_str()), (Some(0), ""), "{args:?}");
    }
}

#[test]
fn kernels_can_be_listed_and_shown_in_each_form() {
    let folder = Folder::new("kernels");
    let (code, out, _) = folder.run(&["kernels", "list"]);
    assert_eq!(code, 0);
    assert!(out.lines().any(|l| l.starts_with("popcount ") && l.contains("of real size")), "{out}");
    for (form, word) in [("wgsl", "fn count_logarithmic"), ("ir", "EntryPoint"), ("code", "instructions")] {
        let (code, out, err) = folder.run(&["kernels", "show", "popcount", "--emit", form]);
        assert_eq!(code, 0, "{err}");
        assert!(out.contains(word), "{form}");
    }
    let (code, _, err) = folder.run(&["kernels", "show", "moon"]);
    assert_eq!(code, 2);
    assert!(err.contains("popcount"), "{err}");
}

#[test]
fn the_doctor_says_what_is_missing_and_how_to_get_it() {
    let (code, out, _) = Folder::new("doctor").run(&["doctor"]);
    assert_eq!(code, 3, "{out}");
    assert!(out.contains("interpreter: cpu on interpreter"), "{out}");
    assert!(out.contains("VK_DRIVER_FILES=/nowhere") && out.contains("apt-get install mesa-vulkan-drivers"), "{out}");
}

#[test]
fn your_own_kernel_runs_and_is_judged_by_the_expected_words() {
    let folder = Folder::new("own").with("k.wgsl", ADD_ONE).with("c.toml", ADD_ONE_CASE);
    let (code, out, err) = folder.own();
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("this kernel has no snapshot"), "{out}");
    assert_eq!(last(&out), "1 passed, 0 failed, 0 skipped");

    let folder = folder.with("c.toml", &ADD_ONE_CASE.replace("[2, 0, -2]", "[2, 7, -2]"));
    let (code, out, _) = folder.own();
    assert_eq!(code, 1, "{out}");
    assert!(out.contains("k       c     cpu      output  1      0x00000007  0x00000000"), "{out}");
    assert!(folder.0.join("k-c-cpu.job").is_file(), "{out}");
}

#[test]
fn an_invocation_that_turns_too_often_fails_before_a_device_is_silent_about_it() {
    let rounds = "output[id.x] = input[id.x] + 1u;\n    }\n    for (var k = 0u; k < ROUNDS; k++) {\n        output[0] |= k & 0u;";
    let kernel = |count: &str| ADD_ONE.replace("output[id.x] = input[id.x] + 1u;", &rounds.replace("ROUNDS", count));
    for (count, code) in [("65533u", 0), ("65534u", 1)] {
        let folder = Folder::new(&format!("turns-{count}")).with("k.wgsl", &kernel(count)).with("c.toml", ADD_ONE_CASE);
        let (got, out, err) = folder.own();
        assert_eq!(got, code, "{out}{err}");
        assert_eq!(out.contains("takes 65535 turns of loops") && out.contains("lavapipe"), code == 1, "{out}");
    }
}

#[test]
fn random_buffers_depend_on_the_seed_alone() {
    let case = "entry = \"main\"\n[[buffer]]\nname = \"input\"\nrandom = 64\n\
                [[buffer]]\nname = \"output\"\nzeros = 64\nread = true\nexpected = [0]\n";
    let folder = Folder::new("seed").with("k.wgsl", ADD_ONE).with("c.toml", case);
    let words = |seed: &str| {
        let args = ["--backend", "cpu", "--kernel", "k.wgsl", "--case", "c.toml", "--out", ".", "--seed", seed];
        let (_, out, _) = folder.run(&args);
        out.lines().filter(|l| l.trim().starts_with("k ")).map(str::to_owned).collect::<Vec<_>>()
    };
    assert!(!words("1").is_empty());
    assert_eq!(words("1"), words("1"));
    assert_ne!(words("1"), words("2"));
}

#[test]
fn an_access_past_the_end_is_a_trap_with_its_line() {
    let case = ADD_ONE_CASE.replace("words = [1, 0xffffffff, -3]", "zeros = 1").replace("expected = [2, 0, -2]\n", "");
    let (code, out, _) = Folder::new("trap").with("k.wgsl", ADD_ONE).with("c.toml", &case).own();
    assert_eq!(code, 1, "{out}");
    assert!(
        out.contains("trap cpu") && out.contains("k.wgsl:7:") && out.contains("out of bounds of length 1"),
        "{out}"
    );
}

#[test]
fn what_is_wrong_in_a_file_is_said_with_its_line() {
    let wrong = [
        ("entry = \"moon\"", "c.toml:1: the WGSL has no entry point `moon`"),
        ("entry = \"main\"\n", "c.toml:1: no buffer is given for `input`"),
        (
            "entry = \"main\"\n[[buffer]]\nname = \"inputs\"\nzeros = 1",
            "c.toml:3: `inputs` is no buffer that `main` uses",
        ),
        ("entry = \"main\"\n[[buffer]]\nname = \"input\"\n", "c.toml:2: the buffer's contents are not clear"),
        (
            "entry = \"main\"\n[[buffer]]\nname = \"input\"\nwords = [1,\n5000000000]",
            "c.toml:5: this number has no 32-bit word",
        ),
        ("entry = \"main\"\n[[buffer]]\nname = \"input\"\nfile = \"none.bin\"", "c.toml:4: "),
        ("entry = \"main\"\ncolour = 3", "c.toml:2: unknown field `colour`"),
        ("entry = ", "c.toml:1: "),
    ];
    for (case, message) in wrong {
        let (code, _, err) = Folder::new("wrong").with("k.wgsl", ADD_ONE).with("c.toml", case).own();
        assert_eq!(code, 2, "{case}: {err}");
        assert!(err.contains(message) && err.contains("remedy:"), "{case}: {err}");
    }
    let broken = ADD_ONE.replace("+ 1u", "+ 1.5");
    let (code, _, err) = Folder::new("wgsl").with("k.wgsl", &broken).with("c.toml", ADD_ONE_CASE).own();
    assert_eq!(code, 2);
    assert!(err.starts_with("error") && err.contains("k.wgsl:7:"), "{err}");
}

#[test]
fn files_that_are_no_jobs_are_refused() {
    let folder = Folder::new("replay").with("not.job", "hello");
    let (code, _, err) = folder.run(&["--backend", "cpu", "--replay", "not.job"]);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("not.job"), "{err}");
    assert_eq!(folder.run(&["--replay", "missing.job"]).0, 2);
}

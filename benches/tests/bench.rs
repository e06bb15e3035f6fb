//! The program as its users run it: what it writes, what it says, and its exit codes. Without a driver as well, since
//! the loader of Vulkan drivers finds none where `VK_DRIVER_FILES` names none.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use sightlines_benches::ambient::{self, Row};
use sightlines_benches::engine::{adapters_here, interpreters};
use sightlines_benches::{Clock, Engine, Report, Threads};

/// A folder of its own for each test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("sightlines-bench-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    fn report(&self) -> Report {
        Report::read(&self.0.join("backends.json")).unwrap()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A folder that stays behind is only litter.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn bench(folder: &Path, line: &str) -> Command {
    let mut bench = Command::new(env!("CARGO_BIN_EXE_sightlines-bench"));
    bench.args(line.split_whitespace()).arg("--out").arg(folder);
    bench.env_remove("WGPU_BACKEND").env_remove("WGPU_ADAPTER_NAME");
    bench
}

fn without_driver(folder: &Path, line: &str) -> Command {
    let mut bench = bench(folder, line);
    bench.env("VK_DRIVER_FILES", "/nonexistent.json").env("VK_ICD_FILENAMES", "/nonexistent.json");
    bench
}

/// Exit code, standard output, standard error.
fn ran(mut command: Command) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = command.output().unwrap();
    (status.code(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

#[test]
fn a_run_measures_every_engine_and_writes_one_object() {
    let folder = Folder::new("run");
    let (code, out, err) = ran(bench(&folder.0, "micro/gather --quick --threads 1 --rounds 2 --simd sse2 --simd avx2"));
    assert_eq!(code, Some(0), "{out}{err}");
    let report = folder.report();
    let lavapipe = adapters_here().into_iter().map(Engine::Wgpu).any(|engine| engine.is_lavapipe());
    assert_eq!(report.summary.lavapipe.is_some(), lavapipe);
    let interpreter: Vec<_> = report.rows.iter().filter(|row| row.backend == "cpu").collect();
    assert_eq!(interpreter.iter().map(|row| row.simd.as_deref()).collect::<Vec<_>>(), [Some("sse2"), Some("avx2")]);
    for row in &report.rows {
        assert_eq!((row.id().as_str(), row.threads, row.rounds_ns.len()), ("micro/gather", 1, 2));
        assert!(row.median_ns > 0.0 && row.lane_ops.unwrap() > 64 << 16, "{row:?}");
        assert_eq!(row.ratio_to_lavapipe.is_some(), lavapipe && row.backend == "cpu");
    }
    assert!(out.contains("interpreter ms") && out.contains("micro, 1 thread, avx2"), "{out}");
    assert!(!out.contains("Benchmarking") && !err.contains("Benchmarking"), "criterion's words belong to a file");
}

#[test]
fn without_lavapipe_the_interpreter_runs_alone_and_it_is_said() {
    let folder = Folder::new("alone");
    let (code, out, err) = ran(without_driver(&folder.0, "micro/reduction --quick --threads 1 --save-baseline first"));
    assert_eq!(code, Some(0), "{out}{err}");
    assert!(out.contains("note: no lavapipe adapter") && out.contains("mesa-vulkan-drivers"), "{out}");
    let rows = folder.report().rows;
    assert!(rows.len() == 1 && rows[0].backend == "cpu" && rows[0].ratio_to_lavapipe.is_none(), "{rows:?}");

    let (code, out, err) = ran(without_driver(&folder.0, "micro/reduction --quick --threads 1 --baseline first"));
    assert_eq!(code, Some(0), "{out}{err}");
    assert!(out.contains("time since first") && out.contains(" %"), "{out}");
}

#[test]
fn what_is_required_and_missing_ends_with_3() {
    let folder = Folder::new("required");
    for line in ["--require llvmpipe", "--require wgpu", "--adapter llvmpipe", "--simd neon --simd sse2"] {
        let (code, _, err) = ran(without_driver(&folder.0, line));
        assert_eq!(code, Some(3), "{line}: {err}");
        assert!(err.starts_with("error: "), "{err}");
    }
    assert!(!folder.0.join("backends.json").exists());
}

#[test]
fn wrong_command_lines_end_with_2_and_empty_selections_with_4() {
    let folder = Folder::new("usage");
    for (line, expected) in [("--baseline none", 2), ("--threads 3", 2), ("(", 2), ("no_such_kernel", 4)] {
        let (code, _, err) = ran(without_driver(&folder.0, line));
        assert_eq!(code, Some(expected), "{line}: {err}");
    }
    let (code, out, _) = ran(bench(&folder.0, "^micro/ --list"));
    assert_eq!((code, out.lines().count()), (Some(0), 4));
}

#[test]
fn ambient_occlusion_has_the_same_bits_in_every_setting_and_level_by_level() {
    let folder = Folder::new("ambient");
    let size = ambient::Size { subdivision: 8, level: 2, runs: 2 };
    let engines = interpreters(&["all".to_owned()]).unwrap();
    let exe = Path::new(env!("CARGO_BIN_EXE_sightlines-bench"));
    let (mut out, mut progress) = (Vec::new(), Vec::new());
    let code = ambient::run(exe, (size, &engines), false, &folder.0, &mut out, &mut progress).unwrap();
    let out = String::from_utf8(out).unwrap();
    assert_eq!(code, 0, "{out}");
    assert!(out.starts_with("258 vertices, 512 triangles, 66 directions: 0.0 MiB of bits"), "{out}");
    assert_eq!(String::from_utf8(progress).unwrap().lines().count(), 2 * engines.len());

    let text = std::fs::read_to_string(folder.0.join("ambient.json")).unwrap();
    let value: serde_json::Value = serde_json::from_str(&text).unwrap();
    let expected = serde_json::json!({ "subdivision": 8, "level": 2, "runs": 2, "threads": "One", "clock": "cpu" });
    for (key, expected) in expected.as_object().unwrap() {
        assert!((cfg!(not(unix)) && key == "clock") || value[0][key] == *expected, "{key} in {}", value[0]);
    }
    let rows: Vec<Row> = serde_json::from_value(value).unwrap();
    for (row, pair) in rows.iter().zip(0..) {
        assert_eq!(row.case.engine, engines[pair / 2]);
        assert_eq!(row.clock, Clock::of(row.case.threads));
        assert_eq!((row.digest, row.occluded), (rows[0].digest, rows[0].occluded));
        assert_eq!((row.runs_ns.len(), row.matrix_bytes, row.embree.len()), (2, 4 * 3 * 258, 0));
        // Only one thread does the same work each time.
        assert_eq!(row.refinement.is_some(), row.case.threads == Threads::One);
        assert!(row.case.threads == Threads::All || row.lane_ops == rows[0].lane_ops, "{row:?}");
        assert!((row.ns_per_bit * 258.0 * 66.0 / row.median_ns - 1.0).abs() < 1e-9);
        assert!(row.occluded > 0.3 && row.occluded < 0.7, "{}", row.occluded);
    }
    let refinement = rows[0].refinement.as_ref().unwrap();
    assert_eq!(refinement.steps.iter().map(|step| step.directions).collect::<Vec<_>>(), [6, 18, 66]);
    assert!(refinement.steps.is_sorted_by_key(|step| step.lane_ops));
    assert_eq!(Some(refinement.alone), rows[0].lane_ops);
    assert!(refinement.ratio >= 1.0, "{}", refinement.ratio);
}

#[cfg(unix)]
#[test]
fn children_that_die_are_failures_and_no_rows() {
    let folder = Folder::new("dead");
    let size = ambient::Size { subdivision: 4, level: 0, runs: 0 };
    let engines = interpreters(&[]).unwrap();
    let (mut out, mut progress) = (Vec::new(), Vec::new());
    let code = ambient::run(Path::new("false"), (size, &engines), false, &folder.0, &mut out, &mut progress).unwrap();
    let (out, progress) = (String::from_utf8(out).unwrap(), String::from_utf8(progress).unwrap());
    assert_eq!((code, out.matches("FAILED: ").count()), (1, 2), "{out}");
    assert!(progress.starts_with(&format!("[1/2] {}, 1 thread: failed\n", engines[0])), "{progress}");
    assert_eq!(std::fs::read_to_string(folder.0.join("ambient.json")).unwrap(), "[]\n");
}

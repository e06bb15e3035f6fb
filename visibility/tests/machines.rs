//! One scene, one file: `sightlines shadows` writes the same bytes on every machine.
//!
//! Test names read `machine/scene`. The reference is the interpreter on one thread; it is compared with two threads, with
//! every SIMD level that this host has, and with every adapter. Without an adapter those tests report themselves as
//! ignored, with the reason; `SIGHTLINES_REQUIRE` (names separated by commas: `wgpu`, or a part of an adapter's name or
//! driver) makes a missing one a failure.

use std::path::Path;
use std::process::{Command, ExitCode};
use std::sync::{Arc, OnceLock};

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use sightlines_backend_cpu::{Config, CpuBackend, Simd};
use sightlines_backend_wgpu::{WgpuBackend, WgpuOptions};
use sightlines_visibility::image::{Depth, Share, write_exr, write_png};
use sightlines_visibility::scene::{Generator, Scene, generate, load};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::bake;
use sightlines_visibility::{Result, sets};

/// A scene by name, with its resolution and samples.
#[derive(Clone, Copy)]
struct Subject {
    name: &'static str,
    resolution: u32,
    samples: u32,
}

const SUBJECTS: [Subject; 3] = [
    Subject { name: "palms", resolution: 32, samples: 1024 },
    Subject { name: "box", resolution: 64, samples: 32 },
    Subject { name: "model.gltf", resolution: 57, samples: 256 },
];

/// PNG, EXR and sets.
type Files = [Vec<u8>; 3];

const NAMES: [&str; 3] = ["a.png", "a.exr", "a.sets"];

/// Two instances of a triangle, one of them scaled, turned and moved into the floor.
const MODEL: &str = r#"{
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0, "translation": [0.1, 0.6, 0]},
              {"mesh": 0, "scale": [1.5, 0.7, 2], "rotation": [0, 0.38268343, 0, 0.9238795], "translation": [-0.4, 0.2, 0.1]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [-0.5, -0.3, -0.4], "max": [0.7, 0.6, 0.5]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": "model.bin", "byteLength": 36}]
}"#;

const VERTICES: [f32; 9] = [-0.5, -0.3, 0.0, 0.7, 0.1, -0.4, 0.0, 0.6, 0.5];

impl Subject {
    /// The arguments that name it, in a folder that then holds what they need.
    fn arguments(self, folder: &Path) -> Result<Vec<String>, Failed> {
        let model = self.name.ends_with(".gltf");
        if model {
            std::fs::write(folder.join(self.name), MODEL)?;
            std::fs::write(folder.join("model.bin"), VERTICES.map(f32::to_le_bytes).concat())?;
        }
        let scene = if model { vec![self.name] } else { vec!["--scene", self.name] };
        let (resolution, samples) = (self.resolution.to_string(), self.samples.to_string());
        let size = ["--resolution", &resolution, "--samples", &samples];
        let outputs = ["-o", NAMES[0], "--exr", NAMES[1], "--sets", NAMES[2]];
        Ok([&scene[..], &size, &outputs].concat().into_iter().map(str::to_owned).collect())
    }

    /// What the program writes on a machine, whose line of the report must name `shown`.
    fn files(self, machine: &[&str], shown: &str) -> Result<Files, Failed> {
        let folder = tempfile::tempdir()?;
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
        command.arg("shadows").args(self.arguments(folder.path())?).args(machine).current_dir(folder.path());
        let output = command.output()?;
        let (report, errors) = (String::from_utf8(output.stdout)?, String::from_utf8(output.stderr)?);
        if !output.status.success() {
            return Err(format!("{}: {errors}", output.status).into());
        }
        let ran = report.lines().find(|line| line.starts_with("backend ")).unwrap_or_default();
        if !ran.contains(shown) {
            return Err(format!("`{shown}` was asked for, and this ran: {ran}").into());
        }
        read(folder.path())
    }

    /// What the library writes on an interpreter of one SIMD level.
    fn files_at(self, simd: Simd) -> Result<Files, Failed> {
        let folder = tempfile::tempdir()?;
        self.arguments(folder.path())?;
        let setup = Setup::new(
            self.scene(folder.path())?,
            &Settings { resolution: Some(self.resolution), samples: Some(self.samples), ..Settings::default() },
        )?;
        let machine = CpuBackend::new(Config { simd: Some(simd), ..Config::default() });
        if machine.simd() != simd {
            return Err(format!("{} ran instead", machine.simd().name()).into());
        }
        let baked = bake(&machine, &setup.request(), &mut |_| ())?;
        let [png, exr, sets] = NAMES.map(|name| folder.path().join(name));
        let share = Share::of(&baked);
        write_png(&png, &share, Depth::Eight)?;
        write_exr(&exr, &share)?;
        sets::write(&sets, &baked.sets)?;
        read(folder.path())
    }

    fn scene(self, folder: &Path) -> Result<Scene> {
        Generator::from_name(self.name).map_or_else(|| load(&folder.join(self.name)), |known| Ok(generate(known)))
    }
}

fn read(folder: &Path) -> Result<Files, Failed> {
    let [png, exr, sets] = NAMES.map(|name| std::fs::read(folder.join(name)));
    Ok([png?, exr?, sets?])
}

/// The files of one interpreter on one thread, made by the first test that asks.
struct Reference(Subject, OnceLock<Result<Files, String>>);

impl Reference {
    fn equals(&self, files: &Files) -> Result<(), Failed> {
        let make = || self.0.files(&["--backend", "cpu", "--threads", "1"], "1 thread");
        let reference = self.1.get_or_init(|| make().map_err(|e| e.message().unwrap_or_default().to_owned()));
        for (name, (expected, found)) in NAMES.iter().zip(reference.as_ref()?.iter().zip(files)) {
            if expected != found {
                let at = expected.iter().zip(found).take_while(|(a, b)| a == b).count();
                return Err(format!("{name} differs from the interpreter's at byte {at} of {}", expected.len()).into());
            }
        }
        Ok(())
    }
}

fn main() -> ExitCode {
    let adapters = WgpuBackend::adapters(&WgpuOptions::default());
    let required = std::env::var("SIGHTLINES_REQUIRE").unwrap_or_default();
    let required = required.split(',').map(str::trim).filter(|name| !name.is_empty() && *name != "cpu");
    let mut trials: Vec<Trial> = required.map(requirement).collect();
    for subject in SUBJECTS {
        let reference = Arc::new(Reference(subject, OnceLock::new()));
        let trial = |machine: &str, files: Box<dyn FnOnce() -> Result<Files, Failed> + Send>| {
            let reference = Arc::clone(&reference);
            Trial::test(format!("{machine}/{}", subject.name), move || reference.equals(&files()?))
        };
        trials.push(trial(
            "threads_2",
            Box::new(move || subject.files(&["--backend", "cpu", "--threads", "2"], "2 threads")),
        ));
        for simd in Simd::available() {
            trials.push(trial(simd.name(), Box::new(move || subject.files_at(simd))));
        }
        if adapters.is_empty() {
            trials.push(ignored("none", subject, "no adapter: wgpu is not tested".to_owned()));
        }
        for adapter in &adapters {
            let name = adapter.name.clone();
            trials.push(if adapter.lacks.is_empty() {
                let asked = name.clone();
                trial(&name, Box::new(move || subject.files(&["--backend", "wgpu", "--adapter", &asked], &asked)))
            } else {
                ignored(&name, subject, adapter.lacks.join("; "))
            });
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

/// Fails unless the program finds an adapter of that name.
fn requirement(name: &str) -> Trial {
    let name = name.to_owned();
    Trial::test(format!("required/{name}"), move || {
        let adapter = if name == "wgpu" { vec![] } else { vec!["--adapter", &*name] };
        SUBJECTS[1].files(&[&["--backend", "wgpu"], &adapter[..]].concat(), "wgpu").map(drop)
    })
}

fn ignored(machine: &str, subject: Subject, reason: String) -> Trial {
    let name = format!("{machine}/{}", subject.name);
    Trial::ignorable_test(name, move || Ok(Completion::ignored_with(reason)))
}

//! One scene, one file: `sightlines` writes the same bytes on every machine.
//!
//! Test names read `machine/scene`. The reference is the interpreter on one thread; it is compared with two threads,
//! with every SIMD level that this host has, and with every adapter. Without an adapter those tests report themselves
//! as ignored, with the reason; `SIGHTLINES_REQUIRE` (names separated by commas: `wgpu`, or a part of an adapter's name
//! or driver) makes a missing one a failure.

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

/// A scene by name, and what is made of it.
#[derive(Clone, Copy)]
struct Subject {
    name: &'static str,
    work: Work,
}

#[derive(Clone, Copy)]
enum Work {
    /// `sightlines shadows`.
    Shadows { resolution: u32, samples: u32 },
    /// `sightlines shadows` with these options, of a generated scene or of `neon.toml`.
    Exposure { options: &'static [&'static str] },
    /// `sightlines ambient`, with these options.
    Ambient { options: &'static [&'static str], names: &'static [&'static str] },
    /// `sightlines compare` of crossing squares at two light sizes; its methods must agree on each machine too.
    Compare { resolution: u32, samples: u32 },
}

const SUBJECTS: [Subject; 11] = [
    Subject { name: "compare", work: Work::Compare { resolution: 24, samples: 64 } },
    Subject { name: "palms", work: Work::Shadows { resolution: 32, samples: 1024 } },
    Subject { name: "box", work: Work::Shadows { resolution: 64, samples: 32 } },
    Subject { name: "model.gltf", work: Work::Shadows { resolution: 57, samples: 256 } },
    Subject {
        name: "quads",
        work: Work::Exposure {
            options: &[
                "--resolution",
                "24",
                "--samples",
                "100",
                "--pattern",
                "blue-noise",
                "--decorrelate",
                "--heights",
                "bumps",
                "--height-scale",
                "0.3",
                "--result",
                "irradiance",
            ],
        },
    },
    Subject {
        name: "ground",
        work: Work::Exposure {
            options: &[
                "--resolution",
                "32",
                "--samples",
                "64",
                "--lightmap",
                "--pattern",
                "halton",
                "--light-size",
                "2",
            ],
        },
    },
    Subject { name: "neon.toml", work: Work::Exposure { options: &["--result", "irradiance", "--word-bits", "31"] } },
    Subject {
        name: "colonnade",
        work: Work::Ambient {
            options: &["--level", "2", "--environment", "sky", "--rotate", "50", "--size", "96x64"],
            names: &["a.glb", "a.ply", "a.occl", "a.png"],
        },
    },
    Subject {
        name: "bumpy-2000",
        work: Work::Ambient {
            options: &["--healpix", "1", "--lazy", "--orbit", "2", "--size", "96x64"],
            names: &["a.0.png", "a.1.png"],
        },
    },
    // The second frame has the matrix of the first.
    Subject {
        name: "spinning.gltf",
        work: Work::Ambient {
            options: &["--level", "2", "--environment", "sky", "--frames", "2", "--size", "96x64"],
            names: &["a.0.png", "a.1.png"],
        },
    },
    Subject {
        name: "cloth",
        work: Work::Ambient {
            options: &["--level", "1", "--frames", "2", "--size", "96x64"],
            names: &["a.0.png", "a.1.png"],
        },
    },
];

/// Two instances of a triangle that turn together about an upright axis.
const SPINNING: &str = r#"{
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [2]}],
    "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [0.1, 0.6, -0.3]}, {"children": [0, 1]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "animations": [{"channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
                    "samplers": [{"input": 1, "output": 2}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [-0.5, -0.3, -0.4], "max": [0.7, 0.6, 0.5]},
                  {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
                  {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC4"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
                    {"buffer": 0, "byteOffset": 44, "byteLength": 32}],
    "buffers": [{"uri": "model.bin", "byteLength": 76}]
}"#;

/// Its keys: times, and no turn and half of one.
const KEYS: [f32; 10] = [0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0];

/// Tubes of two colours over a box that moves.
const NEON: &str = r#"
generator = "box"
pattern = "jittered"
resolution = 24
samples = 200
[[light]]
corner = [-1.0, 4.0, -1.0]
u = [2.0, 0.0, 0.0]
v = [0.0, 0.0, 2.0]
tubes = { count = 3, width = 0.3, colours = [[1.0, 0.3, 0.2], [0.2, 0.4, 1.0]] }
[motion]
offset = [1.0, 0.0, 0.5]
frames = 2
"#;

type Files = Vec<Vec<u8>>;

/// PNG, EXR and sets.
const NAMES: [&str; 3] = ["a.png", "a.exr", "a.sets"];
const OUTPUTS: [&str; 6] = ["-o", NAMES[0], "--exr", NAMES[1], "--sets", NAMES[2]];

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
    /// The files that it makes.
    fn names(self) -> &'static [&'static str] {
        match self.work {
            Work::Shadows { .. } | Work::Exposure { .. } => &NAMES,
            Work::Ambient { names, .. } => names,
            Work::Compare { .. } => &["a.0.png", "a.1.png"],
        }
    }

    /// The arguments that name it, in a folder that then holds what they need.
    fn arguments(self, folder: &Path) -> Result<Vec<String>, Failed> {
        match self.work {
            Work::Shadows { resolution, samples } => self.shadows(folder, resolution, samples),
            Work::Exposure { options } => self.exposure(folder, options),
            Work::Ambient { options, names } => self.ambient(folder, options, names),
            Work::Compare { resolution, samples } => {
                let size = format!("--resolution {resolution} --samples {samples} --light-size 0.5,2");
                let line = format!("compare --scene quads {size} -o a.png");
                Ok(line.split(' ').map(str::to_owned).collect())
            }
        }
    }

    fn ambient(self, folder: &Path, options: &[&'static str], names: &[&'static str]) -> Result<Vec<String>, Failed> {
        let source = match self.name {
            "cloth" => vec!["--motion", self.name],
            "spinning.gltf" => {
                std::fs::write(folder.join(self.name), SPINNING)?;
                let data = [&VERTICES.map(f32::to_le_bytes)[..], &KEYS.map(f32::to_le_bytes)].concat();
                std::fs::write(folder.join("model.bin"), data.concat())?;
                vec![self.name]
            }
            _ => vec!["--scene", self.name],
        };
        let output = |name: &&'static str| match name.rsplit('.').next() {
            Some("glb" | "ply") => vec!["-o", name],
            Some("occl") => vec!["--matrix", name],
            _ => vec![],
        };
        let outputs: Vec<&str> = names.iter().flat_map(output).collect();
        let all = [&["ambient", "--picture", "a.png"], &source[..], options, &outputs].concat();
        Ok(all.into_iter().map(str::to_owned).collect())
    }

    fn exposure(self, folder: &Path, options: &[&'static str]) -> Result<Vec<String>, Failed> {
        let is_file = self.name.ends_with(".toml");
        if is_file {
            std::fs::write(folder.join(self.name), NEON)?;
        }
        let scene = ["shadows", if is_file { "--scene-file" } else { "--scene" }, self.name];
        Ok([&scene[..], &OUTPUTS, options].concat().into_iter().map(str::to_owned).collect())
    }

    fn shadows(self, folder: &Path, resolution: u32, samples: u32) -> Result<Vec<String>, Failed> {
        let model = self.name.ends_with(".gltf");
        if model {
            std::fs::write(folder.join(self.name), MODEL)?;
            std::fs::write(folder.join("model.bin"), VERTICES.map(f32::to_le_bytes).concat())?;
        }
        let scene = if model { vec![self.name] } else { vec!["--scene", self.name] };
        let (resolution, samples) = (resolution.to_string(), samples.to_string());
        let size = ["--resolution", &resolution, "--samples", &samples];
        Ok([&["shadows"], &scene[..], &size, &OUTPUTS].concat().into_iter().map(str::to_owned).collect())
    }

    /// What the program writes on a machine, whose line of the report must name `shown`.
    fn files(self, machine: &[&str], shown: &str) -> Result<Files, Failed> {
        let folder = tempfile::tempdir()?;
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
        command.args(self.arguments(folder.path())?).args(machine).current_dir(folder.path());
        let output = command.output()?;
        let (report, errors) = (String::from_utf8(output.stdout)?, String::from_utf8(output.stderr)?);
        if !output.status.success() {
            return Err(format!("{}: {errors}", output.status).into());
        }
        let ran = report.lines().find(|line| line.starts_with("backend ")).unwrap_or_default();
        if !ran.contains(shown) {
            return Err(format!("`{shown}` was asked for, and this ran: {ran}").into());
        }
        read(folder.path(), self.names())
    }

    /// What the library writes of a shadow on an interpreter of one SIMD level.
    fn files_at(self, simd: Simd, resolution: u32, samples: u32) -> Result<Files, Failed> {
        let folder = tempfile::tempdir()?;
        self.shadows(folder.path(), resolution, samples)?;
        let setup = Setup::new(
            self.scene(folder.path())?,
            &Settings { resolution: Some(resolution), samples: Some(samples), ..Settings::default() },
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
        read(folder.path(), &NAMES)
    }

    fn scene(self, folder: &Path) -> Result<Scene> {
        Generator::from_name(self.name).map_or_else(|| load(&folder.join(self.name)), |known| Ok(generate(known)))
    }
}

fn read(folder: &Path, names: &[&str]) -> Result<Files, Failed> {
    Ok(names.iter().map(|name| std::fs::read(folder.join(name))).collect::<Result<_, _>>()?)
}

/// The files of one interpreter on one thread, made by the first test that asks.
struct Reference(Subject, OnceLock<Result<Files, String>>);

impl Reference {
    fn equals(&self, files: &Files) -> Result<(), Failed> {
        let make = || self.0.files(&["--backend", "cpu", "--threads", "1"], "1 thread");
        let reference = self.1.get_or_init(|| make().map_err(|e| e.message().unwrap_or_default().to_owned()));
        for (name, (expected, found)) in self.0.names().iter().zip(reference.as_ref()?.iter().zip(files)) {
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
        if let Work::Shadows { resolution, samples } = subject.work {
            for simd in Simd::available() {
                trials.push(trial(simd.name(), Box::new(move || subject.files_at(simd, resolution, samples))));
            }
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

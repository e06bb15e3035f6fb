//! One stage, one answer: queries, culling and predicated drawing give the same words on every machine.
//!
//! Test names read `machine/what`. The reference is the interpreter on one thread; it is compared with two threads,
//! with every SIMD level that this host has, and with every adapter. Without an adapter those tests report themselves
//! as ignored, with the reason.

use std::process::ExitCode;
use std::sync::OnceLock;

use libtest_mimic::{Arguments, Completion, Failed, Trial};
use sightlines_backend::Backend;
use sightlines_backend_cpu::{Config, CpuBackend, Simd};
use sightlines_backend_wgpu::{WgpuBackend, WgpuOptions};
use sightlines_kernels::depth_bounds::Form;
use sightlines_kernels::item_histogram::Order;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::Result;
use sightlines_visibility::queries::baselines::{depth_tests, predicated};
use sightlines_visibility::queries::device::draw_counted;
use sightlines_visibility::queries::displacement::{Scene, displace};
use sightlines_visibility::queries::transparency::{Veil, query_veiled};
use sightlines_visibility::queries::{Granularity, Method, Stage, query, share};
use sightlines_visibility::scene::frame::Frame;
use sightlines_visibility::scene::{creature_field, creature_in_hall, crowd};

type Ask = fn(&dyn Backend) -> Result<Vec<u32>>;

/// What a machine is asked, by name.
const ASKED: [(&str, Ask); 4] =
    [("counts", counts), ("displacement", displacement), ("baselines", baselines), ("applications", applications)];

/// Totals, tiles, pixels and depths by both methods and orders, clusters, and what instances cover alone.
fn counts(backend: &dyn Backend) -> Result<Vec<u32>> {
    let world = crowd(50);
    let frame = Frame::new(&world.cameras[0], Picture { width: 72, height: 50 }, world.corners().as_flattened())?;
    let stage = Stage::of(&world, frame)?;
    let mut words = Vec::new();
    for method in [Method::HIB, Method::Hib { order: Order::Scattered }, Method::SAT] {
        let answer = query(backend, &stage, method, 2, &mut |_| ())?;
        words.extend([answer.totals, answer.tiles, answer.shown, answer.depths].concat());
    }
    let all: Vec<usize> = (0..world.instances.len()).collect();
    words.extend(share::covered(backend, &stage, &all, &mut |_| ())?);
    let clusters = Stage::new(&world, frame, &all, Granularity::Clusters { shift: 5 })?;
    words.extend(query(backend, &clusters, Method::HIB, 0, &mut |_| ())?.totals);
    Ok(words)
}

/// Which prisms are kept, by tables and by the item buffer.
fn displacement(backend: &dyn Backend) -> Result<Vec<u32>> {
    let world = creature_in_hall();
    let scene = Scene::new(&world, 0, displace(&world.meshes[0], 0.06, 1, creature_field));
    let frame = Frame::new(&world.cameras[1], Picture { width: 96, height: 96 }, &scene.points())?;
    let mut words = Vec::new();
    for method in [Method::HIB, Method::SAT] {
        words.extend(scene.cull(backend, frame, method, 4)?.kept.into_iter().map(u32::from));
    }
    Ok(words)
}

/// What depth tests keep, and the picture of predicated draws.
fn baselines(backend: &dyn Backend) -> Result<Vec<u32>> {
    let world = crowd(30);
    let frame = Frame::new(&world.cameras[0], Picture { width: 64, height: 48 }, world.corners().as_flattened())?;
    let stage = Stage::of(&world, frame)?;
    let (verdict, painted) = predicated(backend, &world, &stage)?;
    let mut words = [painted.depths, verdict.kept.into_iter().map(u32::from).collect()].concat();
    for form in [Form::Pyramid, Form::Buffers] {
        words.extend(depth_tests(backend, &stage, form)?.kept.into_iter().map(u32::from));
    }
    Ok(words)
}

/// Weighted sums through veils by both methods, and a picture of what another view counted.
fn applications(backend: &dyn Backend) -> Result<Vec<u32>> {
    let world = crowd(24);
    let frame = |camera: usize| {
        Frame::new(&world.cameras[camera], Picture { width: 64, height: 48 }, world.corners().as_flattened())
    };
    let opaque: Vec<usize> = (0..world.instances.len()).filter(|i| i % 2 == 0).collect();
    let veil = |i: usize| Veil { instance: i, through: 10 * i as u32 };
    let veils: Vec<Veil> = (0..world.instances.len()).filter(|i| i % 2 == 1).map(veil).collect();
    let mut words = Vec::new();
    for method in [Method::HIB, Method::SAT] {
        let veiled = query_veiled(backend, &world, frame(0)?, &opaque, &veils, method)?;
        words.extend([veiled.sums, veiled.weights, veiled.answer.totals].concat());
    }
    let [view, light] = [Stage::of(&world, frame(0)?)?, Stage::of(&world, frame(1)?)?];
    words.extend(draw_counted(backend, &light, &view, Method::HIB, 9)?.depths);
    Ok(words)
}

/// The words of one interpreter on one thread, made by the first test that asks.
static REFERENCE: [OnceLock<Result<Vec<u32>, String>>; 4] = [const { OnceLock::new() }; 4];

fn compare(asked: usize, backend: &dyn Backend) -> Result<(), Failed> {
    let one = CpuBackend::new(Config { threads: 1, ..Config::default() });
    let expected = REFERENCE[asked].get_or_init(|| ASKED[asked].1(&one).map_err(|e| e.to_string())).as_ref()?;
    let found = ASKED[asked].1(backend)?;
    match expected.iter().zip(&found).position(|(a, b)| a != b) {
        None if expected.len() == found.len() => Ok(()),
        at => Err(format!("{} words of {}, first difference at {at:?}", found.len(), expected.len()).into()),
    }
}

fn main() -> ExitCode {
    let adapters = WgpuBackend::adapters(&WgpuOptions::default());
    let mut trials = Vec::new();
    for (asked, (name, _)) in ASKED.iter().enumerate() {
        let on = |machine: &str, config: Config| {
            Trial::test(format!("{machine}/{name}"), move || compare(asked, &CpuBackend::new(config)))
        };
        trials.push(on("threads_2", Config { threads: 2, ..Config::default() }));
        for simd in Simd::available() {
            trials.push(on(simd.name(), Config { simd: Some(simd), ..Config::default() }));
        }
        if adapters.is_empty() {
            trials.push(ignored("none", name, "no adapter: wgpu is not tested".to_owned()));
        }
        for adapter in &adapters {
            trials.push(if adapter.lacks.is_empty() {
                let options = WgpuOptions { adapter: Some(adapter.name.clone()), ..WgpuOptions::default() };
                Trial::test(format!("{}/{name}", adapter.name), move || compare(asked, &WgpuBackend::new(&options)?))
            } else {
                ignored(&adapter.name, name, adapter.lacks.join("; "))
            });
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

fn ignored(machine: &str, name: &str, reason: String) -> Trial {
    Trial::ignorable_test(format!("{machine}/{name}"), move || Ok(Completion::ignored_with(reason)))
}

//! Faults: whatever goes wrong is a typed error, never a panic, a hang or a silent fallback.

use std::time::{Duration, Instant};

use sightlines_backend::{
    Backend, BufferId, Command, DeviceError, Dispatch, ErrorKind, Groups, Job, Recording, Result,
};
use sightlines_backend_wgpu::{Backends, WgpuBackend, WgpuOptions};

use crate::{Test, program, reopen, words};

pub(crate) const TESTS: &[(&str, Test)] = &[
    ("wrong_adapter_is_named", wrong_adapter_is_named),
    ("missing_interface_is_named", missing_interface_is_named),
    ("info_names_the_adapter", info_names_the_adapter),
    ("workgroups_that_do_not_fit", workgroups_that_do_not_fit),
    ("malformed_recordings", malformed_recordings),
    ("buffer_beyond_the_limit", buffer_beyond_the_limit),
    ("textures_are_named", textures_are_named),
    ("uncaught_error_is_reported_once", uncaught_error_is_reported_once),
    ("lost_device_stays_lost", lost_device_stays_lost),
    ("timeout_ends_the_wait", timeout_ends_the_wait),
];

const TOUCH: &str = "
override lanes: u32 = 1u;
override rows: u32 = 1u;
var<workgroup> memory: array<u32, rows>;
@group(0) @binding(0) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(lanes)
fn touch() { out[0] = 1u + memory[0]; }";

/// The error of the device that ended the work.
fn device_error<T>(result: Result<T>) -> DeviceError {
    let error = result.err().expect("the work must fail");
    match error.kind() {
        ErrorKind::Device(fault) => fault.clone(),
        _ => panic!("not an error of the device: {error}"),
    }
}

/// The rule that was broken.
fn refusal<T>(result: Result<T>) -> String {
    let error = result.err().expect("the work must be refused");
    match error.kind() {
        ErrorKind::Refused { what, .. } => what.clone(),
        _ => panic!("not a refusal: {error}"),
    }
}

/// One dispatch of [`TOUCH`], which `change` may spoil.
fn touch(change: impl FnOnce(&mut Dispatch)) -> Result<Job> {
    let mut job = Job::new();
    let program = job.program(&program("touch", TOUCH)?);
    let out = job.buffer("out", 4);
    let (slots, groups) = (vec![job.slot(0, out)], Groups::Direct([1, 1, 1]));
    let mut dispatch = Dispatch { program, entry: "touch".into(), overrides: Vec::new(), slots, groups };
    change(&mut dispatch);
    job.record(Command::Dispatch(dispatch));
    job.read("out", out);
    Ok(job)
}

/// Runs a job through a session, as systems do that feed one by hand.
fn run_by_hand(backend: &WgpuBackend, job: &Job) -> Result<Vec<u32>> {
    let mut session = backend.open(&job.programs, &job.buffers)?;
    job.recordings.iter().try_for_each(|recording| session.submit(recording))?;
    Ok(words(&session.read(&job.reads[0])?))
}

fn works(backend: &WgpuBackend) -> Result<()> {
    assert_eq!(run_by_hand(backend, &touch(|_| {})?)?, [1]);
    Ok(())
}

fn wrong_adapter_is_named(backend: &WgpuBackend) -> Result<()> {
    let name = "no card of this name";
    match device_error(reopen(backend, |options| options.adapter = Some(name.into()))) {
        DeviceError::NoAdapter { wanted, reason } => {
            assert_eq!(wanted.as_deref(), Some(name));
            assert!(reason.contains(&backend.adapter().name), "{reason}");
        }
        other => panic!("{other}"),
    }
    Ok(())
}

fn missing_interface_is_named(_: &WgpuBackend) -> Result<()> {
    let options = WgpuOptions { backends: Some(Backends::empty()), ..WgpuOptions::default() };
    assert_eq!(WgpuBackend::adapters(&options), []);
    assert!(matches!(device_error(WgpuBackend::new(&options)), DeviceError::NoAdapter { .. }));
    Ok(())
}

fn info_names_the_adapter(backend: &WgpuBackend) -> Result<()> {
    let name = backend.adapter().name.to_uppercase();
    let again = reopen(backend, |options| options.adapter = Some(name))?;
    let info = again.info();
    assert_eq!((info.backend, &info.adapter), ("wgpu", &backend.adapter().name));
    assert!(info.driver.starts_with(backend.adapter().backend), "{}", info.driver);
    assert!(again.adapter().chosen);
    Ok(())
}

fn workgroups_that_do_not_fit(backend: &WgpuBackend) -> Result<()> {
    for (name, value) in [("lanes", 0.0), ("lanes", -1.0), ("lanes", 257.0), ("rows", 4097.0), ("lane", 1.0)] {
        let job = touch(|dispatch| dispatch.overrides.push((name.into(), value)))?;
        refusal(run_by_hand(backend, &job));
        refusal(backend.run(&job));
    }
    works(backend)
}

fn malformed_recordings(backend: &WgpuBackend) -> Result<()> {
    let spoilt: [fn(&mut Dispatch); 7] = [
        |dispatch| dispatch.program.0 = 3,
        |dispatch| dispatch.entry = "tuch".into(),
        |dispatch| dispatch.slots.clear(),
        |dispatch| dispatch.slots[0].buffer.0 = 9,
        |dispatch| dispatch.slots[0].size = 0,
        |dispatch| dispatch.slots[0].size = 8,
        |dispatch| dispatch.groups = Groups::Direct([65536, 1, 1]),
    ];
    for change in spoilt {
        let job = touch(change)?;
        refusal(run_by_hand(backend, &job));
        refusal(backend.run(&job));
    }
    let mut job = touch(|_| {})?;
    job.reads[0].size = 8;
    refusal(run_by_hand(backend, &job));
    refusal(backend.run(&job));
    works(backend)
}

fn buffer_beyond_the_limit(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    job.buffer("huge", (256 << 20) + 4);
    assert!(refusal(backend.open(&[], &job.buffers)).contains("`huge` has 268435460 bytes"));
    works(backend)
}

fn textures_are_named(backend: &WgpuBackend) -> Result<()> {
    let text = TOUCH.replace("= 1u + memory[0]", "= textureLoad(sky, vec2<u32>(), 0).x")
        + "\n@group(0) @binding(1) var sky: texture_2d<u32>;";
    let mut job = touch(|_| {})?;
    job.programs[0] = program("sky", &text)?;
    let error = backend.run(&job).expect_err("textures are not supported");
    match error.kind() {
        ErrorKind::Unsupported { backend: "wgpu", feature, location: Some(at), .. } => {
            assert!(feature.contains("`sky`"), "{feature}");
            assert_eq!((at.file.as_str(), at.line), ("sky.wgsl", 8));
        }
        _ => panic!("{error}"),
    }
    works(backend)
}

fn uncaught_error_is_reported_once(backend: &WgpuBackend) -> Result<()> {
    let backend = reopen(backend, |_| {})?;
    let (label, size) = (Some("stray"), u64::MAX);
    let usage = wgpu::BufferUsages::STORAGE;
    drop(backend.device().create_buffer(&wgpu::BufferDescriptor { label, size, usage, mapped_at_creation: false }));
    assert!(matches!(device_error(run_by_hand(&backend, &touch(|_| {})?)), DeviceError::Validation(_)));
    works(&backend)
}

fn lost_device_stays_lost(backend: &WgpuBackend) -> Result<()> {
    let backend = reopen(backend, |_| {})?;
    let job = touch(|_| {})?;
    let mut session = backend.open(&job.programs, &job.buffers)?;
    session.submit(&job.recordings[0])?;
    backend.device().destroy();
    let bytes = vec![0; 4];
    let upload = Recording { commands: vec![Command::Upload { buffer: BufferId(0), offset: 0, bytes }] };
    assert!(matches!(device_error(session.submit(&upload)), DeviceError::Lost(_)));
    assert!(matches!(device_error(session.submit(&job.recordings[0])), DeviceError::Lost(_)));
    assert!(matches!(device_error(session.read(&job.reads[0])), DeviceError::Lost(_)));
    assert!(matches!(device_error(backend.open(&job.programs, &job.buffers)), DeviceError::Lost(_)));
    Ok(())
}

fn timeout_ends_the_wait(backend: &WgpuBackend) -> Result<()> {
    let text = "
@group(0) @binding(0) var<storage, read_write> out: array<atomic<u32>>;
@compute @workgroup_size(64)
fn grind(@builtin(global_invocation_id) id: vec3<u32>) {
    var x = id.x;
    for (var i = 0u; i < 2000u; i = i + 1u) { x = x * 1664525u + 1013904223u; x = x ^ (x / (i + 3u)); }
    atomicXor(&out[0], x);
}";
    let mut job = Job::new();
    let grind = job.program(&program("grind", text)?);
    let out = job.buffer("out", 4);
    job.dispatch(grind, "grind", &[(0, out)], [2000, 1, 1]);
    job.read("out", out);
    let slow = reopen(backend, |options| options.timeout = Duration::from_micros(100))?;
    let mut session = slow.open(&job.programs, &job.buffers)?;
    let start = Instant::now();
    let expected = DeviceError::Timeout { seconds: 1 };
    assert_eq!(device_error(session.submit(&job.recordings[0])), expected);
    assert_eq!(device_error(session.submit(&Recording::default())), expected);
    assert_eq!(device_error(session.read(&job.reads[0])), expected);
    assert_eq!(device_error(slow.open(&[], &[])), expected);
    drop(session);
    drop(slow);
    assert!(start.elapsed() < Duration::from_secs(5), "the wait took {:?}", start.elapsed());
    works(backend)
}

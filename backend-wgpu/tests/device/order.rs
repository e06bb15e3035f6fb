//! Memory: uploads, clears, copies and dispatches take effect in their order, whatever their size.

use sightlines_backend::{Backend, BufferId, Command, Job, Read, Recording, Result, Session};
use sightlines_backend_wgpu::WgpuBackend;

use crate::{Test, program, words};

pub(crate) const TESTS: &[(&str, Test)] = &[
    ("commands_take_effect_in_order", commands_take_effect_in_order),
    ("uploads_between_dispatches", uploads_between_dispatches),
    ("words_between_aligned_places", words_between_aligned_places),
    ("upload_of_several_chunks", upload_of_several_chunks),
    ("largest_buffer", largest_buffer),
    ("empty_buffers_and_transfers", empty_buffers_and_transfers),
    ("memory_lives_between_recordings", memory_lives_between_recordings),
    ("sessions_do_not_share_memory", sessions_do_not_share_memory),
    ("sessions_on_two_threads", sessions_on_two_threads),
];

/// `state[i] = 31 * state[i] + input[i]`: any change of order shows.
const MIX: &str = "
@group(0) @binding(0) var<storage, read> input: array<u32>;
@group(0) @binding(1) var<storage, read_write> state: array<u32>;
@compute @workgroup_size(64)
fn mix(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&state) { state[id.x] = state[id.x] * 31u + input[id.x]; }
}";

fn upload(buffer: BufferId, offset: u64, data: &[u32]) -> Command {
    Command::Upload { buffer, offset, bytes: bytemuck::cast_slice(data).to_vec() }
}

fn commands_take_effect_in_order(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    let mix = job.program(&program("mix", MIX)?);
    let (a, state, b) = (job.upload("a", &[1u32, 2, 3, 4]), job.buffer("state", 16), job.buffer("b", 16));
    let slots = [(0, a), (1, state)];
    job.dispatch(mix, "mix", &slots, [1, 1, 1]);
    job.record(Command::Copy { from: state, from_offset: 0, to: b, to_offset: 0, size: 16 });
    job.record(upload(a, 4, &[20, 30]));
    job.dispatch(mix, "mix", &slots, [1, 1, 1]);
    job.record(Command::Clear { buffer: a, offset: 0, size: 8 });
    job.record(Command::Copy { from: a, from_offset: 8, to: b, to_offset: 8, size: 8 });
    job.dispatch(mix, "mix", &slots, [1, 1, 1]);
    for (name, buffer) in [("a", a), ("state", state), ("b", b)] {
        job.read(name, buffer);
    }
    let outputs = backend.run(&job)?;
    assert_eq!(job.recordings.len(), 1);
    assert_eq!(words(&outputs[0]), [0, 0, 30, 4]);
    let mixed = |x: [u32; 3]| (x[0] * 31 + x[1]) * 31 + x[2];
    assert_eq!(words(&outputs[1]), [mixed([1, 1, 0]), mixed([2, 20, 0]), mixed([3, 30, 30]), mixed([4, 4, 4])]);
    assert_eq!(words(&outputs[2]), [1, 2, 30, 4]);
    Ok(())
}

fn uploads_between_dispatches(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    let mix = job.program(&program("mix", MIX)?);
    let (input, state) = (job.buffer("input", 400), job.buffer("state", 400));
    let mut expected = vec![0u32; 100];
    for round in 0..50u32 {
        let data = (0..100).map(|i| (round * 100 + i).wrapping_mul(2_654_435_761)).collect::<Vec<_>>();
        job.record(upload(input, 0, &data));
        job.dispatch(mix, "mix", &[(0, input), (1, state)], [2, 1, 1]);
        expected.iter_mut().zip(&data).for_each(|(x, d)| *x = x.wrapping_mul(31).wrapping_add(*d));
    }
    job.read("state", state);
    assert_eq!(words(&backend.run(&job)?[0]), expected);
    Ok(())
}

fn words_between_aligned_places(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    let a = job.upload("a", &(1..=9u32).collect::<Vec<_>>());
    let b = job.buffer("b", 36);
    job.record(Command::Copy { from: a, from_offset: 4, to: b, to_offset: 12, size: 20 });
    job.record(Command::Clear { buffer: b, offset: 20, size: 4 });
    job.reads.push(Read { name: "part".into(), buffer: b, offset: 4, size: 28 });
    assert_eq!(words(&backend.run(&job)?[0]), [0, 0, 2, 3, 0, 5, 6]);
    Ok(())
}

fn upload_of_several_chunks(backend: &WgpuBackend) -> Result<()> {
    let count = (80 << 20) / 4;
    let data = (0..count as u32).map(|i| i.wrapping_mul(2_654_435_761)).collect::<Vec<_>>();
    let mut job = Job::new();
    let mix = job.program(&program("mix", MIX)?);
    let input = job.upload("input", &data);
    let state = job.upload("state", &data);
    job.dispatch(mix, "mix", &[(0, input), (1, state)], [65535, 1, 1]);
    job.record(upload(input, 0, &[7]));
    job.read("state", state);
    job.read("input", input);
    let outputs = backend.run(&job)?;
    let reached = 65535 * 64;
    let expected = |i: usize| if i < reached { data[i].wrapping_mul(32) } else { data[i] };
    let state = words(&outputs[0]);
    assert_eq!(state.len(), count);
    assert_eq!((0..count).find(|&i| state[i] != expected(i)), None);
    let input = words(&outputs[1]);
    assert_eq!((input[0], input[1..] == data[1..]), (7, true));
    Ok(())
}

fn largest_buffer(backend: &WgpuBackend) -> Result<()> {
    const SIZE: u64 = 256 << 20;
    let mut job = Job::new();
    let buffer = job.buffer("large", SIZE);
    let places = [0, (32 << 20) - 4, 32 << 20, (128 << 20) + 4, SIZE - 4];
    for (index, &place) in places.iter().enumerate() {
        job.record(upload(buffer, place, &[index as u32 + 1]));
    }
    job.read("large", buffer);
    let output = words(&backend.run(&job)?[0]);
    assert_eq!(output.len() as u64, SIZE / 4);
    let found = output.iter().enumerate().filter(|(_, x)| **x != 0).map(|(i, x)| (i as u64 * 4, *x));
    assert_eq!(found.collect::<Vec<_>>(), places.into_iter().zip(1..).collect::<Vec<_>>());
    Ok(())
}

fn empty_buffers_and_transfers(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    let (empty, full) = (job.buffer("empty", 0), job.upload("full", &[5u32]));
    job.record(Command::Clear { buffer: full, offset: 0, size: 0 });
    job.record(Command::Copy { from: full, from_offset: 0, to: empty, to_offset: 0, size: 0 });
    job.record(Command::Upload { buffer: empty, offset: 0, bytes: Vec::new() });
    job.cut();
    job.read("empty", empty);
    job.read("full", full);
    assert_eq!(backend.run(&job)?, [vec![], vec![5, 0, 0, 0]]);
    Ok(())
}

fn memory_lives_between_recordings(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    let mix = job.program(&program("mix", MIX)?);
    let (input, state) = (job.upload("input", &[1u32; 64]), job.buffer("state", 256));
    for _ in 0..3 {
        job.cut();
        job.dispatch(mix, "mix", &[(0, input), (1, state)], [1, 1, 1]);
    }
    job.read("state", state);
    assert_eq!(words(&backend.run(&job)?[0]), [31 * 31 + 31 + 1; 64]);
    Ok(())
}

fn sessions_do_not_share_memory(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    let mix = job.program(&program("mix", MIX)?);
    let (input, state) = (job.buffer("input", 4), job.buffer("state", 4));
    job.dispatch(mix, "mix", &[(0, input), (1, state)], [1, 1, 1]);
    job.read("state", state);
    let mut first = backend.open(&job.programs, &job.buffers)?;
    let mut second = backend.open(&job.programs, &job.buffers)?;
    let step = |session: &mut Box<dyn Session + '_>, value: u32| {
        session.submit(&Recording { commands: vec![upload(input, 0, &[value])] })?;
        session.submit(&job.recordings[0])
    };
    step(&mut first, 1)?;
    step(&mut second, 10)?;
    step(&mut first, 2)?;
    assert_eq!(words(&first.read(&job.reads[0])?), [33]);
    assert_eq!(words(&second.read(&job.reads[0])?), [10]);
    Ok(())
}

fn sessions_on_two_threads(backend: &WgpuBackend) -> Result<()> {
    std::thread::scope(|scope| {
        let threads = [(); 2].map(|()| scope.spawn(|| (0..5).try_for_each(|_| uploads_between_dispatches(backend))));
        threads.into_iter().try_for_each(|thread| thread.join().expect("the thread fails in no other way"))
    })
}

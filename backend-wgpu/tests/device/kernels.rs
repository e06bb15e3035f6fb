//! Kernels: bindings, overrides, group counts, atomics, workgroup memory, and the guards that wgpu adds.

use std::sync::Arc;

use sightlines_backend::{Backend, BufferId, Command, Dispatch, Groups, Job, Program, ProgramId, Result, Slot};
use sightlines_backend_wgpu::WgpuBackend;

use crate::{Test, program, reopen, words};

pub(crate) const TESTS: &[(&str, Test)] = &[
    ("group_counts_from_a_buffer", group_counts_from_a_buffer),
    ("group_counts_beyond_the_limit_run_nothing", group_counts_beyond_the_limit_run_nothing),
    ("no_groups_run_nothing", no_groups_run_nothing),
    ("most_groups_in_each_dimension", most_groups_in_each_dimension),
    ("overrides_by_name_and_id", overrides_by_name_and_id),
    ("pipelines_are_compiled_once", pipelines_are_compiled_once),
    ("uniform_and_offset_slots", uniform_and_offset_slots),
    ("groups_with_a_gap", groups_with_a_gap),
    ("eight_storage_buffers", eight_storage_buffers),
    ("one_buffer_bound_in_several_places", one_buffer_bound_in_several_places),
    ("two_programs_share_a_buffer", two_programs_share_a_buffer),
    ("atomics_over_many_workgroups", atomics_over_many_workgroups),
    ("workgroup_memory_and_barriers", workgroup_memory_and_barriers),
    ("integer_division_is_guarded", integer_division_is_guarded),
    ("out_of_bounds_is_contained", out_of_bounds_is_contained),
];

const COUNT: &str = "
@group(0) @binding(0) var<storage, read_write> count: array<atomic<u32>>;
@compute @workgroup_size(1)
fn count_groups(@builtin(workgroup_id) id: vec3<u32>) {
    atomicAdd(&count[0], 1u);
    atomicMax(&count[1], id.x);
    atomicMax(&count[2], id.y);
    atomicMax(&count[3], id.z);
}";

fn run(backend: &WgpuBackend, job: &mut Job, output: BufferId) -> Result<Vec<u32>> {
    job.read("output", output);
    Ok(words(&backend.run(job)?[0]))
}

fn indirect(job: &Job, program: ProgramId, count: BufferId, groups: BufferId, offset: u64) -> Command {
    Command::Dispatch(Dispatch {
        program,
        entry: "count_groups".into(),
        overrides: Vec::new(),
        slots: vec![job.slot(0, count)],
        groups: Groups::Indirect { buffer: groups, offset },
    })
}

fn group_counts_from_a_buffer(backend: &WgpuBackend) -> Result<()> {
    let text = "
@group(0) @binding(0) var<storage, read_write> groups: array<u32>;
@compute @workgroup_size(1)
fn choose() { groups[1] = 3u; groups[2] = 2u; groups[3] = 4u; }";
    let mut job = Job::new();
    let (choose, counter) = (job.program(&program("choose", text)?), job.program(&program("count", COUNT)?));
    let (groups, count) = (job.buffer("groups", 16), job.buffer("count", 16));
    job.dispatch(choose, "choose", &[(0, groups)], [1, 1, 1]);
    job.record(indirect(&job, counter, count, groups, 4));
    assert_eq!(run(backend, &mut job, count)?, [24, 2, 1, 3]);
    Ok(())
}

fn group_counts_beyond_the_limit_run_nothing(backend: &WgpuBackend) -> Result<()> {
    for groups in [[65536, 1, 1], [1, u32::MAX, 1], [1, 1, 65536], [0, 1, 1]] {
        let mut job = Job::new();
        let counter = job.program(&program("count", COUNT)?);
        let (groups, count) = (job.upload("groups", &groups), job.buffer("count", 16));
        job.record(indirect(&job, counter, count, groups, 0));
        assert_eq!(run(backend, &mut job, count)?, [0; 4]);
    }
    Ok(())
}

fn no_groups_run_nothing(backend: &WgpuBackend) -> Result<()> {
    let mut job = Job::new();
    let counter = job.program(&program("count", COUNT)?);
    let count = job.buffer("count", 16);
    for groups in [[0, 1, 1], [1, 0, 1], [1, 1, 0], [0, 0, 0]] {
        job.dispatch(counter, "count_groups", &[(0, count)], groups);
    }
    assert_eq!(run(backend, &mut job, count)?, [0; 4]);
    Ok(())
}

fn most_groups_in_each_dimension(backend: &WgpuBackend) -> Result<()> {
    for (axis, groups) in [[65535, 1, 1], [1, 65535, 1], [1, 1, 65535]].into_iter().enumerate() {
        let mut job = Job::new();
        let counter = job.program(&program("count", COUNT)?);
        let count = job.buffer("count", 16);
        job.dispatch(counter, "count_groups", &[(0, count)], groups);
        let mut expected = [65535, 0, 0, 0];
        expected[axis + 1] = 65534;
        assert_eq!(run(backend, &mut job, count)?, expected);
    }
    Ok(())
}

const OVERRIDES: &str = "
override factor: u32 = 2u;
@id(7) override term: u32 = 100u;
override lanes: u32 = 4u;
@group(0) @binding(0) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(lanes)
fn fill(@builtin(local_invocation_index) lane: u32) { out[lane] = lane * factor + term; }";

type Overrides = &'static [(&'static str, f64)];

fn filled(job: &Job, fill: ProgramId, out: BufferId, overrides: Overrides) -> Command {
    Command::Dispatch(Dispatch {
        program: fill,
        entry: "fill".into(),
        overrides: overrides.iter().map(|&(name, value)| (name.into(), value)).collect(),
        slots: vec![job.slot(0, out)],
        groups: Groups::Direct([1, 1, 1]),
    })
}

fn overrides_by_name_and_id(backend: &WgpuBackend) -> Result<()> {
    let cases: [(Overrides, [u32; 6]); 3] = [
        (&[], [100, 102, 104, 106, 0, 0]),
        (&[("factor", 10.0), ("7", 1.0)], [1, 11, 21, 31, 0, 0]),
        (&[("lanes", 6.0), ("factor", 4_294_967_295.0)], [100, 99, 98, 97, 96, 95]),
    ];
    for (overrides, expected) in cases {
        let mut job = Job::new();
        let fill = job.program(&program("fill", OVERRIDES)?);
        let out = job.buffer("out", 24);
        job.record(filled(&job, fill, out, overrides));
        assert_eq!(run(backend, &mut job, out)?, expected);
    }
    Ok(())
}

fn pipelines_are_compiled_once(backend: &WgpuBackend) -> Result<()> {
    let backend = reopen(backend, |_| {})?;
    let mut job = Job::new();
    let fill = job.program(&program("fill", OVERRIDES)?);
    let out = job.buffer("out", 24);
    let sets: [Overrides; 4] =
        [&[("factor", 3.0), ("7", 5.0)], &[("7", 5.0), ("factor", 3.0)], &[("factor", 3.0)], &[("factor", 3.0)]];
    for overrides in sets {
        job.record(filled(&job, fill, out, overrides));
    }
    assert_eq!(backend.compiled_pipelines(), 0);
    for _ in 0..3 {
        backend.run(&job)?;
        assert_eq!(backend.compiled_pipelines(), 2);
    }
    Ok(())
}

fn uniform_and_offset_slots(backend: &WgpuBackend) -> Result<()> {
    let text = "
struct Params { scale: u32, shift: u32, pad: vec2<u32> }
@group(0) @binding(3) var<uniform> params: Params;
@group(0) @binding(5) var<storage, read> input: array<u32>;
@group(0) @binding(9) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(8)
fn scale(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&out) { out[id.x] = input[id.x] * params.scale + params.shift + arrayLength(&input); }
}";
    let mut job = Job::new();
    let scale = job.program(&program("scale", text)?);
    let mut params = vec![0u32; 68];
    params[64..66].copy_from_slice(&[10, 7]);
    let (params, input) = (job.upload("params", &params), job.upload("input", &(0..128u32).collect::<Vec<_>>()));
    let out = job.buffer("out", 512);
    let slot = |binding, buffer, offset, size| Slot { group: 0, binding, buffer, offset, size };
    let slots = vec![slot(9, out, 256, 8), slot(3, params, 256, 16), slot(5, input, 256, 12)];
    let (entry, groups) = ("scale".into(), Groups::Direct([1, 1, 1]));
    job.record(Command::Dispatch(Dispatch { program: scale, entry, overrides: Vec::new(), slots, groups }));
    let mut expected = [0; 128];
    expected[64..66].copy_from_slice(&[640 + 7 + 3, 650 + 7 + 3]);
    assert_eq!(run(backend, &mut job, out)?, expected);
    Ok(())
}

fn groups_with_a_gap(backend: &WgpuBackend) -> Result<()> {
    let text = "
@group(1) @binding(2) var<storage, read> input: array<u32>;
@group(2) @binding(0) var<storage, read> unused: array<u32>;
@group(3) @binding(1) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(1)
fn copy() { out[0] = input[0] + 1u; }
@compute @workgroup_size(1)
fn other() { out[0] = unused[0]; }";
    let mut job = Job::new();
    let copy = job.program(&program("gap", text)?);
    let (input, out) = (job.upload("input", &[41u32]), job.buffer("out", 4));
    let slots = vec![Slot { group: 3, ..job.slot(1, out) }, Slot { group: 1, ..job.slot(2, input) }];
    let (entry, groups) = ("copy".into(), Groups::Direct([1, 1, 1]));
    job.record(Command::Dispatch(Dispatch { program: copy, entry, overrides: Vec::new(), slots, groups }));
    assert_eq!(run(backend, &mut job, out)?, [42]);
    Ok(())
}

fn eight_storage_buffers(backend: &WgpuBackend) -> Result<()> {
    let mut text = String::new();
    for i in 0..7 {
        text += &format!("@group(0) @binding({i}) var<storage, read> in{i}: array<u32>;\n");
    }
    let sum = (0..7).map(|i| format!("in{i}[0]")).collect::<Vec<_>>().join(" + ");
    text += "@group(0) @binding(7) var<storage, read_write> out: array<u32>;\n";
    text += &format!("@compute @workgroup_size(256) fn add() {{ out[0] = {sum}; }}");
    let mut job = Job::new();
    let add = job.program(&program("add", &text)?);
    let mut slots = (0..7).map(|i| (i, job.upload(format!("in{i}"), &[10u32.pow(i)]))).collect::<Vec<_>>();
    let out = job.buffer("out", 4);
    slots.push((7, out));
    job.dispatch(add, "add", &slots, [1, 1, 1]);
    assert_eq!(run(backend, &mut job, out)?, [1_111_111]);
    Ok(())
}

/// What the contract's check lets share a buffer: written ranges apart, and any number of readers.
fn one_buffer_bound_in_several_places(backend: &WgpuBackend) -> Result<()> {
    let text = "
@group(0) @binding(0) var<uniform> scale: vec4<u32>;
@group(0) @binding(1) var<storage, read> input: array<u32>;
@group(0) @binding(2) var<storage, read_write> low: array<u32>;
@group(1) @binding(0) var<storage, read_write> high: array<u32>;
@compute @workgroup_size(1)
fn spread(@builtin(workgroup_id) id: vec3<u32>) {
    low[id.x] = input[id.x] * scale.x;
    high[id.x] = input[id.x] + scale.y;
}";
    let mut job = Job::new();
    let spread = job.program(&program("spread", text)?);
    let (input, out) = (job.upload("input", &[3u32, 1, 1, 9]), job.buffer("out", 1024));
    let part = |group, binding, offset| Slot { group, binding, buffer: out, offset, size: 256 };
    let slots = vec![job.slot(0, input), job.slot(1, input), part(0, 2, 0), part(1, 0, 512)];
    let (entry, groups) = ("spread".into(), Groups::Indirect { buffer: input, offset: 0 });
    job.record(Command::Dispatch(Dispatch { program: spread, entry, overrides: Vec::new(), slots, groups }));
    let mut expected = [0; 256];
    expected[..3].copy_from_slice(&[9, 3, 3]);
    expected[128..131].copy_from_slice(&[4, 2, 2]);
    assert_eq!(run(backend, &mut job, out)?, expected);
    Ok(())
}

fn two_programs_share_a_buffer(backend: &WgpuBackend) -> Result<()> {
    let step = |label: &str, body: &str| -> Result<Arc<Program>> {
        let head = "@group(0) @binding(0) var<storage, read_write> x: array<u32>;
@compute @workgroup_size(64) fn step(@builtin(global_invocation_id) id: vec3<u32>)";
        program(label, &format!("{head} {{ let i = id.x; {body} }}"))
    };
    let mut job = Job::new();
    let double = job.program(&step("double", "x[i] = x[i] * 2u;")?);
    let add = job.program(&step("add", "x[i] = x[i] + 1u;")?);
    let x = job.upload("x", &(0..128u32).collect::<Vec<_>>());
    for program in [double, add, add, double, add] {
        job.dispatch(program, "step", &[(0, x)], [2, 1, 1]);
    }
    assert_eq!(run(backend, &mut job, x)?, (0..128).map(|i| (i * 2 + 2) * 2 + 1).collect::<Vec<_>>());
    Ok(())
}

fn atomics_over_many_workgroups(backend: &WgpuBackend) -> Result<()> {
    let text = "
@group(0) @binding(0) var<storage, read_write> a: array<atomic<u32>, 6>;
@group(0) @binding(1) var<storage, read_write> s: array<atomic<i32>, 2>;
@compute @workgroup_size(256)
fn gather(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x;
    atomicAdd(&a[0], i);
    atomicMax(&a[1], i ^ 0x155u);
    atomicMin(&a[2], i + 9u);
    atomicOr(&a[3], 1u << (i & 31u));
    atomicXor(&a[4], i * 2654435761u);
    atomicAnd(&a[5], ~(i << 8u));
    atomicMin(&s[0], 500 - i32(i));
    atomicSub(&s[1], i32(i & 3u));
}";
    let mut job = Job::new();
    let gather = job.program(&program("gather", text)?);
    let (a, s) = (job.upload("a", &[0, 0, u32::MAX, 0, 0, u32::MAX]), job.upload("s", &[0i32, 7]));
    job.dispatch(gather, "gather", &[(0, a), (1, s)], [100, 1, 1]);
    job.read("a", a);
    job.read("s", s);
    let outputs = backend.run(&job)?;
    let all = 0..25_600u32;
    let expected = [
        all.clone().sum(),
        all.clone().map(|i| i ^ 0x155).max().unwrap_or(0),
        9,
        u32::MAX,
        all.clone().fold(0, |x, i| x ^ i.wrapping_mul(2_654_435_761)),
        all.clone().fold(u32::MAX, |x, i| x & !(i << 8)),
    ];
    assert_eq!(words(&outputs[0]), expected);
    assert_eq!(words(&outputs[1]), [(500 - 25_599i32) as u32, (7 - 25_600 / 4 * 6i32) as u32]);
    Ok(())
}

fn workgroup_memory_and_barriers(backend: &WgpuBackend) -> Result<()> {
    let text = "
var<workgroup> rows: array<u32, 4096>;
@group(0) @binding(0) var<storage, read_write> x: array<u32>;
@compute @workgroup_size(256)
fn scan(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    x[id.x] = x[id.x] + rows[lane + 3840u];
    rows[lane] = x[id.x];
    workgroupBarrier();
    for (var step = 1u; step < 256u; step = step << 1u) {
        var sum = rows[lane];
        if lane >= step { sum = sum + rows[lane - step]; }
        workgroupBarrier();
        rows[lane] = sum;
        workgroupBarrier();
    }
    x[id.x] = rows[lane];
    rows[lane + 3840u] = 0xffffffffu;
}";
    let data = (0..2048u32).map(|i| i * i).collect::<Vec<_>>();
    let mut job = Job::new();
    let scan = job.program(&program("scan", text)?);
    let x = job.upload("x", &data);
    job.dispatch(scan, "scan", &[(0, x)], [8, 1, 1]);
    let sums = |block: &[u32]| {
        block
            .iter()
            .scan(0u32, |sum, x| {
                Some({
                    *sum += x;
                    *sum
                })
            })
            .collect::<Vec<_>>()
    };
    assert_eq!(run(backend, &mut job, x)?, data.chunks(256).flat_map(sums).collect::<Vec<_>>());
    Ok(())
}

fn integer_division_is_guarded(backend: &WgpuBackend) -> Result<()> {
    let text = "
@group(0) @binding(0) var<storage, read> v: array<i32, 4>;
@group(0) @binding(1) var<storage, read_write> out: array<i32, 6>;
@compute @workgroup_size(1)
fn divide() {
    out[0] = v[0] / v[1];
    out[1] = v[0] % v[1];
    out[2] = v[2] / v[3];
    out[3] = v[2] % v[3];
    out[4] = i32(u32(v[0]) / u32(v[1]));
    out[5] = v[0] % v[3];
}";
    let mut job = Job::new();
    let divide = job.program(&program("divide", text)?);
    let (v, out) = (job.upload("v", &[17, 0, i32::MIN, -1]), job.buffer("out", 24));
    job.dispatch(divide, "divide", &[(0, v), (1, out)], [1, 1, 1]);
    assert_eq!(run(backend, &mut job, out)?, [17, 0, i32::MIN as u32, 0, 17, 0]);
    Ok(())
}

fn out_of_bounds_is_contained(backend: &WgpuBackend) -> Result<()> {
    let text = "
@group(0) @binding(0) var<storage, read> at: array<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(1)
fn stray() { out[at[0]] = 1u; out[0] = out[at[1]] + at[at[2]]; }";
    let mut job = Job::new();
    let stray = job.program(&program("stray", text)?);
    let beside = job.upload("beside", &[3u32; 256]);
    let (at, out) = (job.upload("at", &[1_000_000, u32::MAX, 77_777]), job.buffer("out", 1024));
    let slots = vec![job.slot(0, at), Slot { size: 8, ..job.slot(1, out) }];
    let (entry, groups) = ("stray".into(), Groups::Direct([1, 1, 1]));
    job.record(Command::Dispatch(Dispatch { program: stray, entry, overrides: Vec::new(), slots, groups }));
    job.read("beside", beside);
    job.read("at", at);
    let outputs = backend.run(&job)?;
    assert_eq!(words(&outputs[0]), [3; 256]);
    assert_eq!(words(&outputs[1]), [1_000_000, u32::MAX, 77_777]);
    Ok(())
}

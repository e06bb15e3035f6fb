//! One test for each rule by which a device would refuse work: the refusal carries the numbers and the remedy.

use std::sync::Arc;

use sightlines_backend::{
    BufferDesc, BufferId, Command, Dispatch, ErrorKind, Groups, Job, Linked, Program, ProgramId, Read, Recording, Slot,
    check,
};

const WGSL: &str = "
override side: u32 = 64;
override cells: u32 = 16;
struct Params { count: u32, more: vec4<u32> }
@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> input: array<u32>;
@group(1) @binding(2) var<storage, read_write> output: array<u32>;
@group(0) @binding(3) var<storage, read_write> other: array<u32>;
var<workgroup> shared_cells: array<u32, cells>;
@compute @workgroup_size(side) fn main() { output[0] = input[0] + params.count; }
@compute @workgroup_size(1) fn two() { output[0] = 1u; other[0] = 2u; }
@compute @workgroup_size(1) fn memory() { shared_cells[0] = 1u; output[0] = shared_cells[1]; }
@compute @workgroup_size(8, 4, 65) fn deep() { output[0] = 1u; }
@compute @workgroup_size(16, 16, 2) fn many() { output[0] = 1u; }
@compute @workgroup_size(1) fn nothing() { }
";

const PARAMS: BufferId = BufferId(0);
const INPUT: BufferId = BufferId(1);
const OUTPUT: BufferId = BufferId(2);

fn program(wgsl: &str) -> Arc<Program> {
    Program::unlinted("rules", Linked::single("rules.wgsl", wgsl).expect("links")).unwrap_or_else(|e| panic!("{e}"))
}

fn slot(group: u32, binding: u32, buffer: BufferId, offset: u64, size: u64) -> Slot {
    Slot { group, binding, buffer, offset, size }
}

/// A job that passes: parameters, 4 KiB of input, 4 KiB of output, and one dispatch of `main`.
fn job() -> Job {
    let mut job = Job::new();
    let id = job.program(&program(WGSL));
    let [params, input, output] = [("params", 32), ("input", 4096), ("output", 4096)].map(|(l, n)| job.buffer(l, n));
    assert_eq!((params, input, output), (PARAMS, INPUT, OUTPUT));
    let slots = vec![slot(0, 0, PARAMS, 0, 32), slot(0, 1, INPUT, 0, 4096), slot(1, 2, OUTPUT, 0, 4096)];
    job.record(Command::Dispatch(Dispatch {
        program: id,
        entry: "main".into(),
        overrides: Vec::new(),
        slots,
        groups: Groups::Direct([1, 1, 1]),
    }));
    job.read("output", OUTPUT);
    job
}

fn dispatch(job: &mut Job) -> &mut Dispatch {
    match &mut job.recordings[0].commands[0] {
        Command::Dispatch(dispatch) => dispatch,
        other => panic!("{other:?}"),
    }
}

/// Changes the passing job, and returns the refusal.
fn refused(change: impl FnOnce(&mut Job)) -> String {
    let mut job = job();
    change(&mut job);
    let error = check::job(&job).expect_err("must be refused");
    match error.kind() {
        ErrorKind::Refused { remedy, .. } => assert!(!remedy.is_empty()),
        other => panic!("{other:?}"),
    }
    error.to_string()
}

/// The passing job with its dispatch changed.
fn refused_dispatch(change: impl FnOnce(&mut Dispatch)) -> String {
    refused(|job| change(dispatch(job)))
}

/// The passing job with another command.
fn refused_command(command: Command) -> String {
    refused(|job| job.record(command))
}

/// A dispatch of another entry point with `output` bound.
fn entry(dispatch: &mut Dispatch, name: &str) {
    dispatch.entry = name.into();
    dispatch.slots = vec![slot(1, 2, OUTPUT, 0, 4096)];
}

#[track_caller]
fn says(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "`{part}` is not in\n{text}");
    }
}

#[test]
fn what_fits_passes() {
    check::job(&job()).unwrap_or_else(|e| panic!("{e}"));
    let mut job = job();
    dispatch(&mut job).overrides = vec![("side".into(), 256.0)];
    dispatch(&mut job).groups = Groups::Direct([65_535, 0, 65_535]);
    job.record(Command::Copy { from: INPUT, from_offset: 4, to: OUTPUT, to_offset: 8, size: 4088 });
    job.record(Command::Clear { buffer: OUTPUT, offset: 0, size: 0 });
    check::job(&job).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn a_refusal_names_recording_command_and_entry_point() {
    let text = refused_dispatch(|d| d.groups = Groups::Direct([1, 65_536, 1]));
    let expected = "refused: recording 0, command 0 (dispatch) of `main` in `rules`: 65536 workgroups in y, the limit \
                    is 65535\n  remedy: spread the workgroups over x and y, or over several dispatches";
    assert_eq!(text, expected);
}

#[test]
fn buffers_are_whole_words() {
    let desc = BufferDesc { label: "odd".into(), size: 6 };
    says(&refused(|job| job.buffers.push(desc)), &["buffer 3 `odd` has 6 bytes, not a multiple of 4"]);
}

#[test]
fn buffers_are_at_most_256_mib() {
    let desc = BufferDesc { label: "big".into(), size: (256 << 20) + 4 };
    says(&refused(|job| job.buffers.push(desc)), &["268435460 bytes, the limit is 268435456"]);
}

#[test]
fn ids_exist() {
    says(&refused_dispatch(|d| d.program = ProgramId(7)), &["program id 7 does not exist, there are 1"]);
    says(&refused_dispatch(|d| d.slots[1].buffer = BufferId(9)), &["buffer id 9 does not exist, there are 3 buffers"]);
    says(&refused_command(Command::Clear { buffer: BufferId(3), offset: 0, size: 4 }), &["buffer id 3 does not exist"]);
    let read = Read { name: "r".into(), buffer: BufferId(4), offset: 0, size: 4 };
    says(&refused(|job| job.reads.push(read)), &["read `r`: buffer id 4 does not exist"]);
}

#[test]
fn entry_points_exist() {
    says(
        &refused_dispatch(|d| d.entry = "maim".into()),
        &["no such entry point", "use one of `main`, `two`, `memory`"],
    );
}

#[test]
fn overrides_exist_and_fit_their_type() {
    let set = |name: &str, value: f64| refused_dispatch(|d| d.overrides = vec![(name.into(), value)]);
    says(&set("width", 1.0), &["override values", "'width' not found"]);
    says(&set("side", f64::NAN), &["finite"]);
    says(&set("side", -1.0), &["doesn't fit"]);
    let needed = "override n: u32; @group(0) @binding(0) var<storage, read_write> o: array<u32>;
        @compute @workgroup_size(1) fn main() { o[0] = n; }";
    let text = refused(|job| {
        job.programs[0] = program(needed);
        dispatch(job).slots = vec![slot(0, 0, OUTPUT, 0, 4096)];
    });
    says(&text, &["Missing value for pipeline-overridable constant with identifier string: 'n'"]);
}

#[test]
fn workgroups_have_at_most_256_invocations() {
    says(&refused_dispatch(|d| entry(d, "many")), &["a workgroup of 16 x 16 x 2 = 512 invocations", "256 in all"]);
    says(&refused_dispatch(|d| entry(d, "deep")), &["8 x 4 x 65", "256 x 256 x 64"]);
    let text = refused_dispatch(|d| d.overrides = vec![("side".into(), 257.0)]);
    says(&text, &["a workgroup of 257 x 1 x 1 = 257 invocations"]);
    says(&refused_dispatch(|d| d.overrides = vec![("side".into(), 0.0)]), &["workgroup_size override"]);
}

#[test]
fn workgroup_memory_is_at_most_16_kib() {
    let cells = |n: f64| {
        let mut job = job();
        entry(dispatch(&mut job), "memory");
        dispatch(&mut job).overrides = vec![("cells".into(), n)];
        check::job(&job)
    };
    assert!(cells(4096.0).is_ok());
    let text = cells(4097.0).expect_err("too much").to_string();
    says(&text, &["16400 bytes of workgroup memory, the limit is 16384"]);
}

#[test]
fn at_most_8_storage_and_12_uniform_buffers() {
    let uses = |count: u32, space: &str, ty: &str, value: &str| {
        let globals = (0..count).map(|i| format!("@group(0) @binding({i}) var<{space}> b{i}: {ty};\n"));
        let sum = (0..count).map(|i| format!("b{i}{value}")).collect::<Vec<_>>().join(" + ");
        let body = format!("@compute @workgroup_size(1) fn main() {{ let x = {sum}; if x == 1u {{ return; }} }}");
        program(&(globals.collect::<String>() + &body))
    };
    let run = |program: Arc<Program>, size: u64| {
        let mut job = Job::new();
        let id = job.program(&program);
        let buffers: Vec<_> = program.bindings().iter().map(|b| (b.binding, job.buffer("b", size))).collect();
        job.dispatch(id, "main", &buffers, [1, 1, 1]);
        check::job(&job).map_err(|e| e.to_string())
    };
    assert_eq!(run(uses(8, "storage, read", "array<u32>", "[0]"), 4), Ok(()));
    assert_eq!(run(uses(12, "uniform", "vec4<u32>", ".x"), 16), Ok(()));
    let storage = run(uses(9, "storage, read", "array<u32>", "[0]"), 4).expect_err("nine");
    says(&storage, &["uses 9 storage buffers, the limit is 8"]);
    let uniform = run(uses(13, "uniform", "vec4<u32>", ".x"), 16).expect_err("thirteen");
    says(&uniform, &["uses 13 uniform buffers, the limit is 12"]);
}

#[test]
fn groups_and_bindings_have_limits() {
    for (group, binding) in [(4, 0), (0, 1000)] {
        let wgsl = format!(
            "@group({group}) @binding({binding}) var<storage, read_write> o: array<u32>;
            @compute @workgroup_size(1) fn main() {{ o[0] = 1u; }}"
        );
        let text = refused(|job| {
            job.programs[0] = program(&wgsl);
            dispatch(job).slots = vec![slot(group, binding, OUTPUT, 0, 4096)];
        });
        says(&text, &[&format!("`o` is at group {group} binding {binding}, the limits are 3 and 999")]);
    }
}

#[test]
fn every_binding_is_bound_once_and_no_others() {
    says(&refused_dispatch(|d| d.slots.truncate(1)), &["group 0 binding 1 (`input`) is not bound"]);
    says(&refused_dispatch(|d| d.slots.push(d.slots[1].clone())), &["group 0 binding 1 (`input`) is bound twice"]);
    let stranger = slot(0, 3, INPUT, 0, 4096);
    says(&refused_dispatch(|d| d.slots.push(stranger)), &["group 0 binding 3: the entry point does not use it"]);
}

#[test]
fn bindings_hold_their_type_and_are_not_empty() {
    says(&refused_dispatch(|d| d.slots[0].size = 16), &["(`params`): binds 16 bytes, the type needs 32"]);
    says(&refused_dispatch(|d| d.slots[1].size = 0), &["(`input`): binds no bytes", "at least one element"]);
}

#[test]
fn bindings_begin_at_multiples_of_256() {
    let text = refused_dispatch(|d| (d.slots[1].offset, d.slots[1].size) = (128, 256));
    says(&text, &["offset 128 in `input` is not a multiple of 256"]);
}

#[test]
fn bindings_have_largest_sizes() {
    let text = refused(|job| {
        job.buffers[1].size = 256 << 20;
        dispatch(job).slots[1].size = (128 << 20) + 4;
    });
    says(&text, &["binds 134217732 bytes, the limit of a storage binding is 134217728"]);
    let text = refused(|job| {
        job.buffers[0].size = 1 << 20;
        dispatch(job).slots[0].size = (64 << 10) + 16;
    });
    says(&text, &["binds 65552 bytes, the limit of a uniform binding is 65536"]);
}

#[test]
fn ranges_lie_in_their_buffer() {
    says(&refused_dispatch(|d| d.slots[1].offset = 256), &["bytes 256..4352 of `input`, which has 4096"]);
    let bytes = vec![0; 8];
    says(&refused_command(Command::Upload { buffer: PARAMS, offset: 28, bytes }), &["bytes 28..36 of `params`"]);
    says(
        &refused_command(Command::Clear { buffer: OUTPUT, offset: 0, size: 4100 }),
        &["command 1 (clear): bytes 0..4100"],
    );
    let copy = Command::Copy { from: INPUT, from_offset: 4092, to: OUTPUT, to_offset: 0, size: 8 };
    says(&refused_command(copy), &["bytes 4092..4100 of `input`"]);
    let copy = Command::Copy { from: INPUT, from_offset: 0, to: OUTPUT, to_offset: 4092, size: 8 };
    says(&refused_command(copy), &["bytes 4092..4100 of `output`"]);
    says(&refused(|job| job.reads[0].offset = 4), &["read `output`: bytes 4..4100 of `output`"]);
}

#[test]
fn ranges_do_not_overflow() {
    let clear = Command::Clear { buffer: OUTPUT, offset: u64::MAX - 3, size: 8 };
    says(&refused_command(clear), &["18446744073709551612 + 8 bytes in `output` overflow 64 bits"]);
    let text = refused_dispatch(|d| d.slots[1].offset = u64::MAX - 255);
    says(&text, &["18446744073709551360 + 4096 bytes in `input` overflow 64 bits"]);
}

#[test]
fn commands_work_in_whole_words() {
    says(&refused_command(Command::Clear { buffer: OUTPUT, offset: 2, size: 4 }), &["offset 2 in `output`"]);
    says(&refused_command(Command::Clear { buffer: OUTPUT, offset: 0, size: 5 }), &["size 5 in `output`"]);
    says(&refused_command(Command::Upload { buffer: OUTPUT, offset: 0, bytes: vec![1, 2, 3] }), &["size 3"]);
    let copy = Command::Copy { from: INPUT, from_offset: 0, to: OUTPUT, to_offset: 1, size: 4 };
    says(&refused_command(copy), &["offset 1 in `output` is not a multiple of 4"]);
    says(&refused(|job| job.reads[0].size = 7), &["read `output`: size 7"]);
    says(&refused_dispatch(|d| d.slots[1].size = 7), &["size 7 in `input`"]);
}

#[test]
fn copies_need_two_buffers() {
    let copy = Command::Copy { from: INPUT, from_offset: 0, to: INPUT, to_offset: 2048, size: 1024 };
    says(&refused_command(copy), &["copies within one buffer, `input`", "by way of another buffer"]);
}

#[test]
fn a_written_buffer_is_not_read_in_the_same_dispatch() {
    let text = refused_dispatch(|d| {
        d.slots[1] = slot(0, 1, OUTPUT, 0, 256);
        d.slots[2] = slot(1, 2, OUTPUT, 256, 256);
    });
    says(&text, &["buffer 2 is bound to `input` and `output`, one of which writes"]);
}

#[test]
fn written_ranges_do_not_overlap() {
    let two = |offset: u64| {
        let mut job = job();
        dispatch(&mut job).entry = "two".into();
        dispatch(&mut job).slots = vec![slot(1, 2, OUTPUT, 0, 512), slot(0, 3, OUTPUT, offset, 512)];
        check::job(&job).map_err(|e| e.to_string())
    };
    assert_eq!(two(512), Ok(()));
    says(&two(256).expect_err("overlap"), &["bound to `output` and `other`, both write bytes 256..512"]);
}

#[test]
fn indirect_workgroups_lie_in_a_buffer_that_is_not_written() {
    let indirect = |buffer, offset| Groups::Indirect { buffer, offset };
    let mut job = job();
    dispatch(&mut job).groups = indirect(INPUT, 4084);
    check::job(&job).unwrap_or_else(|e| panic!("{e}"));
    says(&refused_dispatch(|d| d.groups = indirect(INPUT, 4088)), &["bytes 4088..4100 of `input`"]);
    says(&refused_dispatch(|d| d.groups = indirect(INPUT, 2)), &["offset 2 in `input`"]);
    says(&refused_dispatch(|d| d.groups = indirect(OUTPUT, 0)), &["holds the workgroups and is written as `output`"]);
}

#[test]
fn indirect_counts_past_the_limit_run_nothing() {
    assert_eq!(check::indirect_groups([65_535, 1, 0]), [65_535, 1, 0]);
    assert_eq!(check::indirect_groups([65_536, 1, 1]), [0, 0, 0]);
    assert_eq!(check::indirect_groups([1, 1, u32::MAX]), [0, 0, 0]);
}

#[test]
fn a_recording_of_a_session_is_checked_alone() {
    let job = job();
    check::recording(&job.buffers, &job.programs, &job.recordings[0]).unwrap_or_else(|e| panic!("{e}"));
    let recording = Recording { commands: vec![Command::Clear { buffer: BufferId(8), offset: 0, size: 4 }] };
    let error = check::recording(&job.buffers, &job.programs, &recording).expect_err("no such buffer");
    says(&error.to_string(), &["refused: command 0 (clear): buffer id 8"]);
    let buffers = [BufferDesc { label: "b".into(), size: 2 }];
    says(&check::buffers(&buffers).expect_err("odd").to_string(), &["buffer 0 `b` has 2 bytes"]);
}

#[test]
fn an_entry_point_without_bindings_binds_nothing() {
    let mut job = job();
    dispatch(&mut job).entry = "nothing".into();
    dispatch(&mut job).slots.clear();
    check::job(&job).unwrap_or_else(|e| panic!("{e}"));
}

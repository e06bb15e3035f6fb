//! The job file: what is written is read back, and no bytes whatever give a panic, a hang or a job that breaks rules.

use std::sync::Arc;

use proptest::prelude::*;
use sightlines_backend::{Command, Define, Dispatch, ErrorKind, Groups, Job, Program, Read, Slot};

const MAGIC: &[u8] = b"sightlines job 1\n";

const WGSL: &str = "import package::shared::words::FACTOR;
override side: u32 = 64;
@group(0) @binding(0) var<storage, read> input: array<u32>;
@group(0) @binding(1) var<storage, read_write> output: array<u32>;
@compute @workgroup_size(side) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    output[id.x] = input[id.x] * FACTOR;
}
";

fn program(lint: bool) -> Arc<Program> {
    let sources = |path: &str| match path {
        "main.wgsl" => Some(WGSL.to_owned()),
        "shared/words.wgsl" => Some("const FACTOR = 3u;\n".to_owned()),
        _ => None,
    };
    let defines = [Define::new("FACTOR", "5u")];
    if lint {
        return Program::new("factor", "main.wgsl", &sources, &defines).unwrap_or_else(|e| panic!("{e}"));
    }
    let linked = sightlines_backend::Linked::link("main.wgsl", &sources, &defines).expect("links");
    Program::unlinted("factor", linked).unwrap_or_else(|e| panic!("{e}"))
}

/// A job with every kind of command.
fn job() -> Job {
    let mut job = Job::new();
    let program = job.program(&program(true));
    let input = job.upload("input", &(0..64).collect::<Vec<u32>>());
    let output = job.buffer("output", 256);
    let groups = job.upload("groups", &[1_u32, 1, 1]);
    job.dispatch(program, "main", &[(0, input), (1, output)], [1, 1, 1]);
    job.cut();
    job.record(Command::Copy { from: output, from_offset: 4, to: input, to_offset: 0, size: 252 });
    job.record(Command::Clear { buffer: output, offset: 8, size: 16 });
    let slot = |binding, buffer| Slot { group: 0, binding, buffer, offset: 0, size: 256 };
    job.record(Command::Dispatch(Dispatch {
        program,
        entry: "main".into(),
        overrides: vec![("side".into(), 32.0)],
        slots: vec![slot(0, input), slot(1, output)],
        groups: Groups::Indirect { buffer: groups, offset: 0 },
    }));
    job.read("all", output);
    job.reads.push(Read { name: "some".into(), buffer: output, offset: 128, size: 64 });
    job
}

#[test]
fn a_job_survives_its_file() {
    let before = job();
    let bytes = before.to_bytes();
    assert!(bytes.starts_with(MAGIC));
    let after = Job::from_bytes(&bytes).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(after.buffers, before.buffers);
    assert_eq!(after.recordings, before.recordings);
    assert_eq!(after.reads, before.reads);
    let (a, b) = (&after.programs[0], &before.programs[0]);
    assert_eq!((a.label(), a.id(), a.linked()), (b.label(), b.id(), b.linked()));
    assert_eq!((a.bindings(), a.entries()), (b.bindings(), b.entries()));
    assert_eq!(after.to_bytes(), bytes, "writing is a function of the job");
}

#[test]
fn places_survive_the_file() {
    let after = Job::from_bytes(&job().to_bytes()).unwrap_or_else(|e| panic!("{e}"));
    let module = after.programs[0].module();
    let (handle, _) =
        module.global_variables.iter().find(|(_, g)| g.name.as_deref() == Some("output")).expect("output");
    let at = after.programs[0].locate(module.global_variables.get_span(handle)).expect("a place");
    assert_eq!((at.file.as_str(), at.line), ("main.wgsl", 4));
}

#[test]
fn uploads_are_compact() {
    let mut job = Job::new();
    let data: Vec<u32> = (0..16 << 18).collect();
    job.upload("words", &data);
    let bytes = job.to_bytes();
    assert!(bytes.len() < data.len() * 4 + 200, "{} bytes for {}", bytes.len(), data.len() * 4);
    let after = Job::from_bytes(&bytes).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(after.recordings, job.recordings);
}

#[track_caller]
fn refused(bytes: &[u8]) -> String {
    let error = Job::from_bytes(bytes).map(|_| ()).expect_err("must be refused");
    assert!(matches!(error.kind(), ErrorKind::Format(_) | ErrorKind::Refused { .. }), "{error:?}");
    error.to_string()
}

#[test]
fn other_files_are_refused() {
    assert!(refused(b"").contains("magic"));
    assert!(refused(b"sightlines job 2\n").contains("magic"));
    assert!(refused(MAGIC).starts_with("not a job file of this version"));
    let mut longer = job().to_bytes();
    longer.push(0);
    assert!(refused(&longer).contains("1 bytes follow the job"));
}

#[test]
fn every_truncation_is_refused() {
    let bytes = job().to_bytes();
    for length in 0..bytes.len() {
        refused(&bytes[..length]);
    }
}

#[test]
fn claims_of_endless_data_are_refused_without_allocating() {
    // A map, an array, a byte string and a text whose headers each promise 2^60 entries.
    for header in [0xbb, 0x9b, 0x5b, 0x7b] {
        let mut bytes = [MAGIC, &[header], &(1_u64 << 60).to_be_bytes()].concat();
        bytes.extend([0; 32]);
        refused(&bytes);
    }
    let nested = [MAGIC, &[0x81; 100_000]].concat();
    refused(&nested);
}

#[test]
fn programs_in_a_file_are_compiled_under_the_same_rules() {
    let text = |from: &[u8], to: &[u8]| {
        let bytes = job().to_bytes();
        let at = bytes.windows(from.len()).position(|w| w == from).expect("the text is in the file");
        let mut changed = bytes.clone();
        changed[at..at + from.len()].copy_from_slice(to);
        refused(&changed)
    };
    assert!(text(b"input[id.x] * FACTOR", b"input[id.x] * factor").contains("main.wgsl:6:"));
    assert!(text(b"= input[id.x] * FACT", b"= u32(1.5 * f32(FACT").contains("error"));
    assert!(text(b"array<u32>", b"array<f32>").contains("error"));
    let unlinted = {
        let mut job = Job::new();
        job.program(&program(false));
        Job::from_bytes(&job.to_bytes()).unwrap_or_else(|e| panic!("{e}"))
    };
    assert_eq!(unlinted.programs[0].label(), "factor");
}

#[test]
fn a_job_that_breaks_a_rule_is_refused() {
    let mut job = job();
    job.reads[0].size = 512;
    assert!(refused(&job.to_bytes()).contains("read `all`: bytes 0..512 of `output`, which has 256"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// Any few bytes changed, removed or inserted give a job or a typed error.
    #[test]
    fn mutated_bytes_never_panic(edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..3_u8), 1..6)) {
        let mut bytes = job().to_bytes();
        for (index, byte, kind) in edits {
            let at = index.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => drop(bytes.drain(at..at + 1)),
                _ => bytes.insert(at, byte),
            }
        }
        if let Err(error) = Job::from_bytes(&bytes) {
            let typed = matches!(error.kind(), ErrorKind::Format(_) | ErrorKind::Refused { .. });
            prop_assert!(typed, "{error:?}");
        }
    }

    /// Bytes after the magic line that are nothing in particular.
    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let whole = [MAGIC, &bytes].concat();
        prop_assert!(Job::from_bytes(&whole).is_err());
    }
}

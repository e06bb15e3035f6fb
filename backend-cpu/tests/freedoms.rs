//! What the interpreter does where WGSL leaves a choice that other machines take differently: order, races, traps.
//!
//! Choices that show on one value have their lines in `tests/ops`; docs/wgsl-support.md lists all of them.

use sightlines_backend::{Backend, Command, ErrorKind, Job, Linked, Program, Read, Session};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend, Simd};

/// The buffer `data` of words, `main` on it once for each entry of `groups`; the first error, and the words at the end.
fn run(config: Config, words: &[u32], groups: &[u32], text: &str) -> (Option<ErrorKind>, Vec<u32>) {
    run_on("array<u32>", config, words, groups, text)
}

fn run_on(ty: &str, config: Config, words: &[u32], groups: &[u32], text: &str) -> (Option<ErrorKind>, Vec<u32>) {
    let text = format!("@group(0) @binding(0) var<storage, read_write> data: {ty};\n{text}");
    let linked = Linked::single("freedom.wgsl", &text).unwrap_or_else(|e| panic!("{e}"));
    let program = Program::unlinted("freedom", linked).unwrap_or_else(|e| panic!("{e}"));
    let mut job = Job::new();
    let id = job.program(&program);
    let buffer = job.upload("data", words);
    groups.iter().for_each(|&n| job.dispatch(id, "main", &[(0, buffer)], [n, 1, 1]));
    job.read("data", buffer);
    let backend = CpuBackend::new(config);
    let mut session = backend.open(&job.programs, &job.buffers).unwrap_or_else(|e| panic!("{e}"));
    let error = session.submit(&job.recordings[0]).err();
    let kind = error.map(|e| match e.kind() {
        ErrorKind::Trap(trap) => ErrorKind::Trap(trap.clone()),
        other => panic!("{other}"),
    });
    (kind, read(session.as_mut(), &job.reads[0]))
}

fn read(session: &mut dyn Session, read: &Read) -> Vec<u32> {
    let bytes = session.read(read).unwrap_or_else(|e| panic!("{e}"));
    bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect()
}

/// One thread, every SIMD level, several numbers of lanes.
fn settings(bounds: Bounds) -> impl Iterator<Item = Config> {
    let lanes = [None, Some(16), Some(64), Some(256)];
    let each =
        move |simd| lanes.map(|lanes| Config { threads: 1, simd: Some(simd), lanes, bounds, ..Config::default() });
    Simd::available().into_iter().flat_map(each)
}

#[test]
fn atomics_of_a_gang_happen_in_the_order_of_invocations() {
    let text = "@compute @workgroup_size(70) fn main(@builtin(global_invocation_id) id: vec3u) {
        data[id.x + 1u] = atomicAdd(&count, 1u);
    }
    var<workgroup> count: atomic<u32>;";
    let expected: Vec<u32> = [0].into_iter().chain((0..3).flat_map(|_| 0..70)).collect();
    for config in settings(Bounds::Clamp) {
        assert_eq!(run(config, &[0; 211], &[3], text).1, expected, "{config:?}");
    }
}

#[test]
fn of_racing_stores_the_last_invocation_wins_on_one_thread() {
    let text = "@compute @workgroup_size(20) fn main(@builtin(global_invocation_id) id: vec3u) {
        if id.x % 7u != 3u { data[id.x % 2u] = id.x; }
    }";
    for config in settings(Bounds::Clamp) {
        assert_eq!(run(config, &[0; 2], &[3], text).1, [58, 57], "{config:?}");
    }
}

#[test]
fn a_store_to_a_component_leaves_the_others_alone() {
    let text = "@compute @workgroup_size(12) fn main(@builtin(local_invocation_index) i: u32) {
        data[i / 3u][i % 3u] = i / 3u + 10u * (i % 3u);
    }";
    let expected: Vec<u32> = (0..4).flat_map(|i| [i, 10 + i, 20 + i, 7]).collect();
    for config in settings(Bounds::Clamp) {
        assert_eq!(run_on("array<vec3<u32>, 4>", config, &[7; 16], &[1], text).1, expected, "{config:?}");
    }
}

#[test]
fn a_trap_keeps_what_was_written_before_it() {
    // The second workgroup stops at its own line: the first has run, the third has not, nor has the second dispatch.
    // The access that traps is itself done as with `Bounds::Clamp`: the last word.
    let text = "@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
        workgroupBarrier();
        data[id.x] = data[id.x] + 1u;
        if id.x >= 64u { data[id.x + 1000u] = 7u; }
        data[id.x] = data[id.x] + 10u;
    }";
    let expected: Vec<u32> = (0..191).map(|i| [11, 1, 0][i / 64]).chain([7]).collect();
    for config in settings(Bounds::Trap) {
        let (error, words) = run(config, &[0; 192], &[3, 1], text);
        let Some(ErrorKind::Trap(trap)) = error else { panic!("{config:?}: no trap") };
        assert_eq!((trap.location.map(|at| at.line), trap.invocation), (Some(5), Some([64, 0, 0])), "{config:?}");
        assert_eq!(words, expected, "{config:?}");
    }
}

#[test]
fn fuel_and_barriers_keep_what_was_written_before_them() {
    let endless = "@compute @workgroup_size(16) fn main(@builtin(local_invocation_index) i: u32) {
        data[i] = 5u; loop { data[i] += 1u; if data[i] == 0u { break; } }
    }";
    let parted = "@compute @workgroup_size(16) fn main(@builtin(local_invocation_index) i: u32) {
        data[i] = 5u; if data[i + 16u] == 0u { workgroupBarrier(); } data[i] = 6u;
    }";
    let words: Vec<u32> = (0..32).map(|i| u32::from(i == 20)).collect();
    for config in settings(Bounds::Clamp) {
        let (error, after) = run(Config { fuel: 99, ..config }, &words, &[1], endless);
        assert!(matches!(error, Some(ErrorKind::Trap(_))) && after[..16] == [105; 16], "{config:?}: {after:?}");
        let (error, after) = run(config, &words, &[1], parted);
        assert!(matches!(error, Some(ErrorKind::Trap(_))) && after[..16] == [5; 16], "{config:?}: {after:?}");
    }
}

#[test]
fn a_session_goes_on_after_a_trap() {
    let text = "@group(0) @binding(0) var<storage, read_write> data: array<u32>;
        @compute @workgroup_size(1) fn main() { data[data[0]] = 9u; }";
    let program = Program::unlinted("t", Linked::single("t.wgsl", text).expect("links")).expect("compiles");
    let mut job = Job::new();
    let id = job.program(&program);
    let buffer = job.upload("data", &[7u32, 0]);
    job.dispatch(id, "main", &[(0, buffer)], [1, 1, 1]);
    job.read("data", buffer);
    let backend = CpuBackend::new(Config { threads: 1, bounds: Bounds::Trap, ..Config::default() });
    let mut session = backend.open(&job.programs, &job.buffers).expect("opens");
    assert!(session.submit(&job.recordings[0]).is_err());
    assert_eq!(read(session.as_mut(), &job.reads[0]), [7, 9]);
    for command in &mut job.recordings[0].commands {
        if let Command::Upload { bytes, .. } = command {
            bytes[0] = 1;
        }
    }
    session.submit(&job.recordings[0]).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(read(session.as_mut(), &job.reads[0]), [1, 9]);
}

/// A number, a condition and an operation in WGSL, and what each means.
type Number = (&'static str, fn(u32) -> u32);
type Condition = (&'static str, fn(u32) -> bool);
type Operation = (&'static str, fn(u32, u32) -> u32);

/// What four loads and four stores of neighbouring words do, word after word and lane after lane: the words at the end,
/// and the line and lane of the access that traps.
fn plain(words: &[u32], lanes: &[(u32, u32, u32)], traps: bool) -> (Option<(u32, u32)>, Vec<u32>) {
    let (mut data, last) = (words.to_vec(), words.len() as u32 - 1);
    let place = |at: u32| at.min(last) as usize;
    let outside = |k: u32, at: fn(&(u32, u32, u32)) -> u32| {
        lanes.iter().find(|lane| traps && at(lane).wrapping_add(k) > last).map(|lane| lane.0)
    };
    for k in 0..4 {
        if let Some(lane) = outside(k, |lane| lane.1) {
            return (Some((5 + k, lane)), data);
        }
    }
    for k in 0..4 {
        for (lane, from, to) in lanes {
            data[place(to.wrapping_add(k))] = words[place(from.wrapping_add(k))].wrapping_mul(3).wrapping_add(lane + k);
        }
        if let Some(lane) = outside(k, |lane| lane.2) {
            return (Some((9 + k, lane)), data);
        }
    }
    (None, data)
}

#[test]
fn neighbouring_words_are_accessed_word_after_word() {
    let shapes: [Number; 9] = [
        ("4u * i", |i| 4 * i),
        ("4u * i + 8u", |i| 4 * i + 8),
        ("5u * i + 1u", |i| 5 * i + 1),
        ("3u * i", |i| 3 * i),
        ("i", |i| i),
        ("4u * (99u - i)", |i| 4 * (99 - i)),
        ("i / 3u * 4u", |i| i / 3 * 4),
        ("(i * 7u % 13u) * 4u + 2u", |i| i * 7 % 13 * 4 + 2),
        ("4u * i - 4u", |i| (4 * i).wrapping_sub(4)),
    ];
    let masks: [Condition; 4] =
        [("true", |_| true), ("i % 7u != 3u", |i| i % 7 != 3), ("i >= 90u", |i| i >= 90), ("i == 50u", |i| i == 50)];
    let words: Vec<u32> = (0..400u32).map(|i| i.wrapping_mul(0x9e37_79b9) >> 7).collect();
    for ((load, from), (store, to)) in shapes.iter().flat_map(|load| shapes.iter().map(move |store| (load, store))) {
        for (mask, active) in masks {
            let text = format!(
                "@compute @workgroup_size(100) fn main(@builtin(local_invocation_index) i: u32) {{
                if {mask} {{
                    let a = {load}; let b = {store};
                    let w = data[a];
                    let x = data[a + 1u];
                    let y = data[a + 2u];
                    let z = data[a + 3u];
                    data[b] = w * 3u + i;
                    data[b + 1u] = x * 3u + i + 1u;
                    data[b + 2u] = y * 3u + i + 2u;
                    data[b + 3u] = z * 3u + i + 3u;
                }} }}"
            );
            let lanes: Vec<_> = (0..100).filter(|i| active(*i)).map(|i| (i, from(i), to(i))).collect();
            for (count, bounds) in
                [(400, Bounds::Clamp), (400, Bounds::Trap), (203, Bounds::Clamp), (203, Bounds::Trap)]
            {
                let (trap, expected) = plain(&words[..count], &lanes, bounds == Bounds::Trap);
                for simd in Simd::available() {
                    let config = Config { threads: 1, simd: Some(simd), bounds, ..Config::default() };
                    let (error, after) = run(config, &words[..count], &[1], &text);
                    let found = error.map(|error| match error {
                        ErrorKind::Trap(trap) => (trap.location.map(|at| at.line), trap.invocation.map(|id| id[0])),
                        other => panic!("{other}"),
                    });
                    let what = format!("{load} to {store} where {mask} of {count} words, {config:?}");
                    assert_eq!(found, trap.map(|(line, lane)| (Some(line), Some(lane))), "{what}");
                    assert_eq!(after, expected, "{what}");
                }
            }
        }
    }
}

#[test]
fn neighbouring_words_become_records() {
    let text = "@group(0) @binding(0) var<storage, read> input: array<array<vec4u, 3>>;
        @group(0) @binding(1) var<storage, read_write> output: array<u32>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
            let v = input[id.x][1];
            let at = 4u * id.x;
            output[at] = v.x;
            output[at + 1u] = v.y + 1u;
            output[at + 2u] = v.z;
            output[at + 3u] = v.w * 3u;
        }";
    let program = Program::unlinted("t", Linked::single("t.wgsl", text).expect("links")).expect("compiles");
    let code = CpuBackend::lowered(&program, "main", &[]).expect("lowers").to_string();
    assert_eq!((code.matches("LoadRecord").count(), code.matches("StoreRecord").count()), (1, 1), "{code}");
}

#[test]
fn atomics_without_results_are_those_of_one_lane_after_the_other() {
    let operations: [Operation; 6] = [
        ("atomicAdd", |old, word| old.wrapping_add(word)),
        ("atomicSub", |old, word| old.wrapping_sub(word)),
        ("atomicXor", |old, word| old ^ word),
        ("atomicOr", |old, word| old | word),
        ("atomicMin", |old, word| old.min(word)),
        ("atomicExchange", |_, word| word),
    ];
    let places: [Number; 4] =
        [("i * 5u % 9u", |i| i * 5 % 9), ("i / 20u", |i| i / 20), ("3u", |_| 3), ("i % 11u", |i| i % 11)];
    let words: Vec<u32> = (0..9u32).map(|i| i.wrapping_mul(0x9e37_79b9)).collect();
    for (name, apply) in operations {
        for (place, at) in places {
            for (mask, skip) in [("true", u32::MAX), ("i % 5u != 2u", 2)] {
                let value = |i: u32| i.wrapping_mul(0x85eb_ca6b) ^ 77;
                let text = format!(
                    "@compute @workgroup_size(100) fn main(@builtin(local_invocation_index) i: u32) {{
                    if {mask} {{ {name}(&data[{place}], (i * 0x85ebca6bu) ^ 77u); }} }}"
                );
                let mut expected = words.clone();
                for i in (0..100).filter(|i| i % 5 != skip) {
                    // Past the end is the last word.
                    let word = &mut expected[at(i).min(8) as usize];
                    *word = apply(*word, value(i));
                }
                for config in settings(Bounds::Clamp) {
                    let (_, after) = run_on("array<atomic<u32>>", config, &words, &[1], &text);
                    assert_eq!(after, expected, "{name} at {place} where {mask}, {config:?}");
                }
            }
        }
    }
}

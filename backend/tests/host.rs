//! Typed bindings against naga's layout: what agrees passes, and each way to differ is named with both sides' numbers.

use std::sync::Arc;

use sightlines_backend::host::Bindings;
use sightlines_backend::{Command, ErrorKind, Groups, Job, Program, bindings, check, host};

host! {
    /// Nested in `Params`.
    pub struct Range {
        /// First.
        pub first: u32,
        /// Number.
        pub count: u32,
    }

    /// Every shape a struct may hold.
    pub struct Params {
        /// A vector of 12 bytes, followed by a scalar in its padding.
        pub origin: glam::IVec3,
        /// A scalar.
        pub bias: i32,
        /// An array of structs.
        pub ranges: [Range; 2],
        /// A vector of 8 bytes.
        pub extent: glam::UVec2,
        /// Padding that WGSL adds by itself.
        pub _pad: [u32; 2],
        /// A vector of 16 bytes.
        pub plane: glam::UVec4,
        /// A matrix.
        pub matrix: glam::Mat4,
    }
}

bindings! {
    /// The bindings of `main`.
    pub struct Main {
        read params @ 0: Params,
        read input @ (1, 3): [glam::UVec4],
        write output @ 2: [u32],
        write total @ 5: u32,
    }
}

const PARAMS: &str = "struct Range { first: u32, count: u32 }
struct Params {
    origin: vec3<i32>, bias: i32, ranges: array<Range, 2>, extent: vec2<u32>, plane: vec4<u32>, matrix: mat4x4<f32>,
}
";

const BINDINGS: &str = "@group(0) @binding(0) var<storage, read> params: Params;
@group(1) @binding(3) var<storage, read> input: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read_write> output: array<u32>;
@group(0) @binding(5) var<storage, read_write> total: atomic<u32>;
@group(0) @binding(6) var<storage, read_write> other: array<u32>;
";

const BODY: &str = "@compute @workgroup_size(1) fn main() {
    output[0] = input[0].x + params.plane.y + params.ranges[0].first;
    atomicAdd(&total, 1);
}
@compute @workgroup_size(1) fn second() { other[0] = 1u; }
";

fn program(wgsl: &str) -> Arc<Program> {
    let text = wgsl.to_owned();
    let linked = sightlines_backend::Linked::single("host.wgsl", &text).expect("links");
    Program::unlinted("host", linked).unwrap_or_else(|e| panic!("{e}"))
}

/// The text with `from` replaced by `to`, checked against `Main`.
fn differs(from: &str, to: &str) -> String {
    let original = format!("{PARAMS}{BINDINGS}{BODY}");
    let text = original.replace(from, to);
    assert_ne!(text, original, "`{from}` is not in the text");
    let error = Main::check(&program(&text), "main").expect_err("must differ");
    assert!(matches!(error.kind(), ErrorKind::Layout { name, .. } if name == "Main"), "{error}");
    error.to_string()
}

bindings! {
    /// `uniform` where the WGSL says `read`, and nothing else declared.
    struct Mistaken {
        uniform params @ 0: Params,
    }
}

#[test]
fn access_and_forgotten_bindings_differ() {
    let error = Mistaken::check(&program(&format!("{PARAMS}{BINDINGS}{BODY}")), "main").expect_err("differs");
    let expected = "layout of `Mistaken` differs from the WGSL: params: WGSL access read, Rust access uniform
  `main` uses `output` at group 0 binding 2, Rust does not declare it
  `main` uses `total` at group 0 binding 5, Rust does not declare it
  `main` uses `input` at group 1 binding 3, Rust does not declare it";
    assert_eq!(error.to_string(), expected);
}

#[test]
fn each_difference_is_named() {
    let cases = [
        ("bias: i32", "slack: i32", "params: WGSL `slack` at offset 12, Rust `bias` at offset 12"),
        ("bias: i32", "bias: u32", "params.bias: WGSL type `u32`, Rust type `i32`"),
        ("bias: i32", "@align(16) bias: i32", "params.bias: WGSL offset 16, Rust offset 12"),
        ("ranges: array<Range, 2>", "ranges: array<Range, 3>", "params.ranges: WGSL length 3, Rust length 2"),
        ("struct Range { first: u32, count: u32 }", "struct Range { first: u32 }", "WGSL stride 4, Rust stride 8"),
        ("plane: vec4<u32>", "plane: vec3<u32>", "params.plane: WGSL type `vec3<u32>`, Rust type `vec4<u32>`"),
        ("matrix: mat4x4<f32>", "matrix: mat4x4<f32>, more: u32", "params.more: WGSL offset 128"),
        ("matrix: mat4x4<f32>,", "", "params.matrix: Rust offset 64, WGSL has no such field"),
        ("var<storage, read> input: array<vec4<u32>>", "var<storage, read> input: array<vec4<u32>, 4>", "is a slice"),
        ("array<vec4<u32>>", "array<vec3<u32>>", "input[]: WGSL type `vec3<u32>`, Rust type `vec4<u32>`"),
        ("@group(0) @binding(5)", "@group(0) @binding(4)", "`main` uses `total` at group 0 binding 4"),
        ("total: atomic<u32>", "total: atomic<i32>", "total: WGSL type `atomic<i32>`, Rust type `u32`"),
        ("output[0] =", "other[0] =", "output: Rust declares group 0 binding 2, `main` does not use it"),
    ];
    for (from, to, expected) in cases {
        let text = differs(from, to);
        assert!(text.contains(expected), "`{from}` -> `{to}` gives\n{text}\nwhich lacks `{expected}`");
    }
}

#[test]
fn all_differences_are_reported_at_once() {
    let text = differs("bias: i32, ranges: array<Range, 2>", "bias: u32, ranges: array<Range, 2>, extra: u32");
    assert!(text.contains("params.bias: WGSL type `u32`") && text.contains("WGSL `extra` at offset 32"), "{text}");
}

#[test]
fn a_renamed_binding_is_named() {
    let text = format!("{PARAMS}{BINDINGS}{BODY}").replace("input", "entry_words");
    let error = Main::check(&program(&text), "main").expect_err("renamed");
    assert!(error.to_string().contains("group 1 binding 3: WGSL name `entry_words`, Rust name `input`"), "{error}");
}

#[test]
fn an_unknown_entry_point_lists_the_known_ones() {
    let error = Main::check(&program(&format!("{PARAMS}{BINDINGS}{BODY}")), "maim").expect_err("unknown");
    assert!(error.to_string().contains("no entry point `maim`; it has `main`, `second`"), "{error}");
}

#[test]
fn equal_layouts_launch() {
    let program = program(&format!("{PARAMS}{BINDINGS}{BODY}"));
    Main::check(&program, "main").unwrap_or_else(|e| panic!("{e}"));
    let mut job = Job::new();
    let id = job.program(&program);
    let words = job.zeroed::<u32>("words", 256);
    let bound = Main {
        params: job.value("params", &bytemuck::Zeroable::zeroed()),
        input: job.slice("input", &[glam::UVec4::ONE; 32]).elements(16..32),
        output: words.elements(64..256),
        total: job.zeroed("total", 2).first(),
    };
    job.launch(id, "main", &bound, [1, 1, 1]);
    check::job(&job).unwrap_or_else(|e| panic!("{e}"));
    let Some(Command::Dispatch(dispatch)) = job.recordings[0].commands.last() else { panic!("a dispatch") };
    let slots: Vec<_> = dispatch.slots.iter().map(|s| (s.group, s.binding, s.offset, s.size)).collect();
    assert_eq!(slots, [(0, 0, 0, 128), (1, 3, 256, 256), (0, 2, 256, 768), (0, 5, 0, 4)]);
    assert_eq!(dispatch.groups, Groups::Direct([1, 1, 1]));
    assert_eq!((words.len(), bound.output.len(), bound.output.size()), (256, 192, 768));
}

//! Programs: what reflection says, what overrides make of a module, and that bad WGSL is told by file, line and reason.

use std::sync::Arc;

use sightlines_backend::{Access, Binding, ErrorKind, Linked, Program};

fn program(wgsl: &str) -> Arc<Program> {
    compile(wgsl).unwrap_or_else(|e| panic!("{e}"))
}

fn compile(wgsl: &str) -> Result<Arc<Program>, sightlines_backend::Error> {
    Program::unlinted("label", Linked::single("kernel.wgsl", wgsl).expect("links"))
}

/// The stage, line and text of a refusal.
#[track_caller]
fn refused(wgsl: &str) -> (&'static str, Option<u32>, String) {
    let error = compile(wgsl).map(|_| ()).expect_err("must be refused");
    match error.kind() {
        ErrorKind::Wgsl { stage, location, rendered } => (stage, location.as_ref().map(|l| l.line), rendered.clone()),
        other => panic!("{other:?}"),
    }
}

const WGSL: &str = "override side: u32 = 8;
@id(7) override scale: f32;
struct Params { count: u32, more: vec3<u32> }
struct Tail { count: u32, words: array<vec2<u32>> }
@group(1) @binding(0) var<storage, read_write> tail: Tail;
@group(0) @binding(4) var<storage> input: array<vec3<u32>>;
@group(0) @binding(1) var<uniform> params: Params;
@group(0) @binding(2) var image: texture_2d<f32>;
@group(0) @binding(3) var filtering: sampler;
var<workgroup> cells: array<u32, side * side>;
fn indirectly() -> u32 { return input[0].x; }
@compute @workgroup_size(side, side, 2) fn main() { cells[0] = indirectly(); tail.words[0].x = u32(scale) + cells[1]; }
@compute @workgroup_size(1) fn sampled() {
    tail.count = params.count + u32(textureSampleLevel(image, filtering, vec2<f32>(0.5), 0.0).x);
}
@fragment fn shade() { }
";

#[test]
fn reflection_lists_buffers_and_what_each_entry_point_uses() {
    let program = program(WGSL);
    let expected = [
        ("tail", 1, 0, Access::ReadWrite, 16),
        ("input", 0, 4, Access::Read, 16),
        ("params", 0, 1, Access::Uniform, 32),
    ];
    let bindings = expected.map(|(name, group, binding, access, min_size)| Binding {
        name: name.into(),
        group,
        binding,
        access,
        min_size,
    });
    assert_eq!(program.bindings(), bindings);
    let names = |entry: &str| {
        let used = &program.entry(entry).expect("an entry point").bindings;
        used.iter().map(|&index| program.bindings()[index].name.as_str()).collect::<Vec<_>>()
    };
    assert_eq!(names("main"), ["input", "tail"]);
    assert_eq!(names("sampled"), ["params", "tail"]);
    assert!(program.entry("shade").is_none(), "only compute entry points are listed");
}

#[test]
fn textures_and_samplers_are_no_buffers_but_are_found() {
    let program = program(WGSL);
    let opaque = program.opaque("sampled");
    let found: Vec<_> =
        opaque.iter().map(|o| (o.name.as_str(), o.kind.as_str(), o.location.as_ref().map(|l| l.line))).collect();
    assert_eq!(found, [("image", "texture_2d<f32>", Some(8)), ("filtering", "sampler", Some(9))]);
    assert!(program.opaque("main").is_empty());
    assert!(program.opaque("nothing").is_empty());
}

#[test]
fn override_values_are_applied() {
    let program = program(WGSL);
    let (module, info) = program.specialise("main", &[("side".into(), 4.0), ("7".into(), 2.0)]).expect("specialises");
    assert_eq!(module.entry_points.len(), 1);
    assert_eq!((module.entry_points[0].name.as_str(), module.entry_points[0].workgroup_size), ("main", [4, 4, 2]));
    let entry = &module.entry_points[0].function;
    assert!(
        !entry.expressions.iter().any(|(_, e)| matches!(e, naga::Expression::Override(_))),
        "values stand for names"
    );
    assert_eq!(info.get_entry_point(0).expression_count(), entry.expressions.len());
    let missing = program.specialise("main", &[]).map(|_| ()).expect_err("`scale` has no default").to_string();
    assert!(missing.contains("Missing value") && missing.contains("remedy: give each `override`"), "{missing}");
}

#[test]
fn equal_texts_have_equal_ids() {
    let text = |n: u32| format!("@compute @workgroup_size({n}) fn main() {{ }}\n");
    assert_eq!(program(&text(1)).id(), program(&text(1)).id());
    assert_ne!(program(&text(1)).id(), program(&text(2)).id());
    assert_eq!(program(&text(1)).id().len(), 16);
}

#[test]
fn what_does_not_compile_is_told_by_line_and_reason() {
    let main = "@compute @workgroup_size(1) fn main() { }\n";
    let cases = [
        ("fn f( { }\n", "parse", Some(1), "expected identifier"),
        ("\nfn f() -> u32 { return x; }\n", "parse", Some(2), "no definition in scope for identifier: `x`"),
        ("fn f() -> u32 { return f(); }\n", "parse", Some(1), "recursive"),
        ("fn f() { g(); }\nfn g() { f(); }\n", "parse", Some(2), "cyclic"),
        ("fn f() { }\n\nfn f() { }\n", "parse", Some(3), "redefinition of `f`"),
        ("var<uniform> loose: u32;\nfn f() -> u32 { return loose; }\n", "validate", Some(1), "loose"),
        ("fn f() -> u32 { }\n", "validate", Some(1), ""),
        ("/* open", "parse", None, ""),
        ("enable f16;\nfn f(x: f16) { }\n", "validate", None, "Capabilities"),
    ];
    for (text, stage, line, words) in cases {
        let (found, at, rendered) = refused(&format!("{text}{main}"));
        assert_eq!((found, line.is_none() || at == line), (stage, true), "{text}: {at:?}\n{rendered}");
        assert!(rendered.contains(words), "`{words}` is not in\n{rendered}");
    }
}

#[test]
fn a_program_has_a_compute_entry_point() {
    for text in ["", "fn f() { }\n", "@fragment fn f() { }\n"] {
        let (stage, _, rendered) = refused(text);
        assert_eq!(stage, "validate");
        assert!(rendered.contains("`label` has no `@compute` entry point"), "{rendered}");
    }
}

#[test]
fn text_that_is_nothing_in_particular_never_panics() {
    for text in [
        "\0",
        "\u{feff}fn",
        "🙂",
        "@",
        "0x",
        "1e999",
        "array<array<",
        "const a = 1 / 0;",
        "const a: i32 = -2147483648 / -1;",
    ] {
        let (stage, ..) = refused(text);
        assert!(["parse", "validate"].contains(&stage), "{text:?}");
    }
}

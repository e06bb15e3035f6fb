//! Each lint on a small kernel: that it fires at its line, that it is silent where it should be, its mark and its
//! allowance.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use sightlines_backend::lint::LINTS;
use sightlines_backend::{ErrorKind, Linked, Program};

const MAIN: &str = "@group(0) @binding(0) var<storage, read_write> o: array<u32>;
@compute @workgroup_size(64) fn main(@builtin(local_invocation_index) i: u32) {\n";

/// A program whose `main` has this body, after these items.
fn with(items: &str, body: &str) -> Result<(), sightlines_backend::Error> {
    let text = format!("{items}{MAIN}{body}\n}}\n");
    Program::new("lint", "lint.wgsl", &move |_| Some(text.clone()), &[]).map(|_| ())
}

#[track_caller]
fn clean(items: &str, body: &str) {
    with(items, body).unwrap_or_else(|e| panic!("{e}"));
}

/// The violations as `lint:line`, in order.
#[track_caller]
fn found(items: &str, body: &str) -> Vec<String> {
    let Err(error) = with(items, body) else { panic!("nothing is found in {items}{body}") };
    let ErrorKind::Wgsl { stage: "lint", location: Some(first), rendered } = error.kind() else { panic!("{error}") };
    let mut found = Vec::new();
    let mut lint = "";
    for line in rendered.lines() {
        if let Some(rest) = line.strip_prefix("error: ") {
            lint = rest.split(':').next().unwrap_or_default();
        } else if let Some((_, place)) = line.split_once("┌─ lint.wgsl:") {
            let line: u32 = place.split(':').next().and_then(|n| n.parse().ok()).expect("a line");
            found.push(format!("{lint}:{line}"));
        }
    }
    assert!(found.iter().any(|f| f.ends_with(&format!(":{}", first.line))), "{first} is not among {found:?}");
    found
}

#[test]
fn integer_kernels_are_clean() {
    clean("", "o[i] = (o[i + 1u] * 3u) / max(i, 1u) + u32(i32(i) - 4);\natomic_free();\n}\nfn atomic_free() {");
}

#[test]
fn float_arithmetic_needs_a_mark() {
    let bodies = [
        "let x = f32(o[0]);",
        "let x = bitcast<f32>(o[0]) + 1.0;",
        "let x = -bitcast<f32>(o[0]);",
        "if bitcast<f32>(o[0]) < 1.0 { o[1] = 1u; }",
        "let x = floor(bitcast<f32>(o[0]));",
        "let x = vec3<f32>(bitcast<f32>(o[0])) * 2.0;",
        "let x = u32(bitcast<f32>(o[0]));",
        "let x = modf(bitcast<f32>(o[0]));",
    ];
    for body in bodies {
        assert_eq!(found("", body), ["float-arithmetic:3"], "{body}");
        let marked = format!("/// float: guess - corrected below\nfn guess() {{ {body} }}\n");
        clean(&marked, "guess();");
        clean(&marked.replace("guess - corrected below", "filter"), "guess();");
    }
    clean(
        "",
        "let x = bitcast<f32>(o[0]); var y = vec2<f32>(x, 1.0); y = select(y, y.yx, true); o[1] = bitcast<u32>(y.x);",
    );
}

#[test]
fn entry_points_take_marks_too() {
    let text = "@group(0) @binding(0) var<storage, read_write> o: array<u32>;\n/// What it does.\n/// float: filter\n\
                @compute @workgroup_size(1)\nfn main() { o[0] = u32(f32(o[1]) * 0.5); }\n";
    assert!(Program::new("lint", "lint.wgsl", &|_| Some(text.into()), &[]).is_ok());
}

#[test]
fn inexact_builtins_are_found_in_marked_functions() {
    let calls = [
        "sin(x)",
        "cos(x)",
        "tan(x)",
        "atan2(x, x)",
        "exp2(x)",
        "log(x)",
        "pow(x, x)",
        "sqrt(x)",
        "fract(x)",
        "fma(x, x, x)",
        "mix(x, x, x)",
        "smoothstep(x, x, x)",
        "degrees(x)",
        "quantizeToF16(x)",
        "x % x",
        "dot(vec2<f32>(x), vec2<f32>(x))",
        "length(vec2<f32>(x))",
        "normalize(vec2<f32>(x)).x",
        "cross(vec3<f32>(x), vec3<f32>(x)).x",
        "(mat2x2<f32>(x, x, x, x) * vec2<f32>(x)).x",
        "unpack2x16float(o[0]).x",
    ];
    for call in calls {
        let guess = format!("/// float: guess\nfn guess(x: f32) -> f32 {{ return {call}; }}\n");
        assert_eq!(found(&guess, "let y = guess(1.0);"), ["inexact-builtin:2"], "{call}");
        clean(&format!("/// allow(inexact-builtin): within the slack\n{guess}"), "let y = guess(1.0);");
    }
    for call in ["inverseSqrt(x)", "floor(x)", "min(x, 2.0)", "clamp(x, 0.0, 1.0)", "1.0 / x", "abs(x)", "ldexp(x, 2i)"]
    {
        clean(&format!("/// float: guess\nfn guess(x: f32) -> f32 {{ return {call}; }}\n"), "let y = guess(1.0);");
    }
}

#[test]
fn f32_does_not_cross_memory() {
    let declarations = [
        "@group(0) @binding(1) var<storage, read> a: array<f32>;",
        "@group(0) @binding(1) var<uniform> a: vec4<f32>;",
        "var<workgroup> a: array<array<vec2<f32>, 4>, 4>;",
        "struct S { x: u32, m: mat4x4<f32> } @group(0) @binding(1) var<storage, read_write> a: S;",
    ];
    for declaration in declarations {
        assert_eq!(found(&format!("{declaration}\n"), ""), ["float-memory:1"], "{declaration}");
    }
    clean("/// allow(float-memory): shown, never compared\n@group(0) @binding(1) var<uniform> a: vec4<f32>;\n", "");
    clean("var<private> a: f32;\n@group(0) @binding(1) var<storage, read> b: array<vec4<u32>>;\n", "");
}

#[test]
fn literals_are_exact() {
    for literal in ["0.1", "1.00001", "16777217.0", "0.3f", "1e-40"] {
        assert_eq!(found("", &format!("let x: f32 = {literal};")), ["inexact-literal:3"], "{literal}");
        assert_eq!(found(&format!("const K = {literal};\n"), ""), ["inexact-literal:1"], "{literal}");
    }
    assert_eq!(found("", "let x: f32 = 16777217;"), ["inexact-literal:3"]);
    for literal in ["0.125", "4294967040.0", "1e3", "0x1.8p3", "16777216", "-0.5"] {
        clean("", &format!("let x: f32 = {literal};"));
    }
    clean("/// allow(inexact-literal): a margin, any value near it serves\nconst K = 1.00001;\n", "let x = K;");
}

#[test]
fn floats_are_not_folded() {
    for value in ["1.0 / 3.0", "2.0 * 3.0", "1.0 - 0.5", "sqrt(2.0)", "f32(1.0 + 2.0)"] {
        assert_eq!(found("", &format!("let x: f32 = {value};")), ["folded-float:3"], "{value}");
        assert_eq!(found(&format!("const K = {value};\n"), "let x: f32 = K;"), ["folded-float:1"], "{value}");
        assert_eq!(found(&format!("const K: f32 = {value};\n"), "let x = K;"), ["folded-float:1"], "{value}");
    }
    let twice = "const A = 1.0 / 4.0;\nconst B = A;\n";
    assert_eq!(found(twice, "let x: f32 = B;"), ["folded-float:1"]);
    clean("/// allow(folded-float): exact by hand\nconst K: f32 = 1.0 / 4.0;\n", "let x = K;");
    for value in [
        "-1.0",
        "(2.0)",
        "f32(3)",
        "max(1.0, 2.0)",
        "vec3<f32>(1.0, -2.0, 0.5).y",
        "bitcast<f32>(0x3f800000u)",
        "f32(3 + 4)",
    ] {
        clean("", &format!("let x: f32 = {value};"));
    }
    clean("/// float: guess\nfn f(x: f32) -> f32 { return x * 2.0 - 0.5 / (x + 4.0); }\n", "let y = f(1.0);");
}

#[test]
fn i32_is_not_divided() {
    for body in ["let x = i32(i) / 2;", "let x = i32(i) % 4;", "let x = vec2<i32>(i32(i)) / vec2<i32>(3);"] {
        assert_eq!(found("", body), ["signed-division:3"], "{body}");
    }
    clean(
        "/// allow(signed-division): the numerator is never negative\nfn f(x: i32) -> i32 { return x / 2; }\n",
        "let y = f(1);",
    );
    clean("", "let x = i / 2u + i % 3u; let y = i32(i) >> 1u;");
}

#[test]
fn int_min_is_not_written() {
    for body in ["let x = max(i32(i), -2147483648);", "let x = i32(i) + (-2147483647i - 1i);"] {
        assert_eq!(found("", body), ["int-min-literal:3"], "{body}");
    }
    assert_eq!(found("const K: i32 = -2147483648;\n", "let x = i32(i) + K;"), ["int-min-literal:1"]);
    clean(
        "/// allow(int-min-literal): never leaves this constant\nconst K: i32 = -2147483648;\n",
        "let x = i32(i) + K;",
    );
    clean("", "let x = max(i32(i), -2147483647);");
}

#[test]
fn returned_atomics_are_not_used() {
    let items = "var<workgroup> a: atomic<u32>;\n";
    for body in ["o[0] = atomicAdd(&a, 1u);", "let x = atomicExchange(&a, 1u) + 1u;"] {
        assert_eq!(found(items, body), ["atomic-result:4"], "{body}");
    }
    assert_eq!(
        found(items, "let r = atomicCompareExchangeWeak(&a, 0u, 1u); if r.exchanged { return; }"),
        ["atomic-result:4"]
    );
    clean(items, "atomicAdd(&a, 1u); atomicMax(&a, i); workgroupBarrier(); o[i] = atomicLoad(&a);");
    let claim = "/// allow(atomic-result): the slots are sorted before they are read\nfn claim() -> u32 { return atomicAdd(&a, 1u); }\n";
    clean(&format!("{items}{claim}"), "o[0] = claim();");
}

#[test]
fn subgroups_are_found() {
    let text = "@group(0) @binding(0) var<storage, read_write> o: array<u32>;\n\
                @compute @workgroup_size(64) fn main(@builtin(subgroup_size) n: u32) {\n\
                    o[0] = subgroupAdd(n);\n    o[1] = subgroupBallot(true).x;\n}\n";
    let linked = Linked::single("lint.wgsl", text).expect("links");
    let module = naga::front::wgsl::parse_str(&linked.text).unwrap_or_else(|e| panic!("{}", e.emit_to_string(text)));
    let info = Validator::new(ValidationFlags::all(), Capabilities::all()).validate(&module).expect("valid");
    let rendered = sightlines_backend::lint::check(&module, &info, &linked).expect_err("found").to_string();
    for part in ["subgroup: a subgroup operation or builtin", "takes a subgroup builtin", "3 │", "4 │"] {
        assert!(rendered.contains(part), "`{part}` is not in\n{rendered}");
    }
}

#[test]
fn malformed_marks_are_found() {
    let bad = [
        ("/// float: maybe\nfn f() {}\n", "`maybe` is no kind"),
        ("/// float: guess\nconst K = 1;\n", "only a function is marked"),
        ("/// float: guess\n/// float: filter\nfn f(x: f32) -> f32 { return x + x; }\n", "marked twice"),
        ("/// allow(signed-division)\nfn f(x: i32) -> i32 { return x / 2; }\n", "needs `: reason`"),
        ("/// allow(signed-division):\nfn f(x: i32) -> i32 { return x / 2; }\n", "needs `: reason`"),
        ("/// allow(division): why\nfn f() {}\n", "there is no lint `division`"),
        ("/// allow(stale-mark): why\nfn f() {}\n", "cannot be allowed"),
        ("/// allow(signed-division: why\nfn f() {}\n", "no `)`"),
    ];
    for (items, label) in bad {
        let text = with(items, "").expect_err("malformed").to_string();
        assert!(text.contains("malformed-mark") && text.contains(label), "`{label}` is not in\n{text}");
    }
}

#[test]
fn marks_without_effect_are_found() {
    let stale = [
        "/// float: guess\nfn f() {}\n",
        "/// allow(signed-division): was once\nfn f(x: u32) -> u32 { return x / 2u; }\n",
        "/// allow(float-memory): was once\nvar<private> p: f32;\n",
    ];
    for items in stale {
        assert_eq!(found(items, ""), ["stale-mark:1"], "{items}");
    }
}

#[test]
fn an_allowance_covers_one_lint_of_one_item() {
    let items = "/// allow(signed-division): why\nfn f(x: i32) -> i32 { return x / 2; }\nfn g(x: i32) -> i32 { return x % 2; }\n";
    assert_eq!(found(items, "let y = f(1) + g(2);"), ["signed-division:3"]);
}

#[test]
fn all_violations_are_reported_at_once_by_item_and_line() {
    let items = "const K = 0.1;\nfn f(x: i32) -> i32 { return x / 2; }\nvar<workgroup> w: f32;\n";
    let all = found(items, "let y = f32(i);\nlet z = i32(i) / 3;");
    assert_eq!(
        all,
        ["inexact-literal:1", "signed-division:2", "float-memory:3", "float-arithmetic:6", "signed-division:7"]
    );
}

#[test]
fn a_report_says_what_why_and_what_to_do() {
    let text = with("", "let x = i32(i) / 2;").expect_err("found").to_string();
    let expected = "error: signed-division: `/` or `%` on i32
  ┌─ lint.wgsl:3:9
  │
3 │ let x = i32(i) / 2;
  │         ^^^^^^^^^^ divides i32
  │
  = why: drivers have divided negative operands wrongly, and SPIR-V leaves their remainder open
  = remedy: divide magnitudes as u32 and restore the sign, or shift
";
    assert_eq!(text.trim_end(), expected.trim_end());
}

#[test]
fn unlinted_programs_are_not_linted() {
    let text = format!("{MAIN}o[0] = u32(sin(f32(i)));}}");
    assert!(Program::unlinted("free", Linked::single("free.wgsl", &text).expect("links")).is_ok());
}

#[test]
fn lints_have_distinct_names_and_full_texts() {
    for (index, lint) in LINTS.iter().enumerate() {
        assert!(LINTS[..index].iter().all(|l| l.name != lint.name), "{}", lint.name);
        assert!(![lint.summary, lint.why, lint.remedy].contains(&""), "{}", lint.name);
        let documented = include_str!("../../docs/numerics.md").contains(&format!("`{}`", lint.name));
        assert!(documented, "docs/numerics.md does not speak of `{}`", lint.name);
    }
}

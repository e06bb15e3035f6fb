//! The self-test tests: it passes on the interpreter, and it fails where a function is wrong.
//!
//! A canary is one edit of a shared text of the kind that proofs and reviews miss. The edited function must still
//! compile and lint, and the self-test must see it.

use std::sync::Arc;

use sightlines_backend::{Backend, Job, Program};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::exact::{self, Function, PARTS, Volume, functions};
use sightlines_kernels::source;

/// Blocks of random shapes that tests run.
const BLOCKS: u32 = 16;

fn interpreter() -> CpuBackend {
    CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() })
}

fn named(name: &str) -> &'static Function {
    functions().find(|function| function.name == name).unwrap_or_else(|| panic!("no function {name}"))
}

fn run(backend: &CpuBackend, program: &Arc<Program>, function: &Function, volume: Volume) -> Vec<u32> {
    let mut job = Job::new();
    let output = exact::record(&mut job, program, function, volume);
    job.read("output", output.id());
    let outputs = backend.run(&job).unwrap_or_else(|error| panic!("{}: {error}", function.name));
    outputs[0].chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
}

/// How many words of whole results, and how many digests, differ from the oracle's.
fn wrong(backend: &CpuBackend, program: &Arc<Program>, function: &Function) -> (usize, usize) {
    let differ = |a: &[u32], b: &[u32]| a.iter().zip(b).filter(|(a, b)| a != b).count();
    let whole = run(backend, program, function, Volume::Edges);
    let digests = run(backend, program, function, Volume::Blocks(BLOCKS));
    let expected: Vec<u32> = (0..BLOCKS).map(|block| function.digest(block)).collect();
    (differ(&whole, &function.whole()), differ(&digests, &expected))
}

#[test]
fn every_function_agrees_with_its_definition() {
    let backend = interpreter();
    for part in PARTS {
        let program = exact::compile(part, &source).unwrap_or_else(|error| panic!("{part}: {error}"));
        for function in functions().filter(|function| function.part == part) {
            let whole = run(&backend, &program, function, Volume::Edges);
            for (i, (found, wanted)) in whole.chunks(4).zip(function.whole().chunks(4)).enumerate() {
                assert_eq!(found, wanted, "{} of pair {i}", function.name);
            }
            assert_eq!(wrong(&backend, &program, function), (0, 0), "{}", function.name);
        }
    }
}

#[test]
fn every_entry_point_is_a_function_and_the_other_way_round() {
    for part in PARTS {
        let program = exact::compile(part, &source).unwrap_or_else(|error| panic!("{part}: {error}"));
        let mut entries: Vec<String> = program.entries().iter().map(|entry| entry.name.clone()).collect();
        let mut known: Vec<String> = functions().filter(|f| f.part == part).map(Function::entry).collect();
        entries.sort();
        known.sort();
        assert_eq!(entries, known, "{part}");
    }
}

/// One edit of one text, and the test that must see it.
#[derive(Debug)]
struct Canary {
    function: &'static str,
    file: &'static str,
    text: &'static str,
    instead: &'static str,
}

const fn canary(function: &'static str, file: &'static str, text: &'static str, instead: &'static str) -> Canary {
    Canary { function, file, text, instead }
}

#[rustfmt::skip]
static CANARIES: &[Canary] = &[
    canary("sums64", "wide", "select(0u, 1u, low < a.x)", "select(0u, 1u, low <= a.x)"),
    canary("sums64", "wide", "select(0u, 1u, a.x < b.x)", "0u"),
    canary("signs64", "wide", "select(0u, 1u, a.x != 0u)", "1u"),
    canary("order64", "wide", "(a.x < b.x));", "(a.x <= b.x));"),
    canary("order64", "wide", "select(1, 0, (a.x | a.y) == 0u)", "select(1, 0, a.y == 0u)"),
    canary("shifts64", "wide", "((a.x >> 1u) >> (31u - k))", "(a.x >> (32u - k))"),
    canary("umul_wide", "wide", "let u = al * bh + (t & 0xffffu);", "let u = al * bh;"),
    canary("imul_wide", "wide", "select(0u, ua, b < 0)", "select(0u, ua, b < -1)"),
    canary("mask_dot", "mask", "mask.y & plane.y", "mask.y & plane.x"),
    canary("hash32", "hash", "(s >> 28u) + 4u", "(s >> 28u) + 3u"),
    canary("udiv64_32", "divide", "q += select(0u, 1u, up);\n    return", "return"),
    canary("udiv64_32", "divide", "r = select(r, sub64(r, vec2<u32>(dn, 0u)), up);", "r = sub64(r, vec2<u32>(dn, 0u));"),
    canary("udiv64_32", "divide", "4294967040.0", "4294901760.0"),
    canary("udiv64_32i", "divide", "over = (r1 <= 0xffffu) & (", "over = (r1 < 0xffffu) & false & ("),
    canary("fdiv64_sat", "divide", "select(0x7fffffffu, 0x80000000u, negative)", "0x7fffffffu + 1u"),
    canary("fdiv64_sat", "divide", "if (a.y >= d)", "if (a.y > d)"),
    canary("ufrac", "fraction", "let above = r >= bitcast<i32>(d);", "let above = r > bitcast<i32>(d);"),
    canary("ufrac", "fraction", "let below = r < 0;", "let below = false;"),
    canary("isqrt32", "root", "select(0u, 1u, r < 0)", "0u"),
    canary("isqrt32", "root", "select(0u, 1u, r > bitcast<i32>(2u * s))", "select(0u, 1u, r >= bitcast<i32>(2u * s))"),
    canary("isqrt64", "root", "(r.x > 2u * x)", "(r.x >= 2u * x)"),
    canary("isqrt64", "root", "return select(x >> (s >> 1u), 0u, (n.x | n.y) == 0u);", "return x >> (s >> 1u);"),
    canary("rn_add", "soft_float", "+ ((s >> 7u) & 1u)) >> 7u", "+ 1u) >> 7u"),
    canary("rn_add", "soft_float", "let d = min(ex - ey, 31u);", "let d = min(ex - ey, 25u);"),
    canary("rn_add", "soft_float", "select(x & F_SIGN, 0u, opposed)", "x & F_SIGN"),
    canary("rn_mul", "soft_float", "let h = p.y | select(0u, 1u, p.x != 0u);", "let h = p.y;"),
    canary("rn_mul", "soft_float", "(h >> c) | (h & c)", "h >> c"),
    canary("rn_div", "soft_float", "q += bitcast<u32>(dq);\n    r -= dq * mb;", ""),
    canary("rn_div", "soft_float", "(q << 6u) | select(0u, 1u, r != 0)", "q << 6u"),
    canary("rn_sqrt", "soft_float", "(s << 6u) | select(0u, 1u, r != 0)", "s << 6u"),
    canary("rn_sqrt", "soft_float", "let above = r > bitcast<i32>(2u * s);", "let above = r >= bitcast<i32>(2u * s);"),
    canary("f_to_fix", "fixed_point", "select(0u, 1u, negative & lost)", "0u"),
    canary("fix_to_f", "fixed_point", "158 - bitcast<i32>(s)", "157 - bitcast<i32>(s)"),
    canary("u64_to_f", "fixed_point", "select(0u, 1u, n.x != 0u)", "0u"),
    canary("orient2d", "orientation", "return sgn64(sub64(l, r));", "return bitcast<i32>(l.y - r.y);"),
    canary("edge15", "raster", "(d.x > 0)", "(d.x >= 0)"),
    canary("edge15", "raster", "(d.y < 0)", "(d.y <= 0)"),
    canary("depth_at", "divide", "q += select(0u, 1u, up);\n    return", "return"),
    canary("influence_1d", "divide", "negative & (qr.y != 0u)", "negative"),
    canary("edge_line", "line", "neg64(c)", "vec2<u32>(0u - c.x, ~c.y)"),
    canary("half_plane", "line", "!line_flip(ln), zero)", "true, zero)"),
    canary("half_plane", "line", "(ln.b < 0));", "(ln.b <= 0));"),
    canary("line_cell", "line_cell", "select(0u, 1u, o.y != 0u)", "0u"),
    canary("line_cell", "line_cell", "(ln.b != 0)", "true"),
    canary("line_cell", "line_cell", "!ltu64(ac, shl64(vec2<u32>(n1, 0u), h))", "ltu64(shl64(vec2<u32>(n1, 0u), h), ac)"),
    canary("line_cell_fast", "line_cell", "(n1 == 0u) | (o", "(o"),
    canary("line_cell_fast", "line_cell", "1.00000762939453125", "0.9990234375"),
    canary("line_cell_fast", "line_cell", "1.00000762939453125", "1.0009765625"),
    canary("line_cell_fast", "line_cell", "one - 1u - min(p, one - 1u)", "one - min(p, one - 1u)"),
    canary("atan2_bam", "angle", "5u * n0 > 2u * d0", "5u * n0 >= 2u * d0"),
    canary("atan2_bam", "angle", "(umul_hi(p, q) + 2u) >> 2u", "umul_hi(p, q) >> 2u"),
    canary("atan2_bam", "angle", "(high.x << 15u) + low.x", "high.x << 15u"),
    canary("diamond_angle", "angle", "(0u - t) & 0x3fffffu", "0u - t"),
    canary("normalize3_q15", "direction", "- select(0u, 1u, above)", ""),
    canary("normalize3_q15", "direction", "let below = !ltu64(square", "let below = ltu64(square"),
    canary("oct_dir", "direction", "select(n - au, au - n, v < 0)", "select(n - au, au - n, u < 0)"),
];

/// Compiles the part of a function with one text edited.
fn edited(function: &str, file: &str, text: &str, instead: &str) -> Arc<Program> {
    let path = format!("shared/{file}.wgsl");
    let original = source(&path).unwrap_or_else(|| panic!("no {path}"));
    assert_eq!(original.matches(text).count(), 1, "{path} has `{text}` once");
    let edit = original.replace(text, instead);
    let sources = move |wanted: &str| if wanted == path { Some(edit.clone()) } else { source(wanted) };
    exact::compile(named(function).part, &sources).unwrap_or_else(|error| panic!("{function}, `{instead}`: {error}"))
}

#[test]
fn a_wrong_function_fails_its_self_test() {
    let backend = interpreter();
    let seen = |canary: &&Canary| {
        let &&Canary { function, file, text, instead } = canary;
        wrong(&backend, &edited(function, file, text, instead), named(function)) != (0, 0)
    };
    let unseen: Vec<&Canary> = CANARIES.iter().filter(|canary| !seen(canary)).collect();
    assert!(unseen.is_empty(), "the self-test does not see {unseen:#?}");
}

/// Function, file, guess, and n: the result stays exact where the guess is off by a factor of 1 + 2^-n or 1 - 2^-n.
/// What WGSL permits is 2^-21.6 for a division and 2^-22 for `inverseSqrt`.
#[rustfmt::skip]
static TOLERATED: &[(&str, &str, &str, u32)] = &[
    ("udiv64_32", "divide", "1.0 / f32(dn)", 18),
    ("fdiv64_sat", "divide", "1.0 / f32(dn)", 18),
    ("depth_at", "divide", "1.0 / f32(dn)", 18),
    ("influence_1d", "divide", "1.0 / f32(dn)", 18),
    ("ufrac", "fraction", "f32(n) / f32(d)", 21),
    ("diamond_angle", "fraction", "f32(n) / f32(d)", 21),
    ("line_cell", "fraction", "f32(n) / f32(d)", 16),
    ("atan2_bam", "fraction", "f32(n) / f32(d)", 16),
    ("isqrt32", "root", "f * inverseSqrt(f)", 17),
    ("isqrt64", "root", "f * inverseSqrt(f)", 17),
    ("isqrt64", "root", "let y = inverseSqrt(f)", 19),
    ("rn_div", "soft_float", "1.0 / f32(nb.x)", 19),
    ("rn_sqrt", "soft_float", "inverseSqrt(f)", 21),
    ("normalize3_q15", "direction", "inverseSqrt(f32(max(s, 1u)))", 16),
    ("line_cell_fast", "line_cell", "f32(one) / f32(max(n1, 1u))", 19),
];

#[test]
fn an_inaccurate_guess_changes_no_bit() {
    let backend = interpreter();
    for &(function, file, guess, n) in TOLERATED {
        let error = 1.0 / f64::from(1 << n);
        for factor in [1.0 + error, 1.0 - error] {
            let program = edited(function, file, guess, &format!("{guess} * {factor:.24}"));
            assert_eq!(wrong(&backend, &program, named(function)), (0, 0), "{function}: {guess} * {factor}");
        }
    }
}

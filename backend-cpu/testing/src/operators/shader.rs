//! The entry points around tested functions.

use std::fmt::Write;

use naga::ScalarKind;

use super::{Mode, Signature, Tested, kind_name};

/// Invocations of a workgroup of varying runs.
pub(crate) const WIDTH: usize = 64;

/// Functions of one entry point. Devices take a while for each pipeline, and much longer for a long one.
pub(crate) const FUNCTIONS: usize = 5;

/// Where a function's words begin.
#[derive(Clone, Copy)]
struct Place {
    operands: usize,
    results: usize,
}

/// Name of the entry point of the n-th [`FUNCTIONS`].
pub(crate) fn entry_name(n: usize) -> String {
    format!("test_entry_{n}")
}

/// Bindings and entry points.
pub(crate) fn entries(tested: &[Tested], mode: Mode) -> String {
    let mut text = String::from(
        "\n@group(0) @binding(0) var<storage, read> test_operands: array<u32>;\n\
         @group(0) @binding(1) var<storage, read_write> test_results: array<u32>;\n",
    );
    let width = if mode == Mode::Varying { WIDTH } else { 1 };
    let mut place = Place { operands: 0, results: 0 };
    for (n, chunk) in tested.chunks(FUNCTIONS).enumerate() {
        let name = entry_name(n);
        let _ = write!(
            text,
            "@compute @workgroup_size({width}) fn {name}(\n\
             @builtin(global_invocation_id) test_id: vec3<u32>, @builtin(workgroup_id) test_group: vec3<u32>) {{\n\
             switch test_group.y {{\n"
        );
        for (index, tested) in chunk.iter().enumerate() {
            let body = if mode == Mode::Varying { varying(tested, place) } else { listed(tested, mode, place) };
            let _ = write!(text, "case {index}u: {{\n{body}}}\n");
            place.operands += tested.runs.iter().map(|run| run.operands.len()).sum::<usize>();
            place.results += tested.result_words();
        }
        text.push_str("default: {}\n}\n}\n");
    }
    text
}

/// One call, its operands at the invocation's place.
fn varying(tested: &Tested, place: Place) -> String {
    let operands: usize = tested.parameters.iter().map(Signature::words).sum();
    let (count, results) = (tested.runs.len(), tested.result.words());
    let word = |at: usize| format!("test_operands[test_id.x * {operands}u + {}u]", place.operands + at);
    let call = call(tested, &word);
    let stores =
        stores(&tested.result, &|at| format!("test_results[test_id.x * {results}u + {}u]", place.results + at));
    format!("  if test_id.x < {count}u {{\n  let test_value = {call};\n{stores}  }}\n")
}

/// One call a run line, one after another.
fn listed(tested: &Tested, mode: Mode, place: Place) -> String {
    let (mut body, mut first) = (String::new(), place.operands);
    for (index, run) in tested.runs.iter().enumerate() {
        let word = |at: usize| match mode {
            Mode::Constant => format!("{:#x}u", run.operands[at]),
            _ => format!("test_operands[{}u]", first + at),
        };
        let results = place.results + index * tested.result.words();
        let stores = stores(&tested.result, &|at| format!("test_results[{}u]", results + at));
        let _ = write!(body, "  {{\n  let test_value = {};\n{stores}  }}\n", call(tested, &word));
        first += run.operands.len();
    }
    body
}

fn call(tested: &Tested, word: &dyn Fn(usize) -> String) -> String {
    let mut first = 0;
    let mut arguments = Vec::new();
    for parameter in &tested.parameters {
        let scalars: Vec<String> =
            (0..parameter.words()).map(|i| typed(parameter.scalar.kind, &word(first + i))).collect();
        first += parameter.words();
        arguments.push(format!("{}({})", type_name(parameter), scalars.join(", ")));
    }
    format!("{}({})", tested.name, arguments.join(", "))
}

/// A scalar of `kind` from a word. Non-finite literals are refused by WGSL, so they pass through a variable.
fn typed(kind: ScalarKind, word: &str) -> String {
    let bits = word.strip_suffix('u').and_then(|w| w.strip_prefix("0x")).and_then(|w| u32::from_str_radix(w, 16).ok());
    match (kind, bits) {
        (ScalarKind::Bool, _) => format!("({word} != 0u)"),
        (ScalarKind::Float, Some(bits)) if !f32::from_bits(bits).is_finite() => {
            format!("bitcast<f32>(select({word}, 0u, test_id.z == 0xffffffffu))")
        }
        _ => format!("bitcast<{}>({word})", kind_name(kind)),
    }
}

fn type_name(signature: &Signature) -> String {
    let scalar = kind_name(signature.scalar.kind);
    match (signature.columns, signature.rows) {
        (1, 1) => scalar.to_owned(),
        (1, n) => format!("vec{n}<{scalar}>"),
        (c, r) => format!("mat{c}x{r}<{scalar}>"),
    }
}

fn stores(result: &Signature, place: &dyn Fn(usize) -> String) -> String {
    let mut text = String::new();
    for at in 0..result.words() {
        let (column, row) = (at / result.rows, at % result.rows);
        let scalar = match (result.columns, result.rows) {
            (1, 1) => "test_value".to_owned(),
            (1, _) => format!("test_value[{row}]"),
            _ => format!("test_value[{column}][{row}]"),
        };
        let value = match result.scalar.kind {
            ScalarKind::Bool => format!("select(0u, 1u, {scalar})"),
            _ => format!("bitcast<u32>({scalar})"),
        };
        let _ = writeln!(text, "  {} = {value};", place(at));
    }
    text
}

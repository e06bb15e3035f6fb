//! Reads and runs the files of `tests/ops`.

mod coverage;
mod literal;
mod shader;

use std::path::Path;

use naga::{Handle, Module, Scalar, ScalarKind, Type, TypeInner};
use sightlines_backend::{Backend, Job, Linked, Program};

pub(crate) use coverage::coverage;
use literal::{Expected, literal, split};

/// How the operands of a run line reach the function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Mode {
    /// As literals: what the interpreter folds.
    Constant,
    /// Loaded from a constant index: the same in all invocations.
    Uniform,
    /// Loaded at the invocation's index, so that they differ.
    Varying,
}

impl Mode {
    pub(crate) const ALL: [Mode; 3] = [Mode::Constant, Mode::Uniform, Mode::Varying];
}

/// The WGSL type of a parameter or result, as its scalars.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Signature {
    pub scalar: Scalar,
    /// Columns and rows; 1 and n for a vector, 1 and 1 for a scalar.
    pub columns: usize,
    pub rows: usize,
}

impl Signature {
    pub(crate) fn words(&self) -> usize {
        self.columns * self.rows
    }
}

/// One function under test.
pub(crate) struct Tested {
    pub name: String,
    pub parameters: Vec<Signature>,
    pub result: Signature,
    pub runs: Vec<Run>,
}

/// One run line.
pub(crate) struct Run {
    pub line: usize,
    /// The words of all operands.
    pub operands: Vec<u32>,
    pub expected: Vec<Expected>,
}

pub(crate) struct File {
    path: String,
    text: String,
    module: Module,
    tested: Vec<Tested>,
}

impl File {
    pub(crate) fn read(path: &Path) -> Result<Self, String> {
        let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
        let path = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let module = naga::front::wgsl::parse_str(&text).map_err(|e| e.emit_to_string_with_path(&text, &path))?;
        let mut tested = Vec::new();
        for (_, function) in module.functions.iter() {
            let parameters = function.arguments.iter().map(|a| signature(&module, a.ty)).collect::<Result<_, _>>()?;
            let result = function.result.as_ref().ok_or("a tested function returns a value")?;
            let (name, result) = (function.name.clone().unwrap_or_default(), signature(&module, result.ty)?);
            tested.push(Tested { name, parameters, result, runs: Vec::new() });
        }
        for (index, line) in text.lines().enumerate() {
            let Some(run) = line.strip_prefix("// run: ") else { continue };
            parse_run(run, index + 1, &mut tested).map_err(|e| format!("{path}:{}: {e}", index + 1))?;
        }
        // A function that another one calls is reached through it.
        let called = |name: &str| text.matches(&format!("{name}(")).count() > 1;
        tested.retain(|t| !t.runs.is_empty() || !called(&t.name));
        match tested.iter().find(|t| t.runs.is_empty()) {
            Some(idle) => Err(format!("{path}: no run line for `{}`", idle.name)),
            None => Ok(File { path, text, module, tested }),
        }
    }

    /// Runs every line and reports those whose result differs.
    pub(crate) fn run(&self, mode: Mode, backend: &dyn Backend) -> Result<(), String> {
        let text = format!("{}{}", self.text, shader::entries(&self.tested, mode));
        let linked = Linked::single(&self.path, &text).map_err(|e| e.to_string())?;
        let program = Program::unlinted(&self.path, linked).map_err(|e| e.to_string())?;
        let mut job = Job::new();
        let id = job.program(&program);
        for tested in &self.tested {
            let operands: Vec<u32> = tested.runs.iter().flat_map(|r| r.operands.clone()).collect();
            let operands = job.upload("operands", if operands.is_empty() { &[0] } else { &operands });
            let results = job.buffer("results", (4 * tested.result.words() * tested.runs.len()) as u64);
            let groups = if mode == Mode::Varying { tested.runs.len().div_ceil(shader::WIDTH) as u32 } else { 1 };
            let bind: &[_] = if mode == Mode::Constant { &[(1, results)] } else { &[(0, operands), (1, results)] };
            job.dispatch(id, &format!("test_{}", tested.name), bind, [groups, 1, 1]);
            job.read(&tested.name, results);
        }
        let outputs = backend.run(&job).map_err(|e| e.to_string())?;
        let wrong: Vec<String> =
            self.tested.iter().zip(&outputs).flat_map(|(t, bytes)| self.compare(t, bytes)).collect();
        if wrong.is_empty() { Ok(()) } else { Err(wrong.join("\n")) }
    }

    fn compare(&self, tested: &Tested, bytes: &[u8]) -> Vec<String> {
        let words: Vec<u32> = bytes.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        let runs = tested.runs.iter().zip(words.chunks_exact(tested.result.words()));
        let wrong = runs.filter(|(run, got)| !run.expected.iter().zip(*got).all(|(e, &g)| e.accepts(g)));
        let shown = |(run, got): (&Run, &[u32])| {
            let hex = |words: &[u32]| words.iter().map(|w| format!("{w:#010x}")).collect::<Vec<_>>().join(" ");
            let expected = run.expected.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
            let (path, line, operands) = (&self.path, run.line, hex(&run.operands));
            format!("{path}:{line}: {}({operands}): expected {expected}, got {}", tested.name, hex(got))
        };
        wrong.map(shown).collect()
    }

    fn module(&self) -> &Module {
        &self.module
    }
}

fn signature(module: &Module, ty: Handle<Type>) -> Result<Signature, String> {
    match module.types[ty].inner {
        TypeInner::Scalar(scalar) => Ok(Signature { scalar, columns: 1, rows: 1 }),
        TypeInner::Vector { size, scalar } => Ok(Signature { scalar, columns: 1, rows: size as usize }),
        TypeInner::Matrix { columns, rows, scalar } => {
            Ok(Signature { scalar, columns: columns as usize, rows: rows as usize })
        }
        ref other => Err(format!("a tested function takes and returns scalars, vectors and matrices, not {other:?}")),
    }
}

/// `f(1u, 2u) == 3u`
fn parse_run(run: &str, line: usize, tested: &mut [Tested]) -> Result<(), String> {
    let (call, expected) = run.rsplit_once(" == ").ok_or("a run line reads `f(…) == …`")?;
    let (name, arguments) = call.strip_suffix(')').and_then(|c| c.split_once('(')).ok_or("no call")?;
    let tested = tested.iter_mut().find(|t| t.name == name).ok_or_else(|| format!("no function `{name}`"))?;
    let arguments = split(arguments);
    if arguments.len() != tested.parameters.len() {
        return Err(format!("{} arguments for {} parameters", arguments.len(), tested.parameters.len()));
    }
    let mut operands = Vec::new();
    for (argument, parameter) in arguments.iter().zip(&tested.parameters) {
        for word in literal(argument, parameter)? {
            operands.push(word.word().ok_or("an operand has exact bits")?);
        }
    }
    let expected = literal(expected, &tested.result)?;
    tested.runs.push(Run { line, operands, expected });
    Ok(())
}

fn kind_name(kind: ScalarKind) -> &'static str {
    match kind {
        ScalarKind::Sint => "i32",
        ScalarKind::Uint => "u32",
        ScalarKind::Float => "f32",
        _ => "bool",
    }
}

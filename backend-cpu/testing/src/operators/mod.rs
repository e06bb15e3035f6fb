//! Operators as files: those of `backend-cpu/tests/ops` are read, made jobs, and what comes back is judged, for every
//! machine that runs them.
//!
//! A file is one program, and several functions share an entry point, because devices compile slowly: workgroups with
//! `y = n` run its n-th function. Machines that merge workgroups do so along x, so operands that are loaded uniformly
//! stay uniform.

mod literal;
mod shader;

use std::path::Path;

use naga::{Handle, Module, Scalar, ScalarKind, Type, TypeInner};
use sightlines_backend::{Job, Linked, Program};

pub use literal::Expected;
use literal::{literal, split};

/// How the operands of a run line reach the function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// As literals: what the interpreter folds.
    Constant,
    /// Loaded from a constant index: the same in all invocations.
    Uniform,
    /// Loaded at the invocation's index, so that they differ.
    Varying,
}

impl Mode {
    /// All of them.
    pub const ALL: [Mode; 3] = [Mode::Constant, Mode::Uniform, Mode::Varying];

    /// The name that tests use.
    pub fn name(self) -> &'static str {
        match self {
            Mode::Constant => "constant",
            Mode::Uniform => "uniform",
            Mode::Varying => "varying",
        }
    }
}

/// The WGSL type of a parameter or result, as its scalars.
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// Type of a scalar.
    pub scalar: Scalar,
    /// Columns and rows; 1 and n for a vector, 1 and 1 for a scalar.
    pub columns: usize,
    /// See `columns`.
    pub rows: usize,
}

impl Signature {
    /// Number of scalars.
    pub fn words(&self) -> usize {
        self.columns * self.rows
    }
}

/// One function under test.
pub struct Tested {
    /// Its name.
    pub name: String,
    /// Types of its parameters.
    pub parameters: Vec<Signature>,
    /// Type of its result.
    pub result: Signature,
    /// Its run lines.
    pub runs: Vec<Run>,
}

impl Tested {
    fn result_words(&self) -> usize {
        self.result.words() * self.runs.len()
    }
}

/// One run line.
pub struct Run {
    /// Where it stands in the file.
    pub line: usize,
    /// The words of all operands.
    pub operands: Vec<u32>,
    /// What each word of the result must be.
    pub expected: Vec<Expected>,
}

impl Run {
    /// Whether the words are the expected ones, bit for bit.
    pub fn is_met_by(&self, words: &[u32]) -> bool {
        self.expected.iter().zip(words).all(|(expected, &word)| expected.accepts(word))
    }
}

/// One file.
pub struct File {
    path: String,
    text: String,
    module: Module,
    /// Its functions.
    pub tested: Vec<Tested>,
}

impl File {
    /// Reads a file. A function without a run line is an error.
    pub fn read(path: &Path) -> Result<Self, String> {
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

    /// The work: all run lines, and the words of all results as its one output.
    pub fn job(&self, mode: Mode) -> Result<Job, String> {
        let text = format!("{}{}", self.text, shader::entries(&self.tested, mode));
        let linked = Linked::single(&self.path, &text).map_err(|e| e.to_string())?;
        let program = Program::unlinted(&self.path, linked).map_err(|e| e.to_string())?;
        let mut job = Job::new();
        let id = job.program(&program);
        let operands: Vec<u32> =
            self.tested.iter().flat_map(|t| &t.runs).flat_map(|r| r.operands.iter().copied()).collect();
        let operands = job.upload("operands", &operands);
        let words: usize = self.tested.iter().map(Tested::result_words).sum();
        let results = job.buffer("results", 4 * words as u64);
        let bind: &[_] = if mode == Mode::Constant { &[(1, results)] } else { &[(0, operands), (1, results)] };
        for (n, chunk) in self.tested.chunks(shader::FUNCTIONS).enumerate() {
            let most = chunk.iter().map(|t| t.runs.len()).max().unwrap_or(0);
            let groups = if mode == Mode::Varying { most.div_ceil(shader::WIDTH) } else { 1 };
            job.dispatch(id, &shader::entry_name(n), bind, [groups as u32, chunk.len() as u32, 1]);
        }
        job.read("results", results);
        Ok(job)
    }

    /// For each function, the run lines whose result `accepts` refuses.
    pub fn judge(
        &self,
        results: &[u8],
        accepts: impl Fn(&Tested, &Run, &[u32]) -> bool,
    ) -> Vec<(&Tested, Vec<String>)> {
        let words: Vec<u32> = results.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect();
        let mut rest = words.as_slice();
        let judge = |tested| {
            let (own, after) = rest.split_at(Tested::result_words(tested));
            rest = after;
            (tested, self.refused(tested, own, &accepts))
        };
        self.tested.iter().map(judge).collect()
    }

    fn refused(&self, tested: &Tested, words: &[u32], accepts: &impl Fn(&Tested, &Run, &[u32]) -> bool) -> Vec<String> {
        let runs = tested.runs.iter().zip(words.chunks_exact(tested.result.words()));
        let wrong = runs.filter(|(run, got)| !accepts(tested, run, got));
        let shown = |(run, got): (&Run, &[u32])| {
            let hex = |words: &[u32]| words.iter().map(|w| format!("{w:#010x}")).collect::<Vec<_>>().join(" ");
            let expected = run.expected.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
            let (path, line, operands) = (&self.path, run.line, hex(&run.operands));
            format!("{path}:{line}: {}({operands}): expected {expected}, got {}", tested.name, hex(got))
        };
        wrong.map(shown).collect()
    }

    /// The module of the functions alone.
    pub fn module(&self) -> &Module {
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

/// A scalar's type as WGSL writes it.
pub fn kind_name(kind: ScalarKind) -> &'static str {
    match kind {
        ScalarKind::Sint => "i32",
        ScalarKind::Uint => "u32",
        ScalarKind::Float => "f32",
        _ => "bool",
    }
}

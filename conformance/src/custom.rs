//! Anyone's kernel as a case: a WGSL file and a TOML file that says how to run it.
//!
//! ```toml
//! entry = "main"
//! groups = [1, 1, 1]
//! seed = 7                 # of `random` buffers that name none
//!
//! [overrides]              # values of `override` declarations
//! width = 16
//!
//! [[buffer]]
//! name = "input"           # the variable in the WGSL
//! words = [1, 0xff, -1, 1.5]
//!
//! [[buffer]]
//! name = "output"
//! zeros = 4                # or: random = 4, or: file = "data.bin"
//! read = true
//! expected = [2, 0, 2, 3]  # optional
//! ```
//!
//! What is wrong with either file is said with file, line and remedy. The WGSL is not held to the portability lints.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use serde::Deserialize;
use sightlines_backend::{
    Case, Command, Dispatch, Expected, Groups, Job, Linked, Program, ProgramId, Size, Slot, check,
};
use toml::Spanned;

use crate::diff;
use crate::error::{Error, Result};
use crate::plan::{Selected, Stored};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    entry: Spanned<String>,
    #[serde(default = "one_group")]
    groups: [u32; 3],
    seed: Option<u64>,
    #[serde(default)]
    overrides: BTreeMap<String, f64>,
    #[serde(default)]
    buffer: Vec<Spanned<Buffer>>,
}

fn one_group() -> [u32; 3] {
    [1, 1, 1]
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Buffer {
    name: Spanned<String>,
    words: Option<Vec<Spanned<Word>>>,
    zeros: Option<usize>,
    random: Option<usize>,
    seed: Option<u64>,
    file: Option<Spanned<String>>,
    #[serde(default)]
    read: bool,
    expected: Option<Vec<Spanned<Word>>>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(untagged)]
enum Word {
    Integer(i64),
    Float(f64),
}

/// A message about a place in the TOML file.
struct Source<'a> {
    path: &'a Path,
    text: &'a str,
}

impl Source<'_> {
    fn error(&self, span: Range<usize>, what: &str, remedy: &str) -> Error {
        let line = self.text.get(..span.start).unwrap_or("").matches('\n').count() + 1;
        Error::Usage(format!("{}:{line}: {what}\n  remedy: {remedy}", self.path.display()))
    }

    fn words(&self, words: &[Spanned<Word>]) -> Result<Vec<u32>> {
        let word = |word: &Spanned<Word>| match *word.get_ref() {
            Word::Integer(i) => u32::try_from(i).ok().or_else(|| i32::try_from(i).ok().map(|i| i as u32)),
            Word::Float(f) => Some((f as f32).to_bits()),
        };
        let checked = words.iter().map(|w| {
            word(w).ok_or_else(|| {
                self.error(w.span(), "this number has no 32-bit word", "use -2147483648 to 4294967295, or a float")
            })
        });
        checked.collect()
    }

    fn bytes(&self, buffer: &Spanned<Buffer>, seed: u64) -> Result<Vec<u8>> {
        let (span, buffer) = (buffer.span(), buffer.get_ref());
        let given = [buffer.words.is_some(), buffer.zeros.is_some(), buffer.random.is_some(), buffer.file.is_some()];
        if given.iter().filter(|g| **g).count() != 1 {
            let remedy = "give exactly one of `words = […]`, `zeros = N`, `random = N` or `file = \"…\"`";
            return Err(self.error(span, "the buffer's contents are not clear", remedy));
        }
        if let Some(file) = &buffer.file {
            return self.file(file);
        }
        let limit = STORAGE_LIMIT / 4;
        let length = buffer.zeros.or(buffer.random).unwrap_or(0);
        if length > limit {
            let what = format!("{length} words are more than a storage binding holds");
            return Err(self.error(span, &what, &format!("use at most {limit} words")));
        }
        let words = match (&buffer.words, buffer.random) {
            (Some(words), _) => self.words(words)?,
            (_, Some(length)) => random(buffer.seed.unwrap_or(seed)).take(length).collect(),
            _ => vec![0; length],
        };
        Ok(words.iter().flat_map(|w| w.to_le_bytes()).collect())
    }

    fn file(&self, file: &Spanned<String>) -> Result<Vec<u8>> {
        let path = self.path.parent().unwrap_or(Path::new(".")).join(file.get_ref());
        let bytes = std::fs::read(&path).map_err(|e| {
            self.error(file.span(), &format!("{}: {e}", path.display()), "paths are relative to this file's folder")
        })?;
        if bytes.len() % 4 != 0 {
            let what = format!("{} has {} bytes, not a whole number of words", path.display(), bytes.len());
            return Err(self.error(file.span(), &what, "pad the file to a multiple of 4 bytes"));
        }
        Ok(bytes)
    }
}

/// WebGPU's default limit of a storage binding, in bytes.
const STORAGE_LIMIT: usize = 128 << 20;

/// splitmix64, upper half.
fn random(seed: u64) -> impl Iterator<Item = u32> {
    let mut state = seed;
    std::iter::repeat_with(move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 32) as u32
    })
}

/// Reads both files and makes a case of them.
pub fn load(wgsl: &Path, toml: &Path, seed: u64) -> Result<Selected> {
    let program = compile(wgsl)?;
    let text = std::fs::read_to_string(toml).map_err(|e| Error::read(toml, e))?;
    let source = Source { path: toml, text: &text };
    let file: File = toml::from_str(&text).map_err(|e| {
        let remedy = "docs/testing.md shows the format, under `Your own kernel`";
        source.error(e.span().unwrap_or(0..0), e.message(), remedy)
    })?;
    let (job, expected) = build(&source, &program, &file, file.seed.unwrap_or(seed))?;
    check::job(&job).map_err(|e| Error::Usage(format!("{}: {e}", toml.display())))?;
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let has_oracle = expected.iter().any(Option::is_some);
    let oracle = move |outputs: &Vec<Vec<u8>>| {
        let answers = outputs.iter().zip(&expected);
        let answers = answers.map(|(o, e)| e.clone().unwrap_or_else(|| diff::words(o).collect()));
        answers.map(Expected::Whole).collect()
    };
    let case = Case::new(stem(toml), Size::Small, move || Ok(job.clone()), oracle);
    Ok(Selected { kernel: stem(wgsl), case, has_oracle, stored: Stored::Never })
}

fn compile(wgsl: &Path) -> Result<Arc<Program>> {
    let text = std::fs::read_to_string(wgsl).map_err(|e| Error::read(wgsl, e))?;
    let folder = wgsl.parent().unwrap_or(Path::new(".")).to_owned();
    let root = wgsl.display().to_string();
    let own = root.clone();
    let sources = move |path: &str| {
        if path == own { Some(text.clone()) } else { std::fs::read_to_string(folder.join(path)).ok() }
    };
    let linked = Linked::link(&root, &sources, &[])?;
    Ok(Program::unlinted(&wgsl.file_stem().unwrap_or_default().to_string_lossy(), linked)?)
}

fn build(source: &Source, program: &Arc<Program>, file: &File, seed: u64) -> Result<(Job, Vec<Option<Vec<u32>>>)> {
    let Some(entry) = program.entry(file.entry.get_ref()) else {
        let names: Vec<&str> = program.entries().iter().map(|e| e.name.as_str()).collect();
        let what = format!("the WGSL has no entry point `{}`", file.entry.get_ref());
        return Err(source.error(file.entry.span(), &what, &format!("it has: {}", names.join(", "))));
    };
    let mut job = Job::new();
    let id: ProgramId = job.program(program);
    let (mut slots, mut reads, mut expected) = (Vec::new(), Vec::new(), Vec::new());
    for buffer in &file.buffer {
        let name = &buffer.get_ref().name;
        let used = entry.bindings.iter().map(|&i| &program.bindings()[i]);
        let Some(binding) = used.clone().find(|b| b.name == *name.get_ref()) else {
            let names: Vec<&str> = used.map(|b| b.name.as_str()).collect();
            let what = format!("`{}` is no buffer that `{}` uses", name.get_ref(), entry.name);
            return Err(source.error(name.span(), &what, &format!("it uses: {}", names.join(", "))));
        };
        let bytes = source.bytes(buffer, seed)?;
        let handle = job.upload(name.get_ref().as_str(), &bytes);
        let size = bytes.len() as u64;
        slots.push(Slot { group: binding.group, binding: binding.binding, buffer: handle, offset: 0, size });
        if buffer.get_ref().read {
            reads.push(handle);
            expected.push(buffer.get_ref().expected.as_ref().map(|w| source.words(w)).transpose()?);
        } else if buffer.get_ref().expected.is_some() {
            let what = format!("`{}` has `expected` words and is not read", name.get_ref());
            return Err(source.error(name.span(), &what, "add `read = true`"));
        }
    }
    let bound = |b: &sightlines_backend::Binding| slots.iter().any(|s| (s.group, s.binding) == (b.group, b.binding));
    if let Some(missing) = entry.bindings.iter().map(|&i| &program.bindings()[i]).find(|b| !bound(b)) {
        let what = format!("no buffer is given for `{}`, which `{}` uses", missing.name, entry.name);
        let remedy = format!("add a `[[buffer]]` with `name = \"{}\"`", missing.name);
        return Err(source.error(file.entry.span(), &what, &remedy));
    }
    if reads.is_empty() {
        return Err(source.error(file.entry.span(), "nothing is read back", "add `read = true` to a `[[buffer]]`"));
    }
    let overrides = file.overrides.iter().map(|(name, value)| (name.clone(), *value)).collect();
    let (entry, groups) = (entry.name.clone(), Groups::Direct(file.groups));
    job.record(Command::Dispatch(Dispatch { program: id, entry, overrides, slots, groups }));
    for read in reads {
        let label = job.buffers[read.0 as usize].label.clone();
        job.read(label, read);
    }
    Ok((job, expected))
}

//! Programs as files: WGSL modules whose comments say what to run and what must come out.
//!
//! ```text
//! //! buffer 0: u32 1 2 3          a buffer at @group(0) @binding(0) with these words
//! //! buffer 1: zero 16            16 words of zero
//! //! override: N = 4              for the dispatches that follow
//! //! dispatch: main 2 1 1         entry point and workgroups
//! //! indirect: main 0 16          entry point, buffer and byte offset of the workgroup counts
//! //! expect 1: i32 3 -4 5 0*13    the buffer's words after all dispatches; v*n is n times v
//! //! counts: 64 2 1 12 0 0        semantic costs: invocations, loads, stores, bytes, atomics, barriers
//! //! trap: 12 out of bounds       with bounds that trap, line 12 must trap with a message that contains this text
//! //! fails: non-uniform           every machine must refuse with a message that contains this text
//! ```
//!
//! Invariant: a file that expects nothing is a failure.

use std::collections::BTreeMap;

use sightlines_backend::{Backend, BufferId, Command, Dispatch, Groups, Job, Linked, Outputs, Program};

use crate::engines::Engine;

/// Words of each buffer, by binding.
pub type Buffers = BTreeMap<u32, Vec<u32>>;

/// Semantic costs, from machines that count.
type Costs = Option<[u64; 6]>;

/// What a run leaves, with its costs.
pub type Outcome = (Buffers, Costs);

/// What a file says.
pub struct Script {
    path: String,
    text: String,
    buffers: Buffers,
    dispatches: Vec<Launch>,
    expected: Buffers,
    /// Line and text of the message.
    trap: Option<(u32, String)>,
    fails: Option<String>,
    /// Semantic costs: invocations, loads, stores, bytes, atomics, barriers.
    counts: Option<[u64; 6]>,
}

struct Launch {
    entry: String,
    overrides: Vec<(String, f64)>,
    groups: Count,
}

enum Count {
    Direct([u32; 3]),
    /// Binding and byte offset.
    Indirect(u32, u64),
}

impl Script {
    /// Reads a file; `path` is what its messages call it.
    pub fn parse(path: &str, text: String) -> Result<Self, String> {
        let mut script = Script {
            path: path.to_owned(),
            text: String::new(),
            buffers: BTreeMap::new(),
            dispatches: Vec::new(),
            expected: BTreeMap::new(),
            trap: None,
            fails: None,
            counts: None,
        };
        let mut overrides = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let Some(directive) = line.strip_prefix("//! ") else { continue };
            script
                .directive(directive, &mut overrides)
                .ok_or_else(|| format!("{path}:{}: cannot read `{directive}`", index + 1))?;
        }
        script.text = text;
        Ok(script)
    }

    fn directive(&mut self, directive: &str, overrides: &mut Vec<(String, f64)>) -> Option<()> {
        let (head, rest) = directive.split_once(": ")?;
        match head.split_once(' ').unwrap_or((head, "")) {
            ("buffer", binding) => {
                self.buffers.insert(binding.parse().ok()?, words(rest)?);
            }
            ("expect", binding) => {
                self.expected.insert(binding.parse().ok()?, words(rest)?);
            }
            ("override", _) => {
                let (name, value) = rest.split_once(" = ")?;
                overrides.retain(|(n, _)| n != name);
                overrides.push((name.to_owned(), value.parse().ok()?));
            }
            ("dispatch", _) => {
                let mut parts = rest.split_whitespace();
                let entry = parts.next()?.to_owned();
                let groups: Vec<u32> = parts.map(|p| p.parse().ok()).collect::<Option<_>>()?;
                let groups = Count::Direct(groups.try_into().ok()?);
                self.dispatches.push(Launch { entry, overrides: overrides.clone(), groups });
            }
            ("indirect", _) => {
                let [entry, binding, offset] = rest.split_whitespace().collect::<Vec<_>>().try_into().ok()?;
                let groups = Count::Indirect(binding.parse().ok()?, offset.parse().ok()?);
                self.dispatches.push(Launch { entry: entry.to_owned(), overrides: overrides.clone(), groups });
            }
            ("trap", _) => {
                let (line, message) = rest.split_once(' ')?;
                self.trap = Some((line.parse().ok()?, message.to_owned()));
            }
            ("counts", _) => {
                let counts: Vec<u64> = rest.split_whitespace().map(|c| c.parse().ok()).collect::<Option<_>>()?;
                self.counts = Some(counts.try_into().ok()?);
            }
            ("fails", _) => self.fails = Some(rest.to_owned()),
            _ => return None,
        }
        Some(())
    }

    /// Runs everything on one machine and compares.
    pub fn run(&self, engine: &Engine) -> Result<(), String> {
        self.judge(&self.execute(engine.backend.as_ref()), engine.traps)
    }

    /// Whether a dynamic error is what the file is about: WGSL lets machines answer it in different ways.
    pub fn errs(&self) -> bool {
        self.trap.is_some() || self.fails.is_some()
    }

    /// Compares what a run left, or how it failed, with what the file says. `traps` tells that the machine stops at an
    /// access out of bounds.
    pub fn judge(&self, result: &Result<Outcome, String>, traps: bool) -> Result<(), String> {
        let silent = self.expected.is_empty() && !self.errs();
        if silent || self.dispatches.is_empty() {
            return Err(format!("{}: runs or expects nothing", self.path));
        }
        if let Some(wanted) = &self.fails {
            return refusal(result, wanted);
        }
        if let Some((line, message)) = self.trap.as_ref().filter(|_| traps) {
            let place = format!("{}:{line}:", self.path);
            return refusal(result, message).and(refusal(result, &place));
        }
        let (outputs, counts) = result.as_ref()?;
        if let (Some(expected), Some(got)) = (self.counts, counts)
            && expected != *got
        {
            return Err(format!("{}: counts differ: expected {expected:?}, got {got:?}", self.path));
        }
        for (binding, expected) in &self.expected {
            let got = outputs.get(binding).ok_or_else(|| format!("{}: no buffer {binding}", self.path))?;
            compare(&self.path, *binding, expected, got)?;
        }
        Ok(())
    }

    /// All buffers as they are after the run, and the costs from machines that count.
    pub fn execute(&self, backend: &dyn Backend) -> Result<Outcome, String> {
        let job = self.job()?;
        let (outputs, counts) = run_job(&job, backend).map_err(|e| e.to_string())?;
        Ok((self.words(&outputs), counts))
    }

    /// The outputs of [`Script::job`] by binding.
    pub fn words(&self, outputs: &Outputs) -> Buffers {
        self.buffers.keys().copied().zip(outputs.iter().map(|bytes| to_words(bytes))).collect()
    }

    /// The work as a checked job, which reads every buffer.
    pub fn job(&self) -> Result<Job, String> {
        let linked = Linked::single(&self.path, &self.text).map_err(|e| e.to_string())?;
        let program = Program::unlinted(&self.path, linked).map_err(|e| e.to_string())?;
        let mut job = Job::new();
        let id = job.program(&program);
        let upload = |(&binding, words): (&u32, &Vec<u32>)| (binding, job.upload(format!("{binding}"), words));
        let buffers: BTreeMap<u32, BufferId> = self.buffers.iter().map(upload).collect();
        for launch in &self.dispatches {
            let entry = program.entry(&launch.entry).ok_or_else(|| format!("no entry point {}", launch.entry))?;
            let used = entry.bindings.iter().map(|&b| &program.bindings()[b]);
            let slot = |binding: u32| buffers.get(&binding).map(|&buffer| job.slot(binding, buffer));
            let slots = used.map(|b| slot(b.binding).ok_or_else(|| format!("no buffer {}", b.binding)));
            let slots = slots.collect::<Result<_, _>>()?;
            let groups = match launch.groups {
                Count::Direct(groups) => Groups::Direct(groups),
                Count::Indirect(binding, offset) => Groups::Indirect { buffer: buffers[&binding], offset },
            };
            let (entry, overrides) = (launch.entry.clone(), launch.overrides.clone());
            job.record(Command::Dispatch(Dispatch { program: id, entry, overrides, slots, groups }));
        }
        for (binding, &buffer) in &buffers {
            job.read(format!("{binding}"), buffer);
        }
        sightlines_backend::check::job(&job).map_err(|e| e.to_string())?;
        Ok(job)
    }
}

fn run_job(job: &Job, backend: &dyn Backend) -> sightlines_backend::Result<(Outputs, Costs)> {
    let mut session = backend.open(&job.programs, &job.buffers)?;
    for recording in &job.recordings {
        session.submit(recording)?;
    }
    let outputs = job.reads.iter().map(|read| session.read(read)).collect::<Result<_, _>>()?;
    let counts = session.counts().map(|c| [c.invocations, c.loads, c.stores, c.bytes, c.atomics, c.barriers]);
    Ok((outputs, counts))
}

fn to_words(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect()
}

fn refusal(result: &Result<Outcome, String>, wanted: &str) -> Result<(), String> {
    match result {
        Ok(_) => Err(format!("ran, but must fail with `{wanted}`")),
        Err(message) if message.contains(wanted) => Ok(()),
        Err(message) => Err(format!("must fail with `{wanted}`, but said: {message}")),
    }
}

fn compare(path: &str, binding: u32, expected: &[u32], got: &[u32]) -> Result<(), String> {
    if expected == got {
        return Ok(());
    }
    let first = expected.iter().zip(got).position(|(e, g)| e != g).unwrap_or(expected.len().min(got.len()));
    let differing = expected.iter().zip(got).filter(|(e, g)| e != g).count();
    let at = |words: &[u32]| words.get(first).map_or("nothing".into(), |w| format!("{w:#010x} ({w})"));
    Err(format!(
        "{path}: buffer {binding} differs in {differing} of {} words; first at {first}: expected {}, got {}\n\
         expected {expected:x?}\ngot      {got:x?}",
        expected.len(),
        at(expected),
        at(got)
    ))
}

/// `u32 1 2 0x3`, `i32 -1`, `f32 1.5`, `zero 16`; `v*n` repeats.
fn words(text: &str) -> Option<Vec<u32>> {
    let mut parts = text.split_whitespace();
    let kind = parts.next()?;
    if kind == "zero" {
        return Some(vec![0; parts.next()?.parse().ok()?]);
    }
    let mut words = Vec::new();
    for part in parts {
        let (value, times) = part.split_once('*').unwrap_or((part, "1"));
        let word = match (kind, value.strip_prefix("0x")) {
            ("f32", None) => value.parse::<f32>().ok()?.to_bits(),
            (_, Some(hex)) => u32::from_str_radix(hex, 16).ok()?,
            ("i32", _) => value.parse::<i32>().ok()? as u32,
            ("u32", _) => value.parse().ok()?,
            _ => return None,
        };
        words.extend(std::iter::repeat_n(word, times.parse().ok()?));
    }
    Some(words)
}

//! One small, readable snapshot a case: `snapshots/<kernel>/<case>.snap`, in insta's format.
//!
//! It holds the shapes of the work, and for each output a digest, the range and some words; then the semantic costs. It
//! is rendered from the interpreter's run alone, read by every machine, and written only through insta in a process of
//! its own, whose environment says that it may write.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::{Deserialize, Serialize};
use sightlines_backend::{CONTRACT_VERSION, Command as Step, Dispatch, Groups, Job};

use crate::diff::{Row, Table, word_at, words};
use crate::error::{Error, Result};
use crate::files;
use crate::protocol::Costs;

const SHOWN_DISPATCHES: usize = 16;
const COSTS: &str = "costs\n";

/// The folder of the stored snapshots.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots")
}

/// Path of a case's snapshot.
pub fn path(folder: &Path, kernel: &str, case: &str) -> PathBuf {
    folder.join(kernel).join(format!("{case}.snap"))
}

/// What a snapshot says about a run; without costs for machines that do not count.
pub fn render<O: AsRef<[u8]>>(
    name: (&str, &str),
    job: &Job,
    outputs: &[O],
    probes: &[u32],
    costs: Option<&Costs>,
) -> String {
    let mut text = format!("contract {CONTRACT_VERSION}\nkernel {}\ncase {}\n", name.0, name.1);
    render_work(&mut text, job);
    for (read, output) in job.reads.iter().zip(outputs) {
        render_output(&mut text, &read.name, output.as_ref(), probes);
    }
    if let Some(costs) = costs {
        let Costs { invocations, loads, stores, bytes, atomics, barriers, .. } = costs;
        let _ = write!(
            text,
            "{COSTS}  invocations {invocations}\n  loads {loads}\n  stores {stores}\n  bytes {bytes}\n  atomics {atomics}\n  barriers {barriers}\n"
        );
    }
    text
}

fn render_work(text: &mut String, job: &Job) {
    let steps = job.recordings.iter().flat_map(|r| &r.commands);
    let dispatches = steps.filter_map(|step| if let Step::Dispatch(d) = step { Some(d) } else { None });
    let mut lines: Vec<(String, u64)> = Vec::new();
    for dispatch in dispatches {
        let line = render_dispatch(job, dispatch);
        match lines.last_mut() {
            Some((last, count)) if *last == line => *count += 1,
            _ => lines.push((line, 1)),
        }
    }
    let _ = writeln!(text, "recordings {}", job.recordings.len());
    for (line, count) in lines.iter().take(SHOWN_DISPATCHES) {
        let times = if *count > 1 { format!(", {count} times") } else { String::new() };
        let _ = writeln!(text, "dispatch {line}{times}");
    }
    if lines.len() > SHOWN_DISPATCHES {
        let _ = writeln!(text, "… {} more", lines.len() - SHOWN_DISPATCHES);
    }
}

fn render_dispatch(job: &Job, dispatch: &Dispatch) -> String {
    let program = job.programs.get(dispatch.program.0 as usize);
    let entry = program.and_then(|p| p.entry(&dispatch.entry));
    let by = |[x, y, z]: [u32; 3]| format!("{x}x{y}x{z}");
    let size = entry.map_or_else(String::new, |e| format!(" of {}", by(e.workgroup_size)));
    let groups = match &dispatch.groups {
        Groups::Direct(groups) => format!("{} groups", by(*groups)),
        Groups::Indirect { .. } => "indirect groups".into(),
    };
    let mut line = format!("{} {}: {groups}{size}", program.map_or("?", |p| p.label()), dispatch.entry);
    for (name, value) in &dispatch.overrides {
        let _ = write!(line, ", {name} = {value}");
    }
    line
}

fn render_output(text: &mut String, name: &str, bytes: &[u8], probes: &[u32]) {
    let count = bytes.len() / 4;
    let (mut low, mut high, mut zeros) = (u32::MAX, 0, 0u64);
    for word in words(bytes) {
        (low, high) = (low.min(word), high.max(word));
        zeros += u64::from(word == 0);
    }
    let _ = writeln!(text, "output {name}: {count} words");
    let _ = writeln!(text, "  blake3 {}", blake3::hash(bytes).to_hex());
    if count > 0 {
        let _ = writeln!(text, "  min {low:#010x}, max {high:#010x}, {zeros} zero");
    }
    let usual = [0, 1, 2, 3, count as u32 / 2, (count as u32).saturating_sub(1)];
    let shown: BTreeSet<u32> = if probes.is_empty() { usual.into() } else { probes.iter().copied().collect() };
    for index in shown {
        if let Some(word) = word_at(bytes, u64::from(index)) {
            let _ = writeln!(text, "  [{index}] {word:#010x}");
        }
    }
}

/// The stored snapshot's text, read by insta; `None` where there is none.
pub fn read(path: &Path) -> Result<Option<String>> {
    if !path.exists() {
        return Ok(None);
    }
    let broken = |why: String| Error::read(path, std::io::Error::other(why));
    let snapshot = insta::Snapshot::from_file(path).map_err(|e| broken(e.to_string()))?;
    let text = snapshot.as_text().ok_or_else(|| broken("not a text snapshot".into()))?;
    Ok(Some(normal(&text.to_string())))
}

/// Text as insta compares it: without blank lines around it.
fn normal(text: &str) -> String {
    format!("{}\n", text.trim_matches('\n').trim_end())
}

/// A snapshot's text without the part that only the interpreter can give.
pub fn without_costs(text: &str) -> &str {
    text.find(COSTS).map_or(text, |at| &text[..at])
}

/// What differs between the stored text and the text of a run: words as words, everything else as lines.
pub fn compare(stored: &str, run: &str) -> Option<Table> {
    let (stored, run) = (normal(stored), normal(run));
    if stored == run {
        return None;
    }
    let (stored, run) = (keyed(&stored), keyed(&run));
    let mut table = Table::default();
    let keys = stored.iter().chain(run.iter().filter(|(k, _)| !stored.iter().any(|(s, _)| s == k)));
    for (key, _) in keys {
        let find = |lines: &[(Key, String)]| lines.iter().find(|(k, _)| k == key).map(|(_, v)| v.clone());
        let (expected, got) = (find(&stored), find(&run));
        if expected != got {
            let none = || "(no line)".to_owned();
            table.push(|| row(key, expected.unwrap_or_else(none), got.unwrap_or_else(none)));
        }
    }
    table.some()
}

fn row((section, item): &Key, expected: String, got: String) -> Row {
    let index = item.trim_start_matches('[').trim_end_matches(']');
    let word = |text: &str| u32::from_str_radix(text.strip_prefix("0x")?, 16).ok();
    match (index.parse(), word(&expected), word(&got)) {
        (Ok(index), Some(expected), Some(got)) => Row::word(section, index, expected, got),
        _ => Row::text(section, index, expected, got),
    }
}

type Key = (String, String);

/// Lines as (section, first word) and the rest. A line that repeats gets a number.
fn keyed(text: &str) -> Vec<(Key, String)> {
    let mut lines: Vec<(Key, String)> = Vec::new();
    let mut section = "(work)".to_owned();
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("output ").and_then(|l| l.split_once(':')).map(|(n, _)| n) {
            section = name.to_owned();
        } else if line == COSTS.trim_end() {
            section = "(costs)".to_owned();
        }
        let (first, rest) = line.trim_start().split_once(' ').unwrap_or((line, ""));
        let twins = lines.iter().filter(|((s, i), _)| *s == section && i.split('#').next() == Some(first)).count();
        let item = if twins > 0 { format!("{first}#{}", twins + 1) } else { first.to_owned() };
        lines.push(((section.clone(), item), rest.to_owned()));
    }
    lines
}

/// Stored snapshots that belong to none of the cases.
pub fn orphans(folder: &Path, known: &BTreeSet<PathBuf>) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        let entries = match fs::read_dir(&folder) {
            Ok(entries) => entries,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => continue,
            Err(e) => return Err(Error::read(&folder, e)),
        };
        for entry in entries {
            let path = entry.map_err(|e| Error::read(&folder, e))?.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "snap") && !known.contains(&path) {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// One snapshot to be written.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Writing {
    /// The file.
    pub path: PathBuf,
    /// Its text.
    pub text: String,
}

/// Writes snapshots through insta, in a child process whose environment allows it.
pub fn write(exe: &Path, writings: &[Writing]) -> Result<()> {
    let fail = |why: String| Error::Worker(format!("writing snapshots: {why}"));
    let mut child = Command::new(exe)
        .arg("write-snapshots")
        .env("INSTA_UPDATE", "always")
        .env("INSTA_OUTPUT", "none")
        .env("INSTA_FORCE_PASS", "1")
        .env("INSTA_WORKSPACE_ROOT", files::workspace())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| fail(e.to_string()))?;
    let bytes = serde_json::to_vec(writings).map_err(|e| fail(e.to_string()))?;
    let piped = child.stdin.take().map(|mut input| input.write_all(&bytes));
    let output = child.wait_with_output().map_err(|e| fail(e.to_string()))?;
    if !output.status.success() || !matches!(piped, Some(Ok(()))) {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(fail(format!("{}: {}", output.status, said.trim())));
    }
    for writing in writings {
        if read(&writing.path)?.as_deref() != Some(normal(&writing.text).as_str()) {
            return Err(Error::write(&writing.path, std::io::Error::other("the snapshot was not written")));
        }
    }
    Ok(())
}

/// The child's side of [`write()`]: reads the list from standard input.
pub fn write_here(list: impl std::io::Read) -> Result<()> {
    let writings: Vec<Writing> =
        serde_json::from_reader(list).map_err(|e| Error::Worker(format!("not a list of snapshots: {e}")))?;
    for writing in &writings {
        assert(&writing.path, &writing.text);
    }
    Ok(())
}

/// Asserts a snapshot by insta, with insta's own rules about what may be written.
pub fn assert(path: &Path, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(path.parent().unwrap_or(Path::new(".")));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    settings.bind(|| insta::assert_snapshot!(name.as_ref(), text));
}

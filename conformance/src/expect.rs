//! Failures that are known: one sorted file, each entry with its reason.
//!
//! An entry turns a failure into an expected failure, and a pass into a failure: what has been repaired must leave the
//! file. Entries name machines and cases with `*` for any run of characters. Names that match nothing known, entries
//! without a reason and entries out of order are failures of the suite.

use std::path::Path;

use serde::Deserialize;

use crate::error::{Error, Result};
use crate::result::{CaseResult, Check, Status};

/// One known failure.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expectation {
    /// Machine: `cpu`, `wgpu:*`, `wgpu:SwiftShader*`.
    pub backend: String,
    /// Case: `kernel::case`.
    pub test: String,
    /// Why it fails, and what would have to happen for it to pass.
    #[serde(default)]
    pub reason: String,
}

/// All known failures.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expectations {
    /// The entries, sorted.
    #[serde(default)]
    pub expect: Vec<Expectation>,
}

/// The expectations of this workspace.
pub fn file() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("expectations.toml")
}

impl Expectations {
    /// Reads a file; a missing file is an empty one.
    pub fn read(path: &Path) -> Result<Self> {
        match std::fs::read_to_string(path) {
            Ok(text) => toml::from_str(&text).map_err(|e| Error::Usage(format!("{}: {e}", path.display()))),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(Self::default()),
            Err(e) => Err(Error::read(path, e)),
        }
    }

    /// What is wrong with the file itself, given the names of all cases (`kernel::case`).
    pub fn faults(&self, known: &[String]) -> Vec<String> {
        let mut faults = Vec::new();
        for entry in &self.expect {
            let name = format!("{} on {}", entry.test, entry.backend);
            if entry.reason.trim().is_empty() {
                faults.push(format!("{name}: no reason is given"));
            }
            if entry.backend != "*" && entry.backend != "cpu" && !entry.backend.starts_with("wgpu") {
                faults.push(format!("{name}: no such backend; it is `cpu`, or `wgpu:` and a name"));
            }
            if !known.iter().any(|k| fits(&entry.test, k)) {
                faults.push(format!("{name}: no case has this name"));
            }
        }
        for pair in self.expect.windows(2).filter(|p| (&p[0].test, &p[0].backend) >= (&p[1].test, &p[1].backend)) {
            let [a, b] = pair else { continue };
            faults.push(format!("{} on {} must stand after {} on {}", a.test, a.backend, b.test, b.backend));
        }
        faults
    }

    /// Turns the status of a result into what was expected of it.
    pub fn apply(&self, result: &mut CaseResult) {
        let name = format!("{}::{}", result.kernel, result.case);
        let entry = self.expect.iter().find(|e| fits(&e.test, &name) && fits(&e.backend, &result.machine));
        let Some(entry) = entry else { return };
        match result.status {
            Status::Pass => {
                result.status = Status::UnexpectedPass;
                result.check = Some(Check::Expectation);
                result.message = format!("passes, but is expected to fail: {}; remedy: remove the entry", entry.reason);
            }
            Status::Fail | Status::Trap | Status::Timeout => {
                result.status = Status::ExpectedFail;
                result.message = format!("{} ({})", entry.reason, result.message);
            }
            Status::Skip | Status::ExpectedFail | Status::UnexpectedPass => {}
        }
    }
}

/// Whether a pattern with `*` for any run of characters is the whole of a name.
fn fits(pattern: &str, name: &str) -> bool {
    match pattern.split_once('*') {
        None => pattern == name,
        Some((head, rest)) => name.strip_prefix(head).is_some_and(|tail| {
            tail.char_indices().map(|(i, _)| i).chain([tail.len()]).any(|i| fits(rest, &tail[i..]))
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(backend: &str, test: &str, reason: &str) -> Expectation {
        Expectation { backend: backend.into(), test: test.into(), reason: reason.into() }
    }

    fn after(entries: Vec<Expectation>, status: Status) -> Status {
        let mut result = CaseResult::new("scan", "empty", "wgpu:llvmpipe", status, "");
        Expectations { expect: entries }.apply(&mut result);
        result.status
    }

    #[test]
    fn patterns_fit_whole_names() {
        for (pattern, name) in [("a*c", "abbc"), ("*", ""), ("scan::*", "scan::empty"), ("wgpu:*", "wgpu:x")] {
            assert!(fits(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in [("a*c", "abcd"), ("scan", "scan::empty"), ("wgpu:*", "cpu")] {
            assert!(!fits(pattern, name), "{pattern} {name}");
        }
    }

    #[test]
    fn failures_become_expected_and_passes_become_failures() {
        let known = || vec![entry("wgpu:*", "scan::empty", "a driver's fault")];
        assert_eq!(after(known(), Status::Fail), Status::ExpectedFail);
        assert_eq!(after(known(), Status::Timeout), Status::ExpectedFail);
        assert_eq!(after(known(), Status::Pass), Status::UnexpectedPass);
        assert_eq!(after(known(), Status::Skip), Status::Skip);
        assert_eq!(after(vec![entry("cpu", "scan::empty", "x")], Status::Fail), Status::Fail);
    }

    #[test]
    fn entries_without_reason_unknown_names_and_disorder_are_faults() {
        let known = ["scan::empty".to_owned(), "scan::one".to_owned()];
        let faults = |entries: Vec<Expectation>| Expectations { expect: entries }.faults(&known).len();
        assert_eq!(faults(vec![entry("cpu", "scan::empty", "r"), entry("cpu", "scan::one", "r")]), 0);
        assert_eq!(faults(vec![entry("cpu", "scan::empty", " ")]), 1);
        assert_eq!(faults(vec![entry("gpu", "scan::empty", "r")]), 1);
        assert_eq!(faults(vec![entry("cpu", "scan::moon", "r")]), 1);
        assert_eq!(faults(vec![entry("cpu", "scan::one", "r"), entry("cpu", "scan::empty", "r")]), 1);
    }

    #[test]
    fn the_file_of_this_workspace_reads() {
        Expectations::read(&file()).unwrap();
    }
}

//! Writing snapshots: only where oracle, threads and machines agree, and never unseen.
//!
//! Every snapshot that changes is named, with what changed. A case on which anything disagrees keeps its snapshot and
//! fails.

use std::fs;
use std::path::Path;

use sightlines_backend::Kernel;

use crate::diff::Table;
use crate::error::{Error, Result};
use crate::machine::{Fleet, INSTALL_VULKAN};
use crate::plan::{Plan, Selected};
use crate::run::CaseRun;
use crate::snapshot::{self, Writing};
use crate::{costs, suite};

/// Refuses to bless where nothing may be written, or where nobody could contradict.
pub fn allowed(fleet: &Fleet, variable: impl Fn(&str) -> Option<String>) -> Result<()> {
    let set = |name: &str| variable(name).filter(|v| !matches!(v.as_str(), "" | "0" | "false"));
    if set("CI").is_some() {
        return Err(Error::Usage("--bless is refused where CI is set: continuous integration never writes".into()));
    }
    if set("INSTA_UPDATE").as_deref() == Some("no") {
        return Err(Error::Usage("--bless is refused where INSTA_UPDATE=no".into()));
    }
    if !fleet.machines.iter().any(|m| m.identity.backend == "cpu") {
        return Err(Error::Usage("--bless needs the cpu backend: snapshots are written from the interpreter".into()));
    }
    if !fleet.has_wgpu() {
        return Err(Error::Missing(format!(
            "--bless needs a wgpu device that agrees with the interpreter, and there is none\n  remedy: {INSTALL_VULKAN}"
        )));
    }
    Ok(())
}

/// Writes what changed and says so, one line a snapshot.
pub fn bless(exe: &Path, folder: &Path, kernels: &[Kernel], plan: &Plan, runs: &[CaseRun]) -> Result<Vec<String>> {
    let mut notes = Vec::new();
    let mut writings = Vec::new();
    for (selected, run) in plan.selected.iter().zip(runs) {
        let Some(text) = run.snapshot.as_ref().filter(|_| !run.results.iter().any(suite::is_unsound)) else {
            notes.push(format!("not blessed: {}: see its failure", selected.name()));
            continue;
        };
        notes.extend(changed(folder, selected, text, &mut writings)?);
    }
    let present = costs::render(kernels)?;
    let path = costs::path(folder);
    let stored = snapshot::read(&path)?;
    if stored.as_deref() != Some(present.as_str()) {
        let what = stored.and_then(|s| costs::compare(&s, &present)).map_or_else(|| " new".into(), |t| summary(&t));
        notes.push(format!("blessed machine-costs:{what}"));
        writings.push(Writing { path, text: present });
    }
    if !writings.is_empty() {
        snapshot::write(exe, &writings)?;
    }
    for orphan in snapshot::orphans(folder, &suite::known_paths(folder, plan))? {
        fs::remove_file(&orphan).map_err(|e| Error::write(&orphan, e))?;
        notes.push(format!("removed {}: no case has it", orphan.strip_prefix(folder).unwrap_or(&orphan).display()));
    }
    Ok(notes)
}

fn changed(folder: &Path, selected: &Selected, text: &str, writings: &mut Vec<Writing>) -> Result<Option<String>> {
    let path = snapshot::path(folder, &selected.kernel, &selected.case.name);
    let what = match snapshot::read(&path)? {
        None => " new".to_owned(),
        Some(stored) => match snapshot::compare(&stored, text) {
            None => return Ok(None),
            Some(table) => summary(&table),
        },
    };
    writings.push(Writing { path, text: text.to_owned() });
    Ok(Some(format!("blessed {}:{what}", selected.name())))
}

fn summary(table: &Table) -> String {
    let rows = table.rows.iter().map(|r| format!("\n  {} {}: {} -> {}", r.buffer, r.index, r.expected, r.got));
    let mut text: String = rows.collect();
    if table.total > table.rows.len() as u64 {
        text.push_str(&format!("\n  … {} more", table.total - table.rows.len() as u64));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::{Machine, Wanted};
    use crate::protocol::Identity;

    fn machine(backend: &str) -> Machine {
        let identity = Identity { backend: backend.into(), adapter: "x".into(), driver: String::new(), threads: None };
        Machine { name: backend.into(), wanted: Wanted::Cpu, identity }
    }

    fn fleet(backends: &[&str]) -> Fleet {
        Fleet { machines: backends.iter().map(|b| machine(b)).collect(), absent: None }
    }

    #[test]
    fn blessing_needs_both_backends_and_leave_to_write() {
        let none = |_: &str| None;
        let ci = |name: &str| (name == "CI").then(|| "true".to_owned());
        let no = |name: &str| (name == "INSTA_UPDATE").then(|| "no".to_owned());
        assert!(allowed(&fleet(&["cpu", "wgpu"]), none).is_ok());
        assert!(matches!(allowed(&fleet(&["cpu"]), none), Err(Error::Missing(_))));
        assert!(matches!(allowed(&fleet(&["wgpu"]), none), Err(Error::Usage(_))));
        assert!(matches!(allowed(&fleet(&["cpu", "wgpu"]), ci), Err(Error::Usage(_))));
        assert!(matches!(allowed(&fleet(&["cpu", "wgpu"]), no), Err(Error::Usage(_))));
    }
}

//! Processor instructions of one repetition, counted by callgrind: a load on the machine does not change them.
//!
//! Each count is a child process under valgrind, on one thread, that prepares a subject and repeats it once; callgrind
//! collects inside [`Prepared::repeat`] and nowhere else. Valgrind hides the SIMD levels that it does not know, so the
//! child says which level it ran.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use serde::{Deserialize, Serialize};
use sightlines_backend_cpu::{Config, CpuBackend, Simd};

use crate::error::{Error, Result};
use crate::measure::Prepared;
use crate::report::Instructions;
use crate::subject::{Subject, subjects};

/// The function that is counted, as callgrind knows it.
const COUNTED: &str = "*measure::Prepared*repeat*";

/// How to get valgrind.
const REMEDY: &str = "install it (apt-get install valgrind), or leave out --callgrind";

/// What the child says.
#[derive(Debug, Serialize, Deserialize)]
struct Ran {
    simd: String,
}

/// Ends with an error where there is no valgrind.
pub fn require() -> Result<()> {
    let tried = Command::new("valgrind").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if tried.is_ok_and(|status| status.success()) {
        return Ok(());
    }
    Err(Error::Missing(format!("valgrind, which counts instructions, does not run\n  remedy: {REMEDY}")))
}

/// Counts one repetition of a subject at a SIMD level, or at the best below it that valgrind knows.
pub fn count(exe: &Path, subject: &Subject, simd: &str, folder: &Path) -> Result<Instructions> {
    let file = folder.join(format!("callgrind.{}.out", std::process::id()));
    let output = Command::new("valgrind")
        .args(["--quiet", "--tool=callgrind", "--collect-atstart=no"])
        .arg(format!("--toggle-collect={COUNTED}"))
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(exe)
        .args(["repeat", simd, &subject.to_string()])
        .stdin(Stdio::null())
        .output()
        .map_err(|e| Error::Worker(format!("valgrind: {e}")))?;
    let words = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(Error::Worker(format!("valgrind ended with {}: {}", output.status, words.trim())));
    }
    let ran: Ran = serde_json::from_slice(&output.stdout)
        .map_err(|e| Error::Worker(format!("the child under valgrind said nothing that can be read: {e}")))?;
    let text = std::fs::read_to_string(&file).map_err(|e| Error::file(&file, e))?;
    std::fs::remove_file(&file).map_err(|e| Error::file(&file, e))?;
    let count = total(&text).filter(|count| *count > 0);
    let none = || Error::Measurement(format!("{subject}: callgrind has not seen the repetition"));
    Ok(Instructions { simd: ran.simd, count: count.ok_or_else(none)? })
}

/// The sum in callgrind's file.
fn total(text: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix("totals:").or(line.strip_prefix("summary:")))?;
    line.split_whitespace().next()?.parse().ok()
}

/// The child: prepares a subject and repeats it once.
pub fn repeat(simd: &str, id: &str, out: &mut impl Write) -> Result<()> {
    let subject = subjects().into_iter().find(|subject| subject.to_string() == id);
    let subject = subject.ok_or_else(|| Error::Worker(format!("no subject is called `{id}`")))?;
    let simd = Simd::available().into_iter().find(|level| level.name() == simd);
    let backend = CpuBackend::new(Config { threads: 1, simd, ..Config::default() });
    let mut prepared = Prepared::new(&backend, &(subject.job)()?)?;
    prepared.repeat()?;
    let ran = Ran { simd: backend.simd().name().to_owned() };
    let line = serde_json::to_string(&ran).map_err(|e| Error::Worker(e.to_string()))?;
    Ok(writeln!(out, "{line}")?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn totals_are_found_in_callgrind_s_file() {
        assert_eq!(total("events: Ir\nfn=(1)\n12 5\n\ntotals: 1234567\n"), Some(1_234_567));
        assert_eq!(total("summary: 7\nevents: Ir\n"), Some(7));
        assert_eq!(total("events: Ir\n"), None);
    }

    #[test]
    fn the_child_says_which_level_ran() {
        let mut out = Vec::new();
        repeat("none", "micro/reduction", &mut out).unwrap();
        let best = Simd::available().last().unwrap().name();
        assert_eq!(serde_json::from_slice::<Ran>(&out).unwrap().simd, best);
        assert!(repeat("none", "micro/none", &mut out).is_err());
    }
}

//! Measurements that are child processes of their own, one after the other: a case in JSON there, a row in JSON back.
//!
//! A child that fails is told and costs its row, and nothing else.

use std::fmt::Display;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{EXIT_FAILED, EXIT_OK, Error, Result};
use crate::report::write_whole;

/// What a child measures.
pub(crate) trait Measured: Serialize + DeserializeOwned {
    /// What it is given.
    type Case: Serialize + DeserializeOwned + Display;
    /// The command by which the program is such a child.
    const COMMAND: &'static str;

    /// Measures a case. `tracer` is Embree's program; its files go beside it.
    fn measure(case: Self::Case, tracer: Option<&Path>) -> Result<Self>;

    /// The time that progress tells.
    fn median_ns(&self) -> f64;
}

/// The child: measures a case and writes the row.
pub(crate) fn serve<M: Measured>(case: &str, tracer: Option<&Path>, out: &mut impl Write) -> Result<()> {
    let case = serde_json::from_str(case).map_err(|e| Error::Worker(format!("not a case: {e}")))?;
    let row = M::measure(case, tracer)?;
    let line = serde_json::to_string(&row).map_err(|e| Error::Worker(e.to_string()))?;
    Ok(writeln!(out, "{line}")?)
}

/// Measures every case in a child that `start` begins, and tells each to `progress` as it ends. The answer is the rows,
/// and what failed.
pub(crate) fn measure_all<M: Measured>(
    cases: &[M::Case],
    start: impl Fn(&M::Case) -> Command,
    tracer: Option<&Path>,
    progress: &mut impl Write,
) -> Result<(Vec<M>, Vec<String>)> {
    let (mut rows, mut failures) = (Vec::new(), Vec::new());
    for (index, case) in cases.iter().enumerate() {
        let word = match child::<M>(start(case), case, tracer) {
            Ok(row) => {
                let word = format!("{:.2} s", row.median_ns() / 1e9);
                rows.push(row);
                word
            }
            Err(error) => {
                failures.push(error.to_string());
                "failed".to_owned()
            }
        };
        writeln!(progress, "[{}/{}] {case}: {word}", index + 1, cases.len())?;
    }
    Ok((rows, failures))
}

fn child<M: Measured>(mut command: Command, case: &M::Case, tracer: Option<&Path>) -> Result<M> {
    let text = serde_json::to_string(case).map_err(|e| Error::Worker(e.to_string()))?;
    command.args([M::COMMAND, &text]);
    command.args(tracer.map(|tracer| [Path::new("--tracer"), tracer]).into_iter().flatten());
    let output = command.stdin(Stdio::null()).output();
    let output = output.map_err(|e| Error::Worker(format!("{}: {e}", command.get_program().display())))?;
    if !output.status.success() {
        let words = String::from_utf8_lossy(&output.stderr);
        return Err(Error::Worker(format!("{case} ended with {}: {}", output.status, words.trim())));
    }
    serde_json::from_slice(&output.stdout).map_err(|e| Error::Worker(format!("{case}: not a result: {e}")))
}

/// Writes the rows into a file and says what failed. The answer is the exit code.
pub(crate) fn finish<M: Measured>(rows: &[M], failures: &[String], path: &Path, out: &mut impl Write) -> Result<u8> {
    let mut text = serde_json::to_string_pretty(rows).map_err(|e| Error::file(path, e.into()))?;
    text.push('\n');
    write_whole(path, &text)?;
    for failure in failures {
        writeln!(out, "FAILED: {failure}")?;
    }
    writeln!(out, "{} cases in {}, {} failed", rows.len(), path.display(), failures.len())?;
    Ok(if failures.is_empty() { EXIT_OK } else { EXIT_FAILED })
}

//! The result of a run: rows and their summary, as `backends.json` holds them.
//!
//! Invariant: rows stand in the order thread setting, subject, engine, whatever order they were measured in.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::clock::Clock;
use crate::error::{Error, Result};
use crate::statistics::geometric_mean;
use crate::subject::MICRO;

/// Version of the file's form.
pub const SCHEMA: u32 = 2;

/// A whole run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// [`SCHEMA`].
    pub schema: u32,
    /// One row for each thread setting, subject and engine that was measured.
    pub rows: Vec<Row>,
    /// What the rows come to.
    pub summary: Summary,
}

/// One subject on one engine in one thread setting.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Name of the kernel, or `micro`.
    pub kernel: String,
    /// Name of the case.
    pub case: String,
    /// `cpu` or `wgpu`.
    pub backend: String,
    /// The adapter's own name; `interpreter` for the interpreter.
    pub adapter: String,
    /// Threads of the setting.
    pub threads: usize,
    /// The interpreter's SIMD level.
    pub simd: Option<String>,
    /// What the times are: `wall` or `cpu`.
    pub clock: Clock,
    /// Median of [`Row::rounds_ns`].
    pub median_ns: f64,
    /// Criterion's median time of one repetition in each round.
    pub rounds_ns: Vec<f64>,
    /// The interpreter's lane-operations of one repetition; see the crate's head.
    pub lane_ops: Option<u64>,
    /// `median_ns / lane_ops`.
    pub ns_per_lane_op: Option<f64>,
    /// Processor instructions of one repetition, where they were counted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub instructions: Option<Instructions>,
    /// For the interpreter, the median of the rounds' ratios to lavapipe; below 1 it is faster.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ratio_to_lavapipe: Option<f64>,
}

impl Row {
    /// Whether both measure the same thing.
    pub fn is_same_as(&self, other: &Row) -> bool {
        let key = |row: &Row| {
            let Row { kernel, case, backend, adapter, threads, simd, .. } = row.clone();
            (kernel, case, backend, adapter, threads, simd)
        };
        key(self) == key(other)
    }

    /// Instructions for each lane-operation, where they were counted.
    pub fn instructions_per_lane_op(&self) -> Option<f64> {
        let (count, ops) = (self.instructions.as_ref()?.count, self.lane_ops.filter(|ops| *ops > 0)?);
        Some(count as f64 / ops as f64)
    }

    /// `kernel/case`.
    pub fn id(&self) -> String {
        format!("{}/{}", self.kernel, self.case)
    }
}

/// A count of processor instructions, which no load on the machine changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Instructions {
    /// SIMD level that was counted: the row's, or the best that the counting tool knows.
    pub simd: String,
    /// Instructions of one repetition on one thread.
    pub count: u64,
}

/// What the rows come to.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// Rounds of each measurement.
    pub rounds: usize,
    /// Lavapipe's adapter, where there is one.
    pub lavapipe: Option<String>,
    /// One entry for each thread setting, SIMD level and kind of subject.
    pub groups: Vec<Group>,
    /// What could not be measured, and engines that gave different bits.
    pub failures: Vec<String>,
}

/// The interpreter in one thread setting at one level, on the kernels or on the micro-kernels.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// Threads of the setting.
    pub threads: usize,
    /// SIMD level.
    pub simd: String,
    /// `kernels` or `micro`.
    pub subjects: String,
    /// Rows.
    pub count: usize,
    /// Kernels of the mean ratio, or of the rows where there is none; each micro-kernel is one.
    pub kernels: usize,
    /// Geometric mean of `ns_per_lane_op`: of each kernel's cases, then of the kernels.
    pub mean_ns_per_lane_op: Option<f64>,
    /// Geometric mean of `ratio_to_lavapipe`: of each kernel's cases, then of the kernels, so that a kernel of many
    /// cases counts once.
    pub mean_ratio: Option<f64>,
    /// Kernels whose mean ratio is below 1.
    pub faster: usize,
    /// The largest `ratio_to_lavapipe`.
    pub worst_ratio: Option<f64>,
    /// `kernel/case` of the largest ratio.
    pub worst: Option<String>,
}

impl Report {
    /// Rows with their summary.
    pub fn new(rows: Vec<Row>, rounds: usize, lavapipe: Option<String>, failures: Vec<String>) -> Self {
        let groups = groups(&rows);
        Report { schema: SCHEMA, rows, summary: Summary { rounds, lavapipe, groups, failures } }
    }

    /// Writes the file, whole or not at all.
    pub fn write(&self, path: &Path) -> Result<()> {
        let mut text = serde_json::to_string_pretty(self).map_err(|e| Error::file(path, e.into()))?;
        text.push('\n');
        write_whole(path, &text)
    }

    /// Reads what [`Report::write`] wrote.
    pub fn read(path: &Path) -> Result<Self> {
        let text = fs::read(path).map_err(|e| Error::file(path, e))?;
        let not = |reason: String| Error::Usage(format!("{}: not a report of this version: {reason}", path.display()));
        let report: Report = serde_json::from_slice(&text).map_err(|e| not(e.to_string()))?;
        if report.schema == SCHEMA { Ok(report) } else { Err(not(format!("schema {}", report.schema))) }
    }
}

/// Writes a file through a temporary neighbour and a rename, so that no reader sees half of it.
pub(crate) fn write_whole(path: &Path, text: &str) -> Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|e| Error::file(folder, e))?;
    }
    let mut temporary = OsString::from(path);
    temporary.push(format!(".{}.tmp", std::process::id()));
    let temporary = PathBuf::from(temporary);
    fs::write(&temporary, text).and_then(|()| fs::rename(&temporary, path)).map_err(|e| Error::file(path, e))
}

fn groups(rows: &[Row]) -> Vec<Group> {
    let mut keys: Vec<(usize, &str, bool)> = Vec::new();
    for row in rows {
        let Some(simd) = &row.simd else { continue };
        let key = (row.threads, simd.as_str(), row.kernel == MICRO);
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    keys.into_iter().map(|key| group(rows, key)).collect()
}

fn group(rows: &[Row], (threads, simd, micro): (usize, &str, bool)) -> Group {
    let belongs = |row: &&Row| (row.threads, row.simd.as_deref(), row.kernel == MICRO) == (threads, Some(simd), micro);
    let rows: Vec<&Row> = rows.iter().filter(belongs).collect();
    let costs = kernel_means(&rows, |row| row.ns_per_lane_op);
    let ratios = kernel_means(&rows, |row| row.ratio_to_lavapipe);
    let rated = rows.iter().filter_map(|row| Some((row.ratio_to_lavapipe?, row.id())));
    let worst = rated.max_by(|a, b| a.0.total_cmp(&b.0));
    Group {
        threads,
        simd: simd.to_owned(),
        subjects: if micro { MICRO } else { "kernels" }.to_owned(),
        count: rows.len(),
        kernels: if ratios.is_empty() { costs.len() } else { ratios.len() },
        faster: ratios.iter().filter(|ratio| **ratio < 1.0).count(),
        mean_ns_per_lane_op: geometric_mean(&costs),
        mean_ratio: geometric_mean(&ratios),
        worst_ratio: worst.as_ref().map(|(ratio, _)| *ratio),
        worst: worst.map(|(_, id)| id),
    }
}

/// The geometric mean of each kernel's rows, where they have the value.
fn kernel_means(rows: &[&Row], value: impl Fn(&Row) -> Option<f64>) -> Vec<f64> {
    let mut kernels: Vec<(String, Vec<f64>)> = Vec::new();
    for (row, value) in rows.iter().filter_map(|row| Some((row, value(row)?))) {
        let name = if row.kernel == MICRO { row.id() } else { row.kernel.clone() };
        match kernels.iter_mut().find(|(kernel, _)| *kernel == name) {
            Some((_, values)) => values.push(value),
            None => kernels.push((name, vec![value])),
        }
    }
    kernels.iter().filter_map(|(_, values)| geometric_mean(values)).collect()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn row(id: &str, threads: usize, simd: Option<&str>, median_ns: f64, ratio: Option<f64>) -> Row {
        let (kernel, case) = id.split_once('/').unwrap();
        Row {
            kernel: kernel.into(),
            case: case.into(),
            backend: if simd.is_some() { "cpu" } else { "wgpu" }.into(),
            adapter: if simd.is_some() { "interpreter" } else { "llvmpipe (LLVM 15)" }.into(),
            threads,
            simd: simd.map(str::to_owned),
            clock: if threads == 1 { Clock::Cpu } else { Clock::Wall },
            median_ns,
            rounds_ns: vec![median_ns],
            lane_ops: Some(1000),
            ns_per_lane_op: Some(median_ns / 1000.0),
            instructions: None,
            ratio_to_lavapipe: ratio,
        }
    }

    #[test]
    fn groups_keep_threads_levels_and_micro_kernels_apart() {
        let rows = vec![
            row("scan/counts", 1, None, 2e6, None),
            row("scan/counts", 1, Some("avx2"), 1e6, Some(0.5)),
            row("sat/square", 1, Some("avx2"), 4e6, Some(1.0)),
            row("sat/wide", 1, Some("avx2"), 4e6, Some(4.0)),
            row("micro/gather", 1, Some("avx2"), 4e6, Some(8.0)),
            row("scan/counts", 2, Some("avx2"), 1e6, None),
        ];
        let report = Report::new(rows, 3, None, Vec::new());
        let shown: Vec<_> = report.summary.groups.iter().map(|g| (g.threads, g.subjects.as_str(), g.count)).collect();
        assert_eq!(shown, [(1, "kernels", 3), (1, "micro", 1), (2, "kernels", 1)]);
        let first = &report.summary.groups[0];
        // 0.5 of one kernel, 2 of the other: the second kernel's two cases count as one.
        assert!((first.mean_ratio.unwrap() - 1.0).abs() < 1e-12);
        assert!((first.mean_ns_per_lane_op.unwrap() - 2000.0).abs() < 1e-9);
        assert_eq!((first.kernels, first.faster), (2, 1));
        assert_eq!((first.worst_ratio, first.worst.as_deref()), (Some(4.0), Some("sat/wide")));
        assert_eq!(report.summary.groups[2].mean_ratio, None);
    }

    #[test]
    fn a_written_report_is_read_back_and_other_versions_are_refused() {
        let folder = std::env::temp_dir().join(format!("sightlines-report-{}", std::process::id()));
        let path = folder.join("deep/backends.json");
        let mut report = Report::new(vec![row("scan/counts", 1, Some("avx2"), 1.5, Some(0.5))], 1, None, Vec::new());
        report.write(&path).unwrap();
        assert_eq!(Report::read(&path).unwrap(), report);
        assert_eq!(fs::read_dir(path.parent().unwrap()).unwrap().count(), 1, "the temporary file is gone");
        report.schema += 1;
        report.write(&path).unwrap();
        assert!(matches!(Report::read(&path), Err(Error::Usage(_))));
        fs::remove_dir_all(&folder).unwrap();
    }
}

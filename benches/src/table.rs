//! The report for people: one table a thread setting, then the means.

use std::fmt::Write;

use crate::baseline::Baseline;
use crate::report::{Report, Row};

/// Text in columns: the first `left` are flush left, the others flush right.
pub(crate) struct Columns {
    pub left: usize,
    pub lines: Vec<Vec<String>>,
}

impl Columns {
    pub(crate) fn render(&self, out: &mut String) {
        let width = |column: usize| self.lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
        for line in &self.lines {
            let mut text = String::from("  ");
            for (column, cell) in line.iter().enumerate() {
                let width = width(column);
                let cell = if column < self.left { format!("{cell:<width$}  ") } else { format!("{cell:>width$}  ") };
                text.push_str(&cell);
            }
            out.push_str(text.trim_end());
            out.push('\n');
        }
    }
}

/// The whole report; with a baseline, what changed since.
pub(crate) fn render(report: &Report, baseline: Option<&Baseline>) -> String {
    let mut out = String::new();
    let mut settings: Vec<usize> = report.rows.iter().map(|row| row.threads).collect();
    settings.dedup();
    for threads in settings {
        let rows: Vec<&Row> = report.rows.iter().filter(|row| row.threads == threads).collect();
        let clock = rows.first().map_or("", |row| row.clock.name());
        let _ = writeln!(out, "{threads} {}, {clock}", if threads == 1 { "thread" } else { "threads" });
        setting(&rows, baseline).render(&mut out);
        out.push('\n');
    }
    means(report, &mut out);
    out
}

/// One line for each subject and SIMD level.
fn setting(rows: &[&Row], baseline: Option<&Baseline>) -> Columns {
    let mut adapters: Vec<&str> = Vec::new();
    for row in rows.iter().filter(|row| row.simd.is_none()) {
        if !adapters.contains(&row.adapter.as_str()) {
            adapters.push(&row.adapter);
        }
    }
    let mut head = vec!["kernel".to_owned(), "case".to_owned(), "simd".to_owned()];
    head.extend(adapters.iter().map(|adapter| format!("{} ms", short(adapter))));
    head.extend(["interpreter ms", "ratio", "ns/lane-op"].map(str::to_owned));
    let counted = rows.iter().any(|row| row.instructions.is_some());
    if counted {
        head.extend(["Minstr", "instr/lane-op", "counted at"].map(str::to_owned));
    }
    if let Some(baseline) = baseline {
        head.push(format!("time since {}", baseline.name));
        head.push("ratio since".to_owned());
        if counted {
            head.push("instr since".to_owned());
        }
    }
    let mut lines = vec![head];
    for row in rows.iter().filter(|row| row.simd.is_some()) {
        let mut line = vec![row.kernel.clone(), row.case.clone(), row.simd.clone().unwrap_or_default()];
        line.extend(adapters.iter().map(|adapter| {
            let other = rows.iter().find(|r| r.adapter == *adapter && r.id() == row.id());
            cell(other.map(|r| r.median_ns / 1e6), 3)
        }));
        line.extend([cell(Some(row.median_ns / 1e6), 3), cell(row.ratio_to_lavapipe, 2), cell(row.ns_per_lane_op, 3)]);
        if counted {
            let count = row.instructions.as_ref();
            let level = count.map_or_else(|| "-".to_owned(), |i| i.simd.clone());
            line.extend([cell(count.map(|i| i.count as f64 / 1e6), 3), cell(row.instructions_per_lane_op(), 3), level]);
        }
        if let Some(baseline) = baseline {
            let changes = baseline.changes(row);
            line.extend([percent(changes.time), percent(changes.ratio)]);
            if counted {
                line.push(percent(changes.instructions));
            }
        }
        lines.push(line);
    }
    Columns { left: 3, lines }
}

fn means(report: &Report, out: &mut String) {
    for group in &report.summary.groups {
        let threads = if group.threads == 1 { "1 thread".to_owned() } else { format!("{} threads", group.threads) };
        let _ = write!(out, "{}, {threads}, {}: ", group.subjects, group.simd);
        if let (Some(mean), Some(worst), Some(id)) = (group.mean_ratio, group.worst_ratio, &group.worst) {
            let kernels = if group.kernels == 1 { "kernel" } else { "kernels" };
            let (faster, count) = (group.faster, group.kernels);
            let _ = write!(
                out,
                "ratio to lavapipe {mean:.2} in the geometric mean of {count} {kernels}, {faster} of them faster, \
                 at worst {worst:.2} ({id}); "
            );
        }
        let _ = writeln!(out, "{} ns a lane-operation", cell(group.mean_ns_per_lane_op, 3));
    }
}

/// The part of an adapter's name that stands before its details.
pub(crate) fn short(adapter: &str) -> &str {
    let name = adapter.split(" (").next().unwrap_or(adapter);
    if name == crate::engine::LAVAPIPE { "lavapipe" } else { name }
}

pub(crate) fn cell(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
}

pub(crate) fn percent(change: Option<f64>) -> String {
    change.map_or_else(|| "-".to_owned(), |change| format!("{:+.1} %", 100.0 * change))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::row;

    #[test]
    fn the_table_shows_engines_side_by_side_in_the_order_of_the_rows() {
        let rows = vec![
            row("scan/counts", 1, None, 2e6, None),
            row("scan/counts", 1, Some("avx2"), 1e6, Some(0.5)),
            row("sat/square", 1, Some("avx2"), 4e6, None),
        ];
        let expected = "\
1 thread, CPU time
  kernel  case    simd  lavapipe ms  interpreter ms  ratio  ns/lane-op
  scan    counts  avx2        2.000           1.000   0.50    1000.000
  sat     square  avx2            -           4.000      -    4000.000

kernels, 1 thread, avx2: ratio to lavapipe 0.50 in the geometric mean of 1 kernel, 1 of them faster, at worst 0.50 \
(scan/counts); 2000.000 ns a lane-operation
";
        assert_eq!(render(&Report::new(rows, 1, None, Vec::new()), None), expected);
    }

    #[test]
    fn changes_stand_beside_the_rows() {
        let old = Report::new(vec![row("scan/counts", 2, Some("avx2"), 2e6, Some(0.5))], 1, None, Vec::new());
        let baseline = Baseline { name: "old".into(), report: old };
        let new = Report::new(vec![row("scan/counts", 2, Some("avx2"), 1e6, None)], 1, None, Vec::new());
        let text = render(&new, Some(&baseline));
        assert!(text.contains("time since old") && text.contains("-50.0 %"), "{text}");
    }
}

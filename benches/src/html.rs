//! The report as one page that needs nothing else: means as cards, charts as inline SVG, every number in a table.
//!
//! Colours follow the reader's preference for light or dark. Names that come from outside (adapters, baselines) are
//! escaped.

use std::fmt::Write;

use crate::baseline::Baseline;
use crate::html::chart::{Bar, Chart};
use crate::report::{Group, Report, Row};
use crate::subject::MICRO;
use crate::table::{cell, percent, short};

mod chart;

const STYLE: &str = include_str!("html/style.css");

/// The page.
pub(crate) fn render(report: &Report, baseline: Option<&Baseline>) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Sightlines: backends</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n\
         <h1>Backends against each other</h1>\n"
    );
    lead(report, baseline, &mut page);
    failures(report, &mut page);
    cards(report, &mut page);
    for threads in settings(report) {
        ratios(report, threads, baseline, &mut page);
    }
    levels(report, &mut page);
    scaling(report, &mut page);
    table(report, baseline, &mut page);
    page.push_str("</main>\n</body>\n</html>\n");
    page
}

fn lead(report: &Report, baseline: Option<&Baseline>, page: &mut String) {
    let rounds = report.summary.rounds;
    let rounds = if rounds == 1 { "1 round".to_owned() } else { format!("the median of {rounds} rounds") };
    let other = report.summary.lavapipe.as_deref().map_or_else(String::new, |name| {
        format!(
            " A ratio is the interpreter&rsquo;s time over that of <b>{}</b>; below 1 the interpreter is faster.",
            escape(name)
        )
    });
    let since =
        baseline.map_or_else(String::new, |b| format!(" Changes are since the baseline <b>{}</b>.", escape(&b.name)));
    let _ = writeln!(page, "<p class=\"lead\">The dispatches of each case, {rounds}.{other}{since}</p>");
}

fn failures(report: &Report, page: &mut String) {
    for failure in &report.summary.failures {
        let _ = writeln!(page, "<p class=\"failure\">{}</p>", escape(failure));
    }
}

fn cards(report: &Report, page: &mut String) {
    page.push_str("<div class=\"cards\">\n");
    for group in &report.summary.groups {
        card(group, page);
    }
    page.push_str("</div>\n");
}

fn card(group: &Group, page: &mut String) {
    let what = if group.subjects == MICRO { "micro-kernel" } else { "kernel" };
    let plural = if group.kernels == 1 { "" } else { "s" };
    let figure = match group.mean_ratio {
        Some(ratio) => format!("{ratio:.2}<small>&times; lavapipe&rsquo;s time</small>"),
        None => format!("{}<small>ns a lane-operation</small>", cell(group.mean_ns_per_lane_op, 3)),
    };
    let tone = group.mean_ratio.map_or("", |ratio| if ratio < 1.0 { " better" } else { " worse" });
    let _ = writeln!(
        page,
        "<section class=\"card{tone}\"><h2>{} {what}{plural}</h2><p class=\"tags\">{} &middot; {}</p><p class=\"figure\">{figure}</p>",
        group.kernels,
        threads_name(group.threads),
        escape(&group.simd)
    );
    if let (Some(worst), Some(id)) = (group.worst_ratio, &group.worst) {
        let _ = writeln!(
            page,
            "<p>{} of {} faster; at worst {worst:.2}, {}</p><p>{} ns a lane-operation</p>",
            group.faster,
            group.kernels,
            escape(id),
            cell(group.mean_ns_per_lane_op, 3)
        );
    }
    page.push_str("</section>\n");
}

/// Bars of the interpreter's ratio to lavapipe in one thread setting.
fn ratios(report: &Report, threads: usize, baseline: Option<&Baseline>, page: &mut String) {
    let rows = interpreter(report).filter(|row| row.threads == threads);
    let bars = rows.filter_map(|row| {
        let change = baseline.and_then(|baseline| baseline.changes(row).ratio);
        let note = change.map(|change| (percent(Some(change)), change <= 0.0));
        Some(bar(row, row.ratio_to_lavapipe?, format!("{} ms", cell(Some(row.median_ns / 1e6), 2)), note))
    });
    let title = format!("Time over lavapipe&rsquo;s, {}", threads_name(threads));
    let clock = report.rows.iter().find(|row| row.threads == threads).map_or("", |row| row.clock.name());
    let caption = format!("{clock}; bars to the left are faster than lavapipe, to the right slower");
    Chart { title: &title, caption: &caption, less_is_better: true, bars: bars.collect() }.render(page);
}

/// Bars of each SIMD level against the lowest of the run.
fn levels(report: &Report, page: &mut String) {
    let mut bars = Vec::new();
    let mut lowest: Option<&Row> = None;
    for row in interpreter(report).filter(|row| row.threads == 1) {
        match lowest.filter(|low| low.id() == row.id()) {
            None => lowest = Some(row),
            Some(low) => bars.push(bar(row, low.median_ns / row.median_ns, String::new(), None)),
        }
    }
    let below = interpreter(report).next().and_then(|row| row.simd.clone()).unwrap_or_default();
    let title = format!("Speed of a SIMD level over {}", escape(&below));
    Chart { title: &title, caption: "one thread; bars to the right are faster", less_is_better: false, bars }
        .render(page);
}

/// Bars of all threads against one.
fn scaling(report: &Report, page: &mut String) {
    let one: Vec<&Row> = interpreter(report).filter(|row| row.threads == 1).collect();
    let rows = interpreter(report).filter(|row| row.threads > 1);
    let bars = rows.filter_map(|row| {
        let single = one.iter().find(|single| single.id() == row.id() && single.simd == row.simd)?;
        Some(bar(row, single.median_ns / row.median_ns, String::new(), None))
    });
    let caption = "wall time of all threads against CPU time of one; a busy machine lowers it";
    Chart { title: "Speed of all threads over one", caption, less_is_better: false, bars: bars.collect() }.render(page);
}

fn bar(row: &Row, value: f64, detail: String, note: Option<(String, bool)>) -> Bar {
    let level = row.simd.clone().unwrap_or_default();
    Bar { group: row.kernel.clone(), label: row.case.clone(), level, value, detail, note }
}

fn table(report: &Report, baseline: Option<&Baseline>, page: &mut String) {
    page.push_str("<details open>\n<summary>All numbers</summary>\n<div class=\"scroll\"><table>\n<thead><tr>");
    let mut head = vec![
        "threads",
        "kernel",
        "case",
        "engine",
        "ms",
        "ratio",
        "ns/lane-op",
        "lane-ops",
        "instructions",
        "instr/lane-op",
    ];
    if baseline.is_some() {
        head.extend(["time since", "ratio since", "instr since"]);
    }
    for (column, title) in head.iter().enumerate() {
        let _ = write!(page, "<th{}>{title}</th>", if column < 4 { " class=\"text\"" } else { "" });
    }
    page.push_str("</tr></thead>\n<tbody>\n");
    for row in &report.rows {
        let engine =
            row.simd.as_ref().map_or_else(|| short(&row.adapter).to_owned(), |simd| format!("interpreter {simd}"));
        let counted = row.instructions.as_ref().map(|i| format!("{} ({})", i.count, i.simd));
        let mut cells = vec![
            row.threads.to_string(),
            row.kernel.clone(),
            row.case.clone(),
            engine,
            cell(Some(row.median_ns / 1e6), 3),
            cell(row.ratio_to_lavapipe, 2),
            cell(row.ns_per_lane_op, 3),
            row.lane_ops.map_or_else(|| "-".to_owned(), |ops| ops.to_string()),
            counted.unwrap_or_else(|| "-".to_owned()),
            cell(row.instructions_per_lane_op(), 3),
        ];
        if let Some(baseline) = baseline {
            let changes = baseline.changes(row);
            cells.extend([changes.time, changes.ratio, changes.instructions].map(percent));
        }
        page.push_str("<tr>");
        for (column, text) in cells.iter().enumerate() {
            let _ = write!(page, "<td{}>{}</td>", if column < 4 { " class=\"text\"" } else { "" }, escape(text));
        }
        page.push_str("</tr>\n");
    }
    page.push_str("</tbody>\n</table></div>\n</details>\n");
}

fn interpreter(report: &Report) -> impl Iterator<Item = &Row> {
    report.rows.iter().filter(|row| row.simd.is_some())
}

fn settings(report: &Report) -> Vec<usize> {
    let mut settings: Vec<usize> = report.rows.iter().map(|row| row.threads).collect();
    settings.dedup();
    settings
}

fn threads_name(threads: usize) -> String {
    if threads == 1 { "1 thread".to_owned() } else { format!("{threads} threads") }
}

/// Text for HTML and SVG.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Report;
    use crate::report::tests::row;

    fn page(baseline: Option<&Baseline>) -> String {
        let rows = vec![
            row("scan/counts", 1, None, 2e6, None),
            row("scan/counts", 1, Some("sse2"), 1e6, Some(0.5)),
            row("scan/counts", 1, Some("avx2"), 5e5, Some(0.25)),
            row("sat/square", 1, Some("avx2"), 4e6, Some(2.0)),
            row("scan/counts", 2, Some("avx2"), 3e5, Some(0.4)),
        ];
        render(&Report::new(rows, 3, Some("llvmpipe <LLVM & 15>".into()), vec!["a < b".into()]), baseline)
    }

    #[test]
    fn a_page_needs_nothing_else_and_escapes_names() {
        let page = page(None);
        for outside in ["http://", "https://", "<script", "<link", "src=", "@import", "url("] {
            assert!(!page.contains(outside), "{outside}");
        }
        assert!(page.contains("llvmpipe &lt;LLVM &amp; 15&gt;") && page.contains("a &lt; b"));
        assert_eq!(page.matches("<svg").count(), 4, "two thread settings, levels, threads");
        assert_eq!(page.matches("<svg").count(), page.matches("</svg>").count());
    }

    #[test]
    fn slower_and_faster_bars_differ_and_changes_are_shown() {
        let old = Report::new(vec![row("sat/square", 1, Some("avx2"), 2e6, Some(1.0))], 1, None, Vec::new());
        let page = page(Some(&Baseline { name: "old".into(), report: old }));
        assert!(page.contains("bar better") && page.contains("bar worse"));
        assert!(page.contains("+100.0 %"), "the ratio has doubled since");
    }
}

//! The report for people: fixed order, no times, no colours, so that two equal runs print equal text.

use std::collections::BTreeMap;
use std::io::{self, Write};

use sightlines_backend::CONTRACT_VERSION;

use crate::result::{CaseResult, Report, Status, Taking};

/// Writes the whole report; its last line is the totals.
pub fn write(report: &Report, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "numerics contract {CONTRACT_VERSION}")?;
    for Taking { name, identity } in &report.machines {
        let threads = identity.threads.map_or_else(String::new, |n| format!(", 1 and {n} threads"));
        writeln!(out, "machine {name}: {identity}{threads}")?;
    }
    cases(report, out)?;
    failures(report, out)?;
    suite(report, out)?;
    for note in &report.notes {
        writeln!(out, "\nnote: {}", note.replace('\n', "\n      "))?;
    }
    writeln!(out)?;
    totals(report, out)
}

/// The last line.
pub fn totals(report: &Report, out: &mut dyn Write) -> io::Result<()> {
    let (passed, failed, skipped) = report.totals();
    writeln!(out, "{passed} passed, {failed} failed, {skipped} skipped")
}

fn cases(report: &Report, out: &mut dyn Write) -> io::Result<()> {
    let width = report.results.iter().map(|r| r.case.len()).max().unwrap_or(0);
    let mut kernel = "";
    for case in report.results.chunk_by(|a, b| (&a.kernel, &a.case) == (&b.kernel, &b.case)) {
        if case[0].kernel != kernel {
            kernel = &case[0].kernel;
            writeln!(out, "\n{kernel}")?;
        }
        let of = |status| {
            let names: Vec<&str> = case.iter().filter(|r| r.status == status).map(|r| r.machine.as_str()).collect();
            (!names.is_empty()).then(|| format!("{status} {}", names.join(", ")))
        };
        let line: Vec<String> = Status::ALL.into_iter().filter_map(of).collect();
        writeln!(out, "  {:width$}  {}", case[0].case, line.join("; "))?;
    }
    Ok(())
}

fn failures(report: &Report, out: &mut dyn Write) -> io::Result<()> {
    let of = |status: Status| report.results.iter().filter(move |r| r.status == status);
    for status in Status::ALL {
        if of(status).next().is_none() || status == Status::Pass {
            continue;
        }
        writeln!(out, "\n{}:", heading(status))?;
        if status == Status::Skip {
            let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
            of(status).for_each(|r| *reasons.entry(&r.message).or_default() += 1);
            for (reason, count) in reasons {
                writeln!(out, "  {count}: {reason}")?;
            }
            continue;
        }
        for result in of(status) {
            failure(result, out)?;
        }
    }
    Ok(())
}

fn heading(status: Status) -> &'static str {
    match status {
        Status::Pass => "passed",
        Status::ExpectedFail => "failed as expected",
        Status::Skip => "skipped",
        Status::UnexpectedPass => "expected to fail, but passed",
        Status::Fail => "failed",
        Status::Trap => "trapped",
        Status::Timeout => "timed out",
    }
}

fn failure(result: &CaseResult, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(describe(result, "  ").as_bytes())
}

/// A failing result in full: the check and its message, the table, the command that replays it.
pub fn describe(result: &CaseResult, indent: &str) -> String {
    let check = result.check.map_or_else(String::new, |c| format!(" [{}]", c.name()));
    let mut text = format!("{}{check}: {}\n", result.name(), result.message);
    if let Some(table) = result.table.as_ref().filter(|_| result.status.is_failure()) {
        text.push_str(&table.render(&result.kernel, &result.case, &result.machine));
    }
    if let Some(replay) = &result.replay {
        text.push_str(&format!("replay: {replay}\n"));
    }
    text.lines()
        .enumerate()
        .map(|(i, line)| if i == 0 { format!("{indent}{line}\n") } else { format!("{indent}  {line}\n") })
        .collect()
}

fn suite(report: &Report, out: &mut dyn Write) -> io::Result<()> {
    if report.suite.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nsuite")?;
    for check in &report.suite {
        writeln!(out, "  {}  {}", check.name, check.status)?;
        for line in check.message.lines() {
            writeln!(out, "    {line}")?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diff::{Row, Table};
    use crate::result::{Check, SuiteCheck};

    #[test]
    fn the_report_is_ordered_and_ends_with_the_totals() {
        let mut failed = CaseResult::new("scan", "one", "wgpu:x", Status::Fail, "1 words differ from the oracle");
        failed.check = Some(Check::Oracle);
        failed.table = Some(Table::one(Row::word("sums", 3, 7, 6)));
        failed.replay = Some("cargo xtask conformance --replay target/conformance/scan-one-wgpu_x.job".into());
        let report = Report {
            results: vec![
                CaseResult::new("scan", "empty", "cpu", Status::Pass, ""),
                CaseResult::new("scan", "empty", "wgpu:x", Status::Pass, ""),
                CaseResult::new("scan", "one", "cpu", Status::Pass, ""),
                failed,
                CaseResult::new("scan", "real", "cpu", Status::Skip, "not run"),
            ],
            suite: vec![SuiteCheck { name: "suite::names".into(), status: Status::Pass, message: String::new() }],
            notes: vec!["wgpu was not tested".into()],
            ..Report::default()
        };
        let mut text = Vec::new();
        write(&report, &mut text).unwrap();
        insta::assert_snapshot!(String::from_utf8(text).unwrap(), @r"
        numerics contract 1

        scan
          empty  pass cpu, wgpu:x
          one    pass cpu; fail wgpu:x
          real   skip cpu

        skipped:
          1: not run

        failed:
          scan::one::wgpu:x [oracle]: 1 words differ from the oracle
            kernel  case  backend  buffer  index  expected    got
            scan    one   wgpu:x   sums    3      0x00000007  0x00000006
            replay: cargo xtask conformance --replay target/conformance/scan-one-wgpu_x.job

        suite
          suite::names  pass

        note: wgpu was not tested

        4 passed, 1 failed, 1 skipped
        ");
    }
}

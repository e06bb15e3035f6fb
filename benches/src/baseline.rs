//! Reports kept under a name, to compare later runs with.

use std::path::{Path, PathBuf};

use crate::error::{Error, Result};
use crate::report::{Report, Row};

/// A kept report.
#[derive(Clone, Debug, PartialEq)]
pub struct Baseline {
    /// Its name.
    pub name: String,
    /// The rows to compare with.
    pub report: Report,
}

impl Baseline {
    /// Reads a baseline from the output folder.
    pub fn read(folder: &Path, name: &str) -> Result<Self> {
        let path = file(folder, name);
        if !path.is_file() {
            let remedy = format!("write it with `--save-baseline {name}`");
            return Err(Error::Usage(format!(
                "no baseline `{name}`: {} does not exist\n  remedy: {remedy}",
                path.display()
            )));
        }
        Ok(Baseline { name: name.to_owned(), report: Report::read(&path)? })
    }

    /// Keeps a report under a name.
    pub fn save(folder: &Path, name: &str, report: &Report) -> Result<()> {
        report.write(&file(folder, name))
    }

    /// What changed since the baseline, where both runs have it.
    pub fn changes(&self, row: &Row) -> Changes {
        let Some(old) = self.report.rows.iter().find(|old| old.is_same_as(row)) else { return Changes::default() };
        let change = |new: f64, old: f64| new / old - 1.0;
        let counts = row.instructions.as_ref().zip(old.instructions.as_ref()).filter(|(new, old)| new.simd == old.simd);
        Changes {
            time: Some(change(row.median_ns, old.median_ns)),
            ratio: row.ratio_to_lavapipe.zip(old.ratio_to_lavapipe).map(|(new, old)| change(new, old)),
            instructions: counts.map(|(new, old)| change(new.count as f64, old.count as f64)),
        }
    }
}

/// Relative changes since a baseline. A load on the machine changes the time most, the ratio less, instructions not at
/// all.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Changes {
    /// Of the median time.
    pub time: Option<f64>,
    /// Of the ratio to lavapipe.
    pub ratio: Option<f64>,
    /// Of the instructions.
    pub instructions: Option<f64>,
}

/// Whether a name can be that of a file.
pub fn parse_name(name: &str) -> std::result::Result<String, String> {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if !name.is_empty() && name.chars().all(plain) {
        Ok(name.to_owned())
    } else {
        Err("a baseline's name is made of letters, digits, `-` and `_`".to_owned())
    }
}

fn file(folder: &Path, name: &str) -> PathBuf {
    folder.join("baselines").join(format!("{name}.json"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Instructions;
    use crate::report::tests::row;

    #[test]
    fn changes_are_found_by_what_a_row_measures() {
        let rows = vec![row("scan/counts", 1, Some("avx2"), 2e6, Some(0.5)), row("scan/counts", 1, None, 4e6, None)];
        let baseline = Baseline { name: "old".into(), report: Report::new(rows, 1, None, Vec::new()) };
        let changes = |row: Row| {
            let changes = baseline.changes(&row);
            (changes.time, changes.ratio)
        };
        assert_eq!(changes(row("scan/counts", 1, Some("avx2"), 3e6, Some(0.25))), (Some(0.5), Some(-0.5)));
        assert_eq!(changes(row("scan/counts", 1, None, 2e6, None)), (Some(-0.5), None));
        assert_eq!(changes(row("scan/counts", 2, Some("avx2"), 2e6, None)), (None, None));
    }

    #[test]
    fn instructions_are_compared_at_one_level() {
        let counted = |simd: &str, count| {
            let mut row = row("scan/counts", 1, Some("avx512"), 2e6, None);
            row.instructions = Some(Instructions { simd: simd.into(), count });
            row
        };
        let report = Report::new(vec![counted("avx2", 1000)], 1, None, Vec::new());
        let baseline = Baseline { name: "old".into(), report };
        assert_eq!(baseline.changes(&counted("avx2", 1500)).instructions, Some(0.5));
        assert_eq!(baseline.changes(&counted("sse2", 1500)).instructions, None);
    }

    #[test]
    fn names_are_plain() {
        assert!(parse_name("before-fusion_2").is_ok());
        for bad in ["", "../x", "a b"] {
            assert!(parse_name(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn a_missing_baseline_says_how_to_make_one() {
        let error = Baseline::read(Path::new("nowhere"), "x").unwrap_err();
        assert!(error.to_string().contains("--save-baseline x"), "{error}");
        assert_eq!(error.exit_code(), crate::error::EXIT_USAGE);
    }
}

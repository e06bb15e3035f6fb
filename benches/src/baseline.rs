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

    /// Relative changes of time and of the ratio to lavapipe since the baseline, where both runs have them. A load on
    /// the machine changes the first more than the second.
    pub fn changes(&self, row: &Row) -> (Option<f64>, Option<f64>) {
        let Some(old) = self.report.rows.iter().find(|old| old.is_same_as(row)) else { return (None, None) };
        let ratio = row.ratio_to_lavapipe.zip(old.ratio_to_lavapipe).map(|(new, old)| new / old - 1.0);
        (Some(row.median_ns / old.median_ns - 1.0), ratio)
    }
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
    use crate::report::tests::row;

    #[test]
    fn changes_are_found_by_what_a_row_measures() {
        let rows = vec![row("scan/counts", 1, Some("avx2"), 2e6, Some(0.5)), row("scan/counts", 1, None, 4e6, None)];
        let baseline = Baseline { name: "old".into(), report: Report::new(rows, 1, None, Vec::new()) };
        let changes = |row: Row| baseline.changes(&row);
        assert_eq!(changes(row("scan/counts", 1, Some("avx2"), 3e6, Some(0.25))), (Some(0.5), Some(-0.5)));
        assert_eq!(changes(row("scan/counts", 1, None, 2e6, None)), (Some(-0.5), None));
        assert_eq!(changes(row("scan/counts", 2, Some("avx2"), 2e6, None)), (None, None));
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

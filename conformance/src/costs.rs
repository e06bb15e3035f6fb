//! Machine costs: instructions of the interpreter's lowered code, in one snapshot of their own.
//!
//! They change with every improvement of the lowering, and output bits do not: kept apart, a review sees at once which
//! of the two has changed.

use std::path::{Path, PathBuf};

use sightlines_backend::Kernel;
use sightlines_backend_cpu::CpuBackend;

use crate::diff::{Row, Table};
use crate::error::Result;

const HEAD: &str = "instructions of the lowered code";

/// Path of the snapshot.
pub fn path(folder: &Path) -> PathBuf {
    folder.join("machine-costs.snap")
}

/// The snapshot's text: one line for each entry point of each program of each kernel.
pub fn render(kernels: &[Kernel]) -> Result<String> {
    let mut lines = vec![HEAD.to_owned()];
    for kernel in kernels {
        for program in (kernel.programs)()? {
            for entry in program.entries() {
                let lowered = CpuBackend::lowered(&program, &entry.name, &[])?;
                let (label, entry) = (program.label(), &entry.name);
                lines.push(format!("{} {label} {entry}: {}", kernel.name, lowered.instructions()));
            }
        }
    }
    Ok(lines.join("\n") + "\n")
}

/// Lines that differ between the stored text and the present one.
pub fn compare(stored: &str, present: &str) -> Option<Table> {
    let split = |text: &str| -> Vec<(String, String)> {
        let pairs = text.lines().filter_map(|l| l.rsplit_once(": "));
        pairs.map(|(entry, count)| (entry.to_owned(), count.to_owned())).collect()
    };
    let (stored, present) = (split(stored), split(present));
    let mut table = Table::default();
    let none = || "(none)".to_owned();
    for (entry, count) in &stored {
        let now = present.iter().find(|(e, _)| e == entry).map(|(_, c)| c.clone());
        if now.as_ref() != Some(count) {
            table.push(|| Row::text(entry, "instructions", count, now.unwrap_or_else(none)));
        }
    }
    for (entry, count) in present.iter().filter(|(e, _)| !stored.iter().any(|(s, _)| s == e)) {
        table.push(|| Row::text(entry, "instructions", none(), count));
    }
    table.some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changed_new_and_vanished_entries_are_differences() {
        let stored = "head\na p main: 10\nb p main: 20\n";
        assert_eq!(compare(stored, stored), None);
        let table = compare(stored, "head\na p main: 11\nc p main: 5\n").unwrap();
        assert_eq!(table.total, 3);
        assert_eq!(table.rows[0], Row::text("a p main", "instructions", "10", "11"));
    }
}

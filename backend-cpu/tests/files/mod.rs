//! The WGSL files of a test folder.

use std::path::{Path, PathBuf};

/// Paths in `tests/<folder>`, sorted.
pub(crate) fn wgsl_files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder);
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut files: Vec<PathBuf> = entries.filter(|p| p.extension().is_some_and(|e| e == "wgsl")).collect();
    files.sort();
    files
}

//! Files that a command is to write: refused before the work where they cannot be, numbered where there are several.

use std::io;
use std::path::{Path, PathBuf};

use sightlines_visibility::error::Place;
use sightlines_visibility::{input, output};

/// Refuses targets that cannot be written, that are one file, or that would replace one that was read or that is named
/// there: so it is asked when everything is read.
pub(crate) fn check<'a>(targets: impl IntoIterator<Item = &'a Path>) -> sightlines_visibility::Result<()> {
    let mut taken: Vec<PathBuf> = Vec::new();
    for path in targets {
        output::probe(path)?;
        if input::is_source(path) || taken.contains(&real(path)) {
            let remedy = "give every result a file of its own";
            return Err(Place::file(path).error("the file is read, or is the target of another result", remedy));
        }
        taken.push(real(path));
    }
    Ok(())
}

/// A path by which a file is known whatever name it is given, whether it is there or not.
fn real(path: &Path) -> PathBuf {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let beside = || Ok(folder.canonicalize()?.join(path.file_name().unwrap_or_default()));
    path.canonicalize().or_else(|_: io::Error| beside()).unwrap_or_else(|_: io::Error| path.to_owned())
}

/// `a.png` of one; `a.0.png`, `a.1.png`, … of several.
pub(crate) fn numbered(path: &Path, number: usize, of: usize) -> PathBuf {
    if of == 1 {
        return path.to_owned();
    }
    let extension = path.extension().map_or_else(String::new, |e| format!(".{}", e.to_string_lossy()));
    path.with_extension(format!("{number}{extension}"))
}

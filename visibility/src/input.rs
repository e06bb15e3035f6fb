//! Files that are read whole, and never more of one than its format can need.
//!
//! Every file that the crate reads comes through here, and is remembered, so that no result is written over it.
//! Invariants: what is no file (a device or a pipe), and what has no size (such as a log of the system's that looks
//! like a file), may never end and is refused before it is opened; no more than the limit is held in memory, whatever
//! the system says of a size.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::error::{Error, Place, Result};

/// Files that were read and those that they name, by the one path that each has without links.
static SOURCES: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Whether a file was read in this process, or is named in one that was.
pub fn is_source(path: &Path) -> bool {
    let known = |path| SOURCES.lock().unwrap_or_else(PoisonError::into_inner).contains(&path);
    fs::canonicalize(path).is_ok_and(known)
}

/// Remembers a file that is read, or that one which is read names.
pub(crate) fn remember(path: &Path) {
    if let Ok(path) = fs::canonicalize(path) {
        SOURCES.lock().unwrap_or_else(PoisonError::into_inner).insert(path);
    }
}

/// The bytes of a file that has at most `most`; `remedy` is for one that has more.
pub(crate) fn read(path: &Path, most: u64, remedy: &str) -> Result<Vec<u8>> {
    let failed = |source| Error::read(path, source);
    let found = fs::metadata(path).map_err(failed)?;
    if !found.is_file() && !found.is_dir() {
        return Err(Place::file(path).error("neither a file nor a link to one", "copy its contents to a file"));
    }
    if found.is_file() && found.len() == 0 {
        let remedy = "write it anew; what a system shows as a file without a size must be copied to one";
        return Err(Place::file(path).error("the file is empty", remedy));
    }
    remember(path);
    let too_large = |size: u64| Place::file(path).error(format!("{size} bytes, at most {most} are read"), remedy);
    if found.is_file() && found.len() > most {
        return Err(too_large(found.len()));
    }
    let mut bytes = Vec::with_capacity(found.len() as usize);
    File::open(path).map_err(failed)?.take(most + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > most {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// The same for text.
pub(crate) fn read_text(path: &Path, most: u64, remedy: &str) -> Result<String> {
    let invalid = |e: std::string::FromUtf8Error| io::Error::new(io::ErrorKind::InvalidData, e.utf8_error());
    String::from_utf8(read(path, most, remedy)?).map_err(|e| Error::read(path, invalid(e)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_up_to_its_limit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, "four").unwrap();
        assert_eq!(read(&path, 4, "cut it").unwrap(), b"four");
        let message = read(&path, 3, "cut it").unwrap_err().to_string();
        assert!(message.ends_with("a: 4 bytes, at most 3 are read\n  remedy: cut it"), "{message}");
        fs::write(&path, b"\xff").unwrap();
        let message = read_text(&path, 3, "").unwrap_err().to_string();
        assert!(message.contains("invalid utf-8") && message.contains("save the file as UTF-8"), "{message}");
        assert!(read(folder.path(), 3, "").unwrap_err().to_string().contains("name a file, not a folder"));
    }

    #[cfg(unix)]
    #[test]
    fn what_never_ends_is_not_read() {
        for device in ["/dev/zero", "/dev/urandom"] {
            assert!(read(Path::new(device), 9, "").unwrap_err().to_string().contains("neither a file"), "{device}");
        }
    }

    #[test]
    fn an_empty_file_is_refused_and_so_is_one_of_the_systems_that_may_never_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        fs::write(&path, "").unwrap();
        let mut empty = vec![path.as_path()];
        if cfg!(target_os = "linux") {
            // The second one waits for messages of the kernel, for ever.
            empty.extend(["/proc/self/status", "/proc/kmsg"].map(Path::new));
        }
        for path in empty {
            let message = read(path, 9, "").unwrap_err().to_string();
            assert!(message.contains("the file is empty\n  remedy: write it anew"), "{message}");
        }
    }

    #[test]
    fn what_was_read_is_known_by_any_name() {
        let folder = tempfile::tempdir().unwrap();
        let [path, other, new] = ["a", "b", "c"].map(|name| folder.path().join(name));
        fs::write(&path, "four").unwrap();
        fs::write(&other, "four").unwrap();
        assert!(!is_source(&path));
        read(&path, 4, "").unwrap();
        assert!(is_source(&path) && is_source(&folder.path().join(".").join("a")));
        assert!(!is_source(&other) && !is_source(&new));
        remember(&other);
        assert!(is_source(&other));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(&path, &new).unwrap();
            assert!(is_source(&new));
        }
    }
}

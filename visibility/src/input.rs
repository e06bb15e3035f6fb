//! Files that are read whole, and never more of one than its format can need.
//!
//! Every file that the crate reads comes through here. Invariant: what is no file (a device or a pipe, which may never
//! end) is refused before it is opened, and no more than the limit is held in memory, whatever the system says of a size.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use crate::error::{Error, Place, Result};

/// The bytes of a file that has at most `most`; `remedy` is for one that has more.
pub(crate) fn read(path: &Path, most: u64, remedy: &str) -> Result<Vec<u8>> {
    let failed = |source| Error::read(path, source);
    let found = fs::metadata(path).map_err(failed)?;
    if !found.is_file() && !found.is_dir() {
        return Err(Place::file(path).error("neither a file nor a link to one", "copy its contents to a file"));
    }
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

    /// The system calls files of this folder empty, and they are not.
    #[cfg(target_os = "linux")]
    #[test]
    fn a_size_that_is_not_so_is_not_believed() {
        let message = read(Path::new("/proc/self/status"), 9, "").unwrap_err().to_string();
        assert!(message.contains("10 bytes, at most 9 are read"), "{message}");
    }
}

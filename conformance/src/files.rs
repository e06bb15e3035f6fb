//! Files written whole or not at all, and names that are safe in every file system.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// Root of the workspace that this suite was built from.
pub fn workspace() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."))
}

/// Writes a file through a temporary neighbour and a rename, so that no reader ever sees half of it.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(|e| Error::write(folder, e))?;
    }
    let mut temporary = OsString::from(path);
    temporary.push(format!(".{}.tmp", std::process::id()));
    let temporary = PathBuf::from(temporary);
    let written = fs::write(&temporary, bytes).and_then(|()| fs::rename(&temporary, path));
    written.map_err(|e| {
        // The write has already failed; what is left of the temporary file is only litter.
        let _ = fs::remove_file(&temporary);
        Error::write(path, e)
    })
}

/// A path as the reader of a message would type it: relative to the current folder where that is shorter.
pub fn shown(path: &Path) -> String {
    let here = std::env::current_dir().ok();
    let relative = here.as_deref().and_then(|h| path.strip_prefix(h).ok());
    relative.unwrap_or(path).display().to_string()
}

/// A path as one word of a command for a POSIX shell.
pub fn quoted(path: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-+:@%,=".contains(c);
    if !path.is_empty() && path.chars().all(plain) {
        path.to_owned()
    } else {
        format!("'{}'", path.replace('\'', "'\\''"))
    }
}

/// A number with its noun, in the plural where it is not one.
pub fn count(number: u64, noun: &str) -> String {
    format!("{number} {noun}{}", if number == 1 { "" } else { "s" })
}

/// Letters, digits, `_` and `-` of a name; everything else becomes one `_`.
pub fn slug(name: &str) -> String {
    let mut slug = String::new();
    for c in name.chars() {
        match c {
            c if c.is_ascii_alphanumeric() || c == '-' => slug.push(c),
            _ if slug.ends_with('_') => {}
            _ => slug.push('_'),
        }
    }
    slug.trim_matches('_').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_nothing_behind() {
        let folder = std::env::temp_dir().join(format!("sightlines-files-{}", std::process::id()));
        fs::create_dir_all(folder.join("taken")).unwrap();
        assert!(write_whole(&folder.join("taken"), b"x").is_err(), "a folder was overwritten");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        write_whole(&folder.join("deep/file"), b"x").unwrap();
        assert_eq!(fs::read(folder.join("deep/file")).unwrap(), b"x");
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn commands_keep_odd_names_in_one_word() {
        assert_eq!(quoted("target/a-b_c.job"), "target/a-b_c.job");
        assert_eq!(quoted("it's mine.job"), "'it'\\''s mine.job'");
    }

    #[test]
    fn slugs_are_plain() {
        assert_eq!(slug("wgpu:llvmpipe (LLVM 15.0.6, 256 bits)"), "wgpu_llvmpipe_LLVM_15_0_6_256_bits");
    }
}

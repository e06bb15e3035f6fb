//! Files that are whole or not there: written under another name in the target's folder, then renamed.
//!
//! A run that is killed while it writes leaves such a part behind. Parts are locked as long as their run lives, so the
//! next run with a target in the folder knows those that nobody will finish, and removes them.

use std::fs::{self, File};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::NamedTempFile;

use crate::error::{Error, Result};

const PREFIX: &str = ".sightlines-";
const SUFFIX: &str = ".part";

/// Age from which a part that is not locked is a leftover: a younger one may be about to be locked.
const LEFTOVER: Duration = Duration::from_secs(10);

/// What the formats write to.
pub(crate) trait Sink: Write + Seek {}

impl<T: Write + Seek> Sink for T {}

/// Refuses a target that cannot be written, before the work whose result it is to hold.
///
/// # Errors
///
/// [`Error::Write`]: its folder is missing or not writable, or it is there and not a file.
pub fn probe(path: &Path) -> Result<()> {
    let (_, target) = temporary(path).map_err(|source| Error::write(path, source))?;
    sweep(folder(&target));
    Ok(())
}

/// Removes the parts of runs that were killed.
fn sweep(folder: &Path) {
    let left = |file: &File| {
        let age = file.metadata().and_then(|found| found.modified()).ok().and_then(|time| time.elapsed().ok());
        age.is_some_and(|age| age > LEFTOVER) && file.try_lock().is_ok()
    };
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let is_part = name.to_str().is_some_and(|name| name.starts_with(PREFIX) && name.ends_with(SUFFIX));
        if is_part && File::open(entry.path()).is_ok_and(|file| left(&file)) {
            // One that cannot be removed harms nobody.
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn folder(target: &Path) -> &Path {
    target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Puts at `path` what `fill` writes. After an error the file is what it was before.
pub(crate) fn write(path: &Path, fill: impl FnOnce(&mut dyn Sink) -> io::Result<()>) -> Result<()> {
    let attempt = || {
        let (file, target) = temporary(path)?;
        let mut buffered = BufWriter::new(file);
        fill(&mut buffered)?;
        let file = buffered.into_inner().map_err(io::IntoInnerError::into_error)?;
        // A disk may tell only now that it is full.
        file.as_file().sync_all()?;
        file.persist(target).map_err(|e| e.error)?;
        Ok(())
    };
    attempt().map_err(|source| Error::write(path, source))
}

/// An empty file beside the target, and the target with links followed.
fn temporary(path: &Path) -> io::Result<(NamedTempFile, PathBuf)> {
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    match fs::metadata(&target) {
        Ok(found) if found.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
        Ok(found) if !found.is_file() => return Err(io::Error::new(io::ErrorKind::InvalidInput, "not a regular file")),
        Ok(found) if found.permissions().readonly() => return Err(io::ErrorKind::PermissionDenied.into()),
        _ => {}
    }
    if target.file_name().is_none() {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "not the name of a file"));
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    // The system's mask applies, as it does to any file that a program makes.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // The kind alone: the name of the temporary file tells nobody anything.
    let file = builder.tempfile_in(folder(&target)).map_err(|e| io::Error::from(e.kind()))?;
    // Without locks a leftover stays, and nothing else is lost.
    let _ = file.as_file().try_lock();
    Ok((file, target))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn a_file_is_whole_or_what_it_was() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        write(&path, |out| out.write_all(b"first")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"first");
        let full = |out: &mut dyn Sink| {
            out.write_all(&[0; 1 << 20])?;
            Err(io::ErrorKind::StorageFull.into())
        };
        let error = write(&path, full).unwrap_err().to_string();
        assert!(error.contains("a.png") && error.contains("make room"), "{error}");
        assert_eq!(fs::read(&path).unwrap(), b"first");
        write(&path, |out| out.write_all(b"second")).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        assert_eq!(names(folder.path()), ["a.png"], "nothing else is left");
    }

    #[test]
    fn a_probe_refuses_what_cannot_be_written_and_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        probe(&folder.path().join("new.png")).unwrap();
        assert_eq!(names(folder.path()), [""; 0]);
        let missing = probe(&folder.path().join("no/such/a.png")).unwrap_err().to_string();
        assert!(missing.contains("no/such/a.png") && missing.contains("make its folder"), "{missing}");
        let error = probe(folder.path()).unwrap_err().to_string();
        assert!(error.contains("name a file"), "{error}");
        for nameless in ["", "/", ".."] {
            assert!(matches!(probe(Path::new(nameless)), Err(Error::Write { .. })), "`{nameless}`");
        }
    }

    #[test]
    fn parts_of_killed_runs_are_removed_and_those_of_living_ones_are_not() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.png");
        let old = |name: &str| {
            let file = File::create(folder.path().join(name)).unwrap();
            file.set_modified(std::time::SystemTime::now() - 2 * LEFTOVER).unwrap();
            file
        };
        for left in [".sightlines-dead.part", "other.part", ".sightlines-mine"] {
            drop(old(left));
        }
        let living = old(".sightlines-living.part");
        living.lock().unwrap();
        fs::write(folder.path().join(".sightlines-young.part"), "").unwrap();
        probe(&target).unwrap();
        let mut left = names(folder.path());
        left.sort();
        assert_eq!(left, [".sightlines-living.part", ".sightlines-mine", ".sightlines-young.part", "other.part"]);
    }

    #[cfg(unix)]
    #[test]
    fn devices_are_not_replaced_links_are_followed_and_permissions_are_usual() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        assert!(probe(Path::new("/dev/null")).unwrap_err().to_string().contains("not a regular file"));
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real"), folder.path().join("link"));
        fs::write(&real, "old").unwrap();
        symlink(&real, &link).unwrap();
        write(&link, |out| out.write_all(b"new")).unwrap();
        assert_eq!(fs::read(&real).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
        let plain = folder.path().join("plain");
        fs::write(&plain, "").unwrap();
        assert_eq!(mode(&real), mode(&plain));
        fs::set_permissions(&plain, fs::Permissions::from_mode(0o444)).unwrap();
        assert!(probe(&plain).unwrap_err().to_string().contains("change the permissions"));
    }
}

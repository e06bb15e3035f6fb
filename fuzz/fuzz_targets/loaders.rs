//! Files of any kind, by the door that the tests of loaders go through: the first byte chooses the kind, the rest is
//! the file. A finding is a panic, a hang, too much memory, or an error that does not name the file and a remedy.
#![no_main]

#[path = "../../visibility/tests/loaders/every.rs"]
mod every;

use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;

static FOLDER: LazyLock<tempfile::TempDir> = LazyLock::new(|| tempfile::tempdir().expect("a folder for the files"));

fuzz_target!(|bytes: &[u8]| {
    let Some((choice, bytes)) = bytes.split_first() else { return };
    let mut bytes = bytes.to_vec();
    if choice & 0x80 != 0 {
        every::mend_digest(&mut bytes);
    }
    every::check(FOLDER.path(), every::KINDS[usize::from(choice & 0x7f) % every::KINDS.len()], &bytes);
});

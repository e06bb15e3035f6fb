//! A failing case as one file: the job, and behind it what was expected of it.
//!
//! The file *is* a job file (`Job::from_bytes` does not read what follows the mark of a record), so a browser page or
//! any other runner takes it as it is. The record behind the job lets `--replay` judge without the kernel's oracle: it
//! may come from another commit, or from a kernel that is not in the registry.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sightlines_backend::{Expected, Job, RECORD_MARK};

use crate::error::{Error, Result};
use crate::{diff, files};

const END: &[u8] = b"sightlines expected 1\n";

/// What a failing case was judged by.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Record {
    /// The kernel.
    pub kernel: String,
    /// The case.
    pub case: String,
    /// The machine that failed.
    pub machine: String,
    /// The failing check and its message.
    pub reason: String,
    /// What each output must hold; empty where no oracle could be asked.
    pub expected: Vec<Known>,
    /// The stored snapshot, where there was one.
    pub snapshot: Option<String>,
    /// Probes of the case, to render a snapshot for comparison.
    pub probes: Vec<u32>,
}

/// The words of one output that were known.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Known {
    /// Every word, as bytes.
    Whole(#[serde(with = "serde_bytes")] Vec<u8>),
    /// Pairs of index and word.
    Sample(Vec<(u32, u32)>),
}

impl From<&Expected> for Known {
    fn from(expected: &Expected) -> Self {
        match expected {
            Expected::Whole(words) => Known::Whole(words.iter().flat_map(|w| w.to_le_bytes()).collect()),
            Expected::Sample { words, .. } => Known::Sample(words.clone()),
        }
    }
}

impl Record {
    /// The answers that were known, for a run with these outputs; an output of which nothing was known agrees.
    pub fn expected(&self, outputs: &[Vec<u8>]) -> Vec<Expected> {
        let all = outputs.iter().enumerate();
        let answers = all.map(|(index, output)| match self.expected.get(index) {
            Some(Known::Whole(bytes)) => Expected::Whole(diff::words(bytes).collect()),
            Some(Known::Sample(words)) => Expected::Sample { words: words.clone(), seed: 0 },
            None => Expected::Whole(diff::words(output).collect()),
        });
        answers.collect()
    }
}

/// Where the dump of a case stands.
pub fn path(out: &Path, record: &Record) -> PathBuf {
    let Record { kernel, case, machine, .. } = record;
    out.join(format!("{}-{}-{}.job", files::slug(kernel), files::slug(case), files::slug(machine)))
}

/// Writes a dump, whole or not at all.
pub fn write(out: &Path, job: &[u8], record: &Record) -> Result<PathBuf> {
    let path = path(out, record);
    let mut bytes = [job, RECORD_MARK].concat();
    let start = bytes.len();
    ciborium::into_writer(record, &mut bytes).map_err(|e| Error::write(&path, std::io::Error::other(e.to_string())))?;
    let length = (bytes.len() - start) as u64;
    bytes.extend(length.to_le_bytes());
    bytes.extend(END);
    files::write_whole(&path, &bytes)?;
    Ok(path)
}

/// Reads a dump, or a plain job file.
pub fn read(path: &Path) -> Result<(Job, Option<Record>)> {
    let bytes = std::fs::read(path).map_err(|e| Error::read(path, e))?;
    let (job, record) = split(&bytes).ok_or_else(|| {
        Error::Usage(format!("{}: the record behind the job is damaged\n  remedy: dump the case again", path.display()))
    })?;
    let job = Job::from_bytes(job).map_err(|e| Error::Usage(format!("{}: {e}", path.display())))?;
    Ok((job, record))
}

fn split(bytes: &[u8]) -> Option<(&[u8], Option<Record>)> {
    let Some(rest) = bytes.strip_suffix(END) else { return Some((bytes, None)) };
    let (rest, length) = rest.split_last_chunk::<8>()?;
    let start = rest.len().checked_sub(usize::try_from(u64::from_le_bytes(*length)).ok()?)?;
    let record = ciborium::from_reader(&rest[start..]).ok()?;
    Some((rest[..start].strip_suffix(RECORD_MARK)?, Some(record)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dump_is_a_job_file_with_a_record_and_damage_is_named() {
        let folder = std::env::temp_dir().join(format!("sightlines-dump-{}", std::process::id()));
        let mut job = Job::new();
        let buffer = job.upload("words", &[1u32, 2, 3]);
        job.read("words", buffer);
        let record = Record {
            kernel: "copy".into(),
            case: "three".into(),
            machine: "wgpu:any (thing)".into(),
            expected: vec![Known::Sample(vec![(1, 7)])],
            ..Record::default()
        };
        let path = write(&folder, &job.to_bytes(), &record).unwrap();
        assert_eq!(path.file_name().unwrap(), "copy-three-wgpu_any_thing.job");
        let (back, again) = read(&path).unwrap();
        assert_eq!((back.reads.len(), again.as_ref()), (1, Some(&record)));
        let outputs = [[1u32, 2, 3].iter().flat_map(|w| w.to_le_bytes()).collect::<Vec<u8>>()];
        let table = diff::oracle(&back.reads, &record.expected(&outputs), &outputs).unwrap();
        assert_eq!((table.total, table.rows[0].expected.as_str()), (1, "0x00000007"));

        let mut bytes = std::fs::read(&path).unwrap();
        assert_eq!(Job::from_bytes(&bytes).unwrap().reads, job.reads, "a dump is not a job file");
        let at = bytes.len() - END.len() - 8;
        bytes[at..at + 8].fill(0xff);
        std::fs::write(&path, &bytes).unwrap();
        assert!(matches!(read(&path), Err(Error::Usage(_))));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}

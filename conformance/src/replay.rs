//! Runs a dumped job again and judges it by what was known when it was dumped.

use std::path::Path;

use sightlines_backend::{Case, Size};

use crate::dump::{self, Record};
use crate::error::Result;
use crate::plan::{Selected, Stored};

/// A dump, or a plain job file, as a case.
pub fn load(path: &Path) -> Result<Selected> {
    let (job, record) = dump::read(path)?;
    let has_oracle = record.as_ref().is_some_and(|r| !r.expected.is_empty());
    let name = || path.file_stem().map_or_else(|| "job".into(), |s| s.to_string_lossy().into_owned());
    let record = record.unwrap_or_else(|| Record { kernel: "replay".into(), case: name(), ..Record::default() });
    let (kernel, case, probes) = (record.kernel.clone(), record.case.clone(), record.probes.clone());
    let stored = record.snapshot.clone().map_or(Stored::Never, Stored::Text);
    let case = Case::new(case, Size::Small, move || Ok(job.clone()), move |outputs| record.expected(outputs));
    Ok(Selected { kernel, case: case.probes(probes), has_oracle, stored })
}

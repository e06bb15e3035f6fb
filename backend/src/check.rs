//! Every rule by which a device would refuse work, checked once for all backends.

use crate::{Job, Result};

/// Checks a whole job.
pub fn job(_job: &Job) -> Result<()> {
    Ok(())
}

//! Portability lints over the module: what must not decide an output bit.

use naga::valid::ModuleInfo;

use crate::{Linked, Result};

/// Checks every function of a program.
pub fn check(_module: &naga::Module, _info: &ModuleInfo, _linked: &Linked) -> Result<()> {
    Ok(())
}

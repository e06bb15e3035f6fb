//! Stands where the interpreter will: says that it is not built in, so that nothing can mistake it for a result.

use std::fmt;
use std::sync::Arc;

use sightlines_backend::{Backend, BackendInfo, BufferDesc, ErrorKind, Program, Result, Session};

pub(crate) struct CpuBackend;

#[derive(Default)]
pub(crate) struct Config {
    pub(crate) threads: usize,
    pub(crate) bounds: Bounds,
    pub(crate) count: bool,
}

#[derive(Default)]
pub(crate) enum Bounds {
    #[default]
    Trap,
}

pub(crate) struct Lowered;

impl fmt::Display for Lowered {
    fn fmt(&self, _: &mut fmt::Formatter<'_>) -> fmt::Result {
        Ok(())
    }
}

impl Lowered {
    pub(crate) fn instructions(&self) -> usize {
        0
    }
}

fn absent() -> sightlines_backend::Error {
    ErrorKind::Unsupported {
        backend: "cpu",
        feature: "the interpreter".into(),
        location: None,
        remedy: "build with it".into(),
    }
    .into()
}

impl CpuBackend {
    pub(crate) fn new(_: Config) -> Self {
        CpuBackend
    }

    pub(crate) fn lowered(_: &Program, _: &str, _: &[(String, f64)]) -> Result<Lowered> {
        Err(absent())
    }
}

impl Backend for CpuBackend {
    fn info(&self) -> BackendInfo {
        BackendInfo { backend: "cpu", adapter: "absent".into(), driver: String::new(), threads: None }
    }

    fn open(&self, _: &[Arc<Program>], _: &[BufferDesc]) -> Result<Box<dyn Session + '_>> {
        Err(absent())
    }
}

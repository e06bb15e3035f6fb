//! The GPU backend: runs jobs on Vulkan, Metal or Direct3D 12 through wgpu.
//!
//! A [`WgpuBackend`] is one device of one adapter, with the pipelines compiled for it so far. The device is requested
//! with WebGPU's *default* limits and no optional feature, whatever more the adapter could do, so that a job that runs
//! here runs on every WebGPU device. Programs go in as the contract's own [`naga::Module`], never as text, and all of
//! wgpu's run-time checks (bounds, loops, integer division) stay on.
//!
//! Invariants:
//!
//! * a [`Recording`](sightlines_backend::Recording) is waited for before `submit` returns, so a recording of bounded
//!   cost is a call of bounded time;
//! * commands take effect in their order, uploads included;
//! * what goes wrong in the device or its driver is a typed [`DeviceError`](sightlines_backend::DeviceError). After a
//!   lost device or a timeout the backend refuses all further work with that first error; open a new one.
//!
//! OpenGL runs only when [`WgpuOptions::backends`] or `WGPU_BACKEND` names it. It serves smoke tests, not results: its
//! shaders have no guard around integer `/` and `%`, no bounds checks, and its waits do not heed the limit of time.

mod adapter;
mod device;
mod pipeline;
mod readback;
mod submit;

use std::sync::Arc;

use sightlines_backend::{Backend, BackendInfo, BufferDesc, Job, Outputs, Program, Result, Session, check};

use crate::device::Device;
use crate::pipeline::Pipelines;
use crate::submit::WgpuSession;

pub use crate::adapter::{AdapterReport, WgpuOptions};
pub use wgpu::{Backends, DeviceType};

/// One device, ready to run jobs.
#[derive(Debug)]
pub struct WgpuBackend {
    report: AdapterReport,
    device: Device,
    pipelines: Pipelines,
}

impl WgpuBackend {
    /// Opens the adapter that `options` choose; see [`WgpuOptions`] for the rules.
    ///
    /// # Errors
    ///
    /// [`DeviceError::NoAdapter`](sightlines_backend::DeviceError::NoAdapter) where no adapter has the wanted name, or
    /// the chosen one does not reach WebGPU's default limits. A fallback never takes the place of what was asked for.
    pub fn new(options: &WgpuOptions) -> Result<Self> {
        let (adapter, report) = adapter::choose(options)?;
        let device = Device::open(&adapter, &report, options.timeout)?;
        Ok(WgpuBackend { report, device, pipelines: Pipelines::default() })
    }

    /// Every adapter of the wanted graphics interfaces, the preferred one first. [`AdapterReport::chosen`] marks the
    /// one that [`WgpuBackend::new`] would open.
    pub fn adapters(options: &WgpuOptions) -> Vec<AdapterReport> {
        adapter::reports(options)
    }

    /// The adapter that runs the work.
    pub fn adapter(&self) -> &AdapterReport {
        &self.report
    }

    /// Number of pipelines compiled so far: one for each entry point and set of overrides, however often they run.
    pub fn compiled_pipelines(&self) -> usize {
        self.pipelines.len()
    }

    /// The device itself, for callers that share it with other work.
    pub fn device(&self) -> &wgpu::Device {
        self.device.raw()
    }
}

impl Backend for WgpuBackend {
    fn info(&self) -> BackendInfo {
        BackendInfo {
            backend: "wgpu",
            adapter: self.report.name.clone(),
            driver: format!("{}: {}", self.report.backend, self.report.driver),
            threads: None,
        }
    }

    fn open(&self, programs: &[Arc<Program>], buffers: &[BufferDesc]) -> Result<Box<dyn Session + '_>> {
        check::buffers(buffers)?;
        Ok(Box::new(WgpuSession::open(&self.device, &self.pipelines, programs, buffers)?))
    }

    // The check of the whole job stands for the checks that a session fed by hand makes at each step.
    fn run(&self, job: &Job) -> Result<Outputs> {
        check::job(job)?;
        let mut session = WgpuSession::open(&self.device, &self.pipelines, &job.programs, &job.buffers)?;
        job.recordings.iter().try_for_each(|recording| session.run(recording))?;
        job.reads.iter().map(|read| session.fetch(read)).collect()
    }
}

//! Which machine runs the kernels, and why.

use sightlines_backend::{Backend, BackendInfo, Result};
use sightlines_backend_cpu::{Config, CpuBackend};
use sightlines_backend_wgpu::{WgpuBackend, WgpuOptions};
use sightlines_visibility::error::Place;

use super::Failure;
use super::cli::{BackendName, MachineArgs};

/// Opens the machine that the command line asks for. What it names is what runs, or an error; `auto` without an
/// adapter's name takes a GPU if there is one, and never a software adapter, which the interpreter outruns. With
/// `count` the interpreter counts semantic costs, which takes it longer.
pub(crate) fn open(args: &MachineArgs, count: bool) -> Result<Box<dyn Backend>, Failure> {
    match (args.backend, &args.adapter) {
        (BackendName::Cpu, Some(_)) => {
            Err(contradiction("--adapter", "the interpreter has none", "leave out one of the two"))
        }
        (BackendName::Wgpu, _) if args.threads.is_some() => {
            Err(contradiction("--threads", "only the interpreter has threads to choose", "leave out one of the two"))
        }
        (BackendName::Cpu, None) => Ok(interpreter(args, count)),
        (BackendName::Wgpu, adapter) | (BackendName::Auto, adapter @ Some(_)) => Ok(wgpu(adapter.clone())?),
        (BackendName::Auto, None) => {
            let adapters = WgpuBackend::adapters(&WgpuOptions::default());
            let hardware = adapters.iter().any(|a| a.chosen && !a.software && a.lacks.is_empty());
            if hardware && args.threads.is_none() { Ok(wgpu(None)?) } else { Ok(interpreter(args, count)) }
        }
    }
}

fn contradiction(option: &str, what: &str, remedy: &str) -> Failure {
    Failure::Work(Place::default().element(option).error(what, remedy))
}

fn interpreter(args: &MachineArgs, count: bool) -> Box<dyn Backend> {
    let config = Config { threads: args.threads.map_or(0, usize::from), count, ..Config::default() };
    Box::new(CpuBackend::new(config))
}

fn wgpu(adapter: Option<String>) -> Result<Box<dyn Backend>> {
    Ok(Box::new(WgpuBackend::new(&WgpuOptions { adapter, ..WgpuOptions::default() })?))
}

/// Backend, adapter, driver and threads in one line.
pub(crate) fn describe(info: &BackendInfo) -> String {
    let BackendInfo { backend, adapter, driver, threads } = info;
    let driver = if driver.is_empty() { String::new() } else { format!(" ({driver})") };
    let threads = threads.map_or_else(String::new, |n| format!(", {n} {}", if n == 1 { "thread" } else { "threads" }));
    format!("{backend}, {adapter}{driver}{threads}")
}

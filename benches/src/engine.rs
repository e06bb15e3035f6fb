//! The machines that are compared, found without loading a driver into the coordinating process.

use std::fmt;
use std::thread::available_parallelism;
use std::time::Duration;

use serde::{Deserialize, Serialize};
use sightlines_backend::{Backend, DeviceError, Result as BackendResult};
use sightlines_backend_cpu::{Config, CpuBackend, Simd};
use sightlines_backend_wgpu::{Backends, WgpuBackend, WgpuOptions};

use crate::error::{Error, Result};

/// Part of the name of lavapipe's adapter, the engine that the interpreter is measured against.
pub const LAVAPIPE: &str = "llvmpipe";

/// How to get lavapipe.
pub const INSTALL_LAVAPIPE: &str = "apt-get install mesa-vulkan-drivers";

/// How many threads an engine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Threads {
    /// One, pinned to one core.
    One,
    /// One a core.
    All,
}

impl Threads {
    /// Their number.
    pub fn count(self) -> usize {
        match self {
            Threads::One => 1,
            Threads::All => available_parallelism().map_or(1, usize::from),
        }
    }
}

impl fmt::Display for Threads {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.count();
        write!(f, "{count} {}", if count == 1 { "thread" } else { "threads" })
    }
}

/// An adapter as its child process reports it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Adapter {
    /// Its own name.
    pub name: String,
    /// Name and version of its driver.
    pub driver: String,
    /// Graphics interface: `vulkan`, `metal`, `dx12` or `gl`.
    pub api: String,
    /// Limits of WebGPU that it does not reach.
    pub lacks: Vec<String>,
}

/// A machine.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Engine {
    /// The interpreter at a SIMD level, by [`Simd::name`].
    Cpu {
        /// The level.
        simd: String,
    },
    /// An adapter.
    Wgpu(Adapter),
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Engine::Cpu { simd } => write!(f, "interpreter {simd}"),
            Engine::Wgpu(adapter) => f.write_str(adapter.name.split(" (").next().unwrap_or(&adapter.name)),
        }
    }
}

impl Engine {
    /// `cpu` or `wgpu`.
    pub fn backend(&self) -> &'static str {
        match self {
            Engine::Cpu { .. } => "cpu",
            Engine::Wgpu(_) => "wgpu",
        }
    }

    /// Whether this is the engine that ratios are formed to.
    pub fn is_lavapipe(&self) -> bool {
        matches!(self, Engine::Wgpu(adapter) if adapter.name.contains(LAVAPIPE) && adapter.api != "gl")
    }

    /// Opens it, and nothing else: an answer by another adapter is an error.
    pub fn open(&self, threads: Threads) -> BackendResult<Box<dyn Backend>> {
        match self {
            Engine::Cpu { simd } => {
                let simd = Simd::available().into_iter().find(|level| level.name() == simd);
                Ok(Box::new(CpuBackend::new(Config { threads: threads.count(), simd, ..Config::default() })))
            }
            Engine::Wgpu(wanted) => {
                let backends = Some(Backends::from_comma_list(&wanted.api));
                let timeout = Duration::from_secs(300);
                let options = WgpuOptions { adapter: Some(wanted.name.clone()), backends, timeout };
                let backend = WgpuBackend::new(&options)?;
                let found = backend.adapter();
                if (&found.name, &found.driver) != (&wanted.name, &wanted.driver) {
                    let reason = format!("`{}` ({}) answered", found.name, found.driver);
                    return Err(DeviceError::NoAdapter { wanted: Some(wanted.name.clone()), reason }.into());
                }
                Ok(Box::new(backend))
            }
        }
    }
}

/// Every adapter of Vulkan, Metal and Direct3D 12, or of the interfaces that `WGPU_BACKEND` names.
pub fn adapters_here() -> Vec<Adapter> {
    let reports = WgpuBackend::adapters(&WgpuOptions::default());
    let adapter = |r: sightlines_backend_wgpu::AdapterReport| Adapter {
        name: r.name,
        driver: r.driver,
        api: r.backend.to_owned(),
        lacks: r.lacks,
    };
    reports.into_iter().map(adapter).collect()
}

/// The adapters that take part: all usable ones, or lavapipe where it exists and those that fit a name.
pub fn choose(found: &[Adapter], names: &[String]) -> Result<Vec<Adapter>> {
    let fits = |a: &Adapter, name: &str| {
        let name = name.to_lowercase();
        a.name.to_lowercase().contains(&name) || a.driver.to_lowercase().contains(&name)
    };
    for name in names {
        match found.iter().find(|a| fits(a, name)) {
            None => {
                let all: Vec<&str> = found.iter().map(|a| a.name.as_str()).collect();
                let all = if all.is_empty() { "none".to_owned() } else { all.join(", ") };
                return Err(Error::Missing(format!("no adapter matches `{name}` (found: {all})")));
            }
            Some(a) if !a.lacks.is_empty() => {
                let lacks = a.lacks.join("; ");
                return Err(Error::Missing(format!("`{}` does not reach WebGPU's limits: {lacks}", a.name)));
            }
            Some(_) => {}
        }
    }
    let wanted = |a: &&Adapter| {
        let named = names.is_empty() || names.iter().any(|name| fits(a, name));
        a.lacks.is_empty() && (named || Engine::Wgpu((*a).clone()).is_lavapipe())
    };
    let mut chosen: Vec<Adapter> = Vec::new();
    for adapter in found.iter().filter(wanted) {
        if !chosen.contains(adapter) {
            chosen.push(adapter.clone());
        }
    }
    chosen.sort_by_key(|a| !Engine::Wgpu(a.clone()).is_lavapipe());
    Ok(chosen)
}

/// Ends with an error unless `required` (`wgpu` or part of an adapter's name or driver) is among the chosen adapters.
pub fn require(required: &str, chosen: &[Adapter], trouble: Option<&str>) -> Result<()> {
    let wanted = required.to_lowercase();
    let part = |text: &str| text.to_lowercase().contains(&wanted);
    if chosen.iter().any(|a| wanted == "wgpu" || part(&a.name) || part(&a.driver)) {
        return Ok(());
    }
    let reason = trouble.map_or_else(String::new, |trouble| format!("\n  reason: {trouble}"));
    Err(Error::Missing(format!(
        "`{required}` is required and does not take part{reason}\n  remedy: for lavapipe, {INSTALL_LAVAPIPE}"
    )))
}

/// The interpreter's engines: the named levels, `all` of them, or the best.
pub fn interpreters(levels: &[String]) -> Result<Vec<Engine>> {
    let available: Vec<&str> = Simd::available().into_iter().map(Simd::name).collect();
    if levels.is_empty() {
        let best = available.last().copied().unwrap_or_else(|| Simd::Baseline.name());
        return Ok(vec![Engine::Cpu { simd: best.to_owned() }]);
    }
    let mut engines = Vec::new();
    let all = levels.iter().any(|level| level == "all");
    let levels = if all { available.clone() } else { levels.iter().map(String::as_str).collect() };
    for level in levels {
        if !available.contains(&level) {
            let all = available.join(", ");
            return Err(Error::Missing(format!("this machine has no SIMD level `{level}` (it has: {all})")));
        }
        let engine = Engine::Cpu { simd: level.to_owned() };
        if !engines.contains(&engine) {
            engines.push(engine);
        }
    }
    Ok(engines)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn adapter(name: &str, lacks: &[&str]) -> Adapter {
        let lacks = lacks.iter().map(|s| (*s).to_owned()).collect();
        Adapter { name: name.into(), driver: "driver".into(), api: "vulkan".into(), lacks }
    }

    fn chosen(found: &[Adapter], names: &[&str]) -> Result<Vec<String>> {
        let names: Vec<String> = names.iter().map(|s| (*s).to_owned()).collect();
        choose(found, &names).map(|chosen| chosen.into_iter().map(|a| a.name).collect())
    }

    #[test]
    fn lavapipe_goes_first_and_takes_part_beside_what_is_named() {
        let found = [adapter("GTX", &[]), adapter("SwiftShader", &[]), adapter("llvmpipe (LLVM 15)", &[])];
        assert_eq!(chosen(&found, &[]).unwrap(), ["llvmpipe (LLVM 15)", "GTX", "SwiftShader"]);
        assert_eq!(chosen(&found, &["swift"]).unwrap(), ["llvmpipe (LLVM 15)", "SwiftShader"]);
        assert_eq!(chosen(&found[..1], &[]).unwrap(), ["GTX"]);
        assert!(chosen(&[], &[]).unwrap().is_empty());
    }

    #[test]
    fn what_is_named_and_cannot_be_had_is_missing() {
        let found = [adapter("GTX", &["storage buffers is 4, 8 needed"])];
        assert!(chosen(&found, &[]).unwrap().is_empty(), "a poor adapter is not chosen");
        for name in ["gtx", "radeon"] {
            assert!(matches!(chosen(&found, &[name]), Err(Error::Missing(_))));
        }
        assert!(matches!(interpreters(&["mmx".to_owned()]), Err(Error::Missing(_))));
    }

    #[test]
    fn the_best_level_is_the_default() {
        let best = Simd::available().last().unwrap().name().to_owned();
        assert_eq!(interpreters(&[]).unwrap(), [Engine::Cpu { simd: best.clone() }]);
        assert_eq!(interpreters(&["all".to_owned()]).unwrap().len(), Simd::available().len());
        assert_eq!(interpreters(&[best.clone(), best.clone()]).unwrap(), [Engine::Cpu { simd: best }]);
    }

    #[test]
    fn what_is_required_must_take_part() {
        for name in ["llvmpipe", "driver", "wgpu"] {
            require(name, &[adapter("llvmpipe (LLVM 15)", &[])], None).unwrap();
            assert!(matches!(require(name, &[], None), Err(Error::Missing(_))));
        }
        let error = require("radeon", &[], Some("no loader")).unwrap_err().to_string();
        assert!(error.contains("reason: no loader") && error.contains(INSTALL_LAVAPIPE), "{error}");
    }
}

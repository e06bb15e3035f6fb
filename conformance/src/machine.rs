//! The machines that cases run on, found without loading a driver into this process.
//!
//! A machine's name is `cpu`, or `wgpu:` and the adapter's short name; it is what reports, tests and the expectations
//! file call it. [`Machine::identity`] is who must answer: a run by anyone else is a failure, never a substitute.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use serde::{Deserialize, Serialize};
use sightlines_backend::{Backend, Result as BackendResult};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_backend_wgpu::{AdapterReport, Backends, WgpuBackend, WgpuOptions};

use crate::error::{Error, Result};
use crate::protocol::{self, Identity};

/// How to get a Vulkan device on a machine without a GPU.
pub const INSTALL_VULKAN: &str = "apt-get install mesa-vulkan-drivers";

/// One machine.
#[derive(Clone, Debug)]
pub struct Machine {
    /// `cpu`, or `wgpu:` and a name.
    pub name: String,
    /// How a worker opens it.
    pub wanted: Wanted,
    /// Who must answer.
    pub identity: Identity,
}

/// What a worker is told to open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// The interpreter, with one thread and with all.
    Cpu,
    /// The GPU backend.
    Wgpu {
        /// Name of the adapter.
        adapter: String,
        /// Graphics interface: `vulkan`, `metal`, `dx12` or `gl`.
        api: String,
    },
}

/// An adapter as discovery reports it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct AdapterEntry {
    /// The adapter's own name.
    pub name: String,
    /// Driver name and version.
    pub driver: String,
    /// Graphics interface: `vulkan`, `metal`, `dx12` or `gl`.
    pub api: String,
    /// `DiscreteGpu`, `Cpu` and so on.
    pub kind: String,
    /// Limits by name, for people.
    pub limits: Vec<(String, u64)>,
    /// Limits of WebGPU that it does not reach; it is usable if there are none.
    pub lacks: Vec<String>,
}

impl From<AdapterReport> for AdapterEntry {
    fn from(report: AdapterReport) -> Self {
        let limits = [
            ("buffer bytes", report.max_buffer),
            ("storage binding bytes", report.max_storage_binding),
            ("storage buffers a stage", u64::from(report.max_storage_buffers)),
            ("invocations a workgroup", u64::from(report.max_invocations)),
            ("workgroup memory bytes", u64::from(report.max_workgroup_memory)),
            ("storage offset alignment", u64::from(report.storage_alignment)),
        ];
        AdapterEntry {
            name: report.name,
            driver: report.driver,
            api: report.backend.to_owned(),
            kind: format!("{:?}", report.device_type),
            limits: limits.map(|(name, value)| (name.to_owned(), value)).into(),
            lacks: report.lacks,
        }
    }
}

/// A backend with the setting that a worker runs it in.
pub type Setting = (String, Box<dyn Backend>);

impl Wanted {
    /// Opens the machine, once for each of its settings.
    pub fn open(&self) -> BackendResult<Vec<Setting>> {
        match self {
            Wanted::Cpu => Ok(vec![
                ("1 thread".to_owned(), Box::new(interpreter(1)) as Box<dyn Backend>),
                ("all threads".to_owned(), Box::new(interpreter(0))),
            ]),
            Wanted::Wgpu { adapter, api } => {
                let backends = Some(Backends::from_comma_list(api));
                // The suite's own limit ends a run that does not end, and names the case.
                let timeout = Duration::from_secs(24 * 3600);
                let options = WgpuOptions { adapter: Some(adapter.clone()), backends, timeout };
                Ok(vec![(String::new(), Box::new(WgpuBackend::new(&options)?))])
            }
        }
    }

    /// Arguments of the worker subcommand.
    pub fn arguments(&self) -> Vec<String> {
        match self {
            Wanted::Cpu => vec!["cpu".into()],
            Wanted::Wgpu { adapter, api } => {
                vec!["wgpu".into(), "--adapter".into(), adapter.clone(), "--api".into(), api.clone()]
            }
        }
    }
}

/// Loop iterations that the workgroups of a gang may take together: far beyond any case, and seconds at most.
const FUEL: u64 = 1 << 26;

/// The interpreter as conformance runs it: out-of-range accesses trap, loops end soon, costs are counted.
pub fn interpreter(threads: usize) -> CpuBackend {
    CpuBackend::new(Config { threads, bounds: Bounds::Trap, fuel: FUEL, count: true, ..Config::default() })
}

impl Machine {
    /// The interpreter.
    pub fn cpu() -> Self {
        Machine { name: "cpu".into(), wanted: Wanted::Cpu, identity: interpreter(0).info().into() }
    }

    fn wgpu(entry: &AdapterEntry) -> Self {
        let identity = Identity {
            backend: "wgpu".into(),
            adapter: entry.name.clone(),
            driver: format!("{}: {}", entry.api, entry.driver),
            threads: None,
        };
        let wanted = Wanted::Wgpu { adapter: entry.name.clone(), api: entry.api.clone() };
        Machine { name: format!("wgpu:{}", short(entry)), wanted, identity }
    }
}

/// The adapter's name without its parenthesis and without spaces; behind `gl:` where it is OpenGL.
fn short(entry: &AdapterEntry) -> String {
    let name = entry.name.split(" (").next().unwrap_or(&entry.name);
    let name = name.replace(' ', "_");
    if entry.api == "gl" { format!("gl:{name}") } else { name }
}

/// What was asked for on the command line.
#[derive(Clone, Debug, Default)]
pub struct Asked {
    /// Run the interpreter.
    pub cpu: bool,
    /// Run GPUs.
    pub wgpu: bool,
    /// Adapters by part of their name; all but GL where empty.
    pub adapters: Vec<String>,
    /// What must be there: `cpu`, `wgpu` or part of an adapter's name.
    pub required: Vec<String>,
}

/// The machines of a run.
#[derive(Clone, Debug)]
pub struct Fleet {
    /// The machines, the interpreter first.
    pub machines: Vec<Machine>,
    /// Why no GPU takes part although GPUs were asked for.
    pub absent: Option<String>,
}

impl Fleet {
    /// Finds the machines asked for; missing ones that are required or named are an error.
    pub fn find(exe: &Path, asked: &Asked) -> Result<Self> {
        let mut machines = Vec::new();
        if asked.cpu {
            machines.push(Machine::cpu());
        }
        let found = if asked.wgpu { discover(exe) } else { Ok(Vec::new()) };
        let (adapters, trouble) = match found {
            Ok(adapters) => (adapters, None),
            Err(e) => (Vec::new(), Some(e.to_string())),
        };
        let chosen = choose(&adapters, &asked.adapters)?;
        if asked.wgpu {
            machines.extend(chosen.iter().map(|entry| Machine::wgpu(entry)));
        }
        make_names_unique(&mut machines);
        for required in &asked.required {
            require(required, &machines, trouble.as_deref())?;
        }
        let none = asked.wgpu && chosen.is_empty();
        let absent = none.then(|| trouble.unwrap_or_else(|| poor(&adapters)));
        if machines.is_empty() {
            let reason = absent.unwrap_or_else(|| "no backend was asked for".into());
            return Err(Error::Missing(format!("nothing to run on: {reason}\n  remedy: {INSTALL_VULKAN}")));
        }
        Ok(Fleet { machines, absent })
    }

    /// Whether a GPU takes part.
    pub fn has_wgpu(&self) -> bool {
        self.machines.iter().any(|m| m.identity.backend == "wgpu")
    }
}

/// Why none of the adapters found takes part.
fn poor(adapters: &[AdapterEntry]) -> String {
    let lacking = adapters.iter().filter(|a| a.api != "gl" && !a.lacks.is_empty());
    let lacking: Vec<String> = lacking.map(|a| format!("{}: {}", a.name, a.lacks.join("; "))).collect();
    if lacking.is_empty() {
        return "no Vulkan, Metal or DX12 adapter was found".into();
    }
    format!("no adapter reaches WebGPU's default limits ({})", lacking.join("; "))
}

fn require(required: &str, machines: &[Machine], trouble: Option<&str>) -> Result<()> {
    let wanted = required.to_lowercase();
    let part = |text: &str| text.to_lowercase().contains(&wanted);
    let is = |m: &Machine| m.identity.backend == wanted || part(&m.identity.adapter) || part(&m.identity.driver);
    if machines.iter().any(is) {
        return Ok(());
    }
    let names: Vec<&str> = machines.iter().map(|m| m.name.as_str()).collect();
    let trouble = trouble.map_or_else(String::new, |t| format!("\n  reason: {t}"));
    Err(Error::Missing(format!(
        "`{required}` is required and does not take part (taking part: {}){trouble}\n  \
         remedy: a software Vulkan device: {INSTALL_VULKAN}",
        names.join(", ")
    )))
}

/// The usable adapters but GL where no name is given, else those that fit a name.
fn choose<'a>(adapters: &'a [AdapterEntry], names: &[String]) -> Result<Vec<&'a AdapterEntry>> {
    if names.is_empty() {
        return Ok(adapters.iter().filter(|a| a.api != "gl" && a.lacks.is_empty()).collect());
    }
    let mut chosen: Vec<&AdapterEntry> = Vec::new();
    for name in names {
        let fitting = adapters.iter().filter(|a| fits(a, &name.to_lowercase())).collect::<Vec<_>>();
        if let Some(poor) = fitting.iter().find(|a| !a.lacks.is_empty()) {
            let lacks = poor.lacks.join("; ");
            return Err(Error::Missing(format!("`{}` does not reach WebGPU's default limits: {lacks}", poor.name)));
        }
        if fitting.is_empty() {
            let all: Vec<String> = adapters.iter().map(short).collect();
            let all = if all.is_empty() { "none".into() } else { all.join(", ") };
            return Err(Error::Missing(format!(
                "no adapter matches `{name}` (found: {all})\n  \
                 remedy: name one of these, or install a software Vulkan device: {INSTALL_VULKAN}"
            )));
        }
        for adapter in fitting {
            if !chosen.contains(&adapter) {
                chosen.push(adapter);
            }
        }
    }
    Ok(chosen)
}

/// Part of name or driver; OpenGL only where the name begins with `gl`.
fn fits(adapter: &AdapterEntry, wanted: &str) -> bool {
    if adapter.api == "gl" {
        return wanted.starts_with("gl") && short(adapter).to_lowercase().contains(wanted);
    }
    adapter.name.to_lowercase().contains(wanted) || adapter.driver.to_lowercase().contains(wanted)
}

fn make_names_unique(machines: &mut [Machine]) {
    for i in 1..machines.len() {
        let twins = machines[..i].iter().filter(|m| m.identity.adapter == machines[i].identity.adapter).count();
        if machines[..i].iter().any(|m| m.name == machines[i].name) {
            machines[i].name = format!("{}#{}", machines[i].name, twins + 1);
        }
    }
}

/// Every adapter that wgpu finds, GL included; the variable `WGPU_BACKEND` narrows the search.
pub fn adapters_here() -> Vec<AdapterEntry> {
    let narrowed = std::env::var("WGPU_BACKEND").is_ok_and(|v| !v.trim().is_empty());
    let backends = (!narrowed).then(Backends::all);
    let options = WgpuOptions { backends, ..WgpuOptions::default() };
    WgpuBackend::adapters(&options).into_iter().map(AdapterEntry::from).collect()
}

/// Lists all adapters in a child process, so that a driver that crashes while it loads cannot end the suite.
pub fn discover(exe: &Path) -> Result<Vec<AdapterEntry>> {
    let output = Command::new(exe)
        .arg("adapters")
        .stdin(Stdio::null())
        .output()
        .map_err(|e| Error::Worker(format!("{}: {e}", exe.display())))?;
    let listed = protocol::receive::<Vec<AdapterEntry>>(&mut output.stdout.as_slice()).ok().flatten();
    listed.filter(|_| output.status.success()).ok_or_else(|| {
        let said = String::from_utf8_lossy(&output.stderr);
        Error::Worker(format!("the search for adapters ended with {}: {}", output.status, said.trim()))
    })
}

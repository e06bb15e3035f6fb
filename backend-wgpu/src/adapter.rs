//! Which adapter runs the work: listing, choosing, and saying why one cannot be had.
//!
//! The choice is deterministic. Adapters are ordered (OpenGL last; then discrete, integrated, virtual, other and
//! software devices; then Vulkan, Metal, Direct3D 12; then name, driver and bus), and the first that matches is taken;
//! where a name is wanted, an equal name goes before one that contains it. wgpu's own selection is not used, because it
//! panics on a name that matches nothing.

use std::time::Duration;

use sightlines_backend::{DeviceError, Result};
use wgpu::{Adapter, Backends, DeviceType, Instance, InstanceDescriptor, InstanceFlags, Limits};

/// How to get a software device on a machine without a GPU.
const SOFTWARE: &str =
    "a software Vulkan device serves as well: on Debian or Ubuntu, `apt-get install mesa-vulkan-drivers`";

/// Which adapter to open, and how long to wait for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WgpuOptions {
    /// Part of the adapter's name or driver, in any case. `None`: `WGPU_ADAPTER_NAME`, or else the first adapter in
    /// the order of preference.
    pub adapter: Option<String>,
    /// Graphics interfaces to look at. `None`: `WGPU_BACKEND`, or else Vulkan, Metal and Direct3D 12.
    pub backends: Option<Backends>,
    /// Longest time that one submission may take.
    pub timeout: Duration,
}

impl Default for WgpuOptions {
    fn default() -> Self {
        WgpuOptions { adapter: None, backends: None, timeout: Duration::from_secs(60) }
    }
}

/// One adapter, as `doctor` shows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterReport {
    /// Its own name.
    pub name: String,
    /// Name and version of its driver.
    pub driver: String,
    /// Graphics interface: `vulkan`, `metal`, `dx12` or `gl`.
    pub backend: &'static str,
    /// Kind of device.
    pub device_type: DeviceType,
    /// Whether it is a program on the CPU rather than a GPU.
    pub software: bool,
    /// Whether [`WgpuBackend::new`](crate::WgpuBackend::new) would open it with the same options.
    pub chosen: bool,
    /// Largest buffer in bytes.
    pub max_buffer: u64,
    /// Largest storage binding in bytes.
    pub max_storage_binding: u64,
    /// Storage buffers of one entry point.
    pub max_storage_buffers: u32,
    /// Invocations of one workgroup.
    pub max_invocations: u32,
    /// Workgroup memory in bytes.
    pub max_workgroup_memory: u32,
    /// Smallest alignment of a storage binding in bytes.
    pub storage_alignment: u32,
    /// Smallest and largest subgroup.
    pub subgroups: (u32, u32),
    /// Limits of WebGPU that it does not reach; it is usable if there are none.
    pub lacks: Vec<String>,
}

impl AdapterReport {
    fn new(adapter: &Adapter) -> Self {
        let (info, limits) = (adapter.get_info(), adapter.limits());
        let mut lacks = Vec::new();
        Limits::defaults().check_limits_with_fail_fn(&limits, false, |limit, wanted, has| {
            lacks.push(format!("{limit} is {has}, {wanted} needed"));
        });
        AdapterReport {
            name: info.name,
            driver: [info.driver, info.driver_info].join(" ").trim().to_owned(),
            backend: info.backend.to_str(),
            device_type: info.device_type,
            software: info.device_type == DeviceType::Cpu,
            chosen: false,
            max_buffer: limits.max_buffer_size,
            max_storage_binding: limits.max_storage_buffer_binding_size,
            max_storage_buffers: limits.max_storage_buffers_per_shader_stage,
            max_invocations: limits.max_compute_invocations_per_workgroup,
            max_workgroup_memory: limits.max_compute_workgroup_storage_size,
            storage_alignment: limits.min_storage_buffer_offset_alignment,
            subgroups: (info.subgroup_min_size, info.subgroup_max_size),
            lacks,
        }
    }

    /// How well it fits a wanted name: 0 for an equal name, 1 for a part of name or driver.
    fn fit(&self, wanted: &str) -> Option<u8> {
        let (name, driver, wanted) = (self.name.to_lowercase(), self.driver.to_lowercase(), wanted.to_lowercase());
        if name == wanted { Some(0) } else { (name.contains(&wanted) || driver.contains(&wanted)).then_some(1) }
    }
}

/// What options and environment come to.
#[derive(Debug, PartialEq, Eq)]
struct Wanted {
    name: Option<String>,
    backends: Backends,
}

impl Wanted {
    /// Options go before the environment, the environment before the defaults.
    fn new(options: &WgpuOptions, variable: impl Fn(&str) -> Option<String>) -> Self {
        let named = |key| variable(key).filter(|value| !value.trim().is_empty());
        let backends = options.backends.or_else(|| named("WGPU_BACKEND").map(|list| Backends::from_comma_list(&list)));
        Wanted {
            name: options.adapter.clone().or_else(|| named("WGPU_ADAPTER_NAME")),
            backends: backends.unwrap_or(Backends::PRIMARY),
        }
    }

    fn from_env(options: &WgpuOptions) -> Self {
        Self::new(options, |key| std::env::var(key).ok())
    }
}

/// The adapter that `options` choose.
pub(crate) fn choose(options: &WgpuOptions) -> Result<(Adapter, AdapterReport)> {
    let wanted = Wanted::from_env(options);
    let mut found = list(&wanted);
    let reports = found.iter().map(|(_, report)| report.clone()).collect::<Vec<_>>();
    match pick(&wanted, &reports) {
        Some(index) => Ok(found.swap_remove(index)),
        None => Err(DeviceError::NoAdapter { reason: missing(&wanted, &reports), wanted: wanted.name }.into()),
    }
}

/// Every adapter of the wanted interfaces, in order of preference.
pub(crate) fn reports(options: &WgpuOptions) -> Vec<AdapterReport> {
    list(&Wanted::from_env(options)).into_iter().map(|(_, report)| report).collect()
}

fn list(wanted: &Wanted) -> Vec<(Adapter, AdapterReport)> {
    let backends = wanted.backends & usable();
    if backends.is_empty() {
        return Vec::new();
    }
    let mut descriptor = InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    // Group counts from a buffer must never pass the limit unchecked, whatever the environment says.
    descriptor.flags = descriptor.flags.with_env() | InstanceFlags::VALIDATION_INDIRECT_CALL;
    descriptor.backend_options = descriptor.backend_options.with_env();
    let adapters = pollster::block_on(Instance::new(descriptor).enumerate_adapters(backends));
    let mut found = adapters.into_iter().map(|a| (AdapterReport::new(&a), a)).collect::<Vec<_>>();
    found.sort_by_cached_key(|(report, adapter)| (rank(report), adapter.get_info().device_pci_bus_id));
    let mut found = found.into_iter().map(|(report, adapter)| (adapter, report)).collect::<Vec<_>>();
    let reports = found.iter().map(|(_, report)| report.clone()).collect::<Vec<_>>();
    if let Some(index) = pick(wanted, &reports) {
        found[index].1.chosen = true;
    }
    found
}

/// The interfaces that were compiled in and run kernels; wgpu's device that does nothing serves our own tests only.
fn usable() -> Backends {
    Instance::enabled_backend_features() - Backends::NOOP
}

fn rank(report: &AdapterReport) -> (bool, u8, u8, String, String) {
    let kind = match report.device_type {
        DeviceType::DiscreteGpu => 0,
        DeviceType::IntegratedGpu => 1,
        DeviceType::VirtualGpu => 2,
        DeviceType::Other => 3,
        DeviceType::Cpu => 4,
    };
    let interface = match report.backend {
        "vulkan" => 0,
        "metal" => 1,
        "dx12" => 2,
        _ => 3,
    };
    (report.backend == "gl", kind, interface, report.name.clone(), report.driver.clone())
}

/// The first of the ordered `reports` that fits best.
fn pick(wanted: &Wanted, reports: &[AdapterReport]) -> Option<usize> {
    let fit = |report: &AdapterReport| wanted.name.as_deref().map_or(Some(0), |name| report.fit(name));
    let fits = reports.iter().enumerate().filter_map(|(index, report)| Some((fit(report)?, index)));
    fits.min().map(|(_, index)| index)
}

fn missing(wanted: &Wanted, reports: &[AdapterReport]) -> String {
    let interfaces = wanted.backends & usable();
    if interfaces.is_empty() {
        return "none of the graphics interfaces asked for exists here".to_owned();
    }
    let interfaces = interfaces.iter_names().map(|(name, _)| name.to_lowercase()).collect::<Vec<_>>().join(", ");
    if reports.is_empty() {
        return format!("the machine has no driver for {interfaces}; {SOFTWARE}");
    }
    let names = reports.iter().map(|r| format!("`{}` ({}: {})", r.name, r.backend, r.driver)).collect::<Vec<_>>();
    format!("found {}", names.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(name: &str, driver: &str, backend: &'static str, device_type: DeviceType) -> AdapterReport {
        AdapterReport {
            name: name.into(),
            driver: driver.into(),
            backend,
            device_type,
            software: device_type == DeviceType::Cpu,
            chosen: false,
            max_buffer: 0,
            max_storage_binding: 0,
            max_storage_buffers: 0,
            max_invocations: 0,
            max_workgroup_memory: 0,
            storage_alignment: 0,
            subgroups: (0, 0),
            lacks: Vec::new(),
        }
    }

    fn machine() -> Vec<AdapterReport> {
        let mut reports = vec![
            report("GTX 10", "NVIDIA 5", "gl", DeviceType::DiscreteGpu),
            report("llvmpipe (LLVM 15)", "llvmpipe Mesa 22", "vulkan", DeviceType::Cpu),
            report("GTX 10", "NVIDIA 5", "dx12", DeviceType::DiscreteGpu),
            report("UHD 6", "Intel 9", "vulkan", DeviceType::IntegratedGpu),
            report("GTX 1070", "NVIDIA 5", "vulkan", DeviceType::DiscreteGpu),
            report("GTX 10", "NVIDIA 5", "vulkan", DeviceType::DiscreteGpu),
        ];
        reports.sort_by_key(rank);
        reports
    }

    fn picked(name: Option<&str>) -> Option<(String, &'static str)> {
        let wanted = Wanted { name: name.map(str::to_owned), backends: Backends::PRIMARY };
        let reports = machine();
        pick(&wanted, &reports).map(|index| (reports[index].name.clone(), reports[index].backend))
    }

    #[test]
    fn preference_puts_the_interface_gl_last_and_hardware_first() {
        let order = machine().into_iter().map(|r| (r.name, r.backend)).collect::<Vec<_>>();
        let expected = [
            ("GTX 10", "vulkan"),
            ("GTX 1070", "vulkan"),
            ("GTX 10", "dx12"),
            ("UHD 6", "vulkan"),
            ("llvmpipe (LLVM 15)", "vulkan"),
            ("GTX 10", "gl"),
        ];
        assert_eq!(order, expected.map(|(name, backend)| (name.to_owned(), backend)));
    }

    #[test]
    fn names_match_in_part_and_an_equal_name_goes_first() {
        assert_eq!(picked(None), Some(("GTX 10".into(), "vulkan")));
        assert_eq!(picked(Some("gtx 1070")), Some(("GTX 1070".into(), "vulkan")));
        assert_eq!(picked(Some("GTX 107")), Some(("GTX 1070".into(), "vulkan")));
        assert_eq!(picked(Some("mesa")), Some(("llvmpipe (LLVM 15)".into(), "vulkan")));
        assert_eq!(picked(Some("radeon")), None);
    }

    #[test]
    fn options_go_before_the_environment() {
        let env = |key: &str| match key {
            "WGPU_BACKEND" => Some("gl".to_owned()),
            "WGPU_ADAPTER_NAME" => Some("mesa".to_owned()),
            _ => None,
        };
        let defaults = WgpuOptions::default();
        assert_eq!(Wanted::new(&defaults, |_| None), Wanted { name: None, backends: Backends::PRIMARY });
        assert_eq!(Wanted::new(&defaults, |_| Some(" ".into())), Wanted { name: None, backends: Backends::PRIMARY });
        assert_eq!(Wanted::new(&defaults, env), Wanted { name: Some("mesa".into()), backends: Backends::GL });
        let options = WgpuOptions { adapter: Some("uhd".into()), backends: Some(Backends::VULKAN), ..defaults };
        assert_eq!(Wanted::new(&options, env), Wanted { name: Some("uhd".into()), backends: Backends::VULKAN });
    }

    #[test]
    fn a_missing_adapter_is_explained() {
        let wanted = |backends| Wanted { name: Some("radeon".into()), backends };
        assert!(missing(&wanted(Backends::VULKAN), &machine()).contains("`UHD 6` (vulkan: Intel 9)"));
        assert!(missing(&wanted(Backends::VULKAN), &[]).contains("apt-get install mesa-vulkan-drivers"));
        assert!(missing(&wanted(Backends::empty()), &[]).contains("none of the graphics interfaces"));
    }
}

//! What this machine can run: the interpreter, adapters, drivers and limits, the variables seen, what is missing.

use std::io::Write;
use std::path::Path;

use crate::error::{EXIT_MISSING, EXIT_OK, Result};
use crate::machine::{self, AdapterEntry, INSTALL_VULKAN, Machine};

/// Environment variables that change what runs or what is printed.
pub const VARIABLES: [&str; 12] = [
    "SIGHTLINES_REQUIRE",
    "WGPU_ADAPTER_NAME",
    "WGPU_BACKEND",
    "WGPU_VALIDATION",
    "WGPU_DEBUG",
    "VK_DRIVER_FILES",
    "VK_ICD_FILENAMES",
    "LP_NUM_THREADS",
    "RAYON_NUM_THREADS",
    "INSTA_UPDATE",
    "CI",
    "CARGO_TARGET_DIR",
];

/// Writes the findings; the answer is 3 where no GPU can take part.
pub fn report(exe: &Path, out: &mut dyn Write) -> Result<u8> {
    let cpu = Machine::cpu().identity;
    writeln!(out, "interpreter: {cpu}, up to {} threads", cpu.threads.map_or("?".into(), |n| n.to_string()))?;
    let found = machine::discover(exe);
    let adapters = found.as_ref().map_or(&[][..], Vec::as_slice);
    writeln!(out, "\nadapters: {}", adapters.len())?;
    for adapter in adapters {
        describe(adapter, out)?;
    }
    if let Err(e) = &found {
        writeln!(out, "  {e}")?;
    }
    writeln!(out, "\nvariables:")?;
    let seen = VARIABLES.iter().filter_map(|name| Some((name, std::env::var(name).ok()?)));
    let seen: Vec<_> = seen.collect();
    for (name, value) in &seen {
        writeln!(out, "  {name}={value}")?;
    }
    if seen.is_empty() {
        writeln!(out, "  none of {}", VARIABLES.join(", "))?;
    }
    let usable = adapters.iter().any(|a| a.api != "gl" && a.lacks.is_empty());
    writeln!(out, "\nmissing:")?;
    if usable {
        writeln!(out, "  nothing")?;
        return Ok(EXIT_OK);
    }
    writeln!(out, "  a Vulkan, Metal or DX12 device: the wgpu backend cannot be tested here")?;
    writeln!(out, "  remedy: install the driver of the GPU, or a software Vulkan device: {INSTALL_VULKAN}")?;
    Ok(EXIT_MISSING)
}

fn describe(adapter: &AdapterEntry, out: &mut dyn Write) -> Result<()> {
    let AdapterEntry { name, driver, api, kind, limits, lacks } = adapter;
    writeln!(out, "  {name}\n    {api}, {kind}, driver {driver}")?;
    let limits: Vec<String> = limits.iter().map(|(name, value)| format!("{name} {value}")).collect();
    writeln!(out, "    {}", limits.join(", "))?;
    for lack in lacks {
        writeln!(out, "    does not reach WebGPU's defaults: {lack}")?;
    }
    Ok(())
}

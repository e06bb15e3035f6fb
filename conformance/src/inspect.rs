//! What the registry holds: the list of kernels, and one kernel as linked text, naga IR or lowered code.

use std::io::Write;

use clap::ValueEnum;
use sightlines_backend::{Kernel, Program, Size};
use sightlines_backend_cpu::CpuBackend;

use crate::error::{Error, Result};

/// A form in which a kernel is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Emit {
    /// The linked WGSL.
    Wgsl,
    /// The naga module that every backend runs.
    Ir,
    /// The interpreter's lowered code.
    Code,
}

/// One line a kernel: name, number of cases, summary.
pub fn list(kernels: &[Kernel], out: &mut dyn Write) -> Result<()> {
    let width = kernels.iter().map(|k| k.name.len()).max().unwrap_or(0);
    for kernel in kernels {
        let cases = (kernel.cases)();
        let real = cases.iter().filter(|c| c.size == Size::Real).count();
        writeln!(out, "{:width$}  {} cases, {real} of real size  {}", kernel.name, cases.len(), kernel.summary)?;
    }
    Ok(())
}

/// A kernel's citation and every program of it, in one form.
pub fn show(kernels: &[Kernel], name: &str, emit: Emit, out: &mut dyn Write) -> Result<()> {
    let kernel = kernels.iter().find(|k| k.name == name).ok_or_else(|| {
        let names: Vec<&str> = kernels.iter().map(|k| k.name).collect();
        Error::Usage(format!("no kernel is called `{name}`\n  remedy: one of {}", names.join(", ")))
    })?;
    writeln!(out, "// {}: {}\n// {}", kernel.name, kernel.summary, kernel.citation.replace('\n', "\n// "))?;
    for program in (kernel.programs)()? {
        writeln!(out, "\n// program {} ({})", program.label(), program.id())?;
        match emit {
            Emit::Wgsl => writeln!(out, "{}", program.linked().text)?,
            Emit::Ir => writeln!(out, "{:#?}", program.module())?,
            Emit::Code => code(&program, out)?,
        }
    }
    Ok(())
}

fn code(program: &Program, out: &mut dyn Write) -> Result<()> {
    for entry in program.entries() {
        let lowered = CpuBackend::lowered(program, &entry.name, &[])?;
        writeln!(out, "\n// entry {}: {} instructions\n{lowered}", entry.name, lowered.instructions())?;
    }
    Ok(())
}

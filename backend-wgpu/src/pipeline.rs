//! Shader modules and compute pipelines, compiled once for each device.
//!
//! A pipeline is the entry point of a program under a set of overrides; programs are equal if their ids are. Layouts
//! are explicit, made from the contract's reflection, and hold exactly the bindings that the entry point uses, so the
//! slots of a dispatch are the entries of its bind groups.
//!
//! Overrides are applied to the module before wgpu sees it, by the contract's own function: wgpu would hold only their
//! defaults against the limit on workgroup size, and hand the driver a workgroup that is too large.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::num::NonZeroU64;
use std::sync::{Arc, Mutex};

use sightlines_backend::{Access, Binding, DeviceError, Dispatch, Entry, Error, ErrorKind, Program, Result};
use wgpu::{BindGroupLayout, BindGroupLayoutEntry, BindingType, BufferBindingType, ShaderStages};

use crate::device::{Device, lock, words};

/// Program id, entry point, and overrides with the bits of their values, sorted by name.
type Key = (String, String, Vec<(String, u64)>);

/// A compiled entry point.
#[derive(Debug)]
pub(crate) struct Pipeline {
    /// Unique within its backend.
    pub(crate) id: usize,
    /// The pipeline.
    pub(crate) raw: wgpu::ComputePipeline,
    /// Layouts of the bind groups it uses, by `@group`.
    pub(crate) layouts: BTreeMap<u32, BindGroupLayout>,
}

/// Everything compiled for one device.
#[derive(Debug, Default)]
pub(crate) struct Pipelines {
    modules: Mutex<HashMap<String, wgpu::ShaderModule>>,
    pipelines: Mutex<HashMap<Key, Arc<Pipeline>>>,
}

impl Pipelines {
    /// Number of pipelines.
    pub(crate) fn len(&self) -> usize {
        lock(&self.pipelines).len()
    }

    /// The module of a program.
    pub(crate) fn module(&self, device: &Device, program: &Program) -> Result<wgpu::ShaderModule> {
        let mut modules = lock(&self.modules);
        if let Some(module) = modules.get(program.id()) {
            return Ok(module.clone());
        }
        let module = shader_module(device, program.label(), program.module().clone())?;
        modules.insert(program.id().to_owned(), module.clone());
        Ok(module)
    }

    /// The module with the overrides of a dispatch applied, where there are any.
    fn specialised(&self, device: &Device, program: &Program, dispatch: &Dispatch) -> Result<wgpu::ShaderModule> {
        if program.module().overrides.is_empty() && dispatch.overrides.is_empty() {
            return self.module(device, program);
        }
        let (module, _) = program.specialise(&dispatch.entry, &dispatch.overrides)?;
        shader_module(device, program.label(), module.into_owned())
    }

    /// The pipeline that a dispatch runs.
    pub(crate) fn pipeline(&self, device: &Device, program: &Program, dispatch: &Dispatch) -> Result<Arc<Pipeline>> {
        let mut overrides =
            dispatch.overrides.iter().map(|(name, value)| (name.clone(), value.to_bits())).collect::<Vec<_>>();
        overrides.sort();
        let key = (program.id().to_owned(), dispatch.entry.clone(), overrides);
        let mut pipelines = lock(&self.pipelines);
        if let Some(pipeline) = pipelines.get(&key) {
            return Ok(Arc::clone(pipeline));
        }
        let entry = entry(program, &dispatch.entry)?;
        buffers_only(program, &entry.name)?;
        let module = self.specialised(device, program, dispatch)?;
        let pipeline = Arc::new(compile(device, program, &module, entry, pipelines.len())?);
        pipelines.insert(key, Arc::clone(&pipeline));
        Ok(pipeline)
    }
}

fn entry<'a>(program: &'a Program, name: &str) -> Result<&'a Entry> {
    program.entry(name).ok_or_else(|| {
        let names = program.entries().iter().map(|e| e.name.as_str()).collect::<Vec<_>>().join(", ");
        let what = format!("program `{}` has no entry point `{name}`", program.label());
        Error::refused(what, format!("its entry points are: {names}"))
    })
}

fn shader_module(device: &Device, label: &str, module: naga::Module) -> Result<wgpu::ShaderModule> {
    let source = wgpu::ShaderSource::Naga(Cow::Owned(module));
    let descriptor = wgpu::ShaderModuleDescriptor { label: Some(label), source };
    device.scoped_as(|error| refused(label, error), || Ok(device.raw().create_shader_module(descriptor)))
}

/// A program with textures or samplers is valid WGSL, but slots bind buffers only.
fn buffers_only(program: &Program, entry: &str) -> Result<()> {
    program.opaque(entry).into_iter().next().map_or(Ok(()), |opaque| {
        Err(ErrorKind::Unsupported {
            backend: "wgpu",
            feature: format!("binding `{}` of type {}", opaque.name, opaque.kind),
            location: opaque.location,
            remedy: "pass the data in a storage buffer".to_owned(),
        }
        .into())
    })
}

fn compile(
    device: &Device,
    program: &Program,
    module: &wgpu::ShaderModule,
    entry: &Entry,
    id: usize,
) -> Result<Pipeline> {
    let name = format!("{}::{}", program.label(), entry.name);
    device.scoped_as(
        |error| refused(&name, error),
        || {
            let used = entry.bindings.iter().map(|&index| &program.bindings()[index]);
            let layouts = layouts(device, used);
            // A group beyond the limit makes one layout too many, which the device refuses.
            let most = wgpu::Limits::defaults().max_bind_groups;
            let groups = layouts.keys().next_back().map_or(0, |&last| last.min(most) + 1);
            let slots = (0..groups).map(|group| layouts.get(&group)).collect::<Vec<_>>();
            let layout = device.raw().create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(&name),
                bind_group_layouts: &slots,
                immediate_size: 0,
            });
            let raw = device.raw().create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(&name),
                layout: Some(&layout),
                module,
                entry_point: Some(&entry.name),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                cache: None,
            });
            Ok(Pipeline { id, raw, layouts })
        },
    )
}

fn layouts<'a>(device: &Device, used: impl Iterator<Item = &'a Binding>) -> BTreeMap<u32, BindGroupLayout> {
    let mut groups = BTreeMap::<u32, Vec<BindGroupLayoutEntry>>::new();
    for binding in used {
        groups.entry(binding.group).or_default().push(layout_entry(binding));
    }
    let layout = |entries: &[BindGroupLayoutEntry]| {
        device.raw().create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries })
    };
    groups.into_iter().map(|(group, entries)| (group, layout(&entries))).collect()
}

fn layout_entry(binding: &Binding) -> BindGroupLayoutEntry {
    let ty = match binding.access {
        Access::Uniform => BufferBindingType::Uniform,
        Access::Read => BufferBindingType::Storage { read_only: true },
        Access::ReadWrite => BufferBindingType::Storage { read_only: false },
    };
    BindGroupLayoutEntry {
        binding: binding.binding,
        visibility: ShaderStages::COMPUTE,
        ty: BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: NonZeroU64::new(binding.min_size) },
        count: None,
    }
}

/// Whatever the device says against a module or a pipeline is a failure to compile it, unless memory ran out.
fn refused(entry: &str, error: &wgpu::Error) -> DeviceError {
    match error {
        wgpu::Error::OutOfMemory { .. } => DeviceError::OutOfMemory(words(error)),
        _ => DeviceError::Compile { entry: entry.to_owned(), reason: words(error) },
    }
}

//! link → parse → validate → lint → reflect: one [`naga::Module`] for every backend.

use std::borrow::Cow;
use std::collections::HashSet;
use std::sync::{Arc, Mutex, PoisonError};

use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::SimpleFiles;
use codespan_reporting::term;
use naga::back::pipeline_constants::process_overrides;
use naga::common::wgsl::TypeContext;
use naga::valid::ModuleInfo;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::error::{ErrorKind, Location};
use crate::front::{self, CompileLimits};
use crate::{Define, Error, Linked, Result, Sources};

/// How a kernel uses a binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// `var<uniform>`.
    Uniform,
    /// `var<storage, read>`.
    Read,
    /// `var<storage, read_write>`.
    ReadWrite,
}

/// A buffer binding of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Name of the variable.
    pub name: String,
    /// `@group`.
    pub group: u32,
    /// `@binding`.
    pub binding: u32,
    /// How it is used.
    pub access: Access,
    /// Smallest size in bytes that may be bound.
    pub min_size: u64,
}

/// An entry point of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Name.
    pub name: String,
    /// `@workgroup_size` where no override sets it.
    pub workgroup_size: [u32; 3],
    /// Indices into [`Program::bindings`] of what it uses, sorted by group and binding.
    pub bindings: Vec<usize>,
}

/// A module with override values applied, and what the validator says of it.
pub type Specialised<'a> = (Cow<'a, naga::Module>, Cow<'a, ModuleInfo>);

/// A binding that is no buffer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Opaque {
    /// Name of the variable.
    pub name: String,
    /// Its type, in WGSL.
    pub kind: String,
    /// Where it is declared.
    pub location: Option<Location>,
}

/// A linked, validated and linted program.
#[derive(Debug)]
pub struct Program {
    label: String,
    id: String,
    linked: Linked,
    lint: bool,
    module: naga::Module,
    info: ModuleInfo,
    bindings: Vec<Binding>,
    entries: Vec<Entry>,
    /// Entry points, with the bits of their override values, that have been found to fit a device.
    fitting: Mutex<HashSet<Variant>>,
}

/// An entry point and the bits of its override values.
type Variant = (String, Vec<(String, u64)>);

impl Program {
    /// Links `root` and compiles it under the portability lints.
    pub fn new(label: &str, root: &str, sources: &Sources, defines: &[Define]) -> Result<Arc<Self>> {
        Self::with_limits(label, Linked::link(root, sources, defines)?, true, &CompileLimits::default())
    }

    /// Compiles any WGSL, without the lints: kernels that do not promise the numerics contract.
    pub fn unlinted(label: &str, linked: Linked) -> Result<Arc<Self>> {
        Self::with_limits(label, linked, false, &CompileLimits::default())
    }

    /// Compiles linked text within limits of the caller's choice, with or without the lints.
    pub fn with_limits(label: &str, linked: Linked, lint: bool, limits: &CompileLimits) -> Result<Arc<Self>> {
        Self::compile(label, linked, lint, limits).map(Arc::new)
    }

    fn compile(label: &str, linked: Linked, lint: bool, limits: &CompileLimits) -> Result<Self> {
        let (module, info) = front::compile(&linked, lint, limits)?;
        let bindings = reflect_bindings(&module);
        let entries = reflect_entries(&module, &info, &bindings);
        if entries.is_empty() {
            let notes = vec!["a kernel begins with `@compute @workgroup_size(64) fn main() {`".to_owned()];
            let message = format!("`{label}` has no `@compute` entry point");
            return Err(diagnose(&linked, "validate", &message, &[], notes).into());
        }
        let id = blake3::hash(linked.text.as_bytes()).to_hex()[..16].to_owned();
        let (label, fitting) = (label.to_owned(), Mutex::default());
        Ok(Program { label, id, linked, lint, module, info, bindings, entries, fitting })
    }

    /// Name for people.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// Hash of the linked text: two programs with one id are the same program.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The text and its map.
    pub fn linked(&self) -> &Linked {
        &self.linked
    }

    /// The one module that all backends run.
    pub fn module(&self) -> &naga::Module {
        &self.module
    }

    /// What the validator found out about [`Program::module`].
    pub fn info(&self) -> &ModuleInfo {
        &self.info
    }

    /// All buffer bindings.
    pub fn bindings(&self) -> &[Binding] {
        &self.bindings
    }

    /// All entry points.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// An entry point by name.
    pub fn entry(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().find(|e| e.name == name)
    }

    /// Runs `check` on an entry point with override values unless it has passed before.
    pub(crate) fn check_once(
        &self,
        entry: &str,
        overrides: &[(String, f64)],
        check: impl FnOnce() -> Result<()>,
    ) -> Result<()> {
        let bits = overrides.iter().map(|(name, value)| (name.clone(), value.to_bits())).collect();
        let key = (entry.to_owned(), bits);
        let fitting = || self.fitting.lock().unwrap_or_else(PoisonError::into_inner);
        if !fitting().contains(&key) {
            check()?;
            fitting().insert(key);
        }
        Ok(())
    }

    /// The module and its info with override values applied and only `entry` kept: what a pipeline is made from.
    ///
    /// Values are named as in [`Dispatch::overrides`](crate::Dispatch::overrides). A program that has no overrides and
    /// one entry point is borrowed.
    pub fn specialise(&self, entry: &str, overrides: &[(String, f64)]) -> Result<Specialised<'_>> {
        let fail = |reason: &str| {
            let what = format!("`{entry}` of `{}` does not take these override values: {reason}", self.label);
            Error::refused(what, "give each `override` without a default a value of its type, under its name or `@id`")
        };
        let values = overrides.iter().cloned().collect();
        let stage = Some((naga::ShaderStage::Compute, entry));
        let process = || process_overrides(&self.module, &self.info, stage, &values).map_err(|e| e.to_string());
        let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(process));
        result.unwrap_or_else(|_| Err("naga panicked on them".into())).map_err(|reason| fail(&reason))
    }

    /// Textures, samplers and other bindings that are no buffers and that `entry` uses. They are not among
    /// [`Program::bindings`]; a backend that lacks them refuses with these lines.
    pub fn opaque(&self, entry: &str) -> Vec<Opaque> {
        let Some(index) = self.module.entry_points.iter().position(|e| e.name == entry) else { return Vec::new() };
        let uses = self.info.get_entry_point(index);
        let opaque = |space| matches!(space, naga::AddressSpace::Handle | naga::AddressSpace::Immediate);
        let globals = self.module.global_variables.iter();
        let used = globals.filter(|(handle, global)| opaque(global.space) && !uses[*handle].is_empty());
        used.map(|(handle, global)| Opaque {
            name: global.name.clone().unwrap_or_default(),
            kind: self.module.to_ctx().type_to_string(global.ty),
            location: self.locate(self.module.global_variables.get_span(handle)),
        })
        .collect()
    }

    /// The author's place of a span.
    pub fn locate(&self, span: naga::Span) -> Option<Location> {
        self.linked.locate(span.to_range()?.start)
    }
}

/// A message about spans of linked text, rendered on the authors' files.
pub(crate) fn diagnose(
    linked: &Linked,
    stage: &'static str,
    message: &str,
    labels: &[(naga::Span, String)],
    notes: Vec<String>,
) -> ErrorKind {
    let rendered = Renderer::new(linked).render(message, labels, notes);
    let location = labels.iter().find_map(|(span, _)| linked.locate(span.to_range()?.start));
    ErrorKind::Wgsl { stage, location, rendered }
}

/// Turns diagnostics about linked text into text that shows the authors' lines.
pub(crate) struct Renderer<'a> {
    linked: &'a Linked,
    files: SimpleFiles<&'a str, &'a str>,
}

impl<'a> Renderer<'a> {
    pub(crate) fn new(linked: &'a Linked) -> Self {
        let mut files = SimpleFiles::new();
        for file in &linked.files {
            let text = linked.text.get(file.start as usize..file.end as usize);
            files.add(file.path.as_str(), text.unwrap_or_default());
        }
        Renderer { linked, files }
    }

    pub(crate) fn render(&self, message: &str, labels: &[(naga::Span, String)], notes: Vec<String>) -> String {
        let marks = labels.iter().filter_map(|(span, text)| {
            let range = span.to_range()?;
            let index = self.linked.file_at(range.start)?;
            let file = &self.linked.files[index];
            let (start, end) = (file.start as usize, (file.end as usize).min(range.end).max(range.start));
            Some(Label::primary(index, range.start - start..end - start).with_message(text))
        });
        let diagnostic = Diagnostic::error().with_message(message).with_labels(marks.collect()).with_notes(notes);
        let mut rendered = String::new();
        match term::emit_to_string(&mut rendered, &term::Config::default(), &self.files, &diagnostic) {
            Ok(()) => rendered,
            Err(_) => format!("error: {message}\n"),
        }
    }
}

fn reflect_bindings(module: &naga::Module) -> Vec<Binding> {
    let mut layouter = naga::proc::Layouter::default();
    let known = layouter.update(module.to_ctx()).is_ok();
    let mut bindings = Vec::new();
    for (_, global) in module.global_variables.iter() {
        let Some(resource) = global.binding else { continue };
        let access = match global.space {
            naga::AddressSpace::Uniform => Access::Uniform,
            naga::AddressSpace::Storage { access } if access.contains(naga::StorageAccess::STORE) => Access::ReadWrite,
            naga::AddressSpace::Storage { .. } => Access::Read,
            _ => continue,
        };
        bindings.push(Binding {
            name: global.name.clone().unwrap_or_default(),
            group: resource.group,
            binding: resource.binding,
            access,
            min_size: if known { u64::from(layouter[global.ty].size) } else { 0 },
        });
    }
    bindings
}

fn reflect_entries(module: &naga::Module, info: &ModuleInfo, bindings: &[Binding]) -> Vec<Entry> {
    let mut entries = Vec::new();
    for (index, entry) in module.entry_points.iter().enumerate() {
        if entry.stage != naga::ShaderStage::Compute {
            continue;
        }
        let uses = info.get_entry_point(index);
        let mut used = Vec::new();
        for (handle, global) in module.global_variables.iter() {
            let Some(resource) = global.binding else { continue };
            if uses[handle].is_empty() {
                continue;
            }
            used.extend(bindings.iter().position(|b| (b.group, b.binding) == (resource.group, resource.binding)));
        }
        used.sort_by_key(|&i| (bindings[i].group, bindings[i].binding));
        entries.push(Entry { name: entry.name.clone(), workgroup_size: entry.workgroup_size, bindings: used });
    }
    entries
}

#[derive(Serialize, Deserialize)]
struct Stored {
    label: String,
    linked: Linked,
    lint: bool,
}

impl Serialize for Program {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Stored { label: self.label.clone(), linked: self.linked.clone(), lint: self.lint }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Program {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Stored { label, linked, lint } = Stored::deserialize(deserializer)?;
        Program::compile(&label, linked, lint, &CompileLimits::default()).map_err(serde::de::Error::custom)
    }
}

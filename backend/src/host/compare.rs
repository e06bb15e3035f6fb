//! Compares Rust layouts with naga's, and words every difference with both sides' numbers.
//!
//! Invariant: where [`entry`] returns `Ok`, each byte that the host writes is the byte that the kernel reads.

use naga::common::wgsl::TypeContext;
use naga::proc::Layouter;
use naga::{ArraySize, Handle, Module, ScalarKind, Type, TypeInner};

use super::{Declared, Extent, Field, Scalar, Shape};
use crate::error::ErrorKind;
use crate::{Access, Program, Result};

/// Compares a whole binding list with an entry point of a program.
pub(super) fn entry(name: &str, declared: &[Declared], program: &Program, entry: &str) -> Result<()> {
    let fail = |detail: String| ErrorKind::Layout { name: name.to_owned(), detail };
    let Some(found) = program.entry(entry) else {
        let known = program.entries().iter().map(|e| e.name.as_str()).collect::<Vec<_>>().join("`, `");
        return Err(fail(format!("`{}` has no entry point `{entry}`; it has `{known}`", program.label())).into());
    };
    let mut layouter = Layouter::default();
    if let Err(error) = layouter.update(program.module().to_ctx()) {
        return Err(fail(error.to_string()).into());
    }
    let mut check = Check { module: program.module(), layouter, differences: Vec::new() };
    for item in declared {
        check.binding(item, program, entry);
    }
    for binding in found.bindings.iter().map(|&index| &program.bindings()[index]) {
        if !declared.iter().any(|d| (d.group, d.binding) == (binding.group, binding.binding)) {
            check.differences.push(format!(
                "`{entry}` uses `{}` at group {} binding {}, Rust does not declare it",
                binding.name, binding.group, binding.binding
            ));
        }
    }
    if check.differences.is_empty() { Ok(()) } else { Err(fail(check.differences.join("\n  ")).into()) }
}

struct Check<'a> {
    module: &'a Module,
    layouter: Layouter,
    differences: Vec<String>,
}

impl Check<'_> {
    fn binding(&mut self, declared: &Declared, program: &Program, entry: &str) {
        let at = (declared.group, declared.binding);
        let name = declared.name;
        let used = program.entry(entry).into_iter().flat_map(|e| &e.bindings).map(|&index| &program.bindings()[index]);
        let Some(binding) = used.into_iter().find(|b| (b.group, b.binding) == at) else {
            self.push(format!("{name}: Rust declares group {} binding {}, `{entry}` does not use it", at.0, at.1));
            return;
        };
        if binding.name != name {
            self.push(format!("group {} binding {}: WGSL name `{}`, Rust name `{name}`", at.0, at.1, binding.name));
        }
        if binding.access != declared.access {
            let (wgsl, rust) = (access(binding.access), access(declared.access));
            self.push(format!("{name}: WGSL access {wgsl}, Rust access {rust}"));
        }
        let ty = self.module.global_variables.iter().find_map(|(_, global)| {
            global.binding.filter(|r| (r.group, r.binding) == at && global.name.as_deref() == Some(&binding.name))?;
            Some(global.ty)
        });
        let Some(ty) = ty else { return };
        match declared.extent {
            Extent::One(shape) => self.shape(name, &shape, ty),
            Extent::Many { element, stride } => self.runtime_array(name, &element, stride, ty),
        }
    }

    fn runtime_array(&mut self, path: &str, element: &Shape, stride: u32, ty: Handle<Type>) {
        match self.module.types[ty].inner {
            TypeInner::Array { base, size: ArraySize::Dynamic, stride: wgsl } => {
                if wgsl != stride {
                    self.push(format!("{path}[]: WGSL stride {wgsl}, Rust stride {stride}"));
                }
                self.shape(&format!("{path}[]"), element, base);
            }
            _ => self.push(format!("{path}: WGSL type `{}`, Rust type is a slice", self.name(ty))),
        }
    }

    fn shape(&mut self, path: &str, shape: &Shape, ty: Handle<Type>) {
        match (shape, &self.module.types[ty].inner) {
            (Shape::Scalar(rust), &(TypeInner::Scalar(wgsl) | TypeInner::Atomic(wgsl))) if same(*rust, wgsl) => {}
            (&Shape::Vector { scalar, lanes }, &TypeInner::Vector { size, scalar: wgsl })
                if same(scalar, wgsl) && lanes == size as u32 => {}
            (
                &Shape::Matrix { scalar, columns, rows },
                &TypeInner::Matrix { columns: wgsl_columns, rows: wgsl_rows, scalar: wgsl },
            ) if same(scalar, wgsl) && columns == wgsl_columns as u32 && rows == wgsl_rows as u32 => {}
            (&Shape::Array { element, count, stride }, &TypeInner::Array { base, size, stride: wgsl }) => {
                let length = if let ArraySize::Constant(n) = size { Some(n.get()) } else { None };
                if length != Some(count) {
                    let wgsl = length.map_or_else(|| "known only at run time".to_owned(), |n| n.to_string());
                    self.push(format!("{path}: WGSL length {wgsl}, Rust length {count}"));
                }
                if wgsl != stride {
                    self.push(format!("{path}[]: WGSL stride {wgsl}, Rust stride {stride}"));
                }
                self.shape(&format!("{path}[]"), element, base);
            }
            (&Shape::Struct { fields, size, .. }, TypeInner::Struct { members, span }) => {
                self.members(path, fields, members);
                if size != *span {
                    self.push(format!("{path}: WGSL size {span}, Rust size {size}"));
                }
            }
            _ => self.push(format!("{path}: WGSL type `{}`, Rust type `{}`", self.name(ty), word(shape))),
        }
    }

    fn members(&mut self, path: &str, fields: &[Field], members: &[naga::StructMember]) {
        let padding =
            |f: &&Field| !f.name.starts_with('_') || members.iter().any(|m| m.name.as_deref() == Some(f.name));
        let mut fields = fields.iter().filter(padding);
        for member in members {
            let name = member.name.as_deref().unwrap_or_default();
            let Some(field) = fields.next() else {
                self.push(format!("{path}.{name}: WGSL offset {}, Rust has no such field", member.offset));
                continue;
            };
            if field.name != name {
                let (wgsl, rust) = (member.offset, field.offset);
                self.push(format!("{path}: WGSL `{name}` at offset {wgsl}, Rust `{}` at offset {rust}", field.name));
                continue;
            }
            if field.offset != member.offset {
                self.push(format!("{path}.{name}: WGSL offset {}, Rust offset {}", member.offset, field.offset));
            }
            let size = self.layouter[member.ty].size;
            if field.size != size {
                self.push(format!("{path}.{name}: WGSL size {size}, Rust size {}", field.size));
            }
            self.shape(&format!("{path}.{name}"), field.shape, member.ty);
        }
        for field in fields {
            self.push(format!("{path}.{}: Rust offset {}, WGSL has no such field", field.name, field.offset));
        }
    }

    fn name(&self, ty: Handle<Type>) -> String {
        self.module.to_ctx().type_to_string(ty)
    }

    fn push(&mut self, difference: String) {
        self.differences.push(difference);
    }
}

fn same(rust: Scalar, wgsl: naga::Scalar) -> bool {
    let kind = match rust {
        Scalar::U32 => ScalarKind::Uint,
        Scalar::I32 => ScalarKind::Sint,
        Scalar::F32 => ScalarKind::Float,
    };
    wgsl.kind == kind && wgsl.width == 4
}

fn access(access: Access) -> &'static str {
    match access {
        Access::Uniform => "uniform",
        Access::Read => "read",
        Access::ReadWrite => "read_write",
    }
}

fn word(shape: &Shape) -> String {
    let scalar = |scalar: Scalar| match scalar {
        Scalar::U32 => "u32",
        Scalar::I32 => "i32",
        Scalar::F32 => "f32",
    };
    match *shape {
        Shape::Scalar(s) => scalar(s).to_owned(),
        Shape::Vector { scalar: s, lanes } => format!("vec{lanes}<{}>", scalar(s)),
        Shape::Matrix { scalar: s, columns, rows } => format!("mat{columns}x{rows}<{}>", scalar(s)),
        Shape::Array { element, count, .. } => format!("array<{}, {count}>", word(element)),
        Shape::Struct { name, .. } => name.to_owned(),
    }
}

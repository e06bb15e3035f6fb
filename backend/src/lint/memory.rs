//! Where f32 crosses memory that host or other invocations see.

use naga::{AddressSpace, Module, ScalarKind, TypeInner};

use super::Violation;

/// Finds module-scope variables of such memory whose type holds a float.
pub(super) fn check(module: &Module, found: &mut Vec<Violation>) {
    let floats = float_types(module);
    for (handle, global) in module.global_variables.iter() {
        let crosses =
            matches!(global.space, AddressSpace::Storage { .. } | AddressSpace::Uniform | AddressSpace::WorkGroup);
        let Some(range) = module.global_variables.get_span(handle).to_range() else { continue };
        if crosses && floats[global.ty.index()] {
            let name = global.name.as_deref().unwrap_or_default();
            found.push(Violation { lint: "float-memory", range, label: format!("`{name}` holds f32") });
        }
    }
}

/// For each type, in arena order, whether it holds a float; a type stands after those it is made of.
fn float_types(module: &Module) -> Vec<bool> {
    let mut floats: Vec<bool> = Vec::with_capacity(module.types.len());
    for (_, ty) in module.types.iter() {
        let float = match ty.inner {
            TypeInner::Scalar(scalar)
            | TypeInner::Atomic(scalar)
            | TypeInner::Vector { scalar, .. }
            | TypeInner::Matrix { scalar, .. } => scalar.kind == ScalarKind::Float,
            TypeInner::Array { base, .. } => floats[base.index()],
            TypeInner::Struct { ref members, .. } => members.iter().any(|m| floats[m.ty.index()]),
            _ => false,
        };
        floats.push(float);
    }
    floats
}

//! The rules of a dispatch: its entry point's size and memory, its bindings, and what may not share a buffer.

use naga::AddressSpace;
use naga::proc::Layouter;

use super::{BINDING_ALIGNMENT, Checker, MAX_BINDINGS, MAX_GROUPS, MAX_INVOCATIONS, MAX_STORAGE_BINDING};
use super::{MAX_STORAGE_BUFFERS, MAX_UNIFORM_BINDING, MAX_UNIFORM_BUFFERS, MAX_WORKGROUP_MEMORY, MAX_WORKGROUP_SIZE};
use super::{groups, range};
use crate::{Access, Binding, Dispatch, Entry, Error, Groups, Program, Result, Slot};

impl Checker<'_> {
    pub(super) fn dispatch(&self, dispatch: &Dispatch, context: &str) -> Result<()> {
        let context = format!("{context} (dispatch)");
        let Some(program) = self.programs.get(dispatch.program.0 as usize) else {
            let count = self.programs.len();
            let what = format!("{context}: program id {} does not exist, there are {count}", dispatch.program.0);
            return Err(Error::refused(what, "use an id that this job's `program` returned"));
        };
        let context = format!("{context} of `{}` in `{}`", dispatch.entry, program.label());
        let Some(entry) = program.entry(&dispatch.entry) else {
            let known = program.entries().iter().map(|e| e.name.as_str()).collect::<Vec<_>>().join("`, `");
            let what = format!("{context}: no such entry point");
            return Err(Error::refused(what, format!("use one of `{known}`")));
        };
        program.check_once(&dispatch.entry, &dispatch.overrides, || {
            interface(program, entry, &context)?;
            workgroup(program, dispatch, &context)
        })?;
        groups(self.buffers, &dispatch.groups, &context)?;
        let bound = self.slots(program, entry, dispatch, &context)?;
        aliasing(&bound, &dispatch.groups, &context)
    }

    /// Pairs each slot with its binding: all of the entry point's, once each, and no others.
    fn slots<'a>(
        &self,
        program: &'a Program,
        entry: &Entry,
        dispatch: &'a Dispatch,
        context: &str,
    ) -> Result<Vec<(&'a Slot, &'a Binding)>> {
        let mut bound: Vec<(&Slot, &Binding)> = Vec::new();
        for slot in &dispatch.slots {
            let at = (slot.group, slot.binding);
            let place = format!("{context}, group {} binding {}", at.0, at.1);
            let mut used = entry.bindings.iter().map(|&index| &program.bindings()[index]);
            let Some(binding) = used.find(|b| (b.group, b.binding) == at) else {
                return Err(Error::refused(format!("{place}: the entry point does not use it"), "remove the slot"));
            };
            if bound.iter().any(|(_, b)| (b.group, b.binding) == at) {
                return Err(Error::refused(format!("{place} (`{}`) is bound twice", binding.name), "bind it once"));
            }
            self.slot(slot, binding, &format!("{place} (`{}`)", binding.name))?;
            bound.push((slot, binding));
        }
        let mut used = entry.bindings.iter().map(|&index| &program.bindings()[index]);
        if let Some(binding) = used.find(|b| !bound.iter().any(|(_, known)| known == b)) {
            let (group, number) = (binding.group, binding.binding);
            let what = format!("{context}: group {group} binding {number} (`{}`) is not bound", binding.name);
            return Err(Error::refused(what, "add a slot for it"));
        }
        Ok(bound)
    }

    fn slot(&self, slot: &Slot, binding: &Binding, place: &str) -> Result<()> {
        if slot.size == 0 {
            let remedy = "bind at least one element, and pass the number of elements in a uniform";
            return Err(Error::refused(format!("{place}: binds no bytes"), remedy));
        }
        let name = range(self.buffers, slot.buffer, slot.offset, slot.size, place)?;
        if !slot.offset.is_multiple_of(BINDING_ALIGNMENT) {
            let what = format!("{place}: offset {} in `{name}` is not a multiple of {BINDING_ALIGNMENT}", slot.offset);
            return Err(Error::refused(what, "align what is bound, or pass an offset in a uniform"));
        }
        if slot.size < binding.min_size {
            let what = format!("{place}: binds {} bytes, the type needs {}", slot.size, binding.min_size);
            return Err(Error::refused(what, "make the buffer large enough for the type, or for one element"));
        }
        let (limit, kind) = match binding.access {
            Access::Uniform => (MAX_UNIFORM_BINDING, "uniform"),
            Access::Read | Access::ReadWrite => (MAX_STORAGE_BINDING, "storage"),
        };
        if slot.size > limit {
            let what = format!("{place}: binds {} bytes, the limit of a {kind} binding is {limit}", slot.size);
            return Err(Error::refused(what, "split the data over bindings or dispatches"));
        }
        Ok(())
    }
}

/// Numbers and kinds of the bindings that an entry point uses.
fn interface(program: &Program, entry: &Entry, context: &str) -> Result<()> {
    let used = || entry.bindings.iter().map(|&index| &program.bindings()[index]);
    let uniforms = used().filter(|b| b.access == Access::Uniform).count();
    let storage = used().count() - uniforms;
    for (count, limit, kind) in [(storage, MAX_STORAGE_BUFFERS, "storage"), (uniforms, MAX_UNIFORM_BUFFERS, "uniform")]
    {
        if count > limit {
            let what = format!("{context}: uses {count} {kind} buffers, the limit is {limit}");
            return Err(Error::refused(what, "put several arrays into one buffer, or split the entry point"));
        }
    }
    if let Some(binding) = used().find(|b| b.group >= MAX_GROUPS || b.binding >= MAX_BINDINGS) {
        let (name, group, number) = (&binding.name, binding.group, binding.binding);
        let limits = format!("the limits are {} and {}", MAX_GROUPS - 1, MAX_BINDINGS - 1);
        let what = format!("{context}: `{name}` is at group {group} binding {number}, {limits}");
        return Err(Error::refused(what, "number groups and bindings from 0"));
    }
    Ok(())
}

/// Size and memory of a workgroup, with the override values applied.
fn workgroup(program: &Program, dispatch: &Dispatch, context: &str) -> Result<()> {
    let (module, info) = program.specialise(&dispatch.entry, &dispatch.overrides)?;
    let Some(index) = module.entry_points.iter().position(|e| e.name == dispatch.entry) else {
        return Err(Error::refused(format!("{context}: no such entry point"), "name an entry point of the program"));
    };
    let [x, y, z] = module.entry_points[index].workgroup_size;
    let invocations = [x, y, z].iter().fold(1_u32, |n, &k| n.saturating_mul(k));
    let fits = [x, y, z].iter().zip(MAX_WORKGROUP_SIZE).all(|(&n, limit)| (1..=limit).contains(&n));
    if !fits || invocations > MAX_INVOCATIONS {
        let [a, b, c] = MAX_WORKGROUP_SIZE;
        let limits = format!("the limits are {a} x {b} x {c} and {MAX_INVOCATIONS} in all");
        let what = format!("{context}: a workgroup of {x} x {y} x {z} = {invocations} invocations; {limits}");
        return Err(Error::refused(what, "make the workgroup smaller and dispatch more of them"));
    }
    let mut layouter = Layouter::default();
    if let Err(error) = layouter.update(module.to_ctx()) {
        return Err(Error::refused(format!("{context}: {error}"), "make the type smaller"));
    }
    let uses = info.get_entry_point(index);
    let shared =
        module.global_variables.iter().filter(|(h, g)| g.space == AddressSpace::WorkGroup && !uses[*h].is_empty());
    let bytes: u64 = shared.map(|(_, g)| u64::from(layouter[g.ty].size).next_multiple_of(16)).sum();
    if bytes > MAX_WORKGROUP_MEMORY {
        let what = format!("{context}: {bytes} bytes of workgroup memory, the limit is {MAX_WORKGROUP_MEMORY}");
        return Err(Error::refused(what, "keep less in workgroup memory, or work on smaller tiles"));
    }
    Ok(())
}

/// Within a dispatch, a buffer that is written is bound for nothing else; two written ranges of it do not overlap.
fn aliasing(bound: &[(&Slot, &Binding)], groups: &Groups, context: &str) -> Result<()> {
    let writes = |b: &Binding| b.access == Access::ReadWrite;
    for (index, (a, first)) in bound.iter().enumerate() {
        for (b, second) in bound[..index].iter().filter(|(b, _)| a.buffer == b.buffer) {
            let names = format!("{context}: buffer {} is bound to `{}` and `{}`", a.buffer.0, second.name, first.name);
            if writes(first) != writes(second) {
                let what = format!("{names}, one of which writes");
                return Err(Error::refused(what, "use two buffers, or one read_write binding for both"));
            }
            let disjoint = a.offset + a.size <= b.offset || b.offset + b.size <= a.offset;
            if writes(first) && !disjoint {
                let (from, to) = (a.offset.max(b.offset), (a.offset + a.size).min(b.offset + b.size));
                let what = format!("{names}, both write bytes {from}..{to}");
                return Err(Error::refused(what, "bind disjoint ranges or two buffers"));
            }
        }
        if let Groups::Indirect { buffer, .. } = groups
            && *buffer == a.buffer
            && writes(first)
        {
            let what =
                format!("{context}: buffer {} holds the workgroups and is written as `{}`", buffer.0, first.name);
            return Err(Error::refused(
                what,
                "write the workgroups into a buffer of their own, in an earlier dispatch",
            ));
        }
    }
    Ok(())
}

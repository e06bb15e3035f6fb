//! One dispatch: variables laid out, workgroups one after another, invocations from barrier to barrier.

use std::cell::{Cell, RefCell};
use std::task::{Context, Poll, Waker};

use naga::{AddressSpace, Module, ShaderStage, Span};
use sightlines_backend::{Counts, Dispatch, ErrorKind, Program, Result, Trap, TrapKind};

use super::expression::{entry_arguments, global};
use super::invocation::{Invocation, Place, Shared};
use super::memory::{self, Pointer, Root, Shape, Slot};
use super::unsupported;

/// Runs `groups` workgroups and returns what they cost.
pub(crate) fn dispatch(
    program: &Program,
    command: &Dispatch,
    groups: [u32; 3],
    buffers: &[RefCell<Vec<u32>>],
) -> Result<Counts> {
    let constants = command.overrides.iter().cloned().collect();
    let entry = Some((ShaderStage::Compute, command.entry.as_str()));
    let (module, _) =
        naga::back::pipeline_constants::process_overrides(program.module(), program.info(), entry, &constants)
            .map_err(|e| ErrorKind::Format(e.to_string()))?;
    let slots = command.slots.iter().map(|slot| Slot {
        memory: &buffers[slot.buffer.0 as usize],
        first: slot.offset as usize / 4,
        words: slot.size as usize / 4,
    });
    let shared = Shared {
        module: &module,
        slots: slots.collect(),
        globals: place_globals(&module, command)?,
        workgroup: RefCell::default(),
        counts: Cell::default(),
        fuel: Cell::new(0),
    };
    for z in 0..groups[2] {
        for y in 0..groups[1] {
            for x in 0..groups[0] {
                workgroup(&shared, &command.entry, [x, y, z], groups)?;
            }
        }
    }
    Ok(shared.counts.get())
}

/// Where each global variable begins; workgroup and private variables stand one after another.
fn place_globals(module: &Module, command: &Dispatch) -> Result<Vec<Option<Pointer>>> {
    let (mut workgroup, mut private) = (0, 0);
    let mut globals = Vec::new();
    for (_, variable) in module.global_variables.iter() {
        let shape = Shape::Type(variable.ty);
        let size = || memory::size(module, shape, false);
        let behind = |end: &mut usize, root, size| {
            let word = std::mem::replace(end, *end + size);
            Some(Pointer { root, word, shape })
        };
        globals.push(match variable.space {
            AddressSpace::WorkGroup => behind(&mut workgroup, Root::Workgroup, size()?),
            AddressSpace::Private => behind(&mut private, Root::Private, size()?),
            AddressSpace::Uniform | AddressSpace::Storage { .. } => variable.binding.as_ref().and_then(|b| {
                let slot = command.slots.iter().position(|s| (s.group, s.binding) == (b.group, b.binding))?;
                Some(Pointer { root: Root::Slot(slot), word: 0, shape })
            }),
            other => return unsupported(format!("address space {other:?}")),
        });
    }
    Ok(globals)
}

/// Memory of all variables of one space, initialised.
fn fresh(shared: &Shared<'_>, root: Root) -> Result<Vec<u32>> {
    let module = shared.module;
    let mut words = Vec::new();
    for ((_, variable), pointer) in module.global_variables.iter().zip(&shared.globals) {
        let Some(pointer) = pointer.filter(|p| p.root == root) else { continue };
        words.resize(pointer.word + memory::size(module, pointer.shape, false)?, 0);
        if let Some(init) = variable.init {
            memory::encode(module, pointer.shape, &global(module, init)?, &mut words, pointer.word, false)?;
        }
    }
    Ok(words)
}

fn workgroup(shared: &Shared<'_>, entry: &str, group: [u32; 3], groups: [u32; 3]) -> Result<()> {
    let module = shared.module;
    let Some(entry) = module.entry_points.iter().find(|e| e.name == entry) else {
        return unsupported(format!("entry point {entry}"));
    };
    let size = entry.workgroup_size;
    *shared.workgroup.borrow_mut() = fresh(shared, Root::Workgroup)?;
    let private = fresh(shared, Root::Private)?;
    let mut invocations = Vec::new();
    for index in 0..size.iter().product::<u32>() {
        let local = [index % size[0], index / size[0] % size[1], index / size[0] / size[1]];
        invocations.push(Invocation {
            shared,
            place: Place { local, group, groups, size },
            private: RefCell::new(private.clone()),
            stack: RefCell::default(),
            waiting: Cell::new(None),
        });
    }
    let mut counts = shared.counts.get();
    counts.invocations += invocations.len() as u64;
    shared.counts.set(counts);
    let start = |i| Ok((i, Invocation::call(i, &entry.function, entry_arguments(module, &entry.function, &i.place)?)));
    let mut running = invocations.iter().map(start).collect::<Result<Vec<_>>>()?;
    while !running.is_empty() {
        let mut ended = 0;
        for (_, walk) in &mut running {
            if let Poll::Ready(result) = walk.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
                result?;
                ended += 1;
            }
        }
        if ended == running.len() {
            return Ok(());
        }
        meet(shared, running.iter().map(|(i, _)| i.waiting.take()), ended)?;
    }
    Ok(())
}

/// All invocations must wait at one barrier.
fn meet(shared: &Shared<'_>, mut waiting: impl Iterator<Item = Option<Span>>, ended: usize) -> Result<()> {
    let first = waiting.next().flatten();
    if ended > 0 || waiting.any(|w| w != first) {
        let kind = TrapKind::NonUniformBarrier;
        return Err(ErrorKind::Trap(Trap { kind, location: None, invocation: None }).into());
    }
    let mut counts = shared.counts.get();
    counts.barriers += 1;
    shared.counts.set(counts);
    Ok(())
}

//! A session: buffers on the device, and the running of recordings.
//!
//! A recording is one submission. Uploads go through a staging buffer that is filled before and copied in the
//! recording's order, so a later command sees them and an earlier one does not. A recording that uploads more than
//! [`CHUNK`] bytes becomes several submissions in sequence, which bounds the staging memory; nothing else observes the
//! difference.

use std::collections::HashMap;
use std::num::NonZeroU64;
use std::sync::Arc;

use sightlines_backend::{
    BufferDesc, BufferId, Command, DeviceError, Dispatch, Groups, Program, Read, Recording, Result, Session, Slot,
    check,
};
use wgpu::{BindGroup, BindGroupEntry, Buffer, BufferBinding, BufferUsages, CommandEncoder, ComputePass};

use crate::device::Device;
use crate::pipeline::{Pipeline, Pipelines};
use crate::readback::{self, CHUNK};

/// Layout (pipeline and group) and the ranges bound: binding, buffer, offset, size.
type GroupKey = (usize, u32, Vec<(u32, u32, u64, u64)>);

/// Memory and programs of one job.
#[derive(Debug)]
pub(crate) struct WgpuSession<'a> {
    device: &'a Device,
    pipelines: &'a Pipelines,
    programs: Vec<Arc<Program>>,
    descs: Vec<BufferDesc>,
    buffers: Vec<Buffer>,
    groups: HashMap<GroupKey, BindGroup>,
}

impl<'a> WgpuSession<'a> {
    /// Hands the programs to the device and allocates the buffers; wgpu fills them with zeros.
    pub(crate) fn open(
        device: &'a Device,
        pipelines: &'a Pipelines,
        programs: &[Arc<Program>],
        buffers: &[BufferDesc],
    ) -> Result<Self> {
        device.health()?;
        for program in programs {
            pipelines.module(device, program)?;
        }
        let (programs, descs) = (programs.to_vec(), buffers.to_vec());
        let buffers = descs.iter().map(|desc| allocate(device, desc)).collect::<Result<_>>()?;
        Ok(WgpuSession { device, pipelines, programs, descs, buffers, groups: HashMap::new() })
    }

    /// Runs a recording that has passed the contract's check.
    pub(crate) fn run(&mut self, recording: &Recording) -> Result<()> {
        let device = self.device;
        batches(recording).iter().try_for_each(|steps| {
            device.run(|encoder| {
                let staging = stage(device, steps)?;
                self.encode(steps, staging.as_ref(), encoder)
            })
        })
    }

    /// Reads a range that has passed the contract's check.
    pub(crate) fn fetch(&self, read: &Read) -> Result<Vec<u8>> {
        readback::read(self.device, self.buffer(read.buffer), read.offset, read.size)
    }

    fn buffer(&self, id: BufferId) -> &Buffer {
        &self.buffers[id.0 as usize]
    }

    fn encode(&mut self, steps: &[Step<'_>], staging: Option<&Buffer>, encoder: &mut CommandEncoder) -> Result<()> {
        let mut staged = 0;
        for run in steps.chunk_by(|a, b| a.dispatch().is_some() && b.dispatch().is_some()) {
            if run[0].dispatch().is_some() {
                let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
                run.iter().filter_map(Step::dispatch).try_for_each(|dispatch| self.dispatch(dispatch, &mut pass))?;
            } else if let Step::Upload { buffer, offset, bytes } = &run[0] {
                let size = bytes.len() as u64;
                if let Some(staging) = staging {
                    encoder.copy_buffer_to_buffer(staging, staged, self.buffer(*buffer), *offset, size);
                }
                staged += size;
            } else {
                self.transfer(&run[0], encoder);
            }
        }
        Ok(())
    }

    fn transfer(&self, step: &Step<'_>, encoder: &mut CommandEncoder) {
        match *step {
            Step::Command(&Command::Clear { buffer, offset, size }) if size > 0 => {
                encoder.clear_buffer(self.buffer(buffer), offset, Some(size));
            }
            Step::Command(&Command::Copy { from, from_offset, to, to_offset, size }) if size > 0 => {
                encoder.copy_buffer_to_buffer(self.buffer(from), from_offset, self.buffer(to), to_offset, size);
            }
            _ => {}
        }
    }

    fn dispatch(&mut self, dispatch: &Dispatch, pass: &mut ComputePass<'_>) -> Result<()> {
        let program = Arc::clone(&self.programs[dispatch.program.0 as usize]);
        let pipeline = self.pipelines.pipeline(self.device, &program, dispatch)?;
        pass.set_pipeline(&pipeline.raw);
        for &group in pipeline.layouts.keys() {
            pass.set_bind_group(group, self.bind(&pipeline, group, &dispatch.slots), &[]);
        }
        match dispatch.groups {
            Groups::Direct(groups) if groups.contains(&0) => {}
            Groups::Direct([x, y, z]) => pass.dispatch_workgroups(x, y, z),
            Groups::Indirect { buffer, offset } => pass.dispatch_workgroups_indirect(self.buffer(buffer), offset),
        }
        Ok(())
    }

    /// The bind group of some slots, made once.
    fn bind(&mut self, pipeline: &Pipeline, group: u32, slots: &[Slot]) -> &BindGroup {
        let slots = slots.iter().filter(|slot| slot.group == group).collect::<Vec<_>>();
        let ranges = slots.iter().map(|s| (s.binding, s.buffer.0, s.offset, s.size)).collect();
        let (device, buffers) = (self.device, &self.buffers);
        self.groups.entry((pipeline.id, group, ranges)).or_insert_with(|| {
            let entries = slots.iter().map(|slot| entry(slot, &buffers[slot.buffer.0 as usize])).collect::<Vec<_>>();
            let layout = &pipeline.layouts[&group];
            device.raw().create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
        })
    }
}

impl Session for WgpuSession<'_> {
    fn submit(&mut self, recording: &Recording) -> Result<()> {
        check::recording(&self.descs, &self.programs, recording)?;
        self.run(recording)
    }

    fn read(&mut self, read: &Read) -> Result<Vec<u8>> {
        check::read(&self.descs, read)?;
        self.fetch(read)
    }
}

/// A command, or a part of a large upload.
#[derive(Debug)]
enum Step<'a> {
    Upload { buffer: BufferId, offset: u64, bytes: &'a [u8] },
    Command(&'a Command),
}

impl<'a> Step<'a> {
    fn dispatch(&self) -> Option<&'a Dispatch> {
        match self {
            Step::Command(Command::Dispatch(dispatch)) => Some(dispatch),
            _ => None,
        }
    }

    fn upload(&self) -> &'a [u8] {
        match self {
            Step::Upload { bytes, .. } => bytes,
            Step::Command(_) => &[],
        }
    }
}

/// The recording cut into submissions that upload at most [`CHUNK`] bytes each.
fn batches(recording: &Recording) -> Vec<Vec<Step<'_>>> {
    let mut steps = Vec::new();
    for command in &recording.commands {
        match command {
            Command::Upload { buffer, offset, bytes } => {
                let parts = bytes.chunks(CHUNK as usize).enumerate();
                steps.extend(parts.map(|(i, bytes)| Step::Upload {
                    buffer: *buffer,
                    offset: offset + i as u64 * CHUNK,
                    bytes,
                }));
            }
            _ => steps.push(Step::Command(command)),
        }
    }
    let mut batches = vec![Vec::new()];
    let mut staged = 0;
    for step in steps {
        let size = step.upload().len() as u64;
        if staged + size > CHUNK {
            batches.push(Vec::new());
            staged = 0;
        }
        staged += size;
        let last = batches.len() - 1;
        batches[last].push(step);
    }
    batches
}

/// A buffer with the bytes of all uploads, one after the other.
fn stage(device: &Device, steps: &[Step<'_>]) -> Result<Option<Buffer>> {
    let size = steps.iter().map(|step| step.upload().len()).sum::<usize>();
    if size == 0 {
        return Ok(None);
    }
    let staging = device.raw().create_buffer(&wgpu::BufferDescriptor {
        label: Some("uploads"),
        size: size as u64,
        usage: BufferUsages::COPY_SRC,
        mapped_at_creation: true,
    });
    // Where memory ran out the buffer cannot be mapped either, but the scope around the submission says so first.
    let mut view = staging.slice(..).get_mapped_range_mut().map_err(|error| DeviceError::Lost(error.to_string()))?;
    let mut start = 0;
    for bytes in steps.iter().map(Step::upload) {
        view.slice(start..start + bytes.len()).copy_from_slice(bytes);
        start += bytes.len();
    }
    drop(view);
    staging.unmap();
    Ok(Some(staging))
}

fn entry<'a>(slot: &Slot, buffer: &'a Buffer) -> BindGroupEntry<'a> {
    let range = BufferBinding { buffer, offset: slot.offset, size: NonZeroU64::new(slot.size) };
    BindGroupEntry { binding: slot.binding, resource: wgpu::BindingResource::Buffer(range) }
}

fn allocate(device: &Device, desc: &BufferDesc) -> Result<Buffer> {
    device.scoped(|| {
        Ok(device.raw().create_buffer(&wgpu::BufferDescriptor {
            label: Some(&desc.label),
            // Vulkan has no empty buffers.
            size: desc.size.max(4),
            usage: BufferUsages::STORAGE
                | BufferUsages::UNIFORM
                | BufferUsages::INDIRECT
                | BufferUsages::COPY_SRC
                | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        }))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::tests::{fault, noop};
    use sightlines_backend::{Job, Linked};

    fn upload(offset: u64, size: u64) -> Command {
        Command::Upload { buffer: BufferId(0), offset, bytes: vec![0; size as usize] }
    }

    /// Offset and size of each upload and `None` for each other command, submission by submission.
    fn cut(commands: Vec<Command>) -> Vec<Vec<Option<(u64, u64)>>> {
        let show = |step: &Step<'_>| match step {
            Step::Upload { offset, bytes, .. } => Some((*offset, bytes.len() as u64)),
            Step::Command(_) => None,
        };
        batches(&Recording { commands }).iter().map(|steps| steps.iter().map(show).collect()).collect()
    }

    #[test]
    fn a_recording_of_few_uploads_is_one_submission() {
        let clear = Command::Clear { buffer: BufferId(0), offset: 0, size: 4 };
        let commands = vec![upload(0, CHUNK - 8), clear, upload(4, 8), upload(8, 0)];
        assert_eq!(cut(commands), [vec![Some((0, CHUNK - 8)), None, Some((4, 8))]]);
        assert_eq!(cut(vec![]), [vec![]]);
    }

    #[test]
    fn large_uploads_are_cut_in_order() {
        let clear = Command::Clear { buffer: BufferId(0), offset: 0, size: 4 };
        let cut = cut(vec![upload(0, 4), upload(8, 2 * CHUNK + 4), clear, upload(0, 8)]);
        let expected = [
            vec![Some((0, 4))],
            vec![Some((8, CHUNK))],
            vec![Some((8 + CHUNK, CHUNK))],
            vec![Some((8 + 2 * CHUNK, 4)), None, Some((0, 8))],
        ];
        assert_eq!(cut, expected);
    }

    /// One dispatch of a kernel that wgpu accepts, which `change` may spoil, handed to the device unchecked.
    fn unchecked(wgsl: &str, change: impl FnOnce(&mut Dispatch)) -> Result<usize> {
        let program = Program::unlinted("touch", Linked::single("touch.wgsl", wgsl)?)?;
        let mut job = Job::new();
        let (id, out) = (job.program(&program), job.buffer("out", 1024));
        job.dispatch(id, "touch", &[(0, out)], [1, 1, 1]);
        if let Command::Dispatch(dispatch) = &mut job.recordings[0].commands[0] {
            change(dispatch);
        }
        let (device, pipelines) = (noop(), Pipelines::default());
        let mut session = WgpuSession::open(&device, &pipelines, &job.programs, &job.buffers)?;
        session.run(&job.recordings[0])?;
        Ok(session.groups.len())
    }

    const TOUCH: &str = "
override lanes: u32 = 1u;
@group(0) @binding(0) var<storage, read_write> out: array<u32>;
@compute @workgroup_size(lanes)
fn touch() { out[0] = 1u; }";

    #[test]
    fn the_device_refuses_what_the_check_would_have() {
        assert_eq!(unchecked(TOUCH, |_| {}).expect("it is well formed"), 1);
        let spoilt: [fn(&mut Dispatch); 4] = [
            |dispatch| dispatch.slots.clear(),
            |dispatch| dispatch.slots[0].size = 1028,
            |dispatch| dispatch.slots[0].offset = 4,
            |dispatch| dispatch.groups = Groups::Direct([65536, 1, 1]),
        ];
        for change in spoilt {
            assert!(matches!(fault(unchecked(TOUCH, change)), DeviceError::Validation(_)));
        }
    }

    #[test]
    fn a_pipeline_that_the_device_refuses_is_named() {
        let too_many = |group: u32| TOUCH.replace("@group(0)", &format!("@group({group})"));
        let too_large = unchecked(TOUCH, |dispatch| dispatch.overrides.push(("lanes".into(), 257.0)));
        for spoilt in [too_large, unchecked(&too_many(4), |_| {}), unchecked(&too_many(i32::MAX as u32), |_| {})] {
            match fault(spoilt) {
                DeviceError::Compile { entry, .. } => assert_eq!(entry.split("::").next(), Some("touch")),
                other => panic!("{other}"),
            }
        }
    }

    #[test]
    fn equal_bind_groups_are_made_once() {
        let linked = Linked::single("touch.wgsl", TOUCH).expect("it is one file");
        let program = Program::unlinted("touch", linked).expect("it is valid");
        let mut job = Job::new();
        let (id, a, b) = (job.program(&program), job.buffer("a", 4), job.buffer("b", 4));
        for buffer in [a, b, a, a, b] {
            job.dispatch(id, "touch", &[(0, buffer)], [1, 1, 1]);
        }
        let (device, pipelines) = (noop(), Pipelines::default());
        let mut session = WgpuSession::open(&device, &pipelines, &job.programs, &job.buffers).expect("it is small");
        for _ in 0..2 {
            session.submit(&job.recordings[0]).expect("it is well formed");
            assert_eq!((session.groups.len(), pipelines.len()), (2, 1));
        }
    }

    #[test]
    fn copies_and_uploads_keep_their_order_on_any_device() {
        let mut job = Job::new();
        let (a, b) = (job.upload("a", &[1u32, 2, 3]), job.buffer("b", 12));
        let copy = |from_offset, to_offset| Command::Copy { from: a, from_offset, to: b, to_offset, size: 4 };
        job.record(copy(0, 8));
        job.record(Command::Upload { buffer: a, offset: 0, bytes: vec![9; 4] });
        job.record(copy(0, 0));
        job.record(Command::Clear { buffer: a, offset: 4, size: 4 });
        job.record(copy(4, 4));
        job.read("b", b);
        let (device, pipelines) = (noop(), Pipelines::default());
        let mut session = WgpuSession::open(&device, &pipelines, &[], &job.buffers).expect("buffers are small");
        session.submit(&job.recordings[0]).expect("copies are valid");
        let expected = [[9; 4], [0; 4], [1, 0, 0, 0]].concat();
        assert_eq!(session.read(&job.reads[0]).expect("it can be read"), expected);
    }
}

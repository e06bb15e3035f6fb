//! Every rule by which a device would refuse work, checked once for all backends, before any of them runs.
//!
//! The limits are WebGPU's defaults, so what passes here runs on any WebGPU device, however small. A refusal names the
//! recording, the command, the numbers and the remedy. Backends call [`job`], or [`recording`] for each recording of a
//! session that is fed by hand; kernels never see a limit that differs between machines.
//!
//! Invariant: where these functions return `Ok`, each id exists, each range lies in its buffer, and each dispatch has
//! exactly the bindings of its entry point.

mod dispatch;

use std::sync::Arc;

use crate::{BufferDesc, BufferId, Command, Error, Groups, Job, Program, Read, Recording, Result};

/// Largest buffer, in bytes: 256 MiB.
pub const MAX_BUFFER: u64 = 256 << 20;
/// Largest storage binding, in bytes: 128 MiB.
pub const MAX_STORAGE_BINDING: u64 = 128 << 20;
/// Largest uniform binding, in bytes: 64 KiB.
pub const MAX_UNIFORM_BINDING: u64 = 64 << 10;
/// Storage buffers that one entry point may use.
pub const MAX_STORAGE_BUFFERS: usize = 8;
/// Uniform buffers that one entry point may use.
pub const MAX_UNIFORM_BUFFERS: usize = 12;
/// Bind groups; `@group` is below this.
pub const MAX_GROUPS: u32 = 4;
/// Binding numbers; `@binding` is below this.
pub const MAX_BINDINGS: u32 = 1000;
/// A binding's first byte is a multiple of this.
pub const BINDING_ALIGNMENT: u64 = 256;
/// Invocations of one workgroup.
pub const MAX_INVOCATIONS: u32 = 256;
/// Invocations of one workgroup in x, y and z.
pub const MAX_WORKGROUP_SIZE: [u32; 3] = [256, 256, 64];
/// Workgroup memory of one workgroup, in bytes: 16 KiB. Each variable counts as a multiple of 16.
pub const MAX_WORKGROUP_MEMORY: u64 = 16 << 10;
/// Workgroups of a dispatch in each dimension.
pub const MAX_WORKGROUPS: u32 = 65_535;
/// Sizes, offsets and copies are multiples of this.
const WORD: u64 = 4;

/// The workgroups that an indirect dispatch runs: those of its three words, or none where one of them exceeds
/// [`MAX_WORKGROUPS`]. That is WebGPU's rule, and every backend uses this function for it.
pub fn indirect_groups(words: [u32; 3]) -> [u32; 3] {
    if words.iter().any(|&n| n > MAX_WORKGROUPS) { [0; 3] } else { words }
}

/// Checks a whole job.
pub fn job(job: &Job) -> Result<()> {
    buffers(&job.buffers)?;
    let checker = Checker { buffers: &job.buffers, programs: &job.programs };
    for (index, recording) in job.recordings.iter().enumerate() {
        checker.recording(recording, &format!("recording {index}, "))?;
    }
    job.reads.iter().try_for_each(|r| read(&job.buffers, r))
}

/// Checks buffers before they are allocated.
pub fn buffers(buffers: &[BufferDesc]) -> Result<()> {
    for (index, buffer) in buffers.iter().enumerate() {
        let what = format!("buffer {index} `{}` has {} bytes", buffer.label, buffer.size);
        if !buffer.size.is_multiple_of(WORD) {
            return Err(Error::refused(format!("{what}, not a multiple of 4"), "round the size up to whole words"));
        }
        if buffer.size > MAX_BUFFER {
            let remedy = "split the data into several buffers, with a dispatch for each";
            return Err(Error::refused(format!("{what}, the limit is {MAX_BUFFER}"), remedy));
        }
    }
    Ok(())
}

/// Checks one recording of a session over `buffers` and `programs`.
pub fn recording(buffers: &[BufferDesc], programs: &[Arc<Program>], recording: &Recording) -> Result<()> {
    Checker { buffers, programs }.recording(recording, "")
}

/// Checks one read of a session over `buffers`.
pub fn read(buffers: &[BufferDesc], read: &Read) -> Result<()> {
    let context = format!("read `{}`", read.name);
    range(buffers, read.buffer, read.offset, read.size, &context).map(drop)
}

struct Checker<'a> {
    buffers: &'a [BufferDesc],
    programs: &'a [Arc<Program>],
}

impl Checker<'_> {
    fn recording(&self, recording: &Recording, context: &str) -> Result<()> {
        for (index, command) in recording.commands.iter().enumerate() {
            let context = format!("{context}command {index}");
            match command {
                Command::Upload { buffer, offset, bytes } => {
                    range(self.buffers, *buffer, *offset, bytes.len() as u64, &format!("{context} (upload)"))?;
                }
                Command::Clear { buffer, offset, size } => {
                    range(self.buffers, *buffer, *offset, *size, &format!("{context} (clear)"))?;
                }
                Command::Copy { from, from_offset, to, to_offset, size } => {
                    let context = format!("{context} (copy)");
                    let label = range(self.buffers, *from, *from_offset, *size, &context)?;
                    range(self.buffers, *to, *to_offset, *size, &context)?;
                    if from == to {
                        let what = format!("{context}: copies within one buffer, `{label}`");
                        return Err(Error::refused(what, "copy by way of another buffer"));
                    }
                }
                Command::Dispatch(dispatch) => self.dispatch(dispatch, &context)?,
            }
        }
        Ok(())
    }
}

/// Checks that a range of whole words lies in its buffer, and returns the buffer's label.
fn range<'a>(buffers: &'a [BufferDesc], id: BufferId, offset: u64, size: u64, context: &str) -> Result<&'a str> {
    let buffer = find(buffers, id, context)?;
    let name = &buffer.label;
    for (number, word) in [(offset, "offset"), (size, "size")] {
        if !number.is_multiple_of(WORD) {
            let what = format!("{context}: {word} {number} in `{name}` is not a multiple of 4");
            return Err(Error::refused(what, "work in whole words of 4 bytes"));
        }
    }
    let Some(end) = offset.checked_add(size) else {
        let what = format!("{context}: {offset} + {size} bytes in `{name}` overflow 64 bits");
        return Err(Error::refused(what, "correct the offset or the size"));
    };
    if end > buffer.size {
        let what = format!("{context}: bytes {offset}..{end} of `{name}`, which has {}", buffer.size);
        return Err(Error::refused(what, "make the buffer larger or the range shorter"));
    }
    Ok(name)
}

fn find<'a>(buffers: &'a [BufferDesc], id: BufferId, context: &str) -> Result<&'a BufferDesc> {
    buffers.get(id.0 as usize).ok_or_else(|| {
        let what = format!("{context}: buffer id {} does not exist, there are {} buffers", id.0, buffers.len());
        Error::refused(what, "use an id that this job's `buffer` or `upload` returned")
    })
}

/// Checks where the number of workgroups comes from.
fn groups(buffers: &[BufferDesc], groups: &Groups, context: &str) -> Result<()> {
    match *groups {
        Groups::Direct(counts) => {
            if let Some(axis) = counts.iter().position(|&n| n > MAX_WORKGROUPS) {
                let (n, axis) = (counts[axis], ["x", "y", "z"][axis]);
                let what = format!("{context}: {n} workgroups in {axis}, the limit is {MAX_WORKGROUPS}");
                return Err(Error::refused(what, "spread the workgroups over x and y, or over several dispatches"));
            }
        }
        Groups::Indirect { buffer, offset } => {
            range(buffers, buffer, offset, 12, &format!("{context}, indirect workgroups"))?;
        }
    }
    Ok(())
}

//! From device memory to host memory, in chunks through one mapped buffer.
//!
//! The staging buffer is as large as the range, up to [`CHUNK`]: reading a large buffer costs a bounded amount of extra
//! memory, and each chunk is a submission of its own.

use std::sync::mpsc;

use sightlines_backend::{DeviceError, Result};
use wgpu::{BufferDescriptor, BufferUsages, MapMode};

use crate::device::Device;

/// Largest piece of a transfer between host and device, in bytes.
pub(crate) const CHUNK: u64 = 32 << 20;

/// Reads `size` bytes from `offset` on.
pub(crate) fn read(device: &Device, source: &wgpu::Buffer, offset: u64, size: u64) -> Result<Vec<u8>> {
    let mut bytes = Vec::with_capacity(size as usize);
    if size == 0 {
        return Ok(bytes);
    }
    let staging = device.scoped(|| {
        Ok(device.raw().create_buffer(&BufferDescriptor {
            label: Some("readback"),
            size: size.min(CHUNK),
            usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        }))
    })?;
    let mut done = 0;
    while done < size {
        let part = (size - done).min(CHUNK);
        chunk(device, source, offset + done, &staging, part, &mut bytes)?;
        done += part;
    }
    Ok(bytes)
}

fn chunk(
    device: &Device,
    source: &wgpu::Buffer,
    offset: u64,
    staging: &wgpu::Buffer,
    size: u64,
    bytes: &mut Vec<u8>,
) -> Result<()> {
    let (sender, receiver) = mpsc::channel();
    device.run(|encoder| {
        encoder.copy_buffer_to_buffer(source, offset, staging, 0, size);
        encoder.map_buffer_on_submit(staging, MapMode::Read, 0..size, move |result| {
            // The receiver is gone only if the wait below has failed already.
            let _ = sender.send(result);
        });
        Ok(())
    })?;
    let mapped = receiver.recv_timeout(device.timeout()).map_err(|error| DeviceError::Lost(error.to_string()))?;
    mapped.map_err(|error| DeviceError::Lost(error.to_string()))?;
    let view = staging.slice(..size).get_mapped_range().map_err(|error| DeviceError::Lost(error.to_string()))?;
    bytes.extend_from_slice(&view);
    drop(view);
    staging.unmap();
    Ok(())
}

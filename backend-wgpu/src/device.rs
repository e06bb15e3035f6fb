//! The device: how it is opened, waited for, and how its failures become typed errors.
//!
//! wgpu reports an error in one of four ways: through an error scope, through the handler of uncaptured errors, through
//! the callback of a lost device, or by a panic inside `poll`. All four end here. The first fault that the device
//! cannot recover from (it was lost, or a submission did not end) is kept and answers all later work. The device is
//! then leaked on purpose: to drop it would wait, perhaps for ever, for work that does not end.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use sightlines_backend::{DeviceError, Result};
use wgpu::{CommandEncoder, ErrorFilter, PollError, PollType, SubmissionIndex};

use crate::AdapterReport;

/// A mutex whose data stay valid when a holder panics: every critical section here is a single assignment or insertion.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A device with its queue, its fault and its limit of time.
#[derive(Debug)]
pub(crate) struct Device {
    raw: wgpu::Device,
    queue: wgpu::Queue,
    fault: Arc<Mutex<Option<DeviceError>>>,
    timeout: Duration,
}

impl Device {
    /// Opens a device of `adapter`.
    pub(crate) fn open(adapter: &wgpu::Adapter, report: &AdapterReport, timeout: Duration) -> Result<Self> {
        let (raw, queue) = pollster::block_on(adapter.request_device(&descriptor())).map_err(|error| {
            let reason = if report.lacks.is_empty() { error.to_string() } else { report.lacks.join("; ") };
            DeviceError::NoAdapter { wanted: Some(report.name.clone()), reason }
        })?;
        Ok(Self::new(raw, queue, timeout))
    }

    /// Takes over a device: its errors are reported here from now on.
    pub(crate) fn new(raw: wgpu::Device, queue: wgpu::Queue, timeout: Duration) -> Self {
        let fault = Arc::new(Mutex::new(None));
        let uncaptured = Arc::clone(&fault);
        raw.on_uncaptured_error(Arc::new(move |error| record(&uncaptured, typed(&error))));
        let lost = Arc::clone(&fault);
        raw.set_device_lost_callback(move |_, reason| record(&lost, DeviceError::Lost(reason)));
        Device { raw, queue, fault, timeout }
    }

    pub(crate) fn raw(&self) -> &wgpu::Device {
        &self.raw
    }

    /// The fault that ended the device, every time; an error that no scope caught, once.
    pub(crate) fn health(&self) -> Result<()> {
        let mut fault = lock(&self.fault);
        let found = if fault.as_ref().is_some_and(is_final) { fault.clone() } else { fault.take() };
        found.map_or(Ok(()), |fault| Err(fault.into()))
    }

    /// Runs `work` with every error of the device caught. An error of the device explains one of `work`, so it goes
    /// first.
    pub(crate) fn scoped<T>(&self, work: impl FnOnce() -> Result<T>) -> Result<T> {
        self.scoped_as(typed, work)
    }

    /// [`Device::scoped`] with a translation of its own.
    pub(crate) fn scoped_as<T>(
        &self,
        translate: impl FnOnce(&wgpu::Error) -> DeviceError,
        work: impl FnOnce() -> Result<T>,
    ) -> Result<T> {
        self.health()?;
        let memory = self.raw.push_error_scope(ErrorFilter::OutOfMemory);
        let internal = self.raw.push_error_scope(ErrorFilter::Internal);
        let validation = self.raw.push_error_scope(ErrorFilter::Validation);
        let result = work();
        let validation = pollster::block_on(validation.pop());
        let internal = pollster::block_on(internal.pop());
        let memory = pollster::block_on(memory.pop());
        self.health()?;
        match memory.or(internal).or(validation) {
            Some(error) => Err(translate(&error).into()),
            None => result,
        }
    }

    /// Records commands, hands them to the queue as one submission, and waits until they have run.
    pub(crate) fn run(&self, record: impl FnOnce(&mut CommandEncoder) -> Result<()>) -> Result<()> {
        let index = self.scoped(|| {
            let mut encoder = self.raw.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            record(&mut encoder)?;
            Ok(self.queue.submit([encoder.finish()]))
        })?;
        self.wait(index)
    }

    /// Longest time to wait for one submission.
    pub(crate) fn timeout(&self) -> Duration {
        self.timeout
    }

    fn wait(&self, submission: SubmissionIndex) -> Result<()> {
        let poll = PollType::Wait { submission_index: Some(submission), timeout: Some(self.timeout) };
        // wgpu panics in `poll` when the driver reports a lost device there; no state of ours is open across the call.
        let fault = match catch_unwind(AssertUnwindSafe(|| self.raw.poll(poll))) {
            Ok(Ok(_)) => return self.health(),
            Ok(Err(PollError::Timeout)) => DeviceError::Timeout { seconds: self.timeout.as_secs_f64().ceil() as u64 },
            Ok(Err(error)) => DeviceError::Lost(error.to_string()),
            Err(_) => DeviceError::Lost("the driver failed while the work ran".to_owned()),
        };
        self.give_up(fault);
        self.health()
    }

    /// Ends the device with a fault, and leaks it.
    fn give_up(&self, fault: DeviceError) {
        record(&self.fault, fault);
        std::mem::forget((self.raw.clone(), self.queue.clone()));
    }
}

/// What every adapter is asked for: WebGPU's default limits, and no optional feature.
fn descriptor() -> wgpu::DeviceDescriptor<'static> {
    wgpu::DeviceDescriptor {
        label: Some("sightlines"),
        required_features: wgpu::Features::empty(),
        required_limits: wgpu::Limits::defaults(),
        memory_hints: wgpu::MemoryHints::MemoryUsage,
        ..Default::default()
    }
}

/// Whether the device is of no use after a fault.
fn is_final(fault: &DeviceError) -> bool {
    matches!(fault, DeviceError::Lost(_) | DeviceError::Timeout { .. })
}

/// Keeps a fault, unless a final one is kept already.
fn record(slot: &Mutex<Option<DeviceError>>, fault: DeviceError) {
    let mut slot = lock(slot);
    if !slot.as_ref().is_some_and(is_final) {
        *slot = Some(fault);
    }
}

/// The kind of an error of wgpu.
fn typed(error: &wgpu::Error) -> DeviceError {
    match error {
        wgpu::Error::OutOfMemory { .. } => DeviceError::OutOfMemory(words(error)),
        wgpu::Error::Validation { .. } | wgpu::Error::Internal { .. } => DeviceError::Validation(words(error)),
    }
}

/// An error of wgpu on one line: its causes, outermost first.
pub(crate) fn words(error: &wgpu::Error) -> String {
    let mut causes = Vec::new();
    let mut next = std::error::Error::source(error);
    while let Some(cause) = next {
        causes.push(cause.to_string());
        next = cause.source();
    }
    if causes.is_empty() { error.to_string() } else { causes.join(": ") }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// wgpu's own device that executes copies and nothing else, but validates everything: the paths of errors, tested
    /// without a driver.
    pub(crate) fn noop() -> Device {
        let (raw, queue) = wgpu::Device::noop(&descriptor());
        Device::new(raw, queue, Duration::from_secs(10))
    }

    /// The error of the device that ended the work.
    pub(crate) fn fault<T>(result: Result<T>) -> DeviceError {
        let error = result.err().expect("the work must fail");
        match error.kind() {
            sightlines_backend::ErrorKind::Device(fault) => fault.clone(),
            _ => panic!("not an error of the device: {error}"),
        }
    }

    fn spoil(device: &Device) {
        let usage = wgpu::BufferUsages::STORAGE;
        let descriptor =
            wgpu::BufferDescriptor { label: Some("spoilt"), size: u64::MAX, usage, mapped_at_creation: false };
        drop(device.raw().create_buffer(&descriptor));
    }

    #[test]
    fn a_scope_catches_errors_of_the_device_before_those_of_the_work() {
        let device = noop();
        let work = |device: &Device| {
            spoil(device);
            Err::<(), _>(sightlines_backend::Error::refused("the work", "none"))
        };
        match fault(device.scoped(|| work(&device))) {
            DeviceError::Validation(words) => assert!(words.contains("label = 'spoilt'"), "{words}"),
            other => panic!("{other}"),
        }
        device.scoped(|| Ok(())).expect("the error was reported once");
    }

    #[test]
    fn an_error_outside_a_scope_is_reported_once() {
        let device = noop();
        spoil(&device);
        assert!(matches!(fault(device.scoped(|| Ok(()))), DeviceError::Validation(_)));
        device.scoped(|| Ok(())).expect("the error was reported once");
    }

    #[test]
    fn a_lost_device_answers_everything() {
        let device = noop();
        device.raw().destroy();
        for _ in 0..2 {
            assert!(matches!(fault(device.run(|_| Ok(()))), DeviceError::Lost(_)));
        }
    }

    #[test]
    fn the_first_final_fault_stays() {
        let device = noop();
        device.give_up(DeviceError::Timeout { seconds: 3 });
        record(&device.fault, DeviceError::Lost("later".into()));
        spoil(&device);
        for _ in 0..2 {
            assert_eq!(fault(device.health()), DeviceError::Timeout { seconds: 3 });
        }
    }

    #[test]
    fn kinds_of_errors_are_kept() {
        let source = || Box::new(std::fmt::Error);
        let memory = wgpu::Error::OutOfMemory { source: source() };
        let internal = wgpu::Error::Internal { source: source(), description: String::new() };
        let reason = std::fmt::Error.to_string();
        assert_eq!(typed(&memory), DeviceError::OutOfMemory(reason.clone()));
        assert_eq!(typed(&internal), DeviceError::Validation(reason));
    }
}

//! The kernels that count, against plain loops of one thread and against lavapipe.

use criterion::measurement::Measurement;
use sightlines_backend::{Backend, Job, Session};
use sightlines_backend_wgpu::{WgpuBackend, WgpuOptions};
use sightlines_kernels::item_histogram::{ItemHistogram, Order};
use sightlines_kernels::sat::{Extent, Sat};
use sightlines_kernels::{random, screen};

use super::{Size, Table, failed, fixed, interpreter};
use crate::clock::Clock;
use crate::engine::{LAVAPIPE, Threads};
use crate::error::Result;
use crate::statistics::median;

/// Items of the item buffers.
const ITEMS: u32 = 512;

/// One thing to measure: the job, and what plain Rust makes of the same input.
struct Subject {
    name: String,
    job: Job,
    native: Box<dyn Fn() -> Vec<u32>>,
}

pub(super) fn table(size: Size) -> Result<Table> {
    let mut table = Table::new(
        "Kernels: CPU time in milliseconds of a plain loop of one thread, of the interpreter on one thread, and of lavapipe, \
         all its threads together; outputs are equal",
        &["kernel", "loop ms", "interpreter ms", "interpreter / loop", "lavapipe ms", "interpreter / lavapipe"],
    );
    let cpu = interpreter();
    let lavapipe = WgpuBackend::new(&WgpuOptions { adapter: Some(LAVAPIPE.to_owned()), ..WgpuOptions::default() }).ok();
    for subject in subjects(size)? {
        let native = time(size.runs, || Ok((subject.native)()))?;
        let ours = device(&cpu, &subject, size.runs)?;
        let theirs = lavapipe.as_ref().map(|device_| device(device_, &subject, size.runs)).transpose()?;
        let missing = || "not here".to_owned();
        table.rows.push(vec![
            subject.name,
            fixed(native / 1e6, 2),
            fixed(ours / 1e6, 2),
            fixed(ours / native, 2),
            theirs.map_or_else(missing, |ns| fixed(ns / 1e6, 2)),
            theirs.map_or_else(missing, |ns| fixed(ours / ns, 2)),
        ]);
    }
    Ok(table)
}

/// The median CPU time of `runs` calls after a first one, in nanoseconds.
fn time<T>(runs: usize, mut call: impl FnMut() -> Result<T>) -> Result<f64> {
    let clock = Clock::of(Threads::One);
    std::hint::black_box(call()?);
    let mut times = Vec::new();
    for _ in 0..runs {
        let start = clock.start();
        std::hint::black_box(call()?);
        times.push(clock.to_f64(&clock.end(start)));
    }
    median(&times).ok_or_else(|| failed("no run"))
}

/// The time of a job's recordings after the first, which uploads; its outputs must be those of the plain loop.
fn device(backend: &dyn Backend, subject: &Subject, runs: usize) -> Result<f64> {
    let Subject { name, job, native } = subject;
    let words = |bytes: &[u8]| bytes.as_chunks().0.iter().map(|b| u32::from_le_bytes(*b)).collect::<Vec<u32>>();
    let outputs = backend.run(job).map_err(failed)?;
    if outputs.iter().flat_map(|bytes| words(bytes)).collect::<Vec<_>>() != native() {
        return Err(failed(format!("{name}: {} gives other words than the plain loop", backend.info().adapter)));
    }
    let mut session: Box<dyn Session + '_> = backend.open(&job.programs, &job.buffers).map_err(failed)?;
    session.submit(&job.recordings[0]).map_err(failed)?;
    let probe = job.reads.last().map(|read| sightlines_backend::Read { size: 4, ..read.clone() });
    time(runs, || {
        job.recordings[1..].iter().try_for_each(|recording| session.submit(recording)).map_err(failed)?;
        // A word read back waits for the device.
        probe.as_ref().map(|read| session.read(read)).transpose().map_err(failed)
    })
}

fn subjects(size: Size) -> Result<Vec<Subject>> {
    let side = size.image;
    let clumped = screen::discs(side / 2, side / 2, ITEMS, 5);
    let scattered = (0..side * side / 4).map(|i| random::below(ITEMS, 6, i)).collect();
    let colours = screen::discs(side, side, ITEMS, 7);
    Ok(vec![
        sat(side, &colours)?,
        histogram(format!("histogram of {0} x {0} ids, clumped", side / 2), clumped, Order::Memory)?,
        histogram(format!("histogram of {0} x {0} ids, random", side / 2), scattered, Order::Memory)?,
    ])
}

/// Tables of four channels, a quarter of the items in each.
fn sat(side: u32, colours: &[u32]) -> Result<Subject> {
    let extent = Extent { width: side, height: side };
    let channel = |channel: u32| colours.iter().map(move |item| u32::from(*item < ITEMS && item % 4 == channel));
    let images: Vec<u32> = (0..4).flat_map(channel).collect();
    let kernel = Sat::new().map_err(failed)?;
    let mut job = Job::new();
    let uploaded = job.slice("images", &images);
    job.cut();
    let tables = job.zeroed("tables", images.len() as u64);
    kernel.record(&mut job, (extent, 4), uploaded, tables).map_err(failed)?;
    job.read("tables", tables.id());
    let native = move || {
        let planes = images.chunks(extent.pixels() as usize);
        planes.flat_map(|image| plain_sat(extent.width as usize, image)).collect()
    };
    Ok(Subject { name: format!("tables of {side} x {side}, 4 channels"), job, native: Box::new(native) })
}

fn plain_sat(width: usize, image: &[u32]) -> Vec<u32> {
    let mut table = vec![0_u32; image.len()];
    for (row, pixels) in image.chunks(width).enumerate() {
        let (above, below) = table.split_at_mut(row * width);
        let above = &above[above.len().saturating_sub(width)..];
        let mut sum = 0_u32;
        for (x, pixel) in pixels.iter().enumerate() {
            sum = sum.wrapping_add(*pixel);
            below[x] = sum.wrapping_add(above.get(x).copied().unwrap_or(0));
        }
    }
    table
}

fn histogram(name: String, ids: Vec<u32>, order: Order) -> Result<Subject> {
    let kernel = ItemHistogram::new().map_err(failed)?;
    let mut job = Job::new();
    let buffer = job.slice("ids", &ids);
    job.cut();
    let counts = job.zeroed("counts", u64::from(ITEMS));
    // Counts are added to what is there: each repetition begins with none.
    let size = 4 * u64::from(ITEMS);
    job.record(sightlines_backend::Command::Clear { buffer: counts.id(), offset: 0, size });
    kernel.record_counts(&mut job, order, (ids.len() as u32, buffer), (ITEMS, counts)).map_err(failed)?;
    job.read("counts", counts.id());
    let native = move || {
        let mut counts = vec![0_u32; ITEMS as usize];
        ids.iter().filter(|id| **id < ITEMS).for_each(|id| counts[*id as usize] += 1);
        counts
    };
    Ok(Subject { name, job, native: Box::new(native) })
}

//! Drawing what was counted, on the device: counts of one view set the workgroups of the draws of the next, and the
//! host reads nothing in between.
//!
//! Engelhardt and Dachsbacher, sections 1 and 5: results are used by later shaders without a read-back. A kernel turns
//! counts into arguments of indirect dispatches; those of an instance that was not counted run no workgroup. Invariant:
//! the draws that run are those that a host would choose by the same counts, so the picture is the same, bit for bit.

use std::collections::HashMap;

use glam::UVec4;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, BufferId, Command, Groups, Job};
use sightlines_kernels::depth_bounds::DepthBounds;
use sightlines_kernels::raster::Ids;

use super::answer::Run;
use super::{Item, Method, Painted, Queries, Stage};
use crate::error::Result;

/// Counts the instances of a stage, and draws those of another stage of the same world of which more than `threshold`
/// pixels were counted; all in one session, whose only read is that of the picture.
///
/// # Errors
///
/// Those of a query.
pub fn draw_counted(
    backend: &dyn Backend,
    counted: &Stage,
    drawn: &Stage,
    method: Method,
    threshold: u32,
) -> Result<Painted> {
    let queries = Queries::new()?;
    let mut job = Job::new();
    let pixels = counted.record(&queries.raster, &mut job)?;
    let counts = queries.record(&mut job, counted, &pixels, method, 0)?;
    job.cut();
    let second = job.recordings.len() - 1;
    let places: HashMap<usize, u32> = counted.items.iter().map(|item| item.instance).zip(0..).collect();
    let place = |(number, item): (usize, &Item)| places.get(&item.instance).map(|place| (number, *place));
    let asked: Vec<(usize, u32)> = drawn.items.iter().enumerate().filter_map(place).collect();
    let buffers = record_counted(&queries, &mut job, drawn, &asked, (counts.totals, threshold))?;
    let mut run = Run::open(backend, &job)?;
    run.submit(&job, 0..second, &mut |_| ())?;
    let draw = run.submit(&job, second..job.recordings.len(), &mut |_| ())?;
    run.painted(drawn, buffers, draw)
}

/// Draws some items of a stage of whole instances, one after the other, each if the word of `counts` at its place
/// exceeds a threshold: depths, and the numbers of items.
pub(super) fn record_counted(
    queries: &Queries,
    job: &mut Job,
    stage: &Stage,
    asked: &[(usize, u32)],
    (counts, threshold): (Buffer<[u32]>, u32),
) -> Result<[Buffer<[u32]>; 2]> {
    let picture = stage.frame.view.picture;
    let [depth, items] = ["depth", "items"].map(|name| job.zeroed(name, u64::from(picture.pixels())));
    queries.raster.record_clear(job, picture, depth)?;
    queries.raster.record_clear(job, picture, items)?;
    job.cut();
    let first = job.recordings.len() - 1;
    let mut draws = Draws { arguments: job.buffer("arguments", 0), all: Vec::new() };
    let mut projected = Vec::with_capacity(asked.len());
    for (item, place) in asked {
        let part = stage.layer(&[*item]);
        draws.record(job, *place, |job| {
            let meshes = part.project(&queries.raster, job)?;
            for mesh in &meshes {
                queries.raster.record_depth(job, mesh, stage.faces, depth)?;
            }
            projected.push(meshes);
            Ok(())
        })?;
    }
    for (meshes, (item, place)) in projected.iter().zip(asked) {
        draws.record(job, *place, |job| {
            let ids = Ids { base: *item as u32, step: 0, shift: 31 };
            let each = |mesh| Ok(queries.raster.record_items(job, mesh, stage.faces, ids, [depth, items])?);
            meshes.iter().try_for_each(each)
        })?;
    }
    draws.record_arguments(job, (counts, threshold), first)?;
    Ok([depth, items])
}

/// Draws whose workgroups come from a buffer.
struct Draws {
    arguments: BufferId,
    /// The workgroups that each had, and the place of its count.
    all: Vec<UVec4>,
}

impl Draws {
    /// Makes every dispatch that `record` records depend on a count.
    fn record(&mut self, job: &mut Job, place: u32, record: impl FnOnce(&mut Job) -> Result<()>) -> Result<()> {
        job.cut();
        let first = job.recordings.len() - 1;
        record(job)?;
        for command in job.recordings[first..].iter_mut().flat_map(|recording| &mut recording.commands) {
            let Command::Dispatch(dispatch) = command else { continue };
            let Groups::Direct([x, y, z]) = dispatch.groups else { continue };
            let offset = 12 * self.all.len() as u64;
            dispatch.groups = Groups::Indirect { buffer: self.arguments, offset };
            self.all.push(UVec4::new(x, y, z, place));
        }
        Ok(())
    }

    /// Writes the workgroups in recordings that come before those from `at` on.
    fn record_arguments(&self, job: &mut Job, (counts, threshold): (Buffer<[u32]>, u32), at: usize) -> Result<()> {
        let end = job.recordings.len();
        job.cut();
        let count = self.all.len() as u32;
        job.buffers[self.arguments.0 as usize].size = 12 * u64::from(count.max(1));
        let arguments = Buffer::from_raw(self.arguments, 0, job.size(self.arguments));
        let draws = job.slice("draws", if self.all.is_empty() { &[UVec4::ZERO] } else { &self.all[..] });
        DepthBounds::new()?.record_predicates(job, threshold, (count, draws), counts, arguments)?;
        let before: Vec<_> = job.recordings.drain(end..).collect();
        job.recordings.splice(at..at, before);
        Ok(())
    }
}

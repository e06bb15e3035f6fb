//! What visibility queries are compared with, on the same raster: queries of whole objects, predicated drawing, the
//! hierarchical depth buffer and N-buffers (sections 1 and 2 of the paper).
//!
//! All of them test boxes against the depths of the whole scene, so all keep every instance that shows a pixel. The first
//! two draw the box of each instance and count its pixels, one after the other: `whole_objects` reads each count back
//! before it asks for the next; `predicated` leaves them on the device, where they decide whether the instance's draw runs.

use glam::UVec4;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Command, Groups, Job};
use sightlines_kernels::depth_bounds::{Boxes, DepthBounds, Form};
use sightlines_kernels::item_histogram::Order;
use sightlines_kernels::raster::{Faces, Ids};

use super::answer::Run;
use super::{Drawn, Granularity, Item, Painted, Queries, Spent, Stage, bounds};
use crate::error::Result;
use crate::scene::{Instance, Mesh, World};

/// What a method keeps, and what asking took.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// Whether each item of the stage is drawn.
    pub kept: Vec<bool>,
    /// Drawing the depths that boxes are tested against.
    pub draw: Spent,
    /// The tests.
    pub test: Spent,
    /// How often the host waited for the device.
    pub read_backs: usize,
}

/// The boxes of the meshes in place of the meshes.
fn boxes(world: &World) -> World {
    let boxed = |mesh: &Mesh| {
        let alone = Instance { name: String::new(), mesh: 0, transform: crate::scene::Affine::IDENTITY };
        let one = World { meshes: vec![mesh.clone()], instances: vec![alone], ..world.clone() };
        let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let triangles = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        Mesh { name: mesh.name.clone(), vertices: one.corners().into_flattened(), triangles, ..Mesh::default() }
    };
    World { meshes: world.meshes.iter().map(boxed).collect(), ..world.clone() }
}

/// What boxes are drawn into: the scene's depths, a copy that a box may lower, and the pixels where it does or ties.
struct Probe {
    depth: Buffer<[u32]>,
    copy: Buffer<[u32]>,
    words: Buffer<[u32]>,
    counts: Buffer<[u32]>,
}

impl Probe {
    fn new(job: &mut Job, drawn: &Drawn) -> Self {
        let pixels = u64::from(drawn.picture.pixels());
        let [copy, words] = ["probed depth", "probed pixels"].map(|name| job.zeroed(name, pixels));
        let counts = job.zeroed("box counts", u64::from(drawn.items.max(1)));
        Probe { depth: drawn.depth, copy, words, counts }
    }

    /// Counts the pixels in which the box of an item is not behind the scene.
    fn record(&self, queries: &Queries, job: &mut Job, boxes: &World, stage: &Stage, number: u32) -> Result<()> {
        let picture = stage.frame.view.picture;
        let instance = stage.items[number as usize].instance;
        let part = Stage::new(boxes, stage.frame, &[instance], Granularity::Instances)?;
        let size = 4 * u64::from(picture.pixels());
        job.record(Command::Copy { from: self.depth.id(), from_offset: 0, to: self.copy.id(), to_offset: 0, size });
        queries.raster.record_clear(job, picture, self.words)?;
        let ids = Ids { base: number, step: 0, shift: 31 };
        for projected in part.project(&queries.raster, job)? {
            queries.raster.record_depth(job, &projected, Faces::All, self.copy)?;
            queries.raster.record_items(job, &projected, Faces::All, ids, [self.copy, self.words])?;
        }
        let bins = stage.items.len() as u32;
        Ok(queries.histogram.record_counts(job, Order::Memory, (picture.pixels(), self.words), (bins, self.counts))?)
    }
}

/// Stop and wait: the box of each instance is drawn and its pixels are read back, one instance after the other.
///
/// # Errors
///
/// Whatever the backend refuses.
pub fn whole_objects(backend: &dyn Backend, world: &World, stage: &Stage) -> Result<Verdict> {
    let queries = Queries::new()?;
    let boxes = boxes(world);
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job)?;
    let probe = Probe::new(&mut job, &drawn);
    let mut starts = vec![job.recordings.len()];
    for number in 0..drawn.items {
        job.cut();
        probe.record(&queries, &mut job, &boxes, stage, number)?;
        starts.push(job.recordings.len());
    }
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, 0..starts[0], &mut |_| ())?;
    let mut test = Spent { lane_ops: Some(0), counts: Some(sightlines_backend::Counts::default()), dispatches: 0 };
    let mut kept = Vec::with_capacity(stage.items.len());
    for (number, range) in starts.windows(2).enumerate() {
        test += run.submit(&job, range[0]..range[1], &mut |_| ())?;
        kept.push(run.read(probe.counts)?[number] > 0);
    }
    Ok(Verdict { read_backs: kept.len(), kept, draw, test })
}

/// Predicated drawing: the counts of boxes stay on the device and set the workgroups of each instance's draw, to none
/// where no pixel of its box is seen. The answer has the picture that was drawn so.
///
/// # Errors
///
/// Whatever the backend refuses.
pub fn predicated(backend: &dyn Backend, world: &World, stage: &Stage) -> Result<(Verdict, Painted)> {
    let (queries, predicates) = (Queries::new()?, DepthBounds::new()?);
    let boxes = boxes(world);
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job)?;
    let probe = Probe::new(&mut job, &drawn);
    let first = job.recordings.len();
    for number in 0..drawn.items {
        job.cut();
        probe.record(&queries, &mut job, &boxes, stage, number)?;
    }
    job.cut();
    let second = job.recordings.len() - 1;
    let picture = stage.frame.view.picture;
    let pixels = u64::from(picture.pixels());
    let [depth, words] = ["depth", "item words"].map(|name| job.zeroed(name, pixels));
    queries.raster.record_clear(&mut job, picture, depth)?;
    queries.raster.record_clear(&mut job, picture, words)?;
    let mut draws = Draws { arguments: job.buffer("arguments", 0), all: Vec::new() };
    let mut projected = Vec::new();
    for (number, Item { instance, .. }) in stage.items.iter().enumerate() {
        let part = Stage::new(world, stage.frame, &[*instance], Granularity::Instances)?;
        draws.record(&mut job, number as u32, |job| {
            let on_screen = part.project(&queries.raster, job)?;
            for mesh in &on_screen {
                queries.raster.record_depth(job, mesh, stage.faces, depth)?;
            }
            projected.push(on_screen);
            Ok(())
        })?;
    }
    for (number, meshes) in projected.iter().enumerate() {
        draws.record(&mut job, number as u32, |job| {
            let ids = Ids { base: number as u32, step: 0, shift: 31 };
            let each = |mesh| Ok(queries.raster.record_items(job, mesh, stage.faces, ids, [depth, words])?);
            meshes.iter().try_for_each(each)
        })?;
    }
    draws.predicate(&mut job, &predicates, probe.counts, second)?;
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, 0..first, &mut |_| ())?;
    let test = run.submit(&job, first..second, &mut |_| ())?;
    let again = run.submit(&job, second..job.recordings.len(), &mut |_| ())?;
    let mut kept: Vec<bool> = run.read(probe.counts)?.into_iter().map(|pixels| pixels > 0).collect();
    kept.truncate(stage.items.len());
    let instance = |item: u32| stage.items.get(item as usize).map(|item| item.instance);
    let instances = run.read(words)?.into_iter().map(instance).collect();
    let painted = Painted { depths: run.read(depth)?, instances, draw: again };
    Ok((Verdict { kept, draw, test, read_backs: 0 }, painted))
}

/// Draws whose workgroups come from a buffer.
struct Draws {
    arguments: sightlines_backend::BufferId,
    /// The workgroups that each had, and its object.
    all: Vec<UVec4>,
}

impl Draws {
    /// Makes every dispatch that `record` records depend on an object.
    fn record(&mut self, job: &mut Job, object: u32, record: impl FnOnce(&mut Job) -> Result<()>) -> Result<()> {
        let recording = job.recordings.len() - 1;
        let command = job.recordings[recording].commands.len();
        record(job)?;
        for (number, later) in job.recordings[recording..].iter_mut().enumerate() {
            let from = if number == 0 { command } else { 0 };
            for command in &mut later.commands[from..] {
                let Command::Dispatch(dispatch) = command else { continue };
                let Groups::Direct([x, y, z]) = dispatch.groups else { continue };
                let offset = 12 * self.all.len() as u64;
                dispatch.groups = Groups::Indirect { buffer: self.arguments, offset };
                self.all.push(UVec4::new(x, y, z, object));
            }
        }
        Ok(())
    }

    /// Writes the workgroups in recordings that come before those from `at` on.
    fn predicate(&self, job: &mut Job, kernel: &DepthBounds, counts: Buffer<[u32]>, at: usize) -> Result<()> {
        let end = job.recordings.len();
        job.cut();
        let count = self.all.len() as u32;
        job.buffers[self.arguments.0 as usize].size = 12 * u64::from(count.max(1));
        let arguments = Buffer::from_raw(self.arguments, 0, job.size(self.arguments));
        let draws = job.slice("draws", if self.all.is_empty() { &[UVec4::ZERO] } else { &self.all[..] });
        kernel.record_predicates(job, 0, (count, draws), counts, arguments)?;
        let predicates: Vec<_> = job.recordings.drain(end..).collect();
        job.recordings.splice(at..at, predicates);
        Ok(())
    }
}

/// The hierarchical depth buffer or N-buffers: the rectangle and least depth of each instance against the greatest depth
/// around it.
///
/// # Errors
///
/// Whatever the backend refuses.
pub fn depth_tests(backend: &dyn Backend, stage: &Stage, form: Form) -> Result<Verdict> {
    let (queries, kernel) = (Queries::new()?, DepthBounds::new()?);
    let bounds = bounds::of(stage);
    let asked: Vec<usize> = (0..bounds.len()).filter(|item| !bounds[*item].is_empty()).collect();
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job)?;
    job.cut();
    let boundary = job.recordings.len() - 1;
    let levels = kernel.record_levels(&mut job, form, drawn.picture, drawn.depth)?;
    let rectangles: Vec<UVec4> = asked.iter().map(|item| bounds[*item].rectangle).chain([UVec4::ZERO]).collect();
    let nearest: Vec<u32> = asked.iter().map(|item| bounds[*item].nearest).chain([0]).collect();
    let (rectangles, nearest) = (job.slice("rectangles", &rectangles), job.slice("nearest", &nearest));
    let hidden = job.zeroed("hidden", asked.len() as u64 + 1);
    kernel.record_tests(&mut job, &levels, Boxes { count: asked.len() as u32, rectangles, nearest }, hidden)?;
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, 0..boundary, &mut |_| ())?;
    let test = run.submit(&job, boundary..job.recordings.len(), &mut |_| ())?;
    let mut kept = vec![false; stage.items.len()];
    asked.iter().zip(run.read(hidden)?).for_each(|(item, hidden)| kept[*item] = hidden == 0);
    Ok(Verdict { kept, draw, test, read_backs: 1 })
}

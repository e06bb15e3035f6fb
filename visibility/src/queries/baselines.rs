//! What visibility queries are compared with, on the same raster: queries of whole objects, predicated drawing, the
//! hierarchical depth buffer and N-buffers (sections 1 and 2 of the paper).
//!
//! All of them test boxes against the depths of the whole scene, so all keep every instance that shows a pixel. The
//! first two draw the box of each instance and count its pixels: `whole_objects` waits for each count by itself;
//! `predicated` leaves them on the device, where they decide whether the instance's draw runs. Hardware counts while it
//! draws; here a count is a pass over the picture, and boxes that are apart on the screen share it.

use std::ops::Range;

use glam::UVec4;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Command, Job};
use sightlines_kernels::depth_bounds::{self, DepthBounds, Form};
use sightlines_kernels::item_histogram::Order;
use sightlines_kernels::pieces;

use super::answer::Run;
use super::share::layers;
use super::{Drawn, Granularity, Painted, Queries, Spent, Stage, bounds, device, hib};
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
    /// How often the host waited for the device; for what is not in the picture, it need not.
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

/// The boxes of a stage's items, in layers of those that are apart on the screen and so cannot hide one another. Their
/// pixels are counted layer after layer: what a layer draws, it draws into a copy of the scene's depths.
struct Boxes {
    layers: Vec<Stage>,
    /// The item of each count.
    items: Vec<usize>,
    counts: Buffer<[u32]>,
    /// A copy of depths, and the words and bins of pixels.
    scratch: [Buffer<[u32]>; 3],
}

impl Boxes {
    fn new(job: &mut Job, world: &World, stage: &Stage) -> Result<Self> {
        let instances: Vec<usize> = stage.items.iter().map(|item| item.instance).collect();
        let boxes = Stage::new(&boxes(world), stage.frame, &instances, Granularity::Instances)?;
        let all: Vec<usize> = (0..instances.len()).collect();
        let layers = layers(stage.frame.view.picture, &bounds::of(&boxes), &all, all.len()).unwrap_or_default();
        let pixels = u64::from(stage.frame.view.picture.pixels());
        Ok(Boxes {
            scratch: ["probed depth", "probed pixels", "probed bins"].map(|name| job.zeroed(name, pixels)),
            counts: job.zeroed("box counts", all.len().max(1) as u64),
            layers: layers.iter().map(|layer| boxes.layer(layer)).collect(),
            items: layers.concat(),
        })
    }

    /// Counts the pixels in which the boxes of a layer are not behind the scene; `first` is where its counts begin.
    fn record(&self, queries: &Queries, job: &mut Job, drawn: &Drawn, layer: usize, first: usize) -> Result<()> {
        let pixels = drawn.picture.pixels();
        let [copy, words, labels] = self.scratch;
        let (from, to, size) = (drawn.depth.id(), copy.id(), 4 * u64::from(pixels));
        job.record(Command::Copy { from, from_offset: 0, to, to_offset: 0, size });
        let probed = self.layers[layer].record_over(&queries.raster, job, [copy, words])?;
        let bins: Vec<u32> = probed.firsts.iter().map(|place| first as u32 + place).collect();
        hib::record_labels(queries, job, &probed, 0, &bins, labels)?;
        let counts = (self.items.len() as u32, self.counts);
        Ok(queries.histogram.record_counts(job, Order::Memory, (pixels, labels), counts)?)
    }

    /// Counts all layers; where the recordings of each begin and end.
    fn record_all(&self, queries: &Queries, job: &mut Job, drawn: &Drawn) -> Result<Vec<Range<usize>>> {
        let mut first = 0;
        let mut recordings = Vec::with_capacity(self.layers.len());
        for (number, layer) in self.layers.iter().enumerate() {
            pieces::cut(job);
            let start = job.recordings.len() - 1;
            self.record(queries, job, drawn, number, first)?;
            recordings.push(start..job.recordings.len());
            first += layer.items.len();
        }
        Ok(recordings)
    }

    /// Whether the box of each item of a stage shows a pixel.
    fn kept(&self, items: usize, counts: &[u32]) -> Vec<bool> {
        let mut kept = vec![false; items];
        self.items.iter().zip(counts).for_each(|(item, pixels)| kept[*item] = *pixels > 0);
        kept
    }
}

/// Stop and wait: the boxes are drawn, and the host waits for the count of each instance by itself.
///
/// # Errors
///
/// Whatever the backend refuses.
pub fn whole_objects(backend: &dyn Backend, world: &World, stage: &Stage) -> Result<Verdict> {
    let queries = Queries::new()?;
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job)?;
    let scene = 0..job.recordings.len();
    let boxes = Boxes::new(&mut job, world, stage)?;
    let layers = boxes.record_all(&queries, &mut job, &drawn)?;
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, scene, &mut |_| ())?;
    let mut test = Spent { lane_ops: Some(0), counts: Some(sightlines_backend::Counts::default()), dispatches: 0 };
    let mut counts = Vec::with_capacity(boxes.items.len());
    for (range, layer) in layers.into_iter().zip(&boxes.layers) {
        test += run.submit(&job, range, &mut |_| ())?;
        for _ in &layer.items {
            counts.push(run.read(boxes.counts)?[counts.len()]);
        }
    }
    Ok(Verdict { read_backs: counts.len(), kept: boxes.kept(stage.items.len(), &counts), draw, test })
}

/// Predicated drawing: the counts of boxes stay on the device and set the workgroups of each instance's draw, to none
/// where no pixel of its box is seen. The answer has the picture that was drawn so.
///
/// # Errors
///
/// Whatever the backend refuses.
pub fn predicated(backend: &dyn Backend, world: &World, stage: &Stage) -> Result<(Verdict, Painted)> {
    let queries = Queries::new()?;
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job)?;
    let first = job.recordings.len();
    let boxes = Boxes::new(&mut job, world, stage)?;
    boxes.record_all(&queries, &mut job, &drawn)?;
    job.cut();
    let second = job.recordings.len() - 1;
    let asked: Vec<(usize, u32)> = boxes.items.iter().copied().zip(0..).collect();
    let [depth, words] = device::record_counted(&queries, &mut job, stage, &asked, (boxes.counts, 0))?;
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, 0..first, &mut |_| ())?;
    let test = run.submit(&job, first..second, &mut |_| ())?;
    let again = run.submit(&job, second..job.recordings.len(), &mut |_| ())?;
    let kept = boxes.kept(stage.items.len(), &run.read(boxes.counts)?);
    let painted = run.painted(stage, [depth, words], again)?;
    Ok((Verdict { kept, draw, test, read_backs: 0 }, painted))
}

/// The hierarchical depth buffer or N-buffers: the rectangle and least depth of each instance against the greatest
/// depth around it.
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
    let boxes = depth_bounds::Boxes { count: asked.len() as u32, rectangles, nearest };
    kernel.record_tests(&mut job, &levels, boxes, hidden)?;
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, 0..boundary, &mut |_| ())?;
    let test = run.submit(&job, boundary..job.recordings.len(), &mut |_| ())?;
    let mut kept = vec![false; stage.items.len()];
    asked.iter().zip(run.read(hidden)?).for_each(|(item, hidden)| kept[*item] = hidden == 0);
    Ok(Verdict { kept, draw, test, read_backs: 1 })
}

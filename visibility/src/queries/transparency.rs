//! Visibility through transparent blockers: every pixel of an instance counts as much as is seen of it.
//!
//! Engelhardt and Dachsbacher, section 5: values other than 0 and 1 are written where a pixel is drawn, or summed where
//! it is counted. Opaque instances are drawn first; every pixel then has the weight [`FULL`] times what each veil
//! before it lets through. An instance whose weights sum to nothing is culled. Invariant: a surface further back is
//! behind the same veils or more, and its weight is the same or less; so where a culled instance stood, weights are
//! nothing before and after, everywhere else they and the instance are what they were, and a picture of weighted
//! colours stays the same.

use sightlines_backend::{Backend, Job};
use sightlines_kernels::transmittance::{Pictures, Transmittance};

use super::answer::Run;
use super::share::{MAX_LAYERS, layers};
use super::{Answer, Cost, Drawn, Granularity, Method, Queries, Spent, Stage, bounds, hib};
use crate::error::{Place, Result};
use crate::scene::World;
use crate::scene::frame::Frame;

/// Weight of a pixel with nothing before it: a step less is a grey level of a picture. Sums of 4096 by 4096 fit a word.
pub const FULL: u32 = 255;

/// An instance that lets some light through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Veil {
    /// The instance, by its place in the world.
    pub instance: usize,
    /// How much it lets through, once for all its surfaces, in 1/256.
    pub through: u32,
}

/// What is seen through veils.
#[derive(Clone, Debug)]
pub struct Veiled {
    /// Opaque instances, their pixels without regard to veils, and the picture of them.
    pub answer: Answer,
    /// Sum of the weights of the pixels of each item of it.
    pub sums: Vec<u32>,
    /// Weight of every pixel.
    pub weights: Vec<u32>,
    /// Drawing the veils and weighting the pixels.
    pub weigh: Spent,
}

impl Veiled {
    /// Opaque instances of which at least so much is seen, as a sum of weights.
    pub fn kept(&self, least: u32) -> Vec<usize> {
        let items = self.answer.items.iter().zip(&self.sums);
        items.filter(|(_, sum)| **sum >= least).map(|(item, _)| item.instance).collect()
    }
}

/// Counts opaque instances and sums what is seen of them through veils, both by `method`.
///
/// # Errors
///
/// Those of a query, and more than [`MAX_LAYERS`] veils one over the other.
pub fn query_veiled(
    backend: &dyn Backend,
    world: &World,
    frame: Frame,
    opaque: &[usize],
    veils: &[Veil],
    method: Method,
) -> Result<Veiled> {
    let queries = Queries::new()?;
    let stage = Stage::new(world, frame, opaque, Granularity::Instances)?;
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job)?;
    let weights = job.slice("weights", &vec![FULL; drawn.picture.pixels() as usize]);
    job.cut();
    let weighing = job.recordings.len() - 1;
    for layer in veil_layers(world, frame, veils)? {
        record_layer(&queries, &mut job, &drawn, layer, weights)?;
    }
    job.cut();
    let counting = job.recordings.len() - 1;
    let sums = queries.record_weighted(&mut job, &stage, &drawn, weights, method, 0)?;
    let counts = queries.record(&mut job, &stage, &drawn, method, 0)?;
    let mut run = Run::open(backend, &job)?;
    let draw = run.submit(&job, 0..weighing, &mut |_| ())?;
    let weigh = run.submit(&job, weighing..counting, &mut |_| ())?;
    let count = run.submit(&job, counting..job.recordings.len(), &mut |_| ())?;
    let mut sums = run.read(sums.totals)?;
    sums.truncate(stage.items.len());
    let weights = run.read(weights)?;
    let bytes = job.buffers.iter().map(|buffer| buffer.size).sum();
    let answer = run.answer(&stage, &drawn, &counts, method, Cost { draw, count, bytes })?;
    Ok(Veiled { answer, sums, weights, weigh })
}

/// Veils that are apart on the screen, and what each lets through, by its item.
fn veil_layers(world: &World, frame: Frame, veils: &[Veil]) -> Result<Vec<(Stage, Vec<u32>)>> {
    let instances: Vec<usize> = veils.iter().map(|veil| veil.instance).collect();
    let stage = Stage::new(world, frame, &instances, Granularity::Instances)?;
    let mut through = vec![0; world.instances.len()];
    veils.iter().for_each(|veil| through[veil.instance] = veil.through);
    let all: Vec<usize> = (0..stage.items.len()).collect();
    let layers = layers(frame.view.picture, &bounds::of(&stage), &all, MAX_LAYERS).ok_or_else(|| {
        let what = format!("more than {MAX_LAYERS} of {} veils lie one over the other", veils.len());
        Place::default().element("veils").error(what, "make fewer instances transparent, or join them")
    })?;
    let layer = |items: &Vec<usize>| {
        let part = stage.layer(items);
        let through = part.items.iter().map(|item| through[item.instance]).collect();
        (part, through)
    };
    Ok(layers.iter().map(layer).collect())
}

/// Weights the pixels behind the veils of a layer.
fn record_layer(
    queries: &Queries,
    job: &mut Job,
    drawn: &Drawn,
    (layer, through): (Stage, Vec<u32>),
    weights: sightlines_backend::host::Buffer<[u32]>,
) -> Result<()> {
    let veils = layer.record(&queries.raster, job)?;
    let blockers = hib::labels(queries, job, &veils, 0)?;
    let (depths, blocker_depths) = (drawn.depth, veils.depth);
    let pictures = Pictures { pixels: drawn.picture.pixels(), depths, blocker_depths, blockers };
    let factors = job.slice("through", &through);
    Ok(Transmittance::new()?.record(job, pictures, (through.len() as u32, factors), weights)?)
}

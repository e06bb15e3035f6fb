//! The visible share of each instance: pixels seen over the pixels that it would cover with nothing in front.
//!
//! Engelhardt and Dachsbacher, section 5: the number of hidden pixels gives a fractional visibility, which controls detail.
//! Instances whose rectangles are apart cannot hide one another, so they are drawn and counted at once; the layers are a
//! colouring of the conflict graph, as many as it needs. Invariant: the covered count of an instance is exact, so a share
//! is at most 1.

use glam::UVec4;
use sightlines_backend::{Backend, Job};

use super::answer::Run;
use super::{Answer, Granularity, Method, Queries, Stage, bounds};
use crate::error::Result;
use crate::scene::World;

/// Pixels that each item of a stage of whole instances would show with nothing in front of it; `progress` is called with
/// the share of the work that is done.
///
/// # Errors
///
/// Whatever the backend refuses.
pub fn covered(backend: &dyn Backend, world: &World, stage: &Stage, progress: &mut dyn FnMut(f32)) -> Result<Vec<u32>> {
    let queries = Queries::new()?;
    let mut covered = vec![0; stage.items.len()];
    let layers = layers(&bounds::of(stage).iter().map(|b| b.rectangle).collect::<Vec<_>>());
    for (number, layer) in layers.iter().enumerate() {
        let instances: Vec<usize> = layer.iter().map(|item| stage.items[*item].instance).collect();
        let part = Stage::new(world, stage.frame, &instances, Granularity::Instances)?;
        let mut job = Job::new();
        let drawn = part.record(&queries.raster, &mut job)?;
        let counts = queries.record(&mut job, &part, &drawn, Method::HIB, 0)?;
        let mut run = Run::open(backend, &job)?;
        run.submit(&job, 0..job.recordings.len(), &mut |_| ())?;
        for (item, pixels) in layer.iter().zip(run.read(counts.totals)?) {
            covered[*item] = pixels;
        }
        progress((number + 1) as f32 / layers.len() as f32);
    }
    Ok(covered)
}

/// Numbers in layers of rectangles that are apart, ascending in each layer; empty rectangles are in none.
fn layers(rectangles: &[UVec4]) -> Vec<Vec<usize>> {
    let mut layers: Vec<Vec<usize>> = Vec::new();
    for (number, r) in rectangles.iter().enumerate().filter(|(_, r)| r.x < r.z && r.y < r.w) {
        let apart = |other: &usize| {
            let o = rectangles[*other];
            r.z <= o.x || o.z <= r.x || r.w <= o.y || o.w <= r.y
        };
        match layers.iter_mut().find(|layer| layer.iter().all(apart)) {
            Some(layer) => layer.push(number),
            None => layers.push(vec![number]),
        }
    }
    layers
}

impl Answer {
    /// The visible share of an item in units of 1/65536, rounded to the nearest; none where it covers no pixel. A bound
    /// of its pixels that exceeds what it covers counts as all of it.
    pub fn share(&self, item: usize, covered: &[u32]) -> Option<u32> {
        let all = u64::from(covered[item]);
        (all > 0).then(|| (((u64::from(self.totals[item]).min(all) << 16) + all / 2) / all) as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_hold_what_is_apart() {
        let r = UVec4::new;
        let found = layers(&[r(0, 0, 9, 9), r(8, 8, 12, 12), r(9, 0, 12, 8), r(0, 0, 0, 0), r(0, 0, 1, 1)]);
        assert_eq!(found, [vec![0, 2], vec![1, 4]]);
    }
}

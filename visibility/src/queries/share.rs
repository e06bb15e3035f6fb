//! The visible share of each instance: pixels seen over the pixels that it would cover with nothing in front.
//!
//! Engelhardt and Dachsbacher, section 5: the number of hidden pixels gives a fractional visibility, which controls
//! detail. Instances whose rectangles are apart cannot hide one another, so they are drawn and counted at once, in
//! layers. Invariant: the covered count of an instance is exact, so a share is at most 1.

use sightlines_backend::{Backend, Job};
use sightlines_kernels::raster::Picture;

use super::answer::Run;
use super::{Answer, Method, Queries, Stage, bounds};
use crate::error::{Place, Result};
use crate::queries::bounds::Bounds;

/// Most layers, each of which is a picture that is drawn.
pub const MAX_LAYERS: usize = 1024;

/// Pixels a side of the cells by which a layer finds what is near.
const CELL: u32 = 128;

/// Pixels that each of some items of a stage of whole instances, ascending, would show with nothing in front of it;
/// `progress` is called with the share of the work that is done.
///
/// # Errors
///
/// More than [`MAX_LAYERS`] of them one over the other, and whatever the backend refuses.
pub fn covered(
    backend: &dyn Backend,
    stage: &Stage,
    items: &[usize],
    progress: &mut dyn FnMut(f32),
) -> Result<Vec<u32>> {
    let queries = Queries::new()?;
    let bounds = bounds::of(stage);
    let mut covered = vec![0; stage.items.len()];
    let layers = layers(stage.frame.view.picture, &bounds, items, MAX_LAYERS).ok_or_else(|| {
        let what = format!("more than {MAX_LAYERS} of the {} instances lie one over the other", items.len());
        Place::default().element("covered pixels").error(what, "count without them (--no-shares), or join instances")
    })?;
    for (number, layer) in layers.iter().enumerate() {
        let part = stage.layer(layer);
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
    Ok(items.iter().map(|item| covered[*item]).collect())
}

impl Stage {
    /// Some items of a stage of whole instances, ascending: item i of the part is the i-th of them.
    pub(super) fn layer(&self, items: &[usize]) -> Stage {
        let mut kept = vec![false; items.iter().map(|item| self.items[*item].instance + 1).max().unwrap_or(0)];
        items.iter().for_each(|item| kept[self.items[*item].instance] = true);
        self.part(|instance| kept.get(instance).copied().unwrap_or(false))
    }
}

/// Rectangles that are apart.
struct Layer {
    items: Vec<usize>,
    /// Those of the items that meet each cell of the picture, row after row.
    cells: Vec<Vec<usize>>,
}

/// The cells that a rectangle meets.
fn cells(picture: Picture, bounds: &Bounds) -> impl Iterator<Item = usize> + Clone {
    let r = bounds.rectangle;
    let columns = picture.width.div_ceil(CELL);
    let range = |low: u32, high: u32| low / CELL..=(high - 1) / CELL;
    let (along, down) = (range(r.x, r.z), range(r.y, r.w));
    down.flat_map(move |y| along.clone().map(move |x| (y * columns + x) as usize))
}

/// The items in layers of rectangles that are apart, ascending in each layer, each in the first that has room for it;
/// those without pixels are in none. Nothing where there would be more than `most`.
pub(super) fn layers(picture: Picture, bounds: &[Bounds], items: &[usize], most: usize) -> Option<Vec<Vec<usize>>> {
    let count = (picture.width.div_ceil(CELL) * picture.height.div_ceil(CELL)) as usize;
    let mut layers: Vec<Layer> = Vec::new();
    for &item in items.iter().filter(|item| !bounds[**item].is_empty()) {
        let met = cells(picture, &bounds[item]);
        let apart = |other: &usize| {
            let (r, o) = (bounds[item].rectangle, bounds[*other].rectangle);
            r.z <= o.x || o.z <= r.x || r.w <= o.y || o.w <= r.y
        };
        let free = |layer: &Layer| met.clone().all(|cell| layer.cells[cell].iter().all(apart));
        let place = layers.iter().position(free).unwrap_or(layers.len());
        if place == most {
            return None;
        }
        if place == layers.len() {
            layers.push(Layer { items: Vec::new(), cells: vec![Vec::new(); count] });
        }
        layers[place].items.push(item);
        met.for_each(|cell| layers[place].cells[cell].push(item));
    }
    Some(layers.into_iter().map(|layer| layer.items).collect())
}

impl Answer {
    /// The visible share of an item that covers so many pixels, in units of 1/65536, rounded to the nearest; none where
    /// it covers no pixel. A bound of its pixels that exceeds what it covers counts as all of it.
    pub fn share(&self, item: usize, covered: u32) -> Option<u32> {
        let all = u64::from(covered);
        (all > 0).then(|| (((u64::from(self.totals[item]).min(all) << 16) + all / 2) / all) as u32)
    }
}

#[cfg(test)]
mod tests {
    use glam::UVec4;

    use super::*;

    fn found(rectangles: &[[u32; 4]], most: usize) -> Option<Vec<Vec<usize>>> {
        let bounds = |r: &[u32; 4]| Bounds { rectangle: UVec4::from(*r), ..Bounds::EMPTY };
        let bounds: Vec<Bounds> = rectangles.iter().map(bounds).collect();
        let items: Vec<usize> = (0..bounds.len()).collect();
        layers(Picture { width: 300, height: 200 }, &bounds, &items, most)
    }

    #[test]
    fn layers_hold_what_is_apart() {
        let near = [[0, 0, 9, 9], [8, 8, 12, 12], [9, 0, 12, 8], [0; 4], [0, 0, 1, 1]];
        assert_eq!(found(&near, 2).unwrap(), [vec![0, 2], vec![1, 4]]);
        // Over the borders of cells, and in the last of them.
        let wide = [[0, 0, 300, 1], [127, 1, 129, 200], [128, 127, 300, 129], [299, 199, 300, 200], [129, 1, 299, 127]];
        assert_eq!(found(&wide, 2).unwrap(), [vec![0, 1, 3, 4], vec![2]]);
    }

    #[test]
    fn layers_end_at_the_most() {
        assert_eq!(found(&[[3, 3, 5, 5]; 7], 7).unwrap().len(), 7);
        assert_eq!(found(&[[3, 3, 5, 5]; 8], 7), None);
    }
}

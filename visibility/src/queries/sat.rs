//! Counting by summed-area tables: bounds, region sets, a table a channel, four look-ups a region (section 3.1 of the
//! paper).
//!
//! Bounding rectangles and outlines come from the host, which the method needs for them; the conflict graph, its
//! colouring and the division run on the device. Channels are painted and summed together, as many as a binding holds.

use glam::{IVec2, UVec4};
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job};
use sightlines_kernels::raster::Picture;
use sightlines_kernels::region_sets::{MAX_CHANNELS, MAX_MET, MAX_OBJECTS, MAX_REGIONS, NONE, Regions, Shape};
use sightlines_kernels::sat::{Extent, MAX_WORDS};

use super::answer::Run;
use super::bounds::{self, Bounds};
use super::{Counts, Drawn, Queries, Stage, hib};
use crate::error::{Place, Result};

pub(super) fn record(
    queries: &Queries,
    job: &mut Job,
    stage: &Stage,
    drawn: &Drawn,
    (channels, limit): (u32, Option<u32>),
    weights: Option<Buffer<[u32]>>,
    depth: u32,
) -> Result<Counts> {
    let shape = shape(stage, drawn.picture, channels, limit)?;
    hib::bins(drawn.items, depth)?;
    let regions = regions(queries, job, shape, &bounds::of(stage))?;
    let items = hib::labels(queries, job, drawn, 0)?;
    let words = u64::from(drawn.items.max(1));
    let totals = job.zeroed("totals", words);
    let mut sums =
        vec![Sum { asked: asked(job, UVec4::new(0, 0, shape.width, shape.height), drawn.items), sums: totals }];
    for tile in tiles(shape, depth).filter(|_| depth > 0) {
        sums.push(Sum { asked: asked(job, tile, drawn.items), sums: job.zeroed("tile counts", words) });
    }
    sum_channels(queries, job, &regions, (items, weights), shape, &sums)?;
    let tiles = if depth == 0 { totals } else { gather(job, &sums[1..], drawn.items) };
    Ok(Counts { items: drawn.items, depth, totals, tiles, item_step: 1, tile_step: drawn.items })
}

pub(super) fn record_rectangles(
    queries: &Queries,
    job: &mut Job,
    drawn: &Drawn,
    item: u32,
    rectangles: &[UVec4],
) -> Result<Buffer<[u32]>> {
    let Picture { width, height } = drawn.picture;
    check_width(width)?;
    let shape = Shape { objects: 1, channels: 1, limit: 1, met: 1, width, height };
    let regions = regions(queries, job, shape, &[Bounds::whole(drawn.picture)])?;
    // The item becomes number 0, and every other number at least 1.
    let bases: Vec<u32> = drawn.firsts.iter().map(|first| first.wrapping_sub(item)).collect();
    let items = hib::labels_from(queries, job, drawn, 0, &bases)?;
    let extent = Extent { width, height };
    let [image, table] = ["channel", "table"].map(|name| job.zeroed(name, extent.pixels()));
    queries.region_sets.record_paint(job, &regions, 0..1, items, image)?;
    queries.sat.record(job, (extent, 1), image, table)?;
    let count = rectangles.len() as u32;
    let asked = job.slice("query rectangles", if rectangles.is_empty() { &[UVec4::ZERO] } else { rectangles });
    let sums = job.zeroed("sums", u64::from(count.max(1)));
    queries.sat.record_rectangles(job, (extent, 1), table, (count, asked), sums)?;
    Ok(sums)
}

/// Number of instances of a stage that find no channel of their own, and are divided.
///
/// # Errors
///
/// Those of counting by tables.
pub fn conflicts(backend: &dyn Backend, stage: &Stage, channels: u32) -> Result<usize> {
    let queries = Queries::new()?;
    let shape = shape(stage, stage.frame.view.picture, channels, None)?;
    let mut job = Job::new();
    let channel_of = regions(&queries, &mut job, shape, &bounds::of(stage))?.channel_of;
    let mut run = Run::open(backend, &job)?;
    run.submit(&job, 0..job.recordings.len(), &mut |_| ())?;
    Ok(run.read(channel_of)?.iter().take(stage.items.len()).filter(|channel| **channel == NONE).count())
}

/// A rectangle of the picture, once an item, and where the pixels of each item in it go.
struct Sum {
    asked: Buffer<[UVec4]>,
    sums: Buffer<[u32]>,
}

/// The same query rectangle for every item.
fn asked(job: &mut Job, tile: UVec4, items: u32) -> Buffer<[UVec4]> {
    job.slice("query rectangles", &vec![tile; items.max(1) as usize])
}

/// Paints ones, or weights, sums and counts all channels, as many at once as fit a binding.
fn sum_channels(
    queries: &Queries,
    job: &mut Job,
    regions: &Regions,
    (items, weights): (Buffer<[u32]>, Option<Buffer<[u32]>>),
    shape: Shape,
    sums: &[Sum],
) -> Result<()> {
    let extent = Extent { width: shape.width, height: shape.height };
    let most = (MAX_WORDS / extent.pixels().max(1)).min(u64::from(shape.channels)).max(1);
    let [images, tables] = ["channels", "tables"].map(|name| job.zeroed(name, most * extent.pixels()));
    for first in (0..shape.channels).step_by(most as usize) {
        let channels = first..shape.channels.min(first + most as u32);
        match weights {
            None => queries.region_sets.record_paint(job, regions, channels.clone(), items, images)?,
            Some(weights) => {
                queries.region_sets.record_paint_weights(job, regions, channels.clone(), [items, weights], images)?;
            }
        }
        queries.sat.record(job, (extent, channels.len() as u32), images, tables)?;
        for Sum { asked, sums } in sums {
            queries.region_sets.record_count(job, regions, channels.clone(), [tables, *sums], *asked)?;
        }
    }
    Ok(())
}

/// The counts of all tiles in one buffer, tile after tile.
fn gather(job: &mut Job, tiles: &[Sum], items: u32) -> Buffer<[u32]> {
    let all: Buffer<[u32]> = job.zeroed("counts of tiles", (tiles.len() as u64 * u64::from(items)).max(1));
    for (number, Sum { sums, .. }) in tiles.iter().enumerate().filter(|_| items > 0) {
        job.record(sightlines_backend::Command::Copy {
            from: sums.id(),
            from_offset: 0,
            to: all.id(),
            to_offset: 4 * number as u64 * u64::from(items),
            size: 4 * u64::from(items),
        });
    }
    all
}

/// Makes the regions of instances from their bounds.
pub(super) fn regions(queries: &Queries, job: &mut Job, shape: Shape, bounds: &[Bounds]) -> Result<Regions> {
    let bounds = if bounds.is_empty() { &[Bounds::EMPTY] } else { bounds };
    let rectangles: Vec<UVec4> = bounds.iter().map(|b| b.rectangle).collect();
    let outlines: Vec<IVec2> = bounds.iter().flat_map(|b| b.outline).collect();
    let (rectangles, outlines) = (job.slice("rectangles", &rectangles), job.slice("outlines", &outlines));
    Ok(queries.region_sets.record(job, shape, rectangles, outlines)?)
}

/// Tile (x, y) of a picture holds the pixels whose labels have it: floor(2^depth column / width) = x, and so for rows.
fn tiles(shape: Shape, depth: u32) -> impl Iterator<Item = UVec4> {
    let edge = move |tile: u32, side: u32| (tile * side).div_ceil(1 << depth);
    let Shape { width, height, .. } = shape;
    (0..1 << depth).flat_map(move |y| {
        (0..1 << depth)
            .map(move |x| UVec4::new(edge(x, width), edge(y, height), edge(x + 1, width), edge(y + 1, height)))
    })
}

/// The shape of the regions, and why there is none.
fn shape(stage: &Stage, picture: Picture, channels: u32, limit: Option<u32>) -> Result<Shape> {
    let objects = stage.items.len() as u32;
    let place = || Place::default().element("method sat");
    if stage.instances() != stage.items.len() {
        let what = "tables count instances, and the items are clusters";
        return Err(place().error(what, "count clusters with `hib`"));
    }
    if objects > MAX_OBJECTS {
        let what = format!("{objects} instances, at most {MAX_OBJECTS} have regions");
        return Err(place().error(what, "count with `hib`, or query a part of the scene"));
    }
    if !(1..=MAX_CHANNELS).contains(&channels) {
        return Err(place().error(format!("{channels} channels"), format!("choose 1 to {MAX_CHANNELS}")));
    }
    if limit == Some(0) {
        return Err(place().error("0 regions", format!("choose 1 to {MAX_REGIONS}")));
    }
    let Picture { width, height } = picture;
    check_width(width)?;
    let limit = limit.unwrap_or(MAX_REGIONS).clamp(1, MAX_REGIONS);
    Ok(Shape { objects, channels, limit, met: MAX_MET, width, height })
}

fn check_width(width: u32) -> Result<()> {
    if width.is_multiple_of(4) {
        return Ok(());
    }
    let what = format!("a picture {width} pixels wide, and tables sum four columns at once");
    Err(Place::default().element("method sat").error(what, "choose a width that is a multiple of 4"))
}

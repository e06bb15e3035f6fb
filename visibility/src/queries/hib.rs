//! Counting by the hierarchical item buffer: labels, histogram, mip levels (section 3.2 of the paper).

use sightlines_backend::Job;
use sightlines_backend::host::Buffer;
use sightlines_kernels::item_histogram::{INSTANCE_BITS, MAX_ITEMS, Order, Tiling};
use sightlines_kernels::raster::Picture;

use super::{Counts, Drawn, Queries};
use crate::error::{Place, Result};

/// Greatest logarithm of the tiles a side.
const MAX_DEPTH: u32 = 8;

pub(super) fn record(queries: &Queries, job: &mut Job, drawn: &Drawn, order: Order, depth: u32) -> Result<Counts> {
    let bins = bins(drawn.items, depth)?;
    let labels = labels(queries, job, drawn, depth)?;
    let tiles = job.zeroed("tile counts", u64::from(bins.max(1)));
    let pixels = drawn.picture.pixels();
    queries.histogram.record_counts(job, order, (pixels, labels), (bins, tiles))?;
    counts(queries, job, drawn.items, depth, tiles)
}

pub(super) fn record_weighted(
    queries: &Queries,
    job: &mut Job,
    drawn: &Drawn,
    order: Order,
    weights: Buffer<[u32]>,
    depth: u32,
) -> Result<Counts> {
    let bins = bins(drawn.items, depth)?;
    let labels = labels(queries, job, drawn, depth)?;
    let tiles = job.zeroed("tile weights", u64::from(bins.max(1)));
    let pixels = drawn.picture.pixels();
    queries.histogram.record_weights(job, order, (pixels, [labels, weights]), (bins, tiles))?;
    counts(queries, job, drawn.items, depth, tiles)
}

/// The mip levels of a histogram of items and tiles, and its last, one word an item.
pub(super) fn counts(queries: &Queries, job: &mut Job, items: u32, depth: u32, tiles: Buffer<[u32]>) -> Result<Counts> {
    let levels = if items == 0 { Vec::new() } else { queries.histogram.record_mips(job, depth, items, tiles)? };
    let totals = levels.last().copied().unwrap_or(tiles);
    Ok(Counts { items, depth, totals, tiles, item_step: 1 << (2 * depth), tile_step: 1 })
}

/// Bins of so many items in 2^depth by 2^depth tiles, if the device has room.
pub(super) fn bins(items: u32, depth: u32) -> Result<u32> {
    let bins = u64::from(items) << (2 * depth.min(MAX_DEPTH));
    if depth <= MAX_DEPTH && bins <= u64::from(MAX_ITEMS) {
        return Ok(bins as u32);
    }
    let what = format!("{items} items in 2^{depth} by 2^{depth} tiles need {bins} bins of a histogram");
    let remedy = format!(
        "a device binds at most {MAX_ITEMS} bins: choose fewer tiles (at most 2^{MAX_DEPTH} a side), larger clusters, or \
         query a part of the scene"
    );
    Err(Place::default().element("tiles").error(what, remedy))
}

/// The bin of every pixel; at depth 0 the number of its item.
pub(super) fn labels(queries: &Queries, job: &mut Job, drawn: &Drawn, depth: u32) -> Result<Buffer<[u32]>> {
    let bases: Vec<u32> = drawn.firsts.iter().map(|first| first << (2 * depth)).collect();
    labels_from(queries, job, drawn, depth, &bases)
}

/// The bin of every pixel at a depth, from the first bin of every batch.
pub(super) fn labels_from(
    queries: &Queries,
    job: &mut Job,
    drawn: &Drawn,
    depth: u32,
    bases: &[u32],
) -> Result<Buffer<[u32]>> {
    let labels = job.zeroed("bins of pixels", u64::from(drawn.picture.pixels()));
    record_labels(queries, job, drawn, depth, bases, labels)?;
    Ok(labels)
}

/// The same in a buffer that is there.
pub(super) fn record_labels(
    queries: &Queries,
    job: &mut Job,
    drawn: &Drawn,
    depth: u32,
    bases: &[u32],
    labels: Buffer<[u32]>,
) -> Result<()> {
    let Picture { width, height } = drawn.picture;
    let base = job.slice("first bins", if bases.is_empty() { &[0] } else { bases });
    queries.histogram.record_labels(
        job,
        Tiling { width, height, depth },
        (drawn.words, INSTANCE_BITS),
        base,
        labels,
    )?;
    Ok(())
}

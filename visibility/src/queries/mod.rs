//! Granular visibility queries: how many pixels of what are seen, where.
//!
//! Engelhardt and Dachsbacher, *Granular Visibility Queries on the GPU*. A [`Stage`] is drawn once; one of two methods
//! counts its items, over the whole picture and in 2^t by 2^t tiles of it. [`Counts`] are buffers of the job that drew,
//! so what is recorded after them reads them on the device; [`query`] reads them back.
//!
//! | method | exact | items | cost |
//! |---|---|---|---|
//! | [`Method::Hib`] | yes | instances and clusters, 2^25 bins | a label and an atomic addition a pixel |
//! | [`Method::Sat`] | never fewer than are visible | up to 2,000 instances | a table a channel; 4 look-ups a region |

mod answer;
pub mod baselines;
pub mod bounds;
pub mod detail;
pub mod device;
pub mod displacement;
pub mod files;
mod hib;
pub mod picture;
mod sat;
pub mod shadow_volumes;
pub mod share;
mod stage;
pub mod transparency;

use glam::UVec4;
use sightlines_backend::Job;
use sightlines_backend::host::Buffer;
use sightlines_kernels::item_histogram::{ItemHistogram, Order};
use sightlines_kernels::raster::Raster;
use sightlines_kernels::region_sets::RegionSets;
use sightlines_kernels::sat::Sat;

use crate::error::Result;

pub use answer::{Answer, Cost, Painted, Spent, draw, query};
pub use sat::conflicts;
pub use stage::{Drawn, Granularity, Item, Stage};

/// How pixels are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The hierarchical item buffer: a histogram of the items of all pixels.
    Hib {
        /// In which order pixels meet their bins.
        order: Order,
    },
    /// Summed-area tables of colour channels, read in the regions of each item.
    Sat {
        /// Channels, 1 to 8.
        channels: u32,
        /// Most regions of an item, 1 to 64; none: as many as the number of items allows.
        limit: Option<u32>,
    },
}

impl Method {
    /// The item buffer in the order of memory.
    pub const HIB: Method = Method::Hib { order: Order::Memory };
    /// Four channels, as one colour target has, and as many regions as can be.
    pub const SAT: Method = Method::Sat { channels: 4, limit: None };

    /// Its name on command lines and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Method::Hib { .. } => "hib",
            Method::Sat { .. } => "sat",
        }
    }

    /// Whether counts are the numbers of visible pixels, and not bounds of them.
    pub fn is_exact(self) -> bool {
        matches!(self, Method::Hib { .. })
    }
}

/// The compiled kernels of queries.
pub struct Queries {
    /// The raster that stages are drawn with.
    pub raster: Raster,
    pub(crate) histogram: ItemHistogram,
    sat: Sat,
    region_sets: RegionSets,
}

/// Counts on the device.
#[derive(Clone, Copy, Debug)]
pub struct Counts {
    /// Number of items.
    pub items: u32,
    /// Logarithm of the tiles a side.
    pub depth: u32,
    /// Pixels of every item in the whole picture, a word each.
    pub totals: Buffer<[u32]>,
    /// Pixels of every item in every tile: those of item i in tile (x, y) at
    /// `i * item_step + (x + (y << depth)) * tile_step`.
    pub tiles: Buffer<[u32]>,
    /// Words from an item to the next.
    pub item_step: u32,
    /// Words from a tile to the next.
    pub tile_step: u32,
}

impl Queries {
    /// Compiles the kernels.
    ///
    /// # Errors
    ///
    /// None that a caller can cause.
    pub fn new() -> Result<Self> {
        Ok(Queries {
            raster: Raster::new()?,
            histogram: ItemHistogram::new()?,
            sat: Sat::new()?,
            region_sets: RegionSets::new()?,
        })
    }

    /// Counts the items of a stage that `job` has drawn, in the picture and in its 2^depth by 2^depth tiles.
    ///
    /// # Errors
    ///
    /// More items, tiles or channels than the device's limits allow, with the limit.
    pub fn record(&self, job: &mut Job, stage: &Stage, drawn: &Drawn, method: Method, depth: u32) -> Result<Counts> {
        match method {
            Method::Hib { order } => hib::record(self, job, drawn, order, depth),
            Method::Sat { channels, limit } => sat::record(self, job, stage, drawn, (channels, limit), None, depth),
        }
    }

    /// Counts the pixels of one item in half-open rectangles (x0, y0, x1, y1) of the picture, a word each, by one
    /// table: exact, since a single item shares its channel with none.
    ///
    /// # Errors
    ///
    /// A picture whose width is no multiple of 4.
    pub fn record_rectangles(
        &self,
        job: &mut Job,
        drawn: &Drawn,
        item: u32,
        rectangles: &[UVec4],
    ) -> Result<Buffer<[u32]>> {
        sat::record_rectangles(self, job, drawn, item, rectangles)
    }

    /// Adds the weights of all pixels of each item, modulo 2^32, in the picture and in its 2^depth by 2^depth tiles:
    /// `weights` has a word a pixel, as a picture of how much a blocker lets through or a viewer cares. By the item
    /// buffer the sums are exact, by tables never less where they fit 32 bits.
    ///
    /// # Errors
    ///
    /// Those of [`Queries::record`], and weights that are not one a pixel.
    pub fn record_weighted(
        &self,
        job: &mut Job,
        stage: &Stage,
        drawn: &Drawn,
        weights: Buffer<[u32]>,
        method: Method,
        depth: u32,
    ) -> Result<Counts> {
        match method {
            Method::Hib { order } => hib::record_weighted(self, job, drawn, order, weights, depth),
            Method::Sat { channels, limit } => {
                sat::record(self, job, stage, drawn, (channels, limit), Some(weights), depth)
            }
        }
    }
}

//! Region sets: which rectangles of which colour channels to sum, to count the visible pixels of many objects by
//! tables.
//!
//! Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU", sections 3.1.1 to 3.1.3: a conflict graph of
//! bounding rectangles, its colouring after Chaitin and Briggs, and the division of what finds no colour. The texts of
//! this folder state every step and every choice that the paper leaves open. Invariant: the regions of an object are
//! disjoint and hold all its pixels, so no count is ever less than what is visible.

use std::ops::Range;
use std::sync::Arc;

use bytemuck::Zeroable;
use glam::{IVec2, UVec4};
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "region_sets",
    summary: "rectangles and colour channels that count the visible pixels of many objects by summed-area tables",
    citation: "Engelhardt and Dachsbacher, Granular Visibility Queries on the GPU, 2009, sections 3.1.1 to 3.1.3",
    programs: || Ok(vec![RegionSets::new()?.program]),
    cases: cases::all,
};

/// Most objects.
pub const MAX_OBJECTS: u32 = 2000;

/// Most channels.
pub const MAX_CHANNELS: u32 = 8;

/// Places for regions that an object has, of which `limit` may be used.
pub const MAX_REGIONS: u32 = 64;

/// Most regions of others that an object is divided by: what one workgroup does (docs/numerics.md, Turns of loops).
pub const MAX_MET: u32 = 18_000;

/// Corners of an outline.
pub const CORNERS: u32 = 8;

/// Channel of a conflict object.
pub const NONE: u32 = u32::MAX;

/// Objects that one recording divides at most.
const SPLITS: u32 = 16;

/// Invocations a workgroup.
const GROUP: u32 = 256;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Number of objects.
        pub objects: u32,
        /// Number of channels.
        pub channels: u32,
        /// Most regions of an object.
        pub limit: u32,
        /// Most regions of others that an object is divided by.
        pub met: u32,
        /// Columns of the picture.
        pub width: u32,
        /// Rows of the picture.
        pub height: u32,
        /// The first channel that is painted or counted.
        pub channel: u32,
        /// The one past the last.
        pub end: u32,
        /// Number of the first workgroup, or the object that is divided.
        pub first: u32,
    }
}

bindings! {
    /// What `conflicts` is given.
    pub struct Conflicts {
        uniform params @ 0: Params,
        read rectangles @ 1: [UVec4],
        write conflict_words @ 3: [u32],
    }

    /// What `colour` is given.
    pub struct Colour {
        uniform params @ 0: Params,
        read rectangles @ 1: [UVec4],
        read conflict_bits @ 4: [u32],
        write channel_of @ 5: [u32],
        write region_counts @ 7: [u32],
        write regions @ 8: [UVec4],
        write region_channels @ 9: [u32],
    }

    /// What `split` is given.
    pub struct Split {
        uniform params @ 0: Params,
        read rectangles @ 1: [UVec4],
        read outlines @ 2: [IVec2],
        read conflict_bits @ 4: [u32],
        read given_channel @ 6: [u32],
        write region_counts @ 7: [u32],
        write regions @ 8: [UVec4],
        write region_channels @ 9: [u32],
    }

    /// What `paint` is given.
    pub struct Paint {
        uniform params @ 0: Params,
        read known_counts @ 10: [u32],
        read known_regions @ 11: [UVec4],
        read known_channels @ 12: [u32],
        read items @ 13: [u32],
        write image @ 14: [u32],
    }

    /// What `paint_weights` is given.
    pub struct PaintWeights {
        uniform params @ 0: Params,
        read known_counts @ 10: [u32],
        read known_regions @ 11: [UVec4],
        read known_channels @ 12: [u32],
        read items @ 13: [u32],
        write image @ 14: [u32],
        read weights @ 18: [u32],
    }

    /// What `count` is given.
    pub struct Count {
        uniform params @ 0: Params,
        read known_counts @ 10: [u32],
        read known_regions @ 11: [UVec4],
        read known_channels @ 12: [u32],
        read table @ 15: [u32],
        read queries @ 16: [UVec4],
        write sums @ 17: [u32],
    }
}

/// How regions are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Number of objects, at most [`MAX_OBJECTS`].
    pub objects: u32,
    /// Number of channels, 1 to [`MAX_CHANNELS`].
    pub channels: u32,
    /// Most regions of an object, 1 to [`MAX_REGIONS`]; beyond it visibility is over-estimated.
    pub limit: u32,
    /// Most regions of others that an object is divided by, at most [`MAX_MET`]; where there are more, visibility is
    /// over-estimated.
    pub met: u32,
    /// Columns of the picture, 1 to 4096.
    pub width: u32,
    /// Rows of the picture, 1 to 4096.
    pub height: u32,
}

/// The regions of all objects, on the device.
#[derive(Clone, Copy, Debug)]
pub struct Regions {
    shape: Shape,
    /// Channel of every object, or [`NONE`] of a conflict object.
    pub channel_of: Buffer<[u32]>,
    /// Number of regions of every object.
    pub counts: Buffer<[u32]>,
    /// Half-open rectangles, [`MAX_REGIONS`] places an object.
    pub rectangles: Buffer<[UVec4]>,
    /// Their channels.
    pub channels: Buffer<[u32]>,
}

/// The compiled kernel.
pub struct RegionSets {
    program: Arc<Program>,
}

impl RegionSets {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("region_sets", "", &[])?;
        Conflicts::check(&program, "conflicts")?;
        Colour::check(&program, "colour")?;
        Split::check(&program, "split")?;
        Paint::check(&program, "paint")?;
        PaintWeights::check(&program, "paint_weights")?;
        Count::check(&program, "count")?;
        Ok(RegionSets { program })
    }

    /// Makes the regions of objects, each given by the bounding rectangle of its pixels (x0, y0, x1, y1, half-open,
    /// within the picture) and a convex outline of them with [`CORNERS`] corners, which turn as x to y and may repeat.
    /// An outline that leaves pixels out makes counts wrong; the rectangle itself is a good one where nothing better is
    /// known.
    pub fn record(
        &self,
        job: &mut Job,
        shape: Shape,
        rectangles: Buffer<[UVec4]>,
        outlines: Buffer<[IVec2]>,
    ) -> Result<Regions> {
        shape.check()?;
        let objects = shape.objects;
        let corners = u64::from(CORNERS * objects);
        if rectangles.len() < u64::from(objects) || outlines.len() < corners {
            let what = format!("{objects} objects with {} rectangles and {} corners", rectangles.len(), outlines.len());
            return Err(Error::refused(what, format!("give a rectangle and {CORNERS} corners an object")));
        }
        let places = u64::from(objects.max(1));
        let words = objects * objects.div_ceil(32);
        let conflicts = job.zeroed::<u32>("conflicts", u64::from(words.max(1)));
        let regions = Regions {
            shape,
            channel_of: job.zeroed("channels of objects", places),
            counts: job.zeroed("region counts", places),
            rectangles: job.zeroed("regions", places * u64::from(MAX_REGIONS)),
            channels: job.zeroed("region channels", places * u64::from(MAX_REGIONS)),
        };
        let params = shape.params();
        let program = job.program(&self.program);
        pieces::record(job, words.div_ceil(GROUP), u64::from(32 * 4 * GROUP), |job, piece| {
            let params = job.value("region params", &Params { first: piece.start, ..params });
            let bound = Conflicts { params, rectangles, conflict_words: conflicts };
            job.launch(program, "conflicts", &bound, [piece.len() as u32, 1, 1]);
        });
        pieces::cut(job);
        let Regions { channel_of, counts, rectangles: found, channels: region_channels, .. } = regions;
        let all = job.value("region params", &params);
        let bound = Colour {
            params: all,
            rectangles,
            conflict_bits: conflicts,
            channel_of,
            region_counts: counts,
            regions: found,
            region_channels,
        };
        job.launch(program, "colour", &bound, [1, 1, 1]);
        // No objects are launched too, and shown to write nothing.
        for object in 0..objects.max(1) {
            if object % SPLITS == 0 {
                pieces::cut(job);
            }
            let params = job.value("region params", &Params { first: object, ..params });
            let bound = Split {
                params,
                rectangles,
                outlines,
                conflict_bits: conflicts,
                given_channel: channel_of,
                region_counts: counts,
                regions: found,
                region_channels,
            };
            job.launch(program, "split", &bound, [1, 1, 1]);
        }
        Ok(regions)
    }

    /// Paints a range of channels into `image`, one after another: 1 in every pixel whose item, an object's number, has
    /// its region there in the channel; 0 in the others. A word a pixel, and a word a pixel and channel.
    pub fn record_paint(
        &self,
        job: &mut Job,
        regions: &Regions,
        channels: Range<u32>,
        items: Buffer<[u32]>,
        image: Buffer<[u32]>,
    ) -> Result<()> {
        let Regions { shape, counts: known_counts, rectangles: known_regions, channels: known_channels, .. } = *regions;
        shape.check_planes(&channels, items.len(), image.len())?;
        self.painted(job, shape, channels, "paint", |params| Paint {
            params,
            known_counts,
            known_regions,
            known_channels,
            items,
            image,
        });
        Ok(())
    }

    /// Paints the weights of pixels instead of ones: what is counted is then their sum, modulo 2³².
    pub fn record_paint_weights(
        &self,
        job: &mut Job,
        regions: &Regions,
        channels: Range<u32>,
        [items, weights]: [Buffer<[u32]>; 2],
        image: Buffer<[u32]>,
    ) -> Result<()> {
        let Regions { shape, counts: known_counts, rectangles: known_regions, channels: known_channels, .. } = *regions;
        shape.check_planes(&channels, items.len().min(weights.len()), image.len())?;
        self.painted(job, shape, channels, "paint_weights", |params| PaintWeights {
            params,
            known_counts,
            known_regions,
            known_channels,
            items,
            image,
            weights,
        });
        Ok(())
    }

    fn painted<B: Bindings>(
        &self,
        job: &mut Job,
        shape: Shape,
        channels: Range<u32>,
        entry: &str,
        bound: impl Fn(Buffer<Params>) -> B,
    ) {
        let program = job.program(&self.program);
        let words = u64::from(32 + channels.end - channels.start) * u64::from(GROUP);
        pieces::record(job, (shape.width * shape.height).div_ceil(GROUP), words, |job, piece| {
            let params = Params { first: piece.start, ..shape.params_of(&channels) };
            let bound = bound(job.value("region params", &params));
            job.launch(program, entry, &bound, [piece.len() as u32, 1, 1]);
        });
    }

    /// Adds to `sums`, a word an object, the pixels that the tables of a range of channels, one after another, have in
    /// the object's regions, cut to its rectangle of `queries`. Over all channels this is the object's visible count
    /// there, or more.
    pub fn record_count(
        &self,
        job: &mut Job,
        regions: &Regions,
        channels: Range<u32>,
        [tables, sums]: [Buffer<[u32]>; 2],
        queries: Buffer<[UVec4]>,
    ) -> Result<()> {
        let Regions { shape, counts: known_counts, rectangles: known_regions, channels: known_channels, .. } = *regions;
        let objects = shape.objects;
        shape.check_planes(&channels, u64::MAX, tables.len())?;
        if sums.len().min(queries.len()) < u64::from(objects) {
            let what = format!("{objects} objects with {} sums and {} queries", sums.len(), queries.len());
            return Err(Error::refused(what, "give a sum and a query an object"));
        }
        let program = job.program(&self.program);
        pieces::record(job, objects.div_ceil(GROUP), u64::from(32 * GROUP), |job, piece| {
            let params = Params { first: piece.start, ..shape.params_of(&channels) };
            let params = job.value("region params", &params);
            let bound = Count { params, known_counts, known_regions, known_channels, table: tables, queries, sums };
            job.launch(program, "count", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

impl Shape {
    fn check(&self) -> Result<()> {
        let Shape { objects, channels, limit, met, width, height } = *self;
        let ranges = [
            ("objects", objects, 0..=MAX_OBJECTS),
            ("channels", channels, 1..=MAX_CHANNELS),
            ("regions", limit, 1..=MAX_REGIONS),
            ("regions of others", met, 0..=MAX_MET),
            ("columns", width, 1..=4096),
            ("rows", height, 1..=4096),
        ];
        let out = ranges.into_iter().find(|(_, value, range)| !range.contains(value));
        if let Some((name, value, range)) = out {
            let remedy = format!("use {} to {} {name}", range.start(), range.end());
            return Err(Error::refused(format!("region sets with {value} {name}"), remedy));
        }
        Ok(())
    }

    /// Whether a range of channels exists and fits an item buffer and planes of so many words.
    fn check_planes(&self, channels: &Range<u32>, items: u64, planes: u64) -> Result<()> {
        let (pixels, count) = (u64::from(self.width * self.height), channels.end.saturating_sub(channels.start));
        if count == 0 || channels.end > self.channels {
            let what = format!("channels {} to {} of {}", channels.start, channels.end, self.channels);
            return Err(Error::refused(what, "give a range of the channels that the regions have"));
        }
        if items < pixels || planes < pixels * u64::from(count) {
            let items = if items == u64::MAX { String::new() } else { format!("{items} items and ") };
            let what = format!("{items}{planes} words for {pixels} pixels of {count} channels");
            return Err(Error::refused(what, "give one word a pixel, and one a pixel and channel"));
        }
        Ok(())
    }

    fn params(&self) -> Params {
        let Shape { objects, channels, limit, met, width, height } = *self;
        Params { objects, channels, limit, met, width, height, ..Params::zeroed() }
    }

    fn params_of(&self, channels: &Range<u32>) -> Params {
        Params { channel: channels.start, end: channels.end, ..self.params() }
    }
}

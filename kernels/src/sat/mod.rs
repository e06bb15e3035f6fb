//! Summed-area tables of one to eight channels, modulo 2³² or in 64 bits, and sums over rectangles from them.
//!
//! Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU", section 3.1, count the pixels of objects drawn
//! in pure colours with Crow's tables: four look-ups a rectangle and channel. Channels stand one after another, each by
//! rows; `kernel.wgsl` states output and range exactly. Invariant: sums wrap, so a rectangle whose own sum is below 2³²
//! is answered exactly even where the table has wrapped; only larger sums need the wide tables.

use std::sync::Arc;

use glam::{UVec2, UVec4};
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "sat",
    summary: "summed-area tables of 1 to 8 channels up to 4096 columns wide, and sums over rectangles from them",
    citation: "Engelhardt and Dachsbacher, Granular Visibility Queries on the GPU, 2009, section 3.1; Crow 1984",
    programs: || Ok(vec![Sat::new()?.program]),
    cases: cases::all,
};

/// Widest image.
pub const MAX_WIDTH: u32 = 4096;

/// Tallest image: a binding of 128 MiB holds 8192 rows of the widest, narrower ones stop here.
pub const MAX_HEIGHT: u32 = 1 << 16;

/// Most channels of one call.
pub const MAX_CHANNELS: u32 = 8;

/// Most pixels of all channels of one call: they fill a binding of 128 MiB.
pub const MAX_WORDS: u64 = 1 << 25;

/// Rows that one workgroup sums.
const BAND: u32 = 16;

/// Rectangles a workgroup.
const GROUP: u32 = 256;

/// Size of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Columns: a multiple of 4, from 4 to [`MAX_WIDTH`]. Columns of zeros on the right change no sum.
    pub width: u32,
    /// Rows, at most [`MAX_HEIGHT`].
    pub height: u32,
}

impl Extent {
    /// Number of pixels.
    pub fn pixels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }

    /// Largest pixel value for which no table of this size can wrap.
    pub fn largest_exact(&self) -> u32 {
        (u64::from(u32::MAX) / self.pixels().max(1)) as u32
    }

    fn check(&self, channels: u32, buffers: &[(&str, u64)]) -> Result<()> {
        let Extent { width, height } = *self;
        if width % 4 != 0 || !(4..=MAX_WIDTH).contains(&width) || height > MAX_HEIGHT {
            let remedy =
                format!("pad the width to a multiple of 4, at most {MAX_WIDTH}; use at most {MAX_HEIGHT} rows");
            return Err(Error::refused(format!("a summed-area table of {width} by {height}"), remedy));
        }
        let words = self.pixels() * u64::from(channels);
        if !(1..=MAX_CHANNELS).contains(&channels) || words > MAX_WORDS {
            let what = format!("summed-area tables of {channels} channels of {width} by {height}");
            let remedy = format!("sum 1 to {MAX_CHANNELS} channels of together {MAX_WORDS} pixels at a time");
            return Err(Error::refused(what, remedy));
        }
        let short = buffers.iter().find(|(_, given)| *given < words.max(4) || *given % 4 != 0);
        short.map_or(Ok(()), |(name, given)| {
            let what = format!("a summed-area table of {width} by {height} with {given} words of {name}");
            Err(Error::refused(what, "one word a pixel and channel, at least 4 and a multiple of 4"))
        })
    }

    /// Words that carry sums from band to band.
    fn carries(&self, channels: u32) -> u64 {
        let bands = self.height.div_ceil(BAND).max(2) - 1;
        u64::from(bands) * u64::from(self.width) * u64::from(channels)
    }

    fn params(&self, rectangles: u32) -> Params {
        Params { fours: self.width / 4, height: self.height, rectangles, first: 0 }
    }
}

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Columns in fours.
        pub fours: u32,
        /// Rows.
        pub height: u32,
        /// Rectangles to answer.
        pub rectangles: u32,
        /// Band, or rectangle, of the first workgroup or invocation.
        pub first: u32,
    }
}

bindings! {
    /// What `bands` is given.
    pub struct Bands {
        uniform params @ 0: Params,
        read image @ 1: [UVec4],
        write table @ 2: [UVec4],
    }

    /// What `carries` and `add` are given.
    pub struct Carry {
        uniform params @ 0: Params,
        write words @ 3: [u32],
        write carry @ 4: [u32],
    }

    /// What `rectangle_sums` is given.
    pub struct Rectangles {
        uniform params @ 0: Params,
        read whole @ 5: [u32],
        read rectangles @ 6: [UVec4],
        write sums @ 7: [u32],
    }

    /// What `bands_wide` is given.
    pub struct BandsWide {
        uniform params @ 0: Params,
        read image @ 1: [UVec4],
        write table @ 2: [UVec4],
        write high_table @ 8: [UVec4],
    }

    /// What `carries_wide` and `add_bands_wide` are given.
    pub struct CarryWide {
        uniform params @ 0: Params,
        write words @ 3: [u32],
        write carry @ 4: [u32],
        write high_words @ 9: [u32],
        write high_carry @ 10: [u32],
    }

    /// What `rectangle_sums_wide` is given.
    pub struct RectanglesWide {
        uniform params @ 0: Params,
        read whole @ 5: [u32],
        read rectangles @ 6: [UVec4],
        read high_whole @ 11: [u32],
        write wide_sums @ 12: [UVec2],
    }
}

/// The compiled kernel.
pub struct Sat {
    program: Arc<Program>,
}

impl Sat {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("sat", "", &[])?;
        Bands::check(&program, "bands")?;
        Carry::check(&program, "carries")?;
        Carry::check(&program, "add")?;
        Rectangles::check(&program, "rectangle_sums")?;
        BandsWide::check(&program, "bands_wide")?;
        CarryWide::check(&program, "carries_wide")?;
        CarryWide::check(&program, "add_bands_wide")?;
        RectanglesWide::check(&program, "rectangle_sums_wide")?;
        Ok(Sat { program })
    }

    /// Sums `channels` channels of `images` into `tables`, modulo 2³²; both by rows, one channel after another.
    pub fn record(
        &self,
        job: &mut Job,
        (extent, channels): (Extent, u32),
        images: Buffer<[u32]>,
        tables: Buffer<[u32]>,
    ) -> Result<()> {
        extent.check(channels, &[("image", images.len()), ("table", tables.len())])?;
        let carry = job.zeroed("sat carry", extent.carries(channels));
        let bands = |params| Bands { params, image: by_fours(images), table: by_fours(tables) };
        let carries = |params| Carry { params, words: tables, carry };
        self.steps(job, (extent, channels), ["bands", "carries", "add"], bands, carries);
        Ok(())
    }

    /// Sums `channels` channels of `images` whole, in 64 bits: the low words into the first of `tables`, the high ones
    /// into the second.
    pub fn record_wide(
        &self,
        job: &mut Job,
        (extent, channels): (Extent, u32),
        images: Buffer<[u32]>,
        [low, high]: [Buffer<[u32]>; 2],
    ) -> Result<()> {
        let buffers = [("image", images.len()), ("low table", low.len()), ("high table", high.len())];
        extent.check(channels, &buffers)?;
        let [carry, high_carry] = ["sat carry", "sat high carry"].map(|n| job.zeroed(n, extent.carries(channels)));
        let (image, table, high_table) = (by_fours(images), by_fours(low), by_fours(high));
        let bands = |params| BandsWide { params, image, table, high_table };
        let carries = |params| CarryWide { params, words: low, carry, high_words: high, high_carry };
        self.steps(job, (extent, channels), ["bands_wide", "carries_wide", "add_bands_wide"], bands, carries);
        Ok(())
    }

    fn steps<A: Bindings, B: Bindings>(
        &self,
        job: &mut Job,
        (extent, channels): (Extent, u32),
        [band, carry, add]: [&str; 3],
        bands_bound: impl Fn(Buffer<Params>) -> A,
        carry_bound: impl Fn(Buffer<Params>) -> B,
    ) {
        let Extent { width, height } = extent;
        let bands = height.div_ceil(BAND).max(1);
        let program = job.program(&self.program);
        let words = u64::from(3 * BAND * width * channels);
        let params = |job: &mut Job, first| job.value("sat params", &Params { first, ..extent.params(0) });
        pieces::record(job, bands, words, |job, piece| {
            let bound = bands_bound(params(job, piece.start));
            job.launch(program, band, &bound, [piece.len() as u32, channels, 1]);
        });
        if bands > 1 {
            let bound = carry_bound(params(job, 0));
            job.launch(program, carry, &bound, [width.div_ceil(64), channels, 1]);
            pieces::record(job, bands - 1, words, |job, piece| {
                let bound = carry_bound(params(job, piece.start));
                job.launch(program, add, &bound, [width.div_ceil(256), piece.len() as u32, channels]);
            });
        }
    }

    /// Sums over the first `count` half-open rectangles (x0, y0, x1, y1) of `tables`: `count` words of `sums` for every
    /// channel.
    pub fn record_rectangles(
        &self,
        job: &mut Job,
        (extent, channels): (Extent, u32),
        tables: Buffer<[u32]>,
        (count, rectangles): (u32, Buffer<[UVec4]>),
        sums: Buffer<[u32]>,
    ) -> Result<()> {
        extent.check(channels, &[("table", tables.len())])?;
        check_rectangles(count, channels, rectangles.len(), sums.len())?;
        let bound = |params| Rectangles { params, whole: tables, rectangles, sums };
        self.answers(job, extent, [count, channels], "rectangle_sums", bound);
        Ok(())
    }

    /// The same in 64 bits, low word first, from the two tables that [`Sat::record_wide`] makes.
    pub fn record_rectangles_wide(
        &self,
        job: &mut Job,
        (extent, channels): (Extent, u32),
        [whole, high_whole]: [Buffer<[u32]>; 2],
        (count, rectangles): (u32, Buffer<[UVec4]>),
        wide_sums: Buffer<[UVec2]>,
    ) -> Result<()> {
        extent.check(channels, &[("low table", whole.len()), ("high table", high_whole.len())])?;
        check_rectangles(count, channels, rectangles.len(), wide_sums.len())?;
        let bound = |params| RectanglesWide { params, whole, rectangles, high_whole, wide_sums };
        self.answers(job, extent, [count, channels], "rectangle_sums_wide", bound);
        Ok(())
    }

    fn answers<B: Bindings>(
        &self,
        job: &mut Job,
        extent: Extent,
        [count, channels]: [u32; 2],
        entry: &str,
        bound: impl Fn(Buffer<Params>) -> B,
    ) {
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(14 * GROUP * channels), |job, piece| {
            let params = Params { first: piece.start * GROUP, ..extent.params(count) };
            let bound = bound(job.value("sat params", &params));
            job.launch(program, entry, &bound, [piece.len() as u32, channels, 1]);
        });
    }
}

fn check_rectangles(count: u32, channels: u32, rectangles: u64, sums: u64) -> Result<()> {
    if rectangles < u64::from(count) || sums < u64::from(count) * u64::from(channels) {
        let what = format!("{count} rectangles from {rectangles} into {sums} sums of {channels} channels");
        return Err(Error::refused(what, "give a sum for each rectangle and channel"));
    }
    Ok(())
}

/// The same words, four at a time.
fn by_fours(words: Buffer<[u32]>) -> Buffer<[UVec4]> {
    let slot = words.slot(0, 0);
    Buffer::from_raw(slot.buffer, slot.offset, slot.size)
}

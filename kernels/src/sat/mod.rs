//! Summed-area tables, modulo 2³², and sums over rectangles from them.
//!
//! Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU", section 3.1, count the pixels of objects drawn
//! in pure colours with Crow's tables: four look-ups a rectangle. One channel is one table, so that each stays within
//! a binding; `kernel.wgsl` states output and range exactly. Invariant: sums wrap, so a rectangle whose own sum is below
//! 2³² is answered exactly even where the table has wrapped.

use std::sync::Arc;

use glam::UVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "sat",
    summary: "summed-area tables of images up to 4096 columns wide, and sums over rectangles from them",
    citation: "Engelhardt and Dachsbacher, Granular Visibility Queries on the GPU, 2009, section 3.1; Crow 1984",
    programs: || Ok(vec![Sat::new()?.program]),
    cases: cases::all,
};

/// Widest image.
pub const MAX_WIDTH: u32 = 4096;

/// Tallest image: a binding of 128 MiB holds 8192 rows of the widest, narrower ones stop here.
pub const MAX_HEIGHT: u32 = 1 << 16;

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

    fn check(&self, buffers: &[(&str, u64)]) -> Result<()> {
        let Extent { width, height } = *self;
        if width % 4 != 0 || !(4..=MAX_WIDTH).contains(&width) || height > MAX_HEIGHT {
            let remedy =
                format!("pad the width to a multiple of 4, at most {MAX_WIDTH}; use at most {MAX_HEIGHT} rows");
            return Err(Error::refused(format!("a summed-area table of {width} by {height}"), remedy));
        }
        let short = buffers.iter().find(|(_, words)| *words < self.pixels().max(4) || *words % 4 != 0);
        short.map_or(Ok(()), |(name, words)| {
            let what = format!("a summed-area table of {width} by {height} with {words} words of {name}");
            Err(Error::refused(what, "one word a pixel, at least 4 and a multiple of 4"))
        })
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
        Ok(Sat { program })
    }

    /// Sums one channel, `image`, into `table`, both by rows. Further channels are further calls.
    pub fn record(&self, job: &mut Job, extent: Extent, image: Buffer<[u32]>, table: Buffer<[u32]>) -> Result<()> {
        extent.check(&[("image", image.len()), ("table", table.len())])?;
        let Extent { width, height } = extent;
        let bands = height.div_ceil(BAND).max(1);
        let program = job.program(&self.program);
        let params = |first| Params { fours: width / 4, height, rectangles: 0, first };
        pieces::record(job, bands, u64::from(2 * BAND * width), |job, piece| {
            let params = job.value("sat params", &params(piece.start));
            let bound = Bands { params, image: by_fours(image), table: by_fours(table) };
            job.launch(program, "bands", &bound, [piece.len() as u32, 1, 1]);
        });
        if bands > 1 {
            let carry = job.zeroed("sat carry", u64::from(bands - 1) * u64::from(width));
            let params_of_all = job.value("sat params", &params(0));
            let bound = Carry { params: params_of_all, words: table, carry };
            job.launch(program, "carries", &bound, [width.div_ceil(64), 1, 1]);
            pieces::record(job, bands - 1, u64::from(2 * BAND * width), |job, piece| {
                let bound = Carry { params: job.value("sat params", &params(piece.start)), ..bound };
                job.launch(program, "add", &bound, [width.div_ceil(256), piece.len() as u32, 1]);
            });
        }
        Ok(())
    }

    /// Sums over the first `count` half-open rectangles (x0, y0, x1, y1) of `table` into one word each.
    pub fn record_rectangles(
        &self,
        job: &mut Job,
        extent: Extent,
        table: Buffer<[u32]>,
        count: u32,
        rectangles: Buffer<[UVec4]>,
        sums: Buffer<[u32]>,
    ) -> Result<()> {
        extent.check(&[("table", table.len())])?;
        if rectangles.len() < u64::from(count) || sums.len() < u64::from(count) {
            let what = format!("{count} rectangles from {} into {} words", rectangles.len(), sums.len());
            return Err(Error::refused(what, "give one word for each rectangle"));
        }
        let Extent { width, height } = extent;
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(9 * GROUP), |job, piece| {
            let params = Params { fours: width / 4, height, rectangles: count, first: piece.start * GROUP };
            let params = job.value("sat params", &params);
            let bound = Rectangles { params, whole: table, rectangles, sums };
            job.launch(program, "rectangle_sums", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

/// The same words, four at a time.
fn by_fours(words: Buffer<[u32]>) -> Buffer<[UVec4]> {
    let slot = words.slot(0, 0);
    Buffer::from_raw(slot.buffer, slot.offset, slot.size)
}

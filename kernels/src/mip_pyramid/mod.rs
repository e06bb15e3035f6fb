//! Mip pyramids of one to eight channels, as sums, and sums over rectangles from them.
//!
//! Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU", section 3.1.4, count pixels in a quad-tree a
//! channel instead of a summed-area table: a third more words than the image has and no long sums, but a rectangle
//! takes nodes along its sides at every level where the table takes four words. `kernel.wgsl` states the outputs
//! exactly. Invariant: sums are modulo 2³², so the answers are those of [`crate::sat`], bit for bit.

use std::sync::Arc;

use bytemuck::Zeroable;
use glam::UVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "mip_pyramid",
    summary: "mip pyramids of 1 to 8 channels as sums, and sums over rectangles from them",
    citation: "Engelhardt and Dachsbacher, Granular Visibility Queries on the GPU, 2009, section 3.1.4",
    programs: || Ok(vec![MipPyramid::new()?.program]),
    cases: cases::all,
};

/// Most columns and rows.
pub const MAX_SIDE: u32 = 4096;

/// Most channels.
pub const MAX_CHANNELS: u32 = 8;

/// Most pixels of all channels: they fill a binding of 128 MiB.
pub const MAX_WORDS: u64 = 1 << 25;

/// Invocations a workgroup.
const GROUP: u32 = 64;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Columns of the level that is halved, or of the image.
        pub width: u32,
        /// Its rows.
        pub height: u32,
        /// Number of channels.
        pub channels: u32,
        /// Rectangles to answer.
        pub rectangles: u32,
        /// First node of the finer level, if it is not the image.
        pub fine: u32,
        /// First node of the coarser level.
        pub coarse: u32,
        /// Number of the first workgroup.
        pub first: u32,
    }
}

bindings! {
    /// What `halve_image` is given.
    pub struct HalveImage {
        uniform params @ 0: Params,
        read image @ 1: [u32],
        write nodes @ 2: [u32],
    }

    /// What `halve` is given.
    pub struct Halve {
        uniform params @ 0: Params,
        write nodes @ 2: [u32],
    }

    /// What `rectangle_sums` is given.
    pub struct Rectangles {
        uniform params @ 0: Params,
        read image @ 1: [u32],
        read whole @ 3: [u32],
        read rectangles @ 4: [UVec4],
        write sums @ 5: [u32],
    }
}

/// Size of an image of channels that stand one after another, each by rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Columns, 1 to [`MAX_SIDE`].
    pub width: u32,
    /// Rows, 1 to [`MAX_SIDE`].
    pub height: u32,
    /// Channels, 1 to [`MAX_CHANNELS`].
    pub channels: u32,
}

impl Extent {
    /// Columns and rows of the levels above the image, finest first.
    pub fn levels(&self) -> impl Iterator<Item = [u32; 2]> {
        let halves =
            |[width, height]: &[u32; 2]| (*width > 1 || *height > 1).then(|| [width.div_ceil(2), height.div_ceil(2)]);
        std::iter::successors(Some([self.width, self.height]), halves).skip(1)
    }

    /// Words of all levels above the image.
    pub fn nodes(&self) -> u64 {
        self.levels().map(|[width, height]| u64::from(width * height * self.channels)).sum()
    }

    fn check(&self, image: u64) -> Result<()> {
        let Extent { width, height, channels } = *self;
        let sides = 1..=MAX_SIDE;
        let inside = sides.contains(&width) && sides.contains(&height) && (1..=MAX_CHANNELS).contains(&channels);
        let words = u64::from(width) * u64::from(height) * u64::from(channels);
        if !inside || words > MAX_WORDS {
            let what = format!("a mip pyramid of {width} by {height} pixels in {channels} channels");
            let remedy = format!(
                "use 1 to {MAX_SIDE} pixels a side and 1 to {MAX_CHANNELS} channels, of together {MAX_WORDS} pixels"
            );
            return Err(Error::refused(what, remedy));
        }
        if image < words {
            let what = format!("a mip pyramid of {width} by {height} pixels from {image} words");
            return Err(Error::refused(what, format!("give one word a pixel and channel, {words}")));
        }
        Ok(())
    }
}

/// The levels of an image, on the device.
#[derive(Clone, Copy, Debug)]
pub struct Pyramid {
    extent: Extent,
    image: Buffer<[u32]>,
    nodes: Buffer<[u32]>,
}

impl Pyramid {
    /// The levels above the image, one after another, each of all channels; a word where there is none.
    pub fn nodes(&self) -> Buffer<[u32]> {
        self.nodes
    }
}

/// The compiled kernel.
pub struct MipPyramid {
    program: Arc<Program>,
}

impl MipPyramid {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("mip_pyramid", "", &[])?;
        HalveImage::check(&program, "halve_image")?;
        Halve::check(&program, "halve")?;
        Rectangles::check(&program, "rectangle_sums")?;
        Ok(MipPyramid { program })
    }

    /// Sums an image level by level. The image stays level 0 and must not change.
    pub fn record(&self, job: &mut Job, extent: Extent, image: Buffer<[u32]>) -> Result<Pyramid> {
        extent.check(image.len())?;
        let nodes = job.zeroed("mip nodes", extent.nodes().max(1));
        let program = job.program(&self.program);
        let Extent { mut width, mut height, channels } = extent;
        let (mut fine, mut coarse) = (0, 0);
        for (level, [columns, rows]) in extent.levels().enumerate() {
            let words = u64::from(5 * columns.next_multiple_of(GROUP) * channels);
            pieces::record(job, rows, words, |job, piece| {
                let params = Params { width, height, channels, rectangles: 0, fine, coarse, first: piece.start };
                let params = job.value("mip params", &params);
                let groups = [columns.div_ceil(GROUP), piece.len() as u32, channels];
                match level {
                    0 => job.launch(program, "halve_image", &HalveImage { params, image, nodes }, groups),
                    _ => job.launch(program, "halve", &Halve { params, nodes }, groups),
                }
            });
            fine = coarse;
            coarse += columns * rows * channels;
            [width, height] = [columns, rows];
        }
        Ok(Pyramid { extent, image, nodes })
    }

    /// Sums over the first `count` half-open rectangles (x0, y0, x1, y1): `count` words of `sums` for every channel.
    pub fn record_rectangles(
        &self,
        job: &mut Job,
        pyramid: &Pyramid,
        (count, rectangles): (u32, Buffer<[UVec4]>),
        sums: Buffer<[u32]>,
    ) -> Result<()> {
        let Pyramid { extent: Extent { width, height, channels }, image, nodes } = *pyramid;
        if rectangles.len() < u64::from(count) || sums.len() < u64::from(count * channels) {
            let what = format!("{count} rectangles from {} into {} sums", rectangles.len(), sums.len());
            return Err(Error::refused(what, format!("give a sum for each rectangle and each of {channels} channels")));
        }
        let program = job.program(&self.program);
        // The nodes along the sides of a rectangle, at all levels.
        let words = u64::from(4 * (width + height) * channels);
        pieces::record(job, count, words, |job, piece| {
            let params = Params { width, height, channels, rectangles: count, first: piece.start, ..Params::zeroed() };
            let params = job.value("mip params", &params);
            let bound = Rectangles { params, image, whole: nodes, rectangles, sums };
            job.launch(program, "rectangle_sums", &bound, [piece.len() as u32, channels, 1]);
        });
        Ok(())
    }
}

//! Greatest depths of squares of a depth buffer, boxes tested against them, and predicates for drawing: what visibility
//! queries are compared with.
//!
//! Greene, Kass and Miller, "Hierarchical Z-Buffer Visibility"; Décoret, "N-Buffers for efficient depth map query".
//! `kernel.wgsl` states every output exactly. Invariant: a region that a box is tested against holds its rectangle, so
//! a box that is hidden has no pixel in front.

use std::sync::Arc;

use bytemuck::Zeroable;
use glam::UVec4;
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;
use crate::raster::Picture;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "depth_bounds",
    summary: "depth pyramid and N-buffers of a depth buffer, boxes tested against them, predicates for indirect draws",
    citation: "Greene, Kass and Miller, Hierarchical Z-Buffer Visibility, 1993, section 3; Décoret, N-Buffers for \
               efficient depth map query, 2005, section 3",
    programs: || Ok(vec![DepthBounds::new()?.program]),
    cases: cases::all,
};

/// Invocations a workgroup.
const GROUP: u32 = 256;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Columns of the bound level.
        pub width: u32,
        /// Rows of the bound level.
        pub height: u32,
        /// The bound level.
        pub level: u32,
        /// Boxes, or draws.
        pub count: u32,
        /// Counts up to this draw nothing.
        pub threshold: u32,
        /// Row or workgroup of the first invocation.
        pub first: u32,
    }
}

bindings! {
    /// What `halve` and `widen` are given.
    pub struct Bound {
        uniform params @ 0: Params,
        read fine @ 1: [u32],
        write coarse @ 2: [u32],
    }

    /// What `test_pyramid` and `test_buffers` are given.
    pub struct Test {
        uniform params @ 0: Params,
        read fine @ 1: [u32],
        read rectangles @ 3: [UVec4],
        read nearest @ 4: [u32],
        write hidden @ 5: [u32],
    }

    /// What `predicate` is given.
    pub struct Predicate {
        uniform params @ 0: Params,
        read counts @ 6: [u32],
        read draws @ 7: [UVec4],
        write arguments @ 8: [u32],
    }
}

/// How squares are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Each level half as large as the one before, down to one texel.
    Pyramid,
    /// Each level as large as the picture, up to squares that hold it.
    Buffers,
}

/// The levels of a depth buffer, which is the first.
#[derive(Clone, Debug)]
pub struct Levels {
    form: Form,
    /// The levels, with their columns and rows.
    pub levels: Vec<(Picture, Buffer<[u32]>)>,
}

/// Boxes on the screen.
#[derive(Clone, Copy, Debug)]
pub struct Boxes {
    /// How many.
    pub count: u32,
    /// Half-open rectangles (x0, y0, x1, y1) in the picture, none of them empty.
    pub rectangles: Buffer<[UVec4]>,
    /// Least depth of each.
    pub nearest: Buffer<[u32]>,
}

/// The compiled kernel.
pub struct DepthBounds {
    program: Arc<Program>,
}

impl DepthBounds {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("depth_bounds", "", &[])?;
        Bound::check(&program, "halve")?;
        Bound::check(&program, "widen")?;
        Test::check(&program, "test_pyramid")?;
        Test::check(&program, "test_buffers")?;
        Predicate::check(&program, "predicate")?;
        Ok(DepthBounds { program })
    }

    /// Makes the levels of a depth buffer with a word a pixel.
    pub fn record_levels(&self, job: &mut Job, form: Form, picture: Picture, depth: Buffer<[u32]>) -> Result<Levels> {
        let sides = 1..=Picture::MAX_SIDE;
        let Picture { width, height } = picture;
        if !sides.contains(&width) || !sides.contains(&height) || depth.len() < u64::from(picture.pixels()) {
            let what = format!("depth bounds of {width} by {height} pixels in {} words", depth.len());
            return Err(Error::refused(what, "use 1 to 4096 pixels a side, and give one word a pixel"));
        }
        let program = job.program(&self.program);
        let mut levels = vec![(picture, depth)];
        for level in 0..(width.max(height) - 1).checked_ilog2().map_or(0, |log| log + 1) {
            let (fine, words) = levels[level as usize];
            let (size, entry) = match form {
                Form::Pyramid => (Picture { width: fine.width.div_ceil(2), height: fine.height.div_ceil(2) }, "halve"),
                Form::Buffers => (fine, "widen"),
            };
            let coarse = job.zeroed("depth bounds", u64::from(size.pixels()));
            pieces::record(job, size.height, u64::from(5 * size.width), |job, rows| {
                let params =
                    Params { width: fine.width, height: fine.height, level, first: rows.start, ..Params::zeroed() };
                let bound = Bound { params: job.value("bound params", &params), fine: words, coarse };
                job.launch(program, entry, &bound, [size.width.div_ceil(GROUP), rows.len() as u32, 1]);
            });
            levels.push((size, coarse));
        }
        Ok(Levels { form, levels })
    }

    /// Writes 1 into `hidden` for every box that is hidden, 0 for the others.
    pub fn record_tests(&self, job: &mut Job, levels: &Levels, boxes: Boxes, hidden: Buffer<[u32]>) -> Result<()> {
        let Boxes { count, rectangles, nearest } = boxes;
        if rectangles.len().min(nearest.len()).min(hidden.len()) < u64::from(count) {
            let what = format!("{count} boxes with {} rectangles and {} answers", rectangles.len(), hidden.len());
            return Err(Error::refused(what, "give a rectangle, a depth and a word of the answer for each box"));
        }
        let program = job.program(&self.program);
        let entry = match levels.form {
            Form::Pyramid => "test_pyramid",
            Form::Buffers => "test_buffers",
        };
        for (level, (size, fine)) in (0..).zip(&levels.levels) {
            pieces::record(job, count.div_ceil(GROUP), u64::from(10 * GROUP), |job, piece| {
                let Picture { width, height } = *size;
                let params = Params { width, height, level, count, threshold: 0, first: piece.start };
                let params = job.value("bound params", &params);
                let bound = Test { params, fine: *fine, rectangles, nearest, hidden };
                job.launch(program, entry, &bound, [piece.len() as u32, 1, 1]);
            });
        }
        Ok(())
    }

    /// Writes three words of `arguments` for each of `draws` (workgroups along x, y and z, and an object): its
    /// workgroups where the object's count exceeds `threshold`, else zeros.
    pub fn record_predicates(
        &self,
        job: &mut Job,
        threshold: u32,
        (count, draws): (u32, Buffer<[UVec4]>),
        counts: Buffer<[u32]>,
        arguments: Buffer<[u32]>,
    ) -> Result<()> {
        if draws.len() < u64::from(count) || arguments.len() < 3 * u64::from(count) {
            let what = format!("{count} predicates of {} draws into {} words", draws.len(), arguments.len());
            return Err(Error::refused(what, "give each draw its workgroups, and three words of arguments"));
        }
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(8 * GROUP), |job, piece| {
            let params = Params { count, threshold, first: piece.start, ..Params::zeroed() };
            let bound = Predicate { params: job.value("bound params", &params), counts, draws, arguments };
            job.launch(program, "predicate", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

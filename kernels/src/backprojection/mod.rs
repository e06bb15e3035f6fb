//! Backprojections: the lines on the source plane that bound what a triangle hides from a receiver, as exact integers.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 4. `kernel.wgsl` states the output and
//! the sizes of its numbers. Invariant: the samples in all half-planes of a pair are those of [`crate::grid::hidden`].

use std::ops::Range;
use std::sync::Arc;

use glam::{UVec2, UVec4};
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::grid::{Receivers, View};
use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "backprojection",
    summary: "lines on the source plane that bound what a triangle hides from a receiver",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, section 4",
    programs: || Ok(vec![Backprojection::new()?.program]),
    cases: cases::all,
};

/// Lines of a pair: those of its three edges and that of its own plane.
pub const LINES: u32 = 4;

const GROUP: u32 = 64;

/// Pairs of one recording.
const PAIRS: u32 = 1 << 18;

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Pair or triangle of the first workgroup.
        pub first: u32,
        /// One past the last pair or triangle.
        pub end: u32,
        /// WGSL places structs of a uniform at multiples of 16 bytes.
        pub _pad0: u32,
        /// The same.
        pub _pad1: u32,
        /// Receivers.
        pub view: View,
    }
}

bindings! {
    /// What `listed` is given.
    pub struct Listed {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        read pairs @ 2: [UVec2],
        write lines @ 5: [UVec4],
    }

    /// What `in_regions` is given.
    pub struct InRegions {
        uniform params @ 0: Params,
        read vertices @ 1: [i32],
        read regions @ 3: [i32],
        read starts @ 4: [u32],
        write lines @ 5: [UVec4],
    }
}

/// Number of the first pair of each region (first and last column, first and last row, as
/// [`crate::influence_region`] writes them), and one past the last pair.
pub fn starts(regions: &[[i32; 4]]) -> Result<Vec<u32>> {
    let size = |first: i32, last: i32| (i64::from(last) - i64::from(first) + 1).max(0) as u64;
    let mut end = 0u64;
    let mut starts = vec![0];
    for [x0, x1, y0, y1] in regions {
        end += size(*x0, *x1) * size(*y0, *y1);
        starts.push(u32::try_from(end).map_err(|_| Error::refused(format!("{end} pairs"), "give fewer triangles"))?);
    }
    Ok(starts)
}

/// The compiled kernel.
pub struct Backprojection {
    program: Arc<Program>,
}

impl Backprojection {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("backprojection", "", &[])?;
        Listed::check(&program, "listed")?;
        InRegions::check(&program, "in_regions")?;
        Ok(Backprojection { program })
    }

    /// Writes the [`LINES`] lines of each of `count` pairs (triangle, receiver); `vertices` holds nine coordinates a
    /// triangle.
    pub fn record_pairs(
        &self,
        job: &mut Job,
        receivers: &Receivers,
        vertices: Buffer<[i32]>,
        count: u32,
        pairs: Buffer<[UVec2]>,
        lines: Buffer<[UVec4]>,
    ) -> Result<()> {
        receivers.check()?;
        fits(count.into(), lines)?;
        if pairs.len() < count.into() {
            return Err(Error::refused(format!("{} of {count} pairs", pairs.len()), "give all pairs"));
        }
        let program = job.program(&self.program);
        // Every invocation touches its pair, nine coordinates and sixteen words of lines.
        pieces::record(job, count.div_ceil(GROUP), u64::from(27 * GROUP), |job, piece| {
            let params = params(job, receivers, piece.start * GROUP..count);
            job.launch(program, "listed", &Listed { params, vertices, pairs, lines }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }

    /// Writes the [`LINES`] lines of each triangle and each receiver of its region, row by row, from pair `starts[t]`
    /// on, in recordings of bounded cost. `starts` is [`starts`] of what `regions` holds.
    pub fn record_regions(
        &self,
        job: &mut Job,
        receivers: &Receivers,
        vertices: Buffer<[i32]>,
        regions: Buffer<[i32]>,
        starts: &[u32],
        lines: Buffer<[UVec4]>,
    ) -> Result<()> {
        receivers.check()?;
        let pairs = starts.last().copied().unwrap_or(0);
        fits(pairs.into(), lines)?;
        let triangles = starts.len().saturating_sub(1) as u32;
        if vertices.len() < 9 * u64::from(triangles) || regions.len() < 4 * u64::from(triangles) {
            let what = format!("{} coordinates and {} words of regions", vertices.len(), regions.len());
            return Err(Error::refused(what, format!("give nine and four a triangle, of which there are {triangles}")));
        }
        let program = job.program(&self.program);
        let on_device = job.slice("region starts", if starts.is_empty() { &[0] } else { starts });
        for piece in region_pieces(starts) {
            pieces::cut(job);
            let groups = [(piece.end - piece.start).max(1), 1, 1];
            let params = params(job, receivers, piece);
            job.launch(
                program,
                "in_regions",
                &InRegions { params, vertices, regions, starts: on_device, lines },
                groups,
            );
        }
        Ok(())
    }
}

fn params(job: &mut Job, receivers: &Receivers, items: Range<u32>) -> Buffer<Params> {
    let view = View::of(receivers);
    job.value("backprojection params", &Params { first: items.start, end: items.end, _pad0: 0, _pad1: 0, view })
}

fn fits(pairs: u64, lines: Buffer<[UVec4]>) -> Result<()> {
    if lines.len() < u64::from(LINES) * pairs || pairs > u64::from(u32::MAX / 16) {
        let what = format!("{} lines for {pairs} pairs", lines.len());
        return Err(Error::refused(what, "give every pair of a triangle and a receiver four lines"));
    }
    Ok(())
}

/// Ranges of triangles, each of bounded cost unless one triangle alone exceeds it; one range if there is no triangle.
fn region_pieces(starts: &[u32]) -> Vec<Range<u32>> {
    let triangles = starts.len().saturating_sub(1) as u32;
    let mut pieces = Vec::new();
    let mut first = 0;
    while first < triangles || pieces.is_empty() {
        let most = triangles.min(first.saturating_add(pieces::MAX_GROUPS));
        let cost = |end: u32| starts[end as usize] - starts[first as usize];
        let end = (first + 1..=most).take_while(|end| *end == first + 1 || cost(*end) <= PAIRS).last();
        pieces.push(first..end.unwrap_or(first));
        first = end.unwrap_or(first);
    }
    pieces
}

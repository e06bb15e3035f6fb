//! The visibility matrix on a device: refined block by block, multiplied with intensities as often as they change.
//!
//! Sattler et al. 2004, sections 3.2 to 3.4. The matrix stays in device memory from the first
//! block to the last colour; it is read only where a file wants it. A row of bits is 32 directions of all positions, so
//! whatever is complete stays valid while more directions follow. Positions whose rows would outgrow a binding are
//! divided among several [`Part`]s. Invariant: the bits of the first [`Matrix::done`] directions are those of
//! `vertex_visibility`'s definition, whatever the blocks, the parts and the machine.

use std::collections::BTreeSet;
use std::ops::Range;

use sightlines_backend::{Backend, Counts};
use sightlines_kernels::light_sphere::oracle::Direction;

use super::environment::Intensities;
use super::part::{Kernels, Part};
use super::sphere::Sphere;
use super::surface::Surface;
use crate::error::{Place, Result};

/// Words of a block, 32 directions each.
const BLOCK_WORDS: u32 = 2;

/// Most words of a part's matrix: half of a binding.
const PART_WORDS: u64 = 1 << 24;

/// Most words of a matrix: 4 GiB.
pub const MAX_WORDS: u64 = 1 << 30;

/// Linear colours: red, green and blue of each vertex; an unoccluded one under a white sky of one is one.
pub type Colours = Vec<[f32; 3]>;

/// The matrix of some or all positions of a surface.
pub struct Matrix<'a> {
    /// Vertices of the whole surface.
    vertices: usize,
    sphere: Sphere,
    directions: Vec<Direction>,
    kernels: Kernels,
    parts: Vec<Part<'a>>,
    positions: u32,
    done: u32,
}

/// The work of a matrix, in numbers that do not depend on how fast the machine is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    /// Lane-operations, from the interpreter.
    pub lane_ops: Option<u64>,
    /// Semantic costs, from machines that are told to count them.
    pub counts: Option<Counts>,
}

impl std::iter::Sum for Work {
    fn sum<I: Iterator<Item = Work>>(works: I) -> Work {
        let none = Work { lane_ops: Some(0), counts: Some(Counts::default()) };
        works.fold(none, |sum, work| Work {
            lane_ops: sum.lane_ops.zip(work.lane_ops).map(|(a, b)| a + b),
            counts: sum.counts.zip(work.counts).map(|(mut a, b)| {
                a += b;
                a
            }),
        })
    }
}

impl<'a> Matrix<'a> {
    /// An empty matrix of all positions, on `backend`, with room for `sphere`. Occluders closer than `bias` cells do
    /// not count.
    ///
    /// # Errors
    ///
    /// More than [`MAX_WORDS`], and whatever the backend refuses.
    pub fn open(backend: &'a dyn Backend, surface: &Surface, sphere: Sphere, bias: u32) -> Result<Self> {
        let all: Vec<u32> = (0..surface.positions()).collect();
        Self::open_some(backend, surface, &all, sphere, bias)
    }

    /// The same for the positions `chosen`, each at most once.
    pub fn open_some(
        backend: &'a dyn Backend,
        surface: &Surface,
        chosen: &[u32],
        sphere: Sphere,
        bias: u32,
    ) -> Result<Self> {
        let words = u64::from(sphere.count().div_ceil(32));
        check_size(chosen.len() as u64, words, sphere)?;
        let kernels = Kernels::new()?;
        let directions = sphere.directions();
        let each = (PART_WORDS / words).max(1) as usize;
        let mut vertices_of = vec![Vec::new(); surface.positions() as usize];
        for (vertex, &position) in (0..).zip(&surface.position_of) {
            vertices_of[position as usize].push(vertex);
        }
        let shapes = block_shapes(sphere);
        let open = |chosen: &[u32]| {
            let vertices: Vec<Vec<u32>> =
                chosen.iter().map(|&p| vertices_of.get(p as usize).cloned().unwrap_or_default()).collect();
            Part::open(backend, &kernels, surface, (chosen, &vertices), (&directions, &shapes), bias)
        };
        let parts = chosen.chunks(each).map(open).collect::<Result<_>>()?;
        let (vertices, positions) = (surface.vertices.len(), chosen.len() as u32);
        Ok(Matrix { vertices, sphere, directions, kernels, parts, positions, done: 0 })
    }

    /// Directions whose bits are there.
    pub fn done(&self) -> u32 {
        self.done
    }

    /// Positions that it has rows for.
    pub fn positions(&self) -> u32 {
        self.positions
    }

    /// Computes the next block towards the directions of `target`, a refinement of the sphere it was opened for;
    /// `false` where all of them are done.
    ///
    /// # Errors
    ///
    /// Whatever the backend refuses; the bits that were there stay valid.
    pub fn advance(&mut self, target: Sphere) -> Result<bool> {
        let end = self.next_stop(target);
        if self.done >= end {
            return Ok(false);
        }
        let block = &self.directions[self.done as usize..end as usize];
        for part in &mut self.parts {
            part.see(&self.kernels, (self.done, block))?;
        }
        self.done = end;
        Ok(true)
    }

    /// Directions that are done after the next block towards those of `target`.
    pub fn next_stop(&self, target: Sphere) -> u32 {
        let block = 32 * BLOCK_WORDS;
        target.count().min(self.sphere.count()).min((self.done / block + 1) * block)
    }

    /// The bits so far: for each 32 directions a word of every position.
    pub fn words(&mut self) -> Result<Vec<u32>> {
        let rows = self.done.div_ceil(32) as usize;
        let read = self.parts.iter_mut().map(|part| Ok((part.positions() as usize, part.words(rows as u32)?)));
        let parts = read.collect::<Result<Vec<_>>>()?;
        let row = |row: usize| parts.iter().flat_map(move |(n, words)| &words[row * n..(row + 1) * n]).copied();
        Ok((0..rows).flat_map(row).collect())
    }

    /// Takes the bits of the first `done` directions from an earlier matrix.
    ///
    /// # Errors
    ///
    /// Bits of another size, or of a number of directions that no block ends with.
    pub fn restore(&mut self, done: u32, words: &[u32]) -> Result<()> {
        let (rows, positions) = (done.div_ceil(32) as usize, self.positions as usize);
        if !stops(self.sphere).contains(&done) || words.len() != rows * positions {
            let what = format!("{} words for {done} directions of {positions} positions", words.len());
            return Err(Place::default().element("matrix").error(what, "compute the matrix anew"));
        }
        let mut first = 0;
        for part in &mut self.parts {
            let here = first..first + part.positions() as usize;
            let words: Vec<u32> = (0..rows).flat_map(|row| &words[row * positions..][here.clone()]).copied().collect();
            part.restore(&words)?;
            first = here.end;
        }
        self.done = done;
        Ok(())
    }

    /// Multiplies the matrix with intensities, which are those of the first [`Matrix::done`] directions or of fewer,
    /// and puts the colours of its vertices into `colours`, which holds those of the whole surface.
    ///
    /// # Errors
    ///
    /// Intensities of directions that are not done.
    pub fn light(&mut self, intensities: &Intensities, colours: &mut Colours) -> Result<()> {
        if intensities.values.len() > self.done as usize {
            let what =
                format!("intensities of {} directions, of which {} are done", intensities.values.len(), self.done);
            return Err(Place::default().element("light").error(what, "advance the matrix first"));
        }
        colours.resize(self.vertices, [0.0; 3]);
        self.parts.iter_mut().try_for_each(|part| part.light(&self.kernels, intensities, colours))
    }

    /// Encodes the colours of the last [`Matrix::light`] as bytes, by
    /// [`sightlines_kernels::illumination::gamma_table`].
    ///
    /// # Errors
    ///
    /// Whatever the backend refuses.
    pub fn encode(&mut self, table: &[u32], bytes: &mut Vec<[u8; 3]>) -> Result<()> {
        bytes.resize(self.vertices, [0; 3]);
        self.parts.iter_mut().try_for_each(|part| part.encode(&self.kernels, table, bytes))
    }

    /// What it took so far.
    pub fn work(&self) -> Work {
        self.parts.iter().map(Part::work).sum()
    }
}

/// Numbers of directions after which blocks end.
fn stops(sphere: Sphere) -> BTreeSet<u32> {
    let counts = sphere.refinements().into_iter().map(Sphere::count);
    (0..sphere.count()).step_by(32 * BLOCK_WORDS as usize).chain(counts).collect()
}

/// Where blocks may begin and end within the words of one: at its borders, and where a refinement is complete.
fn block_shapes(sphere: Sphere) -> Vec<Range<u32>> {
    let most = 32 * BLOCK_WORDS;
    let stops = stops(sphere);
    let blocks = stops.iter().flat_map(|&start| {
        let here = move |end: &u32| (start + 1..=(start / most + 1) * most).contains(end);
        stops.iter().copied().filter(here).map(move |end| (start % most, end - start))
    });
    let shapes: BTreeSet<(u32, u32)> = blocks.collect();
    shapes.into_iter().map(|(start, count)| start..start + count).collect()
}

fn check_size(positions: u64, words: u64, sphere: Sphere) -> Result<()> {
    if positions * words <= MAX_WORDS {
        return Ok(());
    }
    let what = format!("the matrix of {positions} positions and {sphere} has {} MiB", (positions * words) >> 18);
    let remedy = format!("choose a lower level: at most {} MiB are taken", MAX_WORDS >> 18);
    Err(Place::default().element("level").error(what, remedy))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_beyond_memory_are_refused_with_a_remedy() {
        let sphere = Sphere::Octahedron { level: 6 };
        assert!(check_size(2_093_000, 513, sphere).is_ok());
        let message = check_size(2_100_000, 513, sphere).unwrap_err().to_string();
        assert!(message.contains("level: the matrix of 2100000 positions and octahedron level 6"), "{message}");
        assert!(message.contains("has 4109 MiB") && message.contains("at most 4096 MiB"), "{message}");
    }

    #[test]
    fn blocks_have_few_shapes() {
        let shapes = |sphere| block_shapes(sphere).into_iter().map(|r| (r.start, r.end)).collect::<Vec<_>>();
        assert_eq!(shapes(Sphere::Octahedron { level: 0 }), [(0, 6)]);
        assert_eq!(
            shapes(Sphere::Octahedron { level: 5 }),
            [(0, 2), (0, 6), (0, 18), (0, 64), (2, 64), (6, 18), (6, 64), (18, 64)]
        );
        assert_eq!(shapes(Sphere::Healpix { order: 0 }), [(0, 12)]);
        assert_eq!(shapes(Sphere::Healpix { order: 2 }), [(0, 64)]);
    }
}

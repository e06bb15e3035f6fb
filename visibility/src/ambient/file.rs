//! The visibility matrix in a file, complete or on the way: for other programs, and to go on after an interruption.
//!
//! All numbers are little-endian. Offsets and sizes in bytes, P positions, V vertices, D directions of which the bits
//! are there:
//!
//! | offset | size | what |
//! |---|---|---|
//! | 0 | 16 | the magic line `sightlines occl` and a line feed |
//! | 16 | 4 | u32: version of this layout, 1 |
//! | 20 | 4 | u32: version of the numerics contract |
//! | 24 | 4 | u32: 0 for directions of the octahedron, 1 for HEALPix |
//! | 28 | 4 | u32: level or order that was asked for |
//! | 32 | 4 | u32: D |
//! | 36 | 4 | u32: P |
//! | 40 | 4 | u32: V |
//! | 44 | 4 | u32: bias in cells |
//! | 48 | 8 | f64: side of a cell, in scene units |
//! | 56 | 32 | BLAKE3 digest of positions and triangles, by which a mesh is known again |
//! | 88 | 4 V | u32: position of each vertex |
//! | … | 4 P ⌈D / 32⌉ | u32: words of all positions, one after another; bit i % 32 of word i / 32: hidden from i |
//! | … | 32 | BLAKE3 digest of all that stands before |
//!
//! Directions are those of the kernel `light_sphere`, in its order.

use std::path::Path;

use sightlines_backend::CONTRACT_VERSION;

use super::matrix::{MAX_WORDS, Matrix};
use super::sphere::Sphere;
use super::surface::Surface;
use crate::error::{Place, Result};
use crate::input;
use crate::output;
use crate::scene::MAX_VERTICES;

/// First bytes of the file of a matrix.
pub const MAGIC: [u8; 16] = *b"sightlines occl\n";
/// Version of the layout.
pub const VERSION: u32 = 1;

const REMEDY: &str = "compute the matrix again with `sightlines ambient --matrix`";

const HEADER: usize = 88;
const DIGEST: usize = blake3::OUT_LEN;

/// A matrix out of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    /// The directions that were asked for.
    pub sphere: Sphere,
    /// Directions whose bits are there.
    pub done: u32,
    /// Number of positions.
    pub positions: u32,
    /// Occluders closer than so many cells did not count.
    pub bias: u32,
    /// Side of a cell, in scene units.
    pub cell: f64,
    /// Digest of positions and triangles.
    pub mesh: [u8; 32],
    /// Position of each vertex.
    pub position_of: Vec<u32>,
    /// The bits: for each 32 directions a word of every position.
    pub words: Vec<u32>,
}

impl Stored {
    /// What is there of a matrix.
    ///
    /// # Errors
    ///
    /// Whatever the backend refuses.
    pub fn of(matrix: &mut Matrix<'_>, surface: &Surface, sphere: Sphere, bias: u32) -> Result<Self> {
        Ok(Stored {
            sphere,
            done: matrix.done(),
            positions: matrix.positions(),
            bias,
            cell: surface.cell,
            mesh: surface.digest(),
            position_of: surface.position_of.clone(),
            words: matrix.words()?,
        })
    }

    /// Whether a direction's light reaches a position, on this side of the vertices' normals or not.
    pub fn is_occluded(&self, position: u32, direction: u32) -> bool {
        let word = self.words[(direction / 32 * self.positions + position) as usize];
        word >> (direction % 32) & 1 == 1
    }

    /// Refuses to go on with another mesh, bias or sphere; coarser octahedra may be refined.
    ///
    /// # Errors
    ///
    /// What differs.
    pub fn check(&self, path: &Path, surface: &Surface, sphere: Sphere, bias: u32) -> Result<()> {
        let refuse = |what: String| {
            Err(Place::file(path)
                .error(what, "leave out --resume, which computes the matrix anew, or name another file"))
        };
        if self.mesh != surface.digest() {
            return refuse("it holds the matrix of another mesh".into());
        }
        if self.bias != bias {
            return refuse(format!("it was computed with a bias of {} cells, not {bias}", self.bias));
        }
        let same_kind = matches!((self.sphere, sphere), (Sphere::Octahedron { .. }, Sphere::Octahedron { .. }));
        if !same_kind && self.sphere != sphere {
            return refuse(format!("it was computed for {}", self.sphere));
        }
        if self.done > sphere.count() {
            return refuse(format!("it holds {} directions, more than {sphere}", self.done));
        }
        Ok(())
    }

    /// Writes it.
    ///
    /// # Errors
    ///
    /// A file that cannot be written; then it is what it was.
    pub fn write(&self, path: &Path) -> Result<()> {
        let (kind, level) = match self.sphere {
            Sphere::Octahedron { level } => (0, level),
            Sphere::Healpix { order } => (1, order),
        };
        let vertices = self.position_of.len() as u32;
        let fields = [VERSION, CONTRACT_VERSION, kind, level, self.done, self.positions, vertices, self.bias];
        let mut bytes = MAGIC.to_vec();
        bytes.extend(fields.iter().flat_map(|field| field.to_le_bytes()));
        bytes.extend(self.cell.to_le_bytes());
        bytes.extend(self.mesh);
        bytes.extend(self.position_of.iter().chain(&self.words).flat_map(|word| word.to_le_bytes()));
        let digest = blake3::hash(&bytes);
        output::write(path, |out| {
            out.write_all(&bytes)?;
            out.write_all(digest.as_bytes())
        })
    }

    /// Reads it.
    ///
    /// # Errors
    ///
    /// A file that is missing, no such file, of another version, or damaged.
    pub fn read(path: &Path) -> Result<Self> {
        // The largest file that can be right.
        let most = (HEADER + DIGEST + 4 * MAX_VERTICES) as u64 + 4 * MAX_WORDS;
        decode(&input::read(path, most, REMEDY)?).map_err(|what| Place::file(path).error(what, REMEDY))
    }
}

fn decode(bytes: &[u8]) -> Result<Stored, String> {
    let rest = bytes.strip_prefix(&MAGIC).ok_or("it is no matrix, which begins with `sightlines occl`")?;
    let (fields, rest) = rest.split_first_chunk::<32>().ok_or("its header is cut off")?;
    let words: Vec<u32> = words_of(fields);
    let &[version, contract, kind, level, done, positions, vertices, bias] = words.as_slice() else {
        return Err("its header is cut off".into());
    };
    if (version, contract) != (VERSION, CONTRACT_VERSION) {
        let [layout, numerics] = [VERSION, CONTRACT_VERSION];
        return Err(format!("layout {version} and contract {contract}, where {layout} and {numerics} are read"));
    }
    let sphere = match kind {
        0 if level <= Sphere::FINEST => Sphere::Octahedron { level },
        1 if level <= Sphere::FINEST => Sphere::Healpix { order: level },
        _ => return Err(format!("its header is damaged: directions of kind {kind} and level {level}")),
    };
    let (cell, rest) = rest.split_first_chunk::<8>().ok_or("its header is cut off")?;
    let (mesh, _) = rest.split_first_chunk::<32>().ok_or("its header is cut off")?;
    let rows = u64::from(done.div_ceil(32));
    let size = HEADER as u64 + 4 * u64::from(vertices) + 4 * u64::from(positions) * rows + DIGEST as u64;
    if done > sphere.count() || bytes.len() as u64 != size {
        return Err(format!("it has {} bytes, {size} are right", bytes.len()));
    }
    let (body, digest) = bytes.split_at(bytes.len() - DIGEST);
    if blake3::hash(body).as_bytes() != digest {
        return Err("its bytes do not match their digest".into());
    }
    let (position_of, words) = body[HEADER..].split_at(4 * vertices as usize);
    let position_of = words_of(position_of);
    if position_of.iter().any(|&position| position >= positions) {
        return Err("a vertex has a position that is not there".into());
    }
    let cell = f64::from_le_bytes(*cell);
    Ok(Stored { sphere, done, positions, bias, cell, mesh: *mesh, position_of, words: words_of(words) })
}

fn words_of(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks::<4>().0.iter().map(|&word| u32::from_le_bytes(word)).collect()
}

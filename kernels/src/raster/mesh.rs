//! Meshes and instances, which sides of them are drawn, and what their pixels are called.
//!
//! Invariant: what passes the check of a mesh has a word in every buffer for each vertex and triangle of each instance.

use glam::IVec4;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Error, Result};

use super::Picture;
use crate::pieces;

/// Most vertices of all instances of a mesh: they fill a binding of 128 MiB.
pub const MAX_POINTS: u32 = 1 << 23;

/// Most triangles of all instances of a mesh: a list of them fills a binding of 128 MiB.
pub const MAX_TRIANGLES: u32 = 1 << 25;

/// Which sides of triangles are drawn. Clockwise is as the viewer sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Faces {
    /// Both.
    All = 3,
    /// Triangles that turn clockwise.
    Clockwise = 1,
    /// Triangles that turn counter-clockwise.
    CounterClockwise = 2,
}

/// Item ids of a mesh: `base + instance * step + (triangle >> shift)`, modulo 2^32. `shift` is at most 31.
///
/// With `step` 1 and `shift` 31 an item is an instance; with a smaller `shift`, a cluster of 2^shift triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ids {
    /// Id of the first instance.
    pub base: u32,
    /// Ids from one instance to the next.
    pub step: u32,
    /// Logarithm of the triangles of a cluster.
    pub shift: u32,
}

/// A mesh and its instances, on the device.
#[derive(Clone, Copy, Debug)]
pub struct Mesh {
    /// Three coordinates a vertex, each in [-2^15, 2^15).
    pub vertices: Buffer<[i32]>,
    /// Number of vertices.
    pub vertex_count: u32,
    /// Three vertices a triangle; a triangle with a vertex that does not exist is not drawn.
    pub indices: Buffer<[u32]>,
    /// Number of triangles.
    pub triangle_count: u32,
    /// Four rows an instance, as [`Placement::rows`] has them.
    pub rows: Buffer<[IVec4]>,
    /// Number of instances.
    pub instance_count: u32,
}

impl Mesh {
    /// Words that a listed triangle is reckoned to touch: a thousandth of the picture.
    pub(super) fn large_words(picture: Picture) -> u64 {
        u64::from((picture.pixels() / 1024).max(256))
    }

    /// Triangles of a piece, if all are listed.
    pub(super) fn large_piece(&self, picture: Picture) -> u32 {
        pieces::pieces(self.triangles(), Self::large_words(picture)).next().map_or(1, |piece| piece.end)
    }

    /// Vertices of all instances.
    pub fn points(&self) -> u32 {
        self.vertex_count.saturating_mul(self.instance_count)
    }

    /// Triangles of all instances.
    pub fn triangles(&self) -> u32 {
        self.triangle_count.saturating_mul(self.instance_count)
    }

    /// A word a triangle, in fours.
    pub(super) fn places(&self) -> u64 {
        u64::from(self.triangles().max(1).next_multiple_of(4))
    }

    pub(super) fn check(&self) -> Result<()> {
        let Mesh { vertex_count, triangle_count, instance_count, .. } = *self;
        if self.points() > MAX_POINTS || self.triangles() > MAX_TRIANGLES {
            let what = format!("{instance_count} instances of {vertex_count} vertices and {triangle_count} triangles");
            let remedy = format!(
                "draw them in several meshes, each of at most {MAX_POINTS} vertices and {MAX_TRIANGLES} triangles of all \
                 instances"
            );
            return Err(Error::refused(what, remedy));
        }
        let needs = [
            ("coordinates", self.vertices.len(), 3 * u64::from(vertex_count)),
            ("indices", self.indices.len(), 3 * u64::from(triangle_count)),
            ("rows", self.rows.len(), 4 * u64::from(instance_count)),
        ];
        let short = needs.iter().find(|(_, have, need)| have < need);
        short.map_or(Ok(()), |(name, have, need)| {
            Err(Error::refused(format!("a mesh with {have} {name}"), format!("give {need} {name}")))
        })
    }
}

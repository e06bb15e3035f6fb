//! Pictures, views and the placement of instances: what the host gives, with its bit budget.
//!
//! Invariant: what passes the checks of this file stays within the table of `docs/numerics.md`, "The raster".

use glam::IVec4;
use sightlines_backend::{Error, Result};

/// Rows of a band.
const BAND: u32 = 512;

/// Clip coordinates are clamped to [-CLIP, CLIP].
pub const CLIP: i32 = 1 << 25;

/// Size of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns, 1 to 4096.
    pub width: u32,
    /// Rows, 1 to 4096; row 0 is the top.
    pub height: u32,
}

impl Picture {
    /// Widest and tallest picture.
    pub const MAX_SIDE: u32 = 4096;

    /// Number of pixels; 0 for sides that no picture has.
    pub fn pixels(&self) -> u32 {
        self.width.checked_mul(self.height).unwrap_or(0)
    }

    /// Rows that a workgroup draws of a triangle: few enough that one large triangle is many workgroups.
    pub(super) fn band(&self) -> u32 {
        self.height.min(BAND)
    }

    pub(super) fn check(&self, words: u64) -> Result<()> {
        let Picture { width, height } = *self;
        let sides = 1..=Self::MAX_SIDE;
        if !sides.contains(&width) || !sides.contains(&height) {
            let what = format!("a picture of {width} by {height} pixels");
            return Err(Error::refused(what, "use 1 to 4096 pixels a side, and several pictures for more"));
        }
        if words < u64::from(self.pixels()) {
            let what = format!("a picture of {width} by {height} pixels in {words} words");
            return Err(Error::refused(what, "give one word a pixel"));
        }
        Ok(())
    }
}

/// A picture and its near plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// The picture.
    pub picture: Picture,
    /// Least W that is divided by: W at the near plane, at least the longer side of the picture in pixels, so that
    /// screen coordinates keep within their bits. An orthographic view has it as its W.
    pub near: i32,
}

impl View {
    pub(super) fn check(&self) -> Result<()> {
        self.picture.check(u64::from(self.picture.pixels()))?;
        let least = self.picture.width.max(self.picture.height) as i32;
        if !(least..=CLIP).contains(&self.near) {
            let what = format!("a near plane at {} clip units", self.near);
            let remedy = format!("scale the scene, or move the near plane, to {least} to {CLIP} clip units");
            return Err(Error::refused(what, remedy));
        }
        Ok(())
    }
}

/// How an instance's vertices become clip coordinates: rows for X, Y, Z and W, each three factors in 1/65536 and a sum.
///
/// X grows to the right and Y upwards; the picture shows -W <= X, Y <= W and Z >= 0, and Z / W is its depth, 0 at the
/// near plane and 1 at the last depth that is told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// The rows.
    pub rows: [IVec4; 4],
}

impl Placement {
    /// Rounds the matrix that takes a vertex (x, y, z, 1) to clip units, row by row. Refuses what a row cannot hold.
    pub fn new(matrix: [[f64; 4]; 4]) -> Result<Self> {
        let mut rows = [IVec4::ZERO; 4];
        for (row, reals) in rows.iter_mut().zip(matrix) {
            let scaled = [reals[0] * 65_536.0, reals[1] * 65_536.0, reals[2] * 65_536.0, reals[3]];
            for (place, real) in scaled.into_iter().enumerate() {
                let most = f64::from(if place < 3 { 1_u32 << 30 } else { 1 << 29 });
                let rounded = (real + 0.5).floor();
                if !(-most < rounded && rounded < most) {
                    let what = format!("a placement with the entry {}", reals[place]);
                    let remedy = "keep factors within 2^14 and sums within 2^29 clip units: scale the scene";
                    return Err(Error::refused(what, remedy));
                }
                row[place] = rounded as i32;
            }
        }
        Ok(Placement { rows })
    }
}

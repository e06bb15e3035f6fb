//! A receiver's map looked up in a camera's view, as a texture: linear between texels and between levels.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 8: the intensities of a map can be a
//! texture of the receiver, with linear and mipmap filters, where [`Surface::View`](super::surface::Surface::View)
//! counts at the very points that are seen. Filters are integers: a level is sums of the map's counts, places and
//! weights are 8 bits below a texel, and the level is told by the larger side of a pixel's footprint.

use super::Rect;
use super::surface::met;
use crate::error::{Place, Result};
use crate::scene::Camera;

/// Bits below a texel, and of a weight between levels.
const PART: u32 = 8;

/// Bits below one sample in what is looked up.
pub const FRACTION: u32 = 2 * PART;

/// A map and its levels, each half as large as the one before.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    /// Sums of counts: a texel of level l holds those of 4^l texels of the map.
    sums: Vec<Vec<u64>>,
}

/// Where a pixel's middle is on a map, and how large it is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Footprint {
    /// Column and row in units of 2^-8 of a texel.
    pub at: [i64; 2],
    /// The larger of the distances to where the next pixel's middles to the right and below are, in those units.
    pub size: u64,
}

impl Levels {
    /// All levels of a map of `side`² counts.
    ///
    /// # Errors
    ///
    /// A side that is no power of two.
    pub fn new(side: u32, counts: &[u32]) -> Result<Self> {
        if !side.is_power_of_two() || counts.len() as u64 != u64::from(side) * u64::from(side) {
            let what = format!("a map of {side} texels a side");
            return Err(Place::default().element("--map").error(what, "choose a power of two up to 8192"));
        }
        let mut sums = vec![counts.iter().map(|count| u64::from(*count)).collect::<Vec<u64>>()];
        let mut side = side as usize;
        while side > 1 {
            let finer = &sums[sums.len() - 1];
            let half = side / 2;
            let sum = |index: usize| {
                let at = 2 * (index / half) * side + 2 * (index % half);
                finer[at] + finer[at + 1] + finer[at + side] + finer[at + side + 1]
            };
            let coarser = (0..half * half).map(sum).collect();
            sums.push(coarser);
            side = half;
        }
        Ok(Levels { sums })
    }

    /// The count at a footprint, in units of 2^-16, between the two levels whose texels are nearest to it in size.
    pub fn look_up(&self, Footprint { at, size }: Footprint) -> u64 {
        let size = size.max(1 << PART);
        let last = self.sums.len() as u32 - 1;
        let level = (size.ilog2() - PART).min(last);
        let weight = if level == last { 0 } else { (size >> level) - (1 << PART) };
        let [near, far] = [level, (level + 1).min(last)].map(|level| self.linear(level, at));
        (near * ((1 << PART) - weight) + far * weight) >> PART
    }

    /// Between the four texels of a level whose centres are nearest; beyond the border the border goes on.
    fn linear(&self, level: u32, at: [i64; 2]) -> u64 {
        let side = 1i64 << (self.sums.len() as u32 - 1 - level);
        let place = |x: i64| {
            let x = ((x >> level) - (1 << (PART - 1))).clamp(0, (side - 1) << PART);
            (x >> PART, ((x >> PART) + 1).min(side - 1), (x & ((1 << PART) - 1)) as u64)
        };
        let ((left, right, x), (top, bottom, y)) = (place(at[0]), place(at[1]));
        let sums = &self.sums[level as usize];
        let row = |row: i64| {
            let [a, b] = [left, right].map(|column| sums[(row * side + column) as usize]);
            a * ((1 << PART) - x) + b * x
        };
        (row(top) * ((1 << PART) - y) + row(bottom) * y) >> (2 * level)
    }
}

/// The footprints of a camera's pixels on a map of `side`² texels of a rectangle, row after row; none where a pixel's
/// middle does not see it.
pub fn footprints(rect: &Rect, camera: &Camera, resolution: u32, side: u32) -> Vec<Option<Footprint>> {
    let unit = f64::from(side << PART);
    let footprint = |index: u32| {
        let pixel = [index % resolution, index / resolution].map(f64::from);
        let [right, below] = [[pixel[0] + 1.0, pixel[1]], [pixel[0], pixel[1] + 1.0]];
        let (_, parts) = met(rect, camera, pixel, resolution)?;
        if !parts.iter().all(|part| (0.0..=1.0).contains(part)) {
            return None;
        }
        // A neighbour that sees the horizon is as far as any map is large.
        let distance = |pixel| match met(rect, camera, pixel, resolution) {
            Some((_, [s, t])) => {
                let [across, down] = [s - parts[0], t - parts[1]].map(|part| part.abs().min(1.0) * unit);
                (across * across + down * down).sqrt()
            }
            None => unit,
        };
        let size = distance(right).max(distance(below)) as u64;
        Some(Footprint { at: parts.map(|part| (part * unit) as i64), size })
    };
    (0..resolution * resolution).map(footprint).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_means_and_what_is_between_is_linear() {
        let levels = Levels::new(4, &[0, 4, 8, 8, 4, 8, 8, 8, 0, 0, 16, 16, 0, 0, 16, 16]).unwrap();
        let look = |x: i64, y: i64, size: u64| levels.look_up(Footprint { at: [x, y], size }) as f64 / 65_536.0;
        // Centres of texels, and half-way between two.
        assert_eq!((look(128, 128, 256), look(384, 128, 10), look(256, 128, 0)), (0.0, 4.0, 2.0));
        // The level of half the side has means of four; the last one that of all.
        assert_eq!((look(256, 256, 512), look(768, 768, 512), look(512, 512, 512)), (4.0, 16.0, 7.0));
        assert_eq!((look(3, 900, 1024), look(900, 9, 1 << 20)), (7.0, 7.0));
        // Half-way between two levels.
        assert_eq!(look(256, 256, 768), (4.0 + 7.0) / 2.0);
        // The border goes on.
        assert_eq!((look(-500, 0, 256), look(1024, 1024, 256)), (0.0, 16.0));
        assert!(Levels::new(3, &[0; 9]).unwrap_err().to_string().contains("power of two"));
    }

    #[test]
    fn footprints_grow_with_distance() {
        let floor = Rect { corner: [-2.0, 0.0, -2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, 4.0] };
        let lens = crate::scene::Lens::angle(50.0).unwrap();
        let camera = Camera::look_at("test", [0.0, 1.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0], lens).unwrap();
        let found = footprints(&floor, &camera, 32, 64);
        let seen: Vec<&Footprint> = found.iter().flatten().collect();
        assert!(found[0].is_none() && seen.len() > 200, "{}", seen.len());
        let (far, near) = (seen[0], seen[seen.len() - 1]);
        assert!(far.at[1] < near.at[1] && far.size > 2 * near.size, "{far:?} {near:?}");
        // From straight above a pixel is as large as the height of the view by their number.
        let lens = crate::scene::Lens::Orthographic { height: 4.0 };
        let above = Camera::look_at("above", [0.0, 9.0, 0.0], [0.0; 3], [0.0, 0.0, -1.0], lens).unwrap();
        let found = footprints(&floor, &above, 32, 64);
        assert!(found.iter().all(|f| f.is_some_and(|f| f.size.abs_diff(2 << PART) <= 1)), "{found:?}");
    }
}

//! The axes of the paper's table: directions and distances of its texels' centres, as integers.
//!
//! Made on the host, by the pinned `libm`, so that every machine is given the same.

use std::f64::consts::{SQRT_2, TAU};

use glam::IVec4;

/// What an integer of the axes is the unit of: 2^14.
pub const AXIS: f64 = 16_384.0;

/// For every i below 2^k: cosine and sine of the centre of angle i, and the distance at the centre of distance i over
/// the square of half side 2^h, all by [`AXIS`] and rounded.
pub fn axes(h: u32, k: u32) -> Vec<IVec4> {
    let count = f64::from(1u32 << k);
    let corner = SQRT_2 * f64::from(1u32 << h) * AXIS;
    let axis = |i: u32| {
        let centre = (f64::from(i) + 0.5) / count;
        let [x, y] = [libm::cos(TAU * centre), libm::sin(TAU * centre)].map(|part| (part * AXIS).round() as i32);
        IVec4::new(x, y, (corner * (2.0 * centre - 1.0)).round() as i32, 0)
    };
    (0..1 << k).map(axis).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opposite_angles_and_distances_are_negated() {
        let axes = axes(10, 6);
        assert_eq!(axes.len(), 64);
        for (i, axis) in axes.iter().enumerate() {
            assert_eq!(axes[(i + 32) % 64].truncate().truncate(), -axis.truncate().truncate(), "angle {i}");
            assert_eq!(axes[63 - i].z, -axis.z, "distance {i}");
            let length = f64::from(axis.x * axis.x + axis.y * axis.y).sqrt();
            assert!((length - AXIS).abs() < 1.0, "angle {i}: {length}");
        }
        assert!(f64::from(axes[63].z) < AXIS * SQRT_2 * 1024.0);
    }
}

//! Which directions light comes from, and how much of the sphere each stands for.

use sightlines_kernels::light_sphere::{self, oracle::Direction};

/// A set of directions over the whole sphere, opposite ones next to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sphere {
    /// The subdivided octahedron: `2 + 4^(level + 1)` directions, each level a prefix of the next.
    Octahedron {
        /// 0 to 6.
        level: u32,
    },
    /// Pixel centres of HEALPix, all of one area: `12 * 4^order` directions. Orders do not refine each other.
    Healpix {
        /// 0 to 6.
        order: u32,
    },
}

/// How directions are weighed in a sum over them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighting {
    /// By solid angle, which makes the sum an integral over the sphere.
    SolidAngle,
    /// All the same, as in the paper.
    Equal,
}

impl Sphere {
    /// Finest level or order.
    pub const FINEST: u32 = light_sphere::MAX_LEVEL;

    /// Number of directions.
    pub fn count(self) -> u32 {
        match self {
            Sphere::Octahedron { level } => light_sphere::count(level),
            Sphere::Healpix { order } => 12 << (2 * order),
        }
    }

    /// The directions, as integer vectors of any length.
    pub fn directions(self) -> Vec<Direction> {
        match self {
            Sphere::Octahedron { level } => {
                light_sphere::directions(level).into_iter().map(|[x, y, z, _]| [x, y, z]).collect()
            }
            Sphere::Healpix { order } => light_sphere::healpix(order),
        }
    }

    /// Shares of the sphere in units of 2^-32.
    pub fn weights(self, weighting: Weighting) -> Vec<u32> {
        match (self, weighting) {
            (Sphere::Octahedron { level }, Weighting::SolidAngle) => light_sphere::weights(level),
            // Half a unit more or less does not matter to a sum of 16,386.
            _ => vec![((1_u64 << 32) / u64::from(self.count())) as u32; self.count() as usize],
        }
    }

    /// The spheres that are complete on the way to this one, coarsest first and itself last.
    pub fn refinements(self) -> Vec<Sphere> {
        match self {
            Sphere::Octahedron { level } => (0..=level).map(|level| Sphere::Octahedron { level }).collect(),
            Sphere::Healpix { .. } => vec![self],
        }
    }

    /// The finest of its refinements whose cost is within `budget`, or the coarsest, where each direction makes
    /// `visits` ([`Surface::visits`](super::Surface::visits)). The same numbers give the same level on every machine.
    pub fn within(self, budget: u64, visits: u64) -> Sphere {
        let refinements = self.refinements();
        let fits = |sphere: &&Sphere| u64::from(sphere.count()).saturating_mul(visits) <= budget;
        refinements.iter().rev().find(fits).copied().unwrap_or(refinements[0])
    }

    /// Mean angle between neighbours, in radians: that between centres of squares of the directions' area.
    pub fn spacing(self) -> f64 {
        (4.0 * std::f64::consts::PI / f64::from(self.count())).sqrt()
    }
}

impl std::fmt::Display for Sphere {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Sphere::Octahedron { level } => write!(f, "octahedron level {level}: {} directions", self.count()),
            Sphere::Healpix { order } => write!(f, "HEALPix order {order}: {} directions", self.count()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_directions_and_weights_agree() {
        for level in 0..=3 {
            for sphere in [Sphere::Octahedron { level }, Sphere::Healpix { order: level }] {
                let count = sphere.count() as usize;
                assert_eq!(sphere.directions().len(), count, "{sphere}");
                for weighting in [Weighting::SolidAngle, Weighting::Equal] {
                    let weights = sphere.weights(weighting);
                    let sum: u64 = weights.iter().map(|&w| u64::from(w)).sum();
                    assert_eq!(weights.len(), count, "{sphere}");
                    assert!(sum.abs_diff(1 << 32) <= count as u64, "{sphere}: {sum}");
                }
            }
        }
    }
}

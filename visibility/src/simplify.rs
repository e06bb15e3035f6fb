//! Coarser meshes for large lights: what a penumbra blurs need not be cast by every triangle.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 10, name simplification as the remedy
//! for meshes whose triangles are small beside the light. The work is that of the library meshoptimizer, behind the
//! feature `simplify`. It computes in the host's f32, so its meshes may differ between hosts: what a simplified scene
//! casts is exact for the mesh whose [`Simplified::hash`] is given, and for that one alone.

use crate::error::{Place, Result};
use crate::scene::Scene;
use crate::shadows::Rect;
use crate::vector::{Vector, cross, dot, length, sub};

/// How far to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// To this share of the triangles, above 0 and below 1.
    Ratio(f64),
    /// As far as the surface moves by at most so many scene units.
    Error(f64),
    /// As far as the light does not show it: by at most what [`tolerance`] says.
    Light,
}

impl Target {
    /// `auto`, a share as `0.25`, or a distance as `error=0.01`.
    ///
    /// # Errors
    ///
    /// Anything else.
    pub fn parse(text: &str) -> Result<Self> {
        let (number, make): (&str, fn(f64) -> Target) = match text.strip_prefix("error=") {
            _ if text == "auto" => return Ok(Target::Light),
            Some(rest) => (rest, Target::Error),
            None => (text, Target::Ratio),
        };
        let number = number.parse::<f64>().ok().filter(|x| x.is_finite() && *x > 0.0);
        match number.map(make) {
            Some(target) if !matches!(target, Target::Ratio(share) if share >= 1.0) => Ok(target),
            _ => {
                let remedy = "write `auto`, a share of the triangles as 0.25, or a distance as error=0.01";
                Err(Place::default().element("--simplify").error(format!("`{text}` is no target"), remedy))
            }
        }
    }
}

/// A scene of fewer triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Simplified {
    /// Its vertices are those of the scene that it was made from.
    pub scene: Scene,
    /// Triangles of that scene.
    pub before: usize,
    /// How far the surface has moved at most, in scene units, as the library estimates it.
    pub moved: f64,
    /// BLAKE3 of the corners of all triangles, as 72 bytes each, in hexadecimal.
    pub hash: String,
}

/// How far a surface may move so that `light` with `samples` samples does not show it: a shadow's edge is then the same
/// to within the distance of two samples. A caster at a distance d of the receiver's plane, which is h from the light,
/// that moves by e moves its backprojection by e h / d; d is that of the middle of the scene's box.
pub fn tolerance(scene: &Scene, light: &Rect, samples: u32, receiver: &Rect) -> f64 {
    let normal = cross(receiver.u, receiver.v);
    let height = |p: Vector| (dot(normal, sub(p, receiver.corner)) / length(normal)).abs();
    let apart = length(light.u).min(length(light.v)) / f64::from(samples).sqrt();
    apart * height(scene.bounds().centre) / height(light.corner)
}

/// Simplifies each part of a scene; `tolerance` is what [`Target::Light`] stands for.
///
/// # Errors
///
/// A program without the feature `simplify`, and parts of which nothing is left.
pub fn simplify(scene: &Scene, target: Target, tolerance: f64) -> Result<Simplified> {
    let (share, error) = match target {
        Target::Ratio(share) => (share, f64::INFINITY),
        Target::Error(error) => (0.0, error),
        Target::Light => (0.0, tolerance),
    };
    let (simplified, moved) = library::simplify(scene, share, error)?;
    if simplified.triangle_count() == 0 {
        let what = format!("nothing is left of {} triangles", scene.triangle_count());
        return Err(Place::default().element("--simplify").error(what, "choose a larger share or a smaller distance"));
    }
    let mut hasher = blake3::Hasher::new();
    for coordinate in simplified.triangles().as_flattened().as_flattened() {
        hasher.update(&coordinate.to_le_bytes());
    }
    let hash = hasher.finalize().to_hex().to_string();
    Ok(Simplified { before: scene.triangle_count(), scene: simplified, moved, hash })
}

#[cfg(feature = "simplify")]
mod library {
    use meshopt::SimplifyOptions;

    use crate::error::Result;
    use crate::scene::{Mesh, Scene};
    use crate::vector::{scale, sub};

    /// Parts of at most `share` of their triangles, or as few as move the surface by at most `error`; and by how much.
    pub(super) fn simplify(scene: &Scene, share: f64, error: f64) -> Result<(Scene, f64)> {
        let bounds = scene.bounds();
        // Points of a part in radii about the middle, where f32 holds them best.
        let point = |p: &[f64; 3]| scale(sub(*p, bounds.centre), 1.0 / bounds.radius).map(|c| c as f32);
        let limit = (error / bounds.radius).min(f64::from(f32::MAX)) as f32;
        let options = SimplifyOptions::ErrorAbsolute | SimplifyOptions::Prune;
        let mut moved = 0.0_f32;
        let mut parts = Vec::new();
        for part in &scene.parts {
            let points: Vec<[f32; 3]> = part.vertices.iter().map(point).collect();
            let least = 3 * (share * part.triangles.len() as f64).ceil() as usize;
            let mut by = 0.0;
            let kept =
                meshopt::simplify_decoder(part.triangles.as_flattened(), &points, least, limit, options, Some(&mut by));
            moved = moved.max(by);
            parts.push(Mesh { triangles: kept.as_chunks().0.to_vec(), uvs: Vec::new(), ..part.clone() });
        }
        Ok((Scene { parts, ..scene.clone() }, f64::from(moved) * bounds.radius))
    }
}

#[cfg(not(feature = "simplify"))]
mod library {
    use crate::error::{Place, Result};
    use crate::scene::Scene;

    pub(super) fn simplify(_: &Scene, _: f64, _: f64) -> Result<(Scene, f64)> {
        let remedy = "build it with `--features simplify`, which needs a C++ compiler, or leave the option out";
        Err(Place::default().element("--simplify").error("this program was built without simplification", remedy))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_read_and_nonsense_is_refused() {
        assert_eq!(Target::parse("auto").unwrap(), Target::Light);
        assert_eq!(Target::parse("0.25").unwrap(), Target::Ratio(0.25));
        assert_eq!(Target::parse("error=2").unwrap(), Target::Error(2.0));
        for bad in ["", "1", "0", "-0.5", "error=", "error=-1", "nan", "25%", "error=inf"] {
            let error = Target::parse(bad).unwrap_err().to_string();
            assert!(error.contains("no target") && error.contains("error=0.01"), "{bad}: {error}");
        }
    }
}

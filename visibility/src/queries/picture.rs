//! Pictures of what was culled: flat shading of a stage's triangles, in a colour for each instance.
//!
//! Clusters name the triangle of every pixel, so the raster needs nothing more. Invariant: of additions, products,
//! quotients and roots of f64 alone, so pictures are the same on every machine.

use sightlines_backend::Backend;
use sightlines_kernels::raster::NOTHING;

use super::{Granularity, Method, Stage, query};
use crate::error::Result;
use crate::scene::World;
use crate::scene::frame::Frame;
use crate::vector::{Vector, cross, dot, length, scale, sub};

/// Three bytes a pixel.
pub type Pixels = Vec<[u8; 3]>;

/// Where nothing is.
pub const BACKGROUND: [u8; 3] = [24, 24, 24];

/// Most clusters of a mesh, as a logarithm.
const CLUSTERS: u32 = 16;

/// Columns between pictures that stand side by side.
const GAP: u32 = 8;

/// Draws some instances, each triangle in the colour that `paint` has for its instance and its number, shaded by its
/// slope towards the eye. Of a mesh of more than 65,536 triangles neighbours have one slope.
///
/// # Errors
///
/// Those of a query.
pub fn shaded(
    backend: &dyn Backend,
    world: &World,
    frame: Frame,
    (instances, eye): (&[usize], Vector),
    paint: impl Fn(usize, usize) -> [u8; 3],
) -> Result<Pixels> {
    let most = world.meshes.iter().map(|mesh| mesh.triangles.len()).max().unwrap_or(0).max(1) as u32;
    let shift = (u32::BITS - (most - 1).leading_zeros()).saturating_sub(CLUSTERS);
    let stage = Stage::new(world, frame, instances, Granularity::Clusters { shift })?;
    let shown = query(backend, &stage, Method::HIB, 0, &mut |_| ())?.shown;
    let colour = |item: &u32| {
        let Some(item) = stage.items.get(*item as usize).filter(|_| *item != NOTHING) else { return BACKGROUND };
        let triangle = (item.cluster as usize) << shift;
        let light = slope(world, item.instance, triangle, eye);
        paint(item.instance, triangle).map(|part| (f64::from(part) * (0.3 + 0.7 * light)) as u8)
    };
    Ok(shown.iter().map(colour).collect())
}

/// How much a triangle faces the eye, from 0 to 1.
fn slope(world: &World, instance: usize, triangle: usize, eye: Vector) -> f64 {
    let instance = &world.instances[instance];
    let mesh = &world.meshes[instance.mesh];
    let [a, b, c] = mesh.triangles[triangle].map(|i| instance.transform.apply(mesh.vertices[i as usize]));
    let (normal, way) = (cross(sub(b, a), sub(c, a)), sub(eye, a));
    let lengths = length(normal) * length(way);
    if lengths > 0.0 { (dot(scale(normal, 1.0 / lengths), way)).abs().min(1.0) } else { 0.0 }
}

/// Pictures of one size side by side: columns, rows and bytes.
pub fn beside(size: [u32; 2], pictures: &[Pixels]) -> ([u32; 2], Vec<u8>) {
    let [width, height] = size.map(|side| side as usize);
    let mut bytes = Vec::new();
    for row in 0..height {
        for (number, picture) in pictures.iter().enumerate() {
            let gap = if number == 0 { 0 } else { GAP as usize };
            bytes.resize(bytes.len() + 3 * gap, u8::MAX);
            bytes.extend(picture[row * width..(row + 1) * width].iter().flatten());
        }
    }
    let count = pictures.len() as u32;
    ([count * size[0] + count.saturating_sub(1) * GAP, size[1]], bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_stand_side_by_side() {
        let ([width, height], bytes) = beside([1, 2], &[vec![[1; 3], [2; 3]], vec![[3; 3], [4; 3]]]);
        assert_eq!((width, height, bytes.len()), (10, 2, 60));
        assert_eq!([bytes[0], bytes[3], bytes[26], bytes[27], bytes[30], bytes[57]], [1, 255, 255, 3, 2, 4]);
    }
}

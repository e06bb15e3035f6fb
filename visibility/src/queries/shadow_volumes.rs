//! Shadow-volume culling: instances without a lit pixel from the light cast no shadow of their own, and are not
//! extruded.
//!
//! Engelhardt and Dachsbacher, section 4.1 and table 1. The light's view is drawn and counted once; casters that are
//! counted keep their volumes. What is lost is nothing at the resolution of that view: an instance that shows no pixel
//! has the least depth at none, so the light's depth buffer of the kept casters is that of all, bit for bit.

use std::collections::HashMap;

use crate::scene::{Affine, Instance, Mesh, World};
use crate::vector::{Vector, add, cross, dot, scale, sub};

/// The shadow volume of a closed mesh from a point light, in the coordinates of the scene: the triangles that face the
/// light, the same pushed away from it by `reach` times their distance, and a quadrilateral for each edge between a
/// triangle that faces it and one that does not, or none.
pub fn extrude(mesh: &Mesh, to_scene: &Affine, light: [f64; 3], reach: f64) -> Mesh {
    let points: Vec<Vector> = mesh.vertices.iter().map(|v| to_scene.apply(*v)).collect();
    let far = points.iter().map(|p| add(*p, scale(sub(*p, light), reach)));
    let count = points.len() as u32;
    let faces = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        dot(cross(sub(b, a), sub(c, a)), sub(light, a)) > 0.0
    };
    let lit: Vec<[u32; 3]> = mesh.triangles.iter().copied().filter(faces).collect();
    let edges = lit.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let mut silhouette: HashMap<(u32, u32), u32> = HashMap::new();
    edges.clone().for_each(|edge| *silhouette.entry(edge).or_default() += 1);
    let mut volume = Mesh { name: mesh.name.clone(), ..Mesh::default() };
    for &[a, b, c] in &lit {
        volume.triangles.extend([[a, b, c], [c + count, b + count, a + count]]);
    }
    for (a, b) in edges.filter(|(a, b)| !silhouette.contains_key(&(*b, *a))) {
        volume.triangles.extend([[b, a, a + count], [b, a + count, b + count]]);
    }
    volume.vertices = points.iter().copied().chain(far).collect();
    volume
}

/// The volumes of some instances as one mesh of one instance.
pub fn volumes(world: &World, casters: &[usize], light: [f64; 3], reach: f64) -> World {
    let mut all = Mesh { name: "shadow volumes".to_owned(), ..Mesh::default() };
    for caster in casters {
        let Instance { mesh, transform, .. } = &world.instances[*caster];
        let volume = extrude(&world.meshes[*mesh], transform, light, reach);
        let first = all.vertices.len() as u32;
        all.vertices.extend(volume.vertices);
        all.triangles.extend(volume.triangles.iter().map(|t| t.map(|i| first + i)));
    }
    let instance = Instance { name: all.name.clone(), mesh: 0, transform: Affine::IDENTITY };
    World { name: all.name.clone(), meshes: vec![all], instances: vec![instance], ..world.clone() }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use super::*;
    use crate::scene::crowd;

    #[test]
    fn a_volume_is_closed_and_of_two_caps_and_a_band() {
        let world = crowd(1);
        let volume = extrude(&world.meshes[1], &world.instances[1].transform, [30.0, 20.0, 5.0], 2.0);
        let edges = volume.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let mut count: HashMap<(u32, u32), i32> = HashMap::new();
        edges.for_each(|edge| *count.entry(edge).or_default() += 1);
        assert!(count.iter().all(|(&(a, b), n)| count.get(&(b, a)) == Some(n)), "every edge is met from both sides");
        let [caps, all] =
            [volume.triangles.iter().filter(|t| t.iter().all(|i| *i < 305)).count(), volume.triangles.len()];
        assert!((250..350).contains(&caps) && all > 2 * caps + 20 && all < 2 * caps + 400, "{caps} of {all}");
    }
}

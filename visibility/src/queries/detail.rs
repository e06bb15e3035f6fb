//! Level of detail by what is seen: an instance that shows few pixels is drawn with few triangles, one that shows none
//! not at all.
//!
//! Engelhardt and Dachsbacher, section 5. Counts of one frame choose the levels of the next.

use super::Answer;
use crate::scene::World;

/// A coarser mesh for instances that show few pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Level {
    /// The mesh that is drawn, by its place in the world.
    pub mesh: usize,
    /// Least pixels that an instance must show for it.
    pub pixels: u32,
}

/// The world in which every counted instance of mesh `finest` has the first of `levels`, ordered from fine to coarse,
/// whose pixels it shows; instances of no level are left out. Other instances stay. The answer has the places of its
/// instances in the world before.
pub fn choose(world: &World, answer: &Answer, finest: usize, levels: &[Level]) -> (World, Vec<usize>) {
    let mut shown = vec![0_u32; world.instances.len()];
    answer.items.iter().zip(&answer.totals).for_each(|(item, pixels)| shown[item.instance] += pixels);
    let mut chosen = World { instances: Vec::new(), ..world.clone() };
    let mut places = Vec::new();
    for (place, instance) in world.instances.iter().enumerate() {
        let mesh = match instance.mesh == finest {
            true => levels.iter().find(|level| shown[place] >= level.pixels.max(1)).map(|level| level.mesh),
            false => Some(instance.mesh),
        };
        if let Some(mesh) = mesh {
            chosen.instances.push(crate::scene::Instance { mesh, ..instance.clone() });
            places.push(place);
        }
    }
    (chosen, places)
}

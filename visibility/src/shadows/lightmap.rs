//! Lightmaps: receivers at the texels that a mesh's texture coordinates cover, and gutters around what they show.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 11, names lightmaps as a use of
//! hidden-sample maps. A texel belongs to the triangle whose texture coordinates hold its centre, ties by the top-left
//! rule, so charts that share an edge share no texel; a texel held twice is an error that names both triangles. The
//! receiver stands where the texel's centre is on its triangle, moved along the triangle's normal by [`BIAS`] cells of
//! the grid, before it is rounded.
//!
//! The bias is what keeps a flat surface from hiding from itself: vertices and receivers are rounded by at most √3/2
//! cells, so a receiver is more than BIAS − √3 > 0 cells in front of the rounded surface around it, and a segment to a
//! sample that is no nearer to that surface does not come back to it. What the rounded scene hides from the moved
//! receiver is the definition.

use crate::error::{Place, Result};
use crate::scene::{Scene, UNMAPPED};
use crate::vector::{Vector, add, cross, length, normalize, scale, sub};

use super::surface::Spot;

/// How far receivers stand in front of their triangles, in cells of the grid.
pub const BIAS: f64 = 2.0;

/// Parts of a texel in which texture coordinates are rounded.
const PARTS: f64 = 256.0;

/// The textured triangles of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Atlas {
    triangles: Vec<Textured>,
}

/// A triangle with its corners in space and on the map.
#[derive(Clone, Debug, PartialEq)]
struct Textured {
    name: String,
    corners: [Vector; 3],
    map: [[f64; 2]; 3],
}

impl Atlas {
    /// All triangles of a scene that have an area.
    ///
    /// # Errors
    ///
    /// A part without texture coordinates, and coordinates outside [0, 1], by part and triangle.
    pub fn new(scene: &Scene) -> Result<Self> {
        let mut triangles = Vec::new();
        for part in &scene.parts {
            let place = |index: usize| {
                Place::default().element(format!("{}: part `{}`, triangle {}", scene.name, part.name, index + 1))
            };
            let bare = part.uvs.iter().position(|map| *map == UNMAPPED);
            if let Some(index) = if part.uvs.is_empty() { Some(0) } else { bare } {
                let remedy = "unwrap the mesh into charts without overlaps, and export it again";
                return Err(place(index).error("it has no texture coordinates", remedy));
            }
            for (index, (triangle, map)) in part.triangles.iter().zip(&part.uvs).enumerate() {
                if let Some(bad) = map.iter().find(|uv| !uv.iter().all(|x| (0.0..=1.0).contains(x))) {
                    let what = format!("the texture coordinates {bad:?} are outside the map");
                    return Err(place(index).error(what, "scale the charts into [0, 1], without repeats"));
                }
                let corners = triangle.map(|vertex| part.vertices[vertex as usize]);
                let [a, b, c] = corners;
                if length(cross(sub(b, a), sub(c, a))) > 0.0 {
                    let name = format!("part `{}`, triangle {}", part.name, index + 1);
                    triangles.push(Textured { name, corners, map: *map });
                }
            }
        }
        Ok(Atlas { triangles })
    }

    /// A receiver for each texel that a triangle holds; v counts upwards, rows downwards.
    pub(super) fn spots(&self, resolution: u32) -> Result<Vec<Option<Spot>>> {
        let mut spots = vec![None; resolution as usize * resolution as usize];
        let mut owner = vec![0u32; spots.len()];
        for (index, triangle) in (0..).zip(&self.triangles) {
            for (texel, spot) in triangle.texels(resolution) {
                if spots[texel].is_some() {
                    let (column, row) = (texel as u32 % resolution, texel as u32 / resolution);
                    let first = &self.triangles[owner[texel] as usize].name;
                    let what = format!("it covers texel ({column}, {row}) of the map, which {first} covers too");
                    let remedy = "unwrap the mesh without overlaps, or raise the resolution if the charts only touch";
                    return Err(Place::default().element(&triangle.name).error(what, remedy));
                }
                spots[texel] = Some(spot);
                owner[texel] = index;
            }
        }
        Ok(spots)
    }
}

impl Textured {
    /// The texels whose centres it holds, and its points there.
    fn texels(&self, resolution: u32) -> Vec<(usize, Spot)> {
        let size = i64::from(resolution);
        let whole = |x: f64| (x * f64::from(resolution) * PARTS).round() as i64;
        let mut corners = [0, 1, 2].map(|i| (self.map[i].map(whole), self.corners[i]));
        corners.iter_mut().for_each(|(map, _)| map[1] = size * PARTS as i64 - map[1]);
        let [a, b, c] = self.corners;
        let normal = normalize(cross(sub(b, a), sub(c, a)));
        let area = edge(corners[0].0, corners[1].0, corners[2].0);
        if area == 0 {
            return Vec::new();
        }
        if area < 0 {
            corners.swap(1, 2);
        }
        let [a, b, c] = corners.map(|(map, _)| map);
        let range = |axis: usize| {
            let all = [a[axis], b[axis], c[axis]];
            let low = all.into_iter().min().unwrap_or(0) / PARTS as i64;
            let high = all.into_iter().max().unwrap_or(0) / PARTS as i64;
            low.max(0)..(high + 1).min(size)
        };
        let mut found = Vec::new();
        for row in range(1) {
            for column in range(0) {
                let centre = [column, row].map(|i| i * PARTS as i64 + PARTS as i64 / 2);
                let weights = [edge(b, c, centre), edge(c, a, centre), edge(a, b, centre)];
                let owns =
                    [(b, c), (c, a), (a, b)].iter().zip(weights).all(|(&(p, q), w)| w > 0 || w == 0 && top_left(p, q));
                if owns {
                    let part = |i: usize| scale(corners[i].1, weights[i] as f64 / area.abs() as f64);
                    let at = add(part(0), add(part(1), part(2)));
                    found.push(((row * size + column) as usize, Spot { at, normal }));
                }
            }
        }
        found
    }
}

/// Twice the area of a triangle of the map, positive where it turns as its corners do.
fn edge(a: [i64; 2], b: [i64; 2], p: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

/// Whether what lies on an edge belongs to the triangle on its inner side: of two that share the edge, one.
fn top_left(a: [i64; 2], b: [i64; 2]) -> bool {
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    y < 0 || y == 0 && x > 0
}

/// Fills texels without a value that touch ones with one, `rounds` times: the mean of those among their eight
/// neighbours.
pub fn dilate<const N: usize>(side: usize, values: &mut [Option<[f64; N]>], rounds: u32) {
    for _ in 0..rounds {
        let before = values.to_vec();
        for (index, value) in values.iter_mut().enumerate().filter(|(_, value)| value.is_none()) {
            let (x, y) = (index % side, index / side);
            let near = (y.saturating_sub(1)..(y + 2).min(side))
                .flat_map(|row| (x.saturating_sub(1)..(x + 2).min(side)).map(move |column| row * side + column));
            let near: Vec<[f64; N]> = near.filter_map(|at| before[at]).collect();
            if !near.is_empty() {
                *value = Some(std::array::from_fn(|i| near.iter().map(|n| n[i]).sum::<f64>() / near.len() as f64));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Mesh;

    /// A square of 2 by 2 in two triangles, over the part of the map between two corners.
    fn square(name: &str, from: [f64; 2], to: [f64; 2]) -> Mesh {
        let map = [[from[0], from[1]], [to[0], from[1]], [to[0], to[1]], [from[0], to[1]]];
        Mesh {
            name: name.to_owned(),
            vertices: vec![[0.0, 0.0, 2.0], [2.0, 0.0, 2.0], [2.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            uvs: vec![[map[0], map[1], map[2]], [map[0], map[2], map[3]]],
            ..Mesh::default()
        }
    }

    fn atlas(parts: Vec<Mesh>) -> Result<Atlas> {
        Atlas::new(&Scene { name: "test".to_owned(), units: "metres", parts })
    }

    #[test]
    fn texels_lie_on_the_surface_once() {
        let spots = atlas(vec![square("a", [0.0, 0.0], [1.0, 0.5])]).unwrap().spots(4).unwrap();
        assert!(spots[..8].iter().all(Option::is_none), "v counts upwards");
        assert_eq!(spots[8].unwrap(), Spot { at: [0.25, 0.0, 0.5], normal: [0.0, 1.0, 0.0] });
        assert_eq!(spots[15].unwrap().at, [1.75, 0.0, 1.5]);
    }

    #[test]
    fn charts_that_overlap_or_are_missing_are_named() {
        let touching = vec![square("a", [0.0, 0.0], [0.5, 1.0]), square("b", [0.5, 0.0], [1.0, 1.0])];
        assert_eq!(atlas(touching).unwrap().spots(5).unwrap().iter().flatten().count(), 25);
        let overlapping = vec![square("a", [0.0, 0.0], [0.6, 1.0]), square("b", [0.4, 0.0], [1.0, 1.0])];
        let error = atlas(overlapping).unwrap().spots(8).unwrap_err().to_string();
        assert!(error.contains("part `b`, triangle") && error.contains("part `a`, triangle 1"), "{error}");
        let bare = Mesh { uvs: vec![], ..square("bare", [0.0; 2], [1.0; 2]) };
        assert!(atlas(vec![bare]).unwrap_err().to_string().contains("part `bare`, triangle 1: it has no texture"));
        assert!(atlas(vec![square("out", [0.0; 2], [1.5; 2])]).unwrap_err().to_string().contains("1.5"));
    }

    #[test]
    fn gutters_take_the_mean_of_their_neighbours() {
        let mut values = vec![None; 16];
        (values[5], values[6]) = (Some([2.0]), Some([4.0]));
        dilate(4, &mut values, 1);
        assert_eq!((values[0], values[1], values[2], values[15]), (Some([2.0]), Some([3.0]), Some([3.0]), None));
        dilate(4, &mut values, 1);
        assert!(values.iter().all(Option::is_some));
    }
}

//! The definition of `docs/numerics.md`, "The raster", step by step in 128-bit integers: every triangle asks every
//! pixel.

use glam::IVec4;

use super::{FAR, Faces, Ids, NOTHING, Picture, View};

/// A vertex on the screen: x and y in 1/16 pixel, and its depth.
pub type Point = [i128; 3];

/// What is drawn: a mesh by value.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Vertices.
    pub vertices: Vec<[i32; 3]>,
    /// Triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Rows of X, Y, Z and W for each instance.
    pub instances: Vec<[IVec4; 4]>,
    /// Which sides are drawn.
    pub faces: Faces,
    /// Ids of its items.
    pub ids: Ids,
}

/// Step 1: clip coordinates.
fn clip(rows: &[IVec4; 4], v: [i32; 3]) -> [i128; 4] {
    rows.map(|row| {
        let product: i128 = (0..3).map(|i| i128::from(row[i]) * i128::from(v[i])).sum();
        (product.div_euclid(1 << 16) + i128::from(row.w)).clamp(-(1 << 25), 1 << 25)
    })
}

/// Step 2: what of a triangle is in front of the near plane.
fn in_front(triangle: [[i128; 4]; 3]) -> Vec<[[i128; 4]; 3]> {
    let cut = |a: [i128; 4], b: [i128; 4]| {
        let mut point = [0, 1, 2, 3].map(|i| a[i] + ((b[i] - a[i]) * a[2]).div_euclid(a[2] - b[2]));
        point[2] = 0;
        point
    };
    let is_front = |p: &[i128; 4]| p[2] >= 0;
    let turned = |first: usize| [0, 1, 2].map(|i| triangle[(first + i) % 3]);
    match triangle.each_ref().map(is_front) {
        [true, true, true] => vec![triangle],
        [false, false, false] => Vec::new(),
        front if front.iter().filter(|f| **f).count() == 1 => {
            let [a, b, c] = turned(front.iter().position(|f| *f).unwrap_or(0));
            vec![[a, cut(a, b), cut(a, c)]]
        }
        front => {
            let [a, b, c] = turned(front.iter().position(|f| !*f).unwrap_or(0) + 1);
            vec![[a, b, cut(b, c)], [a, cut(b, c), cut(a, c)]]
        }
    }
}

/// Step 3: screen coordinates and depth.
fn on_screen(view: View, [x, y, z, w]: [i128; 4]) -> Point {
    let w = w.max(i128::from(view.near));
    let round = |n: i128| (2 * n + w).div_euclid(2 * w);
    let (width, height) = (i128::from(view.picture.width), i128::from(view.picture.height));
    let depth = ((z << 24) / w).min((1 << 24) - 1);
    [8 * width + round(8 * width * x), 8 * height + round(-8 * height * y), depth]
}

/// Steps 1 to 3: the triangles on the screen that are drawn of one.
pub fn project(view: View, rows: &[IVec4; 4], triangle: [[i32; 3]; 3]) -> Vec<[Point; 3]> {
    let drawn = in_front(triangle.map(|v| clip(rows, v)));
    drawn.into_iter().map(|t| t.map(|p| on_screen(view, p))).collect()
}

fn cross(a: Point, b: Point, p: [i128; 2]) -> i128 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

/// Steps 4 and 5: the depth of pixel (x, y) of a triangle, if it covers it.
pub fn depth_at([a, b, c]: [Point; 3], faces: Faces, [x, y]: [u32; 2]) -> Option<u32> {
    let area = cross(a, b, [c[0], c[1]]);
    let side = if area > 0 { 1 } else { 2 };
    if area == 0 || faces as u32 & side == 0 {
        return None;
    }
    let (b, c) = if area > 0 { (b, c) } else { (c, b) };
    let centre = [16 * i128::from(x) + 8, 16 * i128::from(y) + 8];
    let mut sum = 0;
    for (from, to, opposite) in [(a, b, c), (b, c, a), (c, a, b)] {
        let weight = cross(from, to, centre);
        let is_left = to[1] < from[1];
        let is_top = to[1] == from[1] && to[0] > from[0];
        if weight < 0 || weight == 0 && !(is_left || is_top) {
            return None;
        }
        sum += weight * opposite[2];
    }
    Some((sum / area.abs()) as u32)
}

/// Every pixel of the box of a triangle, in the picture.
fn box_of(picture: Picture, triangle: [Point; 3]) -> impl Iterator<Item = [u32; 2]> {
    let range = |axis: usize, side: u32| {
        let side = i128::from(side);
        let low = triangle.iter().map(|p| p[axis]).min().unwrap_or(0).div_euclid(16).clamp(0, side);
        let high = triangle.iter().map(|p| p[axis]).max().unwrap_or(0).div_euclid(16).clamp(-1, side - 1);
        low as u32..(high + 1) as u32
    };
    let columns = range(0, picture.width);
    range(1, picture.height).flat_map(move |y| columns.clone().map(move |x| [x, y]))
}

/// Step 6: the depth and item buffers of several meshes. Large pictures ask only the pixels of a triangle's box.
pub fn pictures(view: View, scenes: &[Scene]) -> [Vec<u32>; 2] {
    let Picture { width, height } = view.picture;
    let mut depths = vec![FAR; (width * height) as usize];
    let mut items = vec![NOTHING; depths.len()];
    let every = depths.len() <= 4096;
    for scene in scenes {
        for (instance, rows) in (0_u32..).zip(&scene.instances) {
            for (number, triangle) in (0_u32..).zip(&scene.triangles) {
                let Some(corners) = vertices_of(scene, triangle) else { continue };
                let Ids { base, step, shift } = scene.ids;
                let id = base.wrapping_add(instance.wrapping_mul(step)).wrapping_add(number >> shift);
                for drawn in project(view, rows, corners) {
                    let mut ask = |[x, y]: [u32; 2]| {
                        let Some(depth) = depth_at(drawn, scene.faces, [x, y]) else { return };
                        let place = (y * width + x) as usize;
                        let nearest = (depths[place], items[place]).min((depth, id));
                        (depths[place], items[place]) = nearest;
                    };
                    match every {
                        true => (0..height).flat_map(|y| (0..width).map(move |x| [x, y])).for_each(&mut ask),
                        false => box_of(view.picture, drawn).for_each(&mut ask),
                    }
                }
            }
        }
    }
    [depths, items]
}

fn vertices_of(scene: &Scene, triangle: &[u32; 3]) -> Option<[[i32; 3]; 3]> {
    let [a, b, c] = triangle.map(|v| scene.vertices.get(v as usize).copied());
    Some([a?, b?, c?])
}

/// The vertices of all instances that are seen against `depths`, one bit each.
pub fn seen(view: View, scene: &Scene, depths: &[u32], bias: u32) -> Vec<u32> {
    let Picture { width, height } = view.picture;
    let count = scene.vertices.len() * scene.instances.len();
    let mut words = vec![0; count.div_ceil(32)];
    let points = scene.instances.iter().flat_map(|rows| scene.vertices.iter().map(move |v| clip(rows, *v)));
    for (number, point) in points.enumerate() {
        let [x, y, z] = on_screen(view, point);
        let (x, y) = (x.div_euclid(16), y.div_euclid(16));
        let inside = (0..i128::from(width)).contains(&x) && (0..i128::from(height)).contains(&y);
        if point[2] >= 0 && inside {
            let depth = depths[(y * i128::from(width) + x) as usize];
            let is_seen = z <= i128::from(depth) + i128::from(bias);
            words[number / 32] |= u32::from(is_seen) << (number % 32);
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::meshes::{Family, flat};

    const SQUARE: Picture = Picture { width: 64, height: 64 };
    const VIEW: View = View { picture: SQUARE, near: 64 };

    fn pixels(picture: Picture) -> impl Iterator<Item = [u32; 2]> {
        (0..picture.height).flat_map(move |y| (0..picture.width).map(move |x| [x, y]))
    }

    /// The triangles of a family on the screen.
    fn triangles(family: Family, count: usize) -> Vec<[Point; 3]> {
        let scene = family.shape(count, SQUARE, 3).drawn(&[flat(SQUARE)]);
        let corners = scene.triangles.iter().map(|t| vertices_of(&scene, t).expect("they exist"));
        corners.flat_map(|corners| project(VIEW, &scene.instances[0], corners)).collect()
    }

    #[test]
    fn a_flat_placement_keeps_sub_pixels() {
        let rows = flat(SQUARE).rows;
        let points = [[-512, -512, 0], [17, -3, 1], [511, 100, 32_767]];
        let screen = project(VIEW, &rows, points);
        assert_eq!(screen, [[[0, 0, 0], [529, 509, 512], [1023, 612, 32_767 * 512]]]);
    }

    #[test]
    fn a_closed_fan_covers_every_pixel_of_its_outline_once() {
        for fan in triangles(Family::Fans, 400).chunks(10) {
            let ring: Vec<Point> = fan.iter().map(|t| t[1]).collect();
            // The outline cut into triangles at another point, a corner of it.
            let outline: Vec<[Point; 3]> = (1..9).map(|i| [ring[0], ring[i], ring[i + 1]]).collect();
            for pixel in pixels(SQUARE) {
                let of = |triangles: &[[Point; 3]]| {
                    triangles.iter().filter(|t| depth_at(**t, Faces::All, pixel).is_some()).count()
                };
                assert_eq!(of(fan), of(&outline), "{pixel:?}");
                assert!(of(fan) <= 1, "{pixel:?} is covered twice");
            }
        }
    }

    #[test]
    fn two_triangles_share_an_edge_without_a_gap() {
        for family in [Family::OnCentres, Family::Slivers, Family::Anywhere] {
            for [a, b, c] in triangles(family, 30) {
                // A point on the other side of the edge b c.
                let d = [b[0] + c[0] - a[0], b[1] + c[1] - a[1], a[2]];
                for pixel in pixels(SQUARE) {
                    let halves = [[a, b, c], [b, d, c]].map(|t| depth_at(t, Faces::All, pixel).is_some());
                    let other_halves = [[a, b, d], [a, d, c]].map(|t| depth_at(t, Faces::All, pixel).is_some());
                    let count = |halves: [bool; 2]| halves.iter().filter(|h| **h).count();
                    assert_eq!(count(halves), count(other_halves), "{family:?} {pixel:?}");
                    assert!(count(halves) <= 1, "{family:?} {pixel:?}");
                }
            }
        }
    }

    #[test]
    fn nothing_outside_its_box_is_covered() {
        for family in Family::ALL {
            for triangle in triangles(family, 24) {
                let inside: Vec<[u32; 2]> = box_of(SQUARE, triangle).collect();
                let outside = pixels(SQUARE).filter(|p| !inside.contains(p));
                assert_eq!(outside.filter(|p| depth_at(triangle, Faces::All, *p).is_some()).count(), 0, "{family:?}");
            }
        }
    }

    #[test]
    fn a_depth_lies_between_those_of_the_vertices_and_knows_no_order_of_them() {
        for family in Family::ALL {
            for [a, b, c] in triangles(family, 24) {
                let (least, most) = (a[2].min(b[2]).min(c[2]), a[2].max(b[2]).max(c[2]));
                for pixel in pixels(SQUARE) {
                    let depth = depth_at([a, b, c], Faces::All, pixel);
                    assert!(depth.is_none_or(|d| (least..=most).contains(&i128::from(d))), "{family:?}");
                    for turned in [[b, c, a], [c, a, b], [b, a, c]] {
                        assert_eq!(depth_at(turned, Faces::All, pixel), depth, "{family:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_cut_keeps_what_is_in_front() {
        let (a, b, c) = ([0, 0, 100, 100], [1000, 50, -100, 100], [-70, 30, -300, 90]);
        assert_eq!(in_front([a, b, c]), [[a, [500, 25, 0, 100], [-18, 7, 0, 97]]]);
        assert_eq!(in_front([b, c, a]), in_front([a, b, c]));
        let d = [40, 40, 100, 100];
        assert_eq!(in_front([d, b, a]), [[a, d, [520, 45, 0, 100]], [a, [520, 45, 0, 100], [500, 25, 0, 100]]]);
        assert_eq!(in_front([b, c, c]), [[[0; 4]; 3]; 0]);
    }
}

//! Tile lists for receivers anywhere: which triangles can come between a tile's receivers and the light.
//!
//! E. A. Haines and J. R. Wallace, "Shaft culling for efficient ray-cast radiosity" (1991): between the box of a tile's
//! receivers and the light's rectangle runs a shaft, and what lies outside one of its planes hides nothing there. Tiles
//! are found by halving the field, and each half is given what its parent's shaft let through. Of one-sided triangles
//! those go too whose fronts no sample sees, or whose backs are turned to no receiver. All in integers; a list that
//! holds too much changes no bit, and one that held too little would be seen by the tests against the definition.

use sightlines_kernels::field::{Field, Receiver};
use sightlines_kernels::grid::{Faces, Triangle};
use sightlines_kernels::tiles::Tiles;

/// Least and greatest coordinates.
type Box3 = [[i32; 3]; 2];

/// The light's samples: least and greatest coordinates.
pub(super) type Extent = [[i32; 2]; 2];

/// What light may pass on its way from a rectangle at z = 0 to a box.
struct Shaft {
    receivers: Box3,
    light: Extent,
}

impl Shaft {
    /// Around the receivers of some rows and columns, and the light as it is shifted for them; none where there are
    /// none.
    fn new(field: &Field, columns: [u32; 2], rows: [u32; 2], light: Extent) -> Option<Self> {
        let all = (rows[0]..rows[1]).flat_map(|row| (columns[0]..columns[1]).map(move |column| [column, row]));
        let all = all.map(|[column, row]| field.receivers()[(row * field.columns() + column) as usize]);
        let mut found: Option<Shaft> = None;
        for Receiver { at, shift } in all.filter(Receiver::is_there) {
            let Shaft { receivers, light: lit } = found.get_or_insert(Shaft {
                receivers: [at, at],
                light: light.map(|corner| [corner[0] + shift[0], corner[1] + shift[1]]),
            });
            for axis in 0..3 {
                receivers[0][axis] = receivers[0][axis].min(at[axis]);
                receivers[1][axis] = receivers[1][axis].max(at[axis]);
            }
            for axis in 0..2 {
                lit[0][axis] = lit[0][axis].min(light[0][axis] + shift[axis]);
                lit[1][axis] = lit[1][axis].max(light[1][axis] + shift[axis]);
            }
        }
        found
    }

    /// Whether a triangle may hide any of the light from any of the receivers.
    fn may_hold(&self, triangle: &Triangle) -> bool {
        let [low, high] = self.receivers;
        let all = |outside: &dyn Fn(&[i32; 3]) -> bool| triangle.iter().all(outside);
        if all(&|p| p[2] >= high[2]) || all(&|p| p[2] <= 0) {
            return false;
        }
        (0..2).all(|axis| {
            let (from, to) = (self.light[0][axis], self.light[1][axis]);
            let beside = all(&|p| p[axis] < low[axis].min(from)) || all(&|p| p[axis] > high[axis].max(to));
            // The side plane through the light's edge rests on the box's nearer or farther edge.
            let near = if low[axis] < from { low[2] } else { high[2] };
            let far = if high[axis] > to { low[2] } else { high[2] };
            let under = |p: &[i32; 3]| side(p[axis] - from, p[2], low[axis] - from, near) < 0;
            let over = |p: &[i32; 3]| side(p[axis] - to, p[2], high[axis] - to, far) > 0;
            !(beside || all(&under) || all(&over))
        })
    }
}

/// Whether the front of a triangle may be between the light and some receiver of a shaft: it needs a sample before it,
/// and a receiver behind it. In 64 bits: a normal's components are below 2^31, differences below 2^16.
fn shows_front(triangle: &Triangle, shaft: &Shaft) -> bool {
    let [a, b, c] = triangle.map(|p| p.map(i64::from));
    let [d, e]: [[i64; 3]; 2] = [b, c].map(|p| std::array::from_fn(|k| p[k] - a[k]));
    let n = [d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]];
    let height = |axis: usize, x: i32| n[axis] * (i64::from(x) - a[axis]);
    let most = |axis: usize, [from, to]: [i32; 2]| height(axis, from).max(height(axis, to));
    let least = |axis: usize, [from, to]: [i32; 2]| height(axis, from).min(height(axis, to));
    let light = |axis: usize| [shaft.light[0][axis], shaft.light[1][axis]];
    let receivers = |axis: usize| [shaft.receivers[0][axis], shaft.receivers[1][axis]];
    most(0, light(0)) + most(1, light(1)) + height(2, 0) > 0
        && (0..3).map(|axis| least(axis, receivers(axis))).sum::<i64>() < 0
}

/// On which side of the line through (0, 0) and (x, z) the point (a, b) is: below 0 is towards smaller x.
fn side(a: i32, b: i32, x: i32, z: i32) -> i64 {
    i64::from(a) * i64::from(z) - i64::from(x) * i64::from(b)
}

/// The lists of all tiles of `size` receivers.
pub(super) fn tiles(size: [u32; 2], field: &Field, light: Extent, triangles: &[Triangle], faces: Faces) -> Tiles {
    let count = [field.columns().div_ceil(size[0]), field.rows().div_ceil(size[1])];
    let mut lists = vec![Vec::new(); (count[0] * count[1]) as usize];
    let all = (0..triangles.len() as u32).collect();
    split(&Halving { size, count, field, light, triangles, faces }, [0, count[0]], [0, count[1]], all, &mut lists);
    let mut starts = vec![0];
    starts.extend(lists.iter().scan(0, |sum, list| {
        *sum += list.len() as u32;
        Some(*sum)
    }));
    Tiles { size, count, starts, entries: lists.concat() }
}

/// Pairs of a triangle and a receiver that meet in the lists.
pub(super) fn pairs(tiles: &Tiles, field: &Field) -> u64 {
    let side = |index: u32, axis: usize, most: u32| {
        let first = index * tiles.size[axis];
        u64::from((first + tiles.size[axis]).min(most) - first)
    };
    let lists = (0..).zip(tiles.starts.windows(2));
    let pairs = lists.map(|(tile, list)| {
        let receivers = side(tile % tiles.count[0], 0, field.columns()) * side(tile / tiles.count[0], 1, field.rows());
        u64::from(list[1] - list[0]) * receivers
    });
    pairs.sum()
}

/// What is halved.
struct Halving<'a> {
    size: [u32; 2],
    count: [u32; 2],
    field: &'a Field,
    light: Extent,
    triangles: &'a [Triangle],
    faces: Faces,
}

/// Gives the tiles of some columns and rows those of `list` that their shafts may hold.
fn split(all: &Halving<'_>, columns: [u32; 2], rows: [u32; 2], mut list: Vec<u32>, lists: &mut [Vec<u32>]) {
    let receivers = |axis: usize, range: [u32; 2], most: u32| range.map(|tile| (tile * all.size[axis]).min(most));
    let across = receivers(0, columns, all.field.columns());
    let down = receivers(1, rows, all.field.rows());
    let Some(shaft) = Shaft::new(all.field, across, down, all.light) else { return };
    let faces = |triangle| all.faces == Faces::Both || shows_front(triangle, &shaft);
    list.retain(|number| {
        let triangle = &all.triangles[*number as usize];
        shaft.may_hold(triangle) && faces(triangle)
    });
    let [wide, high] = [columns[1] - columns[0], rows[1] - rows[0]];
    if list.is_empty() {
        return;
    }
    if wide == 1 && high == 1 {
        lists[(rows[0] * all.count[0] + columns[0]) as usize] = list;
    } else if wide >= high {
        let middle = columns[0] + wide / 2;
        split(all, [columns[0], middle], rows, list.clone(), lists);
        split(all, [middle, columns[1]], rows, list, lists);
    } else {
        let middle = rows[0] + high / 2;
        split(all, columns, [rows[0], middle], list.clone(), lists);
        split(all, columns, [middle, rows[1]], list, lists);
    }
}

#[cfg(test)]
mod tests {
    use sightlines_kernels::grid::{Receivers, Samples};
    use sightlines_kernels::pattern::Pattern;
    use sightlines_kernels::triangles::Family;

    use super::*;

    #[test]
    fn lists_hold_every_triangle_that_hides_and_far_fewer_than_all() {
        let samples = Samples { origin: [-700, -600], step: [90, 80], columns: 16, rows: 16 };
        let receivers = Receivers { origin: [-3000, -2500], step: [500, 450], height: 20_000, columns: 13, rows: 11 };
        let receiver = |r: u32| {
            let [x, y, z] = receivers.at(r);
            Receiver { at: [x, y, if r % 9 == 4 { 0 } else { z - 700 * (r as i32 % 7) }], shift: [r as i32 % 60, 9] }
        };
        let field = Field::new(13, (0..143).map(receiver).collect()).unwrap();
        let triangles: Vec<Triangle> =
            Family::ALL.iter().flat_map(|family| family.triangles(20, &samples, &receivers, 3)).collect();
        let pattern = Pattern::regular(&samples).unwrap();
        let mut entries = Vec::new();
        for faces in [Faces::Both, Faces::Front] {
            let lists = tiles([4, 4], &field, pattern.bounds(), &triangles, faces);
            for r in 0..143 {
                let list = lists.list(r % 13, r / 13).iter().map(|t| &triangles[*t as usize]);
                let all = field.hidden_set_by(faces, r, &pattern, &triangles);
                assert_eq!(field.hidden_set_by(faces, r, &pattern, list), all, "receiver {r}, {faces:?}");
            }
            entries.push(lists.entries.len());
        }
        let [both, front] = entries[..] else { panic!("{entries:?}") };
        assert!(both > 0 && both < 8 * triangles.len(), "{both} of {}", 12 * triangles.len());
        assert!(front > 0 && 3 * front < 2 * both, "{front} of {both}");
    }
}

//! Faces of closed surfaces that other faces make redundant.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 7: of a watertight caster those
//! triangles can go that face the light from all of its corners; the back faces that stay leave the smaller influence
//! regions. Invariant: the sets are the same, bit for bit (docs/numerics.md has the proof). It rests on two properties,
//! which are tested and never assumed: in a connected surface, welded by the points of the grid, every edge runs as
//! often one way as the other; and it stands in front of the light, in a box that holds no receiver.

use sightlines_kernels::field::{Field, Receiver};
use sightlines_kernels::grid::{Point, Triangle, XY};

/// What is left of a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Culled {
    /// The triangles that stay, in their order.
    pub kept: Vec<Triangle>,
    /// How many belong to closed surfaces.
    pub closed: u64,
    /// How many of those are left out.
    pub dropped: u64,
}

/// Least and greatest coordinates.
pub type Box3 = [Point; 2];

/// Leaves out the triangles of closed surfaces that face all of a light whose samples lie between `corners`. `is_clear`
/// says that no receiver is in a box.
pub fn cull(corners: &[Point; 4], is_clear: &dyn Fn(&Box3) -> bool, triangles: &[Triangle]) -> Culled {
    let mut surfaces = Surfaces::new(triangles);
    let mut turns = surfaces.turns(triangles);
    let boxes = surfaces.boxes(triangles);
    for (turn, extent) in turns.iter_mut().zip(&boxes) {
        turn.take_if(|_| extent.is_some_and(|extent| extent[0][2] <= 0 || !is_clear(&extent)));
    }
    let mut culled = Culled::default();
    for (number, triangle) in triangles.iter().enumerate() {
        let turn = turns[surfaces.of(number)];
        let drops = turn.is_some_and(|turn| corners.iter().all(|corner| turn * side(triangle, *corner) >= 0));
        culled.closed += u64::from(turn.is_some());
        culled.dropped += u64::from(drops);
        if !drops {
            culled.kept.push(*triangle);
        }
    }
    culled
}

/// Six times the signed volume of a triangle and a point: positive where the triangle turns counter-clockwise seen from
/// it.
fn side(triangle: &Triangle, from: Point) -> i64 {
    let [a, b, c] = triangle.map(|v| -> [i64; 3] { std::array::from_fn(|k| i64::from(v[k]) - i64::from(from[k])) });
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    -(a[0] * cross[0] + a[1] * cross[1] + a[2] * cross[2])
}

/// Triangles by the surface that they are connected to.
struct Surfaces {
    /// Welded corners of each triangle.
    corners: Vec<[u32; 3]>,
    /// Towards the root of each vertex' tree: one tree a surface.
    parents: Vec<u32>,
}

impl Surfaces {
    fn new(triangles: &[Triangle]) -> Self {
        let mut vertices = Numbers::with_room(triangles.len());
        let corners: Vec<[u32; 3]> = triangles.iter().map(|t| t.map(|p| vertices.of(packed(p)))).collect();
        let mut surfaces = Surfaces { parents: (0..vertices.count).collect(), corners: Vec::new() };
        for [a, b, c] in &corners {
            surfaces.join(*a, *b);
            surfaces.join(*a, *c);
        }
        surfaces.corners = corners;
        surfaces
    }

    fn root(&mut self, mut vertex: u32) -> u32 {
        while self.parents[vertex as usize] != vertex {
            let above = self.parents[self.parents[vertex as usize] as usize];
            self.parents[vertex as usize] = above;
            vertex = above;
        }
        vertex
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }

    /// The root of a triangle's surface.
    fn of(&mut self, triangle: usize) -> usize {
        self.root(self.corners[triangle][0]) as usize
    }

    /// The box of the surface at each root.
    fn boxes(&mut self, triangles: &[Triangle]) -> Vec<Option<Box3>> {
        let mut boxes = vec![None; self.parents.len()];
        for (number, triangle) in triangles.iter().enumerate() {
            let root = self.of(number);
            boxes[root] = triangle.iter().fold(boxes[root], |extent, point| grown(extent, *point));
        }
        boxes
    }

    /// For the root of each surface, which sign of [`side`] says that a face looks outwards; none where it is not
    /// closed.
    fn turns(&mut self, triangles: &[Triangle]) -> Vec<Option<i64>> {
        let mut edges = Numbers::with_room(2 * self.corners.len());
        let mut balances: Vec<(i32, u32)> = Vec::new();
        let mut volumes = vec![0_i128; self.parents.len()];
        for (number, triangle) in triangles.iter().enumerate() {
            let root = self.of(number);
            volumes[root] -= i128::from(side(triangle, [0; 3]));
            let [a, b, c] = self.corners[number];
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let edge = edges.of(u64::from(from.min(to)) << 32 | u64::from(from.max(to))) as usize;
                balances.resize(balances.len().max(edge + 1), (0, from));
                balances[edge].0 += (to > from) as i32 - (to < from) as i32;
            }
        }
        let mut turns: Vec<Option<i64>> =
            volumes.into_iter().map(|volume| Some(if volume < 0 { -1 } else { 1 })).collect();
        for (_, vertex) in balances.into_iter().filter(|(balance, _)| *balance != 0) {
            turns[self.root(vertex) as usize] = None;
        }
        turns
    }
}

/// The receivers of a field by squares of them.
pub struct Crowd<'a> {
    field: &'a Field,
    /// The box of each square that has a receiver, and its first column and row.
    squares: Vec<(Box3, [u32; 2])>,
}

/// Receivers along a side of a square.
const SQUARE: u32 = 16;

impl<'a> Crowd<'a> {
    /// Of all receivers of a field.
    pub fn new(field: &'a Field) -> Self {
        let mut crowd = Crowd { field, squares: Vec::new() };
        let corners = (0..field.rows())
            .step_by(SQUARE as usize)
            .flat_map(|row| (0..field.columns()).step_by(SQUARE as usize).map(move |column| [column, row]));
        let boxed = |corner| Some((crowd.square(corner).fold(None, grown)?, corner));
        crowd.squares = corners.filter_map(boxed).collect();
        crowd
    }

    /// The receivers of a square.
    fn square(&self, [column, row]: [u32; 2]) -> impl Iterator<Item = Point> {
        let [columns, rows] = [self.field.columns(), self.field.rows()];
        let rows = row..(row + SQUARE).min(rows);
        let all = rows.flat_map(move |row| {
            let first = row * columns;
            first + column..first + (column + SQUARE).min(columns)
        });
        let receivers = self.field.receivers();
        all.map(|at| receivers[at as usize]).filter(Receiver::is_there).map(|receiver| receiver.at)
    }

    /// Whether none of them is in a box.
    pub fn is_clear(&self, extent: &Box3) -> bool {
        let near = |square: &&(Box3, [u32; 2])| {
            (0..3).all(|i| square.0[0][i] <= extent[1][i] && square.0[1][i] >= extent[0][i])
        };
        let holds = |at: Point| (0..3).all(|i| (extent[0][i]..=extent[1][i]).contains(&at[i]));
        !self.squares.iter().filter(near).any(|(_, corner)| self.square(*corner).any(holds))
    }
}

/// A box with one more point in it.
fn grown(extent: Option<Box3>, point: Point) -> Option<Box3> {
    let [low, high] = extent.unwrap_or([point; 2]);
    Some([std::array::from_fn(|i| low[i].min(point[i])), std::array::from_fn(|i| high[i].max(point[i]))])
}

/// A point of the grid as one word.
fn packed([x, y, z]: Point) -> u64 {
    let [x, y, z] = [x + XY, y + XY, z].map(|c| u64::from(c as u32));
    x << 32 | y << 16 | z
}

/// Consecutive numbers for words, in the order in which they first come: open addressing.
struct Numbers {
    /// A word and its number, or `EMPTY`.
    slots: Vec<(u64, u32)>,
    count: u32,
}

const EMPTY: u32 = u32::MAX;

impl Numbers {
    fn with_room(words: usize) -> Self {
        Numbers { slots: vec![(0, EMPTY); (2 * words).next_power_of_two().max(16)], count: 0 }
    }

    fn of(&mut self, word: u64) -> u32 {
        if 4 * self.count as usize >= 3 * self.slots.len() {
            self.grow();
        }
        let slot = self.slot(word);
        if self.slots[slot].1 == EMPTY {
            self.slots[slot] = (word, self.count);
            self.count += 1;
        }
        self.slots[slot].1
    }

    /// Where a word stands, or would.
    fn slot(&self, word: u64) -> usize {
        let last = self.slots.len() - 1;
        let mut slot = (word.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 20) as usize & last;
        while self.slots[slot].1 != EMPTY && self.slots[slot].0 != word {
            slot = (slot + 1) & last;
        }
        slot
    }

    fn grow(&mut self) {
        let empty = vec![(0, EMPTY); 2 * self.slots.len()];
        for (word, number) in std::mem::replace(&mut self.slots, empty) {
            if number != EMPTY {
                let slot = self.slot(word);
                self.slots[slot] = (word, number);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use sightlines_kernels::grid::Samples;

    use super::*;

    const LIGHT: Samples = Samples { origin: [-40, -40], step: [10, 10], columns: 8, rows: 8 };

    /// A tetrahedron under the light, its apex towards it; its faces look outwards, so three of them face the light.
    fn tetrahedron(x: i32) -> [Triangle; 4] {
        let [a, b, c, d] = [[x - 90, -80, 900], [x + 90, -80, 900], [x, 80, 900], [x, 0, 800]];
        [[a, b, c], [a, d, b], [b, d, c], [c, d, a]]
    }

    fn counts(triangles: &[Triangle]) -> (usize, u64, u64) {
        let Culled { kept, closed, dropped } = cull(&LIGHT.corners(), &|_| true, triangles);
        (kept.len(), closed, dropped)
    }

    #[test]
    fn faces_towards_all_of_the_light_go_and_the_base_stays() {
        let faces = tetrahedron(0);
        let base: Vec<Triangle> = faces.iter().filter(|t| t.iter().all(|v| v[2] == 900)).copied().collect();
        assert_eq!(cull(&LIGHT.corners(), &|_| true, &faces), Culled { kept: base, closed: 4, dropped: 3 });
        // Which way the surface is wound does not matter.
        assert_eq!(counts(&faces.map(|[a, b, c]| [a, c, b])), (1, 4, 3));
    }

    #[test]
    fn surfaces_are_judged_one_by_one() {
        let mut open = tetrahedron(400).to_vec();
        open.pop();
        assert_eq!(counts(&open), (3, 0, 0));
        let both = [&open[..], &tetrahedron(0)].concat();
        assert_eq!(counts(&both), (4, 4, 3));
    }

    #[test]
    fn a_face_that_is_turned_or_doubled_opens_the_surface() {
        let mut turned = tetrahedron(0);
        turned[1].swap(0, 1);
        assert_eq!(counts(&turned), (4, 0, 0));
        let doubled = [&tetrahedron(0)[..], &tetrahedron(0)[..1]].concat();
        assert_eq!(counts(&doubled), (5, 0, 0));
        // Twice the whole surface is closed: every edge runs twice either way.
        assert_eq!(counts(&[tetrahedron(0), tetrahedron(0)].concat()), (2, 8, 6));
    }

    #[test]
    fn a_surface_stays_whole_that_a_receiver_may_stand_in_or_that_reaches_the_light() {
        let culled = |receivers: &[Point], triangles: &[Triangle]| {
            let field =
                Field::new(receivers.len() as u32, receivers.iter().map(|at| Receiver::new(*at)).collect()).unwrap();
            let crowd = Crowd::new(&field);
            let Culled { closed, dropped, .. } = cull(&LIGHT.corners(), &|extent| crowd.is_clear(extent), triangles);
            (closed, dropped)
        };
        let both = [tetrahedron(0), tetrahedron(200)].concat();
        let far = [[0; 3], [0, 0, 901], [91, 0, 900], [0, 81, 900], [500, 0, 799]];
        assert_eq!(culled(&far, &both), (8, 6));
        assert_eq!(
            culled(&[&[[0, 0, 0]; 60][..], &[[0, 0, 870]]].concat(), &both),
            (4, 3),
            "one inside, in a later square"
        );
        assert_eq!(culled(&[[-90, -80, 800], [290, 80, 900]], &both), (0, 0), "in the corners of the boxes");
        let low = both.iter().map(|t| t.map(|[x, y, z]| [x, y, z - 800])).collect::<Vec<_>>();
        assert_eq!(culled(&far, &low), (0, 0));
    }

    #[test]
    fn faces_that_rounding_has_flattened_to_a_line_or_a_point_change_nothing() {
        let [a, b, _] = tetrahedron(0)[0];
        let flat = [&tetrahedron(0)[..], &[[a, b, a], [a, a, a]]].concat();
        assert_eq!(counts(&flat), (1, 6, 5));
        assert_eq!(counts(&[[a, b, a]]), (0, 1, 1), "a triangle without area is closed, and hides nothing");
    }

    #[test]
    fn numbers_stay_as_the_table_grows() {
        let mut numbers = Numbers::with_room(0);
        let first: Vec<u32> = (0..1000).map(|word| numbers.of(word << 40)).collect();
        assert_eq!(first, (0..1000).collect::<Vec<u32>>());
        assert!((0..1000).all(|word| numbers.of(word << 40) == word as u32));
    }
}

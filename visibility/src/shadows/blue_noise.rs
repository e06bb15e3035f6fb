//! Blue noise: an order of the cells of a torus in which every prefix keeps its points apart.
//!
//! R. Ulichney, "The void-and-cluster method for dither array generation" (SPIE 1913, 1993), section 3: a binary
//! pattern is relaxed until its tightest cluster is its largest void, its points are then ranked by taking clusters
//! away, and the rest by filling voids. Energies are whole numbers, ties go to the lower cell, so that the order is one
//! and the same everywhere.

use std::sync::OnceLock;

use sightlines_kernels::random;

use super::placement::{Point, UNIT};

/// Cells a side.
const SIDE: usize = 64;
const CELLS: usize = SIDE * SIDE;
/// Points of the pattern that is relaxed.
const FIRST: usize = CELLS / 10;
/// The filter's reach: its weight beyond is below 2^-20.
const REACH: i32 = 9;

/// The first `count` points that are lit: of one tile, or of so many side by side that there are enough.
pub(super) fn points(count: u32, is_lit: &dyn Fn(Point) -> bool) -> Vec<Point> {
    static ORDER: OnceLock<Vec<usize>> = OnceLock::new();
    let order = ORDER.get_or_init(order);
    let mut found = Vec::new();
    for tiles in (0..5).map(|bits| 1u32 << bits) {
        let side = tiles * SIDE as u32;
        let place = |cell: u32| (2 * cell + 1) * (UNIT / 2) / side;
        let across = (0..tiles * tiles).map(|tile| [tile % tiles * SIDE as u32, tile / tiles * SIDE as u32]);
        let all = order.iter().flat_map(|cell| {
            let (x, y) = ((cell % SIDE) as u32, (cell / SIDE) as u32);
            across.clone().map(move |[left, top]| [place(left + x), place(top + y)])
        });
        found = all.filter(|p| is_lit(*p)).take(count as usize).collect();
        if found.len() == count as usize {
            break;
        }
    }
    found
}

/// A pattern and the energy that its points give every cell.
struct Torus {
    weights: Vec<u64>,
    energy: Vec<u64>,
    is_set: Vec<bool>,
}

impl Torus {
    fn new() -> Self {
        // exp(-d² / (2 · 1.5²)), in units of 2^-32.
        let weight = |d: i32| libm::exp(-f64::from(d) / 4.5) * 4_294_967_296.0;
        let across = -REACH..=REACH;
        let weights = across.clone().flat_map(|y| across.clone().map(move |x| weight(x * x + y * y) as u64)).collect();
        Torus { weights, energy: vec![0; CELLS], is_set: vec![false; CELLS] }
    }

    fn flip(&mut self, cell: usize) {
        self.is_set[cell] = !self.is_set[cell];
        let (x, y) = ((cell % SIDE) as i32, (cell / SIDE) as i32);
        let wrapped = |at: i32| at.rem_euclid(SIDE as i32) as usize;
        let mut weights = self.weights.iter();
        for dy in -REACH..=REACH {
            for (dx, weight) in (-REACH..=REACH).zip(weights.by_ref()) {
                let energy = &mut self.energy[wrapped(y + dy) * SIDE + wrapped(x + dx)];
                *energy = if self.is_set[cell] { *energy + weight } else { *energy - weight };
            }
        }
    }

    fn tightest(&self) -> usize {
        let set = (0..CELLS).filter(|cell| self.is_set[*cell]);
        set.max_by_key(|cell| (self.energy[*cell], CELLS - cell)).unwrap_or(0)
    }

    fn emptiest(&self) -> usize {
        let free = (0..CELLS).filter(|cell| !self.is_set[*cell]);
        free.min_by_key(|cell| (self.energy[*cell], *cell)).unwrap_or(0)
    }
}

/// All cells, each prefix as even as can be.
fn order() -> Vec<usize> {
    let mut torus = Torus::new();
    let mut seeds = (0..).map(|index| random::below(CELLS as u32, 5, index) as usize);
    let mut set = 0;
    while set < FIRST {
        let cell = seeds.next().unwrap_or(0);
        if !torus.is_set[cell] {
            torus.flip(cell);
            set += 1;
        }
    }
    // Each move lowers the pattern's energy; the bound is never met, and keeps the loop's end plain to see.
    for _ in 0..CELLS {
        let from = torus.tightest();
        torus.flip(from);
        let to = torus.emptiest();
        torus.flip(to);
        if from == to {
            break;
        }
    }
    let relaxed = torus.is_set.clone();
    let mut order = vec![0; CELLS];
    for rank in (0..FIRST).rev() {
        order[rank] = torus.tightest();
        torus.flip(order[rank]);
    }
    (0..CELLS).filter(|cell| relaxed[*cell]).for_each(|cell| torus.flip(cell));
    for place in order.iter_mut().skip(FIRST) {
        *place = torus.emptiest();
        torus.flip(*place);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_prefix_keeps_its_points_apart() {
        for count in [16, 64, 256, 1024] {
            let found = points(count, &|_| true);
            let mut sorted = found.clone();
            sorted.sort_unstable();
            sorted.dedup();
            assert_eq!(sorted.len(), count as usize);
            let apart = |a: Point, b: Point| {
                let across = |i: usize| a[i].abs_diff(b[i]).min(UNIT - a[i].abs_diff(b[i])) as f64 / f64::from(UNIT);
                (across(0) * across(0) + across(1) * across(1)).sqrt()
            };
            let pairs = || (0..found.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
            let least = pairs().map(|(i, j)| apart(found[i], found[j])).fold(1.0, f64::min);
            // A square grid of as many has 1; random points have about 0.01.
            let share = least * f64::from(count).sqrt();
            assert!(share >= 0.5, "{count} points come as close as {share} of a grid's distance");
        }
    }

    #[test]
    fn more_points_than_a_tile_has_come_from_several() {
        let found = points(5000, &|_| true);
        assert_eq!(found.len(), 5000);
        assert_eq!(points(40_000, &|p| p[0] < UNIT / 8).len(), 40_000);
        assert_eq!(points(40_000, &|p| p[0] < UNIT / 64).len(), 16_384, "16 × 16 tiles have no more there");
    }
}

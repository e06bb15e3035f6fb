//! No region at all, all in one tile, one over all tiles, several blocks and windows, tiles that are cut; then 200,000.

use sightlines_backend::{Case, Expected, Job, Size};

use super::{BLOCK, Grid, TileLists, oracle};
use crate::random;

/// 512² receivers in tiles as row spans have them.
const SQUARE: Grid = Grid { size: [16, 16], receivers: [512, 512] };

pub(super) fn all() -> Vec<Case> {
    let narrow = Grid { size: [16, 8], receivers: [40, 19] };
    // 130 rows of 9 tiles: two windows.
    let tall = Grid { size: [16, 8], receivers: [130, 1033] };
    // A window has 2 of the 5 rows.
    let wide = Grid { size: [16, 8], receivers: [8192, 40] };
    vec![
        case("no_region", Size::Small, narrow, 3, |_, _| [1, 0, 0, 5], &[0, 6]),
        case("one_receiver", Size::Small, Grid { receivers: [1, 1], ..narrow }, 1, |_, _| [0; 4], &[0, 1]),
        case("one_tile", Size::Small, narrow, 2 * BLOCK + 1, |_, _| [17, 30, 9, 15], &[0, 4, 5, 6]),
        case("all_tiles", Size::Small, tall, 65, |_, _| [0, 129, 0, 1032], &[0, 1, 1169, 1170]),
        case("tiles_cut", Size::Small, narrow, 300, |grid, i| scattered(grid, i, 12), &[1, 2, 6]),
        case("two_windows", Size::Small, tall, BLOCK + 77, |grid, i| scattered(grid, i, 60), &[1, 1023, 1024, 1170]),
        case("widest", Size::Small, wide, 200, |grid, i| scattered(grid, i, 400), &[1, 1024, 2560]),
        case("one_large_among_small", Size::Small, SQUARE, BLOCK, one_large, &[1, 512, 1024]),
        case("square_200000", Size::Real, SQUARE, 200_000, |grid, i| scattered(grid, i, 45), &[1, 512, 1024]),
    ]
}

/// A rectangle of up to `most` receivers a side anywhere; of each seven one is empty.
fn scattered(grid: &Grid, index: u32, most: u32) -> [i32; 4] {
    let side = |axis: usize| {
        let place = 4 * index + 2 * axis as u32;
        let first = random::below(grid.receivers[axis], 3, place);
        [first, (first + random::below(most, 3, place + 1)).min(grid.receivers[axis] - 1)].map(|at| at as i32)
    };
    let [[x0, x1], [y0, y1]] = [side(0), side(1)];
    if index % 7 == 2 { [x1 + 1, x0, y0, y1] } else { [x0, x1, y0, y1] }
}

fn one_large(grid: &Grid, index: u32) -> [i32; 4] {
    if index == 700 { [0, 511, 0, 511] } else { scattered(grid, index, 9) }
}

fn case(
    name: &str,
    size: Size,
    grid: Grid,
    triangles: u32,
    region: impl Fn(&Grid, u32) -> [i32; 4] + Clone + Send + Sync + 'static,
    probes: &[u32],
) -> Case {
    let regions = move || -> Vec<[i32; 4]> { (0..triangles).map(|index| region(&grid, index)).collect() };
    let given = regions.clone();
    let job = move || {
        let kernel = TileLists::new()?;
        let regions = given();
        let mut job = Job::new();
        let words = job.slice("regions", regions.as_flattened());
        let tallies = kernel.record_tally(&mut job, grid, words)?;
        // One word more shows that nothing is written past the last entry.
        let entries = job.zeroed("entries", oracle::lists(grid.size, grid.receivers, &regions).1.len() as u64 + 1);
        let starts = kernel.record(&mut job, grid, words, entries)?;
        job.read("starts", starts.id());
        job.read("entries", entries.id());
        job.read("tallies", tallies.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let regions = regions();
        let (starts, mut entries) = oracle::lists(grid.size, grid.receivers, &regions);
        entries.push(0);
        let tallies = regions.chunks(BLOCK as usize).flat_map(|block| oracle::tally(grid.size, block)).collect();
        vec![Expected::Whole(starts), Expected::Whole(entries), Expected::Whole(tallies)]
    };
    Case::new(name, size, job, expected).probes(probes.iter().copied())
}

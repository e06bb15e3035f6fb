//! Lists of triangles for tiles of receivers, and how a kernel works through them in launches of bounded length.
//!
//! A tile's receivers are served by the same workgroups, which take the tile's triangles one after the other.
//! Invariant: the launches together meet every receiver row with every entry of its tile exactly once, and there is at
//! least one for each row, so that empty lists too are shown to hide nothing.

use std::ops::Range;

use crate::grid::Receivers;

/// Lists of triangles, one for each tile of receivers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tiles {
    /// Receivers of a tile along x and y.
    pub size: [u32; 2],
    /// Tiles along x and y.
    pub count: [u32; 2],
    /// First entry of each tile, and one past the last entry.
    pub starts: Vec<u32>,
    /// Triangle numbers, ascending within a tile.
    pub entries: Vec<u32>,
}

impl Tiles {
    /// Sorts triangles into tiles by their regions (first and last column, first and last row, as
    /// [`crate::influence_region`] writes them).
    pub fn new(size: [u32; 2], receivers: &Receivers, regions: &[[i32; 4]]) -> Self {
        let count = [receivers.columns.div_ceil(size[0]), receivers.rows.div_ceil(size[1])];
        let tiles = |region| {
            let [columns, rows] = met(size, region);
            rows.flat_map(move |y| columns.clone().map(move |x| (y * count[0] + x) as usize))
        };
        let mut starts = vec![0u32; (count[0] * count[1]) as usize + 1];
        regions.iter().flat_map(|region| tiles(*region)).for_each(|tile| starts[tile + 1] += 1);
        (1..starts.len()).for_each(|tile| starts[tile] += starts[tile - 1]);
        let mut next = starts.clone();
        let mut entries = vec![0; starts[starts.len() - 1] as usize];
        for (triangle, region) in regions.iter().enumerate() {
            for tile in tiles(*region) {
                entries[next[tile] as usize] = triangle as u32;
                next[tile] += 1;
            }
        }
        Tiles { size, count, starts, entries }
    }

    /// Tiles that have one triangle each, in order: what each of them hides shows by itself.
    pub fn solo(size: [u32; 2], receivers: &Receivers) -> Self {
        let count = [receivers.columns.div_ceil(size[0]), receivers.rows.div_ceil(size[1])];
        let tiles = count[0] * count[1];
        Tiles { size, count, starts: (0..=tiles).collect(), entries: (0..tiles).collect() }
    }

    /// The triangles of the tile that holds receiver (x, y).
    pub fn list(&self, x: u32, y: u32) -> &[u32] {
        let tile = (y / self.size[1] * self.count[0] + x / self.size[0]) as usize;
        &self.entries[self.starts[tile] as usize..self.starts[tile + 1] as usize]
    }

    /// What one recording takes after the other: receiver rows in steps of `step`, until a row brings the entries that
    /// the workgroups meet to `pairs`, and at most `list` entries of a tile's list, so that no invocation's loops are
    /// long.
    pub fn launches(&self, rows: u32, step: u32, pairs: u64, list: u32) -> Vec<Launch> {
        let mut launches = Vec::new();
        let mut first = 0;
        while first < rows {
            let mut cost = 0;
            let mut longest = 1;
            let mut end = first;
            while end < rows && cost < pairs {
                let lists = self.row_lists(end / self.size[1]);
                longest = lists.clone().fold(longest, u32::max);
                cost += lists.map(|entries| u64::from(entries.min(list)) + 1).sum::<u64>();
                end += step;
            }
            let rows = first..end.min(rows);
            launches.extend((0..longest).step_by(list as usize).map(|skip| Launch { rows: rows.clone(), skip }));
            first = end;
        }
        launches
    }

    /// Lengths of the lists in a row of tiles.
    fn row_lists(&self, row: u32) -> impl Iterator<Item = u32> + Clone {
        let first = (row * self.count[0]) as usize;
        self.starts[first..=first + self.count[0] as usize].windows(2).map(|pair| pair[1] - pair[0])
    }
}

/// Columns and rows of tiles of this size that a region meets.
fn met(size: [u32; 2], [x0, x1, y0, y1]: [i32; 4]) -> [Range<u32>; 2] {
    if x0 > x1 || y0 > y1 {
        return [0..0, 0..0];
    }
    [(x0, x1, size[0]), (y0, y1, size[1])].map(|(first, last, size)| first as u32 / size..last as u32 / size + 1)
}

/// Consecutive triangles that are sorted together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Batch {
    /// The triangles.
    pub triangles: Range<usize>,
    /// Entries of all their lists.
    pub entries: u64,
}

/// All triangles in batches, in order: as many at a time as `fits` says, of so many triangles with so many entries in
/// tiles of this size; a triangle that does not fit is a batch by itself.
pub fn batches(size: [u32; 2], regions: &[[i32; 4]], fits: impl Fn(u64, u64) -> bool) -> Vec<Batch> {
    let mut batches: Vec<Batch> = Vec::new();
    for (number, region) in regions.iter().enumerate() {
        let [columns, rows] = met(size, *region);
        let more = columns.len() as u64 * rows.len() as u64;
        match batches.last_mut() {
            Some(batch) if fits(batch.triangles.len() as u64 + 1, batch.entries + more) => {
                batch.triangles.end = number + 1;
                batch.entries += more;
            }
            _ => batches.push(Batch { triangles: number..number + 1, entries: more }),
        }
    }
    batches
}

/// Receiver rows, and which part of their tiles' lists.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Launch {
    /// The rows.
    pub rows: Range<u32>,
    /// Entries of each list that earlier launches have met.
    pub skip: u32,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_hold_all_triangles_in_order_and_no_more_entries_than_they_may() {
        let regions = [[0, 0, 0, 0], [0, 7, 0, 3], [1, 0, 0, 0], [4, 4, 2, 2], [0, 15, 0, 15], [0, 0, 0, 0]];
        let size = [4, 2];
        // Entries: 1, 4, 0, 1, 32, 1.
        let cut = |most: u64, entries: u64| {
            let batches = batches(size, &regions, |triangles, held| triangles <= most && held <= entries);
            batches.into_iter().map(|batch| (batch.triangles, batch.entries)).collect::<Vec<_>>()
        };
        assert_eq!(cut(9, 5), [(0..3, 5), (3..4, 1), (4..5, 32), (5..6, 1)]);
        assert_eq!(cut(9, 6), [(0..4, 6), (4..5, 32), (5..6, 1)]);
        assert_eq!(cut(6, 100), [(0..6, 39)]);
        assert_eq!(cut(2, 100), [(0..2, 5), (2..4, 1), (4..6, 33)]);
        assert!(batches(size, &[], |_, _| true).is_empty());
    }

    #[test]
    fn launches_meet_every_row_with_every_entry_once() {
        let lengths = [[0, 0], [5, 1], [0, 9], [3, 3]];
        let mut starts = vec![0];
        lengths.as_flattened().iter().for_each(|entries| starts.push(starts[starts.len() - 1] + entries));
        let entries = (0..starts[8]).collect();
        let tiles = Tiles { size: [4, 2], count: [2, 4], starts, entries };
        for (step, pairs, list) in [(1, 1, 1), (2, 7, 4), (2, 1000, 3), (1, 4, 100), (2, 1, 9)] {
            let mut met = vec![0; 7 * 9];
            for Launch { rows, skip } in tiles.launches(7, step, pairs, list) {
                for row in rows {
                    (skip..skip + list).filter(|at| *at < 9).for_each(|at| met[(row * 9 + at) as usize] += 1);
                }
            }
            for row in 0..7 {
                let longest = lengths[row / 2].into_iter().max().unwrap_or(0).max(1) as usize;
                assert!((0..longest).all(|at| met[row * 9 + at] == 1), "row {row} of {step}, {pairs}, {list}");
            }
        }
    }
}

//! The definitions: an id by its formula, a count by counting, a coarse bin by adding its fine ones.

use super::{NOTHING, Tiling};

/// The id of every pixel: `base + instance · 4^depth + x + y · 2^depth` for tile (x, y), modulo 2³². The instance is
/// what remains of an item by 2^`instance_bits`, the object the quotient.
pub fn labels(tiling: Tiling, (items, instance_bits): (&[u32], u32), base: &[u32]) -> Vec<u32> {
    let tiles = 1_u64 << tiling.depth;
    let (width, height) = (u64::from(tiling.width), u64::from(tiling.height));
    let mut labels = Vec::with_capacity(items.len());
    for (place, &item) in (0..).zip(items) {
        let (object, instance) = (item >> instance_bits, u64::from(item) % (1 << instance_bits));
        labels.push(match base.get(object as usize) {
            Some(&base) if item != NOTHING => {
                let (px, py) = (place % width, place / width);
                let (x, y) = (px * tiles / width, py * tiles / height);
                (u64::from(base) + instance * tiles * tiles + x + y * tiles) as u32
            }
            _ => NOTHING,
        });
    }
    labels
}

/// How often each of the first `bins` ids occurs.
pub fn counts(ids: &[u32], bins: u32) -> Vec<u32> {
    let mut counts = vec![0; bins as usize];
    for &id in ids {
        if let Some(count) = counts.get_mut(id as usize) {
            *count += 1;
        }
    }
    counts
}

/// The sum of the weights of each of the first `bins` ids, modulo 2³².
pub fn weights(ids: &[u32], weights: &[u32], bins: u32) -> Vec<u32> {
    let mut sums = vec![0_u32; bins as usize];
    for (&id, weight) in ids.iter().zip(weights) {
        if let Some(sum) = sums.get_mut(id as usize) {
            *sum = sum.wrapping_add(*weight);
        }
    }
    sums
}

/// The next mip level, as sums: blocks of half the side from blocks of 2^depth by 2^depth.
pub fn halved(fine: &[u32], depth: u32) -> Vec<u32> {
    let (side, half) = (1 << depth, 1 << (depth - 1));
    let mut coarse = vec![0_u32; fine.len() / 4];
    for (place, count) in fine.iter().enumerate() {
        let (block, y, x) = (place / (side * side), place / side % side, place % side);
        let bin = &mut coarse[block * half * half + y / 2 * half + x / 2];
        *bin = bin.wrapping_add(*count);
    }
    coarse
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::item_histogram::item;
    use crate::random;

    #[test]
    fn figure_4_numbers_its_bins_like_this() {
        let tiling = Tiling { width: 8, height: 8, depth: 2 };
        let base = [0, 5 * 16, 8 * 16];
        let mut items = [NOTHING; 64];
        items[0] = item(0, 0);
        items[7] = item(0, 1);
        items[63] = item(1, 2);
        items[2 * 8 + 3] = item(2, 3);
        items[1] = item(3, 0);
        let labels = labels(tiling, (&items, 16), &base);
        assert_eq!(labels[0], 0);
        assert_eq!(labels[7], 16 + 3);
        assert_eq!(labels[63], 80 + 2 * 16 + 15);
        assert_eq!(labels[2 * 8 + 3], 128 + 3 * 16 + 1 + 4);
        assert_eq!(labels[1], NOTHING);
        assert_eq!(labels.iter().filter(|&&id| id != NOTHING).count(), 4);
    }

    #[test]
    fn counts_sum_to_the_ids_in_range() {
        for seed in 0..32 {
            let bins = 1 + random::below(500, seed, 0);
            let ids: Vec<u32> = (0..1000).map(|i| random::below(600, seed, i + 1)).collect();
            let counts = counts(&ids, bins);
            let in_range = ids.iter().filter(|&&id| id < bins).count();
            assert_eq!(counts.iter().sum::<u32>() as usize, in_range, "seed {seed}");
        }
    }

    #[test]
    fn every_mip_level_keeps_the_total_of_every_block() {
        let fine = random::words(1, 5 * 64).iter().map(|w| w >> 16).collect::<Vec<_>>();
        let middle = halved(&fine, 3);
        let coarse = halved(&middle, 2);
        let totals = halved(&coarse, 1);
        assert_eq!((middle.len(), coarse.len(), totals.len()), (5 * 16, 5 * 4, 5));
        for (block, total) in totals.iter().enumerate() {
            assert_eq!(*total, fine[block * 64..][..64].iter().sum::<u32>());
        }
        // Figure 4: tiles 2, 3, 6 and 7 of 4 by 4 are one bin of mip level 1.
        assert_eq!(coarse[1], middle[2] + middle[3] + middle[6] + middle[7]);
    }
}

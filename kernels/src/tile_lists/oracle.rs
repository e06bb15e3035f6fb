//! The definition: every tile asks every triangle.

/// Whether a region (first and last column, first and last row) has receivers.
fn is_region(region: &[i32; 4]) -> bool {
    region[0] <= region[1] && region[2] <= region[3]
}

/// The lists of all tiles of `size` receivers in a field of `receivers`: where each begins, and all entries.
pub fn lists(size: [u32; 2], receivers: [u32; 2], regions: &[[i32; 4]]) -> (Vec<u32>, Vec<u32>) {
    let (mut starts, mut entries) = (vec![0], Vec::new());
    for y in 0..receivers[1].div_ceil(size[1]) {
        for x in 0..receivers[0].div_ceil(size[0]) {
            let [left, top] = [(x * size[0]) as i32, (y * size[1]) as i32];
            let [right, bottom] = [left + size[0] as i32 - 1, top + size[1] as i32 - 1];
            for (triangle, region) in (0..).zip(regions).filter(|(_, region)| is_region(region)) {
                let [x0, x1, y0, y1] = *region;
                if x0 <= right && x1 >= left && y0 <= bottom && y1 >= top {
                    entries.push(triangle);
                }
            }
            starts.push(entries.len() as u32);
        }
    }
    (starts, entries)
}

/// The words of a block's tally.
pub fn tally(size: [u32; 2], regions: &[[i32; 4]]) -> [u32; 8] {
    let mut words = [0; 8];
    for [x0, x1, y0, y1] in regions.iter().filter(|region| is_region(region)).copied() {
        let met = |first: i32, last: i32, side: u32| {
            let begins = |at: &i32| *at == first || (*at as u32).is_multiple_of(side);
            (first..=last).filter(begins).count() as u32
        };
        for (k, entries) in words[..4].iter_mut().enumerate() {
            *entries += met(x0, x1, size[0]) * met(y0, y1, size[1] << k);
        }
        let [columns, rows] = [x1 - x0 + 1, y1 - y0 + 1].map(|side| side as u32);
        words[4] += 1;
        words[5] += rows;
        words[6] += columns * rows % (1 << 16);
        words[7] += columns * rows / (1 << 16);
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_region_over_a_corner_is_in_four_lists() {
        // Tiles of 4 by 2 in a field of 7 by 5: two by three.
        let regions = [[3, 4, 1, 2], [6, 5, 0, 4], [4, 6, 4, 4]];
        assert_eq!(lists([4, 2], [7, 5], &regions), (vec![0, 1, 2, 3, 4, 4, 5], vec![0, 0, 0, 0, 2]));
        assert_eq!(tally([4, 2], &regions), [4 + 1, 2 + 1, 2 + 1, 2 + 1, 2, 3, 7, 0]);
        assert_eq!(tally([4, 2], &[[0, 511, 0, 255]])[6..], [0, 2]);
    }
}

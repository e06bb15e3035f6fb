//! The definitions: a running sum of sums, and a sum over the pixels of a rectangle; both whole, or modulo 2³².

use glam::UVec4;

use super::Extent;

/// The summed-area table of `image`.
pub fn wide_table(extent: Extent, image: &[u32]) -> Vec<u64> {
    let width = extent.width as usize;
    let mut table = vec![0_u64; image.len()];
    for y in 0..extent.height as usize {
        let mut row = 0_u64;
        for x in 0..width {
            row += u64::from(image[y * width + x]);
            let above = if y == 0 { 0 } else { table[(y - 1) * width + x] };
            table[y * width + x] = row + above;
        }
    }
    table
}

/// The same modulo 2³².
pub fn table(extent: Extent, image: &[u32]) -> Vec<u32> {
    wide_table(extent, image).into_iter().map(|sum| sum as u32).collect()
}

/// Sum over a half-open rectangle (x0, y0, x1, y1), cut to the image: pixel by pixel, without a table.
pub fn wide_rectangle(extent: Extent, image: &[u32], rectangle: UVec4) -> u64 {
    let width = extent.width as usize;
    let [x0, y0, x1, y1] = rectangle.to_array().map(|edge| edge as usize);
    let (x1, y1) = (x1.min(width), y1.min(extent.height as usize));
    let rows = (y0..y1).map(|y| image.get(y * width + x0.min(x1)..y * width + x1).unwrap_or_default());
    rows.flatten().map(|&pixel| u64::from(pixel)).sum()
}

/// The same modulo 2³².
pub fn rectangle(extent: Extent, image: &[u32], rectangle: UVec4) -> u32 {
    wide_rectangle(extent, image, rectangle) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random;

    fn image(extent: Extent, seed: u32) -> Vec<u32> {
        random::words(seed, extent.pixels() as usize)
    }

    #[test]
    fn a_table_is_the_sum_over_all_pixels_left_and_above() {
        let extent = Extent { width: 12, height: 9 };
        let image = image(extent, 3);
        let table = table(extent, &image);
        for y in 0..9 {
            for x in 0..12 {
                let mut sum = 0_u32;
                for (j, i) in (0..=y).flat_map(|j| (0..=x).map(move |i| (j, i))) {
                    sum = sum.wrapping_add(image[j * 12 + i]);
                }
                assert_eq!(table[y * 12 + x], sum, "({x}, {y})");
            }
        }
    }

    #[test]
    fn four_look_ups_give_the_rectangle() {
        let extent = Extent { width: 20, height: 17 };
        let image = image(extent, 4);
        let table = table(extent, &image);
        let at = |x: u32, y: u32| if x == 0 || y == 0 { 0 } else { table[((y - 1) * 20 + x - 1) as usize] };
        for i in 0..500 {
            let [a, b] = [0, 1].map(|k| random::below(21, 5, 4 * i + k));
            let [c, d] = [2, 3].map(|k| random::below(18, 5, 4 * i + k));
            let (x0, x1, y0, y1) = (a.min(b), a.max(b), c.min(d), c.max(d));
            let looked_up = at(x1, y1).wrapping_sub(at(x0, y1)).wrapping_sub(at(x1, y0)).wrapping_add(at(x0, y0));
            assert_eq!(rectangle(extent, &image, UVec4::new(x0, y0, x1, y1)), looked_up, "{x0} {y0} {x1} {y1}");
        }
    }

    #[test]
    fn rectangles_are_cut_to_the_image() {
        let extent = Extent { width: 4, height: 2 };
        let image = [1, 2, 3, 4, 5, 6, 7, 8];
        for (cut, sum) in
            [([0, 0, 9, 9], 36), ([2, 0, u32::MAX, 1], 7), ([9, 9, 10, 10], 0), ([3, 1, 1, 2], 0), ([1, 2, 2, 1], 0)]
        {
            assert_eq!(rectangle(extent, &image, cut.into()), sum, "{cut:?}");
        }
    }

    #[test]
    fn the_largest_exact_value_does_not_wrap_and_the_next_does() {
        for extent in [Extent { width: 4096, height: 4096 }, Extent { width: 1024, height: 1024 }] {
            let value = u64::from(extent.largest_exact());
            assert!(value * extent.pixels() <= u64::from(u32::MAX));
            assert!((value + 1) * extent.pixels() > u64::from(u32::MAX));
        }
        assert_eq!(Extent { width: 4096, height: 4096 }.largest_exact(), 255);
        assert_eq!(Extent { width: 1024, height: 1024 }.largest_exact(), 4095);
    }
}

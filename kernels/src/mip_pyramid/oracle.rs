//! The definition: a node is the sum of the pixels below it, modulo 2³².
//!
//! Sums over rectangles are those of [`crate::sat::oracle::rectangle`], pixel by pixel.

/// Level `level` of an image by rows: nodes of 2^level by 2^level pixels, cut to the image.
pub fn level(image: &[u32], [width, height]: [u32; 2], level: u32) -> Vec<u32> {
    let side = 1_u32 << level;
    let node = |x: u32, y: u32| {
        let rows = y * side..((y + 1) * side).min(height);
        let columns = x * side..((x + 1) * side).min(width);
        let row = |j: u32| &image[(j * width + columns.start) as usize..(j * width + columns.end) as usize];
        rows.flat_map(row).fold(0_u32, |sum, pixel| sum.wrapping_add(*pixel))
    };
    let places = (0..height.div_ceil(side)).flat_map(|y| (0..width.div_ceil(side)).map(move |x| (x, y)));
    places.map(|(x, y)| node(x, y)).collect()
}

#[cfg(test)]
mod tests {
    use super::level;

    #[test]
    fn nodes_at_the_border_have_the_pixels_that_there_are() {
        let image: Vec<u32> = (1..=15).collect();
        assert_eq!(level(&image, [5, 3], 0), image);
        assert_eq!(level(&image, [5, 3], 1), [1 + 2 + 6 + 7, 3 + 4 + 8 + 9, 5 + 10, 11 + 12, 13 + 14, 15]);
        assert_eq!(level(&image, [5, 3], 2), [120 - 5 - 10 - 15, 5 + 10 + 15]);
        assert_eq!(level(&image, [5, 3], 3), [120]);
    }
}

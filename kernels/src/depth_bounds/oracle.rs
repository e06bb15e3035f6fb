//! The definitions: the greatest depth of a region, pixel by pixel.

use crate::raster::Picture;

/// The greatest depth of the pixels of a half-open rectangle (x0, y0, x1, y1) that lie in the picture.
pub fn greatest(picture: Picture, depth: &[u32], [x0, y0, x1, y1]: [u32; 4]) -> u32 {
    let rows = y0..y1.min(picture.height);
    let row = |y: u32| (x0..x1.min(picture.width)).map(move |x| depth[(y * picture.width + x) as usize]);
    rows.flat_map(row).max().unwrap_or(0)
}

/// Level `level` of the pyramid, row after row.
pub fn pyramid(picture: Picture, depth: &[u32], level: u32) -> Vec<u32> {
    let side = 1 << level;
    let texel = |x: u32, y: u32| greatest(picture, depth, [x * side, y * side, (x + 1) * side, (y + 1) * side]);
    let (columns, rows) = (picture.width.div_ceil(side), picture.height.div_ceil(side));
    (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))).map(|(x, y)| texel(x, y)).collect()
}

/// Level `level` of the N-buffers, row after row.
pub fn buffers(picture: Picture, depth: &[u32], level: u32) -> Vec<u32> {
    let side = 1 << level;
    let texel = |x: u32, y: u32| greatest(picture, depth, [x, y, x + side, y + side]);
    (0..picture.height).flat_map(|y| (0..picture.width).map(move |x| (x, y))).map(|(x, y)| texel(x, y)).collect()
}

/// What the pyramid looks at for a rectangle: whole texels of the least level where they are two by two at most.
pub fn pyramid_region([x0, y0, x1, y1]: [u32; 4]) -> [u32; 4] {
    let fits = |level: &u32| ((x1 - 1) >> level) - (x0 >> level) <= 1 && ((y1 - 1) >> level) - (y0 >> level) <= 1;
    let level = (0..32).find(fits).unwrap_or(31);
    [x0 >> level << level, y0 >> level << level, (((x1 - 1) >> level) + 1) << level, (((y1 - 1) >> level) + 1) << level]
}

/// What the N-buffers look at: four squares of the greatest power of two up to its longer side.
pub fn buffer_regions([x0, y0, x1, y1]: [u32; 4]) -> Vec<[u32; 4]> {
    let side = 1 << (x1 - x0).max(y1 - y0).ilog2();
    let starts = |low: u32, high: u32| [low, if high - low > side { high - side } else { low }];
    let corners = starts(y0, y1).into_iter().flat_map(|y| starts(x0, x1).map(|x| [x, y]));
    corners.map(|[x, y]| [x, y, x + side, y + side]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_hold_their_rectangle() {
        let sides = [1, 2, 3, 7, 8, 9, 30];
        for (w, h) in sides.iter().flat_map(|w| sides.map(|h| (*w, h))) {
            for (x, y) in (0..20).map(|i| (i * 5 % 17, i * 3 % 11)) {
                let r = [x, y, x + w, y + h];
                let within = |[a, b, c, d]: [u32; 4], [px, py]: [u32; 2]| a <= px && px < c && b <= py && py < d;
                for pixel in (y..y + h).flat_map(|py| (x..x + w).map(move |px| [px, py])) {
                    assert!(within(pyramid_region(r), pixel), "{r:?}");
                    assert!(buffer_regions(r).iter().any(|square| within(*square, pixel)), "{r:?}");
                }
            }
        }
    }
}

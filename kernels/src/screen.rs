//! Item buffers as a renderer leaves them: every pixel names the front-most instance, so equal pixels lie in clumps.
//!
//! The scene is made of discs at random places, painted back to front until they cover about twice the screen.

use crate::random;

/// A pixel that shows no instance.
pub const BACKGROUND: u32 = u32::MAX;

/// The front-most of `instances` discs for every pixel, by rows, or [`BACKGROUND`].
pub fn discs(width: u32, height: u32, instances: u32, seed: u32) -> Vec<u32> {
    let mut pixels = vec![BACKGROUND; width as usize * height as usize];
    // π r² · instances ≈ 2 · width · height.
    let radius = (7 * width * height / (11 * instances.max(1))).isqrt().max(1);
    for instance in 0..instances {
        let cx = i64::from(random::below(width, seed, 3 * instance));
        let cy = i64::from(random::below(height, seed, 3 * instance + 1));
        let r = i64::from(radius / 2 + random::below(radius, seed, 3 * instance + 2));
        for y in (cy - r).max(0)..(cy + r + 1).min(i64::from(height)) {
            let half = (r * r - (y - cy) * (y - cy)).isqrt();
            let (from, to) = ((cx - half).max(0), (cx + half + 1).min(i64::from(width)));
            let row = y as usize * width as usize;
            pixels[row + from as usize..row + to as usize].fill(instance);
        }
    }
    pixels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_screen_is_mostly_covered_and_clumped() {
        let pixels = discs(256, 128, 40, 5);
        let covered = pixels.iter().filter(|&&p| p != BACKGROUND).count();
        assert!((pixels.len() / 2..pixels.len()).contains(&covered), "{covered} pixels are covered");
        let changes = pixels.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!(changes < pixels.len() / 8, "{changes} changes along the rows");
        assert!(pixels.iter().all(|&p| p == BACKGROUND || p < 40));
    }
}

//! The definition: one pixel behind one surface, to the nearest of the weights.

/// What is left of a weight behind a surface that lets `through` of 256 parts pass, halves rounded up.
pub fn behind(weight: u32, through: u32) -> u32 {
    let exact = u64::from(weight) * u64::from(through.min(256));
    let (whole, rest) = (exact / 256, exact % 256);
    (whole + u64::from(rest >= 128)) as u32
}

/// The weight of a pixel: its depth, and its blocker's depth and factor if there is one.
pub fn weight(weight: u32, depth: u32, blocker: Option<(u32, u32)>) -> u32 {
    match blocker {
        Some((nearer, through)) if nearer < depth => behind(weight, through),
        _ => weight,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_half_and_nothing_pass() {
        assert_eq!([256, 128, 1, 0, u32::MAX].map(|through| behind(255, through)), [255, 128, 1, 0, 255]);
        assert_eq!(behind(65_535, 255), 65_279);
    }

    #[test]
    fn weights_never_grow_and_keep_their_order() {
        for through in 0..=256 {
            assert!((0..=2000).all(|weight| behind(weight, through) <= weight));
            assert!((0..2000).all(|weight| behind(weight, through) <= behind(weight + 1, through)));
        }
    }

    #[test]
    fn only_what_is_in_front_dims() {
        let half = |depth| weight(200, depth, Some((7, 128)));
        assert_eq!([half(6), half(7), half(8), weight(200, 8, None)], [200, 200, 100, 200]);
    }
}

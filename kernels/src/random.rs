//! Random numbers by counter: word `i` of stream `seed` is a hash of both, in any order and on any machine.
//!
//! The hash is Wellons's `lowbias32` (2018), applied to index and seed in turn. It makes test inputs; it is no source
//! of secrets.

/// Word `index` of stream `seed`.
pub fn word(seed: u32, index: u32) -> u32 {
    mix(mix(index.wrapping_add(0x9e37_79b9)).wrapping_add(seed))
}

/// Word `index` of stream `seed`, scaled to `[0, bound)`.
pub fn below(bound: u32, seed: u32, index: u32) -> u32 {
    ((u64::from(word(seed, index)) * u64::from(bound)) >> 32) as u32
}

/// The first `len` words of stream `seed`.
pub fn words(seed: u32, len: usize) -> Vec<u32> {
    (0..len as u32).map(|index| word(seed, index)).collect()
}

fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_are_fixed_and_differ() {
        assert_eq!(words(1, 3), [word(1, 0), word(1, 1), word(1, 2)]);
        assert_ne!(words(1, 8), words(2, 8));
        let ones: u32 = words(7, 4096).iter().map(|w| w.count_ones()).sum();
        assert!((65_536_u32).abs_diff(ones) < 1024, "{ones} of 131,072 bits are set");
        assert!((0..1000).all(|i| below(10, 3, i) < 10));
    }
}

//! A bijective hash of numbers of a few bits: the oracle of `shared/permute.wgsl`.
//!
//! A scattered order needs no table of indices if it can be computed. Invariant: for every number of bits the function
//! is one to one, which is what makes a scattered sum equal to an ordered one.

/// Where number `x` of `[0, 2^bits)` goes; `bits` is at most 31.
pub fn permute(x: u32, bits: u32) -> u32 {
    let mask = (1 << bits) - 1;
    let half = bits / 2 + 1;
    let mut h = x.wrapping_mul(0x9e37_79b1).wrapping_add(0x7f4a_7c15) & mask;
    h ^= h >> half;
    h = h.wrapping_mul(0x85eb_ca6b) & mask;
    h ^= h >> half;
    h.wrapping_mul(0xc2b2_ae35) & mask
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_one_to_one() {
        for bits in 0..=16 {
            let mut seen = vec![false; 1 << bits];
            for x in 0..1 << bits {
                let h = permute(x, bits) as usize;
                assert!(!seen[h], "{bits} bits: {h} is reached twice");
                seen[h] = true;
            }
        }
    }

    #[test]
    fn neighbours_are_driven_apart() {
        let near = (0..65_535).filter(|&x| permute(x, 16).abs_diff(permute(x + 1, 16)) < 256).count();
        assert!(near < 1024, "{near} of 65,535 neighbours stay within 256 places");
    }
}

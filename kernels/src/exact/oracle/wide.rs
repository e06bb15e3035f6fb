//! Sums over masks and the hash; sums, products and shifts of 64 bits are Rust's own.

/// 2^b times the number of bits that both have.
pub fn mask_dot(mask: u64, plane: u64, b: u32) -> u32 {
    (mask & plane).count_ones() << b
}

/// PCG's RXS-M-XS 32/32 of the state that follows `v`.
pub fn hash32(v: u32) -> u32 {
    const MODULUS: u64 = 1 << 32;
    let state = (u64::from(v) * 747_796_405 + 2_891_336_453) % MODULUS;
    let word = (state >> ((state >> 28) + 4) ^ state) * 277_803_737 % MODULUS;
    (word >> 22 ^ word) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The inverse of an odd number modulo 2^32, by Newton's iteration.
    fn inverse(odd: u32) -> u32 {
        (0..5).fold(odd, |x, _| x.wrapping_mul(2_u32.wrapping_sub(odd.wrapping_mul(x))))
    }

    #[test]
    fn the_hash_is_undone_step_by_step() {
        for v in (0..1 << 16).map(|i: u32| i.wrapping_mul(0x9e37_79b1)).chain([0, 1, u32::MAX]) {
            let h = hash32(v);
            let word = (h ^ h >> 22).wrapping_mul(inverse(277_803_737));
            // The top four bits are not touched by the shift that they choose; the others follow from above.
            let shift = (word >> 28) + 4;
            let state = (0..32 / shift).fold(word, |state, _| word ^ state >> shift);
            let back = state.wrapping_sub(2_891_336_453).wrapping_mul(inverse(747_796_405));
            assert_eq!(back, v);
        }
    }

    #[test]
    fn masks_count_common_bits() {
        assert_eq!(mask_dot(u64::MAX, u64::MAX, 25), 1 << 31);
        assert_eq!(mask_dot(0b1101, 0b0111, 3), 2 << 3);
        assert_eq!(mask_dot(1 << 63, 1 << 63, 0), 1);
    }
}

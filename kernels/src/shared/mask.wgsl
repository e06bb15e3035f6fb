// Sums over the bits of a mask.

/// 2^b times the number of bits that both have: one bit plane of the sum of fixed-point values over a mask of 64
/// samples. Exact for b <= 25. A value of B bits a sample takes B calls, added up.
fn mask_dot(mask: vec2<u32>, plane: vec2<u32>, b: u32) -> u32 {
    return (countOneBits(mask.x & plane.x) + countOneBits(mask.y & plane.y)) << b;
}

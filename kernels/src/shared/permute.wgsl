// A bijective hash of `bits`-bit numbers: a scattered order that needs no table of indices.
//
// Addition, multiplication by an odd number and x ^ (x >> s) with s > 0 are each bijective modulo 2^bits, and so is
// their chain. The multipliers are those of MurmurHash3 (Appleby 2011) and Knuth's golden ratio.

/// Where number `x` of [0, 2^bits) goes; `bits` is at most 31.
fn permute(x: u32, bits: u32) -> u32 {
    let mask = (1u << bits) - 1u;
    let half = bits / 2u + 1u;
    var h = (x * 0x9e3779b1u + 0x7f4a7c15u) & mask;
    h ^= h >> half;
    h = (h * 0x85ebca6bu) & mask;
    h ^= h >> half;
    return (h * 0xc2b2ae35u) & mask;
}

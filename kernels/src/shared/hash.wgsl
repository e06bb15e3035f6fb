// Noise by counter: a hash in place of `fract(sin(x) * 43758.5453)`, which differs from device to device.

/// The output permutation of O'Neill's PCG (RXS-M-XS 32/32, 2014) after one step of its generator: one to one on u32.
fn hash32(v: u32) -> u32 {
    let s = v * 747796405u + 2891336453u;
    let w = ((s >> ((s >> 28u) + 4u)) ^ s) * 277803737u;
    return (w >> 22u) ^ w;
}

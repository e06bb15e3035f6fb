// Directions on integer lattices.

import package::shared::wide::{ltu64, uabs, umul_wide};

/// floor(|v| * 2^15 / sqrt(s)) with the sign of v, where y is about 1 / sqrt(s).
/// float: guess - off by at most 1, which exact squares of 64 bits correct
fn unit_component(v: i32, s: u32, y: f32) -> i32 {
    let a = uabs(v);
    let square = vec2<u32>((a * a) << 30u, (a * a) >> 2u);
    let c = u32(f32(a) * y * 32768.0);
    let above = ltu64(square, umul_wide(c * c, s));
    let below = !ltu64(square, umul_wide((c + 1u) * (c + 1u), s));
    let exact = c - select(0u, 1u, above) + select(0u, 1u, below);
    return bitcast<i32>(select(exact, 0u - exact, v < 0));
}

/// v scaled to length 2^15, every component rounded towards 0. Components are in [-2^15, 2^15], not all 0.
/// `inverseSqrt` may be off by 256 ULP; WGSL permits 2.
/// float: guess - each component is corrected by its own square
fn normalize3_q15(v: vec3<i32>) -> vec3<i32> {
    let u = bitcast<vec3<u32>>(v);
    let s = u.x * u.x + u.y * u.y + u.z * u.z;
    let y = inverseSqrt(f32(max(s, 1u)));
    return vec3<i32>(unit_component(v.x, s, y), unit_component(v.y, s, y), unit_component(v.z, s, y));
}

/// The direction of a point (i, j) of the square [0, 2n]^2 folded onto the octahedron: |x| + |y| + |z| = n. The centre
/// is +z, the four corners are -z. n <= 2^29.
fn oct_dir(i: i32, j: i32, n: i32) -> vec3<i32> {
    let u = i - n;
    let v = j - n;
    let au = bitcast<i32>(uabs(u));
    let av = bitcast<i32>(uabs(v));
    let z = n - au - av;
    let fu = select(n - av, av - n, u < 0);
    let fv = select(n - au, au - n, v < 0);
    return vec3<i32>(select(u, fu, z < 0), select(v, fv, z < 0), z);
}

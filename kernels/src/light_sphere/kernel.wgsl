// Light spheres: the directions of a subdivided octahedron by number, and directions turned with their environment.
//
// The set of directional lights is the octahedron of Sattler et al. 2004, section 3.4, subdivided
// on its flat faces: level s is the lattice |x| + |y| + |z| = 2^s, 2 + 4^(s+1) directions. Directions are left at their
// lattice length. They are numbered so that every level is a prefix of the next one, and directions 2p and 2p + 1 are
// opposite. Of a pair p the first direction is
//
// * +x, +y, +z for p = 0, 1, 2;
// * from there on, level by level, a point with two odd coordinates. With e the axis of the even one and a, b the two
//   after it in cyclic order, the coordinate on a is positive; pairs are ordered by e, then by the coordinates' sum b +
//   e, then by b - e. Level s has 2^(2s-1) pairs for each e: sums and differences are the odd numbers in (-2^s, 2^s)
//   that agree modulo 4.
//
// `octahedron` writes (x, y, z, 2^s) of every number below `count`. `turn` writes (R u) / 2^14, rounded down, where u
// is a direction scaled to length 2^15 and rounded towards 0, and the rows of R are in units of 2^-14.

import package::shared::direction::normalize3_q15;
import package::shared::wide::uabs;

struct Params {
    /// Directions in all.
    count: u32,
    /// Direction of the first invocation.
    first: u32,
}

struct Turn {
    x: vec4<i32>,
    y: vec4<i32>,
    z: vec4<i32>,
    count: u32,
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read_write> directions: array<vec4<i32>>;
@group(0) @binding(2) var<uniform> rotation: Turn;
@group(0) @binding(3) var<storage, read> given: array<vec4<i32>>;
@group(0) @binding(4) var<storage, read_write> turned: array<vec4<i32>>;

/// The vector with coordinate `e` on axis `axis`, and a and b on the two after it.
fn cyclic(axis: u32, e: i32, a: i32, b: i32) -> vec3<i32> {
    let v = select(vec3<i32>(b, e, a), vec3<i32>(e, a, b), axis == 0u);
    return select(v, vec3<i32>(a, b, e), axis == 2u);
}

/// The first direction of a pair, and the level's 2^s.
fn first_of_pair(pair: u32) -> vec4<i32> {
    if (pair < 3u) {
        return vec4<i32>(cyclic(pair, 1, 0, 0), 1);
    }
    // Levels below s have 1 + 2^(2s-1) pairs.
    let s = (31u - countLeadingZeros((pair - 1u) >> 1u)) / 2u + 1u;
    let each = 1u << (2u * s - 1u);
    let place = pair - 1u - each;
    let axis = place / each;
    let k = place & (each - 1u);
    let row = k >> (s - 1u);
    let column = 2u * (k & ((1u << (s - 1u)) - 1u)) + (row & 1u);
    let n = 1 << s;
    let b = bitcast<i32>(row + column) - n + 1;
    let e = bitcast<i32>(row) - bitcast<i32>(column);
    let a = n - bitcast<i32>(uabs(b) + uabs(e));
    return vec4<i32>(cyclic(axis, e, a, b), n);
}

@compute @workgroup_size(256)
fn octahedron(@builtin(global_invocation_id) id: vec3<u32>) {
    let number = params.first + id.x;
    if (number >= params.count) {
        return;
    }
    let v = first_of_pair(number >> 1u);
    let sign = 1 - 2 * bitcast<i32>(number & 1u);
    directions[number] = vec4<i32>(v.xyz * sign, v.w);
}

fn along(row: vec4<i32>, u: vec3<i32>) -> i32 {
    return (row.x * u.x + row.y * u.y + row.z * u.z) >> 14u;
}

@compute @workgroup_size(256)
fn turn(@builtin(global_invocation_id) id: vec3<u32>) {
    let number = rotation.first + id.x;
    if (number >= rotation.count) {
        return;
    }
    let u = normalize3_q15(given[number].xyz);
    turned[number] = vec4<i32>(along(rotation.x, u), along(rotation.y, u), along(rotation.z, u), 0);
}

// Triangles of a few pixels: one lane walks the box of one triangle, in 32 bits.
//
// Invariant: extents are below 2^8, so twice the area is below 2^16, edge functions in the box too, and a quotient of
// numerators of 2^41 is had by two digits of 12 bits.

import package::shared::raster::{tie, turn};

/// floor(n / d) for d > 0.
fn floor_div(n: i32, d: i32) -> i32 {
    let flip = select(0u, 0xffffffffu, n < 0);
    return bitcast<i32>(((bitcast<u32>(n) ^ flip) / bitcast<u32>(d)) ^ flip);
}

/// Quotient, rounded down, and remainder of u * du + v * dv by s, for |u|, |v| < 2^17, |du|, |dv| < 2^24, 0 < s < 2^16.
fn slope_small(u: i32, v: i32, du: i32, dv: i32, s: i32) -> vec2<i32> {
    let high = u * (du >> 12u) + v * (dv >> 12u);
    let q = floor_div(high, s);
    let low = ((high - q * s) << 12u) + u * (du & 4095) + v * (dv & 4095);
    let r = floor_div(low, s);
    return vec2<i32>((q << 12u) + r, low - r * s);
}

/// Draws a triangle of S > 0 into the pixels from `low` to `high`, which lie in the picture.
fn draw_small(a: vec3<i32>, b: vec3<i32>, c: vec3<i32>, low: vec2<i32>, high: vec2<i32>, id: u32) {
    let s = turn(a.xy, b.xy, c.xy);
    let p = 16 * low + 8;
    let size = high - low + 1;
    // Edge functions opposite a, b, c, and their steps to the right and to the start of the next row.
    var e = vec3<i32>(turn(b.xy, c.xy, p), turn(c.xy, a.xy, p), turn(a.xy, b.xy, p));
    let right = 16 * vec3<i32>(b.y - c.y, c.y - a.y, a.y - b.y);
    let down = 16 * vec3<i32>(c.x - b.x, a.x - c.x, b.x - a.x);
    let next = down - (size.x - 1) * right;
    let dz = vec2<i32>(b.z - a.z, c.z - a.z);
    var depth = slope_small(e.y, e.z, dz.x, dz.y, s);
    let depth_right = slope_small(right.y, right.z, dz.x, dz.y, s);
    let depth_next = slope_small(next.y, next.z, dz.x, dz.y, s);
    depth.x += a.z;
    e -= vec3<i32>(tie(c.xy - b.xy), tie(a.xy - c.xy), tie(b.xy - a.xy));

    let columns = bitcast<u32>(size.x);
    var place = bitcast<u32>(low.y) * params.width + bitcast<u32>(low.x);
    var column = columns;
    let count = columns * bitcast<u32>(size.y);
    for (var i = 0u; i < count; i += 1u) {
        if ((e.x | e.y | e.z) >= 0) {
            plot(place, bitcast<u32>(depth.x), id);
        }
        column -= 1u;
        let turns = column == 0u;
        e += select(right, next, turns);
        depth += select(depth_right, depth_next, turns);
        let carry = depth.y >= s;
        depth -= select(vec2<i32>(0), vec2<i32>(-1, s), carry);
        place += select(1u, params.width - columns + 1u, turns);
        column = select(column, columns, turns);
    }
}

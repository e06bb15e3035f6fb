// Triangles that fit 15 bits: a workgroup draws 16 by 16 pixels at a time, in 32 bits.
//
// Invariant: extents are below 2^15, so twice the area is below 2^30 and edge functions up to a tile beyond the box are
// below 2^31. Quotients are modulo 2^32: those of covered pixels are depths.

import package::shared::divide::udiv64_32;
import package::shared::raster::{tie, turn};
import package::shared::wide::{add64, imul_wide};

/// Quotient modulo 2^32, rounded down, and remainder of u * du + v * dv by s, for 0 < s < 2^31 and sums below 2^63.
fn slope(u: i32, v: i32, du: i32, dv: i32, s: u32) -> vec2<u32> {
    let n = add64(imul_wide(u, du), imul_wide(v, dv));
    let flip = select(0u, 0xffffffffu, (n.y >> 31u) != 0u);
    let m = n ^ vec2<u32>(flip);
    let qr = udiv64_32(vec2<u32>(m.x, m.y % s), s);
    return vec2<u32>(qr.x ^ flip, select(qr.y, s - 1u - qr.y, flip != 0u));
}

/// The sum of two quotients with remainders.
fn add_slope(a: vec2<u32>, b: vec2<u32>, s: u32) -> vec2<u32> {
    let r = a.y + b.y;
    let carry = r >= s;
    return vec2<u32>(a.x + b.x + select(0u, 1u, carry), r - select(0u, s, carry));
}

/// 16 times a quotient with remainder.
fn sixteen(a: vec2<u32>, s: u32) -> vec2<u32> {
    let a2 = add_slope(a, a, s);
    let a4 = add_slope(a2, a2, s);
    let a8 = add_slope(a4, a4, s);
    return add_slope(a8, a8, s);
}

/// floor((start + i * right + j * down) / s) for i, j < 16 and remainders below s < 2^30.
/// float: guess - the quotient is below 31, the guess off by less than 1; the residual, exact modulo 2^32, corrects it
fn carries(start: u32, i: u32, right: u32, j: u32, down: u32, s: u32) -> u32 {
    let sum = f32(start) + f32(i) * f32(right) + f32(j) * f32(down);
    let q = u32(sum / f32(s));
    let r = bitcast<i32>(start + i * right + j * down - q * s);
    return q + select(0u, 1u, r >= bitcast<i32>(s)) - select(0u, 1u, r < 0);
}

/// Draws a triangle of S > 0 into the pixels from `low` to `high`, which lie in the picture.
fn draw_fitting(a: vec3<i32>, b: vec3<i32>, c: vec3<i32>, low: vec2<i32>, high: vec2<i32>, lane: u32, id: u32) {
    let s = bitcast<u32>(turn(a.xy, b.xy, c.xy));
    let p = 16 * low + 8;
    let start = vec3<i32>(turn(b.xy, c.xy, p), turn(c.xy, a.xy, p), turn(a.xy, b.xy, p));
    let right = 16 * vec3<i32>(b.y - c.y, c.y - a.y, a.y - b.y);
    let down = 16 * vec3<i32>(c.x - b.x, a.x - c.x, b.x - a.x);
    let ties = vec3<i32>(tie(c.xy - b.xy), tie(a.xy - c.xy), tie(b.xy - a.xy));
    // What the best corner of a tile has over its first pixel.
    let most = max(15 * right, vec3<i32>(0)) + max(15 * down, vec3<i32>(0)) - ties;
    let dz = vec2<i32>(b.z - a.z, c.z - a.z);
    let slope_right = slope(right.y, right.z, dz.x, dz.y, s);
    let slope_down = slope(down.y, down.z, dz.x, dz.y, s);
    let tile_right = sixteen(slope_right, s);
    let tile_down = sixteen(slope_down, s);
    var row_depth = slope(start.y, start.z, dz.x, dz.y, s);
    row_depth.x += bitcast<u32>(a.z);

    let i = lane % 16u;
    let j = lane / 16u;
    let own = bitcast<i32>(i) * right + bitcast<i32>(j) * down - ties;
    var row_e = start;
    for (var y = low.y; y <= high.y; y += 16) {
        var e = row_e;
        var depth = row_depth;
        for (var x = low.x; x <= high.x; x += 16) {
            let best = e + most;
            if ((best.x | best.y | best.z) >= 0) {
                let mine = e + own;
                let pixel = vec2<i32>(x, y) + vec2<i32>(bitcast<i32>(i), bitcast<i32>(j));
                if (((mine.x | mine.y | mine.z) >= 0) & (pixel.x <= high.x) & (pixel.y <= high.y)) {
                    let more = carries(depth.y, i, slope_right.y, j, slope_down.y, s);
                    let z = depth.x + i * slope_right.x + j * slope_down.x + more;
                    plot(bitcast<u32>(pixel.y) * params.width + bitcast<u32>(pixel.x), z, id);
                }
            }
            e += 16 * right;
            depth = add_slope(depth, tile_right, s);
        }
        row_e += 16 * down;
        row_depth = add_slope(row_depth, tile_down, s);
    }
}

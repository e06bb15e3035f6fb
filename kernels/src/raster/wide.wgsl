// Triangles of any size: as `fitting`, in 64 bits.
//
// Invariant: screen coordinates are within 2^28 of the picture's centre, so twice the area is at most 2^58, and so are
// edge functions in the box. Everything but the test and the depth of a pixel is uniform, and few triangles are this
// large.

import package::shared::raster::tie;
import package::shared::wide::{add64, imul_wide, ltu64, neg64, shl64, sub64, umul_wide};

/// (b - a) x (p - a).
fn turn64(a: vec2<i32>, b: vec2<i32>, p: vec2<i32>) -> vec2<u32> {
    let d = b - a;
    let e = p - a;
    return sub64(imul_wide(d.x, e.y), imul_wide(d.y, e.x));
}

fn is_negative(a: vec2<u32>) -> bool {
    return (a.y >> 31u) != 0u;
}

/// Quotient modulo 2^32 and remainder of 64-bit numbers.
struct Slope {
    q: u32,
    r: vec2<u32>,
}

/// A division bit by bit: what is left of the numerator, and what is known of the quotient.
struct Division {
    left: vec2<u32>,
    known: Slope,
}

fn begin_division(n: vec2<u32>) -> Division {
    return Division(n ^ vec2<u32>(select(0u, 0xffffffffu, is_negative(n))), Slope(0u, vec2<u32>(0u)));
}

/// One more bit; `part` is taken off if it fits.
fn next_bit(a: Slope, part: vec2<u32>) -> Slope {
    let fits = !ltu64(a.r, part);
    return Slope((a.q << 1u) | select(0u, 1u, fits), select(a.r, sub64(a.r, part), fits));
}

fn divide_bit(a: Division, d: vec2<u32>) -> Division {
    let r = shl64(a.known.r, 1u) | vec2<u32>(a.left.y >> 31u, 0u);
    return Division(shl64(a.left, 1u), next_bit(Slope(a.known.q, r), d));
}

/// n / d, rounded down.
fn end_division(a: Slope, n: vec2<u32>, d: vec2<u32>) -> Slope {
    let negative = is_negative(n);
    let last = sub64(d, vec2<u32>(1u, 0u));
    return Slope(a.q ^ select(0u, 0xffffffffu, negative), select(a.r, sub64(last, a.r), negative));
}

/// r, and 1 more for each of two times that s goes into it.
fn reduce(q: u32, r: vec2<u32>, s: vec2<u32>) -> Slope {
    let once = !ltu64(r, s);
    let r1 = select(r, sub64(r, s), once);
    let twice = !ltu64(r1, s);
    return Slope(q + select(0u, 1u, once) + select(0u, 1u, twice), select(r1, sub64(r1, s), twice));
}

/// (u * du + v * dv) / s, rounded down, for |du|, |dv| < 2^25 and s <= 2^60: Horner's rule on the bits of du and dv.
fn slope64(u: vec2<u32>, v: vec2<u32>, du: i32, dv: i32, s: vec2<u32>) -> Slope {
    let m = abs(du);
    let n = abs(dv);
    let su = select(u, neg64(u), vec2<bool>(du < 0));
    let sv = select(v, neg64(v), vec2<bool>(dv < 0));
    var x = begin_division(su);
    var y = begin_division(sv);
    for (var bits = 0u; bits < 64u; bits += 2u) {
        x = divide_bit(divide_bit(x, s), s);
        y = divide_bit(divide_bit(y, s), s);
    }
    let a = end_division(x.known, su, s);
    let b = end_division(y.known, sv, s);
    var sum = Slope(0u, vec2<u32>(0u));
    for (var bit = 25u; bit > 0u; bit -= 1u) {
        let am = 0u - ((bitcast<u32>(m) >> (bit - 1u)) & 1u);
        let bn = 0u - ((bitcast<u32>(n) >> (bit - 1u)) & 1u);
        let doubled = reduce(2u * sum.q, shl64(sum.r, 1u), s);
        sum = reduce(doubled.q, add64(doubled.r, add64(a.r & vec2<u32>(am), b.r & vec2<u32>(bn))), s);
    }
    return Slope(a.q * bitcast<u32>(m) + b.q * bitcast<u32>(n) + sum.q, sum.r);
}

fn add_slope64(a: Slope, b: Slope, s: vec2<u32>) -> Slope {
    return reduce(a.q + b.q, add64(a.r, b.r), s);
}

fn sixteen64(a: Slope, s: vec2<u32>) -> Slope {
    let a2 = add_slope64(a, a, s);
    let a4 = add_slope64(a2, a2, s);
    let a8 = add_slope64(a4, a4, s);
    return add_slope64(a8, a8, s);
}

/// a * k modulo 2^64.
fn times(a: vec2<u32>, k: u32) -> vec2<u32> {
    let low = umul_wide(a.x, k);
    return vec2<u32>(low.x, low.y + a.y * k);
}

/// floor(r / s) for r < 32 s < 2^64.
fn carries64(r: vec2<u32>, s: vec2<u32>) -> u32 {
    let two = next_bit(next_bit(Slope(0u, r), shl64(s, 4u)), shl64(s, 3u));
    return next_bit(next_bit(next_bit(two, shl64(s, 2u)), shl64(s, 1u)), s).q;
}

/// An edge function: at the first pixel of a tile, and over 16 as it grows to the right and down.
struct Edge {
    start: vec2<u32>,
    right: i32,
    down: i32,
    tie: i32,
}

fn edge64(a: vec2<i32>, b: vec2<i32>, p: vec2<i32>) -> Edge {
    return Edge(turn64(a, b, p), a.y - b.y, b.x - a.x, tie(b - a));
}

/// Its value i pixels to the right and j pixels down.
fn at(e: Edge, i: i32, j: i32) -> vec2<u32> {
    return add64(e.start, add64(imul_wide(16 * i, e.right), imul_wide(16 * j, e.down)));
}

/// Whether it is at least 0, ties by the rule, i pixels to the right and j pixels down.
fn is_inside(e: Edge, i: i32, j: i32) -> bool {
    return !is_negative(sub64(at(e, i, j), vec2<u32>(bitcast<u32>(e.tie), 0u)));
}

/// Whether it is at least 0 at some pixel of the tile i pixels to the right and j pixels down.
fn meets_tile(e: Edge, i: i32, j: i32) -> bool {
    return is_inside(e, i + select(0, 15, e.right > 0), j + select(0, 15, e.down > 0));
}

/// Draws a triangle of S > 0 into the pixels from `low` to `high`, which lie in the picture.
fn draw_wide(a: vec3<i32>, b: vec3<i32>, c: vec3<i32>, low: vec2<i32>, high: vec2<i32>, lane: u32, id: u32) {
    let s = turn64(a.xy, b.xy, c.xy);
    let p = 16 * low + 8;
    let bc = edge64(b.xy, c.xy, p);
    let ca = edge64(c.xy, a.xy, p);
    let ab = edge64(a.xy, b.xy, p);
    let db = b.z - a.z;
    let dc = c.z - a.z;
    // Along a row, along a column, and at the first pixel.
    var u = array<vec2<u32>, 3>(imul_wide(16, ca.right), imul_wide(16, ca.down), ca.start);
    var v = array<vec2<u32>, 3>(imul_wide(16, ab.right), imul_wide(16, ab.down), ab.start);
    var slopes: array<Slope, 3>;
    for (var k = 0u; k < 3u; k += 1u) {
        slopes[k] = slope64(u[k], v[k], db, dc, s);
    }
    let right = slopes[0];
    let down = slopes[1];
    var row_depth = slopes[2];
    let tile_right = sixteen64(right, s);
    let tile_down = sixteen64(down, s);
    row_depth.q += bitcast<u32>(a.z);

    let i = lane % 16u;
    let j = lane / 16u;
    let own_q = i * right.q + j * down.q;
    let own_r = add64(times(right.r, i), times(down.r, j));
    for (var y = 0; y <= high.y - low.y; y += 16) {
        var depth = row_depth;
        for (var x = 0; x <= high.x - low.x; x += 16) {
            if (meets_tile(bc, x, y) & meets_tile(ca, x, y) & meets_tile(ab, x, y)) {
                let own = vec2<i32>(x, y) + vec2<i32>(bitcast<i32>(i), bitcast<i32>(j));
                let inside = is_inside(bc, own.x, own.y) & is_inside(ca, own.x, own.y) & is_inside(ab, own.x, own.y);
                let pixel = low + own;
                if (inside & (pixel.x <= high.x) & (pixel.y <= high.y)) {
                    let z = depth.q + own_q + carries64(add64(depth.r, own_r), s);
                    plot(bitcast<u32>(pixel.y) * params.width + bitcast<u32>(pixel.x), z, id);
                }
            }
            depth = add_slope64(depth, tile_right, s);
        }
        row_depth = add_slope64(row_depth, tile_down, s);
    }
}

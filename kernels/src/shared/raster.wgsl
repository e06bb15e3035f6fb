// An integer rasteriser's edge test and depth: coverage without holes or overlaps along shared edges.

import package::shared::divide::udiv64_32;
import package::shared::wide::{add64, umul_wide};

/// (b - a) x (p - a): twice the area of a, b, p, positive for a turn from x to y.
fn turn(a: vec2<i32>, b: vec2<i32>, p: vec2<i32>) -> i32 {
    let d = b - a;
    return d.x * (p.y - a.y) - d.y * (p.x - a.x);
}

/// 1 where points on an edge along d belong to its other side, else 0.
fn tie(d: vec2<i32>) -> i32 {
    return select(1, 0, (d.y < 0) | ((d.y == 0) & (d.x > 0)));
}

/// (b - a) x (p - a), less 1 where points on the edge belong to its other side. Coordinates are in [0, 2^15). With y
/// growing upwards, p is in a counter-clockwise triangle iff this is at least 0 for its three edges; points on an edge
/// belong to the triangle whose edge runs down, or level and to the right.
fn edge15(a: vec2<i32>, b: vec2<i32>, p: vec2<i32>) -> i32 {
    return turn(a, b, p) - tie(b - a);
}

/// floor((w.x z.x + w.y z.y + w.z z.z) / area) for area = w.x + w.y + w.z in [1, 2^32) and every z below 2^24.
fn depth_at(w: vec3<u32>, z: vec3<u32>, area: u32) -> u32 {
    let n = add64(add64(umul_wide(w.x, z.x), umul_wide(w.y, z.y)), umul_wide(w.z, z.z));
    return udiv64_32(n, area).x;
}

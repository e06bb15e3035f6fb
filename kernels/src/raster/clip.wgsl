// From vertices to the screen: clip coordinates, the cut at the near plane, the sub-pixel grid (docs/numerics.md, The
// raster, steps 1 to 3). Every function is total: any words give coordinates within the bit budget.

import package::shared::divide::{fdiv64_sat, udiv64_32};
import package::shared::wide::{add64, imul_wide};

/// Clip coordinates are within this of 0.
const CLIP: i32 = 33554432;

/// floor(row.xyz . v / 2^16) + row.w, clamped.
fn clip_coordinate(row: vec4<i32>, v: vec3<i32>) -> i32 {
    let sum = add64(add64(imul_wide(row.x, v.x), imul_wide(row.y, v.y)), imul_wide(row.z, v.z));
    return clamp(bitcast<i32>((sum.y << 16u) | (sum.x >> 16u)) + row.w, -CLIP, CLIP);
}

/// The point with z = 0 on the way from a, where z >= 0, to b, where z < 0.
fn cut(a: vec4<i32>, b: vec4<i32>) -> vec4<i32> {
    let d = bitcast<u32>(a.z - b.z);
    let way = b - a;
    let x = fdiv64_sat(imul_wide(way.x, a.z), d);
    let y = fdiv64_sat(imul_wide(way.y, a.z), d);
    let w = fdiv64_sat(imul_wide(way.w, a.z), d);
    return vec4<i32>(a.x + x, a.y + y, 0, a.w + w);
}

/// round(scale * n / w) for w > 0, ties upwards.
fn nearest(n: i32, scale: u32, w: i32) -> i32 {
    let doubled = add64(imul_wide(n, bitcast<i32>(2u * scale)), vec2<u32>(bitcast<u32>(w), 0u));
    return fdiv64_sat(doubled, 2u * bitcast<u32>(w));
}

/// Screen coordinates and depth of a clip point with z >= 0; others get some. `near` is at least 1.
fn on_screen(p: vec4<i32>, size: vec2<u32>, near: i32) -> vec3<i32> {
    let w = max(p.w, near);
    let x = nearest(p.x, 8u * size.x, w) + bitcast<i32>(8u * size.x);
    let y = nearest(-p.y, 8u * size.y, w) + bitcast<i32>(8u * size.y);
    let inside = (p.z >= 0) & (p.z < w);
    let z = bitcast<u32>(select(0, p.z, inside));
    let depth = udiv64_32(vec2<u32>(z << 24u, z >> 8u), bitcast<u32>(w)).x;
    return vec3<i32>(x, y, bitcast<i32>(select(0xffffffu, depth, inside)));
}

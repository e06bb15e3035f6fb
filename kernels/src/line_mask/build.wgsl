// Tables of a pattern of samples over a space of lines: one mask, or two, a cell.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 5 and figure 3: the table is made once
// for a pattern, and works for any pattern. Output, for every cell and every word of a mask, samples s in bit s % bits
// of word s / bits, coordinates about the centre of the pattern:
//
//     build_exact     cells of the L1 line space (`line_cell.wgsl`) widened on every side by its slack: at 2 * words *
//     cell
//                     the samples that lie strictly inside every half-plane of the cell, at words more those that lie
//                     outside not every one
//     build_sampled   texels (angle, distance) of the Hough space, 2^k of each: at words * texel the samples inside the
//                     half-plane of the texel's centre
//
// A half-plane's value at a sample is affine in the direction t and in the offset, so its extremes over a cell are at
// the corners: ((T - t) u +- t v + (o - T) 2^h) / T for t and o in units of 1 / T, the slack. With T <= 2^16, |u|, |v|
// <= 2^h and h <= 14 both sides of every comparison stay below 2^31.

import package::shared::line::{Line, line_flip};

struct Params {
    /// Cell of the first invocation.
    first: u32,
    cells: u32,
    /// Samples lie in the square of half side 2^h.
    h: u32,
    /// log2 of the number of directions, or of angles.
    k: u32,
    samples: u32,
    bits: u32,
    words: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> samples: array<vec2<i32>>;
/// Cosine and sine of the centre of angle i, and distance i, all by 2^14.
@group(0) @binding(2) var<storage, read> axes: array<vec4<i32>>;
@group(0) @binding(3) var<storage, read_write> table: array<u32>;

struct Corners {
    /// Least and greatest direction, in units of 1 / whole.
    least: i32,
    greatest: i32,
    whole: i32,
    /// -1 where b < 0.
    sign: i32,
    /// What the direction's part must exceed to be inside at the least offset, and at the greatest.
    inside: i32,
    outside: i32,
}

fn corners(cell: u32) -> Corners {
    let k = params.k;
    let slack = min(10u, 16u - k);
    let whole = 1i << (k + slack);
    let offset = bitcast<i32>((cell & ((2u << k) - 1u)) << slack);
    let direction = bitcast<i32>(((cell >> (k + 1u)) & ((1u << k) - 1u)) << slack);
    let next = 1i << slack;
    let half = 1i << params.h;
    let sign = select(1, -1, (cell >> (2u * k + 1u)) != 0u);
    return Corners(direction - 1, direction + next + 1, whole, sign,
        (whole + 1 - offset) * half, (whole - 1 - offset - next) * half);
}

/// Samples that this word holds.
fn count(word: u32) -> u32 {
    return min(params.bits, params.samples - word * params.bits);
}

@compute @workgroup_size(256)
fn build_exact(@builtin(global_invocation_id) id: vec3<u32>) {
    let cell = params.first + id.x;
    if (cell >= params.cells) {
        return;
    }
    let c = corners(cell);
    var certain = 0u;
    var possible = 0u;
    let end = count(id.y);
    for (var bit = 0u; bit < end; bit += 1u) {
        let at = samples[id.y * params.bits + bit];
        let v = at.y * c.sign;
        let x = (c.whole - c.least) * at.x + c.least * v;
        let y = (c.whole - c.greatest) * at.x + c.greatest * v;
        certain |= select(0u, 1u, min(x, y) > c.inside) << bit;
        possible |= select(0u, 1u, max(x, y) >= c.outside) << bit;
    }
    let to = 2u * params.words * cell + id.y;
    table[to] = certain;
    table[to + params.words] = possible;
}

@compute @workgroup_size(256)
fn build_sampled(@builtin(global_invocation_id) id: vec3<u32>) {
    let texel = params.first + id.x;
    if (texel >= params.cells) {
        return;
    }
    let normal = axes[texel >> params.k].xy;
    let distance = axes[texel & ((1u << params.k) - 1u)].z;
    let has_ties = !line_flip(Line(normal.x, normal.y, vec2<u32>()));
    var inside = 0u;
    let end = count(id.y);
    for (var bit = 0u; bit < end; bit += 1u) {
        let at = samples[id.y * params.bits + bit];
        let value = normal.x * at.x + normal.y * at.y + distance;
        inside |= select(0u, 1u, (value > 0) | ((value == 0) & has_ties)) << bit;
    }
    table[params.words * texel + id.y] = inside;
}

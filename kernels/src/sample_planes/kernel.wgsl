// One projection for each sample of a light: the masks of a regular light as Heckbert and Herf make soft shadows, and
// the additive counts of silhouette volumes.
//
// Heckbert and Herf, "Simulating Soft Shadows with Graphics Hardware" (CMU-CS-97-104, 1997), draw all occluders once
// from each light sample onto the receiver; Eisemann and Décoret, "Visibility Sampling on GPU and Applications" (2007),
// section 10, compare with that. Here a sample's picture is a plane of bits, and 32 planes are a word of the masks.
// `grid.rs` has the definition that they meet bit for bit; triangles stand strictly between source and receivers.
//
// With ADDITIVE true the kernel takes soft shadow volumes instead (section 8; Assarsson et al. 2003): silhouettes are
// those from one point, and what each occluder hides is added up. The silhouettes of the triangles F that face that
// point are the boundary of F, and what a silhouette hides is the sum over F, each triangle signed by whether it faces
// the sample too: `hidden` then holds, for every receiver, the sum over F and all samples of 1 or -1, modulo 2^32.
//
// A workgroup takes a triangle, a band of receiver rows and 64 samples, a lane each. A receiver R is in a sample's
// shadow iff it is inside the three planes through the sample and an edge, turned so that the triangle is inside; the
// value N . (R - S) of such a plane is that of the definition's plane through R and the edge, negated. Where it is 0
// the definition's rule of ties looks at the normal of the latter.

import package::shared::crossing::edge_function;
import package::shared::view::View;
import package::shared::wide::{add64, dot64, imul_wide, sgn64};

const ADDITIVE: bool = false;

struct Params {
    /// Samples along x, and their number.
    sample_columns: u32,
    samples: u32,
    /// Receiver rows of a band.
    band: u32,
    /// First triangle, and one past the last.
    first: u32,
    end: u32,
    /// x and y of the point that silhouettes are seen from.
    from_x: i32,
    from_y: i32,
    _pad: u32,
    view: View,
}

@group(0) @binding(0) var<uniform> params: Params;
/// Nine coordinates a triangle.
@group(0) @binding(1) var<storage, read> vertices: array<i32>;
@group(0) @binding(2) var<storage, read_write> hidden: array<atomic<u32>>;

fn vertex(triangle: u32, corner: u32) -> vec3<i32> {
    let at = 9u * triangle + 3u * corner;
    return vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

/// Column and row, as real numbers, at which the line from a sample through a vertex meets the receivers' plane.
/// float: filter - off by less than a receiver where it falls on one, and never on one where the true place is 2^16 off
fn shadow_of(s: vec3<i32>, p: vec3<i32>) -> vec2<f32> {
    let reach = f32(params.view.height) / f32(p.z);
    let x = f32(s.x - params.view.receiver_x) + f32(p.x - s.x) * reach;
    let y = f32(s.y - params.view.receiver_y) + f32(p.y - s.y) * reach;
    return vec2<f32>(x / f32(params.view.receiver_step_x), y / f32(params.view.receiver_step_y));
}

/// First and last column, first and last row of a box that holds the shadow, one receiver wider on all sides.
/// float: filter - every receiver of the box is decided by exact signs
fn shadow_box(s: vec3<i32>, a: vec3<i32>, b: vec3<i32>, c: vec3<i32>) -> vec4<i32> {
    let p = shadow_of(s, a);
    let q = shadow_of(s, b);
    let r = shadow_of(s, c);
    let most = vec2<f32>(f32(params.view.columns), f32(params.view.rows));
    let low = clamp(min(min(p, q), r), vec2<f32>(0.0), most);
    let high = clamp(max(max(p, q), r), vec2<f32>(-1.0), most);
    return vec4<i32>(vec2<i32>(low) - 1, vec2<i32>(high + 1.0) + 1);
}

/// Whether the tie of a plane through r and the edge p q goes to the inner side.
fn takes_tie(r: vec3<i32>, p: vec3<i32>, q: vec3<i32>) -> bool {
    let n = edge_function(r, q, p);
    return (n.x > 0) | ((n.x == 0) & (n.y > 0));
}

fn is_zero(value: vec2<u32>) -> bool {
    return (value.x | value.y) == 0u;
}

/// Puts a receiver into the shadow of a sample.
fn hide(receiver: u32, sample: u32, sign: i32) {
    if (ADDITIVE) {
        atomicAdd(&hidden[receiver], bitcast<u32>(sign));
    } else {
        atomicOr(&hidden[(sample / 32u) * params.view.columns * params.view.rows + receiver], 1u << (sample % 32u));
    }
}

/// 1 if the triangle turns one way as s sees it, -1 if the other, 0 if s is in its plane.
fn facing(s: vec3<i32>, a: vec3<i32>, b: vec3<i32>, c: vec3<i32>) -> i32 {
    return sgn64(dot64(edge_function(s, a, b), c - s));
}

@compute @workgroup_size(64)
fn planes(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let triangle = params.first + group.x;
    let sample = group.y * 64u + lane;
    if ((triangle >= params.end) | (sample >= params.samples)) {
        return;
    }
    let view = params.view;
    let a = vertex(triangle, 0u);
    let b = vertex(triangle, 1u);
    let c = vertex(triangle, 2u);
    let column = bitcast<i32>(sample % params.sample_columns);
    let row = bitcast<i32>(sample / params.sample_columns);
    let s = vec3<i32>(view.sample_x + column * view.sample_step_x, view.sample_y + row * view.sample_step_y, 0);
    let turn = facing(s, a, b, c);
    if (turn == 0) {
        return;
    }
    // Determinants are negative for triangles that face the point by the right-hand rule.
    if (ADDITIVE && facing(vec3<i32>(params.from_x, params.from_y, 0), a, b, c) >= 0) {
        return;
    }
    let p = select(b, c, turn < 0);
    let q = select(c, b, turn < 0);
    let first = edge_function(s, a, p);
    let second = edge_function(s, p, q);
    let third = edge_function(s, q, a);

    let box = shadow_box(s, a, b, c);
    let x0 = max(box.x, 0);
    let x1 = min(box.z, bitcast<i32>(view.columns) - 1);
    let top = group.z * params.band;
    let bottom = min(top + params.band, view.rows);
    let y0 = max(box.y, bitcast<i32>(top));
    let y1 = min(box.w, bitcast<i32>(bottom) - 1);
    let across = vec3<i32>(first.x, second.x, third.x);
    let right_first = imul_wide(across.x, view.receiver_step_x);
    let right_second = imul_wide(across.y, view.receiver_step_x);
    let right_third = imul_wide(across.z, view.receiver_step_x);
    for (var y = y0; y <= y1; y += 1) {
        var r = vec3<i32>(view.receiver_x + x0 * view.receiver_step_x, view.receiver_y + y * view.receiver_step_y,
            view.height);
        var e = dot64(first, r - s);
        var f = dot64(second, r - s);
        var g = dot64(third, r - s);
        for (var x = x0; x <= x1; x += 1) {
            var is_inside = ((e.y | f.y | g.y) >> 31u) == 0u;
            // Ties are rare: most steps of most lanes take no branch but the next.
            if (is_inside & (is_zero(e) | is_zero(f) | is_zero(g))) {
                is_inside = (!is_zero(e) || takes_tie(r, a, p)) && (!is_zero(f) || takes_tie(r, p, q))
                    && (!is_zero(g) || takes_tie(r, q, a));
            }
            if (is_inside) {
                hide(bitcast<u32>(y) * view.columns + bitcast<u32>(x), sample, 0 - turn);
            }
            e = add64(e, right_first);
            f = add64(f, right_second);
            g = add64(g, right_third);
            r.x += view.receiver_step_x;
        }
    }
}

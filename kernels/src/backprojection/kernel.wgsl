// Backprojections: the lines on the source plane that bound what a triangle hides from a receiver, as exact integers.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 4. A line is four words: a, b, and c as
// a signed 64-bit number, low word first; its half-plane is a u + b v + c >= 0 with u, v in grid units of the source
// plane z = 0. |a|, |b| < 2^31, |c| < 2^48. Output, 16 words a pair of triangle and receiver: the lines of its edges
// (v0 v1, v1 v2, v2 v0; of a triangle seen in the other order v0 v2, v2 v1, v1 v0), positive inside; then the line of
// its own plane, positive on the other side than the receiver. A sample is hidden (`grid.rs`) iff it is in all three
// half-planes, a sample on the line only where a > 0, or a = 0 and b > 0, and strictly inside the fourth. A triangle
// whose plane holds the receiver hides nothing: its four lines are 0 u + 0 v - 1 >= 0.
//
// Nothing is divided, so a vertex at or beyond either plane needs no rule of its own.

import package::shared::backprojection::backproject;
import package::shared::line::Line;
import package::shared::view::{View, receiver_at};

struct Params {
    /// Pair or triangle of the first workgroup.
    first: u32,
    /// One past the last pair or triangle.
    end: u32,
    _pad0: u32,
    _pad1: u32,
    view: View,
}

@group(0) @binding(0) var<uniform> params: Params;
/// Nine coordinates a triangle.
@group(0) @binding(1) var<storage, read> vertices: array<i32>;
/// Triangle and receiver, by their numbers.
@group(0) @binding(2) var<storage, read> pairs: array<vec2<u32>>;
/// First and last column, first and last row of receivers: four words a triangle, as `influence_region` writes them.
@group(0) @binding(3) var<storage, read> regions: array<i32>;
/// Number of the first pair of each region.
@group(0) @binding(4) var<storage, read> starts: array<u32>;
/// Four lines a pair.
@group(0) @binding(5) var<storage, read_write> lines: array<vec4<u32>>;

fn vertex(triangle: u32, corner: u32) -> vec3<i32> {
    let at = 9u * triangle + 3u * corner;
    return vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

fn words(ln: Line) -> vec4<u32> {
    return vec4<u32>(bitcast<u32>(ln.a), bitcast<u32>(ln.b), ln.c);
}

fn store(pair: u32, triangle: u32, column: u32, row: u32) {
    let r = receiver_at(params.view, column, row);
    let found = backproject(r, vertex(triangle, 0u), vertex(triangle, 1u), vertex(triangle, 2u));
    lines[4u * pair] = words(found.first);
    lines[4u * pair + 1u] = words(found.second);
    lines[4u * pair + 2u] = words(found.third);
    lines[4u * pair + 3u] = words(found.own);
}

/// One invocation a pair of the list.
@compute @workgroup_size(64)
fn listed(@builtin(global_invocation_id) id: vec3<u32>) {
    let pair = params.first + id.x;
    if (pair < params.end) {
        let receiver = pairs[pair].y;
        store(pair, pairs[pair].x, receiver % params.view.columns, receiver / params.view.columns);
    }
}

/// One workgroup a triangle: all receivers of its region, row by row.
@compute @workgroup_size(64)
fn in_regions(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let triangle = params.first + group.x;
    if (triangle >= params.end) {
        return;
    }
    let column = bitcast<u32>(regions[4u * triangle]);
    let columns = bitcast<u32>(regions[4u * triangle + 1u]) + 1u - column;
    let row = bitcast<u32>(regions[4u * triangle + 2u]);
    let first = starts[triangle];
    let count = starts[triangle + 1u] - first;
    for (var i = lane; i < count; i += 64u) {
        store(first + i, triangle, column + i % columns, row + i / columns);
    }
}

// Half-planes: the samples of a regular light that any triangles hide from receivers on a parallel plane, exactly.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 4, 5 and 10: the three edges of a
// triangle cut three half-planes out of the source; where a triangle crosses the source or the receivers' plane, its
// own plane is a fourth. `grid.rs` has the definition that the masks meet bit for bit. Nothing is assumed of a
// triangle, so this kernel takes those that `row_span` does not. Output: as `row_span`.
//
// One workgroup serves COUNT receivers of one row: invocation = (light row, receiver), receivers fastest. In one light
// row a half-plane is all samples from a first one on, or all before it, found by bisection with exact signs; where its
// line is parallel to the row it is the whole row or nothing. A sample on an edge's line belongs to the side of larger
// x, or of larger y where the line is parallel to the row; a sample on the triangle's own plane is not hidden.

import package::shared::crossing::{edge_function, along_row, first_inside};
import package::shared::view::{View, receiver_at, sample_row, below};
import package::shared::wide::{imul_wide, add64, dot64, sgn64};

/// Samples along x: a power of two up to 32.
const COLUMNS: u32 = 32u;
/// Samples along y: a power of two up to 32.
const ROWS: u32 = 32u;
/// Whether triangles hide by their fronts alone: those whose back the receiver is behind hide nothing.
const ONE_SIDED: bool = false;
/// Receivers of one workgroup.
const COUNT = 256u / ROWS;

struct Params {
    /// Receiver row of the first workgroup row.
    first_row: u32,
    /// First triangle, and one past the last.
    first: u32,
    end: u32,
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

/// The samples of a row on the inner side of an edge; ties by the rule above.
fn inner(r: vec3<i32>, p: vec3<i32>, q: vec3<i32>, v: i32) -> u32 {
    let n = edge_function(r, p, q);
    let f = along_row(n, r, params.view.sample_x, v);
    if (n.x == 0) {
        let sign = sgn64(f.start);
        return select(0u, below(COLUMNS), (sign > 0) | ((sign == 0) & (n.y > 0)));
    }
    // For a falling E the samples before the crossing are inside: -E < 0 strictly, so a tie is outside.
    let k = first_inside(f, params.view.sample_step_x, COLUMNS);
    return select(below(COLUMNS) & ~below(k), below(k), n.x < 0);
}

/// The samples of a row strictly on the other side of a triangle's plane than the receiver.
fn beyond(r: vec3<i32>, a: vec3<i32>, b: vec3<i32>, c: vec3<i32>, v: i32) -> u32 {
    let side = sgn64(dot64(edge_function(a, b, c), r - a));
    // The normal that points away from the receiver; its sign is never 0 where the triangle is not edge-on.
    let n = edge_function(a, b, c) * (0 - side);
    let f = along_row(n, a, params.view.sample_x, v);
    if (n.x == 0) {
        return select(0u, below(COLUMNS), sgn64(f.start) > 0);
    }
    let k = first_inside(f, params.view.sample_step_x, COLUMNS);
    if (n.x < 0) {
        return below(k);
    }
    // A sample on the plane is not beyond it.
    let at_k = add64(f.start, imul_wide(f.slope, params.view.sample_step_x * bitcast<i32>(k)));
    let tie = (at_k.x | at_k.y) == 0u;
    return below(COLUMNS) & ~below(k + select(0u, 1u, tie));
}

/// The samples of the row at v that a triangle hides from r.
fn row_mask(triangle: u32, r: vec3<i32>, v: i32) -> u32 {
    let a = vertex(triangle, 0u);
    var b = vertex(triangle, 1u);
    var c = vertex(triangle, 2u);
    let orientation = sgn64(dot64(edge_function(r, a, b), c - r));
    if ((orientation == 0) | (ONE_SIDED & (orientation < 0))) {
        return 0u;
    }
    if (orientation < 0) {
        let swapped = b;
        b = c;
        c = swapped;
    }
    return inner(r, a, b, v) & inner(r, b, c, v) & inner(r, c, a, v) & beyond(r, a, b, c, v);
}

@compute @workgroup_size(256)
fn half_planes(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let row = params.first_row + group.y;
    let column = group.x * COUNT + lane % COUNT;
    let j = lane / COUNT;
    let r = receiver_at(params.view, column, row);
    let v = sample_row(params.view, j);
    var mask = 0u;
    for (var triangle = params.first; triangle < params.end; triangle += 1u) {
        mask |= row_mask(triangle, r, v);
    }
    if ((mask != 0u) & (column < params.view.columns)) {
        let sample = j * COLUMNS;
        let plane = (sample / 32u) * params.view.columns * params.view.rows;
        atomicOr(&hidden[plane + row * params.view.columns + column], mask << (sample % 32u));
    }
}

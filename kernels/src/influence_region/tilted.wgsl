// Influence regions on receivers of any plane: which of them a triangle can hide any sample from.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 3, equation 3: a triangle is projected
// from the four corners of the source by four uniform matrices, and the bounding box of the twelve projections is its
// region. Here the receivers are a lattice (`grid.rs`), receiver (i, r) at origin + i U + r V, and the box is exact in
// i and r:
//
//     first = the least whole number >= min p, last = the greatest whole number <= max p
//
// over the coordinates p of all projections, clamped to the receivers that exist. Output: (first column, last column,
// first row, last row) a triangle; the region is empty where a first exceeds its last.
//
// With d = vertex - sample, n = U x V turned away from the source, and m = sample - origin, a line from the sample
// through the vertex meets the plane, by Cramer's rule, at column ((m x V) . d) / (n . d) and row ((U x m) . d) / (n .
// d). The products with m are the matrices. n . d, the *weight*, is how much nearer the vertex is to the plane than the
// sample:
//
// * all weights positive: the box, which is the least one for a triangle that lies in front of the plane. A vertex
//   beyond the plane adds a point that its lines pass on their way, and the box still holds the region of the part in
//   front.
// * no weight positive: the triangle is farther from the plane than the source, hides nothing, and its region is empty.
//   So it is where the whole triangle lies in the source plane, or in or beyond the receivers' plane.
// * some positive: the projection is not bounded, and the region is all receivers.
//
// The last case is conservative, and so is a vertex beyond the plane. Components of d and m are below 2^15, of n and
// the matrices below 2^31, so weights and numerators are below 3 * 2^46.

import package::shared::wide::{add64, dot64, ltu64, sgn64, sub64, umul_wide};

/// A corner of the source and its matrix.
struct Corner {
    sample: vec4<i32>,
    /// m x V.
    column: vec4<i32>,
    /// U x m.
    row: vec4<i32>,
}

struct Params {
    triangles: u32,
    /// Triangle of the first invocation.
    first: u32,
    /// Receivers along U and V, up to 2^13 each.
    columns: u32,
    rows: u32,
    /// Receiver (0, 0).
    origin: vec4<i32>,
    /// Normal of the receivers' plane, pointing away from the source.
    normal: vec4<i32>,
    corners: array<Corner, 4>,
}

@group(0) @binding(0) var<uniform> params: Params;
/// Nine coordinates a triangle.
@group(0) @binding(1) var<storage, read> vertices: array<i32>;
/// Four words a triangle.
@group(0) @binding(2) var<storage, read_write> regions: array<i32>;

/// k a modulo 2^64.
fn multiple(a: vec2<u32>, k: u32) -> vec2<u32> {
    return add64(umul_wide(a.x, k), vec2<u32>(0u, a.y * k));
}

/// floor(n / d) for 0 <= n < 2^13 d, or one more or less.
/// float: guess - each conversion, the sum of positive terms and the quotient: less than 2^-19 relative, 2^-6 of the
/// result
fn near_quotient(n: vec2<u32>, d: vec2<u32>) -> u32 {
    let above = f32(n.y) * 4294967296.0 + f32(n.x);
    return u32(above / (f32(d.y) * 4294967296.0 + f32(d.x)));
}

/// (ceil(n / d), floor(n / d)), the first clamped to [0, count], the second to [-1, count); n signed, d > 0.
fn index_range(n: vec2<u32>, d: vec2<u32>, count: u32) -> vec2<i32> {
    if ((n.y >> 31u) != 0u) {
        return vec2<i32>(0, -1);
    }
    let size = bitcast<i32>(count);
    if (!ltu64(n, multiple(d, count))) {
        return vec2<i32>(size, size - 1);
    }
    let q = near_quotient(n, d);
    let rest = sub64(n, multiple(d, q)); // -d <= rest < 2 d
    let under = (rest.y >> 31u) != 0u;
    let over = !under & !ltu64(rest, d);
    let low = bitcast<i32>(q) + select(0, 1, over) - select(0, 1, under);
    let last = multiple(d, bitcast<u32>(low));
    return vec2<i32>(low + select(0, 1, any(last != n)), low);
}

fn join(a: vec2<i32>, b: vec2<i32>) -> vec2<i32> {
    return vec2<i32>(min(a.x, b.x), max(a.y, b.y));
}

fn store(triangle: u32, columns: vec2<i32>, rows: vec2<i32>) {
    let at = 4u * triangle;
    regions[at] = columns.x;
    regions[at + 1u] = columns.y;
    regions[at + 2u] = rows.x;
    regions[at + 3u] = rows.y;
}

@compute @workgroup_size(64)
fn tilted_region(@builtin(global_invocation_id) id: vec3<u32>) {
    let triangle = params.first + id.x;
    if (triangle >= params.triangles) {
        return;
    }
    // Joined with nothing yet.
    var columns = vec2<i32>(bitcast<i32>(params.columns), -1);
    var rows = vec2<i32>(bitcast<i32>(params.rows), -1);
    var positive = 0u;
    var in_front = false;
    var off_source = false;
    for (var corner = 0u; corner < 3u; corner += 1u) {
        let at = 9u * triangle + 3u * corner;
        let vertex = vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
        in_front = in_front | (sgn64(dot64(params.normal.xyz, vertex - params.origin.xyz)) < 0);
        off_source = off_source | (vertex.z > 0);
        for (var from_corner = 0u; from_corner < 4u; from_corner += 1u) {
            let d = vertex - params.corners[from_corner].sample.xyz;
            let weight = dot64(params.normal.xyz, d);
            if (sgn64(weight) > 0) {
                positive += 1u;
                let column = dot64(params.corners[from_corner].column.xyz, d);
                let row = dot64(params.corners[from_corner].row.xyz, d);
                columns = join(columns, index_range(column, weight, params.columns));
                rows = join(rows, index_range(row, weight, params.rows));
            }
        }
    }
    if ((positive == 0u) | !in_front | !off_source) {
        columns = vec2<i32>(0, -1);
        rows = vec2<i32>(0, -1);
    } else if (positive < 12u) {
        columns = vec2<i32>(0, bitcast<i32>(params.columns) - 1);
        rows = vec2<i32>(0, bitcast<i32>(params.rows) - 1);
    }
    store(triangle, columns, rows);
}

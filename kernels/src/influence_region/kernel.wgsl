// Influence regions: which receivers a triangle can hide any sample from.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 3: a triangle is projected from the four
// corners of the source, and the bounding box of the projections is its region. On the grid (`grid.rs`) the corners are
// the outermost samples and the receivers are points, so the box is exact: for each axis
//
//     first = the least i, last = the greatest i, with  min p <= origin + step * i <= max p
//
// over all points p where a line from a corner sample through a vertex meets the receivers' plane, clamped to the
// receivers that exist. Output: (first column, last column, first row, last row) a triangle; the region is empty where
// a first exceeds its last. `tilted.wgsl` is the same for receivers on any plane.
//
// The box is the least one for a triangle that lies between the planes. Where a triangle stands partly beyond the
// receivers' plane, the lines to its vertices there meet the plane on their way, and the box still holds the region of
// the part in front: that part's points are means of the vertices, and so are their projections. A triangle with a
// vertex in the source plane has no bounded projection, and its region is all receivers. A triangle that lies wholly in
// or beyond one of the planes hides nothing, and its region is empty.
//
// Of a one-sided triangle (`ONE_SIDED`) the samples are those in front of it alone: the corners above are then those of
// the box around them, and the region is the least box around the projections from all of them. Section 3, figure 1,
// has no region for this case; docs/numerics.md derives it.
//
// With w = height - z a line from sample coordinate s through (v, z) meets the plane at (v * height - s * w) / z. All
// numerators stay below 2^31: |v * height|, |s * w|, |origin * z| <= 2^29.

import package::shared::crossing::{Function, along_row, edge_function, first_inside};
import package::shared::wide::add64;

/// Whether triangles hide by their fronts alone.
const ONE_SIDED: bool = false;

struct Params {
    triangles: u32,
    height: i32,
    /// Receivers along x and y.
    columns: u32,
    rows: u32,
    receiver_x: i32,
    receiver_y: i32,
    receiver_step_x: u32,
    receiver_step_y: u32,
    /// First and last sample coordinate along x, then along y.
    sample_first_x: i32,
    sample_last_x: i32,
    sample_first_y: i32,
    sample_last_y: i32,
    /// Triangle of the first invocation.
    first: u32,
    /// Distances and numbers of samples along x and y.
    sample_step_x: i32,
    sample_step_y: i32,
    sample_columns: u32,
    sample_rows: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
/// Nine coordinates a triangle.
@group(0) @binding(1) var<storage, read> vertices: array<i32>;
/// Four words a triangle.
@group(0) @binding(2) var<storage, read_write> regions: array<i32>;

/// floor(n / d).
fn floor_div(n: i32, d: u32) -> i32 {
    let negative = n < 0;
    let magnitude = select(bitcast<u32>(n), bitcast<u32>(-1 - n), negative);
    let quotient = bitcast<i32>(magnitude / d);
    return select(quotient, -1 - quotient, negative);
}

/// Smallest and largest receiver index that lines through one vertex reach.
fn reach(v: i32, z: i32, first: i32, last: i32, origin: i32, step: u32) -> vec2<i32> {
    // Beyond the receivers w is negative, and the samples project in the other order.
    let w = params.height - z;
    let nearest = min(first * w, last * w);
    let farthest = max(first * w, last * w);
    let base = v * params.height - origin * z;
    let d = step * bitcast<u32>(z);
    // The least index is a ceiling: -floor(-n / d).
    return vec2<i32>(-floor_div(farthest - base, d), floor_div(base - nearest, d));
}

fn join(a: vec2<i32>, b: vec2<i32>) -> vec2<i32> {
    return vec2<i32>(min(a.x, b.x), max(a.y, b.y));
}

/// First and last sample of an axis that see a front in any row across it; none where the first exceeds the last. `n`
/// and `a` are a normal and a point of the triangle, and `first`, `last` the ends of the two axes, all with this axis
/// as x.
fn seen(n: vec3<i32>, a: vec3<i32>, first: vec2<i32>, last: vec2<i32>, step: i32, count: u32) -> vec2<i32> {
    // Of a column of samples the end that is farther along the normal sees the front if any does.
    let f = along_row(n, a, first.x, select(first.y, last.y, n.y > 0));
    if (n.x < 0) {
        return vec2<i32>(0, bitcast<i32>(first_inside(f, step, count)) - 1);
    }
    // A sample on the plane sees no face: E > 0 is E - 1 >= 0.
    let above = Function(f.slope, add64(f.start, vec2<u32>(0xffffffffu)));
    return vec2<i32>(bitcast<i32>(first_inside(above, step, count)), bitcast<i32>(count) - 1);
}

/// The coordinates of those samples.
fn ends(first: i32, step: i32, seen: vec2<i32>) -> vec2<i32> {
    return vec2<i32>(first) + step * seen;
}

fn store(triangle: u32, x: vec2<i32>, y: vec2<i32>) {
    let at = 4u * triangle;
    regions[at] = max(x.x, 0);
    regions[at + 1u] = min(x.y, bitcast<i32>(params.columns) - 1);
    regions[at + 2u] = max(y.x, 0);
    regions[at + 3u] = min(y.y, bitcast<i32>(params.rows) - 1);
}

@compute @workgroup_size(64)
fn influence_region(@builtin(global_invocation_id) id: vec3<u32>) {
    let triangle = params.first + id.x;
    if (triangle >= params.triangles) {
        return;
    }
    let at = 9u * triangle;
    let z = vec3<i32>(vertices[at + 2u], vertices[at + 5u], vertices[at + 8u]);
    let low = min(min(z.x, z.y), z.z);
    let high = max(max(z.x, z.y), z.z);
    if ((high <= 0) | (low >= params.height)) {
        store(triangle, vec2<i32>(0, -1), vec2<i32>(0, -1));
        return;
    }
    if (low <= 0) {
        store(triangle, vec2<i32>(0, 0x7fffffff), vec2<i32>(0, 0x7fffffff));
        return;
    }
    var sample_x = vec2<i32>(params.sample_first_x, params.sample_last_x);
    var sample_y = vec2<i32>(params.sample_first_y, params.sample_last_y);
    if (ONE_SIDED) {
        let a = vec3<i32>(vertices[at], vertices[at + 1u], z.x);
        let b = vec3<i32>(vertices[at + 3u], vertices[at + 4u], z.y);
        let c = vec3<i32>(vertices[at + 6u], vertices[at + 7u], z.z);
        let n = edge_function(a, b, c);
        let first = vec2<i32>(sample_x.x, sample_y.x);
        let last = vec2<i32>(sample_x.y, sample_y.y);
        let columns = seen(n, a, first, last, params.sample_step_x, params.sample_columns);
        let rows = seen(n.yxz, a.yxz, first.yx, last.yx, params.sample_step_y, params.sample_rows);
        if (columns.x > columns.y) {
            store(triangle, vec2<i32>(0, -1), vec2<i32>(0, -1));
            return;
        }
        sample_x = ends(sample_x.x, params.sample_step_x, columns);
        sample_y = ends(sample_y.x, params.sample_step_y, rows);
    }
    var x = vec2<i32>(0x7fffffff, -0x7fffffff);
    var y = x;
    for (var corner = 0u; corner < 3u; corner += 1u) {
        let v = at + 3u * corner;
        x = join(x, reach(vertices[v], vertices[v + 2u], sample_x.x, sample_x.y,
            params.receiver_x, params.receiver_step_x));
        y = join(y, reach(vertices[v + 1u], vertices[v + 2u], sample_y.x, sample_y.y,
            params.receiver_y, params.receiver_step_y));
    }
    store(triangle, x, y);
}

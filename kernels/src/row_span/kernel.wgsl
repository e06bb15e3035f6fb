// Row spans: the samples of a regular light that triangles hide from receivers on a parallel plane, exactly.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 4 and 5, by row spans instead of a table:
// the backprojection of a triangle covers, in each row of the light, one span of samples between two edges. `grid.rs` has
// the definition that the masks meet bit for bit. Output: bit s % 32 of `hidden[(s / 32) * receivers + r]` is set if any
// triangle of r's tile list hides sample s from receiver r; other bits are left as they are.
//
// Triangles lie strictly between the planes: 0 < z < height for every vertex. Then, on the parallel planes:
//
// * The backprojected y of a vertex is the same for all receivers of a row, so the first light row at or above it,
//   J = clamp(ceil(N / Z), 0, ROWS) with N = y * height - ry * z - v0 * w, Z = step * w, w = height - z, is found once.
// * Row j is crossed by exactly the two edges with J_low <= j < J_high: the one from the lowest vertex to the highest, and
//   one of the other two. Samples on a vertex's row or an edge fall to one side by the same rule for all triangles.
// * The crossing of an edge is bilinear in receiver column i and light row j: x = P + i C + j (Q + i D), in samples. An f32
//   value of it decides how many samples lie before the crossing, unless it is too near to a sample for its error; then
//   the exact sign of the edge function does, found by bisection.
//
// One workgroup serves COUNT receivers of one row: invocation = (light row, receiver), receivers fastest. It prepares up to
// 256 triangles at a time, one an invocation, then all invocations take one after the other.

import package::shared::crossing::{edge_function, along_row, first_inside};
import package::shared::view::{View, receiver_at, sample_row, below};

/// Samples along x: a power of two up to 32.
const COLUMNS: u32 = 32u;
/// Samples along y: a power of two up to 32.
const ROWS: u32 = 32u;
/// Entries of a list that a launch takes.
const LIST: u32 = 4096u;
/// Receivers of one workgroup.
const COUNT = 256u / ROWS;

struct Params {
    /// Receiver row of the first workgroup row.
    first_row: u32,
    /// Receiver rows that share a tile list.
    tile_rows: u32,
    /// Tiles along x, COUNT receivers each.
    tiles: u32,
    /// Entries of each list that earlier launches have taken.
    skip: u32,
    view: View,
}

@group(0) @binding(0) var<uniform> params: Params;
/// Nine coordinates a triangle.
@group(0) @binding(1) var<storage, read> vertices: array<i32>;
/// Tile t has the list entries `starts[t]` up to `starts[t + 1]`.
@group(0) @binding(2) var<storage, read> starts: array<u32>;
@group(0) @binding(3) var<storage, read> entries: array<u32>;
@group(0) @binding(4) var<storage, read_write> hidden: array<atomic<u32>>;

/// What all invocations need of a triangle: rows and order of its vertices, then the coefficients P, C, Q, D of its three
/// edges and the distance from a sample within which f32 does not decide, as f32 bits.
struct Setup {
    rows: u32,
    limit: u32,
    long_edge: vec4<u32>,
    lower_edge: vec4<u32>,
    upper_edge: vec4<u32>,
}

var<workgroup> setups: array<Setup, 256>;

fn vertex(triangle: u32, corner: u32) -> vec3<i32> {
    let at = 9u * triangle + 3u * corner;
    return vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

/// First light row at or above the backprojection of a vertex: clamp(ceil(N / Z), 0, ROWS).
fn first_row(v: vec3<i32>, ry: i32) -> u32 {
    let w = params.view.height - v.z;
    let n = v.y * params.view.height - ry * v.z - params.view.sample_y * w;
    let z = bitcast<u32>(params.view.sample_step_y * w);
    return select(min((bitcast<u32>(n) + z - 1u) / z, ROWS), 0u, n <= 0);
}

struct Edge {
    /// P (with the half sample of rounding), C, Q, D.
    coefficients: vec4<f32>,
    /// Sum of the magnitudes that the crossing is made of.
    size: f32,
}

/// float: filter - the size bounds the error of every crossing made from these coefficients
fn edge(p: vec3<i32>, q: vec3<i32>, x0: i32, ry: i32) -> Edge {
    let h = params.view.height;
    let w = h - p.z;
    let wz = q.z - p.z;
    let a = p.y * (q.z - h) - q.y * (p.z - h) - ry * wz;
    let b = q.x * (p.z - h) - p.x * (q.z - h) + x0 * wz;
    let step = params.view.receiver_step_x;
    let per_x = 1.0 / f32(params.view.sample_step_x * w);
    let x1 = f32(p.x * h - x0 * p.z - params.view.sample_x * w) * per_x;
    let c1 = f32(0 - step * p.z) * per_x;
    let y1 = f32(p.y * h - ry * p.z - params.view.sample_y * w) / f32(params.view.sample_step_y * w);
    // An edge along the rows is crossed by none.
    let per_a = f32(params.view.sample_step_y) / f32(params.view.sample_step_x) / f32(select(a, 1, a == 0));
    let slope = f32(0 - b) * per_a;
    let turn = f32(0 - step * wz) * per_a;
    let last = f32(COUNT - 1u);
    let size = 1.0 + abs(x1) + last * abs(c1) + (32.0 + 2.0 * abs(y1)) * (abs(slope) + last * abs(turn));
    return Edge(vec4<f32>(x1 - y1 * slope + 0.5, c1 - y1 * turn, slope, turn), size);
}

/// Vertex 0, 1 or 2.
fn pick(a: vec3<i32>, b: vec3<i32>, c: vec3<i32>, number: u32) -> vec3<i32> {
    return select(select(a, b, number == 1u), c, number == 2u);
}

/// float: filter - 2^-18 of the size is twice the error of a crossing
fn prepare(slot: u32, triangle: u32, x0: i32, ry: i32) {
    let a = vertex(triangle, 0u);
    let b = vertex(triangle, 1u);
    let c = vertex(triangle, 2u);
    // Rows are sorted with the numbers of their vertices beneath them, so that no two are equal.
    let keys = vec3<u32>(4u * first_row(a, ry), 4u * first_row(b, ry) + 1u, 4u * first_row(c, ry) + 2u);
    let least = min(keys.x, min(keys.y, keys.z));
    let most = max(keys.x, max(keys.y, keys.z));
    let sorted = vec3<u32>(least, keys.x ^ keys.y ^ keys.z ^ least ^ most, most);
    let rows = sorted >> vec3<u32>(2u);
    let order = sorted & vec3<u32>(3u);
    let low = pick(a, b, c, order.x);
    let middle = pick(a, b, c, order.y);
    let high = pick(a, b, c, order.z);
    setups[slot].rows = rows.x | (rows.y << 6u) | (rows.z << 12u)
        | (order.x << 18u) | (order.y << 20u) | (order.z << 22u);
    if (rows.x == rows.z) {
        return;
    }
    let long_edge = edge(low, high, x0, ry);
    let lower = edge(low, middle, x0, ry);
    let upper = edge(middle, high, x0, ry);
    // An edge that no row crosses can be of any size: it is never used.
    var size = long_edge.size;
    size = max(size, select(lower.size, 0.0, rows.x == rows.y));
    size = max(size, select(upper.size, 0.0, rows.y == rows.z));
    setups[slot].limit = bitcast<u32>(0.5 - size * 0.000003814697265625);
    setups[slot].long_edge = bitcast<vec4<u32>>(long_edge.coefficients);
    setups[slot].lower_edge = bitcast<vec4<u32>>(lower.coefficients);
    setups[slot].upper_edge = bitcast<vec4<u32>>(upper.coefficients);
}

/// Exact number of samples of a light row before the crossing of an edge: the least k with E(k) >= 0, where E is the edge
/// function with the sign that makes it grow.
fn exact_crossing(p: vec3<i32>, q: vec3<i32>, r: vec3<i32>, j: u32) -> u32 {
    let v = sample_row(params.view, j);
    return first_inside(along_row(edge_function(r, p, q), r, params.view.sample_x, v), params.view.sample_step_x, COLUMNS);
}

/// The samples of light row j that a triangle hides from receiver (i, row).
///
/// float: filter - a crossing nearer to a sample than its error is decided by `exact_crossing`
fn span(slot: u32, triangle: u32, i: u32, j: u32, x0: i32, ry: i32) -> u32 {
    let rows = setups[slot].rows;
    let first = rows & 63u;
    let middle = (rows >> 6u) & 63u;
    let last = (rows >> 12u) & 63u;
    var mask = 0u;
    if ((j >= first) & (j < last)) {
        let column = f32(i);
        let line = f32(j);
        let limit = bitcast<f32>(setups[slot].limit);
        let one = bitcast<vec4<f32>>(setups[slot].long_edge);
        let is_lower = j < middle;
        let two = bitcast<vec4<f32>>(select(setups[slot].upper_edge, setups[slot].lower_edge, is_lower));
        let x = one.x + column * one.y + line * (one.z + column * one.w);
        let y = two.x + column * two.y + line * (two.z + column * two.w);
        let left = clamp(min(x, y), 0.0, f32(COLUMNS));
        let right = clamp(max(x, y), 0.0, f32(COLUMNS));
        let near_left = floor(left + 0.5);
        let near_right = floor(right + 0.5);
        var from_sample = u32(near_left);
        var to_sample = u32(near_right);
        let doubt = max(abs(left - near_left), abs(right - near_right));
        if (!(doubt < limit)) {
            let r = vec3<i32>(x0 + bitcast<i32>(i) * params.view.receiver_step_x, ry, params.view.height);
            let low = vertex(triangle, (rows >> 18u) & 3u);
            let centre = vertex(triangle, (rows >> 20u) & 3u);
            let high = vertex(triangle, (rows >> 22u) & 3u);
            let a = exact_crossing(low, high, r, j);
            let b = exact_crossing(select(high, low, is_lower), centre, r, j);
            from_sample = min(a, b);
            to_sample = max(a, b);
        }
        mask = below(to_sample) & ~below(from_sample);
    }
    return mask;
}

@compute @workgroup_size(256)
fn row_span(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let row = params.first_row + group.y;
    let corner = receiver_at(params.view, group.x * COUNT, row);
    let x0 = corner.x;
    let ry = corner.y;
    let i = lane % COUNT;
    let j = lane / COUNT;
    let tile = (row / params.tile_rows) * params.tiles + group.x;
    let first = starts[tile] + params.skip;
    let end = min(starts[tile + 1u], first + LIST);
    var mask = 0u;
    for (var start = first; start < end; start += 256u) {
        let count = min(end - start, 256u);
        workgroupBarrier();
        if (lane < count) {
            prepare(lane, entries[start + lane], x0, ry);
        }
        workgroupBarrier();
        for (var slot = 0u; slot < count; slot += 1u) {
            mask |= span(slot, entries[start + slot], i, j, x0, ry);
        }
    }
    let column = group.x * COUNT + i;
    if ((mask != 0u) & (column < params.view.columns)) {
        let sample = j * COLUMNS;
        let plane = (sample / 32u) * params.view.columns * params.view.rows;
        atomicOr(&hidden[plane + row * params.view.columns + column], mask << (sample % 32u));
    }
}

// Row spans: the samples of a regular light that triangles hide from receivers on a parallel plane, exactly.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 4 and 5, by row spans instead of a table:
// the backprojection of a triangle covers, in each row of the light, one span of samples between two edges. `grid.rs` has
// the definition that the masks meet bit for bit. Output: bit s % 32 of `hidden[(s / 32) * receivers + r]` is set if any
// triangle of r's tile list hides sample s from receiver r; other bits are left as they are.
//
// Triangles lie strictly between the planes: 0 < z < height for every vertex. A row of receivers and a row of samples are
// parallel, so one plane holds both, and what a triangle hides there is told by where its edges meet that plane:
//
// * f(v) = y * height - ry * z - v0 * (height - z) says on which side a vertex stands; a triangle meets the plane iff one
//   vertex has another side than the other two, and the two edges from it cross. f > 0 is one side, f <= 0 the other, so
//   what lies on the plane falls to one side by the same rule for all triangles.
// * The crossing of an edge is the mean of its vertices, weighted by the |f| of the other. From receiver i it is seen
//   before a sample at x(i) = a - i b, in steps of the samples, and hides those k with x <= k of one edge and k < x of the
//   other. Numbers of 18 binary places hold a and b; where x is too near to a whole number for their error, the sign of
//   x - k decides, a sum of two products of integers.
//
// One workgroup serves WIDTH by HEIGHT receivers. Invocations first are triangles, 256 of the list at a time, and find
// which rows of samples they meet for each row of receivers. Each such pair is an item; items wait on a stack until there is
// one for every invocation. Then invocations are items, and each finds its spans for WIDTH receivers. So work is done for what
// meets a row of samples alone, and nearly all lanes have it. The order of items cannot show: spans are joined by OR.

import package::shared::wide::{imul_wide, add64};
import package::shared::view::{View, receiver_at, sample_row};

/// Samples along x: a power of two up to 32.
const COLUMNS: u32 = 32u;
/// Samples along y: a power of two up to 32.
const ROWS: u32 = 32u;
/// Entries of a list that a launch takes.
const LIST: u32 = 4096u;
/// Receivers of one workgroup along x.
const WIDTH: u32 = 16u;
/// Receivers of one workgroup along y.
const HEIGHT: u32 = 4u;
/// Receivers of one workgroup.
const RECEIVERS = WIDTH * HEIGHT;
/// Rows of samples in a word of a mask.
const ROWS_PER_WORD = 32u / COLUMNS;

/// One step between samples, and the bits below it.
const ONE = 262144;
const FRACTION = 262143;
/// Lanes, and triangles or items that they take at a time.
const LANES = 256u;

struct Params {
    /// Receiver row of the first workgroup row.
    first_row: u32,
    /// Receiver rows that share a tile list: a multiple of HEIGHT.
    tile_rows: u32,
    /// Tiles along x, WIDTH receivers each.
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
@group(0) @binding(4) var<storage, read_write> hidden: array<u32>;

/// Row j of the mask of receiver (i, line) at (j * HEIGHT + line) * WIDTH + i.
var<workgroup> masks: array<atomic<u32>, ROWS * RECEIVERS>;
/// Items that wait, as `item` makes them.
var<workgroup> items: array<u32, 512>;
var<workgroup> pushed: atomic<u32>;
var<workgroup> waiting: u32;

fn vertex(triangle: u32, corner: u32) -> vec3<i32> {
    let at = 9u * triangle + 3u * corner;
    return vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

/// A vertex as its backprojection moves over the rows of samples: row (n - line * n_step) / d for a row of receivers.
struct Track {
    n: i32,
    n_step: i32,
    per_d: f32,
}

/// float: filter - 1 / d is off by less than 2^-21 of it
fn track(triangle: u32, corner: u32, ry: i32) -> Track {
    let v = vertex(triangle, corner);
    let w = params.view.height - v.z;
    let n = v.y * params.view.height - ry * v.z - params.view.sample_y * w;
    return Track(n, params.view.receiver_step_y * v.z, 1.0 / f32(params.view.sample_step_y * w));
}

/// float: filter - off by less than 2^-20 of it
fn row_of(t: Track, line: u32) -> f32 {
    return f32(t.n - bitcast<i32>(line) * t.n_step) * t.per_d;
}

/// First row of samples that three vertices may stand on either side of, and one past the last.
///
/// float: filter - rows up to 64 are off by less than 2^-10, so none is missed; those beyond are past all samples
fn rows_met(a: f32, b: f32, c: f32) -> vec2<u32> {
    let first = clamp(min(min(a, b), c) - 0.0009765625, 0.0, f32(ROWS));
    let last = clamp(max(max(a, b), c) + 0.0009765625, 0.0, f32(ROWS));
    return vec2<u32>(u32(ceil(first)), u32(ceil(last)));
}

/// A triangle, a row of receivers and a row of samples.
fn item(triangle: u32, line: u32, j: u32) -> u32 {
    return (triangle << 7u) | (line << 5u) | j;
}

/// allow(atomic-result): the order of items cannot show, as spans are joined by OR
fn push(item: u32) {
    items[atomicAdd(&pushed, 1u)] = item;
}

/// Number of items that wait, the same for all invocations.
fn depth(lane: u32) -> u32 {
    workgroupBarrier();
    if (lane == 0u) {
        waiting = atomicLoad(&pushed);
    }
    return workgroupUniformLoad(&waiting);
}

/// A vertex, and f of it.
fn sided(v: vec3<i32>, ry: i32, v0: i32) -> vec4<i32> {
    return vec4<i32>(v, v.y * params.view.height - ry * v.z - v0 * (params.view.height - v.z));
}

/// An edge that crosses the plane, each vertex with the weight that it has in the crossing.
struct Edge {
    p: vec4<i32>,
    q: vec4<i32>,
}

fn edge(p: vec4<i32>, q: vec4<i32>) -> Edge {
    return Edge(vec4<i32>(p.xyz, abs(q.w)), vec4<i32>(q.xyz, abs(p.w)));
}

/// Where an edge is seen from receiver i before the samples: at (start - i * slope) / ONE, with an error up to
/// `doubt` / ONE.
struct Crossing {
    start: i32,
    slope: i32,
    doubt: i32,
}

/// How far from u a vertex is seen from rx on the samples' plane, times its distance from the receivers' plane.
fn reach(v: vec4<i32>, rx: i32, u: i32) -> i32 {
    return v.x * params.view.height - rx * v.z - u * (params.view.height - v.z);
}

/// The crossing of an edge for the receivers from rx on; a doubt of ONE where it is too far away to be told.
///
/// float: filter - `doubt` bounds the error of all receivers of the workgroup
fn crossing(e: Edge, rx: i32) -> Crossing {
    let p_weight = f32(e.p.w);
    let q_weight = f32(e.q.w);
    let w = f32(params.view.height - e.p.z) * p_weight + f32(params.view.height - e.q.z) * q_weight;
    let scale = f32(ONE) / (f32(params.view.sample_step_x) * w);
    let p = f32(reach(e.p, rx, params.view.sample_x)) * p_weight;
    let q = f32(reach(e.q, rx, params.view.sample_x)) * q_weight;
    let z = f32(e.p.z) * p_weight + f32(e.q.z) * q_weight;
    let slope = f32(params.view.receiver_step_x) * z * scale;
    let size = (abs(p) + abs(q)) * scale + f32(WIDTH) * slope;
    if (!(size < 1073741824.0)) {
        return Crossing(0, 0, ONE);
    }
    return Crossing(i32((p + q) * scale), i32(slope), i32(size * 0.0000019073486328125) + 20);
}

/// Whether x <= k, exactly.
fn is_reached(e: Edge, rx: i32, k: i32) -> bool {
    let u = params.view.sample_x + params.view.sample_step_x * k;
    let sum = add64(imul_wide(reach(e.p, rx, u), e.p.w), imul_wide(reach(e.q, rx, u), e.q.w));
    return (bitcast<i32>(sum.y) < 0) | ((sum.x | sum.y) == 0u);
}

/// The half of a range of numbers that holds the least k that is reached.
fn halved(e: Edge, rx: i32, range: vec2<i32>) -> vec2<i32> {
    let k = (range.x + range.y) >> 1u;
    let is_open = range.x < range.y;
    let reached = is_reached(e, rx, min(k, bitcast<i32>(COLUMNS) - 1));
    return vec2<i32>(select(range.x, k + 1, is_open & !reached), select(range.y, k, is_open & reached));
}

/// Exact number of samples before the crossing of an edge: ceil(x), between 0 and COLUMNS. `guess` is off by less than a
/// quarter, unless the crossing could not be told.
fn before(e: Edge, rx: i32, guess: i32, is_told: bool) -> i32 {
    let columns = bitcast<i32>(COLUMNS);
    if (is_told) {
        // Between nearest - 1 and nearest + 1.
        let nearest = (guess + ONE / 2) >> 18u;
        let k = clamp(nearest, 0, columns - 1);
        let exact = select(k + 1, k, is_reached(e, rx, k));
        return select(exact, select(columns, 0, nearest < 0), nearest != k);
    }
    // Six halvings leave one of 33 numbers; no loop, as turns of loops are few (docs/numerics.md).
    let few = halved(e, rx, halved(e, rx, halved(e, rx, vec2<i32>(0, columns))));
    return halved(e, rx, halved(e, rx, halved(e, rx, few))).x;
}

/// Adds what an item hides from `count` receivers to the masks.
fn take(item: u32, x0: i32, y0: i32, count: u32) {
    let triangle = item >> 7u;
    let line = (item >> 5u) & 3u;
    let j = item & 31u;
    let ry = y0 + params.view.receiver_step_y * bitcast<i32>(line);
    let v0 = sample_row(params.view, j);
    let a = sided(vertex(triangle, 0u), ry, v0);
    let b = sided(vertex(triangle, 1u), ry, v0);
    let c = sided(vertex(triangle, 2u), ry, v0);
    let is_a = ((b.w > 0) == (c.w > 0)) & ((a.w > 0) != (b.w > 0));
    let is_b = ((c.w > 0) == (a.w > 0)) & ((b.w > 0) != (c.w > 0));
    let is_c = ((a.w > 0) == (b.w > 0)) & ((c.w > 0) != (a.w > 0));
    if (!(is_a | is_b | is_c)) {
        return;
    }
    let alone = select(select(c, b, is_b), a, is_a);
    let one = edge(alone, select(select(a, c, is_b), b, is_a));
    let two = edge(alone, select(select(b, a, is_b), c, is_a));
    spans(one, two, (j * HEIGHT + line) * WIDTH, x0, count);
}

/// Adds the samples between two edges to the masks of `count` receivers, from `place` on.
fn spans(one: Edge, two: Edge, place: u32, x0: i32, count: u32) {
    let first = crossing(one, x0);
    let second = crossing(two, x0);
    let doubt = max(first.doubt, second.doubt);
    // Where x is no whole number ceil(x) is floor(x + 1).
    var x = first.start + ONE;
    var y = second.start + ONE;
    for (var i = 0u; i < count; i += 1u) {
        var low = min(x, y) >> 18u;
        var high = max(x, y) >> 18u;
        if (min((x + doubt) & FRACTION, (y + doubt) & FRACTION) <= 2 * doubt) {
            let rx = x0 + params.view.receiver_step_x * bitcast<i32>(i);
            let from_one = before(one, rx, x - ONE, first.doubt < ONE);
            let from_two = before(two, rx, y - ONE, second.doubt < ONE);
            low = min(from_one, from_two);
            high = max(from_one, from_two);
        }
        low = max(low, 0);
        high = min(high, bitcast<i32>(COLUMNS));
        if (low < high) {
            let span = (0xffffffffu >> bitcast<u32>(32 - (high - low))) << bitcast<u32>(low);
            atomicOr(&masks[place + i], span);
        }
        x -= first.slope;
        y -= second.slope;
    }
}

/// Joins the masks of the workgroup's receivers to those in memory.
fn store(lane: u32, x: u32, y: u32) {
    for (var at = lane; at < ROWS / ROWS_PER_WORD * RECEIVERS; at += LANES) {
        let word = at / RECEIVERS;
        let receiver = at % RECEIVERS;
        let column = x + receiver % WIDTH;
        let row = y + receiver / WIDTH;
        var mask = 0u;
        for (var k = 0u; k < ROWS_PER_WORD; k += 1u) {
            mask |= atomicLoad(&masks[(word * ROWS_PER_WORD + k) * RECEIVERS + receiver]) << (k * COLUMNS);
        }
        if ((mask != 0u) & (column < params.view.columns) & (row < params.view.rows)) {
            hidden[(word * params.view.rows + row) * params.view.columns + column] |= mask;
        }
    }
}

@compute @workgroup_size(256)
fn row_span(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let x = group.x * WIDTH;
    let y = params.first_row + group.y * HEIGHT;
    let corner = receiver_at(params.view, x, y);
    let columns = min(WIDTH, params.view.columns - x);
    let lines = min(HEIGHT, params.view.rows - y);
    let tile = (y / params.tile_rows) * params.tiles + group.x;
    let first = starts[tile] + params.skip;
    let end = min(starts[tile + 1u], first + LIST);
    var count = 0u;
    for (var start = first; start < end; start += LANES) {
        let is_there = start + lane < end;
        let triangle = entries[min(start + lane, end - 1u)];
        let a = track(triangle, 0u, corner.y);
        let b = track(triangle, 1u, corner.y);
        let c = track(triangle, 2u, corner.y);
        for (var line = 0u; line < lines; line += 1u) {
            var rows = rows_met(row_of(a, line), row_of(b, line), row_of(c, line));
            rows.y = select(0u, rows.y, is_there);
            for (var turn = 0u; turn < ROWS; turn += 1u) {
                if (rows.x < rows.y) {
                    push(item(triangle, line, rows.x));
                    rows.x += 1u;
                }
                let pushed_now = depth(lane);
                if (pushed_now == count) {
                    break;
                }
                count = pushed_now;
                if (count >= LANES) {
                    count -= LANES;
                    take(items[count + lane], corner.x, corner.y, columns);
                    workgroupBarrier();
                    if (lane == 0u) {
                        atomicStore(&pushed, count);
                    }
                    workgroupBarrier();
                }
            }
        }
    }
    if (lane < count) {
        take(items[lane], corner.x, corner.y, columns);
    }
    workgroupBarrier();
    store(lane, x, y);
}

// Row spans: the samples of a regular light that triangles hide from receivers on a parallel plane, exactly.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 4 and 5, by row spans instead of a
// table: the backprojection of a triangle covers, in each row of the light, one span of samples between two edges.
// `grid.rs` has the definition that the masks meet bit for bit. Output: bit s % 32 of `hidden[(s / 32) * receivers +
// r]` is set if any triangle of r's tile list hides sample s from receiver r; other bits are left as they are.
//
// Triangles lie strictly between the planes: 0 < z < height for every vertex. A row of receivers and a row of samples
// are parallel, so one plane holds both, and what a triangle hides there is told by where its edges meet that plane:
//
// * f(v) = y * height - ry * z - v0 * (height - z) says on which side a vertex stands; a triangle meets the plane iff
//   one vertex has another side than the other two, and the two edges from it cross. f > 0 is one side, f <= 0 the
//   other, so what lies on the plane falls to one side by the same rule for all triangles.
// * The crossing of an edge is the mean of its vertices, weighted by the |f| of the other. From receiver i it is seen
//   before a sample at x(i) = a - i b, in steps of the samples, and hides those k with x <= k of one edge and k < x of
//   the other. Numbers of 18 binary places hold a and b; where x is too near to a whole number for their error, the
//   sign of x - k decides, a sum of two products of integers.
//
// Of a one-sided triangle (`ONE_SIDED`) the edge whose crossing is the left one, seen from where the front hides, is
// known by its turn: the span is from that crossing to the other, and empty where the back would hide. docs/numerics.md
// has the proof.
//
// One workgroup serves WIDTH by HEIGHT receivers. Invocations first are triangles, 256 of the list at a time, and find
// which rows of samples they meet for each row of receivers. Each such pair is an item; items wait on a stack until
// there is one for every invocation. Then invocations are items, and each finds its spans for those of WIDTH receivers
// that see it before the light. So work is done for what meets a row of samples alone, and nearly all lanes have it.
// The order of items cannot show: spans are joined by OR. Now and then the rows of samples are found that nobody of a
// row of receivers sees any more; these make no items, and when there are no others the rest of the list is left.

import package::shared::wide::{imul_wide, add64};
import package::shared::view::{View, receiver_at, sample_row};

/// Samples along x: a power of two up to 32.
const COLUMNS: u32 = 32u;
/// Samples along y: a power of two up to 32.
const ROWS: u32 = 32u;
/// Entries of a list that a launch takes.
const LIST: u32 = 4096u;
/// Whether triangles hide by their fronts alone.
const ONE_SIDED: bool = false;
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
/// Half a step before the first sample, and past the last.
const BEFORE = -131072;
const BEHIND = i32(COLUMNS) * ONE + 131072;
/// Lanes, and triangles or items that they take at a time.
const LANES = 256u;
/// Most items that wait.
const ITEMS = 1280u;
/// Items that are taken before rows of samples are looked through, and then as many again as before.
const LOOK = 1024u;

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
var<workgroup> items: array<u32, ITEMS>;
/// Items that wait, and those for which there was no room.
var<workgroup> pushed: atomic<u32>;
/// A number that all invocations are told.
var<workgroup> told: u32;
/// Rows of samples that are hidden from a whole row of receivers.
var<workgroup> hidden_rows: array<atomic<u32>, HEIGHT>;

fn vertex(triangle: u32, corner: u32) -> vec3<i32> {
    let at = 9u * triangle + 3u * corner;
    return vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}

/// A vertex as its backprojection moves over the rows of samples: at `at`, and by `step` less for each row of
/// receivers, in units of 1 / 1024 row. Both are cut at FAR.
struct Track {
    at: i32,
    step: i32,
}

const FAR = 268435456;

/// float: filter - both are off by less than 2^-20 of them and a unit
fn track(triangle: u32, corner: u32, ry: i32) -> Track {
    let v = vertex(triangle, corner);
    let w = params.view.height - v.z;
    let n = v.y * params.view.height - ry * v.z - params.view.sample_y * w;
    let per = 1024.0 / f32(params.view.sample_step_y * w);
    let at = clamp(f32(n) * per, -268435456.0, 268435456.0);
    return Track(i32(at), i32(min(f32(params.view.receiver_step_y * v.z) * per, 268435456.0)));
}

/// How far the rows of HEIGHT rows of receivers may be off, in units: without limit where they are too far away to be
/// told.
fn slack_of(a: Track, b: Track, c: Track) -> i32 {
    let size = max(max(abs(a.at) + 3 * a.step, abs(b.at) + 3 * b.step), abs(c.at) + 3 * c.step);
    return select((size >> 19u) + 6, 2 * FAR, size >= FAR);
}

/// First row of samples that three vertices may stand on either side of, and one past the last.
fn rows_met(a: i32, b: i32, c: i32, slack: i32) -> vec2<i32> {
    let low = min(min(a, b), c);
    let high = max(max(a, b), c);
    return vec2<i32>(max((low - slack + 1023) >> 10u, 0), min((high + slack + 1023) >> 10u, i32(ROWS)));
}

/// A triangle, a row of receivers and a row of samples.
fn item(triangle: u32, line: u32, j: u32) -> u32 {
    return (triangle << 7u) | (line << 5u) | j;
}

/// Rows from the first to one before the second, which is greater.
fn between(rows: vec2<i32>) -> u32 {
    return (0xffffffffu >> bitcast<u32>(32 - (rows.y - rows.x))) << bitcast<u32>(rows.x);
}

/// Pushes a triangle's items for rows of samples as far as there is room, and returns the rows that are left.
///
/// allow(atomic-result): the order of items cannot show, as spans are joined by OR
fn push(triangle: u32, line: u32, rows: u32) -> u32 {
    var left = rows;
    for (var at = atomicAdd(&pushed, countOneBits(rows)); (left != 0u) & (at < ITEMS); at += 1u) {
        items[at] = item(triangle, line, firstTrailingBit(left));
        left &= left - 1u;
    }
    return left;
}

/// Number of items that were pushed, the same for all invocations.
fn depth(lane: u32) -> u32 {
    workgroupBarrier();
    if (lane == 0u) {
        told = atomicLoad(&pushed);
    }
    return workgroupUniformLoad(&told);
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

/// Exact number of samples before the crossing of an edge: ceil(x), between 0 and COLUMNS. `guess` is off by less than
/// a quarter, unless the crossing could not be told.
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
    let next = select(select(a, c, is_b), b, is_a);
    let last = select(select(b, a, is_b), c, is_a);
    let turned = ONE_SIDED & (alone.w > 0);
    let one = edge(alone, select(next, last, turned));
    let two = edge(alone, select(last, next, turned));
    spans(one, two, (j * HEIGHT + line) * WIDTH, x0, count);
}

/// The receivers, from the first to one past the last of `count`, that may see something of two edges before the light.
///
/// float: filter - a crossing at these bounds is off by less than 2^11 / ONE, and they are half a step from the light
fn receivers_met(first: Crossing, second: Crossing, count: u32) -> vec2<u32> {
    let starts = vec2<i32>(first.start, second.start);
    let per = 1.0 / vec2<f32>(max(vec2<i32>(first.slope, second.slope), vec2<i32>(1)));
    let enter = vec2<f32>(starts - BEHIND) * per;
    let leave = vec2<f32>(starts - BEFORE) * per;
    let most = f32(count);
    return vec2<u32>(
        u32(clamp(min(enter.x, enter.y), 0.0, most)),
        u32(ceil(clamp(max(leave.x, leave.y), 0.0, most))),
    );
}

/// The end of a span where it begins: the first where the order tells the face, else the lower.
fn start_of(x: i32, y: i32) -> i32 {
    return select(min(x, y), x, ONE_SIDED);
}

/// The end of a span where it ends.
fn end_of(x: i32, y: i32) -> i32 {
    return select(max(x, y), y, ONE_SIDED);
}

/// Adds the samples between two edges to the masks of `count` receivers, from `place` on.
fn spans(one: Edge, two: Edge, place: u32, x0: i32, count: u32) {
    let first = crossing(one, x0);
    let second = crossing(two, x0);
    let doubt = max(first.doubt, second.doubt);
    let met = receivers_met(first, second, count);
    // Where x is no whole number ceil(x) is floor(x + 1); `doubt` more changes that only where it is in doubt.
    var x = first.start + ONE + doubt - bitcast<i32>(met.x) * first.slope;
    var y = second.start + ONE + doubt - bitcast<i32>(met.x) * second.slope;
    let seeing = max(met.y, met.x) - met.x;
    let begin = place + met.x;
    for (var i = 0u; i < seeing; i += 1u) {
        var low = start_of(x, y) >> 18u;
        var high = end_of(x, y) >> 18u;
        if (min(x & FRACTION, y & FRACTION) <= 2 * doubt) {
            let rx = x0 + params.view.receiver_step_x * bitcast<i32>(met.x + i);
            let from_one = before(one, rx, x - ONE - doubt, first.doubt < ONE);
            let from_two = before(two, rx, y - ONE - doubt, second.doubt < ONE);
            low = start_of(from_one, from_two);
            high = end_of(from_one, from_two);
        }
        low = max(low, 0);
        high = min(high, bitcast<i32>(COLUMNS));
        if (low < high) {
            let span = (0xffffffffu >> bitcast<u32>(32 - (high - low))) << bitcast<u32>(low);
            atomicOr(&masks[begin + i], span);
        }
        x -= first.slope;
        y -= second.slope;
    }
}

/// Takes the last `count` items, as many as there are invocations at a time, and returns how many are left.
fn take_all(lane: u32, count: u32, corner: vec3<i32>, columns: u32) -> u32 {
    var left = count;
    while (left >= LANES) {
        left -= LANES;
        take(items[left + lane], corner.x, corner.y, columns);
    }
    workgroupBarrier();
    if (lane == 0u) {
        atomicStore(&pushed, left);
    }
    workgroupBarrier();
    return left;
}

/// Looks for rows of samples that are hidden from `columns` receivers of each of `lines` rows, and returns whether all
/// are.
fn look(lane: u32, columns: u32, lines: u32) -> bool {
    var line = lane / ROWS;
    let j = lane % ROWS;
    let all = 0xffffffffu >> (32u - COLUMNS);
    if (line < lines) {
        var row = all;
        for (var i = 0u; i < columns; i += 1u) {
            row &= atomicLoad(&masks[(j * HEIGHT + line) * WIDTH + i]);
        }
        if (row == all) {
            atomicOr(&hidden_rows[line], 1u << j);
        }
    }
    workgroupBarrier();
    if (lane == 0u) {
        told = 0u;
        for (line = 0u; line < lines; line += 1u) {
            told += countOneBits(atomicLoad(&hidden_rows[line]));
        }
    }
    return workgroupUniformLoad(&told) == lines * ROWS;
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
    if (first >= end) {
        return;
    }
    var count = 0u;
    var taken = 0u;
    var next_look = LOOK;
    for (var start = first; start < end; start += LANES) {
        var triangle = 0u;
        var a = Track(0, 0);
        var b = a;
        var c = a;
        // Who has no triangle meets no row.
        var slack = -FAR;
        if (start + lane < end) {
            triangle = entries[start + lane];
            a = track(triangle, 0u, corner.y);
            b = track(triangle, 1u, corner.y);
            c = track(triangle, 2u, corner.y);
            slack = slack_of(a, b, c);
        }
        for (var line = 0u; line < lines; line += 1u) {
            let rows = rows_met(a.at, b.at, c.at, slack);
            a.at -= a.step;
            b.at -= b.step;
            c.at -= c.step;
            var left = 0u;
            if (rows.x < rows.y) {
                left = between(rows) & ~atomicLoad(&hidden_rows[line]);
            }
            for (var is_left = true; is_left;) {
                if (left != 0u) {
                    left = push(triangle, line, left);
                }
                count = depth(lane);
                is_left = count > ITEMS;
                if (count >= LANES) {
                    taken += min(count, ITEMS);
                    count = take_all(lane, min(count, ITEMS), corner, columns);
                    taken -= count;
                }
            }
        }
        if (taken >= next_look) {
            next_look = 2u * taken;
            if (look(lane, columns, lines)) {
                count = 0u;
                break;
            }
        }
    }
    if (lane < count) {
        take(items[lane], corner.x, corner.y, columns);
    }
    workgroupBarrier();
    store(lane, x, y);
}

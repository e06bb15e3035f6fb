// Vertex visibility: which vertices of a mesh are occluded towards which directional lights, exactly and without a
// depth map.
//
// Sattler et al. 2004, sections 3.1 and 3.2, outside-in: all vertices at once for a direction.
// Instead of a depth map the vertices themselves are binned in the plane across the direction, and each triangle tests
// those under it (an irregular z-buffer, with the roles of points and triangles as in Johnson et al., "The Irregular
// Z-Buffer", 2005); opposite directions share the projection. `oracle.rs` has the definition that every bit meets.
// Output: bit 2p (2p + 1) % 32 of `occluded[row + vertex]` is set if a triangle hides the vertex towards the first
// (second) direction of pair p; other bits are left as they are.
//
// Coordinates are taken in the cyclic order u, v, w in which the direction's largest component is that of w, and of the
// two opposite directions the one with d.w > 0 is "forward". Along it (u, v, w) falls on X = u d.w - w d.u,
// Y = v d.w - w d.v, exactly; |X|, |Y| < 2^29, as |d.u| + |d.v| + d.w <= 2^14.
//
// One workgroup has a part of a triangle for each lane, sorted by the vertices under them, so that neighbouring lanes
// end together. A lane tests up to BLOCK vertices by f32 weights, which leave out those that are surely beside the
// triangle, and its own corners. What they leave, one vertex in ten, waits for all lanes to take their share, and is
// decided in integers by `exact_side`: f32 sets no bit. The order of what waits cannot show, as bits are set by OR.

import package::shared::wide::{add64, dot64, imul_wide, neg64, sgn64, sub64, umul_hi, umul_wide};

/// Parts of triangles of a workgroup.
const GROUP = 256u;
/// Classes of parts by the number of vertices under them, more in the last; a power of four.
const CLASSES = 64u;
/// Zeros below the first class: three times the longest reach of a step of their prefix sums.
const BELOW = 48u;
/// Rows of bins that a lane takes at a time.
const ROWS = 4u;
/// Vertices that a lane tests at a time: a bit for each.
const BLOCK = 32u;
/// Pairs of a part and a vertex that may wait to be decided.
const WAITING = 2048u;
/// Most vertices that a launch tests with a part.
const MOST = 8192u;
/// Larger than every error: nothing is decided by f32.
const UNDECIDED: f32 = 1267650600228229401496703205376.0;

struct Params {
    vertices: u32,
    /// Parts of triangles.
    parts: u32,
    /// Logarithm of the number of bins along X.
    column_bits: u32,
    /// Logarithm of the number of bins.
    bin_bits: u32,
    /// Frame of the first pair.
    pair: u32,
    /// Workgroups of a pair.
    groups: u32,
    /// Number of the first workgroup.
    first: u32,
    /// Cells along w that an occluder must be farther away than.
    bias: u32,
    /// Word of the first vertex.
    row: u32,
    /// Rows of bins of a part.
    rows: u32,
    /// Words of a plane of `placed`.
    plane: u32,
}

/// A pair of opposite directions, the plane across them and its bins.
struct Frame {
    /// Axis that u is: 0 for x.
    axis: u32,
    /// 1 if forward is the second direction of the pair.
    flip: u32,
    /// The forward direction.
    u: i32,
    v: i32,
    w: i32,
    /// Least X and Y.
    x: i32,
    y: i32,
    /// Bins a unit, in 2^-32.
    x_scale: u32,
    y_scale: u32,
    /// Sides of a bin are less than this.
    reach: u32,
    /// Twice the error of a difference of two X or Y that were rounded to f32.
    blur: u32,
    /// Place of the first bit, 2p % 32.
    bit: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> frames: array<Frame>;
/// All x, then all y, then all z.
@group(0) @binding(2) var<storage, read> vertices: array<i32>;
/// Vertices of every bin, from the second word on.
@group(0) @binding(3) var<storage, read_write> counts: array<atomic<u32>>;
/// From the second word on, first place of every bin; after `place`, the place behind its last. The first word stays 0.
@group(0) @binding(4) var<storage, read_write> cursors: array<atomic<u32>>;
/// Planes: bin by bin X of every vertex as f32, Y, and its number; then, vertex by vertex, its place in the other
/// planes.
@group(0) @binding(5) var<storage, read_write> placed: array<u32>;
/// x of all parts' first corners, y of all first corners, …, z of all third corners.
@group(0) @binding(6) var<storage, read> corners: array<i32>;
/// First place of every bin, and the place behind the last.
@group(0) @binding(7) var<storage, read> starts: array<u32>;
@group(0) @binding(8) var<storage, read> points: array<u32>;
@group(0) @binding(9) var<storage, read_write> occluded: array<atomic<u32>>;
/// Numbers of all parts' first corners, then of all second and third ones: beyond all vertices where it is none of
/// them; then the number of each part within its triangle.
@group(0) @binding(10) var<storage, read> numbers: array<u32>;
/// Workgroups that take what `occlude` leaves: those of the launch, as often as the part with most vertices needs.
@group(0) @binding(11) var<storage, read_write> more: array<atomic<u32>>;

var<workgroup> sizes: array<atomic<u32>, CLASSES>;
/// Two sides, as a step of prefix sums reads one and writes the other.
var<workgroup> ladder: array<u32, 2u * (CLASSES + BELOW)>;
/// Parts with vertices under their boxes, those with few first.
var<workgroup> order: array<u32, GROUP>;
/// Pairs that f32 does not tell apart from hits: the lane that has the part, and from bit 23 down the vertex' place.
var<workgroup> waiting: array<u32, WAITING>;
/// Of the blocks that lanes have tested: how many pairs they have found, from bit 14 on how many vertices they had, and
/// in bit 31 whether any lane has vertices left.
var<workgroup> pushed: atomic<u32>;
var<workgroup> state: u32;
/// Parts in `order`.
var<workgroup> busy: u32;

fn axis_of(frame: Frame, place: u32) -> u32 {
    let axis = frame.axis + place;
    return select(axis, axis - 3u, axis > 2u);
}

/// (u, v, w) of a vertex.
fn vertex_at(frame: Frame, i: u32) -> vec3<i32> {
    let n = params.vertices;
    return vec3<i32>(vertices[axis_of(frame, 0u) * n + i], vertices[axis_of(frame, 1u) * n + i],
        vertices[axis_of(frame, 2u) * n + i]);
}

/// (u, v, w) of the corner of a part's triangle.
fn corner_at(frame: Frame, part: u32, corner: u32) -> vec3<i32> {
    let n = params.parts;
    let first = 3u * corner;
    return vec3<i32>(corners[(first + axis_of(frame, 0u)) * n + part], corners[(first + axis_of(frame, 1u)) * n + part],
        corners[(first + axis_of(frame, 2u)) * n + part]);
}

/// (X, Y, w) of a point (u, v, w).
fn flatten(frame: Frame, p: vec3<i32>) -> vec3<i32> {
    return vec3<i32>(p.x * frame.w - p.z * frame.u, p.y * frame.w - p.z * frame.v, p.z);
}

fn column_of(frame: Frame, x: i32) -> u32 {
    return umul_hi(bitcast<u32>(x - frame.x), frame.x_scale);
}

fn row_of(frame: Frame, y: i32) -> u32 {
    return umul_hi(bitcast<u32>(y - frame.y), frame.y_scale);
}

fn bin_of(frame: Frame, pair: u32, p: vec3<i32>) -> u32 {
    return (pair << params.bin_bits) + (row_of(frame, p.y) << params.column_bits) + column_of(frame, p.x);
}

@compute @workgroup_size(256)
fn count(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = params.first + group.x;
    let pair = number / params.groups;
    let i = (number - pair * params.groups) * 256u + lane;
    if (i >= params.vertices) {
        return;
    }
    let frame = frames[params.pair + pair];
    atomicAdd(&counts[bin_of(frame, pair, flatten(frame, vertex_at(frame, i))) + 1u], 1u);
}

/// allow(atomic-result): the order of vertices within a bin cannot show, as each is tested by itself
@compute @workgroup_size(256)
fn place(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = params.first + group.x;
    let pair = number / params.groups;
    let i = (number - pair * params.groups) * 256u + lane;
    if (i >= params.vertices) {
        return;
    }
    let frame = frames[params.pair + pair];
    let p = flatten(frame, vertex_at(frame, i));
    let at = atomicAdd(&cursors[bin_of(frame, pair, p) + 1u], 1u);
    let rounded = rounded_of(p);
    placed[at] = bitcast<u32>(rounded.x);
    placed[at + params.plane] = bitcast<u32>(rounded.y);
    placed[at + 2u * params.plane] = i;
    placed[3u * params.plane + pair * params.vertices + i] = at;
}

/// float: filter - X and Y below 2^24 are exact, others off by less than 2^5
fn rounded_of(p: vec3<i32>) -> vec2<f32> {
    return vec2<f32>(p.xy);
}

/// Corners of a part's triangle in (X, Y, w).
struct Corners {
    a: vec3<i32>,
    b: vec3<i32>,
    c: vec3<i32>,
}

fn corners_of(frame: Frame, part: u32) -> Corners {
    return Corners(flatten(frame, corner_at(frame, part, 0u)), flatten(frame, corner_at(frame, part, 1u)),
        flatten(frame, corner_at(frame, part, 2u)));
}

/// Longer side of the box of a triangle.
fn span_of(t: Corners) -> u32 {
    let low = min(min(t.a.xy, t.b.xy), t.c.xy);
    let high = max(max(t.a.xy, t.b.xy), t.c.xy);
    let size = bitcast<vec2<u32>>(high - low);
    return max(size.x, size.y);
}

/// Whether a triangle is seen edge-on, or has no area.
fn is_edge_on(t: Corners) -> bool {
    let d = t.b.xy - t.a.xy;
    let e = t.c.xy - t.a.xy;
    let area = sub64(imul_wide(d.x, e.y), imul_wide(d.y, e.x));
    return (area.x | area.y) == 0u;
}

/// Whether f32 cannot tell a triangle's area from none.
/// float: filter - the area is within 2^-20 of `size`, and 2^-12 is asked for
fn is_thin(t: Corners) -> bool {
    let d = vec2<f32>(t.b.xy - t.a.xy);
    let e = vec2<f32>(t.c.xy - t.a.xy);
    let size = abs(d.x * e.y) + abs(d.y * e.x);
    return abs(d.x * e.y - d.y * e.x) <= size * 0.000244140625;
}

/// A triangle over its first corner. The weights of the two others are b . (x, y) and c . (x, y); what is added to each
/// of the three is `slack`, so that one below 0 is of a point outside.
struct Face {
    origin: vec2<f32>,
    b: vec2<f32>,
    c: vec2<f32>,
    slack: f32,
    /// 1 + 3 `slack`: less the two other weights, that of the first corner.
    limit: f32,
}

/// float: filter - `slack` is eight times the error of a weight: the area's, relative to it, and that of products and
/// sums of up to `spread`; and twice that of rounded coordinates
fn face_of(frame: Frame, t: Corners) -> Face {
    let d = vec2<f32>(t.b.xy - t.a.xy);
    let e = vec2<f32>(t.c.xy - t.a.xy);
    let thin = is_thin(t);
    let size = abs(d.x * e.y) + abs(d.y * e.x);
    let per_area = 1.0 / select(d.x * e.y - d.y * e.x, 1.0, thin);
    let b = vec2<f32>(e.y, 0.0 - e.x) * per_area;
    let c = vec2<f32>(0.0 - d.y, d.x) * per_area;
    let norm = abs(b.x) + abs(b.y) + abs(c.x) + abs(c.y);
    let spread = f32(frame.reach + span_of(t)) * norm;
    let error = (2.0 * spread + 1.0) * (size * abs(per_area) + 1.0) * 0.0000019073486328125 + f32(frame.blur) * norm;
    let slack = select(error, UNDECIDED, thin);
    return Face(vec2<f32>(t.a.xy), b, c, slack, 3.0 * slack + 1.0);
}

/// Sign of det(d, p, q) for the edge from p to q, seen from the vertex that both are relative to.
fn edge_side(frame: Frame, p: vec3<i32>, q: vec3<i32>) -> i32 {
    return sgn64(along(frame, cross_of(p, q)));
}

/// The same where that is 0, for a vertex moved by (e, e^2, e^3) along x, y and z: the sign of the first component of
/// d x (q - p) that is not 0.
fn tie_side(frame: Frame, p: vec3<i32>, q: vec3<i32>) -> i32 {
    let g = cross_of(vec3<i32>(frame.u, frame.v, frame.w), q - p);
    let x = select(select(g.x, g.z, frame.axis == 1u), g.y, frame.axis == 2u);
    let y = select(select(g.y, g.x, frame.axis == 1u), g.z, frame.axis == 2u);
    let z = select(select(g.z, g.y, frame.axis == 1u), g.x, frame.axis == 2u);
    return sign(select(select(z, y, y != 0), x, x != 0));
}

fn cross_of(p: vec3<i32>, q: vec3<i32>) -> vec3<i32> {
    return vec3<i32>(p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x);
}

/// d . n for the forward direction d.
fn along(frame: Frame, n: vec3<i32>) -> vec2<u32> {
    return dot64(n, vec3<i32>(frame.u, frame.v, frame.w));
}

/// v * k modulo 2^64.
fn scaled(v: vec2<u32>, k: u32) -> vec2<u32> {
    let low = umul_wide(v.x, k);
    return vec2<u32>(low.x, low.y + v.y * k);
}

/// 1 if the part's triangle hides the vertex towards the forward direction, -1 if towards its opposite, 0 if neither.
///
/// Differences are below 2^15, so normals are below 2^31, `rise` below 2^48 and its product with d.w below 2^62; d . n
/// is below 2^45, and its product with the bias below 2^60.
fn exact_side(frame: Frame, part: u32, vertex: u32) -> i32 {
    let v = vertex_at(frame, vertex);
    let a = corner_at(frame, part, 0u) - v;
    let b = corner_at(frame, part, 1u) - v;
    let c = corner_at(frame, part, 2u) - v;
    var sides = vec3<i32>(edge_side(frame, a, b), edge_side(frame, b, c), edge_side(frame, c, a));
    if (any(sides == vec3<i32>(0))) {
        let ties = vec3<i32>(tie_side(frame, a, b), tie_side(frame, b, c), tie_side(frame, c, a));
        sides = select(sides, ties, sides == vec3<i32>(0));
    }
    if ((sides.x == 0) | (sides.x != sides.y) | (sides.x != sides.z)) {
        return 0;
    }
    let n = cross_of(b - a, c - a);
    let facing = along(frame, n);
    let distance = scaled(dot64(n, a), bitcast<u32>(frame.w));
    let negative = (facing.y >> 31u) != 0u;
    let least = scaled(select(facing, neg64(facing), negative), params.bias);
    let ahead = select(distance, neg64(distance), negative);
    let forward = sgn64(sub64(ahead, least)) > 0;
    let backward = sgn64(add64(ahead, least)) < 0;
    return select(select(0, -1, backward), 1, forward);
}

/// Columns and rows of bins under a part, and the rows of its corners.
struct Region {
    columns: vec2<u32>,
    rows: vec2<u32>,
    corners: vec3<u32>,
}

fn region_of(frame: Frame, part: u32, t: Corners) -> Region {
    let x = vec3<u32>(column_of(frame, t.a.x), column_of(frame, t.b.x), column_of(frame, t.c.x));
    let y = vec3<u32>(row_of(frame, t.a.y), row_of(frame, t.b.y), row_of(frame, t.c.y));
    let first = min(min(y.x, y.y), y.z) + numbers[3u * params.parts + part] * params.rows;
    let last = min(max(max(y.x, y.y), y.z), first + params.rows - 1u);
    return Region(vec2<u32>(min(min(x.x, x.y), x.z), max(max(x.x, x.y), x.z)), vec2<u32>(first, last), y);
}

/// Vertices of neighbouring rows of bins under a part: number j is at `offset[r] + j` for the first row r with j <
/// `end[r]`.
struct Ranges {
    offset: vec4<u32>,
    end: vec4<u32>,
}

/// First place, and the place behind the last, of the vertices in a row of bins under a part.
fn range_of(region: Region, pair: u32, row: u32) -> vec2<u32> {
    let first = (pair << params.bin_bits) + (min(row, region.rows.y) << params.column_bits);
    let start = starts[first + region.columns.x];
    return vec2<u32>(start, select(start, starts[first + region.columns.y + 1u], row <= region.rows.y));
}

/// The vertices of rows from `row` on, up to the region's last.
fn ranges_of(region: Region, pair: u32, row: u32) -> Ranges {
    let a = range_of(region, pair, row);
    let b = range_of(region, pair, row + 1u);
    let c = range_of(region, pair, row + 2u);
    let d = range_of(region, pair, row + 3u);
    let to_b = a.y - a.x;
    let to_c = to_b + (b.y - b.x);
    let to_d = to_c + (c.y - c.x);
    return Ranges(vec4<u32>(a.x, b.x - to_b, c.x - to_c, d.x - to_d), vec4<u32>(to_b, to_c, to_d, to_d + (d.y - d.x)));
}

/// The same without the first ones.
fn without(ranges: Ranges, first: u32) -> Ranges {
    return Ranges(ranges.offset + first, max(ranges.end, vec4<u32>(first)) - first);
}

fn at_row(words: vec4<u32>, r: u32) -> u32 {
    return select(select(select(words.w, words.z, r < 3u), words.y, r < 2u), words.x, r < 1u);
}

fn place_of(ranges: Ranges, j: u32) -> u32 {
    let offset = select(select(select(ranges.offset.w, ranges.offset.z, j < ranges.end.z), ranges.offset.y,
        j < ranges.end.y), ranges.offset.x, j < ranges.end.x);
    return offset + j;
}

/// Place of a part's corner, 2^32 - 1 where it is no vertex.
fn corner_place(pair: u32, part: u32, corner: u32) -> u32 {
    let number = numbers[corner * params.parts + part];
    let place = points[3u * params.plane + pair * params.vertices + min(number, params.vertices - 1u)];
    return select(0xffffffffu, place, number < params.vertices);
}

/// The bit of the vertex at a place in a row of bins, 0 where it is not within a block.
fn bit_of(ranges: Ranges, place: u32, r: u32) -> u32 {
    let j = place - at_row(ranges.offset, r);
    return select(0u, 1u << j, (r < ROWS) & (j < BLOCK));
}

/// A bit for each of up to BLOCK vertices that may be under a triangle.
/// float: filter - weights with an error below `slack` / 8
fn near(face: Face, ranges: Ranges, count: u32) -> u32 {
    var beside = 0u;
    for (var j = 0u; j < count; j += 1u) {
        let at = place_of(ranges, j);
        let x = bitcast<f32>(points[at]) - face.origin.x;
        let y = bitcast<f32>(points[at + params.plane]) - face.origin.y;
        let b = y * face.b.y + (x * face.b.x + face.slack);
        let c = y * face.c.y + (x * face.c.x + face.slack);
        let signs = bitcast<u32>(b) | bitcast<u32>(c) | bitcast<u32>(face.limit - (b + c));
        beside |= (signs >> 31u) << j;
    }
    return select(0u, ~beside & (0xffffffffu >> (BLOCK - count)), count != 0u);
}

/// How many vertices are in bins under a part.
fn vertices_under(region: Region, pair: u32) -> u32 {
    let first = (pair << params.bin_bits) + region.columns.x;
    let width = region.columns.y - region.columns.x + 1u;
    var sum = 0u;
    for (var row = region.rows.x; row <= region.rows.y; row += 1u) {
        let bin = first + (row << params.column_bits);
        sum += starts[bin + width] - starts[bin];
    }
    return sum;
}

/// Sum over `4 * reach` classes up to `lane`, from sums over `reach` classes each.
fn class_step(lane: u32, side: u32, reach: u32, sum: u32) -> u32 {
    let place = side * (CLASSES + BELOW) + BELOW + lane;
    if (lane < CLASSES) {
        ladder[place] = sum;
    }
    workgroupBarrier();
    if (lane < CLASSES) {
        return sum + ladder[place - reach] + ladder[place - 2u * reach] + ladder[place - 3u * reach];
    }
    return 0u;
}

/// Puts the workgroup's parts in order, so that neighbouring lanes have about as many vertices to test; the number of
/// those that have any. A part that has none gives 0.
/// allow(atomic-result): the order of parts within a class cannot show, as each is tested by itself
fn sort_parts(lane: u32, part: u32, count: u32) -> u32 {
    let size = min(count, CLASSES - 1u);
    if (lane < BELOW) {
        ladder[lane] = 0u;
        ladder[lane + CLASSES + BELOW] = 0u;
    }
    var rank = 0u;
    if (count != 0u) {
        rank = atomicAdd(&sizes[size], 1u);
    }
    workgroupBarrier();
    var own = 0u;
    if (lane < CLASSES) {
        own = atomicLoad(&sizes[lane]);
    }
    var sum = class_step(lane, 0u, 1u, own);
    sum = class_step(lane, 1u, 4u, sum);
    sum = class_step(lane, 0u, 16u, sum);
    if (lane < CLASSES) {
        ladder[CLASSES + BELOW + lane] = sum - own;
    }
    if (lane == CLASSES - 1u) {
        busy = sum;
    }
    workgroupBarrier();
    if (count != 0u) {
        order[ladder[CLASSES + BELOW + size] + rank] = part;
    }
    return workgroupUniformLoad(&busy);
}

/// The state that all lanes have left; `pushed` is 0 then.
/// allow(atomic-result): all lanes have added, so what one takes is the sum
fn next_state(lane: u32) -> u32 {
    workgroupBarrier();
    if (lane == 0u) {
        state = atomicExchange(&pushed, 0u);
    }
    return workgroupUniformLoad(&state);
}

/// Lets the pairs of a part that this lane has, a vertex for each of `bits`, wait at places from `first` on.
fn wait(lane: u32, pair: u32, ranges: Ranges, bits: u32, first: u32) {
    var rest = bits;
    for (var i = first; rest != 0u; i += 1u) {
        if (i < WAITING) {
            waiting[i] = (lane << 23u) | (place_of(ranges, firstTrailingBit(rest)) - pair * params.vertices);
        }
        rest &= rest - 1u;
    }
}

/// Decides a pair that has waited.
fn decide(frame: Frame, pair: u32, waited: u32) {
    let vertex = points[2u * params.plane + pair * params.vertices + (waited & 0x7fffffu)];
    let side = exact_side(frame, order[waited >> 23u], vertex);
    if (side != 0) {
        let second = select(1u, 0u, side > 0) ^ frame.flip;
        atomicOr(&occluded[params.row + vertex], 1u << (frame.bit + second));
    }
}

/// What a lane tests vertices with.
struct Task {
    face: Face,
    region: Region,
    /// Places of the part's corners.
    own: vec3<u32>,
}

/// The task of a part; without a row of bins if it is seen edge-on, or not there.
fn task_of(frame: Frame, pair: u32, part: u32, is_there: bool) -> Task {
    let corners = corners_of(frame, part);
    var region = region_of(frame, part, corners);
    var met = is_there;
    if (is_thin(corners)) {
        met &= !is_edge_on(corners);
    }
    region.rows.x = select(region.rows.y + 1u, region.rows.x, met);
    let own = vec3<u32>(corner_place(pair, part, 0u), corner_place(pair, part, 1u), corner_place(pair, part, 2u));
    return Task(face_of(frame, corners), region, own);
}

/// How far a lane has come.
struct Cursor {
    /// Row of bins, and how many vertices are in those before.
    row: u32,
    before: u32,
    /// Number of the next vertex.
    next: u32,
}

/// Vertices that are tested together.
struct Block {
    /// All vertices in its rows, and those from the cursor on.
    all: u32,
    ranges: Ranges,
    count: u32,
    /// Those that may be hidden.
    bits: u32,
}

/// Tests up to BLOCK vertices, those before number `end`.
fn block_at(task: Task, pair: u32, cursor: Cursor, end: u32) -> Block {
    let all = ranges_of(task.region, pair, cursor.row);
    let first = min(cursor.next - cursor.before, all.end.w);
    let ranges = without(all, first);
    let rows = task.region.corners - cursor.row;
    let own = bit_of(ranges, task.own.x, rows.x) | bit_of(ranges, task.own.y, rows.y) | bit_of(ranges, task.own.z, rows.z);
    let count = min(min(end - cursor.before, all.end.w) - first, BLOCK);
    return Block(all.end.w, ranges, count, near(task.face, ranges, count) & ~own);
}

/// The cursor behind a block; behind the last row after vertex number `end`.
fn behind(cursor: Cursor, block: Block, last_row: u32, end: u32) -> Cursor {
    let next = cursor.next + block.count;
    let is_through = block.ranges.end.w == block.count;
    let row = cursor.row + select(0u, ROWS, is_through);
    let before = cursor.before + select(0u, block.all, is_through);
    return Cursor(select(row, last_row + 1u, next >= end), before, next);
}

/// Decides all pairs that blocks have found; whether any lane has more to test. Pairs that wait at a time are as many
/// as all vertices of the blocks may make, so that the work does not depend on which of them are in which block.
/// allow(atomic-result): the order in which pairs wait cannot show, as each is decided by itself
fn settle(frame: Frame, pair: u32, lane: u32, block: Block, has_more: bool) -> bool {
    let found = countOneBits(block.bits);
    var place = 0u;
    if (block.count != 0u) {
        place = atomicAdd(&pushed, (block.count << 14u) | found) & 0x3fffu;
    }
    if (has_more) {
        atomicOr(&pushed, 0x80000000u);
    }
    let left = next_state(lane);
    let total = left & 0x3fffu;
    for (var start = 0u; start < ((left >> 14u) & 0x3fffu); start += WAITING) {
        if ((place < start + WAITING) & (place + found > start)) {
            wait(lane, pair, block.ranges, block.bits, place - start);
        }
        workgroupBarrier();
        for (var i = start + lane; i < min(total, start + WAITING); i += GROUP) {
            decide(frame, pair, waiting[i - start]);
        }
        workgroupBarrier();
    }
    return (left >> 31u) != 0u;
}

/// Occlusion by the parts of a workgroup, of at most MOST vertices under each from number `skip` on; how many there are
/// under this lane's.
fn occlude_group(number: u32, lane: u32, skip: u32) -> u32 {
    let pair = number / params.groups;
    let mine = (number - pair * params.groups) * GROUP + lane;
    let frame = frames[params.pair + pair];
    var count = 0u;
    if (mine < params.parts) {
        count = vertices_under(region_of(frame, mine, corners_of(frame, mine)), pair);
    }
    let sorted = sort_parts(lane, mine, select(0u, count, count > skip));
    let task = task_of(frame, pair, order[lane], lane < sorted);
    var cursor = Cursor(task.region.rows.x, 0u, skip);
    var is_open = true;
    while (is_open) {
        var block = Block();
        if (cursor.row <= task.region.rows.y) {
            block = block_at(task, pair, cursor, skip + MOST);
            cursor = behind(cursor, block, task.region.rows.y, skip + MOST);
        }
        is_open = settle(frame, pair, lane, block, cursor.row <= task.region.rows.y);
    }
    return count;
}

@compute @workgroup_size(GROUP)
fn occlude(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let count = occlude_group(params.first + group.x, lane, 0u);
    if (count > MOST) {
        atomicMax(&more[1], (count - 1u) / MOST);
    }
}

/// The same for vertices that `occlude` has left.
@compute @workgroup_size(GROUP)
fn occlude_rest(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    occlude_group(params.first + group.x, lane, (group.y + 1u) * MOST);
}

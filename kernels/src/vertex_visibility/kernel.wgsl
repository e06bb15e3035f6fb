// Vertex visibility: which vertices of a mesh are occluded towards which directional lights, exactly and without a depth map.
//
// "Ambient occlusion by occlusion queries", sections 3.1 and 3.2, outside-in: all vertices at once for a direction. Instead of
// a depth map the vertices themselves are binned in the plane across the direction, and each triangle tests those under it
// (an irregular z-buffer, with the roles of points and triangles as in Johnson et al., "The Irregular Z-Buffer", 2005); opposite
// directions share the projection. `oracle.rs` has the definition that every bit meets. Output: bit 2p (2p + 1) % 32 of
// `occluded[row + vertex]` is set if a triangle hides the vertex towards the first (second) direction of pair p; other bits
// are left as they are.
//
// Coordinates are taken in the cyclic order u, v, w in which the direction's largest component is that of w, and of the
// two opposite directions the one with d.w > 0 is "forward". Along it (u, v, w) falls on X = u d.w - w d.u,
// Y = v d.w - w d.v, exactly; |X|, |Y| < 2^29, as |d.u| + |d.v| + d.w <= 2^14. An f32 barycentric test decides most pairs;
// a pair in doubt is decided by `exact_side`.

import package::shared::wide::{add64, dot64, imul_wide, neg64, sgn64, sub64, umul_hi, umul_wide};

/// Parts of triangles of a workgroup.
const GROUP: u32 = 256u;
/// Classes of parts by the number of vertices under their boxes; a power of four.
const CLASSES: u32 = 64u;
/// Zeros below the first class: three times the longest reach of a step of their prefix sums.
const BELOW: u32 = 48u;
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
    /// Vertices under each part's box that earlier launches have met, and the most that this one meets.
    skip: u32,
    most: u32,
    /// Workgroups of the launch.
    launch: u32,
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
/// X, Y, w and number of every vertex, bin by bin.
@group(0) @binding(5) var<storage, read_write> placed: array<vec4<i32>>;
/// x of all parts' first corners, y of all first corners, …, z of all third corners.
@group(0) @binding(6) var<storage, read> corners: array<i32>;
/// First place of every bin, and the place behind the last.
@group(0) @binding(7) var<storage, read> starts: array<u32>;
@group(0) @binding(8) var<storage, read> points: array<vec4<i32>>;
@group(0) @binding(9) var<storage, read_write> occluded: array<atomic<u32>>;
/// Numbers of all parts' first corners, then of all second and third ones; then, for a triangle in one part, how many of its
/// corners are vertices, else 4 and more for its parts.
@group(0) @binding(10) var<storage, read> numbers: array<u32>;
/// Workgroups that the launches after the first need: all or none.
@group(0) @binding(11) var<storage, read_write> more: array<atomic<u32>>;

var<workgroup> sizes: array<atomic<u32>, CLASSES>;
/// Two sides, as a step of prefix sums reads one and writes the other.
var<workgroup> ladder: array<u32, 2u * (CLASSES + BELOW)>;
/// Parts with vertices under their boxes, those with few first.
var<workgroup> order: array<u32, GROUP>;

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
    let slot = atomicAdd(&cursors[bin_of(frame, pair, p) + 1u], 1u);
    placed[slot] = vec4<i32>(p, bitcast<i32>(i));
}

/// A triangle over its first corner: barycentric weights of the two others are b . (x, y) and c . (x, y), and w rises by
/// their multiples of `rise`. Weights are within `slack`, a distance within `low` and `high` is in doubt.
struct Face {
    origin: vec3<i32>,
    b: vec2<f32>,
    c: vec2<f32>,
    rise: vec2<f32>,
    slack: f32,
    low: f32,
    high: f32,
}

/// Columns and rows of bins that the box of a triangle, or of a part of it, meets.
struct Region {
    columns: vec2<u32>,
    rows: vec2<u32>,
    span: i32,
}

fn region_of(frame: Frame, a: vec3<i32>, b: vec3<i32>, c: vec3<i32>) -> Region {
    let low = min(min(a.xy, b.xy), c.xy);
    let high = max(max(a.xy, b.xy), c.xy);
    return Region(vec2<u32>(column_of(frame, low.x), column_of(frame, high.x)),
        vec2<u32>(row_of(frame, low.y), row_of(frame, high.y)), max(high.x - low.x, high.y - low.y));
}

/// Whether three points of the plane are on one line.
fn is_edge_on(a: vec3<i32>, b: vec3<i32>, c: vec3<i32>) -> bool {
    let d = b.xy - a.xy;
    let e = c.xy - a.xy;
    let t = sub64(imul_wide(d.x, e.y), imul_wide(d.y, e.x));
    return (t.x | t.y) == 0u;
}

/// Whether f32 cannot tell a triangle's area from none.
/// float: filter - the area is within 2^-20 of `size`, and 2^-12 is asked for
fn is_thin(a: vec3<i32>, b: vec3<i32>, c: vec3<i32>) -> bool {
    let d = vec2<f32>(b.xy - a.xy);
    let e = vec2<f32>(c.xy - a.xy);
    let size = abs(d.x * e.y) + abs(d.y * e.x);
    return abs(d.x * e.y - d.y * e.x) <= size * 0.000244140625;
}

/// float: filter - `slack` is eight times the error of a weight: the area's, relative to it, and that of products and sums
/// of up to `spread`
fn prepare(frame: Frame, a: vec3<i32>, b: vec3<i32>, c: vec3<i32>, span: i32) -> Face {
    let d = vec2<f32>(b.xy - a.xy);
    let e = vec2<f32>(c.xy - a.xy);
    let thin = is_thin(a, b, c);
    let size = abs(d.x * e.y) + abs(d.y * e.x);
    let per_area = 1.0 / select(d.x * e.y - d.y * e.x, 1.0, thin);
    let to_b = vec2<f32>(e.y, 0.0 - e.x) * per_area;
    let to_c = vec2<f32>(0.0 - d.y, d.x) * per_area;
    let rise = vec2<f32>(f32(b.z - a.z), f32(c.z - a.z));
    let distance = f32(bitcast<u32>(span) + frame.reach);
    let spread = distance * (abs(to_b.x) + abs(to_b.y) + abs(to_c.x) + abs(to_c.y));
    let error = (2.0 * spread + 1.0) * (size * abs(per_area) + 1.0) * 0.0000019073486328125;
    let slack = select(error, UNDECIDED, thin);
    let depth_slack = 2.0 * (abs(rise.x) + abs(rise.y)) * slack + 0.0625;
    let bias = f32(params.bias);
    return Face(a, to_b, to_c, rise, slack, bias - depth_slack, bias + depth_slack);
}

/// Sign of det(d, p, q) for the edge from p to q, seen from the vertex that both are relative to; where it is 0, the sign
/// for a vertex moved by (e, e^2, e^3) along x, y and z, that of the first component of d x (q - p) that is not 0.
fn edge_side(frame: Frame, p: vec3<i32>, q: vec3<i32>) -> i32 {
    let n = cross_of(p, q);
    let t = along(frame, n);
    let g = cross_of(vec3<i32>(frame.u, frame.v, frame.w), q - p);
    let x = select(select(g.x, g.z, frame.axis == 1u), g.y, frame.axis == 2u);
    let y = select(select(g.y, g.x, frame.axis == 1u), g.z, frame.axis == 2u);
    let z = select(select(g.z, g.y, frame.axis == 1u), g.x, frame.axis == 2u);
    let tie = select(select(z, y, y != 0), x, x != 0);
    return select(sgn64(t), sign(tie), (t.x | t.y) == 0u);
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
/// Differences are below 2^15, so normals are below 2^31, `rise` below 2^48 and its product with d.w below 2^62; d . n is
/// below 2^45, and its product with the bias below 2^60.
fn exact_side(frame: Frame, part: u32, vertex: u32) -> i32 {
    let v = vertex_at(frame, vertex);
    let a = corner_at(frame, part, 0u) - v;
    let b = corner_at(frame, part, 1u) - v;
    let c = corner_at(frame, part, 2u) - v;
    let side = edge_side(frame, a, b);
    if ((side == 0) | (side != edge_side(frame, b, c)) | (side != edge_side(frame, c, a))) {
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

/// Whether a vertex is a corner of a part's triangle, which then cannot hide it: most doubts are of this kind.
fn is_corner(part: u32, vertex: u32) -> bool {
    let n = params.parts;
    return (vertex == numbers[part]) | (vertex == numbers[n + part]) | (vertex == numbers[2u * n + part]);
}

/// float: filter - what `slack`, `low` and `high` leave in doubt is decided by `exact_side`
fn test(frame: Frame, face: Face, part: u32, at: u32) {
    let p = points[at];
    let x = f32(p.x - face.origin.x);
    let y = f32(p.y - face.origin.y);
    let b = x * face.b.x + y * face.b.y;
    let c = x * face.c.x + y * face.c.y;
    let inner = min(min(b, c), 1.0 - b - c);
    let ahead = f32(face.origin.z - p.z) + (b * face.rise.x + c * face.rise.y);
    let distance = abs(ahead);
    if ((inner > 0.0 - face.slack) & (distance > face.low)) {
        var side = select(-1, 1, ahead > 0.0);
        if (!((inner > face.slack) & (distance > face.high))) {
            side = 0;
            if (!is_corner(part, bitcast<u32>(p.w))) {
                side = exact_side(frame, part, bitcast<u32>(p.w));
            }
        }
        if (side != 0) {
            let second = select(1u, 0u, side > 0) ^ frame.flip;
            atomicOr(&occluded[params.row + bitcast<u32>(p.w)], 1u << (frame.bit + second));
        }
    }
}

/// Corners of a part in (X, Y, w).
struct Corners {
    a: vec3<i32>,
    b: vec3<i32>,
    c: vec3<i32>,
}

fn corners_of(frame: Frame, part: u32) -> Corners {
    return Corners(flatten(frame, corner_at(frame, part, 0u)), flatten(frame, corner_at(frame, part, 1u)),
        flatten(frame, corner_at(frame, part, 2u)));
}

/// Bins under a part: of a triangle in several parts, `params.rows` rows each.
fn bins_of(frame: Frame, part: u32, corners: Corners) -> Region {
    let region = region_of(frame, corners.a, corners.b, corners.c);
    let number = numbers[3u * params.parts + part];
    if (number < 4u) {
        return region;
    }
    let row = region.rows.x + (number - 4u) * params.rows;
    return Region(region.columns, vec2<u32>(row, min(region.rows.y, row + params.rows - 1u)), region.span);
}

/// How many vertices are in bins under a part; none if they are no more than its own corners.
fn vertices_under(region: Region, pair: u32, part: u32) -> u32 {
    let first = (pair << params.bin_bits) + region.columns.x;
    let width = region.columns.y - region.columns.x + 1u;
    var sum = 0u;
    for (var row = region.rows.x; row <= region.rows.y; row += 1u) {
        let bin = first + (row << params.column_bits);
        sum += starts[bin + width] - starts[bin];
    }
    let corners = numbers[3u * params.parts + part];
    return select(sum, 0u, (corners < 4u) & (sum == corners));
}

/// A class that grows with a number from 1 on: exact below 16, then four classes to each doubling.
fn class_of(count: u32) -> u32 {
    let top = firstLeadingBit(max(count, 16u));
    let wide = 4u * top + ((count >> (top - 2u)) & 3u);
    return min(select(wide, count, count < 16u), CLASSES - 1u);
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

/// Puts the workgroup's parts in order, so that neighbouring lanes have about as many vertices to test; the number of those
/// that have any. A part that has none gives 0.
/// allow(atomic-result): the order of parts within a class cannot show, as each is tested by itself
fn sort_parts(lane: u32, part: u32, count: u32) -> u32 {
    let size = class_of(count);
    if (lane < BELOW) {
        ladder[lane] = 0u;
        ladder[lane + CLASSES + BELOW] = 0u;
    }
    workgroupBarrier();
    if (count != 0u) {
        atomicAdd(&sizes[size], 1u);
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
        atomicStore(&sizes[lane], sum - own);
        ladder[CLASSES + BELOW + BELOW + lane] = sum;
    }
    workgroupBarrier();
    if (count != 0u) {
        order[atomicAdd(&sizes[size], 1u)] = part;
    }
    workgroupBarrier();
    return ladder[2u * (CLASSES + BELOW) - 1u];
}

/// One lane tests the vertices under a part, from number `params.skip` on and at most `params.most`.
fn sweep(frame: Frame, face: Face, region: Region, pair: u32, part: u32) {
    let first = (pair << params.bin_bits) + region.columns.x;
    let width = region.columns.y - region.columns.x + 1u;
    var row = region.rows.x;
    var at = 0u;
    var end = 0u;
    var skip = params.skip;
    var left = params.most;
    while ((at < end) | (row <= region.rows.y)) {
        if (at == end) {
            let bin = first + (row << params.column_bits);
            at = starts[bin];
            end = starts[bin + width];
            let met = min(skip, end - at);
            at += met;
            skip -= met;
            end = min(end, at + left);
            left -= end - at;
            row += 1u;
        }
        if (at < end) {
            test(frame, face, part, at);
            at += 1u;
        }
    }
}

/// Occlusion by the parts of one workgroup; whether one of them has more vertices than this launch meets.
fn occlude_group(number: u32, lane: u32) -> bool {
    let pair = number / params.groups;
    let mine = (number - pair * params.groups) * GROUP + lane;
    let frame = frames[params.pair + pair];
    var count = 0u;
    if (mine < params.parts) {
        count = vertices_under(bins_of(frame, mine, corners_of(frame, mine)), pair, mine);
    }
    let busy = sort_parts(lane, mine, select(0u, count, count > params.skip));
    if (lane < busy) {
        let part = order[lane];
        let corners = corners_of(frame, part);
        let region = bins_of(frame, part, corners);
        var edge_on = false;
        if (is_thin(corners.a, corners.b, corners.c)) {
            edge_on = is_edge_on(corners.a, corners.b, corners.c);
        }
        if (!edge_on) {
            sweep(frame, prepare(frame, corners.a, corners.b, corners.c, region.span), region, pair, part);
        }
    }
    return count > params.skip + params.most;
}

@compute @workgroup_size(GROUP)
fn occlude(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    if (occlude_group(params.first + group.x, lane)) {
        atomicMax(&more[0], params.launch);
    }
}

/// The same for vertices that `occlude` has left: launched as often as there could be any, with workgroups if there are.
@compute @workgroup_size(GROUP)
fn occlude_rest(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    occlude_group(params.first + group.x, lane);
}

// Greatest depths of squares of a depth buffer, boxes tested against them, and predicates for drawing.
//
// Greene, Kass and Miller, "Hierarchical Z-Buffer Visibility" (SIGGRAPH 1993), section 3: a pyramid whose texel has the
// greatest depth of four finer ones. Décoret, "N-Buffers for efficient depth map query" (Eurographics 2005), section 3:
// a level of a picture's size whose texel has the greatest depth of the square of side 2^l that begins there. Both are
// what Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), section 2, compare with.
//
// `halve` makes level l + 1 of the pyramid from level l: coarse texel (x, y) is the greatest of the texels (2x, 2y) to
// (2x + 1, 2y + 1) that exist. `widen` makes level l + 1 of the N-buffers: texel p is the greatest of level l at p,
// p + (s, 0), p + (0, s) and p + (s, s), those that exist, where s = 2^l.
//
// A box has a rectangle of pixels, half-open and not empty, and a least depth. It is hidden iff that is more than the
// greatest depth of a region that holds the rectangle: in `test_pyramid` the texels that meet it on the least level
// where they are at most two by two; in `test_buffers` the squares of side s = 2^floor(log2 of its longer side) that
// begin at its first column and row and s before its ends, but not before its first. Only boxes of the bound level are
// answered.
//
// `predicate` writes the workgroups of draw i as they are where counts[object] exceeds a threshold, else 0.

struct Params {
    /// Columns and rows of the bound level.
    width: u32,
    height: u32,
    /// The bound level.
    level: u32,
    /// Boxes, or draws.
    count: u32,
    /// Counts up to this draw nothing.
    threshold: u32,
    /// Row or workgroup of the first invocation.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> fine: array<u32>;
@group(0) @binding(2) var<storage, read_write> coarse: array<u32>;
/// First column and row, and one past the last of each.
@group(0) @binding(3) var<storage, read> rectangles: array<vec4<u32>>;
@group(0) @binding(4) var<storage, read> nearest: array<u32>;
@group(0) @binding(5) var<storage, read_write> hidden: array<u32>;
@group(0) @binding(6) var<storage, read> counts: array<u32>;
/// Workgroups along x, y and z, and the object of a draw.
@group(0) @binding(7) var<storage, read> draws: array<vec4<u32>>;
@group(0) @binding(8) var<storage, read_write> arguments: array<u32>;

/// The depth of a texel, 0 where there is none.
fn depth_at(x: u32, y: u32) -> u32 {
    var depth = 0u;
    if ((x < params.width) & (y < params.height)) {
        depth = fine[y * params.width + x];
    }
    return depth;
}

fn greatest(low: vec2<u32>, high: vec2<u32>) -> u32 {
    return max(max(depth_at(low.x, low.y), depth_at(high.x, low.y)), max(depth_at(low.x, high.y), depth_at(high.x, high.y)));
}

@compute @workgroup_size(256)
fn halve(@builtin(global_invocation_id) id: vec3<u32>) {
    let row = params.first + id.y;
    let columns = (params.width + 1u) / 2u;
    if ((id.x >= columns) | (row >= (params.height + 1u) / 2u)) {
        return;
    }
    let low = 2u * vec2<u32>(id.x, row);
    coarse[row * columns + id.x] = greatest(low, low + 1u);
}

@compute @workgroup_size(256)
fn widen(@builtin(global_invocation_id) id: vec3<u32>) {
    let row = params.first + id.y;
    if ((id.x >= params.width) | (row >= params.height)) {
        return;
    }
    let low = vec2<u32>(id.x, row);
    coarse[row * params.width + id.x] = greatest(low, low + (1u << params.level));
}

@compute @workgroup_size(256)
fn test_pyramid(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.count) {
        return;
    }
    let r = rectangles[number];
    var level = 0u;
    while (any(((r.zw - 1u) >> vec2<u32>(level)) > (r.xy >> vec2<u32>(level)) + 1u)) {
        level += 1u;
    }
    if (level == params.level) {
        let far = greatest(r.xy >> vec2<u32>(level), (r.zw - 1u) >> vec2<u32>(level));
        hidden[number] = select(0u, 1u, nearest[number] > far);
    }
}

@compute @workgroup_size(256)
fn test_buffers(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.count) {
        return;
    }
    let r = rectangles[number];
    let level = firstLeadingBit(max(r.z - r.x, r.w - r.y));
    if (level == params.level) {
        let last = max(r.zw, r.xy + (1u << level)) - (1u << level);
        hidden[number] = select(0u, 1u, nearest[number] > greatest(r.xy, last));
    }
}

@compute @workgroup_size(256)
fn predicate(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.count) {
        return;
    }
    let draw = draws[number];
    let groups = select(vec3<u32>(0u), draw.xyz, counts[draw.w] > params.threshold);
    arguments[3u * number] = groups.x;
    arguments[3u * number + 1u] = groups.y;
    arguments[3u * number + 2u] = groups.z;
}

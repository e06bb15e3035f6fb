// Mip pyramids of one to eight channels, as sums, and sums over rectangles from them.
//
// Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), section 3.1.4: instead of a
// summed-area table, a quad-tree a channel tracks how many texels are occupied, and a rectangle is put together from
// its nodes.
//
// Level 0 is the image, by rows, one channel after another. Level k + 1 has half the columns and rows of level k,
// rounded up, and
//
//     level[k + 1](x, y) = sum of level[k](i, j) over 2 x <= i < 2 x + 2, 2 y <= j < 2 y + 2,
//
// modulo 2^32, up to the level of one node a channel. Levels 1 and up stand one after another in `nodes`.
//
// `rectangle_sums` answers half-open rectangles, cut to the image, as the tables of `sat` do: at each level what stands
// out by a column or a row is added, and the rest is taken at the next one. What reaches the image's border stands out
// nowhere there, so the whole image is one node.

struct Params {
    /// Columns and rows of the level that is halved, or of the image.
    width: u32,
    height: u32,
    channels: u32,
    rectangles: u32,
    /// First node of the finer level, if it is not the image, and of the coarser one.
    fine: u32,
    coarse: u32,
    /// Number of the first workgroup.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> image: array<u32>;
@group(0) @binding(2) var<storage, read_write> nodes: array<u32>;
/// The nodes, once all levels are there.
@group(0) @binding(3) var<storage, read> whole: array<u32>;
/// x0, y0, x1, y1.
@group(0) @binding(4) var<storage, read> rectangles: array<vec4<u32>>;
@group(0) @binding(5) var<storage, read_write> sums: array<u32>;

/// Where a node of the coarser level stands, and the first of its four in the finer one.
struct Node {
    exists: bool,
    place: u32,
    child: u32,
    /// Whether it has a second column and a second row.
    more: vec2<bool>,
}

/// A row of workgroups takes a row of nodes, and a slice of them a channel.
fn node_at(id: vec3<u32>) -> Node {
    let x = id.x;
    let y = params.first + id.y;
    let width = (params.width + 1u) / 2u;
    let height = (params.height + 1u) / 2u;
    let child = (id.z * params.height + 2u * y) * params.width + 2u * x;
    let more = vec2<bool>(2u * x + 1u < params.width, 2u * y + 1u < params.height);
    return Node(x < width, params.coarse + (id.z * height + y) * width + x, child, more);
}

@compute @workgroup_size(64)
fn halve_image(@builtin(global_invocation_id) id: vec3<u32>) {
    let node = node_at(id);
    if (!node.exists) {
        return;
    }
    var sum = image[node.child];
    if (node.more.x) {
        sum += image[node.child + 1u];
    }
    if (node.more.y) {
        sum += image[node.child + params.width];
    }
    if (node.more.x & node.more.y) {
        sum += image[node.child + params.width + 1u];
    }
    nodes[node.place] = sum;
}

@compute @workgroup_size(64)
fn halve(@builtin(global_invocation_id) id: vec3<u32>) {
    let node = node_at(id);
    if (!node.exists) {
        return;
    }
    let child = params.fine + node.child;
    var sum = nodes[child];
    if (node.more.x) {
        sum += nodes[child + 1u];
    }
    if (node.more.y) {
        sum += nodes[child + params.width];
    }
    if (node.more.x & node.more.y) {
        sum += nodes[child + params.width + 1u];
    }
    nodes[node.place] = sum;
}

/// A level: its first node of a channel, and its sides.
struct Level {
    image: bool,
    start: u32,
    size: vec2<u32>,
}

fn node(level: Level, x: u32, y: u32) -> u32 {
    let place = level.start + y * level.size.x + x;
    if (level.image) {
        return image[place];
    }
    return whole[place];
}

/// What a lane adds of column x, from row `low` to before row `high`.
fn column_sum(level: Level, x: u32, low: u32, high: u32, lane: u32) -> u32 {
    var sum = 0u;
    for (var y = low + lane; y < high; y += 64u) {
        sum += node(level, x, y);
    }
    return sum;
}

/// What a lane adds of row y, from column `low` to before column `high`.
fn row_sum(level: Level, y: u32, low: u32, high: u32, lane: u32) -> u32 {
    var sum = 0u;
    for (var x = low + lane; x < high; x += 64u) {
        sum += node(level, x, y);
    }
    return sum;
}

fn is_odd(n: u32) -> bool {
    return (n & 1u) != 0u;
}

/// What a lane adds of a rectangle of a channel: columns and rows that stand out, level by level.
fn lane_sum(rectangle: u32, channel: u32, lane: u32) -> u32 {
    let size = vec2<u32>(params.width, params.height);
    var low = min(rectangles[rectangle].xy, size);
    var high = min(rectangles[rectangle].zw, size);
    var level = Level(true, channel * size.x * size.y, size);
    // First node of the next level, and of all channels.
    var next = 0u;
    var sum = 0u;
    while (all(low < high)) {
        if (all(level.size == vec2<u32>(1u))) {
            return sum + column_sum(level, 0u, 0u, 1u, lane);
        }
        if (is_odd(low.x)) {
            sum += column_sum(level, low.x, low.y, high.y, lane);
            low.x += 1u;
        }
        if (is_odd(high.x) & (high.x < level.size.x) & (low.x < high.x)) {
            high.x -= 1u;
            sum += column_sum(level, high.x, low.y, high.y, lane);
        }
        if (is_odd(low.y)) {
            sum += row_sum(level, low.y, low.x, high.x, lane);
            low.y += 1u;
        }
        if (is_odd(high.y) & (high.y < level.size.y) & (low.y < high.y)) {
            high.y -= 1u;
            sum += row_sum(level, high.y, low.x, high.x, lane);
        }
        low /= 2u;
        high = (high + 1u) / 2u;
        let coarse = (level.size + 1u) / 2u;
        level = Level(false, next + channel * coarse.x * coarse.y, coarse);
        next += params.channels * coarse.x * coarse.y;
    }
    return sum;
}

var<workgroup> total: atomic<u32>;

/// A workgroup takes a rectangle, and a row of them a channel.
@compute @workgroup_size(64)
fn rectangle_sums(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let rectangle = params.first + group.x;
    if (rectangle >= params.rectangles) {
        return;
    }
    atomicAdd(&total, lane_sum(rectangle, group.y, lane));
    workgroupBarrier();
    if (lane == 0u) {
        sums[group.y * params.rectangles + rectangle] = atomicLoad(&total);
    }
}

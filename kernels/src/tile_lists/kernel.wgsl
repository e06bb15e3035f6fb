// Tile lists: which triangles can hide anything from the receivers of each tile, by number.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 3: a triangle matters to the receivers
// of its influence region alone. The lists are a counting sort of (tile, triangle) as in Satish, Harris and Garland,
// "Designing Efficient Sorting Algorithms for Manycore GPUs" (IPDPS 2009): `count` a block of triangles by tiles, the
// sums of all counts before, tile after tile and block after block (kernel `scan`), and `scatter` a block to where its
// sums say.
//
// A region is first and last column, first and last row of receivers, as `influence_region` writes it; none where a
// first exceeds its last. Tile (x, y) has number y * tiles_x + x and holds the receivers with column >> shift_x = x and
// row >> shift_y = y. Outputs:
//
// * `tally`, for each block of BLOCK triangles eight words: entries in tiles of 1, 2, 4 and 8 times 2^shift_y rows,
//   triangles that have a region, sum of their rows, and their receivers as sums of area % 2^16 and area / 2^16.
// * `starts[t]` is the number of entries of all tiles before t, and `entries[starts[t]]` up to `starts[t + 1]` are the
//   triangles whose region meets tile t, ascending.
//
// The order rests on no atomic: within a block, STEP triangles at a time set their bits in the tiles that they meet,
// and the bits below its own tell each its place.

/// Triangles of a block.
const BLOCK: u32 = 1024u;
/// Tiles of a window: a workgroup takes the tiles of as many whole rows as fit.
const WINDOW: u32 = 1024u;
/// Triangles that are scattered at a time.
const STEP = 64u;
const LANES = 256u;

struct Params {
    triangles: u32,
    blocks: u32,
    /// Block of the first workgroup.
    first: u32,
    /// Logarithms of a tile's receivers along x and y.
    shift_x: u32,
    shift_y: u32,
    tiles_x: u32,
    tiles_y: u32,
    /// Rows of tiles in a window.
    window: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> regions: array<vec4<i32>>;
@group(0) @binding(2) var<storage, read_write> tallies: array<u32>;
/// Count of tile t in block b at t * blocks + b.
@group(0) @binding(3) var<storage, read_write> counts: array<u32>;
/// What precedes each count.
@group(0) @binding(4) var<storage, read> offsets: array<u32>;
@group(0) @binding(5) var<storage, read_write> starts: array<u32>;
@group(0) @binding(6) var<storage, read_write> entries: array<u32>;

/// The region of a triangle; none past the last.
fn region_of(triangle: u32) -> vec4<i32> {
    if (triangle < params.triangles) {
        return regions[triangle];
    }
    return vec4<i32>(0, -1, 0, -1);
}

/// First and last column, first and last row of the tiles of a window that a triangle's region meets; a window begins
/// at row `top`, and rows count from there.
fn tiles_of(triangle: u32, top: u32) -> vec4<i32> {
    let region = region_of(triangle);
    if ((region.x > region.y) | (region.z > region.w)) {
        return vec4<i32>(0, -1, 0, -1);
    }
    let above = bitcast<i32>(top);
    let last = bitcast<i32>(min(params.window, params.tiles_y - top)) - 1;
    return vec4<i32>(
        region.x >> params.shift_x,
        min(region.y >> params.shift_x, bitcast<i32>(params.tiles_x) - 1),
        max((region.z >> params.shift_y) - above, 0),
        min((region.w >> params.shift_y) - above, last),
    );
}

var<workgroup> lane_sums: array<u32, 2048>;
var<workgroup> part_sums: array<u32, 128>;

@compute @workgroup_size(256)
fn tally(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let block = params.first + group.x;
    var entries_of = vec4<u32>(0u);
    var sizes = vec4<u32>(0u);
    for (var place = lane; place < BLOCK; place += LANES) {
        let region = region_of(block * BLOCK + place);
        if ((region.x <= region.y) & (region.z <= region.w)) {
            let columns = bitcast<u32>((region.y >> params.shift_x) - (region.x >> params.shift_x) + 1);
            let shifts = params.shift_y + vec4<u32>(0u, 1u, 2u, 3u);
            let rows = (vec4<i32>(region.w) >> shifts) - (vec4<i32>(region.z) >> shifts) + 1;
            entries_of += columns * bitcast<vec4<u32>>(rows);
            let height = bitcast<u32>(region.w - region.z + 1);
            let area = bitcast<u32>(region.y - region.x + 1) * height;
            sizes += vec4<u32>(1u, height, area & 0xffffu, area >> 16u);
        }
    }
    for (var k = 0u; k < 4u; k += 1u) {
        lane_sums[k * LANES + lane] = entries_of[k];
        lane_sums[(4u + k) * LANES + lane] = sizes[k];
    }
    workgroupBarrier();
    // Sixteen invocations a sum, and one that adds theirs.
    if (lane < 128u) {
        var sum = 0u;
        for (var at = lane & 15u; at < LANES; at += 16u) {
            sum += lane_sums[(lane >> 4u) * LANES + at];
        }
        part_sums[lane] = sum;
    }
    workgroupBarrier();
    if (lane < 8u) {
        var sum = 0u;
        for (var at = 0u; at < 16u; at += 1u) {
            sum += part_sums[lane * 16u + at];
        }
        tallies[8u * block + lane] = sum;
    }
}

/// Counts, or the next place in the list, of each tile of the window.
var<workgroup> found: array<atomic<u32>, WINDOW>;
/// Which of STEP triangles meet a tile, two words a tile.
var<workgroup> marks: array<atomic<u32>, 2u * WINDOW>;

/// Tiles of the window that begins at row `top`.
fn window_tiles(top: u32) -> u32 {
    return min(params.window, params.tiles_y - top) * params.tiles_x;
}

@compute @workgroup_size(256)
fn count(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let block = params.first + group.x;
    let top = group.y * params.window;
    let tiles = window_tiles(top);
    for (var tile = lane; tile < tiles; tile += LANES) {
        atomicStore(&found[tile], 0u);
    }
    workgroupBarrier();
    for (var place = lane; place < BLOCK; place += LANES) {
        let met = tiles_of(block * BLOCK + place, top);
        for (var y = met.z; y <= met.w; y += 1) {
            let row = bitcast<u32>(y) * params.tiles_x;
            for (var x = met.x; x <= met.y; x += 1) {
                atomicAdd(&found[row + bitcast<u32>(x)], 1u);
            }
        }
    }
    workgroupBarrier();
    for (var tile = lane; tile < tiles; tile += LANES) {
        counts[(top * params.tiles_x + tile) * params.blocks + block] = atomicLoad(&found[tile]);
    }
}

@compute @workgroup_size(256)
fn start(@builtin(global_invocation_id) id: vec3<u32>) {
    let tile = params.first * LANES + id.x;
    if (tile <= params.tiles_x * params.tiles_y) {
        starts[tile] = offsets[tile * params.blocks];
    }
}

@compute @workgroup_size(256)
fn scatter(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let block = params.first + group.x;
    let top = group.y * params.window;
    let tiles = window_tiles(top);
    for (var tile = lane; tile < tiles; tile += LANES) {
        atomicStore(&found[tile], offsets[(top * params.tiles_x + tile) * params.blocks + block]);
        atomicStore(&marks[2u * tile], 0u);
        atomicStore(&marks[2u * tile + 1u], 0u);
    }
    workgroupBarrier();
    // Four invocations share a triangle's rows of tiles.
    let slot = lane % STEP;
    let word = slot >> 5u;
    let bit = 1u << (slot & 31u);
    let before = vec2<u32>(select(bit - 1u, 0xffffffffu, word == 1u), select(0u, bit - 1u, word == 1u));
    for (var step = 0u; step < BLOCK; step += STEP) {
        let triangle = block * BLOCK + step + slot;
        let met = tiles_of(triangle, top);
        let first = met.z + bitcast<i32>(lane / STEP);
        for (var y = first; y <= met.w; y += 4) {
            let row = bitcast<u32>(y) * params.tiles_x;
            for (var x = met.x; x <= met.y; x += 1) {
                atomicOr(&marks[2u * (row + bitcast<u32>(x)) + word], bit);
            }
        }
        workgroupBarrier();
        for (var y = first; y <= met.w; y += 4) {
            let row = bitcast<u32>(y) * params.tiles_x;
            for (var x = met.x; x <= met.y; x += 1) {
                let tile = row + bitcast<u32>(x);
                let low = atomicLoad(&marks[2u * tile]) & before.x;
                let high = atomicLoad(&marks[2u * tile + 1u]) & before.y;
                let at = atomicLoad(&found[tile]) + countOneBits(low) + countOneBits(high);
                entries[at] = triangle;
            }
        }
        workgroupBarrier();
        for (var y = first; y <= met.w; y += 4) {
            let row = bitcast<u32>(y) * params.tiles_x;
            for (var x = met.x; x <= met.y; x += 1) {
                let tile = row + bitcast<u32>(x);
                atomicStore(&marks[2u * tile + word], 0u);
                atomicAdd(&found[tile], 1u);
            }
        }
        workgroupBarrier();
    }
}

// Prefix sums of u32, modulo 2^32.
//
// Reduce-then-scan of Merrill and Grimshaw, "Parallel Scan for Stream Architectures" (University of Virginia, 2009):
// the sums of all tiles are taken, scanned by this same kernel one level up, and carried into the scan of each tile. No
// workgroup ever waits for another, so nothing is asked of the device's scheduler.
//
// With x = the first `count` words of `input`, word i < count of `output` is, modulo 2^32,
//
//     inclusive   x[0] + … + x[i]
//     exclusive   x[0] + … + x[i - 1], and 0 for i = 0.
//
// Words travel in fours: both buffers are a multiple of 16 bytes long. What `input` holds past `count` is ignored; the
// words of `output` between `count` and the next multiple of four become 0, and no word past those is written.

import package::shared::block_scan::{block_scan, prefix4};

/// Which of the two sums.
const INCLUSIVE: bool = true;
/// Words a workgroup.
const TILE: u32 = 4096u;

struct Params {
    count: u32,
    /// Tile of the first workgroup.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> input: array<vec4<u32>>;
/// Sum of every tile.
@group(0) @binding(2) var<storage, read_write> sums: array<u32>;
/// What precedes every tile.
@group(0) @binding(3) var<storage, read> carries: array<u32>;
@group(0) @binding(4) var<storage, read_write> output: array<vec4<u32>>;
/// The input by words.
@group(0) @binding(5) var<storage, read> words: array<u32>;

var<workgroup> lane_sums: array<u32, 256>;
var<workgroup> row_sums: array<u32, 16>;

/// Which words of a four are among the first `count`.
fn present(place: u32) -> vec4<bool> {
    return 4u * place + vec4<u32>(0u, 1u, 2u, 3u) < vec4<u32>(params.count);
}

/// Four words, with 0 for those past the end. `whole` says that the end is not in the workgroup's tile.
fn fetch(place: u32, whole: bool) -> vec4<u32> {
    if (whole) {
        return input[place];
    }
    var four = vec4<u32>(0u);
    if (4u * place < params.count) {
        four = select(four, input[place], present(place));
    }
    return four;
}

/// Stores what precedes `four`, plus `four`'s own sums.
fn emit(place: u32, whole: bool, before: u32, own: vec4<u32>, four: vec4<u32>) {
    let sum = before + own - select(four, vec4<u32>(0u), INCLUSIVE);
    if (whole) {
        output[place] = sum;
    } else if (4u * place < params.count) {
        output[place] = select(vec4<u32>(0u), sum, present(place));
    }
}

fn is_whole(tile: u32) -> bool {
    return TILE * (tile + 1u) <= params.count;
}

@compute @workgroup_size(256)
fn reduce(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let tile = params.first + group.x;
    let first = tile * TILE;
    let end = min(first + TILE, params.count);
    var own = 0u;
    for (var row = first; row < end; row += 256u) {
        if (row + lane < end) {
            own += words[row + lane];
        }
    }
    lane_sums[lane] = own;
    workgroupBarrier();
    if (lane < 16u) {
        var sum = 0u;
        for (var row = 0u; row < 256u; row += 16u) {
            sum += lane_sums[row + lane];
        }
        row_sums[lane] = sum;
    }
    workgroupBarrier();
    if (lane == 0u) {
        var sum = 0u;
        for (var row = 0u; row < 16u; row += 1u) {
            sum += row_sums[row];
        }
        sums[tile] = sum;
    }
}

/// Lane l scans the fours l, l + 256, l + 512 and l + 768 of its tile: neighbours take neighbouring words.
@compute @workgroup_size(256)
fn scan(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let tile = params.first + group.x;
    let first = tile * TILE / 4u + lane;
    let whole = is_whole(tile);
    let a = fetch(first, whole);
    let b = fetch(first + 256u, whole);
    let c = fetch(first + 512u, whole);
    let d = fetch(first + 768u, whole);
    let sum_a = prefix4(a);
    let sum_b = prefix4(b);
    let sum_c = prefix4(c);
    let sum_d = prefix4(d);
    let before = block_scan(lane, vec4<u32>(sum_a.w, sum_b.w, sum_c.w, sum_d.w)) + carries[tile];
    emit(first, whole, before.x, sum_a, a);
    emit(first + 256u, whole, before.y, sum_b, b);
    emit(first + 512u, whole, before.z, sum_c, c);
    emit(first + 768u, whole, before.w, sum_d, d);
}

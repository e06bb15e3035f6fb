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
/// Fours a workgroup: 4096 words.
const TILE: u32 = 1024u;

struct Params {
    count: u32,
}

struct Tile {
    a: vec4<u32>,
    b: vec4<u32>,
    c: vec4<u32>,
    d: vec4<u32>,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> input: array<vec4<u32>>;
/// Sum of every tile.
@group(0) @binding(2) var<storage, read_write> sums: array<u32>;
/// What precedes every tile.
@group(0) @binding(3) var<storage, read> carries: array<u32>;
@group(0) @binding(4) var<storage, read_write> output: array<vec4<u32>>;

var<workgroup> lane_sums: array<u32, 256>;
var<workgroup> row_sums: array<u32, 16>;

/// Which words of a four are among the first `count`.
fn present(place: u32) -> vec4<bool> {
    return 4u * place + vec4<u32>(0u, 1u, 2u, 3u) < vec4<u32>(params.count);
}

/// Four words, with 0 for those past the end. `whole` says that the workgroup's tile has no end.
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

/// Lane l holds the fours l, l + 256, l + 512 and l + 768 of the tile: neighbours read neighbouring words.
fn fetch_tile(first: u32, whole: bool) -> Tile {
    return Tile(
        fetch(first, whole),
        fetch(first + 256u, whole),
        fetch(first + 512u, whole),
        fetch(first + 768u, whole),
    );
}

fn is_whole(tile: u32) -> bool {
    return 4u * TILE * (tile + 1u) <= params.count;
}

@compute @workgroup_size(256)
fn reduce(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let tile = fetch_tile(group.x * TILE + lane, is_whole(group.x));
    let four = tile.a + tile.b + tile.c + tile.d;
    lane_sums[lane] = four.x + four.y + four.z + four.w;
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
        sums[group.x] = sum;
    }
}

@compute @workgroup_size(256)
fn scan(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let first = group.x * TILE + lane;
    let whole = is_whole(group.x);
    let tile = fetch_tile(first, whole);
    let a = prefix4(tile.a);
    let b = prefix4(tile.b);
    let c = prefix4(tile.c);
    let d = prefix4(tile.d);
    let before = block_scan(lane, vec4<u32>(a.w, b.w, c.w, d.w)) + carries[group.x];
    emit(first, whole, before.x, a, tile.a);
    emit(first + 256u, whole, before.y, b, tile.b);
    emit(first + 512u, whole, before.z, c, tile.c);
    emit(first + 768u, whole, before.w, d, tile.d);
}

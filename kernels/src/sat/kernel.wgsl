// Summed-area tables of one channel, modulo 2^32, and sums over rectangles from them.
//
// Crow, "Summed-Area Tables for Texture Mapping" (SIGGRAPH 1984); Hensley et al., "Fast Summed-Area Table Generation
// and its Applications" (Computer Graphics Forum 24(3), 2005); used to count the pixels of objects drawn in pure colours by
// Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), section 3.1.
//
// For an image of `4 * fours` columns (at most 4096) and `height` rows, stored by rows,
//
//     table(x, y) = sum of image(i, j) over i <= x, j <= y, modulo 2^32,
//
// which is exact while width * height * largest value < 2^32: values up to 255 at 4096², to 4095 at 1024². Past that
// the table wraps, and a rectangle is still answered exactly if its own sum is below 2^32.
//
// `bands` scans the rows and sums the columns of each band of 16 rows; `carries` sums what stands above each band, and
// `add` adds it. Rectangles are half-open: `x0 <= x < x1`, `y0 <= y < y1`, cut to the image, and 0 when empty.

import package::shared::block_scan::{block_scan, prefix4};

/// Rows that one workgroup sums.
const BAND: u32 = 16u;

struct Params {
    /// Columns in fours, 1 to 1024.
    fours: u32,
    height: u32,
    rectangles: u32,
    /// Band, or rectangle, of the first workgroup or invocation.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage, read> image: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read_write> table: array<vec4<u32>>;
/// The table by words.
@group(0) @binding(3) var<storage, read_write> words: array<u32>;
/// Row b: the row of the table just above band b + 1.
@group(0) @binding(4) var<storage, read_write> carry: array<u32>;
/// The table by words, once it is whole.
@group(0) @binding(5) var<storage, read> whole: array<u32>;
/// x0, y0, x1, y1.
@group(0) @binding(6) var<storage, read> rectangles: array<vec4<u32>>;
@group(0) @binding(7) var<storage, read_write> sums: array<u32>;

fn fetch(row: u32, column: u32) -> vec4<u32> {
    var four = vec4<u32>(0u);
    if (column < params.fours) {
        four = image[row * params.fours + column];
    }
    return four;
}

fn emit(row: u32, column: u32, four: vec4<u32>) {
    if (column < params.fours) {
        table[row * params.fours + column] = four;
    }
}

/// The table of each band by itself.
@compute @workgroup_size(256)
fn bands(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let top = (params.first + group.x) * BAND;
    let end = min(top + BAND, params.height);
    var sum_a = vec4<u32>(0u);
    var sum_b = vec4<u32>(0u);
    var sum_c = vec4<u32>(0u);
    var sum_d = vec4<u32>(0u);
    for (var row = top; row < end; row += 1u) {
        let a = prefix4(fetch(row, lane));
        let b = prefix4(fetch(row, lane + 256u));
        let c = prefix4(fetch(row, lane + 512u));
        let d = prefix4(fetch(row, lane + 768u));
        let before = block_scan(lane, vec4<u32>(a.w, b.w, c.w, d.w));
        sum_a += before.x + a;
        sum_b += before.y + b;
        sum_c += before.z + c;
        sum_d += before.w + d;
        emit(row, lane, sum_a);
        emit(row, lane + 256u, sum_b);
        emit(row, lane + 512u, sum_c);
        emit(row, lane + 768u, sum_d);
    }
}

/// Sums over all bands above, by column: neighbouring lanes are neighbouring columns.
@compute @workgroup_size(64)
fn carries(@builtin(global_invocation_id) id: vec3<u32>) {
    let width = 4u * params.fours;
    if (id.x >= width) {
        return;
    }
    var sum = 0u;
    for (var band = 0u; (band + 1u) * BAND < params.height; band += 1u) {
        sum += words[((band + 1u) * BAND - 1u) * width + id.x];
        carry[band * width + id.x] = sum;
    }
}

/// Adds to every band but the first what stands above it.
@compute @workgroup_size(256)
fn add(@builtin(workgroup_id) group: vec3<u32>, @builtin(global_invocation_id) id: vec3<u32>) {
    let width = 4u * params.fours;
    if (id.x >= width) {
        return;
    }
    let band = params.first + group.y;
    let above = carry[band * width + id.x];
    let top = (band + 1u) * BAND;
    let end = min(top + BAND, params.height);
    for (var row = top; row < end; row += 1u) {
        words[row * width + id.x] += above;
    }
}

/// Sum over the columns left of `x` and the rows above `y`.
fn corner(x: u32, y: u32) -> u32 {
    var sum = 0u;
    if (x > 0u && y > 0u) {
        sum = whole[(y - 1u) * 4u * params.fours + x - 1u];
    }
    return sum;
}

@compute @workgroup_size(256)
fn rectangle_sums(@builtin(global_invocation_id) id: vec3<u32>) {
    let rectangle = params.first + id.x;
    if (rectangle >= params.rectangles) {
        return;
    }
    let size = vec2<u32>(4u * params.fours, params.height);
    let low = min(rectangles[rectangle].xy, size);
    let high = max(min(rectangles[rectangle].zw, size), low);
    sums[rectangle] = corner(high.x, high.y) - corner(low.x, high.y) - corner(high.x, low.y) + corner(low.x, low.y);
}

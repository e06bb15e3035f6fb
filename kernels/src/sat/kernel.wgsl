// Summed-area tables of one to eight channels, modulo 2^32 or in 64 bits, and sums over rectangles from them.
//
// Crow, "Summed-Area Tables for Texture Mapping" (SIGGRAPH 1984); Hensley et al., "Fast Summed-Area Table Generation
// and its Applications" (Computer Graphics Forum 24(3), 2005); used to count the pixels of objects drawn in pure colours by
// Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), section 3.1.
//
// For an image of `4 * fours` columns (at most 4096) and `height` rows, stored by rows, one channel after another,
//
//     table(x, y) = sum of image(i, j) over i <= x, j <= y, modulo 2^32,
//
// which is exact while width * height * largest value < 2^32: values up to 255 at 4096², to 4095 at 1024². Past that
// the table wraps, and a rectangle is still answered exactly if its own sum is below 2^32. The wide entry points hold
// sums of any values whole: `table` has the low words and `high_table`, of the same shape, the high ones.
//
// `bands` scans the rows and sums the columns of each band of 16 rows; `carries` sums what stands above each band, and
// `add` adds it. Rectangles are half-open: `x0 <= x < x1`, `y0 <= y < y1`, cut to the image, and 0 when empty; each is
// answered for every channel, the sums one channel after another.

import package::shared::block_scan::{block_scan, prefix4};
import package::shared::wide::{add64, sub64};

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
/// Row b of a channel: the row of the table just above band b + 1.
@group(0) @binding(4) var<storage, read_write> carry: array<u32>;
/// The table by words, once it is whole.
@group(0) @binding(5) var<storage, read> whole: array<u32>;
/// x0, y0, x1, y1.
@group(0) @binding(6) var<storage, read> rectangles: array<vec4<u32>>;
@group(0) @binding(7) var<storage, read_write> sums: array<u32>;
/// High words of all of them.
@group(0) @binding(8) var<storage, read_write> high_table: array<vec4<u32>>;
@group(0) @binding(9) var<storage, read_write> high_words: array<u32>;
@group(0) @binding(10) var<storage, read_write> high_carry: array<u32>;
@group(0) @binding(11) var<storage, read> high_whole: array<u32>;
@group(0) @binding(12) var<storage, read_write> wide_sums: array<vec2<u32>>;

/// First four of a row of a channel.
fn row_start(channel: u32, row: u32) -> u32 {
    return (channel * params.height + row) * params.fours;
}

fn fetch(start: u32, column: u32) -> vec4<u32> {
    var four = vec4<u32>(0u);
    if (column < params.fours) {
        four = image[start + column];
    }
    return four;
}

fn emit(start: u32, column: u32, four: vec4<u32>) {
    if (column < params.fours) {
        table[start + column] = four;
    }
}

/// The table of each band by itself; a row of workgroups takes a channel.
@compute @workgroup_size(256)
fn bands(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let top = (params.first + group.x) * BAND;
    let end = min(top + BAND, params.height);
    var sum_a = vec4<u32>(0u);
    var sum_b = vec4<u32>(0u);
    var sum_c = vec4<u32>(0u);
    var sum_d = vec4<u32>(0u);
    for (var row = top; row < end; row += 1u) {
        let start = row_start(group.y, row);
        let a = prefix4(fetch(start, lane));
        let b = prefix4(fetch(start, lane + 256u));
        let c = prefix4(fetch(start, lane + 512u));
        let d = prefix4(fetch(start, lane + 768u));
        let before = block_scan(lane, vec4<u32>(a.w, b.w, c.w, d.w));
        sum_a += before.x + a;
        sum_b += before.y + b;
        sum_c += before.z + c;
        sum_d += before.w + d;
        emit(start, lane, sum_a);
        emit(start, lane + 256u, sum_b);
        emit(start, lane + 512u, sum_c);
        emit(start, lane + 768u, sum_d);
    }
}

/// First carry of a channel.
fn carry_start(channel: u32) -> u32 {
    return channel * ((params.height - 1u) / BAND) * 4u * params.fours;
}

/// Sums over all bands above, by column: neighbouring lanes are neighbouring columns.
@compute @workgroup_size(64)
fn carries(@builtin(global_invocation_id) id: vec3<u32>) {
    let width = 4u * params.fours;
    if (id.x >= width) {
        return;
    }
    let start = 4u * row_start(id.y, 0u);
    var sum = 0u;
    for (var band = 0u; (band + 1u) * BAND < params.height; band += 1u) {
        sum += words[start + ((band + 1u) * BAND - 1u) * width + id.x];
        carry[carry_start(id.y) + band * width + id.x] = sum;
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
    let above = carry[carry_start(group.z) + band * width + id.x];
    let start = 4u * row_start(group.z, 0u);
    let top = (band + 1u) * BAND;
    let end = min(top + BAND, params.height);
    for (var row = top; row < end; row += 1u) {
        words[start + row * width + id.x] += above;
    }
}

/// A rectangle cut to the image; empty where x0 >= x1 or y0 >= y1.
fn cut_rectangle(rectangle: u32) -> vec4<u32> {
    let size = vec2<u32>(4u * params.fours, params.height);
    let low = min(rectangles[rectangle].xy, size);
    return vec4<u32>(low, max(min(rectangles[rectangle].zw, size), low));
}

/// Sum over the columns left of `x` and the rows above `y` of a channel.
fn corner(channel: u32, x: u32, y: u32) -> u32 {
    var sum = 0u;
    if (x > 0u && y > 0u) {
        sum = whole[4u * row_start(channel, y - 1u) + x - 1u];
    }
    return sum;
}

/// A row of workgroups takes a channel.
@compute @workgroup_size(256)
fn rectangle_sums(@builtin(global_invocation_id) id: vec3<u32>) {
    let rectangle = params.first + id.x;
    if (rectangle >= params.rectangles) {
        return;
    }
    let r = cut_rectangle(rectangle);
    let sum = corner(id.y, r.z, r.w) - corner(id.y, r.x, r.w) - corner(id.y, r.z, r.y) + corner(id.y, r.x, r.y);
    sums[id.y * params.rectangles + rectangle] = sum;
}

/// Four numbers of 64 bits.
struct Wide {
    low: vec4<u32>,
    high: vec4<u32>,
}

fn add_wide(a: Wide, b: Wide) -> Wide {
    let low = a.low + b.low;
    return Wide(low, a.high + b.high + select(vec4<u32>(0u), vec4<u32>(1u), low < b.low));
}

/// Sums of four words from the sums of their lower and upper halves: rows have at most 4096 words, so both are below 2^28.
fn from_halves(lower: vec4<u32>, upper: vec4<u32>) -> Wide {
    return add_wide(Wide(lower, vec4<u32>(0u)), Wide(upper << vec4<u32>(16u), upper >> vec4<u32>(16u)));
}

fn emit_wide(start: u32, column: u32, four: Wide) {
    if (column < params.fours) {
        table[start + column] = four.low;
        high_table[start + column] = four.high;
    }
}

@compute @workgroup_size(256)
fn bands_wide(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let top = (params.first + group.x) * BAND;
    let end = min(top + BAND, params.height);
    let half = vec4<u32>(16u);
    let zero = Wide(vec4<u32>(0u), vec4<u32>(0u));
    var sum_a = zero;
    var sum_b = zero;
    var sum_c = zero;
    var sum_d = zero;
    for (var row = top; row < end; row += 1u) {
        let start = row_start(group.y, row);
        let image_a = fetch(start, lane);
        let image_b = fetch(start, lane + 256u);
        let image_c = fetch(start, lane + 512u);
        let image_d = fetch(start, lane + 768u);
        let a = prefix4(image_a & vec4<u32>(0xffffu));
        let b = prefix4(image_b & vec4<u32>(0xffffu));
        let c = prefix4(image_c & vec4<u32>(0xffffu));
        let d = prefix4(image_d & vec4<u32>(0xffffu));
        let e = prefix4(image_a >> half);
        let f = prefix4(image_b >> half);
        let g = prefix4(image_c >> half);
        let h = prefix4(image_d >> half);
        let lower = block_scan(lane, vec4<u32>(a.w, b.w, c.w, d.w));
        let upper = block_scan(lane, vec4<u32>(e.w, f.w, g.w, h.w));
        sum_a = add_wide(sum_a, from_halves(lower.x + a, upper.x + e));
        sum_b = add_wide(sum_b, from_halves(lower.y + b, upper.y + f));
        sum_c = add_wide(sum_c, from_halves(lower.z + c, upper.z + g));
        sum_d = add_wide(sum_d, from_halves(lower.w + d, upper.w + h));
        emit_wide(start, lane, sum_a);
        emit_wide(start, lane + 256u, sum_b);
        emit_wide(start, lane + 512u, sum_c);
        emit_wide(start, lane + 768u, sum_d);
    }
}

@compute @workgroup_size(64)
fn carries_wide(@builtin(global_invocation_id) id: vec3<u32>) {
    let width = 4u * params.fours;
    if (id.x >= width) {
        return;
    }
    let start = 4u * row_start(id.y, 0u);
    var sum = vec2<u32>(0u);
    for (var band = 0u; (band + 1u) * BAND < params.height; band += 1u) {
        let place = start + ((band + 1u) * BAND - 1u) * width + id.x;
        sum = add64(sum, vec2<u32>(words[place], high_words[place]));
        carry[carry_start(id.y) + band * width + id.x] = sum.x;
        high_carry[carry_start(id.y) + band * width + id.x] = sum.y;
    }
}

@compute @workgroup_size(256)
fn add_bands_wide(@builtin(workgroup_id) group: vec3<u32>, @builtin(global_invocation_id) id: vec3<u32>) {
    let width = 4u * params.fours;
    if (id.x >= width) {
        return;
    }
    let band = params.first + group.y;
    let column = carry_start(group.z) + band * width + id.x;
    let above = vec2<u32>(carry[column], high_carry[column]);
    let start = 4u * row_start(group.z, 0u);
    let top = (band + 1u) * BAND;
    let end = min(top + BAND, params.height);
    for (var row = top; row < end; row += 1u) {
        let place = start + row * width + id.x;
        let sum = add64(above, vec2<u32>(words[place], high_words[place]));
        words[place] = sum.x;
        high_words[place] = sum.y;
    }
}

fn corner_wide(channel: u32, x: u32, y: u32) -> vec2<u32> {
    var sum = vec2<u32>(0u);
    if (x > 0u && y > 0u) {
        let place = 4u * row_start(channel, y - 1u) + x - 1u;
        sum = vec2<u32>(whole[place], high_whole[place]);
    }
    return sum;
}

@compute @workgroup_size(256)
fn rectangle_sums_wide(@builtin(global_invocation_id) id: vec3<u32>) {
    let rectangle = params.first + id.x;
    if (rectangle >= params.rectangles) {
        return;
    }
    let r = cut_rectangle(rectangle);
    let outer = add64(corner_wide(id.y, r.z, r.w), corner_wide(id.y, r.x, r.y));
    let inner = add64(corner_wide(id.y, r.x, r.w), corner_wide(id.y, r.z, r.y));
    wide_sums[id.y * params.rectangles + rectangle] = sub64(outer, inner);
}

// Summed-area tables of one to eight channels, modulo 2^32 or in 64 bits, and sums over rectangles from them.
//
// Crow, "Summed-Area Tables for Texture Mapping" (SIGGRAPH 1984); Hensley et al., "Fast Summed-Area Table Generation
// and its Applications" (Computer Graphics Forum 24(3), 2005); used to count the pixels of objects drawn in pure
// colours by Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), section 3.1.
//
// For an image of `4 * fours` columns (at most 4096) and `height` rows, stored by rows, one channel after another,
//
//     table(x, y) = sum of image(i, j) over i <= x, j <= y, modulo 2^32,
//
// which is exact while width * height * largest value < 2^32: values up to 255 at 4096², to 4095 at 1024². Past that
// the table wraps, and a rectangle is still answered exactly if its own sum is below 2^32. The wide entry points hold
// sums of any values whole: `table` has the low words and `high_table`, of the same shape, the high ones.
//
// `bands` makes the table of each band of 16 rows by itself, 4 rows by 1024 columns at a time; `carries` sums what
// stands above each band, and `add` adds it. Rectangles are half-open: `x0 <= x < x1`, `y0 <= y < y1`, cut to the
// image, and 0 when empty; each is answered for every channel, the sums one channel after another.

import package::shared::block_scan::{prefix4, row_scans};
import package::shared::wide::{add64, sub64};

/// Rows that one workgroup sums, a multiple of the four that it scans at once.
const BAND: u32 = 16u;
/// Fours of a block of columns: one a lane.
const BLOCK: u32 = 256u;

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

/// The rows of a band, in one channel.
struct Rows {
    channel: u32,
    top: u32,
    end: u32,
}

/// Four pixels; others of the image beside it and below the band: sums there are neither written nor used.
fn fetch(rows: Rows, row: u32, column: u32) -> vec4<u32> {
    return image[row_start(rows.channel, min(row, rows.end - 1u)) + min(column, params.fours - 1u)];
}

fn emit(rows: Rows, row: u32, column: u32, four: vec4<u32>) {
    if (row < rows.end) {
        if (column < params.fours) {
            table[row_start(rows.channel, row) + column] = four;
        }
    }
}

/// What the table of a band has in the column left of a block; zero above the band.
fn edge(rows: Rows, row: u32, block: u32) -> u32 {
    var sum = 0u;
    if (rows.top <= row && row < rows.end) {
        sum = table[row_start(rows.channel, row) + block - 1u].w;
    }
    return sum;
}

/// Sums of four rows of a band left of a block.
fn left_sums(rows: Rows, row: u32, block: u32) -> vec4<u32> {
    var sums = vec4<u32>(0u);
    if (block > 0u) {
        let a = edge(rows, row, block);
        let b = edge(rows, row + 1u, block);
        let c = edge(rows, row + 2u, block);
        sums = vec4<u32>(a, b, c, edge(rows, row + 3u, block)) - vec4<u32>(edge(rows, row - 1u, block), a, b, c);
    }
    return sums;
}

/// The table of each band by itself; a row of workgroups takes a channel.
@compute @workgroup_size(256)
fn bands(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let top = (params.first + group.x) * BAND;
    let rows = Rows(group.y, top, min(top + BAND, params.height));
    for (var block = 0u; block < params.fours; block += BLOCK) {
        let column = block + lane;
        var sum = vec4<u32>(0u);
        for (var row = top; row < rows.end; row += 4u) {
            let a = prefix4(fetch(rows, row, column));
            let b = prefix4(fetch(rows, row + 1u, column));
            let c = prefix4(fetch(rows, row + 2u, column));
            let d = prefix4(fetch(rows, row + 3u, column));
            let before = row_scans(lane, vec4<u32>(a.w, b.w, c.w, d.w), left_sums(rows, row, block));
            sum += before.x + a;
            emit(rows, row, column, sum);
            sum += before.y + b;
            emit(rows, row + 1u, column, sum);
            sum += before.z + c;
            emit(rows, row + 2u, column, sum);
            sum += before.w + d;
            emit(rows, row + 3u, column, sum);
        }
        storageBarrier();
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

/// Sums of words from the sums of their lower and upper halves: a block has 1024 columns, so both are below 2^26.
fn from_halves(lower: vec4<u32>, upper: vec4<u32>) -> Wide {
    return add_wide(Wide(lower, vec4<u32>(0u)), Wide(upper << vec4<u32>(16u), upper >> vec4<u32>(16u)));
}

fn emit_wide(rows: Rows, row: u32, column: u32, four: Wide) {
    if (row < rows.end) {
        if (column < params.fours) {
            let place = row_start(rows.channel, row) + column;
            table[place] = four.low;
            high_table[place] = four.high;
        }
    }
}

/// What the table of a band has in the column left of a block, four times.
fn edge_wide(rows: Rows, row: u32, block: u32) -> Wide {
    var sum = Wide(vec4<u32>(0u), vec4<u32>(0u));
    if (row < rows.end && block > 0u) {
        let place = row_start(rows.channel, row) + block - 1u;
        sum = Wide(vec4<u32>(table[place].w), vec4<u32>(high_table[place].w));
    }
    return sum;
}

@compute @workgroup_size(256)
fn bands_wide(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let top = (params.first + group.x) * BAND;
    let rows = Rows(group.y, top, min(top + BAND, params.height));
    let half = vec4<u32>(16u);
    let none = vec4<u32>(0u);
    for (var block = 0u; block < params.fours; block += BLOCK) {
        let column = block + lane;
        var sum = Wide(none, none);
        for (var row = top; row < rows.end; row += 4u) {
            let image_a = fetch(rows, row, column);
            let image_b = fetch(rows, row + 1u, column);
            let image_c = fetch(rows, row + 2u, column);
            let image_d = fetch(rows, row + 3u, column);
            let a = prefix4(image_a & vec4<u32>(0xffffu));
            let b = prefix4(image_b & vec4<u32>(0xffffu));
            let c = prefix4(image_c & vec4<u32>(0xffffu));
            let d = prefix4(image_d & vec4<u32>(0xffffu));
            let e = prefix4(image_a >> half);
            let f = prefix4(image_b >> half);
            let g = prefix4(image_c >> half);
            let h = prefix4(image_d >> half);
            let lower = row_scans(lane, vec4<u32>(a.w, b.w, c.w, d.w), none);
            let upper = row_scans(lane, vec4<u32>(e.w, f.w, g.w, h.w), none);
            sum = add_wide(sum, from_halves(lower.x + a, upper.x + e));
            emit_wide(rows, row, column, add_wide(sum, edge_wide(rows, row, block)));
            sum = add_wide(sum, from_halves(lower.y + b, upper.y + f));
            emit_wide(rows, row + 1u, column, add_wide(sum, edge_wide(rows, row + 1u, block)));
            sum = add_wide(sum, from_halves(lower.z + c, upper.z + g));
            emit_wide(rows, row + 2u, column, add_wide(sum, edge_wide(rows, row + 2u, block)));
            sum = add_wide(sum, from_halves(lower.w + d, upper.w + h));
            emit_wide(rows, row + 3u, column, add_wide(sum, edge_wide(rows, row + 3u, block)));
        }
        storageBarrier();
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

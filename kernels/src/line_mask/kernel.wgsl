// Line masks: the samples of any pattern that triangles hide from receivers anywhere, by a table of lines.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 5 and 6: each edge of the
// backprojection is looked up in a table that holds, for lines near one another, the samples on their inner side; the
// AND of three masks is what the triangle hides, the OR over triangles is the hidden-samples map. Output: bit s % bits
// of `hidden[(s / bits) * receivers + r]` is set if any triangle of r's tile list hides sample s from receiver r; other
// bits are left as they are.
//
// EXACT: the table (`build.wgsl`) knows of each cell which samples are certainly and which are possibly inside. Samples
// that are possibly inside all half-planes and not certainly are decided by the signs of the lines themselves. So the
// masks are those of the definition in `grid.rs`, bit for bit, whatever the table's size, and whichever of the cells
// within its slack `line_cell_fast` returns. Otherwise the table is the paper's: one mask for each angle and distance,
// taken as it is, and wrong for the samples between the line and the centre of its texel. Past its last cell a table
// has one without samples; inverted it is the cell of a half-plane that covers the square.
//
// Nothing is assumed of a triangle. The edges' half-planes are a cone of one side, so what is above the receiver is no
// special case; one that reaches down to the source has its own plane as a fourth line, for the samples that lie on it.
//
// One workgroup serves WIDTH * HEIGHT receivers and takes BATCH triangles at a time: first an invocation a pair of
// triangle and receiver finds its lines and cells, then the pairs that hide anything are listed in their order, and an
// invocation a listed pair and word of its mask looks up. Coordinates are relative to the centre of the pattern, as it
// is shifted for the receiver: differences are below 2^15, x and y below 2^15 in magnitude, |c| < 2^48.

import package::line_mask::hough::texel;
import package::shared::backprojection::backproject;
import package::shared::crossing::edge_function;
import package::shared::line::{Line, line_flip};
import package::shared::line_cell::{CELL_ALL, CELL_NONE, line_cell_fast};
import package::shared::view::below;
import package::shared::wide::{dot64, sgn64};

/// Whether the table is one of certain and possible samples.
const EXACT: bool = true;
/// Whether triangles hide by their fronts alone.
const ONE_SIDED: bool = false;
/// Receivers of a workgroup along x and y, and all of them.
const WIDTH: u32 = 4u;
const HEIGHT: u32 = 4u;
const COUNT = WIDTH * HEIGHT;
/// Triangles at a time.
const BATCH = 128u / COUNT;
/// Entries of a list that a launch takes.
const LIST: u32 = 256u;

struct Params {
    /// Receiver row of the first workgroup row.
    first_row: u32,
    /// Receiver rows that share a tile list.
    tile_rows: u32,
    /// Tiles along x, WIDTH receivers each.
    tiles: u32,
    /// The centre of the pattern; the samples lie in the square of half side 2^h about it.
    centre_x: i32,
    centre_y: i32,
    h: u32,
    /// log2 of the table's directions, or angles.
    k: u32,
    samples: u32,
    /// Samples of a word.
    bits: u32,
    /// Words of a mask, at most 32.
    words: u32,
    /// Where the words of the cell without samples begin.
    empty: u32,
    /// Entries of each list that earlier launches have taken.
    skip: u32,
    /// Receivers along x and y.
    columns: u32,
    rows: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
/// Nine coordinates a triangle.
@group(0) @binding(1) var<storage, read> vertices: array<i32>;
/// Tile t has the list entries `starts[t]` up to `starts[t + 1]`.
@group(0) @binding(2) var<storage, read> starts: array<u32>;
@group(0) @binding(3) var<storage, read> entries: array<u32>;
/// Relative to the centre.
@group(0) @binding(4) var<storage, read> samples: array<vec2<i32>>;
@group(0) @binding(5) var<storage, read> table: array<u32>;
@group(0) @binding(6) var<storage, read_write> hidden: array<atomic<u32>>;
/// Where each receiver stands, and how far the pattern is shifted for it: x in the low half of w, y in the high one. A
/// receiver with z = 0 is none.
@group(0) @binding(7) var<storage, read> receivers: array<vec4<i32>>;

/// The edges' lines, and where the table knows of them and of the triangle's own plane: the cell's first word, and bit
/// 31 where it is to be inverted. A line that covers the square is 0 u + 0 v + 0 >= 0.
struct Pair {
    first: Line,
    second: Line,
    third: Line,
    rows: vec4<u32>,
}

var<workgroup> pairs: array<Pair, 128>;
/// A bit for each pair of which no cell is `CELL_NONE`.
var<workgroup> alive: array<atomic<u32>, 4>;
/// Those pairs in ascending order.
var<workgroup> order: array<u32, 128>;
/// What the workgroup has found: word w of receiver i at i << shift | w.
var<workgroup> masks: array<atomic<u32>, 512>;

/// log2 of the words, rounded up.
fn shift() -> u32 {
    return 32u - countLeadingZeros(params.words - 1u);
}

/// A receiver about the centre of its pattern, which is on the grid.
struct Receiver {
    at: vec3<i32>,
    centre: vec3<i32>,
}

/// A vertex about a centre.
fn vertex(triangle: u32, corner: u32, centre: vec3<i32>) -> vec3<i32> {
    let at = 9u * triangle + 3u * corner;
    return vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]) - centre;
}

/// Masks of a cell.
const SETS = select(1u, 2u, EXACT);

fn cell_of(ln: Line) -> u32 {
    if (EXACT) {
        return line_cell_fast(ln, params.h, params.k);
    }
    return texel(ln, params.h, params.k);
}

/// Where the words of a cell begin.
fn row_of(cell: u32) -> u32 {
    let row = (cell & 0x7fffffffu) * (SETS * params.words);
    return select(row | (cell & 0x80000000u), params.empty | 0x80000000u, cell == CELL_ALL);
}

fn relevant(ln: Line, cell: u32) -> Line {
    let covers = cell == CELL_ALL;
    return Line(select(ln.a, 0, covers), select(ln.b, 0, covers), select(ln.c, vec2<u32>(0u), covers));
}

/// Whether r is where the front of a triangle may hide something: behind its plane.
fn is_behind(r: vec3<i32>, a: vec3<i32>, b: vec3<i32>, c: vec3<i32>) -> bool {
    return sgn64(dot64(edge_function(a, b, c), a - r)) > 0;
}

/// Finds lines and cells of a pair; whether it may hide anything.
fn prepare(pair: u32, triangle: u32, r: Receiver) -> bool {
    let a = vertex(triangle, 0u, r.centre);
    let b = vertex(triangle, 1u, r.centre);
    let c = vertex(triangle, 2u, r.centre);
    if (ONE_SIDED) {
        if (!is_behind(r.at, a, b, c)) {
            return false;
        }
    }
    let found = backproject(r.at, a, b, c);
    let x = cell_of(found.first);
    let y = cell_of(found.second);
    let z = cell_of(found.third);
    var own = CELL_ALL;
    if (min(min(a.z, b.z), c.z) <= 0) {
        // Samples on the plane are outside, so a plane that is the source's holds none.
        let nowhere = (found.own.a == 0) & (found.own.b == 0) & ((found.own.c.x | found.own.c.y) == 0u);
        own = select(cell_of(found.own), CELL_NONE, nowhere);
    }
    let rows = vec4<u32>(row_of(x), row_of(y), row_of(z), row_of(own));
    pairs[pair] = Pair(relevant(found.first, x), relevant(found.second, y), relevant(found.third, z), rows);
    return (x != CELL_NONE) & (y != CELL_NONE) & (z != CELL_NONE) & (own != CELL_NONE);
}

/// The samples of a word that are certainly, and those that are possibly, in a half-plane.
fn known(row: u32, word: u32) -> vec2<u32> {
    let inverted = 0u - (row >> 31u);
    let at = (row & 0x7fffffffu) + word;
    if (EXACT) {
        let turn = inverted & params.words;
        return vec2<u32>(table[at + turn], table[at + params.words - turn]) ^ vec2<u32>(inverted);
    }
    return vec2<u32>(table[at] ^ inverted);
}

/// `half_plane` for a line that is in the table, and so passes the square or covers it.
///
/// The value is that of 16 low bits and 32 high ones, T = floor(value / 2^16). With |u|, |v| <= 2^14, low parts of a
/// and b below 2^16, |c| <= (1 + 2^-16) 2^14 (|a| + |b|) and |a| + |b| <= 2^32 - 2^17 (a component of a normal is a
/// difference of two products below 2^30), the sum of the low products is below 2^31 and |value| below 2^47: both are
/// exact in 32 bits.
fn inside(ln: Line, u: i32, v: i32) -> bool {
    let low = (ln.a & 0xffff) * u + (ln.b & 0xffff) * v;
    let rest = (low & 0xffff) + bitcast<i32>(ln.c.x & 0xffffu);
    let c = bitcast<i32>((ln.c.y << 16u) | (ln.c.x >> 16u));
    let high = (ln.a >> 16u) * u + (ln.b >> 16u) * v + c + (low >> 16u) + (rest >> 16u);
    return select(high >= 0, !line_flip(ln), (high | (rest & 0xffff)) == 0);
}

/// Whether a sample is strictly on the other side of a triangle's plane than r.
fn beyond(triangle: u32, r: Receiver, at: vec2<i32>) -> bool {
    let a = vertex(triangle, 0u, r.centre);
    let n = edge_function(a, vertex(triangle, 1u, r.centre), vertex(triangle, 2u, r.centre));
    return sgn64(dot64(n, r.at - a)) * sgn64(dot64(n, vec3<i32>(at, 0) - a)) < 0;
}

/// The samples of a word that the triangle of a pair, in the list from `start` on, hides from its receiver.
fn mask_of(group: vec2<u32>, pair: u32, start: u32, word: u32) -> u32 {
    let rows = pairs[pair].rows;
    let touches = rows.w != (params.empty | 0x80000000u);
    let there = below(min(params.bits, params.samples - word * params.bits));
    var sets = known(rows.x, word) & known(rows.y, word) & known(rows.z, word) & vec2<u32>(there);
    if (touches) {
        sets &= known(rows.w, word);
    }
    var mask = sets.x;
    if (EXACT) {
        var doubtful = sets.y & ~sets.x;
        while (doubtful != 0u) {
            let bit = firstTrailingBit(doubtful);
            doubtful &= doubtful - 1u;
            let at = samples[word * params.bits + bit];
            var hides = inside(pairs[pair].first, at.x, at.y) & inside(pairs[pair].second, at.x, at.y)
                & inside(pairs[pair].third, at.x, at.y);
            if (touches & hides) {
                hides = beyond(entries[start + pair / COUNT], receiver(group, pair % COUNT), at);
            }
            mask |= select(0u, 1u << bit, hides);
        }
    }
    return mask;
}

/// Column and row of a receiver of the workgroup.
fn place(group: vec2<u32>, i: u32) -> vec2<u32> {
    return vec2<u32>(group.x * WIDTH, params.first_row + group.y * HEIGHT) + vec2<u32>(i % WIDTH, i / WIDTH);
}

fn is_there(at: vec2<u32>) -> bool {
    return (at.x < params.columns) & (at.y < params.rows);
}

fn receiver(group: vec2<u32>, i: u32) -> Receiver {
    let at = place(group, i);
    let found = receivers[at.y * params.columns + at.x];
    let centre = vec3<i32>(params.centre_x + ((found.w << 16u) >> 16u), params.centre_y + (found.w >> 16u), 0);
    return Receiver(found.xyz - centre, centre);
}

/// The pairs that are alive, with number below `lane`: all of them for 128.
fn alive_below(lane: u32) -> u32 {
    var count = 0u;
    for (var word = 0u; word < 4u; word += 1u) {
        let bits = clamp(lane, 32u * word, 32u * word + 32u) - 32u * word;
        count += countOneBits(atomicLoad(&alive[word]) & below(bits));
    }
    return count;
}

@compute @workgroup_size(128)
fn line_mask(@builtin(workgroup_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let group = id.xy;
    let tile = (place(group, 0u).y / params.tile_rows) * params.tiles + group.x;
    let first = starts[tile] + params.skip;
    let end = min(starts[tile + 1u], first + LIST);
    for (var start = first; start < end; start += BATCH) {
        workgroupBarrier();
        if (lane < 4u) {
            atomicStore(&alive[lane], 0u);
        }
        workgroupBarrier();
        let slot = lane / COUNT;
        if ((slot < end - start) & is_there(place(group, lane % COUNT))) {
            let r = receiver(group, lane % COUNT);
            if (r.at.z > 0 && prepare(lane, entries[start + slot], r)) {
                atomicOr(&alive[lane / 32u], 1u << (lane % 32u));
            }
        }
        workgroupBarrier();
        if ((atomicLoad(&alive[lane / 32u]) & (1u << (lane % 32u))) != 0u) {
            order[alive_below(lane)] = lane;
        }
        workgroupBarrier();
        let items = alive_below(128u) << shift();
        for (var item = lane; item < items; item += 128u) {
            let pair = order[item >> shift()];
            let word = item & ((1u << shift()) - 1u);
            if (word < params.words) {
                let mask = mask_of(group, pair, start, word);
                if (mask != 0u) {
                    atomicOr(&masks[((pair % COUNT) << shift()) | word], mask);
                }
            }
        }
    }
    workgroupBarrier();
    for (var item = lane; item < (COUNT << shift()); item += 128u) {
        let at = place(group, item >> shift());
        let word = item & ((1u << shift()) - 1u);
        let mask = atomicLoad(&masks[item]);
        if (is_there(at) & (mask != 0u)) {
            atomicOr(&hidden[(word * params.rows + at.y) * params.columns + at.x], mask);
        }
    }
}

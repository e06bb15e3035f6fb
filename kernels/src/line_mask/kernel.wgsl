// Line masks: the samples of any pattern that triangles hide from receivers on a parallel plane, by a table of lines.
//
// Eisemann and Décoret, "Visibility Sampling on GPU and Applications", sections 5 and 6: each edge of the backprojection is
// looked up in a table that holds, for lines near one another, the samples on their inner side; the AND of three masks is
// what the triangle hides, the OR over triangles is the hidden-samples map. Output: bit s % bits of
// `hidden[(s / bits) * receivers + r]` is set if any triangle of r's tile list hides sample s from receiver r; other bits
// are left as they are.
//
// EXACT: the table (`build.wgsl`) knows of each cell which samples are certainly and which are possibly inside. Samples that
// are possibly inside all half-planes and not certainly are decided by the signs of the lines themselves. So the masks
// are those of the definition in `grid.rs`, bit for bit, whatever the table's size, and whichever of the cells within its
// slack `line_cell_fast` returns. Otherwise the table is the paper's: one mask for each angle and distance, taken as it is,
// and wrong for the samples between the line and the centre of its texel.
//
// Nothing is assumed of a triangle. One that reaches the source or the receivers' plane has its own plane as a fourth line.
//
// One workgroup serves width * height receivers. For some triangles at a time, first one invocation a pair of triangle and
// receiver finds its lines and cells, then one a receiver and word of its mask looks up. Coordinates are relative to the
// centre of the pattern: differences are below 2^15, x and y below 2^15 in magnitude, |c| < 2^48.

import package::line_mask::hough::texel;
import package::shared::backprojection::backproject;
import package::shared::crossing::edge_function;
import package::shared::line::{Line, half_plane};
import package::shared::line_cell::{CELL_ALL, CELL_NONE, line_cell_fast};
import package::shared::view::{View, receiver_at, below};
import package::shared::wide::{dot64, sgn64};

/// Whether the table is one of certain and possible samples.
const EXACT: bool = true;

struct Params {
    /// Receiver row of the first workgroup row.
    first_row: u32,
    /// Receiver rows that share a tile list.
    tile_rows: u32,
    /// Tiles along x.
    tiles: u32,
    /// Receivers of a workgroup along x and y.
    width: u32,
    height: u32,
    /// Triangles at a time: batch * width * height <= 256.
    batch: u32,
    /// The centre of the pattern; the samples lie inside the square of half side 2^h about it.
    centre_x: i32,
    centre_y: i32,
    h: u32,
    /// log2 of the table's directions, or angles.
    k: u32,
    samples: u32,
    /// Samples of a word, and words of a mask: words * width * height <= 256.
    bits: u32,
    words: u32,
    _pad0: u32,
    _pad1: u32,
    _pad2: u32,
    view: View,
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

/// The edges' lines and cells; the fourth cell is that of the triangle's own plane. The first is `CELL_NONE` if any is.
struct Pair {
    first: Line,
    second: Line,
    third: Line,
    cells: vec4<u32>,
}

var<workgroup> pairs: array<Pair, 256>;

fn centred(p: vec3<i32>) -> vec3<i32> {
    return p - vec3<i32>(params.centre_x, params.centre_y, 0);
}

fn vertex(triangle: u32, corner: u32) -> vec3<i32> {
    let at = 9u * triangle + 3u * corner;
    return centred(vec3<i32>(vertices[at], vertices[at + 1u], vertices[at + 2u]));
}

fn cell_of(ln: Line) -> u32 {
    if (EXACT) {
        return line_cell_fast(ln, params.h, params.k);
    }
    return texel(ln, params.h, params.k);
}

/// The cell of the triangle's own plane: samples on it are outside, so a plane that is the source's holds none.
fn own_cell(own: Line) -> u32 {
    let nowhere = (own.a == 0) & (own.b == 0) & ((own.c.x | own.c.y) == 0u);
    return select(cell_of(own), CELL_NONE, nowhere);
}

fn prepare(pair: u32, triangle: u32, r: vec3<i32>) {
    let a = vertex(triangle, 0u);
    let b = vertex(triangle, 1u);
    let c = vertex(triangle, 2u);
    let found = backproject(r, a, b, c);
    var cells = vec4<u32>(cell_of(found.first), cell_of(found.second), cell_of(found.third), CELL_ALL);
    if ((min(min(a.z, b.z), c.z) <= 0) | (max(max(a.z, b.z), c.z) >= r.z)) {
        cells.w = own_cell(found.own);
    }
    if (any(cells == vec4<u32>(CELL_NONE))) {
        cells.x = CELL_NONE;
    }
    pairs[pair] = Pair(found.first, found.second, found.third, cells);
}

/// The samples of a word that are certainly, and those that are possibly, in a half-plane.
fn known(cell: u32, word: u32) -> vec2<u32> {
    if (cell >= CELL_NONE) {
        return vec2<u32>(0u - (cell & 1u));
    }
    if (EXACT) {
        let at = 2u * params.words * (cell & 0x7fffffffu) + word;
        let sets = vec2<u32>(table[at], table[at + params.words]);
        return select(sets, ~sets.yx, (cell >> 31u) != 0u);
    }
    return vec2<u32>(table[params.words * cell + word]);
}

/// Whether a triangle hides a sample from r, decided by signs.
fn decide(pair: u32, triangle: u32, r: vec3<i32>, sample: u32) -> bool {
    let at = samples[sample];
    let inner = half_plane(pairs[pair].first, at.x, at.y) & half_plane(pairs[pair].second, at.x, at.y)
        & half_plane(pairs[pair].third, at.x, at.y);
    if (pairs[pair].cells.w == CELL_ALL) {
        return inner;
    }
    let a = vertex(triangle, 0u);
    let n = edge_function(a, vertex(triangle, 1u), vertex(triangle, 2u));
    let sides = sgn64(dot64(n, r - a)) * sgn64(dot64(n, vec3<i32>(at, 0) - a));
    return inner & (sides < 0);
}

/// The samples of a word that a triangle hides from r, without those of `found` that need a decision.
fn mask_of(pair: u32, triangle: u32, r: vec3<i32>, word: u32, found: u32) -> u32 {
    let cells = pairs[pair].cells;
    if (cells.x == CELL_NONE) {
        return 0u;
    }
    let sets = known(cells.x, word) & known(cells.y, word) & known(cells.z, word) & known(cells.w, word);
    var mask = sets.x;
    if (EXACT) {
        var doubtful = sets.y & ~sets.x & ~found & below(min(params.bits, params.samples - word * params.bits));
        while (doubtful != 0u) {
            let bit = firstTrailingBit(doubtful);
            doubtful &= doubtful - 1u;
            mask |= select(0u, 1u << bit, decide(pair, triangle, r, word * params.bits + bit));
        }
    }
    return mask;
}

@compute @workgroup_size(256)
fn line_mask(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let corner = vec2<u32>(group.x * params.width, params.first_row + group.y * params.height);
    let tile = (corner.y / params.tile_rows) * params.tiles + group.x;
    let receivers = params.width * params.height;
    let word = lane % params.words;
    let mine = lane / params.words;
    let place = corner + vec2<u32>(mine % params.width, mine / params.width);
    let theirs = lane % receivers;
    let other = corner + vec2<u32>(theirs % params.width, theirs / params.width);
    let r = centred(receiver_at(params.view, place.x, place.y));
    let s = centred(receiver_at(params.view, other.x, other.y));
    let is_there = (mine < receivers) & (place.x < params.view.columns) & (place.y < params.view.rows);
    let end = starts[tile + 1u];
    var mask = 0u;
    for (var start = starts[tile]; start < end; start += params.batch) {
        let count = min(end - start, params.batch);
        workgroupBarrier();
        if (lane < count * receivers) {
            prepare(lane, entries[start + lane / receivers], s);
        }
        workgroupBarrier();
        if (is_there) {
            for (var slot = 0u; slot < count; slot += 1u) {
                mask |= mask_of(slot * receivers + mine, entries[start + slot], r, word, mask);
            }
        }
    }
    mask &= below(min(params.bits, params.samples - word * params.bits));
    if (is_there & (mask != 0u)) {
        atomicOr(&hidden[(word * params.view.rows + place.y) * params.view.columns + place.x], mask);
    }
}

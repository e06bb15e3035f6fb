// Divides the rectangle of a conflict object among channels, by one workgroup of 64 lanes; a lane owns a piece.
//
// Regions of others are met by objects and then by their regions: those that exist, overlap the object's rectangle and
// in whose overlap, by the outlines of the two objects, may be pixels of either; the first `met` of them, the others
// are left out, and visibility may be over-estimated where they are.
//
// The pieces begin as the bounding rectangle. Each region that is met divides
// every piece that it overlaps and in which its channel is still free. The overlap may hold, by the outlines of the two
// objects, pixels of neither: nothing happens; only of the other: it is dropped; of this one, or of both: it becomes a
// piece in which the channel is occupied. What is left of the piece makes up to four more, above, left, right and
// below. Where that would make more than `limit` pieces, only pieces that lie wholly in the region are dropped or
// occupied, and visibility may be over-estimated. Then pairs of pieces that make a rectangle and leave a channel free
// are merged, the first pair first. A piece gets the channel in which regions overlap it least, by pixels; lowest
// number among equals, so a free one if there is one.
//
// Invariant: a region that is met costs an invocation one turn of a loop to divide by it and one to weigh it, for
// nothing beneath loops; a neighbour costs four, however many regions it has, as each lane looks at one of them
// (docs/numerics.md, Turns of loops).

require NONE: u32;

var<workgroup> piece_at: array<vec4<u32>, 64>;
var<workgroup> occupied_at: array<u32, 64>;
/// A number below 8 of every lane: bit k of lane i is bit i % 32 of word 2 k + i / 32.
var<workgroup> planes: array<atomic<u32>, 6>;
/// What comes of all lanes, and what lane 0 tells all.
var<workgroup> tally: atomic<u32>;
var<workgroup> head: u32;
/// A bit for every region of a neighbour, and what lane 0 tells all of them.
var<workgroup> reaching: array<atomic<u32>, 2>;
var<workgroup> reaching_head: vec2<u32>;

/// Whether a rectangle lies beyond the line from a to b.
fn is_beyond(a: vec2<i32>, b: vec2<i32>, low: vec2<i32>, high: vec2<i32>) -> bool {
    let d = b - a;
    // d x (p - a) at the corner where it is largest.
    let p = select(low, high, vec2<bool>((d.y < 0), (d.x > 0)));
    return d.x * (p.y - a.y) - d.y * (p.x - a.x) < 0;
}

/// Whether the outline of an object reaches into a rectangle, or touches it.
fn outline_meets(object: u32, r: vec4<u32>) -> bool {
    let low = vec2<i32>(r.xy);
    let high = vec2<i32>(r.zw);
    let at = 8u * object;
    let a = outlines[at];
    let b = outlines[at + 1u];
    let c = outlines[at + 2u];
    let d = outlines[at + 3u];
    let e = outlines[at + 4u];
    let f = outlines[at + 5u];
    let g = outlines[at + 6u];
    let h = outlines[at + 7u];
    let least = min(min(min(a, b), min(c, d)), min(min(e, f), min(g, h)));
    let most = max(max(max(a, b), max(c, d)), max(max(e, f), max(g, h)));
    let apart = is_beyond(a, b, low, high) | is_beyond(b, c, low, high) | is_beyond(c, d, low, high)
        | is_beyond(d, e, low, high) | is_beyond(e, f, low, high) | is_beyond(f, g, low, high)
        | is_beyond(g, h, low, high) | is_beyond(h, a, low, high);
    return !apart & all(least <= high) & all(most >= low);
}

/// The regions of another object that may share pixels with this one's rectangle, a bit each; uniform.
fn regions_reaching(object: u32, other: u32, lane: u32) -> vec2<u32> {
    if (lane < region_counts[other]) {
        let v = shared_part(rectangles[object], regions[64u * other + lane]);
        if (!is_empty(v)) {
            if (outline_meets(object, v) | outline_meets(other, v)) {
                atomicOr(&reaching[lane / 32u], 1u << (lane % 32u));
            }
        }
    }
    workgroupBarrier();
    if (lane == 0u) {
        reaching_head = vec2<u32>(atomicLoad(&reaching[0]), atomicLoad(&reaching[1]));
        atomicStore(&reaching[0], 0u);
        atomicStore(&reaching[1], 0u);
    }
    return workgroupUniformLoad(&reaching_head);
}

/// The lowest of 64 bits, of which one is set.
fn lowest_bit(bits: vec2<u32>) -> u32 {
    return select(firstTrailingBit(bits.x), 32u + firstTrailingBit(bits.y), bits.x == 0u);
}

fn without_lowest(bits: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(bits.x & (bits.x - 1u), select(bits.y, bits.y & (bits.y - 1u), bits.x == 0u));
}

/// What a piece becomes; `part` is the one in which the channel is occupied, or `NONE`.
struct Pieces {
    count: u32,
    rectangles: array<vec4<u32>, 5>,
    part: u32,
}

/// A piece that stays as it is, if it exists.
fn kept(r: vec4<u32>, exists: bool) -> Pieces {
    var out: Pieces;
    out.count = select(0u, 1u, exists);
    out.rectangles[0] = r;
    out.part = NONE;
    return out;
}

fn add_piece(out: ptr<function, Pieces>, r: vec4<u32>) {
    if (!is_empty(r)) {
        (*out).rectangles[(*out).count] = r;
        (*out).count += 1u;
    }
}

/// A piece cut around its part v: above, left, v itself if it is kept, right, below.
fn divided(r: vec4<u32>, v: vec4<u32>, with_part: bool) -> Pieces {
    var out: Pieces;
    add_piece(&out, vec4<u32>(r.xyz, v.y));
    add_piece(&out, vec4<u32>(r.x, v.y, v.x, v.w));
    out.part = select(NONE, out.count, with_part);
    add_piece(&out, select(vec4<u32>(0u), v, vec4<bool>(with_part)));
    add_piece(&out, vec4<u32>(v.z, v.y, r.z, v.w));
    add_piece(&out, vec4<u32>(r.x, v.w, r.zw));
    return out;
}

/// Sum over all lanes; uniform.
fn total_of(value: u32, lane: u32) -> u32 {
    atomicAdd(&tally, value);
    workgroupBarrier();
    if (lane == 0u) {
        head = atomicLoad(&tally);
        atomicStore(&tally, 0u);
    }
    return workgroupUniformLoad(&head);
}

fn set_bit(k: u32, value: u32, lane: u32) {
    atomicOr(&planes[2u * k + lane / 32u], ((value >> k) & 1u) << (lane % 32u));
}

/// What bit k of all lanes before this one adds up to.
fn bits_before(k: u32, lane: u32) -> u32 {
    let within = (1u << (lane % 32u)) - 1u;
    let low = atomicLoad(&planes[2u * k]) & select(within, 0xffffffffu, lane >= 32u);
    let high = atomicLoad(&planes[2u * k + 1u]) & select(0u, within, lane >= 32u);
    return (countOneBits(low) + countOneBits(high)) << k;
}

/// Sum of values below 8 over the lanes before this one.
fn before(value: u32, lane: u32) -> u32 {
    if (lane < 6u) {
        atomicStore(&planes[lane], 0u);
    }
    workgroupBarrier();
    set_bit(0u, value, lane);
    set_bit(1u, value, lane);
    set_bit(2u, value, lane);
    workgroupBarrier();
    return bits_before(0u, lane) + bits_before(1u, lane) + bits_before(2u, lane);
}

/// Puts piece `i` of those that a lane has made where all lanes see it.
fn place_piece(pieces: ptr<function, Pieces>, i: u32, place: u32, occupied: u32, bit: u32) {
    if (i < (*pieces).count) {
        piece_at[place + i] = (*pieces).rectangles[i];
        occupied_at[place + i] = occupied | select(0u, bit, i == (*pieces).part);
    }
}

/// Divides the pieces by the region at `at` of another object; returns how many there are now.
fn divide_by(object: u32, other: u32, at: u32, count: u32, lane: u32) -> u32 {
    let r = piece_at[lane];
    let occupied = occupied_at[lane];
    let bit = 1u << region_channels[at];
    let v = shared_part(r, regions[at]);
    let overlaps = (lane < count) & !is_empty(v) & ((occupied & bit) == 0u);
    let own = overlaps & outline_meets(object, v);
    let acts = own | (overlaps & outline_meets(other, v));
    if (total_of(select(0u, 1u, acts), lane) == 0u) {
        return count;
    }
    var pieces = kept(r, lane < count);
    if (acts) {
        pieces = divided(r, v, own);
    }
    var total = total_of(pieces.count, lane);
    if (total > params.limit) {
        pieces = kept(r, lane < count);
        if (acts & all(v == r)) {
            pieces = divided(r, v, own);
        }
        total = total_of(pieces.count, lane);
    }
    let place = before(pieces.count, lane);
    place_piece(&pieces, 0u, place, occupied, bit);
    place_piece(&pieces, 1u, place, occupied, bit);
    place_piece(&pieces, 2u, place, occupied, bit);
    place_piece(&pieces, 3u, place, occupied, bit);
    place_piece(&pieces, 4u, place, occupied, bit);
    workgroupBarrier();
    return total;
}

/// Whether two rectangles have a whole side in common.
fn make_rectangle(a: vec4<u32>, b: vec4<u32>) -> bool {
    let beside = all(a.yw == b.yw) & ((a.z == b.x) | (b.z == a.x));
    let above = all(a.xz == b.xz) & ((a.w == b.y) | (b.w == a.y));
    return beside | above;
}

/// Merges the first pair of pieces that may be; returns how many there are now.
fn merge_pair(count: u32, lane: u32) -> u32 {
    let r = piece_at[lane];
    let occupied = occupied_at[lane];
    let full = (1u << params.channels) - 1u;
    var partner = NONE;
    for (var other = count; other > lane + 1u; other -= 1u) {
        let fits = make_rectangle(r, piece_at[other - 1u]) & ((occupied | occupied_at[other - 1u]) != full);
        partner = select(partner, other - 1u, fits);
    }
    // The least pair has the greatest complement, and no pair the complement 0.
    atomicMax(&tally, ~select((lane << 8u) | partner, NONE, partner == NONE));
    workgroupBarrier();
    if (lane == 0u) {
        head = ~atomicLoad(&tally);
        atomicStore(&tally, 0u);
    }
    let pair = workgroupUniformLoad(&head);
    if (pair == NONE) {
        return count;
    }
    let a = pair >> 8u;
    let b = pair & 255u;
    let next = piece_at[min(lane + 1u, 63u)];
    let next_occupied = occupied_at[min(lane + 1u, 63u)];
    let merged = vec4<u32>(min(piece_at[a].xy, piece_at[b].xy), max(piece_at[a].zw, piece_at[b].zw));
    let both = occupied_at[a] | occupied_at[b];
    workgroupBarrier();
    if (lane == a) {
        piece_at[lane] = merged;
        occupied_at[lane] = both;
    } else if (lane >= b) {
        piece_at[lane] = next;
        occupied_at[lane] = next_occupied;
    }
    workgroupBarrier();
    return count - 1u;
}

/// Adds to `cost`, by channels and clamped to 2^32 - 1, the pixels of the region at `at` of another object in a piece.
fn add_cost(cost: ptr<function, array<u32, 8>>, r: vec4<u32>, object: u32, other: u32, at: u32) {
    let v = shared_part(r, regions[at]);
    if (!is_empty(v)) {
        if (outline_meets(object, v) | outline_meets(other, v)) {
            let channel = region_channels[at];
            let pixels = (v.z - v.x) * (v.w - v.y);
            (*cost)[channel] += min(pixels, NONE - (*cost)[channel]);
        }
    }
}

/// Divides the rectangle of an object, piece by piece, by all regions that it meets; returns how many pieces there are.
fn divide_all(object: u32, lane: u32) -> u32 {
    var count = 1u;
    var left = params.met;
    for (var word = 0u; word < row_words(); word += 1u) {
        var bits = conflict_bits[object * row_words() + word];
        while (bits != 0u) {
            let other = 32u * word + firstTrailingBit(bits);
            bits &= bits - 1u;
            var found = regions_reaching(object, other, lane);
            while (((found.x | found.y) != 0u) & (left != 0u)) {
                count = divide_by(object, other, 64u * other + lowest_bit(found), count, lane);
                found = without_lowest(found);
                left -= 1u;
            }
        }
    }
    return count;
}

/// The channel in which the regions that an object meets cover a piece least.
fn best_channel(object: u32, r: vec4<u32>, lane: u32) -> u32 {
    var cost = array<u32, 8>();
    var left = params.met;
    for (var word = 0u; word < row_words(); word += 1u) {
        var bits = conflict_bits[object * row_words() + word];
        while (bits != 0u) {
            let other = 32u * word + firstTrailingBit(bits);
            bits &= bits - 1u;
            var found = regions_reaching(object, other, lane);
            while (((found.x | found.y) != 0u) & (left != 0u)) {
                add_cost(&cost, r, object, other, 64u * other + lowest_bit(found));
                found = without_lowest(found);
                left -= 1u;
            }
        }
    }
    var best = 0u;
    for (var channel = 1u; channel < params.channels; channel += 1u) {
        best = select(best, channel, cost[channel] < cost[best]);
    }
    return best;
}

/// Writes the regions of a conflict object.
fn split_object(object: u32, lane: u32) {
    piece_at[lane] = rectangles[object];
    occupied_at[lane] = 0u;
    workgroupBarrier();
    var count = divide_all(object, lane);
    var last = count + 1u;
    while (count < last) {
        last = count;
        count = merge_pair(count, lane);
    }
    let r = piece_at[lane];
    let best = best_channel(object, r, lane);
    if (lane < count) {
        regions[64u * object + lane] = r;
        region_channels[64u * object + lane] = best;
    }
    if (lane == 0u) {
        region_counts[object] = count;
    }
}

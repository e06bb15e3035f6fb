// Region sets: which rectangles of which colour channels to sum, to count the visible pixels of many objects by tables.
//
// Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009), sections 3.1.1 to 3.1.3; the
// colouring is that of Chaitin and Briggs, as Muchnick, "Advanced Compiler Design and Implementation" (1997), has it.
//
// `conflicts` finds the pairs of objects whose bounding rectangles overlap. `colour` takes away the object with the
// fewest remaining conflicts, lowest number first, until none is left, then puts them back in reverse and gives each
// the lowest channel that none of its neighbours has; one that finds none is a conflict object. `split` divides the
// rectangle of one conflict object after another (split.wgsl). The regions of an object are disjoint and hold all its
// pixels, so a count is never less than what is visible; it is more only where two objects share a channel.
//
// `paint` draws an item buffer in several channels, one after another: 1 where the pixel's region is of that channel;
// `paint_weights` draws a weight instead of 1 (section 5: visibility that is not binary). `count` adds the sums of the
// channels' tables over the regions of every object, cut to a rectangle of the object's own.

import package::region_sets::colour::colour_graph;
import package::region_sets::split::split_object;

/// The channel of an object or region that has none.
const NONE: u32 = 0xffffffffu;

struct Params {
    objects: u32,
    /// Channels, 1 to 8.
    channels: u32,
    /// Most regions of an object, 1 to 64.
    limit: u32,
    /// Most regions of others that an object is divided by.
    met: u32,
    /// Columns and rows of the picture; a table has as many.
    width: u32,
    height: u32,
    /// The channels that are painted or counted: the first, and the one past the last.
    channel: u32,
    end: u32,
    /// Number of the first workgroup, or the object that is divided.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
/// x0, y0, x1, y1 of every object in pixels, half-open.
@group(0) @binding(1) var<storage, read> rectangles: array<vec4<u32>>;
/// Eight corners of the convex outline of every object, turning as x to y; corners may repeat.
@group(0) @binding(2) var<storage, read> outlines: array<vec2<i32>>;
/// A row of bits for every object: the objects it is in conflict with.
@group(0) @binding(3) var<storage, read_write> conflict_words: array<u32>;
@group(0) @binding(4) var<storage, read> conflict_bits: array<u32>;
@group(0) @binding(5) var<storage, read_write> channel_of: array<u32>;
@group(0) @binding(6) var<storage, read> given_channel: array<u32>;
/// Number of regions of every object, at most 64.
@group(0) @binding(7) var<storage, read_write> region_counts: array<u32>;
/// 64 rectangles for every object.
@group(0) @binding(8) var<storage, read_write> regions: array<vec4<u32>>;
@group(0) @binding(9) var<storage, read_write> region_channels: array<u32>;
/// The same, once they are known.
@group(0) @binding(10) var<storage, read> known_counts: array<u32>;
@group(0) @binding(11) var<storage, read> known_regions: array<vec4<u32>>;
@group(0) @binding(12) var<storage, read> known_channels: array<u32>;
/// Object of every pixel, or any word past them.
@group(0) @binding(13) var<storage, read> items: array<u32>;
/// The painted channels, one after another.
@group(0) @binding(14) var<storage, read_write> image: array<u32>;
/// Their summed-area tables.
@group(0) @binding(15) var<storage, read> table: array<u32>;
/// What of each object is asked for.
@group(0) @binding(16) var<storage, read> queries: array<vec4<u32>>;
@group(0) @binding(17) var<storage, read_write> sums: array<u32>;
/// Weight of every pixel.
@group(0) @binding(18) var<storage, read> weights: array<u32>;

/// Words of a row of bits.
fn row_words() -> u32 {
    return (params.objects + 31u) / 32u;
}

/// What two half-open rectangles have in common; empty where x0 >= x1 or y0 >= y1.
fn shared_part(a: vec4<u32>, b: vec4<u32>) -> vec4<u32> {
    return vec4<u32>(max(a.xy, b.xy), min(a.zw, b.zw));
}

fn is_empty(r: vec4<u32>) -> bool {
    return (r.x >= r.z) | (r.y >= r.w);
}

@compute @workgroup_size(256)
fn conflicts(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let words = row_words();
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.objects * words) {
        return;
    }
    let object = number / words;
    let first = 32u * (number - object * words);
    let own = rectangles[object];
    var bits = 0u;
    for (var other = first; other < min(first + 32u, params.objects); other += 1u) {
        let meets = !is_empty(shared_part(own, rectangles[other])) & (other != object);
        bits |= select(0u, 1u, meets) << (other - first);
    }
    conflict_words[number] = bits;
}

/// One workgroup.
@compute @workgroup_size(256)
fn colour(@builtin(local_invocation_index) lane: u32) {
    colour_graph(lane);
    for (var object = lane; object < params.objects; object += 256u) {
        let channel = vertex_state[object];
        channel_of[object] = channel;
        region_counts[object] = select(1u, 0u, channel == NONE);
        regions[64u * object] = select(rectangles[object], vec4<u32>(0u), channel == NONE);
        region_channels[64u * object] = channel;
    }
}

/// One workgroup divides one object, if it is a conflict object; the host launches them in their order.
@compute @workgroup_size(64)
fn split(@builtin(local_invocation_index) lane: u32) {
    if (given_channel[params.first] == NONE) {
        split_object(params.first, lane);
    }
}

/// The channel of a pixel's region, or `NONE`.
fn channel_at(place: u32) -> u32 {
    let item = items[place];
    let pixel = vec2<u32>(place % params.width, place / params.width);
    var channel = NONE;
    if (item < params.objects) {
        for (var i = 0u; i < known_counts[item]; i += 1u) {
            let r = known_regions[64u * item + i];
            let inside = all(pixel >= r.xy) & all(pixel < r.zw);
            channel = select(channel, known_channels[64u * item + i], inside);
        }
    }
    return channel;
}

fn paint_pixel(place: u32, value: u32) {
    let own = channel_at(place);
    for (var channel = params.channel; channel < params.end; channel += 1u) {
        let at = (channel - params.channel) * params.width * params.height + place;
        image[at] = select(0u, value, channel == own);
    }
}

@compute @workgroup_size(256)
fn paint(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let place = (params.first + group.x) * 256u + lane;
    if (place < params.width * params.height) {
        paint_pixel(place, 1u);
    }
}

@compute @workgroup_size(256)
fn paint_weights(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let place = (params.first + group.x) * 256u + lane;
    if (place < params.width * params.height) {
        paint_pixel(place, weights[place]);
    }
}

/// Sum over the columns left of x and the rows above y of the table that begins at `start`.
fn corner(start: u32, x: u32, y: u32) -> u32 {
    var sum = 0u;
    if ((x > 0u) & (y > 0u)) {
        sum = table[start + (y - 1u) * params.width + x - 1u];
    }
    return sum;
}

@compute @workgroup_size(256)
fn count(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let object = (params.first + group.x) * 256u + lane;
    if (object >= params.objects) {
        return;
    }
    let query = shared_part(queries[object], vec4<u32>(0u, 0u, params.width, params.height));
    var sum = 0u;
    for (var i = 0u; i < known_counts[object]; i += 1u) {
        let r = shared_part(query, known_regions[64u * object + i]);
        let channel = known_channels[64u * object + i];
        if (!is_empty(r) & (channel >= params.channel) & (channel < params.end)) {
            let start = (channel - params.channel) * params.width * params.height;
            sum += corner(start, r.z, r.w) - corner(start, r.x, r.w) - corner(start, r.z, r.y) + corner(start, r.x, r.y);
        }
    }
    sums[object] += sum;
}

// Illumination of vertices: the visibility matrix times the intensities of its directional lights, in fixed point.
//
// Sattler et al. 2004, sections 3.2, 3.3 and 5. An entry of the matrix is n . l for a visible
// light and 0 for an occluded one; here it is kept as one bit, and n . l, 0 where it is negative, is made when it is
// used. All sums are of integers, so neither their order nor the order of the lights can show; a colour is rounded to
// f32 once.
//
// `blur` writes for every texel and channel floor(sum over i of taps[i] * texel(i - radius) / 2^16), where texels are
// taken along a row, around, or along a column, the last texel standing for those beyond. `look_up` writes for every
// light j and channel floor(texel * weights[j] / 2^32), of the texel that holds direction j of a latitude-longitude map
// (row floor(height * angle from +z / pi), column floor(width * angle from +x towards +y / 2 pi)) or of a cube map.
// `illuminate` writes for vertex v, channel c
//
//     sum over visible j of max(0, floor(n_v . l_j / 2^15)) * intensities[j][c] / 2^shift[c], rounded once,
//
// the sum modulo 2^64, as the bits of an f32; `add_block` adds the sum of a block of lights to those of earlier ones,
// and `resolve` rounds them. `encode` writes how many of 255 ascending thresholds a colour reaches, for each channel.

import package::shared::angle::atan2_bam;
import package::shared::fixed_point::u64_to_f;
import package::shared::root::isqrt32;
import package::shared::wide::{add64, uabs, umul_hi, umul_wide};

struct Map {
    /// Texels a row; of a cube map, of a face's row.
    width: u32,
    /// Rows; 0 for a cube map, whose faces +x, -x, +y, -y, +z, -z follow each other.
    height: u32,
    /// Number of items, and the item of the first invocation.
    count: u32,
    first: u32,
    /// Of `blur`: texels on either side, and whether it is along columns.
    radius: u32,
    along_columns: u32,
}

@group(0) @binding(0) var<uniform> map: Map;
@group(0) @binding(1) var<storage, read> texels: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read> taps: array<u32>;
@group(0) @binding(3) var<storage, read_write> blurred: array<vec4<u32>>;
/// Of length about 2^15.
@group(0) @binding(4) var<storage, read> directions: array<vec4<i32>>;
@group(0) @binding(5) var<storage, read> weights: array<u32>;
@group(0) @binding(6) var<storage, read_write> looked_up: array<vec4<u32>>;

@compute @workgroup_size(256)
fn blur(@builtin(global_invocation_id) id: vec3<u32>) {
    let texel = map.first + id.x;
    if (texel >= map.count) {
        return;
    }
    let row = texel / map.width;
    let column = texel - row * map.width;
    var red = vec2<u32>();
    var green = vec2<u32>();
    var blue = vec2<u32>();
    for (var i = 0u; i <= 2u * map.radius; i += 1u) {
        var from_row = row;
        var from_column = column;
        if (map.along_columns != 0u) {
            from_row = bitcast<u32>(clamp(bitcast<i32>(row + i) - bitcast<i32>(map.radius), 0, bitcast<i32>(map.height) - 1));
        } else {
            // The radius is at most the width.
            from_column = (column + i + map.width - map.radius) % map.width;
        }
        let value = texels[from_row * map.width + from_column];
        let tap = taps[i];
        red = add64(red, umul_wide(value.x, tap));
        green = add64(green, umul_wide(value.y, tap));
        blue = add64(blue, umul_wide(value.z, tap));
    }
    blurred[texel] = vec4<u32>(upper(red), upper(green), upper(blue), 0u);
}

/// floor(v / 2^16) of a v below 2^48.
fn upper(v: vec2<u32>) -> u32 {
    return (v.y << 16u) | (v.x >> 16u);
}

fn latitude_longitude(d: vec3<i32>) -> u32 {
    let radius = bitcast<i32>(isqrt32(bitcast<u32>(d.x * d.x + d.y * d.y)));
    // The angle from +z is at most half a turn, 2^31.
    let row = min(umul_hi(atan2_bam(radius, d.z), 2u * map.height), map.height - 1u);
    return row * map.width + umul_hi(atan2_bam(d.y, d.x), map.width);
}

/// Texel of a coordinate in [-major, major] of a face.
fn across(coordinate: i32, major: u32) -> u32 {
    return min(bitcast<u32>(coordinate + bitcast<i32>(major)) * map.width / (2u * major), map.width - 1u);
}

/// Faces and their axes as OpenGL has them; of equal components the first is the major one.
fn cube(d: vec3<i32>) -> u32 {
    let a = vec3<u32>(uabs(d.x), uabs(d.y), uabs(d.z));
    var face = 4u;
    var major = max(a.z, 1u);
    var s = select(d.x, 0 - d.x, d.z < 0);
    var t = 0 - d.y;
    var negative = d.z < 0;
    if ((a.x >= a.y) & (a.x >= a.z)) {
        face = 0u;
        major = max(a.x, 1u);
        negative = d.x < 0;
        s = select(0 - d.z, d.z, negative);
    } else if (a.y >= a.z) {
        face = 2u;
        major = a.y;
        negative = d.y < 0;
        s = d.x;
        t = select(d.z, 0 - d.z, negative);
    }
    face += select(0u, 1u, negative);
    return (face * map.width + across(t, major)) * map.width + across(s, major);
}

@compute @workgroup_size(256)
fn look_up(@builtin(global_invocation_id) id: vec3<u32>) {
    let light = map.first + id.x;
    if (light >= map.count) {
        return;
    }
    let d = directions[light].xyz;
    var place = 0u;
    if (map.height == 0u) {
        place = cube(d);
    } else {
        place = latitude_longitude(d);
    }
    let texel = texels[place];
    let weight = weights[light];
    looked_up[light] = vec4<u32>(umul_hi(texel.x, weight), umul_hi(texel.y, weight), umul_hi(texel.z, weight), 0u);
}

struct Lights {
    /// Vertices with normals of their own.
    vertices: u32,
    /// Rows of the bit matrix: vertices by position.
    positions: u32,
    count: u32,
    /// Vertex of the first invocation.
    first: u32,
    /// Results are in units of 2^-shift, for each channel.
    shift: vec3<i32>,
}

@group(0) @binding(7) var<uniform> lights: Lights;
/// All x, then all y, then all z, of length at most 2^15.
@group(0) @binding(8) var<storage, read> normals: array<i32>;
/// Position of every vertex.
@group(0) @binding(9) var<storage, read> position_of: array<u32>;
@group(0) @binding(10) var<storage, read> occluded: array<u32>;
@group(0) @binding(11) var<storage, read> units: array<vec4<i32>>;
@group(0) @binding(12) var<storage, read> intensities: array<vec4<u32>>;
/// f32 bits of all red values, then green, then blue.
@group(0) @binding(13) var<storage, read_write> colours: array<u32>;

/// For each channel the low words of all vertices' sums, then the high words.
@group(0) @binding(17) var<storage, read_write> sums: array<u32>;

struct Light {
    red: vec2<u32>,
    green: vec2<u32>,
    blue: vec2<u32>,
}

fn light_of(vertex: u32) -> Light {
    let n = vec3<i32>(normals[vertex], normals[lights.vertices + vertex], normals[2u * lights.vertices + vertex]);
    let position = position_of[vertex];
    var red = vec2<u32>();
    var green = vec2<u32>();
    var blue = vec2<u32>();
    for (var first = 0u; first < lights.count; first += 32u) {
        let hidden = occluded[first / 32u * lights.positions + position];
        let end = min(lights.count - first, 32u);
        for (var bit = 0u; bit < end; bit += 1u) {
            let l = units[first + bit];
            let cosine = max((n.x * l.x + n.y * l.y + n.z * l.z) >> 15u, 0);
            let entry = select(bitcast<u32>(cosine), 0u, ((hidden >> bit) & 1u) != 0u);
            let light = intensities[first + bit];
            red = add64(red, umul_wide(entry, light.x));
            green = add64(green, umul_wide(entry, light.y));
            blue = add64(blue, umul_wide(entry, light.z));
        }
    }
    return Light(red, green, blue);
}

fn write_colour(vertex: u32, light: Light) {
    colours[vertex] = u64_to_f(light.red, lights.shift.x);
    colours[lights.vertices + vertex] = u64_to_f(light.green, lights.shift.y);
    colours[2u * lights.vertices + vertex] = u64_to_f(light.blue, lights.shift.z);
}

fn sum_at(vertex: u32, channel: u32) -> vec2<u32> {
    let low = 2u * channel * lights.vertices + vertex;
    return vec2<u32>(sums[low], sums[low + lights.vertices]);
}

fn add_to_sum(vertex: u32, channel: u32, more: vec2<u32>) {
    let low = 2u * channel * lights.vertices + vertex;
    let sum = add64(sum_at(vertex, channel), more);
    sums[low] = sum.x;
    sums[low + lights.vertices] = sum.y;
}

@compute @workgroup_size(256)
fn illuminate(@builtin(global_invocation_id) id: vec3<u32>) {
    let vertex = lights.first + id.x;
    if (vertex < lights.vertices) {
        write_colour(vertex, light_of(vertex));
    }
}

@compute @workgroup_size(256)
fn add_block(@builtin(global_invocation_id) id: vec3<u32>) {
    let vertex = lights.first + id.x;
    if (vertex < lights.vertices) {
        let light = light_of(vertex);
        add_to_sum(vertex, 0u, light.red);
        add_to_sum(vertex, 1u, light.green);
        add_to_sum(vertex, 2u, light.blue);
    }
}

@compute @workgroup_size(256)
fn resolve(@builtin(global_invocation_id) id: vec3<u32>) {
    let vertex = lights.first + id.x;
    if (vertex < lights.vertices) {
        write_colour(vertex, Light(sum_at(vertex, 0u), sum_at(vertex, 1u), sum_at(vertex, 2u)));
    }
}

@group(0) @binding(14) var<storage, read> given: array<u32>;
/// f32 bits of ascending positive numbers.
@group(0) @binding(15) var<storage, read> thresholds: array<u32>;
/// Red in the lowest byte, then green, blue, 255.
@group(0) @binding(16) var<storage, read_write> encoded: array<u32>;

/// How many thresholds a value reaches; bits of positive floats are ordered as the floats are.
fn code(value: u32) -> u32 {
    var reached = 0u;
    for (var step = 128u; step != 0u; step >>= 1u) {
        let next = reached + step;
        reached = select(reached, next, value >= thresholds[next - 1u]);
    }
    return reached;
}

@compute @workgroup_size(256)
fn encode(@builtin(global_invocation_id) id: vec3<u32>) {
    let vertex = lights.first + id.x;
    if (vertex >= lights.vertices) {
        return;
    }
    let red = code(given[vertex]);
    let green = code(given[lights.vertices + vertex]);
    let blue = code(given[2u * lights.vertices + vertex]);
    encoded[vertex] = red | (green << 8u) | (blue << 16u) | 0xff000000u;
}

// Depth and item buffers of indexed triangles, instance by instance, in integers.
//
// Laine and Karras, "High-Performance Software Rasterization on GPUs" (HPG 2011), section 3, has the fixed-point
// pipeline; the buffers are those that Engelhardt and Dachsbacher, "Granular Visibility Queries on the GPU" (I3D 2009),
// section 3, count pixels in. docs/numerics.md, "The raster", states the outputs exactly, step by step, and why every
// path meets them.
//
// `clear` sets a buffer, bound as `depth`, to 2^32 - 1. `project` puts the vertices of all instances on the screen.
// `sort` marks the triangles that are not small; from the prefix sums of the marks `list` lists them, and `arguments`
// tells how many workgroups of `large` there are. `small` draws the triangles of a few pixels, a lane each; `large` the
// listed ones, a workgroup each triangle and band of rows, 256 pixels at a time. With ITEMS false both leave the least
// depth in `depth`; with ITEMS true, once the depths of all meshes are known, they leave in `items` the least id of the
// triangles that have that depth. `points` tells which projected points are not behind the depths of their pixels.

import package::raster::clip::{clip_coordinate, cut, on_screen};
import package::raster::fitting::draw_fitting;
import package::raster::small::draw_small;
import package::raster::wide::{draw_wide, turn64};
import package::shared::raster::turn;
import package::shared::wide::sgn64;

/// Whether ids are written, and not depths.
const ITEMS: bool = false;

/// Sub-pixels that the extents of a small triangle stay below.
const SMALL: i32 = 256;
/// The same of one that fits 15 bits.
const FITTING: i32 = 32768;

struct Params {
    width: u32,
    height: u32,
    /// Least divisor of the perspective division, at least 1.
    near: i32,
    /// Vertices, triangles and instances of the mesh.
    vertices: u32,
    triangles: u32,
    instances: u32,
    /// Bit 0: triangles of S > 0 are drawn, bit 1: those of S < 0.
    faces: u32,
    /// id = id_base + instance * id_step + (triangle >> id_shift).
    id_base: u32,
    id_step: u32,
    id_shift: u32,
    /// Rows of a band.
    band: u32,
    /// Added to the depth that a point is compared with.
    bias: u32,
    /// Most listed triangles of a launch of `large`.
    piece: u32,
    /// Number of the first workgroup.
    first: u32,
}

@group(0) @binding(0) var<uniform> params: Params;
/// Three coordinates a vertex.
@group(0) @binding(1) var<storage, read> vertices: array<i32>;
/// Three vertices a triangle.
@group(0) @binding(2) var<storage, read> indices: array<u32>;
/// The rows of X, Y, Z and W of every instance.
@group(0) @binding(3) var<storage, read> rows: array<vec4<i32>>;
/// Screen coordinates and depth of vertex `v` of instance `n` at `n * vertices + v`, and 1 if it is in front, else 0.
@group(0) @binding(4) var<storage, read_write> projected: array<vec4<i32>>;
@group(0) @binding(5) var<storage, read> screen: array<vec4<i32>>;
/// 1 for every triangle of every instance that `large` draws, else 0.
@group(0) @binding(6) var<storage, read_write> marks: array<u32>;
/// Those triangles.
@group(0) @binding(7) var<storage, read> listed: array<u32>;
@group(0) @binding(8) var<storage, read_write> depth: array<atomic<u32>>;
@group(0) @binding(9) var<storage, read_write> items: array<atomic<u32>>;
/// A bit for every projected vertex.
@group(0) @binding(10) var<storage, read_write> seen: array<atomic<u32>>;

/// The marks, once they are known, and how many there are before each triangle.
@group(0) @binding(11) var<storage, read> known_marks: array<u32>;
@group(0) @binding(12) var<storage, read> marks_before: array<u32>;
@group(0) @binding(13) var<storage, read_write> large_list: array<u32>;
/// Workgroups of every piece of `large`.
@group(0) @binding(14) var<storage, read_write> workgroups: array<u32>;

fn plot(place: u32, z: u32, id: u32) {
    if (!ITEMS) {
        atomicMin(&depth[place], z);
    } else if (atomicLoad(&depth[place]) == z) {
        atomicMin(&items[place], id);
    }
}

@compute @workgroup_size(256)
fn clear(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let place = (params.first + group.x) * 256u + lane;
    if (place < params.width * params.height) {
        atomicStore(&depth[place], 0xffffffffu);
    }
}

/// Clip coordinates of a vertex of an instance.
fn clip_point(instance: u32, vertex: u32) -> vec4<i32> {
    let v = vec3<i32>(vertices[3u * vertex], vertices[3u * vertex + 1u], vertices[3u * vertex + 2u]);
    let row = 4u * instance;
    return vec4<i32>(clip_coordinate(rows[row], v), clip_coordinate(rows[row + 1u], v),
        clip_coordinate(rows[row + 2u], v), clip_coordinate(rows[row + 3u], v));
}

fn to_screen(p: vec4<i32>) -> vec3<i32> {
    return on_screen(p, vec2<u32>(params.width, params.height), params.near);
}

@compute @workgroup_size(256)
fn project(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.vertices * params.instances) {
        return;
    }
    let instance = number / params.vertices;
    let p = clip_point(instance, number - instance * params.vertices);
    projected[number] = vec4<i32>(to_screen(p), select(0, 1, p.z >= 0));
}

/// The first and last pixel of the picture, from row `top` to row `bottom`, whose centres are in the box of a triangle.
fn box_low(a: vec2<i32>, b: vec2<i32>, c: vec2<i32>, top: i32) -> vec2<i32> {
    return max((min(min(a, b), c) + 7) >> vec2<u32>(4u), vec2<i32>(0, top));
}

fn box_high(a: vec2<i32>, b: vec2<i32>, c: vec2<i32>, bottom: i32) -> vec2<i32> {
    return min((max(max(a, b), c) - 8) >> vec2<u32>(4u), vec2<i32>(bitcast<i32>(params.width) - 1, bottom));
}

/// Sides of the box of a triangle in sub-pixels.
fn extents(a: vec2<i32>, b: vec2<i32>, c: vec2<i32>) -> vec2<i32> {
    return max(max(a, b), c) - min(min(a, b), c);
}

fn id_of(instance: u32, triangle: u32) -> u32 {
    return params.id_base + instance * params.id_step + (triangle >> params.id_shift);
}

/// Vertices of a triangle; those that the mesh does not have are answered by three equal ones, which draw nothing.
fn corners(triangle: u32) -> vec3<u32> {
    let at = 3u * triangle;
    let v = vec3<u32>(indices[at], indices[at + 1u], indices[at + 2u]);
    return select(v, vec3<u32>(0u), max(max(v.x, v.y), v.z) >= params.vertices);
}

/// A triangle on the screen: its box in pixels, and whether it is drawn at all, by one lane, or by a workgroup.
struct Setup {
    a: vec4<i32>,
    b: vec4<i32>,
    c: vec4<i32>,
    low: vec2<i32>,
    high: vec2<i32>,
    is_drawn: bool,
    is_small: bool,
}

fn set_up(instance: u32, triangle: u32) -> Setup {
    let v = corners(triangle) + instance * params.vertices;
    let a = screen[v.x];
    let b = screen[v.y];
    let c = screen[v.z];
    let front = a.w + b.w + c.w;
    let low = box_low(a.xy, b.xy, c.xy, 0);
    let high = box_high(a.xy, b.xy, c.xy, bitcast<i32>(params.height) - 1);
    let is_empty = (front == 3) & any(low > high);
    let sides = extents(a.xy, b.xy, c.xy);
    let is_small = (front == 3) & (max(sides.x, sides.y) < SMALL);
    return Setup(a, b, c, low, high, (front != 0) & !is_empty, is_small);
}

@compute @workgroup_size(256)
fn sort(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.triangles * params.instances) {
        return;
    }
    let instance = number / params.triangles;
    let t = set_up(instance, number - instance * params.triangles);
    marks[number] = select(0u, 1u, t.is_drawn & !t.is_small);
}

@compute @workgroup_size(256)
fn list(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number < params.triangles * params.instances) {
        if (known_marks[number] != 0u) {
            large_list[marks_before[number]] = number;
        }
    }
}

/// An invocation for every piece of `params.piece` triangles.
@compute @workgroup_size(64)
fn arguments(@builtin(global_invocation_id) id: vec3<u32>) {
    let triangles = params.triangles * params.instances;
    let first = id.x * params.piece;
    if (first >= triangles) {
        return;
    }
    let all = marks_before[triangles - 1u] + known_marks[triangles - 1u];
    workgroups[3u * id.x] = min(all - min(first, all), params.piece);
    workgroups[3u * id.x + 1u] = (params.height + params.band - 1u) / params.band;
    workgroups[3u * id.x + 2u] = 1u;
}

@compute @workgroup_size(256)
fn small(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.triangles * params.instances) {
        return;
    }
    let instance = number / params.triangles;
    let triangle = number - instance * params.triangles;
    let t = set_up(instance, triangle);
    if (!(t.is_drawn & t.is_small)) {
        return;
    }
    let s = turn(t.a.xy, t.b.xy, t.c.xy);
    let id = id_of(instance, triangle);
    if ((s > 0) & ((params.faces & 1u) != 0u)) {
        draw_small(t.a.xyz, t.b.xyz, t.c.xyz, t.low, t.high, id);
    }
    if ((s < 0) & ((params.faces & 2u) != 0u)) {
        draw_small(t.a.xyz, t.c.xyz, t.b.xyz, t.low, t.high, id);
    }
}

/// Draws the rows from `top` to `bottom` of a triangle.
fn draw_large(a: vec3<i32>, b: vec3<i32>, c: vec3<i32>, top: i32, bottom: i32, lane: u32, id: u32) {
    let low = box_low(a.xy, b.xy, c.xy, top);
    let high = box_high(a.xy, b.xy, c.xy, bottom);
    let s = sgn64(turn64(a.xy, b.xy, c.xy));
    let faces = select(0u, 1u, s > 0) | select(0u, 2u, s < 0);
    if ((low.x > high.x) | (low.y > high.y) | ((params.faces & faces) == 0u)) {
        return;
    }
    let second = select(c, b, s > 0);
    let third = select(b, c, s > 0);
    let sides = extents(a.xy, b.xy, c.xy);
    if (max(sides.x, sides.y) < FITTING) {
        draw_fitting(a, second, third, low, high, lane, id);
    } else {
        draw_wide(a, second, third, low, high, lane, id);
    }
}

/// What of a triangle is in front of the near plane: a fan of `triangles` triangles.
struct Fan {
    first: vec3<i32>,
    second: vec3<i32>,
    third: vec3<i32>,
    fourth: vec3<i32>,
    triangles: u32,
}

/// The fan of a triangle that crosses the near plane; `front` tells which vertices are in front.
fn cut_triangle(instance: u32, corner: vec3<u32>, front: vec3<bool>) -> Fan {
    // Turned so that the vertices in front come first.
    let turned = select(select(corner, corner.yzx, !front.x & front.y), corner.zxy, front.z & !front.y);
    let a = clip_point(instance, turned.x);
    let b = clip_point(instance, turned.y);
    let c = clip_point(instance, turned.z);
    let two = vec4<bool>(b.z >= 0);
    let other = to_screen(cut(select(a, b, two), select(b, c, two)));
    let last = to_screen(cut(a, c));
    let first_vertex = instance * params.vertices;
    let first = screen[first_vertex + turned.x].xyz;
    if (two.x) {
        return Fan(first, screen[first_vertex + turned.y].xyz, other, last, 2u);
    }
    return Fan(first, other, last, last, 1u);
}

/// Draws the rows from `top` to `bottom` of a listed triangle.
fn draw(number: u32, top: i32, bottom: i32, lane: u32) {
    let instance = number / params.triangles;
    let triangle = number - instance * params.triangles;
    let corner = corners(triangle);
    let v = corner + instance * params.vertices;
    let a = screen[v.x];
    let b = screen[v.y];
    let c = screen[v.z];
    let front = vec3<i32>(a.w, b.w, c.w) == vec3<i32>(1);
    var fan = Fan(a.xyz, b.xyz, c.xyz, c.xyz, 1u);
    if (!all(front)) {
        fan = cut_triangle(instance, corner, front);
    }
    for (var i = 0u; i < fan.triangles; i += 1u) {
        draw_large(fan.first, fan.second, fan.third, top, bottom, lane, id_of(instance, triangle));
        fan.second = fan.third;
        fan.third = fan.fourth;
    }
}

@compute @workgroup_size(256)
fn large(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let top = group.y * params.band;
    let bottom = min(top + params.band, params.height) - 1u;
    draw(listed[params.first + group.x], bitcast<i32>(top), bitcast<i32>(bottom), lane);
}

/// A point is seen iff it is in front and in the picture, and its depth is at most that of its pixel and the bias.
@compute @workgroup_size(256)
fn points(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = (params.first + group.x) * 256u + lane;
    if (number >= params.vertices * params.instances) {
        return;
    }
    let p = screen[number];
    let pixel = bitcast<vec2<u32>>(p.xy >> vec2<u32>(4u));
    if ((p.w == 0) | (pixel.x >= params.width) | (pixel.y >= params.height)) {
        return;
    }
    let least = bitcast<u32>(p.z) - min(bitcast<u32>(p.z), params.bias);
    if (least <= atomicLoad(&depth[pixel.y * params.width + pixel.x])) {
        atomicOr(&seen[number / 32u], 1u << (number % 32u));
    }
}

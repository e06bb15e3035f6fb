// Predicates of the plane under test: collinear and nearly collinear points, exact depths and columns.

import package::exact::kernel::{emit1, emit2, end_input, finish, first_input, noise, raw};
import package::shared::influence::influence_1d;
import package::shared::orientation::orient2d;
import package::shared::raster::{depth_at, edge15};

struct Triple {
    a: vec2<i32>,
    b: vec2<i32>,
    c: vec2<i32>,
}

/// Points of [-2^30, 2^30)^2; three of four inputs are on one line, or off it by -1 to 2.
fn triple(i: u32) -> Triple {
    let p = noise(i, 0u);
    let q = noise(i, 1u);
    let a = bitcast<vec2<i32>>(vec2<u32>(raw(i, 0u), raw(i, 1u))) >> vec2<u32>(1u);
    let b = bitcast<vec2<i32>>(vec2<u32>(raw(i, 2u), raw(i, 3u)));
    if ((p & 3u) == 0u) {
        return Triple(a, b >> vec2<u32>(1u), bitcast<vec2<i32>>(vec2<u32>(raw(i, 4u), raw(i, 5u))) >> vec2<u32>(1u));
    }
    let d = b >> vec2<u32>(17u);
    let start = a >> vec2<u32>(1u);
    let off = bitcast<vec2<i32>>(vec2<u32>((p >> 2u) & 3u, (p >> 4u) & 3u)) - vec2<i32>(1);
    let e = select(vec2<i32>(0), off, (p & 64u) != 0u);
    return Triple(start, start + d * bitcast<i32>(q & 0x3fffu), start + d * bitcast<i32>((q >> 14u) & 0x3fffu) + e);
}

/// Points of [0, 2^15)^2; one of two inputs is on one line, or off it by 1.
fn triple15(i: u32) -> Triple {
    let p = noise(i, 0u);
    let m = vec2<u32>(0x7fffu);
    let a = vec2<u32>(raw(i, 0u), raw(i, 1u)) & m;
    let b = vec2<u32>(raw(i, 2u), raw(i, 3u)) & m;
    let c = vec2<u32>(raw(i, 4u), raw(i, 5u)) & m;
    let d = b & vec2<u32>(127u);
    let start = a >> vec2<u32>(1u);
    let near_b = start + d * ((p >> 1u) & 127u);
    let near_c = start + d * ((p >> 8u) & 127u) + vec2<u32>((p >> 15u) & 1u, 0u);
    let near = (p & 1u) != 0u;
    let mirror = vec2<u32>(((p >> 16u) & 1u) * 0x7fffu, ((p >> 17u) & 1u) * 0x7fffu);
    return Triple(
        bitcast<vec2<i32>>(select(a, start, near) ^ mirror),
        bitcast<vec2<i32>>(select(b, near_b, near) ^ mirror),
        bitcast<vec2<i32>>(select(c, near_c, near) ^ mirror),
    );
}

struct Depth {
    w: vec3<u32>,
    z: vec3<u32>,
}

/// Weights with a sum in [1, 2^32), depths below 2^24; in one of two inputs two depths are equal and the third is -1 to
/// 2 off, so that the quotient is whole or next to it.
fn depth(i: u32) -> Depth {
    let p = noise(i, 0u);
    let z = vec3<u32>(raw(i, 3u), raw(i, 4u), raw(i, 5u)) & vec3<u32>(0xffffffu);
    let near = vec3<u32>(z.x, z.x, (z.x + ((p >> 1u) & 3u) - 1u) & 0xffffffu);
    let third = select(raw(i, 2u) >> 2u, 1u, (p & 8u) != 0u);
    let w = vec3<u32>(raw(i, 0u) >> 1u, raw(i, 1u) >> 2u, max(third, 1u));
    return Depth(w, select(z, near, (p & 1u) != 0u));
}

struct Span {
    v: i32,
    vz: u32,
    hz: u32,
    s: i32,
    t: u32,
}

fn signed15(x: u32) -> i32 {
    return max(bitcast<i32>(x & 0xffffu) - 0x8000, -0x7fff);
}

/// 0 < vz <= hz < 2^15, |v|, |s| < 2^15, t <= 16; in one of four inputs the first column begins at v exactly.
fn span_of(i: u32) -> Span {
    let p = noise(i, 0u);
    let hz = max(raw(i, 1u) & 0x7fffu, 1u);
    let vz = 1u + raw(i, 2u) % hz;
    let t = (p >> 2u) % 17u;
    let v = signed15(raw(i, 0u));
    let whole = (v >> t) << t;
    if (((p & 3u) == 0u) & (whole > -0x8000)) {
        return Span(whole, vz, hz, whole, t);
    }
    return Span(v, vz, hz, signed15(raw(i, 3u)), t);
}

@compute @workgroup_size(256)
fn test_orient2d(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = triple(i);
        sum += emit2(i, bitcast<vec2<u32>>(vec2<i32>(orient2d(p.a, p.b, p.c), orient2d(p.b, p.a, p.c))));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_edge15(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = triple15(i);
        sum += emit2(i, bitcast<vec2<u32>>(vec2<i32>(edge15(p.a, p.b, p.c), edge15(p.b, p.a, p.c))));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_depth_at(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = depth(i);
        sum += emit1(i, depth_at(p.w, p.z, p.w.x + p.w.y + p.w.z));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_influence_1d(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = span_of(i);
        sum += emit2(i, bitcast<vec2<u32>>(influence_1d(p.v, bitcast<i32>(p.vz), bitcast<i32>(p.hz), p.s, p.t)));
    }
    finish(group.x, sum);
}

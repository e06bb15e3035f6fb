// Angles and directions under test: axes, diagonals, folds of the reduction, exact fractions.

import package::exact::kernel::{emit, emit1, end_input, finish, first_input, noise, raw};
import package::shared::angle::{atan2_bam, diamond_angle};
import package::shared::direction::{normalize3_q15, oct_dir};
import package::shared::wide::{shr64, uabs, umul_wide};

/// Any vector (x, y); in one of four inputs y / x is within 2 of the fold at 2/5.
fn vector(i: u32) -> vec2<i32> {
    let p = noise(i, 0u);
    let m = raw(i, 1u) >> 4u;
    let folded = vec2<u32>(5u * m, 2u * m + ((p >> 2u) & 3u) - 1u);
    return bitcast<vec2<i32>>(select(vec2<u32>(raw(i, 0u), raw(i, 1u)), folded, (p & 3u) == 0u));
}

/// A vector of [-2^29, 2^29)^2; in one of two inputs y 2^20 is next to a multiple of |x| + |y|.
fn short_vector(i: u32) -> vec2<i32> {
    let p = noise(i, 0u);
    let d = raw(i, 0u) >> 3u;
    let y = shr64(umul_wide(d, raw(i, 1u) & 0xfffffu), 20u).x + ((p >> 1u) & 1u);
    let any = bitcast<vec2<i32>>(vec2<u32>(raw(i, 0u), raw(i, 1u))) >> vec2<u32>(2u);
    return select(any, bitcast<vec2<i32>>(vec2<u32>(d - y, y)), (p & 1u) != 0u);
}

/// A vector of [-2^15, 2^15]^3 that is not 0; one of four inputs is near the x axis.
fn vector3(i: u32) -> vec3<i32> {
    let p = noise(i, 0u);
    let v = bitcast<vec3<i32>>(vec3<u32>(raw(i, 0u), raw(i, 1u), raw(i, 2u)) % vec3<u32>(65537u)) - vec3<i32>(32768);
    let near = vec3<i32>(v.x, v.y >> 13u, v.z >> 13u);
    let w = select(v, near, (p & 3u) == 0u);
    return select(w, vec3<i32>(0, 0, 1), (w.x | w.y | w.z) == 0);
}

struct Place {
    i: i32,
    j: i32,
    n: i32,
}

/// A place of a lattice with n <= 2^29; one of two inputs is on the equator or next to it.
fn place(i: u32) -> Place {
    let p = noise(i, 0u);
    let n = bitcast<i32>(max(raw(i, 0u) & 0x1fffffffu, 1u));
    let side = bitcast<u32>(2 * n + 1);
    let x = bitcast<i32>(raw(i, 1u) % side);
    let rest = n - bitcast<i32>(uabs(x - n)) + bitcast<i32>((p >> 1u) & 1u);
    let y = clamp(n + select(rest, 0 - rest, (p & 4u) != 0u), 0, 2 * n);
    return Place(x, select(bitcast<i32>(raw(i, 2u) % side), y, (p & 1u) != 0u), n);
}

@compute @workgroup_size(256)
fn test_atan2_bam(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let v = vector(i);
        sum += emit1(i, atan2_bam(v.y, v.x));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_diamond_angle(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let v = short_vector(i);
        sum += emit1(i, diamond_angle(v.y, v.x));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_normalize3_q15(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit(i, vec4<u32>(bitcast<vec3<u32>>(normalize3_q15(vector3(i))), 0u));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_oct_dir(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = place(i);
        sum += emit(i, vec4<u32>(bitcast<vec3<u32>>(oct_dir(p.i, p.j, p.n)), 0u));
    }
    finish(group.x, sum);
}

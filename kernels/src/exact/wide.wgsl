// 64-bit integers, hashes and masks under test.

import package::exact::kernel::{emit, emit1, emit2, end_input, finish, first_input, noise, raw};
import package::shared::hash::hash32;
import package::shared::mask::mask_dot;
import package::shared::wide::{abs64, add64, clz64, imul_wide, ltu64, neg64, sgn64, shl64, shr64, sub64, uabs};
import package::shared::wide::umul_wide;

struct Pair {
    a: vec2<u32>,
    b: vec2<u32>,
}

/// Any two; in one of four inputs their low words differ by -1 to 2 and their high words are equal.
fn pair(i: u32) -> Pair {
    let p = noise(i, 0u);
    let a = vec2<u32>(raw(i, 0u), raw(i, 1u));
    let near = vec2<u32>(a.x + ((p >> 2u) & 3u) - 1u, a.y);
    return Pair(a, select(vec2<u32>(raw(i, 2u), raw(i, 3u)), near, (p & 3u) == 0u));
}

@compute @workgroup_size(256)
fn test_sums64(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = pair(i);
        sum += emit(i, vec4<u32>(add64(p.a, p.b), sub64(p.a, p.b)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_signs64(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = pair(i);
        sum += emit(i, vec4<u32>(neg64(p.a), abs64(p.a)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_order64(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = pair(i);
        let sign = bitcast<u32>(sgn64(p.a));
        sum += emit(i, vec4<u32>(u32(ltu64(p.a, p.b)), sign, uabs(bitcast<i32>(p.a.x)), clz64(p.a)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_shifts64(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = pair(i);
        sum += emit(i, vec4<u32>(shl64(p.a, p.b.x & 63u), shr64(p.a, p.b.x & 63u)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_umul_wide(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit2(i, umul_wide(raw(i, 0u), raw(i, 1u)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_imul_wide(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit2(i, imul_wide(bitcast<i32>(raw(i, 0u)), bitcast<i32>(raw(i, 1u))));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_mask_dot(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = pair(i);
        sum += emit1(i, mask_dot(p.a, p.b, noise(i, 1u) % 26u));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_hash32(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit1(i, hash32(raw(i, 0u)));
    }
    finish(group.x, sum);
}

// Soft floats and conversions under test: ties, cancellation, subnormal and infinite results.

import package::exact::kernel::{emit1, end_input, finish, first_input, noise, raw};
import package::shared::fixed_point::{f_to_fix, fix_to_f, u64_to_f};
import package::shared::soft_float::{rn_add, rn_div, rn_mul, rn_sqrt};

/// Any two patterns; or the second with an exponent next to the first's, or such that the product or the quotient is
/// next to the subnormals or to infinity; or next to the negated first.
fn float_pair(i: u32) -> vec2<u32> {
    let p = noise(i, 0u);
    let kind = p & 7u;
    let delta = (p >> 3u) & 63u;
    let a = raw(i, 0u);
    let b = raw(i, 1u);
    let ea = (a >> 23u) & 255u;
    var e = ea + delta - 32u;
    e = select(e, 87u - ea + delta, kind == 5u);
    e = select(e, ea + delta + 95u, kind == 6u);
    e = select(e, 350u - ea + delta, kind == 7u);
    let scaled = (b & 0x807fffffu) | ((e & 255u) << 23u);
    let opposite = (a ^ 0x80000000u) + (delta & 7u) - 3u;
    return vec2<u32>(a, select(select(b, scaled, kind > 2u), opposite, kind == 4u));
}

/// Any pattern, an exact square or a rounded one, or one next to those.
fn float_square(i: u32) -> u32 {
    let p = noise(i, 0u);
    let x = raw(i, 0u) & select(0xffffffffu, 0xfffff000u, (p & 2u) != 0u);
    let square = rn_mul(x, x) + ((p >> 2u) & 3u) - 1u;
    return select(raw(i, 0u), square, (p & 1u) != 0u);
}

/// A scale from -64 to 64, in one of two inputs one that brings x near the limits of i32 or of its fraction.
fn scale_of(i: u32, x: u32) -> i32 {
    let p = noise(i, 0u);
    let near = bitcast<i32>(102u - ((x >> 23u) & 255u) + ((p >> 1u) & 63u));
    return select(bitcast<i32>((p >> 1u) % 129u) - 64, clamp(near, -64, 64), (p & 1u) != 0u);
}

/// A scale from -96 to 96.
fn wide_scale(i: u32) -> i32 {
    return bitcast<i32>(noise(i, 0u) % 193u) - 96;
}

/// Any 64 bits; or those whose low word only breaks ties; or 32 bits.
fn wide_value(i: u32) -> vec2<u32> {
    let p = noise(i, 1u);
    let low = select((p >> 1u) & 1u, raw(i, 0u), (p & 1u) != 0u);
    return vec2<u32>(low, select(raw(i, 1u), 0u, (p & 28u) == 0u));
}

@compute @workgroup_size(256)
fn test_rn_add(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = float_pair(i);
        sum += emit1(i, rn_add(p.x, p.y));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_rn_mul(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = float_pair(i);
        sum += emit1(i, rn_mul(p.x, p.y));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_rn_div(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let p = float_pair(i);
        sum += emit1(i, rn_div(p.x, p.y));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_rn_sqrt(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit1(i, rn_sqrt(float_square(i)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_f_to_fix(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let x = raw(i, 0u);
        sum += emit1(i, bitcast<u32>(f_to_fix(x, scale_of(i, x))));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_fix_to_f(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit1(i, fix_to_f(bitcast<i32>(raw(i, 0u)), wide_scale(i)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_u64_to_f(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit1(i, u64_to_f(wide_value(i), wide_scale(i)));
    }
    finish(group.x, sum);
}

// Quotients and roots under test: operands on and next to exact multiples and squares.

import package::exact::kernel::{emit1, emit2, end_input, finish, first_input, noise, raw};
import package::shared::divide::{fdiv64_sat, udiv64_32, udiv64_32i};
import package::shared::fraction::ufrac;
import package::shared::root::{isqrt32, isqrt64};
import package::shared::wide::{add64, neg64, shr64, umul_wide};

struct Quotient {
    n: vec2<u32>,
    d: u32,
}

/// n = q d + r: every dividend of the domain, with the remainders 0, 1 and d - 1 in three of four inputs.
fn quotient(i: u32) -> Quotient {
    let d = max(raw(i, 0u), 1u);
    let kind = noise(i, 0u) & 3u;
    var r = select(0u, d - 1u, kind == 1u);
    r = select(r, min(1u, d - 1u), kind == 2u);
    r = select(r, raw(i, 2u) % d, kind == 3u);
    return Quotient(add64(umul_wide(raw(i, 1u), d), vec2<u32>(r, 0u)), d);
}

/// The same with either sign, or any 64 bits.
fn signed_quotient(i: u32) -> Quotient {
    let p = noise(i, 1u);
    let q = quotient(i);
    let any = vec2<u32>(raw(i, 2u), raw(i, 3u));
    let n = select(q.n, neg64(q.n), (p & 1u) != 0u);
    return Quotient(select(n, any, (p & 6u) == 0u), q.d);
}

struct Fraction {
    n: u32,
    d: u32,
    k: u32,
}

/// n <= d <= 2^30; in one of two inputs n 2^k is next to a multiple of d.
fn fraction(i: u32) -> Fraction {
    let p = noise(i, 0u);
    let d = (raw(i, 0u) & 0x3fffffffu) + 1u;
    let k = (p >> 2u) % 21u;
    let multiple = umul_wide(raw(i, 1u) & ((1u << k) - 1u), d);
    let near = min(shr64(multiple, k).x + ((p >> 1u) & 1u), d);
    return Fraction(select(raw(i, 1u) % (d + 1u), near, (p & 1u) != 0u), d, k);
}

/// Any word, or s s - 1 to s s + 2.
fn square32(i: u32) -> u32 {
    let p = noise(i, 0u);
    let s = raw(i, 0u) >> 16u;
    return select(raw(i, 0u), s * s + ((p >> 1u) & 3u) - 1u, (p & 1u) != 0u);
}

/// Any 64 bits, or s s - 1 to s s + 1.
fn square64(i: u32) -> vec2<u32> {
    let p = noise(i, 0u);
    let square = umul_wide(raw(i, 0u), raw(i, 0u));
    let step = select(vec2<u32>((p >> 2u) & 1u, 0u), vec2<u32>(0xffffffffu), (p & 2u) != 0u);
    return select(vec2<u32>(raw(i, 0u), raw(i, 1u)), add64(square, step), (p & 1u) != 0u);
}

@compute @workgroup_size(256)
fn test_udiv64_32(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let q = quotient(i);
        sum += emit2(i, udiv64_32(q.n, q.d));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_udiv64_32i(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let q = quotient(i);
        sum += emit2(i, udiv64_32i(q.n, q.d));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_fdiv64_sat(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let q = signed_quotient(i);
        sum += emit1(i, bitcast<u32>(fdiv64_sat(q.n, q.d)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_ufrac(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        let f = fraction(i);
        sum += emit2(i, ufrac(f.n, f.d, f.k));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_isqrt32(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit1(i, isqrt32(square32(i)));
    }
    finish(group.x, sum);
}

@compute @workgroup_size(256)
fn test_isqrt64(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    var sum = 0u;
    for (var i = first_input(group.x, lane); i < end_input(group.x); i += 256u) {
        sum += emit1(i, isqrt64(square64(i)));
    }
    finish(group.x, sum);
}

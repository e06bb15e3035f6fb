//! Inputs and answers of `float.wgsl`.

use super::super::oracle::float::{f_to_fix, fix_to_f, rn_add, rn_div, rn_mul, rn_sqrt, u64_to_f};
use super::{Edges, Function, Inputs, join, one};

const fn test(name: &'static str, edges: Edges, answer: fn(&Inputs, u32) -> [u32; 4]) -> Function {
    Function { name, part: "float", edges, answer }
}

pub(super) static ALL: [Function; 7] = [
    test("rn_add", Edges::Floats, |inputs, i| {
        let (a, b) = pair(inputs, i);
        one(rn_add(a, b))
    }),
    test("rn_mul", Edges::Floats, |inputs, i| {
        let (a, b) = pair(inputs, i);
        one(rn_mul(a, b))
    }),
    test("rn_div", Edges::Floats, |inputs, i| {
        let (a, b) = pair(inputs, i);
        one(rn_div(a, b))
    }),
    test("rn_sqrt", Edges::Floats, |inputs, i| {
        let p = inputs.noise(i, 0);
        let x = inputs.raw(i, 0) & if p & 2 != 0 { 0xffff_f000 } else { u32::MAX };
        let near = rn_mul(x, x).wrapping_add(p >> 2 & 3).wrapping_sub(1);
        one(rn_sqrt(if p & 1 != 0 { near } else { inputs.raw(i, 0) }))
    }),
    test("f_to_fix", Edges::Floats, |inputs, i| {
        let p = inputs.noise(i, 0);
        let x = inputs.raw(i, 0);
        let near = 102 - exponent(x) as i32 + (p >> 1 & 63) as i32;
        let k = if p & 1 != 0 { near.clamp(-64, 64) } else { (p >> 1) as i32 % 129 - 64 };
        one(f_to_fix(x, k) as u32)
    }),
    test("fix_to_f", Edges::Integers, |inputs, i| one(fix_to_f(inputs.raw(i, 0) as i32, scale(inputs, i)))),
    test("u64_to_f", Edges::Integers, |inputs, i| {
        let p = inputs.noise(i, 1);
        let low = if p & 1 != 0 { inputs.raw(i, 0) } else { p >> 1 & 1 };
        let high = if p & 28 == 0 { 0 } else { inputs.raw(i, 1) };
        one(u64_to_f(join(low, high), scale(inputs, i)))
    }),
];

fn exponent(x: u32) -> u32 {
    x >> 23 & 255
}

fn scale(inputs: &Inputs, i: u32) -> i32 {
    (inputs.noise(i, 0) % 193) as i32 - 96
}

fn pair(inputs: &Inputs, i: u32) -> (u32, u32) {
    let p = inputs.noise(i, 0);
    let delta = p >> 3 & 63;
    let (a, b) = (inputs.raw(i, 0), inputs.raw(i, 1));
    let e = exponent(a);
    let with_exponent = |e: u32| b & 0x807f_ffff | (e & 255) << 23;
    let b = match p & 7 {
        0..=2 => b,
        3 => with_exponent((e + delta).wrapping_sub(32)),
        4 => (a ^ 1 << 31).wrapping_add(delta & 7).wrapping_sub(3),
        5 => with_exponent((87 + delta).wrapping_sub(e)),
        6 => with_exponent(e + delta + 95),
        _ => with_exponent(350 + delta - e),
    };
    (a, b)
}

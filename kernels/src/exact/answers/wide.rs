//! Inputs and answers of `wide.wgsl`.

use super::super::oracle::wide::{hash32, mask_dot};
use super::{Edges, Function, Inputs, join, one, split, two};

const fn test(name: &'static str, answer: fn(&Inputs, u32) -> [u32; 4]) -> Function {
    Function { name, part: "wide", edges: Edges::Integers, answer }
}

pub(super) static ALL: [Function; 8] = [
    test("sums64", |inputs, i| {
        let (a, b) = pair(inputs, i);
        both(a.wrapping_add(b), a.wrapping_sub(b))
    }),
    test("signs64", |inputs, i| {
        let (a, _) = pair(inputs, i);
        both(a.wrapping_neg(), (a as i64).unsigned_abs())
    }),
    test("order64", |inputs, i| {
        let (a, b) = pair(inputs, i);
        [u32::from(a < b), (a as i64).signum() as u32, (a as i32).unsigned_abs(), a.leading_zeros()]
    }),
    test("shifts64", |inputs, i| {
        let (a, b) = pair(inputs, i);
        both(a << (b % 64), a >> (b % 64))
    }),
    test("umul_wide", |inputs, i| {
        let [low, high] = split(u64::from(inputs.raw(i, 0)) * u64::from(inputs.raw(i, 1)));
        two(low, high)
    }),
    test("imul_wide", |inputs, i| {
        let [low, high] = split((i64::from(inputs.raw(i, 0) as i32) * i64::from(inputs.raw(i, 1) as i32)) as u64);
        two(low, high)
    }),
    test("mask_dot", |inputs, i| {
        let (a, b) = pair(inputs, i);
        one(mask_dot(a, b, inputs.noise(i, 1) % 26))
    }),
    test("hash32", |inputs, i| one(hash32(inputs.raw(i, 0)))),
];

fn both(x: u64, y: u64) -> [u32; 4] {
    let ([a, b], [c, d]) = (split(x), split(y));
    [a, b, c, d]
}

fn pair(inputs: &Inputs, i: u32) -> (u64, u64) {
    let p = inputs.noise(i, 0);
    let (low, high) = (inputs.raw(i, 0), inputs.raw(i, 1));
    let b = match p & 3 {
        0 => join(low.wrapping_add(p >> 2 & 3).wrapping_sub(1), high),
        _ => join(inputs.raw(i, 2), inputs.raw(i, 3)),
    };
    (join(low, high), b)
}

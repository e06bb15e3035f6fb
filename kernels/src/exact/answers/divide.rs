//! Inputs and answers of `divide.wgsl`.

use super::super::oracle::divide::{fdiv64_sat, isqrt32, isqrt64, udiv64_32, ufrac};
use super::{Edges, Function, Inputs, join, one, two};

const fn test(name: &'static str, answer: fn(&Inputs, u32) -> [u32; 4]) -> Function {
    Function { name, part: "divide", edges: Edges::Integers, answer }
}

pub(super) static ALL: [Function; 6] = [
    test("udiv64_32", divided),
    test("udiv64_32i", divided),
    test("fdiv64_sat", |inputs, i| {
        let p = inputs.noise(i, 1);
        let (n, d) = quotient(inputs, i);
        let n = match p {
            _ if p & 6 == 0 => join(inputs.raw(i, 2), inputs.raw(i, 3)),
            _ if p & 1 != 0 => n.wrapping_neg(),
            _ => n,
        };
        one(fdiv64_sat(n as i64, d) as u32)
    }),
    test("ufrac", |inputs, i| {
        let p = inputs.noise(i, 0);
        let d = inputs.raw(i, 0) % (1 << 30) + 1;
        let k = (p >> 2) % 21;
        let multiple = u64::from(inputs.raw(i, 1) % (1 << k)) * u64::from(d);
        let near = ((multiple >> k) as u32 + (p >> 1 & 1)).min(d);
        let n = if p & 1 != 0 { near } else { inputs.raw(i, 1) % (d + 1) };
        let (q, r) = ufrac(n, d, k);
        two(q, r)
    }),
    test("isqrt32", |inputs, i| {
        let p = inputs.noise(i, 0);
        let s = inputs.raw(i, 0) >> 16;
        let near = (s * s).wrapping_add(p >> 1 & 3).wrapping_sub(1);
        one(isqrt32(if p & 1 != 0 { near } else { inputs.raw(i, 0) }))
    }),
    test("isqrt64", |inputs, i| {
        let p = inputs.noise(i, 0);
        let s = u64::from(inputs.raw(i, 0));
        let near = if p & 2 != 0 { (s * s).wrapping_sub(1) } else { s * s + u64::from(p >> 2 & 1) };
        one(isqrt64(if p & 1 != 0 { near } else { join(inputs.raw(i, 0), inputs.raw(i, 1)) }))
    }),
];

fn divided(inputs: &Inputs, i: u32) -> [u32; 4] {
    let (n, d) = quotient(inputs, i);
    let (q, r) = udiv64_32(n, d);
    two(q, r)
}

fn quotient(inputs: &Inputs, i: u32) -> (u64, u32) {
    let d = inputs.raw(i, 0).max(1);
    let r = match inputs.noise(i, 0) & 3 {
        0 => 0,
        1 => d - 1,
        2 => 1.min(d - 1),
        _ => inputs.raw(i, 2) % d,
    };
    (u64::from(inputs.raw(i, 1)) * u64::from(d) + u64::from(r), d)
}

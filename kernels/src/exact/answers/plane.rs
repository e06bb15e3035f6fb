//! Inputs and answers of `plane.wgsl`.

use super::super::oracle::plane::{Point, depth_at, edge15, influence_1d, orient2d};
use super::{Edges, Function, Inputs, one, two};

const fn test(name: &'static str, answer: fn(&Inputs, u32) -> [u32; 4]) -> Function {
    Function { name, part: "plane", edges: Edges::Integers, answer }
}

pub(super) static ALL: [Function; 4] = [
    test("orient2d", |inputs, i| {
        let [a, b, c] = triple(inputs, i);
        two(orient2d(a, b, c) as u32, orient2d(b, a, c) as u32)
    }),
    test("edge15", |inputs, i| {
        let [a, b, c] = triple15(inputs, i);
        two(edge15(a, b, c) as u32, edge15(b, a, c) as u32)
    }),
    test("depth_at", |inputs, i| {
        let p = inputs.noise(i, 0);
        let z = [3, 4, 5].map(|k| inputs.raw(i, k) % (1 << 24));
        let near = [z[0], z[0], z[0].wrapping_add(p >> 1 & 3).wrapping_sub(1) % (1 << 24)];
        let third = if p & 8 != 0 { 1 } else { inputs.raw(i, 2) >> 2 };
        let w = [inputs.raw(i, 0) >> 1, inputs.raw(i, 1) >> 2, third.max(1)];
        one(depth_at(w, if p & 1 != 0 { near } else { z }, w.iter().sum()))
    }),
    test("influence_1d", |inputs, i| {
        let p = inputs.noise(i, 0);
        let hz = (inputs.raw(i, 1) % (1 << 15)).max(1);
        let vz = 1 + inputs.raw(i, 2) % hz;
        let t = (p >> 2) % 17;
        let v = signed15(inputs.raw(i, 0));
        let whole = v >> t << t;
        let near = p & 3 == 0 && whole > -0x8000;
        let (v, s) = if near { (whole, whole) } else { (v, signed15(inputs.raw(i, 3))) };
        let [first, last] = influence_1d(v, vz as i32, hz as i32, s, t);
        two(first as u32, last as u32)
    }),
];

fn signed15(x: u32) -> i32 {
    ((x & 0xffff) as i32 - 0x8000).max(-0x7fff)
}

fn triple(inputs: &Inputs, i: u32) -> [Point; 3] {
    let (p, q) = (inputs.noise(i, 0), inputs.noise(i, 1));
    let word = |k| inputs.raw(i, k) as i32;
    let at = |k| [word(k) >> 1, word(k + 1) >> 1];
    if p & 3 == 0 {
        return [at(0), at(2), at(4)];
    }
    let off = |shift: u32| if p & 64 != 0 { (p >> shift & 3) as i32 - 1 } else { 0 };
    let along = |steps: u32, e: [i32; 2]| {
        [0, 1].map(|axis| (word(axis) >> 2) + (word(2 + axis) >> 17) * (steps & 0x3fff) as i32 + e[axis as usize])
    };
    [along(0, [0, 0]), along(q, [0, 0]), along(q >> 14, [off(2), off(4)])]
}

fn triple15(inputs: &Inputs, i: u32) -> [Point; 3] {
    let p = inputs.noise(i, 0);
    let word = |k| inputs.raw(i, k) & 0x7fff;
    let mirror = |axis: u32| (p >> (16 + axis) & 1) * 0x7fff;
    let along = |steps: u32, e: u32| {
        [0, 1].map(|axis| (word(axis) >> 1) + (word(2 + axis) & 127) * steps + if axis == 0 { e } else { 0 })
    };
    let points = match p & 1 {
        0 => [0, 2, 4].map(|k| [word(k), word(k + 1)]),
        _ => [along(0, 0), along(p >> 1 & 127, 0), along(p >> 8 & 127, p >> 15 & 1)],
    };
    points.map(|[x, y]| [(x ^ mirror(0)) as i32, (y ^ mirror(1)) as i32])
}

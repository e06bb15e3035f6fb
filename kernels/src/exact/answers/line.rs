//! Inputs and answers of `line.wgsl`.

use super::super::oracle::line::{self, Line, NONE};
use super::{Edges, Function, Inputs, join, split, two};

const fn test(name: &'static str, answer: fn(&Inputs, u32) -> [u32; 4]) -> Function {
    Function { name, part: "line", edges: Edges::Integers, answer }
}

pub(super) static ALL: [Function; 4] = [
    test("edge_line", |inputs, i| {
        let p = inputs.noise(i, 0);
        let sliver = p & 3 == 0;
        let point = |k: u32, flips: u32| {
            let at = |axis: u32| ((inputs.raw(i, k + axis) ^ flips >> axis & 1) & 0x7fff) as i32;
            [at(0) - 0x4000, at(1) - 0x4000, at(2)]
        };
        let second = if sliver { point(3, p >> 2) } else { point(6, 0) };
        let Line { a, b, c } = line::edge_line(point(0, 0), point(3, 0), second);
        let [low, high] = split(c as u64);
        [a as u32, b as u32, low, high]
    }),
    test("half_plane", |inputs, i| {
        let p = inputs.noise(i, 0);
        let (a, b) = (coefficient(inputs.raw(i, 0)), coefficient(inputs.raw(i, 1)));
        let (u, v) = (inputs.raw(i, 2) as i32 >> 1, inputs.raw(i, 3) as i32 >> 1);
        let near = small(p >> 2) - i64::from(a) * i64::from(u) - i64::from(b) * i64::from(v);
        let any = join(inputs.raw(i, 4), inputs.raw(i, 5)) as i64;
        // The high word is halved, so that the value at the sample has 64 bits.
        let any = any >> 33 << 32 | any & 0xffff_ffff;
        let line = Line { a, b, c: if p & 3 == 0 { any } else { near } };
        two(line::half_plane(line, u, v).into(), line::half_plane(line.negated(), u, v).into())
    }),
    test("line_cell", |inputs, i| {
        let (line, h, k) = lookup(inputs, i, 0);
        two(line::line_cell(line, h, k), line::line_cell(line.negated(), h, k))
    }),
    test("line_cell_fast", |inputs, i| {
        let (line, h, k) = lookup(inputs, i, 1);
        let near = displaced(line::line_cell(line, h, k), k, inputs.noise(i, 2));
        // Whichever cell the device takes, it says itself that it may; on a cell known here it must say what is true.
        two(1, line::admissible(line, h, k, near).into())
    }),
];

/// Any word but -2^31.
fn coefficient(x: u32) -> i32 {
    (x as i32).max(-i32::MAX)
}

/// -1, 0, 1 or 2.
fn small(p: u32) -> i64 {
    i64::from(p & 3) - 1
}

fn lookup(inputs: &Inputs, i: u32, shift: u32) -> (Line, u32, u32) {
    let (p, q) = (inputs.noise(i, 0), inputs.noise(i, 1));
    let (h, k) = (q % 16, (q >> 8) % 15);
    let (a, b) = (coefficient(inputs.raw(i, 0)) >> shift, coefficient(inputs.raw(i, 1)) >> shift);
    let norm = u64::from(a.unsigned_abs() + b.unsigned_abs());
    let c = match p & 3 {
        0 => join(inputs.raw(i, 2), inputs.raw(i, 3)) as i64,
        _ => ((norm * u64::from(inputs.raw(i, 2))) >> (32 - h)) as i64 + small(p >> 2),
    };
    (Line { a, b, c: if p & 16 != 0 { c.wrapping_neg() } else { c } }, h, k)
}

fn displaced(cell: u32, k: u32, p: u32) -> u32 {
    if cell >= NONE {
        return cell ^ p & 1;
    }
    let field = |shift: u32, bits: u32, p: u32| (cell >> shift).wrapping_add(p & 3).wrapping_sub(1) % (1 << bits);
    cell >> (2 * k + 1) << (2 * k + 1) | field(k + 1, k, p >> 2) << (k + 1) | field(0, k + 1, p)
}

//! Every vector form of every operation, on every SIMD level of the machine, against the scalar semantics.

use std::cell::Cell;

use fearless_simd::{Level, dispatch};

use super::alu;
use super::compare::passing;
use super::fused;
use super::mask::{CHUNK, Exec, Mask};
use super::rows::{Chunk, Rows};
use crate::Simd;
use crate::code::{BinOp, Compare, Pair, QuadOp, Reg, TernOp, Test, UnOp};
use crate::semantics;

/// Words at which operations change their behaviour.
const EDGES: &[u32] = &[
    0,
    1,
    2,
    3,
    5,
    7,
    31,
    32,
    33,
    63,
    127,
    255,
    0xffff,
    0x10000,
    0x007f_ffff,
    0x0080_0000,
    0x0080_0001,
    0x3eff_ffff,
    0x3f00_0000,
    0x3f7f_ffff,
    0x3f80_0000,
    0x3fc0_0000,
    0x4020_0000,
    0x40a0_0000,
    0x42fe_0000,
    0x477f_e000,
    0x4780_0000,
    0x4b00_0000,
    0x4b7f_ffff,
    0x4eff_ffff,
    0x4f00_0000,
    0x4f7f_ffff,
    0x4f80_0000,
    0x7f7f_ffff,
    0x7f80_0000,
    0x7fc0_0000,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_0001,
    0x8080_0000,
    0xbf00_0000,
    0xbf80_0000,
    0xc020_0000,
    0xcf00_0000,
    0xff7f_ffff,
    0xff80_0000,
    0xffff_fffe,
    0xffff_ffff,
];

/// A block, and some chunks more.
const CHUNKS: usize = 6;
const LANES: usize = CHUNKS * CHUNK;

fn word(seed: u32) -> u32 {
    let mixed = (seed ^ seed >> 16).wrapping_mul(0x45d9_f3b5);
    let mixed = (mixed ^ mixed >> 15).wrapping_mul(0x2c1b_3c6d);
    mixed ^ mixed >> 13
}

/// Rows of operands: edge words against each other, then words without pattern.
fn operands() -> Vec<[[u32; LANES]; 3]> {
    let pairs: Vec<(u32, u32)> = EDGES.iter().flat_map(|a| EDGES.iter().map(move |b| (*a, *b))).collect();
    let mut rows = Vec::new();
    for run in pairs.chunks(LANES) {
        let at = |lane: usize| run[lane % run.len()];
        let third = |lane: usize| EDGES[(lane * 7 + rows.len()) % EDGES.len()];
        rows.push([std::array::from_fn(|l| at(l).0), std::array::from_fn(|l| at(l).1), std::array::from_fn(third)]);
    }
    for seed in 0..16 {
        rows.push(std::array::from_fn(|row| std::array::from_fn(|lane| word(seed << 16 | (row << 8 | lane) as u32))));
    }
    rows
}

struct Files {
    vectors: Vec<Chunk>,
    scalars: Vec<u32>,
}

impl Files {
    /// Operands in registers 1 to 3 of both files, what is left over in vector register 0.
    fn new(rows: &[[u32; LANES]; 3]) -> Self {
        let mut vectors = vec![Chunk([0x5555_5555; CHUNK]); CHUNKS];
        for row in rows {
            vectors.extend(row.as_chunks().0.iter().map(|chunk| Chunk(*chunk)));
        }
        Files { vectors, scalars: vec![0, rows[0][0], rows[1][0], rows[2][0]] }
    }

    fn run(&mut self, f: impl FnOnce(&Rows<'_>)) -> Vec<u32> {
        f(&Rows {
            vectors: Cell::from_mut(&mut self.vectors[..]).as_slice_of_cells(),
            scalars: Cell::from_mut(&mut self.scalars[..]).as_slice_of_cells(),
            chunks: CHUNKS,
            low: 0,
            high: CHUNKS,
        });
        self.vectors[..CHUNKS].iter().flat_map(|chunk| chunk.0).collect()
    }
}

fn levels() -> Vec<(Simd, Level)> {
    Simd::available().into_iter().filter_map(|simd| Some((simd, simd.level()?))).collect()
}

fn register(index: u16, scalar: bool) -> Reg {
    if scalar { Reg::scalar(index) } else { Reg::vector(index) }
}

/// Equal bits, or two NaNs: the payload of a NaN is the host's.
fn same(a: u32, b: u32) -> bool {
    a == b || f32::from_bits(a).is_nan() && f32::from_bits(b).is_nan()
}

fn compare(what: &str, got: &[u32], want: impl Fn(usize) -> (u32, String)) {
    for (lane, got) in got.iter().enumerate() {
        let (want, operands) = want(lane);
        assert!(same(*got, want), "{what} of {operands}: {got:#010x}, not {want:#010x}");
    }
}

#[test]
fn unary_operations_agree_on_every_level() {
    for (simd, level) in levels() {
        for rows in operands() {
            for op in UnOp::ALL {
                for scalar in [false, true] {
                    let a = register(1, scalar);
                    let got =
                        Files::new(&rows).run(|r| dispatch!(level, s => alu::unary(s, r, *op, Reg::vector(0), a)));
                    compare(&format!("{op:?} on {}", simd.name()), &got, |lane| {
                        let a = rows[0][if scalar { 0 } else { lane }];
                        (semantics::unary(*op, a), format!("{a:#010x}"))
                    });
                }
            }
        }
    }
}

#[test]
fn binary_operations_agree_on_every_level() {
    for (simd, level) in levels() {
        for rows in operands() {
            for op in BinOp::ALL {
                for form in 0..4 {
                    let (a, b) = (register(1, form & 1 != 0), register(2, form & 2 != 0));
                    let got =
                        Files::new(&rows).run(|r| dispatch!(level, s => alu::binary(s, r, *op, Reg::vector(0), a, b)));
                    compare(&format!("{op:?} on {}", simd.name()), &got, |lane| {
                        let a = rows[0][if a.is_scalar() { 0 } else { lane }];
                        let b = rows[1][if b.is_scalar() { 0 } else { lane }];
                        (semantics::binary(*op, a, b), format!("{a:#010x}, {b:#010x}"))
                    });
                }
            }
        }
    }
}

#[test]
fn ternary_operations_agree_on_every_level() {
    for (simd, level) in levels() {
        for rows in operands() {
            for op in [TernOp::Select, TernOp::Fma] {
                for form in 0..8u16 {
                    let args: [Reg; 3] = std::array::from_fn(|i| register(i as u16 + 1, form >> i & 1 != 0));
                    let got =
                        Files::new(&rows).run(|r| dispatch!(level, s => alu::ternary(s, r, op, Reg::vector(0), args)));
                    compare(&format!("{op:?} on {}", simd.name()), &got, |lane| {
                        let x: [u32; 3] = std::array::from_fn(|i| rows[i][if args[i].is_scalar() { 0 } else { lane }]);
                        (semantics::ternary(op, x[0], x[1], x[2]), format!("{x:x?}"))
                    });
                }
            }
        }
    }
}

#[test]
fn pairs_agree_on_every_level() {
    for (simd, level) in levels() {
        for rows in operands() {
            for op in Pair::ALL {
                let words = op.parts().map_or([true, true], |parts| parts.words);
                let args = [register(1, false), register(2, words[0]), register(3, words[1])];
                let got =
                    Files::new(&rows).run(|r| dispatch!(level, s => fused::pair(s, r, *op, Reg::vector(0), args)));
                compare(&format!("{op:?} on {}", simd.name()), &got, |lane| {
                    let x: [u32; 3] = std::array::from_fn(|i| rows[i][if args[i].is_scalar() { 0 } else { lane }]);
                    (semantics::pair(*op, x[0], x[1], x[2]), format!("{x:x?}"))
                });
            }
        }
    }
}

#[test]
fn quads_and_mixes_agree_on_every_level() {
    for (simd, level) in levels() {
        for rows in operands() {
            for op in QuadOp::ALL {
                for (form, places) in
                    [0, 2, 8, 10].into_iter().flat_map(|form| [[0, 1, 2, 1], [1, 0, 0, 2]].map(|p| (form, p)))
                {
                    let args: [Reg; 4] = std::array::from_fn(|i| register(places[i] as u16 + 1, form >> i & 1 != 0));
                    let got =
                        Files::new(&rows).run(|r| dispatch!(level, s => fused::quad(s, r, *op, Reg::vector(0), args)));
                    compare(&format!("{op:?} on {}", simd.name()), &got, |lane| {
                        let x = std::array::from_fn(|i| rows[places[i]][if args[i].is_scalar() { 0 } else { lane }]);
                        (semantics::quad(*op, x), format!("{x:x?}"))
                    });
                }
            }
            let by: [Reg; 5] = [2, 3, 1, 2, 3].map(Reg::scalar);
            let got =
                Files::new(&rows).run(|r| dispatch!(level, s => fused::mix(s, r, Reg::vector(0), Reg::vector(1), by)));
            compare(&format!("mix on {}", simd.name()), &got, |lane| {
                let words = by.map(|r| rows[r.index() - 1][0]);
                (semantics::mix(rows[0][lane], words), format!("{:#x} by {words:x?}", rows[0][lane]))
            });
        }
    }
}

#[test]
fn inverse_square_roots_agree_for_every_significand() {
    for (simd, level) in levels() {
        // Scaling by 4 halves the result: two binades stand for all.
        for first in (0x3f80_0000..0x4080_0000u32).step_by(LANES) {
            let row: [u32; LANES] = std::array::from_fn(|lane| first + lane as u32);
            let got = Files::new(&[row; 3])
                .run(|r| dispatch!(level, s => alu::unary(s, r, UnOp::InverseSqrt, Reg::vector(0), Reg::vector(1))));
            compare(&format!("inverse square root on {}", simd.name()), &got, |lane| {
                (semantics::unary(UnOp::InverseSqrt, row[lane]), format!("{:#x}", row[lane]))
            });
        }
    }
}

#[test]
fn choices_agree_on_every_level() {
    for (simd, level) in levels() {
        for rows in operands() {
            for op in Compare::ALL {
                for form in 0..8u16 {
                    let [b, accept, reject] = [2, 3, 1].map(|i| register(i, form >> (i - 1) & 1 != 0));
                    let (test, dst) = (Test { op: *op, a: register(1, false), b }, Reg::vector(0));
                    let got = Files::new(&rows)
                        .run(|r| dispatch!(level, s => fused::choose(s, r, test, dst, [accept, reject])));
                    compare(&format!("choice by {op:?} on {}", simd.name()), &got, |lane| {
                        let word = |r: Reg| rows[r.index() - 1][if r.is_scalar() { 0 } else { lane }];
                        let holds = semantics::compare(*op, word(test.a), word(b));
                        let operands = format!("{:#x}, {:#x}", word(test.a), word(b));
                        (if holds { word(accept) } else { word(reject) }, operands)
                    });
                }
            }
        }
    }
}

#[test]
fn switches_agree_on_every_level() {
    for (simd, level) in levels() {
        for rows in operands() {
            for form in 0..8u16 {
                let arms: [Reg; 3] = std::array::from_fn(|i| register(3 - i as u16, form >> i & 1 != 0));
                // The second word is met by the first lane, the third by few.
                for words in [[2, 1], [1, 1], [3, 2]].map(|words| words.map(Reg::scalar)) {
                    let got = Files::new(&rows).run(
                        |r| dispatch!(level, s => fused::switch(s, r, Reg::vector(0), Reg::vector(1), words, arms)),
                    );
                    compare(&format!("switch on {}", simd.name()), &got, |lane| {
                        let word = |r: Reg| rows[r.index() - 1][if r.is_scalar() { 0 } else { lane }];
                        let arm = words.iter().position(|r| word(*r) == rows[0][lane]).unwrap_or(2);
                        (word(arms[arm]), format!("{:#x}, {:#x?}", rows[0][lane], words.map(word)))
                    });
                }
            }
        }
    }
}

#[test]
fn masked_operations_agree_on_every_level() {
    let rows = &operands()[0];
    let mut exec = Exec::new(LANES);
    exec.set(Mask::first(LANES - 3).and_not(Mask::first(21)));
    for (_, level) in levels() {
        let got = Files::new(rows).run(|r| {
            let r = &Rows { low: exec.low, high: exec.high, ..*r };
            dispatch!(level, s => alu::blend(s, r, &exec, Reg::vector(0), Reg::vector(1)));
        });
        let want = |lane| if exec.mask.has(lane) { rows[0][lane] } else { 0x5555_5555 };
        compare("blend", &got, |lane| (want(lane), format!("lane {lane}")));

        let length = 64;
        let mut wrong = None;
        let got = Files::new(rows)
            .run(|r| wrong = dispatch!(level, s => alu::check(s, r, &exec, Reg::vector(0), Reg::vector(1), length)));
        compare("check", &got, |lane| (rows[0][lane].min(length - 1), format!("lane {lane}")));
        let first = (0..LANES).find(|lane| exec.mask.has(*lane) && rows[0][*lane] >= length);
        assert_eq!(wrong, first.map(|lane| (lane, rows[0][lane])));
    }
}

#[test]
fn tests_agree_on_every_level() {
    let mut exec = Exec::new(LANES);
    exec.set(Mask::first(LANES - 3).and_not(Mask::first(20)));
    for (simd, level) in levels() {
        for rows in operands() {
            for op in Compare::ALL {
                for form in 0..4 {
                    let test = Test { op: *op, a: register(1, form & 1 != 0), b: register(2, form & 2 != 0) };
                    let mut masks = [Mask::default(); 2];
                    for (mask, test) in masks.iter_mut().zip([test, test.negated()]) {
                        Files::new(&rows).run(|r| {
                            let r = &Rows { low: exec.low, high: exec.high, ..*r };
                            *mask = dispatch!(level, s => passing(s, r, &exec, test));
                        });
                    }
                    for lane in 0..LANES {
                        let a = rows[0][if test.a.is_scalar() { 0 } else { lane }];
                        let b = rows[1][if test.b.is_scalar() { 0 } else { lane }];
                        let (active, holds) = (exec.mask.has(lane), semantics::compare(*op, a, b));
                        let want = [active && holds, active && !holds];
                        let got = masks.map(|mask| mask.has(lane));
                        assert_eq!(got, want, "{op:?} on {} of {a:#010x}, {b:#010x}", simd.name());
                    }
                }
            }
        }
    }
}

#[test]
fn addresses_are_surveyed() {
    let counting: [u32; LANES] = std::array::from_fn(|lane| 0xffff_fff0u32.wrapping_add(lane as u32));
    let mut broken = counting;
    broken[LANES - 1] = 0;
    for (_, level) in levels() {
        for (row, want) in [(counting, Some(counting[0])), (broken, None)] {
            let mut got = None;
            Files::new(&[row; 3]).run(|r| got = dispatch!(level, s => alu::survey(s, r, Reg::vector(1), 0, 9)).0);
            assert_eq!(got, want);
        }
        let below: [u32; LANES] = std::array::from_fn(|lane| 99 - lane as u32);
        for (offset, limit, want) in
            [(0, 100, true), (0, 99, false), (7, 107, true), (7, 106, false), (u32::MAX - 20, 60, false), (0, 0, false)]
        {
            let mut inside = None;
            Files::new(&[below; 3])
                .run(|r| inside = Some(dispatch!(level, s => alu::survey(s, r, Reg::vector(1), offset, limit)).1));
            assert_eq!(inside, Some(want), "{offset}, {limit}");
        }
    }
}

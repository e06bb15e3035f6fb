//! Inputs and answers of `angle.wgsl`.

use super::super::oracle::angle::{atan2_bam, diamond_angle, normalize3_q15, oct_dir};
use super::{Edges, Function, Inputs, one};

const fn test(name: &'static str, answer: fn(&Inputs, u32) -> [u32; 4]) -> Function {
    Function { name, part: "angle", edges: Edges::Integers, answer }
}

pub(super) static ALL: [Function; 4] = [
    test("atan2_bam", |inputs, i| {
        let p = inputs.noise(i, 0);
        let m = inputs.raw(i, 1) >> 4;
        let [x, y] = match p & 3 {
            0 => [5 * m, (2 * m).wrapping_add(p >> 2 & 3).wrapping_sub(1)],
            _ => [inputs.raw(i, 0), inputs.raw(i, 1)],
        };
        one(atan2_bam(y as i32, x as i32))
    }),
    test("diamond_angle", |inputs, i| {
        let p = inputs.noise(i, 0);
        let [x, y] = match p & 1 {
            0 => [0, 1].map(|k| inputs.raw(i, k) as i32 >> 2),
            _ => {
                let d = inputs.raw(i, 0) >> 3;
                let y = ((u64::from(d) * u64::from(inputs.raw(i, 1) % (1 << 20))) >> 20) as i32 + (p >> 1 & 1) as i32;
                [d as i32 - y, y]
            }
        };
        one(diamond_angle(y, x))
    }),
    test("normalize3_q15", |inputs, i| {
        let v = [0, 1, 2].map(|k| (inputs.raw(i, k) % 65_537) as i32 - 32_768);
        let near = inputs.noise(i, 0) & 3 == 0;
        let v = if near { [v[0], v[1] >> 13, v[2] >> 13] } else { v };
        signed(normalize3_q15(if v == [0; 3] { [0, 0, 1] } else { v }))
    }),
    test("oct_dir", |inputs, i| {
        let p = inputs.noise(i, 0);
        let n = (inputs.raw(i, 0) % (1 << 29)).max(1) as i32;
        let side = 2 * n as u32 + 1;
        let x = (inputs.raw(i, 1) % side) as i32;
        let rest = n - (x - n).abs() + (p >> 1 & 1) as i32;
        let y = (if p & 4 != 0 { n - rest } else { n + rest }).clamp(0, 2 * n);
        signed(oct_dir(x, if p & 1 != 0 { y } else { (inputs.raw(i, 2) % side) as i32 }, n))
    }),
];

fn signed([x, y, z]: [i32; 3]) -> [u32; 4] {
    [x as u32, y as u32, z as u32, 0]
}

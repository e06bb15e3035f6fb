//! Four micro-kernels, each laying one cost bare, with the same computation in plain Rust beside it.
//!
//! They make no promise of equal bits on other machines (their WGSL is not linted), so the native functions state what
//! the outputs must be. Invariant: [`INVOCATIONS`] invocations, one output word each.

use sightlines_backend::{Job, Linked, Program, Result};

/// Invocations of every micro-kernel.
pub const INVOCATIONS: u32 = 1 << 16;

/// Invocations of one workgroup of the reduction.
const WIDTH: u32 = 256;

/// One micro-kernel.
pub struct Micro {
    /// Name of its file in `micro/`.
    pub name: &'static str,
    /// Whether every machine must give the native words; a driver may rewrite the f32 of those that are not.
    pub portable: bool,
    /// The same computation in Rust: every output word.
    pub native: fn() -> Vec<u32>,
    wgsl: &'static str,
    workgroup: u32,
    table: Option<fn() -> Vec<u32>>,
}

/// All four.
pub static ALL: [Micro; 4] = [
    Micro {
        name: "arithmetic",
        portable: true,
        native: || (0..INVOCATIONS).map(arithmetic).collect(),
        wgsl: include_str!("../micro/arithmetic.wgsl"),
        workgroup: 64,
        table: None,
    },
    Micro {
        name: "mandelbrot",
        portable: false,
        native: || (0..INVOCATIONS).map(mandelbrot).collect(),
        wgsl: include_str!("../micro/mandelbrot.wgsl"),
        workgroup: 64,
        table: None,
    },
    Micro {
        name: "gather",
        portable: true,
        native: gather,
        wgsl: include_str!("../micro/gather.wgsl"),
        workgroup: 64,
        table: Some(table),
    },
    Micro {
        name: "reduction",
        portable: true,
        native: || (0..INVOCATIONS / WIDTH).flat_map(reduction).collect(),
        wgsl: include_str!("../micro/reduction.wgsl"),
        workgroup: WIDTH,
        table: None,
    },
];

impl Micro {
    /// The work: one dispatch, one output.
    pub fn job(&self) -> Result<Job> {
        let linked = Linked::single(&format!("micro/{}.wgsl", self.name), self.wgsl)?;
        let mut job = Job::new();
        let program = job.program(&Program::unlinted(self.name, linked)?);
        let results = job.buffer("results", 4 * u64::from(INVOCATIONS));
        let mut bound = vec![(0, results)];
        if let Some(table) = self.table {
            bound.push((1, job.upload("table", &table())));
        }
        job.dispatch(program, "main", &bound, [INVOCATIONS / self.workgroup, 1, 1]);
        job.read("results", results);
        Ok(job)
    }
}

fn arithmetic(id: u32) -> u32 {
    let (mut bits, mut value) = (id, id as f32);
    for _ in 0..64 {
        bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        bits ^= bits >> 13;
        value *= 0.9995117;
        value += 0.5;
    }
    bits ^ value.to_bits()
}

fn mandelbrot(id: u32) -> u32 {
    let cx = (id % 256) as f32 * 0.0109375 - 2.2;
    let cy = (id / 256) as f32 * 0.009375 - 1.2;
    let (mut x, mut y) = (0.0_f32, 0.0_f32);
    for count in 0..256 {
        let (xx, yy, xy) = (x * x, y * y, x * y);
        if xx + yy > 4.0 {
            return count;
        }
        (x, y) = (xx - yy + cx, xy + xy + cy);
    }
    256
}

/// Random words below 2^16.
fn table() -> Vec<u32> {
    (0..INVOCATIONS).map(|i| sightlines_kernels::random::word(20, i) >> 16).collect()
}

fn gather() -> Vec<u32> {
    let table = table();
    let chain = |id: u32| (0..64).fold(id, |at, _| (table[at as usize] + id) & 0xffff);
    (0..INVOCATIONS).map(chain).collect()
}

/// One workgroup's words. Every round adds the sum of all to three times each.
fn reduction(group: u32) -> Vec<u32> {
    let mut values: Vec<u32> = (group * WIDTH..(group + 1) * WIDTH).collect();
    for _ in 0..8 {
        let sum = values.iter().fold(0_u32, |sum, value| sum.wrapping_add(*value));
        values.iter_mut().for_each(|value| *value = value.wrapping_mul(3).wrapping_add(sum));
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_divergent_kernel_diverges_as_stated() {
        let counts = (0..INVOCATIONS).map(mandelbrot).collect::<Vec<_>>();
        let mean = counts.iter().sum::<u32>() as f64 / f64::from(INVOCATIONS);
        assert!((50.0..65.0).contains(&mean), "mean {mean}");
        assert!(counts.contains(&256) && counts.iter().any(|count| *count < 3));
    }
}

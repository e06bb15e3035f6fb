//! Any logical operation on two or three masks by look-ups in a table of bytes, for machines without an integer unit.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 5, equation 4. `kernel.wgsl` states the
//! output exactly. Every machine of today has the operations themselves; this kernel is the checked equivalent, and
//! shows that the AND of half-planes and the OR of triangles are all that a mask needs.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "op_map",
    summary: "logical operations on two or three masks by a table of bytes",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, section 5, equation 4",
    programs: || Ok(vec![OpMap::new()?.program]),
    cases: cases::all,
};

/// Words of a table for `operands` masks, two or three: a byte for any bytes of theirs.
pub const fn table_words(operands: usize) -> u32 {
    1 << (8 * operands - 2)
}

/// Invocations a workgroup.
const GROUP: u32 = 256;

/// An operation on three bits: bit x + 2y + 4z is its result for bits x, y and z; of two bits, z is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Truth(pub u8);

impl Truth {
    /// All three: half-planes to a triangle.
    pub const AND: Truth = Truth(0b1000_0000);
    /// Any of the three, or of the first two: triangles to a hidden set.
    pub const OR: Truth = Truth(0b1111_1110);
}

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Words of masks to combine, or of a table to build.
        pub words: u32,
        /// The operation's truth table.
        pub truth: u32,
        /// Word of the first invocation.
        pub first: u32,
    }
}

bindings! {
    /// What `build` is given.
    pub struct Build {
        uniform params @ 0: Params,
        write table @ 1: [u32],
    }

    /// What `combine_two` is given.
    pub struct CombineTwo {
        uniform params @ 0: Params,
        read op_map @ 2: [u32],
        read a @ 3: [u32],
        read b @ 4: [u32],
        write combined @ 6: [u32],
    }

    /// What `combine_three` is given.
    pub struct CombineThree {
        uniform params @ 0: Params,
        read op_map @ 2: [u32],
        read a @ 3: [u32],
        read b @ 4: [u32],
        read c @ 5: [u32],
        write combined @ 6: [u32],
    }
}

/// The compiled kernel.
pub struct OpMap {
    program: Arc<Program>,
}

impl OpMap {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("op_map", "", &[])?;
        Build::check(&program, "build")?;
        CombineTwo::check(&program, "combine_two")?;
        CombineThree::check(&program, "combine_three")?;
        Ok(OpMap { program })
    }

    /// The table of an operation on `operands` masks, two or three, of [`table_words`].
    pub fn table(&self, job: &mut Job, operation: Truth, operands: usize) -> Buffer<[u32]> {
        let words = table_words(operands);
        let table = job.zeroed("op map", u64::from(words));
        let program = job.program(&self.program);
        pieces::record(job, words / GROUP, u64::from(GROUP), |job, piece| {
            let params = Params { words, truth: u32::from(operation.0), first: piece.start * GROUP };
            let params = job.value("op map params", &params);
            job.launch(program, "build", &Build { params, table }, [piece.len() as u32, 1, 1]);
        });
        table
    }

    /// Combines the words of two or three masks, by the table for as many, all of one length; `combined` must not
    /// overlap them.
    pub fn record(
        &self,
        job: &mut Job,
        op_map: Buffer<[u32]>,
        masks: &[Buffer<[u32]>],
        combined: Buffer<[u32]>,
    ) -> Result<()> {
        let words = u32::try_from(combined.len()).ok().filter(|_| masks.iter().all(|m| m.len() == combined.len()));
        let fits = (2..=3).contains(&masks.len()) && op_map.len() == u64::from(table_words(masks.len()));
        let Some(words) = words.filter(|_| fits) else {
            let lengths: Vec<u64> = masks.iter().chain([&combined]).map(|mask| mask.len()).collect();
            let what = format!("masks of {lengths:?} words by a table of {}", op_map.len());
            return Err(Error::refused(what, "give two or three masks and a result of one length, and their table"));
        };
        let program = job.program(&self.program);
        pieces::record(job, words.div_ceil(GROUP), u64::from(8 * GROUP), |job, piece| {
            let params = job.value("op map params", &Params { words, truth: 0, first: piece.start * GROUP });
            let groups = [piece.len() as u32, 1, 1];
            match *masks {
                [a, b] => job.launch(program, "combine_two", &CombineTwo { params, op_map, a, b, combined }, groups),
                [a, b, c, ..] => {
                    let bound = CombineThree { params, op_map, a, b, c, combined };
                    job.launch(program, "combine_three", &bound, groups);
                }
                _ => {}
            }
        });
        Ok(())
    }
}

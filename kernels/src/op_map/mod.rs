//! Any logical operation on three masks by look-ups in a table of bytes, for machines without an integer unit.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 5, equation 4. `kernel.wgsl` states the
//! output exactly. Every machine of today has the operations themselves; this kernel is the checked equivalent, and shows
//! that the AND of half-planes and the OR of triangles are all that a mask needs.

use std::sync::Arc;

use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
pub mod oracle;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "op_map",
    summary: "logical operations on three masks by a table of 256³ bytes",
    citation: "Eisemann and Décoret, Visibility Sampling on GPU and Applications, 2007, section 5, equation 4",
    programs: || Ok(vec![OpMap::new()?.program]),
    cases: cases::all,
};

/// Words of a table: 256³ bytes.
pub const TABLE: u32 = 1 << 22;

/// Invocations a workgroup.
const GROUP: u32 = 256;

/// An operation on three bits: bit x + 2y + 4z is its result for bits x, y and z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Truth(pub u8);

impl Truth {
    /// All three: half-planes to a triangle.
    pub const AND: Truth = Truth(0b1000_0000);
    /// Any of the three: triangles to a hidden set.
    pub const OR: Truth = Truth(0b1111_1110);
}

host! {
    /// Mirrors `struct Params`.
    pub struct Params {
        /// Words to combine.
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

    /// What `combine` is given.
    pub struct Combine {
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
        Combine::check(&program, "combine")?;
        Ok(OpMap { program })
    }

    /// The table of an operation, of [`TABLE`] words.
    pub fn table(&self, job: &mut Job, operation: Truth) -> Buffer<[u32]> {
        let table = job.zeroed("op map", u64::from(TABLE));
        let program = job.program(&self.program);
        pieces::record(job, TABLE / GROUP, u64::from(GROUP), |job, piece| {
            let params = Params { words: 0, truth: u32::from(operation.0), first: piece.start * GROUP };
            let params = job.value("op map params", &params);
            job.launch(program, "build", &Build { params, table }, [piece.len() as u32, 1, 1]);
        });
        table
    }

    /// Combines the words of three masks into a fourth, all of one length; the fourth must not overlap the others.
    pub fn record(
        &self,
        job: &mut Job,
        op_map: Buffer<[u32]>,
        [a, b, c]: [Buffer<[u32]>; 3],
        combined: Buffer<[u32]>,
    ) -> Result<()> {
        let lengths = [a.len(), b.len(), c.len(), combined.len()];
        let words = u32::try_from(combined.len()).ok().filter(|_| lengths.iter().all(|n| *n == combined.len()));
        let Some(words) = words.filter(|_| op_map.len() == u64::from(TABLE)) else {
            let what = format!("masks of {lengths:?} words by a table of {}", op_map.len());
            return Err(Error::refused(what, format!("give four masks of one length and a table of {TABLE} words")));
        };
        let program = job.program(&self.program);
        pieces::record(job, words.div_ceil(GROUP), u64::from(8 * GROUP), |job, piece| {
            let params = job.value("op map params", &Params { words, truth: 0, first: piece.start * GROUP });
            let bound = Combine { params, op_map, a, b, c, combined };
            job.launch(program, "combine", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

//! Register files as rows of lanes, and passes over them.
//!
//! A pass computes one row from others, a chunk at a time. Whether an operand is a row or a word that all lanes share,
//! and where it stands, is settled before the operation is looked at: a loop is then compiled for the kinds of its
//! operands, and holds nothing but loads, the operation and the store. Invariant: all rows of a pass are equally long,
//! so one comparison ends the loop and no access in it is checked.

use std::cell::Cell;

use fearless_simd::prelude::*;
use fearless_simd::{Simd, u32x16};

use super::lanes::Lanes;
use super::mask::CHUNK;
use crate::code::Reg;

/// Chunks of one turn of a loop, as many as a word of a mask tells.
pub(super) const BLOCK: usize = 4;

/// Sixteen lanes of a register.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
pub(super) struct Chunk(pub(super) [u32; CHUNK]);

/// The register files, and which chunks to work on.
#[derive(Clone, Copy)]
pub(super) struct Rows<'a> {
    pub(super) vectors: &'a [Cell<Chunk>],
    pub(super) scalars: &'a [Cell<u32>],
    /// Chunks of one row.
    pub(super) chunks: usize,
    pub(super) low: usize,
    pub(super) high: usize,
}

impl<'a> Rows<'a> {
    /// The chunks of a vector register that are worked on.
    #[inline(always)]
    pub(super) fn row(&self, register: Reg) -> &'a [Cell<Chunk>] {
        &self.vectors[register.index() * self.chunks + self.low..][..self.len()]
    }

    /// The same from the beginning of a block on, which is a word of a mask.
    #[inline(always)]
    pub(super) fn aligned(&self) -> Self {
        Rows { low: self.low / BLOCK * BLOCK, ..*self }
    }

    /// Where the lanes of a chunk stand in a mask: its word, and their place in it. The rows are aligned.
    #[inline(always)]
    pub(super) fn lanes(&self, at: At) -> (usize, usize) {
        match at {
            At::Block(block, chunk) => (self.low / BLOCK + block, chunk * CHUNK),
            At::Rest(chunk) => (self.high / BLOCK, chunk * CHUNK),
        }
    }

    /// Chunks to work on.
    #[inline(always)]
    pub(super) fn len(&self) -> usize {
        self.high - self.low
    }

    #[inline(always)]
    pub(super) fn scalar(&self, register: Reg) -> u32 {
        self.scalars[register.index()].get()
    }

    /// One lane of an operand.
    pub(super) fn lane(&self, register: Reg, lane: usize) -> u32 {
        if register.is_scalar() {
            return self.scalar(register);
        }
        self.vectors[register.index() * self.chunks + lane / CHUNK].get().0[lane % CHUNK]
    }

    /// Chunk `index`, counted from the first lane, of an operand.
    #[inline(always)]
    pub(super) fn chunk(&self, register: Reg, index: usize) -> [u32; CHUNK] {
        if register.is_scalar() {
            return [self.scalar(register); CHUNK];
        }
        self.vectors[register.index() * self.chunks + index].get().0
    }

    /// Writes a chunk of a vector register.
    #[inline(always)]
    pub(super) fn set_chunk(&self, register: Reg, index: usize, words: [u32; CHUNK]) {
        self.vectors[register.index() * self.chunks + index].set(Chunk(words));
    }

    /// A vector register as an operand.
    #[inline(always)]
    pub(super) fn operand(&self, register: Reg) -> Row<'a> {
        let (blocks, rest) = self.row(register).as_chunks();
        Row { blocks, rest }
    }

    /// A scalar register as an operand.
    #[inline(always)]
    pub(super) fn word(&self, register: Reg) -> Word {
        Word(self.scalar(register))
    }
}

/// Evaluates an expression in which names of registers stand for the operands that they hold, of the kinds that they
/// are.
macro_rules! operands {
    ($rows:expr, [$name:ident $(, $more:ident)*] => $then:expr) => {
        if $name.is_scalar() {
            let $name = $rows.word($name);
            operands!($rows, [$($more),*] => $then)
        } else {
            let $name = $rows.operand($name);
            operands!($rows, [$($more),*] => $then)
        }
    };
    ($rows:expr, [] => $then:expr) => {
        $then
    };
}
pub(super) use operands;

#[inline(always)]
pub(super) fn load<S: Simd>(s: S, cell: &Cell<Chunk>) -> u32x16<S> {
    u32x16::simd_from(s, cell.get().0)
}

#[inline(always)]
pub(super) fn store<S: Simd>(cell: &Cell<Chunk>, value: u32x16<S>) {
    cell.set(Chunk(value.into()));
}

/// A chunk of a row: of a block, or of the chunks that are left over.
#[derive(Clone, Copy)]
pub(super) enum At {
    Block(usize, usize),
    Rest(usize),
}

/// An operand whose kind is known when the loop is compiled.
pub(super) trait Operand<S: Simd>: Copy {
    /// Whether all lanes share it.
    const IS_WORD: bool;

    /// One chunk.
    fn at(self, s: S, at: At) -> u32x16<S>;

    /// `t op` this, on one chunk.
    #[inline(always)]
    fn after<O: Lanes>(self, s: S, t: u32x16<S>, at: At) -> u32x16<S> {
        O::apply(s, t, self.at(s, at))
    }
}

/// A row of lanes.
#[derive(Clone, Copy)]
pub(super) struct Row<'a> {
    blocks: &'a [[Cell<Chunk>; BLOCK]],
    rest: &'a [Cell<Chunk>],
}

impl<'a> Row<'a> {
    #[inline(always)]
    fn cell(self, at: At) -> &'a Cell<Chunk> {
        match at {
            At::Block(block, chunk) => &self.blocks[block][chunk],
            At::Rest(chunk) => &self.rest[chunk],
        }
    }
}

impl<S: Simd> Operand<S> for Row<'_> {
    const IS_WORD: bool = false;

    #[inline(always)]
    fn at(self, s: S, at: At) -> u32x16<S> {
        load(s, self.cell(at))
    }
}

/// A word that all lanes share.
#[derive(Clone, Copy)]
pub(super) struct Word(pub(super) u32);

impl<S: Simd> Operand<S> for Word {
    const IS_WORD: bool = true;

    #[inline(always)]
    fn at(self, s: S, _: At) -> u32x16<S> {
        s.splat_u32x16(self.0)
    }

    #[inline(always)]
    fn after<O: Lanes>(self, s: S, t: u32x16<S>, _: At) -> u32x16<S> {
        O::by(s, t, self.0)
    }
}

/// `dst = f(chunk)`.
#[inline(always)]
pub(super) fn pass<S: Simd>(dst: Row<'_>, f: impl Fn(At) -> u32x16<S>) {
    for block in 0..dst.blocks.len() {
        for chunk in 0..BLOCK {
            let at = At::Block(block, chunk);
            store(dst.cell(at), f(at));
        }
    }
    for chunk in 0..dst.rest.len() {
        let at = At::Rest(chunk);
        store(dst.cell(at), f(at));
    }
}

//! Places: what a pointer means once calls are inlined and types are split into words.
//!
//! A place is a root (variables, private or workgroup memory, a buffer) and a word offset with an optional run-time
//! part. Buffers keep WGSL's host layout; everything else is packed, one word a scalar, so a loaded value and the
//! memory it came from have the same order of words.

use naga::{ScalarKind, TypeInner, VectorSize};

use super::build::{Builder, Fail};
use super::tree::{Op, Stmt, Val, Var};
use crate::code::{BinOp, Mem};

/// Where a place begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Root {
    /// Variables from this one on; the offset is always constant.
    Vars(u32),
    /// Memory from this word on.
    Mem(Mem, u32),
}

/// A typed location.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) root: Root,
    pub(super) ty: TypeInner,
    /// Run-time part of the offset, in words.
    pub(super) dynamic: Option<Val>,
    /// Constant part of the offset, in words.
    pub(super) offset: u32,
}

fn lanes(size: VectorSize) -> u32 {
    size as u32
}

impl<'m> Builder<'m> {
    /// Number of scalars of a type.
    pub(super) fn flat(&self, ty: &TypeInner) -> Result<u32, Fail> {
        Ok(match ty {
            TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => {
                let word = scalar.width == 4 || scalar.kind == ScalarKind::Bool;
                if !word {
                    return Err(Fail::unsupported(format!("the {}-bit scalar type", scalar.width * 8), None));
                }
                1
            }
            TypeInner::Vector { size, scalar } => lanes(*size) * self.flat(&TypeInner::Scalar(*scalar))?,
            TypeInner::Matrix { columns, rows, scalar } => {
                lanes(*columns) * lanes(*rows) * self.flat(&TypeInner::Scalar(*scalar))?
            }
            TypeInner::Array { base, size, .. } => {
                let count = self.count(*size)?.unwrap_or(0);
                let each = self.flat(self.inner(*base))?;
                count.checked_mul(each).ok_or_else(|| Fail::unsupported("an array of this size", None))?
            }
            TypeInner::Struct { members, .. } => {
                let mut sum = 0u32;
                for member in members {
                    sum = sum.saturating_add(self.flat(self.inner(member.ty))?);
                }
                sum
            }
            _ => return Err(Fail::unsupported("a resource that is not a buffer (texture, sampler, ray query)", None)),
        })
    }

    /// Elements of an array; `None` where the buffer decides.
    pub(super) fn count(&self, size: naga::ArraySize) -> Result<Option<u32>, Fail> {
        match size.resolve(self.module.to_ctx()) {
            Ok(naga::proc::IndexableLength::Known(count)) => Ok(Some(count)),
            Ok(naga::proc::IndexableLength::Dynamic) => Ok(None),
            Err(e) => Err(Fail::unsupported(format!("an array size ({e})"), None)),
        }
    }

    /// Words from one element to the next, and the element's type and count, of anything that can be indexed.
    fn elements(&self, place: &Place) -> Result<(TypeInner, u32, Option<u32>), Fail> {
        let host = matches!(place.root, Root::Mem(Mem::Buffer(_), _));
        Ok(match place.ty {
            TypeInner::Vector { size, scalar } => (TypeInner::Scalar(scalar), 1, Some(lanes(size))),
            TypeInner::Matrix { columns, rows, scalar } => {
                let stride = if host && rows == VectorSize::Tri { 4 } else { lanes(rows) };
                (TypeInner::Vector { size: rows, scalar }, stride, Some(lanes(columns)))
            }
            TypeInner::Array { base, size, stride } => {
                let inner = self.inner(base).clone();
                let words = if host { stride / 4 } else { self.flat(&inner)? };
                (inner, words, self.count(size)?)
            }
            _ => return Err(Fail::unsupported("indexing this type", None)),
        })
    }

    /// The place of a member or of an element at a constant index.
    pub(super) fn at_constant(&mut self, place: &Place, index: u32, span: naga::Span) -> Result<Place, Fail> {
        let mut out = place.clone();
        if let TypeInner::Struct { members, .. } = &place.ty {
            let member = &members[index as usize];
            out.ty = self.inner(member.ty).clone();
            out.offset += if matches!(place.root, Root::Mem(Mem::Buffer(_), _)) {
                member.offset / 4
            } else {
                let mut sum = 0;
                for m in &members[..index as usize] {
                    sum += self.flat(self.inner(m.ty))?;
                }
                sum
            };
            return Ok(out);
        }
        let (ty, stride, count) = self.elements(place)?;
        if count.is_none_or(|n| index >= n) {
            let index = self.constant(index);
            return self.at_dynamic(place, index, span);
        }
        out.ty = ty;
        out.offset += index * stride;
        Ok(out)
    }

    /// The place of an element at a run-time index, clamped or trapped as the run wants it.
    pub(super) fn at_dynamic(&mut self, place: &Place, index: Val, span: naga::Span) -> Result<Place, Fail> {
        if let (Some(index), Ok((_, _, Some(count)))) = (self.tree.constant(index), self.elements(place))
            && index < count
        {
            return self.at_constant(place, index, span);
        }
        let (ty, stride, count) = self.elements(place)?;
        let length = match (count, place.root) {
            (Some(count), _) => self.constant(count),
            (None, Root::Mem(Mem::Buffer(buffer), _)) => {
                // A runtime-sized array of words that is the whole buffer: the access itself checks its range.
                if stride == 1 && place.offset == 0 && place.dynamic.is_none() {
                    return Ok(Place { ty, dynamic: Some(index), ..place.clone() });
                }
                self.define(Op::ArrayLength { buffer, offset: place.offset, stride })
            }
            _ => return Err(Fail::unsupported("a runtime-sized array outside a buffer", Some(span))),
        };
        let site = self.site(span);
        let index = self.define(Op::Check { index, length, site });
        let words = if stride.is_power_of_two() {
            let by = self.constant(stride.trailing_zeros());
            self.define(Op::Bin(BinOp::Shl, index, by))
        } else {
            let stride = self.constant(stride);
            self.define(Op::Bin(BinOp::Mul, index, stride))
        };
        let dynamic = match place.dynamic {
            Some(before) => self.define(Op::Bin(BinOp::Add, before, words)),
            None => words,
        };
        Ok(Place { ty, dynamic: Some(dynamic), ..place.clone() })
    }

    /// Number of elements behind a pointer to a runtime-sized array.
    pub(super) fn array_length(&mut self, place: &Place) -> Result<Val, Fail> {
        let (_, stride, count) = self.elements(place)?;
        Ok(match (count, place.root) {
            (Some(count), _) => self.constant(count),
            (None, Root::Mem(Mem::Buffer(buffer), _)) => {
                self.define(Op::ArrayLength { buffer, offset: place.offset, stride })
            }
            _ => return Err(Fail::unsupported("a runtime-sized array outside a buffer", None)),
        })
    }

    /// Calls `f` with the offset of each scalar of a type, in order.
    fn leaves(&self, place: &Place, out: &mut Vec<u32>) -> Result<(), Fail> {
        match &place.ty {
            TypeInner::Scalar(_) | TypeInner::Atomic(_) => {
                self.flat(&place.ty)?;
                out.push(place.offset);
            }
            TypeInner::Struct { members, .. } => {
                let host = matches!(place.root, Root::Mem(Mem::Buffer(_), _));
                let mut packed = 0;
                for member in members {
                    let ty = self.inner(member.ty).clone();
                    let size = self.flat(&ty)?;
                    let step = if host { member.offset / 4 } else { packed };
                    packed += size;
                    self.leaves(&Place { ty, offset: place.offset + step, ..place.clone() }, out)?;
                }
            }
            _ => {
                let (ty, stride, count) = self.elements(place)?;
                for index in 0..count.unwrap_or(0) {
                    let offset = place.offset + index * stride;
                    self.leaves(&Place { ty: ty.clone(), offset, ..place.clone() }, out)?;
                }
            }
        }
        Ok(())
    }

    /// Memory, base address and offset added to it, of a place in memory.
    pub(super) fn address(&mut self, place: &Place) -> Option<(Mem, Val, u32)> {
        let Root::Mem(mem, base) = place.root else { return None };
        let addr = place.dynamic.unwrap_or_else(|| self.constant(0));
        let (addr, more) = self.split_sum(addr);
        Some((mem, addr, base.wrapping_add(more)))
    }

    /// Loads every scalar of a place.
    pub(super) fn load(&mut self, place: &Place, span: naga::Span) -> Result<Vec<Val>, Fail> {
        let mut leaves = Vec::new();
        self.leaves(place, &mut leaves)?;
        if let Root::Vars(base) = place.root {
            return Ok(leaves.into_iter().map(|leaf| self.get(Var(base + leaf))).collect());
        }
        let (mem, addr, base) = self.address(place).expect("a place is variables or memory");
        self.count_load(mem, leaves.len());
        let site = self.site(span);
        Ok(leaves
            .into_iter()
            .map(|leaf| self.define(Op::Load { mem, addr, offset: base.wrapping_add(leaf), site }))
            .collect())
    }

    /// Stores every scalar of a place.
    pub(super) fn store(&mut self, place: &Place, values: &[Val], span: naga::Span) -> Result<(), Fail> {
        self.spend(values.len() as u32)?;
        let mut leaves = Vec::new();
        self.leaves(place, &mut leaves)?;
        if let Root::Vars(base) = place.root {
            for (leaf, &value) in leaves.iter().zip(values) {
                self.set(Var(base + leaf), value);
            }
            return Ok(());
        }
        let (mem, addr, base) = self.address(place).expect("a place is variables or memory");
        self.count_store(mem, leaves.len());
        let site = self.site(span);
        for (leaf, &value) in leaves.iter().zip(values) {
            self.push(Stmt::Store { mem, addr, offset: base.wrapping_add(*leaf), value, site });
        }
        Ok(())
    }
}

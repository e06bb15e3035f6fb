//! Memory as words, pointers into it, and the layout of types.
//!
//! Buffers have WGSL's host-shareable layout, so padding is where the specification puts it and stores leave it alone.
//! Everything else is dense, one word a scalar: its layout cannot be observed.

use std::cell::RefCell;

use naga::proc::IndexableLength;
use naga::{Handle, Module, Scalar, Type, TypeInner, VectorSize};
use sightlines_backend::Result;

use super::unsupported;
use super::value::Value;

/// Which memory a pointer goes into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Root {
    /// A bound range: index of the slot.
    Slot(usize),
    Workgroup,
    Private,
    Function,
}

/// What a pointer points to; vectors and scalars inside composites have no handle of their own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    Type(Handle<Type>),
    Vector(VectorSize, Scalar),
    Scalar(Scalar),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pointer {
    pub root: Root,
    /// Word offset in the root.
    pub word: usize,
    pub shape: Shape,
}

/// A type taken apart.
pub(crate) enum Kind<'a> {
    Scalar(Scalar),
    Vector(usize, Scalar),
    Matrix(usize, VectorSize, Scalar),
    /// Element and number; none where the buffer decides.
    Array(Handle<Type>, Option<usize>, usize),
    Struct(&'a [naga::StructMember], usize),
}

/// A bound range of a buffer.
pub(crate) struct Slot<'a> {
    pub memory: &'a RefCell<Vec<u32>>,
    pub first: usize,
    pub words: usize,
}

pub(crate) fn kind(module: &Module, shape: Shape) -> Result<Kind<'_>> {
    let ty = match shape {
        Shape::Scalar(scalar) => return Ok(Kind::Scalar(scalar)),
        Shape::Vector(size, scalar) => return Ok(Kind::Vector(size as usize, scalar)),
        Shape::Type(ty) => ty,
    };
    Ok(match &module.types[ty].inner {
        TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => Kind::Scalar(*scalar),
        TypeInner::Vector { size, scalar } => Kind::Vector(*size as usize, *scalar),
        TypeInner::Matrix { columns, rows, scalar } => Kind::Matrix(*columns as usize, *rows, *scalar),
        TypeInner::Array { base, size, stride } => {
            let length = match size.resolve(module.to_ctx()) {
                Ok(IndexableLength::Known(n)) => Some(n as usize),
                Ok(IndexableLength::Dynamic) => None,
                Err(_) => return unsupported("array of a size that no override fixes"),
            };
            Kind::Array(*base, length, *stride as usize / 4)
        }
        TypeInner::Struct { members, span } => Kind::Struct(members, *span as usize / 4),
        other => return unsupported(format!("type {other:?}")),
    })
}

/// Words that a type of fixed size takes.
pub(crate) fn size(module: &Module, shape: Shape, host: bool) -> Result<usize> {
    Ok(match kind(module, shape)? {
        Kind::Scalar(_) => 1,
        Kind::Vector(n, _) => n,
        Kind::Matrix(columns, rows, _) => columns * column_stride(rows, host),
        Kind::Array(base, length, stride) => {
            let stride = if host { stride } else { size(module, Shape::Type(base), host)? };
            stride * length.unwrap_or(0)
        }
        Kind::Struct(_, span) if host => span,
        Kind::Struct(members, _) => {
            members.iter().map(|m| size(module, Shape::Type(m.ty), false)).sum::<Result<usize>>()?
        }
    })
}

fn column_stride(rows: VectorSize, host: bool) -> usize {
    if host && rows == VectorSize::Tri { 4 } else { rows as usize }
}

/// The part `index` of a composite: its word offset inside it and its shape. None for a scalar.
pub(crate) fn part(module: &Module, shape: Shape, index: usize, host: bool) -> Result<(usize, Shape)> {
    Ok(match kind(module, shape)? {
        Kind::Scalar(_) => return unsupported("part of a scalar"),
        Kind::Vector(_, scalar) => (index, Shape::Scalar(scalar)),
        Kind::Matrix(_, rows, scalar) => (index * column_stride(rows, host), Shape::Vector(rows, scalar)),
        Kind::Array(base, _, stride) => {
            let stride = if host { stride } else { size(module, Shape::Type(base), host)? };
            (index * stride, Shape::Type(base))
        }
        Kind::Struct(members, _) if host => (members[index].offset as usize / 4, Shape::Type(members[index].ty)),
        Kind::Struct(members, _) => {
            let before = members[..index].iter().map(|m| size(module, Shape::Type(m.ty), false));
            (before.sum::<Result<usize>>()?, Shape::Type(members[index].ty))
        }
    })
}

/// Number of parts of a composite whose size its type fixes; 0 for a scalar.
pub(crate) fn parts(module: &Module, shape: Shape) -> Result<usize> {
    Ok(match kind(module, shape)? {
        Kind::Scalar(_) => 0,
        Kind::Vector(n, _) | Kind::Matrix(n, ..) => n,
        Kind::Array(_, length, _) => length.map_or_else(|| unsupported("value of a runtime-sized array"), Ok)?,
        Kind::Struct(members, _) => members.len(),
    })
}

/// The value whose words begin at `word`.
pub(crate) fn decode(module: &Module, shape: Shape, words: &[u32], word: usize, host: bool) -> Result<Value> {
    if let Kind::Scalar(scalar) = kind(module, shape)? {
        return Value::from_word(scalar, words[word]);
    }
    let element = |i| {
        let (offset, shape) = part(module, shape, i, host)?;
        decode(module, shape, words, word + offset, host)
    };
    (0..parts(module, shape)?).map(element).collect::<Result<_>>().map(Value::Composite)
}

/// Writes a value's words from `word` on; padding keeps what it holds.
pub(crate) fn encode(
    module: &Module,
    shape: Shape,
    value: &Value,
    words: &mut [u32],
    word: usize,
    host: bool,
) -> Result<()> {
    let Value::Composite(values) = value else {
        words[word] = value.word();
        return Ok(());
    };
    for (i, value) in values.iter().enumerate() {
        let (offset, shape) = part(module, shape, i, host)?;
        encode(module, shape, value, words, word + offset, host)?;
    }
    Ok(())
}

/// The zero value of a type.
pub(crate) fn zero(module: &Module, shape: Shape) -> Result<Value> {
    decode(module, shape, &vec![0; size(module, shape, false)?], 0, false)
}

/// Scalars of a type of fixed size.
pub(crate) fn scalars(module: &Module, shape: Shape) -> Result<usize> {
    size(module, shape, false)
}

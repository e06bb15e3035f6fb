//! Values as trees: a scalar, a composite of values, or a pointer.
//!
//! Invariant: a vector is a composite of scalars, a matrix a composite of column vectors.

use naga::{Literal, Scalar, ScalarKind};
use sightlines_backend::Result;
use sightlines_backend_cpu::math;

use super::memory::Pointer;
use super::unsupported;

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Bool(bool),
    I32(i32),
    U32(u32),
    F32(f32),
    Composite(Vec<Value>),
    Pointer(Pointer),
}

use Value::{Bool, Composite, F32, I32, U32};

impl Value {
    pub(crate) fn literal(literal: Literal) -> Result<Self> {
        match literal {
            Literal::Bool(x) => Ok(Bool(x)),
            Literal::I32(x) => Ok(I32(x)),
            Literal::U32(x) => Ok(U32(x)),
            Literal::F32(x) => Ok(F32(x)),
            other => unsupported(format!("literal {other:?}")),
        }
    }

    /// The scalar of `scalar`'s type whose memory word is `word`.
    pub(crate) fn from_word(scalar: Scalar, word: u32) -> Result<Self> {
        match (scalar.kind, scalar.width) {
            (ScalarKind::Bool, _) => Ok(Bool(word != 0)),
            (ScalarKind::Sint, 4) => Ok(I32(word as i32)),
            (ScalarKind::Uint, 4) => Ok(U32(word)),
            (ScalarKind::Float, 4) => Ok(F32(f32::from_bits(word))),
            _ => unsupported(format!("scalar {scalar:?}")),
        }
    }

    /// The memory word of a scalar.
    pub(crate) fn word(&self) -> u32 {
        match *self {
            Bool(x) => u32::from(x),
            I32(x) => x as u32,
            U32(x) => x,
            F32(x) => x.to_bits(),
            Composite(_) | Value::Pointer(_) => panic!("not a scalar: {self:?}"),
        }
    }

    pub(crate) fn bool(&self) -> bool {
        match self {
            Bool(x) => *x,
            other => panic!("not a bool: {other:?}"),
        }
    }

    pub(crate) fn f32(&self) -> f32 {
        match self {
            F32(x) => *x,
            other => panic!("not an f32: {other:?}"),
        }
    }

    pub(crate) fn pointer(&self) -> &Pointer {
        match self {
            Value::Pointer(pointer) => pointer,
            other => panic!("not a pointer: {other:?}"),
        }
    }

    /// The parts of a composite; a scalar is its own only part.
    pub(crate) fn parts(&self) -> &[Value] {
        match self {
            Composite(parts) => parts,
            scalar => std::slice::from_ref(scalar),
        }
    }

    pub(crate) fn floats(&self) -> Vec<f32> {
        self.parts().iter().map(Value::f32).collect()
    }

    pub(crate) fn words(&self) -> Vec<u32> {
        self.parts().iter().map(Value::word).collect()
    }

    pub(crate) fn vector(components: impl IntoIterator<Item = f32>) -> Self {
        Composite(components.into_iter().map(F32).collect())
    }

    pub(crate) fn is_matrix(&self) -> bool {
        matches!(self.parts().first(), Some(Composite(_)))
    }
}

/// Applies `f` to corresponding scalars of `args`; a scalar beside a composite serves all its parts.
pub(crate) fn scalarwise(args: &[&Value], f: &dyn Fn(&[&Value]) -> Result<Value>) -> Result<Value> {
    let parts = args.iter().find_map(|a| if let Composite(parts) = a { Some(parts.len()) } else { None });
    let Some(parts) = parts else { return f(args) };
    let part = |i: usize| {
        let parts = args.iter().map(|a| if let Composite(parts) = a { &parts[i] } else { *a });
        scalarwise(&parts.collect::<Vec<_>>(), f)
    };
    (0..parts).map(part).collect::<Result<_>>().map(Composite)
}

/// `as`: a conversion where `convert` is set, else a change of type with the same bits.
pub(crate) fn cast(value: &Value, kind: ScalarKind, convert: Option<u8>) -> Result<Value> {
    scalarwise(&[value], &|args| {
        let x = args[0];
        let Some(width) = convert else { return Value::from_word(Scalar { kind, width: 4 }, x.word()) };
        Ok(match (kind, width, x) {
            (ScalarKind::Bool, _, F32(x)) => Bool(*x != 0.0),
            (ScalarKind::Bool, _, x) => Bool(x.word() != 0),
            (ScalarKind::Sint, 4, F32(x)) => I32(math::f32_to_i32(*x)),
            (ScalarKind::Sint, 4, x) => I32(x.word() as i32),
            (ScalarKind::Uint, 4, F32(x)) => U32(math::f32_to_u32(*x)),
            (ScalarKind::Uint, 4, x) => U32(x.word()),
            (ScalarKind::Float, 4, F32(x)) => F32(*x),
            (ScalarKind::Float, 4, I32(x)) => F32(math::i32_to_f32(*x)),
            (ScalarKind::Float, 4, x) => F32(math::u32_to_f32(x.word())),
            _ => return unsupported(format!("conversion to {kind:?} of {width} bytes")),
        })
    })
}

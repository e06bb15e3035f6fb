//! The types that programs use.

use super::random::Random;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Scalar {
    Bool,
    I32,
    U32,
    F32,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Type {
    Scalar(Scalar),
    Vector(usize, Scalar),
    /// Columns and rows of f32.
    Matrix(usize, usize),
    Array(Box<Type>, usize),
    /// Index into the program's structures.
    Struct(usize),
}

pub(crate) const BOOL: Type = Type::Scalar(Scalar::Bool);
pub(crate) const I32: Type = Type::Scalar(Scalar::I32);
pub(crate) const U32: Type = Type::Scalar(Scalar::U32);
pub(crate) const F32: Type = Type::Scalar(Scalar::F32);

impl Scalar {
    pub(crate) const ALL: [Scalar; 4] = [Scalar::Bool, Scalar::I32, Scalar::U32, Scalar::F32];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Scalar::Bool => "bool",
            Scalar::I32 => "i32",
            Scalar::U32 => "u32",
            Scalar::F32 => "f32",
        }
    }
}

impl Type {
    pub(crate) fn name(&self) -> String {
        match self {
            Type::Scalar(scalar) => scalar.name().to_owned(),
            Type::Vector(n, scalar) => format!("vec{n}<{}>", scalar.name()),
            Type::Matrix(columns, rows) => format!("mat{columns}x{rows}<f32>"),
            Type::Array(element, n) => format!("array<{}, {n}>", element.name()),
            Type::Struct(index) => format!("S{index}"),
        }
    }

    /// A scalar, vector or matrix; numbers more often than bool.
    pub(crate) fn small(random: &mut Random<'_>) -> Type {
        let scalar = *random.pick(&[Scalar::Bool, Scalar::I32, Scalar::I32, Scalar::U32, Scalar::U32, Scalar::F32]);
        match random.below(8) {
            0..=4 => Type::Scalar(scalar),
            5 | 6 => Type::Vector(2 + random.below(3), scalar),
            _ => Type::Matrix(2 + random.below(3), 2 + random.below(3)),
        }
    }

    /// A type that a buffer may hold: without bool, which none may, and without f32, whose NaN would show there.
    pub(crate) fn shareable(random: &mut Random<'_>) -> Type {
        let scalar = *random.pick(&[Scalar::I32, Scalar::U32]);
        let vector = Type::Vector(2 + random.below(3), scalar);
        match random.below(4) {
            0 | 1 => Type::Scalar(scalar),
            2 => vector,
            _ => Type::Array(Box::new(vector), 1 + random.below(3)),
        }
    }

    /// Any type: an array or a structure one time in three.
    pub(crate) fn any(random: &mut Random<'_>, structs: usize) -> Type {
        match random.below(6) {
            0 => Type::Array(Box::new(Type::small(random)), 1 + random.below(6)),
            1 if structs > 0 => Type::Struct(random.below(structs)),
            2 if structs > 0 && random.chance(30) => {
                Type::Array(Box::new(Type::Struct(random.below(structs))), 1 + random.below(3))
            }
            _ => Type::small(random),
        }
    }
}

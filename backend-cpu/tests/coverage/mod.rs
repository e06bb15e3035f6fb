//! Which operations the files reach: none may be forgotten.

use std::collections::BTreeSet;
use std::sync::Arc;

use naga::proc::TypeResolution;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Expression, ScalarKind, TypeInner};

use sightlines_testing::operators::{File, kind_name};

/// Every operation of WGSL on bool, i32, u32 and f32, with the operand types it must be tested on.
const WANTED: &[(&str, &[&str])] = &[
    ("Negate", &["i32", "f32"]),
    ("LogicalNot", &["bool"]),
    ("BitwiseNot", &["i32", "u32"]),
    ("Add Subtract Multiply Divide Modulo", &["i32", "u32", "f32"]),
    ("Less LessEqual Greater GreaterEqual", &["i32", "u32", "f32"]),
    ("Equal NotEqual", &["bool", "i32", "u32", "f32"]),
    ("And InclusiveOr", &["bool", "i32", "u32"]),
    ("ExclusiveOr ShiftLeft ShiftRight", &["i32", "u32"]),
    ("Select", &["bool", "i32", "u32", "f32"]),
    ("All Any", &["bool"]),
    ("As", &["bool", "i32", "u32", "f32"]),
    ("Abs Min Max Clamp", &["i32", "u32", "f32"]),
    ("Sign Dot", &["i32", "f32"]),
    ("Saturate Cos Cosh Sin Sinh Tan Tanh Acos Asin Atan Atan2 Asinh Acosh Atanh Radians Degrees", &["f32"]),
    ("Ceil Floor Round Fract Trunc Modf Frexp Ldexp Exp Exp2 Log Log2 Pow", &["f32"]),
    ("Cross Distance Length Normalize FaceForward Reflect Refract", &["f32"]),
    ("Fma Mix Step SmoothStep Sqrt InverseSqrt Transpose Determinant QuantizeToF16", &["f32"]),
    ("CountTrailingZeros CountLeadingZeros CountOneBits ReverseBits", &["i32", "u32"]),
    ("ExtractBits InsertBits FirstTrailingBit FirstLeadingBit", &["i32", "u32"]),
    ("Dot4I8Packed Dot4U8Packed", &["u32"]),
    ("Pack4x8snorm Pack4x8unorm Pack2x16snorm Pack2x16unorm Pack2x16float", &["f32"]),
    ("Pack4xI8 Pack4xI8Clamp", &["i32"]),
    ("Pack4xU8 Pack4xU8Clamp", &["u32"]),
    ("Unpack4x8snorm Unpack4x8unorm Unpack2x16snorm Unpack2x16unorm Unpack2x16float", &["u32"]),
    ("Unpack4xI8 Unpack4xU8", &["u32"]),
];

/// Fails with the operations that no file reaches.
pub(crate) fn coverage(files: &[Arc<File>]) -> Result<(), String> {
    let mut reached = BTreeSet::new();
    for file in files {
        collect(file, &mut reached)?;
    }
    let wanted = WANTED.iter().flat_map(|(names, types)| {
        names.split(' ').flat_map(|name| types.iter().map(move |ty| format!("{name} {ty}")))
    });
    let missing: Vec<String> = wanted.filter(|w| !reached.contains(w)).collect();
    if missing.is_empty() { Ok(()) } else { Err(format!("no file reaches: {}", missing.join(", "))) }
}

fn collect(file: &File, reached: &mut BTreeSet<String>) -> Result<(), String> {
    let module = file.module();
    let info = Validator::new(ValidationFlags::all(), Capabilities::SHADER_FLOAT16_IN_FLOAT32)
        .validate(module)
        .map_err(|e| e.as_inner().to_string())?;
    for (handle, function) in module.functions.iter() {
        let info = &info[handle];
        for (_, expression) in function.expressions.iter() {
            let (name, operand) = match expression {
                Expression::Unary { op, expr } => (format!("{op:?}"), expr),
                Expression::Binary { op, left, .. } => (format!("{op:?}"), left),
                Expression::Select { accept, .. } => ("Select".to_owned(), accept),
                Expression::Relational { fun, argument } => (format!("{fun:?}"), argument),
                Expression::Math { fun, arg, .. } => (format!("{fun:?}"), arg),
                Expression::As { expr, .. } => ("As".to_owned(), expr),
                _ => continue,
            };
            let kind = match &info[*operand].ty {
                TypeResolution::Handle(ty) => scalar_kind(&module.types[*ty].inner),
                TypeResolution::Value(inner) => scalar_kind(inner),
            };
            if let Some(kind) = kind {
                reached.insert(format!("{name} {}", kind_name(kind)));
            }
        }
    }
    Ok(())
}

fn scalar_kind(inner: &TypeInner) -> Option<ScalarKind> {
    inner.scalar().map(|scalar| scalar.kind)
}

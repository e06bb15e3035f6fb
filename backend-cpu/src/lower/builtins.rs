//! WGSL's mathematical builtins, spelled out in operations on words wherever the specification gives a formula.

use std::rc::Rc;

use naga::{Expression, Handle, MathFunction, ScalarKind, TypeInner};

use super::build::{Builder, Fail};
use super::tree::{Op, Val};
use crate::code::{BinOp, TernOp, UnOp};

type Args = [Option<Handle<Expression>>; 4];

impl Builder<'_> {
    pub(super) fn bin(&mut self, op: BinOp, a: Val, b: Val) -> Val {
        self.define(Op::Bin(op, a, b))
    }

    pub(super) fn un(&mut self, op: UnOp, a: Val) -> Val {
        self.define(Op::Un(op, a))
    }

    pub(super) fn select(&mut self, cond: Val, accept: Val, reject: Val) -> Val {
        self.define(Op::Tern(TernOp::Select, cond, accept, reject))
    }

    fn float(&mut self, value: f32) -> Val {
        self.constant(value.to_bits())
    }

    pub(super) fn math(&mut self, fun: MathFunction, args: Args) -> Result<Rc<[Val]>, Fail> {
        let first = args[0].expect("every builtin has an argument");
        let kind = self.kind_of(first);
        let ty = self.type_of(first);
        let mut words: Vec<Rc<[Val]>> = Vec::new();
        for arg in args.into_iter().flatten() {
            words.push(self.words(arg)?);
        }
        if let Some(result) = self.whole(fun, kind, &ty, &words)? {
            return Ok(result);
        }
        let count = words.iter().map(|w| w.len()).max().unwrap_or(1);
        let mut result = Vec::with_capacity(count);
        for i in 0..count {
            let at: Vec<Val> = words.iter().map(|w| w[i.min(w.len() - 1)]).collect();
            result.push(self.componentwise(fun, kind, &at)?);
        }
        Ok(result.into())
    }

    /// Builtins whose result is not made component by component.
    fn whole(
        &mut self,
        fun: MathFunction,
        kind: ScalarKind,
        ty: &TypeInner,
        w: &[Rc<[Val]>],
    ) -> Result<Option<Rc<[Val]>>, Fail> {
        let a = &w[0];
        Ok(Some(match fun {
            MathFunction::Dot if kind == ScalarKind::Float => [self.dot_f(a, &w[1])].into(),
            MathFunction::Dot => [self.dot_with(a, &w[1], BinOp::Mul, BinOp::Add)].into(),
            MathFunction::Cross => self.cross(a, &w[1]).into(),
            MathFunction::Length => [self.length(a)].into(),
            MathFunction::Distance => {
                let difference: Vec<Val> =
                    a.iter().zip(w[1].iter()).map(|(&x, &y)| self.bin(BinOp::SubF, x, y)).collect();
                [self.length(&difference)].into()
            }
            MathFunction::Normalize => {
                let length = self.length(a);
                a.iter().map(|&x| self.bin(BinOp::DivF, x, length)).collect()
            }
            MathFunction::FaceForward => {
                let dot = self.dot_f(&w[1], &w[2]);
                let zero = self.float(0.0);
                let keep = self.bin(BinOp::LtF, dot, zero);
                let turn = |&x: &Val| {
                    let negative = self.un(UnOp::NegF, x);
                    self.select(keep, x, negative)
                };
                a.iter().map(turn).collect()
            }
            MathFunction::Reflect => {
                let dot = self.dot_f(&w[1], a);
                let two = self.float(2.0);
                let twice = self.bin(BinOp::MulF, two, dot);
                let turn = |(&x, &n): (&Val, &Val)| {
                    let along = self.bin(BinOp::MulF, twice, n);
                    self.bin(BinOp::SubF, x, along)
                };
                a.iter().zip(w[1].iter()).map(turn).collect()
            }
            MathFunction::Refract => self.refract(a, &w[1], w[2][0]),
            MathFunction::Transpose => {
                let TypeInner::Matrix { columns, rows, .. } = *ty else {
                    return Err(Fail::unsupported("transposing this type", None));
                };
                let (columns, rows) = (columns as usize, rows as usize);
                (0..columns * rows).map(|i| a[(i % columns) * rows + i / columns]).collect()
            }
            MathFunction::Determinant => [self.determinant(a)].into(),
            MathFunction::Outer => {
                let b = w[1].clone();
                b.iter()
                    .flat_map(|&y| a.iter().map(move |&x| (x, y)))
                    .map(|(x, y)| self.bin(BinOp::MulF, x, y))
                    .collect()
            }
            MathFunction::Modf | MathFunction::Frexp => {
                let (low, high) = if fun == MathFunction::Modf {
                    let whole: Vec<Val> = a.iter().map(|&x| self.un(UnOp::Trunc, x)).collect();
                    let fraction: Vec<Val> = a.iter().zip(&whole).map(|(&x, &t)| self.bin(BinOp::SubF, x, t)).collect();
                    (fraction, whole)
                } else {
                    let fraction: Vec<Val> = a.iter().map(|&x| self.un(UnOp::FrexpFraction, x)).collect();
                    (fraction, a.iter().map(|&x| self.un(UnOp::FrexpExponent, x)).collect())
                };
                low.into_iter().chain(high).collect()
            }
            MathFunction::Dot4I8Packed | MathFunction::Dot4U8Packed => {
                let signed = fun == MathFunction::Dot4I8Packed;
                let (x, y) = (self.fields(a[0], 8, signed), self.fields(w[1][0], 8, signed));
                [self.dot_with(&x, &y, BinOp::Mul, BinOp::Add)].into()
            }
            MathFunction::Pack4x8snorm => [self.pack(a, 8, UnOp::PackSnorm8)].into(),
            MathFunction::Pack4x8unorm => [self.pack(a, 8, UnOp::PackUnorm8)].into(),
            MathFunction::Pack2x16snorm => [self.pack(a, 16, UnOp::PackSnorm16)].into(),
            MathFunction::Pack2x16unorm => [self.pack(a, 16, UnOp::PackUnorm16)].into(),
            MathFunction::Pack2x16float => [self.pack(a, 16, UnOp::PackHalf)].into(),
            MathFunction::Pack4xI8 | MathFunction::Pack4xU8 => [self.pack(a, 8, UnOp::Move)].into(),
            MathFunction::Pack4xI8Clamp => {
                let clamped: Vec<Val> = a.iter().map(|&x| self.clamp(x, -128i32 as u32, 127, true)).collect();
                [self.pack(&clamped, 8, UnOp::Move)].into()
            }
            MathFunction::Pack4xU8Clamp => {
                let clamped: Vec<Val> = a.iter().map(|&x| self.clamp(x, 0, 255, false)).collect();
                [self.pack(&clamped, 8, UnOp::Move)].into()
            }
            MathFunction::Unpack4xI8 => self.fields(a[0], 8, true).into(),
            MathFunction::Unpack4xU8 => self.fields(a[0], 8, false).into(),
            MathFunction::Unpack4x8snorm => self.unpack(a[0], 8, true, 127.0),
            MathFunction::Unpack4x8unorm => self.unpack(a[0], 8, false, 255.0),
            MathFunction::Unpack2x16snorm => self.unpack(a[0], 16, true, 32767.0),
            MathFunction::Unpack2x16unorm => self.unpack(a[0], 16, false, 65535.0),
            MathFunction::Unpack2x16float => {
                let halves = self.fields(a[0], 16, false);
                halves.into_iter().map(|half| self.un(UnOp::UnpackHalf, half)).collect()
            }
            MathFunction::Inverse => return Err(Fail::unsupported("the inverse of a matrix", None)),
            _ => return Ok(None),
        }))
    }

    fn componentwise(&mut self, fun: MathFunction, kind: ScalarKind, w: &[Val]) -> Result<Val, Fail> {
        let by = |float: BinOp, signed: BinOp, unsigned: BinOp| match kind {
            ScalarKind::Float => float,
            ScalarKind::Sint => signed,
            _ => unsigned,
        };
        let (min, max) = (by(BinOp::MinF, BinOp::MinI, BinOp::MinU), by(BinOp::MaxF, BinOp::MaxI, BinOp::MaxU));
        let a = w[0];
        Ok(match fun {
            MathFunction::Abs => match kind {
                ScalarKind::Float => self.un(UnOp::AbsF, a),
                ScalarKind::Sint => self.un(UnOp::AbsI, a),
                _ => a,
            },
            MathFunction::Sign => self.un(if kind == ScalarKind::Float { UnOp::SignF } else { UnOp::SignI }, a),
            MathFunction::Min => self.bin(min, a, w[1]),
            MathFunction::Max => self.bin(max, a, w[1]),
            MathFunction::Clamp => {
                let low = self.bin(max, a, w[1]);
                self.bin(min, low, w[2])
            }
            MathFunction::Saturate => {
                let (zero, one) = (self.float(0.0), self.float(1.0));
                let low = self.bin(BinOp::MaxF, a, zero);
                self.bin(BinOp::MinF, low, one)
            }
            MathFunction::Fract => {
                let floor = self.un(UnOp::Floor, a);
                self.bin(BinOp::SubF, a, floor)
            }
            MathFunction::Radians => {
                let factor = self.constant(0x3c8e_fa35);
                self.bin(BinOp::MulF, a, factor)
            }
            MathFunction::Degrees => {
                let factor = self.constant(0x4265_2ee1);
                self.bin(BinOp::MulF, a, factor)
            }
            MathFunction::Fma => self.define(Op::Tern(TernOp::Fma, a, w[1], w[2])),
            MathFunction::Mix => {
                let one = self.float(1.0);
                let rest = self.bin(BinOp::SubF, one, w[2]);
                let x = self.bin(BinOp::MulF, a, rest);
                let y = self.bin(BinOp::MulF, w[1], w[2]);
                self.bin(BinOp::AddF, x, y)
            }
            MathFunction::Step => {
                let reached = self.bin(BinOp::LeF, a, w[1]);
                let one = self.float(1.0);
                self.bin(BinOp::And, reached, one)
            }
            MathFunction::SmoothStep => self.smooth_step(a, w[1], w[2]),
            MathFunction::Atan2 => self.bin(BinOp::Atan2, a, w[1]),
            MathFunction::Pow => self.bin(BinOp::Pow, a, w[1]),
            MathFunction::Ldexp => self.bin(BinOp::Ldexp, a, w[1]),
            MathFunction::ExtractBits => self.extract(a, w[1], w[2], kind == ScalarKind::Sint),
            MathFunction::InsertBits => self.insert(a, w[1], w[2], w[3]),
            other => {
                let op =
                    unary_of(other, kind).ok_or_else(|| Fail::unsupported(format!("the builtin {other:?}"), None))?;
                self.un(op, a)
            }
        })
    }

    fn smooth_step(&mut self, low: Val, high: Val, x: Val) -> Val {
        let (zero, one) = (self.float(0.0), self.float(1.0));
        let above = self.bin(BinOp::SubF, x, low);
        let range = self.bin(BinOp::SubF, high, low);
        let ratio = self.bin(BinOp::DivF, above, range);
        let t = self.bin(BinOp::MaxF, ratio, zero);
        let t = self.bin(BinOp::MinF, t, one);
        let square = self.bin(BinOp::MulF, t, t);
        let (two, three) = (self.float(2.0), self.float(3.0));
        let twice = self.bin(BinOp::MulF, two, t);
        let rest = self.bin(BinOp::SubF, three, twice);
        self.bin(BinOp::MulF, square, rest)
    }

    fn length(&mut self, a: &[Val]) -> Val {
        if let [only] = a {
            return self.un(UnOp::AbsF, *only);
        }
        let square = self.dot_f(a, a);
        self.un(UnOp::Sqrt, square)
    }

    fn cross(&mut self, a: &[Val], b: &[Val]) -> Vec<Val> {
        [(1, 2), (2, 0), (0, 1)]
            .into_iter()
            .map(|(i, j)| {
                let x = self.bin(BinOp::MulF, a[i], b[j]);
                let y = self.bin(BinOp::MulF, a[j], b[i]);
                self.bin(BinOp::SubF, x, y)
            })
            .collect()
    }

    fn refract(&mut self, x: &[Val], n: &[Val], eta: Val) -> Rc<[Val]> {
        let (zero, one) = (self.float(0.0), self.float(1.0));
        let d = self.dot_f(n, x);
        let d2 = self.bin(BinOp::MulF, d, d);
        let rest = self.bin(BinOp::SubF, one, d2);
        let eta2 = self.bin(BinOp::MulF, eta, eta);
        let scaled = self.bin(BinOp::MulF, eta2, rest);
        let k = self.bin(BinOp::SubF, one, scaled);
        let total = self.bin(BinOp::LtF, k, zero);
        let root = self.un(UnOp::Sqrt, k);
        let along = self.bin(BinOp::MulF, eta, d);
        let along = self.bin(BinOp::AddF, along, root);
        let bend = |(&x, &n): (&Val, &Val)| {
            let x = self.bin(BinOp::MulF, eta, x);
            let n = self.bin(BinOp::MulF, along, n);
            let refracted = self.bin(BinOp::SubF, x, n);
            self.select(total, zero, refracted)
        };
        x.iter().zip(n).map(bend).collect()
    }

    /// Determinant of a square matrix given by columns, expanded along the first column.
    fn determinant(&mut self, m: &[Val]) -> Val {
        match m.len() {
            4 => {
                let x = self.bin(BinOp::MulF, m[0], m[3]);
                let y = self.bin(BinOp::MulF, m[2], m[1]);
                self.bin(BinOp::SubF, x, y)
            }
            9 => {
                let cross = self.cross(&m[3..6], &m[6..9]);
                self.dot_f(&m[..3], &cross)
            }
            _ => {
                let minors: Vec<Val> = (0..4)
                    .map(|row| {
                        let rest: Vec<Val> = (4..16).filter(|i| i % 4 != row).map(|i| m[i]).collect();
                        self.determinant(&rest)
                    })
                    .collect();
                let terms: Vec<Val> = (0..4).map(|row| self.bin(BinOp::MulF, m[row], minors[row])).collect();
                let sum = self.bin(BinOp::SubF, terms[0], terms[1]);
                let sum = self.bin(BinOp::AddF, sum, terms[2]);
                self.bin(BinOp::SubF, sum, terms[3])
            }
        }
    }

    fn clamp(&mut self, x: Val, low: u32, high: u32, signed: bool) -> Val {
        let (low, high) = (self.constant(low), self.constant(high));
        let (max, min) = if signed { (BinOp::MaxI, BinOp::MinI) } else { (BinOp::MaxU, BinOp::MinU) };
        let x = self.bin(max, x, low);
        self.bin(min, x, high)
    }

    /// The fields of `width` bits of a word, lowest first.
    fn fields(&mut self, word: Val, width: u32, signed: bool) -> Vec<Val> {
        let down = self.constant(32 - width);
        (0..32 / width)
            .map(|i| {
                let up = self.constant(32 - width * (i + 1));
                let top = self.bin(BinOp::Shl, word, up);
                self.bin(if signed { BinOp::ShrI } else { BinOp::ShrU }, top, down)
            })
            .collect()
    }

    fn pack(&mut self, words: &[Val], width: u32, op: UnOp) -> Val {
        let mask = self.constant(u32::MAX >> (32 - width));
        let mut packed = self.constant(0);
        for (i, &word) in words.iter().enumerate() {
            let field = self.un(op, word);
            let field = self.bin(BinOp::And, field, mask);
            let shift = self.constant(width * i as u32);
            let field = self.bin(BinOp::Shl, field, shift);
            packed = self.bin(BinOp::Or, packed, field);
        }
        packed
    }

    fn unpack(&mut self, word: Val, width: u32, signed: bool, scale: f32) -> Rc<[Val]> {
        let (scale, low) = (self.float(scale), self.float(-1.0));
        let fields = self.fields(word, width, signed);
        let convert = if signed { UnOp::IntToFloat } else { UnOp::UintToFloat };
        let widen = |field: Val| {
            let value = self.un(convert, field);
            let value = self.bin(BinOp::DivF, value, scale);
            if signed { self.bin(BinOp::MaxF, value, low) } else { value }
        };
        fields.into_iter().map(widen).collect()
    }

    /// Offset and count clamped to the word, as WGSL says, and 32 − count.
    fn field(&mut self, offset: Val, count: Val) -> (Val, Val, Val) {
        let width = self.constant(32);
        let offset = self.bin(BinOp::MinU, offset, width);
        let room = self.bin(BinOp::Sub, width, offset);
        let count = self.bin(BinOp::MinU, count, room);
        let rest = self.bin(BinOp::Sub, width, count);
        (offset, count, rest)
    }

    fn extract(&mut self, word: Val, offset: Val, count: Val, signed: bool) -> Val {
        let (offset, count, rest) = self.field(offset, count);
        let up = self.bin(BinOp::Sub, rest, offset);
        let top = self.bin(BinOp::Shl, word, up);
        let field = self.bin(if signed { BinOp::ShrI } else { BinOp::ShrU }, top, rest);
        let zero = self.constant(0);
        let empty = self.bin(BinOp::Eq, count, zero);
        self.select(empty, zero, field)
    }

    fn insert(&mut self, word: Val, new: Val, offset: Val, count: Val) -> Val {
        let (offset, count, rest) = self.field(offset, count);
        let (zero, ones) = (self.constant(0), self.constant(u32::MAX));
        let mask = self.bin(BinOp::ShrU, ones, rest);
        let mask = self.bin(BinOp::Shl, mask, offset);
        let empty = self.bin(BinOp::Eq, count, zero);
        let mask = self.select(empty, zero, mask);
        let new = self.bin(BinOp::Shl, new, offset);
        let new = self.bin(BinOp::And, new, mask);
        let keep = self.un(UnOp::Not, mask);
        let old = self.bin(BinOp::And, word, keep);
        self.bin(BinOp::Or, old, new)
    }
}

fn unary_of(fun: MathFunction, kind: ScalarKind) -> Option<UnOp> {
    Some(match fun {
        MathFunction::Cos => UnOp::Cos,
        MathFunction::Cosh => UnOp::Cosh,
        MathFunction::Sin => UnOp::Sin,
        MathFunction::Sinh => UnOp::Sinh,
        MathFunction::Tan => UnOp::Tan,
        MathFunction::Tanh => UnOp::Tanh,
        MathFunction::Acos => UnOp::Acos,
        MathFunction::Asin => UnOp::Asin,
        MathFunction::Atan => UnOp::Atan,
        MathFunction::Asinh => UnOp::Asinh,
        MathFunction::Acosh => UnOp::Acosh,
        MathFunction::Atanh => UnOp::Atanh,
        MathFunction::Ceil => UnOp::Ceil,
        MathFunction::Floor => UnOp::Floor,
        MathFunction::Round => UnOp::Round,
        MathFunction::Trunc => UnOp::Trunc,
        MathFunction::Exp => UnOp::Exp,
        MathFunction::Exp2 => UnOp::Exp2,
        MathFunction::Log => UnOp::Log,
        MathFunction::Log2 => UnOp::Log2,
        MathFunction::Sqrt => UnOp::Sqrt,
        MathFunction::InverseSqrt => UnOp::InverseSqrt,
        MathFunction::QuantizeToF16 => UnOp::QuantizeToF16,
        MathFunction::CountTrailingZeros => UnOp::CountTrailingZeros,
        MathFunction::CountLeadingZeros => UnOp::CountLeadingZeros,
        MathFunction::CountOneBits => UnOp::CountOneBits,
        MathFunction::ReverseBits => UnOp::ReverseBits,
        MathFunction::FirstTrailingBit => UnOp::FirstTrailingBit,
        MathFunction::FirstLeadingBit if kind == ScalarKind::Sint => UnOp::FirstLeadingBitI,
        MathFunction::FirstLeadingBit => UnOp::FirstLeadingBitU,
        _ => return None,
    })
}

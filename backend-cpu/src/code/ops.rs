//! Operations: what an instruction does to words.
//!
//! One list of pairs ([`pairs`]) serves the instruction, its meaning and its SIMD forms.

use std::fmt;

use super::Reg;

/// Declares operations and the list of them all.
macro_rules! operations {
    ($(#[$meta:meta])* $name:ident { $($(#[$op_meta:meta])* $op:ident),* $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[allow(missing_docs, reason = "named as the WGSL operators and builtins they are")]
        pub enum $name { $($(#[$op_meta])* $op),* }

        impl $name {
            /// Every operation.
            pub const ALL: &[$name] = &[$($name::$op),*];
        }
    };
}

operations! {
    /// Operations on one word.
    UnOp {
        Move,
        Not,
        NegI,
        AbsI,
        SignI,
        NegF,
        AbsF,
        SignF,
        Floor,
        Ceil,
        Trunc,
        Round,
        Sqrt,
        InverseSqrt,
        FloatToInt,
        FloatToUint,
        IntToFloat,
        UintToFloat,
        CountOneBits,
        CountLeadingZeros,
        CountTrailingZeros,
        ReverseBits,
        FirstLeadingBitI,
        FirstLeadingBitU,
        FirstTrailingBit,
        Sin,
        Cos,
        Tan,
        Asin,
        Acos,
        Atan,
        Sinh,
        Cosh,
        Tanh,
        Asinh,
        Acosh,
        Atanh,
        Exp,
        Exp2,
        Log,
        Log2,
        QuantizeToF16,
        PackHalf,
        UnpackHalf,
        PackSnorm8,
        PackUnorm8,
        PackSnorm16,
        PackUnorm16,
        FrexpFraction,
        FrexpExponent,
    }
}

operations! {
    /// Operations on two words.
    BinOp {
        Add,
        Sub,
        Mul,
        /// ⌊a b / 2^32⌋: no WGSL operation, but one that lowering finds.
        MulHigh,
        /// The same of i32.
        MulHighI,
        And,
        Or,
        Xor,
        Shl,
        ShrU,
        ShrI,
        DivU,
        DivI,
        RemU,
        RemI,
        MinU,
        MaxU,
        MinI,
        MaxI,
        Eq,
        Ne,
        LtU,
        LeU,
        LtI,
        LeI,
        AddF,
        SubF,
        MulF,
        DivF,
        RemF,
        MinF,
        MaxF,
        EqF,
        NeF,
        LtF,
        LeF,
        Atan2,
        Pow,
        Ldexp,
    }
}

/// Operations on three words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "named as the WGSL builtins they are")]
pub enum TernOp {
    /// `a` where the third operand is true, else `b`: operands are (condition, accept, reject).
    Select,
    Fma,
}

operations! {
    /// Operations on four words: what 64-bit arithmetic in two words and determinants are made of.
    QuadOp {
        /// `a * b + c * d`.
        MulMulAdd,
        /// `a * b - c * d`.
        MulMulSub,
        /// `(a << b) | (c >> d)`.
        ShlShrOr,
        /// `a + b`, and 1 more where `c < d`: the upper word of a sum.
        AddCarry,
        /// `a - b`, and 1 less where `c < d`: the upper word of a difference.
        SubBorrow,
        /// `(a == b) & (c < d)`.
        EqLtU,
        /// Whether 2^32 a + c is less than 2^32 b + d.
        LtWide,
        /// Whether it is not.
        GeWide,
    }
}

operations! {
    /// Comparisons that control flow makes itself. Integers need no negated forms: `!(a < b)` is `b <= a`.
    Compare {
        Eq,
        Ne,
        LtU,
        LeU,
        LtI,
        LeI,
        EqF,
        NeF,
        LtF,
        LeF,
        /// Not less, or not ordered.
        NotLtF,
        /// Not less or equal, or not ordered.
        NotLeF,
    }
}

impl BinOp {
    /// The comparison whose truth this operation computes.
    pub(crate) fn comparison(self) -> Option<Compare> {
        Some(match self {
            BinOp::Eq => Compare::Eq,
            BinOp::Ne => Compare::Ne,
            BinOp::LtU => Compare::LtU,
            BinOp::LeU => Compare::LeU,
            BinOp::LtI => Compare::LtI,
            BinOp::LeI => Compare::LeI,
            BinOp::EqF => Compare::EqF,
            BinOp::NeF => Compare::NeF,
            BinOp::LtF => Compare::LtF,
            BinOp::LeF => Compare::LeF,
            _ => return None,
        })
    }
}

/// A condition of control flow: passed where `a op b` holds.
#[derive(Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "operands are named by their role")]
pub struct Test<R = Reg> {
    pub op: Compare,
    pub a: R,
    pub b: R,
}

impl<R: Copy> Test<R> {
    /// Passed where this test fails.
    pub(crate) fn negated(self) -> Self {
        let Test { op, a, b } = self;
        match op {
            Compare::Eq => Test { op: Compare::Ne, a, b },
            Compare::Ne => Test { op: Compare::Eq, a, b },
            Compare::LtU => Test { op: Compare::LeU, a: b, b: a },
            Compare::LeU => Test { op: Compare::LtU, a: b, b: a },
            Compare::LtI => Test { op: Compare::LeI, a: b, b: a },
            Compare::LeI => Test { op: Compare::LtI, a: b, b: a },
            Compare::EqF => Test { op: Compare::NeF, a, b },
            Compare::NeF => Test { op: Compare::EqF, a, b },
            Compare::LtF => Test { op: Compare::NotLtF, a, b },
            Compare::LeF => Test { op: Compare::NotLeF, a, b },
            Compare::NotLtF => Test { op: Compare::LtF, a, b },
            Compare::NotLeF => Test { op: Compare::LeF, a, b },
        }
    }

    pub(crate) fn map<Q>(self, f: &mut impl FnMut(R, bool) -> Q) -> Test<Q> {
        Test { op: self.op, a: f(self.a, false), b: f(self.b, false) }
    }
}

impl<R: fmt::Debug> fmt::Debug for Test<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}({:?}, {:?})", self.op, self.a, self.b)
    }
}

/// Read-modify-write operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "named as the WGSL builtins they are")]
pub enum AtomicOp {
    Add,
    Sub,
    And,
    Or,
    Xor,
    MinU,
    MaxU,
    MinI,
    MaxI,
    Exchange,
    CompareExchange,
}

impl QuadOp {
    /// Whether it is made of two products.
    pub(crate) const fn is_product(self) -> bool {
        matches!(self, QuadOp::MulMulAdd | QuadOp::MulMulSub)
    }
}

impl BinOp {
    /// Whether operands may change places.
    pub(crate) const fn is_commutative(self) -> bool {
        use BinOp::{Add, And, Eq, MaxI, MaxU, MinI, MinU, Mul, MulHigh, MulHighI, Ne, Or, Xor};
        matches!(self, Add | Mul | MulHigh | MulHighI | And | Or | Xor | Eq | Ne | MinU | MaxU | MinI | MaxI)
    }
}

/// Hands the list of pairs to a macro: name, first operation and what its right operand is (a row of lanes, or a word
/// that all share), second operation and what its other operand is, and on which side of the second operation the
/// result of the first stands. `left` is `(a first b) second c`, `right` is `c second (a first b)`; `a` is a row.
macro_rules! pairs {
    ($then:ident) => {
        $then! {
            ShrXor = ShrU word Xor row left,
            ShrAnd = ShrU word And word left,
            ShrOr = ShrU word Or row left,
            ShrAdd = ShrU word Add row left,
            ShrMul = ShrU word Mul word left,
            ShrShr = ShrU word ShrU row left,
            ShrRowOr = ShrU row Or row left,
            ShrRowAnd = ShrU row And word left,
            ShlOr = Shl word Or row left,
            ShlAdd = Shl word Add row left,
            ShlAddWord = Shl word Add word left,
            ShlRowOr = Shl row Or row left,
            ShlRest = Shl word Sub row right,
            ShlShr = Shl row ShrU word left,
            AndAdd = And word Add row left,
            AndAddWord = And word Add word left,
            AndOr = And word Or row left,
            AndEq = And word Eq word left,
            AndNe = And word Ne word left,
            AndShl = And word Shl word left,
            AndMul = And word Mul word left,
            AndAnd = And row And row left,
            AndRowOr = And row Or row left,
            AndRowAdd = And row Add row left,
            AndRowRest = And row Sub row right,
            AndRowNe = And row Ne word left,
            OrAnd = Or row And row left,
            OrAndWord = Or row And word left,
            OrOr = Or row Or row left,
            OrEq = Or row Eq word left,
            OrNe = Or row Ne word left,
            XorXor = Xor row Xor row left,
            XorXorWord = Xor row Xor word left,
            XorAnd = Xor row And word left,
            XorAdd = Xor row Add row left,
            XorSub = Xor row Sub row left,
            XorMul = Xor row Mul word left,
            AddAdd = Add row Add row left,
            AddAddWord = Add row Add word left,
            AddSub = Add row Sub row left,
            AddRest = Add row Sub row right,
            AddAnd = Add row And word left,
            AddShr = Add row ShrU word left,
            AddShrI = Add row ShrI word left,
            AddLtU = Add row LtU row left,
            AddWordAnd = Add word And word left,
            AddWordLtU = Add word LtU word left,
            AddWordMul = Add word Mul word left,
            SubAdd = Sub row Add row left,
            SubSub = Sub row Sub row left,
            SubRest = Sub row Sub row right,
            SubMul = Sub row Mul row left,
            SubMulWord = Sub row Mul word left,
            MulAdd = Mul row Add row left,
            MulSub = Mul row Sub row left,
            MulRest = Mul row Sub row right,
            MulWordAdd = Mul word Add row left,
            MulWordAddWord = Mul word Add word left,
            MulWordSub = Mul word Sub row left,
            MulWordRest = Mul word Sub row right,
            MulHighRest = MulHigh row Sub row right,
            MulHighIAdd = MulHighI row Add row left,
            MulHighIWordAdd = MulHighI word Add row left,
            MaxIMinI = MaxI word MinI word left,
            MaxIAdd = MaxI word Add word left,
            EqAnd = Eq word And row left,
            EqOr = Eq word Or row left,
            EqRowAnd = Eq row And row left,
            NeAnd = Ne word And row left,
            NeOr = Ne word Or row left,
            LtUAnd = LtU row And row left,
            LtUOr = LtU row Or row left,
            LtUWordAnd = LtU word And row left,
            LtUWordOr = LtU word Or row left,
            LtIAnd = LtI word And row left,
            LtIOr = LtI word Or row left,
            LtIRowAnd = LtI row And row left,
            LeUAnd = LeU row And row left,
            LeUOr = LeU row Or row left,
            // A truth value is −1: subtracting a comparison adds one where it holds, adding it takes one away.
            LtUMore = LtU row Sub row right,
            LtULess = LtU row Add row left,
            NeMore = Ne word Sub row right,
            NeFrom = Ne word Sub row left,
            NeLess = Ne word Add row left,
            EqMore = Eq word Sub row right,
            EqLess = Eq word Add row left,
            LtIMore = LtI word Sub row right,
            LtILess = LtI word Add row left,
            LeIMore = LeI row Sub row right,
            MulFAddF = MulF row AddF row left,
            MulFSubF = MulF row SubF row left,
            MulFRest = MulF row SubF row right,
            MulFMulF = MulF row MulF word left,
            MulFWordAddF = MulF word AddF row left,
            MulFWordAddFWord = MulF word AddF word left,
            AddFAddF = AddF row AddF row left,
            AddFMulF = AddF row MulF word left,
            DivFMulF = DivF row MulF row left,
            SubFAddF = SubF row AddF row left,
        }
    };
}
pub(crate) use pairs;

/// What kind of operand a pair takes, as written in the list.
pub(crate) const fn is_word(kind: &str) -> bool {
    kind.len() == "word".len()
}

/// The two operations of a pair, as [`Pair::of`] is asked for them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Parts {
    pub(crate) first: BinOp,
    pub(crate) second: BinOp,
    /// Whether the operands `b` and `c` are words.
    pub(crate) words: [bool; 2],
    /// Whether the first one's result is the left operand of the second.
    pub(crate) left: bool,
}

macro_rules! declare_pairs {
    ($($pair:ident = $first:ident $b:ident $second:ident $c:ident $side:ident),* $(,)?) => {
/// Two binary operations in one.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[allow(missing_docs, reason = "named after their operations")]
        pub enum Pair {
            $($pair,)*
            /// `(a ^ (a >> b)) * c`: the step of many hashes.
            XorShrMul,
        }

        impl Pair {
            /// Every pair.
            pub const ALL: &[Pair] = &[$(Pair::$pair,)* Pair::XorShrMul];

            const PARTS: &[(Parts, Pair)] = &[$((
                Parts {
                    first: BinOp::$first,
                    second: BinOp::$second,
                    words: [is_word(stringify!($b)), is_word(stringify!($c))],
                    left: is_left(stringify!($side)),
                },
                Pair::$pair,
            )),*];

            /// The pair of two operations.
            pub(crate) fn of(parts: Parts) -> Option<Pair> {
                Self::PARTS.iter().find(|entry| entry.0 == parts).map(|entry| entry.1)
            }

            /// The two operations of a pair; [`Pair::XorShrMul`] has three.
            #[cfg(test)]
            pub(crate) fn parts(self) -> Option<Parts> {
                Self::PARTS.iter().find(|entry| entry.1 == self).map(|entry| entry.0)
            }
        }
    };
}

const fn is_left(side: &str) -> bool {
    side.len() == "left".len()
}

pairs!(declare_pairs);

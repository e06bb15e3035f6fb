//! Several operations in one pass over the lanes: pairs, and choices by a comparison.
//!
//! What a pass saves is loads and stores of registers and the fetch of an instruction, which cost more than most
//! operations do.

use fearless_simd::{Simd, u32x16};

use super::lanes::{Lanes, for_comparison, op};
use super::rows::{At, Operand, Row, Rows, operands, pass};
use crate::code::{Compare, Pair, QuadOp, Reg, Test, is_word, pairs};

/// `dst = op(a, b, c)`, on a vector register; `a` is a row, and what the others are is the pair's.
pub(super) fn pair<S: Simd>(s: S, r: &Rows<'_>, pair: Pair, dst: Reg, [a, b, c]: [Reg; 3]) {
    s.vectorize(
        #[inline(always)]
        move || {
            let (dst, a) = (r.operand(dst), r.operand(a));
            operands!(r, [b, c] => pair_row(s, pair, dst, a, b, c));
        },
    );
}

#[inline(always)]
fn pair_row<S: Simd, B: Operand<S>, C: Operand<S>>(s: S, pair: Pair, dst: Row<'_>, a: Row<'_>, b: B, c: C) {
    macro_rules! second {
        ($op:ident left, $t:expr, $at:expr) => {
            c.after::<op::$op>(s, $t, $at)
        };
        ($op:ident right, $t:expr, $at:expr) => {
            op::$op::apply(s, c.at(s, $at), $t)
        };
    }
    macro_rules! passes {
        ($($pair:ident = $first:ident $b:ident $second:ident $c:ident $side:ident),* $(,)?) => {
            match pair {
                // Loops for operands that a pair never has are left out.
                $(Pair::$pair if B::IS_WORD == is_word(stringify!($b)) && C::IS_WORD == is_word(stringify!($c)) => {
                    pass(dst, #[inline(always)] |at| {
                        let t = b.after::<op::$first>(s, a.at(s, at), at);
                        second!($second $side, t, at)
                    });
                })*
                Pair::XorShrMul if B::IS_WORD && C::IS_WORD => {
                    pass(dst, #[inline(always)] |at| {
                        let x = a.at(s, at);
                        c.after::<op::Mul>(s, op::Xor::apply(s, x, b.after::<op::ShrU>(s, x, at)), at)
                    });
                }
                other => unreachable!("{other:?} on operands of other kinds"),
            }
        };
    }
    pairs!(passes);
}

/// `dst = op(a, b, c, d)`, on a vector register; `a` and `c` are rows.
pub(super) fn quad<S: Simd>(s: S, r: &Rows<'_>, op: QuadOp, dst: Reg, [a, b, c, d]: [Reg; 4]) {
    s.vectorize(
        #[inline(always)]
        move || {
            let (dst, a, c) = (r.operand(dst), r.operand(a), r.operand(c));
            operands!(r, [b, d] => quad_row(s, op, dst, (a, b), (c, d)));
        },
    );
}

#[inline(always)]
fn quad_row<'a, S: Simd, B: Operand<S>, D: Operand<S>>(
    s: S,
    op: QuadOp,
    dst: Row<'a>,
    (a, b): (Row<'a>, B),
    (c, d): (Row<'a>, D),
) {
    macro_rules! each {
        (|$at:ident| $form:expr) => {
            pass(
                dst,
                #[inline(always)]
                |$at| $form,
            )
        };
    }
    // A truth value is −1.
    match op {
        QuadOp::MulMulAdd => each!(|at| s.add_u32x16(product(s, a, b, at), product(s, c, d, at))),
        QuadOp::MulMulSub => each!(|at| s.sub_u32x16(product(s, a, b, at), product(s, c, d, at))),
        QuadOp::ShlShrOr => {
            each!(|at| s.or_u32x16(b.after::<op::Shl>(s, a.at(s, at), at), d.after::<op::ShrU>(s, c.at(s, at), at)))
        }
        QuadOp::AddCarry => each!(|at| s.sub_u32x16(s.add_u32x16(a.at(s, at), b.at(s, at)), less(s, c, d, at))),
        QuadOp::SubBorrow => each!(|at| s.add_u32x16(s.sub_u32x16(a.at(s, at), b.at(s, at)), less(s, c, d, at))),
        QuadOp::EqLtU => each!(|at| s.and_u32x16(equal(s, a, b, at), less(s, c, d, at))),
        QuadOp::LtWide => each!(|at| wide_less(s, (a, b), (c, d), at)),
        QuadOp::GeWide => each!(|at| s.not_u32x16(wide_less(s, (a, b), (c, d), at))),
    }
}

#[inline(always)]
fn product<S: Simd>(s: S, a: Row<'_>, b: impl Operand<S>, at: At) -> u32x16<S> {
    s.mul_u32x16(a.at(s, at), b.at(s, at))
}

#[inline(always)]
fn less<S: Simd>(s: S, a: Row<'_>, b: impl Operand<S>, at: At) -> u32x16<S> {
    op::LtU::apply(s, a.at(s, at), b.at(s, at))
}

#[inline(always)]
fn equal<S: Simd>(s: S, a: Row<'_>, b: impl Operand<S>, at: At) -> u32x16<S> {
    op::Eq::apply(s, a.at(s, at), b.at(s, at))
}

/// Whether 2^32 a + c is less than 2^32 b + d.
#[inline(always)]
fn wide_less<S: Simd>(
    s: S,
    (a, b): (Row<'_>, impl Operand<S>),
    (c, d): (Row<'_>, impl Operand<S>),
    at: At,
) -> u32x16<S> {
    s.or_u32x16(less(s, a, b, at), s.and_u32x16(equal(s, a, b, at), less(s, c, d, at)))
}

/// [`crate::code::Inst::Mix`], on a vector register.
pub(super) fn mix<S: Simd>(s: S, r: &Rows<'_>, dst: Reg, a: Reg, by: [Reg; 5]) {
    s.vectorize(
        #[inline(always)]
        move || {
            let (dst, a) = (r.operand(dst), r.operand(a));
            let [first, factor, second, other, last] = by.map(|word| r.scalar(word));
            pass(
                dst,
                #[inline(always)]
                |at| {
                    let x = op::Mul::by(s, folded(s, a.at(s, at), first), factor);
                    folded(s, op::Mul::by(s, folded(s, x, second), other), last)
                },
            );
        },
    );
}

/// `x ^ (x >> by)`.
#[inline(always)]
fn folded<S: Simd>(s: S, x: u32x16<S>, by: u32) -> u32x16<S> {
    s.xor_u32x16(x, op::ShrU::by(s, x, by))
}

/// `dst = test ? accept : reject`, on a vector register; the first operand of the test is a row.
pub(super) fn choose<S: Simd>(s: S, r: &Rows<'_>, test: Test, dst: Reg, arms: [Reg; 2]) {
    let negated = matches!(test.op, Compare::NotLtF | Compare::NotLeF);
    let (test, [accept, reject]) = if negated { (test.negated(), [arms[1], arms[0]]) } else { (test, arms) };
    let Test { op, a, b } = test;
    s.vectorize(
        #[inline(always)]
        move || {
            let (dst, a) = (r.operand(dst), r.operand(a));
            operands!(r, [b, accept, reject] => choose_row(s, op, dst, (a, b), accept, reject));
        },
    );
}

#[inline(always)]
fn choose_row<'a, S: Simd, B: Operand<S>>(
    s: S,
    test: Compare,
    dst: Row<'a>,
    (a, b): (Row<'a>, B),
    accept: impl Operand<S>,
    reject: impl Operand<S>,
) {
    macro_rules! passes {
        ($test:ty) => {
            pass(
                dst,
                #[inline(always)]
                |at| choice(s, b.after::<$test>(s, a.at(s, at), at), accept.at(s, at), reject.at(s, at)),
            )
        };
    }
    for_comparison!(test, passes);
}

/// [`crate::code::Inst::Switch`], on a vector register; `a` is a row.
pub(super) fn switch<S: Simd>(s: S, r: &Rows<'_>, dst: Reg, a: Reg, words: [Reg; 2], [x, y, z]: [Reg; 3]) {
    s.vectorize(
        #[inline(always)]
        move || {
            let (dst, a, [first, second]) = (r.operand(dst), r.operand(a), words.map(|word| r.word(word)));
            operands!(r, [x, y, z] => pass(
                dst,
                #[inline(always)]
                |at| {
                    let other = choice(s, equal(s, a, second, at), y.at(s, at), z.at(s, at));
                    choice(s, equal(s, a, first, at), x.at(s, at), other)
                },
            ));
        },
    );
}

/// `dst = cond ? accept : reject`, on a vector register; `cond` is a row.
pub(super) fn select<S: Simd>(s: S, r: &Rows<'_>, dst: Reg, cond: Reg, [accept, reject]: [Reg; 2]) {
    s.vectorize(
        #[inline(always)]
        move || {
            let (dst, cond) = (r.operand(dst), r.operand(cond));
            operands!(r, [accept, reject] => pass(
                dst,
                #[inline(always)]
                |at| choice(s, cond.at(s, at), accept.at(s, at), reject.at(s, at)),
            ));
        },
    );
}

#[inline(always)]
fn choice<S: Simd>(s: S, truth: u32x16<S>, accept: u32x16<S>, reject: u32x16<S>) -> u32x16<S> {
    s.select_u32x16(s.simd_ne_u32x16(truth, s.splat_u32x16(0)), accept, reject)
}

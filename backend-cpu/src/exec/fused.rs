//! Several operations in one pass over the lanes: pairs, and choices by a comparison.
//!
//! What a pass saves is loads and stores of registers and the fetch of an instruction, which cost more than most
//! operations do. Every loop is compiled for the kinds of its operands, so that nothing is decided inside it.

use std::cell::Cell;

use fearless_simd::{Simd, u32x16};

use super::alu::{Chunk, Rows, load, store};
use super::lanes::{Lanes, for_comparison, op};
use crate::code::{Compare, Pair, QuadOp, Reg, Test, pairs};

/// An operand whose kind is known when the loop is compiled.
trait Operand<S: Simd>: Copy {
    /// Chunk `i`.
    fn at(self, s: S, i: usize) -> u32x16<S>;

    /// `t op` this, on chunk `i`.
    #[inline(always)]
    fn after<O: Lanes>(self, s: S, t: u32x16<S>, i: usize) -> u32x16<S> {
        O::apply(s, t, self.at(s, i))
    }
}

/// A row of lanes.
#[derive(Clone, Copy)]
struct Row<'a>(&'a [Cell<Chunk>]);

/// A word that all lanes share.
#[derive(Clone, Copy)]
struct Word(u32);

impl<S: Simd> Operand<S> for Row<'_> {
    #[inline(always)]
    fn at(self, s: S, i: usize) -> u32x16<S> {
        load(s, &self.0[i])
    }
}

impl<S: Simd> Operand<S> for Word {
    #[inline(always)]
    fn at(self, s: S, _: usize) -> u32x16<S> {
        s.splat_u32x16(self.0)
    }

    #[inline(always)]
    fn after<O: Lanes>(self, s: S, t: u32x16<S>, _: usize) -> u32x16<S> {
        O::by(s, t, self.0)
    }
}

#[inline(always)]
fn row<'a>(r: &Rows<'a>, register: Reg) -> Row<'a> {
    Row(&r.row(register)[..r.high - r.low])
}

#[inline(always)]
fn word(r: &Rows<'_>, register: Reg) -> Word {
    Word(r.scalar(register))
}

/// `dst = f(chunk number)`.
#[inline(always)]
fn pass<S: Simd>(r: &Rows<'_>, dst: Reg, f: impl Fn(usize) -> u32x16<S>) {
    for (i, d) in row(r, dst).0.iter().enumerate() {
        store(d, f(i));
    }
}

/// `dst = op(a, b, c)`, on a vector register.
pub(super) fn pair<S: Simd>(s: S, r: Rows<'_>, pair: Pair, dst: Reg, [a, b, c]: [Reg; 3]) {
    macro_rules! second {
        ($op:ident left, $t:expr, $c:expr, $i:expr) => {
            $c.after::<op::$op>(s, $t, $i)
        };
        ($op:ident right, $t:expr, $c:expr, $i:expr) => {
            op::$op::apply(s, $c.at(s, $i), $t)
        };
    }
    macro_rules! passes {
        ($($pair:ident = $first:ident $b:ident $second:ident $c:ident $side:ident),* $(,)?) => {
            match pair {
                $(Pair::$pair => {
                    let (a, b, c) = (row(&r, a), $b(&r, b), $c(&r, c));
                    pass(&r, dst, #[inline(always)] |i| {
                        let t = b.after::<op::$first>(s, a.at(s, i), i);
                        second!($second $side, t, c, i)
                    });
                })*
                Pair::XorShrMul => {
                    let (a, b, c) = (row(&r, a), word(&r, b), word(&r, c));
                    pass(&r, dst, #[inline(always)] |i| {
                        let x = a.at(s, i);
                        c.after::<op::Mul>(s, op::Xor::apply(s, x, b.after::<op::ShrU>(s, x, i)), i)
                    });
                }
            }
        };
    }
    s.vectorize(
        #[inline(always)]
        || pairs!(passes),
    );
}

/// `dst = op(a, b, c, d)`, on a vector register; `a` and `c` are rows.
pub(super) fn quad<S: Simd>(s: S, r: Rows<'_>, op: QuadOp, dst: Reg, [a, b, c, d]: [Reg; 4]) {
    macro_rules! loops {
        ($b:ident, $d:ident) => {{
            let (a, b, c, d) = (row(&r, a), $b(&r, b), row(&r, c), $d(&r, d));
            macro_rules! each {
                (|$i:ident| $form:expr) => {
                    pass(
                        &r,
                        dst,
                        #[inline(always)]
                        |$i| $form,
                    )
                };
            }
            // A truth value is −1.
            match op {
                QuadOp::MulMulAdd => each!(|i| s.add_u32x16(product(s, a, b, i), product(s, c, d, i))),
                QuadOp::MulMulSub => each!(|i| s.sub_u32x16(product(s, a, b, i), product(s, c, d, i))),
                QuadOp::ShlShrOr => {
                    each!(|i| s.or_u32x16(b.after::<op::Shl>(s, a.at(s, i), i), d.after::<op::ShrU>(s, c.at(s, i), i)))
                }
                QuadOp::AddCarry => each!(|i| s.sub_u32x16(s.add_u32x16(a.at(s, i), b.at(s, i)), less(s, c, d, i))),
                QuadOp::SubBorrow => each!(|i| s.add_u32x16(s.sub_u32x16(a.at(s, i), b.at(s, i)), less(s, c, d, i))),
                QuadOp::EqLtU => each!(|i| s.and_u32x16(equal(s, a, b, i), less(s, c, d, i))),
                QuadOp::LtWide => {
                    each!(|i| { s.or_u32x16(less(s, a, b, i), s.and_u32x16(equal(s, a, b, i), less(s, c, d, i))) })
                }
                QuadOp::GeWide => each!(|i| {
                    s.not_u32x16(s.or_u32x16(less(s, a, b, i), s.and_u32x16(equal(s, a, b, i), less(s, c, d, i))))
                }),
            }
        }};
    }
    s.vectorize(
        #[inline(always)]
        || match (b.is_scalar(), d.is_scalar()) {
            (false, false) => loops!(row, row),
            (false, true) => loops!(row, word),
            (true, false) => loops!(word, row),
            (true, true) => loops!(word, word),
        },
    );
}

#[inline(always)]
fn product<S: Simd>(s: S, a: Row<'_>, b: impl Operand<S>, i: usize) -> u32x16<S> {
    s.mul_u32x16(a.at(s, i), b.at(s, i))
}

#[inline(always)]
fn less<S: Simd>(s: S, a: Row<'_>, b: impl Operand<S>, i: usize) -> u32x16<S> {
    op::LtU::apply(s, a.at(s, i), b.at(s, i))
}

#[inline(always)]
fn equal<S: Simd>(s: S, a: Row<'_>, b: impl Operand<S>, i: usize) -> u32x16<S> {
    op::Eq::apply(s, a.at(s, i), b.at(s, i))
}

/// [`crate::code::Inst::Mix`], on a vector register.
pub(super) fn mix<S: Simd>(s: S, r: Rows<'_>, dst: Reg, a: Reg, by: [Reg; 5]) {
    let [first, factor, second, other, last] = by;
    let (first, second, last) = (r.scalar(first), r.scalar(second), r.scalar(last));
    let (factor, other) = (r.scalar(factor), r.scalar(other));
    s.vectorize(
        #[inline(always)]
        || {
            let a = row(&r, a);
            pass(
                &r,
                dst,
                #[inline(always)]
                |i| {
                    let x = op::Mul::by(s, folded(s, a.at(s, i), first), factor);
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

/// Calls a macro with the kinds of two operands that are chosen from.
macro_rules! arms {
    ($accept:ident, $reject:ident, $choices:ident, $($test:tt)*) => {
        match ($accept.is_scalar(), $reject.is_scalar()) {
            (false, false) => $choices!($($test)*, row, row),
            (false, true) => $choices!($($test)*, row, word),
            (true, false) => $choices!($($test)*, word, row),
            (true, true) => $choices!($($test)*, word, word),
        }
    };
}

/// `dst = test ? accept : reject`, on a vector register; the first operand of the test is a row.
pub(super) fn choose<S: Simd>(s: S, r: Rows<'_>, test: Test, dst: Reg, arms: [Reg; 2]) {
    let negated = matches!(test.op, Compare::NotLtF | Compare::NotLeF);
    let (test, [accept, reject]) = if negated { (test.negated(), [arms[1], arms[0]]) } else { (test, arms) };
    let Test { op: test, a, b } = test;
    macro_rules! choices {
        ($test:ty, $b:ident, $accept:ident, $reject:ident) => {{
            let (a, b, accept, reject) = (row(&r, a), $b(&r, b), $accept(&r, accept), $reject(&r, reject));
            pass(
                &r,
                dst,
                #[inline(always)]
                |i| choice(s, b.after::<$test>(s, a.at(s, i), i), accept.at(s, i), reject.at(s, i)),
            );
        }};
    }
    macro_rules! kinds {
        ($test:ty) => {
            if b.is_scalar() {
                arms!(accept, reject, choices, $test, word)
            } else {
                arms!(accept, reject, choices, $test, row)
            }
        };
    }
    s.vectorize(
        #[inline(always)]
        || for_comparison!(test, kinds),
    );
}

/// `dst = cond ? accept : reject`, on a vector register; `cond` is a row.
pub(super) fn select<S: Simd>(s: S, r: Rows<'_>, dst: Reg, cond: Reg, [accept, reject]: [Reg; 2]) {
    macro_rules! choices {
        ($cond:ident, $accept:ident, $reject:ident) => {{
            let (cond, accept, reject) = ($cond(&r, cond), $accept(&r, accept), $reject(&r, reject));
            pass(
                &r,
                dst,
                #[inline(always)]
                |i| choice(s, cond.at(s, i), accept.at(s, i), reject.at(s, i)),
            );
        }};
    }
    s.vectorize(
        #[inline(always)]
        || arms!(accept, reject, choices, row),
    );
}

#[inline(always)]
fn choice<S: Simd>(s: S, truth: u32x16<S>, accept: u32x16<S>, reject: u32x16<S>) -> u32x16<S> {
    s.select_u32x16(s.simd_ne_u32x16(truth, s.splat_u32x16(0)), accept, reject)
}

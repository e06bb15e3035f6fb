//! Folding, algebra and idioms against the plain operations: every rule on words where it could go wrong, and
//! expressions without pattern.
//!
//! An expression is evaluated twice: as it is written, by the scalar semantics, and as the builder makes it. A rule is
//! named together with an operation that it must leave out, so that a rule that never applies is a failure too.

use sightlines_backend::{Linked, Program};

use super::build::Builder;
use super::tree::{Builtin, Op, Tree, Val};
use super::{Options, lower};
use crate::CodeLimits;
use crate::code::{BinOp, Code, Inst, TernOp, UnOp};
use crate::semantics::{binary, ternary, unary};

use BinOp::{Add, And, DivU, Eq, LeI, LeU, LtI, LtU, MinU, Mul, MulHigh, MulHighI, Ne, Or, RemU, Shl, ShrU, Sub, Xor};
use UnOp::{AbsI, NegI, Not};

/// Words at which integer rules change their behaviour.
const EDGES: [u32; 22] = [
    0,
    1,
    2,
    3,
    15,
    16,
    17,
    31,
    32,
    33,
    63,
    0x7fff,
    0xffff,
    0x1_0000,
    0x1_0001,
    0x7fff_ffff,
    0x8000_0000,
    0x8000_0001,
    0xffff_0000,
    0xffff_7fff,
    0xffff_fffe,
    0xffff_ffff,
];

/// An expression of inputs and words.
#[derive(Clone, Debug)]
enum Ex {
    In(u8),
    Word(u32),
    Un(UnOp, Box<Ex>),
    Bin(BinOp, Box<Ex>, Box<Ex>),
    Select(Box<[Ex; 3]>),
}

fn un(op: UnOp, a: &Ex) -> Ex {
    Ex::Un(op, Box::new(a.clone()))
}

fn bin(op: BinOp, a: &Ex, b: &Ex) -> Ex {
    Ex::Bin(op, Box::new(a.clone()), Box::new(b.clone()))
}

fn with(op: BinOp, a: &Ex, word: u32) -> Ex {
    bin(op, a, &Ex::Word(word))
}

fn select(cond: &Ex, accept: &Ex, reject: &Ex) -> Ex {
    Ex::Select(Box::new([cond, accept, reject].map(Ex::clone)))
}

impl Ex {
    fn value(&self, inputs: [u32; 3]) -> u32 {
        match self {
            Ex::In(index) => inputs[*index as usize],
            Ex::Word(word) => *word,
            Ex::Un(op, a) => unary(*op, a.value(inputs)),
            Ex::Bin(op, a, b) => binary(*op, a.value(inputs), b.value(inputs)),
            Ex::Select(args) => {
                let [cond, accept, reject] = args.each_ref().map(|arg| arg.value(inputs));
                ternary(TernOp::Select, cond, accept, reject)
            }
        }
    }

    fn build(&self, builder: &mut Builder<'_>) -> Val {
        match self {
            Ex::In(index) => builder.define(Op::Builtin(Builtin::GlobalId(*index))),
            Ex::Word(word) => builder.constant(*word),
            Ex::Un(op, a) => {
                let a = a.build(builder);
                builder.define(Op::Un(*op, a))
            }
            Ex::Bin(op, a, b) => {
                let (a, b) = (a.build(builder), b.build(builder));
                builder.define(Op::Bin(*op, a, b))
            }
            Ex::Select(args) => {
                let [cond, accept, reject] = args.each_ref().map(|arg| arg.build(builder));
                builder.define(Op::Tern(TernOp::Select, cond, accept, reject))
            }
        }
    }
}

/// The value of what the builder made.
fn value(tree: &Tree, val: Val, inputs: [u32; 3]) -> u32 {
    let of = |val: Val| value(tree, val, inputs);
    match tree.op(val) {
        Op::Const(word) => word,
        Op::Builtin(Builtin::GlobalId(index)) => inputs[index as usize],
        Op::Un(op, a) => unary(op, of(a)),
        Op::Bin(op, a, b) => binary(op, of(a), of(b)),
        Op::Tern(op, a, b, c) => ternary(op, of(a), of(b), of(c)),
        other => unreachable!("{other:?} is not made of arithmetic"),
    }
}

/// Whether what the builder made has an operation that a rule should have left out.
fn has(tree: &Tree, val: Val, gone: &dyn Fn(Op) -> bool) -> bool {
    let mut found = gone(tree.op(val));
    tree.op(val).operands(|operand| found |= has(tree, operand, gone));
    found
}

/// Calls `f` with the tree and the value that become of an expression.
fn built(expression: &Ex, f: impl FnOnce(&Tree, Val)) {
    let module = naga::front::wgsl::parse_str("@compute @workgroup_size(1) fn main() {}").expect("it parses");
    let flags = naga::valid::ValidationFlags::all();
    let info = naga::valid::Validator::new(flags, naga::valid::Capabilities::empty()).validate(&module);
    let info = info.expect("it is valid");
    let options = Options { count: false, limits: CodeLimits::default() };
    let mut builder = Builder::new(&module, &info, [1, 1, 1], 0, options);
    let val = expression.build(&mut builder);
    f(&builder.tree, val);
}

#[track_caller]
fn agrees(expression: &Ex, tree: &Tree, val: Val, inputs: [u32; 3]) {
    let (got, want) = (value(tree, val, inputs), expression.value(inputs));
    assert_eq!(got, want, "{expression:?} of {inputs:x?} became {:?}", tree.vals);
}

/// `expression` is the same on all edge words, and has no operation for which `gone` holds.
#[track_caller]
fn rule(expression: &Ex, gone: impl Fn(Op) -> bool) {
    built(expression, |tree, val| {
        assert!(!has(tree, val, &gone), "no rule applied to {expression:?}: {:?}", tree.vals);
        for a in EDGES {
            for b in EDGES {
                for c in [0, 1, 31, 0x8000_0000, 0xffff_ffff] {
                    agrees(expression, tree, val, [a, b, c]);
                }
            }
        }
    });
}

fn is(op: BinOp) -> impl Fn(Op) -> bool {
    move |other| matches!(other, Op::Bin(same, ..) if same == op)
}

fn is_select(op: Op) -> bool {
    matches!(op, Op::Tern(TernOp::Select, ..))
}

const X: Ex = Ex::In(0);
const Y: Ex = Ex::In(1);

#[test]
fn rules_on_truth_values_hold() {
    let less = bin(LtU, &X, &Y);
    let (zero, one, ones) = (Ex::Word(0), Ex::Word(1), Ex::Word(u32::MAX));
    rule(&bin(Add, &X, &select(&less, &one, &zero)), is(And));
    rule(&bin(Sub, &X, &select(&less, &one, &zero)), is(And));
    rule(&bin(Add, &select(&less, &one, &zero), &X), is(And));
    rule(&select(&less, &ones, &zero), is_select);
    rule(&select(&less, &zero, &ones), is_select);
    rule(&select(&less, &X, &zero), is_select);
    rule(&select(&less, &ones, &X), is_select);
    rule(&select(&less, &zero, &one), is_select);
    rule(&select(&un(Not, &less), &X, &Y), |op| matches!(op, Op::Un(Not, _)));
    rule(&select(&with(LtI, &X, 0), &un(NegI, &X), &X), is_select);
    rule(&with(Ne, &with(And, &less, 1), 0), is(Ne));
    rule(&with(Eq, &with(And, &less, 1), 0), is(Eq));
    for op in [Eq, Ne, LtU, LeU, LtI, LeI] {
        rule(&un(Not, &bin(op, &X, &Y)), |op| matches!(op, Op::Un(Not, _)));
        rule(&un(Not, &un(Not, &bin(op, &X, &Y))), |op| matches!(op, Op::Un(Not, _)));
        rule(&select(&bin(op, &Ex::Word(7), &X), &X, &Y), |op| matches!(op, Op::Bin(LtU | LeU, a, _) if a.0 == 0));
    }
}

#[test]
fn rules_on_integers_hold() {
    let chain = |op: BinOp, a, b| with(op, &with(op, &X, a), b);
    for word in EDGES {
        rule(&with(Sub, &X, word), is(Sub));
        rule(&bin(Sub, &Ex::Word(0), &with(Add, &X, word)), is(Sub));
        for other in EDGES {
            rule(&chain(Add, word, other), |_| false);
            rule(&chain(And, word, other), |_| false);
            rule(&with(And, &with(ShrU, &X, word), other), |_| false);
            rule(&with(LeU, &with(And, &X, word), other), |_| false);
            rule(&with(LtU, &with(MinU, &X, word), other), |_| false);
            rule(&bin(LtU, &Ex::Word(word), &with(RemU, &X, other)), |_| false);
            rule(&bin(LeU, &Ex::Word(word), &with(ShrU, &X, other)), |_| false);
        }
    }
    for by in 0..=33u32 {
        for more in [0, 1, 15, 16, 31, 32, 33] {
            rule(&chain(Shl, by, more), |_| false);
            rule(&chain(ShrU, by, more), |_| false);
        }
        rule(&with(DivU, &X, 1 << (by % 32)), is(DivU));
        rule(&with(RemU, &X, 1 << (by % 32)), is(RemU));
    }
    rule(&with(Ne, &with(ShrU, &X, 31), 0), is(ShrU));
    rule(&with(Eq, &with(And, &X, 0x8000_0000), 0), is(And));
    rule(&bin(Shl, &Ex::Word(0), &X), is(Shl));
    rule(&bin(ShrU, &Ex::Word(0), &X), is(ShrU));
    rule(&bin(Add, &X, &un(NegI, &Y)), |op| matches!(op, Op::Un(NegI, _)));
    rule(&bin(Sub, &X, &un(NegI, &Y)), |op| matches!(op, Op::Un(NegI, _)));
}

#[test]
fn bounds_decide_comparisons_and_masks() {
    let small = with(RemU, &X, 12);
    rule(&with(LeU, &small, 31), is(LeU));
    rule(&with(And, &small, 31), is(And));
    rule(&with(LtU, &small, 11), |op| matches!(op, Op::Const(u32::MAX)));
    rule(&bin(LtU, &Ex::Word(15), &with(RemU, &Y, 15)), is(LtU));
    rule(&with(LtU, &bin(Add, &small, &with(And, &Y, 7)), 23), is(LtU));
    rule(&with(LeU, &bin(Xor, &small, &with(And, &Y, 64)), 127), is(LeU));
    rule(&with(LeU, &bin(Mul, &small, &small), 225), is(LeU));
    rule(&with(LeU, &with(Shl, &small, 4), 240), is(LeU));
    rule(&with(LtU, &with(ShrU, &Y, 28), 16), is(LtU));
    rule(&with(MinU, &un(UnOp::CountLeadingZeros, &Y), 32), is(MinU));
}

/// ⌊x y / 2^32⌋ in 16-bit halves.
fn high(x: &Ex, y: &Ex) -> Ex {
    let (xl, xh, yl, yh) = (with(And, x, 0xffff), with(ShrU, x, 16), with(And, y, 0xffff), with(ShrU, y, 16));
    let t = bin(Add, &bin(Mul, &xh, &yl), &with(ShrU, &bin(Mul, &xl, &yl), 16));
    let u = bin(Add, &bin(Mul, &xl, &yh), &with(And, &t, 0xffff));
    bin(Add, &bin(Add, &bin(Mul, &xh, &yh), &with(ShrU, &t, 16)), &with(ShrU, &u, 16))
}

#[test]
fn idioms_hold() {
    rule(&high(&X, &Y), is(Mul));
    rule(&high(&X, &Ex::Word(0x1234_5678)), is(Mul));
    // A factor that has no upper half.
    rule(&high(&with(And, &X, 0xffff), &Y), is(Mul));
    let negative = |x: &Ex| with(LtI, x, 0);
    let (zero, product) = (Ex::Word(0), high(&X, &Y));
    let signed = bin(Sub, &product, &select(&negative(&X), &Y, &zero));
    let signed = bin(Sub, &signed, &select(&negative(&Y), &X, &zero));
    rule(&signed, |op| is(MulHigh)(op) || is(Sub)(op));
    built(&signed, |tree, val| assert!(has(tree, val, &is(MulHighI))));
    let by_constant =
        bin(Sub, &high(&X, &Ex::Word(0x1234_5678)), &select(&negative(&X), &Ex::Word(0x1234_5678), &zero));
    rule(&by_constant, is(Sub));
}

/// Expressions without pattern.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 33) as usize % end
    }

    fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    fn word(&mut self, depth: u32) -> Ex {
        if depth == 0 || self.below(6) == 0 {
            return if self.below(3) == 0 { Ex::Word(self.pick(&EDGES)) } else { Ex::In(self.below(3) as u8) };
        }
        match self.below(10) {
            0 => un(self.pick(&[Not, NegI, AbsI, UnOp::CountLeadingZeros]), &self.word(depth - 1)),
            1 | 2 => select(&self.truth(depth - 1), &self.word(depth - 1), &self.word(depth - 1)),
            3 => with(And, &self.truth(depth - 1), 1),
            4 => bin(And, &self.truth(depth - 1), &self.word(depth - 1)),
            _ => {
                let plain = BinOp::ALL.iter().copied().take_while(|op| *op != Eq).collect::<Vec<_>>();
                bin(self.pick(&plain), &self.word(depth - 1), &self.word(depth - 1))
            }
        }
    }

    fn truth(&mut self, depth: u32) -> Ex {
        match self.below(4) {
            0 if depth > 0 => un(Not, &self.truth(depth - 1)),
            1 if depth > 0 => bin(self.pick(&[And, Or, Xor]), &self.truth(depth - 1), &self.truth(depth - 1)),
            _ => {
                let op = self.pick(&[Eq, Ne, LtU, LeU, LtI, LeI]);
                bin(op, &self.word(depth.saturating_sub(1)), &self.word(depth.saturating_sub(1)))
            }
        }
    }
}

#[test]
fn expressions_without_pattern_keep_their_value() {
    for seed in 0..4000 {
        let mut random = Random(seed);
        random.below(2);
        let expression = random.word(1 + seed as u32 % 6);
        built(&expression, |tree, val| {
            for _ in 0..100 {
                agrees(&expression, tree, val, std::array::from_fn(|_| random.pick(&EDGES)));
            }
        });
    }
}

/// The code of a kernel of 256 lanes, `body` its statements.
fn code(body: &str) -> Code {
    let text = format!(
        "@group(0) @binding(0) var<storage, read_write> words: array<u32>;
@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group: vec3u, @builtin(global_invocation_id) id: vec3u) {{ {body} }}"
    );
    let linked = Linked::single("body.wgsl", &text).expect("it is text");
    let program = Program::unlinted("body", linked).expect("it is valid");
    lower(&program, "main", &[], Options { count: false, limits: CodeLimits::default() }).expect("it can be lowered")
}

#[test]
fn choices_by_one_word_are_switches() {
    let code = code(
        "let x = words[id.x];
        var y = x + 9u;
        y = select(y, x * 3u, x == 5u);
        y = select(y, 4u, x == 6u);
        y = select(y, x + 2u, x == 7u);
        words[id.x] = select(y, 1u, x < 3u);",
    );
    let count = |f: fn(&Inst) -> bool| code.insts.iter().filter(|inst| f(inst)).count();
    assert_eq!(count(|inst| matches!(inst, Inst::Switch { .. })), 1, "{code}");
    assert_eq!(count(|inst| matches!(inst, Inst::Choose { .. })), 2, "{code}");
}

#[test]
fn workgroups_share_a_gang_where_they_go_together() {
    assert!(code("words[id.x] = group.x * 3u;").mergeable);
    assert!(code("for (var i = id.x; i < 256u * group.x; i += 9u) { words[id.x] += i; }").mergeable);
    assert!(!code("for (var i = 0u; i < group.x; i++) { words[id.x] += i; }").mergeable, "lanes would part");
    assert!(!code("words[id.x] = words[group.x];").mergeable, "one load would become as many as there are lanes");
}

//! Atomics of a gang: what its active lanes do to words, in the order of lanes.
//!
//! Invariant: memory and results are those of one lane after the other. Where that cannot show, lanes are taken
//! together: those that meet in one word without looking at what it held, and those that draw from one counter.

use fearless_simd::Simd;

use super::mask::{CHUNK, Exec};
use super::memory::{Outside, SharedWord};
use super::rows::Rows;
use crate::code::{AtomicArgs, AtomicOp, Reg};
use crate::semantics;

/// Applies an atomic operation for each active lane.
pub(super) fn atomic<S: Simd, T: SharedWord>(
    s: S,
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    args: &AtomicArgs,
) -> Option<Outside> {
    s.vectorize(
        #[inline(always)]
        || match (args.compare, args.dst, args.op) {
            (Some(compare), _, _) => {
                each(r, exec, words, args, |word, lane, value| word.compare_exchange(r.lane(compare, lane), value))
            }
            (None, None, op) if args.addr.is_scalar() => {
                let total = combine(r, exec, op, args.value)?;
                once(r, exec, words, args, |word| word.update(op, total)).1
            }
            (None, Some(dst), AtomicOp::Add) if args.addr.is_scalar() => draw(r, exec, words, args, dst),
            (None, Some(_), op) => each(r, exec, words, args, |word, _, value| word.update(op, value)),
            // The operation is known where the loop is compiled.
            (None, None, AtomicOp::Add) => scatter(r, exec, words, args, AtomicOp::Add),
            (None, None, AtomicOp::Or) => scatter(r, exec, words, args, AtomicOp::Or),
            (None, None, AtomicOp::MinU) => scatter(r, exec, words, args, AtomicOp::MinU),
            (None, None, op) => scatter(r, exec, words, args, op),
        },
    )
}

/// The word at an index, the last one where it is past the end, and that.
#[inline(always)]
fn find<'a, T>(words: &'a [T], index: u32, lane: usize, outside: &mut Option<Outside>) -> Option<&'a T> {
    words.get(index as usize).or_else(|| {
        outside.get_or_insert(Outside { lane, index, length: words.len() as u32 });
        words.last()
    })
}

/// Changes the word that all lanes address; what `change` makes of it, 0 where there is no word.
fn once<T>(
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    args: &AtomicArgs,
    change: impl FnOnce(&T) -> u32,
) -> (u32, Option<Outside>) {
    let mut outside = None;
    let lane = exec.mask.first_lane().unwrap_or(0);
    let word = find(words, r.scalar(args.addr).wrapping_add(args.offset), lane, &mut outside);
    (word.map_or(0, change), outside)
}

/// Changes the word of each active lane; old words go where the results go, if anywhere.
#[inline(always)]
fn each<T>(
    r: Rows<'_>,
    exec: &Exec,
    words: &[T],
    args: &AtomicArgs,
    change: impl Fn(&T, usize, u32) -> u32,
) -> Option<Outside> {
    let mut outside = None;
    for i in exec.low..exec.high {
        let (places, values) = (r.chunk(args.addr, i), r.chunk(args.value, i));
        let mut old = args.dst.map_or([0; CHUNK], |dst| r.chunk(dst, i));
        for lane in lanes(exec.mask.chunk(i)) {
            let place = i * CHUNK + lane;
            let word = find(words, places[lane].wrapping_add(args.offset), place, &mut outside);
            old[lane] = word.map_or(0, |word| change(word, place, values[lane]));
        }
        if let Some(dst) = args.dst {
            r.set_chunk(dst, i, old);
        }
    }
    outside
}

/// Changes the word of each active lane, and forgets what it held.
#[inline(always)]
fn scatter<T: SharedWord>(r: Rows<'_>, exec: &Exec, words: &[T], args: &AtomicArgs, op: AtomicOp) -> Option<Outside> {
    let mut outside = None;
    for i in exec.low..exec.high {
        let bits = exec.mask.chunk(i);
        let (mut places, values) = (r.chunk(args.addr, i), r.chunk(args.value, i));
        places.iter_mut().for_each(|place| *place = place.wrapping_add(args.offset));
        let mut change = |lane: usize, value: u32| {
            if let Some(word) = find(words, places[lane], i * CHUNK + lane, &mut outside) {
                word.update(op, value);
            }
        };
        if bits != u16::MAX {
            lanes(bits).for_each(|lane| change(lane, values[lane]));
        } else if places.iter().fold(0, |other, place| other | (place ^ places[0])) == 0 {
            let total = values.into_iter().reduce(|sum, value| semantics::atomic(joint(op), sum, value));
            change(0, total.unwrap_or(0));
        } else {
            (0..CHUNK).for_each(|lane| change(lane, values[lane]));
        }
    }
    outside
}

/// Lanes that draw from one counter: each finds what those before it have left.
fn draw<T: SharedWord>(r: Rows<'_>, exec: &Exec, words: &[T], args: &AtomicArgs, dst: Reg) -> Option<Outside> {
    if words.is_empty() {
        return each(r, exec, words, args, |_, _, _| 0);
    }
    let total = combine(r, exec, AtomicOp::Add, args.value)?;
    let (mut sum, outside) = once(r, exec, words, args, |word| word.update(AtomicOp::Add, total));
    for i in exec.low..exec.high {
        let (values, mut old) = (r.chunk(args.value, i), r.chunk(dst, i));
        for lane in lanes(exec.mask.chunk(i)) {
            old[lane] = sum;
            sum = sum.wrapping_add(values[lane]);
        }
        r.set_chunk(dst, i, old);
    }
    outside
}

/// One operand that does to a word what the operands of all active lanes do, in order.
fn combine(r: Rows<'_>, exec: &Exec, op: AtomicOp, value: Reg) -> Option<u32> {
    let op = joint(op);
    let join = |sum, value| semantics::atomic(op, sum, value);
    (exec.low..exec.high)
        .flat_map(|i| {
            let values = r.chunk(value, i);
            lanes(exec.mask.chunk(i)).map(move |lane| values[lane])
        })
        .reduce(join)
}

/// What joins two operands to one.
fn joint(op: AtomicOp) -> AtomicOp {
    match op {
        // A difference of many is the difference of their sum.
        AtomicOp::Sub => AtomicOp::Add,
        op => op,
    }
}

/// Lanes of a chunk.
#[inline(always)]
fn lanes(mut bits: u16) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits.wrapping_sub(1);
        (lane < CHUNK).then_some(lane)
    })
}

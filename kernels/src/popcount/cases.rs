//! From no receiver to the soft shadow of a disc on 512² receivers under 32² light samples.
//!
//! Small cases run all four methods in one job; real ones run one method each, so that they can be compared in time.
//! Outputs of small cases are four words longer than their receivers, and those words must keep their mark.

use sightlines_backend::{Case, Expected, Job, Size};

use super::{Method, Popcount, Shape, oracle};
use crate::{pieces, random};

/// Words past the end of an output, and what they hold before and after.
const SLACK: usize = 4;
const MARK: u32 = 0x5eed_5eed;

pub(super) fn all() -> Vec<Case> {
    let shape = |receivers, samples, bits| Shape { receivers, samples, bits };
    let mut cases = vec![
        small("nothing", shape(0, 32, 32), |_, _| u32::MAX, &[0]),
        small("one_receiver", shape(1, 32, 32), |_, _| 0x8421_1248, &[0]),
        small("one_sample", shape(300, 1, 1), |_, r| r, &[0, 1, 255, 256]),
        small("one_past_group", shape(257, 64, 32), random::word, &[0, 255, 256]),
        small("each_single_bit", shape(1024, 1024, 32), |w, r| u32::from(r / 32 == w) << (r % 32), &[0, 31, 1023]),
        small("each_run_of_bits", shape(1025, 1024, 32), run_of_bits, &[0, 1, 31, 32, 33, 1023, 1024]),
        small("none_and_all", shape(512, 1024, 32), |_, r| 0_u32.wrapping_sub(r % 2), &[0, 1, 510, 511]),
        small("stray_bits", shape(259, 33, 32), |_, _| u32::MAX, &[0, 258]),
        small("four_channels_124", shape(1000, 124, 31), random::word, &[0, 1, 999]),
        small("eight_targets_992", shape(777, 992, 31), random::word, &[0, 1, 776]),
    ];
    cases.extend(Method::ALL.map(disc_shadow));
    cases.push(more_than_a_dispatch());
    cases
}

/// Receiver r has its lowest r samples hidden.
fn run_of_bits(word: u32, receiver: u32) -> u32 {
    let bits = receiver.saturating_sub(32 * word).min(32);
    ((1_u64 << bits) - 1) as u32
}

fn planes(shape: Shape, mask: fn(u32, u32) -> u32) -> Vec<u32> {
    (0..shape.words()).flat_map(|word| (0..shape.receivers.max(1)).map(move |r| mask(word, r))).collect()
}

fn small(name: &str, shape: Shape, mask: fn(u32, u32) -> u32, probes: &[u32]) -> Case {
    let job = move || {
        let kernel = Popcount::new()?;
        let mut job = Job::new();
        let masks = job.slice("masks", &planes(shape, mask));
        for method in Method::ALL {
            let marks = vec![MARK; shape.receivers as usize + SLACK];
            let hidden = job.slice("hidden", &marks);
            let visible = job.slice("visible", &marks);
            kernel.record(&mut job, method, shape, masks, hidden, visible)?;
            job.read(format!("hidden.{}", method.entry()), hidden.id());
            job.read(format!("visible.{}", method.entry()), visible.id());
        }
        Ok(job)
    };
    let expected = move |_: &_| {
        let masks = planes(shape, mask);
        let marked = |mut words: Vec<u32>| {
            words.extend([MARK; SLACK]);
            Expected::Whole(words)
        };
        let hidden = oracle::hidden(shape, &masks);
        let pair = [marked(hidden.clone()), marked(oracle::visible(shape, &hidden))];
        Method::ALL.iter().flat_map(|_| pair.clone()).collect()
    };
    Case::new(name, Size::Small, job, expected).probes(probes.iter().copied())
}

fn real(name: String, shape: Shape, method: Method, masks: fn(Shape) -> Vec<u32>, probes: &[u32]) -> Case {
    let job = move || {
        let kernel = Popcount::new()?;
        let mut job = Job::new();
        let masks = job.slice("masks", &masks(shape));
        pieces::cut(&mut job);
        let hidden = job.zeroed("hidden", u64::from(shape.receivers));
        let visible = job.zeroed("visible", u64::from(shape.receivers));
        kernel.record(&mut job, method, shape, masks, hidden, visible)?;
        job.read("hidden", hidden.id());
        job.read("visible", visible.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let hidden = oracle::hidden(shape, &masks(shape));
        let visible = oracle::visible(shape, &hidden);
        vec![Expected::Whole(hidden), Expected::Whole(visible)]
    };
    Case::new(name, Size::Real, job, expected).probes(probes.iter().copied())
}

const SIDE: u32 = 512;

fn disc_shadow(method: Method) -> Case {
    let shape = Shape { receivers: SIDE * SIDE, samples: 1024, bits: 32 };
    let middle = SIDE / 2 * SIDE;
    let probes = [0, middle, middle + 100, middle + 128, middle + 256, SIDE * SIDE - 1];
    real(format!("disc_shadow_{}", method.entry()), shape, method, disc_masks, &probes)
}

/// Hidden samples of a disc midway between a square light of 32 by 32 samples, 8 texels apart, and a receiver of 512 by
/// 512 texels, all centred: light row `word`, bit i is hidden where the midpoint of both points lies in the disc.
fn disc_masks(shape: Shape) -> Vec<u32> {
    // Four times the distances of midpoints, so that all are integers.
    const RADIUS: i64 = 400;
    const SPACING: i64 = 8;
    const LIGHT: i64 = 31 * SPACING;
    let side = i64::from(SIDE);
    let mut masks = Vec::with_capacity((shape.receivers * shape.words()) as usize);
    for word in 0..i64::from(shape.words()) {
        for y in 0..side {
            let dy = 2 * y + 1 - side + 2 * word * SPACING - LIGHT;
            let square = RADIUS * RADIUS - dy * dy;
            masks.extend((0..side).map(|x| hidden_row(2 * x + 1 - side - LIGHT, square, 2 * SPACING)));
        }
    }
    masks
}

/// Bits i of 32 for which (start + i · spacing)² <= square.
fn hidden_row(start: i64, square: i64, spacing: i64) -> u32 {
    if square < 0 {
        return 0;
    }
    let half = square.isqrt();
    let first = (-half - start + spacing - 1).div_euclid(spacing).clamp(0, 32);
    let end = ((half - start).div_euclid(spacing) + 1).clamp(first, 32);
    (((1_u64 << end) - 1) & !((1_u64 << first) - 1)) as u32
}

/// One receiver more than 65,535 workgroups have.
fn more_than_a_dispatch() -> Case {
    let shape = Shape { receivers: 65_535 * 256 + 1, samples: 20, bits: 32 };
    let masks = |shape: Shape| random::words(9, shape.receivers as usize);
    let last = shape.receivers - 1;
    real("more_than_a_dispatch".into(), shape, Method::Builtin, masks, &[0, 1, last / 2, last - 1, last])
}

//! From no word to 16 Mi + 3: one to three levels, and every edge of a four, a workgroup and a tile.
//!
//! Small cases take both sums in one job. Their inputs are followed by words that must be ignored, their outputs by
//! words that must keep their mark.

use sightlines_backend::{Case, Expected, Job, Size};

use super::{Kind, Scan, TILE, oracle};
use crate::{pieces, random};

/// Words past the end of buffers, and what they hold.
const SLACK: usize = 4;
const MARK: u32 = 0x5eed_5eed;

const REAL: u32 = (16 << 20) + 3;

pub(super) fn all() -> Vec<Case> {
    vec![
        small("nothing", 0, |_| 0),
        small("one", 1, |_| u32::MAX),
        small("three", 3, |i| i + 5),
        small("one_group", 256, |i| i),
        small("one_past_group", 257, |i| random::word(1, i) >> 20),
        small("one_past_quarter", TILE / 4 + 1, |i| random::word(2, i) >> 20),
        small("one_short_of_tile", TILE - 1, |i| random::word(3, i) >> 20),
        small("one_tile", TILE, |_| 1),
        small("one_past_tile", TILE + 1, |i| random::word(4, i) >> 20),
        small("zeros", 10_000, |_| 0),
        small("full_range", 70_001, |i| random::word(5, i)),
        small("all_ones_bits", 50_000, |_| u32::MAX),
        real("counts", Kind::Inclusive, |i| random::word(6, i) >> 24),
        real("compaction", Kind::Exclusive, |i| random::word(7, i) & 1),
    ]
}

fn padded(count: u32, value: fn(u32) -> u32) -> Vec<u32> {
    let mut words: Vec<u32> = (0..count).map(value).collect();
    words.resize(words.len().next_multiple_of(4) + SLACK, MARK);
    words
}

fn small(name: &str, count: u32, value: fn(u32) -> u32) -> Case {
    const KINDS: [(Kind, &str); 2] = [(Kind::Inclusive, "inclusive"), (Kind::Exclusive, "exclusive")];
    let job = move || {
        let kernel = Scan::new()?;
        let mut job = Job::new();
        let input = job.slice("input", &padded(count, value));
        for (kind, label) in KINDS {
            let output = job.slice("output", &vec![MARK; input.len() as usize]);
            kernel.record(&mut job, kind, count, input, output)?;
            job.read(label, output.id());
        }
        Ok(job)
    };
    let expected = move |_: &_| {
        let input: Vec<u32> = (0..count).map(value).collect();
        let answer = |(kind, _)| {
            let mut sums = oracle::scan(kind, &input);
            sums.resize(sums.len().next_multiple_of(4), 0);
            sums.extend([MARK; SLACK]);
            Expected::Whole(sums)
        };
        KINDS.map(answer).to_vec()
    };
    let probes = [0, 1, count / 2, count.saturating_sub(1), count];
    Case::new(name, Size::Small, job, expected).probes(distinct(probes))
}

fn real(name: &str, kind: Kind, value: fn(u32) -> u32) -> Case {
    let job = move || {
        let kernel = Scan::new()?;
        let mut job = Job::new();
        let input = job.slice("input", &padded(REAL, value));
        pieces::cut(&mut job);
        let output = job.zeroed("output", input.len());
        kernel.record(&mut job, kind, REAL, input, output)?;
        job.read("output", output.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let input: Vec<u32> = (0..REAL).map(value).collect();
        let mut sums = oracle::scan(kind, &input);
        sums.resize(sums.len().next_multiple_of(4) + SLACK, 0);
        vec![Expected::Whole(sums)]
    };
    let probes = [0, 1, TILE - 1, TILE, TILE * TILE - 1, TILE * TILE, REAL - 1, REAL];
    Case::new(name, Size::Real, job, expected).probes(distinct(probes))
}

fn distinct<const N: usize>(probes: [u32; N]) -> Vec<u32> {
    let mut probes = probes.to_vec();
    probes.sort_unstable();
    probes.dedup();
    probes
}

//! Damaged files: small valid ones of every kind, cut, changed and shuffled in thousands of seeded ways.
//!
//! What a reader should find here is that no damage makes a loader panic or leaves its user without a file and a
//! remedy; which damage gives which message is the matter of the tests beside each loader.

mod every;
mod seeds;

use std::panic::{AssertUnwindSafe, catch_unwind};

use every::{KINDS, check, mend_digest};

/// Mutations of each seed.
const ROUNDS: u64 = 1000;

/// Numbers from a seed (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }

    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}

/// Words that text files are hurt with.
const WORDS: [&str; 16] = [
    "-1",
    "0",
    "1e38",
    "1e-320",
    "nan",
    "inf",
    "4294967295",
    "18446744073709551616",
    "null",
    "[",
    "{",
    "\"",
    "\n",
    " ",
    "\u{feff}",
    "x",
];

/// Numbers that binary files are hurt with.
const NUMBERS: [u32; 10] =
    [0, 1, 2, 0x7f, 0xff, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff, f32::NAN.to_bits(), f32::INFINITY.to_bits()];

/// Hurts a file once.
fn hurt(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len());
    let end = (at + 1 + random.below(40)).min(bytes.len());
    match random.below(8) {
        0 => bytes[at..].iter_mut().take(1).for_each(|byte| *byte ^= 1 << random.below(8)),
        1 => bytes.truncate(at),
        2 => drop(bytes.drain(at..end)),
        3 => {
            let piece = bytes[at..end].to_vec();
            let to = random.below(bytes.len() + 1);
            bytes.splice(to..to, piece);
        }
        4 => {
            let number = random.one(&NUMBERS).to_le_bytes();
            let place = at / 4 * 4;
            bytes[place..].iter_mut().zip(number).for_each(|(byte, new)| *byte = new);
        }
        5 => drop(bytes.splice(at..at, random.one(&WORDS).bytes())),
        _ => {
            // One word in place of another.
            let word = |byte: &u8| byte.is_ascii_alphanumeric() || b".-+_".contains(byte);
            let start = bytes[..at].iter().rposition(|b| !word(b)).map_or(0, |before| before + 1);
            let end = bytes[at..].iter().position(|b| !word(b)).map_or(bytes.len(), |after| at + after);
            bytes.splice(start..end, random.one(&WORDS).bytes());
        }
    }
}

#[test]
fn every_seed_is_read() {
    for (kind, bytes) in seeds::all() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a").with_extension(kind);
        std::fs::write(&path, bytes).unwrap();
        every::read(kind, &path).unwrap_or_else(|error| panic!("{kind}: {error}"));
    }
    let kinds: Vec<&str> = seeds::all().iter().map(|(kind, _)| *kind).collect();
    assert!(KINDS.iter().all(|kind| kinds.contains(kind)), "{kinds:?}");
}

#[test]
fn no_damage_is_met_with_a_panic_or_a_message_without_a_file() {
    let folder = tempfile::tempdir().unwrap();
    for (number, (kind, whole)) in (0..).zip(seeds::all()) {
        for round in 0..ROUNDS {
            let mut random = Random(number << 32 | round);
            let mut bytes = whole.clone();
            (0..1 + random.below(3)).for_each(|_| hurt(&mut bytes, &mut random));
            if random.below(2) == 0 && ["sets", "occl", "seen"].contains(&kind) {
                mend_digest(&mut bytes);
            }
            let done = catch_unwind(AssertUnwindSafe(|| check(folder.path(), kind, &bytes)));
            assert!(done.is_ok(), "{kind}, seed {number}, round {round}:\n{}", String::from_utf8_lossy(&bytes));
        }
    }
}

/// Pictures, whose sizes stand before their texels, are cut everywhere.
#[test]
fn pictures_cut_anywhere_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (kind, whole) in seeds::all().into_iter().filter(|(kind, _)| ["hdr", "exr"].contains(kind)) {
        for length in (0..whole.len()).step_by(7) {
            let path = folder.path().join(length.to_string()).with_extension(kind);
            std::fs::write(&path, &whole[..length]).unwrap();
            assert!(every::read(kind, &path).is_err(), "{length} of {} bytes", whole.len());
        }
    }
}

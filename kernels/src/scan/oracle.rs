//! The definition: a running sum modulo 2³².

use super::Kind;

/// The prefix sums of `input`.
pub fn scan(kind: Kind, input: &[u32]) -> Vec<u32> {
    let mut sum = 0_u32;
    let mut sums = Vec::with_capacity(input.len());
    for &word in input {
        let before = sum;
        sum = sum.wrapping_add(word);
        sums.push(match kind {
            Kind::Inclusive => sum,
            Kind::Exclusive => before,
        });
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random;

    #[test]
    fn known_sums() {
        assert_eq!(scan(Kind::Inclusive, &[3, 1, 4, 1]), [3, 4, 8, 9]);
        assert_eq!(scan(Kind::Exclusive, &[3, 1, 4, 1]), [0, 3, 4, 8]);
        assert_eq!(scan(Kind::Inclusive, &[u32::MAX, 2]), [u32::MAX, 1]);
        assert_eq!(scan(Kind::Inclusive, &[]), []);
    }

    #[test]
    fn differences_of_the_sums_are_the_input() {
        for seed in 0..64 {
            let input = random::words(seed, 1 + seed as usize * 37);
            let inclusive = scan(Kind::Inclusive, &input);
            let exclusive = scan(Kind::Exclusive, &input);
            for i in 0..input.len() {
                assert_eq!(inclusive[i].wrapping_sub(exclusive[i]), input[i], "seed {seed}, word {i}");
            }
            assert_eq!(exclusive[0], 0);
            assert_eq!(exclusive[1..], inclusive[..input.len() - 1]);
        }
    }
}

//! The definition: sample by sample, a bit is set or it is not.

use super::Shape;

/// Number of hidden samples of every receiver.
pub fn hidden(shape: Shape, masks: &[u32]) -> Vec<u32> {
    let mut hidden = vec![0; shape.receivers as usize];
    for word in 0..shape.words() {
        let samples = shape.bits.min(shape.samples - word * shape.bits);
        let plane = (word * shape.receivers) as usize;
        for bit in 0..samples {
            for (count, mask) in hidden.iter_mut().zip(&masks[plane..]) {
                *count += mask >> bit & 1;
            }
        }
    }
    hidden
}

/// Number of visible samples of every receiver: all that are not hidden.
pub fn visible(shape: Shape, hidden: &[u32]) -> Vec<u32> {
    hidden.iter().map(|count| shape.samples - count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random;

    #[test]
    fn it_counts_what_the_library_counts() {
        let shape = Shape { receivers: 100, samples: 5 * 32, bits: 32 };
        let masks = random::words(1, 500);
        let counted = hidden(shape, &masks);
        for receiver in 0..100 {
            let expected: u32 = (0..5).map(|word| masks[word * 100 + receiver].count_ones()).sum();
            assert_eq!(counted[receiver], expected, "receiver {receiver}");
        }
    }

    #[test]
    fn bits_that_are_no_samples_do_not_count() {
        let shape = Shape { receivers: 2, samples: 40, bits: 31 };
        let masks = [u32::MAX; 4];
        assert_eq!(hidden(shape, &masks), [40, 40]);
        assert_eq!(visible(shape, &[40, 40]), [0, 0]);
        assert_eq!(hidden(shape, &[0x8000_0000, 0, 0xffff_fe00, 1]), [0, 1]);
        assert_eq!(visible(shape, &[0, 1]), [40, 39]);
    }
}

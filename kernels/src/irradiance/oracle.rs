//! The definition, sample by sample, in i128: what a receiver sees of a group, and what that sends to it.

use super::{Groups, UNIT};
use crate::field::{Field, Receiver};
use crate::pattern::Pattern;

/// cos a cos b / d^2 of a sample at (x, y, 0), which faces +z, and a receiver with a normal of length [`UNIT`]: in
/// units of 2^-48 a square cell, rounded down after each division by the square of the distance.
pub fn weight(receiver: [i32; 3], normal: [i32; 3], sample: [i32; 2]) -> u64 {
    let w = [receiver[0] - sample[0], receiver[1] - sample[1], receiver[2]].map(i128::from);
    let facing = -(0..3).map(|i| i128::from(normal[i]) * w[i]).sum::<i128>();
    if facing <= 0 {
        return 0;
    }
    let square: i128 = w.iter().map(|c| c * c).sum();
    // Two cosines, in units of 2^-31.
    let cosines = facing * w[2] * (1 << 31) / (i128::from(UNIT) * square);
    (cosines * (1 << 17) / square) as u64
}

/// Visible samples and sum of weights of one group at one receiver, whose mask has the pattern's words.
pub fn sums(
    pattern: &Pattern,
    groups: &Groups,
    group: u32,
    receiver: &Receiver,
    normal: [i32; 3],
    mask: &[u32],
) -> (u32, u64) {
    if !receiver.is_there() {
        return (0, 0);
    }
    let hidden = |s: u32| mask[(s / pattern.bits()) as usize] >> (s % pattern.bits()) & 1 != 0;
    let seen = (0..pattern.count()).filter(|s| groups.holds(pattern, group, *s) && !hidden(*s));
    let weights = seen.map(|s| {
        let [x, y, _] = pattern.at(s);
        weight(receiver.at, normal, [x + receiver.shift[0], y + receiver.shift[1]])
    });
    weights.fold((0, 0), |(count, sum), weight| (count + 1, sum + weight))
}

/// Both outputs of all groups and receivers, in the kernel's order, of masks in theirs.
pub fn all(pattern: &Pattern, groups: &Groups, field: &Field, normals: &[[i32; 3]], masks: &[u32]) -> [Vec<u32>; 2] {
    let count = field.count() as usize;
    let (mut visible, mut light) = (Vec::new(), Vec::new());
    for group in 0..groups.count() {
        for (index, receiver) in field.receivers().iter().enumerate() {
            let mask: Vec<u32> = masks.iter().skip(index).step_by(count).copied().collect();
            let (seen, sum) = sums(pattern, groups, group, receiver, normals[index], &mask);
            visible.push(seen);
            light.extend([sum as u32, (sum >> 32) as u32]);
        }
    }
    [visible, light]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weight_is_the_kernel_of_the_form_factor() {
        assert_eq!(weight([0, 0, 1], [0, 0, -UNIT], [0, 0]), 1 << 48, "a cell away, face to face");
        assert_eq!(weight([0, 0, 16], [0, 0, -UNIT], [0, 0]), 1 << 40);
        assert_eq!(weight([0, 0, 16], [0, 0, UNIT], [0, 0]), 0, "turned away");
        assert_eq!(weight([16, 0, 16], [0, 0, -UNIT], [0, 0]), 1 << 38, "half the cosines, half the rest");
        for (r, n, s) in
            [([900, -20, 7000], [100, 0, -32767], [-300, 80]), ([-16384, 0, 900], [-20000, 9000, -20000], [16383, 5])]
        {
            let w = [r[0] - s[0], r[1] - s[1], r[2]].map(f64::from);
            let square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
            let facing = -(w[0] * f64::from(n[0]) + w[1] * f64::from(n[1]) + w[2] * f64::from(n[2])) / f64::from(UNIT);
            let want = facing.max(0.0) * w[2] / (square * square) * (1u64 << 48) as f64;
            let found = weight(r, n, s) as f64;
            assert!((found - want).abs() <= 1.0 + 131_072.0 / square, "{found} and {want}");
        }
    }
}

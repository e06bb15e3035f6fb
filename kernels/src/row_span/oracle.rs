//! The sets of every receiver by the definition alone: one determinant after the other, in i128.

use crate::grid::{Faces, Receivers, Samples, Triangle, hidden_set_by};

/// Words of the masks of all receivers: word w of receiver r at `w * receivers + r`.
pub fn sets(samples: &Samples, receivers: &Receivers, triangles: &[Triangle]) -> Vec<u32> {
    sets_by(Faces::Both, samples, receivers, triangles)
}

/// The same of triangles that hide by `faces`.
pub fn sets_by(faces: Faces, samples: &Samples, receivers: &Receivers, triangles: &[Triangle]) -> Vec<u32> {
    let count = receivers.count() as usize;
    let mut words = vec![0; count * samples.words() as usize];
    for receiver in 0..count {
        let mask = hidden_set_by(faces, receivers.at(receiver as u32), samples, triangles);
        mask.into_iter().enumerate().for_each(|(w, word)| words[w * count + receiver] = word);
    }
    words
}

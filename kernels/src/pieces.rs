//! Dispatches in pieces: no recording runs for long, whatever the size of the work.
//!
//! A device's watchdog ends a submission of seconds, one dispatch has at most 65,535 workgroups a dimension, and
//! progress must show. So a kernel numbers its workgroups from a `first` that the host gives, and the host launches
//! ranges of them. Invariants: pieces cover every workgroup once and in order, and there is at least one, so that a
//! kernel is launched, and shown to write nothing, even for no items.

use std::ops::Range;

use sightlines_backend::Job;

/// Words of memory that the workgroups of one recording may touch: milliseconds for a GPU, a second or two for the
/// slowest software device.
pub const WORDS: u64 = 1 << 23;

/// Most workgroups that a device accepts in one dimension.
pub const MAX_GROUPS: u32 = 65_535;

/// Even ranges of `groups` workgroups that touch `words` words each.
pub fn pieces(groups: u32, words: u64) -> impl Iterator<Item = Range<u32>> {
    let groups = groups.max(1);
    let most = (WORDS / words.max(1)).clamp(1, u64::from(MAX_GROUPS)) as u32;
    let even = groups.div_ceil(groups.div_ceil(most));
    (0..groups).step_by(even as usize).map(move |first| first..groups.min(first.saturating_add(even)))
}

/// Calls `launch` for every piece; several pieces have a recording each.
pub fn record(job: &mut Job, groups: u32, words: u64, mut launch: impl FnMut(&mut Job, Range<u32>)) {
    let several = pieces(groups, words).nth(1).is_some();
    for piece in pieces(groups, words) {
        if several {
            cut(job);
        }
        launch(job, piece);
    }
}

/// Begins a new recording, unless the current one is still empty.
pub fn cut(job: &mut Job) {
    if job.recordings.last().is_some_and(|recording| !recording.commands.is_empty()) {
        job.cut();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_cover_every_group_once_and_stay_within_both_limits() {
        for (groups, words) in [(0, 0), (1, 1), (1, u64::MAX), (65_535, 1), (65_536, 1), (70_000, 1 << 13), (9, WORDS)]
        {
            let mut next = 0;
            for piece in pieces(groups, words) {
                assert_eq!(piece.start, next, "{groups} groups of {words} words");
                assert!(!piece.is_empty() && piece.len() <= MAX_GROUPS as usize);
                assert!(piece.len() == 1 || piece.len() as u64 * words <= WORDS);
                next = piece.end;
            }
            assert_eq!(next, groups.max(1));
        }
        assert_eq!(pieces(65_536, 1).count(), 2);
    }

    #[test]
    fn a_cut_leaves_no_empty_recording() {
        let mut job = Job::new();
        cut(&mut job);
        job.upload("words", &[1_u32]);
        cut(&mut job);
        cut(&mut job);
        job.upload("words", &[2_u32]);
        assert_eq!(job.recordings.iter().map(|r| r.commands.len()).collect::<Vec<_>>(), [1, 1]);
    }
}

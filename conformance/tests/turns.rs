//! The case that is made to loop longest takes as many turns as docs/numerics.md derives, and no more.

use sightlines_backend::Backend;
use sightlines_backend_cpu::{Config, CpuBackend};

/// Bound of an invocation of `split`, and what it takes at least where 1999 neighbours have 18,000 regions: a turn to
/// find each neighbour and each region, to divide and to weigh.
const SPLIT: std::ops::RangeInclusive<u64> = 2 * (1999 + 18_000) + 2 * (1999 + 63)..=48_548;

#[test]
fn the_most_regions_that_an_object_meets_stay_within_their_bound() {
    let kernel = sightlines_kernels::registry().iter().find(|kernel| kernel.name == "region_sets").unwrap();
    let case = (kernel.cases)().into_iter().find(|case| case.name == "met_18000").unwrap();
    let backend = CpuBackend::new(Config { count: true, ..Config::default() });
    let job = (case.job)().unwrap();
    let mut session = backend.open(&job.programs, &job.buffers).unwrap();
    job.recordings.iter().for_each(|recording| session.submit(recording).unwrap());
    let turns = session.counts().unwrap().turns;
    assert!(SPLIT.contains(&turns), "{turns} turns of loops, {SPLIT:?} expected");
}

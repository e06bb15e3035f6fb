//! From no pixel to 1024² of them: every weight under every factor, ties of depth, blockers that are none.

use sightlines_backend::{Case, Expected, Job, Size};

use super::{ALL, MAX_WEIGHT, Pictures, Transmittance, oracle};
use crate::random;
use crate::raster::{FAR, NOTHING};

/// Pixels past the last, which keep their weights.
const SLACK: u32 = 3;

/// A pixel's weight, depth, blocker's depth, and blocker.
type Make = fn(u32) -> [u32; 4];

pub(super) fn all() -> Vec<Case> {
    vec![
        case("nothing", Size::Small, 0, &[128], |_| [255, 9, 3, 0], &[0]),
        case("one_past_group", Size::Small, 257, &[64, 256], |p| [255, p, 100, p % 3], &[0, 101, 256, 257]),
        case("each_weight_and_factor", Size::Small, 257 * 256, &FACTORS, |p| [p % 256, 9, 8, p / 256], &[255, 65_791]),
        case("great_weights", Size::Small, 4096, &[255, u32::MAX, 1], |p| [MAX_WEIGHT - p, 9, 8, p % 3], &[0, 1, 2]),
        case(
            "near_and_far",
            Size::Small,
            1000,
            &[100],
            |p| [255, [5, FAR][p as usize % 2], [4, 5, FAR][p as usize % 3], 0],
            &[0, 1, 2, 3, 4, 5],
        ),
        case("no_blockers", Size::Small, 300, &[], |p| [p, 9, 8, [0, NOTHING][p as usize % 2]], &[0, 299]),
        case("square_1024", Size::Real, 1 << 20, &[200, 30, 0, 255, 256, 128, 77], scattered, &[0, 1, (1 << 20) - 1]),
    ]
}

/// Every factor once.
const FACTORS: [u32; 257] = {
    let mut factors = [0; 257];
    let mut i = 0;
    while i <= ALL {
        factors[i as usize] = i;
        i += 1;
    }
    factors
};

fn scattered(pixel: u32) -> [u32; 4] {
    let below = |limit: u32, which: u32| random::below(limit, 50 + which, pixel);
    [below(256, 0), below(1 << 24, 1), below(1 << 24, 2), below(9, 3)]
}

fn case(name: &str, size: Size, pixels: u32, factors: &'static [u32], make: Make, probes: &[u32]) -> Case {
    let column = move |which: usize| (0..pixels + SLACK).map(|pixel| make(pixel)[which]).collect::<Vec<u32>>();
    let job = move || {
        let mut job = Job::new();
        let weights = job.slice("weights", &column(0));
        let depths = job.slice("depths", &column(1));
        let blocker_depths = job.slice("blocker_depths", &column(2));
        let blockers = job.slice("blockers", &column(3));
        let through = job.slice("through", if factors.is_empty() { &[0] } else { factors });
        let pictures = Pictures { pixels, depths, blocker_depths, blockers };
        Transmittance::new()?.record(&mut job, pictures, (factors.len() as u32, through), weights)?;
        job.read("weights", weights.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let weight = |pixel: u32| {
            let [weight, depth, nearer, blocker] = make(pixel);
            let through = factors.get(blocker as usize);
            if pixel < pixels { oracle::weight(weight, depth, through.map(|t| (nearer, *t))) } else { weight }
        };
        vec![Expected::Whole((0..pixels + SLACK).map(weight).collect())]
    };
    Case::new(name, size, job, expected).probes(probes.iter().copied())
}

//! Groups of one to 24 colours and one for each sample, receivers a cell away and a grid away, turned away, shifted,
//! absent.

use sightlines_backend::{Case, Expected, Job, Outputs, Result, Size};

use super::{Groups, Irradiance, Seen, UNIT, oracle};
use crate::exact::oracle::angle::normalize3_q15;
use crate::field::{Field, Receiver};
use crate::grid::{XY, Z};
use crate::pattern::Pattern;
use crate::random;

const SEED: u32 = 41;

/// What a case is made of.
struct Input {
    pattern: Pattern,
    groups: Groups,
    field: Field,
    normals: Vec<[i32; 3]>,
    masks: Vec<u32>,
}

pub(super) fn all() -> Vec<Case> {
    let halton = |count| fits(Pattern::halton([-1000, -900], [2000, 1800], count));
    vec![
        case("no_group_sees", Size::Small, || {
            input(9, 5, fits(Pattern::new(vec![[0, 0]; 33], 32)), |_| 0, |_, _| u32::MAX)
        }),
        case("one_sample", Size::Small, || input(1, 1, fits(Pattern::new(vec![[5, -7]], 32)), |_| 0, |_, _| 0)),
        case("one_group_37", Size::Small, move || input(11, 7, halton(37), |_| 0, random_word)),
        case("two_colours_124", Size::Small, move || {
            input(13, 5, fits(halton(124).with_bits(31)), |s| u32::from(s % 3 == 0), random_word)
        }),
        case("24_colours_992", Size::Small, move || {
            input(8, 8, fits(halton(992).with_bits(31)), |s| random::below(24, SEED, s), random_word)
        }),
        case("a_group_each", Size::Small, move || input(3, 3, halton(100), |s| s, random_word)),
        case("corners_of_the_grid", Size::Small, corners),
        case("nearest", Size::Small, nearest),
        case("square_64_24_colours", Size::Real, move || input(64, 64, halton(1024), |s| s % 24, random_word)),
    ]
}

fn fits<T>(made: Result<T>) -> T {
    made.expect("the cases are on the grid")
}

fn random_word(receiver: u32, word: u32) -> u32 {
    random::word(SEED + 1, 32 * receiver + word)
}

/// Receivers anywhere below a light in the middle, shifted by up to 256 cells, some of them none, and some turned away.
fn input(columns: u32, rows: u32, pattern: Pattern, of: fn(u32) -> u32, mask: fn(u32, u32) -> u32) -> Input {
    let below = |bound: u32, index: u32| random::below(bound, SEED, index) as i32;
    let receiver = |r: u32| {
        let [x, y] = [0, 1].map(|axis| below(2 * XY as u32, 8 * r + axis) - XY);
        let z = if r % 13 == 5 { 0 } else { 1 + below(Z as u32 - 1, 8 * r + 2) };
        Receiver { at: [x, y, z], shift: [3, 4].map(|axis| below(512, 8 * r + axis) - 256) }
    };
    let normal = |r: u32| {
        let [x, y, z] = [5, 6, 7].map(|axis| below(4001, 8 * r + axis) - 2000);
        normalize3_q15([x, y, z - 1500])
    };
    let count = columns * rows;
    let groups = fits(Groups::new(&pattern, &(0..pattern.count()).map(of).collect::<Vec<_>>()));
    let field = fits(Field::new(columns, (0..count).map(receiver).collect()));
    let masks = (0..pattern.words()).flat_map(|word| (0..count).map(move |r| mask(r, word))).collect();
    Input { pattern, groups, field, normals: (0..count).map(normal).collect(), masks }
}

/// The longest distances and the greatest squares, with normals along and against them.
fn corners() -> Input {
    let ends = [-XY, XY - 1];
    let pattern = fits(Pattern::new(ends.map(|x| ends.map(|y| [x, y])).concat(), 32));
    let places: Vec<Receiver> =
        ends.iter().flat_map(|x| ends.map(|y| [1, Z - 1].map(|z| Receiver::new([*x, y, z])))).flatten().collect();
    let toward = |r: &Receiver| {
        let [x, y, z] = r.at;
        normalize3_q15([x, y, z].map(|c| -c / 2))
    };
    let mut normals: Vec<[i32; 3]> = places.iter().map(toward).collect();
    normals[3] = [-UNIT, 0, 0];
    normals[5] = [0; 3];
    let groups = Groups::all(&pattern);
    let masks = vec![0; places.len()];
    Input { groups, field: fits(Field::new(4, places)), normals, masks, pattern }
}

/// A stack of samples a cell away, the greatest sum there is, and distances at which quotients pass 32 bits.
fn nearest() -> Input {
    let pattern = fits(Pattern::new(vec![[0, 0]; 1024], 32));
    let receiver = |z: i32| Receiver::new([0, 0, z]);
    let places: Vec<Receiver> = [1, 2, 255, 256, 257, 181, 1 << 14, Z - 1].map(receiver).to_vec();
    let masks = vec![0; 32 * places.len()];
    let normals = vec![[0, 0, -UNIT]; places.len()];
    Input { groups: Groups::all(&pattern), field: fits(Field::new(8, places)), normals, masks, pattern }
}

fn case(name: &str, size: Size, make: impl Fn() -> Input + Copy + Send + Sync + 'static) -> Case {
    let job = move || {
        let Input { pattern, groups, field, normals, masks } = make();
        let mut job = Job::new();
        let kernel = Irradiance::new()?;
        let masks = job.slice("masks", &masks);
        let seen = Seen { pattern: &pattern, groups: &groups, field: &field, masks };
        let visible = kernel.record_counts(&mut job, &seen)?;
        let light = kernel.record(&mut job, &seen, &normals)?;
        job.read("visible", visible.id());
        job.read("light", light.id());
        Ok(job)
    };
    let expected = move |_: &Outputs| {
        let Input { pattern, groups, field, normals, masks } = make();
        oracle::all(&pattern, &groups, &field, &normals, &masks).map(Expected::Whole).into()
    };
    Case::new(name, size, job, expected).probes([0])
}

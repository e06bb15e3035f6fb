//! Patterns of one to 1024 samples under every family of triangles, tables of every size, the paper's table and what it
//! gets wrong, and a thicket at real size.

use sightlines_backend::host::Buffer;
use sightlines_backend::{Case, Expected, Job, Outputs, Result, Size};

use super::{LineMask, Resolution, Space, TILE, oracle, record_differ, record_masks, record_masks_by};
use crate::field::{Field, Receiver};
use crate::grid::{Faces, Receivers, Samples, Triangle, XY};
use crate::influence_region::oracle::region;
use crate::pattern::Pattern;
use crate::random;
use crate::tiles::Tiles;
use crate::triangles::{Family, contacts, corners, crossing, levels};

const FEW: Receivers = Receivers { origin: [-1500, -1100], step: [290, 370], height: 24_576, columns: 11, rows: 7 };
const MANY: Receivers = Receivers { origin: [-4080, -4080], step: [64, 64], height: 24_576, columns: 128, rows: 128 };
/// As wide as the grid.
const WIDE: Receivers =
    Receivers { origin: [-16_384, -16_384], step: [3276, 4095], height: 32_767, columns: 11, rows: 9 };
/// 77 tiles, each with a triangle of its own.
const SOLO: Receivers = Receivers { origin: [-1500, -1100], step: [72, 92], height: 24_576, columns: 44, rows: 28 };
/// Where the paper's table is measured.
const PENUMBRA: Receivers =
    Receivers { origin: [-1600, -1600], step: [160, 160], height: 24_576, columns: 20, rows: 20 };

/// Resolutions of the paper's table that are measured.
const MEASURED: std::ops::RangeInclusive<u32> = 4..=10;

const SEED: u32 = 29;

/// A light of 2000 by 1800 units: Halton's points.
fn halton(count: u32) -> Pattern {
    fits(Pattern::halton([-1000, -900], [2000, 1800], count))
}

fn regular(step: i32, columns: u32, rows: u32) -> Pattern {
    let origin = [columns, rows].map(|n| -(step * (n as i32 - 1)) / 2);
    fits(Pattern::regular(&Samples { origin, step: [step, step], columns, rows }))
}

fn words(count: usize) -> Pattern {
    let near = random::words(SEED, count).into_iter().map(|word| word & 0x07ff_07ff);
    fits(Pattern::from_words(&near.collect::<Vec<u32>>()))
}

fn fits(pattern: Result<Pattern>) -> Pattern {
    pattern.expect("a pattern of the cases is on the grid")
}

fn exact(bits: u32) -> Resolution {
    Resolution { space: Space::Exact, bits }
}

fn sampled(bits: u32) -> Resolution {
    Resolution { space: Space::Sampled, bits }
}

pub(super) fn all() -> Vec<Case> {
    let channels = |count: u32| fits(halton(count).with_bits(31));
    let jitter = || fits(Pattern::jittered([-900, -800], [60, 110], 31, 16, SEED));
    let grid_corners = || fits(Pattern::new([-XY, XY - 1].map(|x| [-XY, XY - 1].map(|y| [x, y])).concat(), 32));
    let mut cases = vec![
        masks("nothing", regular(64, 32, 32), exact(3), FEW, |_, _| Vec::new()),
        masks("one", regular(64, 32, 32), exact(5), FEW, |_, _| {
            vec![[[0, 0, 12_288], [300, 0, 12_288], [0, 300, 12_000]]]
        }),
        masks("regular_32", regular(512, 8, 4), exact(6), FEW, mixed),
        masks("regular_64", regular(128, 8, 8), exact(6), FEW, mixed),
        masks("regular_256", regular(128, 16, 16), exact(5), FEW, mixed),
        masks("regular_1024", regular(64, 32, 32), exact(5), FEW, mixed),
        masks("one_sample", words(1), exact(2), FEW, mixed),
        masks("halton_37", halton(37), exact(6), FEW, mixed),
        masks("jittered_496", jitter(), exact(5), FEW, mixed),
        masks("words_1000", words(1000), exact(5), FEW, mixed),
        masks("channels_124", channels(124), exact(6), FEW, mixed),
        masks("channels_992", channels(992), exact(5), FEW, mixed),
        masks("crossing_37", halton(37), exact(6), FEW, |s, r| crossing(60, s, r)),
        masks("crossing_992", channels(992), exact(4), FEW, |s, r| crossing(20, s, r)),
        masks("levels_124", halton(124), exact(5), FEW, |_, r| levels(r.height)),
        masks("corners_of_the_grid", grid_corners(), exact(5), WIDE, |_, r| corners(100, r)),
        masks("table_of_1_bit", halton(124), exact(1), FEW, mixed),
        masks("table_of_7_bits", words(21), exact(7), FEW, mixed),
        masks("paper_32", halton(32), sampled(7), FEW, mixed),
        masks("paper_124", channels(124), sampled(6), FEW, mixed),
        masks("paper_crossing", halton(64), sampled(5), FEW, |s, r| crossing(40, s, r)),
        masks("paper_levels", halton(40), sampled(8), FEW, |_, r| levels(r.height)),
        table("table_37", halton(37), exact(4)),
        table("table_of_the_grid", grid_corners(), exact(7)),
        table("table_124_channels", channels(124), exact(3)),
        table("paper_table_37", halton(37), sampled(6)),
        table("paper_table_992", channels(992), sampled(4)),
        paper_error(),
        field("field_37", halton(37), exact(6), Faces::Both),
        field("field_992", channels(992), exact(4), Faces::Both),
        field("field_paper", halton(64), sampled(6), Faces::Both),
        field("field_front", halton(100), exact(6), Faces::Front),
        thicket("thicket_992", channels(992)),
        thicket("thicket_64", halton(64)),
    ];
    cases.extend(Family::ALL.map(|family| {
        let make = move |s: &Samples, r: &Receivers| family.triangles(77, s, r, 3);
        solo(&format!("family_{}", family.name()), halton(64), exact(5), make)
    }));
    cases.push(solo("solo_crossing", halton(64), exact(5), |s, r| crossing(77, s, r)));
    cases.push(solo("solo_contacts", halton(64), exact(5), |_, r| contacts(TILE, r)));
    cases.push(solo("solo_levels", halton(64), exact(5), |_, r| levels(r.height).split_off(20)));
    cases.push(solo("solo_channels_124", channels(124), exact(4), mixed_77));
    cases.push(solo("solo_paper", halton(64), sampled(6), mixed_77));
    cases
}

/// Several of every family, one after the other.
fn mixed_77(samples: &Samples, receivers: &Receivers) -> Vec<Triangle> {
    Family::ALL.into_iter().flat_map(|family| family.triangles(8, samples, receivers, 5)).take(77).collect()
}

fn mixed(samples: &Samples, receivers: &Receivers) -> Vec<Triangle> {
    Family::ALL.into_iter().flat_map(|family| family.triangles(3, samples, receivers, 5)).collect()
}

fn regions(pattern: &Pattern, receivers: &Receivers, triangles: &[Triangle]) -> Vec<[i32; 4]> {
    let samples = pattern.enclosing();
    triangles.iter().map(|t| region(t, &samples, receivers)).collect()
}

fn tiles(pattern: &Pattern, receivers: &Receivers, triangles: &[Triangle]) -> Tiles {
    Tiles::new(TILE, receivers, &regions(pattern, receivers, triangles))
}

fn record(
    job: &mut Job,
    pattern: &Pattern,
    resolution: Resolution,
    receivers: &Receivers,
    triangles: &[Triangle],
) -> Result<Buffer<[u32]>> {
    let tiles = tiles(pattern, receivers, triangles);
    record_masks(job, pattern, resolution, &Field::from(receivers), &tiles, triangles)
}

fn masks(
    name: &str,
    pattern: Pattern,
    resolution: Resolution,
    receivers: Receivers,
    make: impl Fn(&Samples, &Receivers) -> Vec<Triangle> + Copy + Send + Sync + 'static,
) -> Case {
    let middle = receivers.count() / 2;
    let probes: Vec<u32> = (0..pattern.words()).step_by(5).map(|word| word * receivers.count() + middle).collect();
    let answered = pattern.clone();
    let job = move || {
        let mut job = Job::new();
        let triangles = make(&pattern.enclosing(), &receivers);
        let hidden = record(&mut job, &pattern, resolution, &receivers, &triangles)?;
        job.read("hidden", hidden.id());
        Ok(job)
    };
    let expected = move |_: &Outputs| {
        let triangles = make(&answered.enclosing(), &receivers);
        vec![Expected::Whole(match resolution.space {
            Space::Exact => oracle::sets(&answered, &receivers, &triangles),
            Space::Sampled => {
                let tiles = tiles(&answered, &receivers, &triangles);
                oracle::sampled_sets(&answered, resolution.bits, &Field::from(&receivers), &tiles, &triangles)
            }
        })]
    };
    Case::new(name, Size::Small, job, expected).probes(probes)
}

/// One triangle a tile: what it hides too much is not covered up by others.
fn solo(
    name: &str,
    pattern: Pattern,
    resolution: Resolution,
    make: impl Fn(&Samples, &Receivers) -> Vec<Triangle> + Copy + Send + Sync + 'static,
) -> Case {
    let tiles = Tiles::solo(TILE, &SOLO);
    let (answered, lists) = (pattern.clone(), tiles.clone());
    let job = move || {
        let mut job = Job::new();
        let triangles = make(&pattern.enclosing(), &SOLO);
        let hidden = record_masks(&mut job, &pattern, resolution, &Field::from(&SOLO), &tiles, &triangles)?;
        job.read("hidden", hidden.id());
        Ok(job)
    };
    let expected = move |_: &Outputs| {
        let triangles = make(&answered.enclosing(), &SOLO);
        vec![Expected::Whole(match resolution.space {
            Space::Exact => oracle::tile_sets(&answered, &Field::from(&SOLO), &lists, &triangles),
            Space::Sampled => oracle::sampled_sets(&answered, resolution.bits, &Field::from(&SOLO), &lists, &triangles),
        })]
    };
    Case::new(name, Size::Small, job, expected).probes((0..8).map(|tile| SOLO.columns * 2 + 4 * tile))
}

/// Receivers at heights of their own, patterns shifted by up to the light's size, holes; a triangle a tile.
fn field(name: &str, pattern: Pattern, resolution: Resolution, faces: Faces) -> Case {
    let below = |bound: u32, index: u32| random::below(bound, SEED, index) as i32;
    let receiver = move |index: u32| {
        let [x, y, z] = SOLO.at(index);
        let shift = [below(2000, 3 * index) - 1000, below(1800, 3 * index + 1) - 900];
        let z = if index % 11 == 3 { 0 } else { z - below(16_000, 3 * index + 2) };
        Receiver { at: [x, y, z], shift }
    };
    let field = move || fits_field(Field::new(SOLO.columns, (0..SOLO.count()).map(receiver).collect()));
    let triangles = |pattern: &Pattern| {
        let mut triangles = mixed_77(&pattern.enclosing(), &SOLO);
        triangles.splice(0..20, crossing(20, &pattern.enclosing(), &SOLO));
        triangles
    };
    let answered = pattern.clone();
    let job = move || {
        let mut job = Job::new();
        let tiles = Tiles::solo(TILE, &SOLO);
        let kernel = LineMask::with_faces(&pattern, resolution, faces)?;
        let hidden = record_masks_by(&mut job, &kernel, &field(), &tiles, &triangles(&pattern))?;
        job.read("hidden", hidden.id());
        Ok(job)
    };
    let expected = move |_: &Outputs| {
        let (field, tiles, triangles) = (field(), Tiles::solo(TILE, &SOLO), triangles(&answered));
        vec![Expected::Whole(match resolution.space {
            Space::Exact => oracle::tile_sets_by(faces, &answered, &field, &tiles, &triangles),
            Space::Sampled => oracle::sampled_sets(&answered, resolution.bits, &field, &tiles, &triangles),
        })]
    };
    Case::new(name, Size::Small, job, expected).probes((0..8).map(|tile| SOLO.columns * 2 + 4 * tile))
}

fn fits_field(field: Result<Field>) -> Field {
    field.expect("a field of the cases is on the grid")
}

/// The table itself.
fn table(name: &str, pattern: Pattern, resolution: Resolution) -> Case {
    let cells = resolution.cells();
    let words = resolution.cell_words(pattern.words()) as u32;
    let answered = pattern.clone();
    let job = move || {
        let mut job = Job::new();
        let table = LineMask::new(&pattern, resolution)?.record_table(&mut job);
        job.read("table", table.cells.id());
        Ok(job)
    };
    let expected = move |_: &Outputs| {
        let axes = super::axes(answered.half_side_bits(), resolution.bits);
        let cell = |cell: u32| match resolution.space {
            Space::Exact => oracle::cell(&answered, resolution.bits, cell),
            Space::Sampled => {
                let [angle, distance] = [cell >> resolution.bits, cell & ((1 << resolution.bits) - 1)];
                oracle::texel(&answered, &axes, angle as usize, distance as usize)
            }
        };
        let empty = std::iter::repeat_n(0, words as usize);
        vec![Expected::Whole((0..cells).flat_map(cell).chain(empty).collect())]
    };
    Case::new(name, Size::Small, job, expected).probes((0..8).map(|i| i * (cells / 8) * words + words - 1))
}

/// What the paper's table of each resolution gets wrong: surplus and missing bits.
fn paper_error() -> Case {
    let triangles = |pattern: &Pattern| {
        let samples = pattern.enclosing();
        let mut triangles = Family::Leaves.triangles(40, &samples, &PENUMBRA, SEED);
        triangles.extend(Family::LightSized.triangles(4, &samples, &PENUMBRA, SEED));
        triangles
    };
    let job = move || {
        let pattern = halton(124);
        let triangles = triangles(&pattern);
        let mut job = Job::new();
        let truth = record(&mut job, &pattern, Resolution::exact(&pattern), &PENUMBRA, &triangles)?;
        let counts = job.zeroed("counts", 2 * MEASURED.count() as u64);
        for (index, bits) in MEASURED.enumerate() {
            let found = record(&mut job, &pattern, sampled(bits), &PENUMBRA, &triangles)?;
            record_differ(&mut job, found, truth, 2 * index as u32, counts)?;
        }
        job.read("wrong bits", counts.id());
        Ok(job)
    };
    let expected = move |_: &Outputs| {
        let pattern = halton(124);
        let triangles = triangles(&pattern);
        let truth = oracle::sets(&pattern, &PENUMBRA, &triangles);
        let tiles = tiles(&pattern, &PENUMBRA, &triangles);
        let wrong = |bits| {
            oracle::differ(&oracle::sampled_sets(&pattern, bits, &Field::from(&PENUMBRA), &tiles, &triangles), &truth)
        };
        vec![Expected::Whole(MEASURED.flat_map(wrong).collect())]
    };
    Case::new("paper_error", Size::Real, job, expected).probes(0..2 * MEASURED.count() as u32)
}

/// Leaves over a floor; the oracle looks at a seeded sample of receivers.
fn thicket(name: &str, pattern: Pattern) -> Case {
    let leaves = |pattern: &Pattern| Family::Leaves.triangles(3000, &pattern.enclosing(), &MANY, SEED);
    let answered = pattern.clone();
    let centre = MANY.count() / 2 + MANY.columns / 2;
    let probes: Vec<u32> = (0..pattern.words()).step_by(5).map(|word| word * MANY.count() + centre).collect();
    let job = move || {
        let mut job = Job::new();
        let hidden = record(&mut job, &pattern, Resolution::exact(&pattern), &MANY, &leaves(&pattern))?;
        job.read("hidden", hidden.id());
        Ok(job)
    };
    let expected = move |_: &Outputs| {
        let triangles = leaves(&answered);
        let regions = regions(&answered, &MANY, &triangles);
        let looks = (0..32).map(|index| random::below(MANY.count(), SEED, index));
        let words = looks.flat_map(|receiver| {
            let (x, y) = ((receiver % MANY.columns) as i32, (receiver / MANY.columns) as i32);
            let reaches = |r: &[i32; 4]| (r[0]..=r[1]).contains(&x) && (r[2]..=r[3]).contains(&y);
            let near = regions.iter().zip(&triangles).filter(|(r, _)| reaches(r)).map(|(_, triangle)| triangle);
            let mask = answered.hidden_set(MANY.at(receiver), near);
            (0..).zip(mask).map(move |(w, word)| (w * MANY.count() + receiver, word))
        });
        vec![Expected::Sample { words: words.collect(), seed: u64::from(SEED) }]
    };
    Case::new(name, Size::Real, job, expected).probes(probes)
}

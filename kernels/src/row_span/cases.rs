//! Every shape of light and every family of triangles at a size whose whole oracle is quick, and a thicket at real size
//! whose oracle looks at a seeded sample of receivers, most of them in the penumbra.

use sightlines_backend::{Case, Expected, Job, Outputs, Result, Size};

use super::{LIST, RowSpan, Scene, WIDTH, oracle};
use crate::grid::{Faces, Receivers, Samples, Triangle, hidden_set, hidden_set_by};
use crate::influence_region::oracle::region;
use crate::random;
use crate::tiles::Tiles;
use crate::triangles::Family;

/// A light of square cells about the origin.
fn light(step: i32, columns: u32, rows: u32) -> Samples {
    let origin = [columns, rows].map(|n| -(step * (n as i32 - 1)) / 2);
    Samples { origin, step: [step, step], columns, rows }
}

/// Few receivers, wide apart, so that all parts of a triangle's shadow are met.
const FEW: Receivers = Receivers { origin: [-1500, -1100], step: [290, 370], height: 24_576, columns: 11, rows: 7 };

/// 77 tiles of 16 by 4 receivers.
const SOLO: Receivers = Receivers { origin: [-1500, -1100], step: [18, 92], height: 24_576, columns: 176, rows: 28 };
const SOLO_TILES: u32 = 77;

const MANY: Receivers = Receivers { origin: [-4080, -4080], step: [32, 32], height: 24_576, columns: 256, rows: 256 };

/// Receivers that the oracle of the real size looks at.
const LOOKS: u32 = 96;
const SEED: u32 = 17;
const LEAVES: u32 = 20_000;

pub(super) fn all() -> Vec<Case> {
    let full = light(64, 32, 32);
    let mut cases = vec![
        small("nothing", full, FEW, |_, _| Vec::new()),
        small("one", full, FEW, |_, _| vec![[[0, 0, 12_288], [300, 0, 12_288], [0, 300, 12_000]]]),
        small("samples_256", light(128, 16, 16), FEW, mixed),
        small("samples_64", light(64, 8, 8), FEW, mixed),
        small("samples_32", light(512, 8, 4), FEW, mixed),
        small("uneven_steps", Samples { step: [33, 97], ..light(64, 32, 32) }, FEW, mixed),
        small("low_receivers", light(16, 32, 32), Receivers { height: 40, step: [9, 7], ..FEW }, mixed),
        small("one_receiver", full, Receivers { columns: 1, rows: 1, ..FEW }, mixed),
        small("crowd", full, Receivers { columns: 9, rows: 1, ..FEW }, slivers),
        small("nobody_sees_more", full, Receivers { columns: 4, rows: 3, ..FEW }, curtain),
        small_by(Faces::Front, "front_256", light(128, 16, 16), FEW, mixed),
        small_by(Faces::Front, "front_64", light(64, 8, 8), FEW, mixed),
        small_by(Faces::Front, "front_32", light(512, 8, 4), FEW, mixed),
        long_list(),
        thicket(),
    ];
    for (faces, prefix) in [(Faces::Both, "family"), (Faces::Front, "front")] {
        cases.extend(Family::ALL.map(|family| {
            let make = move |s: &Samples, r: &Receivers| family.triangles(SOLO_TILES, s, r, 3);
            solo(faces, &format!("{prefix}_{}", family.name()), full, make)
        }));
    }
    cases
}

fn mixed(samples: &Samples, receivers: &Receivers) -> Vec<Triangle> {
    Family::ALL.into_iter().flat_map(|family| family.triangles(4, samples, receivers, 5)).collect()
}

/// Slivers across all rows of samples: a row of receivers has more items at once than may wait, and most hide few
/// samples.
fn slivers(_: &Samples, _: &Receivers) -> Vec<Triangle> {
    let sliver = |index: u32| {
        let x = random::below(1600, SEED, index) as i32 - 800;
        [[x, -3000, 12_288], [x + 6, -3000, 12_288], [x + 3, 3000, 12_200]]
    };
    (0..200).map(sliver).collect()
}

/// Triangles that hide all of the light from the upper receivers, and whole rows of it or parts of rows from others,
/// over and over, and a last one that hides more from these.
fn curtain(_: &Samples, _: &Receivers) -> Vec<Triangle> {
    let large = |index: i32| [[-9000, -40 - index, 12_000], [9000, -40 - index, 12_000], [0, -15_000, 11_000]];
    let aside = |index: i32| [[-400 - index, -9000, 12_000], [-400 - index, 9000, 12_000], [-15_000, 0, 11_000]];
    let last = [[-200, 0, 9000], [700, 30, 9000], [100, 900, 9000]];
    (0..150).flat_map(|index| [large(index), aside(index)]).chain([last]).collect()
}

fn tiles(samples: &Samples, receivers: &Receivers, triangles: &[Triangle], tile_rows: u32) -> Tiles {
    let regions: Vec<[i32; 4]> = triangles.iter().map(|t| region(t, samples, receivers)).collect();
    Tiles::new([WIDTH, tile_rows], receivers, &regions)
}

fn job(samples: &Samples, receivers: &Receivers, triangles: &[Triangle], tiles: &Tiles) -> Result<Job> {
    job_by(Faces::Both, samples, receivers, triangles, tiles)
}

fn job_by(
    faces: Faces,
    samples: &Samples,
    receivers: &Receivers,
    triangles: &[Triangle],
    tiles: &Tiles,
) -> Result<Job> {
    let kernel = RowSpan::with_faces(samples, faces)?;
    let mut job = Job::new();
    let words: Vec<i32> = triangles.iter().flatten().flatten().copied().collect();
    // A binding holds at least one element.
    let vertices = job.slice("vertices", if words.is_empty() { &[0] } else { &words[..] });
    let starts = job.slice("starts", &tiles.starts);
    let entries = job.slice("entries", if tiles.entries.is_empty() { &[0] } else { &tiles.entries[..] });
    let hidden = job.zeroed("hidden", u64::from(receivers.count()) * u64::from(samples.words()));
    kernel.record(&mut job, receivers, tiles, Scene { vertices, starts, entries, hidden })?;
    job.read("hidden", hidden.id());
    Ok(job)
}

fn probes(samples: &Samples, receivers: &Receivers) -> impl Iterator<Item = u32> + use<> {
    let count = receivers.count();
    (0..samples.words()).step_by(5).map(move |word| word * count + count / 2)
}

fn small(
    name: &str,
    samples: Samples,
    receivers: Receivers,
    make: impl Fn(&Samples, &Receivers) -> Vec<Triangle> + Clone + Send + Sync + 'static,
) -> Case {
    small_by(Faces::Both, name, samples, receivers, make)
}

fn small_by(
    faces: Faces,
    name: &str,
    samples: Samples,
    receivers: Receivers,
    make: impl Fn(&Samples, &Receivers) -> Vec<Triangle> + Clone + Send + Sync + 'static,
) -> Case {
    let triangles = make.clone();
    let job = move || {
        let triangles = triangles(&samples, &receivers);
        job_by(faces, &samples, &receivers, &triangles, &tiles(&samples, &receivers, &triangles, 4))
    };
    let expected = move |_: &Outputs| {
        let triangles = make(&samples, &receivers);
        vec![Expected::Whole(oracle::sets_by(faces, &samples, &receivers, &triangles))]
    };
    Case::new(name, Size::Small, job, expected).probes(probes(&samples, &receivers))
}

/// A triangle for each tile: many together hide all, and would hide a bit too much as well.
fn solo(
    faces: Faces,
    name: &str,
    samples: Samples,
    make: impl Fn(&Samples, &Receivers) -> Vec<Triangle> + Clone + Send + Sync + 'static,
) -> Case {
    let tiles = Tiles::solo([WIDTH, 4], &SOLO);
    let triangles = make.clone();
    let lists = tiles.clone();
    let job = move || job_by(faces, &samples, &SOLO, &triangles(&samples, &SOLO), &lists);
    let expected = move |_: &Outputs| {
        let triangles = make(&samples, &SOLO);
        let list = |x, y| tiles.list(x, y).iter().map(|&triangle| &triangles[triangle as usize]);
        let set = |at: u32| hidden_set_by(faces, SOLO.at(at), &samples, list(at % SOLO.columns, at / SOLO.columns));
        let sets: Vec<Vec<u32>> = (0..SOLO.count()).map(set).collect();
        vec![Expected::Whole((0..samples.words() as usize).flat_map(|w| sets.iter().map(move |s| s[w])).collect())]
    };
    Case::new(name, Size::Small, job, expected).probes(probes(&samples, &SOLO))
}

/// One tile whose list is longer than the loops of some devices, and the only triangle that hides anything at its end.
fn long_list() -> Case {
    let samples = light(64, 32, 32);
    let receivers = Receivers { columns: 8, rows: 1, ..FEW };
    let make = move || {
        let far = [[16_000, 16_000, 100], [16_100, 16_000, 100], [16_000, 16_100, 100]];
        let mut triangles = vec![far; 16 * LIST as usize];
        triangles.push([[-300, -200, 12_288], [300, 0, 12_288], [0, 300, 12_000]]);
        triangles
    };
    let job = move || {
        let triangles = make();
        let entries: Vec<u32> = (0..triangles.len() as u32).collect();
        let tiles = Tiles { size: [WIDTH, 4], count: [1, 1], starts: vec![0, entries.len() as u32], entries };
        job(&samples, &receivers, &triangles, &tiles)
    };
    let expected =
        move |_: &Outputs| vec![Expected::Whole(oracle::sets(&samples, &receivers, &make()[16 * LIST as usize..]))];
    Case::new("long_list", Size::Small, job, expected).probes(probes(&samples, &receivers))
}

fn leaves() -> Vec<Triangle> {
    Family::Leaves.triangles(LEAVES, &light(64, 32, 32), &MANY, SEED)
}

fn thicket() -> Case {
    let samples = light(64, 32, 32);
    let expected = move |outputs: &Outputs| {
        let triangles = leaves();
        let regions: Vec<[i32; 4]> = triangles.iter().map(|t| region(t, &samples, &MANY)).collect();
        let looks = penumbra(outputs.first().map_or(&[], |bytes| bytes.as_slice()), &samples);
        let words = looks.into_iter().flat_map(|receiver| {
            let (x, y) = ((receiver % MANY.columns) as i32, (receiver / MANY.columns) as i32);
            let near = |r: &&([i32; 4], &Triangle)| (r.0[0]..=r.0[1]).contains(&x) && (r.0[2]..=r.0[3]).contains(&y);
            let pairs: Vec<([i32; 4], &Triangle)> = regions.iter().copied().zip(&triangles).collect();
            let mask = hidden_set(MANY.at(receiver), &samples, pairs.iter().filter(near).map(|r| r.1));
            (0..samples.words()).zip(mask).map(move |(w, word)| (w * MANY.count() + receiver, word))
        });
        vec![Expected::Sample { words: words.collect(), seed: u64::from(SEED) }]
    };
    let job = move || job(&samples, &MANY, &leaves(), &tiles(&samples, &MANY, &leaves(), 8));
    let centre = MANY.count() / 2 + MANY.columns / 2;
    Case::new("thicket_20000", Size::Real, job, expected).probes((0..32).step_by(5).map(|w| w * MANY.count() + centre))
}

/// A seeded sample of receivers: three of four see some of the light and not all of it, where there are such.
fn penumbra(bytes: &[u8], samples: &Samples) -> Vec<u32> {
    let count = MANY.count();
    let bits = |receiver: u32| -> u32 {
        let word = |w: u32| {
            let at = 4 * (w * count + receiver) as usize;
            bytes.get(at..at + 4).map_or(0, |b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]).count_ones())
        };
        (0..samples.words()).map(word).sum()
    };
    let mut looks = Vec::new();
    for index in 0.. {
        let receiver = random::below(count, SEED, index);
        let partly = (1..samples.count()).contains(&bits(receiver));
        if partly || index % 4 == 0 {
            looks.push(receiver);
        }
        if looks.len() as u32 >= LOOKS || index > 100_000 {
            break;
        }
    }
    looks
}

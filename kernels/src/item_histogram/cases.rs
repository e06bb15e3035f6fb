//! From no item to 2048² pixels in 65,536 bins: whole screens, where ids lie in clumps, and random ids.
//!
//! A screen case runs the whole chain, labels, counts and mip levels; the others count given ids. Small cases count in
//! both orders, and the words past their bins must keep their mark.

use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{INSTANCE_BITS, ItemHistogram, NOTHING, Order, Tiling, item, oracle};
use crate::raster::meshes::{ball, seen_from_origin, upload};
use crate::raster::oracle::Scene;
use crate::raster::{self, Ids, Picture, Raster, View};
use crate::{pieces, random, screen};

/// Words past the end of the bins, and what they hold.
const SLACK: usize = 4;
const MARK: u32 = 0x5eed_5eed;

const FIGURE_4: &[u32] = &[5, 3, 4];

pub(super) fn all() -> Vec<Case> {
    let random_ids = |name, side: u32, bins, order| real_ids(name, side * side, bins, order);
    vec![
        small("nothing", &[], 192, &[0, 191]),
        small("no_bins", &[3, 1, 4, 1, 5], 0, &[0]),
        small("one", &[7], 8, &[6, 7]),
        generated("one_past_group", 257, 16, |i| i % 16, &[0, 1, 15]),
        generated("one_past_block", 4097, 192, |i| random::below(192, 1, i), &[0, 191]),
        generated("one_bin", 10_000, 1, |_| 0, &[0]),
        generated("one_bin_of_many", 40_000, 5000, |_| 4096, &[0, 4095, 4096, 4097]),
        generated("absent_ids", 5000, 100, |i| if i % 3 == 0 { i } else { random::word(2, i) }, &[0, 1, 3, 99]),
        generated("one_past_small_tile", 9000, 513, |i| i % 515, &[0, 255, 256, 512]),
        generated("one_past_tile", 20_000, 8193, |i| random::below(8194, 3, i), &[0, 4095, 4096, 8192]),
        weighted("weights", Size::Small, tiling(60, 40), |i| random::word(6, i) >> 24),
        weighted("weights_wrap", Size::Small, tiling(60, 40), |i| random::word(7, i)),
        weighted("weights_512", Size::Real, tiling(512, 512), |i| random::word(8, i) >> 24),
        screen_case("figure_4", Size::Small, FIGURE_4, tiling(96, 64), Order::Memory),
        screen_case("figure_4_uneven", Size::Small, FIGURE_4, tiling(301, 77), Order::Scattered),
        chain("chain_instances", Size::Small, [96, 64], INSTANCES),
        chain("chain_clusters", Size::Small, [96, 64], CLUSTERS),
        chain("chain_clusters_512", Size::Real, [512, 512], CLUSTERS),
        screen_case("screen_512_192", Size::Real, FIGURE_4, tiling(512, 512), Order::Memory),
        screen_case("screen_512_192_scattered", Size::Real, FIGURE_4, tiling(512, 512), Order::Scattered),
        screen_case("screen_2048_65536", Size::Real, CROWD, tiling(2048, 2048), Order::Memory),
        screen_case("screen_2048_65536_scattered", Size::Real, CROWD, tiling(2048, 2048), Order::Scattered),
        random_ids("random_512_192", 512, 192, Order::Memory),
        random_ids("random_2048_65536", 2048, 65_536, Order::Memory),
    ]
}

/// Eight objects of 512 instances: 65,536 bins at depth 2.
const CROWD: &[u32] = &[512; 8];

fn tiling(width: u32, height: u32) -> Tiling {
    Tiling { width, height, depth: 2 }
}

/// First bin of every object.
fn bases(instances: &[u32], depth: u32) -> Vec<u32> {
    let starts = instances.iter().scan(0, |next, n| Some(std::mem::replace(next, *next + n)));
    starts.map(|start: u32| start << (2 * depth)).collect()
}

/// The item buffer of a screen of discs.
fn items(instances: &[u32], tiling: Tiling) -> Vec<u32> {
    let all = instances.iter().sum();
    let names: Vec<u32> = (0_u16..).zip(instances).flat_map(|(o, &n)| (0..n as u16).map(move |i| item(o, i))).collect();
    let pixels = screen::discs(tiling.width, tiling.height, all, 11);
    pixels.iter().map(|&pixel| names.get(pixel as usize).copied().unwrap_or(NOTHING)).collect()
}

fn screen_case(name: &str, size: Size, instances: &'static [u32], tiling: Tiling, order: Order) -> Case {
    let bins = instances.iter().sum::<u32>() << (2 * tiling.depth);
    let expected = move |_: &_| {
        let labels =
            oracle::labels(tiling, (&items(instances, tiling), INSTANCE_BITS), &bases(instances, tiling.depth));
        let mut levels = vec![oracle::counts(&labels, bins)];
        for depth in (1..=tiling.depth).rev() {
            levels.push(oracle::halved(&levels[levels.len() - 1], depth));
        }
        std::iter::once(labels).chain(levels).map(Expected::Whole).collect()
    };
    let blocks = bins >> (2 * tiling.depth);
    Case::new(name, size, move || screen_job(instances, tiling, order), expected).probes([0, 1, 5, blocks - 1])
}

fn screen_job(instances: &[u32], tiling: Tiling, order: Order) -> Result<Job> {
    let kernel = ItemHistogram::new()?;
    let mut job = Job::new();
    let items = job.slice("items", &items(instances, tiling));
    let base = job.slice("base", &bases(instances, tiling.depth));
    pieces::cut(&mut job);
    let labels = job.zeroed("labels", items.len());
    kernel.record_labels(&mut job, tiling, (items, INSTANCE_BITS), base, labels)?;
    let blocks = instances.iter().sum::<u32>();
    let bins = blocks << (2 * tiling.depth);
    let counts = job.zeroed("counts", u64::from(bins));
    kernel.record_counts(&mut job, order, (labels.len() as u32, labels), (bins, counts))?;
    let levels = kernel.record_mips(&mut job, tiling.depth, blocks, counts)?;
    job.read("labels", labels.id());
    job.read("counts", counts.id());
    for (level, buffer) in (1..).zip(levels) {
        job.read(format!("mip.{level}"), buffer.id());
    }
    Ok(job)
}

/// How items of two meshes are numbered, what of them is the instance, and the first bins of the objects.
struct Naming {
    ids: [Ids; 2],
    instance_bits: u32,
    base: &'static [u32],
}

/// Instances of two objects: five and four.
const INSTANCES: &Naming = &Naming {
    ids: [Ids { base: 0, step: 1, shift: 31 }, Ids { base: 1 << INSTANCE_BITS, step: 1, shift: 31 }],
    instance_bits: INSTANCE_BITS,
    base: &[0, 5 * 16],
};

/// Clusters of 32 triangles: 19 of each of the nine instances of 600 triangles.
const CLUSTERS: &Naming = &Naming {
    ids: [Ids { base: 0, step: 19, shift: 5 }, Ids { base: 5 * 19, step: 19, shift: 5 }],
    instance_bits: 31,
    base: &[0],
};

/// Balls before a camera: two meshes, five instances and four.
fn balls([width, height]: [u32; 2], naming: &Naming) -> (View, Vec<Scene>) {
    let view = View { picture: Picture { width, height }, near: 4096 };
    let place = |i: u32| {
        let at = [0, 1].map(|axis| f64::from(random::below(1200, 14, 2 * i + axis)) - 600.0);
        seen_from_origin(256.0, 16.0, [at[0], at[1], 900.0 + 90.0 * f64::from(i % 4)], 250.0 / 16_384.0, i + 1)
    };
    let scenes = naming.ids.into_iter().zip([0..5, 5..9]).map(|(ids, instances)| {
        let mut scene = ball().drawn(&instances.map(place).collect::<Vec<_>>());
        scene.ids = ids;
        scene
    });
    (view, scenes.collect())
}

/// Draws meshes, names their pixels, counts them, and sums the counts over the tiles.
fn chain(name: &str, size: Size, sides: [u32; 2], naming: &'static Naming) -> Case {
    let tiling = tiling(sides[0], sides[1]);
    let blocks = if naming.base.len() > 1 { 9 } else { 9 * 19 };
    let expected = move |_: &_| {
        let (view, scenes) = balls(sides, naming);
        let [_, items] = raster::oracle::pictures(view, &scenes);
        let labels = oracle::labels(tiling, (&items, naming.instance_bits), naming.base);
        let counts = oracle::counts(&labels, blocks << 4);
        let halved = oracle::halved(&counts, 2);
        let whole = oracle::halved(&halved, 1);
        [counts, halved, whole, labels].map(Expected::Whole).into()
    };
    let job = move || {
        let (kernel, raster) = (ItemHistogram::new()?, Raster::new()?);
        let (view, scenes) = balls(sides, naming);
        let mut job = Job::new();
        let pixels = u64::from(view.picture.pixels());
        let [depth, items, labels] = ["depth", "items", "labels"].map(|name| job.zeroed(name, pixels));
        raster.record_clear(&mut job, view.picture, depth)?;
        raster.record_clear(&mut job, view.picture, items)?;
        let mut drawn = Vec::new();
        for scene in &scenes {
            let mesh = upload(&mut job, scene);
            let projected = raster.project(&mut job, view, mesh)?;
            raster.record_depth(&mut job, &projected, scene.faces, depth)?;
            drawn.push((projected, scene));
        }
        for (projected, scene) in &drawn {
            raster.record_items(&mut job, projected, scene.faces, scene.ids, [depth, items])?;
        }
        let base = job.slice("base", naming.base);
        kernel.record_labels(&mut job, tiling, (items, naming.instance_bits), base, labels)?;
        let bins = blocks << 4;
        let counts = job.zeroed("counts", u64::from(bins));
        kernel.record_counts(&mut job, Order::Scattered, (pixels as u32, labels), (bins, counts))?;
        let levels = kernel.record_mips(&mut job, 2, blocks, counts)?;
        job.read("counts", counts.id());
        job.read("tiles_of_four", levels[0].id());
        job.read("whole", levels[1].id());
        job.read("labels", labels.id());
        Ok(job)
    };
    Case::new(name, size, job, expected).probes([0, 5, 16 * blocks / 2, 16 * blocks - 1])
}

/// Sums a weight of every pixel of a screen, as of a blocker that lets light through, in both orders, and two mip
/// levels.
fn weighted(name: &str, size: Size, tiling: Tiling, weight: fn(u32) -> u32) -> Case {
    let blocks = FIGURE_4.iter().sum::<u32>();
    let bins = blocks << (2 * tiling.depth);
    let ids = move || oracle::labels(tiling, (&items(FIGURE_4, tiling), INSTANCE_BITS), &bases(FIGURE_4, tiling.depth));
    let weights = move || (0..tiling.width * tiling.height).map(weight).collect::<Vec<u32>>();
    let expected = move |_: &_| {
        let fine = oracle::weights(&ids(), &weights(), bins);
        let middle = oracle::halved(&fine, 2);
        let coarse = oracle::halved(&middle, 1);
        [fine.clone(), fine, middle, coarse].map(Expected::Whole).into()
    };
    let job = move || {
        let kernel = ItemHistogram::new()?;
        let mut job = Job::new();
        let given = [job.slice("ids", &ids()), job.slice("weights", &weights())];
        let count = tiling.width * tiling.height;
        let [sums, scattered] = ["sums", "sums.scattered"].map(|name| job.zeroed(name, u64::from(bins)));
        kernel.record_weights(&mut job, Order::Memory, (count, given), (bins, sums))?;
        kernel.record_weights(&mut job, Order::Scattered, (count, given), (bins, scattered))?;
        let levels = kernel.record_mips(&mut job, tiling.depth, blocks, sums)?;
        for (name, buffer) in
            ["sums", "sums.scattered", "mip.1", "mip.2"].into_iter().zip([sums, scattered].into_iter().chain(levels))
        {
            job.read(name, buffer.id());
        }
        Ok(job)
    };
    Case::new(name, size, job, expected).probes([0, 1, 5, blocks - 1])
}

/// Counts `ids` in both orders.
fn small(name: &str, ids: &'static [u32], bins: u32, probes: &[u32]) -> Case {
    both_orders(name, move || ids.to_vec(), bins, probes)
}

fn generated(name: &str, len: u32, bins: u32, id: fn(u32) -> u32, probes: &[u32]) -> Case {
    both_orders(name, move || (0..len).map(id).collect(), bins, probes)
}

fn both_orders(
    name: &str,
    ids: impl Fn() -> Vec<u32> + Clone + Send + Sync + 'static,
    bins: u32,
    probes: &[u32],
) -> Case {
    let given = ids.clone();
    let job = move || {
        let kernel = ItemHistogram::new()?;
        let mut job = Job::new();
        let mut ids = given();
        let items = ids.len() as u32;
        ids.extend([0; SLACK]);
        let ids = job.slice("ids", &ids);
        for (order, label) in [(Order::Memory, "counts"), (Order::Scattered, "counts.scattered")] {
            let mut marked = vec![0; bins as usize];
            marked.extend([MARK; SLACK]);
            let counts = job.slice("counts", &marked);
            kernel.record_counts(&mut job, order, (items, ids), (bins, counts))?;
            job.read(label, counts.id());
        }
        Ok(job)
    };
    let expected = move |_: &_| {
        let mut counts = oracle::counts(&ids(), bins);
        counts.extend([MARK; SLACK]);
        vec![Expected::Whole(counts); 2]
    };
    Case::new(name, Size::Small, job, expected).probes(probes.iter().copied())
}

fn real_ids(name: &str, len: u32, bins: u32, order: Order) -> Case {
    let ids = move || -> Vec<u32> { (0..len).map(|i| random::below(bins, 12, i)).collect() };
    let job = move || {
        let kernel = ItemHistogram::new()?;
        let mut job = Job::new();
        let ids = job.slice("ids", &ids());
        pieces::cut(&mut job);
        let counts = job.zeroed("counts", u64::from(bins));
        kernel.record_counts(&mut job, order, (len, ids), (bins, counts))?;
        job.read("counts", counts.id());
        Ok(job)
    };
    let expected = move |_: &_| vec![Expected::Whole(oracle::counts(&ids(), bins))];
    Case::new(name, Size::Real, job, expected).probes([0, 1, bins / 2, bins - 1])
}

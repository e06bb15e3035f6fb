//! Lists of pairs and whole regions: every family of triangles, vertices on and beyond both planes, the grid's corners.

use glam::{UVec2, UVec4};
use sightlines_backend::{Case, Expected, Job, Size};

use super::{Backprojection, LINES, oracle, starts};
use crate::grid::{Receivers, Samples, Triangle};
use crate::influence_region::oracle::region;
use crate::random;
use crate::triangles::{Family, corners, crossing, levels};

const SAMPLES: Samples = Samples { origin: [-1000, -900], step: [63, 58], columns: 32, rows: 32 };
const FEW: Receivers = Receivers { origin: [-1500, -1100], step: [290, 370], height: 20_000, columns: 11, rows: 7 };
/// As wide as the grid.
const WIDE: Receivers =
    Receivers { origin: [-16_384, -16_384], step: [3276, 4095], height: 32_767, columns: 11, rows: 9 };
const MANY: Receivers = Receivers { origin: [-4080, -4080], step: [32, 32], height: 24_576, columns: 256, rows: 256 };

pub(super) fn all() -> Vec<Case> {
    let mut cases = vec![
        listed("no_pair", Size::Small, FEW, 0, |_| Vec::new()),
        listed("one_pair", Size::Small, FEW, 1, |_| vec![[[0, 0, 9000], [300, 0, 9000], [0, 300, 8000]]]),
        listed("pairs_levels", Size::Small, FEW, 1500, |r| levels(r.height)),
        listed("pairs_crossing", Size::Small, FEW, 1500, |r| crossing(60, &SAMPLES, r)),
        listed("pairs_corners", Size::Small, WIDE, 3000, |r| corners(300, r)),
        listed("pairs_200000", Size::Real, MANY, 200_000, |r| families(r, 2000)),
        in_regions("no_region", Size::Small, FEW, |_| Vec::new()),
        in_regions("regions_crossing", Size::Small, FEW, |r| crossing(12, &SAMPLES, r)),
        in_regions("thicket_500", Size::Real, MANY, |r| Family::Leaves.triangles(500, &SAMPLES, r, 7)),
    ];
    cases.extend(Family::ALL.map(|family| {
        let make = move |r: &Receivers| family.triangles(16, &SAMPLES, r, 4);
        in_regions(&format!("regions_{}", family.name()), Size::Small, FEW, make)
    }));
    cases
}

fn families(receivers: &Receivers, each: u32) -> Vec<Triangle> {
    Family::ALL.into_iter().flat_map(|family| family.triangles(each, &SAMPLES, receivers, 6)).collect()
}

fn pairs(count: u32, triangles: usize, receivers: &Receivers) -> Vec<UVec2> {
    let pick = |i| UVec2::new(random::below(triangles as u32, 21, i), random::below(receivers.count(), 22, i));
    (0..count).map(pick).collect()
}

/// Every pair's words, or two zero words where there is no pair: a binding holds at least one element.
fn answer(receivers: &Receivers, triangles: &[Triangle], pairs: impl Iterator<Item = UVec2>) -> Vec<Expected> {
    let mut words: Vec<u32> =
        pairs.flat_map(|pair| oracle::words(receivers.at(pair.y), &triangles[pair.x as usize])).collect();
    words.resize(words.len().max(16), 0);
    vec![Expected::Whole(words)]
}

fn vertices(triangles: &[Triangle]) -> Vec<i32> {
    if triangles.is_empty() { vec![0] } else { triangles.as_flattened().as_flattened().to_vec() }
}

fn listed(
    name: &str,
    size: Size,
    receivers: Receivers,
    count: u32,
    make: impl Fn(&Receivers) -> Vec<Triangle> + Copy + Send + Sync + 'static,
) -> Case {
    let job = move || {
        let triangles = make(&receivers);
        let mut job = Job::new();
        let vertices = job.slice("vertices", &vertices(&triangles));
        let pairs = pairs(count, triangles.len(), &receivers);
        let pairs = job.slice("pairs", if pairs.is_empty() { &[UVec2::ZERO] } else { &pairs[..] });
        let lines = job.zeroed::<UVec4>("lines", u64::from(LINES * count.max(1)));
        Backprojection::new()?.record_pairs(&mut job, &receivers, vertices, count, pairs, lines)?;
        job.read("lines", lines.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let triangles = make(&receivers);
        answer(&receivers, &triangles, pairs(count, triangles.len(), &receivers).into_iter())
    };
    Case::new(name, size, job, expected).probes(0..16)
}

fn in_regions(
    name: &str,
    size: Size,
    receivers: Receivers,
    make: impl Fn(&Receivers) -> Vec<Triangle> + Copy + Send + Sync + 'static,
) -> Case {
    let regions =
        move || -> Vec<[i32; 4]> { make(&receivers).iter().map(|t| region(t, &SAMPLES, &receivers)).collect() };
    let job = move || {
        let mut job = Job::new();
        let vertices = job.slice("vertices", &vertices(&make(&receivers)));
        let regions = regions();
        let starts = starts(&regions)?;
        let words = regions.as_flattened();
        let regions = job.slice("regions", if words.is_empty() { &[0] } else { words });
        let pairs = u64::from(starts[starts.len() - 1]).max(1);
        let lines = job.zeroed::<UVec4>("lines", u64::from(LINES) * pairs);
        Backprojection::new()?.record_regions(&mut job, &receivers, vertices, regions, &starts, lines)?;
        job.read("lines", lines.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let inside = regions().into_iter().enumerate().flat_map(|(triangle, [x0, x1, y0, y1])| {
            let receiver = move |x: i32, y: i32| UVec2::new(triangle as u32, y as u32 * receivers.columns + x as u32);
            (y0..=y1).flat_map(move |y| (x0..=x1).map(move |x| receiver(x, y)))
        });
        answer(&receivers, &make(&receivers), inside)
    };
    Case::new(name, size, job, expected).probes(0..16)
}

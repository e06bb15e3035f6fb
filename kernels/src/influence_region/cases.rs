//! From no triangle to 200,000, and the families that are hard to get right.

use sightlines_backend::{Case, Expected, Job, Size};

use super::{InfluenceRegion, oracle};
use crate::grid::{Point, Receivers, Samples, Triangle};
use crate::random;
use crate::triangles::Family;

const SAMPLES: Samples = Samples { origin: [-992, -992], step: [64, 64], columns: 32, rows: 32 };
const RECEIVERS: Receivers =
    Receivers { origin: [-8176, -8170], step: [32, 31], height: 24_576, columns: 512, rows: 512 };

pub(super) fn all() -> Vec<Case> {
    let mut cases = vec![
        case("nothing", Size::Small, Vec::new),
        case("one", Size::Small, || vec![[[0, 0, 12_288], [100, 0, 12_288], [0, 100, 12_000]]]),
        case("beyond_the_planes", Size::Small, beyond),
        case("extremes", Size::Small, extremes),
        case("mixed_200000", Size::Real, || families(200_000 / 9)),
    ];
    cases.extend(
        Family::ALL
            .map(|family| case(family.name(), Size::Small, move || family.triangles(600, &SAMPLES, &RECEIVERS, 1))),
    );
    cases
}

/// Triangles with vertices on, under and above either plane.
fn beyond() -> Vec<Triangle> {
    let levels = [0, 1, 12_000, RECEIVERS.height - 1, RECEIVERS.height, 32_767];
    let mut triangles = Vec::new();
    for a in levels {
        for b in levels {
            for c in levels {
                triangles.push([[-500, 40, a], [700, -60, b], [10, 900, c]]);
            }
        }
    }
    triangles
}

/// Vertices at the corners of the grid, next to the source and next to the receivers.
fn extremes() -> Vec<Triangle> {
    let corners: Vec<Point> = [-16_384, 16_383]
        .into_iter()
        .flat_map(|x| [-16_384, 16_383].map(|y| (x, y)))
        .flat_map(|(x, y)| [1, RECEIVERS.height - 1].map(|z| [x, y, z]))
        .collect();
    let pick = |i: u32| corners[random::below(corners.len() as u32, 9, i) as usize];
    (0..300).map(|i| [pick(3 * i), pick(3 * i + 1), pick(3 * i + 2)]).collect()
}

fn families(each: u32) -> Vec<Triangle> {
    Family::ALL.into_iter().flat_map(|family| family.triangles(each, &SAMPLES, &RECEIVERS, 2)).collect()
}

fn case(name: &str, size: Size, make: impl Fn() -> Vec<Triangle> + Clone + Send + Sync + 'static) -> Case {
    let triangles = make.clone();
    let job = move || {
        let kernel = InfluenceRegion::new()?;
        let mut job = Job::new();
        let triangles = triangles();
        let count = triangles.len() as u64;
        let words: Vec<i32> = triangles.into_iter().flatten().flatten().collect();
        // A binding holds at least one element.
        let vertices = job.slice("vertices", if words.is_empty() { &[0] } else { &words[..] });
        let regions = job.zeroed("regions", 4 * count.max(1));
        kernel.record(&mut job, &SAMPLES, &RECEIVERS, vertices, regions)?;
        job.read("regions", regions.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let regions = make().into_iter().flat_map(|t| oracle::region(&t, &SAMPLES, &RECEIVERS));
        let mut words: Vec<u32> = regions.map(|word| word as u32).collect();
        words.resize(words.len().max(4), 0);
        vec![Expected::Whole(words)]
    };
    Case::new(name, size, job, expected).probes([0, 1, 2, 3])
}

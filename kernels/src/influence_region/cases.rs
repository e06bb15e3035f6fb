//! From no triangle to 200,000, and the families that are hard to get right; receivers on a parallel plane and on
//! others.

use sightlines_backend::host::Buffer;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{InfluenceRegion, TiltedRegion, oracle};
use crate::grid::{Faces, Lattice, Point, Receivers, Samples, Triangle, XY, Z};
use crate::random;
use crate::triangles::Family;

const SAMPLES: Samples = Samples { origin: [-992, -992], step: [64, 64], columns: 32, rows: 32 };
const RECEIVERS: Receivers =
    Receivers { origin: [-8176, -8170], step: [32, 31], height: 24_576, columns: 512, rows: 512 };
/// A floor that rises along x by half a step a step.
const SLOPE: Lattice =
    Lattice { origin: [-8176, -8170, 18_000], axes: [[32, 0, 16], [0, 31, 0]], columns: 512, rows: 512 };
/// A wall at right angles to the source, beside it.
const WALL: Lattice = Lattice { origin: [6000, -5000, 200], axes: [[0, 20, 0], [0, 0, 45]], columns: 500, rows: 400 };
/// Axes that are neither at right angles to each other nor to any of the grid's, and turn the other way.
const SKEW: Lattice =
    Lattice { origin: [3000, -7000, 9000], axes: [[-11, 23, 7], [17, 13, 29]], columns: 300, rows: 257 };

const ONE: Triangle = [[0, 0, 12_288], [100, 0, 12_288], [0, 100, 12_000]];

pub(super) fn all() -> Vec<Case> {
    let mut cases = vec![
        parallel("nothing", Size::Small, Vec::new),
        parallel("one", Size::Small, || vec![ONE]),
        parallel("beyond_the_planes", Size::Small, || beyond(RECEIVERS.height)),
        parallel("extremes", Size::Small, || extremes([1, RECEIVERS.height - 1])),
        one_sided("front_beyond_the_planes", Size::Small, || beyond(RECEIVERS.height)),
        one_sided("front_extremes", Size::Small, || extremes([1, RECEIVERS.height - 1])),
        one_sided("front_families", Size::Small, || families(100, &RECEIVERS)),
        one_sided("front_through_samples", Size::Small, through_samples),
        one_sided("front_mixed_50000", Size::Real, || families(50_000 / 10, &RECEIVERS)),
        parallel("mixed_200000", Size::Real, || families(200_000 / 9, &RECEIVERS)),
        tilted("tilted_nothing", Size::Small, SLOPE, Vec::new),
        tilted("tilted_one", Size::Small, SLOPE, || vec![ONE]),
        tilted("tilted_beyond_the_planes", Size::Small, SLOPE, || beyond(SLOPE.at(256)[2])),
        tilted("tilted_extremes", Size::Small, SKEW, || extremes([0, Z - 1])),
        tilted("tilted_widest", Size::Small, widest(), || extremes([0, Z - 1])),
        tilted("tilted_parallel", Size::Small, Lattice::from(&RECEIVERS), || families(60, &RECEIVERS)),
        tilted("tilted_slope", Size::Small, SLOPE, || families(60, SLOPE)),
        tilted("tilted_wall", Size::Small, WALL, || families(60, WALL)),
        tilted("tilted_skew", Size::Small, SKEW, || families(60, SKEW)),
        tilted("tilted_on_lattice_lines", Size::Small, SKEW, || exact(&SKEW)),
        tilted("tilted_mixed_100000", Size::Real, SLOPE, || families(100_000 / 10, SLOPE)),
    ];
    cases
        .extend(Family::ALL.map(|family| {
            parallel(family.name(), Size::Small, move || family.triangles(600, &SAMPLES, &RECEIVERS, 1))
        }));
    cases
}

/// Two receivers a side, as far apart as the grid allows: the largest products there are.
fn widest() -> Lattice {
    let side = 2 * XY - 1;
    Lattice { origin: [-XY, -XY, 1], axes: [[side, 0, Z - 2], [0, side, Z - 2]], columns: 2, rows: 1 }
}

/// Vertices half-way between corners of the source and receivers, so that projections are whole.
fn exact(lattice: &Lattice) -> Vec<Triangle> {
    let corners = SAMPLES.corners();
    let vertex = |index: u32| -> Point {
        let receiver = lattice.at(random::below(lattice.count(), 15, index));
        let sample = corners[index as usize % 4];
        // Sums that are odd are moved by half a unit: a near miss of a whole projection.
        std::array::from_fn(|k| (receiver[k] + sample[k]).div_euclid(2))
    };
    (0..300).map(|i| [vertex(3 * i), vertex(3 * i + 1), vertex(3 * i + 2)]).collect()
}

/// Triangles with vertices on, under and above the source plane and a height.
fn beyond(height: i32) -> Vec<Triangle> {
    let levels = [0, 1, 12_000, height - 1, height, 32_767];
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

/// Planes that hold samples: a vertex below two samples or one, so that a row of samples sees neither face.
fn through_samples() -> Vec<Triangle> {
    let pick = |index: u32| SAMPLES.at(random::below(SAMPLES.count(), 21, index));
    let below = |[x, y, _]: Point, z: i32| [x, y, z];
    let level = |index: u32| 1 + random::below(20_000, 22, index) as i32;
    let pairs = (0..200).map(|i| (i, pick(3 * i), pick(3 * i + 1), pick(3 * i + 2)));
    pairs
        .map(|(i, a, b, c)| {
            [
                below(a, level(3 * i)),
                below(b, level(3 * i + 1)),
                below(if i % 2 == 0 { a } else { c }, level(3 * i + 2)),
            ]
        })
        .collect()
}

/// Vertices at the corners of the grid, at two heights.
fn extremes(heights: [i32; 2]) -> Vec<Triangle> {
    let corners: Vec<Point> = [-16_384, 16_383]
        .into_iter()
        .flat_map(|x| [-16_384, 16_383].map(|y| (x, y)))
        .flat_map(|(x, y)| heights.map(|z| [x, y, z]))
        .collect();
    let pick = |i: u32| corners[random::below(corners.len() as u32, 9, i) as usize];
    (0..300).map(|i| [pick(3 * i), pick(3 * i + 1), pick(3 * i + 2)]).collect()
}

fn families<R: Into<Lattice> + Copy>(each: u32, receivers: R) -> Vec<Triangle> {
    Family::ALL.into_iter().flat_map(|family| family.triangles(each, &SAMPLES, receivers, 2)).collect()
}

fn parallel(name: &str, size: Size, make: impl Fn() -> Vec<Triangle> + Clone + Send + Sync + 'static) -> Case {
    by(Faces::Both, name, size, make)
}

fn one_sided(name: &str, size: Size, make: impl Fn() -> Vec<Triangle> + Clone + Send + Sync + 'static) -> Case {
    by(Faces::Front, name, size, make)
}

fn by(faces: Faces, name: &str, size: Size, make: impl Fn() -> Vec<Triangle> + Clone + Send + Sync + 'static) -> Case {
    let record = move |job: &mut Job, vertices, regions| {
        InfluenceRegion::with_faces(faces)?.record(job, &SAMPLES, &RECEIVERS, vertices, regions)
    };
    case(name, size, make, record, move |triangle| oracle::region_by(faces, triangle, &SAMPLES, &RECEIVERS))
}

fn tilted(
    name: &str,
    size: Size,
    lattice: Lattice,
    make: impl Fn() -> Vec<Triangle> + Clone + Send + Sync + 'static,
) -> Case {
    let record =
        move |job: &mut Job, vertices, regions| TiltedRegion::new()?.record(job, &SAMPLES, &lattice, vertices, regions);
    case(name, size, make, record, move |triangle| oracle::tilted(triangle, &SAMPLES, &lattice))
}

fn case(
    name: &str,
    size: Size,
    make: impl Fn() -> Vec<Triangle> + Clone + Send + Sync + 'static,
    record: impl Fn(&mut Job, Buffer<[i32]>, Buffer<[i32]>) -> Result<()> + Send + Sync + 'static,
    region: impl Fn(&Triangle) -> [i32; 4] + Send + Sync + 'static,
) -> Case {
    let triangles = make.clone();
    let job = move || {
        let mut job = Job::new();
        let triangles = triangles();
        let count = triangles.len() as u64;
        let words = triangles.as_flattened().as_flattened();
        // A binding holds at least one element.
        let vertices = job.slice("vertices", if words.is_empty() { &[0] } else { words });
        let regions = job.zeroed("regions", 4 * count.max(1));
        record(&mut job, vertices, regions)?;
        job.read("regions", regions.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let mut words: Vec<u32> = make().iter().flat_map(&region).map(|word| word as u32).collect();
        words.resize(words.len().max(4), 0);
        vec![Expected::Whole(words)]
    };
    Case::new(name, size, job, expected).probes([0, 1, 2, 3])
}

//! Influence regions against the definition: they miss no receiver, and no side of them could be nearer.

use sightlines_backend::Job;
use sightlines_kernels::grid::{Lattice, Receivers, Samples, Triangle, hidden};
use sightlines_kernels::influence_region::{TiltedRegion, oracle};
use sightlines_kernels::triangles::Family;

/// Few samples close together, so that all of the source is tried.
const SAMPLES: Samples = Samples { origin: [-40, -30], step: [9, 11], columns: 8, rows: 8 };

const LATTICES: [(&str, Lattice); 4] = [
    ("floor", Lattice { origin: [-150, -150, 400], axes: [[13, 0, 0], [0, 17, 0]], columns: 24, rows: 20 }),
    ("slope", Lattice { origin: [-150, -150, 300], axes: [[13, 0, 5], [0, 17, -2]], columns: 24, rows: 20 }),
    ("wall", Lattice { origin: [160, -150, 20], axes: [[0, 13, 0], [0, 0, 17]], columns: 24, rows: 20 }),
    ("skew", Lattice { origin: [420, -100, 150], axes: [[-7, 11, 3], [5, 3, 15]], columns: 24, rows: 20 }),
];

fn triangles(lattice: Lattice) -> Vec<Triangle> {
    let mut triangles: Vec<Triangle> =
        Family::ALL.into_iter().flat_map(|family| family.triangles(24, &SAMPLES, lattice, 31)).collect();
    // Through either plane, and through both.
    let raised = triangles.clone();
    triangles.extend(raised.iter().step_by(3).map(|[a, b, [x, y, _]]| [*a, *b, [*x, *y, 0]]));
    triangles.extend(raised.iter().step_by(4).map(|[a, b, [x, y, _]]| [*a, *b, [*x, *y, 900]]));
    triangles.extend(raised.iter().step_by(5).map(|[a, [u, v, _], [x, y, _]]| [*a, [*u, *v, 900], [*x, *y, 0]]));
    triangles
}

fn contains([x0, x1, y0, y1]: [i32; 4], lattice: &Lattice, receiver: u32) -> bool {
    let (column, row) = ((receiver % lattice.columns) as i32, (receiver / lattice.columns) as i32);
    (x0..=x1).contains(&column) && (y0..=y1).contains(&row)
}

#[test]
fn no_receiver_outside_a_region_is_hidden_from_any_sample() {
    for (name, lattice) in LATTICES {
        let [mut inside, mut bounded, mut empty] = [0; 3];
        for triangle in triangles(lattice) {
            let region = oracle::tilted(&triangle, &SAMPLES, &lattice);
            bounded += u32::from(region != [0, 23, 0, 19]);
            empty += u32::from(region[0] > region[1] || region[2] > region[3]);
            for receiver in 0..lattice.count() {
                let is_hidden = (0..SAMPLES.count()).any(|s| hidden(lattice.at(receiver), SAMPLES.at(s), &triangle));
                let within = contains(region, &lattice, receiver);
                assert!(
                    within || !is_hidden,
                    "{name}: {triangle:?} hides from receiver {receiver} and not in {region:?}"
                );
                inside += u32::from(is_hidden);
            }
        }
        assert!(
            inside > 1000 && bounded > 80 && empty > 10,
            "{name}: {inside} hidden, {bounded} bounded, {empty} empty"
        );
    }
}

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Points of the source's rectangle, its corners among them.
fn source() -> Vec<Vector> {
    let [first, .., last] = SAMPLES.corners();
    let between =
        |axis: usize, part: u32| f64::from(first[axis]) + f64::from(last[axis] - first[axis]) * f64::from(part) / 4.0;
    (0..25).map(|i| [between(0, i % 5), between(1, i / 5), 0.0]).collect()
}

/// Points of a triangle, its vertices among them.
fn points(triangle: &Triangle) -> Vec<Vector> {
    let mean = |weights: [i32; 3]| {
        std::array::from_fn(|k| (0..3).map(|v| f64::from(weights[v] * triangle[v][k])).sum::<f64>() / 4.0)
    };
    (0..=4).flat_map(|a| (0..=4 - a).map(move |b| mean([a, b, 4 - a - b]))).collect()
}

/// Least and greatest column and row at which lines from the source through the triangle meet the lattice's plane;
/// nothing where they do not all meet it, or the triangle does not lie in front of it.
fn bounds(triangle: &Triangle, lattice: &Lattice) -> Option<[[f64; 2]; 2]> {
    let [origin, across, down, normal] =
        [lattice.origin, lattice.axes[0], lattice.axes[1], lattice.normal()].map(|v| v.map(f64::from));
    let height = |p: Vector| dot(normal, std::array::from_fn(|k| p[k] - origin[k]));
    let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for s in source() {
        for p in points(triangle) {
            let (far, near) = (height(s).abs(), height(p) * height(s).signum());
            if p[2] <= 0.0 || near <= 0.0 || near >= far {
                return None;
            }
            let meets: Vector = std::array::from_fn(|k| s[k] + (p[k] - s[k]) * far / (far - near) - origin[k]);
            let dual = [cross(down, normal), cross(normal, across)];
            for (bound, dual) in bounds.iter_mut().zip(dual) {
                let at = dot(meets, dual) / dot(normal, normal);
                *bound = [bound[0].min(at), bound[1].max(at)];
            }
        }
    }
    Some(bounds)
}

#[test]
fn regions_of_triangles_in_front_are_the_boxes_of_their_projections() {
    for (name, lattice) in LATTICES {
        let mut seen = 0;
        for triangle in triangles(lattice) {
            let Some([columns, rows]) = bounds(&triangle, &lattice) else { continue };
            seen += 1;
            let region = oracle::tilted(&triangle, &SAMPLES, &lattice);
            for (found, [low, high], count) in
                [([region[0], region[1]], columns, 24), ([region[2], region[3]], rows, 20)]
            {
                // Within rounding of a whole number both neighbours are right here.
                let first = [low - 1e-7, low + 1e-7].map(|low| (low.ceil() as i32).clamp(0, count));
                let last = [high - 1e-7, high + 1e-7].map(|high| (high.floor() as i32).clamp(-1, count - 1));
                assert!(first.contains(&found[0]) && last.contains(&found[1]), "{name}: {triangle:?} has {region:?}");
            }
        }
        assert!(seen > 60, "{name}: {seen} triangles in front");
    }
}

#[test]
fn the_parallel_case_is_the_tilted_one_with_axes_along_the_source() {
    let receivers = Receivers { origin: [-150, -150], step: [13, 17], height: 400, columns: 24, rows: 20 };
    let lattice = Lattice::from(&receivers);
    for triangle in triangles(lattice) {
        let [x0, x1, y0, y1] = oracle::region(&triangle, &SAMPLES, &receivers);
        let ends = [x0.clamp(0, 24), x1.clamp(-1, 23), y0.clamp(0, 20), y1.clamp(-1, 19)];
        assert_eq!(ends, oracle::tilted(&triangle, &SAMPLES, &lattice), "{triangle:?}");
    }
}

#[test]
fn a_light_that_reaches_the_plane_of_its_receivers_is_refused() {
    let kernel = TiltedRegion::new().expect("it compiles");
    let mut job = Job::new();
    let (vertices, regions) = (job.zeroed("vertices", 9), job.zeroed("regions", 4));
    let wall = LATTICES[2].1;
    kernel.record(&mut job, &SAMPLES, &wall, vertices, regions).expect("a wall beside the light");
    let through = Lattice { origin: [0, -150, 20], ..wall };
    for lattice in [through, Lattice { origin: [23, -150, 20], ..wall }] {
        let error = kernel.record(&mut Job::new(), &SAMPLES, &lattice, vertices, regions).expect_err("it is refused");
        assert!(error.to_string().contains("clear of each other"), "{error}");
    }
    let short = job.zeroed("regions", 3);
    let error = kernel.record(&mut job, &SAMPLES, &wall, vertices, short).expect_err("it is refused");
    assert!(error.to_string().contains("four words"), "{error}");
}

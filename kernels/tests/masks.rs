//! The kernels that see, on shrinking random scenes: masks equal the definition, shared edges neither leak nor cover twice,
//! and influence regions miss no receiver. Kernels run on the interpreter; a failure prints the least scene that fails.

use std::sync::LazyLock;

use proptest::prelude::*;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::grid::{Lattice, Point, Receivers, Samples, Triangle, XY, Z, hidden, hidden_set, is_on_grid};
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::{InfluenceRegion, TiltedRegion, oracle};
use sightlines_kernels::row_span::{RowSpan, Scene, Tiles, is_between, tile_width};

/// One interpreter for all scenes, so that a kernel is lowered once.
static MACHINE: LazyLock<CpuBackend> =
    LazyLock::new(|| CpuBackend::new(Config { bounds: Bounds::Trap, threads: 1, ..Config::default() }));

/// Columns and rows of the lights that a bake uses.
const SHAPES: [[u32; 2]; 6] = [[8, 4], [8, 8], [16, 8], [16, 16], [32, 16], [32, 32]];

/// A light over its receivers.
#[derive(Clone, Copy, Debug)]
struct View {
    samples: Samples,
    receivers: Receivers,
}

/// An origin and a step of `count` points that stay on the grid; steps of few units make ties.
fn axis(count: u32) -> impl Strategy<Value = (i32, i32)> {
    let most = (XY / count as i32).max(2);
    let step =
        prop_oneof![1..4_i32, 1..most, Just(most - 1), (0..6_u32).prop_map(move |bits| (1 << bits).min(most - 1))];
    step.prop_flat_map(move |step| {
        let extent = step * (count as i32 - 1);
        (prop_oneof![-extent..=0, -XY..XY - extent], Just(step))
    })
}

fn view() -> impl Strategy<Value = View> {
    let light = (0..SHAPES.len()).prop_flat_map(|shape| {
        let [columns, rows] = SHAPES[shape];
        (axis(columns), axis(rows)).prop_map(move |((x, step_x), (y, step_y))| Samples {
            origin: [x, y],
            step: [step_x, step_y],
            columns,
            rows,
        })
    });
    let floor = (1..12_u32, 1..6_u32).prop_flat_map(|(columns, rows)| {
        let height = prop_oneof![2..9, 2..600, 2..Z, Just(Z - 1)];
        (axis(columns), axis(rows), height).prop_map(move |((x, step_x), (y, step_y), height)| Receivers {
            origin: [x, y],
            step: [step_x, step_y],
            height,
            columns,
            rows,
        })
    });
    (light, floor).prop_map(|(samples, receivers)| View { samples, receivers })
}

impl View {
    /// Anywhere on the grid; on or beside a line from a receiver to a sample, exactly where the grid allows.
    fn vertex(self) -> impl Strategy<Value = Point> {
        let Receivers { height, .. } = self.receivers;
        let anywhere = (-XY..XY, -XY..XY, 0..Z).prop_map(|(x, y, z)| [x, y, z]);
        let sides = (0..self.receivers.count(), 0..self.samples.count());
        let part = prop_oneof![Just((1, 2)), Just((1, 4)), Just((3, 4)), (0..8, Just(8)), (0..200, Just(199))];
        let beside = [-2..=2_i32, -2..=2, -2..=2];
        let on_ray = (sides, part, prop_oneof![Just([0; 3]), beside]).prop_map(move |((r, s), (part, of), beside)| {
            let (receiver, sample) = (self.receivers.at(r), self.samples.at(s));
            let at = std::array::from_fn(|k| sample[k] + (receiver[k] - sample[k]) * part / of + beside[k]);
            clamped(at, [0, Z - 1])
        });
        let level = (anywhere.clone(), prop_oneof![Just(0), Just(1), Just(height - 1), Just(height), Just(Z - 1)])
            .prop_map(|([x, y, _], z)| [x, y, z]);
        prop_oneof![1 => anywhere, 6 => on_ray, 1 => level]
    }

    /// A vertex strictly between source and receivers.
    fn between(self) -> impl Strategy<Value = Point> {
        let height = self.receivers.height;
        self.vertex().prop_map(move |vertex| clamped(vertex, [1, height - 1]))
    }
}

fn clamped([x, y, z]: Point, [low, high]: [i32; 2]) -> Point {
    [x.clamp(-XY, XY - 1), y.clamp(-XY, XY - 1), z.clamp(low, high)]
}

/// A view and triangles of vertices of any height, or strictly between the planes.
fn scene(most: usize, between: bool) -> impl Strategy<Value = (View, Vec<Triangle>)> {
    view().prop_flat_map(move |view| {
        let vertex = if between { view.between().boxed() } else { view.vertex().boxed() };
        let triangle = [vertex.clone(), vertex.clone(), vertex];
        (Just(view), proptest::collection::vec(triangle, 1..=most))
    })
}

/// The masks of each group of triangles, by a kernel.
fn masks(
    view: &View,
    groups: &[&[Triangle]],
    mut record: impl FnMut(&mut Job, &[Triangle], Buffer<[i32]>, Buffer<[u32]>),
) -> Vec<Vec<u32>> {
    let mut job = Job::new();
    for triangles in groups {
        let vertices = job.slice("vertices", triangles.as_flattened().as_flattened());
        let hidden = job.zeroed("hidden", u64::from(view.receivers.count() * view.samples.words()));
        record(&mut job, triangles, vertices, hidden);
        job.read("hidden", hidden.id());
    }
    let outputs = MACHINE.run(&job).expect("it runs");
    outputs.iter().map(|bytes| bytes.as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect()).collect()
}

fn by_half_planes(view: &View, groups: &[&[Triangle]]) -> Vec<Vec<u32>> {
    let kernel = HalfPlanes::new(&view.samples).expect("it compiles");
    masks(view, groups, |job, triangles, vertices, hidden| {
        let all = 0..triangles.len() as u32;
        kernel.record(job, &view.receivers, vertices, all, hidden).expect("it is recorded");
    })
}

fn by_row_span(view: &View, groups: &[&[Triangle]]) -> Vec<Vec<u32>> {
    let View { samples, receivers } = view;
    let kernel = RowSpan::new(samples).expect("it compiles");
    masks(view, groups, |job, triangles, vertices, hidden| {
        assert!(triangles.iter().all(|t| is_between(t, receivers.height)), "{triangles:?}");
        let regions: Vec<[i32; 4]> = triangles.iter().map(|t| oracle::region(t, samples, receivers)).collect();
        let tiles = Tiles::new([tile_width(samples), 2], receivers, &regions);
        let starts = job.slice("starts", &tiles.starts);
        // A binding holds at least one element.
        let entries = job.slice("entries", if tiles.entries.is_empty() { &[0] } else { &tiles.entries[..] });
        let buffers = Scene { vertices, starts, entries, hidden };
        kernel.record(job, receivers, &tiles, buffers).expect("it is recorded");
    })
}

/// The masks by the definition, in the order of the kernels'.
fn defined(view: &View, triangles: &[Triangle]) -> Vec<u32> {
    let count = view.receivers.count();
    let sets: Vec<Vec<u32>> = (0..count).map(|r| hidden_set(view.receivers.at(r), &view.samples, triangles)).collect();
    (0..view.samples.words() as usize).flat_map(|word| sets.iter().map(move |set| set[word])).collect()
}

/// A triangle and a point of its edge, all on the grid: the edge's middle.
fn split(view: View) -> impl Strategy<Value = (Triangle, Point)> {
    [view.between(), view.between(), view.between()].prop_map(|[a, b, c]| {
        let c = std::array::from_fn(|k| c[k] - (c[k] - b[k]) % 2);
        ([a, b, c], std::array::from_fn(|k| (b[k] + c[k]) / 2))
    })
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, max_shrink_iters: 4096, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config(256))]

    #[test]
    fn half_planes_equal_the_definition((view, triangles) in scene(3, false)) {
        prop_assert_eq!(&by_half_planes(&view, &[&triangles])[0], &defined(&view, &triangles));
    }

    #[test]
    fn row_spans_equal_the_definition((view, triangles) in scene(3, true)) {
        prop_assert_eq!(&by_row_span(&view, &[&triangles])[0], &defined(&view, &triangles));
    }

    #[test]
    fn two_halves_of_a_triangle_make_it_up_and_share_no_sample(
        (view, ([a, b, c], middle)) in view().prop_flat_map(|view| (Just(view), split(view)))
    ) {
        let parts: [&[Triangle]; 3] = [&[[a, b, c]], &[[a, b, middle]], &[[middle, c, a]]];
        for masks in [by_row_span(&view, &parts), by_half_planes(&view, &parts)] {
            for ((whole, left), right) in masks[0].iter().zip(&masks[1]).zip(&masks[2]) {
                prop_assert_eq!(left & right, 0, "samples are covered twice");
                prop_assert_eq!(left | right, *whole, "samples leak, or are gained");
            }
        }
    }

    #[test]
    fn a_closed_mesh_is_left_as_often_as_it_is_entered(
        (view, [a, b, c, d]) in view().prop_flat_map(|view| {
            (Just(view), [view.between(), view.between(), view.between(), view.between()])
        })
    ) {
        let faces: [&[Triangle]; 4] = [&[[a, b, c]], &[[a, c, d]], &[[a, d, b]], &[[b, d, c]]];
        for masks in [by_row_span(&view, &faces), by_half_planes(&view, &faces)] {
            for word in 0..masks[0].len() {
                prop_assert_eq!(masks.iter().fold(0, |parity, mask| parity ^ mask[word]), 0, "word {}", word);
            }
        }
    }

    #[test]
    fn no_receiver_outside_a_region_is_hidden_from_any_sample((view, triangles) in scene(2, false)) {
        let View { samples, receivers } = view;
        for triangle in &triangles {
            let [x0, x1, y0, y1] = region_of(triangle, &samples, &receivers);
            for receiver in 0..receivers.count() {
                let (x, y) = ((receiver % receivers.columns) as i32, (receiver / receivers.columns) as i32);
                let inside = (x0..=x1).contains(&x) && (y0..=y1).contains(&y);
                let set = hidden_set(receivers.at(receiver), &samples, [triangle]);
                prop_assert!(inside || set.iter().all(|word| *word == 0), "receiver ({x}, {y}) of {triangle:?}");
            }
        }
    }
}

/// The region by the kernel, which must equal the oracle's.
fn region_of(triangle: &Triangle, samples: &Samples, receivers: &Receivers) -> [i32; 4] {
    let mut job = Job::new();
    let vertices = job.slice("vertices", triangle.as_flattened());
    let regions = job.zeroed("regions", 4);
    let kernel = InfluenceRegion::new().expect("it compiles");
    kernel.record(&mut job, samples, receivers, vertices, regions).expect("it is recorded");
    let region = read_region(job, regions);
    assert_eq!(region, oracle::region(triangle, samples, receivers), "{triangle:?}");
    region
}

fn read_region(mut job: Job, regions: Buffer<[i32]>) -> [i32; 4] {
    job.read("regions", regions.id());
    let bytes = &MACHINE.run(&job).expect("it runs")[0];
    std::array::from_fn(|k| i32::from_le_bytes(std::array::from_fn(|byte| bytes[4 * k + byte])))
}

/// A lattice of few receivers on the grid, on any plane, beside which the light stands clear.
fn lattice() -> impl Strategy<Value = (Samples, Lattice)> {
    let step = || prop_oneof![-3..=3_i32, -40..=40, -1500..=1500];
    let axes = [[step(), step(), step()], [step(), step(), step()]];
    let origin = (-XY..XY, -XY..XY, 1..Z).prop_map(|(x, y, z)| [x, y, z]);
    let lattice = (origin, axes, 1..9_u32, 1..9_u32)
        .prop_map(|(origin, axes, columns, rows)| Lattice { origin, axes, columns, rows })
        .prop_filter("on the grid", |lattice| lattice.check().is_ok());
    (view(), lattice).prop_map(|(view, lattice)| (view.samples, lattice)).prop_filter(
        "the light stands on one side",
        |(samples, lattice)| {
            let side = |p: Point| {
                let n = lattice.normal();
                (0..3).map(|k| i128::from(n[k]) * i128::from(p[k] - lattice.origin[k])).sum::<i128>().signum()
            };
            let sides = samples.corners().map(side);
            sides[0] != 0 && sides.iter().all(|s| *s == sides[0])
        },
    )
}

proptest! {
    #![proptest_config(config(192))]

    #[test]
    fn regions_on_tilted_receivers_miss_none(
        ((samples, lattice), picks) in (lattice(), proptest::collection::vec((0..64_u32, 0..1024_u32, 0..=8_i32), 3)),
        beside in [-300..=300_i32, -300..=300, -300..=300],
    ) {
        // Vertices on lines from receivers to samples, and one moved off its line.
        let mut triangle: Triangle = std::array::from_fn(|v| {
            let (r, s, part) = picks[v];
            let (receiver, sample) = (lattice.at(r % lattice.count()), samples.at(s % samples.count()));
            std::array::from_fn(|k| sample[k] + (receiver[k] - sample[k]) * part / 8)
        });
        triangle[2] = clamped(std::array::from_fn(|k| triangle[2][k] + beside[k]), [0, Z - 1]);
        prop_assert!(triangle.iter().all(|v| is_on_grid(*v)));
        let mut job = Job::new();
        let (vertices, regions) = (job.slice("vertices", triangle.as_flattened()), job.zeroed("regions", 4));
        let kernel = TiltedRegion::new().expect("it compiles");
        kernel.record(&mut job, &samples, &lattice, vertices, regions).expect("it is recorded");
        let region = read_region(job, regions);
        prop_assert_eq!(region, oracle::tilted(&triangle, &samples, &lattice));
        for receiver in 0..lattice.count() {
            let (x, y) = ((receiver % lattice.columns) as i32, (receiver / lattice.columns) as i32);
            let inside = (region[0]..=region[1]).contains(&x) && (region[2]..=region[3]).contains(&y);
            let is_hidden = || (0..samples.count()).any(|s| hidden(lattice.at(receiver), samples.at(s), &triangle));
            prop_assert!(inside || !is_hidden(), "receiver ({x}, {y})");
        }
    }
}

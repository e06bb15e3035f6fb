//! The kernels that see, on shrinking random scenes: masks equal the definition, shared edges neither leak nor cover
//! twice, and influence regions miss no receiver. Kernels run on the interpreter; a failure prints the least scene that
//! fails.

use std::sync::LazyLock;

use proptest::prelude::*;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Job};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::field::Field;
use sightlines_kernels::grid::{Lattice, Point, Receivers, Samples, Triangle, XY, Z, hidden, hidden_set, is_on_grid};
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::{InfluenceRegion, TiltedRegion, oracle};
use sightlines_kernels::line_mask::{LineMask, Resolution, Space, TILE};
use sightlines_kernels::pattern::Pattern;
use sightlines_kernels::row_span::{HEIGHT, RowSpan, Scene, WIDTH, is_between};
use sightlines_kernels::tiles::Tiles;

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

/// Numbers that become an origin and a step of points that stay on the grid.
type RawAxis = (i32, i32);

/// Numbers that become a view. Scenes are made from numbers that do not depend on each other, so that they shrink.
#[derive(Clone, Copy, Debug)]
struct RawView {
    shape: usize,
    light: [RawAxis; 2],
    floor: [RawAxis; 2],
    size: [u32; 2],
    height: i32,
}

/// Numbers that become a vertex: `part` of the way from a sample to a receiver, if there is a part, and moved.
#[derive(Clone, Copy, Debug)]
struct RawVertex {
    point: Point,
    receiver: u32,
    sample: u32,
    part: Option<(i32, i32)>,
}

fn raw_axis() -> impl Strategy<Value = RawAxis> {
    // Steps of few units, and of powers of two, make ties.
    let step = prop_oneof![1..4, 1..XY, (0..14).prop_map(|bits| 1 << bits)];
    (prop_oneof![-200..200, -XY..XY], step)
}

fn raw_view() -> impl Strategy<Value = RawView> {
    let height = prop_oneof![2..9, 2..600, 2..Z];
    (0..SHAPES.len(), [raw_axis(), raw_axis()], [raw_axis(), raw_axis()], [1..12_u32, 1..6], height)
        .prop_map(|(shape, light, floor, size, height)| RawView { shape, light, floor, size, height })
}

fn raw_vertex() -> impl Strategy<Value = RawVertex> {
    let beside = [prop_oneof![Just(0), -2..=2], prop_oneof![Just(0), -2..=2], prop_oneof![Just(0), -2..=2]];
    let part = prop_oneof![Just((1, 2)), Just((1, 4)), Just((3, 4)), (0..8, Just(8)), (0..200, Just(199))];
    let on_ray = (beside, part.prop_map(Some));
    let anywhere = ([-XY..XY, -XY..XY, 0..Z], Just(None));
    // Of all heights those on and next to the planes matter most; `between` holds the last to the receivers'.
    let height = prop_oneof![Just(0), Just(1), Just(Z - 1)];
    let level = (-XY..XY, -XY..XY, height).prop_map(|(x, y, z)| ([x, y, z], None));
    let place = prop_oneof![6 => on_ray.boxed(), 1 => anywhere.boxed(), 1 => level.boxed()];
    (place, 0..60_u32, 0..1024_u32).prop_map(|((point, part), receiver, sample)| RawVertex {
        point,
        receiver,
        sample,
        part,
    })
}

impl RawView {
    fn view(self) -> View {
        let [columns, rows] = SHAPES[self.shape];
        let (x, y) = (on_grid(self.light[0], columns), on_grid(self.light[1], rows));
        let samples = Samples { origin: [x.0, y.0], step: [x.1, y.1], columns, rows };
        let [columns, rows] = self.size;
        let (x, y) = (on_grid(self.floor[0], columns), on_grid(self.floor[1], rows));
        let height = self.height;
        View { samples, receivers: Receivers { origin: [x.0, y.0], step: [x.1, y.1], height, columns, rows } }
    }
}

fn on_grid((origin, step): RawAxis, count: u32) -> RawAxis {
    let steps = count as i32 - 1;
    let step = step.min((2 * XY - 1) / steps.max(1));
    (origin.clamp(-XY, XY - 1 - step * steps), step)
}

impl RawVertex {
    /// The vertex, its z held within `heights`.
    fn vertex(self, view: &View, heights: [i32; 2]) -> Point {
        let RawVertex { point, receiver, sample, part } = self;
        let receiver = view.receivers.at(receiver % view.receivers.count());
        let sample = view.samples.at(sample % view.samples.count());
        let along = |k: usize| part.map_or(0, |(part, of)| sample[k] + (receiver[k] - sample[k]) * part / of);
        clamped(std::array::from_fn(|k| along(k) + point[k]), heights)
    }
}

fn clamped([x, y, z]: Point, [low, high]: [i32; 2]) -> Point {
    [x.clamp(-XY, XY - 1), y.clamp(-XY, XY - 1), z.clamp(low, high)]
}

/// A view and up to so many triangles, of vertices of any height.
fn scene(most: usize) -> impl Strategy<Value = (View, Vec<Triangle>)> {
    let triangle = [raw_vertex(), raw_vertex(), raw_vertex()];
    (raw_view(), proptest::collection::vec(triangle, 1..=most)).prop_map(|(raw, triangles)| {
        let view = raw.view();
        (view, triangles.into_iter().map(|t| t.map(|v| v.vertex(&view, [0, Z - 1]))).collect())
    })
}

/// A view and points strictly between its planes.
fn between<const N: usize>() -> impl Strategy<Value = (View, [Point; N])> {
    (raw_view(), std::array::from_fn::<_, N, _>(|_| raw_vertex())).prop_map(|(raw, points)| {
        let view = raw.view();
        (view, points.map(|v| v.vertex(&view, [1, view.receivers.height - 1])))
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
        let (tiles, scene) = tiled(job, view, triangles, [WIDTH, HEIGHT], vertices, hidden);
        kernel.record(job, receivers, &tiles, scene).expect("it is recorded");
    })
}

/// By the exact table of lines, as coarse as a table may be, so that much is left to signs.
fn by_line_mask(view: &View, groups: &[&[Triangle]]) -> Vec<Vec<u32>> {
    let View { samples, receivers } = view;
    let pattern = Pattern::regular(samples).expect("it is on the grid");
    let kernel = LineMask::new(&pattern, Resolution { space: Space::Exact, bits: 3 }).expect("it compiles");
    masks(view, groups, |job, triangles, vertices, hidden| {
        let table = kernel.record_table(job);
        let (tiles, scene) = tiled(job, view, triangles, TILE, vertices, hidden);
        kernel.record(job, &Field::from(receivers), &tiles, table, scene).expect("it is recorded");
    })
}

/// Triangles sorted into tiles by their regions.
fn tiled(
    job: &mut Job,
    view: &View,
    triangles: &[Triangle],
    size: [u32; 2],
    vertices: Buffer<[i32]>,
    hidden: Buffer<[u32]>,
) -> (Tiles, Scene) {
    let regions: Vec<[i32; 4]> = triangles.iter().map(|t| oracle::region(t, &view.samples, &view.receivers)).collect();
    let tiles = Tiles::new(size, &view.receivers, &regions);
    let starts = job.slice("starts", &tiles.starts);
    // A binding holds at least one element.
    let entries = job.slice("entries", if tiles.entries.is_empty() { &[0] } else { &tiles.entries[..] });
    (tiles, Scene { vertices, starts, entries, hidden })
}

/// The first receiver and sample of which masks and definition disagree.
fn difference(view: &View, found: &[u32], triangles: &[Triangle]) -> Option<String> {
    let (count, words) = (view.receivers.count(), view.samples.words());
    (0..count).find_map(|receiver| {
        let set = hidden_set(view.receivers.at(receiver), &view.samples, triangles);
        (0..words).find_map(|word| {
            let (found, wanted) = (found[(word * count + receiver) as usize], set[word as usize]);
            let sample = 32 * word + (found ^ wanted).trailing_zeros();
            (found != wanted).then(|| {
                let [at, from] = [view.receivers.at(receiver), view.samples.at(sample)];
                let wrongly = if wanted >> (sample % 32) & 1 == 0 { "wrongly hidden" } else { "wrongly visible" };
                format!("sample {sample} {from:?} is {wrongly} from receiver {receiver} {at:?}")
            })
        })
    })
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, max_shrink_iters: 4096, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config(192))]

    #[test]
    fn half_planes_equal_the_definition((view, triangles) in scene(3)) {
        let found = by_half_planes(&view, &[&triangles]);
        prop_assert_eq!(difference(&view, &found[0], &triangles), None);
    }

    #[test]
    fn line_masks_equal_the_definition((view, triangles) in scene(3)) {
        let found = by_line_mask(&view, &[&triangles]);
        prop_assert_eq!(difference(&view, &found[0], &triangles), None);
    }

    #[test]
    fn row_spans_equal_the_definition((view, [a, b, c, d]) in between()) {
        let triangles = [[a, b, c], [d, c, b]];
        let found = by_row_span(&view, &[&triangles]);
        prop_assert_eq!(difference(&view, &found[0], &triangles), None);
    }

    #[test]
    fn two_halves_of_a_triangle_make_it_up_and_share_no_sample((view, [a, b, c]) in between()) {
        // Moved by at most a unit, so that the middle of an edge is a point of the grid.
        let c: Point = std::array::from_fn(|k| c[k] - (c[k] - b[k]) % 2);
        let middle: Point = std::array::from_fn(|k| (b[k] + c[k]) / 2);
        let parts: [&[Triangle]; 3] = [&[[a, b, c]], &[[a, b, middle]], &[[middle, c, a]]];
        for by in [by_row_span, by_half_planes, by_line_mask] {
            let masks = by(&view, &parts);
            for ((whole, left), right) in masks[0].iter().zip(&masks[1]).zip(&masks[2]) {
                prop_assert_eq!(left & right, 0, "samples are covered twice");
                prop_assert_eq!(left | right, *whole, "samples leak, or are gained");
            }
        }
    }

    #[test]
    fn a_closed_mesh_is_left_as_often_as_it_is_entered((view, [a, b, c, d]) in between()) {
        let faces: [&[Triangle]; 4] = [&[[a, b, c]], &[[a, c, d]], &[[a, d, b]], &[[b, d, c]]];
        for by in [by_row_span, by_half_planes, by_line_mask] {
            let masks = by(&view, &faces);
            for word in 0..masks[0].len() {
                prop_assert_eq!(masks.iter().fold(0, |parity, mask| parity ^ mask[word]), 0, "word {}", word);
            }
        }
    }

    #[test]
    fn no_receiver_outside_a_region_is_hidden_from_any_sample((view, triangles) in scene(2)) {
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
    (raw_view(), lattice).prop_map(|(raw, lattice)| (raw.view().samples, lattice)).prop_filter(
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

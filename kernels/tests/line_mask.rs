//! Tables of lines against the kernels that need none: the same masks on regular lights, whatever the table's size; and the
//! paper's table, wrong by less the finer it is.

use sightlines_backend::{Backend, ErrorKind, Job};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::grid::{Receivers, Samples, Triangle};
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::oracle::region;
use sightlines_kernels::line_mask::{LineMask, Resolution, Space, oracle, record_differ, tile_shape};
use sightlines_kernels::pattern::Pattern;
use sightlines_kernels::row_span::{RowSpan, Scene, Tiles, is_between, tile_width};
use sightlines_kernels::triangles::{Family, crossing};

const RECEIVERS: Receivers =
    Receivers { origin: [-1500, -1100], step: [97, 61], height: 20_000, columns: 33, rows: 19 };

fn light(columns: u32, rows: u32) -> Samples {
    Samples { origin: [-1000, -900], step: [63, 58], columns, rows }
}

fn tiles(size: [u32; 2], samples: &Samples, triangles: &[Triangle]) -> Tiles {
    let regions: Vec<[i32; 4]> = triangles.iter().map(|t| region(t, samples, &RECEIVERS)).collect();
    Tiles::new(size, &RECEIVERS, &regions)
}

fn scene(job: &mut Job, tiles: &Tiles, triangles: &[Triangle], words: u32) -> Scene {
    Scene {
        vertices: job.slice("vertices", triangles.as_flattened().as_flattened()),
        starts: job.slice("starts", &tiles.starts),
        entries: job.slice("entries", &tiles.entries),
        hidden: job.zeroed("hidden", u64::from(RECEIVERS.count() * words)),
    }
}

fn run(job: &Job) -> Vec<Vec<u32>> {
    let backend = CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() });
    let outputs = backend.run(job).expect("it runs");
    let words = |bytes: &Vec<u8>| bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
    outputs.iter().map(words).collect()
}

fn exact(bits: u32) -> Resolution {
    Resolution { space: Space::Exact, bits }
}

#[test]
fn a_regular_light_has_the_masks_of_row_spans_and_half_planes() {
    for (columns, rows, bits) in [(32, 32, 4), (16, 16, 5), (8, 8, 6), (8, 4, 7)] {
        let samples = light(columns, rows);
        let pattern = Pattern::regular(&samples).expect("on the grid");
        let triangles: Vec<Triangle> =
            Family::ALL.iter().flat_map(|family| family.triangles(40, &samples, &RECEIVERS, 8)).collect();
        assert!(triangles.iter().all(|triangle| is_between(triangle, RECEIVERS.height)));

        let mut job = Job::new();
        let kernel = LineMask::new(&pattern, exact(bits)).expect("it compiles");
        let lists = tiles(tile_shape(&pattern), &samples, &triangles);
        let by_table = scene(&mut job, &lists, &triangles, samples.words());
        let table = kernel.record_table(&mut job);
        kernel.record(&mut job, &RECEIVERS, &lists, table, by_table).expect("it fits");

        let lists = tiles([tile_width(&samples), 4], &samples, &triangles);
        let by_rows = scene(&mut job, &lists, &triangles, samples.words());
        RowSpan::new(&samples).and_then(|rows| rows.record(&mut job, &RECEIVERS, &lists, by_rows)).expect("it fits");

        let by_signs = job.zeroed("hidden", by_rows.hidden.len());
        let all = 0..triangles.len() as u32;
        let kernel = HalfPlanes::new(&samples).expect("it compiles");
        kernel.record(&mut job, &RECEIVERS, by_rows.vertices, all, by_signs).expect("it fits");

        [by_table.hidden, by_rows.hidden, by_signs].iter().for_each(|hidden| job.read("hidden", hidden.id()));
        let found = run(&job);
        assert!(found[0].iter().any(|word| *word != 0), "{columns} x {rows}: nothing is hidden");
        assert_eq!(found[0], found[1], "{columns} x {rows}: table and row spans");
        assert_eq!(found[0], found[2], "{columns} x {rows}: table and half-planes");
    }
}

#[test]
fn triangles_through_both_planes_have_the_masks_of_half_planes() {
    let samples = light(16, 16);
    let pattern = Pattern::regular(&samples).expect("on the grid");
    let triangles = crossing(80, &samples, &RECEIVERS);
    let mut job = Job::new();
    let lists = tiles(tile_shape(&pattern), &samples, &triangles);
    let by_table = scene(&mut job, &lists, &triangles, samples.words());
    let kernel = LineMask::new(&pattern, exact(6)).expect("it compiles");
    let table = kernel.record_table(&mut job);
    kernel.record(&mut job, &RECEIVERS, &lists, table, by_table).expect("it fits");
    let by_signs = job.zeroed("hidden", by_table.hidden.len());
    let kernel = HalfPlanes::new(&samples).expect("it compiles");
    kernel.record(&mut job, &RECEIVERS, by_table.vertices, 0..80, by_signs).expect("it fits");
    [by_table.hidden, by_signs].iter().for_each(|hidden| job.read("hidden", hidden.id()));
    let found = run(&job);
    assert!(found[0].iter().any(|word| *word != 0));
    assert_eq!(found[0], found[1]);
}

#[test]
fn the_size_of_an_exact_table_does_not_show_and_the_papers_error_falls_with_it() {
    let pattern = Pattern::halton([-1000, -900], [2000, 1800], 124).expect("on the grid");
    let samples = pattern.enclosing();
    let triangles = Family::Leaves.triangles(60, &samples, &RECEIVERS, 3);
    let lists = tiles(tile_shape(&pattern), &samples, &triangles);
    let truth = oracle::sets(&pattern, &RECEIVERS, &triangles);
    let mut job = Job::new();
    let true_map = job.slice("truth", &truth);
    let record = |job: &mut Job, resolution: Resolution| {
        let kernel = LineMask::new(&pattern, resolution).expect("it compiles");
        let scene = scene(job, &lists, &triangles, pattern.words());
        let table = kernel.record_table(job);
        kernel.record(job, &RECEIVERS, &lists, table, scene).expect("it fits");
        let counts = job.zeroed("counts", 2);
        record_differ(job, scene.hidden, true_map, 0, counts).expect("they fit");
        job.read("wrong bits", counts.id());
    };
    (1..=8).for_each(|bits| record(&mut job, exact(bits)));
    (3..=10).for_each(|bits| record(&mut job, Resolution { space: Space::Sampled, bits }));
    let wrong: Vec<u32> = run(&job).iter().map(|counts| counts.iter().sum()).collect();
    let (exact, paper) = wrong.split_at(8);
    assert_eq!(exact, [0; 8], "exact tables of 1 to 8 bits");
    assert!(paper.is_sorted_by(|a, b| a > b), "each doubling of the paper's table leaves fewer wrong bits: {paper:?}");
    assert!(paper[7] > 0 && paper[0] > 50 * paper[7], "{paper:?}");
}

#[test]
fn tables_and_tiles_that_do_not_fit_are_refused() {
    let pattern = Pattern::halton([0, 0], [500, 500], 1000).expect("on the grid");
    let refused = |what: &str, result: sightlines_backend::Result<()>| match result.expect_err(what).kind() {
        ErrorKind::Refused { what: said, remedy } => assert!(said.contains(what) && !remedy.is_empty(), "{said}"),
        other => panic!("not a refusal: {other}"),
    };
    for (bits, named) in [(0, "0 bits"), (11, "11 bits"), (9, "268435456 bytes")] {
        refused(named, LineMask::new(&pattern, exact(bits)).map(drop));
    }
    let kernel = LineMask::new(&pattern, exact(3)).expect("it compiles");
    let other = LineMask::new(&pattern, exact(4)).expect("it compiles");
    let mut job = Job::new();
    let triangles = [[[0, 0, 100], [10, 0, 100], [0, 10, 100]]];
    let [wide, high] = tile_shape(&pattern);
    let lists = tiles([wide, high], &pattern.enclosing(), &triangles);
    let scene = scene(&mut job, &lists, &triangles, pattern.words());
    let table = kernel.record_table(&mut job);
    let other = other.record_table(&mut job);
    let narrow = Tiles { size: [wide - 1, high], ..lists.clone() };
    let few = Scene { hidden: job.zeroed("hidden", 7), ..scene };
    refused("[7, 1]", kernel.record(&mut job, &RECEIVERS, &narrow, table, scene));
    refused("7 words", kernel.record(&mut job, &RECEIVERS, &lists, table, few));
    refused("65536 words", kernel.record(&mut job, &RECEIVERS, &lists, other, scene));
    refused("0 counts", record_differ(&mut job, scene.hidden, scene.hidden, 0, few.hidden.elements(0..0)));
    kernel.record(&mut job, &RECEIVERS, &lists, table, scene).expect("these fit");
}

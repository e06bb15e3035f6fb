//! Tables of lines against the kernels that need none: the same masks on regular lights, whatever the table's size; and
//! the paper's table, wrong by less the finer it is.

use std::sync::Arc;

use sightlines_backend::{Backend, Define, ErrorKind, Job, Program};
use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::field::{Field, Receiver};
use sightlines_kernels::grid::{Receivers, Samples, Triangle};
use sightlines_kernels::half_planes::HalfPlanes;
use sightlines_kernels::influence_region::oracle::region;
use sightlines_kernels::line_mask::{LineMask, Resolution, Space, TILE, oracle, record_differ, record_masks};
use sightlines_kernels::pattern::Pattern;
use sightlines_kernels::random;
use sightlines_kernels::row_span::{HEIGHT, RowSpan, Scene, WIDTH, is_between};
use sightlines_kernels::source;
use sightlines_kernels::tiles::Tiles;
use sightlines_kernels::triangles::{Family, contacts, corners, crossing, levels};

const RECEIVERS: Receivers =
    Receivers { origin: [-1500, -1100], step: [97, 61], height: 20_000, columns: 33, rows: 19 };

fn field() -> Field {
    Field::from(&RECEIVERS)
}

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

fn attempt(job: &Job) -> sightlines_backend::Result<Vec<Vec<u32>>> {
    let backend = CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() });
    let words = |bytes: &Vec<u8>| bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect();
    Ok(backend.run(job)?.iter().map(words).collect())
}

fn run(job: &Job) -> Vec<Vec<u32>> {
    attempt(job).expect("it runs")
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
        let lists = tiles(TILE, &samples, &triangles);
        let by_table = scene(&mut job, &lists, &triangles, samples.words());
        let table = kernel.record_table(&mut job);
        kernel.record(&mut job, &field(), &lists, table, by_table).expect("it fits");

        let lists = tiles([WIDTH, HEIGHT], &samples, &triangles);
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
    let lists = tiles(TILE, &samples, &triangles);
    let by_table = scene(&mut job, &lists, &triangles, samples.words());
    let kernel = LineMask::new(&pattern, exact(6)).expect("it compiles");
    let table = kernel.record_table(&mut job);
    kernel.record(&mut job, &field(), &lists, table, by_table).expect("it fits");
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
    let lists = tiles(TILE, &samples, &triangles);
    let truth = oracle::sets(&pattern, &RECEIVERS, &triangles);
    let mut job = Job::new();
    let true_map = job.slice("truth", &truth);
    let record = |job: &mut Job, resolution: Resolution| {
        let kernel = LineMask::new(&pattern, resolution).expect("it compiles");
        let scene = scene(job, &lists, &triangles, pattern.words());
        let table = kernel.record_table(job);
        kernel.record(job, &field(), &lists, table, scene).expect("it fits");
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
    for (bits, named) in [(0, "0 bits"), (11, "11 bits"), (9, "268435712 bytes")] {
        refused(named, LineMask::new(&pattern, exact(bits)).map(drop));
    }
    let kernel = LineMask::new(&pattern, exact(3)).expect("it compiles");
    let other = LineMask::new(&pattern, exact(4)).expect("it compiles");
    let mut job = Job::new();
    let triangles = [[[0, 0, 100], [10, 0, 100], [0, 10, 100]]];
    let [wide, high] = TILE;
    let lists = tiles([wide, high], &pattern.enclosing(), &triangles);
    let scene = scene(&mut job, &lists, &triangles, pattern.words());
    let table = kernel.record_table(&mut job);
    let other = other.record_table(&mut job);
    let narrow = Tiles { size: [wide - 1, high], ..lists.clone() };
    let few = Scene { hidden: job.zeroed("hidden", 7), ..scene };
    refused("[3, 4]", kernel.record(&mut job, &field(), &narrow, table, scene));
    refused("7 words", kernel.record(&mut job, &field(), &lists, table, few));
    refused("65600 words", kernel.record(&mut job, &field(), &lists, other, scene));
    refused("0 counts", record_differ(&mut job, scene.hidden, scene.hidden, 0, few.hidden.elements(0..0)));
    kernel.record(&mut job, &field(), &lists, table, scene).expect("these fit");
}

/// One edit of one text, and what it spoils.
#[rustfmt::skip]
static CANARIES: &[(&str, &str, &str)] = &[
    ("line_mask/build.wgsl", "max(x, y) >= c.outside", "max(x, y) >= c.inside"),
    ("line_mask/build.wgsl", "min(x, y) > c.inside", "min(x, y) > c.outside"),
    ("line_mask/build.wgsl", "select(1, -1, (cell", "select(1, 1, (cell"),
    ("line_mask/build.wgsl", "params.samples - word * params.bits", "params.samples - params.bits"),
    ("line_mask/kernel.wgsl", "var doubtful = sets.y & ~sets.x;", "var doubtful = 0u;"),
    ("line_mask/kernel.wgsl", "let turn = inverted & params.words;", "let turn = 0u;"),
    ("line_mask/kernel.wgsl", "(low >> 16u) + (rest >> 16u)", "(low >> 16u)"),
    ("line_mask/kernel.wgsl", "(ln.c.y << 16u) | ", ""),
    ("line_mask/kernel.wgsl", "!line_flip(ln), (high", "true, (high"),
    ("line_mask/kernel.wgsl", "(high | (rest & 0xffff)) == 0", "high == 0"),
    ("line_mask/kernel.wgsl", "(rest & 0xffff)) == 0", "(rest & 0xffff)) == 1"),
    ("line_mask/kernel.wgsl", "select(ln.a, 0, covers)", "ln.a"),
    ("line_mask/kernel.wgsl", "select(cell_of(found.own), CELL_NONE, nowhere)", "cell_of(found.own)"),
    ("line_mask/kernel.wgsl", "dot64(n, vec3<i32>(at, 0) - a)) < 0", "dot64(n, vec3<i32>(at, 0) - a)) <= 0"),
    ("line_mask/kernel.wgsl", "min(min(a.z, b.z), c.z) <= 0", "false"),
    ("line_mask/kernel.wgsl", "if (touches & hides)", "if (false)"),
    ("line_mask/kernel.wgsl", "((found.w << 16u) >> 16u)", "(found.w & 0xffff)"),
    ("line_mask/kernel.wgsl", "+ (found.w >> 16u)", ""),
    ("line_mask/kernel.wgsl", "r.at.z > 0 && ", ""),
    ("line_mask/kernel.wgsl", "return count;", "return max(count, 1u) - 1u;"),
    ("shared/backprojection.wgsl", "let turned = orientation < 0;", "let turned = false;"),
    ("shared/line_cell.wgsl", "1.00000762939453125", "0.9375"),
];

/// A program of the kernel with one text edited.
fn edited(of: &Program, path: &'static str, text: &str, instead: &str) -> Arc<Program> {
    let original = source(path).unwrap_or_else(|| panic!("no {path}"));
    assert_eq!(original.matches(text).count(), 1, "{path} has `{text}` once");
    let edit = original.replace(text, instead);
    let sources = move |wanted: &str| if wanted == path { Some(edit.clone()) } else { source(wanted) };
    let (entry, defines) = match of.label() {
        "line_mask.build" => ("line_mask/build.wgsl", vec![]),
        _ => ("line_mask/kernel.wgsl", vec![Define::new("EXACT", true)]),
    };
    Program::new(of.label(), entry, &sources, &defines).unwrap_or_else(|error| panic!("`{instead}`: {error}"))
}

/// Receivers with shifts of either sign along both axes; every seventh is none.
fn shifted(receivers: &Receivers) -> Field {
    let receiver = |index: u32| {
        let [x, y, z] = receivers.at(index);
        let by = [0, 16].map(|bits| (random::word(8, index) >> bits & 0x3ff) as i32 - 512);
        Receiver { at: [x, y, if index.is_multiple_of(7) { 0 } else { z }], shift: by }
    };
    Field::new(receivers.columns, (0..receivers.count()).map(receiver).collect()).expect("on the grid")
}

/// Small scenes that together reach every decision, each tile with a triangle of its own: the job, and its masks.
fn scenes() -> Vec<(Job, Vec<u32>)> {
    let samples = light(8, 8);
    let regular = Pattern::regular(&samples).expect("on the grid");
    let halton = Pattern::halton([-1000, -900], [2000, 1800], 70).expect("on the grid");
    let few = Receivers { columns: 36, rows: 32, step: [88, 38], ..RECEIVERS };
    let families = || Family::ALL.iter().flat_map(|family| family.triangles(8, &samples, &few, 2)).take(72).collect();
    let mut through: Vec<Triangle> = levels(few.height).into_iter().step_by(4).collect();
    through.extend(crossing(20, &samples, &few));
    // On the source plane, with an edge through samples.
    through.extend((0..20).map(|i| [samples.at(3 * i), samples.at(63 - 2 * i), [0, 100 * i as i32 - 900, 9000]]));
    let ends = Pattern::new(vec![[-16_384, -16_384], [16_383, -16_384], [-16_384, 16_383], [16_383, 16_383]], 32);
    let wide = Receivers { origin: [-16_384, -16_384], step: [936, 1057], height: 32_767, ..few };
    let far = corners(72, &wide);
    let scenes: [(Pattern, Receivers, Vec<Triangle>); 6] = [
        (regular.clone(), few, families()),
        (halton.clone(), few, families()),
        (regular.clone(), few, contacts(TILE, &few)),
        (regular, few, through.clone()),
        (halton, few, through),
        (ends.expect("on the grid"), wide, far),
    ];
    let prepared = scenes.map(|(pattern, receivers, mut triangles)| {
        triangles.resize(72, triangles[0]);
        let tiles = Tiles::solo(TILE, &receivers);
        let mut job = Job::new();
        let field = if pattern.count() == 70 { shifted(&receivers) } else { Field::from(&receivers) };
        let hidden = record_masks(&mut job, &pattern, exact(4), &field, &tiles, &triangles).expect("it fits");
        job.read("hidden", hidden.id());
        (job, oracle::tile_sets(&pattern, &field, &tiles, &triangles))
    });
    prepared.to_vec()
}

/// Whether every scene still has the masks of the definition once the programs are edited.
fn holds(scenes: &[(Job, Vec<u32>)], path: &'static str, text: &str, instead: &str) -> bool {
    let is_used = |program: &Arc<Program>| match path {
        "line_mask/build.wgsl" => program.label() == "line_mask.build",
        _ => program.label() != "line_mask.build",
    };
    scenes.iter().all(|(job, truth)| {
        let mut job = job.clone();
        job.programs.iter_mut().filter(|p| is_used(p)).for_each(|p| *p = edited(p, path, text, instead));
        attempt(&job).is_ok_and(|found| found[0] == *truth)
    })
}

#[test]
fn a_wrong_table_or_decision_is_seen_and_an_inaccurate_guess_is_not() {
    let scenes = scenes();
    assert!(scenes.iter().all(|(job, truth)| run(job)[0] == *truth), "unedited");
    let unseen: Vec<_> = CANARIES.iter().filter(|(path, text, instead)| holds(&scenes, path, text, instead)).collect();
    assert!(unseen.is_empty(), "the masks do not show {unseen:#?}");
    for guess in
        ["f32(one) / f32(max(n1, 1u)) * 1.0000019073486328125", "f32(one) / f32(max(n1, 1u)) * 0.9999980926513671875"]
    {
        assert!(holds(&scenes, "shared/line_cell.wgsl", "f32(one) / f32(max(n1, 1u))", guess), "{guess}");
    }
}

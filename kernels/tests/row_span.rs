//! What the cases of `row_span` show: one edit of the kernel of the kind that proofs and reviews miss must change a
//! mask, and a guess that is as bad as WGSL permits must not.

use std::sync::Arc;

use sightlines_backend::{Backend, Expected, Job, Program};
use sightlines_backend_cpu::{Config, CpuBackend};
use sightlines_kernels::grid::{Receivers, Samples, Triangle, hidden_set};
use sightlines_kernels::row_span::{HEIGHT, KERNEL, RowSpan, Scene, WIDTH};
use sightlines_kernels::source;
use sightlines_kernels::tiles::Tiles;

const PATH: &str = "row_span/kernel.wgsl";

/// An edit that spoils a decision.
#[rustfmt::skip]
static CANARIES: &[(&str, &str)] = &[
    ("min(x & FRACTION, y & FRACTION) <= 2 * doubt", "false"),
    ("| ((sum.x | sum.y) == 0u)", ""),
    ("if (is_told)", "if (true)"),
    ("select(k + 1, k, is_reached(e, rx, k))", "k"),
    ("((b.w > 0) == (c.w > 0))", "((b.w >= 0) == (c.w >= 0))"),
    ("(high + slack + 1023)", "(high + slack)"),
    ("(low - slack + 1023)", "(low - slack + 2047)"),
    ("2 * FAR, size >= FAR", "6, size >= FAR"),
    ("if (lane < count)", "if (lane + 1u < count)"),
    ("x -= first.slope;", ""),
    ("i32(COLUMNS) * ONE + 131072", "(i32(COLUMNS) - 2) * ONE"),
    ("BEFORE = -131072", "BEFORE = 524288"),
    ("is_left = count > ITEMS", "is_left = false"),
    ("if (row == all)", "if (row != 0u)"),
    ("== lines * ROWS", ">= ROWS"),
    ("high = min(high, bitcast<i32>(COLUMNS));", "high = min(high, bitcast<i32>(COLUMNS) - 1);"),
];

/// The families of triangles, one a tile, many in one tile, and those far away, with their masks by the definition.
fn scenes() -> Vec<(Job, Vec<u32>)> {
    let is_taken = |name: &str| name.starts_with("family_") || ["crowd", "nobody_sees_more"].contains(&name);
    let families = (KERNEL.cases)().into_iter().filter(|case| is_taken(&case.name));
    let scenes = families.map(|case| match (case.expected)(&Vec::new()).remove(0) {
        Expected::Whole(masks) => ((case.job)().expect("it is recorded"), masks),
        _ => panic!("{} is not whole", case.name),
    });
    scenes.chain([far()]).collect()
}

/// A light of neighbouring points far from receivers far apart: crossings beyond the range of the guess.
fn far() -> (Job, Vec<u32>) {
    let samples = Samples { origin: [-16, -16], step: [1, 1], columns: 32, rows: 32 };
    let receivers = Receivers { origin: [-15_000, -15_000], step: [180, 1100], height: 24_576, columns: 160, rows: 28 };
    let tiles = Tiles::solo([WIDTH, HEIGHT], &receivers);
    let count = tiles.entries.len() as u32;
    // Above a receiver of each tile, and far wider than the light is seen from there.
    let triangles: Vec<Triangle> = (0..count)
        .map(|tile| {
            let (x, y) = (tile % tiles.count[0] * WIDTH + 7, tile / tiles.count[0] * HEIGHT + 2);
            let [x, y, z] = receivers.at(y * receivers.columns + x);
            let wide = 100 + 7 * tile as i32;
            [[x - wide, y - wide, z - 2], [x + wide, y + 1, z - 3], [x - 5, y + wide, z - 1]]
        })
        .collect();
    let mut job = Job::new();
    let vertices = job.slice("vertices", triangles.as_flattened().as_flattened());
    let (starts, entries) = (job.slice("starts", &tiles.starts), job.slice("entries", &tiles.entries));
    let hidden = job.zeroed("hidden", u64::from(receivers.count() * samples.words()));
    let kernel = RowSpan::new(&samples).expect("it compiles");
    kernel.record(&mut job, &receivers, &tiles, Scene { vertices, starts, entries, hidden }).expect("it fits");
    job.read("hidden", hidden.id());
    let list = |x, y| tiles.list(x, y).iter().map(|triangle| &triangles[*triangle as usize]);
    let set = |r: u32| hidden_set(receivers.at(r), &samples, list(r % receivers.columns, r / receivers.columns));
    let sets: Vec<Vec<u32>> = (0..receivers.count()).map(set).collect();
    (job, (0..32).flat_map(|word| sets.iter().map(move |set| set[word])).collect())
}

/// The kernel for 32 by 32 samples, as its text stands, with one edit.
fn edited(text: &str, instead: &str) -> Arc<Program> {
    let original = source(PATH).expect("its text");
    assert_eq!(original.matches(text).count(), 1, "`{text}` stands there once");
    let edit = original.replace(text, instead);
    let sources = move |wanted: &str| if wanted == PATH { Some(edit.clone()) } else { source(wanted) };
    Program::new("row_span", PATH, &sources, &[]).unwrap_or_else(|error| panic!("`{instead}`: {error}"))
}

/// Whether every scene has its masks with this program.
fn holds(scenes: &[(Job, Vec<u32>)], program: &Arc<Program>) -> bool {
    let machine = CpuBackend::new(Config { threads: 1, ..Config::default() });
    scenes.iter().all(|(job, masks)| {
        let mut job = job.clone();
        job.programs.iter_mut().for_each(|p| *p = program.clone());
        let outputs = machine.run(&job).expect("it runs");
        outputs[0].as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).eq(masks.iter().copied())
    })
}

#[test]
fn a_wrong_decision_is_seen_and_an_inaccurate_guess_is_not() {
    let scenes = scenes();
    for division in ["f32(ONE) / (f32(params.view.sample_step_x) * w)", "1024.0 / f32(params.view.sample_step_y * w)"] {
        for guess in ["1.0", "1.000000476837158203125", "0.999999523162841796875"] {
            let program = edited(division, &format!("{division} * {guess}"));
            assert!(scenes.len() == 13 && holds(&scenes, &program), "off by {guess}");
        }
    }
    let unseen: Vec<_> = CANARIES.iter().filter(|(text, instead)| holds(&scenes, &edited(text, instead))).collect();
    assert!(unseen.is_empty(), "the masks do not show {unseen:#?}");
}

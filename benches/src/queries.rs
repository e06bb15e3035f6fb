//! Visibility queries: `cargo xtask bench queries`.
//!
//! What is compared on one machine is counted in lane-operations of the interpreter, which no load changes; what is
//! compared between machines is CPU time of this process on one thread, all of a driver's threads together. Every table
//! stands beside the figures of Engelhardt and Dachsbacher, *Granular Visibility Queries on the GPU*, where they have
//! some.

mod kernels;

use std::io::Write;
use std::path::Path;

use serde::Serialize;
use sightlines_backend_cpu::{Config, CpuBackend};
use sightlines_kernels::depth_bounds::Form;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::queries::baselines::{Verdict, depth_tests, predicated, whole_objects};
use sightlines_visibility::queries::displacement::{Scene, displace};
use sightlines_visibility::queries::{Answer, Method, Spent, Stage, conflicts, draw, query, shadow_volumes};
use sightlines_visibility::scene::frame::Frame;
use sightlines_visibility::scene::{World, creature_field, creature_in_hall, crowd};

use crate::error::{EXIT_OK, Error, Result};
use crate::report::write_whole;
use crate::table::Columns;

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Pixels a side of the target that counts.
    pub target: u32,
    /// Numbers of objects.
    pub objects: &'static [u32],
    /// Targets of the table that varies them.
    pub targets: &'static [u32],
    /// Side of the images and item buffers of the kernels' table.
    pub image: u32,
    /// Repetitions, of which the median counts.
    pub runs: usize,
}

impl Size {
    /// For numbers that are kept.
    pub const FULL: Size = Size {
        target: 512,
        objects: &[100, 200, 300, 400, 500, 1000, 2000],
        targets: &[512, 1024, 2048, 4096],
        image: 1024,
        runs: 5,
    };
    /// For a look.
    pub const QUICK: Size = Size { target: 128, objects: &[20, 40], targets: &[64, 128], image: 256, runs: 1 };
}

/// One table of the report.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table {
    /// What it shows.
    pub title: String,
    /// Names of its columns.
    pub head: Vec<String>,
    /// Its cells.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    fn new(title: &str, head: &[&str]) -> Self {
        Table { title: title.to_owned(), head: head.iter().map(|name| (*name).to_owned()).collect(), rows: Vec::new() }
    }

    fn print(&self, out: &mut impl Write) -> Result<()> {
        let lines = [std::slice::from_ref(&self.head), &self.rows].concat();
        let mut text = format!("{}\n", self.title);
        Columns { left: 1, lines }.render(&mut text);
        Ok(writeln!(out, "{text}")?)
    }
}

fn failed(e: impl std::fmt::Display) -> Error {
    Error::Measurement(e.to_string())
}

fn interpreter() -> CpuBackend {
    CpuBackend::new(Config { threads: 1, ..Config::default() })
}

/// Measures, prints each table when it is there, and writes `queries.json` into the folder.
pub fn run(size: Size, folder: &Path, out: &mut impl Write) -> Result<u8> {
    let makers: [fn(Size) -> Result<Table>; 6] = [kernels::table, table_1, table_2, table_3, targets, baselines];
    let mut tables = Vec::new();
    for make in makers {
        let table = make(size)?;
        table.print(out)?;
        out.flush()?;
        tables.push(table);
    }
    let path = folder.join("queries.json");
    let text = serde_json::to_string_pretty(&tables).map_err(|e| Error::file(&path, e.into()))?;
    write_whole(&path, &(text + "\n"))?;
    writeln!(out, "{} tables in {}", tables.len(), path.display())?;
    Ok(EXIT_OK)
}

/// The balls of a crowd without its floor, from its light.
fn balls(count: u32, side: u32) -> Result<(World, Stage)> {
    let mut world = crowd(count);
    world.instances.remove(0);
    let frame = frame(&world, 1, side, world.corners().as_flattened())?;
    let stage = Stage::of(&world, frame).map_err(failed)?;
    Ok((world, stage))
}

fn frame(world: &World, camera: usize, side: u32, points: &[[f64; 3]]) -> Result<Frame> {
    Frame::new(&world.cameras[camera], Picture { width: side, height: side }, points).map_err(failed)
}

fn ask(stage: &Stage, method: Method) -> Result<Answer> {
    query(&interpreter(), stage, method, 0, &mut |_| ()).map_err(failed)
}

/// Lane-operations in millions.
fn ops(spent: impl IntoIterator<Item = Spent>) -> f64 {
    spent.into_iter().filter_map(|spent| spent.lane_ops).sum::<u64>() as f64 / 1e6
}

fn fixed(value: f64, digits: usize) -> String {
    format!("{value:.digits$}")
}

/// The paper's frames per second without culling, by tables, item buffer and predicates (280GTX).
const TABLE_1: [(u32, [u32; 4]); 5] = [
    (100, [53, 217, 194, 217]),
    (200, [27, 99, 121, 113]),
    (300, [19, 63, 87, 70]),
    (400, [14, 38, 48, 37]),
    (500, [11, 26, 31, 27]),
];

/// Work of a frame: the light's view and its counts, and the volumes of the casters that are left, drawn for the
/// viewer.
fn table_1(size: Size) -> Result<Table> {
    let head =
        ["balls", "lit", "SAT", "pred.", "Mops none", "SAT", "HIB", "pred.", "none/SAT", "none/HIB", "none/pred."];
    let title = format!(
        "Table 1: shadow volumes. Casters kept (lit: by HIB, exact), Mega-lane-operations of a frame: a light's view of \
         {0} x {0} pixels with its counts, and the volumes in a viewer's of {1} x {1}; in brackets the paper's quotients \
         of frames per second",
        size.target,
        size.target / 2
    );
    let mut table = Table::new(&title, &[&head[..], &["paper"]].concat());
    for &count in size.objects.iter().filter(|count| **count <= 500) {
        let (world, stage) = balls(count, size.target)?;
        let hib = ask(&stage, Method::HIB)?;
        let sat = ask(&stage, Method::SAT)?;
        let (verdict, painted) = predicated(&interpreter(), &world, &stage).map_err(failed)?;
        let seen = |answer: &Answer| answer.totals.iter().map(|pixels| *pixels > 0).collect::<Vec<_>>();
        let kept = [vec![true; hib.totals.len()], seen(&sat), seen(&hib), verdict.kept.clone()];
        let queried = [
            0.0,
            ops([sat.cost.draw, sat.cost.count]),
            ops([hib.cost.draw, hib.cost.count]),
            ops([verdict.draw, verdict.test]),
        ];
        if painted.depths != hib.depths {
            return Err(failed("predicated drawing lost a pixel"));
        }
        let mut frames = [0.0; 4];
        let mut counts = [0; 4];
        for (method, kept) in kept.iter().enumerate() {
            let casters: Vec<usize> =
                stage.items.iter().zip(kept).filter(|(_, k)| **k).map(|(i, _)| i.instance).collect();
            counts[method] = casters.len();
            frames[method] = queried[method] + volumes(&world, &casters, size.target / 2)?;
        }
        let paper = TABLE_1.iter().find(|(n, _)| *n == count).map_or_else(String::new, |(_, fps)| {
            let quotient = |i: usize| f64::from(fps[i]) / f64::from(fps[0]);
            format!("({:.1} {:.1} {:.1})", quotient(1), quotient(2), quotient(3))
        });
        let mut row = vec![count.to_string(), counts[2].to_string(), counts[1].to_string(), counts[3].to_string()];
        row.extend(frames.map(|ops| fixed(ops, 0)));
        row.extend([1, 2, 3].map(|method| fixed(frames[0] / frames[method], 2)));
        row.push(paper);
        table.rows.push(row);
    }
    Ok(table)
}

/// Lane-operations of drawing shadow volumes before the viewer.
fn volumes(world: &World, casters: &[usize], side: u32) -> Result<f64> {
    let volumes = shadow_volumes::volumes(world, casters, world.cameras[1].eye, 1.0);
    let frame = frame(&volumes, 0, side, volumes.corners().as_flattened())?;
    let stage = Stage::of(&volumes, frame).map_err(failed)?;
    Ok(ops([draw(&interpreter(), &stage).map_err(failed)?.draw]))
}

/// The paper's conflict objects, error in pixels and in percent.
const TABLE_2: [(u32, [f64; 3]); 5] = [
    (100, [10.0, 1.6, 2.3]),
    (200, [50.0, 1.7, 2.6]),
    (300, [116.0, 2.7, 4.4]),
    (400, [166.0, 6.3, 9.8]),
    (500, [249.0, 7.4, 11.6]),
];

fn table_2(size: Size) -> Result<Table> {
    let head =
        ["balls", "conflicts", "px", "%", "paper", "8 ch. conflicts", "px", "%", "Mops draw", "SAT", "SAT 8", "HIB"];
    let mut table = Table::new(
        "Table 2: summed-area tables. Conflict objects, mean error of a seen object in pixels and percent with 4 and 8 \
         channels; in brackets the paper's (4 channels); work of drawing and of counting",
        &head,
    );
    for &count in size.objects {
        let (_, stage) = balls(count, size.target)?;
        let exact = ask(&stage, Method::HIB)?;
        let mut cells = Vec::new();
        let mut work = Vec::new();
        for channels in [4, 8] {
            let method = Method::Sat { channels, limit: None };
            let bound = ask(&stage, method)?;
            let [px, percent] = error(&exact.totals, &bound.totals)?;
            let found = conflicts(&interpreter(), &stage, channels).map_err(failed)?;
            cells.push([found.to_string(), fixed(px, 1), fixed(percent, 1)]);
            work.push(fixed(ops([bound.cost.count]), 1));
        }
        let paper = TABLE_2.iter().find(|(n, _)| *n == count);
        let paper = paper.map_or_else(String::new, |(_, [n, px, percent])| format!("({n} {px} {percent})"));
        let mut row = vec![count.to_string()];
        row.extend(cells[0].clone());
        row.push(paper);
        row.extend(cells[1].clone());
        row.push(fixed(ops([exact.cost.draw]), 1));
        row.extend(work);
        row.push(fixed(ops([exact.cost.count]), 1));
        table.rows.push(row);
    }
    Ok(table)
}

/// Mean error of the objects that are seen: in pixels, and in percent of each one's pixels.
fn error(exact: &[u32], bound: &[u32]) -> Result<[f64; 2]> {
    if exact.iter().zip(bound).any(|(exact, bound)| bound < exact) {
        return Err(failed("a table counted fewer pixels than are seen"));
    }
    let seen: Vec<[f64; 2]> =
        exact.iter().zip(bound).filter(|(e, _)| **e > 0).map(|(e, b)| [f64::from(b - e), f64::from(*e)]).collect();
    let count = seen.len().max(1) as f64;
    let px = seen.iter().map(|[more, _]| more).sum::<f64>() / count;
    Ok([px, 100.0 * seen.iter().map(|[more, of]| more / of).sum::<f64>() / count])
}

fn table_3(size: Size) -> Result<Table> {
    let mut table = Table::new(
        "Table 3: displacement. Prisms extruded of 7,128, each of 4 triangles, and Mega-lane-operations of the first pass, \
         its counts and the picture; in brackets the paper's frames per second (280GTX, prisms of 7,132)",
        &["method", "full", "Mops", "partial", "Mops", "occluded", "Mops", "paper"],
    );
    let world = creature_in_hall();
    let scene = Scene::new(&world, 0, displace(&world.meshes[0], 0.06, 2, creature_field));
    let methods = [
        ("none", None, "(71 90 90)"),
        ("item buffer, 8 x 8", Some((Method::HIB, 3)), "(61 80 186)"),
        ("item buffer, 16 x 16", Some((Method::HIB, 4)), "(61 105 186)"),
        ("item buffer, 32 x 32", Some((Method::HIB, 5)), "(61 123 186)"),
        ("item buffer, 128 x 128", Some((Method::HIB, 7)), "(66 131 186 at 90 x 90)"),
        ("summed-area table", Some((Method::SAT, 0)), "(57 89 112)"),
    ];
    for (name, method, paper) in methods {
        let mut row = vec![name.to_owned()];
        for camera in 0..3 {
            let frame = frame(&world, camera, size.target, &scene.points())?;
            let (kept, before) = match method {
                None => (vec![true; scene.displaced.prisms.len()], 0.0),
                Some((method, depth)) => {
                    let culled = scene.cull(&interpreter(), frame, method, depth).map_err(failed)?;
                    (culled.kept, ops([culled.draw, culled.count]))
                }
            };
            let left = scene.extruded(&kept);
            let drawn = draw(&interpreter(), &Stage::of(&left, frame).map_err(failed)?).map_err(failed)?;
            let full = draw(&interpreter(), &Stage::of(&scene.full, frame).map_err(failed)?).map_err(failed)?;
            if drawn.depths != full.depths {
                return Err(failed(format!("{name}: a seen pixel was lost")));
            }
            row.push(kept.iter().filter(|kept| **kept).count().to_string());
            row.push(fixed(before + ops([drawn.draw]), 1));
        }
        row.push(paper.to_owned());
        table.rows.push(row);
    }
    Ok(table)
}

fn targets(size: Size) -> Result<Table> {
    let head = ["target", "Mpixels", "Mops draw", "HIB", "per pixel", "HIB scattered", "SAT", "per pixel"];
    let mut table = Table::new("Targets: lane-operations of counting 300 balls, in all and a pixel", &head);
    for &side in size.targets {
        let (_, stage) = balls(300, side)?;
        let pixels = f64::from(side) * f64::from(side) / 1e6;
        let scattered = Method::Hib { order: sightlines_kernels::item_histogram::Order::Scattered };
        let [hib, scattered, sat] = [ask(&stage, Method::HIB)?, ask(&stage, scattered)?, ask(&stage, Method::SAT)?];
        let count = |answer: &Answer| ops([answer.cost.count]);
        table.rows.push(vec![
            format!("{side} x {side}"),
            fixed(pixels, 2),
            fixed(ops([hib.cost.draw]), 1),
            fixed(count(&hib), 1),
            fixed(count(&hib) / pixels, 1),
            fixed(count(&scattered), 1),
            fixed(count(&sat), 1),
            fixed(count(&sat) / pixels, 1),
        ]);
    }
    Ok(table)
}

/// Table 4 from measurements: what each method keeps of a crowd, how often it waits, and what it costs.
fn baselines(size: Size) -> Result<Table> {
    let count = if size == Size::FULL { 300 } else { 40 };
    let mut table = Table::new(
        &format!(
            "Table 4: {count} balls. Instances kept, waits of the host, work beyond drawing, and what a method tells"
        ),
        &["method", "kept", "waits", "Mops", "granularity", "instances of one draw", "counts"],
    );
    let (world, stage) = balls(count, size.target)?;
    let hib = ask(&stage, Method::HIB)?;
    let sat = ask(&stage, Method::SAT)?;
    let backend = interpreter();
    let whole = whole_objects(&backend, &world, &stage).map_err(failed)?;
    let (predicates, _) = predicated(&backend, &world, &stage).map_err(failed)?;
    let pyramid = depth_tests(&backend, &stage, Form::Pyramid).map_err(failed)?;
    let buffers = depth_tests(&backend, &stage, Form::Buffers).map_err(failed)?;
    let mut row = |cells: [&str; 4], kept: usize, waits: usize, spent: Spent| {
        let [name, granularity, instances, counts] = cells.map(str::to_owned);
        table.rows.push(vec![
            name,
            kept.to_string(),
            waits.to_string(),
            fixed(ops([spent]), 1),
            granularity,
            instances,
            counts,
        ]);
    };
    row(["no culling", "-", "-", "none"], stage.items.len(), 0, Spent { lane_ops: Some(0), ..Spent::default() });
    let mut verdict = |cells: [&str; 4], verdict: &Verdict| {
        row(cells, verdict.kept.iter().filter(|kept| **kept).count(), verdict.read_backs, verdict.test);
    };
    verdict(["whole-object queries", "draw call", "no", "of boxes, to the host"], &whole);
    verdict(["predicated drawing", "draw call", "no", "none"], &predicates);
    verdict(["depth pyramid", "rectangle", "yes", "none"], &pyramid);
    verdict(["N-buffers", "rectangle", "yes", "none"], &buffers);
    row(["summed-area tables", "any rectangle", "yes", "never too few"], sat.visible(), 0, sat.cost.count);
    row(["item buffer", "tiles, clusters", "yes", "exact"], hib.visible(), 0, hib.cost.count);
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_whole_and_methods_agree() {
        let folder = std::env::temp_dir().join(format!("sightlines-bench-queries-{}", std::process::id()));
        let mut out = Vec::new();
        assert_eq!(run(Size { objects: &[20], targets: &[64], ..Size::QUICK }, &folder, &mut out).unwrap(), EXIT_OK);
        let text = String::from_utf8(out).unwrap();
        for title in ["Kernels", "Table 1", "Table 2", "Table 3", "Targets", "Table 4"] {
            assert!(text.contains(title), "{title} is not in\n{text}");
        }
        let written = std::fs::read_to_string(folder.join("queries.json")).unwrap();
        let tables: Vec<serde_json::Value> = serde_json::from_str(&written).unwrap();
        assert!(tables.iter().all(|table| !table["rows"].as_array().unwrap().is_empty()));
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn errors_are_of_seen_objects() {
        assert_eq!(error(&[0, 10, 20], &[5, 11, 20]).unwrap(), [0.5, 5.0]);
        assert!(error(&[3], &[2]).is_err());
    }
}

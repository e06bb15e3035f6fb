//! Every family of hard triangles, both kinds of view, cuts at the near plane, instances, items; and pictures of real
//! size.
//!
//! A case draws its meshes' depths, then their items, and tests the vertices of the first against the depths. Words
//! past the picture must keep their mark.

use sightlines_backend::{Case, Expected, Job, Outputs, Result, Size};

use super::meshes::{Family, Shape, ball, flat, seen_from_origin, upload};
use super::oracle::{self, Scene};
use super::{Faces, Ids, Picture, Raster, View};
use crate::{pieces, random};

/// Words past the end of buffers, and what they hold.
const SLACK: usize = 4;
const MARK: u32 = 0x5eed_5eed;

/// The clip units of a unit of the perspective views.
const SCALE: f64 = 256.0;

/// What a case draws, and the bias of its points.
#[derive(Clone)]
struct Input {
    view: View,
    scenes: Vec<Scene>,
    bias: u32,
}

pub(super) fn all() -> Vec<Case> {
    let mut cases = vec![
        small("nothing", || input(64, 64, vec![Shape::default().drawn(&[flat(picture(64, 64))])])),
        small("no_instances", || input(64, 64, vec![Family::Anywhere.shape(9, picture(64, 64), 1).drawn(&[])])),
        small("one_pixel", || family(Family::OnCentres, picture(1, 1), 40)),
        small("odd_sides", || family(Family::Anywhere, picture(61, 37), 40)),
        small("clockwise", || faces(Faces::Clockwise)),
        small("counter_clockwise", || faces(Faces::CounterClockwise)),
        small("no_such_vertex", no_such_vertex),
        small("clusters", clusters),
        small("instances", || camera(64, 1.0, 300, 4)),
        small("crossing_near", || room(64, 40.0)),
        small("behind", || camera(64, -1.0, 20, 1)),
        small("two_meshes", two_meshes),
        small("past_the_budget", past_the_budget),
    ];
    cases.extend(Family::ALL.map(|f| small(&format!("family_{}", f.name()), move || family(f, picture(64, 64), 60))));
    // Every one in 64 bits, and all of them in the picture: the most that a workgroup draws.
    cases.push(small("huge_256", || family(Family::Huge, picture(64, 64), 256)));
    cases.push(case("bands", Size::Real, bands, [0, 2048 * 64, 1024 * 192 + 7]));
    cases.push(case("balls_500", Size::Real, balls, [1024 * 511 + 500, 1024 * 700 + 300]));
    let square = || camera(4096, 1.0, 120, 4);
    cases.push(case("balls_4096", Size::Real, square, [4096 * 1800 + 2000, 4096 * 2047 + 2047, 4096 * 2900 + 3000]));
    cases.push(case("room_512", Size::Real, || room(512, 300.0), [0, 512 * 256 + 256, 512 * 511 + 7]));
    cases.push(case("terrain_4096", Size::Real, terrain, [4096 * 256 + 17, 4096 * 400 + 4000]));
    cases
}

fn picture(width: u32, height: u32) -> Picture {
    Picture { width, height }
}

fn input(width: u32, height: u32, scenes: Vec<Scene>) -> Input {
    Input { view: View { picture: picture(width, height), near: width.max(height) as i32 }, scenes, bias: 1 << 9 }
}

fn family(family: Family, picture: Picture, count: usize) -> Input {
    input(picture.width, picture.height, vec![family.shape(count, picture, 7).drawn(&[flat(picture)])])
}

fn faces(faces: Faces) -> Input {
    let mut drawn = family(Family::Anywhere, picture(64, 64), 40);
    drawn.scenes[0].faces = faces;
    drawn
}

fn no_such_vertex() -> Input {
    let mut drawn = family(Family::Small, picture(64, 64), 30);
    for (number, triangle) in drawn.scenes[0].triangles.iter_mut().enumerate().step_by(3) {
        triangle[number % 3] = if number % 2 == 0 { 90 } else { u32::MAX };
    }
    drawn
}

/// Items by clusters of 16 triangles of two instances.
fn clusters() -> Input {
    let picture = picture(64, 64);
    let placement = flat(picture);
    let mut moved = placement;
    moved.rows[0].w += 1 << 19;
    let mut scene = Family::Small.shape(100, picture, 9).drawn(&[placement, moved]);
    scene.ids = Ids { base: 1000, step: 7, shift: 4 };
    Input { scenes: vec![scene], ..input(64, 64, Vec::new()) }
}

/// A camera among `count` balls.
fn camera(side: u32, ahead: f64, size: u32, count: u32) -> Input {
    let place = |i: u32| {
        let along = |axis: u32, spread: u32| f64::from(random::below(2 * spread, 5, 4 * i + axis)) - f64::from(spread);
        let z = f64::from(400 + random::below(2600, 5, 4 * i + 2)) * ahead;
        let radius = f64::from(size) / 2.0 + f64::from(random::below(size, 5, 4 * i + 3));
        seen_from_origin(SCALE, 16.0, [along(0, 1200), along(1, 1200), z], radius / 16_384.0, i + 1)
    };
    let mut scene = ball().drawn(&(0..count).map(place).collect::<Vec<_>>());
    scene.ids = Ids { base: 0, step: 1, shift: 31 };
    Input { view: View { picture: picture(side, side), near: 4096 }, scenes: vec![scene], bias: 4 }
}

/// The camera within a box whose walls cross the near plane, with balls.
fn room(side: u32, size: f64) -> Input {
    let mut shape = Shape::default();
    let corner = |i: u32| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -(1 << 14) } else { 1 << 14 });
    shape.vertices.extend((0..8).map(corner));
    for [a, b, c, d] in [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]] {
        shape.triangles.extend([[a, b, c], [a, c, d]]);
    }
    let wall = seen_from_origin(SCALE, 16.0, [3.0, -2.0, 0.7 * size], size / 16_384.0, 77);
    let near_wall = seen_from_origin(SCALE, 16.0, [0.0, 30.0, 0.1 * size], 5.0 * size / 16_384.0, 0);
    let mut drawn = camera(side, 1.0, 300, if side < 100 { 1 } else { 20 });
    let mut walls = shape.drawn(&[wall, near_wall]);
    walls.ids.base = 1000;
    drawn.scenes.push(walls);
    drawn
}

/// Meshes share the buffers; ids of the second are lower.
fn two_meshes() -> Input {
    let picture = picture(64, 64);
    let [mut first, second] = [3, 4].map(|seed| Family::Twins.shape(30, picture, seed).drawn(&[flat(picture)]));
    first.ids.base = 500;
    Input { scenes: vec![first.clone(), second, first], ..input(64, 64, Vec::new()) }
}

/// Factors and sums at their bounds: clip coordinates are clamped, and what is drawn is still what the definition says.
fn past_the_budget() -> Input {
    let picture = picture(64, 64);
    let mut placement = flat(picture);
    let most = (1 << 30) - 1;
    placement.rows[0].x = most;
    placement.rows[1] = [-most, most, 0, (1 << 29) - 1].into();
    let mut scene = Family::Anywhere.shape(40, picture, 21).drawn(&[placement, flat(picture)]);
    let extremes = [-32_768, 0, 32_767];
    scene.vertices.extend((0..27).map(|i| [extremes[i % 3], extremes[i / 3 % 3], extremes[i / 9]]));
    let first = scene.vertices.len() as u32 - 27;
    scene.triangles.extend((0..25).map(|i| [first + i, first + (i * 7 + 1) % 27, first + (i * 11 + 2) % 27]));
    Input { view: View { picture, near: 64 }, scenes: vec![scene], bias: u32::MAX }
}

/// More pixels than a workgroup takes of a triangle.
fn bands() -> Input {
    family(Family::Anywhere, picture(2048, 192), 12)
}

/// The paper's 500 instances of 606 triangles, at 1024².
fn balls() -> Input {
    camera(1024, 1.0, 60, 500)
}

/// Hills of 2,048 triangles under a camera, in the widest picture.
fn terrain() -> Input {
    let mut shape = Shape::default();
    for (row, column) in (0..33).flat_map(|row| (0..33).map(move |column| (row, column))) {
        let height = random::below(790, 31, row * 33 + column);
        shape.vertices.push([column as i32 * 1016 - 16_256, height as i32 - 900, row as i32 * 1016 - 16_256]);
    }
    for (row, column) in (0..32).flat_map(|row| (0..32).map(move |column| (row, column))) {
        let a = row * 33 + column;
        shape.triangles.extend([[a, a + 1, a + 34], [a, a + 34, a + 33]]);
    }
    let mut scene = shape.drawn(&[seen_from_origin(SCALE, 16.0, [0.0, -40.0, 900.0], 0.07, 0)]);
    scene.ids = Ids { base: 0, step: 0, shift: 6 };
    Input { view: View { picture: picture(4096, 512), near: 4096 }, scenes: vec![scene], bias: 64 }
}

fn small(name: &str, make: impl Fn() -> Input + Clone + Send + Sync + 'static) -> Case {
    let pixels = make().view.picture.pixels();
    let probes = [0, pixels / 3, pixels / 2 + 7].map(|probe| probe.min(pixels - 1));
    case(name, Size::Small, make, probes)
}

fn case(
    name: &str,
    size: Size,
    make: impl Fn() -> Input + Clone + Send + Sync + 'static,
    probes: impl IntoIterator<Item = u32>,
) -> Case {
    let oracles = make.clone();
    let expected = move |_: &Outputs| {
        let Input { view, scenes, bias } = oracles();
        let [depths, items] = oracle::pictures(view, &scenes);
        let seen = oracle::seen(view, &scenes[0], &depths, bias);
        [depths, items, seen].map(|words| Expected::Whole([words, vec![MARK; SLACK]].concat())).into()
    };
    let mut probes: Vec<u32> = probes.into_iter().collect();
    probes.dedup();
    Case::new(name, size, move || job(&make()), expected).probes(probes)
}

fn job(input: &Input) -> Result<Job> {
    let Input { view, scenes, bias } = input;
    let kernel = Raster::new()?;
    let mut job = Job::new();
    let pixels = view.picture.pixels() as usize;
    let depth = job.slice("depth", &vec![MARK; pixels + SLACK]);
    let items = job.slice("items", &vec![MARK; pixels + SLACK]);
    kernel.record_clear(&mut job, view.picture, depth)?;
    kernel.record_clear(&mut job, view.picture, items)?;
    let mut drawn = Vec::new();
    for scene in scenes {
        let mesh = upload(&mut job, scene);
        pieces::cut(&mut job);
        let projected = kernel.project(&mut job, *view, mesh)?;
        kernel.record_depth(&mut job, &projected, scene.faces, depth)?;
        drawn.push((projected, scene));
    }
    for (projected, scene) in &drawn {
        kernel.record_items(&mut job, projected, scene.faces, scene.ids, [depth, items])?;
    }
    let mut words = vec![0; (scenes[0].vertices.len() * scenes[0].instances.len()).div_ceil(32)];
    words.extend([MARK; SLACK]);
    let seen = job.slice("seen", &words);
    kernel.record_points(&mut job, &drawn[0].0, *bias, depth, seen)?;
    job.read("depth", depth.id());
    job.read("items", items.id());
    job.read("seen", seen.id());
    Ok(job)
}

//! From ten triangles to many, and scenes that sorting by tiles could trip over: work grows with what there is, told by
//! counts.

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_visibility::scene::bumpy_sphere;
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::{Bake, Effort, Faces, Rect, Request, bake_with};

type Triangles = Vec<[[f64; 3]; 3]>;

/// A floor of four by four metres under a light of one, three metres above it.
fn request(triangles: Triangles) -> Request {
    Request {
        triangles,
        faces: Faces::Both,
        light: Rect { corner: [-0.5, 3.0, -0.5], u: [1.0, 0.0, 0.0], v: [0.0, 0.0, 1.0] },
        receiver: Rect { corner: [-2.0, 0.0, 2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, -4.0] },
        resolution: 64,
        samples: 64,
    }
}

fn baked(request: &Request, effort: &Effort) -> Bake {
    let machine = CpuBackend::new(Config { bounds: Bounds::Trap, threads: 1, ..Config::default() });
    bake_with(&machine, request, effort, &mut |_| ()).unwrap()
}

/// Millions of lane-operations.
fn cost(triangles: Triangles) -> f64 {
    baked(&request(triangles), &Effort::default()).work.lane_ops.unwrap() as f64 / 1e6
}

/// A part of 1 that depends on two numbers.
fn part(a: usize, b: usize) -> f64 {
    ((a * 7919 + b * 104_729) % 10_007) as f64 / 10_007.0
}

/// Triangles of half a centimetre above one texel.
fn specks(count: usize) -> Triangles {
    let speck = |i| {
        let [x, y, z] = [0.01 + 0.03 * part(i, 1), 0.02 + 0.03 * part(i, 2), 0.01 + 0.03 * part(i, 3)];
        [[x, y, z], [x + 0.005, y, z], [x, y + 0.003, z + 0.004]]
    };
    (0..count).map(speck).collect()
}

/// Small triangles all over.
fn dust(count: usize) -> Triangles {
    let grain = |i| {
        let [x, y, z] = [4.0 * part(i, 4) - 2.0, 0.1 + part(i, 5), 4.0 * part(i, 6) - 2.0];
        [[x, y, z], [x + 0.02, y, z], [x, y + 0.01, z + 0.02]]
    };
    (0..count).map(grain).collect()
}

/// Triangles over all of the floor, one above the other.
fn sheets(count: usize) -> Triangles {
    let sheet = |i: usize| {
        let y = 1.0 + i as f64 / (2 * count) as f64;
        [[-15.0, y, 9.0], [15.0, y, 9.0], [0.0, y, -15.0]]
    };
    (0..count).map(sheet).collect()
}

/// From ten triangles to ten times as many work grows tenfold at most, and a little for what is there without any.
#[test]
fn no_mesh_is_a_cliff() {
    let without = cost(Vec::new());
    for (name, make) in [
        ("specks", specks as fn(usize) -> Triangles),
        ("dust", dust),
        ("bumpy", |count| {
            bumpy_sphere(count).triangles().iter().map(|t| t.map(|[x, y, z]| [x / 2.0, y / 2.0, z / 2.0])).collect()
        }),
    ] {
        let costs: Vec<f64> = [10, 100, 1000, 10_000].map(|count| cost(make(count)) - without).to_vec();
        assert!(costs.windows(2).all(|pair| pair[1] < 11.0 * pair[0] + 1.0), "{name}: {costs:.1?} over {without:.1}");
    }
}

/// All triangles in the list of one tile cost no more each when there are many, and are not lost.
#[test]
fn one_list_may_hold_everything() {
    let costs = [3000, 30_000].map(|count| cost(specks(count)));
    assert!(costs[1] < 11.0 * costs[0], "{costs:.1?}");
    // More than a launch takes of a list.
    let request = request(specks(9000));
    let (one, many) =
        (baked(&request, &Effort::default()), baked(&request, &Effort { memory: 4096, ..Effort::default() }));
    assert_eq!(one.sets, many.sets);
    assert!(one.visible.iter().any(|seen| *seen < 64));
}

/// Receivers that see nothing any more leave the rest of their lists.
#[test]
fn sheets_behind_sheets_cost_their_sorting_alone() {
    let [few, many] = [40, 4000].map(|count| baked(&request(sheets(count)), &Effort::default()));
    assert_eq!((few.visible.iter().sum::<u32>(), &few.sets), (0, &many.sets));
    assert_eq!(many.work.pairs, 4000 * 64 * 64);
    let [few, many] = [few, many].map(|bake| bake.work.lane_ops.unwrap());
    assert!(many < 6 * few, "{many} is more than 6 times {few}");
}

/// One triangle over everything among many small ones takes its own work and not theirs.
#[test]
fn one_large_triangle_among_small_ones() {
    let large = sheets(1);
    let [alone, small, both] = [large.clone(), dust(5000), [dust(5000), large].concat()].map(cost);
    assert!(both < 1.2 * (alone + small), "{both:.1} of {alone:.1} and {small:.1}");
}

/// A light as wide as the floor and close to it.
#[test]
fn a_light_as_large_as_the_scene() {
    let wide = |count| {
        let light = Rect { corner: [-2.0, 1.5, -2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, 4.0] };
        let bake = baked(&Request { light, ..request(dust(count)) }, &Effort::default());
        (bake.work.lane_ops.unwrap() as f64 / 1e6, bake.work.bytes)
    };
    let [(few, few_bytes), (many, many_bytes)] = [100, 1000].map(wide);
    assert!(many < 11.0 * few, "{many:.1} of {few:.1}");
    assert!(many_bytes < 11 * few_bytes, "{many_bytes} bytes of {few_bytes}");
}

/// What lists take is bounded, and what all takes does not grow but by the triangles themselves.
#[test]
fn memory_is_that_of_the_lists_and_the_triangles() {
    let settings = Settings { resolution: Some(64), samples: Some(64), light_size: Some(1.0), ..Settings::default() };
    let request = Setup::new(bumpy_sphere(20_000), &settings).unwrap().request();
    let [little, much] = [1 << 16, 1 << 26].map(|memory| {
        let effort = Effort { memory, ..Effort::default() };
        let bake = baked(&request, &effort);
        (bake.work.bytes, bake.sets)
    });
    assert_eq!(little.1, much.1);
    let triangles = 20_000 * (36 + 16 + 4);
    assert!(little.0 < much.0 && little.0 < triangles + (1 << 17), "{} and {} bytes", little.0, much.0);
}

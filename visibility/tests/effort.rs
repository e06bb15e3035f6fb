//! What a bake is spared or given changes no bit of it: culling, and memory for lists.

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_visibility::scene::bumpy_sphere;
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::{Bake, Effort, Request, bake_with};

fn machine() -> CpuBackend {
    CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() })
}

/// A closed mesh whose light is as wide as its radius.
fn sphere(resolution: u32) -> Request {
    let settings =
        Settings { resolution: Some(resolution), samples: Some(256), light_size: Some(1.0), ..Settings::default() };
    Setup::new(bumpy_sphere(1200), &settings).unwrap().request()
}

fn baked(request: &Request, effort: Effort) -> Bake {
    bake_with(&machine(), request, &effort, &mut |_| ()).unwrap()
}

#[test]
fn culling_closed_surfaces_changes_no_bit() {
    let request = sphere(96);
    let auto = baked(&request, Effort::default());
    let off = baked(&request, Effort { cull: false, ..Effort::default() });
    assert_eq!((auto.work.closed, off.work.closed, off.work.culled), (1224, 0, 0));
    assert!((200..612).contains(&auto.work.culled), "{} culled", auto.work.culled);
    assert!(auto.work.pairs * 10 < off.work.pairs * 8);
    assert!(auto.visible.iter().filter(|seen| (1..256).contains(*seen)).count() > 1000);
    assert_eq!(auto.sets, off.sets);
}

#[test]
fn nested_surfaces_are_culled_and_cut_ones_are_not() {
    let mut request = sphere(64);
    request.receiver.corner[1] = 0.4;
    request.triangles = cube([-1.5, 0.5, -1.5], [1.5, 1.0, 1.5]).to_vec();
    request.triangles.extend(cube([-0.2, 0.6, -0.2], [0.2, 0.8, 0.2]));
    let auto = baked(&request, Effort::default());
    let off = baked(&request, Effort { cull: false, ..Effort::default() });
    assert_eq!((auto.work.closed, auto.work.culled), (24, 4));
    assert_eq!(auto.sets, off.sets);
    // The receivers' plane cuts both boxes, and some receivers are inside: nothing between the planes is closed.
    request.receiver.corner[1] = 0.7;
    let cut = baked(&request, Effort::default());
    assert_eq!((cut.work.closed, cut.work.culled), (0, 0));
    assert_eq!(cut.sets, baked(&request, Effort { cull: false, ..Effort::default() }).sets);
}

/// A box of twelve triangles that look outwards.
fn cube(low: [f64; 3], high: [f64; 3]) -> [[[f64; 3]; 3]; 12] {
    let corner = |i: usize| std::array::from_fn(|axis| if i >> axis & 1 == 1 { high[axis] } else { low[axis] });
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    std::array::from_fn(|i| {
        let [a, b, c, d] = faces[i / 2];
        (if i % 2 == 0 { [a, b, c] } else { [a, c, d] }).map(corner)
    })
}

#[test]
fn little_memory_takes_more_turns_and_changes_no_bit() {
    let request = sphere(96);
    let one = baked(&request, Effort::default());
    let many = baked(&request, Effort { memory: 4096, ..Effort::default() });
    assert!(many.work.lane_ops > one.work.lane_ops, "the batches were one");
    assert_eq!((many.sets, many.visible, many.work.pairs), (one.sets, one.visible, one.work.pairs));
}

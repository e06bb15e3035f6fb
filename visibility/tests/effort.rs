//! What a bake is spared or given changes no bit of it: culling, the faces of closed surfaces, and memory for lists.

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_visibility::scene::{Mesh, Scene, bumpy_sphere};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::expose::{Exposed, Exposure, Sampling, expose};
use sightlines_visibility::shadows::light::Light;
use sightlines_visibility::shadows::lightmap::Atlas;
use sightlines_visibility::shadows::placement::Placement;
use sightlines_visibility::shadows::surface::{HeightMap, Surface};
use sightlines_visibility::shadows::{Bake, Effort, Faces, Rect, Request, bake_with};

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

/// What enters a closed surface crosses a front, and what leaves it a back: either faces hide what both do, from fewer
/// pairs.
#[test]
fn fronts_of_a_closed_surface_hide_what_the_whole_does() {
    let request = sphere(96);
    let [both, front, back] = [Faces::Both, Faces::Front, Faces::Back]
        .map(|faces| baked(&Request { faces, ..request.clone() }, Effort { cull: false, ..Effort::default() }));
    assert_eq!((&front.sets, &back.sets), (&both.sets, &both.sets));
    assert_eq!((both.work.pairs, front.work.pairs, back.work.pairs), (684_084, 567_822, 154_714));
    assert_eq!(front.work.culled, 0);
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

const FLOOR: Rect = Rect { corner: [-2.0, 0.0, 2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, -4.0] };

/// A floor with a lightmap.
fn lightmap() -> Surface {
    let vertices = vec![[-2.0, 0.0, 2.0], [2.0, 0.0, 2.0], [2.0, 0.0, -2.0], [-2.0, 0.0, -2.0]];
    let uvs = vec![[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];
    let floor =
        Mesh { name: "floor".to_owned(), vertices, triangles: vec![[0, 1, 2], [0, 2, 3]], uvs, ..Mesh::default() };
    Surface::Lightmap(Atlas::new(&Scene { name: "floor".to_owned(), units: "metres", parts: vec![floor] }).unwrap())
}

/// A bumpy sphere and a box over receivers that row spans cannot take.
fn exposure(surface: Surface, effort: Effort) -> Exposure {
    let sphere = bumpy_sphere(150).triangles();
    let sphere = sphere.into_iter().map(|t| t.map(|[x, y, z]| [x * 0.5 + 0.4, y * 0.5 + 0.6, z * 0.5 - 0.2]));
    Exposure {
        triangles: sphere.chain(cube([-1.1, 1.0, -0.4], [-0.6, 1.3, 0.5])).collect(),
        faces: Faces::Both,
        light: Light::from(Rect { corner: [-0.6, 3.0, -0.5], u: [1.2, 0.0, 0.0], v: [0.0, 0.0, 1.0] }),
        surface,
        resolution: 24,
        sampling: Sampling { placement: Placement::Halton, ..Sampling::new(50) },
        light_sums: true,
        motion: None,
        effort,
    }
}

fn exposed(exposure: &Exposure) -> Exposed {
    expose(&machine(), exposure, &mut |_| ()).unwrap()
}

#[test]
fn slopes_walls_height_fields_and_lightmaps_are_culled_and_taken_in_turns_alike() {
    let slope = Rect { corner: [-2.0, -0.6, 2.0], v: [0.0, 0.5, -4.0], ..FLOOR };
    let wall = Rect { corner: [-1.8, 0.1, -0.9], u: [3.6, 0.0, 0.0], v: [0.0, 2.4, 0.0] };
    let heights = Surface::Heights(Rect { corner: [-2.0, -0.7, 2.0], ..FLOOR }, HeightMap::bumps(0.6));
    for (name, surface) in [
        ("slope", Surface::Plane(slope)),
        ("wall", Surface::Plane(wall)),
        ("heights", heights),
        ("lightmap", lightmap()),
    ] {
        let whole = exposed(&exposure(surface.clone(), Effort { cull: false, ..Effort::default() }));
        let auto = exposed(&exposure(surface.clone(), Effort::default()));
        let turns = exposed(&exposure(surface, Effort { memory: 256, ..Effort::default() }));
        let seen = |exposed: &Exposed| exposed.visible.iter().filter(|seen| (1..50).contains(*seen)).count();
        assert!(seen(&whole) > 15, "{name}: {} texels are partly lit", seen(&whole));
        assert_eq!((auto.work.closed, whole.work.closed), (168 + 12, 0), "{name}");
        assert!((30..140).contains(&auto.work.culled), "{name}: {} culled", auto.work.culled);
        assert!(auto.work.pairs * 10 < whole.work.pairs * 9, "{name}: {} of {}", auto.work.pairs, whole.work.pairs);
        assert!(turns.work.lane_ops > auto.work.lane_ops, "{name}: the turns were one");
        for other in [auto, turns] {
            assert_eq!(
                (&other.sets, &other.visible, &other.light),
                (&whole.sets, &whole.visible, &whole.light),
                "{name}"
            );
        }
    }
}

/// Each receiver has the light elsewhere, so faces must face all of the places where it is; and a surface around a
/// receiver hides by its fronts alone.
#[test]
fn shifted_patterns_and_receivers_inside_are_minded() {
    let decorrelated = |effort| {
        let exposure = exposure(Surface::Plane(Rect { v: [0.0, -0.2, -4.0], ..FLOOR }), effort);
        Exposure { sampling: Sampling { decorrelated: true, ..exposure.sampling }, ..exposure }
    };
    let inside = |effort| {
        // A wall of receivers within the box and beside it.
        let rect = Rect { corner: [-1.5, 1.1, -0.1], u: [2.0, 0.0, 0.0], v: [0.0, 0.1, 0.0] };
        exposure(Surface::Plane(rect), effort)
    };
    for (name, make, closed) in
        [("decorrelated", &decorrelated as &dyn Fn(Effort) -> Exposure, 180), ("inside", &inside, 0)]
    {
        let whole = exposed(&make(Effort { cull: false, ..Effort::default() }));
        let auto = exposed(&make(Effort::default()));
        assert_eq!((auto.work.closed, auto.sets == whole.sets), (closed, true), "{name}");
    }
}

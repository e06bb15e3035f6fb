//! What queries are for: each application culls a known set, and what is drawn afterwards shows that nothing was lost.

use sightlines_backend_cpu::{Config, CpuBackend};
use sightlines_kernels::depth_bounds::Form;
use sightlines_kernels::raster::{NOTHING, Picture};
use sightlines_visibility::queries::baselines::{depth_tests, predicated, whole_objects};
use sightlines_visibility::queries::detail::{Level, choose};
use sightlines_visibility::queries::device::draw_counted;
use sightlines_visibility::queries::displacement::{Scene, displace};
use sightlines_visibility::queries::transparency::{FULL, Veil, query_veiled};
use sightlines_visibility::queries::{Granularity, Item, Method, Stage, draw, query, shadow_volumes, share};
use sightlines_visibility::scene::frame::Frame;
use sightlines_visibility::scene::{Affine, Instance, World, ball_levels, creature_field, creature_in_hall, crowd};

fn backend() -> CpuBackend {
    CpuBackend::new(Config::default())
}

fn square(side: u32) -> Picture {
    Picture { width: side, height: side }
}

#[test]
fn casters_without_a_lit_pixel_change_nothing_of_the_lights_depths() {
    let world = crowd(200);
    let light = &world.cameras[1];
    let frame = Frame::new(light, square(256), world.corners().as_flattened()).unwrap();
    let stage = Stage::of(&world, frame).unwrap();
    let all = draw(&backend(), &stage).unwrap();
    let mut extruded = Vec::new();
    for method in [Method::HIB, Method::SAT] {
        let answer = query(&backend(), &stage, method, 0, &mut |_| ()).unwrap();
        let lit: Vec<usize> =
            answer.items.iter().zip(&answer.totals).filter(|(_, n)| **n > 0).map(|(item, _)| item.instance).collect();
        let kept = Stage::new(&world, frame, &lit, Granularity::Instances).unwrap();
        let drawn = draw(&backend(), &kept).unwrap();
        assert!(drawn.depths == all.depths && drawn.instances == all.instances, "{method:?}: a lit pixel was lost");
        let casters: Vec<usize> = lit.iter().copied().filter(|instance| *instance > 0).collect();
        let volumes = shadow_volumes::volumes(&world, &casters, light.eye, 3.0);
        extruded.push((casters.len(), volumes.triangle_count()));
    }
    assert_eq!(extruded, [(172, 158_568), (174, 160_436)]);
}

#[test]
fn prisms_without_a_seen_pixel_of_the_hull_change_nothing_of_the_picture() {
    let world = creature_in_hall();
    let displaced = displace(&world.meshes[0], 0.06, 2, creature_field);
    let scene = Scene::new(&world, 0, displaced);
    let mut kept = Vec::new();
    for camera in &world.cameras {
        let frame = Frame::new(camera, square(256), &scene.points()).unwrap();
        let full = draw(&backend(), &Stage::of(&scene.full, frame).unwrap()).unwrap();
        for (method, depth) in [(Method::HIB, 3), (Method::HIB, 6), (Method::SAT, 0)] {
            let culled = scene.cull(&backend(), frame, method, depth).unwrap();
            let left = scene.extruded(&culled.kept);
            let drawn = draw(&backend(), &Stage::of(&left, frame).unwrap()).unwrap();
            assert!(
                drawn.depths == full.depths && drawn.instances == full.instances,
                "{} {method:?} {depth}",
                camera.name
            );
            kept.push(culled.kept.iter().filter(|kept| **kept).count());
        }
    }
    assert_eq!(kept, [7128, 7128, 7128, 6719, 4194, 3917, 0, 0, 0]);
}

#[test]
fn detail_follows_what_is_seen_and_what_is_not_seen_is_not_drawn() {
    let mut world = crowd(200);
    let [middle, coarse] = ball_levels();
    world.meshes.extend([middle, coarse]);
    let frame = Frame::new(&world.cameras[0], square(256), world.corners().as_flattened()).unwrap();
    let stage = Stage::of(&world, frame).unwrap();
    let answer = query(&backend(), &stage, Method::HIB, 0, &mut |_| ()).unwrap();
    let all = draw(&backend(), &stage).unwrap();
    let finest = [Level { mesh: 1, pixels: 1 }];
    let (lossless, places) = choose(&world, &answer, 1, &finest);
    let drawn = draw(&backend(), &Stage::of(&lossless, frame).unwrap()).unwrap();
    let instances: Vec<_> = drawn.instances.iter().map(|i| i.map(|i| places[i])).collect();
    assert!(drawn.depths == all.depths && instances == all.instances, "a seen pixel was lost");
    let levels = [Level { mesh: 1, pixels: 200 }, Level { mesh: 2, pixels: 50 }, Level { mesh: 3, pixels: 1 }];
    let (coarser, places) = choose(&world, &answer, 1, &levels);
    let drawn = draw(&backend(), &Stage::of(&coarser, frame).unwrap()).unwrap();
    let differ = drawn.instances.iter().zip(&all.instances).filter(|(a, b)| a.map(|i| places[i]) != **b).count();
    let triangles = [&world, &lossless, &coarser].map(|world| world.triangle_count());
    assert_eq!((triangles, differ), ([121_202, 75_752, 21_884], 609));
}

#[test]
fn a_share_is_of_what_an_instance_would_cover_alone() {
    let world = crowd(60);
    let frame = Frame::new(&world.cameras[1], square(128), world.corners().as_flattened()).unwrap();
    let stage = Stage::of(&world, frame).unwrap();
    let all: Vec<usize> = (0..stage.items.len()).collect();
    let covered = share::covered(&backend(), &stage, &all, &mut |_| ()).unwrap();
    for (item, covered) in stage.items.iter().zip(covered) {
        let alone = Stage::new(&world, frame, &[item.instance], Granularity::Instances).unwrap();
        let pixels = draw(&backend(), &alone).unwrap().instances.iter().flatten().count();
        assert_eq!(covered as usize, pixels, "{item:?}");
    }
}

#[test]
fn baselines_keep_all_that_is_seen_and_more() {
    let world = crowd(200);
    let frame = Frame::new(&world.cameras[0], square(128), world.corners().as_flattened()).unwrap();
    let stage = Stage::of(&world, frame).unwrap();
    let all = draw(&backend(), &stage).unwrap();
    let seen: Vec<bool> = stage.items.iter().map(|item| all.instances.contains(&Some(item.instance))).collect();
    let whole = whole_objects(&backend(), &world, &stage).unwrap();
    let (drawn, painted) = predicated(&backend(), &world, &stage).unwrap();
    let pyramid = depth_tests(&backend(), &stage, Form::Pyramid).unwrap();
    let buffers = depth_tests(&backend(), &stage, Form::Buffers).unwrap();
    assert!(painted.depths == all.depths && painted.instances == all.instances, "predicated drawing lost a pixel");
    assert_eq!((whole.read_backs, drawn.read_backs, pyramid.read_backs), (163, 0, 1));
    assert_eq!(whole.kept, drawn.kept, "both ask whether a box shows a pixel");
    for (name, verdict) in [("whole", &whole), ("pyramid", &pyramid), ("buffers", &buffers)] {
        assert!(verdict.kept.iter().zip(&seen).all(|(kept, seen)| *kept || !seen), "{name} culls what is seen");
        let instances: Vec<usize> =
            stage.items.iter().zip(&verdict.kept).filter(|(_, kept)| **kept).map(|(item, _)| item.instance).collect();
        let left = Stage::new(&world, frame, &instances, Granularity::Instances).unwrap();
        assert_eq!(draw(&backend(), &left).unwrap().depths, all.depths, "{name}");
    }
    let kept = |kept: &[bool]| kept.iter().filter(|kept| **kept).count();
    let counts = [&seen, &whole.kept, &buffers.kept, &pyramid.kept].map(|verdict| kept(verdict));
    assert_eq!(counts, [117, 134, 126, 147]);
}

#[test]
fn what_the_light_counts_the_viewer_draws_without_the_host() {
    let world = crowd(60);
    let [view, light] = [0, 1].map(|camera| {
        let frame = Frame::new(&world.cameras[camera], square(96), world.corners().as_flattened()).unwrap();
        Stage::of(&world, frame).unwrap()
    });
    for (method, threshold) in [(Method::HIB, 0), (Method::HIB, 30), (Method::SAT, 0)] {
        let answer = query(&backend(), &light, method, 0, &mut |_| ()).unwrap();
        let counted: Vec<bool> = answer.totals.iter().map(|pixels| *pixels > threshold).collect();
        assert!(counted.contains(&true) && counted.contains(&false), "{method:?} {threshold}");
        let chosen = view.part(|instance| counted[answer.items.iter().position(|i| i.instance == instance).unwrap()]);
        let expected = draw(&backend(), &chosen).unwrap();
        let found = draw_counted(&backend(), &light, &view, method, threshold).unwrap();
        assert!(found.depths == expected.depths && found.instances == expected.instances, "{method:?} {threshold}");
    }
}

/// The weight of every pixel behind veils of one kind, whose order does not matter: by one draw of each.
fn weights(world: &World, frame: Frame, veils: &[Veil], opaque: &[u32]) -> Vec<u32> {
    let mut weights = vec![FULL; opaque.len()];
    for veil in veils {
        let alone = Stage::new(world, frame, &[veil.instance], Granularity::Instances).unwrap();
        let drawn = draw(&backend(), &alone).unwrap();
        for ((weight, depth), veil_depth) in weights.iter_mut().zip(opaque).zip(drawn.depths) {
            if veil_depth < *depth {
                *weight = (*weight * veil.through + 128) / 256;
            }
        }
    }
    weights
}

#[test]
fn what_is_lost_in_smoke_is_culled_and_no_weighted_pixel_changes() {
    // Three panes of smoke stand before the left of the picture: 255, 12, 1 and nothing are the weights behind them.
    let mut world = crowd(200);
    let pane = |depth: f64| Affine([[0.4, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.4, 0.0], [-5.0, 2.5, depth]]);
    let smoke = |depth| Instance { name: "smoke".to_owned(), mesh: 0, transform: pane(depth) };
    world.instances.extend([14.0, 14.5, 15.0].map(smoke));
    let frame = Frame::new(&world.cameras[0], square(256), world.corners().as_flattened()).unwrap();
    let (smoke, opaque): (Vec<usize>, Vec<usize>) = (0..world.instances.len()).partition(|i| *i > 200);
    let veils: Vec<Veil> = smoke.iter().map(|instance| Veil { instance: *instance, through: 12 }).collect();
    let mut kept = Vec::new();
    for method in [Method::HIB, Method::SAT] {
        let before = query_veiled(&backend(), &world, frame, &opaque, &veils, method).unwrap();
        assert_eq!(before.weights, weights(&world, frame, &veils, &before.answer.depths), "{method:?}");
        let mut sums = vec![0; before.sums.len()];
        let shown = before.answer.shown.iter().zip(&before.weights);
        shown.filter(|(item, _)| **item != NOTHING).for_each(|(item, weight)| sums[*item as usize] += weight);
        match method {
            Method::Hib { .. } => assert_eq!(before.sums, sums),
            Method::Sat { .. } => assert!(before.sums.iter().zip(&sums).all(|(bound, exact)| bound >= exact)),
        }
        let left = before.kept(1);
        let after = query_veiled(&backend(), &world, frame, &left, &veils, method).unwrap();
        assert_eq!(after.weights, before.weights, "{method:?}");
        for (pixel, weight) in before.weights.iter().enumerate().filter(|(_, weight)| **weight > 0) {
            let instance = |item: u32, items: &[Item]| items.get(item as usize).map(|item| item.instance);
            let [was, is] = [&before, &after].map(|v| instance(v.answer.shown[pixel], &v.answer.items));
            assert_eq!(was, is, "{method:?}: pixel {pixel} of weight {weight}");
        }
        kept.push([opaque.len(), before.answer.visible(), left.len()]);
    }
    assert_eq!(kept, [[201, 126, 69], [201, 139, 74]]);
}

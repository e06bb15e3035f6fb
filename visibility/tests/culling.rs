//! What queries are for: each application culls a known set, and what is drawn afterwards shows that nothing was lost.

use sightlines_backend_cpu::{Config, CpuBackend};
use sightlines_kernels::depth_bounds::Form;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::queries::baselines::{depth_tests, predicated, whole_objects};
use sightlines_visibility::queries::detail::{Level, choose};
use sightlines_visibility::queries::displacement::{Scene, displace};
use sightlines_visibility::queries::{Granularity, Method, Stage, draw, query, shadow_volumes, share};
use sightlines_visibility::scene::frame::Frame;
use sightlines_visibility::scene::{ball_levels, creature_field, creature_in_hall, crowd};

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
    let covered = share::covered(&backend(), &world, &stage, &mut |_| ()).unwrap();
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
    assert_eq!((whole.read_backs, drawn.read_backs, pyramid.read_backs), (201, 0, 1));
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

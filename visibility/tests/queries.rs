//! Counts of both methods against a count of every pixel of the raster's oracle, which asks every triangle.

use glam::UVec4;
use sightlines_backend::{Backend, Job};
use sightlines_backend_cpu::{Config, CpuBackend};
use sightlines_kernels::item_histogram::Order;
use sightlines_kernels::raster::oracle::{self, pictures};
use sightlines_kernels::raster::{Faces, Ids, NOTHING, Picture};
use sightlines_visibility::queries::{Answer, Granularity, Method, Queries, Stage, bounds, query};
use sightlines_visibility::scene::frame::{Frame, Snapped};
use sightlines_visibility::scene::{Affine, Camera, Instance, World, crowd, generate_world};

fn backend() -> CpuBackend {
    CpuBackend::new(Config::default())
}

fn frame(world: &World, camera: &Camera, width: u32, height: u32) -> Frame {
    Frame::new(camera, Picture { width, height }, world.corners().as_flattened()).unwrap()
}

/// The instance of every pixel, by the oracle.
fn shown(world: &World, frame: &Frame) -> Vec<u32> {
    let scene = |(number, instance): (usize, &Instance)| {
        let mesh = &world.meshes[instance.mesh];
        let Snapped { vertices, to_mesh } = Snapped::of(mesh);
        let rows = frame.placement(&instance.transform.then(&to_mesh)).unwrap().rows;
        let ids = Ids { base: number as u32, step: 1, shift: 31 };
        oracle::Scene { vertices, triangles: mesh.triangles.clone(), instances: vec![rows], faces: Faces::All, ids }
    };
    let scenes: Vec<oracle::Scene> = world.instances.iter().enumerate().map(scene).collect();
    let [_, items] = pictures(frame.view, &scenes);
    items
}

/// Pixels of every instance in every tile, counted one by one.
fn counted(shown: &[u32], instances: usize, [width, height]: [usize; 2], depth: u32) -> Vec<u32> {
    let side = 1 << depth;
    let mut counts = vec![0; instances * side * side];
    for (pixel, item) in shown.iter().enumerate().filter(|(_, item)| **item != NOTHING) {
        let (x, y) = (pixel % width * side / width, pixel / width * side / height);
        counts[*item as usize * side * side + y * side + x] += 1;
    }
    counts
}

fn ask(stage: &Stage, method: Method, depth: u32) -> Answer {
    query(&backend(), stage, method, depth, &mut |_| ()).unwrap()
}

#[test]
fn item_buffer_counts_are_those_of_every_pixel_and_tables_never_count_less() {
    for (name, camera, [width, height], depth) in [
        ("crowd-40", 0, [96, 64], 2),
        ("crowd-40", 1, [60, 61], 3),
        ("quads", 9, [52, 40], 0),
        ("colonnade", 9, [64, 64], 1),
    ] {
        let world = generate_world(name).unwrap();
        let lone = Camera::parse("3,2.5,4/0,1.2,0", [0.0, 1.0, 0.0]).unwrap().unwrap();
        let frame = frame(&world, world.cameras.get(camera).unwrap_or(&lone), width as u32, height as u32);
        let stage = Stage::of(&world, frame).unwrap();
        let shown = shown(&world, &frame);
        let expected = counted(&shown, world.instances.len(), [width, height], depth);
        let whole = counted(&shown, world.instances.len(), [width, height], 0);
        assert!(whole.iter().sum::<u32>() > 40, "{name}: the picture is not empty");
        for order in [Order::Memory, Order::Scattered] {
            let exact = ask(&stage, Method::Hib { order }, depth);
            assert!(exact.shown == shown && exact.tiles == expected && exact.totals == whole, "{name} {order:?}");
        }
        for (channels, limit) in [(4, None), (1, None), (8, Some(1))].into_iter().filter(|_| width % 4 == 0) {
            let bound = ask(&stage, Method::Sat { channels, limit }, depth);
            assert!(bound.totals.iter().zip(&whole).all(|(bound, exact)| bound >= exact), "{name}");
            assert!(bound.tiles.iter().zip(&expected).all(|(bound, exact)| bound >= exact), "{name}");
            let each = 1 << (2 * depth);
            let sums: Vec<u32> = bound.tiles.chunks(each).map(|tiles| tiles.iter().sum()).collect();
            assert_eq!(sums, bound.totals, "{name}: tiles are parts of the picture");
        }
    }
}

#[test]
fn bounds_hold_every_pixel_of_their_instance() {
    let world = crowd(30);
    for camera in &world.cameras {
        let frame = frame(&world, camera, 120, 90);
        for (number, (instance, bounds)) in
            world.instances.iter().zip(bounds::of(&Stage::of(&world, frame).unwrap())).enumerate()
        {
            let alone = World { instances: vec![instance.clone()], ..world.clone() };
            let pixels = shown(&alone, &frame);
            let [x0, y0, x1, y1] = bounds.rectangle.to_array();
            for pixel in (0..pixels.len() as u32).filter(|p| pixels[*p as usize] != NOTHING) {
                let (x, y) = (pixel % 120, pixel / 120);
                assert!((x0..x1).contains(&x) && (y0..y1).contains(&y), "instance {number}: {x}, {y} {bounds:?}");
                for (corner, next) in (0..8).map(|i| (bounds.outline[i], bounds.outline[(i + 1) % 8])) {
                    for [cx, cy] in [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[dx, dy]| [(x + dx) as i32, (y + dy) as i32])
                    {
                        let way = next - corner;
                        let turn = way.x * (cy - corner.y) - way.y * (cx - corner.x);
                        assert!(turn >= 0, "instance {number}: pixel {x}, {y} leaves {bounds:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_flush_with_the_near_plane_is_bounded_by_its_own_rectangle() {
    let mut world = crowd(1);
    let tile = |i: usize| Affine::placed(0.7, [f64::from(i as u8 % 7), 0.1 / 3.0, f64::from(i as u8 / 7)]);
    world.instances = (0..49).map(|i| Instance { transform: tile(i), ..world.instances[1].clone() }).collect();
    let top = Camera::parse("3,9,3/3,0,3/height=9", [0.0, 1.0, 0.0]).unwrap().unwrap();
    let stage = Stage::of(&world, frame(&world, &top, 128, 128)).unwrap();
    assert!(bounds::of(&stage).iter().all(|b| b.rectangle.z - b.rectangle.x < 25), "no ball is wider than 1.5 of 9");
}

#[test]
fn clusters_are_counted_and_sum_to_their_instances() {
    let world = crowd(5);
    let frame = frame(&world, &world.cameras[0], 64, 64);
    let whole = ask(&Stage::of(&world, frame).unwrap(), Method::HIB, 1);
    let all: Vec<usize> = (0..6).collect();
    let stage = Stage::new(&world, frame, &all, Granularity::Clusters { shift: 4 }).unwrap();
    let fine = ask(&stage, Method::HIB, 1);
    assert_eq!(fine.items.len(), 1 + 5 * 38);
    for (item, pixels) in whole.items.iter().zip(&whole.totals) {
        let parts = fine.items.iter().zip(&fine.totals).filter(|(part, _)| part.instance == item.instance);
        // A pixel where two instances have one depth shows the lower number, which is the same of both.
        assert_eq!(parts.map(|(_, pixels)| pixels).sum::<u32>(), *pixels, "{item:?}");
    }
}

#[test]
fn limits_are_named_with_what_to_do() {
    let world = crowd(40);
    let wide = Stage::of(&world, frame(&world, &world.cameras[0], 64, 64)).unwrap();
    let frame = frame(&world, &world.cameras[0], 62, 64);
    let stage = Stage::of(&world, frame).unwrap();
    let refused = |stage: &Stage, method, depth| {
        let error = query(&backend(), stage, method, depth, &mut |_| ()).unwrap_err();
        assert!(error.is_bad_input(), "{error}");
        error.to_string()
    };
    let all: Vec<usize> = (0..41).collect();
    let clusters = Stage::new(&world, frame, &all, Granularity::Clusters { shift: 0 }).unwrap();
    let bins = refused(&clusters, Method::HIB, 6);
    assert!(bins.contains("24242 items in 2^6 by 2^6 tiles need 99295232 bins"), "{bins}");
    assert!(bins.contains("at most 33554432 bins: choose fewer tiles"), "{bins}");
    assert!(refused(&stage, Method::HIB, 9).contains("at most 2^8 a side"));
    assert!(refused(&stage, Method::SAT, 0).contains("62 pixels wide"));
    assert!(refused(&clusters, Method::SAT, 0).contains("count clusters with `hib`"));
    let nine = Method::Sat { channels: 9, limit: None };
    assert!(refused(&stage, nine, 0).contains("choose 1 to 8"));
    let none = Method::Sat { channels: 4, limit: Some(0) };
    assert!(refused(&wide, none, 0).contains("choose 1 to 64"));
    let many = World { instances: (0..2001).map(|i| world.instances[i % 40 + 1].clone()).collect(), ..world.clone() };
    let many = Stage::of(&many, frame).unwrap();
    assert!(refused(&many, Method::SAT, 0).contains("2001 instances, at most 2000 have regions"));
}

#[test]
fn rectangles_of_one_item_and_weights_are_those_of_every_pixel() {
    let world = crowd(40);
    let frame = frame(&world, &world.cameras[0], 96, 64);
    let stage = Stage::of(&world, frame).unwrap();
    let shown = shown(&world, &frame);
    let queries = Queries::new().unwrap();
    let mut job = Job::new();
    let drawn = stage.record(&queries.raster, &mut job).unwrap();
    let rectangles = [[0, 0, 96, 64], [10, 20, 50, 40], [95, 63, 96, 64], [7, 7, 7, 9]].map(UVec4::from);
    let sums: Vec<_> =
        [0, 17].map(|item| queries.record_rectangles(&mut job, &drawn, item, &rectangles).unwrap()).into();
    let weights: Vec<u32> = (0..96 * 64).map(|pixel| pixel % 251).collect();
    let weighed = job.slice("weights", &weights);
    let weighed = queries.record_weighted(&mut job, &stage, &drawn, weighed, Method::HIB, 1).unwrap();
    for buffer in sums.iter().chain([&weighed.totals, &weighed.tiles]) {
        job.read("words", buffer.id());
    }
    let outputs = backend().run(&job).unwrap();
    let words =
        |output: usize| outputs[output].as_chunks().0.iter().map(|b| u32::from_le_bytes(*b)).collect::<Vec<_>>();
    for (output, item) in [(0, 0), (1, 17)] {
        let inside = |r: &UVec4, pixel: u32| {
            (r.x..r.z).contains(&(pixel % 96)) && (r.y..r.w).contains(&(pixel / 96)) && shown[pixel as usize] == item
        };
        let expected = rectangles.iter().map(|r| (0..96 * 64).filter(|pixel| inside(r, *pixel)).count() as u32);
        assert_eq!(words(output), expected.collect::<Vec<_>>(), "item {item}");
    }
    let mut expected = vec![0; 41];
    shown
        .iter()
        .zip(&weights)
        .filter(|(item, _)| **item != NOTHING)
        .for_each(|(item, w)| expected[*item as usize] += w);
    assert_eq!(words(2), expected);
    assert_eq!(words(3).chunks(4).map(|tiles| tiles.iter().sum::<u32>()).collect::<Vec<_>>(), expected);
}

//! Methods beside each other: projections give the same bits as sampling, and silhouette volumes err as they must.

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_visibility::compare::{Added, maps, projections, tables, volumes};
use sightlines_visibility::scene::{Generator, generate};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::{Faces, Request, bake};

fn machine() -> CpuBackend {
    CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() })
}

fn request(generator: &str, resolution: u32, samples: u32, light_size: f64) -> Request {
    let settings = Settings {
        resolution: Some(resolution),
        samples: Some(samples),
        light_size: Some(light_size),
        ..Settings::default()
    };
    let generator = Generator::from_name(generator).unwrap();
    Setup::new(generate(generator), &settings).unwrap().request()
}

#[test]
fn a_projection_for_each_sample_gives_the_same_sets() {
    let machine = machine();
    for (generator, resolution, samples, light) in
        [("box", 33, 32, 0.4), ("quads", 40, 128, 2.0), ("colonnade", 48, 64, 1.0), ("palms", 24, 64, 0.4)]
    {
        let request = request(generator, resolution, samples, light);
        let [ours, theirs] = [bake, projections].map(|method| method(&machine, &request, &mut |_| ()).unwrap());
        assert_eq!(ours.sets, theirs.sets, "{generator}");
        assert_eq!(ours.visible, theirs.visible, "{generator}");
        assert!(ours.visible.iter().any(|seen| (1..samples).contains(seen)), "{generator} has a penumbra");
        assert_eq!(theirs.work.pairs % u64::from(samples), 0);
    }
}

/// The order of the paper errs by the texels of its table alone: a few samples of a thousand.
#[test]
fn a_table_of_angles_and_distances_errs_by_its_texels() {
    for (generator, resolution, samples, light) in [("palms", 24, 64, 0.4), ("colonnade", 48, 256, 1.0)] {
        let request = request(generator, resolution, samples, light);
        let [ours, theirs] = [bake, tables].map(|method| method(&machine(), &request, &mut |_| ()).unwrap());
        let bits: u32 = ours.sets.masks.iter().zip(&theirs.sets.masks).map(|(a, b)| (a ^ b).count_ones()).sum();
        let all = samples * resolution * resolution;
        assert!(bits > 0 && bits * 200 < all, "{generator}: {bits} of {all}");
        assert_eq!(ours.sets.samples_uv, theirs.sets.samples_uv);
    }
}

/// A patch of a soft shadow map is right for a box whose lid alone is seen, up to the texels of the map; columns are
/// not.
#[test]
fn soft_shadow_maps_are_near_and_too_light_beside_what_the_centre_does_not_see() {
    let mean = |request: &Request| {
        let exact = bake(&machine(), request, &mut |_| ()).unwrap().visible;
        let Added { visible, work } = maps(request, &mut |_| ()).unwrap();
        assert!(work.pairs > 0 && work.lane_ops.is_none());
        let sum: u32 = exact.iter().zip(&visible).map(|(a, b)| a.abs_diff(*b)).sum();
        f64::from(sum) / (exact.len() as f64 * f64::from(request.samples))
    };
    let [lid, columns] =
        [request("box", 96, 256, 0.4), request("colonnade", 96, 256, 1.0)].map(|request| mean(&request));
    assert!(lid < 0.002 && columns > 3.0 * lid && columns < 0.05, "{lid} and {columns}");
}

/// Texels that volumes make too dark and too light, and by how many samples at most.
fn errors(request: &Request) -> [u32; 3] {
    let machine = machine();
    let exact = bake(&machine, request, &mut |_| ()).unwrap().visible;
    let added = volumes(&machine, request, &mut |_| ()).unwrap().visible;
    let count = |errs: fn(&u32, &u32) -> bool| exact.iter().zip(&added).filter(|(e, a)| errs(e, a)).count() as u32;
    let most = exact.iter().zip(&added).map(|(e, a)| e.abs_diff(*a)).max().unwrap();
    [count(|exact, added| added < exact), count(|exact, added| added > exact), most]
}

#[test]
fn silhouette_volumes_are_exact_under_one_silhouette_and_too_dark_where_casters_overlap() {
    assert_eq!(errors(&request("box", 64, 64, 0.4)), [0, 0, 0]);
    assert_eq!(errors(&request("colonnade", 128, 64, 0.4)), [332, 0, 30]);
    assert_eq!(errors(&request("colonnade", 32, 32, 0.4)), [16, 0, 8]);
}

#[test]
fn what_reaches_the_receiver_is_refused() {
    let mut request = request("box", 16, 32, 0.4);
    let one_sided = Request { faces: Faces::Front, ..request.clone() };
    assert!(maps(&one_sided, &mut |_| ()).unwrap_err().to_string().contains("one-sided"));
    let [x, y, z] = request.receiver.corner;
    request.triangles.push([[x + 1.0, y, z + 1.0], [x + 2.0, y + 1.0, z + 1.0], [x + 1.0, y + 1.0, z + 2.0]]);
    let refusal = projections(&machine(), &request, &mut |_| ()).expect_err("it touches the receiver").to_string();
    assert!(refusal.contains("1 triangles reach") && refusal.contains("remedy"), "{refusal}");
    assert_eq!(volumes(&machine(), &request, &mut |_| ()).expect_err("so does it here").to_string(), refusal);
}

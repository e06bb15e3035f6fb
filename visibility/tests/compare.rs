//! Methods beside each other: projections give the same bits as sampling, and silhouette volumes err as they must.

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_visibility::compare::{projections, volumes};
use sightlines_visibility::scene::{Generator, generate};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::{Request, bake};

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
    let [x, y, z] = request.receiver.corner;
    request.triangles.push([[x + 1.0, y, z + 1.0], [x + 2.0, y + 1.0, z + 1.0], [x + 1.0, y + 1.0, z + 2.0]]);
    let refusal = projections(&machine(), &request, &mut |_| ()).expect_err("it touches the receiver").to_string();
    assert!(refusal.contains("1 triangles reach") && refusal.contains("remedy"), "{refusal}");
    assert_eq!(volumes(&machine(), &request, &mut |_| ()).expect_err("so does it here").to_string(), refusal);
}

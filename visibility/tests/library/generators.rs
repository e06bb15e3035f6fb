//! Generated scenes: their counts, their bits, and that they are what their names say.

use sightlines_visibility::scene::{Generator, Scene, generate};

fn digest(scene: &Scene) -> String {
    let mut hasher = blake3::Hasher::new();
    for part in &scene.parts {
        hasher.update(part.name.as_bytes());
        for coordinate in part.vertices.as_flattened() {
            hasher.update(&coordinate.to_le_bytes());
        }
        for index in part.triangles.as_flattened() {
            hasher.update(&index.to_le_bytes());
        }
    }
    hasher.finalize().to_hex()[..16].to_owned()
}

#[test]
fn generated_scenes_are_the_same_bits_everywhere() {
    let found = Generator::ALL.map(|generator| {
        let scene = generate(generator);
        format!("{} {} {} {}", scene.name, scene.parts.len(), scene.triangle_count(), digest(&scene))
    });
    let expected = [
        "palms 5 29040 040a0a3df02de87d",
        "box 1 12 d5ed236d768eb758",
        "quads 2 4 a1290d58841667e0",
        "colonnade 14 744 7962f9a9a29880a7",
        "office 144 1728 3a2b27913b81f256",
        "ground 1 8192 29a1d61071fead60",
    ];
    assert_eq!(found, expected);
}

#[test]
fn generated_scenes_keep_the_invariant_of_scenes() {
    for generator in Generator::ALL {
        let scene = generate(generator);
        assert_eq!(Generator::from_name(&scene.name), Some(generator));
        assert_eq!(scene.degenerate_count(), 0, "{}", scene.name);
        let used: Vec<[f64; 3]> = scene.triangles().into_flattened();
        assert_eq!(used.len(), 3 * scene.triangle_count());
        assert!(used.as_flattened().iter().all(|c| c.is_finite()));
        assert!(scene.bounds().min[1] >= 0.0, "{} stands on the ground", scene.name);
        for part in &scene.parts {
            let unused = (0..part.vertices.len() as u32).find(|i| !part.triangles.as_flattened().contains(i));
            assert_eq!(unused, None, "{}: {}", scene.name, part.name);
        }
    }
}

/// Volume within a closed surface whose triangles turn counter-clockwise as seen from outside.
fn volume(triangles: &[[[f64; 3]; 3]]) -> f64 {
    let six_fold = |[a, b, c]: &[[f64; 3]; 3]| {
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    triangles.iter().map(six_fold).sum::<f64>() / 6.0
}

#[test]
fn boxes_and_columns_are_closed_and_face_outwards() {
    assert!((volume(&generate(Generator::Box).triangles()) - 1.0).abs() < 1e-12);
    let colonnade = generate(Generator::Colonnade);
    // A regular polygon of 16 corners on a circle of radius 0.35, 4 high; and two beams of 12 × 0.5 × 0.8.
    let column = 4.0 * 8.0 * 0.35 * 0.35 * libm::sin(std::f64::consts::TAU / 16.0);
    let expected = 12.0 * column + 2.0 * 12.0 * 0.5 * 0.8;
    assert!((volume(&colonnade.triangles()) - expected).abs() < 1e-9);
}

#[test]
fn palms_differ_in_height_and_crown() {
    let palms = generate(Generator::Palms);
    let tops: Vec<f64> =
        palms.parts.iter().map(|palm| palm.vertices.iter().map(|v| v[1]).fold(0.0, f64::max)).collect();
    for (number, top) in tops.iter().enumerate() {
        assert!((2.0..6.0).contains(top), "palm {number} is {top} high");
        assert!(tops[..number].iter().all(|other| (other - top).abs() > 1e-3));
    }
    let feet = palms.parts.iter().map(|palm| palm.vertices[0]);
    assert!(feet.clone().all(|foot| foot[1] == 0.0));
}

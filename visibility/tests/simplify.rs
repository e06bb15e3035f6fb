//! Simplified casters: what they cost and what they change, where the program has the library, and what it says where
//! not.

use std::process::Command;

#[cfg(feature = "simplify")]
mod library {
    use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
    use sightlines_visibility::scene::bumpy_sphere;
    use sightlines_visibility::setup::{Settings, Setup};
    use sightlines_visibility::shadows::bake;
    use sightlines_visibility::simplify::{Simplified, Target, simplify, tolerance};

    fn setup(light_size: f64) -> Setup {
        let settings =
            Settings { resolution: Some(64), samples: Some(256), light_size: Some(light_size), ..Settings::default() };
        Setup::new(bumpy_sphere(8000), &settings).unwrap()
    }

    fn simplified(setup: &Setup, target: Target) -> Simplified {
        let limit = tolerance(&setup.scene, &setup.lights[0].rect, setup.sampling.count, &setup.receiver);
        simplify(&setup.scene, target, limit).unwrap()
    }

    /// Samples that are hidden by one of two meshes alone, of a thousand.
    fn differing(setup: &Setup, other: &Simplified) -> f64 {
        let machine = CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() });
        let coarse = Setup { scene: other.scene.clone(), ..setup.clone() };
        let [a, b] = [setup, &coarse].map(|setup| bake(&machine, &setup.request(), &mut |_| ()).unwrap().sets.masks);
        let bits: u32 = a.iter().zip(&b).map(|(a, b)| (a ^ b).count_ones()).sum();
        1000.0 * f64::from(bits) / (32 * a.len()) as f64
    }

    #[test]
    fn an_eighth_of_the_triangles_casts_almost_the_same_shadow() {
        let setup = setup(0.4);
        let half = simplified(&setup, Target::Ratio(0.5));
        let eighth = simplified(&setup, Target::Ratio(0.125));
        let count = |s: &Simplified| (s.before, s.scene.triangle_count());
        let before = setup.scene.triangle_count();
        assert!(count(&half).0 == before && count(&half).1.abs_diff(before / 2) < 8, "{:?}", count(&half));
        assert!(count(&eighth).1.abs_diff(before / 8) < 8, "{:?}", count(&eighth));
        assert!(half.moved < eighth.moved && half.hash != eighth.hash && half.hash.len() == 64);
        let [fine, coarse] = [&half, &eighth].map(|s| differing(&setup, s));
        assert!(0.0 < fine && fine < coarse && coarse < 10.0, "{fine} and {coarse} of 1000 samples");
        assert_eq!(simplified(&setup, Target::Ratio(0.5)), half, "the same mesh again");
    }

    #[test]
    fn a_larger_light_lets_more_triangles_go() {
        let counts = [0.1, 0.4, 1.0].map(|size| {
            let setup = setup(size);
            let found = simplified(&setup, Target::Light);
            let limit = tolerance(&setup.scene, &setup.lights[0].rect, 256, &setup.receiver);
            assert!(found.moved <= limit * 1.001, "{} beyond {limit}", found.moved);
            found.scene.triangle_count()
        });
        assert!(counts[0] > counts[1] && counts[1] > counts[2], "{counts:?}");
    }

    #[test]
    fn nothing_that_is_left_is_refused() {
        let setup = setup(0.4);
        let message = simplify(&setup.scene, Target::Error(1e6), 0.0).unwrap_err().to_string();
        assert!(message.contains("nothing is left") && message.contains("smaller distance"), "{message}");
    }
}

#[test]
fn the_program_simplifies_or_names_the_feature() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
    let line = "shadows --scene palms --backend cpu --resolution 16 --samples 32 --simplify 0.5";
    let output = command.args(line.split_whitespace()).current_dir(folder.path()).output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    if cfg!(feature = "simplify") {
        assert!(output.status.success() && out.contains("simplified 29040 to "), "{out}{err}");
    } else {
        assert_eq!(output.status.code(), Some(2), "{err}");
        assert!(err.contains("--simplify") && err.contains("--features simplify"), "{err}");
        assert!(std::fs::read_dir(folder.path()).unwrap().next().is_none(), "nothing was written");
    }
}

//! Colours are the matrix times what the environment brings.

use sightlines_visibility::ambient::file::Stored;
use sightlines_visibility::ambient::{Colours, Environment, Filter, Lighting, Matrix, Sphere, Surface, Weighting};
use sightlines_visibility::scene::{Generator, bumpy_sphere};
use sightlines_visibility::setup::Up;

use super::{finish, machine, surface};

const SPHERE: Sphere = Sphere::Octahedron { level: 3 };

const PLAIN: Lighting = Lighting { blur: Some(0.0), ..Lighting::DEFAULT };

/// Colours under several environments, from one matrix.
fn colours<const N: usize>(surface: &Surface, lights: [(&Environment, Lighting); N]) -> [Colours; N] {
    let machine = machine();
    let mut matrix = Matrix::open(&machine, surface, SPHERE, 1).unwrap();
    finish(&mut matrix, SPHERE);
    lights.map(|(environment, lighting)| {
        let mut colours = Colours::new();
        matrix.light(&environment.look_up(&machine, SPHERE, &lighting).unwrap(), &mut colours).unwrap();
        colours
    })
}

/// A mesh without hollows.
fn ball() -> Surface {
    let mut scene = bumpy_sphere(400);
    for vertex in &mut scene.parts[0].vertices {
        let centred = [vertex[0], vertex[1] - 2.0, vertex[2]];
        let length = centred.iter().map(|c| c * c).sum::<f64>().sqrt();
        *vertex = centred.map(|c| c / length);
    }
    Surface::new(&scene).unwrap()
}

/// The brightest where a map's column is `column`, black elsewhere, on the horizon's half of the rows.
fn stripe(column: u32) -> Environment {
    let texel = |i: u32| {
        let inside = (i % 64).abs_diff(column).min(64 - (i % 64).abs_diff(column)) < 8 && (8..24).contains(&(i / 64));
        [if inside { 1.0 } else { 0.0 }; 3]
    };
    Environment { width: 64, height: 32, texels: (0..64 * 32).map(texel).collect() }
}

#[test]
fn a_ball_under_a_white_sky_is_white_all_over() {
    let equal = Lighting { weighting: Weighting::Equal, ..PLAIN };
    let white = Environment::white();
    let [exact, equal] = colours(&ball(), [(&white, PLAIN), (&white, equal)]);
    for colour in &exact {
        assert!(colour.iter().all(|c| (c - 1.0).abs() < 0.02), "{colour:?}");
    }
    assert_ne!(exact, equal, "weights matter");
}

#[test]
fn light_comes_from_where_the_map_has_it_and_turns_with_it() {
    let ball = ball();
    let right = stripe(48);
    let [plain, turned, level] = colours(
        &ball,
        [(&right, PLAIN), (&right, Lighting { turn: 90.0, ..PLAIN }), (&right, Lighting { up: Up::Z, ..PLAIN })],
    );
    let brightest = |colours: &Colours| {
        let most = (0..colours.len()).max_by(|&a, &b| colours[a][0].total_cmp(&colours[b][0])).unwrap();
        ball.normals[most].map(|c| f64::from(c) / 32_768.0)
    };
    let [x, y, z] = brightest(&plain);
    assert!(x > 0.95, "three quarters across is +x: {x}, {y}, {z}");
    let [x, y, z] = brightest(&turned);
    assert!(z < -0.95, "+x turned a quarter counter-clockwise about y is -z: {x}, {y}, {z}");
    let [x, y, z] = brightest(&level);
    assert!(x > 0.95, "x stays where z is up: {x}, {y}, {z}");
    let [top] = colours(&ball, [(&Environment { width: 2, height: 1, texels: vec![[1.0; 3]; 2] }, PLAIN)]);
    assert!(top.iter().all(|c| (c[1] - 1.0).abs() < 0.02));
}

#[test]
fn colours_are_the_product_that_the_stored_matrix_gives() {
    let surface = surface(Generator::Colonnade);
    let machine = machine();
    let sky = Environment::sky();
    let lighting = Lighting { turn: -33.0, blur: None, ..PLAIN };
    let light = sky.look_up(&machine, SPHERE, &lighting).unwrap();
    let mut matrix = Matrix::open(&machine, &surface, SPHERE, 1).unwrap();
    assert!(matrix.light(&light, &mut Colours::new()).is_err(), "nothing is done yet");
    finish(&mut matrix, SPHERE);
    let mut colours = Colours::new();
    matrix.light(&light, &mut colours).unwrap();
    let stored = Stored::of(&mut matrix, &surface, SPHERE, 1).unwrap();
    for (vertex, colour) in colours.iter().enumerate() {
        let normal = surface.normals[vertex].map(i64::from);
        for (channel, found) in colour.iter().enumerate() {
            let entry = |j: usize| {
                let dot: i64 = (0..3).map(|axis| normal[axis] * i64::from(light.units[j][axis])).sum();
                let open = !stored.is_occluded(surface.position_of[vertex], j as u32);
                if open { (dot >> 15).max(0) } else { 0 }
            };
            let sum: u128 =
                (0..light.values.len()).map(|j| entry(j) as u128 * u128::from(light.values[j][channel])).sum();
            let expected = libm::scalbn(sum as f64, -light.shift[channel]);
            assert!((f64::from(*found) - expected).abs() <= expected * 1e-7, "vertex {vertex}: {expected}");
        }
    }
}

#[test]
fn a_blur_spreads_light_over_the_map() {
    let ball = ball();
    let sun = stripe(48);
    let [sharp, soft] = colours(&ball, [(&sun, PLAIN), (&sun, Lighting { blur: Some(30.0), ..PLAIN })]);
    let mean = |colours: &Colours| colours.iter().map(|c| f64::from(c[0])).sum::<f64>() / colours.len() as f64;
    let most = |colours: &Colours| colours.iter().map(|c| c[0]).fold(0.0, f32::max);
    assert!(most(&soft) < 0.95 * most(&sharp));
    assert!((mean(&soft) / mean(&sharp) - 1.0).abs() < 0.05, "{} and {}", mean(&soft), mean(&sharp));
}

/// The mean over the sphere of what directions bring.
fn brought(environment: &Environment, sphere: Sphere, lighting: &Lighting) -> f64 {
    let light = environment.look_up(&machine(), sphere, lighting).unwrap();
    let sum: u64 = light.values.iter().map(|value| u64::from(value[0])).sum();
    // A sum over cosines is four times as much, in units of 2^-15.
    libm::scalbn(sum as f64, 13 - light.shift[0])
}

#[test]
fn the_filter_of_the_sphere_keeps_the_light_that_the_filter_of_the_map_gains_at_the_poles() {
    let sphere = Sphere::Healpix { order: 3 };
    let map = Lighting { filter: Filter::Map, ..Lighting::DEFAULT };
    // A sun of ten degrees at an angle from the zenith.
    for (degrees, gain) in [(0.0, 1.45..1.6), (90.0, 0.98..1.02)] {
        let (s, c) = libm::sincos(degrees * std::f64::consts::PI / 180.0);
        let lit = |i: u32| {
            let (row, column) = (f64::from(i / 360) + 0.5, f64::from(i % 360) + 0.5);
            let (level, height) = libm::sincos(row * std::f64::consts::PI / 180.0);
            let along = libm::cos((column - 100.0) * std::f64::consts::PI / 180.0);
            c * height + s * level * along > libm::cos(5.0 * std::f64::consts::PI / 180.0)
        };
        let texels = (0..360 * 180).map(|i| [if lit(i) { 40.0 } else { 0.0 }; 3]).collect();
        let sun = Environment { width: 360, height: 180, texels };
        let [whole, kept, gained] =
            [sun.mean()[0], brought(&sun, sphere, &Lighting::DEFAULT), brought(&sun, sphere, &map)];
        assert!((kept / whole - 1.0).abs() < 0.02, "{degrees}: {kept} of {whole}");
        assert!(gain.contains(&(gained / whole)), "{degrees}: {gained} of {whole}");
    }
}

//! The matrix is what the definition says, however it came about.

use sightlines_backend_cpu::{Config, CpuBackend, Simd};
use sightlines_kernels::random;
use sightlines_kernels::vertex_visibility::oracle::word;
use sightlines_visibility::ambient::file::Stored;
use sightlines_visibility::ambient::{Matrix, Sphere, Surface};
use sightlines_visibility::scene::Generator;

use super::{bumpy, finish, machine, surface};

const LEVEL_2: Sphere = Sphere::Octahedron { level: 2 };
const LEVEL_3: Sphere = Sphere::Octahedron { level: 3 };

fn words(surface: &Surface, sphere: Sphere, bias: u32) -> Vec<u32> {
    let machine = machine();
    let mut matrix = Matrix::open(&machine, surface, sphere, bias).unwrap();
    finish(&mut matrix, sphere);
    matrix.words().unwrap()
}

/// The word of 32 directions of a position, by the definition.
fn defined(surface: &Surface, sphere: Sphere, bias: u32, row: usize, position: u32) -> u32 {
    let directions = sphere.directions();
    let block = &directions[32 * row..directions.len().min(32 * row + 32)];
    word(&surface.mesh, position, block, bias)
}

#[test]
fn small_scenes_are_right_as_a_whole() {
    for (generator, sphere, bias) in [
        (Generator::Box, LEVEL_2, 1),
        (Generator::Quads, LEVEL_2, 0),
        (Generator::Colonnade, LEVEL_2, 1),
        (Generator::Box, Sphere::Healpix { order: 1 }, 40),
        (Generator::Quads, Sphere::Octahedron { level: 0 }, 0),
    ] {
        let surface = surface(generator);
        let count = surface.positions();
        let found = words(&surface, sphere, bias);
        let rows = sphere.count().div_ceil(32) as usize;
        assert_eq!(found.len(), rows * count as usize);
        for row in 0..rows {
            for position in 0..count {
                let expected = defined(&surface, sphere, bias, row, position);
                assert_eq!(
                    found[row * count as usize + position as usize],
                    expected,
                    "{generator:?}, row {row}, {position}"
                );
            }
        }
    }
}

#[test]
fn a_closed_mesh_of_real_size_is_right_in_a_seeded_sample() {
    let surface = bumpy(70_000);
    let count = surface.positions();
    assert!((34_000..36_000).contains(&count) && surface.findings.open_edges == 0);
    let sphere = Sphere::Octahedron { level: 1 };
    let found = words(&surface, sphere, 1);
    let mut occluded = 0;
    for position in (0..20).map(|i| random::below(count, 77, i)) {
        let expected = defined(&surface, sphere, 1, 0, position);
        assert_eq!(found[position as usize], expected, "position {position}");
        occluded += expected.count_ones();
    }
    assert!((100..300).contains(&occluded), "{occluded} of 360 pairs of the sample are occluded");
}

#[test]
fn refined_level_by_level_it_is_the_same_and_what_is_there_stays() {
    let surface = surface(Generator::Colonnade);
    let machine = machine();
    let mut matrix = Matrix::open(&machine, &surface, LEVEL_3, 1).unwrap();
    let whole = words(&surface, LEVEL_3, 1);
    for (target, done) in LEVEL_3.refinements().into_iter().zip([6, 18, 66, 258]) {
        assert!(finish(&mut matrix, target) > 0);
        assert_eq!(matrix.done(), done);
        let found = matrix.words().unwrap();
        let rows = (done / 32) as usize * surface.positions() as usize;
        assert_eq!(found[..rows], whole[..rows], "whole words at {done} directions");
        let rest = (1 << (done % 32)) - 1;
        let last = found[rows..].iter().zip(&whole[rows..]);
        assert!({ last }.all(|(found, whole)| *found == whole & rest), "the last word at {done} directions");
    }
    assert_eq!(finish(&mut matrix, LEVEL_3), 0, "nothing is left to do");
}

#[test]
fn a_matrix_that_was_interrupted_anywhere_goes_on_to_the_same_end() {
    let surface = surface(Generator::Quads);
    let machine = machine();
    let whole = words(&surface, LEVEL_3, 1);
    for blocks in [1, 2, 3, 5] {
        let mut first = Matrix::open(&machine, &surface, LEVEL_3, 1).unwrap();
        (0..blocks).for_each(|_| assert!(first.advance(LEVEL_3).unwrap()));
        let stored = Stored::of(&mut first, &surface, LEVEL_3, 1).unwrap();
        drop(first);
        let mut second = Matrix::open(&machine, &surface, LEVEL_3, 1).unwrap();
        second.restore(stored.done, &stored.words).unwrap();
        finish(&mut second, LEVEL_3);
        assert!(second.words().unwrap() == whole, "after {blocks} blocks");
        assert!(second.restore(258, &stored.words[1..]).is_err());
    }
}

#[test]
fn a_matrix_that_outgrows_a_binding_is_divided_and_does_not_show_it() {
    // 35,000 positions of 513 words are more than half a binding.
    let (surface, machine) = (bumpy(70_000), machine());
    let coarse = Sphere::Octahedron { level: 0 };
    let mut divided = Matrix::open(&machine, &surface, Sphere::Octahedron { level: 6 }, 1).unwrap();
    finish(&mut divided, coarse);
    let words = divided.words().unwrap();
    assert!(words == self::words(&surface, coarse, 1));
    let mut again = Matrix::open(&machine, &surface, Sphere::Octahedron { level: 6 }, 1).unwrap();
    again.restore(6, &words).unwrap();
    assert!(again.words().unwrap() == words);
}

#[test]
fn neither_threads_nor_simd_show() {
    let surface = surface(Generator::Quads);
    let expected = words(&surface, LEVEL_2, 1);
    let levels = Simd::available().into_iter().map(|simd| Config { simd: Some(simd), ..Config::default() });
    for config in levels.chain([Config { threads: 3, ..Config::default() }]) {
        let machine = CpuBackend::new(config);
        let mut matrix = Matrix::open(&machine, &surface, LEVEL_2, 1).unwrap();
        finish(&mut matrix, LEVEL_2);
        assert!(matrix.words().unwrap() == expected, "{}", machine.simd().name());
    }
}

#[test]
fn rows_of_chosen_positions_are_those_of_all() {
    let surface = surface(Generator::Colonnade);
    let machine = machine();
    let whole = words(&surface, LEVEL_2, 1);
    let chosen: Vec<u32> = (0..surface.positions()).rev().step_by(3).collect();
    let mut matrix = Matrix::open_some(&machine, &surface, &chosen, LEVEL_2, 1).unwrap();
    finish(&mut matrix, LEVEL_2);
    for (at, word) in matrix.words().unwrap().into_iter().enumerate() {
        let (row, place) = (at / chosen.len(), chosen[at % chosen.len()] as usize);
        assert_eq!(word, whole[row * surface.positions() as usize + place], "row {row}, position {place}");
    }
    assert!(Matrix::open_some(&machine, &surface, &[3, 3], LEVEL_2, 1).is_err(), "twice");
    assert!(Matrix::open_some(&machine, &surface, &[u32::MAX], LEVEL_2, 1).is_err(), "not there");
}

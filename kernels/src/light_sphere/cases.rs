//! All seven levels, and rotations of lattice and equal-area directions.

use glam::IVec4;
use sightlines_backend::{Case, Expected, Job, Size};

use super::{LightSphere, MAX_LEVEL, Rotation, count, healpix, oracle};
use crate::random;

pub(super) fn all() -> Vec<Case> {
    let name = |level: u32| format!("level_{level}");
    let size = |level: u32| if level == MAX_LEVEL { Size::Real } else { Size::Small };
    let mut cases: Vec<Case> = (0..=MAX_LEVEL).map(|s| level(&name(s), size(s), s)).collect();
    cases.extend([
        turn("turned_by_nothing", || Rotation::IDENTITY, || lattice(2)),
        turn("quarter_turn", quarter, || lattice(3)),
        turn("skew_turn", skew, || lattice(4)),
        turn("equal_areas_turned", skew, || healpix(2)),
        turn("longest_and_shortest", skew, extremes),
        turn("none_turned", skew, Vec::new),
    ]);
    cases
}

fn lattice(level: u32) -> Vec<oracle::Direction> {
    oracle::octahedron(level).into_iter().map(|(d, _)| d).collect()
}

fn quarter() -> Rotation {
    Rotation::new([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]).expect("a rotation")
}

/// By the Pythagorean triple 3, 4, 5 about z, then by 5, 12, 13 about x.
fn skew() -> Rotation {
    let (c, s, d, t) = (0.6, 0.8, 5.0 / 13.0, 12.0 / 13.0);
    Rotation::new([[c, -s, 0.0], [d * s, d * c, -t], [t * s, t * c, d]]).expect("a rotation")
}

/// Components up to ±2^15, and vectors of one unit.
fn extremes() -> Vec<oracle::Direction> {
    let component = |i: u32| [-32_768, -1, 0, 1, 2, 32_767, 32_768][random::below(7, 3, i) as usize];
    (0..500).map(|i| [0, 1, 2].map(|axis| component(3 * i + axis))).filter(|d| *d != [0; 3]).collect()
}

/// Words of vectors whose fourth component is given too.
fn words(vectors: impl IntoIterator<Item = [i32; 4]>) -> Vec<u32> {
    vectors.into_iter().flatten().map(|c| c as u32).collect()
}

fn level(name: &str, size: Size, level: u32) -> Case {
    // One direction past the end shows that nothing is written there.
    let job = move || {
        let mut job = Job::new();
        let directions = job.zeroed("directions", u64::from(count(level)) + 1);
        LightSphere::new()?.record_level(&mut job, level, directions)?;
        job.read("directions", directions.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let all = oracle::octahedron(level).into_iter().map(|([x, y, z], n)| [x, y, z, n]);
        vec![Expected::Whole(words(all.chain([[0; 4]])))]
    };
    Case::new(name, size, job, expected).probes([0, 1, 2, 3, 8 * count(level) / 5, 4 * count(level) - 2])
}

fn turn(name: &str, rotation: fn() -> Rotation, make: fn() -> Vec<oracle::Direction>) -> Case {
    let job = move || {
        let mut job = Job::new();
        let mut given: Vec<IVec4> = make().into_iter().map(|[x, y, z]| IVec4::new(x, y, z, 7)).collect();
        let count = given.len() as u32;
        given.push(IVec4::ONE);
        let given = job.slice("given", &given);
        let turned = job.zeroed("turned", given.len());
        LightSphere::new()?.record_turn(&mut job, rotation(), count, given, turned)?;
        job.read("turned", turned.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let turned = make().into_iter().map(|d| oracle::turned(d, rotation().rows())).map(|[x, y, z]| [x, y, z, 0]);
        vec![Expected::Whole(words(turned.chain([[0; 4]])))]
    };
    Case::new(name, Size::Small, job, expected).probes([0, 1, 2, 3])
}

//! Every byte of a table, words of every kind through other operations, and half-planes to triangles to hidden sets, as
//! the paper goes: three half-planes by AND, triangles by OR, each equal to the grid's definition. A table for three
//! masks has 16 MiB, so only cases of two are small.

use sightlines_backend::host::Buffer;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{OpMap, Truth, oracle, table_words};
use crate::backprojection::oracle::backproject;
use crate::exact::oracle::line::half_plane;
use crate::grid::{Receivers, Samples, Triangle, hidden_set};
use crate::random;
use crate::triangles::Family;

const MAJORITY: Truth = Truth(0b1110_1000);
const PARITY: Truth = Truth(0b1001_0110);
const FIRST_WITHOUT_SECOND: Truth = Truth(0b0010_0010);

pub(super) fn all() -> Vec<Case> {
    vec![
        words("one_word", Truth::OR, 2, 1),
        words("either", Truth::OR, 2, 257),
        words("one_or_other", PARITY, 2, 1000),
        words("first_without_second", FIRST_WITHOUT_SECOND, 2, 1000),
        words("and", Truth::AND, 3, 1000),
        words("or", Truth::OR, 3, 257),
        words("majority", MAJORITY, 3, 1000),
        words("parity", PARITY, 3, 100_000),
        triangles(),
        table("table_and", Truth::AND),
        table("table_parity", PARITY),
    ]
}

/// All zeros, all ones, and random words, each with each.
fn mask(seed: u32, count: usize) -> Vec<u32> {
    let word = |i: u32| match random::below(4, seed, i) {
        0 => 0,
        1 => u32::MAX,
        _ => random::word(seed + 9, i),
    };
    (0..count as u32).map(word).collect()
}

fn words(name: &str, operation: Truth, operands: usize, count: usize) -> Case {
    let masks = move || (1..=operands as u32).map(move |seed| mask(seed, count)).collect::<Vec<_>>();
    let job = move || {
        let kernel = OpMap::new()?;
        let mut job = Job::new();
        let inputs: Vec<Buffer<[u32]>> = masks().iter().map(|words| job.slice("mask", words)).collect();
        let table = kernel.table(&mut job, operation, operands);
        let combined = job.zeroed("combined", count as u64);
        kernel.record(&mut job, table, &inputs, combined)?;
        job.read("combined", combined.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let masks = masks();
        let of = |operand: usize, word: usize| masks.get(operand).map_or(0, |mask| mask[word]);
        let answer = |w| oracle::combine(operation, of(0, w), of(1, w), of(2, w));
        vec![Expected::Whole((0..count).map(answer).collect())]
    };
    let probes = [0, 1, 2, 255, 256].into_iter().filter(|probe| (*probe as usize) < count);
    let size = if operands == 2 { Size::Small } else { Size::Real };
    Case::new(name, size, job, expected).probes(probes)
}

fn table(name: &str, operation: Truth) -> Case {
    let job = move || {
        let mut job = Job::new();
        let table = OpMap::new()?.table(&mut job, operation, 3);
        job.read("table", table.id());
        Ok(job)
    };
    let words = 0..table_words(3);
    let expected =
        move |_: &_| vec![Expected::Whole(words.clone().map(|word| oracle::table_word(operation, word)).collect())];
    Case::new(name, Size::Real, job, expected).probes(vec![0, 63, 64, 2_105_408, 4_194_303])
}

const LIGHT: Samples = Samples { origin: [-1000, -900], step: [63, 58], columns: 32, rows: 32 };
const RECEIVERS: Receivers =
    Receivers { origin: [-1500, -1100], step: [290, 370], height: 20_000, columns: 11, rows: 7 };

/// Words of the sets of all receivers.
fn set_words() -> u64 {
    u64::from(RECEIVERS.count() * LIGHT.words())
}

/// Four triangles, all between light and receivers.
fn occluders() -> Vec<Triangle> {
    let of = |family: Family, seed| family.triangles(1, &LIGHT, &RECEIVERS, seed);
    [of(Family::LightSized, 3), of(Family::OnSampleRays, 4), of(Family::NearPlanes, 5), of(Family::Leaves, 6)].concat()
}

/// For each receiver, the samples inside one edge of a triangle; none where it is seen edge-on.
fn half_planes(triangle: &Triangle, edge: usize) -> Vec<u32> {
    let mut words = Vec::new();
    for receiver in 0..RECEIVERS.count() {
        let line = backproject(RECEIVERS.at(receiver), triangle).map(|found| found.edges[edge]);
        let inside = |sample: u32| {
            let [u, v, _] = LIGHT.at(sample);
            line.is_some_and(|line| half_plane(line, u, v))
        };
        let word = |w: u32| (0..32).map(|bit| u32::from(inside(32 * w + bit)) << bit).sum::<u32>();
        words.extend((0..LIGHT.words()).map(word));
    }
    words
}

fn hidden_by(triangles: &[Triangle]) -> Vec<u32> {
    (0..RECEIVERS.count()).flat_map(|receiver| hidden_set(RECEIVERS.at(receiver), &LIGHT, triangles)).collect()
}

fn triangles() -> Case {
    let job = || {
        let kernel = OpMap::new()?;
        let mut job = Job::new();
        let and = kernel.table(&mut job, Truth::AND, 3);
        let layers: Vec<Buffer<[u32]>> = occluders()
            .iter()
            .map(|triangle| {
                let edges = [0, 1, 2].map(|edge| job.slice("half-planes", &half_planes(triangle, edge)));
                joined(&kernel, &mut job, and, &edges)
            })
            .collect::<Result<_>>()?;
        let or = kernel.table(&mut job, Truth::OR, 3);
        let three = joined(&kernel, &mut job, or, &layers[..3])?;
        let either = kernel.table(&mut job, Truth::OR, 2);
        let hidden = joined(&kernel, &mut job, either, &[three, layers[3]])?;
        for layer in layers {
            job.read("triangle", layer.id());
        }
        job.read("hidden", hidden.id());
        Ok(job)
    };
    let expected = |_: &_| {
        let occluders = occluders();
        let mut sets: Vec<Vec<u32>> = occluders.iter().map(|one| hidden_by(std::slice::from_ref(one))).collect();
        sets.push(hidden_by(&occluders));
        sets.into_iter().map(Expected::Whole).collect()
    };
    Case::new("triangles", Size::Real, job, expected).probes(vec![0, 400, 1200, 2463])
}

fn joined(kernel: &OpMap, job: &mut Job, table: Buffer<[u32]>, masks: &[Buffer<[u32]>]) -> Result<Buffer<[u32]>> {
    let combined = job.zeroed("combined", set_words());
    kernel.record(job, table, masks, combined)?;
    Ok(combined)
}

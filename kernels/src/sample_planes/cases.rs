//! All families of hard triangles, every shape of light, and leaves over a floor at a size where methods are compared.

use sightlines_backend::{Case, Expected, Job, Outputs, Result, Size};

use super::{SamplePlanes, Scene, oracle};
use crate::grid::{Receivers, Samples, Triangle, hidden_set};
use crate::random;
use crate::triangles::Family;

const fn light(columns: u32, rows: u32) -> Samples {
    Samples { origin: [-1000, -900], step: [63, 58], columns, rows }
}

const FEW: Receivers = Receivers { origin: [-1500, -1100], step: [290, 370], height: 20_000, columns: 11, rows: 7 };
const MANY: Receivers = Receivers { origin: [-2000, -2000], step: [20, 20], height: 20_000, columns: 200, rows: 300 };

pub(super) fn all() -> Vec<Case> {
    let mut cases = vec![
        masks("nothing", light(8, 4), Family::Anywhere, 0),
        masks("samples_32", light(8, 4), Family::LightSized, 30),
        masks("samples_64", light(8, 8), Family::LightSized, 30),
        masks("samples_1024", light(32, 32), Family::LightSized, 12),
        additive("additive_closed", light(8, 8), Family::Closed, 24),
        additive("additive_anywhere", light(8, 4), Family::Anywhere, 20),
    ];
    cases.extend(Family::ALL.map(|f| masks(&format!("family_{}", f.name()), light(8, 8), f, 16)));
    cases.push(leaves());
    cases
}

fn masks(name: &str, samples: Samples, family: Family, count: u32) -> Case {
    let triangles = move || triangles(family, count, &samples, &FEW);
    let expected = move |_: &Outputs| vec![Expected::Whole(oracle::sets(&samples, &FEW, &triangles()))];
    let middle = FEW.count() / 2;
    let probes = (0..samples.words()).step_by(5).map(|w| w * FEW.count() + middle);
    Case::new(name, Size::Small, move || job(&samples, &FEW, &triangles(), false), expected).probes(probes)
}

fn additive(name: &str, samples: Samples, family: Family, count: u32) -> Case {
    let triangles = move || triangles(family, count, &samples, &FEW);
    let expected = move |_: &Outputs| {
        let counts = oracle::additive(&samples, &FEW, &triangles());
        vec![Expected::Whole(counts.into_iter().map(|count| count as u32).collect())]
    };
    Case::new(name, Size::Small, move || job(&samples, &FEW, &triangles(), true), expected).probes([0, 30, 38, 76])
}

fn triangles(family: Family, count: u32, samples: &Samples, receivers: &Receivers) -> Vec<Triangle> {
    if count == 0 { Vec::new() } else { family.triangles(count, samples, receivers, 8) }
}

fn job(samples: &Samples, receivers: &Receivers, triangles: &[Triangle], additive: bool) -> Result<Job> {
    let kernel = SamplePlanes::new()?;
    let mut job = Job::new();
    let words: Vec<i32> = triangles.iter().flatten().flatten().copied().collect();
    // A binding holds at least one element.
    let vertices = job.slice("vertices", if words.is_empty() { &[0] } else { &words[..] });
    let scene = Scene { samples: *samples, receivers: *receivers, vertices, triangles: triangles.len() as u32 };
    let planes = if additive { 1 } else { u64::from(samples.words()) };
    let hidden = job.zeroed("hidden", u64::from(receivers.count()) * planes);
    if additive {
        kernel.record_additive(&mut job, scene, hidden)?;
    } else {
        kernel.record(&mut job, scene, hidden)?;
    }
    job.read("hidden", hidden.id());
    Ok(job)
}

/// Two bands of receivers; the oracle looks at a seeded sample of them.
fn leaves() -> Case {
    let samples = light(16, 16);
    let leaves = move || triangles(Family::Leaves, 200, &samples, &MANY);
    let expected = move |_: &Outputs| {
        let leaves = leaves();
        let looks = (0..64).map(|index| random::below(MANY.count(), 14, index));
        let words = looks.flat_map(|receiver| {
            let mask = hidden_set(MANY.at(receiver), &samples, &leaves);
            (0..samples.words()).zip(mask).map(move |(w, word)| (w * MANY.count() + receiver, word))
        });
        vec![Expected::Sample { words: words.collect(), seed: 14 }]
    };
    let centre = MANY.count() / 2 + MANY.columns / 2;
    Case::new("leaves_200", Size::Real, move || job(&samples, &MANY, &leaves(), false), expected)
        .probes((0..8).map(|w| w * MANY.count() + centre))
}

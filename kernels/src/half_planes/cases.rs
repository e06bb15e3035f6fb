//! Triangles on, under and above either plane, and the families of `row_span`, whose masks must be the same.

use sightlines_backend::{Case, Expected, Job, Outputs, Size};

use super::{HalfPlanes, oracle};
use crate::grid::{Faces, Receivers, Samples, Triangle, hidden_set};
use crate::random;
use crate::triangles::{Family, crossing, levels};

fn light(columns: u32, rows: u32) -> Samples {
    Samples { origin: [-1000, -900], step: [63, 58], columns, rows }
}

const FEW: Receivers = Receivers { origin: [-1500, -1100], step: [290, 370], height: 20_000, columns: 11, rows: 7 };
const MANY: Receivers = Receivers { origin: [-2000, -2000], step: [32, 32], height: 20_000, columns: 128, rows: 64 };

pub(super) fn all() -> Vec<Case> {
    let families = |family: Family| move |s: &Samples, r: &Receivers| family.triangles(16, s, r, 8);
    let mut cases = vec![
        case("nothing", light(32, 32), FEW, |_, _| Vec::new()),
        case("levels", light(32, 32), FEW, |_, r| levels(r.height)),
        case("crossing_1024", light(32, 32), FEW, |s, r| crossing(30, s, r)),
        case("crossing_256", light(16, 16), FEW, |s, r| crossing(30, s, r)),
        case("crossing_64", light(8, 8), FEW, |s, r| crossing(60, s, r)),
        case("crossing_32", light(8, 4), FEW, |s, r| crossing(60, s, r)),
        case_by(Faces::Front, "front_levels", light(32, 32), FEW, |_, r| levels(r.height)),
        case_by(Faces::Front, "front_crossing", light(16, 16), FEW, |s, r| crossing(30, s, r)),
        case_by(Faces::Front, "front_64", light(8, 8), FEW, |s, r| crossing(60, s, r)),
        case_by(Faces::Front, "front_32", light(8, 4), FEW, |s, r| crossing(60, s, r)),
        case_by(Faces::Front, "front_through_samples", light(32, 32), FEW, |s, _| through_samples(s)),
        case("through_samples", light(32, 32), FEW, |s, _| through_samples(s)),
    ];
    cases.extend(Family::ALL.map(|f| case(&format!("family_{}", f.name()), light(32, 32), FEW, families(f))));
    cases.push(floor());
    cases
}

/// Triangles that stand on the source plane with an edge through samples: their own plane holds a row of them.
fn through_samples(samples: &Samples) -> Vec<Triangle> {
    let at = |sample: u32| samples.at(sample);
    let count = samples.count();
    let pick = |i: u32| at(random::below(count, 13, i));
    (0..24).map(|i| [pick(2 * i), pick(2 * i + 1), [0, 100 * (i as i32 - 12), 9000]]).collect()
}

fn case(
    name: &str,
    samples: Samples,
    receivers: Receivers,
    make: impl Fn(&Samples, &Receivers) -> Vec<Triangle> + Clone + Send + Sync + 'static,
) -> Case {
    case_by(Faces::Both, name, samples, receivers, make)
}

fn case_by(
    faces: Faces,
    name: &str,
    samples: Samples,
    receivers: Receivers,
    make: impl Fn(&Samples, &Receivers) -> Vec<Triangle> + Clone + Send + Sync + 'static,
) -> Case {
    let triangles = make.clone();
    let job = move || job(faces, &samples, &receivers, &triangles(&samples, &receivers));
    let expected = move |_: &Outputs| {
        let triangles = make(&samples, &receivers);
        vec![Expected::Whole(oracle::sets_by(faces, &samples, &receivers, &triangles))]
    };
    let middle = receivers.count() / 2;
    Case::new(name, Size::Small, job, expected)
        .probes((0..samples.words()).step_by(5).map(|w| w * receivers.count() + middle))
}

fn job(
    faces: Faces,
    samples: &Samples,
    receivers: &Receivers,
    triangles: &[Triangle],
) -> sightlines_backend::Result<Job> {
    let kernel = HalfPlanes::with_faces(samples, faces)?;
    let mut job = Job::new();
    let words: Vec<i32> = triangles.iter().flatten().flatten().copied().collect();
    // A binding holds at least one element.
    let vertices = job.slice("vertices", if words.is_empty() { &[0] } else { &words[..] });
    let hidden = job.zeroed("hidden", u64::from(receivers.count()) * u64::from(samples.words()));
    kernel.record(&mut job, receivers, vertices, 0..triangles.len() as u32, hidden)?;
    job.read("hidden", hidden.id());
    Ok(job)
}

/// Posts that stand in the receivers' plane, at a size where the kernel is used; the oracle looks at a seeded sample.
fn floor() -> Case {
    let samples = light(32, 32);
    let posts = move || crossing(60, &samples, &MANY);
    let expected = move |_: &Outputs| {
        let posts = posts();
        let looks = (0..48).map(|index| random::below(MANY.count(), 14, index));
        let words = looks.flat_map(|receiver| {
            let mask = hidden_set(MANY.at(receiver), &samples, &posts);
            (0..samples.words()).zip(mask).map(move |(w, word)| (w * MANY.count() + receiver, word))
        });
        vec![Expected::Sample { words: words.collect(), seed: 14 }]
    };
    let centre = MANY.count() / 2 + MANY.columns / 2;
    Case::new("posts_60", Size::Real, move || job(Faces::Both, &samples, &MANY, &posts()), expected)
        .probes((0..32).step_by(5).map(|w| w * MANY.count() + centre))
}

//! The work of several runs as curves: over the light's size, or over whatever else varies.

use sightlines_visibility::compare::Run;
use sightlines_visibility::plot::{Curve, Plot};

/// A quantity of a run, as axis and in names.
type Quantity = (&'static str, fn(&Run) -> f64);

const QUANTITIES: [Quantity; 4] = [
    ("side of the light, in scene units", |run| run.light_side),
    ("receivers a side", |run| f64::from(run.resolution)),
    ("samples", |run| f64::from(run.samples)),
    ("triangles", |run| run.triangles as f64),
];

/// Lane-operations of every run that has them, by method, over the first quantity that is not the same in all; what
/// else varies is named beside the curve.
pub(super) fn plot(runs: &[Run], scene: &str) -> Plot {
    let counted: Vec<&Run> = runs.iter().filter(|run| run.work.lane_ops.is_some()).collect();
    let varies = |(_, of): &Quantity| counted.iter().any(|run| of(run) != of(counted[0]));
    let mut varying = QUANTITIES.into_iter().filter(varies);
    let axis = varying.next().unwrap_or(QUANTITIES[0]);
    let others: Vec<Quantity> = varying.collect();
    let name = |run: &Run| {
        let rest = others.iter().map(|(what, of)| format!(", {} {}", of(run), what.split(',').next().unwrap_or(what)));
        run.method.to_owned() + &rest.collect::<String>()
    };
    let mut curves: Vec<Curve> = Vec::new();
    for run in counted {
        let name = name(run);
        let point = [axis.1(run), run.work.lane_ops.unwrap_or(0) as f64];
        match curves.iter_mut().find(|curve| curve.name == name) {
            Some(curve) => curve.points.push(point),
            None => curves.push(Curve { name, points: vec![point] }),
        }
    }
    curves.iter_mut().for_each(|curve| curve.points.sort_by(|a, b| a[0].total_cmp(&b[0])));
    Plot { title: scene.to_owned(), axes: [axis.0.to_owned(), "lane-operations".to_owned()], curves }
}

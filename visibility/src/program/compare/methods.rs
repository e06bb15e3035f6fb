//! The methods that are compared, one after the other, on one request.

use std::io::Write;
use std::time::Instant;

use sightlines_backend::Backend;
use sightlines_visibility::compare::{Added, Run, maps, projections, tables, volumes};
use sightlines_visibility::image::Share;
use sightlines_visibility::setup::Setup;
use sightlines_visibility::shadows::{Bake, Request, Work, bake};
use sightlines_visibility::simplify::{Simplified, Target, simplify, tolerance};

use super::CompareArgs;
use crate::program::Failure;
use crate::program::progress::Progress;

/// What the methods gave on one request.
#[derive(Default)]
pub(super) struct Methods {
    /// A row each, sampling first.
    pub(super) rows: Vec<Run>,
    /// Sampling, then each method that adds up, and how far it is off.
    pub(super) panels: Vec<Share>,
    /// Bits in which projections differ from sampling: none, if all is well.
    pub(super) bits: u64,
}

/// Simplified scenes of a setup, one for each target.
pub(super) fn coarser(args: &CompareArgs, setup: &Setup) -> sightlines_visibility::Result<Vec<Simplified>> {
    let limit = tolerance(&setup.scene, &setup.lights[0].rect, setup.sampling.count, &setup.receiver);
    args.simplify.iter().map(|target: &Target| simplify(&setup.scene, *target, limit)).collect()
}

impl Methods {
    /// Runs them all.
    pub(super) fn run(
        backend: &dyn Backend,
        args: &CompareArgs,
        setup: &Setup,
        coarser: &[Simplified],
        out: &mut dyn Write,
    ) -> Result<Self, Failure> {
        let request = setup.request();
        let mut methods = Methods::default();
        let (ours, row) = timed("sampling", &request, |progress| bake(backend, &request, progress))?;
        methods.rows.push(Run { work: ours.work, differ: Some(0.0), ..row });
        methods.panels.push(share(&request, ours.visible.clone()));
        if !args.no_projections {
            let (theirs, row) = timed("projections", &request, |progress| projections(backend, &request, progress))?;
            methods.bits = differing(&ours, &theirs);
            methods.sets(&ours, &theirs, row);
        }
        let (theirs, row) = timed("tables", &request, |progress| tables(backend, &request, progress))?;
        methods.sets(&ours, &theirs, row);
        let (added, row) = timed("volumes", &request, |progress| volumes(backend, &request, progress))?;
        methods.adds(&ours, added, row, &request);
        let (added, row) = timed("maps", &request, |progress| maps(&request, progress))?;
        methods.adds(&ours, added, row, &request);
        for simplified in coarser {
            let request = Request { triangles: simplified.scene.triangles(), ..request.clone() };
            let (theirs, row) = timed("simplified", &request, |progress| bake(backend, &request, progress))?;
            methods.sets(&ours, &theirs, row);
            let Simplified { before, moved, hash, .. } = simplified;
            writeln!(
                out,
                "simplified {before} to {} triangles, moved by {moved:.3e} units at most",
                request.triangles.len()
            )?;
            writeln!(out, "           {hash}")?;
        }
        Ok(methods)
    }

    /// A row of a method that gives sets.
    fn sets(&mut self, ours: &Bake, theirs: &Bake, row: Run) {
        let all = ours.sets.texels() as f64 * f64::from(ours.sets.samples);
        let differ = Some(differing(ours, theirs) as f64 / all);
        self.rows.push(Run { work: theirs.work, differ, error: error(ours, &theirs.visible), ..row });
    }

    /// A row and the panels of a method that adds up.
    fn adds(&mut self, ours: &Bake, theirs: Added, row: Run, request: &Request) {
        let Added { visible, work } = theirs;
        self.rows.push(Run { work, error: error(ours, &visible), ..row });
        let apart = ours.visible.iter().zip(&visible).map(|(a, b)| a.abs_diff(*b)).collect();
        self.panels.extend([share(request, visible), share(request, apart)]);
    }

    /// Prints a line for each.
    pub(super) fn report(&self, args: &CompareArgs, out: &mut dyn Write) -> Result<(), Failure> {
        let head = ["method", "triangles", "pairs", "lane-ops", "differ", "error", "time"];
        let [method, triangles, pairs, ops, differ, error, time] = head;
        writeln!(out, "{method:<12} {triangles:>9} {pairs:>12} {ops:>14} {differ:>9} {error:>9} {time:>10}")?;
        for Run { method, triangles, work, differ, error, seconds, .. } in &self.rows {
            let ops = work.lane_ops.map_or_else(|| "-".to_owned(), |ops| ops.to_string());
            let differ = differ.map_or_else(|| "-".to_owned(), |differ| format!("{differ:.6}"));
            let pairs = work.pairs;
            writeln!(
                out,
                "{method:<12} {triangles:>9} {pairs:>12} {ops:>14} {differ:>9} {error:>9.6} {seconds:>8.3} s"
            )?;
        }
        if !args.no_projections {
            writeln!(out, "projections differ in {} bits", self.bits)?;
        }
        if let [ours, volumes, _, maps, _] = &self.panels[..] {
            for (name, theirs) in [("volumes", volumes), ("maps", maps)] {
                let pairs = || ours.visible.iter().zip(&theirs.visible);
                let darker = pairs().filter(|(ours, theirs)| theirs < ours).count();
                let lighter = pairs().filter(|(ours, theirs)| theirs > ours).count();
                let most = pairs().map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0);
                writeln!(
                    out,
                    "{name} are too dark at {darker} texels and too light at {lighter}, by {most} samples at most"
                )?;
            }
        }
        Ok(out.flush()?)
    }
}

fn share(request: &Request, visible: Vec<u32>) -> Share {
    Share { resolution: request.resolution, samples: request.samples, visible }
}

/// Bits that are not the same.
fn differing(a: &Bake, b: &Bake) -> u64 {
    a.sets.masks.iter().zip(&b.sets.masks).map(|(a, b)| u64::from((a ^ b).count_ones())).sum()
}

/// How far shares of the light are apart, in the mean.
fn error(ours: &Bake, theirs: &[u32]) -> f64 {
    let sum: u64 = ours.visible.iter().zip(theirs).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / (theirs.len() as f64 * f64::from(ours.sets.samples))
}

/// Length of the light's first side.
pub(super) fn light_side(request: &Request) -> f64 {
    request.light.u.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// A method's result, and a row with its time and still without its work.
fn timed<T>(
    method: &'static str,
    request: &Request,
    work: impl FnOnce(&mut dyn FnMut(f32)) -> sightlines_visibility::Result<T>,
) -> Result<(T, Run), Failure> {
    let progress = Progress::new(method.to_owned());
    let start = Instant::now();
    let result = work(&mut |share| progress.show(share))?;
    let run = Run {
        resolution: request.resolution,
        samples: request.samples,
        light_side: light_side(request),
        triangles: request.triangles.len(),
        method,
        work: Work::default(),
        differ: None,
        error: 0.0,
        seconds: start.elapsed().as_secs_f64(),
    };
    Ok((result, run))
}

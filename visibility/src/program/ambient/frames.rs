//! Frames of a motion, each with a picture: what moves as a whole keeps its matrix, and what is only shifted its
//! colours.

use std::io::Write;
use std::path::PathBuf;

use sightlines_backend::Backend;
use sightlines_visibility::Result;
use sightlines_visibility::ambient::{Colours, Environment, Lighting, Moving, Step, Surface, Turn, View};
use sightlines_visibility::error::Place;
use sightlines_visibility::scene::{Camera, Motion, Scene};

use super::args::AmbientArgs;
use super::{count, exposure, pictures};
use crate::program::Failure;

/// The scenes of all frames, evenly over the motion.
pub(super) struct Frames {
    motion: Motion,
    count: u32,
}

impl Frames {
    /// What the command line asks for, if it asks for frames.
    pub(super) fn new(args: &AmbientArgs) -> Result<Option<Self>> {
        let Some(count) = args.frames else { return Ok(None) };
        let motion = match (&args.source.motion, &args.source.model) {
            (Some(motion), _) => motion.clone(),
            (None, Some(model)) => Motion::load(model)?,
            (None, None) => {
                let what = "the scene does not move";
                let remedy = "give --motion, or a glTF model with an animation";
                return Err(Place::default().element("--frames").error(what, remedy));
            }
        };
        Ok(Some(Frames { motion, count }))
    }

    /// The scene of a frame.
    pub(super) fn at(&self, frame: u32) -> Result<Scene> {
        self.motion.at(self.motion.duration() * f64::from(frame) / f64::from(self.count))
    }

    /// Shades frame after frame and takes its picture.
    pub(super) fn run(
        &self,
        args: &AmbientArgs,
        backend: &dyn Backend,
        cameras: &[(Camera, PathBuf)],
        (environment, is_white): (&Environment, bool),
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let mut white = args.white.or(is_white.then_some(1.0));
        let budget = args.budget.map(|budget| budget.saturating_mul(1_000_000));
        let mut moving = Moving::new(backend, args.sphere(), args.bias, budget);
        let mut before: Option<(Step, Colours)> = None;
        let mut total = Total::default();
        for (frame, (camera, path)) in (0..self.count).zip(cameras) {
            let scene = self.at(frame)?;
            let surface = Surface::new(&scene)?;
            let step = moving.step(&scene, &surface)?;
            let same = |(known, _): &(Step, Colours)| Step { pairs: 0, ..*known } == Step { pairs: 0, ..step };
            let (how, colours) = match before.take().filter(same) {
                Some((_, colours)) => ("as before".to_owned(), colours),
                None => {
                    let lighting = Lighting { pose: step.pose, ..args.lighting() };
                    let mut colours = Colours::new();
                    moving.light(&environment.look_up(backend, step.sphere, &lighting)?, &mut colours)?;
                    (describe(&step, frame, cameras), colours)
                }
            };
            // All frames have the exposure of the first.
            let white = *white.get_or_insert_with(|| exposure(&colours));
            let view = View::new(backend, &surface, camera, args.size)?;
            pictures::write(args, (&view, path), &surface, (&colours, white))?;
            writeln!(out, "frame      {}: {}, {how}, {} pairs", path.display(), step.sphere, step.pairs)?;
            total.matrices += u32::from(step.matrix_of == frame);
            total.pairs += step.pairs;
            before = Some((step, colours));
        }
        writeln!(out, "matrices   {} for {} frames", total.matrices, self.count)?;
        if args.counts { count(&moving.work(), total.pairs, out) } else { Ok(()) }
    }
}

/// What all frames took.
#[derive(Default)]
struct Total {
    matrices: u32,
    pairs: u64,
}

/// Whose matrix a frame has.
fn describe(step: &Step, frame: u32, cameras: &[(Camera, PathBuf)]) -> String {
    let of = cameras[step.matrix_of as usize].1.file_name().unwrap_or_default().display();
    match step {
        Step { matrix_of, .. } if *matrix_of == frame => "a new matrix".to_owned(),
        Step { pose: Turn::NONE, .. } => format!("the matrix of {of}"),
        Step { pose, .. } => format!("the matrix of {of} turned by {:.2} degrees", pose.degrees()),
    }
}

//! Frames of a motion: every one has a matrix of its own, of the level that its budget allows.
//!
//! "Ambient occlusion by occlusion queries", sections 4.2 and 6. What is only shifted keeps its colours; what turns or
//! bends needs a new matrix, and no structure is built for it.

use std::io::Write;
use std::path::PathBuf;

use sightlines_backend::Backend;
use sightlines_visibility::Result;
use sightlines_visibility::ambient::{Colours, Environment, Matrix, Sphere, Surface, View};
use sightlines_visibility::error::Place;
use sightlines_visibility::scene::{Camera, Motion, Scene};

use super::args::AmbientArgs;
use super::{exposure, pictures};
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
        let mut before: Option<(Surface, Colours)> = None;
        for (frame, (camera, path)) in (0..self.count).zip(cameras) {
            let surface = Surface::new(&self.at(frame)?)?;
            let sphere = args
                .budget
                .map_or(args.sphere(), |budget| args.sphere().within(budget.saturating_mul(1_000_000), &surface));
            let same = |(known, _): &(Surface, Colours)| known.mesh == surface.mesh && known.normals == surface.normals;
            let (colours, how) = match before.take().filter(same) {
                Some((_, colours)) => (colours, "as before".to_owned()),
                None => (shade(args, backend, &surface, sphere, environment)?, sphere.to_string()),
            };
            // All frames have the exposure of the first.
            let white = *white.get_or_insert_with(|| exposure(&colours));
            let view = View::new(backend, &surface, camera, args.size)?;
            pictures::write(args, (&view, path), &surface, (&colours, white))?;
            writeln!(out, "frame      {}: {} positions, {how}", path.display(), surface.positions())?;
            before = Some((surface, colours));
        }
        Ok(())
    }
}

fn shade(
    args: &AmbientArgs,
    backend: &dyn Backend,
    surface: &Surface,
    sphere: Sphere,
    environment: &Environment,
) -> Result<Colours> {
    let mut matrix = Matrix::open(backend, surface, sphere, args.bias)?;
    while matrix.advance(sphere)? {}
    let mut colours = Colours::new();
    matrix.light(&environment.look_up(backend, sphere, &args.lighting())?, &mut colours)?;
    Ok(colours)
}

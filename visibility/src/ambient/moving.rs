//! Scenes in motion, frame after frame: a new matrix where something bends or moves against something else, the old one
//! where all of it moves as a whole.
//!
//! Sattler et al. 2004, sections 4.2 and 6. A budget is a number of visits of a position or a
//! triangle by a direction, which every machine counts alike. A new matrix spends no more of it than one frame has, or
//! the coarsest level; frames that keep their matrix refine it with theirs and with what was left before. Invariant: a
//! frame's bits are those of the matrix of the scene in the frame that it was made for, of the finest level that is
//! complete.

use sightlines_backend::Backend;

use super::environment::Intensities;
use super::matrix::{Colours, Matrix, Work};
use super::sphere::Sphere;
use super::surface::Surface;
use super::turn::Turn;
use crate::error::Result;
use crate::scene::Scene;

/// Part of a cell by which corners may stand beside where a motion as a whole takes them.
const SLACK: f64 = 1.0 / 16.0;

/// The matrix of a scene that moves.
pub struct Moving<'a> {
    backend: &'a dyn Backend,
    sphere: Sphere,
    bias: u32,
    budget: Option<u64>,
    frames: u32,
    kept: Option<Kept<'a>>,
    /// Of the matrices before.
    spent: Vec<Work>,
}

struct Kept<'a> {
    matrix: Matrix<'a>,
    frame: u32,
    /// The scene in that frame, its cells, and visits that a direction makes of it.
    scene: Scene,
    cell: f64,
    visits: u64,
}

/// What a frame has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Its directions.
    pub sphere: Sphere,
    /// The frame, from 0, whose matrix it has: an earlier one, or itself.
    pub matrix_of: u32,
    /// How the scene has turned since then: the [`Lighting::pose`](super::Lighting::pose) of this frame.
    pub pose: Turn,
    /// Pairs of a position and a direction that were evaluated for it.
    pub pairs: u64,
}

impl<'a> Moving<'a> {
    /// Nothing has moved yet. Matrices are of `sphere`, or with a budget of as much of it as that allows.
    pub fn new(backend: &'a dyn Backend, sphere: Sphere, bias: u32, budget: Option<u64>) -> Self {
        Moving { backend, sphere, bias, budget, frames: 0, kept: None, spent: Vec::new() }
    }

    /// The next frame: a scene, and its surface.
    ///
    /// # Errors
    ///
    /// Whatever the backend refuses.
    pub fn step(&mut self, scene: &Scene, surface: &Surface) -> Result<Step> {
        let frame = self.frames;
        self.frames += 1;
        let known = self.kept.take().and_then(|kept| match Turn::between(&kept.scene, scene, SLACK * kept.cell) {
            Some(turn) => Some((kept, turn)),
            None => {
                self.spent.push(kept.matrix.work());
                None
            }
        });
        let (mut kept, pose) = match known {
            Some(known) => known,
            None => (self.open(frame, scene, surface)?, Turn::NONE),
        };
        let before = kept.matrix.done();
        let allowed = self.budget.map(|budget| budget.saturating_mul(u64::from(frame - kept.frame) + 1));
        let sphere = kept.refine(self.sphere, allowed)?;
        let pairs = u64::from(kept.matrix.positions()) * u64::from(kept.matrix.done() - before);
        let step = Step { sphere, matrix_of: kept.frame, pose, pairs };
        self.kept = Some(kept);
        Ok(step)
    }

    fn open(&self, frame: u32, scene: &Scene, surface: &Surface) -> Result<Kept<'a>> {
        let matrix = Matrix::open(self.backend, surface, self.sphere, self.bias)?;
        Ok(Kept { matrix, frame, scene: scene.clone(), cell: surface.cell, visits: surface.visits() })
    }

    /// Colours of the last frame, under intensities looked up for its step.
    ///
    /// # Errors
    ///
    /// What [`Matrix::light`] refuses.
    pub fn light(&mut self, intensities: &Intensities, colours: &mut Colours) -> Result<()> {
        self.kept.as_mut().map_or(Ok(()), |kept| kept.matrix.light(intensities, colours))
    }

    /// What all frames took so far.
    pub fn work(&self) -> Work {
        self.spent.iter().copied().chain(self.kept.as_ref().map(|kept| kept.matrix.work())).sum()
    }
}

impl Kept<'_> {
    /// Goes on as far as so many visits in all allow; the answer is the finest level that is complete.
    fn refine(&mut self, sphere: Sphere, allowed: Option<u64>) -> Result<Sphere> {
        let within = allowed.map_or(sphere, |allowed| sphere.within(allowed, self.visits));
        while self.matrix.advance(within)? {}
        let most = allowed.map_or(u64::MAX, |allowed| allowed / self.visits.max(1));
        while u64::from(self.matrix.next_stop(sphere)) <= most && self.matrix.advance(sphere)? {}
        let complete = |sphere: &&Sphere| sphere.count() <= self.matrix.done();
        Ok(sphere.refinements().iter().rev().find(complete).copied().unwrap_or(within))
    }
}

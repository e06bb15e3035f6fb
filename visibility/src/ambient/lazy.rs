//! Lazy evaluation: only what a camera has come to see.
//!
//! Sattler et al. 2004, section 4.1: of the triangles that nobody has seen yet, those that come
//! into view are to be done, and the positions of their corners are evaluated before they are shown; when few are left,
//! all are done at once and the search ends. Triangles are listed and not vertices, because a triangle shows where a
//! corner does not. Invariant: a vertex of a triangle that was seen has the colour that the full matrix gives it.

use sightlines_backend::Backend;

use super::environment::Intensities;
use super::matrix::{Colours, Matrix, Work};
use super::picture::View;
use super::sphere::Sphere;
use super::surface::Surface;
use crate::error::Result;

/// A matrix of the positions that have been needed so far.
pub struct Lazy<'a> {
    backend: &'a dyn Backend,
    surface: &'a Surface,
    sphere: Sphere,
    bias: u32,
    threshold: usize,
    /// Whether a triangle was not seen yet.
    unseen: Vec<bool>,
    /// Whether a position's row is there.
    known: Vec<bool>,
    batches: Vec<Matrix<'a>>,
}

/// What a look found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Triangles that nobody has seen yet, after it.
    pub unseen: usize,
    /// Triangles that it added.
    pub todo: usize,
    /// Positions that were evaluated for them.
    pub positions: usize,
}

impl<'a> Lazy<'a> {
    /// Nothing is seen yet. With fewer than `threshold` triangles unseen, a look takes all that are left.
    pub fn new(backend: &'a dyn Backend, surface: &'a Surface, sphere: Sphere, bias: u32, threshold: usize) -> Self {
        let unseen = vec![true; surface.mesh.triangles.len()];
        let known = vec![false; surface.mesh.vertices.len()];
        Lazy { backend, surface, sphere, bias, threshold, unseen, known, batches: Vec::new() }
    }

    /// Evaluates what a view shows for the first time.
    ///
    /// # Errors
    ///
    /// Whatever the backend refuses.
    pub fn look(&mut self, view: &View) -> Result<Look> {
        let left = self.unseen.iter().filter(|unseen| **unseen).count();
        let all = left < self.threshold;
        let todo: Vec<u32> = match all {
            true => (0..self.unseen.len() as u32).filter(|&t| self.unseen[t as usize]).collect(),
            false => view.seen().into_iter().filter(|&t| self.unseen[t as usize]).collect(),
        };
        let mut positions = Vec::new();
        for &triangle in &todo {
            self.unseen[triangle as usize] = false;
            for corner in self.surface.mesh.triangles[triangle as usize] {
                if !std::mem::replace(&mut self.known[corner as usize], true) {
                    positions.push(corner);
                }
            }
        }
        positions.sort_unstable();
        if !positions.is_empty() {
            let mut batch = Matrix::open_some(self.backend, self.surface, &positions, self.sphere, self.bias)?;
            while batch.advance(self.sphere)? {}
            self.batches.push(batch);
        }
        Ok(Look { unseen: left - todo.len(), todo: todo.len(), positions: positions.len() })
    }

    /// Colours of all vertices that are known; the others are black.
    ///
    /// # Errors
    ///
    /// What [`Matrix::light`] refuses.
    pub fn light(&mut self, intensities: &Intensities) -> Result<Colours> {
        let mut colours = vec![[0.0; 3]; self.surface.vertices.len()];
        self.batches.iter_mut().try_for_each(|batch| batch.light(intensities, &mut colours))?;
        Ok(colours)
    }

    /// What it took so far.
    pub fn work(&self) -> Work {
        self.batches.iter().map(Matrix::work).sum()
    }

    /// Whether a vertex has a colour.
    pub fn knows(&self, vertex: u32) -> bool {
        self.known[self.surface.position_of[vertex as usize] as usize]
    }
}

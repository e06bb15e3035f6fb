//! Ambient occlusion: the matrix against its definition, refinement, light, files, and the program.

mod comparison;
mod files;
mod light;
mod matrix;
mod motion;
mod program;
mod views;

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_visibility::ambient::{Matrix, Sphere, Surface};
use sightlines_visibility::scene::{Generator, bumpy_sphere, generate};

fn machine() -> CpuBackend {
    CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() })
}

fn surface(generator: Generator) -> Surface {
    Surface::new(&generate(generator)).unwrap()
}

/// A closed mesh of about so many triangles.
fn bumpy(triangles: usize) -> Surface {
    Surface::new(&bumpy_sphere(triangles)).unwrap()
}

/// Advances to the end of `sphere`, and counts the blocks.
fn finish(matrix: &mut Matrix<'_>, sphere: Sphere) -> usize {
    (0..).take_while(|_| matrix.advance(sphere).unwrap()).count()
}

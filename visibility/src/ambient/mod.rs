//! Ambient occlusion and light from an environment, at the vertices of a scene.
//!
//! Sattler et al. 2004: directional lights all around, one visibility matrix, any number of
//! environments. A [`Surface`] is a scene on the grid, a [`Matrix`] its visibility on a device, refined block by block;
//! an [`Environment`] becomes [`Intensities`], and the product of both the colours of the vertices. Everything that
//! reaches a result is decided in integers, so it is the same on every machine.

mod blur;
pub mod environment;
pub mod export;
pub mod file;
pub mod lazy;
mod map;
pub mod matrix;
mod moving;
mod part;
pub mod picture;
mod radiance;
pub mod sphere;
mod stage;
pub mod surface;
mod turn;

pub use environment::{Environment, Filter, Intensities, Lighting};
pub use lazy::Lazy;
pub use matrix::{Colours, Matrix};
pub use moving::{Moving, Step};
pub use picture::View;
pub use sphere::{Sphere, Weighting};
pub use surface::Surface;
pub use turn::Turn;

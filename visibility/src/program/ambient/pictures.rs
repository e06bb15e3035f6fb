//! Pictures of a shaded scene: the cameras that the command line asks for, and lazy evaluation along them.

use std::io::Write;
use std::path::PathBuf;

use sightlines_backend::Backend;
use sightlines_kernels::illumination::gamma_table;
use sightlines_kernels::raster::Picture;
use sightlines_visibility::Result;
use sightlines_visibility::ambient::{Colours, Environment, Lazy, Surface, View};
use sightlines_visibility::error::Place;
use sightlines_visibility::queries::files::write_rgb;
use sightlines_visibility::scene::{Bounds, Camera, Lens, camera};
use sightlines_visibility::setup::Up;

use super::args::AmbientArgs;
use super::{count, exposure};
use crate::program::{Failure, targets};

/// The cameras, and a file for each: of an orbit, or one camera for each frame.
pub(super) fn cameras(args: &AmbientArgs, bounds: &Bounds) -> Result<Vec<(Camera, PathBuf)>> {
    let Some(path) = &args.picture else { return Ok(Vec::new()) };
    let up = match args.up() {
        Up::Y => [0.0, 1.0, 0.0],
        Up::Z => [0.0, 0.0, 1.0],
    };
    let first = match &args.camera {
        None => default_camera(bounds, up, args.size)?,
        Some(words) => Camera::parse(words, up)?.ok_or_else(|| {
            let remedy = "give eye and target, as 4,3,6/0,1,0 or 4,3,6/0,1,0/60";
            Place::default().element("--camera").error(format!("`{words}` is no camera"), remedy)
        })?,
    };
    let orbit = match args.orbit {
        Some(count) => first.orbit(bounds.centre, up, count)?,
        None => vec![first],
    };
    let count = args.frames.map_or(orbit.len(), |frames| frames as usize);
    let cameras: Vec<Camera> = orbit.into_iter().cycle().take(count).collect();
    let file = |(number, camera)| (camera, targets::numbered(path, number, count));
    Ok(cameras.into_iter().enumerate().map(file).collect())
}

/// From above, in front and to the right, all in the picture.
fn default_camera(bounds: &Bounds, up: [f64; 3], size: Picture) -> Result<Camera> {
    let slope = libm::tan(camera::DEFAULT_ANGLE * std::f64::consts::PI / 360.0);
    let narrow = slope * (f64::from(size.width) / f64::from(size.height)).min(1.0);
    // The scene's sphere fills the narrower side but for a margin.
    let distance = 1.03 * bounds.radius * (1.0 + narrow * narrow).sqrt() / narrow;
    // Along x, up and towards the viewer; of length 1.
    let [x, high, near] = [0.48, 0.36, 0.8].map(|part| part * distance);
    let arm = if up[1] > 0.0 { [x, high, near] } else { [x, -near, high] };
    let eye = [0, 1, 2].map(|axis| bounds.centre[axis] + arm[axis]);
    Camera::look_at("default", eye, bounds.centre, up, Lens::angle(camera::DEFAULT_ANGLE)?)
}

/// Writes a picture.
pub(super) fn write(
    args: &AmbientArgs,
    (view, path): (&View, &PathBuf),
    surface: &Surface,
    (colours, white): (&Colours, f64),
) -> Result<()> {
    write_rgb(path, view.size(), &view.shade(surface, colours, &gamma_table(args.gamma, white)?))
}

/// Takes the pictures one after another, and evaluates what each shows for the first time.
pub(super) fn lazily(
    args: &AmbientArgs,
    backend: &dyn Backend,
    surface: &Surface,
    cameras: &[(Camera, PathBuf)],
    (environment, is_white): (&Environment, bool),
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let all = surface.mesh.triangles.len();
    let intensities = environment.look_up(backend, args.sphere(), &args.lighting())?;
    let mut lazy = Lazy::new(backend, surface, args.sphere(), args.bias, args.threshold.unwrap_or(all / 20));
    let mut white = args.white.or(is_white.then_some(1.0));
    let mut positions = 0;
    for (camera, path) in cameras {
        let view = View::new(backend, surface, camera, args.size)?;
        let look = lazy.look(&view)?;
        let colours = lazy.light(&intensities)?;
        // All pictures have the exposure of the first.
        let white = *white.get_or_insert_with(|| exposure(&colours));
        write(args, (&view, path), surface, (&colours, white))?;
        let (unseen, todo) = (look.unseen, look.todo);
        let done = look.positions;
        positions += done as u64;
        writeln!(out, "picture    {}: {todo} triangles to do, {unseen} unseen, {done} positions", path.display())?;
    }
    if args.counts { count(&lazy.work(), positions * u64::from(args.sphere().count()), out) } else { Ok(()) }
}

//! `--map`: the receiver's map looked up in a camera's view, beside what is counted there.

use std::io::Write;

use sightlines_backend::Backend;
use sightlines_visibility::error::Place;
use sightlines_visibility::image::{Share, write_panels};
use sightlines_visibility::setup::Setup;
use sightlines_visibility::shadows::MAX_RESOLUTION;
use sightlines_visibility::shadows::filter::{FRACTION, Levels, footprints};
use sightlines_visibility::shadows::surface::Surface;

use super::args::{ResultName, ShadowsArgs};
use super::{Outputs, Total, one_light};
use crate::program::Failure;

/// Bakes the map, looks it up, and writes the three panels.
pub(super) fn write(
    args: &ShadowsArgs,
    setup: &Setup,
    outputs: &Outputs,
    counted: &Total,
    backend: &dyn Backend,
    side: u32,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let refuse = |what: String, remedy: &str| Err(Failure::Work(Place::default().element("--map").error(what, remedy)));
    let Surface::View(rect, camera) = &setup.surface else {
        return refuse("no camera looks at it".to_owned(), "give a --camera");
    };
    if !side.is_power_of_two() || side > MAX_RESOLUTION {
        return refuse(format!("a map of {side} texels a side"), "choose a power of two up to 8192");
    }
    if !counted.is_white {
        return refuse("the lights have colours".to_owned(), "leave --map out: it is of white light");
    }
    let flat = Setup { surface: Surface::Plane(*rect), resolution: side, ..setup.clone() };
    let mut map = Total::default();
    for number in 0..flat.lights.len() {
        map.add(&one_light(args, &flat, number, backend)?, ResultName::Share);
    }
    let levels = Levels::new(side, &map.visible)?;
    let looked: Vec<u32> = footprints(rect, camera, setup.resolution, side)
        .into_iter()
        .map(|footprint| footprint.map_or(0, |footprint| nearest(levels.look_up(footprint))))
        .collect();
    let share = |visible| Share { resolution: setup.resolution, samples: counted.samples, visible };
    let pairs = counted.visible.iter().zip(&looked).zip(&counted.is_there);
    let apart: Vec<u32> = pairs.map(|((a, b), there)| if *there { a.abs_diff(*b) } else { 0 }).collect();
    let most = apart.iter().max().copied().unwrap_or(0);
    let pixels = counted.is_there.iter().filter(|there| **there).count().max(1) as f64;
    let samples = f64::from(counted.samples);
    let mean = apart.iter().map(|apart| f64::from(*apart)).sum::<f64>() / (pixels * samples);
    let off = apart.iter().filter(|apart| **apart > 0).count();
    writeln!(out, "map        {side} x {side}: {off} of {pixels} pixels differ, {mean:.6} of the light in the mean,")?;
    writeln!(out, "           {:.6} at most", f64::from(most) / samples)?;
    if let Some(path) = &outputs.png {
        let seen = counted.visible.iter().zip(&counted.is_there).map(|(seen, there)| if *there { *seen } else { 0 });
        write_panels(path, &[share(seen.collect()), share(looked), share(apart)])?;
    }
    Ok(())
}

/// Whole samples.
fn nearest(count: u64) -> u32 {
    ((count + (1 << (FRACTION - 1))) >> FRACTION) as u32
}

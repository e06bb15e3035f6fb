//! Environment maps from files: Radiance HDR and OpenEXR, as latitude–longitude maps or as crosses of a cube's faces.
//!
//! The shape tells the layout: 2 : 1 is latitude–longitude, 4 : 3 a cross that lies (left, front, right, back; top and
//! bottom at the front), 3 : 4 one that stands (top, front, bottom, back upside down; left and right at the front).
//! Faces are seen from inside; the front is −z, with +x to its right and +y up, the middle of a latitude–longitude map.
//! A cross becomes a latitude–longitude map of four sides by two, by the texel that each direction meets.

use std::io::Cursor;
use std::path::Path;

use exr::prelude::{MetaData, ReadChannels, ReadLayers};

use super::environment::{Environment, direction_at};
use super::radiance::{self, MAX_TEXELS, Picture};
use crate::error::{Place, Result};
use crate::input;

/// Largest file that is read, in bytes.
const MAX_BYTES: u64 = 1 << 30;

/// Largest values of a channel, which fixed point has room for.
const RANGE: std::ops::RangeInclusive<f32> = 1e-4..=1e23;

const REMEDY: &str = "export the environment again, as Radiance HDR or OpenEXR";

impl Environment {
    /// Reads a map.
    ///
    /// # Errors
    ///
    /// A file that is missing, neither format, damaged, too large, of another shape, or with texels that are no light.
    pub fn load(path: &Path) -> Result<Self> {
        let bytes = input::read(path, MAX_BYTES, "scale the environment down")?;
        let place = Place::file(path);
        let picture = if bytes.starts_with(b"#?") {
            radiance::read(&place, &bytes)?
        } else if bytes.starts_with(&[0x76, 0x2f, 0x31, 0x01]) {
            open_exr(&bytes).map_err(|what| place.clone().error(what, REMEDY))?
        } else {
            return Err(place.error("neither Radiance HDR nor OpenEXR", REMEDY));
        };
        let (width, height, texels) = check(&place, picture)?;
        match (width, height) {
            _ if width == 2 * height => Ok(Environment { width, height, texels }),
            _ if 3 * width == 4 * height => Ok(unfold(&texels, width, width / 4)),
            _ if 4 * width == 3 * height => Ok(unfold(&texels, width, width / 3)),
            _ => {
                let what =
                    format!("{width} by {height} texels: neither a latitude–longitude map nor a cross of a cube");
                Err(place.error(what, "give a map of 2 : 1, or a cross of 4 : 3 or 3 : 4"))
            }
        }
    }
}

/// Red, green and blue of the first layer.
fn open_exr(bytes: &[u8]) -> Result<Picture, String> {
    let told = |e: exr::error::Error| e.to_string();
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(told)?;
    let size = meta.headers.first().ok_or("it has no layer")?.layer_size;
    if (size.width() as u64).saturating_mul(size.height() as u64) > MAX_TEXELS {
        return Err(format!("it has {} by {} texels, and at most {MAX_TEXELS} are read", size.width(), size.height()));
    }
    let create = |size: exr::prelude::Vec2<usize>, _: &_| (size.width(), vec![[0.0; 3]; size.area()]);
    let set =
        |(width, texels): &mut (usize, Vec<[f32; 3]>), at: exr::prelude::Vec2<usize>, (r, g, b): (f32, f32, f32)| {
            texels[at.y() * *width + at.x()] = [r, g, b];
        };
    let layers = exr::prelude::read().no_deep_data().largest_resolution_level().rgb_channels(create, set);
    let image = layers.first_valid_layer().all_attributes().non_parallel().from_buffered(Cursor::new(bytes));
    let (width, texels) = image.map_err(told)?.layer_data.channel_data.pixels;
    Ok((width as u32, (texels.len() / width.max(1)) as u32, texels))
}

/// Refuses texels that are no light.
fn check(place: &Place, picture: Picture) -> Result<Picture> {
    let (width, _, texels) = &picture;
    let bad = |texel: &[f32; 3]| texel.iter().any(|c| !c.is_finite() || *c < 0.0);
    if let Some(at) = texels.iter().position(bad) {
        let (row, column) = (at / *width as usize + 1, at % *width as usize + 1);
        let what = format!("it is {:?}", texels[at]);
        let remedy = "clip the environment to finite values that are not negative";
        return Err(place.clone().element(format!("texel in row {row}, column {column}")).error(what, remedy));
    }
    for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
        let most = texels.iter().map(|texel| texel[channel]).fold(0.0, f32::max);
        if most != 0.0 && !RANGE.contains(&most) {
            let remedy = format!("scale the environment: {:e} to {:e} are taken", RANGE.start(), RANGE.end());
            return Err(place.clone().error(format!("the largest {name} is {most:e}"), remedy));
        }
    }
    Ok(picture)
}

/// A cross, whose faces have `side` texels a side, as a latitude–longitude map.
fn unfold(texels: &[[f32; 3]], across: u32, side: u32) -> Environment {
    let lies = across / side == 4;
    let (width, height) = (4 * side, 2 * side);
    let texel = |i: u32| {
        let ([column, row], [u, v]) = cell(direction_at([i % width, i / width], [width, height]), lies);
        let at = |c: f64| ((0.5 * (c + 1.0) * f64::from(side)) as u32).min(side - 1);
        texels[((row * side + at(v)) * across + column * side + at(u)) as usize]
    };
    Environment { width, height, texels: (0..width * height).map(texel).collect() }
}

/// The cell of the cross that holds a direction, and where in it, from -1 to 1 to the right and downwards.
fn cell([x, y, z]: [f64; 3], lies: bool) -> ([u32; 2], [f64; 2]) {
    let [a, b, c] = [x, y, z].map(f64::abs);
    if b >= a && b >= c {
        return if y > 0.0 { ([1, 0], [x / b, -z / b]) } else { ([1, 2], [x / b, z / b]) };
    }
    if a >= c {
        return if x > 0.0 { ([2, 1], [z / a, -y / a]) } else { ([0, 1], [-z / a, -y / a]) };
    }
    match z < 0.0 {
        true => ([1, 1], [x / c, -y / c]),
        false if lies => ([3, 1], [-x / c, -y / c]),
        false => ([1, 3], [x / c, y / c]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cross whose texels hold the direction that they stand for, moved to be positive.
    fn cross(side: u32, lies: bool) -> (Vec<[f32; 3]>, u32) {
        let (across, down) = if lies { (4 * side, 3 * side) } else { (3 * side, 4 * side) };
        let mut texels = vec![[0.0; 3]; (across * down) as usize];
        let steps = 8 * side as i32;
        let range = || (-steps..=steps).map(|i| f64::from(i) / f64::from(steps));
        for face in 0..6 {
            for p in range() {
                for q in range() {
                    let [x, y, z] =
                        [[1.0, p, q], [-1.0, p, q], [p, 1.0, q], [p, -1.0, q], [p, q, 1.0], [p, q, -1.0]][face];
                    let ([column, row], [u, v]) = cell([x, y, z], lies);
                    let at = |c: f64| ((0.5 * (c + 1.0) * f64::from(side)) as u32).min(side - 1);
                    let place = (row * side + at(v)) * across + column * side + at(u);
                    texels[place as usize] = [x, y, z].map(|c| c as f32 + 1.0);
                }
            }
        }
        (texels, across)
    }

    #[test]
    fn both_crosses_unfold_to_the_directions_that_they_show() {
        for lies in [true, false] {
            let (texels, across) = cross(16, lies);
            let map = unfold(&texels, across, 16);
            for (i, texel) in (0..).zip(&map.texels) {
                let d = direction_at([i % map.width, i / map.width], [map.width, map.height]);
                let longest = d.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
                for axis in 0..3 {
                    let found = f64::from(texel[axis]) - 1.0;
                    assert!((found - d[axis] / longest).abs() < 0.13, "lies {lies}, texel {i}: {found} of {d:?}");
                }
            }
        }
    }

    #[test]
    fn neighbours_across_the_edges_of_a_cross_are_neighbours_on_the_sphere() {
        let near = |found: f64, expected: f64| (found - expected).abs() < 2e-3;
        // Just above and below the upper edge of the front, and to the right of it.
        let (cell_above, [u, v]) = cell([0.2, 1.001, -1.0], true);
        assert!(cell_above == [1, 0] && near(u, 0.2) && near(v, 1.0), "{cell_above:?}: {u}, {v}");
        let (cell_below, [u, v]) = cell([0.2, 0.999, -1.0], true);
        assert!(cell_below == [1, 1] && near(u, 0.2) && near(v, -1.0), "{cell_below:?}: {u}, {v}");
        let (cell_right, [u, v]) = cell([1.001, 0.3, -1.0], true);
        assert!(cell_right == [2, 1] && near(u, -1.0) && near(v, -0.3), "{cell_right:?}: {u}, {v}");
    }
}

//! The lights of a scene file: rectangles, where in them they shine, and in which colours.

use serde::Deserialize;
use toml::Spanned;

use super::file::Source;
use crate::error::{Place, Result};
use crate::scene::limit;
use crate::shadows::Rect;
use crate::shadows::light::{Area, Colour, Form, Light, MAX_AREAS, Texture, WHITE};

/// Brightest channel of a colour.
const MAX_COLOUR: f64 = 1e6;

/// `[[light]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Entry {
    corner: [f64; 3],
    u: [f64; 3],
    v: [f64; 3],
    colour: Option<Colour>,
    image: Option<String>,
    tubes: Option<Tubes>,
    polygons: Option<Vec<Polygon>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Tubes {
    count: u32,
    width: f64,
    colours: Option<Vec<Colour>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Polygon {
    corners: Vec<[f64; 2]>,
    colour: Option<Colour>,
}

/// The light that an entry describes.
pub(super) fn light(source: &Source<'_>, entry: &Spanned<Entry>) -> Result<Light> {
    let place = source.at("light", entry);
    let Entry { corner, u, v, colour, image, tubes, polygons } = entry.get_ref();
    let form = match (image, tubes, polygons) {
        (None, None, None) => Form::Whole,
        (Some(name), None, None) => Form::Image(Texture::load(&source.beside(name))?),
        (None, Some(Tubes { count, width, colours }), None) => {
            let colours = colours.clone().unwrap_or_else(|| vec![WHITE]);
            for colour in &colours {
                check_colour(&place, colour)?;
            }
            Form::Areas(Area::tubes(&place, *count, *width, &colours)?)
        }
        (None, None, Some(polygons)) => {
            limit(place.clone(), "polygons", polygons.len(), MAX_AREAS)?;
            Form::Areas(polygons.iter().map(|polygon| area(&place, polygon)).collect::<Result<_>>()?)
        }
        _ => return Err(place.error("it has several forms", "give it one of `image`, `tubes` and `polygons`")),
    };
    let colour = colour.unwrap_or(WHITE);
    check_colour(&place, &colour)?;
    Ok(Light { rect: Rect { corner: *corner, u: *u, v: *v }, form, colour })
}

fn area(place: &Place, polygon: &Polygon) -> Result<Area> {
    let colour = polygon.colour.unwrap_or(WHITE);
    check_colour(place, &colour)?;
    Area::new(place, &polygon.corners, colour)
}

fn check_colour(place: &Place, colour: &Colour) -> Result<()> {
    if colour.iter().all(|c| (0.0..=MAX_COLOUR).contains(c)) && *colour != [0.0; 3] {
        return Ok(());
    }
    let remedy = "give red, green and blue from 0 to 1e6, not all 0";
    Err(place.clone().error(format!("the colour {colour:?} does not shine"), remedy))
}

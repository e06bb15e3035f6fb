//! Lights: a rectangle, where in it the light shines, and in which colours.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 8: any planar light is a rectangle with
//! samples only where there is light, and samples of one colour are a group with a mask of its own. Forms are told in
//! units of 2^-16 of the rectangle's sides, so that what is lit is decided in integers.

use std::collections::HashMap;
use std::io::Cursor;
use std::path::Path;

use sightlines_kernels::irradiance::MAX_GROUPS;

use super::Rect;
use super::placement::{Point, UNIT};
use crate::error::{Error, Place, Result};
use crate::input;
use crate::scene::MAX_FILE_BYTES;

/// Red, green and blue, linear; white is 1, 1, 1.
pub type Colour = [f64; 3];

/// White.
pub const WHITE: Colour = [1.0; 3];

/// Most areas of a form, and most corners of one.
pub const MAX_AREAS: usize = 256;

/// A light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its bounding rectangle; it shines along u × v.
    pub rect: Rect,
    /// Where it shines.
    pub form: Form,
    /// What its colours are multiplied by.
    pub colour: Colour,
}

/// Where a light shines, and in which colours.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Form {
    /// Everywhere, white.
    #[default]
    Whole,
    /// In polygons; where several cover a point, in the first.
    Areas(Vec<Area>),
    /// Where an image is not black.
    Image(Texture),
}

/// A polygon of one colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Corners in turn, in units of 2^-16 of the sides; what an odd number of edges encloses is inside.
    pub corners: Vec<[i64; 2]>,
    /// Its colour.
    pub colour: Colour,
}

/// An image stretched over the rectangle, its columns along u and its rows along v.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    columns: u32,
    rows: u32,
    /// 0 to 65,535 a channel, linear.
    pixels: Vec<[u16; 3]>,
}

impl From<Rect> for Light {
    fn from(rect: Rect) -> Self {
        Light { rect, form: Form::Whole, colour: WHITE }
    }
}

impl Light {
    /// The colour at a point; none where it does not shine.
    pub fn at(&self, point: Point) -> Option<Colour> {
        let colour = match &self.form {
            Form::Whole => WHITE,
            Form::Areas(areas) => areas.iter().find(|area| area.holds(point))?.colour,
            Form::Image(texture) => texture.at(point)?,
        };
        Some([0, 1, 2].map(|i| colour[i] * self.colour[i]))
    }

    /// Whether its rectangle shines as a whole, in white.
    pub fn is_plain(&self) -> bool {
        self.form == Form::Whole && self.colour == WHITE
    }

    /// The part of the rectangle that shines, of 256 × 256 points.
    pub fn lit_share(&self) -> f64 {
        if self.form == Form::Whole {
            return 1.0;
        }
        let points = (0..1u32 << 16).map(|i| [i % 256, i / 256].map(|x| x * 256 + 128));
        points.filter(|p| self.at(*p).is_some()).count() as f64 / 65_536.0
    }
}

impl Area {
    /// A polygon by corners in parts of the sides, from 0 to 1.
    ///
    /// # Errors
    ///
    /// Fewer than three corners or too many, and corners outside the rectangle.
    pub fn new(place: &Place, corners: &[[f64; 2]], colour: Colour) -> Result<Self> {
        if !(3..=MAX_AREAS).contains(&corners.len()) {
            let what = format!("a polygon of {} corners", corners.len());
            return Err(place.clone().error(what, format!("give it 3 to {MAX_AREAS}")));
        }
        if let Some(bad) = corners.iter().find(|corner| !corner.iter().all(|x| (0.0..=1.0).contains(x))) {
            let remedy = "corners are parts of the light's sides: choose numbers from 0 to 1";
            return Err(place.clone().error(format!("a corner at {bad:?} is outside the light's rectangle"), remedy));
        }
        let corners = corners.iter().map(|c| c.map(|x| (x * f64::from(UNIT)).round() as i64)).collect();
        Ok(Area { corners, colour })
    }

    /// `count` neon tubes along u, side by side, each `width` of its share of v wide; colours take turns.
    ///
    /// # Errors
    ///
    /// No tubes or too many, a width out of range, or no colours.
    pub fn tubes(place: &Place, count: u32, width: f64, colours: &[Colour]) -> Result<Vec<Self>> {
        let sound = (1..=MAX_AREAS as u32).contains(&count) && width > 0.0 && width <= 1.0 && !colours.is_empty();
        if !sound {
            let what = format!("{count} tubes of width {width:?} in {} colours", colours.len());
            let remedy = format!("choose 1 to {MAX_AREAS} tubes, a width above 0 and at most 1, and a colour");
            return Err(place.clone().error(what, remedy));
        }
        let share = 1.0 / f64::from(count);
        let tube = |index: u32| {
            let [low, high] = [-0.5, 0.5].map(|side| (f64::from(index) + 0.5 + side * width) * share);
            let corners = [[0.0, low], [1.0, low], [1.0, high], [0.0, high]];
            Area::new(place, &corners, colours[index as usize % colours.len()])
        };
        (0..count).map(tube).collect()
    }

    /// Whether the ray from a point along +u crosses an odd number of edges; an edge holds its lower end and not its
    /// upper.
    fn holds(&self, [u, v]: Point) -> bool {
        let (u, v) = (i64::from(u), i64::from(v));
        let edges = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        let crossed = edges.filter(|(a, b)| {
            let (low, high) = if a[1] <= b[1] { (a, b) } else { (b, a) };
            (low[1]..high[1]).contains(&v) && (high[0] - low[0]) * (v - low[1]) > (u - low[0]) * (high[1] - low[1])
        });
        crossed.count() % 2 == 1
    }
}

impl Texture {
    /// Rows of pixels, linear, 65,535 being white.
    pub fn new(columns: u32, rows: u32, pixels: Vec<[u16; 3]>) -> Self {
        assert_eq!(pixels.len(), columns as usize * rows as usize, "a pixel for each column and row");
        Texture { columns, rows, pixels }
    }

    /// Reads a PNG: grey or coloured, 8 or 16 bits, values taken as linear; what is transparent does not shine.
    ///
    /// # Errors
    ///
    /// A file that is missing, no PNG, too large, or black.
    pub fn load(path: &Path) -> Result<Self> {
        let (columns, rows, pixels) = read_png(path)?;
        if pixels.iter().all(|pixel| *pixel == [0; 3]) {
            return Err(Place::file(path).error("the image is black: a light of it shines nowhere", "lighten it"));
        }
        Ok(Texture { columns, rows, pixels })
    }

    fn at(&self, [u, v]: Point) -> Option<Colour> {
        let along = |x: u32, count: u32| ((u64::from(x) * u64::from(count)) >> 16) as usize;
        let pixel = self.pixels[along(v, self.rows) * self.columns as usize + along(u, self.columns)];
        (pixel != [0; 3]).then(|| pixel.map(|value| f64::from(value) / 65_535.0))
    }
}

/// Columns, rows and pixels of a PNG, 16 bits a channel, multiplied by how opaque they are.
pub(crate) fn read_png(path: &Path) -> Result<(u32, u32, Vec<[u16; 3]>)> {
    const MOST: u32 = 8192;
    let failed = |e: png::DecodingError| match e {
        png::DecodingError::IoError(source) => Error::read(path, source),
        other => Place::file(path).error(other.to_string(), "save the image as PNG"),
    };
    let bytes = input::read(path, MAX_FILE_BYTES, "scale the image down")?;
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(failed)?;
    let (columns, rows) = (reader.info().width, reader.info().height);
    if columns > MOST || rows > MOST {
        let what = format!("an image of {columns} by {rows} pixels");
        return Err(Place::file(path).error(what, format!("scale it to at most {MOST} a side")));
    }
    let mut bytes = vec![0; reader.output_buffer_size().unwrap_or_default()];
    let frame = reader.next_frame(&mut bytes).map_err(failed)?;
    bytes.truncate(frame.buffer_size());
    let values: Vec<u32> = match frame.bit_depth {
        png::BitDepth::Sixteen => bytes.as_chunks().0.iter().map(|two| u32::from(u16::from_be_bytes(*two))).collect(),
        _ => bytes.iter().map(|byte| u32::from(*byte) * 257).collect(),
    };
    let channels = frame.color_type.samples();
    let pixels = values.chunks_exact(channels).map(|pixel| {
        let (rgb, alpha) = match *pixel {
            [grey] => ([grey; 3], 65_535),
            [grey, alpha] => ([grey; 3], alpha),
            [r, g, b] => ([r, g, b], 65_535),
            [r, g, b, alpha, ..] => ([r, g, b], alpha),
            [] => ([0; 3], 0),
        };
        rgb.map(|value| (value * alpha / 65_535) as u16)
    });
    Ok((columns, rows, pixels.collect()))
}

/// Colours of a light, and which of them each sample has.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    /// The colours.
    pub colours: Vec<Colour>,
    /// The colour's number, for each sample.
    pub of: Vec<u32>,
}

impl Palette {
    /// At most `most` colours for samples of these colours: those that there are, or else their means in the cells of
    /// the finest even division of the channels that leaves no more than `most` of them.
    ///
    /// # Panics
    ///
    /// Where `most` is 0.
    pub fn new(samples: &[Colour], most: usize) -> Self {
        assert!(most > 0, "a light has a colour");
        let peak = samples.as_flattened().iter().copied().fold(0.0, f64::max);
        let even = |levels: u32| numbered(samples, |c| c.map(|x| ((x / peak) * f64::from(levels)).round() as u64));
        let (count, exact) = numbered(samples, |c| c.map(f64::to_bits));
        let of = if count <= most.min(MAX_GROUPS) {
            exact
        } else {
            let fits = (0..=255).rev().map(even).find(|(count, _)| *count <= most);
            fits.map_or_else(|| vec![0; samples.len()], |(_, of)| of)
        };
        Palette { colours: means(samples, &of), of }
    }
}

/// How many keys there are, and the number of each sample's, in the order in which they first appear.
fn numbered(samples: &[Colour], key: impl Fn(Colour) -> [u64; 3]) -> (usize, Vec<u32>) {
    let mut numbers = HashMap::new();
    let mut number = |colour: &Colour| {
        let next = numbers.len() as u32;
        *numbers.entry(key(*colour)).or_insert(next)
    };
    let of = samples.iter().map(&mut number).collect();
    (numbers.len(), of)
}

/// The mean colour of the samples of each number: theirs, without rounding, where all are equal.
fn means(samples: &[Colour], of: &[u32]) -> Vec<Colour> {
    let count = of.iter().max().map_or(0, |most| *most as usize + 1);
    let mut groups = vec![Vec::new(); count];
    of.iter().zip(samples).for_each(|(number, colour)| groups[*number as usize].push(*colour));
    let mean = |group: &Vec<Colour>| match group[..] {
        [first, ..] if group.iter().all(|colour| *colour == first) => first,
        _ => [0, 1, 2].map(|i| group.iter().map(|colour| colour[i]).sum::<f64>() / group.len() as f64),
    };
    groups.iter().map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const RECT: Rect = Rect { corner: [0.0; 3], u: [1.0, 0.0, 0.0], v: [0.0, 0.0, 1.0] };
    const RED: Colour = [1.0, 0.0, 0.0];
    const BLUE: Colour = [0.0, 0.0, 0.5];

    #[test]
    fn polygons_hold_what_an_odd_number_of_edges_encloses() {
        let place = Place::default();
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let whole = Area::new(&place, &corners, WHITE).unwrap();
        assert!([[0, 0], [UNIT - 1, UNIT - 1], [UNIT / 2, 7]].iter().all(|p| whole.holds(*p)));
        // Two triangles that share a diagonal own every point once.
        let halves = [[0, 1, 2], [0, 2, 3]].map(|t| Area::new(&place, &t.map(|i: usize| corners[i]), WHITE).unwrap());
        for i in 0..200 {
            for p in [[300 * i, 327 * i], [300 * i, 300 * i], [300 * (200 - i), 300 * i]] {
                assert_eq!(halves.iter().filter(|half| half.holds(p)).count(), 1, "{p:?}");
            }
        }
        assert!(
            Area::new(&place, &corners[..2], WHITE).is_err() && Area::new(&place, &[[1.1, 0.0]; 3], WHITE).is_err()
        );
    }

    #[test]
    fn tubes_shine_in_turn_and_not_between() {
        let areas = Area::tubes(&Place::default(), 4, 0.5, &[RED, BLUE]).unwrap();
        let light = Light { form: Form::Areas(areas), ..Light::from(RECT) };
        let at = |part: u32| light.at([UNIT / 3, part * UNIT / 16]);
        assert_eq!([0, 2, 4, 6, 10, 14].map(at), [None, Some(RED), None, Some(BLUE), Some(RED), Some(BLUE)]);
        assert_eq!(light.lit_share(), 0.5);
        assert!(Area::tubes(&Place::default(), 0, 0.5, &[RED]).is_err());
        assert!(Area::tubes(&Place::default(), 3, 1.5, &[RED]).is_err());
    }

    #[test]
    fn images_shine_where_they_are_not_black() {
        let texture = Texture::new(2, 1, vec![[0; 3], [65_535, 0, 0]]);
        let light = Light { form: Form::Image(texture), colour: [0.5, 1.0, 1.0], ..Light::from(RECT) };
        assert_eq!((light.at([0, 9]), light.at([UNIT / 2, 9])), (None, Some([0.5, 0.0, 0.0])));
        assert_eq!(light.lit_share(), 0.5);
    }

    #[test]
    fn palettes_keep_what_they_can_and_take_means_of_the_rest() {
        let few = Palette::new(&[RED, BLUE, RED], 24);
        assert_eq!((few.colours, few.of), (vec![RED, BLUE], vec![0, 1, 0]));
        let ramp: Vec<Colour> = (0..100).map(|i| [f64::from(i) / 99.0; 3]).collect();
        let some = Palette::new(&ramp, 24);
        assert_eq!(some.colours.len(), 24);
        assert!(some.of.is_sorted() && some.colours.is_sorted_by(|a, b| a[0] < b[0]));
        assert_eq!(Palette::new(&ramp, 1).colours.len(), 1);
    }
}

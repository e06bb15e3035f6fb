//! Where samples stand on a light: patterns of any number of points, kept where the light shines.
//!
//! Points are pairs of whole numbers below [`UNIT`], in units of 2^-16 of the light's two sides; snapping puts a point
//! (u, v) at the rectangle's corner + floor((u, v) × size / 2^16) cells. Every pattern is made of integers: the same on
//! every host. Samples that come later refine those before them, except on grids, whose cells depend on how many there
//! are.

use std::path::Path;

use sightlines_kernels::random;

use super::blue_noise;
use crate::error::{Place, Result};
use crate::input;

/// A whole side of the light.
pub const UNIT: u32 = 1 << 16;

/// Most samples of a light.
pub const MAX_SAMPLES: u32 = 1 << 16;

/// Largest file of points, in bytes.
const MAX_BYTES: u64 = 1 << 23;

/// A point of a light, in units of 2^-16 of its sides.
pub type Point = [u32; 2];

/// How samples are placed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Placement {
    /// Centres of the cells of a grid as square as the number of samples lets it be.
    #[default]
    Grid,
    /// A random place in each cell of that grid.
    Jittered,
    /// Halton's sequence in bases 2 and 3.
    Halton,
    /// Void and cluster: every prefix keeps its points apart.
    BlueNoise,
    /// These, in this order.
    Points(Vec<Point>),
}

impl Placement {
    /// The names of those that need no file.
    pub const NAMES: [&str; 4] = ["grid", "jittered", "halton", "blue-noise"];

    /// The one of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        let all = [Placement::Grid, Placement::Jittered, Placement::Halton, Placement::BlueNoise];
        Self::NAMES.iter().zip(all).find(|(known, _)| **known == name).map(|(_, placement)| placement)
    }

    /// Reads points from a text file: two numbers of [0, 1) a line, `#` begins a comment.
    ///
    /// # Errors
    ///
    /// A file that is missing, empty or too long, or a line that is no point, by its number.
    pub fn load(path: &Path) -> Result<Self> {
        let text = input::read_text(path, MAX_BYTES, "give fewer points, one a line")?;
        let mut points = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let line = line.split('#').next().unwrap_or_default().trim();
            if line.is_empty() {
                continue;
            }
            points.push(point(line).ok_or_else(|| {
                let remedy = "write two numbers from 0 to below 1, with a space or comma between them";
                Place::line(path, index + 1).error(format!("`{line}` is no point of the light"), remedy)
            })?);
        }
        if points.is_empty() || points.len() > MAX_SAMPLES as usize {
            let what = format!("{} points in it", points.len());
            return Err(Place::file(path).error(what, format!("give 1 to {MAX_SAMPLES}, one a line")));
        }
        Ok(Placement::Points(points))
    }

    /// `count` points where `is_lit`; on a grid of a light that is not lit everywhere, the most that are not above it.
    ///
    /// # Errors
    ///
    /// No samples or too many, a number that makes no grid, and a light that shines from next to nowhere.
    pub fn points(&self, count: u32, seed: u32, is_lit: &dyn Fn(Point) -> bool) -> Result<Vec<Point>> {
        let refuse = |what: String, remedy: &str| Err(Place::default().element("samples").error(what, remedy));
        if !(1..=MAX_SAMPLES).contains(&count) {
            return refuse(format!("{count} samples cannot be baked"), "choose 1 to 65536");
        }
        let found = match self {
            Placement::Grid => on_grid(count, is_lit, centre)?,
            Placement::Jittered => on_grid(count, is_lit, |cell, shape| jittered(cell, shape, seed))?,
            Placement::Halton => {
                let all = (1..=64 * MAX_SAMPLES).map(|index| [inverse(2, index), inverse(3, index)]);
                all.filter(|p| is_lit(*p)).take(count as usize).collect()
            }
            Placement::BlueNoise => blue_noise::points(count, is_lit),
            Placement::Points(points) => points.iter().copied().filter(|p| is_lit(*p)).take(count as usize).collect(),
        };
        let exact = !matches!(self, Placement::Grid | Placement::Jittered);
        if found.is_empty() || exact && found.len() < count as usize {
            let what = format!("{count} samples are wanted, and {} fall where the light shines", found.len());
            return refuse(what, "take fewer samples, another pattern, or a light that fills more of its rectangle");
        }
        Ok(found)
    }
}

fn point(line: &str) -> Option<Point> {
    let mut numbers = line.split([' ', '\t', ',', ';']).filter(|n| !n.is_empty()).map(str::parse::<f64>);
    let (u, v, rest) = (numbers.next()?.ok()?, numbers.next()?.ok()?, numbers.next());
    let inside = |x: f64| (0.0..1.0).contains(&x);
    (rest.is_none() && inside(u) && inside(v)).then(|| [u, v].map(|x| (x * f64::from(UNIT)) as u32))
}

/// Columns and rows of a grid of so many cells, as square as can be: at least as many columns as rows.
pub(super) fn shape(count: u32) -> [u32; 2] {
    let rows = (1..=count.isqrt()).rev().find(|rows| count.is_multiple_of(*rows)).unwrap_or(1);
    [count / rows, rows]
}

/// One point a cell.
fn on_grid(
    count: u32,
    is_lit: &dyn Fn(Point) -> bool,
    place: impl Fn([u32; 2], [u32; 2]) -> Point,
) -> Result<Vec<Point>> {
    let lit = |[columns, rows]: [u32; 2]| -> Vec<Point> {
        let cells = (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row]));
        cells.map(|cell| place(cell, [columns, rows])).filter(|p| is_lit(*p)).collect()
    };
    let [columns, rows] = shape(count);
    let whole = lit([columns, rows]);
    if whole.len() < (columns * rows) as usize {
        // The light has a form: square grids, finer and finer, until they are clearly too fine.
        let tried = (1..).map(|n| lit([n, n])).take_while(|found| found.len() <= 2 * count as usize).take(512);
        let fits = tried.filter(|found| found.len() <= count as usize);
        return Ok(fits.fold(Vec::new(), |best, found| if found.len() > best.len() { found } else { best }));
    }
    if columns > 4 * rows {
        let what = format!("{count} samples make a grid of {columns} by {rows}");
        let near =
            (1..).map(|side: u32| side * side).take_while(|n| *n <= MAX_SAMPLES).min_by_key(|n| n.abs_diff(count));
        let remedy = format!("choose {}, or another pattern", near.unwrap_or(1));
        return Err(Place::default().element("samples").error(what, remedy));
    }
    Ok(whole)
}

fn centre(cell: [u32; 2], shape: [u32; 2]) -> Point {
    [0, 1].map(|axis| (2 * cell[axis] + 1) * (UNIT / 2) / shape[axis])
}

fn jittered(cell: [u32; 2], shape: [u32; 2], seed: u32) -> Point {
    let index = cell[1] * shape[0] + cell[0];
    let within = |axis: usize| u64::from(random::below(UNIT, seed, 2 * index + axis as u32));
    [0, 1].map(|axis| ((u64::from(cell[axis] * UNIT) + within(axis)) / u64::from(shape[axis])) as u32)
}

/// The digits of `index` in `base`, mirrored at the point, in units of 2^-16.
fn inverse(base: u64, index: u32) -> u32 {
    let (mut rest, mut mirrored, mut unit) = (u64::from(index), 0, 1);
    while rest > 0 {
        mirrored = mirrored * base + rest % base;
        unit *= base;
        rest /= base;
    }
    (u64::from(UNIT) * mirrored / unit) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: fn(Point) -> bool = |_| true;

    fn points(placement: &Placement, count: u32) -> Vec<Point> {
        placement.points(count, 1, &ALL).unwrap()
    }

    #[test]
    fn grids_are_as_square_as_their_number_lets_them_be() {
        assert_eq!([1, 2, 32, 128, 992, 1024].map(shape), [[1, 1], [2, 1], [8, 4], [16, 8], [32, 31], [32, 32]]);
        assert_eq!(
            points(&Placement::Grid, 4),
            [[16_384, 16_384], [49_152, 16_384], [16_384, 49_152], [49_152, 49_152]]
        );
        let error = Placement::Grid.points(37, 1, &ALL).unwrap_err().to_string();
        assert!(error.contains("37 by 1") && error.contains("36"), "{error}");
        assert!(Placement::Grid.points(0, 1, &ALL).is_err() && Placement::Halton.points(70_000, 1, &ALL).is_err());
    }

    #[test]
    fn jittered_points_are_one_a_cell_and_depend_on_the_seed() {
        let found = points(&Placement::Jittered, 1024);
        let cells: Vec<[u32; 2]> = found.iter().map(|p| p.map(|x| x >> 11)).collect();
        assert!((0..1024).all(|i| cells[i as usize] == [i % 32, i / 32]));
        assert_ne!(found, Placement::Jittered.points(1024, 2, &ALL).unwrap());
    }

    #[test]
    fn halton_is_van_der_corput_in_two_bases() {
        assert_eq!(points(&Placement::Halton, 3), [[32_768, 21_845], [16_384, 43_690], [49_152, 7281]]);
    }

    #[test]
    fn a_light_with_a_form_has_samples_where_it_shines() {
        let half = |p: Point| p[0] < UNIT / 2;
        for placement in [Placement::Grid, Placement::Jittered, Placement::Halton, Placement::BlueNoise] {
            let found = placement.points(200, 1, &half).unwrap();
            assert!(
                found.iter().all(|p| half(*p)) && (180..=200).contains(&found.len()),
                "{placement:?} {}",
                found.len()
            );
        }
        let error = Placement::Halton.points(9, 1, &|_| false).unwrap_err().to_string();
        assert!(error.contains("0 fall"), "{error}");
    }

    #[test]
    fn points_from_a_file_and_lines_that_are_none() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let load = |text: &str| {
            std::fs::write(&path, text).unwrap();
            Placement::load(&path)
        };
        assert_eq!(
            load("# two\n0 0.5\n\n0.25,0.75 # b\n").unwrap(),
            Placement::Points(vec![[0, 32_768], [16_384, 49_152]])
        );
        let error = load("0 0\n0 1\n").unwrap_err().to_string();
        assert!(error.contains("a.txt:2: `0 1` is no point"), "{error}");
        assert!(load("# none\n").unwrap_err().to_string().contains("0 points"));
        assert!(load("1 2 3").is_err() && load("0.1 x").is_err() && load("nan 0").is_err());
    }
}

//! Receivers in scene units: planes, height fields over a plane, and the texels of a mesh's lightmap.
//!
//! Eisemann and Décoret, "Visibility Sampling on GPU and Applications", section 8: receivers need not lie on a plane; a
//! height map moves them. A spot is where a receiver stands and the side of the surface that it is on; everything in
//! f64, + − × ÷ √.

use std::path::Path;

use super::Rect;
use super::light::read_png;
use super::lightmap::Atlas;
use crate::error::{Error, Place, Result};
use crate::scene::{Camera, Lens, MAX_COORDINATE};
use crate::vector::{Vector, add, cross, dot, length, normalize, scale, sub};

/// A receiver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Where it stands.
    pub at: [f64; 3],
    /// The unit normal of the side that receives.
    pub normal: [f64; 3],
}

/// What receives light.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// A rectangle, on the side that the light is on.
    Plane(Rect),
    /// A rectangle whose points are moved along its normal, towards the light.
    Heights(Rect, HeightMap),
    /// The same, on the triangles between the heights, which cast shadows on each other; receivers stand some cells in
    /// front of them, as those of a lightmap.
    Relief(Rect, HeightMap),
    /// A rectangle as a camera sees it: receivers are where the rays through the pixels' centres meet it.
    View(Rect, Camera),
    /// The texels of a mesh, which receive on the front of their triangles and stand some cells in front of them.
    Lightmap(Atlas),
}

/// Heights over a rectangle, in scene units: columns along u, rows along v, given at the centres of their cells.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    columns: u32,
    rows: u32,
    heights: Vec<f64>,
}

impl HeightMap {
    /// Rows of heights.
    ///
    /// # Errors
    ///
    /// A height that is not finite, and rows that are not full.
    pub fn new(columns: u32, rows: u32, heights: Vec<f64>) -> Result<Self> {
        let full = columns > 0 && heights.len() as u64 == u64::from(columns) * u64::from(rows);
        if !full || heights.iter().any(|h| !h.is_finite()) {
            let what = format!("{} heights in {rows} rows of {columns}", heights.len());
            return Err(Place::default().element("heights").error(what, "give each cell a finite height"));
        }
        Ok(HeightMap { columns, rows, heights })
    }

    /// Reads heights from a PNG: black is 0, white is `scale`.
    ///
    /// # Errors
    ///
    /// A file that is missing or no PNG.
    pub fn load(path: &Path, scale: f64) -> Result<Self> {
        let (columns, rows, pixels) = read_png(path)?;
        Self::new(columns, rows, pixels.iter().map(|pixel| f64::from(pixel[0]) / 65_535.0 * scale).collect())
    }

    /// [`bumps`](Self::bumps) where the name is `bumps`, else the PNG at `path`.
    ///
    /// # Errors
    ///
    /// A scale out of range, and what [`load`](Self::load) refuses.
    pub fn named(path: &Path, name: &str, scale: f64) -> Result<Self> {
        if !(scale.is_finite() && scale.abs() <= MAX_COORDINATE) {
            let place = Place::default().element("height scale");
            return Err(place.error(format!("{scale:?} is out of range"), "choose a number up to 1e12, in scene units"));
        }
        if name == "bumps" { Ok(Self::bumps(scale)) } else { Self::load(path, scale) }
    }

    /// Smooth bumps, up to `scale` high: sums of three waves, 256 × 256 heights.
    pub fn bumps(scale: f64) -> Self {
        const SIDE: u32 = 256;
        let wave = |x: f64, y: f64| {
            let turn = std::f64::consts::TAU * (x / f64::from(SIDE));
            let other = std::f64::consts::TAU * (y / f64::from(SIDE));
            libm::sin(3.0 * turn) * libm::sin(2.0 * other)
                + libm::sin(5.0 * other + 2.0 * turn) / 2.0
                + libm::sin(7.0 * turn - 4.0 * other) / 4.0
        };
        let cells = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (f64::from(x), f64::from(y))));
        let heights = cells.map(|(x, y)| (wave(x, y) / 3.5 + 0.5) * scale).collect();
        HeightMap { columns: SIDE, rows: SIDE, heights }
    }

    /// The height at (s, t) of [0, 1]², between the four nearest cells' centres.
    fn at(&self, [s, t]: [f64; 2]) -> f64 {
        let place = |x: f64, count: u32| {
            let x = (x * f64::from(count) - 0.5).clamp(0.0, f64::from(count - 1));
            let low = x.floor();
            (low as usize, (low as usize + 1).min(count as usize - 1), x - low)
        };
        let ((left, right, x), (top, bottom, y)) = (place(s, self.columns), place(t, self.rows));
        let row = |row: usize| {
            let [a, b] = [left, right].map(|column| self.heights[row * self.columns as usize + column]);
            a + (b - a) * x
        };
        row(top) + (row(bottom) - row(top)) * y
    }
}

/// Most triangles of a relief.
const MAX_RELIEF: u64 = 1 << 21;

/// A height map over a rectangle as triangles: corners at the centres of its cells and on its border.
struct Relief<'a> {
    rect: &'a Rect,
    up: Vector,
    map: &'a HeightMap,
}

impl Relief<'_> {
    /// A corner by its number along each side: 0 is on the border, 1 the first centre.
    fn corner(&self, [column, row]: [u32; 2]) -> Vector {
        let HeightMap { columns, rows, heights } = self.map;
        let part = |k: u32, count: u32| ((f64::from(k) - 0.5) / f64::from(count)).clamp(0.0, 1.0);
        let near = |k: u32, count: u32| k.max(1).min(count) - 1;
        let height = heights[(near(row, *rows) * columns + near(column, *columns)) as usize];
        let along = add(scale(self.rect.u, part(column, *columns)), scale(self.rect.v, part(row, *rows)));
        add(add(self.rect.corner, along), scale(self.up, height))
    }

    /// The triangles of the cell between four corners: the one along the columns first.
    fn cell(&self, [column, row]: [u32; 2]) -> [[Vector; 3]; 2] {
        let at = |right: u32, down: u32| self.corner([column + right, row + down]);
        [[at(0, 0), at(1, 0), at(1, 1)], [at(0, 0), at(1, 1), at(0, 1)]]
    }

    /// The receiver at (s, t) of [0, 1]², on its triangle.
    fn spot(&self, [s, t]: [f64; 2]) -> Spot {
        let place = |x: f64, count: u32| {
            let cell = ((x * f64::from(count) + 0.5).floor() as u32).min(count);
            let knot = |k: u32| ((f64::from(k) - 0.5) / f64::from(count)).clamp(0.0, 1.0);
            (cell, (x - knot(cell)) / (knot(cell + 1) - knot(cell)))
        };
        let ((column, x), (row, y)) = (place(s, self.map.columns), place(t, self.map.rows));
        let [along, down] = self.cell([column, row]);
        // From a along one side of the cell, then along the other: to b and c, or to c and b.
        let (corners, at) = if x >= y {
            (along, add(along[0], add(scale(sub(along[1], along[0]), x), scale(sub(along[2], along[1]), y))))
        } else {
            (down, add(down[0], add(scale(sub(down[2], down[0]), y), scale(sub(down[1], down[2]), x))))
        };
        let [a, b, c] = corners;
        let normal = normalize(cross(sub(b, a), sub(c, a)));
        Spot { at, normal: if dot(normal, self.up) < 0.0 { scale(normal, -1.0) } else { normal } }
    }
}

impl Surface {
    /// What it casts shadows with.
    ///
    /// # Errors
    ///
    /// A relief of too many triangles.
    pub(super) fn casters(&self, light: &Rect) -> Result<Vec<[[f64; 3]; 3]>> {
        let Surface::Relief(rect, map) = self else { return Ok(Vec::new()) };
        let count = 2 * (u64::from(map.columns) + 1) * (u64::from(map.rows) + 1);
        if count > MAX_RELIEF {
            let what = format!("{} by {} heights make {count} triangles", map.columns, map.rows);
            let remedy = format!("scale the heights down: at most {MAX_RELIEF} triangles cast shadows on themselves");
            return Err(Place::default().element("heights").error(what, remedy));
        }
        let relief = Relief { rect, up: facing(rect, light), map };
        let cells = (0..=map.rows).flat_map(|row| (0..=map.columns).map(move |column| [column, row]));
        Ok(cells.flat_map(|cell| relief.cell(cell)).collect())
    }

    /// Its receivers at `resolution`², row after row; none where a texel has no surface.
    ///
    /// # Errors
    ///
    /// A lightmap whose texture coordinates overlap at this resolution.
    pub fn spots(&self, resolution: u32, light: &Rect) -> Result<Vec<Option<Spot>>> {
        let (rect, map) = match self {
            Surface::Plane(rect) => (rect, None),
            Surface::Heights(rect, map) => (rect, Some(map)),
            Surface::Relief(rect, map) => return Ok(relief(rect, map, resolution, light)),
            Surface::View(rect, camera) => return seen(rect, camera, resolution, light),
            Surface::Lightmap(atlas) => return atlas.spots(resolution),
        };
        let up = facing(rect, light);
        let point = |s: f64, t: f64| {
            let flat = add(rect.corner, add(scale(rect.u, s), scale(rect.v, t)));
            map.map_or(flat, |map| add(flat, scale(up, map.at([s, t]))))
        };
        let texel = 1.0 / f64::from(resolution);
        let spot = |index: u32| {
            let [s, t] = [index % resolution, index / resolution].map(|i| (f64::from(i) + 0.5) * texel);
            let across = sub(point(s + texel / 2.0, t), point(s - texel / 2.0, t));
            let down = sub(point(s, t + texel / 2.0), point(s, t - texel / 2.0));
            let normal = normalize(cross(across, down));
            let normal = if dot(normal, up) < 0.0 { scale(normal, -1.0) } else { normal };
            Some(Spot { at: point(s, t), normal })
        };
        Ok((0..resolution * resolution).map(spot).collect())
    }
}

/// The receivers of a relief.
fn relief(rect: &Rect, map: &HeightMap, resolution: u32, light: &Rect) -> Vec<Option<Spot>> {
    let relief = Relief { rect, up: facing(rect, light), map };
    let part = |i: u32| (f64::from(i) + 0.5) / f64::from(resolution);
    (0..resolution * resolution).map(|i| Some(relief.spot([part(i % resolution), part(i / resolution)]))).collect()
}

/// The points of a rectangle that a camera sees at the centres of its pixels, of a picture as wide as high.
fn seen(rect: &Rect, camera: &Camera, resolution: u32, light: &Rect) -> Result<Vec<Option<Spot>>> {
    let up = facing(rect, light);
    let spot = |index: u32| {
        let [column, row] = [index % resolution, index / resolution].map(f64::from);
        let (at, parts) = met(rect, camera, [column, row], resolution)?;
        parts.iter().all(|part| (0.0..=1.0).contains(part)).then_some(Spot { at, normal: up })
    };
    let spots: Vec<Option<Spot>> = (0..resolution * resolution).map(spot).collect();
    if spots.iter().all(Option::is_none) {
        let what = format!("the camera `{}` does not see the receiver", camera.name);
        return Err(Place::default().element("camera").error(what, "turn it, or move it"));
    }
    Ok(spots)
}

/// Where the ray through the middle of a pixel meets a rectangle's plane, and at which parts of its sides.
pub(super) fn met(rect: &Rect, camera: &Camera, pixel: [f64; 2], resolution: u32) -> Option<(Vector, [f64; 2])> {
    let (normal, foot) = (cross(rect.u, rect.v), sub(rect.corner, camera.eye));
    let [x, y] = pixel.map(|i| 2.0 * (i + 0.5) / f64::from(resolution) - 1.0);
    let aside = |half: f64| add(scale(camera.right, x * half), scale(camera.up, -y * half));
    let (from, way) = match camera.lens {
        Lens::Perspective { slope, .. } => ([0.0; 3], add(camera.forward, aside(slope))),
        Lens::Orthographic { height } => (aside(height / 2.0), camera.forward),
    };
    let distance = dot(normal, sub(foot, from)) / dot(normal, way);
    let at = add(add(camera.eye, from), scale(way, distance));
    let part = |side: Vector| dot(side, sub(at, rect.corner)) / dot(side, side);
    // A ray along the plane meets it nowhere: its distance is no number, or beyond all.
    (distance > 0.0 && distance.is_finite()).then(|| (at, [part(rect.u), part(rect.v)]))
}

/// The unit normal of a rectangle on the side that a light is on.
fn facing(rect: &Rect, light: &Rect) -> Vector {
    let normal = normalize(cross(rect.u, rect.v));
    let middle = add(light.corner, scale(add(light.u, light.v), 0.5));
    if dot(normal, sub(middle, rect.corner)) < 0.0 { scale(normal, -1.0) } else { normal }
}

/// Refuses a rectangle without area.
pub(super) fn check_area(rect: &Rect, what: &str) -> Result<(), Error> {
    if length(cross(rect.u, rect.v)) > 0.0 {
        return Ok(());
    }
    Err(Place::default().error(format!("the {what} has no area"), "give it two sides of some length"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLOOR: Rect = Rect { corner: [0.0; 3], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, 4.0] };
    const ABOVE: Rect = Rect { corner: [1.0, 5.0, 1.0], u: [1.0, 0.0, 0.0], v: [0.0, 0.0, 1.0] };

    #[test]
    fn a_plane_receives_on_the_lights_side() {
        let spots = Surface::Plane(FLOOR).spots(2, &ABOVE).unwrap();
        assert_eq!(spots[1], Some(Spot { at: [3.0, 0.0, 1.0], normal: [0.0, 1.0, 0.0] }));
        let below = Rect { corner: [1.0, -5.0, 1.0], ..ABOVE };
        assert_eq!(Surface::Plane(FLOOR).spots(2, &below).unwrap()[0].unwrap().normal, [0.0, -1.0, 0.0]);
    }

    #[test]
    fn a_camera_sees_the_floor_in_perspective_and_without() {
        let up = [0.0, 1.0, 0.0];
        let camera = |lens| Camera::look_at("test", [2.0, 4.0, 6.0], [2.0, 0.0, 2.0], up, lens).unwrap();
        let spots = |lens| Surface::View(FLOOR, camera(lens)).spots(9, &ABOVE);
        for lens in [Lens::angle(40.0).unwrap(), Lens::Orthographic { height: 3.0 }] {
            let spots = spots(lens).unwrap();
            let middle = spots[40].unwrap();
            assert!(length(sub(middle.at, [2.0, 0.0, 2.0])) < 1e-12 && middle.normal == up, "{middle:?}");
            // Higher in the picture is farther away, and to the right is towards +x.
            let (above, right) = (spots[31].unwrap().at, spots[41].unwrap().at);
            assert!(above[2] < 2.0 && right[0] > 2.0 && above[1].abs() < 1e-12, "{above:?} {right:?}");
        }
        assert!(spots(Lens::angle(120.0).unwrap()).unwrap()[0].is_none(), "the sky has no receiver");
        let away = Camera::look_at("away", [0.0, 4.0, 0.0], [0.0, 8.0, 0.0], up, Lens::angle(40.0).unwrap()).unwrap();
        let error = Surface::View(FLOOR, away).spots(4, &ABOVE).unwrap_err().to_string();
        assert!(error.contains("`away` does not see"), "{error}");
    }

    #[test]
    fn heights_move_receivers_and_turn_their_normals() {
        let slope = HeightMap::new(2, 1, vec![0.0, 2.0]).unwrap();
        let spots = Surface::Heights(FLOOR, slope).spots(4, &ABOVE).unwrap();
        let heights: Vec<f64> = spots[..4].iter().map(|spot| spot.unwrap().at[1]).collect();
        assert_eq!(heights, [0.0, 0.5, 1.5, 2.0]);
        let [x, y, z] = spots[1].unwrap().normal;
        assert!(x < 0.0 && y > 0.0 && z == 0.0, "{x} {y} {z}");
        // On its triangles: the border is as high as the nearest height, and between the two it is straight.
        let slope = HeightMap::new(2, 1, vec![0.0, 2.0]).unwrap();
        let relief = Surface::Relief(FLOOR, slope);
        let spots = relief.spots(4, &ABOVE).unwrap();
        let heights: Vec<f64> = spots[..4].iter().map(|spot| spot.unwrap().at[1]).collect();
        assert_eq!(heights, [0.0, 0.5, 1.5, 2.0]);
        let casters = relief.casters(&ABOVE).unwrap();
        assert_eq!(casters.len(), 2 * 3 * 2);
        let within = |spot: &Spot, t: &[Vector; 3]| {
            let n = normalize(cross(sub(t[1], t[0]), sub(t[2], t[0])));
            dot(n, sub(spot.at, t[0])).abs() < 1e-12 && dot(n, spot.normal).abs() > 1.0 - 1e-12
        };
        assert!(spots.iter().flatten().all(|spot| casters.iter().any(|t| within(spot, t))));
        let many = Surface::Relief(FLOOR, HeightMap::new(2000, 2000, vec![0.0; 4_000_000]).unwrap());
        assert!(many.casters(&ABOVE).unwrap_err().to_string().contains("8008002 triangles"));
        let bumps = HeightMap::bumps(0.5);
        assert!(bumps.heights.iter().all(|h| (0.0..=0.5).contains(h)));
        assert!(HeightMap::new(2, 2, vec![0.0; 3]).is_err() && HeightMap::new(1, 1, vec![f64::NAN]).is_err());
    }
}

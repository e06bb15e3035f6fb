//! Cameras: where one stands, where it looks, and its lens; from glTF, from words, or along a path.
//!
//! Words are `EYE/TARGET` or `EYE/TARGET/LENS`, points as `x,y,z`; a lens is the angle from bottom to top in degrees
//! (`45`), or the height of an orthographic picture in scene units (`height=8`). Invariant: the axes of a camera are at
//! right angles and of length 1, and the same bits on every host.

use crate::error::{Place, Result};
use crate::vector::{Vector, cross, dot, length, normalize, scale, sub};

/// The angle of a lens that nothing is said about, in degrees from bottom to top.
pub const DEFAULT_ANGLE: f64 = 45.0;

/// How a camera projects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lens {
    /// In perspective.
    Perspective {
        /// Tangent of half the angle from bottom to top.
        slope: f64,
        /// Distance of the near plane in scene units; none: just before what is nearest.
        near: Option<f64>,
    },
    /// Without perspective.
    Orthographic {
        /// Scene units from bottom to top.
        height: f64,
    },
}

/// A camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Name in its file, or its words.
    pub name: String,
    /// Where it stands.
    pub eye: [f64; 3],
    /// To the right of its picture.
    pub right: [f64; 3],
    /// Upwards in its picture.
    pub up: [f64; 3],
    /// Where it looks.
    pub forward: [f64; 3],
    /// How it projects.
    pub lens: Lens,
}

impl Lens {
    /// A lens in perspective of an angle from bottom to top, in degrees.
    ///
    /// # Errors
    ///
    /// An angle that is not between 0.1 and 170 degrees.
    pub fn angle(degrees: f64) -> Result<Self> {
        if !(0.1..=170.0).contains(&degrees) {
            let what = format!("an angle of {degrees:?} degrees from bottom to top");
            return Err(Place::default().element("camera").error(what, "choose 0.1 to 170 degrees"));
        }
        Ok(Lens::Perspective { slope: libm::tan(degrees * std::f64::consts::PI / 360.0), near: None })
    }
}

impl Camera {
    /// A camera at `eye` that looks at `target`, upright with respect to `up`; where it looks along `up`, another axis
    /// is up in its picture.
    ///
    /// # Errors
    ///
    /// Points that are not finite or coincide.
    pub fn look_at(name: impl Into<String>, eye: [f64; 3], target: [f64; 3], up: [f64; 3], lens: Lens) -> Result<Self> {
        let name = name.into();
        let way = sub(target, eye);
        let distance = length(way);
        if !distance.is_finite() || distance == 0.0 {
            let what = format!("the camera stands at {eye:?} and looks at {target:?}");
            return Err(Place::default().element("camera").error(what, "give two points that differ"));
        }
        let forward = scale(way, 1.0 / distance);
        let upright = |up: Vector| {
            let right = cross(forward, up);
            (dot(right, right) > 1e-12 * dot(up, up)).then(|| normalize(right))
        };
        let axes = [up, [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
        let right = axes.into_iter().find_map(upright).unwrap_or([1.0, 0.0, 0.0]);
        Ok(Camera { name, eye, right, up: cross(right, forward), forward, lens })
    }

    /// Reads `EYE/TARGET[/LENS]`; the answer is none for words of another shape, such as a name.
    ///
    /// # Errors
    ///
    /// What [`Lens::angle`] and [`Camera::look_at`] refuse.
    pub fn parse(words: &str, up: [f64; 3]) -> Result<Option<Self>> {
        let parts: Vec<&str> = words.split('/').collect();
        let (eye, target, lens) = match *parts {
            [eye, target] => (eye, target, None),
            [eye, target, lens] => (eye, target, Some(lens)),
            _ => return Ok(None),
        };
        let (Some(eye), Some(target)) = (point(eye), point(target)) else { return Ok(None) };
        let lens = lens.map_or_else(|| Lens::angle(DEFAULT_ANGLE), parse_lens)?;
        Camera::look_at(words, eye, target, up, lens).map(Some)
    }

    /// `count` cameras on a level circle through this one's eye about the axis `up` through `target`, this one first,
    /// all looking at `target`.
    ///
    /// # Errors
    ///
    /// What [`Camera::look_at`] refuses.
    pub fn orbit(&self, target: [f64; 3], up: [f64; 3], count: u32) -> Result<Vec<Self>> {
        let axis = normalize(up);
        let arm = sub(self.eye, target);
        let level = scale(axis, dot(arm, axis));
        let out = sub(arm, level);
        let side = cross(axis, out);
        let camera = |number: u32| {
            let (s, c) = libm::sincos(std::f64::consts::TAU * f64::from(number) / f64::from(count));
            let eye = [0, 1, 2].map(|i| target[i] + level[i] + c * out[i] + s * side[i]);
            Camera::look_at(format!("{} {number}", self.name), eye, target, up, self.lens)
        };
        (0..count).map(camera).collect()
    }
}

/// `x,y,z`.
fn point(words: &str) -> Option<Vector> {
    let mut parts = words.split(',').map(|word| word.trim().parse::<f64>().ok());
    let found = [parts.next()??, parts.next()??, parts.next()??];
    parts.next().is_none().then_some(found)
}

fn parse_lens(words: &str) -> Result<Lens> {
    let refused = || {
        let what = format!("`{words}` is no lens");
        Place::default().element("camera").error(what, "give degrees, as 45, or height= and scene units, as height=8")
    };
    match words.strip_prefix("height=") {
        None => Lens::angle(words.trim().parse().map_err(|_| refused())?),
        Some(height) => match height.trim().parse::<f64>() {
            Ok(height) if height > 0.0 && height.is_finite() => Ok(Lens::Orthographic { height }),
            _ => Err(refused()),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vector = [0.0, 1.0, 0.0];

    #[test]
    fn axes_are_at_right_angles_also_where_the_camera_looks_along_up() {
        for target in [[0.0, 0.0, -5.0], [3.0, -2.0, 1.0], [0.0, -9.0, 0.0], [0.0, 1e-3, 0.0]] {
            let Camera { right, up, forward, .. } =
                Camera::look_at("", [0.0; 3], target, UP, Lens::Orthographic { height: 1.0 }).unwrap();
            for (a, b) in [(right, up), (up, forward), (forward, right)] {
                assert!(dot(a, b).abs() < 1e-12 && (length(a) - 1.0).abs() < 1e-12, "{target:?}");
            }
            assert!(dot(cross(right, up), forward) < -0.999, "x to the right, y up, z towards the viewer");
        }
        let level = Camera::look_at("", [0.0; 3], [0.0, 0.0, -5.0], UP, Lens::Orthographic { height: 1.0 }).unwrap();
        assert_eq!((level.right, level.up), ([1.0, 0.0, 0.0], UP));
    }

    #[test]
    fn words_are_read_names_are_left_and_nonsense_is_refused() {
        let camera = Camera::parse("1,2,3/1, 2, -4", UP).unwrap().unwrap();
        assert_eq!((camera.eye, camera.forward), ([1.0, 2.0, 3.0], [0.0, 0.0, -1.0]));
        let Lens::Perspective { slope, near: None } = camera.lens else { panic!("{:?}", camera.lens) };
        assert!((slope - 0.41421356).abs() < 1e-7);
        let flat = Camera::parse("0,0,9/0,0,0/height=4", UP).unwrap().unwrap();
        assert_eq!(flat.lens, Lens::Orthographic { height: 4.0 });
        for name in ["front", "a/b", "1,2/3,4,5", "1,2,3", "1,2,3,4/0,0,0", "a/b/c/d"] {
            assert_eq!(Camera::parse(name, UP).unwrap(), None, "{name}");
        }
        for bad in ["1,2,3/1,2,3", "1,2,3/0,0,0/180", "1,2,3/0,0,0/wide", "1,2,3/0,0,0/height=0", "1,2,inf/0,0,0"] {
            let message = Camera::parse(bad, UP).unwrap_err().to_string();
            assert!(message.contains("camera: ") && message.contains("remedy: "), "{bad}: {message}");
        }
    }

    #[test]
    fn an_orbit_keeps_height_and_distance() {
        let camera = Camera::parse("3,2,0/0,1,0", UP).unwrap().unwrap();
        let orbit = camera.orbit([0.0, 1.0, 0.0], UP, 4).unwrap();
        assert_eq!(orbit[0].eye, [3.0, 2.0, 0.0]);
        let expected = [[3.0, 2.0, 0.0], [0.0, 2.0, -3.0], [-3.0, 2.0, 0.0], [0.0, 2.0, 3.0]];
        for (camera, expected) in orbit.iter().zip(expected) {
            assert!(length(sub(camera.eye, expected)) < 1e-12, "{:?}", camera.eye);
        }
    }
}

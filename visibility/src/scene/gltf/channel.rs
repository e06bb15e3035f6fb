//! Channels of a glTF animation: the value of a node's property at a time, by the format's three interpolations.
//!
//! glTF 2.0, appendix C: STEP holds the key before, LINEAR mixes the keys around the time (rotations along the shorter
//! arc of the sphere), CUBICSPLINE is Hermite's cubic through the keys, with tangents a second. Before the first key
//! and after the last the value is theirs. Invariant: a rotation has length 1, whatever the keys and tangents of the
//! file.

use std::path::Path;

use gltf::animation::{Interpolation, Property};

use super::REMEDY;
use super::accessor::Buffers;
use super::animation::Rest;
use crate::error::{Place, Result};

#[derive(Clone, Debug)]
pub(super) struct Channel {
    pub(super) node: usize,
    property: Property,
    interpolation: Interpolation,
    times: Vec<f64>,
    /// A value a key; of splines the tangent before it, the value, and the tangent behind it.
    values: Vec<f64>,
}

impl Channel {
    pub(super) fn read(
        path: &Path,
        buffers: &Buffers<'_>,
        node: usize,
        channel: &gltf::animation::Channel<'_>,
    ) -> Result<Self> {
        let place = || Place::file(path).element(format!("channel {} of the animation", channel.index()));
        let (sampler, property) = (channel.sampler(), channel.target().property());
        let interpolation = sampler.interpolation();
        let width = if property == Property::Rotation { 4 } else { 3 };
        let (times, values) = (buffers.times(&sampler.input())?, buffers.keys(&sampler.output(), width)?);
        if let Some(bad) = times.iter().chain(&values).find(|value| !value.is_finite()) {
            return Err(place().error(format!("a time or a value is {bad:?}"), REMEDY));
        }
        if let Some(at) = times.windows(2).position(|pair| pair[0] >= pair[1]) {
            let what = format!("key {} is at {:?} s and the next at {:?} s", at + 1, times[at], times[at + 1]);
            return Err(place().error(what, "export it with keys in the order of time"));
        }
        let each = if interpolation == Interpolation::CubicSpline { 3 } else { 1 };
        if times.is_empty() || values.len() != each * width * times.len() {
            let (keys, found) = (times.len(), values.len() / width);
            return Err(place().error(format!("{keys} keys and {found} values, where each key has {each}"), REMEDY));
        }
        Ok(Channel { node, property, interpolation, times, values })
    }

    /// The time of the last key.
    pub(super) fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    pub(super) fn apply(&self, time: f64, rest: &mut Rest) {
        // A node with a matrix is not animated, as the format says.
        let Rest::Parts { translation, rotation, scale } = rest else { return };
        match self.property {
            Property::Translation => *translation = self.sample(time, straight),
            Property::Scale => *scale = self.sample(time, straight),
            Property::Rotation => *rotation = unit(self.sample(time, between)),
            Property::MorphTargetWeights => {}
        }
    }

    /// The value at a time, by its neighbours.
    fn sample<const N: usize>(&self, time: f64, mix: fn([f64; N], [f64; N], f64) -> [f64; N]) -> [f64; N] {
        let values = self.values.as_chunks::<N>().0;
        let spline = self.interpolation == Interpolation::CubicSpline;
        let value = |key: usize| values[if spline { 3 * key + 1 } else { key }];
        let after = self.times.partition_point(|key| *key <= time);
        let (Some(before), true) = (after.checked_sub(1), after < self.times.len()) else {
            return value(after.min(self.times.len() - 1));
        };
        let whole = self.times[after] - self.times[before];
        let part = (time - self.times[before]) / whole;
        match self.interpolation {
            Interpolation::Step => value(before),
            Interpolation::Linear => mix(value(before), value(after), part),
            Interpolation::CubicSpline => {
                let [leaving, arriving] = [3 * before + 2, 3 * after].map(|at| values[at].map(|c| whole * c));
                hermite([value(before), leaving, value(after), arriving], part)
            }
        }
    }
}

fn straight<const N: usize>(a: [f64; N], b: [f64; N], t: f64) -> [f64; N] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * t)
}

/// The cubic from `a`, left with `leaving`, to `b`, reached with `arriving`, where t goes from 0 to 1.
fn hermite<const N: usize>([a, leaving, b, arriving]: [[f64; N]; 4], t: f64) -> [f64; N] {
    let (square, cube) = (t * t, t * t * t);
    let weights = [2.0 * cube - 3.0 * square + 1.0, cube - 2.0 * square + t, 3.0 * square - 2.0 * cube, cube - square];
    let [at_a, out, at_b, into] = weights;
    std::array::from_fn(|i| at_a * a[i] + out * leaving[i] + at_b * b[i] + into * arriving[i])
}

/// The rotation between two, along the shorter arc.
fn between(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    let (a, b) = (unit(a), unit(b));
    let dot = (0..4).map(|i| a[i] * b[i]).sum::<f64>();
    let b = if dot < 0.0 { b.map(|c| -c) } else { b };
    let angle = libm::acos(dot.abs().min(1.0));
    let (from, to) = if angle > 1e-4 {
        let whole = libm::sin(angle);
        (libm::sin((1.0 - t) * angle) / whole, libm::sin(t * angle) / whole)
    } else {
        (1.0 - t, t)
    };
    std::array::from_fn(|i| from * a[i] + to * b[i])
}

/// At length 1; no rotation where there is no length.
fn unit(rotation: [f64; 4]) -> [f64; 4] {
    let length = rotation.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length > 0.0 { rotation.map(|c| c / length) } else { [0.0, 0.0, 0.0, 1.0] }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HALF: f64 = std::f64::consts::FRAC_1_SQRT_2;

    fn near<const N: usize>(found: [f64; N], expected: [f64; N]) {
        assert!((0..N).all(|i| (found[i] - expected[i]).abs() < 1e-12), "{found:?}, not {expected:?}");
    }

    fn channel(interpolation: Interpolation, property: Property, times: &[f64], values: &[f64]) -> Channel {
        Channel { node: 0, property, interpolation, times: times.to_vec(), values: values.to_vec() }
    }

    fn rotated(channel: &Channel, time: f64) -> [f64; 4] {
        let mut rest = Rest::Parts { translation: [0.0; 3], rotation: [0.0, 0.0, 0.0, 1.0], scale: [1.0; 3] };
        channel.apply(time, &mut rest);
        let Rest::Parts { rotation, .. } = rest else { panic!("it has become a matrix") };
        rotation
    }

    #[test]
    fn rotations_go_the_shorter_way_at_an_even_pace() {
        let quarter = [0.0, 0.0, HALF, HALF];
        for target in [quarter, quarter.map(|c| -c)] {
            let third = between([0.0, 0.0, 0.0, 1.0], target, 1.0 / 3.0);
            near(third, [0.0, 0.0, libm::sin(std::f64::consts::PI / 12.0), libm::cos(std::f64::consts::PI / 12.0)]);
        }
        near(between(quarter, quarter, 0.7), quarter);
    }

    #[test]
    fn each_interpolation_gives_what_is_computed_by_hand() {
        let (times, ends) = ([1.0, 3.0], [2.0, 0.0, -1.0, 6.0, 4.0, 1.0]);
        let step = channel(Interpolation::Step, Property::Translation, &times, &ends);
        let linear = channel(Interpolation::Linear, Property::Translation, &times, &ends);
        for (time, held, mixed) in [
            (0.0, [2.0, 0.0, -1.0], [2.0, 0.0, -1.0]),
            (1.0, [2.0, 0.0, -1.0], [2.0, 0.0, -1.0]),
            (1.5, [2.0, 0.0, -1.0], [3.0, 1.0, -0.5]),
            (3.0, [6.0, 4.0, 1.0], [6.0, 4.0, 1.0]),
            (9.0, [6.0, 4.0, 1.0], [6.0, 4.0, 1.0]),
        ] {
            near(step.sample(time, straight), held);
            near(linear.sample(time, straight), mixed);
        }
        // Into, value and out of two keys. The first tangent in and the last one out do not matter.
        let keys = [[99.0; 3], [2.0, 0.0, -1.0], [4.0, 0.0, 1.0], [-2.0, 0.0, 1.0], [6.0, 4.0, 1.0], [99.0; 3]];
        let spline = channel(Interpolation::CubicSpline, Property::Scale, &times, keys.as_flattened());
        // At 1.5 s a quarter has passed: the weights are 27/32, 9/64, 5/32 and -3/64, and tangents count twice.
        let quarter = [54.0 / 32.0 + 72.0 / 64.0 + 30.0 / 32.0 + 12.0 / 64.0, 20.0 / 32.0, -0.5];
        // In the middle they are 1/2, 1/8, 1/2 and -1/8.
        for (time, expected) in [
            (0.5, [2.0, 0.0, -1.0]),
            (1.0, [2.0, 0.0, -1.0]),
            (1.5, quarter),
            (2.0, [5.5, 2.0, 0.0]),
            (3.0, [6.0, 4.0, 1.0]),
            (7.0, [6.0, 4.0, 1.0]),
        ] {
            near(spline.sample(time, straight), expected);
        }
    }

    #[test]
    fn a_spline_whose_tangents_are_the_slope_is_straight_and_its_slope_at_a_key_is_the_tangent() {
        let keys = [0.0, 1.0, 3.0, 3.0, 7.0, 0.0].map(|x| [x, 0.0, 0.0]);
        let spline = channel(Interpolation::CubicSpline, Property::Translation, &[0.0, 2.0], keys.as_flattened());
        for time in [0.25, 1.0, 1.875] {
            near(spline.sample(time, straight), [1.0 + 3.0 * time, 0.0, 0.0]);
        }
        let bent = [0.0, 1.0, 5.0, -3.0, 7.0, 0.0].map(|x| [x, 0.0, 0.0]);
        let spline = channel(Interpolation::CubicSpline, Property::Translation, &[0.0, 2.0], bent.as_flattened());
        let slope = |from: f64, to: f64| {
            (spline.sample(to, straight::<3>)[0] - spline.sample(from, straight::<3>)[0]) / (to - from)
        };
        assert!((slope(0.0, 1e-6) - 5.0).abs() < 1e-4 && (slope(2.0 - 1e-6, 2.0 - 1e-12) + 3.0).abs() < 1e-4);
    }

    #[test]
    fn rotations_have_length_one_whatever_the_file_says() {
        // A quarter turn about z, its key of length 2; the spline's tangents are 0.
        let (rest, quarter, none) = ([0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 2.0 * HALF, 2.0 * HALF], [0.0; 4]);
        let times = [0.0, 1.0];
        let linear = channel(Interpolation::Linear, Property::Rotation, &times, [rest, quarter].as_flattened());
        let spline = channel(
            Interpolation::CubicSpline,
            Property::Rotation,
            &times,
            [none, rest, none, none, quarter, none].as_flattened(),
        );
        let eighth = [0.0, 0.0, libm::sin(std::f64::consts::PI / 8.0), libm::cos(std::f64::consts::PI / 8.0)];
        near(rotated(&linear, 0.5), eighth);
        near(rotated(&linear, 1.0), [0.0, 0.0, HALF, HALF]);
        // Half of each: (0, 0, 0.7071, 1.2071) at length 1.
        let long = (HALF * HALF + (0.5 + HALF) * (0.5 + HALF)).sqrt();
        near(rotated(&spline, 0.5), [0.0, 0.0, HALF / long, (0.5 + HALF) / long]);
        let nothing = channel(Interpolation::Step, Property::Rotation, &times, [none, none].as_flattened());
        near(rotated(&nothing, 0.5), rest);
    }
}

//! Scenes that move without a file: a skeleton that walks on the spot, and a cloth that waves.
//!
//! Both repeat after one period of time 1, in f64 and `libm`, so that every frame is the same bits on every host.

use std::f64::consts::TAU;

use crate::scene::{Mesh, Scene};
use crate::vector::{Vector, add, cross, length, normalize, scale, sub};

/// Vertices around a bone, and rings of them.
const AROUND: u32 = 8;
const RINGS: u32 = 19;

/// Vertices along each side of the cloth.
const THREADS: u32 = 57;

/// A bone from one end to the other by way of a bend.
struct Bone {
    ends: [Vector; 2],
    bend: Vector,
    /// In the middle.
    radius: f64,
    /// How much thicker it is towards its ends.
    knobs: f64,
}

fn straight(from: Vector, to: Vector, radius: f64) -> Bone {
    Bone { ends: [from, to], bend: scale(add(from, to), 0.5), radius, knobs: 0.6 }
}

/// Turned about the axis x, which points to the right, and forwards for a positive angle.
fn swing(length: f64, angle: f64) -> Vector {
    let (s, c) = libm::sincos(angle);
    [0.0, -length * c, length * s]
}

/// A skeleton of 54 bones and 8,316 vertices, 1.75 metres tall, that looks along z.
pub(in crate::scene) fn skeleton(time: f64) -> Scene {
    let bones = pose(TAU * time);
    let mut mesh = Mesh::named("skeleton");
    bones.iter().for_each(|bone| sweep(bone, &mut mesh));
    Scene { name: "skeleton".into(), units: "metres", parts: vec![mesh] }
}

fn pose(phase: f64) -> Vec<Bone> {
    let (s, c) = libm::sincos(phase);
    let bob = 0.02 * (1.0 - libm::cos(2.0 * phase));
    let hips = [0.0, 0.95 + bob, 0.0];
    let spine = |part: f64| add(hips, [0.015 * s * part, 0.52 * part, -0.05 * libm::sin(TAU * 0.5 * part)]);
    let mut bones = vec![straight(add(hips, [-0.13, 0.0, 0.0]), add(hips, [0.13, 0.0, 0.0]), 0.055)];
    bones.extend((0..10).map(|i| straight(spine(f64::from(i) / 10.0), spine(f64::from(i + 1) / 10.0), 0.028)));
    let head = add(spine(1.0), [0.0, 0.06, 0.01]);
    bones.push(Bone { knobs: 0.0, ..straight(head, add(head, [0.0, 0.23, 0.04]), 0.1) });
    for side in [-1.0, 1.0] {
        let across = |x: f64, y: f64, z: f64| [side * x, y, z];
        for rib in 0..8 {
            let at = spine(0.42 + 0.07 * f64::from(rib));
            let size = 1.0 - 0.07 * (f64::from(rib) - 3.0) * (f64::from(rib) - 3.0) / 3.0;
            let front = add(at, across(0.03, -0.1, 0.17 * size));
            bones.push(Bone {
                ends: [at, front],
                bend: add(at, across(0.25 * size, -0.04, 0.09)),
                radius: 0.011,
                knobs: 0.0,
            });
        }
        let shoulder = add(spine(0.97), across(0.19, 0.0, 0.0));
        bones.push(straight(spine(0.97), shoulder, 0.016));
        // The left arm goes with the right leg.
        let arm = -0.55 * side * s;
        let elbow = add(shoulder, add(swing(0.29, arm), across(0.04, 0.0, 0.0)));
        let wrist = add(elbow, swing(0.25, arm + 0.35 + 0.25 * (1.0 - side * s)));
        bones.extend([straight(shoulder, elbow, 0.02), straight(elbow, wrist, 0.016)]);
        bones.extend((0..5).map(|finger| {
            let spread = across(0.012 * f64::from(finger) - 0.02, 0.0, 0.01 * f64::from(finger));
            straight(wrist, add(wrist, add(swing(0.15, arm + 0.5), spread)), 0.008)
        }));
        let hip = add(hips, across(0.1, -0.02, 0.0));
        let thigh = 0.5 * side * s;
        let knee = add(hip, swing(0.43, thigh));
        let ankle = add(knee, swing(0.42, thigh - 0.15 - 0.35 * (1.0 - side * c)));
        bones.extend([straight(hip, knee, 0.027), straight(knee, ankle, 0.022)]);
        bones.extend((0..3).map(|toe| {
            let spread = across(0.025 * f64::from(toe) - 0.025, -0.05, 0.2);
            straight(ankle, add(ankle, spread), 0.014)
        }));
    }
    bones
}

/// A closed surface around a bone, thicker towards both ends.
fn sweep(bone: &Bone, mesh: &mut Mesh) {
    let [from, to] = bone.ends;
    let along = |t: f64| {
        let (a, b, c) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t);
        // The curve passes through the bend.
        let control = sub(scale(bone.bend, 2.0), scale(add(from, to), 0.5));
        add(add(scale(from, a), scale(control, b)), scale(to, c))
    };
    let first = mesh.vertices([from]);
    for ring in 0..RINGS {
        let t = (f64::from(ring) + 0.5) / f64::from(RINGS);
        let tangent = normalize(sub(along(t + 1e-3), along(t - 1e-3)));
        let other = if tangent[0].abs() < 0.8 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let u = normalize(cross(tangent, other));
        let v = cross(tangent, u);
        let middle = 2.0 * t - 1.0;
        // Without knobs an ellipsoid, with them a shaft whose ends are rounded late.
        let level = middle * middle;
        let round = (1.0 - if bone.knobs > 0.0 { level * level * level } else { level }).max(0.0).sqrt();
        let radius =
            bone.radius.min(0.5 * length(sub(to, from))) * (1.0 - 0.25 * bone.knobs + bone.knobs * level) * round;
        mesh.vertices((0..AROUND).map(|i| {
            let (s, c) = libm::sincos(TAU * f64::from(i) / f64::from(AROUND));
            add(along(t), add(scale(u, radius * c), scale(v, radius * s)))
        }));
    }
    let last = mesh.vertices([to]);
    let at = |ring: u32, i: u32| first + 1 + ring * AROUND + i % AROUND;
    for i in 0..AROUND {
        mesh.triangles.extend([[first, at(0, i + 1), at(0, i)], [last, at(RINGS - 1, i), at(RINGS - 1, i + 1)]]);
        for ring in 0..RINGS - 1 {
            mesh.quad([at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)]);
        }
    }
}

/// A cloth of 3,249 vertices, one metre wide, that hangs from its upper edge and waves.
pub(in crate::scene) fn cloth(time: f64) -> Scene {
    let mut mesh = Mesh::named("cloth");
    let step = 1.0 / f64::from(THREADS - 1);
    for row in 0..THREADS {
        let down = f64::from(row) * step;
        mesh.vertices((0..THREADS).map(|column| {
            let x = f64::from(column) * step;
            let wave = libm::sin(TAU * (2.5 * x - time + 0.35 * down)) + 0.5 * libm::sin(TAU * (4.0 * x + time - down));
            let gather = 0.25 * down * libm::sin(TAU * (x - 0.5 * time) * 2.0) * step * 10.0;
            [x - 0.5 + gather, 2.0 - down, (0.03 + 0.13 * down) * wave]
        }));
    }
    for row in 0..THREADS - 1 {
        for column in 0..THREADS - 1 {
            let at = row * THREADS + column;
            mesh.quad([at, at + THREADS, at + THREADS + 1, at + 1]);
        }
    }
    Scene { name: "cloth".into(), units: "metres", parts: vec![mesh] }
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::*;

    #[test]
    fn bones_are_closed_and_face_outwards() {
        let mesh = skeleton(0.3).parts.remove(0);
        assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (8316, 54 * 304));
        let edges = mesh.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let directed: HashSet<(u32, u32)> = edges.collect();
        assert_eq!(directed.len(), 3 * mesh.triangles.len());
        assert!(directed.iter().all(|&(a, b)| directed.contains(&(b, a))), "an edge is open");
        for bone in mesh.triangles.chunks(304) {
            let volume = bone.iter().map(|t| {
                let [a, b, c] = t.map(|i| mesh.vertices[i as usize]);
                a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            });
            assert!(volume.sum::<f64>() > 0.0);
        }
    }

    #[test]
    fn motions_repeat_and_move() {
        for motion in [skeleton, cloth] {
            let [start, middle, end] = [0.0, 0.4, 1.0].map(|time| motion(time).parts.remove(0));
            let farthest = |a: &Mesh, b: &Mesh| {
                let pairs = a.vertices.iter().zip(&b.vertices);
                pairs.map(|(p, q)| length(sub(*p, *q))).fold(0.0, f64::max)
            };
            assert!(farthest(&start, &end) < 1e-9, "{}", farthest(&start, &end));
            assert!(farthest(&start, &middle) > 0.1);
        }
        assert_eq!(cloth(0.0).parts[0].vertices.len(), 3249);
    }
}

//! Scenes that moved as a whole: turned, shifted and scaled, with nothing moved against anything else.
//!
//! Sattler et al. 2004, section 6: the visibility matrix of such a scene stays as it is, and its
//! environment is looked up in turned directions. Whether a scene moved so is told by its corners, not by what moved
//! them, so nodes, skins and generated motions are all alike. Invariants: the turn that is found takes every corner to
//! within the given slack of where it is now, and every normal to its direction; a scene that has not turned has
//! [`Turn::NONE`] exactly.

use crate::scene::{Mesh, Scene};
use crate::vector::{Vector, add, cross, length, normalize, scale, sub};

/// A rotation of a whole scene since its matrix was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Where the axes of the scene as it was point now.
    axes: [Vector; 3],
}

/// Most that a turned normal may differ from that of the scene: a unit of a surface's normals.
const NORMAL_SLACK: f64 = 1.0 / 32_768.0;

/// What three corners tell of a motion: it takes `from` to `to` and lengths to `size` times what they were.
struct Anchor {
    from: Vector,
    to: Vector,
    size: f64,
}

impl Turn {
    /// No rotation.
    pub const NONE: Turn = Turn { axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };

    /// The rotation that took all of `from` to where `to` is, but for a shift and a scale; nothing where a corner is
    /// more than `slack`, in units of `from`, beside where these take it, or where the scenes are not the same.
    pub fn between(from: &Scene, to: &Scene, slack: f64) -> Option<Turn> {
        let same = |(a, b): (&Mesh, &Mesh)| {
            a.triangles == b.triangles && a.vertices.len() == b.vertices.len() && a.normals.len() == b.normals.len()
        };
        if from.parts.len() != to.parts.len() || !from.parts.iter().zip(&to.parts).all(same) {
            return None;
        }
        let [(a, to_a), (b, to_b), (c, to_c)] = corners_far_apart(from, to)?;
        let (ahead, to_ahead) = (sub(b, a), sub(to_b, to_a));
        let anchor = Anchor { from: a, to: to_a, size: length(to_ahead) / length(ahead) };
        let turned = frame(ahead, sub(c, a)).zip(frame(to_ahead, sub(to_c, to_a))).map(|(was, is)| {
            let axis = |i: usize| (0..3).map(|k| scale(is[k], was[k][i])).fold([0.0; 3], add);
            Turn { axes: [0, 1, 2].map(axis) }
        });
        [Some(Turn::NONE), turned].into_iter().flatten().find(|turn| turn.explains(from, to, &anchor, slack))
    }

    /// Where a direction of the scene as it was points now.
    pub fn apply(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [u, v, w] = self.axes;
        add(add(scale(u, x), scale(v, y)), scale(w, z))
    }

    /// The angle of the rotation, from 0 to 180.
    pub fn degrees(&self) -> f64 {
        let trace = self.axes[0][0] + self.axes[1][1] + self.axes[2][2];
        libm::acos((0.5 * (trace - 1.0)).clamp(-1.0, 1.0)) * 180.0 / std::f64::consts::PI
    }

    fn explains(&self, from: &Scene, to: &Scene, anchor: &Anchor, slack: f64) -> bool {
        let place = |p: Vector| add(anchor.to, scale(self.apply(sub(p, anchor.from)), anchor.size));
        let near = |(p, q): (Vector, Vector)| length(sub(place(p), q)) <= slack * anchor.size;
        corners(from, to).all(near) && normals(from, to).all(|(n, m)| self.takes_normal(n, m))
    }

    /// Lengths of normals do not matter, but for those that have none.
    fn takes_normal(&self, from: Vector, to: Vector) -> bool {
        if from == [0.0; 3] || to == [0.0; 3] {
            return from == to;
        }
        length(sub(self.apply(normalize(from)), normalize(to))) <= NORMAL_SLACK
    }
}

/// Every corner of every triangle, in both scenes.
fn corners<'a>(from: &'a Scene, to: &'a Scene) -> impl Iterator<Item = (Vector, Vector)> {
    used(from, to).map(|(a, b, corner)| (a.vertices[corner], b.vertices[corner]))
}

/// The normals of those corners that have some.
fn normals<'a>(from: &'a Scene, to: &'a Scene) -> impl Iterator<Item = (Vector, Vector)> {
    used(from, to).filter_map(|(a, b, corner)| a.normals.get(corner).copied().zip(b.normals.get(corner).copied()))
}

fn used<'a>(from: &'a Scene, to: &'a Scene) -> impl Iterator<Item = (&'a Mesh, &'a Mesh, usize)> {
    let parts = from.parts.iter().zip(&to.parts);
    parts.flat_map(|(a, b)| a.triangles.as_flattened().iter().map(move |&corner| (a, b, corner as usize)))
}

/// A corner, the one that is farthest from it, and the one that is farthest from the line through both.
fn corners_far_apart(from: &Scene, to: &Scene) -> Option<[(Vector, Vector); 3]> {
    let farthest = |distance: &dyn Fn(Vector) -> f64| {
        corners(from, to).max_by(|(p, _), (q, _)| distance(*p).total_cmp(&distance(*q)))
    };
    let first = corners(from, to).next()?;
    let second = farthest(&|p| length(sub(p, first.0)))?;
    let along = sub(second.0, first.0);
    let third = farthest(&|p| length(cross(along, sub(p, first.0))))?;
    Some([first, second, third])
}

/// Axes at right angles, the first along `ahead` and the second towards `aside`, unless these are on a line.
fn frame(ahead: Vector, aside: Vector) -> Option<[Vector; 3]> {
    let across = cross(ahead, aside);
    if length(across) <= 0.0 {
        return None;
    }
    let (u, w) = (normalize(ahead), normalize(across));
    Some([u, cross(w, u), w])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Affine, generate_world};

    /// A scene of several parts, and its image.
    fn moved(map: &Affine) -> [Scene; 2] {
        let scene = generate_world("trio").unwrap().flatten();
        let parts = scene.parts.iter().map(|part| part.moved(map)).collect();
        [scene.clone(), Scene { parts, ..scene }]
    }

    /// About the axis (1, 2, 2) / 3.
    fn quaternion(degrees: f64) -> [f64; 4] {
        let (s, c) = libm::sincos(degrees * std::f64::consts::PI / 360.0);
        [s / 3.0, 2.0 * s / 3.0, 2.0 * s / 3.0, c]
    }

    #[test]
    fn what_was_turned_shifted_and_scaled_is_found() {
        for (degrees, size) in [(40.0, 1.0), (-140.0, 0.01), (180.0, 300.0), (0.01, 1.0)] {
            let map = Affine::decomposed([5.0, -80.0, 0.25], quaternion(degrees), [size; 3]);
            let [from, to] = moved(&map);
            let turn = Turn::between(&from, &to, 1e-9).unwrap();
            assert!((turn.degrees() - degrees.abs()).abs() < 1e-5, "{degrees}: {}", turn.degrees());
            for d in [[1.0, 0.0, 0.0], [0.0, 0.6, -0.8], [-0.3, 0.2, 0.1]] {
                let expected = scale(map.linear(d), 1.0 / size);
                assert!(length(sub(turn.apply(d), expected)) < 1e-9, "{degrees}: {d:?}");
            }
        }
    }

    #[test]
    fn what_was_only_shifted_or_scaled_has_not_turned_at_all() {
        for (size, shift) in [(1.0, [0.0; 3]), (1.0, [7.1, 1e3, -2.0]), (3.3, [0.0, 0.1, 0.0])] {
            let [from, to] = moved(&Affine::placed(size, shift));
            assert_eq!(Turn::between(&from, &to, 1e-9), Some(Turn::NONE), "{size} and {shift:?}");
        }
    }

    #[test]
    fn what_moved_otherwise_is_not() {
        let turn = quaternion(30.0);
        for bent in [
            Affine::decomposed([0.0; 3], turn, [1.0, 1.0, 1.001]),
            Affine::decomposed([0.0; 3], turn, [-1.0, 1.0, 1.0]),
            Affine([[1.0, 0.0, 0.0], [0.01, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]]),
        ] {
            let [from, to] = moved(&bent);
            assert_eq!(Turn::between(&from, &to, 1e-4), None, "{bent:?}");
        }
        let [from, whole] = moved(&Affine::decomposed([0.0; 3], turn, [1.0; 3]));
        let with = |edit: &dyn Fn(&mut Scene)| {
            let mut to = whole.clone();
            edit(&mut to);
            Turn::between(&from, &to, 1e-4)
        };
        assert!(with(&|_| ()).is_some());
        assert_eq!(with(&|to| to.parts[2].vertices[3][0] += 2e-4), None, "one vertex");
        assert!(with(&|to| to.parts[2].vertices[3][0] += 5e-5).is_some(), "within the slack");
        assert_eq!(with(&|to| to.parts[1] = from.parts[1].clone()), None, "one part stays");
        assert_eq!(with(&|to| to.parts[0].triangles.swap(0, 1)), None, "other triangles");
        assert_eq!(with(&|to| drop(to.parts.pop())), None, "fewer parts");
    }

    #[test]
    fn normals_must_turn_with_the_corners() {
        let [mut from, mut to] = moved(&Affine::decomposed([0.0; 3], quaternion(30.0), [2.0; 3]));
        let map = Turn::between(&from, &to, 1e-9).unwrap();
        for (was, is) in from.parts.iter_mut().zip(&mut to.parts) {
            was.normals = was.vertices.iter().map(|&v| add(v, [0.1, 0.2, 9.0])).collect();
            is.normals = was.normals.iter().map(|&n| scale(map.apply(n), 7.0)).collect();
        }
        assert_eq!(Turn::between(&from, &to, 1e-9), Some(map));
        let mut other = to.clone();
        other.parts[0].normals[5][1] += 0.1;
        assert_eq!(Turn::between(&from, &other, 1e-9), None);
        other.parts[0].normals[5] = [0.0; 3];
        assert_eq!(Turn::between(&from, &other, 1e-9), None);
        from.parts[0].normals[5] = [0.0; 3];
        assert_eq!(Turn::between(&from, &other, 1e-9), Some(map));
    }
}

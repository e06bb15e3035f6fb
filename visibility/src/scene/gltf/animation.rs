//! Animations of glTF: channels of nodes, linear or in steps, and skins over them.
//!
//! Rotations are interpolated along the sphere, as the format says; a skinned vertex is the weighted mean of where its
//! joints take it. Morph targets are left in their bind pose. Everything is f64 and `libm`.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use gltf::animation::{Interpolation, Property};
use gltf::{Document, Node, Semantic};

use super::accessor::Buffers;
use super::{REMEDY, Walk, affine, parse, roots};
use crate::error::{Place, Result};
use crate::scene::{Affine, MAX_TRIANGLES, MAX_VERTICES, Mesh, Scene, World, limit, load};
use crate::vector::{add, scale};

/// A file whose nodes move.
#[derive(Clone, Debug)]
pub struct Animated {
    path: PathBuf,
    /// Parents before their children.
    nodes: Vec<Joint>,
    meshes: Vec<Skinned>,
    skins: Vec<Vec<(usize, Affine)>>,
    channels: Vec<Channel>,
}

/// A node.
#[derive(Clone, Debug)]
struct Joint {
    name: String,
    parent: Option<usize>,
    rest: Rest,
    mesh: Option<usize>,
    skin: Option<usize>,
}

/// The transform of a node that nothing moves.
#[derive(Clone, Copy, Debug)]
enum Rest {
    Matrix(Affine),
    Parts { translation: [f64; 3], rotation: [f64; 4], scale: [f64; 3] },
}

/// A mesh, and for each vertex the joints that take it along; none where it has no skin.
#[derive(Clone, Debug)]
struct Skinned {
    mesh: Mesh,
    joints: Vec<[(usize, f64); 4]>,
}

#[derive(Clone, Debug)]
struct Channel {
    node: usize,
    property: Property,
    steps: bool,
    times: Vec<f64>,
    values: Vec<f64>,
}

impl Animated {
    pub(in crate::scene) fn read(path: &Path, bytes: &[u8]) -> Result<Self> {
        let (document, blob) = parse(path, bytes)?;
        let buffers = Buffers::load(path, &document, blob)?;
        let Some(animation) = document.animations().next() else {
            let remedy = "export the scene with its animation, or leave out --frames";
            return Err(Place::file(path).error("it has no animation", remedy));
        };
        let (order, nodes) = joints(path, &document)?;
        let place = |node: &Node<'_>| order.get(&node.index()).copied();
        let mut channels = Vec::new();
        for channel in animation.channels() {
            if let Some(node) = place(&channel.target().node())
                && channel.target().property() != Property::MorphTargetWeights
            {
                channels.push(Channel::read(path, &buffers, node, &channel)?);
            }
        }
        let mut skins = Vec::new();
        for skin in document.skins() {
            let outside = || {
                let place = Place::file(path).element(format!("skin {}", skin.index()));
                place.error("a joint is not in the scene", REMEDY)
            };
            let joints = skin.joints().map(|joint| place(&joint).ok_or_else(outside)).collect::<Result<Vec<_>>>()?;
            let inverse = match skin.inverse_bind_matrices() {
                Some(accessor) => buffers.matrices(&accessor, joints.len())?,
                None => vec![Affine::IDENTITY; joints.len()],
            };
            skins.push(joints.into_iter().zip(inverse).collect());
        }
        let world = World {
            name: load::name(path),
            units: "metres",
            meshes: Vec::new(),
            instances: Vec::new(),
            cameras: Vec::new(),
        };
        let known = HashMap::new();
        let walk = Walk { path, buffers, seen: HashSet::new(), known, world, vertices: 0, triangles: 0 };
        let (mut meshes, mut vertices, mut triangles) = (Vec::new(), 0, 0);
        for mesh in document.meshes() {
            let read = Skinned::read(&walk, &mesh)?;
            let place = || Place::file(path).element(format!("mesh {}", mesh.index()));
            vertices += read.mesh.vertices.len();
            triangles += read.mesh.triangles.len();
            limit(place(), "vertices", vertices, MAX_VERTICES)?;
            limit(place(), "triangles", triangles, MAX_TRIANGLES)?;
            meshes.push(read);
        }
        let animated = Animated { path: path.to_owned(), nodes, meshes, skins, channels };
        animated.check()?;
        Ok(animated)
    }

    /// Refuses vertices whose joints are not those of their skin.
    fn check(&self) -> Result<()> {
        for joint in &self.nodes {
            let (Some(mesh), Some(skin)) = (joint.mesh, joint.skin) else { continue };
            let (mesh, count) = (&self.meshes[mesh], self.skins[skin].len());
            let place = || Place::file(&self.path).element(format!("node `{}`", joint.name));
            if mesh.joints.len() != mesh.mesh.vertices.len() {
                return Err(place().error("it has a skin, and its mesh has no joints for some vertices", REMEDY));
            }
            if let Some(bad) = mesh.joints.as_flattened().iter().find(|(joint, _)| *joint >= count) {
                return Err(
                    place().error(format!("a vertex follows joint {}, and the skin has {count}", bad.0), REMEDY)
                );
            }
        }
        Ok(())
    }

    /// The time of the last key.
    pub(in crate::scene) fn duration(&self) -> f64 {
        self.channels.iter().filter_map(|channel| channel.times.last()).fold(0.0, |most: f64, time| most.max(*time))
    }

    pub(in crate::scene) fn at(&self, time: f64) -> Result<Scene> {
        let mut rests: Vec<Rest> = self.nodes.iter().map(|joint| joint.rest).collect();
        self.channels.iter().for_each(|channel| channel.apply(time, &mut rests[channel.node]));
        let mut places: Vec<Affine> = Vec::with_capacity(rests.len());
        for (joint, rest) in self.nodes.iter().zip(rests) {
            let own = rest.affine();
            places.push(joint.parent.map_or(own, |parent| places[parent].then(&own)));
        }
        let part = |(at, joint): (usize, &Joint)| {
            let skinned = &self.meshes[joint.mesh?];
            let mesh = match joint.skin {
                Some(skin) => {
                    skinned.bend(&self.skins[skin].iter().map(|(at, bind)| places[*at].then(bind)).collect::<Vec<_>>())
                }
                None => skinned.mesh.moved(&places[at]),
            };
            Some(Mesh { name: joint.name.clone(), ..mesh })
        };
        let parts = self.nodes.iter().enumerate().filter_map(part).collect();
        Scene { name: load::name(&self.path), units: "metres", parts }.check(&self.path)
    }
}

/// Nodes of the scene in an order that has parents before children, and where each of the file's nodes is in it.
fn joints(path: &Path, document: &Document) -> Result<(HashMap<usize, usize>, Vec<Joint>)> {
    let (mut order, mut nodes) = (HashMap::new(), Vec::new());
    let mut stack: Vec<(Node<'_>, Option<usize>)> =
        roots(document).into_iter().rev().map(|root| (root, None)).collect();
    while let Some((node, parent)) = stack.pop() {
        if order.insert(node.index(), nodes.len()).is_some() {
            let what = "the node is reached twice: the hierarchy has a cycle, or two parents share a child";
            let place = Place::file(path).element(format!("node {}", node.index()));
            return Err(place.error(what, "give every node one parent"));
        }
        let rest = match node.transform() {
            gltf::scene::Transform::Matrix { .. } => Rest::Matrix(affine(&node)),
            gltf::scene::Transform::Decomposed { translation, rotation, scale } => Rest::Parts {
                translation: translation.map(f64::from),
                rotation: rotation.map(f64::from),
                scale: scale.map(f64::from),
            },
        };
        let name = node.name().or(node.mesh().and_then(|mesh| mesh.name())).unwrap_or_default().to_owned();
        let (mesh, skin) = (node.mesh().map(|mesh| mesh.index()), node.skin().map(|skin| skin.index()));
        let children: Vec<Node<'_>> = node.children().collect();
        stack.extend(children.into_iter().rev().map(|child| (child, Some(nodes.len()))));
        nodes.push(Joint { name, parent, rest, mesh, skin });
    }
    Ok((order, nodes))
}

impl Rest {
    fn affine(self) -> Affine {
        match self {
            Rest::Matrix(affine) => affine,
            Rest::Parts { translation, rotation, scale } => Affine::decomposed(translation, rotation, scale),
        }
    }
}

impl Skinned {
    fn read(walk: &Walk<'_>, mesh: &gltf::Mesh<'_>) -> Result<Self> {
        let whole = walk.read_mesh(mesh)?;
        let mut joints = Vec::new();
        for primitive in mesh.primitives() {
            let Some(positions) = primitive.get(&Semantic::Positions) else { continue };
            let accessors = (primitive.get(&Semantic::Joints(0)), primitive.get(&Semantic::Weights(0)));
            let (Some(numbers), Some(weights)) = accessors else { continue };
            let counts = [&positions, &numbers, &weights].map(|accessor| accessor.count());
            if counts != [counts[0]; 3] {
                let [positions, numbers, weights] = counts;
                let what = format!("{positions} positions, {numbers} joints and {weights} weights");
                let element = format!("mesh {}, primitive {}", mesh.index(), primitive.index());
                return Err(Place::file(walk.path).element(element).error(what, REMEDY));
            }
            let (numbers, weights) =
                (walk.buffers.fours(&numbers, "joints")?, walk.buffers.fours(&weights, "weights")?);
            let four = |(n, w): (&[f64; 4], &[f64; 4])| {
                let sum: f64 = w.iter().sum();
                [0, 1, 2, 3].map(|i| (n[i] as usize, if sum > 0.0 { w[i] / sum } else { 0.25 }))
            };
            joints.extend(numbers.iter().zip(&weights).map(four));
        }
        Ok(Skinned { mesh: whole, joints })
    }

    /// Where the joints take it. Normals are computed anew by whoever needs them.
    fn bend(&self, joints: &[Affine]) -> Mesh {
        let vertex = |(vertex, four): (&[f64; 3], &[(usize, f64); 4])| {
            let moved = |(joint, weight): &(usize, f64)| scale(joints[*joint].apply(*vertex), *weight);
            four.iter().filter(|(_, weight)| *weight != 0.0).map(moved).fold([0.0; 3], add)
        };
        let vertices = self.mesh.vertices.iter().zip(&self.joints).map(vertex).collect();
        Mesh { vertices, triangles: self.mesh.triangles.clone(), ..Mesh::default() }
    }
}

impl Channel {
    fn read(path: &Path, buffers: &Buffers<'_>, node: usize, channel: &gltf::animation::Channel<'_>) -> Result<Self> {
        let place = || Place::file(path).element(format!("channel {} of the animation", channel.index()));
        let (sampler, property) = (channel.sampler(), channel.target().property());
        let steps = match sampler.interpolation() {
            Interpolation::Linear => false,
            Interpolation::Step => true,
            Interpolation::CubicSpline => {
                let remedy = "export it with linear keys, or bake it to frames";
                return Err(place().error("it is interpolated by cubic splines, which are not read", remedy));
            }
        };
        let width = if property == Property::Rotation { 4 } else { 3 };
        let (times, values) = (buffers.keys(&sampler.input(), 1)?, buffers.keys(&sampler.output(), width)?);
        let rising = times.windows(2).all(|pair| pair[0] < pair[1]) && times.iter().all(|time| time.is_finite());
        if times.is_empty() || !rising || values.len() != width * times.len() {
            let what = format!("{} times, which must rise, and {} values", times.len(), values.len() / width);
            return Err(place().error(what, REMEDY));
        }
        Ok(Channel { node, property, steps, times, values })
    }

    fn apply(&self, time: f64, rest: &mut Rest) {
        // A node with a matrix is not animated, as the format says.
        let Rest::Parts { translation, rotation, scale } = rest else { return };
        match self.property {
            Property::Translation => {
                *translation = self.sample(time, |a, b, t| [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t))
            }
            Property::Scale => *scale = self.sample(time, |a, b, t| [0, 1, 2].map(|i| a[i] + (b[i] - a[i]) * t)),
            Property::Rotation => *rotation = self.sample(time, between),
            Property::MorphTargetWeights => {}
        }
    }

    /// The value at a time, by its neighbours.
    fn sample<const N: usize>(&self, time: f64, mix: impl Fn([f64; N], [f64; N], f64) -> [f64; N]) -> [f64; N] {
        let values = self.values.as_chunks::<N>().0;
        let after = self.times.partition_point(|key| *key <= time);
        let (Some(before), true) = (after.checked_sub(1), after < self.times.len()) else {
            return values[after.min(values.len() - 1)];
        };
        if self.steps {
            return values[before];
        }
        let part = (time - self.times[before]) / (self.times[after] - self.times[before]);
        mix(values[before], values[after], part)
    }
}

/// The rotation between two, along the shorter arc.
fn between(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    let dot = (0..4).map(|i| a[i] * b[i]).sum::<f64>();
    let b = if dot < 0.0 { b.map(|c| -c) } else { b };
    let angle = libm::acos(dot.abs().min(1.0));
    let (from, to) = if angle > 1e-4 {
        let whole = libm::sin(angle);
        (libm::sin((1.0 - t) * angle) / whole, libm::sin(t * angle) / whole)
    } else {
        (1.0 - t, t)
    };
    let mixed = [0, 1, 2, 3].map(|i| from * a[i] + to * b[i]);
    let length = mixed.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length > 0.0 { mixed.map(|c| c / length) } else { [0.0, 0.0, 0.0, 1.0] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_go_the_shorter_way_at_an_even_pace() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let quarter = [0.0, 0.0, half, half];
        for target in [quarter, quarter.map(|c| -c)] {
            let third = between([0.0, 0.0, 0.0, 1.0], target, 1.0 / 3.0);
            let expected = [0.0, 0.0, libm::sin(std::f64::consts::PI / 12.0), libm::cos(std::f64::consts::PI / 12.0)];
            assert!((0..4).all(|i| (third[i] - expected[i]).abs() < 1e-12), "{third:?}");
        }
        assert_eq!(between(quarter, quarter, 0.7).map(|c| (c * 1e9).round()), quarter.map(|c| (c * 1e9).round()));
    }
}

//! Animations of glTF: nodes that channels move, and skins over them.
//!
//! A skinned vertex is the weighted mean of where its joints take it. Morph targets are left in their bind pose.
//! Everything is f64 and `libm`.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use gltf::animation::Property;
use gltf::{Document, Node, Semantic};

use super::accessor::Buffers;
use super::channel::Channel;
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
pub(super) enum Rest {
    Matrix(Affine),
    Parts { translation: [f64; 3], rotation: [f64; 4], scale: [f64; 3] },
}

/// A mesh, and for each vertex the joints that take it along; none where it has no skin.
#[derive(Clone, Debug)]
struct Skinned {
    mesh: Mesh,
    joints: Vec<[(usize, f64); 4]>,
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
        if channels.is_empty() {
            let remedy = "export it with keys of nodes; morph targets are not read";
            return Err(Place::file(path).error("its first animation moves no node of the scene", remedy));
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
        self.channels.iter().map(Channel::end).fold(0.0, f64::max)
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

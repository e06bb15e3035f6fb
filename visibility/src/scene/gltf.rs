//! glTF 2.0 through the `gltf` crate: nodes with their transforms, every mesh once, every use of one as an instance,
//! and cameras.
//!
//! The hierarchy must be a forest, as the format says: a node that is reached twice is refused, which ends cycles and
//! keeps shared subtrees from growing without bound. Skins and morph targets are left in their bind pose.

use std::collections::{HashMap, HashSet};
use std::path::Path;

use gltf::json::animation::Channel;
use gltf::json::validation::{Checked, Error as Reason};
use gltf::mesh::Mode;
use gltf::{Document, Node, Primitive, Semantic};

use super::{Affine, Camera, Instance, Lens, MAX_TRIANGLES, MAX_VERTICES, Mesh, UNMAPPED, World, limit, load};
use crate::error::{Place, Result};
use crate::vector::{add, cross, length, scale};

mod accessor;
mod animation;
mod channel;

use accessor::Buffers;
pub use animation::Animated;

const REMEDY: &str = "export the scene again";

/// Extensions that change shapes in ways which are not read.
const UNREADABLE: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"];

pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<World> {
    let (document, blob) = parse(path, bytes)?;
    let buffers = Buffers::load(path, &document, blob)?;
    let (meshes, instances, cameras) = (Vec::new(), Vec::new(), Vec::new());
    let world = World { name: load::name(path), units: "metres", meshes, instances, cameras };
    let mut walk =
        Walk { path, buffers, seen: HashSet::new(), known: HashMap::new(), world, vertices: 0, triangles: 0 };
    for root in roots(&document) {
        walk.tree(root)?;
    }
    Ok(walk.world)
}

/// The document, checked. Extensions of materials and the like may be required or not: they do not change a shape.
fn parse(path: &Path, bytes: &[u8]) -> Result<(Document, Option<Vec<u8>>)> {
    let place = || Place::file(path);
    // The length in a GLB's header counts the header and that of its first chunk.
    let length = bytes.get(8..12).and_then(|field| field.try_into().ok()).map_or(0, u32::from_le_bytes);
    if bytes.starts_with(b"glTF") && length < 20 {
        return Err(place().error("its header is cut off", REMEDY));
    }
    if bytes.starts_with(b"glTF") && u64::from(length) > bytes.len() as u64 {
        let what = format!("it is cut off: its header says {length} bytes, and it has {}", bytes.len());
        return Err(place().error(what, "copy the file again, or export the scene again"));
    }
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let parsed = gltf::Gltf::from_slice_without_validation(text).map_err(|e| match e {
        gltf::Error::Deserialize(e) if e.line() > 0 && !bytes.starts_with(b"glTF") => {
            Place::line(path, e.line()).error(e.to_string(), REMEDY)
        }
        e => place().error(e.to_string(), REMEDY),
    })?;
    let mut root = parsed.document.into_json();
    if let Some(name) =
        root.extensions_used.iter().chain(&root.extensions_required).find(|&e| UNREADABLE.contains(&&**e))
    {
        return Err(place().error(format!("it uses {name}, which is not read"), "export the scene without it"));
    }
    root.extensions_required.clear();
    // The crate's own validation takes these for granted.
    for (index, mesh) in root.meshes.iter().enumerate() {
        let attributes = || mesh.primitives.iter().flat_map(|primitive| primitive.attributes.values());
        if attributes().any(|accessor| accessor.value() >= root.accessors.len()) {
            return Err(place()
                .element(format!("meshes[{index}]"))
                .error("an accessor's index is out of bounds", REMEDY));
        }
    }
    for (index, animation) in root.animations.iter().enumerate() {
        let place = |channel: usize| place().element(format!("animations[{index}].channels[{channel}].target"));
        for (channel, Channel { target, .. }) in animation.channels.iter().enumerate() {
            if target.node.value() >= root.nodes.len() {
                return Err(place(channel).error("its node's index is out of bounds", REMEDY));
            }
            if target.path == Checked::Invalid {
                return Err(place(channel).error("its path is none of the format's", REMEDY));
            }
        }
    }
    let document = Document::from_json(root).map_err(|e| match e {
        gltf::Error::Validation(found) => {
            let first = found.first().map(|(at, reason): &(_, Reason)| (at.to_string(), reason.to_string()));
            let (at, reason) = first.unwrap_or_default();
            place().element(at).error(reason, REMEDY)
        }
        e => place().error(e.to_string(), REMEDY),
    })?;
    Ok((document, parsed.blob))
}

/// Roots of the default scene, else of the first, else every node that is nobody's child.
fn roots(document: &Document) -> Vec<Node<'_>> {
    if let Some(scene) = document.default_scene().or_else(|| document.scenes().next()) {
        return scene.nodes().collect();
    }
    let children: HashSet<usize> =
        document.nodes().flat_map(|n| n.children().map(|c| c.index()).collect::<Vec<_>>()).collect();
    document.nodes().filter(|node| !children.contains(&node.index())).collect()
}

struct Walk<'a> {
    path: &'a Path,
    buffers: Buffers<'a>,
    seen: HashSet<usize>,
    /// Where the meshes of the file are in the world.
    known: HashMap<usize, usize>,
    world: World,
    vertices: usize,
    triangles: usize,
}

impl Walk<'_> {
    /// Visits a tree, parents before children and children in order, on a stack of its own.
    fn tree(&mut self, root: Node<'_>) -> Result<()> {
        let mut stack = vec![(root, Affine::IDENTITY)];
        while let Some((node, parent)) = stack.pop() {
            let place = Place::file(self.path).element(format!("node {}", node.index()));
            if !self.seen.insert(node.index()) {
                let what = "the node is reached twice: the hierarchy has a cycle, or two parents share a child";
                return Err(place.error(what, "give every node one parent"));
            }
            let place_of = parent.then(&affine(&node));
            if let Some(mesh) = node.mesh() {
                let name = node.name().or(mesh.name()).unwrap_or_default().to_owned();
                let mesh = self.mesh(&mesh)?;
                let part = &self.world.meshes[mesh];
                self.vertices += part.vertices.len();
                self.triangles += part.triangles.len();
                limit(place.clone(), "vertices", self.vertices, MAX_VERTICES)?;
                limit(place.clone(), "triangles", self.triangles, MAX_TRIANGLES)?;
                self.world.instances.push(Instance { name, mesh, transform: place_of });
            }
            if let Some(camera) = node.camera() {
                let name = node.name().or(camera.name()).unwrap_or_default().to_owned();
                self.world.cameras.push(camera_at(name, &camera, &place_of, place)?);
            }
            let children: Vec<Node<'_>> = node.children().collect();
            stack.extend(children.into_iter().rev().map(|child| (child, place_of)));
        }
        Ok(())
    }

    /// A mesh's place in the world, where it is put when it is first met.
    fn mesh(&mut self, mesh: &gltf::Mesh<'_>) -> Result<usize> {
        if let Some(known) = self.known.get(&mesh.index()) {
            return Ok(*known);
        }
        let read = self.read_mesh(mesh)?;
        self.world.meshes.push(read);
        let place = self.world.meshes.len() - 1;
        self.known.insert(mesh.index(), place);
        Ok(place)
    }

    fn read_mesh(&self, mesh: &gltf::Mesh<'_>) -> Result<Mesh> {
        let mut part = Mesh { name: mesh.name().unwrap_or_default().to_owned(), ..Mesh::default() };
        for primitive in mesh.primitives() {
            let Some(positions) = primitive.get(&Semantic::Positions) else { continue };
            let first = part.vertices.len() as u32;
            let place =
                || Place::file(self.path).element(format!("mesh {}, primitive {}", mesh.index(), primitive.index()));
            limit(place(), "vertices", part.vertices.len().saturating_add(positions.count()), MAX_VERTICES)?;
            let points = self.buffers.vectors(&positions, "positions")?;
            if let Some(accessor) = primitive.get(&Semantic::Normals) {
                let normals = self.buffers.vectors(&accessor, "normals")?;
                part.normals.resize(first as usize, [0.0; 3]);
                part.normals.extend(normals);
            }
            let map =
                primitive.get(&Semantic::TexCoords(0)).map(|accessor| self.buffers.pairs(&accessor)).transpose()?;
            if map.is_some() {
                part.uvs.resize(part.triangles.len(), UNMAPPED);
            }
            for triangle in self.triangles(&primitive, points.len())? {
                if let Some(bad) = triangle.iter().find(|&&i| i as usize >= points.len()) {
                    let what = format!("vertex {bad} (from 0) is used, and there are {}", points.len());
                    return Err(place().error(what, REMEDY));
                }
                part.triangles.push(triangle.map(|i| first + i));
                // v counts downwards in glTF, upwards here.
                let corner = |[u, v]: [f64; 2]| [u, 1.0 - v];
                let corners = map.as_ref().map(|map| triangle.map(|i| map.get(i as usize).copied().map(corner)));
                match corners {
                    Some([Some(a), Some(b), Some(c)]) => part.uvs.push([a, b, c]),
                    _ if map.is_some() || !part.uvs.is_empty() => part.uvs.push(UNMAPPED),
                    _ => {}
                }
            }
            limit(place(), "triangles", part.triangles.len(), MAX_TRIANGLES)?;
            part.vertices.extend(points);
        }
        if !part.normals.is_empty() {
            part.normals.resize(part.vertices.len(), [0.0; 3]);
        }
        Ok(part)
    }

    /// The corners of a primitive's triangles; points and lines have none.
    fn triangles(&self, primitive: &Primitive<'_>, points: usize) -> Result<Vec<[u32; 3]>> {
        let corners = || match primitive.indices() {
            Some(accessor) => self.buffers.indices(&accessor),
            None => Ok((0..points as u32).collect()),
        };
        Ok(match primitive.mode() {
            Mode::Triangles => corners()?.as_chunks::<3>().0.to_vec(),
            Mode::TriangleStrip => strip(&corners()?),
            Mode::TriangleFan => fan(&corners()?),
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => Vec::new(),
        })
    }
}

/// Every second triangle of a strip turns the other way.
fn strip(corners: &[u32]) -> Vec<[u32; 3]> {
    let turned = |(i, w): (usize, &[u32])| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] };
    corners.windows(3).enumerate().map(turned).collect()
}

fn fan(corners: &[u32]) -> Vec<[u32; 3]> {
    corners.get(1..).unwrap_or_default().windows(2).map(|w| [corners[0], w[0], w[1]]).collect()
}

/// The transform of a node.
fn affine(node: &Node<'_>) -> Affine {
    match node.transform() {
        gltf::scene::Transform::Matrix { matrix } => Affine(matrix.map(|[x, y, z, _]| [x, y, z].map(f64::from))),
        gltf::scene::Transform::Decomposed { translation, rotation, scale } => {
            Affine::decomposed(translation.map(f64::from), rotation.map(f64::from), scale.map(f64::from))
        }
    }
}

/// A camera looks along the negative z axis of its node, with y up.
fn camera_at(name: String, camera: &gltf::Camera<'_>, node: &Affine, place: Place) -> Result<Camera> {
    let [_, up, back, eye] = node.0;
    let lens = match camera.projection() {
        gltf::camera::Projection::Perspective(lens) => {
            Lens::Perspective { slope: libm::tan(f64::from(lens.yfov()) / 2.0), near: Some(f64::from(lens.znear())) }
        }
        gltf::camera::Projection::Orthographic(lens) => Lens::Orthographic { height: 2.0 * f64::from(lens.ymag()) },
    };
    let size = match lens {
        Lens::Perspective { slope, near } => slope.min(near.unwrap_or(1.0)),
        Lens::Orthographic { height } => height,
    };
    let turned = cross(up, back).iter().all(|c| c.is_finite()) && length(cross(up, back)) > 0.0;
    if !(size > 0.0 && size.is_finite() && turned) {
        let what = format!("camera {} has a lens or a transform without extent", camera.index());
        return Err(place.error(what, REMEDY));
    }
    Camera::look_at(name, eye, add(eye, scale(back, -1.0)), up, lens)
}

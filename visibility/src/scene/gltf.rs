//! glTF 2.0 through the `gltf` crate: nodes with their transforms, and every use of a mesh as a part of its own.
//!
//! The hierarchy must be a forest, as the format says: a node that is reached twice is refused, which ends cycles and
//! keeps shared subtrees from growing without bound. Skins and morph targets are left in their bind pose.

use std::collections::HashSet;
use std::path::Path;

use gltf::json::validation::Error as Reason;
use gltf::mesh::Mode;
use gltf::{Document, Node, Primitive, Semantic};

use super::{MAX_TRIANGLES, MAX_VERTICES, Mesh, Scene, limit, load};
use crate::error::{Place, Result};
use crate::vector::{Vector, add, scale};

mod accessor;

use accessor::Buffers;

const REMEDY: &str = "export the scene again";

/// Extensions that change shapes in ways which are not read.
const UNREADABLE: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"];

pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Scene> {
    let (document, blob) = parse(path, bytes)?;
    let buffers = Buffers::load(path, &document, blob)?;
    let mut walk = Walk { path, buffers, seen: HashSet::new(), parts: Vec::new(), vertices: 0, triangles: 0 };
    for root in roots(&document) {
        walk.tree(root)?;
    }
    Ok(Scene { name: load::name(path), units: "metres", parts: walk.parts })
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
    parts: Vec<Mesh>,
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
            let place_of = parent.then(&Affine::of(&node));
            if let Some(mesh) = node.mesh() {
                let name = node.name().or(mesh.name()).unwrap_or_default().to_owned();
                let part = self.part(name, &mesh, &place_of)?;
                self.vertices += part.vertices.len();
                self.triangles += part.triangles.len();
                limit(place.clone(), "vertices", self.vertices, MAX_VERTICES)?;
                limit(place, "triangles", self.triangles, MAX_TRIANGLES)?;
                self.parts.push(part);
            }
            let children: Vec<Node<'_>> = node.children().collect();
            stack.extend(children.into_iter().rev().map(|child| (child, place_of)));
        }
        Ok(())
    }

    /// One use of a mesh, in the coordinates of the scene.
    fn part(&self, name: String, mesh: &gltf::Mesh<'_>, transform: &Affine) -> Result<Mesh> {
        let mut part = Mesh { name, ..Mesh::default() };
        for primitive in mesh.primitives() {
            let Some(positions) = primitive.get(&Semantic::Positions) else { continue };
            let first = part.vertices.len() as u32;
            let points = self.buffers.positions(&positions)?;
            for triangle in self.triangles(&primitive, points.len())? {
                if let Some(bad) = triangle.iter().find(|&&i| i as usize >= points.len()) {
                    let place = Place::file(self.path);
                    let element = format!("mesh {}, primitive {}", mesh.index(), primitive.index());
                    let what = format!("vertex {bad} (from 0) is used, and there are {}", points.len());
                    return Err(place.element(element).error(what, REMEDY));
                }
                part.triangles.push(triangle.map(|i| first + i));
            }
            part.vertices.extend(points.into_iter().map(|p| transform.apply(p)));
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

/// An affine map: the images of the three axes, and of the origin.
#[derive(Clone, Copy)]
struct Affine([Vector; 4]);

impl Affine {
    const IDENTITY: Affine = Affine([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]]);

    fn of(node: &Node<'_>) -> Self {
        match node.transform() {
            gltf::scene::Transform::Matrix { matrix } => Affine(matrix.map(|[x, y, z, _]| [x, y, z].map(f64::from))),
            gltf::scene::Transform::Decomposed { translation, rotation, scale: s } => {
                let [x, y, z, w] = rotation.map(f64::from);
                let axes = [
                    [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)],
                    [2.0 * (x * y - z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w)],
                    [2.0 * (x * z + y * w), 2.0 * (y * z - x * w), 1.0 - 2.0 * (x * x + y * y)],
                ];
                let axis = |i: usize| scale(axes[i], s[i].into());
                Affine([axis(0), axis(1), axis(2), translation.map(f64::from)])
            }
        }
    }

    fn linear(&self, [x, y, z]: Vector) -> Vector {
        add(add(scale(self.0[0], x), scale(self.0[1], y)), scale(self.0[2], z))
    }

    fn apply(&self, point: Vector) -> Vector {
        add(self.linear(point), self.0[3])
    }

    /// `inner` first, then this.
    fn then(&self, inner: &Affine) -> Affine {
        let [a, b, c, origin] = inner.0;
        Affine([self.linear(a), self.linear(b), self.linear(c), self.apply(origin)])
    }
}

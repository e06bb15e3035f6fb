//! The numbers of a glTF file: buffers from the GLB's chunk, from `data:` URIs or from files beside it, read through
//! accessors with every range checked. Sparse accessors and quantised positions are understood.

use std::path::Path;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::{Source, View};
use gltf::{Accessor, Document};

use super::REMEDY;
use crate::error::{Error, Place, Result};
use crate::input;
use crate::scene::{Affine, MAX_FILE_BYTES, MAX_TRIANGLES, MAX_VERTICES, limit, load};
use crate::vector::Vector;

pub(super) struct Buffers<'a> {
    path: &'a Path,
    bytes: Vec<Vec<u8>>,
}

impl<'a> Buffers<'a> {
    pub(super) fn load(path: &'a Path, document: &Document, mut blob: Option<Vec<u8>>) -> Result<Self> {
        for image in document.images() {
            if let gltf::image::Source::Uri { uri, .. } = image.source()
                && let Some(name) = percent_decoded(uri)
            {
                input::remember(&path.with_file_name(name));
            }
        }
        let (mut bytes, mut total) = (Vec::new(), 0);
        for buffer in document.buffers() {
            let place = || Place::file(path).element(format!("buffer {}", buffer.index()));
            let data = match buffer.source() {
                Source::Bin => blob.take().ok_or_else(|| place().error("the file has no binary chunk", REMEDY))?,
                Source::Uri(uri) => fetch(path, uri, place)?,
            };
            if data.len() < buffer.length() {
                let what = format!("{} bytes are promised, {} are there", buffer.length(), data.len());
                return Err(place().error(what, REMEDY));
            }
            total += data.len() as u64;
            if total > MAX_FILE_BYTES {
                let what = format!("with it the buffers hold {total} bytes, at most {MAX_FILE_BYTES} are read");
                return Err(place().error(what, "simplify the scene, or split it"));
            }
            bytes.push(data);
        }
        Ok(Buffers { path, bytes })
    }

    /// Positions or normals, from floats or (quantised) integers.
    pub(super) fn vectors(&self, accessor: &Accessor<'_>, what: &str) -> Result<Vec<Vector>> {
        self.expect(accessor, Dimensions::Vec3, accessor.data_type() != DataType::U32, what, MAX_VERTICES)?;
        Ok(self.scaled(accessor)?.as_chunks::<3>().0.to_vec())
    }

    /// Texture coordinates, from floats or integers.
    pub(super) fn pairs(&self, accessor: &Accessor<'_>) -> Result<Vec<[f64; 2]>> {
        let kind = accessor.data_type() != DataType::U32;
        self.expect(accessor, Dimensions::Vec2, kind, "texture coordinates", MAX_VERTICES)?;
        Ok(self.scaled(accessor)?.as_chunks::<2>().0.to_vec())
    }

    /// Every component, whole numbers scaled to [-1, 1] where the accessor says so.
    fn scaled(&self, accessor: &Accessor<'_>) -> Result<Vec<f64>> {
        let largest = match accessor.data_type() {
            DataType::I8 => 127.0,
            DataType::U8 => 255.0,
            DataType::I16 => 32767.0,
            DataType::U16 => 65535.0,
            DataType::U32 | DataType::F32 => 1.0,
        };
        let unit = |v: f64| if accessor.normalized() { (v / largest).max(-1.0) } else { v };
        Ok(self.values(accessor)?.into_iter().map(unit).collect())
    }

    /// Joints or their weights, four each.
    pub(super) fn fours(&self, accessor: &Accessor<'_>, what: &str) -> Result<Vec<[f64; 4]>> {
        self.expect(accessor, Dimensions::Vec4, true, what, MAX_VERTICES)?;
        // Weights are shares of their sum, so integers need no scale.
        Ok(self.values(accessor)?.as_chunks::<4>().0.to_vec())
    }

    /// So many affine maps, from matrices of four columns.
    pub(super) fn matrices(&self, accessor: &Accessor<'_>, count: usize) -> Result<Vec<Affine>> {
        let whole = accessor.data_type() == DataType::F32 && accessor.count() >= count;
        self.expect(accessor, Dimensions::Mat4, whole, "inverse bind matrices", MAX_VERTICES)?;
        let columns = |m: &[f64; 16]| Affine([0, 4, 8, 12].map(|at| [m[at], m[at + 1], m[at + 2]]));
        Ok(self.values(accessor)?.as_chunks().0.iter().map(columns).collect())
    }

    /// Times of an animation, in seconds.
    pub(super) fn times(&self, accessor: &Accessor<'_>) -> Result<Vec<f64>> {
        self.expect(accessor, Dimensions::Scalar, accessor.data_type() == DataType::F32, "times", MAX_VERTICES)?;
        self.values(accessor)
    }

    /// Values of an animation, `width` numbers each: floats, or of rotations whole numbers that stand for [-1, 1].
    pub(super) fn keys(&self, accessor: &Accessor<'_>, width: usize) -> Result<Vec<f64>> {
        let shape = if width == 4 { Dimensions::Vec4 } else { Dimensions::Vec3 };
        let whole = width == 4 && accessor.normalized() && accessor.data_type() != DataType::U32;
        self.expect(accessor, shape, whole || accessor.data_type() == DataType::F32, "keys", MAX_VERTICES)?;
        self.scaled(accessor)
    }

    /// Corners of faces.
    pub(super) fn indices(&self, accessor: &Accessor<'_>) -> Result<Vec<u32>> {
        let whole = matches!(accessor.data_type(), DataType::U8 | DataType::U16 | DataType::U32);
        self.expect(accessor, Dimensions::Scalar, whole, "indices", 3 * MAX_TRIANGLES)?;
        Ok(self.values(accessor)?.into_iter().map(|v| v as u32).collect())
    }

    fn place(&self, accessor: &Accessor<'_>) -> Place {
        Place::file(self.path).element(format!("accessor {}", accessor.index()))
    }

    fn expect(&self, accessor: &Accessor<'_>, shape: Dimensions, kind: bool, what: &str, most: usize) -> Result<()> {
        if accessor.dimensions() != shape || !kind {
            let found = format!("{:?} of {:?}", accessor.dimensions(), accessor.data_type());
            return Err(self.place(accessor).error(format!("{what} cannot be {found}"), REMEDY));
        }
        limit(self.place(accessor), what, accessor.count(), most)
    }

    /// Every component, in order.
    fn values(&self, accessor: &Accessor<'_>) -> Result<Vec<f64>> {
        let shape = Shape { parts: accessor.dimensions().multiplicity(), kind: accessor.data_type() };
        let broken = |what: String| self.place(accessor).error(what, REMEDY);
        let mut values = match accessor.view() {
            Some(view) => self.scan(&view, accessor.offset(), accessor.count(), shape).map_err(broken)?,
            None => vec![0.0; accessor.count() * shape.parts],
        };
        let Some(sparse) = accessor.sparse() else { return Ok(values) };
        let (indices, fresh) = (sparse.indices(), sparse.values());
        let kind = match indices.index_type() {
            gltf::accessor::sparse::IndexType::U8 => DataType::U8,
            gltf::accessor::sparse::IndexType::U16 => DataType::U16,
            gltf::accessor::sparse::IndexType::U32 => DataType::U32,
        };
        let count = sparse.count();
        limit(self.place(accessor), "sparse values", count, accessor.count())?;
        let indices = self.scan(&indices.view(), indices.offset(), count, Shape { parts: 1, kind }).map_err(broken)?;
        let fresh = self.scan(&fresh.view(), fresh.offset(), count, shape).map_err(broken)?;
        for (index, fresh) in indices.into_iter().zip(fresh.chunks(shape.parts)) {
            let start = index as usize * shape.parts;
            let Some(old) = values.get_mut(start..start + shape.parts) else {
                return Err(broken(format!("sparse index {index} is beyond the {} elements", accessor.count())));
            };
            old.copy_from_slice(fresh);
        }
        Ok(values)
    }

    /// `count` elements of a view, from `offset` on.
    fn scan(&self, view: &View<'_>, offset: usize, count: usize, shape: Shape) -> Result<Vec<f64>, String> {
        let outside = || format!("its {count} elements reach beyond buffer view {}", view.index());
        let element = shape.parts * shape.kind.size();
        let stride = view.stride().unwrap_or(element);
        let bytes = &self.bytes[view.buffer().index()];
        let end = view.offset().checked_add(view.length());
        let bytes = end.and_then(|end| bytes.get(view.offset()..end)).ok_or_else(outside)?;
        let last = count.saturating_sub(1).checked_mul(stride).and_then(|last| last.checked_add(offset));
        let needed = last.and_then(|last| last.checked_add(if count == 0 { 0 } else { element }));
        if needed.is_none_or(|needed| needed > bytes.len()) {
            return Err(outside());
        }
        let starts = (0..count).map(|i| offset + i * stride);
        let size = shape.kind.size();
        let part = |at: usize| shape.kind.value(&bytes[at..at + size]);
        Ok(starts.flat_map(|at| (0..shape.parts).map(move |k| at + k * size)).map(part).collect())
    }
}

/// How an element is laid out.
#[derive(Clone, Copy)]
struct Shape {
    parts: usize,
    kind: DataType,
}

/// Decoding of one component, little-endian.
trait Component {
    fn value(self, bytes: &[u8]) -> f64;
}

impl Component for DataType {
    fn value(self, bytes: &[u8]) -> f64 {
        match (self, bytes) {
            (DataType::I8, &[a]) => (a as i8).into(),
            (DataType::U8, &[a]) => a.into(),
            (DataType::I16, &[a, b]) => i16::from_le_bytes([a, b]).into(),
            (DataType::U16, &[a, b]) => u16::from_le_bytes([a, b]).into(),
            (DataType::U32, &[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]).into(),
            (DataType::F32, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]).into(),
            _ => unreachable!("components are cut to their size"),
        }
    }
}

/// The bytes that a URI names: in itself, or in a file beside the scene.
fn fetch(path: &Path, uri: &str, place: impl Fn() -> Place) -> Result<Vec<u8>> {
    if let Some(data) = uri.strip_prefix("data:") {
        let coded = data.split_once(";base64,").map(|(_, coded)| coded);
        let coded = coded.ok_or_else(|| place().error("a data URI that is not base64", REMEDY))?;
        return BASE64_STANDARD.decode(coded).map_err(|e| place().error(format!("its base64: {e}"), REMEDY));
    }
    if uri.contains("://") {
        let remedy = "put the buffer beside the scene, or embed it";
        return Err(place().error(format!("`{uri}` is not on this machine"), remedy));
    }
    let name = percent_decoded(uri).ok_or_else(|| place().error(format!("`{uri}` is not a URI"), REMEDY))?;
    load::read(&path.with_file_name(&name)).map_err(|e| match e {
        Error::Read { source, .. } => {
            let what = format!("its file `{name}` cannot be read: {source}");
            place().error(what, "put the file beside the scene, or export the scene with its buffers embedded")
        }
        e => e,
    })
}

fn percent_decoded(uri: &str) -> Option<String> {
    let mut pieces = uri.split('%');
    let mut bytes = pieces.next()?.as_bytes().to_vec();
    for piece in pieces {
        bytes.push(u8::from_str_radix(piece.get(..2)?, 16).ok()?);
        bytes.extend_from_slice(&piece.as_bytes()[2..]);
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::percent_decoded;

    #[test]
    fn uris_are_decoded() {
        assert_eq!(percent_decoded("a%20b%C3%A9.bin").as_deref(), Some("a bé.bin"));
        for bad in ["%", "%2", "%zz", "%ff"] {
            assert_eq!(percent_decoded(bad), None, "{bad}");
        }
    }
}

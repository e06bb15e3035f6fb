//! Wavefront OBJ, through `tobj`. Positions, faces, normals and texture coordinates matter; materials are not looked
//! for.
//!
//! Normals are taken where every corner of every face has one that is there; a vertex with several becomes as many.
//!
//! `tobj` would refuse a mesh for its texture coordinates, makes a face of a polyline, and tells what is wrong but not
//! where. So it is given the [`statements`] that matter, through a reader that knows how far it has come, and texture
//! coordinates are read beside it ([`maps`]), in the same order of faces.

use std::borrow::Cow;
use std::collections::HashMap;
use std::io::{self, BufRead, Read};
use std::path::Path;

use tobj::{LoadError, LoadOptions};

use super::{MAX_VERTICES, Mesh, Scene, UNMAPPED, limit, load, polygon};
use crate::error::{Error, Place, Result};

const REMEDY: &str = "mend the line, or export the mesh again";

pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Scene> {
    let text = text(path, bytes)?;
    let with_normals = has_all_normals(&text);
    let mut lines = Lines { statements: statements(&text, with_normals), number: 0, text: String::new(), used: 0 };
    let options = LoadOptions { ignore_points: true, ignore_lines: true, ..LoadOptions::default() };
    let (models, _) = tobj::load_obj_buf(&mut lines, &options, |_| Ok((Vec::new(), Default::default()))).map_err(
        |error| match error {
            LoadError::FaceVertexOutOfBounds => out_of_range(path, &text),
            LoadError::PositionParseError => lines.refused(path, "it is no vertex of three numbers"),
            LoadError::FaceParseError => lines.refused(path, "it is no face of whole numbers"),
            other => lines.refused(path, &other.to_string()),
        },
    )?;
    let mut maps = maps(&text).into_iter();
    let parts = models.into_iter().map(|model| part(path, model, &mut maps)).collect::<Result<_>>()?;
    Ok(Scene { name: load::name(path), units: "units of the file", parts })
}

/// The text of a file, without the mark of its encoding. Names may have bytes that are not UTF-8.
fn text<'a>(path: &Path, bytes: &'a [u8]) -> Result<Cow<'a, str>> {
    if let Some(zero) = bytes.iter().position(|&byte| byte == 0) {
        let line = 1 + bytes[..zero].iter().filter(|&&byte| byte == b'\n').count();
        return Err(
            Place::line(path, line).error("it has a zero byte, so it is no text", "save the file as UTF-8 text")
        );
    }
    Ok(String::from_utf8_lossy(bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes)))
}

fn part(path: &Path, model: tobj::Model, maps: &mut impl Iterator<Item = Map>) -> Result<Mesh> {
    let tobj::Model { mesh, name } = model;
    let place = || Place::file(path).element(format!("mesh `{name}`"));
    let (vertices, normals, indices) = corners(&mesh);
    let vertices = vertices.as_slice();
    limit(place(), "vertices", vertices.len(), MAX_VERTICES)?;
    let mut triangles = Vec::with_capacity(indices.len() / 3);
    let mut uvs = Vec::new();
    let mut rest = indices.as_slice();
    let threes = vec![3; if mesh.face_arities.is_empty() { rest.len() / 3 } else { 0 }];
    for &arity in mesh.face_arities.iter().chain(&threes) {
        let (corners, after) = rest.split_at(arity as usize);
        polygon::triangulate(place, vertices, corners, &mut triangles)?;
        // Files without texture coordinates have no maps.
        if let Some(map) = maps.next() {
            let at = |vertex: &u32| corners.iter().position(|corner| corner == vertex).and_then(|i| *map.get(i)?);
            let mapped = triangles[uvs.len()..].iter().map(|t| t.each_ref().map(at));
            let mapped = mapped.map(|map| if let [Some(a), Some(b), Some(c)] = map { [a, b, c] } else { UNMAPPED });
            uvs.extend(mapped.collect::<Vec<_>>());
        }
        rest = after;
    }
    Ok(Mesh { vertices: vertices.to_vec(), triangles, uvs, name, normals })
}

/// Vertices, their normals if there are any, and the vertices of all corners: each pair of position and normal once.
fn corners(mesh: &tobj::Mesh) -> (Vec<[f64; 3]>, Vec<[f64; 3]>, Vec<u32>) {
    let (positions, normals) = (mesh.positions.as_chunks::<3>().0, mesh.normals.as_chunks::<3>().0);
    if normals.is_empty() || mesh.normal_indices.len() != mesh.indices.len() {
        return (positions.to_vec(), Vec::new(), mesh.indices.clone());
    }
    let mut known = HashMap::new();
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    let mut vertex = |pair: (u32, u32)| {
        *known.entry(pair).or_insert_with(|| {
            pairs.push(pair);
            pairs.len() as u32 - 1
        })
    };
    let corners = mesh.indices.iter().zip(&mesh.normal_indices).map(|(p, n)| vertex((*p, *n))).collect();
    let take = |from: &[[f64; 3]], at: u32| from[at as usize];
    let vertices = pairs.iter().map(|pair| take(positions, pair.0)).collect();
    (vertices, pairs.iter().map(|pair| take(normals, pair.1)).collect(), corners)
}

/// Texture coordinates of a face's corners, where it has them.
type Map = Vec<Option<[f64; 2]>>;

/// The maps of all faces of three corners or more, in order; none in a file without texture coordinates.
fn maps(text: &str) -> Vec<Map> {
    let mut points: Vec<Option<[f64; 2]>> = Vec::new();
    let mut maps = Vec::new();
    for (_, statement) in joined(text) {
        let mut words = statement.split_whitespace();
        match words.next() {
            Some("vt") => {
                let mut numbers = words.map(|word| word.parse::<f64>().ok());
                points.push(numbers.next().flatten().zip(numbers.next().flatten()).map(|(u, v)| [u, v]));
            }
            Some("f") => {
                let point = |corner: &str| {
                    let number: i64 = corner.split('/').nth(1)?.parse().ok()?;
                    let index = if number < 0 { points.len() as i64 + number } else { number - 1 };
                    *points.get(usize::try_from(index).ok()?)?
                };
                let map: Map = words.map(point).collect();
                maps.extend((map.len() > 2).then_some(map));
            }
            _ => {}
        }
    }
    if points.is_empty() { Vec::new() } else { maps }
}

/// What matters of a file, one line each with the number of its first line: `v` with its coordinates (and weight), `f`
/// with its vertices, the names of objects and groups, and `vn` if normals are wanted. A backslash at its end continues
/// a line.
fn statements(text: &str, with_normals: bool) -> impl Iterator<Item = (usize, String)> {
    joined(text).map(move |(number, statement)| (number, essence(&statement, with_normals)))
}

/// All statements, on one line each.
fn joined(text: &str) -> impl Iterator<Item = (usize, String)> {
    let mut lines = text.lines().enumerate();
    std::iter::from_fn(move || {
        let (number, line) = lines.next()?;
        let mut statement = line.to_owned();
        while let Some(start) = statement.trim_end().strip_suffix('\\') {
            statement.truncate(start.len());
            statement.push(' ');
            statement.push_str(lines.next().map_or("", |(_, line)| line));
        }
        Some((number + 1, statement))
    })
}

/// Whether every corner of every face has a normal that the file has.
fn has_all_normals(text: &str) -> bool {
    let count = statements(text, true).filter(|(_, line)| line.starts_with("vn ")).count() as i64;
    let is_there = |corner: &str| {
        let normal: Option<i64> = corner.split('/').nth(2).and_then(|word| word.parse().ok());
        normal.is_some_and(|normal| normal != 0 && (-count..=count).contains(&normal))
    };
    let faces = statements(text, true);
    count > 0 && { faces }
        .all(|(_, line)| line.strip_prefix("f ").is_none_or(|corners| corners.split(' ').all(is_there)))
}

fn essence(statement: &str, with_normals: bool) -> String {
    let words: Vec<&str> = statement.split_whitespace().collect();
    match words.as_slice() {
        ["v", x, y, z, w] => ["v", x, y, z, w].join(" "),
        ["v", rest @ ..] => ["v"].iter().chain(rest.iter().take(3)).copied().collect::<Vec<_>>().join(" "),
        ["f", corners @ ..] => {
            let vertex = |corner: &&str| {
                let mut numbers = corner.split('/');
                let (position, normal) = (numbers.next().unwrap_or_default(), numbers.nth(1));
                normal.filter(|_| with_normals).map_or(position.to_owned(), |normal| format!("{position}//{normal}"))
            };
            ["f".to_owned()].into_iter().chain(corners.iter().map(vertex)).collect::<Vec<_>>().join(" ")
        }
        ["vn", rest @ ..] if with_normals => ["vn"].iter().chain(rest).copied().collect::<Vec<_>>().join(" "),
        ["o" | "g", ..] => statement.trim().to_owned(),
        _ => String::new(),
    }
}

/// The first face that uses a vertex which the file does not have.
fn out_of_range(path: &Path, text: &str) -> Error {
    let count = statements(text, false).filter(|(_, line)| line.starts_with("v ")).count() as i64;
    let mut so_far = 0;
    for (number, line) in statements(text, false) {
        so_far += i64::from(line.starts_with("v "));
        let corners = line.strip_prefix("f ").unwrap_or_default().split(' ').filter_map(|word| word.parse().ok());
        if let Some(bad) = { corners }.find(|&i: &i64| i == 0 || i > count || i < -so_far) {
            let what = format!("the face uses vertex {bad}, and the file has {count} vertices");
            return Place::line(path, number).error(what, REMEDY);
        }
    }
    Place::file(path).error("a face uses a vertex that comes after its object", "put every `v` before the faces")
}

/// The statements of a file as a reader.
struct Lines<I> {
    statements: I,
    /// Where the statement in `text` starts.
    number: usize,
    text: String,
    used: usize,
}

impl<I> Lines<I> {
    /// The error of the statement that was read last.
    fn refused(&self, path: &Path, what: &str) -> Error {
        let start: String = self.text.trim_end().chars().take(40).collect();
        Place::line(path, self.number).error(format!("`{start}`: {what}"), REMEDY)
    }
}

impl<I: Iterator<Item = (usize, String)>> Read for Lines<I> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let length = self.fill_buf()?.read(out)?;
        self.consume(length);
        Ok(length)
    }
}

impl<I: Iterator<Item = (usize, String)>> BufRead for Lines<I> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.used == self.text.len()
            && let Some((number, statement)) = self.statements.next()
        {
            (self.number, self.text, self.used) = (number, statement + "\n", 0);
        }
        Ok(&self.text.as_bytes()[self.used..])
    }

    fn consume(&mut self, amount: usize) {
        self.used += amount;
    }
}

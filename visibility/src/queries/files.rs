//! Answers in files: JSON and CSV for tables, a heat map for the eye, and the visible set for programs.
//!
//! What is written depends on the scene, the camera and the method alone, never on the machine. The visible set is
//! binary, little-endian; offsets and sizes in bytes:
//!
//! | offset | size | what |
//! |---|---|---|
//! | 0 | 16 | the magic line `sightlines seen` and a line feed |
//! | 16 | 4 | u32: version of this layout, 1 |
//! | 20 | 4 | u32: version of the numerics contract |
//! | 24 | 4 | u32: number of instances of the scene |
//! | 28 | 4 | u32: number of views, in the order of the cameras |
//! | 32 | 4 × views × words | u32: the sets, view after view, each of words = ⌈instances / 32⌉; bit i % 32 of word i / 32: instance i has a visible pixel |
//! | … | 32 | BLAKE3 digest of all that stands before |

use std::io;
use std::path::Path;

use serde::Serialize;
use sightlines_backend::CONTRACT_VERSION;
use sightlines_kernels::raster::NOTHING;

use super::Answer;
use super::picture::BACKGROUND;
use crate::error::{Place, Result};
use crate::input;
use crate::output;
use crate::scene::World;

/// First bytes of a file of visible sets.
pub const MAGIC: [u8; 16] = *b"sightlines seen\n";

/// Largest file of visible sets that is read, in bytes.
const MAX_BYTES: u64 = 1 << 30;

const REMEDY: &str = "make the sets again with `sightlines queries --seen`";

const VERSION: u32 = 1;
const HEADER: usize = 32;
const DIGEST: usize = blake3::OUT_LEN;

/// One camera's answer, and what its instances would cover alone.
#[derive(Clone, Debug)]
pub struct View {
    /// Name of the camera.
    pub camera: String,
    /// Columns and rows.
    pub size: [u32; 2],
    /// The counts.
    pub answer: Answer,
    /// Pixels that each item would show with nothing in front, of those for which that is known.
    pub covered: Vec<Option<u32>>,
}

/// A row of a report.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Place of the instance in the scene.
    pub instance: usize,
    /// Its name.
    pub name: String,
    /// Name of its mesh.
    pub mesh: String,
    /// The cluster of triangles, 0 where instances are counted.
    pub cluster: u32,
    /// Pixels counted.
    pub pixels: u32,
    /// Pixels that it would show with nothing in front, if that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub covered: Option<u32>,
    /// Pixels in each tile, rows of tiles from the top.
    pub tiles: Vec<u32>,
}

/// A view as JSON has it.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    camera: &'a str,
    width: u32,
    height: u32,
    method: &'a str,
    exact: bool,
    tiles_a_side: u32,
    items: Vec<Row>,
}

impl View {
    /// The rows of a report, by instance and cluster.
    pub fn rows(&self, world: &World) -> Vec<Row> {
        let row = |number: usize| {
            let item = self.answer.items[number];
            let instance = &world.instances[item.instance];
            Row {
                instance: item.instance,
                name: instance.name.clone(),
                mesh: world.meshes[instance.mesh].name.clone(),
                cluster: item.cluster,
                pixels: self.answer.totals[number],
                covered: self.covered[number],
                tiles: self.answer.tiles_of(number).to_vec(),
            }
        };
        let mut rows: Vec<Row> = (0..self.answer.items.len()).map(row).collect();
        rows.sort_by_key(|row| (row.instance, row.cluster));
        rows
    }

    fn report<'a>(&'a self, world: &'a World) -> Report<'a> {
        Report {
            scene: &world.name,
            camera: &self.camera,
            width: self.size[0],
            height: self.size[1],
            method: self.answer.method.name(),
            exact: self.answer.method.is_exact(),
            tiles_a_side: 1 << self.answer.depth,
            items: self.rows(world),
        }
    }

    /// One bit for each instance of the scene: whether a pixel of it was counted.
    fn seen(&self, instances: usize) -> Vec<u32> {
        let mut words = vec![0; instances.div_ceil(32)];
        let items = self.answer.items.iter().zip(&self.answer.totals).filter(|(_, pixels)| **pixels > 0);
        items.for_each(|(item, _)| words[item.instance / 32] |= 1 << (item.instance % 32));
        words
    }
}

/// Writes the views of a scene as JSON: an array with an object a camera.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_json(path: &Path, world: &World, views: &[View]) -> Result<()> {
    let reports: Vec<Report<'_>> = views.iter().map(|view| view.report(world)).collect();
    output::write(path, |out| {
        serde_json::to_writer_pretty(&mut *out, &reports)?;
        out.write_all(b"\n")
    })
}

/// Writes the views of a scene as CSV: a row for each camera and item, with a column for each tile.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_csv(path: &Path, world: &World, views: &[View]) -> Result<()> {
    let side = views.first().map_or(1, |view| 1_usize << view.answer.depth);
    output::write(path, |out| {
        write!(out, "camera,instance,name,mesh,cluster,pixels,covered")?;
        (0..side * side).try_for_each(|tile| write!(out, ",tile {} {}", tile % side, tile / side))?;
        writeln!(out)?;
        for view in views {
            for row in view.rows(world) {
                let [camera, name, mesh] = [&view.camera, &row.name, &row.mesh].map(|text| quoted(text));
                let covered = row.covered.map_or_else(String::new, |covered| covered.to_string());
                write!(out, "{camera},{},{name},{mesh},{},{},{covered}", row.instance, row.cluster, row.pixels)?;
                row.tiles.iter().try_for_each(|pixels| write!(out, ",{pixels}"))?;
                writeln!(out)?;
            }
        }
        Ok(())
    })
}

/// A field of CSV: in quotation marks where it needs them.
fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

/// Colours of the heat map at 0, 1/4, … 1 of visible share: those of the palette viridis.
const HEAT: [[i32; 3]; 5] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// The colour of a share in 1/65536.
fn heat(share: u32) -> [u8; 3] {
    let place = share.min(65_536) * 4;
    let (step, rest) = ((place >> 16).min(3), place - ((place >> 16).min(3) << 16));
    let [a, b] = [HEAT[step as usize], HEAT[step as usize + 1]];
    [0, 1, 2].map(|i| (a[i] + (((b[i] - a[i]) * rest as i32) >> 16)) as u8)
}

/// Writes a picture of a view in which the colour of a pixel is the visible share of its instance: violet where little
/// of it is seen, yellow where all is. Where that is not known, as of clusters, it is the share of the busiest item.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_heat_map(path: &Path, view: &View) -> Result<()> {
    let most = view.answer.totals.iter().copied().max().unwrap_or(0).max(1);
    let share = |(item, covered): (usize, &Option<u32>)| view.answer.share(item, covered.unwrap_or(most));
    let colours: Vec<[u8; 3]> =
        view.covered.iter().enumerate().map(share).map(|share| share.map_or(BACKGROUND, heat)).collect();
    let colour = |item: &u32| if *item == NOTHING { BACKGROUND } else { colours[*item as usize] };
    let pixels: Vec<u8> = view.answer.shown.iter().flat_map(colour).collect();
    write_rgb(path, view.size, &pixels)
}

/// Writes a picture of three bytes a pixel.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_rgb(path: &Path, [width, height]: [u32; 2], pixels: &[u8]) -> Result<()> {
    let failed = |e| match e {
        png::EncodingError::IoError(e) => e,
        other => io::Error::other(other),
    };
    output::write(path, |out| {
        let mut encoder = png::Encoder::new(out, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(pixels).map_err(failed)?;
        writer.finish().map_err(failed)
    })
}

/// Writes the visible sets of all views.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_seen(path: &Path, world: &World, views: &[View]) -> Result<()> {
    let instances = world.instances.len();
    let mut bytes = MAGIC.to_vec();
    let header = [VERSION, CONTRACT_VERSION, instances as u32, views.len() as u32];
    let sets = views.iter().flat_map(|view| view.seen(instances));
    bytes.extend(header.into_iter().chain(sets).flat_map(u32::to_le_bytes));
    bytes.extend(*blake3::hash(&bytes).as_bytes());
    output::write(path, |out| out.write_all(&bytes))
}

/// Reads visible sets: for each view the places of the instances that are seen, ascending.
///
/// # Errors
///
/// A file that is missing, is not such a file, is of another version, or is damaged.
pub fn read_seen(path: &Path) -> Result<Vec<Vec<usize>>> {
    decode(&input::read(path, MAX_BYTES, REMEDY)?).map_err(|what| Place::file(path).error(what, REMEDY))
}

fn decode(bytes: &[u8]) -> Result<Vec<Vec<usize>>, String> {
    if bytes.len() < HEADER + DIGEST || !bytes.starts_with(&MAGIC) {
        return Err("it is no file of visible sets".into());
    }
    let (body, digest) = bytes.split_at(bytes.len() - DIGEST);
    if blake3::hash(body).as_bytes() != digest {
        return Err("its bytes do not match their digest".into());
    }
    let words: Vec<u32> = body[MAGIC.len()..].as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect();
    let [version, contract, instances, views] = [words[0], words[1], words[2], words[3]];
    if (version, contract) != (VERSION, CONTRACT_VERSION) {
        return Err(format!(
            "layout {version} and contract {contract}, where {VERSION} and {CONTRACT_VERSION} are read"
        ));
    }
    let each = (instances as usize).div_ceil(32);
    if each == 0 || body.len() as u64 != HEADER as u64 + 4 * each as u64 * u64::from(views) {
        return Err(format!("{views} views of {instances} instances do not fill its {} bytes", bytes.len()));
    }
    let seen = |view: usize| {
        let set = &words[4 + view * each..4 + (view + 1) * each];
        (0..instances as usize).filter(|i| set[i / 32] >> (i % 32) & 1 == 1).collect()
    };
    Ok((0..views as usize).map(seen).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heat_runs_from_violet_to_yellow() {
        assert_eq!(
            [0, 16_384, 65_536, u32::MAX].map(heat),
            [[68, 1, 84], [59, 82, 139], [253, 231, 37], [253, 231, 37]]
        );
        assert_eq!(heat(8192), [63, 41, 111]);
    }

    #[test]
    fn fields_of_csv_are_quoted_where_they_must_be() {
        assert_eq!(["a b", "a,b", "a\"b"].map(quoted), ["a b", "\"a,b\"", "\"a\"\"b\""]);
    }
}

//! The positions of a matrix whose rows fit one binding, in a session of their own.
//!
//! Three stages share its memory: blocks of visibility, light and encoding. They are recorded when they are needed,
//! against tables that were measured when the session was opened.

use std::ops::Range;

use glam::{IVec4, UVec4};
use sightlines_backend::host::Buffer;
use sightlines_backend::{Backend, Command, Job, Read, Recording, Session};
use sightlines_kernels::illumination::{self, Illumination};
use sightlines_kernels::light_sphere::oracle::Direction;
use sightlines_kernels::vertex_visibility::{Resident, VertexVisibility};

use super::environment::Intensities;
use super::matrix::{Colours, Work};
use super::stage::Stage;
use super::surface::Surface;
use crate::error::Result;

/// The compiled kernels.
pub(super) struct Kernels {
    visibility: VertexVisibility,
    illumination: Illumination,
}

impl Kernels {
    pub(super) fn new() -> Result<Self> {
        Ok(Kernels { visibility: VertexVisibility::new()?, illumination: Illumination::new()? })
    }
}

/// Buffers that outlive the stages.
struct Kept {
    mesh: Resident,
    surface: illumination::Surface,
    bias: u32,
}

pub(super) struct Part<'a> {
    session: Box<dyn Session + 'a>,
    table: Stage,
    kept: Kept,
    /// Where the stages of light, encoding and visibility begin.
    starts: [Stage; 3],
    colours: Buffer<[u32]>,
    /// Vertices of the surface in the order of the part's.
    vertices: Vec<u32>,
}

impl<'a> Part<'a> {
    /// `chosen` positions and the vertices at each; all directions, and the blocks of them that may be asked for.
    pub(super) fn open(
        backend: &'a dyn Backend,
        kernels: &Kernels,
        surface: &Surface,
        (chosen, vertices_of): (&[u32], &[Vec<u32>]),
        (directions, shapes): (&[Direction], &[Range<u32>]),
        bias: u32,
    ) -> Result<Self> {
        let mut job = Job::new();
        let (kept, vertices) = keep(&mut job, surface, (chosen, vertices_of), directions.len() as u32, bias)?;
        let uploads = std::mem::take(&mut job.recordings);
        let light = Stage::after(&job);
        let dark = Intensities::dark(directions.len());
        let (lit, colours) = kept.light(&light, kernels, &dark)?;
        let encode = Stage::after(&lit);
        let (encoded, _) = kept.encode(&encode, kernels, colours, &[u32::MAX; 255])?;
        let see = Stage::after(&encoded);
        let block = |shape: &Range<u32>| (shape.start, &directions[shape.start as usize..shape.end as usize]);
        let blocks = shapes.iter().map(|shape| kept.see(&see, kernels, block(shape)));
        let table = see.widest(&blocks.collect::<Result<Vec<_>>>()?);
        let all = table.table();
        let mut session = backend.open(&all.programs, &all.buffers)?;
        uploads.iter().try_for_each(|recording| session.submit(recording))?;
        Ok(Part { session, table, kept, starts: [light, encode, see], colours, vertices })
    }

    pub(super) fn positions(&self) -> u32 {
        self.kept.surface.positions
    }

    /// Computes the bits of a block of directions: the number of the first, and all of them.
    pub(super) fn see(&mut self, kernels: &Kernels, block: (u32, &[Direction])) -> Result<()> {
        let job = self.kept.see(&self.starts[2], kernels, block)?;
        self.run(&job)
    }

    pub(super) fn light(&mut self, kernels: &Kernels, light: &Intensities, colours: &mut Colours) -> Result<()> {
        let (job, buffer) = self.kept.light(&self.starts[0], kernels, light)?;
        self.run(&job)?;
        let words = self.read(buffer, buffer.len())?;
        let count = self.vertices.len();
        for (at, &vertex) in self.vertices.iter().enumerate() {
            colours[vertex as usize] = [0, 1, 2].map(|channel| f32::from_bits(words[channel * count + at]));
        }
        Ok(())
    }

    pub(super) fn encode(&mut self, kernels: &Kernels, table: &[u32], bytes: &mut [[u8; 3]]) -> Result<()> {
        let (job, buffer) = self.kept.encode(&self.starts[1], kernels, self.colours, table)?;
        self.run(&job)?;
        let words = self.read(buffer, buffer.len())?;
        for (&vertex, word) in self.vertices.iter().zip(words) {
            let [red, green, blue, _] = word.to_le_bytes();
            bytes[vertex as usize] = [red, green, blue];
        }
        Ok(())
    }

    /// The first rows of bits.
    pub(super) fn words(&mut self, rows: u32) -> Result<Vec<u32>> {
        self.read(self.kept.surface.occluded, u64::from(rows) * u64::from(self.positions()))
    }

    /// Uploads the first rows of bits.
    pub(super) fn restore(&mut self, words: &[u32]) -> Result<()> {
        let bytes = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let upload = Command::Upload { buffer: self.kept.surface.occluded.id(), offset: 0, bytes };
        Ok(self.session.submit(&Recording { commands: vec![upload] })?)
    }

    pub(super) fn work(&self) -> Work {
        Work { lane_ops: self.session.lane_ops(), counts: self.session.counts() }
    }

    fn run(&mut self, job: &Job) -> Result<()> {
        sightlines_backend::check::job(job)?;
        self.table.holds(job)?;
        Ok(job.recordings.iter().try_for_each(|recording| self.session.submit(recording))?)
    }

    fn read(&mut self, buffer: Buffer<[u32]>, words: u64) -> Result<Vec<u32>> {
        let read = Read { name: "part".into(), buffer: buffer.id(), offset: 0, size: 4 * words };
        let bytes = self.session.read(&read)?;
        Ok(bytes.as_chunks().0.iter().map(|bytes| u32::from_le_bytes(*bytes)).collect())
    }
}

/// Uploads what stays: the mesh, normals and positions of the vertices at `chosen`, and room for their matrix.
fn keep(
    job: &mut Job,
    surface: &Surface,
    (chosen, vertices_of): (&[u32], &[Vec<u32>]),
    most: u32,
    bias: u32,
) -> Result<(Kept, Vec<u32>)> {
    let mesh = Resident::upload_some(job, &surface.mesh, chosen)?;
    let positions = chosen.len() as u32;
    let at = (0..).zip(vertices_of).flat_map(|(place, at): (u32, _)| at.iter().map(move |&vertex| (place, vertex)));
    let (position_of, vertices): (Vec<u32>, Vec<u32>) = at.unzip();
    let normals: Vec<i32> =
        (0..3).flat_map(|axis| vertices.iter().map(move |&v| surface.normals[v as usize][axis])).collect();
    let surface = illumination::Surface {
        normals: job.slice("normals", &normals),
        position_of: job.slice("positions", &position_of),
        positions,
        occluded: job.zeroed("matrix", u64::from(positions) * u64::from(most.div_ceil(32))),
    };
    Ok((Kept { mesh, surface, bias }, vertices))
}

impl Kept {
    fn see(&self, start: &Stage, kernels: &Kernels, block: (u32, &[Direction])) -> Result<Job> {
        let see = |job: &mut Job| {
            kernels.visibility.record(job, &self.mesh, block, self.bias, self.surface.occluded)?;
            Ok(())
        };
        Ok(start.record(see)?.0)
    }

    fn light(&self, start: &Stage, kernels: &Kernels, light: &Intensities) -> Result<(Job, Buffer<[u32]>)> {
        let recorded = start.record(|job| {
            let units: Vec<IVec4> = light.units.iter().map(|&[x, y, z]| IVec4::new(x, y, z, 0)).collect();
            let values: Vec<UVec4> = light.values.iter().copied().map(UVec4::from_array).collect();
            let lights = (values.len() as u32, job.slice("units", &units), job.slice("intensities", &values));
            let buffer = job.zeroed("colours", self.surface.normals.len());
            kernels.illumination.record_illuminate(job, &self.surface, lights, light.shift, buffer)?;
            Ok(buffer)
        });
        Ok(recorded?)
    }

    fn encode(
        &self,
        start: &Stage,
        kernels: &Kernels,
        colours: Buffer<[u32]>,
        table: &[u32],
    ) -> Result<(Job, Buffer<[u32]>)> {
        let vertices = (self.surface.normals.len() / 3) as u32;
        let recorded = start.record(|job| {
            let thresholds = job.slice("thresholds", table);
            let buffer = job.zeroed("encoded", vertices.into());
            kernels.illumination.record_encode(job, vertices, colours, thresholds, buffer)?;
            Ok(buffer)
        });
        Ok(recorded?)
    }
}

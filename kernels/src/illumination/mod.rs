//! Illumination of vertices by an environment: blur and look-up of a map, matrix times intensities, gamma.
//!
//! Sattler et al. 2004, sections 3.2, 3.3 and 5. `kernel.wgsl` states the four outputs exactly.
//! The matrix is `vertex_visibility`'s bits; cosines are made of normals and lights in units of 2^-15 when they are
//! used. Intensities are in fixed point, with one exponent a channel that the host chooses ([`Fixed`], which counts
//! what the range loses). Invariant: a colour is one rounding of an exact integer.

use std::sync::Arc;

use glam::{IVec3, IVec4, UVec4};
use sightlines_backend::host::{Bindings, Buffer};
use sightlines_backend::{Error, Job, Kernel, Program, Result, bindings, host};

use crate::pieces;

mod cases;
mod fixed;
pub mod oracle;

pub use fixed::{Fixed, gamma_table, gaussian_taps, scaled_weights};
pub use oracle::Shape;

/// This kernel in the registry.
pub const KERNEL: Kernel = Kernel {
    name: "illumination",
    summary: "colours of vertices: environment blurred and looked up, matrix times intensities, gamma by table",
    citation: "Sattler et al., Hardware-Accelerated Ambient Occlusion Computation, 2004, sections 3.2, 3.3 and 5",
    programs: || Ok(vec![Illumination::new()?.program]),
    cases: cases::all,
};

/// Most texels on either side of a blur.
pub const MAX_RADIUS: u32 = 64;

/// Most texels of a map: they fill a binding of 128 MiB.
pub const MAX_TEXELS: u32 = 1 << 23;

/// Most lights of one sum, which then stays below 2^63.
pub const MAX_LIGHTS: u32 = 1 << 16;

const GROUP: u32 = 256;

host! {
    /// Mirrors `struct Map`.
    pub struct Map {
        /// Texels a row.
        pub width: u32,
        /// Rows, or 0 for a cube map.
        pub height: u32,
        /// Number of items.
        pub count: u32,
        /// Item of the first invocation.
        pub first: u32,
        /// Texels on either side.
        pub radius: u32,
        /// 1 for a blur along columns.
        pub along_columns: u32,
    }

    /// Mirrors `struct Lights`.
    pub struct Lights {
        /// Number of vertices.
        pub vertices: u32,
        /// Number of positions.
        pub positions: u32,
        /// Number of lights.
        pub count: u32,
        /// Vertex of the first invocation.
        pub first: u32,
        /// Exponents of the channels.
        pub shift: IVec3,
        /// Padding.
        pub _pad: u32,
    }
}

bindings! {
    /// What `blur` is given.
    pub struct Blur {
        uniform map @ 0: Map,
        read texels @ 1: [UVec4],
        read taps @ 2: [u32],
        write blurred @ 3: [UVec4],
    }

    /// What `look_up` is given.
    pub struct LookUp {
        uniform map @ 0: Map,
        read texels @ 1: [UVec4],
        read directions @ 4: [IVec4],
        read weights @ 5: [u32],
        write looked_up @ 6: [UVec4],
    }

    /// What `illuminate` is given.
    pub struct Illuminate {
        uniform lights @ 7: Lights,
        read normals @ 8: [i32],
        read position_of @ 9: [u32],
        read occluded @ 10: [u32],
        read units @ 11: [IVec4],
        read intensities @ 12: [UVec4],
        write colours @ 13: [u32],
    }

    /// What `add_block` is given.
    pub struct AddBlock {
        uniform lights @ 7: Lights,
        read normals @ 8: [i32],
        read position_of @ 9: [u32],
        read occluded @ 10: [u32],
        read units @ 11: [IVec4],
        read intensities @ 12: [UVec4],
        write sums @ 17: [u32],
    }

    /// What `resolve` is given.
    pub struct Resolve {
        uniform lights @ 7: Lights,
        write colours @ 13: [u32],
        write sums @ 17: [u32],
    }

    /// What `encode` is given.
    pub struct Encode {
        uniform lights @ 7: Lights,
        read given @ 14: [u32],
        read thresholds @ 15: [u32],
        write encoded @ 16: [u32],
    }
}

/// Vertices with normals, and the lights that they see.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// All x, then all y, then all z of the normals, which are of length at most 2^15.
    pub normals: Buffer<[i32]>,
    /// Position of every vertex, a column of the bit matrix.
    pub position_of: Buffer<[u32]>,
    /// Number of positions.
    pub positions: u32,
    /// The bits of `vertex_visibility`.
    pub occluded: Buffer<[u32]>,
}

/// Shift of a colour's channel whose texels have shift `texel` and whose lights' weights, shares of the sphere, are
/// shifted up by `weight` ([`scaled_weights`]): an unoccluded vertex under an environment of one is then one.
pub fn colour_shift(texel: i32, weight: u32) -> i32 {
    // 15 for the cosine, less 2: four times the mean of the positive cosines over the sphere is 1.
    13 + texel + weight as i32
}

impl Shape {
    /// Texels in all, if the shape can be a map.
    fn texels(self) -> Option<u32> {
        let count = match self {
            Shape::LatitudeLongitude { width, height } => width.checked_mul(height)?,
            Shape::Cube { side } => side.checked_mul(side)?.checked_mul(6)?,
        };
        (1..=MAX_TEXELS).contains(&count).then_some(count)
    }

    fn map(self, count: u32, first: u32) -> Map {
        let (width, height) = match self {
            Shape::LatitudeLongitude { width, height } => (width, height),
            Shape::Cube { side } => (side, 0),
        };
        Map { width, height, count, first, radius: 0, along_columns: 0 }
    }
}

/// The compiled kernel.
pub struct Illumination {
    program: Arc<Program>,
}

impl Illumination {
    /// Compiles it.
    pub fn new() -> Result<Self> {
        let program = crate::program("illumination", "", &[])?;
        Blur::check(&program, "blur")?;
        LookUp::check(&program, "look_up")?;
        Illuminate::check(&program, "illuminate")?;
        AddBlock::check(&program, "add_block")?;
        Resolve::check(&program, "resolve")?;
        Encode::check(&program, "encode")?;
        Ok(Illumination { program })
    }

    /// One pass of a blur of a latitude-longitude map, along rows or along columns. `taps` are an odd number that sum
    /// to at most 2^16 ([`gaussian_taps`]).
    pub fn record_blur(
        &self,
        job: &mut Job,
        (width, height): (u32, u32),
        taps: Buffer<[u32]>,
        along_columns: bool,
        texels: Buffer<[UVec4]>,
        blurred: Buffer<[UVec4]>,
    ) -> Result<()> {
        let shape = Shape::LatitudeLongitude { width, height };
        let count = check_map(shape, texels)?;
        let radius = taps.len() as u32 / 2;
        if taps.len().is_multiple_of(2) || radius > MAX_RADIUS.min(width) || blurred.len() < u64::from(count) {
            let what = format!("a blur of {width} by {height} texels by {} taps into {}", taps.len(), blurred.len());
            let remedy =
                format!("use at most {MAX_RADIUS} texels on either side and no more than a row, one result a texel");
            return Err(Error::refused(what, remedy));
        }
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(GROUP * (10 * radius + 8)), |job, piece| {
            let map = Map { radius, along_columns: u32::from(along_columns), ..shape.map(count, piece.start * GROUP) };
            let map = job.value("blur", &map);
            job.launch(program, "blur", &Blur { map, texels, taps, blurred }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }

    /// Intensities of the first `count` lights: the texel of each direction, components within [-2^15, 2^15], times its
    /// weight.
    pub fn record_look_up(
        &self,
        job: &mut Job,
        (shape, texels): (Shape, Buffer<[UVec4]>),
        count: u32,
        directions: Buffer<[IVec4]>,
        weights: Buffer<[u32]>,
        looked_up: Buffer<[UVec4]>,
    ) -> Result<()> {
        check_map(shape, texels)?;
        let least = [directions.len(), weights.len(), looked_up.len()].into_iter().min().unwrap_or(0);
        if count > MAX_LIGHTS || least < u64::from(count) {
            let what = format!("a look-up of {count} lights with {least} of directions, weights or intensities");
            return Err(Error::refused(what, format!("give one of each a light, and at most {MAX_LIGHTS} lights")));
        }
        let program = job.program(&self.program);
        pieces::record(job, count.div_ceil(GROUP), u64::from(128 * GROUP), |job, piece| {
            let map = job.value("environment", &shape.map(count, piece.start * GROUP));
            let bound = LookUp { map, texels, directions, weights, looked_up };
            job.launch(program, "look_up", &bound, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }

    /// Colours of all vertices, three planes of f32 bits, under the first `count` lights: unit directions of length
    /// 2^15 in the frame of the normals, and intensities. `shift` is each channel's [`colour_shift`].
    pub fn record_illuminate(
        &self,
        job: &mut Job,
        surface: &Surface,
        block: (u32, Buffer<[IVec4]>, Buffer<[UVec4]>),
        shift: [i32; 3],
        colours: Buffer<[u32]>,
    ) -> Result<()> {
        surface.check(block)?;
        check_colours(surface.vertices(), shift, colours)?;
        let Surface { normals, position_of, occluded, .. } = *surface;
        let (_, units, intensities) = block;
        self.launch_lights(job, "illuminate", surface.lights(block.0, shift), |lights| Illuminate {
            lights,
            normals,
            position_of,
            occluded,
            units,
            intensities,
            colours,
        });
        Ok(())
    }

    /// Adds what a block of lights gives to `sums`, six words a vertex, which are 0 before the first block. The bits of
    /// `surface` are those of the block; all blocks together have at most [`MAX_LIGHTS`] lights.
    pub fn record_block(
        &self,
        job: &mut Job,
        surface: &Surface,
        block: (u32, Buffer<[IVec4]>, Buffer<[UVec4]>),
        sums: Buffer<[u32]>,
    ) -> Result<()> {
        surface.check(block)?;
        check_sums(surface.vertices(), sums)?;
        let Surface { normals, position_of, occluded, .. } = *surface;
        let (_, units, intensities) = block;
        self.launch_lights(job, "add_block", surface.lights(block.0, [0; 3]), |lights| AddBlock {
            lights,
            normals,
            position_of,
            occluded,
            units,
            intensities,
            sums,
        });
        Ok(())
    }

    /// Colours of `vertices` vertices from the sums over all blocks.
    pub fn record_resolve(
        &self,
        job: &mut Job,
        vertices: u32,
        sums: Buffer<[u32]>,
        shift: [i32; 3],
        colours: Buffer<[u32]>,
    ) -> Result<()> {
        check_sums(vertices.into(), sums)?;
        check_colours(vertices.into(), shift, colours)?;
        let lights = Lights { vertices, positions: 0, count: 0, first: 0, shift: IVec3::from_array(shift), _pad: 0 };
        self.launch_lights(job, "resolve", lights, |lights| Resolve { lights, colours, sums });
        Ok(())
    }

    fn launch_lights<B: Bindings>(
        &self,
        job: &mut Job,
        entry: &str,
        lights: Lights,
        bind: impl Fn(Buffer<Lights>) -> B,
    ) {
        let program = job.program(&self.program);
        let words = u64::from(GROUP * (lights.count / 8 + 16));
        pieces::record(job, lights.vertices.div_ceil(GROUP), words, |job, piece| {
            let lights = job.value("lights", &Lights { first: piece.start * GROUP, ..lights });
            job.launch(program, entry, &bind(lights), [piece.len() as u32, 1, 1]);
        });
    }

    /// Bytes of the colours of `vertices` vertices, as [`gamma_table`] encodes them.
    pub fn record_encode(
        &self,
        job: &mut Job,
        vertices: u32,
        given: Buffer<[u32]>,
        thresholds: Buffer<[u32]>,
        encoded: Buffer<[u32]>,
    ) -> Result<()> {
        let fits = given.len() >= 3 * u64::from(vertices) && encoded.len() >= u64::from(vertices);
        if !fits || thresholds.len() != 255 {
            let what = format!("an encoding of {vertices} colours by {} thresholds", thresholds.len());
            return Err(Error::refused(what, "give three words a colour, one a result, and 255 thresholds"));
        }
        let program = job.program(&self.program);
        pieces::record(job, vertices.div_ceil(GROUP), u64::from(32 * GROUP), |job, piece| {
            let lights =
                Lights { vertices, positions: 0, count: 0, first: piece.start * GROUP, shift: IVec3::ZERO, _pad: 0 };
            let lights = job.value("lights", &lights);
            job.launch(program, "encode", &Encode { lights, given, thresholds, encoded }, [piece.len() as u32, 1, 1]);
        });
        Ok(())
    }
}

impl Surface {
    fn vertices(&self) -> u64 {
        self.normals.len() / 3
    }

    fn lights(&self, count: u32, shift: [i32; 3]) -> Lights {
        let (vertices, positions) = (self.vertices() as u32, self.positions);
        Lights { vertices, positions, count, first: 0, shift: IVec3::from_array(shift), _pad: 0 }
    }

    /// Refuses lights for which there are no bits, directions or intensities.
    fn check(&self, (count, units, intensities): (u32, Buffer<[IVec4]>, Buffer<[UVec4]>)) -> Result<()> {
        let bits = u64::from(self.positions) * u64::from(count.div_ceil(32));
        let (lights, vertices) = (units.len().min(intensities.len()), self.vertices());
        let fits = self.occluded.len() >= bits && lights >= count.into() && self.position_of.len() >= vertices;
        if fits && count <= MAX_LIGHTS {
            return Ok(());
        }
        let what = format!(
            "light for {vertices} vertices at {} positions from {count} of {lights} lights, with {} of {bits} words of bits",
            self.positions,
            self.occluded.len()
        );
        Err(Error::refused(what, format!("give a bit for each position and light, and at most {MAX_LIGHTS} lights")))
    }
}

fn check_colours(vertices: u64, shift: [i32; 3], colours: Buffer<[u32]>) -> Result<()> {
    if colours.len() >= 3 * vertices && shift.iter().all(|s| s.abs() <= 96) {
        return Ok(());
    }
    let what = format!("{} words for the colours of {vertices} vertices, with shifts {shift:?}", colours.len());
    Err(Error::refused(what, "give three words a vertex, and shifts within ±96"))
}

fn check_sums(vertices: u64, sums: Buffer<[u32]>) -> Result<()> {
    if sums.len() >= 6 * vertices {
        return Ok(());
    }
    Err(Error::refused(format!("{} words for the sums of {vertices} vertices", sums.len()), "give six words a vertex"))
}

/// The number of texels of a map that `texels` holds.
fn check_map(shape: Shape, texels: Buffer<[UVec4]>) -> Result<u32> {
    match shape.texels() {
        Some(count) if texels.len() >= u64::from(count) => Ok(count),
        _ => {
            let what = format!("a map {shape:?} of {} texels", texels.len());
            Err(Error::refused(what, format!("use 1 to {MAX_TEXELS} texels, all of them given")))
        }
    }
}

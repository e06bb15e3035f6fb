//! Pictures of the visible share: PNG for the eye, EXR for further work.
//!
//! A [`Share`] holds whole numbers, so pictures are equal wherever the sets are. Values are linear: white sees the
//! whole light. Column and row of a pixel are those of its texel.

use std::io;
use std::path::Path;

use exr::prelude::{Encoding, Image, SpecificChannels, WritableImage};

use crate::error::Result;
use crate::output;
use crate::shadows::{Bake, Sets};

/// How many light samples each texel sees, over one or more lights.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Share {
    /// Texels a side.
    pub resolution: u32,
    /// Samples that there are.
    pub samples: u32,
    /// Samples that each texel sees, row after row.
    pub visible: Vec<u32>,
}

/// Bits of a pixel of a PNG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// 8 bits: 256 greys.
    Eight,
    /// 16 bits: enough for every number of samples.
    Sixteen,
}

impl Share {
    /// The share of one light.
    pub fn of(bake: &Bake) -> Self {
        let Sets { resolution, samples, .. } = bake.sets;
        Share { resolution, samples, visible: bake.visible.clone() }
    }

    /// Adds another light of the same receiver.
    ///
    /// # Panics
    ///
    /// Where the resolutions differ.
    pub fn add(&mut self, other: &Share) {
        assert_eq!(self.resolution, other.resolution, "lights of one receiver");
        self.samples += other.samples;
        self.visible.iter_mut().zip(&other.visible).for_each(|(sum, more)| *sum += more);
    }

    /// Mean over all texels, from 0 to 1.
    pub fn mean(&self) -> f64 {
        let seen: u64 = self.visible.iter().map(|&n| u64::from(n)).sum();
        seen as f64 / (u64::from(self.samples) * self.visible.len() as u64) as f64
    }

    /// Every texel as a whole number from 0 to `white`, rounded to the nearest.
    fn scaled(&self, white: u32) -> impl Iterator<Item = u32> {
        let samples = u64::from(self.samples);
        self.visible.iter().map(move |&n| ((u64::from(n) * u64::from(white) + samples / 2) / samples) as u32)
    }
}

/// Writes a grey PNG: 0 sees nothing of the light, the largest value all of it. No gamma is applied.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_png(path: &Path, share: &Share, depth: Depth) -> Result<()> {
    let (depth, bytes): (_, Vec<u8>) = match depth {
        Depth::Eight => (png::BitDepth::Eight, share.scaled(0xFF).map(|v| v as u8).collect()),
        Depth::Sixteen => {
            (png::BitDepth::Sixteen, share.scaled(0xFFFF).flat_map(|v| (v as u16).to_be_bytes()).collect())
        }
    };
    write_grey(path, [share.resolution; 2], depth, &bytes)
}

/// Writes pictures of one receiver side by side, as [`write_png`] writes one with 8 bits.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_panels(path: &Path, panels: &[Share]) -> Result<()> {
    let side = panels.first().map_or(0, |share| share.resolution);
    let pictures: Vec<Vec<u8>> = panels.iter().map(|share| share.scaled(0xFF).map(|v| v as u8).collect()).collect();
    let row = |y: usize| pictures.iter().flat_map(move |picture| &picture[y * side as usize..(y + 1) * side as usize]);
    let bytes: Vec<u8> = (0..side as usize).flat_map(row).copied().collect();
    write_grey(path, [side * panels.len() as u32, side], png::BitDepth::Eight, &bytes)
}

fn write_grey(path: &Path, [width, height]: [u32; 2], depth: png::BitDepth, bytes: &[u8]) -> Result<()> {
    let failed = |e| match e {
        png::EncodingError::IoError(e) => e,
        other => io::Error::other(other),
    };
    output::write(path, |out| {
        let mut encoder = png::Encoder::new(out, width, height);
        encoder.set_color(png::ColorType::Grayscale);
        encoder.set_depth(depth);
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(bytes).map_err(failed)?;
        writer.finish().map_err(failed)
    })
}

/// Writes an OpenEXR file with one f32 channel `Y`: the visible share, from 0 to 1.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_exr(path: &Path, share: &Share) -> Result<()> {
    let side = share.resolution as usize;
    let pixel = |at: exr::prelude::Vec2<usize>| (share.visible[at.y() * side + at.x()] as f32 / share.samples as f32,);
    let channels = SpecificChannels::build().with_channel("Y").with_pixel_fn(pixel);
    let layer = exr::prelude::Layer::new(
        (side, side),
        exr::prelude::LayerAttributes::default(),
        Encoding::SMALL_LOSSLESS,
        channels,
    );
    output::write(path, |out| {
        Image::from_layer(layer).write().non_parallel().to_buffered(out).map_err(|e| match e {
            exr::error::Error::Io(e) => e,
            other => io::Error::other(other),
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_add_and_round_to_the_nearest() {
        let mut share = Share { resolution: 2, samples: 32, visible: vec![0, 1, 16, 32] };
        assert_eq!(share.scaled(255).collect::<Vec<_>>(), [0, 8, 128, 255]);
        assert_eq!(share.mean(), 49.0 / 128.0);
        share.add(&Share { resolution: 2, samples: 32, visible: vec![32, 0, 0, 32] });
        assert_eq!((share.samples, &*share.visible), (64, &[32, 1, 16, 64][..]));
        assert_eq!(share.scaled(0xFFFF).collect::<Vec<_>>(), [32768, 1024, 16384, 65535]);
    }
}

//! Pictures of the visible share: PNG for the eye, EXR for further work.
//!
//! A [`Share`] holds whole numbers, so pictures are equal wherever the sets are; a [`Picture`] holds f64 made of such
//! by + − × ÷. Values are linear: white sees the whole light. Column and row of a pixel are those of its texel.

use std::io;
use std::path::Path;

use exr::prelude::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, WritableImage};

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

/// Red, green and blue of each texel, linear.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Texels a side.
    pub resolution: u32,
    /// Colours, row after row.
    pub pixels: Vec<[f64; 3]>,
}

impl Picture {
    /// The greatest value of any channel.
    pub fn peak(&self) -> f64 {
        self.pixels.as_flattened().iter().copied().fold(0.0, f64::max)
    }
}

/// Writes a grey PNG: 0 sees nothing of the light, the largest value all of it. No gamma is applied.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_png(path: &Path, share: &Share, depth: Depth) -> Result<()> {
    encode_png(path, share.resolution, png::ColorType::Grayscale, depth, share.scaled(depth.white()))
}

/// Writes a PNG in colour: black is 0, the largest value `white` or more. No gamma is applied.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_picture_png(path: &Path, picture: &Picture, white: f64, depth: Depth) -> Result<()> {
    let most = f64::from(depth.white());
    let part = |value: &f64| if white > 0.0 { value / white } else { 0.0 };
    let values = picture.pixels.as_flattened().iter().map(|value| (part(value).clamp(0.0, 1.0) * most).round() as u32);
    encode_png(path, picture.resolution, png::ColorType::Rgb, depth, values)
}

impl Depth {
    /// The largest value.
    fn white(self) -> u32 {
        match self {
            Depth::Eight => 0xFF,
            Depth::Sixteen => 0xFFFF,
        }
    }
}

fn encode_png(
    path: &Path,
    side: u32,
    colour: png::ColorType,
    depth: Depth,
    values: impl Iterator<Item = u32>,
) -> Result<()> {
    let (depth, bytes): (_, Vec<u8>) = match depth {
        Depth::Eight => (png::BitDepth::Eight, values.map(|v| v as u8).collect()),
        Depth::Sixteen => (png::BitDepth::Sixteen, values.flat_map(|v| (v as u16).to_be_bytes()).collect()),
    };
    encode_bytes(path, [side; 2], colour, depth, &bytes)
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
    let size = [side * panels.len() as u32, side];
    encode_bytes(path, size, png::ColorType::Grayscale, png::BitDepth::Eight, &bytes)
}

fn encode_bytes(
    path: &Path,
    [width, height]: [u32; 2],
    colour: png::ColorType,
    depth: png::BitDepth,
    bytes: &[u8],
) -> Result<()> {
    let failed = |e| match e {
        png::EncodingError::IoError(e) => e,
        other => io::Error::other(other),
    };
    output::write(path, |out| {
        let mut encoder = png::Encoder::new(out, width, height);
        encoder.set_color(colour);
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
    let values = share.visible.iter().map(|&n| n as f32 / share.samples as f32);
    encode_exr(path, share.resolution, [("Y", values.collect())])
}

/// Writes an OpenEXR file with the f32 channels `R`, `G` and `B`.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write_picture_exr(path: &Path, picture: &Picture) -> Result<()> {
    let channel = |i: usize| picture.pixels.iter().map(|pixel| pixel[i] as f32).collect();
    encode_exr(path, picture.resolution, [("R", channel(0)), ("G", channel(1)), ("B", channel(2))])
}

fn encode_exr<const N: usize>(path: &Path, side: u32, channels: [(&str, Vec<f32>); N]) -> Result<()> {
    let channels = channels.map(|(name, values)| AnyChannel::new(name, FlatSamples::F32(values)));
    let size = (side as usize, side as usize);
    let channels = AnyChannels::sort(channels.into_iter().collect());
    let layer = Layer::new(size, LayerAttributes::default(), Encoding::SMALL_LOSSLESS, channels);
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

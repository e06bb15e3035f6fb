//! Radiance's `.hdr` pictures: RGBE texels, flat or run-length encoded, in any of the eight orders of scanlines.
//!
//! G. Ward, "Real Pixels", in *Graphics Gems II* (1991), and the format's description in Radiance's documentation. It
//! is read here because results must be the same bits on every host and every damage must be named: a texel is mantissa
//! × 2^(exponent − 136) exactly, and neither runs past a scanline nor missing bytes pass for a picture.

use crate::error::{Place, Result};

/// Most texels of a picture.
pub(super) const MAX_TEXELS: u64 = 1 << 25;

/// Columns, rows and texels, the upper row first.
pub(super) type Picture = (u32, u32, Vec<[f32; 3]>);

const REMEDY: &str = "export the environment again, as Radiance HDR or OpenEXR";

/// Reads a picture; `place` is its file.
pub(super) fn read(place: &Place, bytes: &[u8]) -> Result<Picture> {
    let refuse = |what: String| place.clone().error(what, REMEDY);
    let (size, body) = header(bytes).map_err(refuse)?;
    let mut rest = body;
    let mut scanlines = Vec::with_capacity(size.texels());
    for row in 0..size.scanlines {
        let scanline = scanline(&mut rest, size.length)
            .map_err(|what| place.clone().element(format!("scanline {}", row + 1)).error(what, REMEDY))?;
        scanlines.extend(scanline.into_iter().map(texel));
    }
    Ok(size.upright(&scanlines))
}

/// How scanlines lie in the picture.
struct Size {
    scanlines: u32,
    length: u32,
    /// Whether scanlines are columns.
    columns: bool,
    /// Whether scanlines come from the bottom or the right, and texels in them.
    reversed: [bool; 2],
}

impl Size {
    fn texels(&self) -> usize {
        self.scanlines as usize * self.length as usize
    }

    fn upright(&self, texels: &[[f32; 3]]) -> Picture {
        let (width, height) = if self.columns { (self.scanlines, self.length) } else { (self.length, self.scanlines) };
        let from = |row: u32, column: u32| {
            let (line, at) = if self.columns { (column, row) } else { (row, column) };
            let line = if self.reversed[0] { self.scanlines - 1 - line } else { line };
            let at = if self.reversed[1] { self.length - 1 - at } else { at };
            texels[(line * self.length + at) as usize]
        };
        let upright = (0..height).flat_map(|row| (0..width).map(move |column| (row, column)));
        (width, height, upright.map(|(row, column)| from(row, column)).collect())
    }
}

/// The size, and what follows the header.
fn header(bytes: &[u8]) -> Result<(Size, &[u8]), String> {
    let mut rest = bytes;
    let mut line = || {
        let end = rest.iter().take(4096).position(|&b| b == b'\n').ok_or("its header is cut off")?;
        let line = String::from_utf8_lossy(&rest[..end]).trim_end().to_owned();
        rest = &rest[end + 1..];
        Ok::<_, String>(line)
    };
    if !line()?.starts_with("#?") {
        return Err("it is no Radiance picture, which begins with `#?`".into());
    }
    loop {
        let entry = line()?;
        match entry.strip_prefix("FORMAT=") {
            _ if entry.is_empty() => break,
            Some("32-bit_rle_rgbe") | None => {}
            Some(other) => return Err(format!("its format is {other}, and 32-bit_rle_rgbe is read")),
        }
    }
    let size = line()?;
    let wrong = || format!("its size is `{size}`, which is none");
    let words: Vec<&str> = size.split_whitespace().collect();
    let &[first, scanlines, second, length] = words.as_slice() else { return Err(wrong()) };
    let (columns, reversed) = match (first, second) {
        ("-Y", "+X") => (false, [false, false]),
        ("-Y", "-X") => (false, [false, true]),
        ("+Y", "+X") => (false, [true, false]),
        ("+Y", "-X") => (false, [true, true]),
        ("+X", "-Y") => (true, [false, false]),
        ("+X", "+Y") => (true, [false, true]),
        ("-X", "-Y") => (true, [true, false]),
        ("-X", "+Y") => (true, [true, true]),
        _ => return Err(wrong()),
    };
    let side = |word: &str| word.parse::<u32>().ok().filter(|side| *side > 0).ok_or_else(wrong);
    let (scanlines, length) = (side(scanlines)?, side(length)?);
    if u64::from(scanlines) * u64::from(length) > MAX_TEXELS {
        return Err(format!("it has {scanlines} by {length} texels, and at most {MAX_TEXELS} are read"));
    }
    Ok((Size { scanlines, length, columns, reversed }, rest))
}

/// RGBE of one scanline.
fn scanline(rest: &mut &[u8], length: u32) -> Result<Vec<[u8; 4]>, String> {
    let length = length as usize;
    let encoded = rest.len() >= 4 && rest[..2] == [2, 2] && rest[2] < 128;
    if encoded && (8..1 << 15).contains(&length) {
        let named = usize::from(rest[2]) << 8 | usize::from(rest[3]);
        if named != length {
            return Err(format!("it says that it has {named} texels, and the picture has {length}"));
        }
        *rest = &rest[4..];
        return planes(rest, length);
    }
    flat(rest, length)
}

/// Four planes of runs, as Radiance writes them since 1991.
fn planes(rest: &mut &[u8], length: usize) -> Result<Vec<[u8; 4]>, String> {
    let mut texels = vec![[0; 4]; length];
    for plane in 0..4 {
        let mut at = 0;
        while at < length {
            let [count] = take(rest)?;
            let run = count > 128;
            let count = usize::from(if run { count - 128 } else { count });
            if count == 0 || at + count > length {
                return Err(format!("a run of {count} at texel {at} of {length}"));
            }
            let mut value = 0;
            for (place, texel) in texels[at..at + count].iter_mut().enumerate() {
                if place == 0 || !run {
                    [value] = take(rest)?;
                }
                texel[plane] = value;
            }
            at += count;
        }
    }
    Ok(texels)
}

/// Whole texels; (1, 1, 1, n) repeats the last one n times, and once more 256 times as often for each that follows it.
fn flat(rest: &mut &[u8], length: usize) -> Result<Vec<[u8; 4]>, String> {
    let mut texels: Vec<[u8; 4]> = Vec::with_capacity(length);
    let mut shift = 0;
    while texels.len() < length {
        let texel: [u8; 4] = take(rest)?;
        if texel[..3] != [1, 1, 1] {
            texels.push(texel);
            shift = 0;
            continue;
        }
        let (at, count) = (texels.len(), usize::from(texel[3]) << shift);
        let last = *texels.last().ok_or("it begins with a repetition")?;
        if shift > 16 || at + count > length {
            return Err(format!("a run of {count} at texel {at} of {length}"));
        }
        texels.resize(at + count, last);
        shift += 8;
    }
    Ok(texels)
}

fn take<const N: usize>(rest: &mut &[u8]) -> Result<[u8; N], String> {
    let (bytes, after) = rest.split_first_chunk().ok_or("the file ends before it does")?;
    *rest = after;
    Ok(*bytes)
}

fn texel([red, green, blue, exponent]: [u8; 4]) -> [f32; 3] {
    let value = |mantissa: u8| libm::scalbnf(f32::from(mantissa), i32::from(exponent) - 136);
    if exponent == 0 { [0.0; 3] } else { [red, green, blue].map(value) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(size: &str, body: &[u8]) -> Result<Picture> {
        let header = format!("#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n{size}\n");
        read(&Place::default(), &[header.as_bytes(), body].concat())
    }

    #[test]
    fn texels_are_exact() {
        assert_eq!(texel([128, 64, 1, 129]), [1.0, 0.5, 1.0 / 128.0]);
        assert_eq!(texel([255, 255, 255, 0]), [0.0; 3]);
        assert_eq!(texel([128, 0, 0, 249])[0], f32::from_bits((127 + 120) << 23));
        assert_eq!(texel([128, 0, 0, 20])[0], f32::from_bits((127 - 109) << 23));
    }

    #[test]
    fn flat_repeated_and_encoded_scanlines_are_read() {
        let one = [128, 128, 128, 129];
        let (w, h, texels) = picture("-Y 1 +X 3", &[one, [64, 0, 0, 129], [1, 1, 1, 1]].concat()).unwrap();
        assert_eq!((w, h, texels), (3, 1, vec![[1.0; 3], [0.5, 0.0, 0.0], [0.5, 0.0, 0.0]]));
        // Red 0, 1, … 8 apart; green in a run; blue in two; exponents in a run.
        let body =
            [&[2, 2, 0, 9, 9][..], &[0, 1, 2, 3, 4, 5, 6, 7, 8], &[137, 128], &[132, 7, 133, 9], &[137, 136]].concat();
        let (_, _, texels) = picture("-Y 1 +X 9", &body).unwrap();
        assert_eq!(texels[8], [8.0, 128.0, 9.0]);
        assert_eq!(texels[3], [3.0, 128.0, 7.0]);
    }

    #[test]
    fn scanlines_of_every_order_are_turned_upright() {
        let texel = |n: u8| [n, 0, 0, 136];
        let body = [1, 2, 3, 4, 5, 6].map(texel).concat();
        let reds = |size: &str| {
            let (width, _, texels) = picture(size, &body).unwrap();
            (width, texels.into_iter().map(|t| t[0] as u8).collect::<Vec<_>>())
        };
        assert_eq!(reds("-Y 2 +X 3"), (3, vec![1, 2, 3, 4, 5, 6]));
        assert_eq!(reds("+Y 2 +X 3"), (3, vec![4, 5, 6, 1, 2, 3]));
        assert_eq!(reds("-Y 2 -X 3"), (3, vec![3, 2, 1, 6, 5, 4]));
        assert_eq!(reds("+X 2 -Y 3"), (2, vec![1, 4, 2, 5, 3, 6]));
        assert_eq!(reds("-X 2 +Y 3"), (2, vec![6, 3, 5, 2, 4, 1]));
    }

    #[test]
    fn damage_is_named() {
        let message = |result: Result<Picture>| result.unwrap_err().to_string();
        for (size, body, expected) in [
            ("-Y 1 +X 2", &[1_u8, 2, 3, 4][..], "scanline 1: the file ends before it does"),
            ("-Y 1 +X 9", &[2, 2, 0, 8, 0], "it says that it has 8 texels, and the picture has 9"),
            ("-Y 1 +X 9", &[2, 2, 0, 9, 138, 1], "a run of 10 at texel 0 of 9"),
            ("-Y 1 +X 9", &[2, 2, 0, 9, 0, 1], "a run of 0 at texel 0 of 9"),
            ("-Y 1 +X 2", &[1, 1, 1, 4], "it begins with a repetition"),
            ("-Y 1 +X 2", &[9, 1, 1, 4, 1, 1, 1, 2], "a run of 2 at texel 1 of 2"),
            ("-Y 0 +X 2", &[], "its size is `-Y 0 +X 2`"),
            ("2 2", &[], "its size is `2 2`"),
            ("-Y 99999 +X 99999", &[], "at most 33554432 are read"),
        ] {
            assert!(message(picture(size, body)).contains(expected), "{size}: {}", message(picture(size, body)));
        }
        let read = |text: &str| message(read(&Place::default(), text.as_bytes()));
        assert!(read("PNG\n").contains("begins with `#?`"));
        assert!(read("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n").contains("its format is 32-bit_rle_xyze"));
        assert!(read("#?RADIANCE\n").contains("cut off"));
    }
}

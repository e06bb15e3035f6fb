//! The hidden-sample sets in a file, for programs that want who is hidden rather than how many.
//!
//! All numbers are little-endian. Offsets and sizes in bytes:
//!
//! | offset | size | what |
//! |---|---|---|
//! | 0 | 16 | the magic line `sightlines sets` and a line feed |
//! | 16 | 4 | u32: version of this layout, 2 |
//! | 20 | 4 | u32: version of the numerics contract under which the sets were baked |
//! | 24 | 4 | u32: resolution, texels a side of the receiver |
//! | 28 | 4 | u32: samples of the light |
//! | 32 | 4 | u32: words a texel, samples / bits, rounded up |
//! | 36 | 4 | u32: bits, the samples of a word: 31 or 32 |
//! | 40 | 8 | f64: side of a grid cell, in scene units |
//! | 48 | 8 × samples | two i32 a sample: where it stands, in grid cells in the frame of the light |
//! | … | 4 × words × resolution² | u32: the sets, row after row; bit i % bits of word i / bits: sample i is hidden |
//! | … | 32 | BLAKE3 digest of all that stands before |

use std::io;
use std::path::Path;

use sightlines_backend::CONTRACT_VERSION;

use crate::error::{Place, Result};
use crate::input;
use crate::output;
use crate::shadows::placement::MAX_SAMPLES;
use crate::shadows::{MAX_RESOLUTION, MAX_WORDS, Sets};

/// First bytes of a file of sets.
pub const MAGIC: [u8; 16] = *b"sightlines sets\n";
/// Version of the layout.
pub const VERSION: u32 = 2;

const REMEDY: &str = "bake the sets again with `sightlines shadows --sets`";

const HEADER: usize = 48;
const DIGEST: usize = blake3::OUT_LEN;
/// Bytes that are converted and hashed at a time.
const CHUNK: usize = 1 << 16;

/// Writes the sets of one light.
///
/// # Errors
///
/// A file that cannot be written; then nothing of it is left.
pub fn write(path: &Path, sets: &Sets) -> Result<()> {
    output::write(path, |out| {
        let mut hasher = blake3::Hasher::new();
        let mut emit = |bytes: &[u8]| -> io::Result<()> {
            hasher.update(bytes);
            out.write_all(bytes)
        };
        emit(&header(sets))?;
        let samples = sets.samples_uv.as_flattened();
        emit(&samples.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>())?;
        for words in sets.masks.chunks(CHUNK / 4) {
            emit(&words.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>())?;
        }
        let digest = hasher.finalize();
        out.write_all(digest.as_bytes())
    })
}

fn header(sets: &Sets) -> Vec<u8> {
    let mut header = MAGIC.to_vec();
    for field in [VERSION, CONTRACT_VERSION, sets.resolution, sets.samples, sets.words, sets.bits] {
        header.extend(field.to_le_bytes());
    }
    header.extend(sets.cell.to_le_bytes());
    header
}

/// Reads the sets of one light.
///
/// # Errors
///
/// A file that is missing, is not such a file, is of another version, or is damaged.
pub fn read(path: &Path) -> Result<Sets> {
    // The largest file that can be right.
    let most = (HEADER + 8 * MAX_SAMPLES as usize + DIGEST) as u64 + 4 * MAX_WORDS;
    decode(&input::read(path, most, REMEDY)?).map_err(|what| Place::file(path).error(what, REMEDY))
}

fn decode(bytes: &[u8]) -> Result<Sets, String> {
    let Some((header, rest)) = bytes.split_at_checked(HEADER).filter(|(header, _)| header.starts_with(&MAGIC)) else {
        return Err("it is no file of hidden-sample sets".into());
    };
    let (fields, cell) = header[MAGIC.len()..].split_at(24);
    let &[version, contract, resolution, samples, words, bits] = &words_of(fields)[..] else {
        unreachable!("24 bytes")
    };
    if (version, contract) != (VERSION, CONTRACT_VERSION) {
        let [layout, numerics] = [VERSION, CONTRACT_VERSION];
        return Err(format!("layout {version} and contract {contract}, where {layout} and {numerics} are read"));
    }
    let count = u64::from(resolution).pow(2) * u64::from(words);
    let shape = (1..=MAX_RESOLUTION).contains(&resolution) && (1..=MAX_SAMPLES).contains(&samples);
    if !shape || !matches!(bits, 31 | 32) || words != samples.div_ceil(bits) || count > MAX_WORDS {
        let what = format!("{resolution} texels a side, {samples} samples, {words} words of {bits} bits");
        return Err(format!("its header is damaged: {what}"));
    }
    let cell = f64::from_le_bytes(cell.try_into().map_err(|_| "its header is cut off")?);
    if !(cell.is_finite() && cell > 0.0) {
        return Err(format!("its header is damaged: a grid cell of {cell}"));
    }
    let (positions, masks) = (8 * samples as usize, 4 * count as usize);
    if rest.len() != positions + masks + DIGEST {
        return Err(format!("it has {} bytes, {} are right", bytes.len(), HEADER + positions + masks + DIGEST));
    }
    let (body, digest) = bytes.split_at(bytes.len() - DIGEST);
    if blake3::hash(body).as_bytes() != digest {
        return Err("its bytes do not match their digest".into());
    }
    let (positions, masks) = body[HEADER..].split_at(positions);
    let samples_uv = words_of(positions).as_chunks::<2>().0.iter().map(|uv| uv.map(|v| v as i32)).collect();
    Ok(Sets { resolution, samples, bits, words, masks: words_of(masks), samples_uv, cell })
}

fn words_of(bytes: &[u8]) -> Vec<u32> {
    bytes.as_chunks::<4>().0.iter().map(|&word| u32::from_le_bytes(word)).collect()
}

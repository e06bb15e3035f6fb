//! Pictures and sets: round trips, and what damaged files and full disks come to.

use exr::prelude::{ReadChannels, ReadLayers};
use sightlines_visibility::image::{Depth, Share, write_exr, write_png};
use sightlines_visibility::shadows::{Bake, Sets, Work};
use sightlines_visibility::{Error, sets};

use super::{Folder, refusal};

/// Sets with a known pattern.
fn known() -> Sets {
    let (resolution, samples, words) = (3, 64, 2);
    let masks = (0..18_u32).map(|i| i.wrapping_mul(0x9E37_79B9) >> (i % 7)).collect();
    let samples_uv = (0..64).map(|i| [i % 8 - 4, i / 8 - 4]).collect();
    Sets { resolution, samples, bits: 32, words, masks, samples_uv, cell: 0.125 }
}

#[test]
fn the_share_of_a_bake_is_what_the_device_counted() {
    let visible = vec![64, 31, 64, 64, 64, 64, 64, 64, 0];
    let share = Share::of(&Bake { sets: known(), visible: visible.clone(), work: Work::default() });
    assert_eq!((share.resolution, share.samples, &share.visible), (3, 64, &visible));
    assert_eq!(share.mean(), (7.0 * 64.0 + 31.0) / (9.0 * 64.0));
}

fn read_png(bytes: &[u8]) -> (png::OutputInfo, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut data).unwrap();
    data.truncate(info.buffer_size());
    (info, data)
}

#[test]
fn png_of_8_and_16_bits() {
    let folder = Folder::new();
    let share = Share { resolution: 2, samples: 1024, visible: vec![0, 1024, 512, 3] };
    let path = folder.path("a.png");
    write_png(&path, &share, Depth::Eight).unwrap();
    let (info, data) = read_png(&std::fs::read(&path).unwrap());
    assert_eq!((info.width, info.height, info.color_type), (2, 2, png::ColorType::Grayscale));
    assert_eq!((info.bit_depth, data), (png::BitDepth::Eight, vec![0, 255, 128, 1]));
    write_png(&path, &share, Depth::Sixteen).unwrap();
    let (info, data) = read_png(&std::fs::read(&path).unwrap());
    assert_eq!(info.bit_depth, png::BitDepth::Sixteen);
    assert_eq!(data, [0_u16, 65535, 32768, 192].map(u16::to_be_bytes).concat());
    assert_eq!(folder.names(), ["a.png"]);
}

#[test]
fn exr_holds_the_exact_share() {
    let folder = Folder::new();
    let share = Share { resolution: 3, samples: 96, visible: vec![0, 1, 2, 48, 32, 96, 95, 3, 7] };
    let path = folder.path("a.exr");
    write_exr(&path, &share).unwrap();
    let read = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = read.all_attributes().from_file(&path).unwrap();
    let channels = image.layer_data.channel_data.list;
    assert_eq!((channels.len(), channels[0].name.to_string()), (1, "Y".to_owned()));
    let exr::prelude::FlatSamples::F32(values) = &channels[0].sample_data else { panic!("not f32") };
    let expected: Vec<f32> = share.visible.iter().map(|&n| n as f32 / 96.0).collect();
    assert_eq!(values, &expected);
    assert_eq!(folder.names(), ["a.exr"]);
}

#[test]
fn equal_shares_make_equal_files() {
    let folder = Folder::new();
    let share = Share { resolution: 3, samples: 64, visible: (0..9).map(|i| 7 * i).collect() };
    for name in ["a", "b"] {
        write_png(&folder.path(&format!("{name}.png")), &share, Depth::Eight).unwrap();
        write_exr(&folder.path(&format!("{name}.exr")), &share).unwrap();
        sets::write(&folder.path(&format!("{name}.sets")), &known()).unwrap();
    }
    let read = |name: &str| std::fs::read(folder.path(name)).unwrap();
    for kind in ["png", "exr", "sets"] {
        assert_eq!(read(&format!("a.{kind}")), read(&format!("b.{kind}")), "{kind}");
    }
}

#[test]
fn sets_come_back_and_stand_where_the_documentation_says() {
    let folder = Folder::new();
    let path = folder.path("a.sets");
    sets::write(&path, &known()).unwrap();
    assert_eq!(sets::read(&path).unwrap(), known());
    let bytes = std::fs::read(&path).unwrap();
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert!(bytes.starts_with(b"sightlines sets\n"));
    assert_eq!([16, 24, 28, 32, 36].map(word), [2, 3, 64, 2, 32]);
    assert_eq!(word(20), sightlines_backend::CONTRACT_VERSION);
    assert_eq!(bytes[40..48], 0.125_f64.to_le_bytes());
    assert_eq!((word(48) as i32, word(52) as i32), (-4, -4));
    let masks = 48 + 8 * 64;
    assert_eq!((0..18).map(|i| word(masks + 4 * i)).collect::<Vec<_>>(), known().masks);
    assert_eq!(&bytes[masks + 72..], blake3::hash(&bytes[..masks + 72]).as_bytes());
}

#[test]
fn large_sets_come_back() {
    let masks = (0..200 * 200 * 4_u32).map(|i| i.wrapping_mul(0x85EB_CA6B)).collect();
    let large = Sets {
        resolution: 200,
        samples: 128,
        bits: 32,
        words: 4,
        masks,
        samples_uv: vec![[i32::MIN, 7]; 128],
        cell: 1e-3,
    };
    let path = Folder::new();
    let path = path.path("a.sets");
    sets::write(&path, &large).unwrap();
    assert!(sets::read(&path).unwrap() == large);
}

#[test]
fn damaged_sets_are_refused() {
    let folder = Folder::new();
    let path = folder.path("a.sets");
    sets::write(&path, &known()).unwrap();
    let whole = std::fs::read(&path).unwrap();
    let refused = |bytes: &[u8]| refusal(sets::read(&folder.put("b.sets", bytes)), "b.sets");
    for at in 0..whole.len() {
        let mut flipped = whole.clone();
        flipped[at] ^= 0x10;
        refused(&flipped);
        refused(&whole[..at]);
    }
    assert!(refused(&[&whole[..], b"x"].concat()).contains("bytes, "));
    assert!(refused(b"PNG").contains("no file of hidden-sample sets"));
    let with = |at: usize, value: u32| {
        let mut bytes = whole.clone();
        bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
        refused(&bytes)
    };
    assert!(with(16, 3).contains("layout 3"));
    assert!(with(20, 77).contains("contract 77"));
    assert!(with(24, 0).contains("0 texels a side"));
    assert!(with(24, u32::MAX).contains("4294967295 texels a side"));
    assert!(with(28, 65).contains("65 samples"));
    assert!(with(32, 3).contains("3 words"));
    assert!(with(36, 30).contains("of 30 bits"));
    assert!(with(44, 0xFFF0_0000).contains("a grid cell of -inf"));
    assert!(with(24, 4).contains("bytes, "));
    assert!(with(600, 0).contains("do not match their digest"));
    refusal(sets::read(&folder.path("none.sets")), "none.sets");
}

#[test]
fn a_target_that_cannot_be_written_is_named() {
    let folder = Folder::new();
    let share = Share { resolution: 3, samples: 64, visible: (0..9).map(|i| 7 * i).collect() };
    let path = folder.path("none/a");
    for error in [
        write_png(&path, &share, Depth::Eight).unwrap_err(),
        write_exr(&path, &share).unwrap_err(),
        sets::write(&path, &known()).unwrap_err(),
    ] {
        assert!(matches!(&error, Error::Write { path: named, .. } if *named == path), "{error}");
        assert!(error.to_string().contains("make its folder"), "{error}");
    }
    assert_eq!(folder.names(), [""; 0]);
}

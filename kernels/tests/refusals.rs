//! Work that a kernel cannot do is refused when it is recorded, with the numbers and a remedy.

use sightlines_backend::{ErrorKind, Job, Result};
use sightlines_kernels::item_histogram::{ItemHistogram, Order, Tiling};
use sightlines_kernels::mip_pyramid::{self, MipPyramid};
use sightlines_kernels::op_map::{OpMap, Truth};
use sightlines_kernels::popcount::{Method, Popcount, Shape};
use sightlines_kernels::raster::{self, Faces, Ids, Mesh, Picture, Placement, Raster, View};
use sightlines_kernels::region_sets::{self, RegionSets};
use sightlines_kernels::sat::{Extent, Sat};
use sightlines_kernels::scan::{self, Kind, Scan};

#[track_caller]
fn refused(result: Result<()>, number: &str) {
    let error = result.expect_err("it must be refused");
    match error.kind() {
        ErrorKind::Refused { what, remedy } => {
            assert!(what.contains(number), "`{what}` does not name {number}");
            assert!(!remedy.is_empty());
        }
        other => panic!("not a refusal: {other}"),
    }
}

#[test]
fn masks_of_too_many_words_or_of_no_bits() {
    let kernel = Popcount::new().expect("it compiles");
    let mut job = Job::new();
    let masks = job.zeroed("masks", 64);
    let [hidden, visible] = ["hidden", "visible"].map(|name| job.zeroed(name, 1));
    for (samples, bits) in [(0, 32), (33 * 32, 32), (64, 0), (64, 33), (33, 1)] {
        let shape = Shape { receivers: 1, samples, bits };
        refused(kernel.record(&mut job, Method::Builtin, shape, masks, hidden, visible), &samples.to_string());
    }
    for (receivers, samples) in [(2, 32), (1, 1024)] {
        let shape = Shape { receivers, samples, bits: 16 };
        let short = job.zeroed("masks", u64::from(receivers * samples / 16) - 1);
        refused(kernel.record(&mut job, Method::Table, shape, short, hidden, visible), &receivers.to_string());
    }
    let shape = Shape { receivers: 1, samples: 1024, bits: 32 };
    kernel.record(&mut job, Method::Builtin, shape, masks, hidden, visible).expect("32 words are allowed");
}

#[test]
fn scans_of_too_many_words_or_of_odd_buffers() {
    let kernel = Scan::new().expect("it compiles");
    let mut job = Job::new();
    let [four, five, none] = [4, 5, 0].map(|len| job.zeroed::<u32>("words", len));
    refused(kernel.record(&mut job, Kind::Inclusive, scan::MAX_COUNT + 1, four, four), "33554433");
    refused(kernel.record(&mut job, Kind::Inclusive, 5, five, four), "of 5");
    refused(kernel.record(&mut job, Kind::Inclusive, 5, four, four), "5 words");
    refused(kernel.record(&mut job, Kind::Exclusive, 0, none, four), "of 0");
    assert!(job.recordings.is_empty(), "a refusal records nothing");
}

#[test]
fn tables_of_odd_or_large_images() {
    let kernel = Sat::new().expect("it compiles");
    let mut job = Job::new();
    let [image, table] = ["image", "table"].map(|name| job.zeroed::<u32>(name, 64));
    for (width, height) in [(0, 4), (6, 4), (4100, 1), (4, (1 << 16) + 1), (16, 5)] {
        refused(kernel.record(&mut job, (Extent { width, height }, 1), image, table), &height.to_string());
    }
    let (rectangles, sums) = (job.zeroed("rectangles", 2), job.zeroed("sums", 3));
    let extent = Extent { width: 16, height: 4 };
    refused(kernel.record_rectangles(&mut job, (extent, 1), table, (3, rectangles), sums), "3 rectangles");
    for channels in [0, 9] {
        refused(kernel.record(&mut job, (extent, channels), image, table), &format!("{channels} channels"));
    }
    refused(kernel.record(&mut job, (extent, 2), image, table), "64 words of image");
    let large = Extent { width: 4096, height: 4096 };
    refused(kernel.record_wide(&mut job, (large, 3), image, [table, table]), "3 channels of 4096");
    let half = job.zeroed::<u32>("high table", 32);
    refused(kernel.record_wide(&mut job, (extent, 1), image, [table, half]), "32 words of high table");
    let (two, pairs) = (job.zeroed("rectangles", 2), job.zeroed("sums", 3));
    let tables = [job.zeroed("low", 128), job.zeroed("high", 128)];
    refused(kernel.record_rectangles_wide(&mut job, (extent, 2), tables, (2, two), pairs), "3 sums of 2 channels");
    assert!(job.recordings.is_empty(), "a refusal records nothing");
}

#[test]
fn pyramids_of_large_images_or_short_buffers() {
    let kernel = MipPyramid::new().expect("it compiles");
    let mut job = Job::new();
    let image = job.zeroed::<u32>("image", 63);
    for (width, height, channels) in [(0, 4, 1), (4, 4097, 1), (4, 4, 9), (4, 4, 0), (4096, 4096, 3), (8, 8, 1)] {
        let extent = mip_pyramid::Extent { width, height, channels };
        refused(kernel.record(&mut job, extent, image).map(drop), &format!("{width} by {height}"));
    }
    assert!(job.recordings.is_empty(), "a refusal records nothing");
    let extent = mip_pyramid::Extent { width: 9, height: 7, channels: 1 };
    let pyramid = kernel.record(&mut job, extent, image).expect("it is small");
    let (two, sums) = (job.zeroed("rectangles", 2), job.zeroed("sums", 3));
    refused(kernel.record_rectangles(&mut job, &pyramid, (3, two), sums), "3 rectangles from 2");
    let (two, sums) = (job.zeroed("rectangles", 2), job.zeroed("sums", 1));
    refused(kernel.record_rectangles(&mut job, &pyramid, (2, two), sums), "into 1 sums");
}

#[test]
fn histograms_whose_buffers_are_short() {
    let kernel = ItemHistogram::new().expect("it compiles");
    let mut job = Job::new();
    let words = job.zeroed::<u32>("words", 16);
    refused(kernel.record_counts(&mut job, Order::Memory, (17, words), (1, words)), "17");
    refused(kernel.record_counts(&mut job, Order::Memory, (16, words), (17, words)), "17");
    for (width, height, depth) in [(0, 4, 1), (4, 65_536, 1), (4, 4, 9), (4, 5, 1)] {
        let tiling = Tiling { width, height, depth };
        let pixels = (width * height).to_string();
        let number = if pixels == "20" { pixels } else { depth.to_string() };
        refused(kernel.record_labels(&mut job, tiling, (words, 16), words, words), &number);
    }
    let tiling = Tiling { width: 4, height: 4, depth: 1 };
    refused(kernel.record_labels(&mut job, tiling, (words, 32), words, words), "32 bits");
    refused(kernel.record_mips(&mut job, 2, 2, words).map(drop), "16 bins");
    refused(kernel.record_mips(&mut job, 9, 1, words).map(drop), "depth 9");
    assert!(job.recordings.is_empty(), "a refusal records nothing");
}

#[test]
fn pictures_and_meshes_past_the_bit_budget_of_the_raster() {
    let kernel = Raster::new().expect("it compiles");
    let mut job = Job::new();
    let pixels = job.zeroed::<u32>("pixels", 64);
    for (width, height) in [(0, 4), (4, 0), (4097, 1), (1, 4097), (13, 5)] {
        refused(kernel.record_clear(&mut job, Picture { width, height }, pixels), &format!("{width} by {height}"));
    }
    let picture = Picture { width: 8, height: 8 };
    let mesh = Mesh {
        vertices: job.zeroed("vertices", 9),
        vertex_count: 3,
        indices: job.zeroed("indices", 3),
        triangle_count: 1,
        rows: job.zeroed("rows", 4),
        instance_count: 1,
    };
    for near in [0, 7, raster::CLIP + 1, -8] {
        refused(kernel.project(&mut job, View { picture, near }, mesh).map(drop), &near.to_string());
    }
    let view = View { picture, near: 8 };
    for (short, number) in [
        (Mesh { vertex_count: 4, ..mesh }, "9 coordinates"),
        (Mesh { triangle_count: 2, ..mesh }, "3 indices"),
        (Mesh { instance_count: 2, ..mesh }, "4 rows"),
        (Mesh { instance_count: 1 << 22, ..mesh }, "4194304 instances"),
        (Mesh { instance_count: 1 << 31, ..mesh }, "2147483648 instances"),
    ] {
        refused(kernel.project(&mut job, view, short).map(drop), number);
    }
    assert!(job.recordings.is_empty(), "a refusal records nothing");
    let projected = kernel.project(&mut job, view, mesh).expect("it is small");
    let short = job.zeroed("pixels", 63);
    refused(kernel.record_depth(&mut job, &projected, Faces::All, short), "63 words");
    let ids = Ids { base: 0, step: 1, shift: 32 };
    refused(kernel.record_items(&mut job, &projected, Faces::All, ids, [pixels, pixels]), "2^32");
    let none = job.zeroed("seen", 0);
    refused(kernel.record_points(&mut job, &projected, 0, pixels, none), "3 points");
}

#[test]
fn placements_that_rows_cannot_hold() {
    for (place, entry) in [(0, 16_384.0), (3, 536_870_912.0), (1, f64::NAN), (2, f64::NEG_INFINITY)] {
        let mut matrix = [[0.0; 4]; 4];
        matrix[1][place] = entry;
        refused(Placement::new(matrix).map(drop), &entry.to_string());
    }
    let placement = Placement::new([[0.5, -1.0 / 65_536.0, 16_383.99, 7.5]; 4]).expect("within the bounds");
    assert_eq!(placement.rows[2].to_array(), [32_768, -1, 1_073_741_169, 8]);
}

#[test]
fn region_sets_of_too_many_objects_channels_or_regions() {
    let kernel = RegionSets::new().expect("it compiles");
    let mut job = Job::new();
    let (rectangles, outlines) = (job.zeroed("rectangles", 2), job.zeroed("outlines", 16));
    let shape = region_sets::Shape { objects: 2, channels: 4, limit: 64, met: 100, width: 64, height: 64 };
    for (refusal, number) in [
        (region_sets::Shape { objects: 2001, ..shape }, "2001 objects"),
        (region_sets::Shape { channels: 9, ..shape }, "9 channels"),
        (region_sets::Shape { channels: 0, ..shape }, "0 channels"),
        (region_sets::Shape { limit: 65, ..shape }, "65 regions"),
        (region_sets::Shape { met: 18_001, ..shape }, "18001 regions of others"),
        (region_sets::Shape { width: 4097, ..shape }, "4097 columns"),
        (region_sets::Shape { height: 0, ..shape }, "0 rows"),
        (region_sets::Shape { objects: 3, ..shape }, "2 rectangles"),
    ] {
        refused(kernel.record(&mut job, refusal, rectangles, outlines).map(drop), number);
    }
    assert!(job.recordings.is_empty(), "a refusal records nothing");
    let regions = kernel.record(&mut job, shape, rectangles, outlines).expect("it is small");
    let (short, words, queries) = (job.zeroed("short", 4095), job.zeroed("words", 4096), job.zeroed("queries", 1));
    refused(kernel.record_paint(&mut job, &regions, 0..1, short, words), "4095 items");
    refused(kernel.record_paint(&mut job, &regions, 1..3, words, words), "4096 pixels of 2 channels");
    refused(kernel.record_paint_weights(&mut job, &regions, 3..5, [words, words], words), "channels 3 to 5 of 4");
    refused(kernel.record_paint_weights(&mut job, &regions, 0..1, [words, short], words), "4095 items");
    refused(kernel.record_count(&mut job, &regions, 2..2, [words, words], queries), "channels 2 to 2");
    refused(kernel.record_count(&mut job, &regions, 0..1, [words, words], queries), "1 queries");
}

#[test]
fn masks_of_several_lengths_and_short_tables() {
    let kernel = OpMap::new().expect("it compiles");
    let mut job = Job::new();
    let [two, three] = [2, 3].map(|operands| kernel.table(&mut job, Truth::AND, operands));
    let [a, b, combined] = ["a", "b", "combined"].map(|name| job.zeroed(name, 40));
    let longer = job.zeroed("other", 41);
    refused(kernel.record(&mut job, three, &[a, longer, b], combined), "41");
    refused(kernel.record(&mut job, three, &[a, a, b], longer), "41");
    refused(kernel.record(&mut job, two, &[a, a, b], combined), "16384");
    refused(kernel.record(&mut job, three, &[a, b], combined), "4194304");
    refused(kernel.record(&mut job, two, &[a], combined), "40");
    kernel.record(&mut job, three, &[a, a, b], combined).expect("one mask may be taken twice");
    kernel.record(&mut job, two, &[a, b], combined).expect("two masks");
}

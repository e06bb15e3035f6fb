//! Work that a kernel cannot do is refused when it is recorded, with the numbers and a remedy.

use sightlines_backend::{ErrorKind, Job, Result};
use sightlines_kernels::item_histogram::{ItemHistogram, Order, Tiling};
use sightlines_kernels::popcount::{Method, Popcount, Shape};
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
        refused(kernel.record(&mut job, Extent { width, height }, image, table), &height.to_string());
    }
    let (rectangles, sums) = (job.zeroed("rectangles", 2), job.zeroed("sums", 3));
    let extent = Extent { width: 16, height: 4 };
    refused(kernel.record_rectangles(&mut job, extent, table, 3, rectangles, sums), "3 rectangles");
    assert!(job.recordings.is_empty(), "a refusal records nothing");
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
        refused(kernel.record_labels(&mut job, tiling, words, words, words), &number);
    }
    refused(kernel.record_mips(&mut job, 2, 2, words).map(drop), "16 bins");
    refused(kernel.record_mips(&mut job, 9, 1, words).map(drop), "depth 9");
    assert!(job.recordings.is_empty(), "a refusal records nothing");
}

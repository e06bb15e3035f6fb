//! From no row to 4096² pixels: every edge of a four, a group of lanes and a band of rows, one to eight channels, and
//! sums of more than 32 bits.
//!
//! A case sums its channels and answers rectangles in all of them. Images, tables and sums are followed by words that
//! must be ignored or kept.

use glam::{UVec2, UVec4};
use sightlines_backend::host::Buffer;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{Extent, Sat, oracle};
use crate::{pieces, random, screen};

/// Words past the end of buffers, and what they hold.
const SLACK: usize = 4;
const MARK: u32 = 0x5eed_5eed;

/// Images of a case, one a channel, and its rectangles.
#[derive(Clone, Copy)]
struct Input {
    extent: Extent,
    channels: fn(Extent) -> Vec<Vec<u32>>,
    rectangles: fn(Extent) -> Vec<UVec4>,
}

pub(super) fn all() -> Vec<Case> {
    let small = |name, width, height, channels, rectangles, probes: &[u32]| {
        case(name, (Size::Small, false), Input { extent: Extent { width, height }, channels, rectangles }, probes)
    };
    let wide = |name, width, height, channels, rectangles, probes: &[u32]| {
        case(name, (Size::Small, true), Input { extent: Extent { width, height }, channels, rectangles }, probes)
    };
    let real = |name, side, channels, probes: &[u32]| case(name, (Size::Real, false), square(side, channels), probes);
    vec![
        small("nothing", 4, 0, ones, |_| Vec::new(), &[0]),
        small("one_four", 4, 1, noise, spread, &[0, 3]),
        small("one_row", 4096, 1, noise, spread, &[0, 1023, 1024, 4095]),
        small("one_column_of_fours", 4, 300, noise, spread, &[0, 63, 64, 1199]),
        small("one_band", 64, 16, noise, spread, &[0, 1023]),
        small("one_past_band", 64, 17, noise, spread, &[0, 1023, 1024, 1087]),
        small("one_past_lanes", 1028, 33, noise, spread, &[1023, 1024, 1027, 33_923]),
        small("all_ones", 100, 100, ones, spread, &[0, 99, 9900, 9999]),
        small("largest_exact", 256, 256, largest, spread, &[0, 255, 65_280, 65_535]),
        small("wraps", 516, 40, full_range, spread, &[0, 515, 20_639]),
        small("edge_rectangles", 40, 24, noise, edges, &[0, 1, 2, 3, 4, 5, 6, 7]),
        small("four_channels", 64, 48, |e| colours(e, 4), spread, &[0, 63, 3071, 3072, 12_287]),
        small("eight_channels", 36, 35, |e| colours(e, 8), spread, &[0, 1259, 1260, 10_079]),
        wide("wide_nothing", 4, 0, ones, |_| Vec::new(), &[0]),
        wide("wide_full_range", 516, 40, full_range, spread, &[0, 515, 20_639]),
        wide("wide_largest", 1028, 33, |e| one(e, |_| u32::MAX), spread, &[0, 1, 1024, 33_923]),
        wide("wide_edge_rectangles", 40, 24, full_range, edges, &[0, 39, 959]),
        wide("wide_channels", 64, 17, |e| [full_range(e), noise(e), ones(e)].concat(), spread, &[0, 1087, 3263]),
        real("items_4096", 4096, |e| colours(e, 1), &[0, 4095, 8_390_655, 16_777_215]),
        real("colours_1024", 1024, |e| colours(e, 4), &[0, 1023, 524_799, 1_048_575, 4_194_303]),
        case("wide_1024", (Size::Real, true), square(1024, full_range), &[0, 1023, 524_799, 1_048_575]),
    ]
}

fn square(side: u32, channels: fn(Extent) -> Vec<Vec<u32>>) -> Input {
    Input { extent: Extent { width: side, height: side }, channels, rectangles: spread }
}

fn one(extent: Extent, value: impl FnMut(u32) -> u32) -> Vec<Vec<u32>> {
    vec![(0..extent.pixels() as u32).map(value).collect()]
}

fn ones(extent: Extent) -> Vec<Vec<u32>> {
    one(extent, |_| 1)
}

fn noise(extent: Extent) -> Vec<Vec<u32>> {
    one(extent, |i| random::word(1, i) >> 24)
}

fn full_range(extent: Extent) -> Vec<Vec<u32>> {
    one(extent, |i| random::word(2, i))
}

fn largest(extent: Extent) -> Vec<Vec<u32>> {
    one(extent, |_| extent.largest_exact())
}

/// Objects in pure colours, as the paper draws them: object i is 1 in one channel and 0 in the others.
fn colours(extent: Extent, channels: u32) -> Vec<Vec<u32>> {
    let pixels = screen::discs(extent.width, extent.height, 500, 3);
    let shows = |pixel: u32, channel: u32| u32::from(pixel != screen::BACKGROUND && pixel % channels.max(4) == channel);
    (0..channels).map(|channel| pixels.iter().map(|&pixel| shows(pixel, channel)).collect()).collect()
}

/// Rectangles of all sizes, all over the image.
fn spread(extent: Extent) -> Vec<UVec4> {
    let edge = |bound: u32, k: u32| random::below(bound + 1, 4, k);
    let rectangle = |i: u32| {
        let [a, b] = [0, 1].map(|k| edge(extent.width, 4 * i + k));
        let [c, d] = [2, 3].map(|k| edge(extent.height, 4 * i + k));
        UVec4::new(a.min(b), c.min(d), a.max(b), c.max(d))
    };
    (0..300).map(rectangle).collect()
}

/// Whole, empty, single-pixel, inverted and outlying rectangles.
fn edges(extent: Extent) -> Vec<UVec4> {
    let (w, h) = (extent.width, extent.height);
    let rectangles = [
        [0, 0, w, h],
        [0, 0, 0, 0],
        [w - 1, h - 1, w, h],
        [5, 5, 5, 20],
        [7, 9, 3, 2],
        [0, 0, u32::MAX, u32::MAX],
        [w, h, w + 9, h + 9],
        [3, 0, 4, h],
    ];
    rectangles.map(UVec4::from).to_vec()
}

fn case(name: &str, (size, wide): (Size, bool), input: Input, probes: &[u32]) -> Case {
    let expected = move |_: &_| if wide { wide_answer(input) } else { answer(input) };
    let job = move || if wide { wide_job(input) } else { job(input) };
    Case::new(name, size, job, expected).probes(probes.iter().copied())
}

/// A result and the marks behind it.
fn marked(mut words: Vec<u32>) -> Expected {
    words.extend([MARK; SLACK]);
    Expected::Whole(words)
}

fn answer(input: Input) -> Vec<Expected> {
    let (extent, rectangles) = (input.extent, (input.rectangles)(input.extent));
    let images = (input.channels)(extent);
    let tables = images.iter().flat_map(|image| oracle::table(extent, image)).collect();
    let sums = images.iter().flat_map(|image| rectangles.iter().map(|r| oracle::rectangle(extent, image, *r)));
    vec![marked(tables), marked(sums.collect())]
}

fn wide_answer(input: Input) -> Vec<Expected> {
    let (extent, rectangles) = (input.extent, (input.rectangles)(input.extent));
    let images = (input.channels)(extent);
    let tables: Vec<u64> = images.iter().flat_map(|image| oracle::wide_table(extent, image)).collect();
    let low = tables.iter().map(|&sum| sum as u32).collect();
    let high = tables.iter().map(|&sum| (sum >> 32) as u32).collect();
    let sums = images.iter().flat_map(|image| rectangles.iter().map(|r| oracle::wide_rectangle(extent, image, *r)));
    let sums = sums.flat_map(|sum| [sum as u32, (sum >> 32) as u32]).collect();
    vec![marked(low), marked(high), marked(sums)]
}

/// The images of a case, its rectangles, and how many there are of both.
struct Given {
    extent: (Extent, u32),
    images: Buffer<[u32]>,
    rectangles: (u32, Buffer<[UVec4]>),
}

impl Given {
    fn upload(job: &mut Job, input: Input) -> Given {
        let images = (input.channels)(input.extent);
        let mut rectangles = (input.rectangles)(input.extent);
        let count = rectangles.len() as u32;
        rectangles.push(UVec4::splat(MARK));
        let extent = (input.extent, images.len() as u32);
        let mut words = images.concat();
        words.extend([MARK; SLACK]);
        let images = job.slice("images", &words);
        Given { extent, images, rectangles: (count, job.slice("rectangles", &rectangles)) }
    }

    /// Marks where the tables will be.
    fn tables(&self, job: &mut Job, name: &str) -> Buffer<[u32]> {
        job.slice(name, &vec![MARK; self.images.len() as usize])
    }

    /// Marks where the sums will be, each of so many words.
    fn sums(&self, job: &mut Job, words: usize) -> Buffer<[u32]> {
        let count = self.rectangles.0 as usize * self.extent.1 as usize;
        job.slice("sums", &vec![MARK; words * count + SLACK])
    }
}

fn job(input: Input) -> Result<Job> {
    let kernel = Sat::new()?;
    let mut job = Job::new();
    let given = Given::upload(&mut job, input);
    let (tables, sums) = (given.tables(&mut job, "tables"), given.sums(&mut job, 1));
    pieces::cut(&mut job);
    kernel.record(&mut job, given.extent, given.images, tables)?;
    pieces::cut(&mut job);
    kernel.record_rectangles(&mut job, given.extent, tables, given.rectangles, sums)?;
    job.read("tables", tables.id());
    job.read("rectangles", sums.id());
    Ok(job)
}

fn wide_job(input: Input) -> Result<Job> {
    let kernel = Sat::new()?;
    let mut job = Job::new();
    let given = Given::upload(&mut job, input);
    let tables = ["low tables", "high tables"].map(|name| given.tables(&mut job, name));
    let sums = given.sums(&mut job, 2);
    let pairs = Buffer::<[UVec2]>::from_raw(sums.id(), 0, sums.size());
    pieces::cut(&mut job);
    kernel.record_wide(&mut job, given.extent, given.images, tables)?;
    pieces::cut(&mut job);
    kernel.record_rectangles_wide(&mut job, given.extent, tables, given.rectangles, pairs)?;
    job.read("low tables", tables[0].id());
    job.read("high tables", tables[1].id());
    job.read("rectangles", sums.id());
    Ok(job)
}

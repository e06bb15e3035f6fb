//! From no row to 4096² pixels: every edge of a four, a group of lanes and a band of rows, and one to four channels.
//!
//! A case sums its channels and answers rectangles from the first table. Images and tables of small cases are followed by
//! words that must be ignored or kept.

use glam::UVec4;
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
        case(name, Size::Small, Input { extent: Extent { width, height }, channels, rectangles }, probes)
    };
    let real = |name, side, channels, probes: &[u32]| {
        let extent = Extent { width: side, height: side };
        case(name, Size::Real, Input { extent, channels, rectangles: spread }, probes)
    };
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
        small("four_channels", 64, 48, pure_colours, spread, &[0, 63, 3071]),
        real("items_4096", 4096, one_colour, &[0, 4095, 8_390_655, 16_777_215]),
        real("colours_1024", 1024, pure_colours, &[0, 1023, 524_799, 1_048_575]),
    ]
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

/// Objects in pure colours, as the paper draws them: object i is 1 in channel i mod 4 and 0 in the others.
fn colours(extent: Extent, channels: u32) -> Vec<Vec<u32>> {
    let pixels = screen::discs(extent.width, extent.height, 500, 3);
    let shows = |pixel: u32, channel: u32| u32::from(pixel != screen::BACKGROUND && pixel % 4 == channel);
    (0..channels).map(|channel| pixels.iter().map(|&pixel| shows(pixel, channel)).collect()).collect()
}

fn pure_colours(extent: Extent) -> Vec<Vec<u32>> {
    colours(extent, 4)
}

fn one_colour(extent: Extent) -> Vec<Vec<u32>> {
    colours(extent, 1)
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

fn case(name: &str, size: Size, input: Input, probes: &[u32]) -> Case {
    let expected = move |_: &_| {
        let extent = input.extent;
        let images = (input.channels)(extent);
        let mut expected: Vec<Expected> = images
            .iter()
            .map(|image| {
                let mut table = oracle::table(extent, image);
                table.extend([MARK; SLACK]);
                Expected::Whole(table)
            })
            .collect();
        let rectangles = (input.rectangles)(extent);
        let mut sums: Vec<u32> = rectangles.iter().map(|r| oracle::rectangle(extent, &images[0], *r)).collect();
        sums.extend([MARK; SLACK]);
        expected.push(Expected::Whole(sums));
        expected
    };
    Case::new(name, size, move || job(input), expected).probes(probes.iter().copied())
}

fn job(input: Input) -> Result<Job> {
    let extent = input.extent;
    let kernel = Sat::new()?;
    let mut job = Job::new();
    let mut first = None;
    for (channel, mut image) in (input.channels)(extent).into_iter().enumerate() {
        image.extend([MARK; SLACK]);
        let image = job.slice(format!("image {channel}"), &image);
        let table = job.slice(format!("table {channel}"), &vec![MARK; image.len() as usize]);
        pieces::cut(&mut job);
        kernel.record(&mut job, extent, image, table)?;
        pieces::cut(&mut job);
        job.read(format!("table.{channel}"), table.id());
        first.get_or_insert(table);
    }
    if let Some(table) = first {
        let mut rectangles = (input.rectangles)(extent);
        let count = rectangles.len() as u32;
        rectangles.push(UVec4::splat(MARK));
        let sums = job.slice("sums", &vec![MARK; count as usize + SLACK]);
        let rectangles = job.slice("rectangles", &rectangles);
        kernel.record_rectangles(&mut job, extent, table, count, rectangles, sums)?;
        job.read("rectangles", sums.id());
    }
    Ok(job)
}

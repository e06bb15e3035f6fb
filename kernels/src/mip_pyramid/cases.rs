//! From one pixel to 1024² in four channels: odd sides, single rows and columns, sums that wrap, rectangles of all
//! sizes and at all edges.
//!
//! A case makes the levels and answers rectangles in all channels; the answers are those of the definition of
//! [`crate::sat`]. Sums are followed by words that must be kept.

use glam::UVec4;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{Extent, MipPyramid, oracle};
use crate::sat::{self, oracle::rectangle};
use crate::{pieces, random, screen};

/// Words past the end of the sums, and what they hold.
const SLACK: usize = 4;
const MARK: u32 = 0x5eed_5eed;

pub(super) fn all() -> Vec<Case> {
    let small = |name, [width, height, channels]: [u32; 3], rectangles| {
        case(name, Size::Small, Extent { width, height, channels }, full_range, rectangles)
    };
    vec![
        small("one_pixel", [1, 1, 1], 20),
        small("nothing_asked", [4, 4, 1], 0),
        small("one_row", [77, 1, 1], 60),
        small("one_column", [1, 131, 2], 60),
        small("even", [64, 64, 1], 300),
        small("odd", [61, 37, 1], 300),
        small("one_past_power", [129, 65, 3], 200),
        small("eight_channels", [33, 20, 8], 100),
        case("colours", Size::Small, Extent { width: 96, height: 64, channels: 4 }, colours, 100),
        case("colours_1024", Size::Real, Extent { width: 1024, height: 1024, channels: 4 }, colours, 500),
    ]
}

fn full_range(extent: Extent) -> Vec<u32> {
    random::words(3, (extent.width * extent.height * extent.channels) as usize)
}

/// Objects in pure colours.
fn colours(extent: Extent) -> Vec<u32> {
    let pixels = screen::discs(extent.width, extent.height, 200, 3);
    let shows = |pixel: u32, channel: u32| u32::from(pixel != screen::BACKGROUND && pixel % extent.channels == channel);
    (0..extent.channels).flat_map(|channel| pixels.iter().map(move |&pixel| shows(pixel, channel))).collect()
}

/// The whole image and more, nothing, an inverted rectangle, the last pixel, then others of all sizes.
fn rectangles(extent: Extent, count: u32) -> Vec<UVec4> {
    let (w, h) = (extent.width, extent.height);
    let edges = [[0, 0, u32::MAX, u32::MAX], [0, 0, 0, h], [w, h, 0, 0], [w - 1, h - 1, w, h], [0, 0, w, h]];
    let edge = |bound: u32, k: u32| random::below(bound + 1, 4, k);
    let spread = |i: u32| {
        let [a, b] = [0, 1].map(|k| edge(w, 4 * i + k));
        let [c, d] = [2, 3].map(|k| edge(h, 4 * i + k));
        UVec4::new(a.min(b), c.min(d), a.max(b), c.max(d))
    };
    edges.map(UVec4::from).into_iter().chain((0..).map(spread)).take(count as usize).collect()
}

fn case(name: &str, size: Size, extent: Extent, image: fn(Extent) -> Vec<u32>, count: u32) -> Case {
    let Extent { width, height, .. } = extent;
    let expected = move |_: &_| {
        let image = image(extent);
        let planes: Vec<&[u32]> = image.chunks((width * height) as usize).collect();
        let levels = 1..=extent.levels().count() as u32;
        let level = |level: u32| planes.iter().flat_map(move |plane| oracle::level(plane, [width, height], level));
        let mut nodes: Vec<u32> = levels.flat_map(level).collect();
        nodes.resize(nodes.len().max(1), 0);
        let rectangles = rectangles(extent, count);
        let sum = |plane: &[u32], r: UVec4| rectangle(sat::Extent { width, height }, plane, r);
        let sums = planes.iter().flat_map(|plane| rectangles.iter().map(|&r| sum(plane, r)));
        let sums = sums.chain([MARK; SLACK]).collect();
        vec![Expected::Whole(nodes), Expected::Whole(sums)]
    };
    let probes = [0, extent.nodes() / 2, extent.nodes().max(1) - 1].map(|probe| probe as u32);
    let mut probes = probes.to_vec();
    probes.dedup();
    Case::new(name, size, move || job(extent, &image(extent), count), expected).probes(probes)
}

fn job(extent: Extent, image: &[u32], count: u32) -> Result<Job> {
    let kernel = MipPyramid::new()?;
    let mut job = Job::new();
    let image = job.slice("image", image);
    let mut asked = rectangles(extent, count);
    asked.push(UVec4::ZERO);
    let asked = job.slice("rectangles", &asked);
    let sums = job.slice("sums", &vec![MARK; (count * extent.channels) as usize + SLACK]);
    pieces::cut(&mut job);
    let pyramid = kernel.record(&mut job, extent, image)?;
    kernel.record_rectangles(&mut job, &pyramid, (count, asked), sums)?;
    job.read("nodes", pyramid.nodes().id());
    job.read("rectangles", sums.id());
    Ok(job)
}

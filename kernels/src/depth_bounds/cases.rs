//! From one pixel to 1024² with 2,000 boxes: odd sides, narrow pictures, boxes of a pixel and of the whole picture.
//!
//! A case makes every level of both forms, tests its boxes against both, and writes predicates of as many draws.

use glam::UVec4;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{Boxes, DepthBounds, Form, oracle};
use crate::random;
use crate::raster::{FAR, Picture};

/// Words past the end of what is written, and what they hold.
const SLACK: usize = 3;
const MARK: u32 = 0x5eed_5eed;

/// Draws whose objects are seen in no more pixels are not drawn.
const THRESHOLD: u32 = 5;

#[derive(Clone, Copy)]
struct Input {
    picture: Picture,
    boxes: u32,
}

pub(super) fn all() -> Vec<Case> {
    let of = |name, size, width, height, boxes| case(name, size, Input { picture: Picture { width, height }, boxes });
    vec![
        of("no_boxes", Size::Small, 8, 8, 0),
        of("one_pixel", Size::Small, 1, 1, 4),
        of("one_row", Size::Small, 301, 1, 40),
        of("one_column", Size::Small, 1, 70, 40),
        of("odd_sides", Size::Small, 61, 37, 257),
        of("powers_of_two", Size::Small, 64, 32, 300),
        of("one_past_power", Size::Small, 33, 65, 300),
        of("screen_1024", Size::Real, 1024, 1024, 2000),
    ]
}

impl Input {
    /// Slopes with steps, so that neither near nor far wins everywhere, and some background.
    fn depth(self) -> Vec<u32> {
        let Picture { width, height } = self.picture;
        let at = |i: u32| {
            let (x, y) = (i % width, i / width);
            let far = random::below(40, 1, (x >> 3) + 512 * (y >> 3)) == 0;
            if far { FAR } else { (x * 5000 + y * 3000) % 4_000_000 + (random::word(2, i) >> 20) }
        };
        (0..width * height).map(at).collect()
    }

    fn rectangles(self) -> Vec<[u32; 4]> {
        let Picture { width, height } = self.picture;
        let range = |side: u32, i: u32| {
            let low = random::below(side, 3, i);
            let most = if i % 8 < 2 { side } else { side.min(1 + side / 16) };
            (low, (low + 1 + random::below(most, 4, i)).min(side))
        };
        let rectangle = |i: u32| {
            let ((x0, x1), (y0, y1)) = (range(width, 2 * i), range(height, 2 * i + 1));
            if i == 0 { [0, 0, width, height] } else { [x0, y0, x1, y1] }
        };
        (0..self.boxes).map(rectangle).collect()
    }

    fn nearest(self) -> Vec<u32> {
        (0..self.boxes).map(|i| random::below(5_000_000, 5, i)).collect()
    }

    fn draws(self) -> Vec<UVec4> {
        let draw = |i: u32| UVec4::new(1 + i % 7, 1 + i % 3, 1, random::below(self.boxes, 6, i));
        (0..self.boxes).map(draw).collect()
    }

    fn counts(self) -> Vec<u32> {
        (0..self.boxes).map(|i| random::below(12, 7, i)).collect()
    }

    fn hidden(self, regions: impl Fn([u32; 4]) -> Vec<[u32; 4]>) -> Expected {
        let depth = self.depth();
        let far = |r: [u32; 4]| regions(r).into_iter().map(|r| oracle::greatest(self.picture, &depth, r)).max();
        let answers = self.rectangles().into_iter().zip(self.nearest()).map(|(r, near)| u32::from(Some(near) > far(r)));
        marked(answers.collect())
    }

    fn levels(self) -> u32 {
        let longest = self.picture.width.max(self.picture.height);
        (0..).find(|level| 1 << level >= longest).unwrap_or(0)
    }
}

/// Words, and the marks behind them that must stay.
fn marked(words: Vec<u32>) -> Expected {
    Expected::Whole([words, vec![MARK; SLACK]].concat())
}

fn case(name: &str, size: Size, input: Input) -> Case {
    let expected = move |_: &_| {
        let depth = input.depth();
        let mut all = Vec::new();
        all.extend(
            (1..=input.levels()).map(|level| oracle::pyramid(input.picture, &depth, level)).map(Expected::Whole),
        );
        all.push(input.hidden(|r| vec![oracle::pyramid_region(r)]));
        // Squares of large pictures are many pixels each: levels of them are checked where they are small.
        all.extend((1..=input.levels()).map(|level| match size {
            Size::Small => Expected::Whole(oracle::buffers(input.picture, &depth, level)),
            Size::Real => sampled(input.picture, &depth, level),
        }));
        all.push(input.hidden(oracle::buffer_regions));
        let counts = input.counts();
        let argument = |draw: UVec4| {
            let [x, y, z, object] = draw.to_array();
            if counts[object as usize] > THRESHOLD { [x, y, z] } else { [0; 3] }
        };
        all.push(marked(input.draws().into_iter().flat_map(argument).collect()));
        all
    };
    Case::new(name, size, move || job(input), expected).probes([0])
}

/// Squares that begin at every 16,411th pixel.
fn sampled(picture: Picture, depth: &[u32], level: u32) -> Expected {
    let side = 1 << level;
    let square = |at: u32| {
        let (x, y) = (at % picture.width, at / picture.width);
        (at, oracle::greatest(picture, depth, [x, y, x + side, y + side]))
    };
    Expected::Sample { words: (0..picture.pixels()).step_by(16_411).map(square).collect(), seed: 16_411 }
}

fn job(input: Input) -> Result<Job> {
    let kernel = DepthBounds::new()?;
    let mut job = Job::new();
    let depth = job.slice("depth", &input.depth());
    let rectangles: Vec<UVec4> = input.rectangles().into_iter().map(UVec4::from).collect();
    let rectangles = job.slice("rectangles", if rectangles.is_empty() { &[UVec4::ZERO] } else { &rectangles[..] });
    let nearest = job.slice("nearest", &[&input.nearest()[..], &[0]].concat());
    let boxes = Boxes { count: input.boxes, rectangles, nearest };
    for (form, name) in [(Form::Pyramid, "pyramid"), (Form::Buffers, "buffers")] {
        let levels = kernel.record_levels(&mut job, form, input.picture, depth)?;
        for (level, (_, words)) in levels.levels.iter().enumerate().skip(1) {
            job.read(format!("{name}.{level}"), words.id());
        }
        let hidden = job.slice("hidden", &vec![MARK; input.boxes as usize + SLACK]);
        kernel.record_tests(&mut job, &levels, boxes, hidden)?;
        job.read(format!("{name}.hidden"), hidden.id());
    }
    let draws = input.draws();
    let draws = job.slice("draws", if draws.is_empty() { &[UVec4::ZERO] } else { &draws[..] });
    let counts = job.slice("counts", &[&input.counts()[..], &[0]].concat());
    let arguments = job.slice("arguments", &vec![MARK; 3 * input.boxes as usize + SLACK]);
    kernel.record_predicates(&mut job, THRESHOLD, (input.boxes, draws), counts, arguments)?;
    job.read("arguments", arguments.id());
    Ok(job)
}

//! From no object to 2,000: figures of the paper, rectangles that nest and touch, discs on a screen, small limits.
//!
//! A case makes regions, paints all channels from an item buffer, sums the tables and counts, in the whole picture and
//! in a part of it for each object; and weights of the pixels, by two channels at a time. Objects are squares or the
//! discs of a screen, outlined by octagons.

use glam::UVec4;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::oracle::{self, Object};
use super::{MAX_MET, MAX_REGIONS, NONE, RegionSets, Shape};
use crate::sat::{Extent, Sat};
use crate::{pieces, random};

/// Objects of a case, and the object of every pixel.
type Screen = (Vec<Object>, Vec<u32>);

/// How a case's objects are made, for a picture of so many columns and rows.
type Make = fn(u32, u32) -> Screen;

pub(super) fn all() -> Vec<Case> {
    let small = |name, channels, limit, make: Make| case(name, Size::Small, [channels, limit, MAX_MET], [64, 48], make);
    vec![
        small("nothing", 4, 64, |w, h| squares(w, h, &[])),
        small("one", 4, 64, |w, h| squares(w, h, &[[3, 2, 40, 30]])),
        small("apart", 1, 64, |w, h| squares(w, h, &[[0, 0, 8, 8], [8, 0, 16, 8], [0, 8, 8, 16], [50, 40, 64, 48]])),
        small("empty_rectangles", 2, 64, |w, h| {
            squares(w, h, &[[5, 5, 5, 9], [0, 0, 9, 9], [7, 3, 2, 8], [4, 4, 9, 9]])
        }),
        small("figure_3", 2, 64, |w, h| {
            squares(w, h, &[[0, 4, 20, 30], [16, 4, 40, 30], [36, 4, 60, 30], [8, 8, 50, 26]])
        }),
        small("nested", 4, 64, nested),
        small("nested_one_channel", 1, 64, nested),
        small("equal", 4, 64, |w, h| squares(w, h, &[[10, 10, 30, 40]; 9])),
        small("corners_only", 1, 64, corners_only),
        small("discs_40", 4, 64, |w, h| discs(40, w, h, 1)),
        small("discs_40_two_channels", 2, 64, |w, h| discs(40, w, h, 1)),
        small("discs_40_eight_channels", 8, 64, |w, h| discs(40, w, h, 1)),
        small("limit_1", 2, 1, |w, h| discs(40, w, h, 2)),
        small("limit_6", 2, 6, |w, h| discs(40, w, h, 2)),
        small("one_past_word", 3, 16, |w, h| discs(33, w, h, 3)),
        small("one_past_group", 8, 8, |w, h| discs(257, w, h, 4)),
        case("met_by_none", Size::Small, [2, 64, 0], [64, 48], |w, h| discs(40, w, h, 2)),
        case("met_by_5", Size::Small, [2, 64, 5], [64, 48], |w, h| discs(40, w, h, 2)),
        case("met_by_1999", Size::Real, [1, 64, MAX_MET], [136, 135], met_by_many),
        case("met_18000", Size::Real, [1, 64, MAX_MET], [136, 96], met_by_most),
        case("discs_300", Size::Real, [4, 32, MAX_MET], [512, 512], |w, h| scattered(300, w, h, 5)),
        case("discs_1000_dense", Size::Real, [2, 64, MAX_MET], [768, 512], |w, h| discs(1000, w, h, 7)),
        case("discs_2000", Size::Real, [8, 64, MAX_MET], [1024, 1024], |w, h| scattered(2000, w, h, 6)),
    ]
}

fn bounds(rectangle: [u32; 4]) -> Object {
    let [x0, y0, x1, y1] = rectangle.map(|edge| edge as i32);
    Object { rectangle, outline: vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]] }
}

/// Every second pixel of rectangles, those of later ones in front.
fn squares(width: u32, height: u32, rectangles: &[[u32; 4]]) -> Screen {
    let mut items = vec![NONE; (width * height) as usize];
    for (object, [x0, y0, x1, y1]) in (0..).zip(rectangles) {
        for (x, y) in (*y0..*y1).flat_map(|y| (*x0..*x1).map(move |x| (x, y))) {
            if (x + y + object) % 2 == 0 {
                items[(y * width + x) as usize] = object;
            }
        }
    }
    (rectangles.iter().copied().map(bounds).collect(), items)
}

fn nested(width: u32, height: u32) -> Screen {
    let rectangles: Vec<[u32; 4]> = (0..12).map(|i| [2 * i, i, 60 - 2 * i, 44 - i]).collect();
    squares(width, height, &rectangles)
}

/// A rectangle that finds no channel among all others: the most regions that one object may be divided by.
fn met_by_many(width: u32, height: u32) -> Screen {
    let mut rectangles = vec![[0, 0, width, height]];
    rectangles.extend((0..1999).map(|i| (3 * (i % 45), 3 * (i / 45))).map(|(x, y)| [x, y, x + 2, y + 2]));
    squares(width, height, &rectangles)
}

/// The most regions that an object may meet, and the most neighbours. Stacks of 15 squares, a pixel each, are covered
/// three times over, and the whole picture twice: of those two rectangles the last finds the only channel, and the
/// other meets all else, 198 regions a stack: squares divide what covers them into 61 pieces, in which no channel is
/// free.
fn met_by_most(width: u32, height: u32) -> Screen {
    let mut rectangles = Vec::new();
    for stack in 0..110 {
        let (x, y) = (3 * (stack % 45), 31 * (stack / 45));
        rectangles.extend((0..15).map(|i| [x + 1, y + 2 * i + 1, x + 2, y + 2 * i + 2]));
        rectangles.extend([[x, y, x + 3, y + 31]; 3]);
    }
    rectangles.extend((0..18).map(|i| [i, 95, i + 1, 96]));
    rectangles.extend([[0, 0, width, height]; 2]);
    squares(width, height, &rectangles)
}

/// Thin diagonal outlines, whose rectangles overlap where one, the other or none of them is.
fn corners_only(width: u32, height: u32) -> Screen {
    let mut items = vec![NONE; (width * height) as usize];
    let mut objects = Vec::new();
    for object in 0..10_u32 {
        let (x, y) = (3 * object % 30, 2 * object % 20);
        let falls = object % 2 == 0;
        for step in 0..20 {
            let column = if falls { x + step } else { x + 19 - step };
            items[((y + step) * width + column) as usize] = object;
        }
        let [x0, y0, x1, y1] = [x, y, x + 20, y + 20].map(|edge| edge as i32);
        let outline = match falls {
            true => vec![[x0, y0], [x0 + 1, y0], [x1, y1 - 1], [x1, y1], [x1 - 1, y1], [x0, y0 + 1]],
            false => vec![[x1, y0], [x1, y0 + 1], [x0 + 1, y1], [x0, y1], [x0, y1 - 1], [x1 - 1, y0]],
        };
        objects.push(Object { rectangle: [x, y, x + 20, y + 20], outline });
    }
    (objects, items)
}

/// Discs that cover about twice the picture, later ones in front.
pub(super) fn discs(count: u32, width: u32, height: u32, seed: u32) -> Screen {
    let radius = (7 * width * height / (11 * count.max(1))).isqrt().max(1);
    discs_of(count, radius, [width, height], seed)
}

/// Discs of which one in two overlaps another.
fn scattered(count: u32, width: u32, height: u32, seed: u32) -> Screen {
    discs_of(count, (width * height / (12 * count)).isqrt(), [width, height], seed)
}

fn discs_of(count: u32, radius: u32, [width, height]: [u32; 2], seed: u32) -> Screen {
    let mut items = vec![NONE; (width * height) as usize];
    let mut objects = Vec::new();
    for object in 0..count {
        let cx = random::below(width, seed, 3 * object) as i32;
        let cy = random::below(height, seed, 3 * object + 1) as i32;
        let r = (radius / 2 + random::below(radius, seed, 3 * object + 2)) as i32;
        let cut = |low: i32, side: u32| low.clamp(0, side as i32) as u32;
        let rectangle = [cut(cx - r, width), cut(cy - r, height), cut(cx + r + 1, width), cut(cy + r + 1, height)];
        let [x0, y0, x1, y1] = rectangle;
        for (x, y) in (y0..y1).flat_map(|y| (x0..x1).map(move |x| (x, y))) {
            let (dx, dy) = (x as i32 - cx, y as i32 - cy);
            if dx * dx + dy * dy <= r * r {
                items[(y * width + x) as usize] = object;
            }
        }
        // An octagon around the disc and its pixels' far corners: 5/12 exceeds the tangent of an eighth of a turn by
        // half.
        let (far, near) = (r + 2, (r + 2) * 5 / 12 + 1);
        let ring = [(-near, -far), (near, -far), (far, -near), (far, near), (near, far), (-near, far), (-far, near)];
        let ring = ring.into_iter().chain([(-far, -near)]);
        objects.push(Object { rectangle, outline: ring.map(|(x, y)| [cx + x, cy + y]).collect() });
    }
    (objects, items)
}

fn case(name: &str, size: Size, [channels, limit, met]: [u32; 3], [width, height]: [u32; 2], make: Make) -> Case {
    let shape = move |objects: &[Object]| Shape { objects: objects.len() as u32, channels, limit, met, width, height };
    let expected = move |_: &_| {
        let (objects, items) = make(width, height);
        answer(&objects, &items, shape(&objects))
    };
    let job = move || {
        let (objects, items) = make(width, height);
        job(&objects, &items, shape(&objects))
    };
    let count = make(width, height).0.len().max(1) as u32;
    let mut probes = vec![0, count / 3, count - 1];
    probes.dedup();
    Case::new(name, size, job, expected).probes(probes)
}

/// For every object the whole picture and more, and a part of it.
fn queries(objects: usize, Shape { width, height, .. }: Shape) -> [Vec<[u32; 4]>; 2] {
    let edge = |side: u32, object: usize, k: u32| random::below(side + 1, 40, 4 * object as u32 + k);
    let part = |object| [edge(width, object, 0) / 2, edge(height, object, 1) / 2, edge(width, object, 2), height];
    [vec![[0, 0, u32::MAX, height]; objects], (0..objects).map(part).collect()]
}

/// Weights of the pixels.
fn weights(shape: Shape) -> Vec<u32> {
    (0..shape.width * shape.height).map(|pixel| random::below(256, 41, pixel)).collect()
}

/// What each buffer holds; an object that is not there has one place of zeros.
fn answer(objects: &[Object], items: &[u32], shape: Shape) -> Vec<Expected> {
    let (colours, regions) = oracle::regions(objects, shape);
    let painted = |weights: &[u32]| -> Vec<Vec<u32>> {
        (0..shape.channels).map(|c| oracle::paint(&regions, shape, c, items, weights)).collect()
    };
    let (images, weighted) = (painted(&vec![1; items.len()]), painted(&weights(shape)));
    let queries = queries(objects.len(), shape);
    let places = objects.len().max(1);
    let padded = |mut words: Vec<u32>, count: usize| {
        words.resize(count, 0);
        words
    };
    let slots = |words: &dyn Fn(&oracle::Region) -> Vec<u32>, each: usize| {
        let of = |regions: &Vec<oracle::Region>| padded(regions.iter().flat_map(words).collect(), each);
        padded(regions.iter().flat_map(of).collect(), places * each)
    };
    let most = MAX_REGIONS as usize;
    let outputs = [
        padded(oracle::channel_words(&colours), places),
        padded(regions.iter().map(|r| r.len() as u32).collect(), places),
        slots(&|r| r.rectangle.to_vec(), 4 * most),
        slots(&|r| vec![r.channel], most),
        padded(oracle::counts(&regions, shape, &images, &queries[0]), places),
        padded(oracle::counts(&regions, shape, &images, &queries[1]), places),
        padded(oracle::counts(&regions, shape, &weighted, &queries[0]), places),
    ];
    outputs.map(Expected::Whole).into()
}

fn job(objects: &[Object], items: &[u32], shape: Shape) -> Result<Job> {
    let (kernel, sat) = (RegionSets::new()?, Sat::new()?);
    let mut job = Job::new();
    let (mut rectangles, mut outlines) = oracle::words(objects);
    // A binding holds at least one element.
    rectangles.resize(rectangles.len().max(1), UVec4::ZERO);
    outlines.resize(outlines.len().max(1), glam::IVec2::ZERO);
    let (rectangles, outlines) = (job.slice("rectangles", &rectangles), job.slice("outlines", &outlines));
    let items = job.slice("items", items);
    let places = objects.len().max(1);
    let queries = queries(places, shape).map(|queries| {
        let queries: Vec<UVec4> = queries.into_iter().map(UVec4::from).collect();
        job.slice("queries", &queries)
    });
    let regions = kernel.record(&mut job, shape, rectangles, outlines)?;
    let sums = ["sums", "part_sums", "weight_sums"].map(|name| job.zeroed(name, places as u64));
    let extent = Extent { width: shape.width, height: shape.height };
    let planes = extent.pixels() * u64::from(shape.channels);
    let (images, tables) = (job.zeroed("images", planes), job.zeroed("tables", planes));
    pieces::cut(&mut job);
    kernel.record_paint(&mut job, &regions, 0..shape.channels, items, images)?;
    sat.record(&mut job, (extent, shape.channels), images, tables)?;
    for (sums, queries) in sums.into_iter().zip(queries) {
        kernel.record_count(&mut job, &regions, 0..shape.channels, [tables, sums], queries)?;
    }
    let weights = job.slice("weights", &weights(shape));
    for first in (0..shape.channels).step_by(2) {
        let some = first..(first + 2).min(shape.channels);
        pieces::cut(&mut job);
        kernel.record_paint_weights(&mut job, &regions, some.clone(), [items, weights], images)?;
        sat.record(&mut job, (extent, some.len() as u32), images, tables)?;
        kernel.record_count(&mut job, &regions, some, [tables, sums[2]], queries[0])?;
    }
    job.read("channels", regions.channel_of.id());
    job.read("counts", regions.counts.id());
    job.read("regions", regions.rectangles.id());
    job.read("region_channels", regions.channels.id());
    job.read("sums", sums[0].id());
    job.read("part_sums", sums[1].id());
    job.read("weight_sums", sums[2].id());
    Ok(job)
}

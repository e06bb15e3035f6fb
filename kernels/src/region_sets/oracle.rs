//! The paper's three steps, one object and one rectangle at a time, and pixels counted one by one.

use glam::{IVec2, UVec4};

use super::{NONE, Shape};

/// An object on the screen.
#[derive(Clone, Debug)]
pub struct Object {
    /// Bounding rectangle, half-open.
    pub rectangle: [u32; 4],
    /// Convex outline, turning as x to y.
    pub outline: Vec<[i32; 2]>,
}

/// A rectangle and its channel: one query of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Half-open.
    pub rectangle: [u32; 4],
    /// The channel.
    pub channel: u32,
}

/// What two rectangles have in common.
fn common(a: [u32; 4], b: [u32; 4]) -> Option<[u32; 4]> {
    let c = [a[0].max(b[0]), a[1].max(b[1]), a[2].min(b[2]), a[3].min(b[3])];
    (c[0] < c[2] && c[1] < c[3]).then_some(c)
}

/// Section 3.1.1: who is in conflict with whom.
pub fn conflicts(objects: &[Object]) -> Vec<Vec<usize>> {
    let of = |i: usize| {
        let meets = |j: &usize| *j != i && common(objects[i].rectangle, objects[*j].rectangle).is_some();
        (0..objects.len()).filter(meets).collect()
    };
    (0..objects.len()).map(of).collect()
}

/// Section 3.1.1: a channel for every object, `None` for conflict objects.
pub fn colours(conflicts: &[Vec<usize>], channels: u32) -> Vec<Option<u32>> {
    let mut present = vec![true; conflicts.len()];
    let mut stack = Vec::new();
    while stack.len() < conflicts.len() {
        let degree = |v: usize| conflicts[v].iter().filter(|w| present[**w]).count();
        let left = (0..conflicts.len()).filter(|&v| present[v]);
        let least = left.min_by_key(|&v| (degree(v), v)).unwrap_or(0);
        present[least] = false;
        stack.push(least);
    }
    let mut colours = vec![None; conflicts.len()];
    while let Some(v) = stack.pop() {
        colours[v] = (0..channels).find(|&c| conflicts[v].iter().all(|&w| colours[w] != Some(c)));
    }
    colours
}

/// Whether a convex outline reaches into a rectangle, or touches it: no edge and no side of the rectangle parts them.
fn meets(outline: &[[i32; 2]], rectangle: [u32; 4]) -> bool {
    let [x0, y0, x1, y1] = rectangle.map(i64::from);
    let points: Vec<[i64; 2]> = outline.iter().map(|p| p.map(i64::from)).collect();
    let parted_by_edge = (0..points.len()).any(|i| {
        let (a, b) = (points[i], points[(i + 1) % points.len()]);
        let outside = |[x, y]: [i64; 2]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) < 0;
        [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].into_iter().all(outside)
    });
    let parted_by_side = points.iter().all(|p| p[0] < x0)
        || points.iter().all(|p| p[0] > x1)
        || points.iter().all(|p| p[1] < y0)
        || points.iter().all(|p| p[1] > y1);
    !parted_by_edge && !parted_by_side
}

#[derive(Clone, Debug)]
struct Piece {
    rectangle: [u32; 4],
    occupied: Vec<bool>,
}

/// A piece cut by a region that takes its part `v`: above, left, the part, right, below.
fn cut(piece: &Piece, v: [u32; 4], part: Option<Piece>) -> Vec<Piece> {
    let [x0, y0, x1, y1] = piece.rectangle;
    let rest = |rectangle: [u32; 4]| {
        let exists = rectangle[0] < rectangle[2] && rectangle[1] < rectangle[3];
        exists.then(|| Piece { rectangle, occupied: piece.occupied.clone() })
    };
    let pieces = [
        rest([x0, y0, x1, v[1]]),
        rest([x0, v[1], v[0], v[3]]),
        part,
        rest([v[2], v[1], x1, v[3]]),
        rest([x0, v[3], x1, y1]),
    ];
    pieces.into_iter().flatten().collect()
}

/// Divides all pieces of an object by a region of another; `wholes` leaves alone those that are not wholly in it.
fn divide(pieces: &[Piece], object: &Object, other: &Object, region: Region, wholes: bool) -> Vec<Piece> {
    let channel = region.channel as usize;
    let divided = |piece: &Piece| {
        let free = !piece.occupied[channel];
        let Some(v) = common(piece.rectangle, region.rectangle).filter(|_| free) else { return vec![piece.clone()] };
        let (own, others) = (meets(&object.outline, v), meets(&other.outline, v));
        if !own && !others || wholes && v != piece.rectangle {
            return vec![piece.clone()];
        }
        let mut occupied = piece.occupied.clone();
        occupied[channel] = true;
        cut(piece, v, own.then_some(Piece { rectangle: v, occupied }))
    };
    pieces.iter().flat_map(divided).collect()
}

/// Merges pairs of pieces that make a rectangle and have a channel in common that is free, the first pair first.
fn merge(pieces: &mut Vec<Piece>) {
    let joined = |a: &Piece, b: &Piece| {
        let (r, s) = (a.rectangle, b.rectangle);
        let beside = r[1] == s[1] && r[3] == s[3] && (r[2] == s[0] || s[2] == r[0]);
        let above = r[0] == s[0] && r[2] == s[2] && (r[3] == s[1] || s[3] == r[1]);
        let occupied: Vec<bool> = a.occupied.iter().zip(&b.occupied).map(|(a, b)| a | b).collect();
        let rectangle = [r[0].min(s[0]), r[1].min(s[1]), r[2].max(s[2]), r[3].max(s[3])];
        ((beside || above) && occupied.contains(&false)).then_some(Piece { rectangle, occupied })
    };
    let pairs = |pieces: &[Piece]| {
        let mut pairs = (0..pieces.len()).flat_map(|i| (i + 1..pieces.len()).map(move |j| (i, j)));
        pairs.find_map(|(i, j)| joined(&pieces[i], &pieces[j]).map(|piece| (i, j, piece)))
    };
    while let Some((i, j, piece)) = pairs(pieces) {
        pieces[i] = piece;
        pieces.remove(j);
    }
}

/// Section 3.1.2: the regions of every object.
pub fn regions(objects: &[Object], shape: Shape) -> (Vec<Option<u32>>, Vec<Vec<Region>>) {
    let conflicts = conflicts(objects);
    let colours = colours(&conflicts, shape.channels);
    let whole = |(object, colour): (&Object, &Option<u32>)| {
        colour.map(|channel| Region { rectangle: object.rectangle, channel }).into_iter().collect()
    };
    let mut regions: Vec<Vec<Region>> = objects.iter().zip(&colours).map(whole).collect();
    for (i, object) in objects.iter().enumerate().filter(|(i, _)| colours[*i].is_none()) {
        let of = |j: &usize| regions[*j].iter().map(|r| (&objects[*j], *r)).collect::<Vec<(&Object, Region)>>();
        let reaches = |(other, region): &(&Object, Region)| {
            common(object.rectangle, region.rectangle)
                .is_some_and(|v| meets(&object.outline, v) || meets(&other.outline, v))
        };
        let known = conflicts[i].iter().flat_map(of).filter(reaches);
        let known: Vec<(&Object, Region)> = known.take(shape.met as usize).collect();
        let mut pieces = vec![Piece { rectangle: object.rectangle, occupied: vec![false; shape.channels as usize] }];
        for (other, region) in &known {
            let divided = divide(&pieces, object, other, *region, false);
            let fits = divided.len() <= shape.limit as usize;
            pieces = if fits { divided } else { divide(&pieces, object, other, *region, true) };
        }
        merge(&mut pieces);
        let chosen = |piece: &Piece| {
            let cost = |channel: u32| {
                let costs = known.iter().filter(|(_, r)| r.channel == channel).filter_map(|(other, region)| {
                    let v = common(piece.rectangle, region.rectangle)?;
                    let shared = meets(&object.outline, v) || meets(&other.outline, v);
                    shared.then(|| u64::from((v[2] - v[0]) * (v[3] - v[1])))
                });
                costs.sum::<u64>().min(u64::from(u32::MAX))
            };
            let channel = (0..shape.channels).min_by_key(|&c| (cost(c), c)).unwrap_or(0);
            Region { rectangle: piece.rectangle, channel }
        };
        regions[i] = pieces.iter().map(chosen).collect();
    }
    (colours, regions)
}

/// The image of a channel: the weight of a pixel whose region is of that channel, else 0.
pub fn paint(regions: &[Vec<Region>], shape: Shape, channel: u32, items: &[u32], weights: &[u32]) -> Vec<u32> {
    let at = |(place, (&item, &weight)): (usize, (&u32, &u32))| {
        let (x, y) = (place as u32 % shape.width, place as u32 / shape.width);
        let holds = |r: &Region| {
            let [x0, y0, x1, y1] = r.rectangle;
            r.channel == channel && (x0..x1).contains(&x) && (y0..y1).contains(&y)
        };
        if regions.get(item as usize).is_some_and(|regions| regions.iter().any(holds)) { weight } else { 0 }
    };
    items.iter().zip(weights).enumerate().map(at).collect()
}

/// Section 3.1.3: for every object the painted pixels of its regions' channels, cut to its query.
pub fn counts(regions: &[Vec<Region>], shape: Shape, images: &[Vec<u32>], queries: &[[u32; 4]]) -> Vec<u32> {
    let of = |(regions, query): (&Vec<Region>, &[u32; 4])| {
        let sum = |region: &Region| {
            let Some([x0, y0, x1, y1]) = common(region.rectangle, *query) else { return 0 };
            let x1 = x1.min(shape.width);
            let image = &images[region.channel as usize];
            let rows = (y0..y1.min(shape.height)).map(|y| (y * shape.width) as usize);
            rows.flat_map(|row| &image[row + x0.min(x1) as usize..row + x1 as usize]).sum::<u32>()
        };
        regions.iter().map(sum).sum()
    };
    regions.iter().zip(queries).map(of).collect()
}

/// Rectangles and corners as the kernel takes them; outlines of fewer than eight corners repeat the last.
pub fn words(objects: &[Object]) -> (Vec<UVec4>, Vec<IVec2>) {
    let corners = |object: &Object| {
        let last = object.outline.len() - 1;
        let outline = object.outline.clone();
        (0..8).map(move |i| IVec2::from(outline[last.min(i)]))
    };
    (objects.iter().map(|o| o.rectangle.into()).collect(), objects.iter().flat_map(corners).collect())
}

/// The words of every object's channel.
pub fn channel_words(colours: &[Option<u32>]) -> Vec<u32> {
    colours.iter().map(|colour| colour.unwrap_or(NONE)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::region_sets::MAX_MET;
    use crate::region_sets::cases::discs;

    fn object(rectangle: [u32; 4]) -> Object {
        let [x0, y0, x1, y1] = rectangle.map(|edge| edge as i32);
        Object { rectangle, outline: vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]] }
    }

    fn shape(objects: usize, channels: u32, limit: u32) -> Shape {
        Shape { objects: objects as u32, channels, limit, met: MAX_MET, width: 64, height: 64 }
    }

    #[test]
    fn a_ring_of_five_needs_three_channels() {
        let ring: Vec<Vec<usize>> = (0..5).map(|i| vec![(i + 4) % 5, (i + 1) % 5]).collect();
        let three = colours(&ring, 3);
        assert!((0..5).all(|i| three[i].is_some() && three[i] != three[(i + 1) % 5]));
        assert_eq!(colours(&ring, 2).iter().filter(|c| c.is_none()).count(), 1);
        assert_eq!(colours(&ring, 1).iter().filter(|c| c.is_some()).count(), 2);
    }

    #[test]
    fn a_conflict_object_takes_the_channels_that_its_neighbours_leave() {
        // Three in a row over a wide one, two channels: as figure 3, whose last step merges what one channel serves.
        let objects = [[0, 0, 8, 8], [4, 0, 16, 8], [12, 0, 20, 8], [2, 2, 18, 6]].map(object);
        let (colours, regions) = regions(&objects, shape(4, 2, 64));
        let divided: Vec<usize> = (0..4).filter(|&i| colours[i].is_none()).collect();
        assert_eq!(divided.len(), 1);
        let [x0, y0, x1, y1] = objects[divided[0]].rectangle;
        let area = |r: [u32; 4]| (r[2] - r[0]) * (r[3] - r[1]);
        assert_eq!(regions[divided[0]].iter().map(|r| area(r.rectangle)).sum::<u32>(), (x1 - x0) * (y1 - y0));
        assert!(regions[divided[0]].len() > 1);
    }

    #[test]
    fn where_only_the_other_is_its_part_is_dropped_and_where_none_is_nothing_happens() {
        let region = Region { rectangle: [0, 0, 8, 8], channel: 0 };
        let corner = |at: [i32; 2]| Object {
            rectangle: [0, 0, 8, 8],
            outline: vec![at, [at[0] + 1, at[1]], [at[0] + 1, at[1] + 1], [at[0], at[1] + 1]],
        };
        let piece = || vec![Piece { rectangle: [4, 4, 16, 16], occupied: vec![false; 2] }];
        let outline = |at: [i32; 2]| Object { rectangle: [4, 4, 16, 16], ..corner(at) };
        let rectangles = |pieces: Vec<Piece>| pieces.iter().map(|p| (p.rectangle, p.occupied[0])).collect::<Vec<_>>();
        let (far, here) = ([12, 12], [5, 5]);
        let rest = [([8, 4, 16, 8], false), ([4, 8, 16, 16], false)];
        assert_eq!(rectangles(divide(&piece(), &outline(far), &corner(here), region, false)), rest);
        assert_eq!(rectangles(divide(&piece(), &outline(far), &corner([1, 1]), region, false)).len(), 1);
        let kept = divide(&piece(), &outline(here), &corner([1, 1]), region, false);
        assert_eq!(rectangles(kept), [([4, 4, 8, 8], true), rest[0], rest[1]]);
    }

    #[test]
    fn no_count_is_less_than_what_is_visible_and_few_are_more() {
        for (count, channels, limit, met, spare) in [
            (9, 8, 64, MAX_MET, 0),
            (40, 4, 64, MAX_MET, 5),
            (120, 4, 64, MAX_MET, 30),
            (120, 2, 8, MAX_MET, 100),
            (60, 8, 1, MAX_MET, 100),
            (120, 4, 64, 9, 60),
        ] {
            let (objects, items) = discs(count, 128, 96, 5);
            let shape = Shape { met, width: 128, height: 96, ..shape(objects.len(), channels, limit) };
            let (_, regions) = regions(&objects, shape);
            let ones = vec![1; items.len()];
            let images: Vec<Vec<u32>> = (0..channels).map(|c| paint(&regions, shape, c, &items, &ones)).collect();
            let everywhere = vec![[0, 0, 128, 96]; objects.len()];
            let found = counts(&regions, shape, &images, &everywhere);
            let visible = |o: usize| items.iter().filter(|&&item| item == o as u32).count() as u32;
            assert!((0..objects.len()).all(|o| found[o] >= visible(o)), "{count} in {channels}");
            let more: u32 = (0..objects.len()).map(|o| found[o] - visible(o)).sum();
            let all = items.iter().filter(|&&item| item != NONE).count() as u32;
            assert!(more * 100 <= all * spare, "{count} in {channels}: {more} of {all} too many");
            let outside =
                |o: usize| regions[o].iter().any(|r| common(r.rectangle, objects[o].rectangle) != Some(r.rectangle));
            assert!(!(0..objects.len()).any(outside));
            assert!(regions.iter().all(|r| r.len() <= limit as usize));
        }
    }
}

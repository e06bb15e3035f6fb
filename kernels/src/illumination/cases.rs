//! Each step by itself on small inputs and edges; the whole way from a map to bytes at real size.

use glam::{IVec4, UVec4};
use rayon::prelude::*;
use sightlines_backend::host::Buffer;
use sightlines_backend::{Case, Expected, Job, Result, Size};

use super::{Fixed, Illumination, Shape, Surface, colour_shift, gamma_table, gaussian_taps, oracle, scaled_weights};
use crate::exact::oracle::angle::normalize3_q15;
use crate::light_sphere::{LightSphere, Rotation, oracle::octahedron, oracle::turned, weights};
use crate::random;

/// What stands behind the end of an output.
const MARK: u32 = 0x5eed_5eed;

pub(super) fn all() -> Vec<Case> {
    let sky = Shape::LatitudeLongitude { width: 31, height: 17 };
    vec![
        look_up("one_texel", Shape::LatitudeLongitude { width: 1, height: 1 }, lattice(2)),
        look_up("sky", sky, [lattice(3), any(400)].concat()),
        look_up("poles_and_seam", sky, edges()),
        look_up("cube", Shape::Cube { side: 12 }, [lattice(3), any(400)].concat()),
        look_up("cube_edges", Shape::Cube { side: 4 }, edges()),
        blur("blur_one", 1, 1, 1),
        blur("blur_around", 17, 5, 17),
        blur("blur_wide", 40, 24, 6),
        colours("no_light", 70, 0, |_| 0),
        colours("one_light", 70, 1, |_| 0),
        colours("a_word_and_one", 300, 33, |i| random::word(1, i)),
        colours("all_dark", 70, 64, |_| u32::MAX),
        colours("full_range", 257, 258, |i| random::word(2, i) & random::word(3, i)),
        in_blocks("in_blocks", 257, 258, &[96, 32, 64, 66]),
        encode("codes", 1000),
        whole(30_000, 5),
    ]
}

type Direction = [i32; 3];

fn lattice(level: u32) -> Vec<Direction> {
    octahedron(level).into_iter().map(|(d, _)| normalize3_q15(d)).collect()
}

fn any(count: u32) -> Vec<Direction> {
    (0..count).map(|i| [0, 1, 2].map(|axis| random::below(65_537, 7, 3 * i + axis) as i32 - 32_768)).collect()
}

/// Poles, the seam, edges and corners of the cube, and their neighbours.
fn edges() -> Vec<Direction> {
    let c = [-32_768, -32_767, -1, 0, 1, 32_767, 32_768];
    c.iter().flat_map(|&x| c.iter().flat_map(move |&y| c.map(|z| [x, y, z]))).collect()
}

fn texels(count: u32, seed: u32) -> Vec<[u32; 4]> {
    (0..count).map(|i| [0, 1, 2].map(|c| random::word(seed, 3 * i + c))).map(|[r, g, b]| [r, g, b, 0]).collect()
}

fn light_weights(count: usize) -> Vec<u32> {
    (0..count as u32).map(|i| [u32::MAX, 0, 1, 1 << 31, random::word(9, i)][i.min(4) as usize]).collect()
}

fn upload4(job: &mut Job, name: &str, values: &[[u32; 4]]) -> Buffer<[UVec4]> {
    let values: Vec<UVec4> = values.iter().copied().map(UVec4::from_array).collect();
    job.slice(name, if values.is_empty() { &[UVec4::ZERO] } else { &values[..] })
}

fn upload_directions(job: &mut Job, directions: &[Direction]) -> Buffer<[IVec4]> {
    let values: Vec<IVec4> = directions.iter().map(|&[x, y, z]| IVec4::new(x, y, z, 0)).collect();
    job.slice("directions", if values.is_empty() { &[IVec4::ZERO] } else { &values[..] })
}

fn fours(values: impl IntoIterator<Item = [u32; 4]>) -> Vec<u32> {
    values.into_iter().flatten().chain([0; 4]).collect()
}

fn look_up(name: &str, shape: Shape, directions: Vec<Direction>) -> Case {
    let map = move || texels(shape.texels().unwrap_or(0), 11);
    let lights = directions.clone();
    let job = move || {
        let mut job = Job::new();
        let texels = upload4(&mut job, "texels", &map());
        let given = upload_directions(&mut job, &lights);
        let weights = job.slice("weights", &light_weights(lights.len()));
        let looked_up = job.zeroed("looked up", lights.len() as u64 + 1);
        let kernel = Illumination::new()?;
        kernel.record_look_up(&mut job, (shape, texels), lights.len() as u32, given, weights, looked_up)?;
        job.read("looked_up", looked_up.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let map = map();
        let intensities = directions.iter().zip(light_weights(directions.len())).map(|(&d, weight)| {
            let texel = map[oracle::texel_of(shape, d) as usize];
            texel.map(|value| ((u64::from(value) * u64::from(weight)) >> 32) as u32)
        });
        vec![Expected::Whole(fours(intensities))]
    };
    Case::new(name, Size::Small, job, expected).probes([0, 1, 2, 12])
}

fn blur(name: &str, width: u32, height: u32, radius: u32) -> Case {
    let taps = move || gaussian_taps(f64::from(radius) / 2.0, radius).expect("in range");
    let job = move || {
        let mut job = Job::new();
        let given = upload4(&mut job, "texels", &texels(width * height, 12));
        let taps = job.slice("taps", &taps());
        let rows = job.zeroed("blurred along rows", given.len() + 1);
        let both = job.zeroed("blurred", given.len() + 1);
        let kernel = Illumination::new()?;
        kernel.record_blur(&mut job, (width, height), taps, false, given, rows)?;
        kernel.record_blur(&mut job, (width, height), taps, true, rows, both)?;
        job.read("rows", rows.id());
        job.read("both", both.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let rows = oracle::blurred(width, &texels(width * height, 12), &taps(), false);
        let both = oracle::blurred(width, &rows, &taps(), true);
        vec![Expected::Whole(fours(rows)), Expected::Whole(fours(both))]
    };
    Case::new(name, Size::Small, job, expected).probes([0, 1, 2, 3])
}

/// Normals of length up to 2^15, some along an axis.
fn normals(count: u32) -> Vec<Direction> {
    let all = edges().into_iter().chain(any(count)).filter(|d| *d != [0; 3]);
    all.take(count as usize).map(normalize3_q15).collect()
}

/// Positions: two vertices out of three share theirs with another one.
fn position_of(vertices: u32) -> Vec<u32> {
    (0..vertices).map(|v| v * 2 / 3).collect()
}

fn planes<T: Copy>(values: &[[T; 3]]) -> Vec<T> {
    (0..3).flat_map(|axis| values.iter().map(move |v| v[axis])).collect()
}

fn surface(job: &mut Job, vertices: u32, lights: u32, hidden: fn(u32) -> u32) -> Surface {
    let positions = vertices * 2 / 3 + 1;
    let words = positions * lights.div_ceil(32).max(1);
    Surface {
        normals: job.slice("normals", &planes(&normals(vertices))),
        position_of: job.slice("positions", &position_of(vertices)),
        positions,
        occluded: job.slice("occluded", &(0..words).map(hidden).collect::<Vec<u32>>()),
    }
}

fn entries(vertex: u32, lights: &[Direction], positions: u32, hidden: fn(u32) -> u32) -> Vec<u32> {
    let normal = normals(vertex + 1)[vertex as usize];
    entries_of(normal, vertex * 2 / 3, lights, positions, hidden)
}

fn entries_of(
    normal: Direction,
    position: u32,
    lights: &[Direction],
    positions: u32,
    hidden: fn(u32) -> u32,
) -> Vec<u32> {
    let is_hidden = |j: u32| hidden(j / 32 * positions + position) >> (j % 32) & 1 == 1;
    (0..).zip(lights).map(|(j, &light)| oracle::entry(normal, light, is_hidden(j))).collect()
}

fn colours(name: &str, vertices: u32, lights: u32, hidden: fn(u32) -> u32) -> Case {
    const SHIFT: [i32; 3] = [20, 47, -3];
    let units = move || lattice(3).into_iter().take(lights as usize).collect::<Vec<_>>();
    let job = move || {
        let mut job = Job::new();
        let surface = surface(&mut job, vertices, lights, hidden);
        let units = upload_directions(&mut job, &units());
        let intensities = upload4(&mut job, "intensities", &texels(lights, 13));
        let colours = job.slice("colours", &vec![MARK; 3 * vertices as usize + 1]);
        let kernel = Illumination::new()?;
        kernel.record_illuminate(&mut job, &surface, (lights, units, intensities), SHIFT, colours)?;
        job.read("colours", colours.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let (units, intensities) = (units(), texels(lights, 13));
        let colour = |v: u32| oracle::colour(&entries(v, &units, vertices * 2 / 3 + 1, hidden), &intensities, SHIFT);
        let colours: Vec<[u32; 3]> = (0..vertices).map(colour).collect();
        vec![Expected::Whole(planes(&colours).into_iter().chain([MARK]).collect())]
    };
    Case::new(name, Size::Small, job, expected).probes([0, 1, vertices, 2 * vertices])
}

/// Lights in blocks of their own bits, whose sums are carried from one to the next.
fn in_blocks(name: &str, vertices: u32, lights: u32, blocks: &'static [u32]) -> Case {
    const SHIFT: [i32; 3] = [40, 11, -7];
    let hidden = |i: u32| random::word(4, i);
    let units = move || lattice(3).into_iter().take(lights as usize).collect::<Vec<_>>();
    let job = move || {
        let mut job = Job::new();
        let whole = surface(&mut job, vertices, lights, hidden);
        let sums = job.zeroed("sums", 6 * u64::from(vertices));
        let kernel = Illumination::new()?;
        let mut first = 0;
        for &count in blocks {
            let range = first as usize..(first + count) as usize;
            let words = first / 32 * whole.positions..(first + count).div_ceil(32) * whole.positions;
            let occluded = job.slice("occluded", &words.map(hidden).collect::<Vec<u32>>());
            let units = upload_directions(&mut job, &units()[range.clone()]);
            let intensities = upload4(&mut job, "intensities", &texels(lights, 13)[range]);
            kernel.record_block(&mut job, &Surface { occluded, ..whole }, (count, units, intensities), sums)?;
            first += count;
        }
        let colours = job.slice("colours", &vec![MARK; 3 * vertices as usize + 1]);
        kernel.record_resolve(&mut job, vertices, sums, SHIFT, colours)?;
        job.read("colours", colours.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let (units, intensities) = (units(), texels(lights, 13));
        let colour = |v: u32| oracle::colour(&entries(v, &units, vertices * 2 / 3 + 1, hidden), &intensities, SHIFT);
        let colours: Vec<[u32; 3]> = (0..vertices).map(colour).collect();
        vec![Expected::Whole(planes(&colours).into_iter().chain([MARK]).collect())]
    };
    Case::new(name, Size::Small, job, expected).probes([0, 1, vertices, 2 * vertices])
}

fn encode(name: &str, vertices: u32) -> Case {
    let thresholds = || gamma_table(2.2, 1.0).expect("in range");
    let given = move || -> Vec<[u32; 3]> {
        let table = thresholds();
        // Thresholds, what is next to them, nothing, and everything above.
        let value = |i: u32| match i % 5 {
            0 => table[(i / 5 % 255) as usize],
            1 => table[(i / 5 % 255) as usize] - 1,
            2 => random::word(15, i) >> 2,
            3 => 0,
            _ => f32::INFINITY.to_bits() - i,
        };
        (0..vertices).map(|v| [0, 1, 2].map(|c| value(3 * v + c))).collect()
    };
    let job = move || {
        let mut job = Job::new();
        let given = job.slice("given", &planes(&given()));
        let thresholds = job.slice("thresholds", &thresholds());
        let encoded = job.zeroed("encoded", u64::from(vertices) + 1);
        Illumination::new()?.record_encode(&mut job, vertices, given, thresholds, encoded)?;
        job.read("encoded", encoded.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let codes = given().into_iter().map(|colour| oracle::encoded(colour, &thresholds()));
        vec![Expected::Whole(codes.chain([0]).collect())]
    };
    Case::new(name, Size::Small, job, expected).probes([0, 1, 2, 3])
}

const WIDTH: u32 = 512;
const HEIGHT: u32 = 256;

/// A sky with a sun 40,000 times as bright as the rest.
fn sky() -> Fixed {
    let texel = |i: u32| {
        let (row, column) = (i / WIDTH, i % WIDTH);
        let sun = if row.abs_diff(60) < 3 && column.abs_diff(100) < 3 { 40_000.0 } else { 0.0 };
        let blue = 1.0 - row as f32 / 512.0;
        [sun + 0.3 * blue, sun + 0.5 * blue, sun + blue + random::below(1000, 16, i) as f32 / 4096.0]
    };
    Fixed::new(&(0..WIDTH * HEIGHT).map(texel).collect::<Vec<_>>()).expect("finite and positive")
}

fn rotation() -> Rotation {
    Rotation::new([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]).expect("a rotation")
}

fn shadows(i: u32) -> u32 {
    random::word(17, i) & random::word(18, i)
}

/// The whole way: blur, rotation, look-up, matrix times intensities, gamma; colours and codes are compared in a sample.
fn whole(vertices: u32, level: u32) -> Case {
    let taps = || gaussian_taps(1.5, 4).expect("in range");
    let count = crate::light_sphere::count(level);
    let job = move || -> Result<Job> {
        let mut job = Job::new();
        let (kernel, sphere) = (Illumination::new()?, LightSphere::new()?);
        let sky = sky();
        let texels = upload4(&mut job, "texels", &sky.values);
        let taps = job.slice("taps", &taps());
        let rows = job.zeroed("blurred along rows", texels.len());
        let map = job.zeroed("blurred", texels.len());
        kernel.record_blur(&mut job, (WIDTH, HEIGHT), taps, false, texels, rows)?;
        kernel.record_blur(&mut job, (WIDTH, HEIGHT), taps, true, rows, map)?;
        let directions = job.zeroed("lattice", u64::from(count));
        let [units, turned] = [0; 2].map(|_| job.zeroed("directions", u64::from(count)));
        sphere.record_level(&mut job, level, directions)?;
        sphere.record_turn(&mut job, Rotation::IDENTITY, count, directions, units)?;
        sphere.record_turn(&mut job, rotation(), count, directions, turned)?;
        let (weights, up) = scaled_weights(&weights(level));
        let weights = job.slice("weights", &weights);
        let intensities = job.zeroed("intensities", u64::from(count));
        let shape = Shape::LatitudeLongitude { width: WIDTH, height: HEIGHT };
        kernel.record_look_up(&mut job, (shape, map), count, turned, weights, intensities)?;
        let surface = surface(&mut job, vertices, count, shadows);
        let colours = job.zeroed("colours", 3 * u64::from(vertices));
        let shift = sky.shifts.map(|s| colour_shift(s, up));
        kernel.record_illuminate(&mut job, &surface, (count, units, intensities), shift, colours)?;
        let thresholds = job.slice("thresholds", &gamma_table(2.2, 4.0)?);
        let encoded = job.zeroed("encoded", u64::from(vertices));
        kernel.record_encode(&mut job, vertices, colours, thresholds, encoded)?;
        job.read("colours", colours.id());
        job.read("encoded", encoded.id());
        Ok(job)
    };
    let expected = move |_: &_| {
        let sky = sky();
        let rows = oracle::blurred(WIDTH, &sky.values, &taps(), false);
        let map = oracle::blurred(WIDTH, &rows, &taps(), true);
        let (weights, up) = scaled_weights(&weights(level));
        let lights: Vec<Direction> = octahedron(level).into_iter().map(|(d, _)| d).collect();
        let shape = Shape::LatitudeLongitude { width: WIDTH, height: HEIGHT };
        let intensity = |(d, &weight): (&Direction, &u32)| {
            let texel = map[oracle::texel_of(shape, turned(*d, rotation().rows())) as usize];
            texel.map(|value| ((u64::from(value) * u64::from(weight)) >> 32) as u32)
        };
        let intensities: Vec<[u32; 4]> = lights.iter().zip(&weights).map(intensity).collect();
        let units: Vec<Direction> = lights.into_iter().map(normalize3_q15).collect();
        let (normals, shift) = (normals(vertices), sky.shifts.map(|s| colour_shift(s, up)));
        let thresholds = gamma_table(2.2, 4.0).expect("in range");
        let sample: Vec<u32> = (0..400).map(|i| random::below(vertices, 19, i)).collect();
        let colour = |&v: &u32| {
            let entries = entries_of(normals[v as usize], v * 2 / 3, &units, vertices * 2 / 3 + 1, shadows);
            (v, oracle::colour(&entries, &intensities, shift))
        };
        let found: Vec<(u32, [u32; 3])> = sample.par_iter().map(colour).collect();
        let words = |(v, colour): &(u32, [u32; 3])| [0, 1, 2].map(|c| (c * vertices + v, colour[c as usize]));
        let codes = found.iter().map(|(v, colour)| (*v, oracle::encoded(*colour, &thresholds))).collect();
        vec![
            Expected::Sample { words: found.iter().flat_map(words).collect(), seed: 19 },
            Expected::Sample { words: codes, seed: 19 },
        ]
    };
    Case::new(format!("sky_{vertices}"), Size::Real, job, expected).probes([0, 1, 2, 3])
}

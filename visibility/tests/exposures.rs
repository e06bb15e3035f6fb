//! Exposures against the definition: every option on a small scene, each set and count, in i128.

use std::path::Path;

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::irradiance::oracle::weight;
use sightlines_kernels::random;
use sightlines_visibility::error::Place;
use sightlines_visibility::scene::{Camera, Generator, Lens, Mesh, Scene, generate};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::expose::{Exposed, Exposure, Motion, Prepared, Sampling, expose, prepare};
use sightlines_visibility::shadows::light::{Area, Form, Light, Texture};
use sightlines_visibility::shadows::lightmap::{Atlas, BIAS};
use sightlines_visibility::shadows::placement::Placement;
use sightlines_visibility::shadows::surface::{HeightMap, Surface};
use sightlines_visibility::shadows::{Effort, Faces, Rect, Request, bake};

type Quad = [[f64; 3]; 4];

const FLOOR: Rect = Rect { corner: [-2.0, 0.0, 2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, -4.0] };
const LAMP: Rect = Rect { corner: [-0.6, 3.0, -0.5], u: [1.2, 0.0, 0.0], v: [0.0, 0.0, 1.0] };
const SIDE: u32 = 18;

fn machine() -> CpuBackend {
    CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() })
}

fn quad([a, b, c, d]: Quad) -> [[[f64; 3]; 3]; 2] {
    [[a, b, c], [a, c, d]]
}

/// A tilted slab in the air, a post through the floor, a fin that reaches through the light's plane, and a sliver.
fn casters() -> Vec<[[f64; 3]; 3]> {
    let slab = quad([[-0.5, 1.0, -0.4], [0.6, 1.3, -0.4], [0.6, 1.2, 0.5], [-0.5, 0.9, 0.5]]);
    let post = quad([[-1.0, -0.2, 0.1], [-0.9, -0.2, 0.1], [-0.9, 0.8, 0.2], [-1.0, 0.8, 0.2]]);
    let fin = quad([[0.2, 2.6, 0.3], [0.2, 3.4, 0.3], [0.25, 3.4, 0.9], [0.25, 2.6, 0.9]]);
    let sliver = [[[0.9, 0.1, -0.9], [0.9001, 0.1, -0.9], [-0.3, 2.0, 0.4]]];
    [&slab[..], &post, &fin, &sliver].concat()
}

fn exposure(surface: Surface, sampling: Sampling) -> Exposure {
    Exposure {
        triangles: casters(),
        faces: Faces::Both,
        light: Light::from(LAMP),
        surface,
        resolution: SIDE,
        sampling,
        light_sums: true,
        motion: None,
        effort: Effort::default(),
    }
}

fn sampled(placement: Placement, count: u32) -> Sampling {
    Sampling { placement, ..Sampling::new(count) }
}

/// Exposes and holds every bit, count and sum to the definition on the integers of [`prepare`]; the answer is how many
/// texels see a part of the light.
fn holds(exposure: &Exposure) -> (Exposed, u32) {
    let Prepared { field, normals, frames, faces, passes, palette, .. } = prepare(exposure).unwrap();
    let exposed = expose(&machine(), exposure, &mut |_| ()).unwrap();
    let samples: Vec<[i32; 2]> = passes.iter().flat_map(|pass| pass.points().to_vec()).collect();
    let texels = field.count() as usize;
    assert_eq!(exposed.sets.samples_uv, samples);
    let mut partly = 0;
    for (texel, receiver) in field.receivers().iter().enumerate() {
        let (mut counts, mut sums) = (vec![0; palette.colours.len()], vec![0; palette.colours.len()]);
        for (sample, [x, y]) in samples.iter().enumerate() {
            let point = [x + receiver.shift[0], y + receiver.shift[1]];
            let mut ever = !receiver.is_there();
            for triangles in &frames {
                let is = |t| faces.hide(receiver.at, [point[0], point[1], 0], t);
                let is_hidden = !receiver.is_there() || triangles.iter().any(is);
                ever |= is_hidden;
                if !is_hidden {
                    counts[palette.of[sample] as usize] += 1;
                    sums[palette.of[sample] as usize] += weight(receiver.at, normals[texel], point);
                }
            }
            assert_eq!(exposed.sets.is_hidden(texel, sample as u32), ever, "texel {texel}, sample {sample}");
        }
        let all = |sums: usize| (0..palette.colours.len()).map(move |colour| colour * sums + texel);
        assert_eq!(all(texels).map(|at| exposed.visible[at]).collect::<Vec<_>>(), counts, "texel {texel}");
        assert_eq!(all(texels).map(|at| exposed.light[at]).collect::<Vec<_>>(), sums, "texel {texel}");
        let seen: u32 = counts.iter().sum();
        partly += u32::from(seen > 0 && seen < samples.len() as u32 * frames.len() as u32);
    }
    (exposed, partly)
}

#[test]
fn every_pattern_equals_the_definition() {
    let points = Placement::Points((0..50).map(|i| [i * 1300, (i * i * 26) % 65_536]).collect());
    for sampling in [
        sampled(Placement::Grid, 36),
        sampled(Placement::Jittered, 64),
        sampled(Placement::Halton, 37),
        sampled(Placement::BlueNoise, 100),
        sampled(points, 50),
        Sampling { bits: 31, ..sampled(Placement::Halton, 124) },
        sampled(Placement::Halton, 1),
    ] {
        let (exposed, partly) = holds(&exposure(Surface::Plane(FLOOR), sampling.clone()));
        assert!(partly > 30 || sampling.count == 1, "{sampling:?}: the penumbra has {partly} texels");
        assert_eq!(exposed.samples, [sampling.count]);
    }
}

/// More samples than a mask has come in several passes; what they see adds up.
#[test]
fn passes_add_up() {
    let exposure = Exposure { resolution: 6, ..exposure(Surface::Plane(FLOOR), sampled(Placement::Halton, 1100)) };
    assert_eq!(prepare(&exposure).unwrap().passes.len(), 2);
    assert_eq!(holds(&exposure).0.sets.words, 35);
    let short = Sampling { bits: 31, ..exposure.sampling.clone() };
    assert_eq!(holds(&Exposure { sampling: short, ..exposure }).0.sets.words, 36);
}

/// What row spans take has the same sets by lines, so that an option more does not change them.
#[test]
fn a_plain_light_has_the_sets_of_a_bake() {
    for samples in [32, 256, 1024] {
        let exposure = exposure(Surface::Plane(FLOOR), Sampling::new(samples));
        let faces = Faces::Both;
        let request = Request { triangles: casters(), faces, light: LAMP, receiver: FLOOR, resolution: SIDE, samples };
        let baked = bake(&machine(), &request, &mut |_| ()).unwrap();
        let by_lines = expose(&machine(), &exposure, &mut |_| ()).unwrap();
        assert_eq!((&by_lines.sets, &by_lines.visible), (&baked.sets, &baked.visible), "{samples}");
        let plain = expose(&machine(), &Exposure { light_sums: false, ..exposure }, &mut |_| ()).unwrap();
        assert_eq!((plain.sets, plain.visible, plain.work), (baked.sets, baked.visible, baked.work));
    }
}

#[test]
fn each_receiver_of_a_decorrelated_light_has_a_shift_of_its_own() {
    let sampling = Sampling { decorrelated: true, ..sampled(Placement::Grid, 64) };
    let exposure = exposure(Surface::Plane(FLOOR), sampling);
    let (_, partly) = holds(&exposure);
    assert!(partly > 30, "the penumbra has {partly} texels");
    let Prepared { field, passes, .. } = prepare(&exposure).unwrap();
    let [low, high] = passes[0].bounds();
    // Samples are 1/8 of the sides apart, and shifts up to half of that on average.
    let apart = (((high[0] - low[0]) as f64 / 7.0) * ((high[1] - low[1]) as f64 / 7.0)).sqrt() as i32;
    let shifts = |axis: usize| field.receivers().iter().map(move |r| r.shift[axis]);
    for axis in 0..2 {
        let (least, greatest) = (shifts(axis).min().unwrap(), shifts(axis).max().unwrap());
        assert!(least < -apart * 2 / 5 && greatest > apart * 2 / 5, "{least} to {greatest} of {apart}");
        assert!(least >= -apart / 2 - 2 && greatest <= apart / 2 + 2, "{least} to {greatest} of {apart}");
    }
}

#[test]
fn lights_of_any_form_and_colour() {
    let place = Place::default();
    let (red, blue) = ([1.0, 0.0, 0.0], [0.0, 0.25, 1.0]);
    let triangle = Area::new(&place, &[[0.0, 0.0], [1.0, 0.2], [0.4, 1.0]], red).unwrap();
    let tubes = Area::tubes(&place, 3, 0.3, &[red, blue]).unwrap();
    let image = Texture::new(6, 5, (0..30u16).map(|i| [i * 2000, 0, if i % 4 == 0 { 0 } else { 60_000 }]).collect());
    for (form, colours) in
        [(Form::Areas(vec![triangle]), 1), (Form::Areas(tubes), 2), (Form::Image(image.clone()), 24), (Form::Whole, 1)]
    {
        let light = Light { form, colour: [0.5, 1.0, 1.0], rect: LAMP };
        let (exposed, partly) =
            holds(&Exposure { light, ..exposure(Surface::Plane(FLOOR), sampled(Placement::Halton, 90)) });
        assert!(
            exposed.colours.len() <= colours && (colours < 24 || exposed.colours.len() > 12),
            "{:?}",
            exposed.colours
        );
        assert!(partly > 20, "the penumbra has {partly} texels");
        assert_eq!(exposed.samples.iter().sum::<u32>(), 90);
    }
    // A group for each of its 29 colours, and for fewer.
    let light = Light { form: Form::Image(image), ..Light::from(LAMP) };
    for (most, found) in [(1000, 29), (11, 11)] {
        let sampling = Sampling { colours: most, ..sampled(Placement::Halton, 300) };
        let exposure = Exposure { light: light.clone(), ..exposure(Surface::Plane(FLOOR), sampling) };
        let colours = prepare(&exposure).unwrap().palette.colours.len();
        assert!(colours <= found && colours * 2 > found, "{colours} of {most}");
    }
}

#[test]
fn height_fields_slopes_and_walls() {
    let wall = Rect { corner: [-1.8, 0.1, -0.7], u: [3.6, 0.0, 0.0], v: [0.0, 2.4, 0.0] };
    let slope = Rect { v: [0.0, 1.0, -4.0], ..FLOOR };
    let lens = Lens::angle(20.0).unwrap();
    let camera = Camera::look_at("test", [1.0, 3.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0], lens).unwrap();
    for (surface, least) in [
        (Surface::Heights(FLOOR, HeightMap::bumps(0.8)), 30),
        (Surface::Plane(slope), 30),
        (Surface::Plane(wall), 10),
        (Surface::View(FLOOR, camera), 30),
    ] {
        let (exposed, partly) = holds(&exposure(surface, sampled(Placement::Halton, 40)));
        assert!(partly > least, "the penumbra has {partly} texels");
        assert!(exposed.is_there.iter().all(|there| *there));
    }
    // The part of a wall that is above the light has no receivers, and sees nothing.
    let tall = Rect { v: [0.0, 4.8, 0.0], ..wall };
    let (exposed, _) = holds(&exposure(Surface::Plane(tall), sampled(Placement::Halton, 40)));
    let above = exposed.is_there.iter().filter(|there| !**there).count();
    assert!((100..160).contains(&above), "{above} texels are above the light");
}

/// A height field that casts on itself: its triangles are casters, and a slope of it hides none of itself.
#[test]
fn a_relief_hides_from_its_valleys_and_no_slope_from_itself() {
    let light = Light::from(Rect { corner: [-3.4, 0.8, -0.5], u: [0.6, 0.6, 0.0], v: [0.0, 0.0, 1.0] });
    let heights = HeightMap::new(6, 5, (0..30).map(|i| f64::from(i * 7 % 5) * 0.12).collect()).unwrap();
    let casting = |surface| Exposure {
        light: light.clone(),
        triangles: vec![],
        ..exposure(surface, sampled(Placement::Halton, 40))
    };
    let (alone, _) = holds(&casting(Surface::Heights(FLOOR, heights.clone())));
    let relief = casting(Surface::Relief(FLOOR, heights));
    assert_eq!(prepare(&relief).unwrap().frames[0].len(), 2 * 7 * 6);
    let (exposed, partly) = holds(&relief);
    let seen = |exposed: &Exposed| exposed.visible.iter().sum::<u32>();
    assert_eq!((seen(&alone), seen(&exposed), partly), (40 * SIDE * SIDE, 7595, 79));
    // A plane is one slope, however the light stands.
    let slope = HeightMap::new(2, 2, vec![0.0, 1.0, 0.3, 1.3]).unwrap();
    let flat = casting(Surface::Relief(FLOOR, slope));
    let middle = holds(&flat).0;
    let inner = |texel: usize| (5..13).contains(&(texel % SIDE as usize)) && (5..13).contains(&(texel / SIDE as usize));
    assert!((0..(SIDE * SIDE) as usize).filter(|t| inner(*t)).all(|t| middle.visible[t] == 40), "a slope hides itself");
}

/// A tilted floor at real size: 256² receivers, 256 samples, 29,040 triangles; seeded receivers of the penumbra and
/// others.
#[test]
fn a_slope_under_the_palms_equals_the_definition_on_its_penumbra() {
    let settings = Settings { resolution: Some(256), samples: Some(256), ..Settings::default() };
    let setup = Setup::new(generate(Generator::Palms), &settings).unwrap();
    let plain = setup.exposure(0, false);
    let Surface::Plane(floor) = plain.surface else { panic!("the default receiver is a plane") };
    let [corner, v] = [floor.corner, floor.v].map(|mut side| {
        side[1] -= 0.1 * floor.u[0];
        side
    });
    let slope = Exposure { surface: Surface::Plane(Rect { corner, v, ..floor }), ..plain };
    let exposed = expose(&machine(), &slope, &mut |_| ()).unwrap();
    let Prepared { field, frames, passes, .. } = prepare(&slope).unwrap();
    let partly = |texel: &u32| (1..256).contains(&exposed.visible[*texel as usize]);
    let looks: Vec<u32> = (0..).map(|i| random::below(256 * 256, 41, i)).filter(partly).take(10).collect();
    for texel in looks.into_iter().chain((0..4).map(|i| random::below(256 * 256, 42, i))) {
        let want = field.hidden_set(texel, &passes[0], &frames[0]);
        let at = 8 * texel as usize;
        assert_eq!(exposed.sets.masks[at..at + 8], want, "texel {texel}");
    }
}

/// A box with a lightmap: no face hides from itself, and what is turned away is dark.
#[test]
fn a_lightmap_of_a_box() {
    let cells: Vec<[f64; 2]> = (0..6).map(|i| [f64::from(i % 3) / 3.0, f64::from(i / 3) / 2.0]).collect();
    let corner = |i: usize| [i & 1, i >> 1 & 1, i >> 2 & 1].map(|x| x as f64 - 0.5);
    let faces: [[usize; 4]; 6] = [[2, 6, 7, 3], [0, 1, 5, 4], [1, 3, 7, 5], [0, 4, 6, 2], [4, 5, 7, 6], [0, 2, 3, 1]];
    let (mut vertices, mut triangles, mut uvs) = (Vec::new(), Vec::new(), Vec::new());
    for (face, [u, v]) in faces.iter().zip(cells) {
        let first = vertices.len() as u32;
        vertices.extend(face.map(corner));
        let map = [[0.02, 0.02], [0.31, 0.02], [0.31, 0.48], [0.02, 0.48]].map(|[x, y]| [u + x, v + y]);
        triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        uvs.extend([[map[0], map[1], map[2]], [map[0], map[2], map[3]]]);
    }
    let mesh = Mesh { name: "box".to_owned(), vertices, triangles, uvs, ..Mesh::default() };
    let scene = Scene { name: "box".to_owned(), units: "metres", parts: vec![mesh] };
    let atlas = Atlas::new(&scene).unwrap();
    let exposure = Exposure {
        triangles: scene.triangles(),
        surface: Surface::Lightmap(atlas),
        resolution: 24,
        ..exposure(Surface::Plane(FLOOR), sampled(Placement::Halton, 40))
    };
    let (exposed, _) = holds(&exposure);
    let picture = exposed.picture();
    // Faces go up the map row by row: the top is the first, the bottom the second.
    let texel = |column: usize, row: usize| picture[row * 24 + column][0];
    assert_eq!((texel(4, 17), texel(12, 17)), (1.0, 0.0), "all of the top sees the light, nothing of the bottom does");
    let top = (0..24 * 24).filter(|t| t % 24 < 8 && t / 24 >= 12 && exposed.is_there[*t]);
    assert!(top.clone().count() > 60 && top.clone().all(|t| picture[t][0] == 1.0), "the top hides from itself");
    assert!(BIAS > 3f64.sqrt());
}

#[test]
fn what_moves_leaves_its_shadow_in_every_frame() {
    let moving = quad([[-1.4, 0.7, -0.2], [-0.9, 0.7, -0.2], [-0.9, 0.7, 0.4], [-1.4, 0.7, 0.4]]).to_vec();
    let offsets: Vec<[f64; 3]> = (0..3).map(|i| [f64::from(i) * 0.7, 0.0, 0.1]).collect();
    let motion = Some(Motion { triangles: moving, offsets });
    let (exposed, partly) =
        holds(&Exposure { motion, ..exposure(Surface::Plane(FLOOR), sampled(Placement::Halton, 40)) });
    assert_eq!(exposed.samples, [120]);
    assert!(partly > 60, "{partly} texels are partly lit");
}

/// Casters of one face, by lines and by row spans: each face hides by itself what it should, together they hide all.
#[test]
fn one_sided_casters_hide_by_the_face_that_counts() {
    let mut found = Vec::new();
    for faces in [Faces::Both, Faces::Front, Faces::Back] {
        let by_lines = Exposure { faces, ..exposure(Surface::Plane(FLOOR), Sampling::new(64)) };
        let (exposed, _) = holds(&by_lines);
        let by_rows = expose(&machine(), &Exposure { light_sums: false, ..by_lines.clone() }, &mut |_| ()).unwrap();
        assert_eq!((&by_rows.sets, &by_rows.visible), (&exposed.sets, &exposed.visible), "{faces:?}");
        holds(&Exposure { surface: Surface::Heights(FLOOR, HeightMap::bumps(0.8)), ..by_lines });
        found.push(exposed.sets.masks);
    }
    let hidden = |masks: &[u32]| masks.iter().map(|word| word.count_ones()).sum::<u32>();
    let either = found[1].iter().zip(&found[2]).map(|(front, back)| front | back);
    assert!(either.eq(found[0].iter().copied()));
    assert_eq!([0, 1, 2].map(|faces: usize| hidden(&found[faces])), [3685, 409, 3313]);
}

/// A very large light, as wide as the floor and close above the casters.
#[test]
fn a_light_as_large_as_the_scene() {
    let light = Light::from(Rect { corner: [-2.2, 1.5, -2.2], u: [4.4, 0.0, 0.0], v: [0.0, 0.0, 4.4] });
    let (_, partly) = holds(&Exposure { light, ..exposure(Surface::Plane(FLOOR), sampled(Placement::Jittered, 100)) });
    assert!(partly > 200, "{partly} texels are partly lit");
}

/// Irradiance in scene units: a floor of no casters under a small lamp of radiance 1 has area / height² straight below
/// it.
#[test]
fn irradiance_is_in_scene_units() {
    let light = Light::from(Rect { corner: [-0.05, 3.0, -0.05], u: [0.1, 0.0, 0.0], v: [0.0, 0.0, 0.1] });
    let exposure =
        Exposure { light, triangles: vec![], resolution: 9, ..exposure(Surface::Plane(FLOOR), Sampling::new(64)) };
    let light = expose(&machine(), &exposure, &mut |_| ()).unwrap().irradiance();
    let middle = light[4 * 9 + 4][0];
    assert!((middle - 0.01 / 9.0).abs() < 1e-6, "{middle}");
    // At a distance of 16/9 from the foot both cosines are 3 / √(9 + d²).
    let aside = light[4 * 9][0];
    let d: f64 = 16.0 / 9.0;
    assert!((aside - 0.01 * 9.0 / ((9.0 + d * d) * (9.0 + d * d))).abs() < 1e-5, "{aside}");
}

#[test]
fn exposures_that_make_no_sense_are_refused() {
    let message = |exposure: Exposure| prepare(&exposure).unwrap_err().to_string();
    let plane = || Surface::Plane(FLOOR);
    assert!(message(exposure(plane(), sampled(Placement::Halton, 70_000))).contains("70000 samples"));
    let bits = Sampling { bits: 30, ..Sampling::new(32) };
    assert!(message(exposure(plane(), bits)).contains("30 samples a word"));
    let large = Exposure { resolution: 8192, ..exposure(plane(), Sampling::new(1024)) };
    assert!(message(large).contains("too much"));
    let behind = Rect { corner: [-2.0, 4.0, 2.0], v: [0.0, 1.0, -4.0], ..FLOOR };
    assert!(message(exposure(Surface::Plane(behind), Sampling::new(32))).contains("in front of the light"));
    let flat = Rect { v: [0.0; 3], ..FLOOR };
    assert!(message(exposure(Surface::Plane(flat), Sampling::new(32))).contains("no area"));
    assert!(HeightMap::load(Path::new("none.png"), 1.0).unwrap_err().to_string().contains("none.png"));
}

//! Baked sets against the definition, in i128: whole on small scenes, on a seeded penumbra sample of the palms.

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::grid::{Triangle, hidden_set};
use sightlines_kernels::influence_region::oracle::region;
use sightlines_kernels::random;
use sightlines_visibility::scene::{Generator, generate};
use sightlines_visibility::shadows::snap::{Snapped, snap};
use sightlines_visibility::shadows::{Bake, Rect, Request, bake};

fn machine() -> CpuBackend {
    CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() })
}

fn request(triangles: Vec<[[f64; 3]; 3]>, resolution: u32, samples: u32, side: f64) -> Request {
    Request {
        triangles,
        light: Rect { corner: [-side / 2.0, 3.0, -side / 2.0], u: [side, 0.0, 0.0], v: [0.0, 0.0, side] },
        receiver: Rect { corner: [-2.0, 0.0, 2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, -4.0] },
        resolution,
        samples,
    }
}

/// The set of a texel, by the definition alone.
fn defined(scene: &Snapped, side: u32, texel: u32) -> Vec<u32> {
    let (mut column, mut row) = (texel % side, texel / side);
    if scene.mirrored[0] {
        column = side - 1 - column;
    }
    if scene.mirrored[1] {
        row = side - 1 - row;
    }
    let near = |t: &&Triangle| {
        let [x0, x1, y0, y1] = region(t, &scene.samples, &scene.receivers);
        (x0..=x1).contains(&(column as i32)) && (y0..=y1).contains(&(row as i32))
    };
    let triangles = scene.between.iter().filter(near).chain(&scene.crossing);
    hidden_set(scene.receivers.at(row * side + column), &scene.samples, triangles)
}

fn set(baked: &Bake, texel: u32) -> &[u32] {
    &baked.masks[(texel * baked.words) as usize..][..baked.words as usize]
}

/// A tilted slab in the air, a post that stands through the floor, and a sliver.
fn small() -> Vec<[[f64; 3]; 3]> {
    let quad = |a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]| [[a, b, c], [a, c, d]];
    let slab = quad([-0.5, 1.0, -0.4], [0.6, 1.3, -0.4], [0.6, 1.2, 0.5], [-0.5, 0.9, 0.5]);
    let post = quad([-1.0, -0.2, 0.1], [-0.9, -0.2, 0.1], [-0.9, 0.8, 0.2], [-1.0, 0.8, 0.2]);
    let sliver = [[[0.9, 0.1, -0.9], [0.9001, 0.1, -0.9], [-0.3, 2.0, 0.4]]];
    [&slab[..], &post[..], &sliver[..]].concat()
}

#[test]
fn small_scenes_equal_the_definition_whole() {
    for (samples, side) in [(32, 0.4), (64, 1.3), (256, 0.4), (1024, 0.4)] {
        let request = request(small(), 24, samples, side);
        let scene = snap(&request).unwrap();
        assert_eq!((scene.between.len(), scene.crossing.len()), (3, 2));
        let baked = bake(&machine(), &request, &mut |_| ()).unwrap();
        let mut partly = 0;
        for texel in 0..24 * 24 {
            let want = defined(&scene, 24, texel);
            assert_eq!(set(&baked, texel), want, "texel {texel} under {samples} samples");
            let hidden: u32 = want.iter().map(|w| w.count_ones()).sum();
            partly += u32::from((1..samples).contains(&hidden));
        }
        assert!(partly > 20, "the penumbra has only {partly} texels");
    }
}

#[test]
fn the_palms_equal_the_definition_on_their_penumbra() {
    let side = 128;
    let palms = generate(Generator::Palms).triangles();
    let scaled = palms.iter().map(|t| t.map(|p| p.map(|c| c / 6.9))).collect();
    let request = request(scaled, side, 1024, 0.4);
    let scene = snap(&request).unwrap();
    let baked = bake(&machine(), &request, &mut |_| ()).unwrap();
    let visible = baked.visible();
    let penumbra = |texel: &u32| (1..1024).contains(&visible[*texel as usize]);
    let looks: Vec<u32> = (0..).map(|i| random::below(side * side, 23, i)).filter(penumbra).take(64).collect();
    for texel in looks {
        assert_eq!(set(&baked, texel), defined(&scene, side, texel), "texel {texel}");
    }
}

#[test]
fn progress_grows_to_one() {
    let mut last = 0.0;
    bake(&machine(), &request(small(), 24, 64, 0.4), &mut |share| {
        assert!((last..=1.0).contains(&share), "{share} after {last}");
        last = share;
    })
    .unwrap();
    assert_eq!(last, 1.0);
}

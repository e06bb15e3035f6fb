//! Baked sets against the definition, in i128: whole on small scenes, on a seeded penumbra sample of the palms.

use sightlines_backend_cpu::{Bounds, Config, CpuBackend};
use sightlines_kernels::grid::hidden_set;
use sightlines_kernels::influence_region::oracle::region;
use sightlines_kernels::random;
use sightlines_visibility::scene::{Generator, generate};
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::snap::{Snapped, snap};
use sightlines_visibility::shadows::{Bake, Effort, Faces, Rect, Request, Work, bake, bake_with};

fn machine() -> CpuBackend {
    CpuBackend::new(Config { bounds: Bounds::Trap, ..Config::default() })
}

fn request(triangles: Vec<[[f64; 3]; 3]>, resolution: u32, samples: u32, side: f64) -> Request {
    Request {
        triangles,
        faces: Faces::Both,
        light: Rect { corner: [-side / 2.0, 3.0, -side / 2.0], u: [side, 0.0, 0.0], v: [0.0, 0.0, side] },
        receiver: Rect { corner: [-2.0, 0.0, 2.0], u: [4.0, 0.0, 0.0], v: [0.0, 0.0, -4.0] },
        resolution,
        samples,
    }
}

/// A scene with the regions of its triangles, by their oracle.
struct Defined {
    scene: Snapped,
    regions: Vec<[i32; 4]>,
}

impl Defined {
    fn new(request: &Request) -> Self {
        let scene = snap(request).unwrap();
        let regions = scene.between.iter().map(|t| region(t, &scene.samples, &scene.receivers)).collect();
        Defined { scene, regions }
    }

    /// The set of a texel, by the definition alone.
    fn set(&self, texel: u32) -> Vec<u32> {
        let Snapped { samples, receivers, mirrored, .. } = &self.scene;
        let side = receivers.columns;
        let turned = |at: u32, mirrored: bool| if mirrored { side - 1 - at } else { at };
        let (column, row) = (turned(texel % side, mirrored[0]), turned(texel / side, mirrored[1]));
        let near =
            |[x0, x1, y0, y1]: [i32; 4]| (x0..=x1).contains(&(column as i32)) && (y0..=y1).contains(&(row as i32));
        let between = self.scene.between.iter().zip(&self.regions).filter(|(_, region)| near(**region)).map(|(t, _)| t);
        hidden_set(receivers.at(row * side + column), samples, between.chain(&self.scene.crossing))
    }

    /// Triangles and the receivers in their regions.
    fn pairs(&self) -> u64 {
        let side = |first: i32, last: i32| (i64::from(last) - i64::from(first) + 1).max(0) as u64;
        let crossing = u64::from(self.scene.receivers.count()) * self.scene.crossing.len() as u64;
        self.regions.iter().map(|[x0, x1, y0, y1]| side(*x0, *x1) * side(*y0, *y1)).sum::<u64>() + crossing
    }
}

fn set(baked: &Bake, texel: u32) -> &[u32] {
    let words = baked.sets.words;
    &baked.sets.masks[(texel * words) as usize..][..words as usize]
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
        let defined = Defined::new(&request);
        assert_eq!((defined.scene.between.len(), defined.scene.crossing.len()), (3, 2));
        let baked = bake(&machine(), &request, &mut |_| ()).unwrap();
        let mut partly = 0;
        for texel in 0..24 * 24 {
            let want = defined.set(texel);
            assert_eq!(set(&baked, texel), want, "texel {texel} under {samples} samples");
            let hidden: u32 = want.iter().map(|w| w.count_ones()).sum();
            assert_eq!(baked.visible[texel as usize], samples - hidden, "texel {texel} under {samples} samples");
            partly += u32::from((1..samples).contains(&hidden));
        }
        assert!(partly > 20, "the penumbra has only {partly} texels");
    }
}

/// The palms as the program bakes them where nothing is asked for: 512² texels, 1024 samples, light size 0.4.
#[test]
fn the_palms_equal_the_definition_on_their_penumbra() {
    let request = Setup::new(generate(Generator::Palms), &Settings::default()).unwrap().request();
    assert_eq!((request.resolution, request.samples), (512, 1024));
    let defined = Defined::new(&request);
    let baked = bake(&machine(), &request, &mut |_| ()).unwrap();
    let partly = |texel: &u32| (1..1024).contains(&baked.visible[*texel as usize]);
    let looks: Vec<u32> = (0..).map(|i| random::below(512 * 512, 23, i)).filter(partly).take(256).collect();
    let all: Vec<u32> = looks.iter().copied().chain((0..64).map(|i| random::below(512 * 512, 24, i))).collect();
    for texel in all {
        let want = defined.set(texel);
        assert_eq!(set(&baked, texel), want, "texel {texel}");
        let hidden: u32 = want.iter().map(|word| word.count_ones()).sum();
        assert_eq!(baked.visible[texel as usize], 1024 - hidden, "texel {texel}");
    }
}

#[test]
fn work_is_counted_and_does_not_depend_on_threads() {
    let request = request(small(), 24, 64, 0.4);
    let work = |threads, count| {
        let machine = CpuBackend::new(Config { threads, count, ..Config::default() });
        // The sliver is a line on the grid, and culling would leave it out.
        bake_with(&machine, &request, &Effort { cull: false, ..Effort::default() }, &mut |_| ()).unwrap().work
    };
    let one = work(1, true);
    assert_eq!(one.pairs, Defined::new(&request).pairs());
    assert_eq!(one.pairs, 1599);
    let counts = one.counts.unwrap();
    assert!(counts.atomics > 0 && counts.loads > counts.stores && one.lane_ops.unwrap() > counts.loads);
    assert_eq!(work(2, true), one);
    assert_eq!(work(2, false), Work { counts: None, ..one });
}

#[test]
fn work_adds_up_and_what_is_not_counted_stays_so() {
    let part = Work { pairs: 3, closed: 4, culled: 1, bytes: 9, lane_ops: Some(40), counts: None };
    let mut sum = Work::default();
    sum += part;
    sum += part;
    assert_eq!(sum, Work { pairs: 6, closed: 8, culled: 2, bytes: 9, lane_ops: Some(80), counts: None });
    sum += Work { lane_ops: None, ..part };
    assert_eq!(sum, Work { pairs: 9, closed: 12, culled: 3, bytes: 9, lane_ops: None, counts: None });
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

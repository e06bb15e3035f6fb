//! A grove of palms, as many triangles as the palms that papers measure: about 29,000.
//!
//! Fronds are few and long against the grove's radius, so that even a large light leaves palms in the shadow.

use std::f64::consts::TAU;

use crate::scene::Mesh;
use crate::vector::{Vector, add, cross, normalize, scale, sub};

const PALMS: u32 = 5;
/// Frusta of a trunk, each wider at its top: the scars of old leaves.
const TRUNK_RINGS: u32 = 12;
const TRUNK_SIDES: u32 = 8;
/// Pieces of a frond's midrib.
const MIDRIB_PIECES: u32 = 12;
/// Leaflets on each side of a midrib.
const LEAFLETS: u32 = 62;
const UP: Vector = [0.0, 1.0, 0.0];

/// Numbers from a seed, by an integer hash (SplitMix64) of a counter.
struct Random(u64);

impl Random {
    /// A number of [low, high), a multiple of 2^-53 of the range.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        low + (high - low) * ((z >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// A horizontal direction.
fn heading(angle: f64) -> Vector {
    [libm::cos(angle), 0.0, libm::sin(angle)]
}

/// One palm in the middle, the others around it, leaning outwards.
pub(super) fn grove() -> Vec<Mesh> {
    let mut random = Random(0x5167_4711);
    (0..PALMS)
        .map(|number| {
            let angle = TAU * f64::from(number) / f64::from(PALMS - 1) + random.between(-0.15, 0.15);
            let distance = if number == 0 { 0.3 } else { random.between(3.2, 3.8) };
            palm(number, scale(heading(angle), distance), angle, &mut random)
        })
        .collect()
}

fn palm(number: u32, foot: Vector, away: f64, random: &mut Random) -> Mesh {
    let mut mesh = Mesh::named(format!("palm {}", number + 1));
    let height = random.between(2.0, 3.4);
    let lean = scale(heading(away + random.between(-0.6, 0.6)), random.between(0.2, 0.8));
    let stem = |t: f64| add(add(foot, scale(UP, height * t)), scale(lean, t * t));
    trunk(&mut mesh, stem, random.between(0.10, 0.15));
    let fronds = 10 + number % 3;
    let (first, length) = (random.between(0.0, TAU), random.between(2.2, 2.7));
    for index in 0..fronds {
        let turn = TAU * f64::from(index) / f64::from(fronds);
        let frond = Frond {
            root: stem(1.0),
            angle: first + turn + random.between(-0.12, 0.12),
            curl: random.between(-0.4, 0.4),
            rise: random.between(0.35, 0.75),
            droop: random.between(0.55, 0.85),
            length: length * random.between(0.88, 1.08),
        };
        frond.build(&mut mesh);
    }
    mesh
}

fn trunk(mesh: &mut Mesh, stem: impl Fn(f64) -> Vector, radius: f64) {
    let ring = |t: f64, radius: f64| {
        let centre = stem(t);
        (0..TRUNK_SIDES).map(move |i| add(centre, scale(heading(TAU * f64::from(i) / f64::from(TRUNK_SIDES)), radius)))
    };
    for piece in 0..TRUNK_RINGS {
        let (low, high) = (f64::from(piece) / f64::from(TRUNK_RINGS), f64::from(piece + 1) / f64::from(TRUNK_RINGS));
        let taper = |t: f64| radius * (1.0 - 0.45 * t);
        let (bottom, top) = (mesh.vertices(ring(low, taper(low))), mesh.vertices(ring(high, 1.2 * taper(high))));
        for i in 0..TRUNK_SIDES {
            let next = (i + 1) % TRUNK_SIDES;
            mesh.quad([bottom + i, top + i, top + next, bottom + next]);
        }
    }
}

/// A leaf of a palm: a midrib that rises, bends over and turns, with leaflets along both sides.
struct Frond {
    root: Vector,
    /// Heading at the root.
    angle: f64,
    /// How far the heading turns until the tip.
    curl: f64,
    /// Slope at the root.
    rise: f64,
    /// How much of the length the tip has fallen below that slope.
    droop: f64,
    length: f64,
}

impl Frond {
    /// The midrib at `s`, from 0 at the root to 1 at the tip.
    fn at(&self, s: f64) -> Vector {
        let out = scale(heading(self.angle + self.curl * s), self.length * s * (1.0 - 0.12 * s));
        let up = scale(UP, self.length * s * (self.rise - self.droop * s));
        add(self.root, add(out, up))
    }

    fn tangent(&self, s: f64) -> Vector {
        normalize(sub(self.at(s + 0.01), self.at(s - 0.01)))
    }

    fn build(&self, mesh: &mut Mesh) {
        self.midrib(mesh);
        for number in 0..LEAFLETS {
            let s = 0.08 + 0.92 * (f64::from(number) + 0.5) / f64::from(LEAFLETS);
            self.leaflet(mesh, s, 1.0);
            self.leaflet(mesh, s, -1.0);
        }
    }

    /// A ribbon that narrows towards the tip.
    fn midrib(&self, mesh: &mut Mesh) {
        let mut below = None;
        for piece in 0..=MIDRIB_PIECES {
            let s = f64::from(piece) / f64::from(MIDRIB_PIECES);
            let across = scale(self.side(s), 0.018 * self.length * (1.05 - s));
            let row = mesh.vertices([sub(self.at(s), across), add(self.at(s), across)]);
            if let Some(below) = below.replace(row) {
                mesh.quad([below, below + 1, row + 1, row]);
            }
        }
    }

    fn side(&self, s: f64) -> Vector {
        normalize(cross(self.tangent(s), UP))
    }

    /// A blade of two pieces that points outwards and forwards and hangs at its tip.
    fn leaflet(&self, mesh: &mut Mesh, s: f64, side: f64) {
        let tangent = self.tangent(s);
        let out = normalize(add(scale(self.side(s), side), scale(tangent, 0.8)));
        // Longest at a third of the frond, so that the frond is pointed.
        let length = self.length * (0.035 + 0.34 * s.sqrt() * (1.0 - s));
        let width = 0.006 * self.length;
        let row = |along: f64, hang: f64, width: f64| {
            let centre = add(self.at(s), add(scale(out, along * length), scale(UP, -hang * length)));
            [sub(centre, scale(tangent, width)), add(centre, scale(tangent, width))]
        };
        let root = mesh.vertices(row(0.0, 0.0, 0.6 * width));
        let belly = mesh.vertices(row(0.5, 0.06, width));
        let tip = mesh.vertices(row(1.0, 0.32, 0.1 * width));
        mesh.quad([root, root + 1, belly + 1, belly]);
        mesh.quad([belly, belly + 1, tip + 1, tip]);
    }
}

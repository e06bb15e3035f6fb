//! Scenes without a file: a palm grove of the size that papers measure, and small ones whose shadows are known.
//!
//! They are the same bits on every host: positions come from integer hashes, f64 arithmetic and `libm` alone. All stand
//! with y up, in metres, above the ground plane y = 0.

mod bumpy;
mod crowd;
mod moving;
mod office;
mod palms;
mod shapes;

use super::{Mesh, Scene, World};

pub use bumpy::{MAX_BUMPY, bumpy_sphere, trio};
pub use crowd::{MAX_BALLS, ball_levels, creature_field, creature_in_hall, crowd};
pub(super) use moving::{cloth, skeleton};

/// A scene by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Generator {
    /// Five palms: trunks of stacked rings, curved fronds with leaflets.
    Palms,
    /// One cube in the air.
    Box,
    /// Two upright squares that cross.
    Quads,
    /// Two rows of columns that carry beams.
    Colonnade,
    /// Desks in rows, with legs, screens and chairs.
    Office,
    /// Hills and hollows, with texture coordinates.
    Ground,
}

impl Generator {
    /// All of them.
    pub const ALL: [Generator; 6] = [
        Generator::Palms,
        Generator::Box,
        Generator::Quads,
        Generator::Colonnade,
        Generator::Office,
        Generator::Ground,
    ];

    /// The name that command lines and scene files use.
    pub fn name(self) -> &'static str {
        match self {
            Generator::Palms => "palms",
            Generator::Box => "box",
            Generator::Quads => "quads",
            Generator::Colonnade => "colonnade",
            Generator::Office => "office",
            Generator::Ground => "ground",
        }
    }

    /// The generator of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Generator::ALL.into_iter().find(|generator| generator.name() == name)
    }
}

/// Makes a scene.
pub fn generate(generator: Generator) -> Scene {
    let parts = match generator {
        Generator::Palms => palms::grove(),
        Generator::Box => vec![shapes::cuboid("box", [-0.5, 0.5, -0.5], [0.5, 1.5, 0.5])],
        Generator::Quads => shapes::quads(),
        Generator::Colonnade => shapes::colonnade(),
        Generator::Office => office::desks(),
        Generator::Ground => vec![shapes::ground()],
    };
    Scene { name: generator.name().to_owned(), units: "metres", parts }
}

/// A scene with instances and cameras by name: `hall`, `trio`, `crowd-100` and the like up to [`MAX_BALLS`],
/// `bumpy-2000` and the like up to [`MAX_BUMPY`] triangles, or a [`Generator`].
pub fn generate_world(name: &str) -> Option<World> {
    match name {
        "hall" => return Some(creature_in_hall()),
        "trio" => return Some(World::of(trio())),
        _ => {}
    }
    let triangles = name.strip_prefix("bumpy-").and_then(|count| count.parse().ok());
    if let Some(count) = triangles.filter(|count| (24..=MAX_BUMPY).contains(count)) {
        return Some(World::of(bumpy_sphere(count)));
    }
    let balls = name.strip_prefix("crowd-").and_then(|count| count.parse().ok());
    let crowd = balls.filter(|count| (1..=MAX_BALLS).contains(count)).map(crowd);
    crowd.or_else(|| Generator::from_name(name).map(|known| World::of(generate(known))))
}

impl Mesh {
    fn named(name: impl Into<String>) -> Self {
        Mesh { name: name.into(), ..Mesh::default() }
    }

    /// Appends vertices; the answer is the index of the first.
    fn vertices(&mut self, points: impl IntoIterator<Item = [f64; 3]>) -> u32 {
        let first = self.vertices.len() as u32;
        self.vertices.extend(points);
        first
    }

    /// A quadrilateral of four vertices in turn.
    fn quad(&mut self, [a, b, c, d]: [u32; 4]) {
        self.triangles.extend([[a, b, c], [a, c, d]]);
    }
}

//! The order of the paper: each triangle's region, three look-ups a receiver in a table of angles and distances, AND,
//! OR.
//!
//! Eisemann and Décoret, *Visibility Sampling on GPU and Applications*, sections 3 to 5. The table holds the samples
//! inside the half-plane of each texel's centre, so it is as wrong as it is coarse: samples between a line and the
//! centre of its texel are taken to be on the wrong side. `bake` has the same sets without that error.

use sightlines_backend::{Backend, Job};
use sightlines_kernels::field::Field;
use sightlines_kernels::influence_region::InfluenceRegion;
use sightlines_kernels::line_mask::{LineMask, Resolution, Space, TILE, record_masks_by};
use sightlines_kernels::pattern::Pattern;
use sightlines_kernels::popcount::{Method, Popcount, Shape};
use sightlines_kernels::tiles::Tiles;

use super::{interleaved, snapped, upload};
use crate::error::Result;
use crate::shadows::compose::{Composed, run};
use crate::shadows::{Bake, Request, Work, assemble};

/// log2 of the table's angles and of its distances.
pub const TABLE_BITS: u32 = 9;

/// Bakes sets by a table of 2^[`TABLE_BITS`] angles and as many distances. Its pairs are triangles and receivers in a
/// region.
///
/// # Errors
///
/// As [`projections`](super::projections).
pub fn tables(backend: &dyn Backend, request: &Request, progress: &mut dyn FnMut(f32)) -> Result<Bake> {
    let scene = snapped(request)?;
    let receivers = &scene.receivers;
    let mut work = Work::default();
    let mut job = Job::new();
    let given = upload(&mut job, &scene);
    let words = job.zeroed("regions", 4 * u64::from(given.triangles.max(1)));
    if given.triangles > 0 {
        InfluenceRegion::new()?.record(&mut job, &scene.samples, receivers, given.vertices, words)?;
    }
    job.read("regions", words.id());
    let [words] = run(backend, &job, &mut work, &mut |_| ())?;
    let regions: Vec<[i32; 4]> = words.as_chunks().0.iter().map(|r: &[u32; 4]| r.map(|word| word as i32)).collect();
    let regions = &regions[..given.triangles as usize];
    let side = |first: i32, last: i32| (i64::from(last) - i64::from(first) + 1).max(0) as u64;
    work.pairs = regions.iter().map(|[x0, x1, y0, y1]| side(*x0, *x1) * side(*y0, *y1)).sum();

    let pattern = Pattern::regular(&scene.samples)?;
    let kernel = LineMask::new(&pattern, Resolution { space: Space::Sampled, bits: TABLE_BITS })?;
    let tiles = Tiles::new(TILE, receivers, regions);
    let mut job = Job::new();
    let hidden = record_masks_by(&mut job, &kernel, &Field::from(receivers), &tiles, &scene.between)?;
    let shape = Shape { receivers: receivers.count(), samples: scene.samples.count(), bits: 32 };
    let counts = ["hidden counts", "visible counts"].map(|name| job.zeroed(name, u64::from(receivers.count())));
    Popcount::new()?.record(&mut job, Method::Builtin, shape, hidden, counts[0], counts[1])?;
    job.read("hidden", hidden.id());
    job.read("visible", counts[1].id());
    let [planes, visible] = run(backend, &job, &mut work, progress)?;
    progress(1.0);
    let masks = interleaved(&planes, receivers.count() as usize, scene.samples.words() as usize);
    Ok(assemble(request, &scene, Composed { masks, visible, work }))
}

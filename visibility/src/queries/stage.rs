//! What is drawn and counted: instances of a world before a camera, each with its item numbers.
//!
//! Items are numbered mesh by mesh, then instance by instance, then cluster by cluster. Meshes go to the device in
//! batches that fit the raster and the 16 bits which an item's word has for its place in a batch. Invariant: the pixels
//! of a stage depend on its frame and its instances alone, so a stage of fewer instances in the same frame draws those
//! exactly as before.

use std::sync::Arc;

use glam::IVec4;
use sightlines_backend::Job;
use sightlines_backend::host::Buffer;
use sightlines_kernels::pieces;
use sightlines_kernels::raster::{self, Faces, Ids, MAX_POINTS, Picture, Placement, Raster};

use crate::error::{Place, Result};
use crate::scene::frame::{Frame, Snapped};
use crate::scene::{Mesh, World};

/// Items of a batch: 16 bits of the word of a pixel.
const BATCH_ITEMS: usize = 1 << 16;

/// Most batches: the other 16 bits, without the word of a pixel that shows nothing.
const MAX_BATCHES: usize = (1 << 16) - 1;

/// Most batches of a recording, so that scenes of many meshes run in steps too.
const RECORDED_BATCHES: usize = 64;

/// What an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Granularity {
    /// An instance.
    Instances,
    /// 2^shift neighbouring triangles of an instance; shift is below 31.
    Clusters {
        /// Logarithm of the triangles of a cluster.
        shift: u32,
    },
}

impl Granularity {
    fn shift(self) -> u32 {
        match self {
            Granularity::Instances => 31,
            Granularity::Clusters { shift } => shift,
        }
    }
}

/// What is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Item {
    /// The instance, by its place in the world.
    pub instance: usize,
    /// The cluster, 0 where an item is an instance.
    pub cluster: u32,
}

/// Instances before a camera.
#[derive(Clone, Debug)]
pub struct Stage {
    /// Camera and picture.
    pub frame: Frame,
    /// Which sides of triangles are drawn.
    pub faces: Faces,
    /// The items, by number.
    pub items: Vec<Item>,
    pub(super) batches: Vec<Batch>,
    shift: u32,
}

/// Instances of a mesh that are drawn at once.
#[derive(Clone, Debug)]
pub(super) struct Batch {
    /// Vertices on the mesh's grid.
    pub(super) vertices: Arc<Vec<[i32; 3]>>,
    triangles: Arc<Vec<[u32; 3]>>,
    pub(super) placements: Vec<Placement>,
    /// Number of its first item.
    pub(super) first: u32,
    /// Items of an instance.
    pub(super) step: u32,
}

/// The buffers of a stage that was drawn.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The picture.
    pub picture: Picture,
    /// Least depth of every pixel, or [`raster::FAR`].
    pub depth: Buffer<[u32]>,
    /// For every pixel the batch and the item's place in it, 16 bits each, or [`raster::NOTHING`].
    pub words: Buffer<[u32]>,
    /// First item of every batch, which turns words into numbers.
    pub(super) firsts: Vec<u32>,
    /// Number of items.
    pub items: u32,
}

impl Stage {
    /// The given instances of a world, by their places in it, in a frame that was made for all of them.
    ///
    /// # Errors
    ///
    /// More items, vertices or clusters than the device's limits allow.
    pub fn new(world: &World, frame: Frame, instances: &[usize], granularity: Granularity) -> Result<Self> {
        let shift = granularity.shift();
        let mut stage = Stage { frame, faces: Faces::All, items: Vec::new(), batches: Vec::new(), shift };
        let mut by_mesh = instances.to_vec();
        by_mesh.sort_by_key(|instance| world.instances[*instance].mesh);
        for users in by_mesh.chunk_by(|a, b| world.instances[*a].mesh == world.instances[*b].mesh) {
            stage.add(world, &world.meshes[world.instances[users[0]].mesh], users)?;
        }
        if stage.batches.len() > MAX_BATCHES {
            let what = format!("{} batches of instances, at most {MAX_BATCHES} are drawn", stage.batches.len());
            return Err(Place::default().element("scene").error(what, "join its meshes, or choose larger clusters"));
        }
        Ok(stage)
    }

    /// Adds the instances of a mesh, in batches.
    fn add(&mut self, world: &World, mesh: &Mesh, users: &[usize]) -> Result<()> {
        if mesh.triangles.is_empty() {
            return Ok(());
        }
        let step = ((mesh.triangles.len() - 1) >> self.shift) + 1;
        let most = (MAX_POINTS as usize / mesh.vertices.len().max(1)).min(BATCH_ITEMS / step);
        if most == 0 {
            let (vertices, triangles) = (mesh.vertices.len(), mesh.triangles.len());
            let what = format!("{vertices} vertices and {triangles} triangles in {step} items");
            let remedy = format!(
                "split the mesh below {MAX_POINTS} vertices, and choose larger clusters: at most {BATCH_ITEMS} items"
            );
            return Err(Place::default().element(format!("mesh `{}`", mesh.name)).error(what, remedy));
        }
        let snapped = Snapped::of(mesh);
        let (vertices, triangles) = (snapped.vertices.into(), mesh.triangles.clone().into());
        for part in users.chunks(most) {
            let place = |i: &usize| self.frame.placement(&world.instances[*i].transform.then(&snapped.to_mesh));
            self.batches.push(Batch {
                vertices: Arc::clone(&vertices),
                triangles: Arc::clone(&triangles),
                placements: part.iter().map(place).collect::<Result<_>>()?,
                first: self.items.len() as u32,
                step: step as u32,
            });
            let clusters = |i: &usize| (0..step as u32).map(|cluster| (*i, cluster)).collect::<Vec<_>>();
            self.items.extend(part.iter().flat_map(clusters).map(|(instance, cluster)| Item { instance, cluster }));
        }
        Ok(())
    }

    /// The stage with those of its instances alone that `keeps`, by their places in the world; it draws them as before.
    pub fn part(&self, keeps: impl Fn(usize) -> bool) -> Self {
        let mut part = Stage { items: Vec::new(), batches: Vec::new(), ..*self };
        for batch in &self.batches {
            let (first, step) = (batch.first as usize, batch.step as usize);
            let items = |n: usize| &self.items[first + n * step..first + (n + 1) * step];
            let kept: Vec<usize> = (0..batch.placements.len()).filter(|n| keeps(items(*n)[0].instance)).collect();
            if !kept.is_empty() {
                let placements = kept.iter().map(|n| batch.placements[*n]).collect();
                part.batches.push(Batch { placements, first: part.items.len() as u32, ..batch.clone() });
                part.items.extend(kept.iter().flat_map(|n| items(*n)));
            }
        }
        part
    }

    /// All instances of a world before a camera, as whole instances.
    ///
    /// # Errors
    ///
    /// Nothing in front of the camera, and those of [`Stage::new`].
    pub fn of(world: &World, frame: Frame) -> Result<Self> {
        let all: Vec<usize> = (0..world.instances.len()).collect();
        Stage::new(world, frame, &all, Granularity::Instances)
    }

    /// Number of instances.
    pub fn instances(&self) -> usize {
        self.batches.iter().map(|batch| batch.placements.len()).sum()
    }

    /// Number of triangles that are drawn, instances counted each.
    pub fn triangles(&self) -> u64 {
        self.batches.iter().map(|batch| (batch.placements.len() * batch.triangles.len()) as u64).sum()
    }

    /// Draws the stage: depths of all batches, then items. What follows may read all of [`Drawn`].
    ///
    /// # Errors
    ///
    /// What the raster refuses.
    pub fn record(&self, raster: &Raster, job: &mut Job) -> Result<Drawn> {
        let picture = self.frame.view.picture;
        let [depth, words] = ["depth", "item words"].map(|name| job.zeroed(name, u64::from(picture.pixels())));
        raster.record_clear(job, picture, depth)?;
        self.record_over(raster, job, [depth, words])
    }

    /// Draws the stage over depths that are there already, and its items anew.
    pub(super) fn record_over(
        &self,
        raster: &Raster,
        job: &mut Job,
        [depth, words]: [Buffer<[u32]>; 2],
    ) -> Result<Drawn> {
        let picture = self.frame.view.picture;
        raster.record_clear(job, picture, words)?;
        let projected = self.project(raster, job)?;
        for (number, mesh) in projected.iter().enumerate() {
            begin(job, number);
            raster.record_depth(job, mesh, self.faces, depth)?;
        }
        for (number, (mesh, batch)) in projected.iter().zip(&self.batches).enumerate() {
            begin(job, number);
            let ids = Ids { base: (number as u32) << 16, step: batch.step, shift: self.shift };
            raster.record_items(job, mesh, self.faces, ids, [depth, words])?;
        }
        let firsts = self.batches.iter().map(|batch| batch.first).collect();
        Ok(Drawn { picture, depth, words, firsts, items: self.items.len() as u32 })
    }

    /// Puts the vertices of every batch on the screen.
    pub(super) fn project(&self, raster: &Raster, job: &mut Job) -> Result<Vec<raster::Projected>> {
        let mut projected = Vec::with_capacity(self.batches.len());
        for (number, batch) in self.batches.iter().enumerate() {
            begin(job, number);
            let mesh = batch.upload(job);
            projected.push(raster.project(job, self.frame.view, mesh)?);
        }
        Ok(projected)
    }
}

/// Begins a recording where enough batches are in the last one.
fn begin(job: &mut Job, batch: usize) {
    if batch.is_multiple_of(RECORDED_BATCHES) {
        pieces::cut(job);
    }
}

impl Batch {
    pub(super) fn upload(&self, job: &mut Job) -> raster::Mesh {
        let rows: Vec<IVec4> = self.placements.iter().flat_map(|placement| placement.rows).collect();
        raster::Mesh {
            vertices: job.slice("vertices", self.vertices.as_flattened()),
            vertex_count: self.vertices.len() as u32,
            indices: job.slice("triangles", self.triangles.as_flattened()),
            triangle_count: self.triangles.len() as u32,
            rows: job.slice("placements", &rows),
            instance_count: self.placements.len() as u32,
        }
    }
}

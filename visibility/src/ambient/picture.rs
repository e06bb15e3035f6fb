//! Pictures of a shaded surface, and which triangles a camera sees.
//!
//! The exact raster draws triangle numbers once for a camera; colours are then interpolated where a pixel's ray meets
//! its triangle's plane. One [`View`] serves any number of lights, and the lists of lazy evaluation. Invariant: a
//! triangle is seen if and only if the raster gives it a pixel.

use sightlines_backend::{Backend, Job};
use sightlines_kernels::raster::{self, Faces, Ids, NOTHING, Picture, Raster};

use super::matrix::Colours;
use super::surface::Surface;
use crate::error::Result;
use crate::scene::frame::Frame;
use crate::scene::{Affine, Camera, Lens};
use crate::vector::{Vector, add, cross, dot, scale, sub};

/// What a pixel without a triangle shows.
const BACKGROUND: [u8; 3] = [104, 112, 124];

/// A surface from a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    camera: Camera,
    picture: Picture,
    /// The triangle of each pixel, or [`NOTHING`].
    items: Vec<u32>,
}

impl View {
    /// Draws the surface.
    ///
    /// # Errors
    ///
    /// A camera that has nothing in front of it, a picture of a size that the raster does not draw, and whatever the
    /// backend refuses.
    pub fn new(backend: &dyn Backend, surface: &Surface, camera: &Camera, picture: Picture) -> Result<Self> {
        let frame = Frame::new(camera, picture, &surface.corners())?;
        let raster = Raster::new()?;
        let mut job = Job::new();
        let [depth, items] = ["depth", "triangles"].map(|name| job.zeroed(name, u64::from(picture.pixels())));
        raster.record_clear(&mut job, picture, depth)?;
        raster.record_clear(&mut job, picture, items)?;
        let placement = frame.placement(&Affine::placed(surface.cell, surface.centre))?;
        let mesh = raster::Mesh {
            vertices: job.slice("vertices", surface.mesh.vertices.as_flattened()),
            vertex_count: surface.positions(),
            indices: job.slice("triangles", surface.mesh.triangles.as_flattened()),
            triangle_count: surface.mesh.triangles.len() as u32,
            rows: job.slice("placement", &placement.rows),
            instance_count: 1,
        };
        let drawn = raster.project(&mut job, frame.view, mesh)?;
        raster.record_depth(&mut job, &drawn, Faces::All, depth)?;
        let ids = Ids { base: 0, step: 0, shift: 0 };
        raster.record_items(&mut job, &drawn, Faces::All, ids, [depth, items])?;
        job.read("triangles", items.id());
        let bytes = backend.run(&job)?;
        let items = bytes[0].as_chunks().0.iter().map(|word| u32::from_le_bytes(*word)).collect();
        Ok(View { camera: camera.clone(), picture, items })
    }

    /// Columns and rows.
    pub fn size(&self) -> [u32; 2] {
        [self.picture.width, self.picture.height]
    }

    /// The triangles that have a pixel, in ascending order.
    pub fn seen(&self) -> Vec<u32> {
        let mut seen: Vec<u32> = self.items.iter().copied().filter(|item| *item != NOTHING).collect();
        seen.sort_unstable();
        seen.dedup();
        seen
    }

    /// Three bytes a pixel, by a table that [`sightlines_kernels::illumination::gamma_table`] makes.
    pub fn shade(&self, surface: &Surface, colours: &Colours, table: &[u32]) -> Vec<u8> {
        let triangles: Vec<[u32; 3]> = surface.parts.iter().flat_map(|part| part.triangles.iter().copied()).collect();
        let code = |value: f32| table.partition_point(|threshold| f32::from_bits(*threshold) <= value) as u8;
        let pixel = |(at, item): (usize, &u32)| {
            if *item == NOTHING {
                return BACKGROUND;
            }
            let corners = triangles[*item as usize];
            let weights = self.weights(at as u32, corners.map(|corner| surface.vertices[corner as usize]));
            let channel =
                |c: usize| (0..3).map(|k| weights[k] * f64::from(colours[corners[k] as usize][c])).sum::<f64>();
            [0, 1, 2].map(|c| code(channel(c) as f32))
        };
        self.items.iter().enumerate().flat_map(pixel).collect()
    }

    /// Weights of a triangle's corners where the ray of a pixel meets its plane, none below 0. The raster's corners are
    /// rounded, so a ray may pass just beside a triangle whose pixel it is.
    fn weights(&self, pixel: u32, [a, b, c]: [Vector; 3]) -> [f64; 3] {
        let (origin, direction) = self.ray(pixel % self.picture.width, pixel / self.picture.width);
        let (to_b, to_c, from_a) = (sub(b, a), sub(c, a), sub(origin, a));
        let normal = cross(direction, to_c);
        let whole = dot(to_b, normal);
        let second = dot(from_a, normal) / whole;
        let third = dot(direction, cross(from_a, to_b)) / whole;
        if !(second.is_finite() && third.is_finite()) {
            return [1.0 / 3.0; 3];
        }
        let weights = [1.0 - second - third, second, third].map(|weight| weight.clamp(0.0, 1.0));
        let sum = weights[0] + weights[1] + weights[2];
        if sum > 0.0 { weights.map(|weight| weight / sum) } else { [1.0 / 3.0; 3] }
    }

    fn ray(&self, column: u32, row: u32) -> (Vector, Vector) {
        let Camera { eye, right, up, forward, lens, .. } = &self.camera;
        let [width, height] = self.size().map(f64::from);
        let x = (2.0 * f64::from(column) + 1.0 - width) / height;
        let y = (height - 2.0 * f64::from(row) - 1.0) / height;
        let across = |size: f64| add(scale(*right, x * size), scale(*up, y * size));
        match lens {
            Lens::Perspective { slope, .. } => (*eye, add(*forward, across(*slope))),
            Lens::Orthographic { height } => (add(*eye, across(0.5 * height)), *forward),
        }
    }
}

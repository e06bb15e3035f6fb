//! Compute kernels for visibility: one folder a kernel, each with its WGSL, its oracle and its cases.
//!
//! A folder holds `kernel.wgsl` (the one text that every machine runs), `mod.rs` (typed bindings and the function that
//! records the kernel into a [`Job`](sightlines_backend::Job)), `oracle.rs` (the paper's definition in plain Rust,
//! never made from the WGSL) and `cases.rs` (named inputs from nothing to real size). `docs/adding-a-kernel.md` walks
//! through a new one.
//!
//! Invariants: integers decide every output bit; no kernel needs forward progress between workgroups, a subgroup size
//! or an optional feature; every kernel stays within WebGPU's default limits.

use std::sync::Arc;

use sightlines_backend::{Define, Kernel, Program, Result};

pub mod backprojection;
pub mod depth_bounds;
pub mod depth_map;
pub mod exact;
pub mod field;
pub mod grid;
pub mod half_planes;
pub mod illumination;
pub mod influence_region;
pub mod irradiance;
pub mod item_histogram;
pub mod light_sphere;
pub mod line_mask;
pub mod mip_pyramid;
pub mod op_map;
pub mod pattern;
pub mod permute;
pub mod pieces;
pub mod popcount;
pub mod random;
pub mod raster;
pub mod region_sets;
pub mod row_span;
pub mod sample_planes;
pub mod sat;
pub mod scan;
pub mod screen;
pub mod tile_lists;
pub mod tiles;
pub mod transmittance;
pub mod triangles;
pub mod vertex_visibility;

/// Makes the registry and the table of WGSL texts from one list; `parts` are further texts of a kernel's folder.
macro_rules! package {
    (
        kernels: $($kernel:ident),* $(,)?;
        shared: $($shared:ident),* $(,)?;
        parts: $($folder:ident / $part:ident),* $(,)?;
    ) => {
        static KERNELS: &[Kernel] = &[$($kernel::KERNEL),*];

        /// Package path and text of every WGSL file.
        static TEXTS: &[(&str, &str)] = &[
            $((
                concat!(stringify!($kernel), "/kernel.wgsl"),
                include_str!(concat!(stringify!($kernel), "/kernel.wgsl")),
            ),)*
            $((
                concat!("shared/", stringify!($shared), ".wgsl"),
                include_str!(concat!("shared/", stringify!($shared), ".wgsl")),
            ),)*
            $((
                concat!(stringify!($folder), "/", stringify!($part), ".wgsl"),
                include_str!(concat!(stringify!($folder), "/", stringify!($part), ".wgsl")),
            ),)*
        ];
    };
}

package! {
    kernels:
        backprojection,
        depth_bounds,
        depth_map,
        exact,
        half_planes,
        illumination,
        influence_region,
        irradiance,
        item_histogram,
        light_sphere,
        line_mask,
        mip_pyramid,
        op_map,
        popcount,
        raster,
        region_sets,
        row_span,
        sample_planes,
        sat,
        scan,
        tile_lists,
        transmittance,
        vertex_visibility;
    shared:
        angle,
        backprojection,
        block_scan,
        crossing,
        direction,
        divide,
        fixed_point,
        fraction,
        hash,
        influence,
        line,
        line_cell,
        mask,
        orientation,
        permute,
        raster,
        root,
        soft_float,
        view,
        wide;
    parts:
        exact / angle,
        exact / divide,
        exact / float,
        exact / line,
        exact / plane,
        exact / wide,
        influence_region / tilted,
        line_mask / build,
        line_mask / differ,
        line_mask / hough,
        raster / clip,
        raster / fitting,
        raster / small,
        raster / wide,
        region_sets / colour,
        region_sets / split;
}

/// Every kernel of the workspace, by name.
pub fn registry() -> &'static [Kernel] {
    KERNELS
}

/// The text of a WGSL file of this package, such as `shared/permute.wgsl`.
pub fn source(path: &str) -> Option<String> {
    TEXTS.iter().find(|(known, _)| *known == path).map(|(_, text)| (*text).to_owned())
}

/// Links and compiles `kernel`'s text; `variant` names what the defines choose and is empty if there are none.
pub fn program(kernel: &str, variant: &str, defines: &[Define]) -> Result<Arc<Program>> {
    let label = if variant.is_empty() { kernel.to_owned() } else { format!("{kernel}.{variant}") };
    Program::new(&label, &format!("{kernel}/kernel.wgsl"), &source, defines)
}

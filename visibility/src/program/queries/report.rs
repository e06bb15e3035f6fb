//! What the command tells on standard output: the scene, a table a camera, and what it took.

use std::io::Write;

use sightlines_backend::{BackendInfo, Counts};
use sightlines_kernels::raster::NOTHING;
use sightlines_visibility::queries::files::{Row, View};
use sightlines_visibility::queries::{Cost, Spent};
use sightlines_visibility::scene::World;

use crate::program::{Failure, machine};

/// Rows of a table at most; files have all.
const ROWS: usize = 24;

/// What is looked at.
pub(super) fn scene(world: &World, out: &mut dyn Write) -> Result<(), Failure> {
    let World { name, meshes, instances, cameras, .. } = world;
    writeln!(out, "scene      {name}: {} triangles", world.triangle_count())?;
    let [meshes, instances, cameras] = [meshes.len(), instances.len(), cameras.len()];
    writeln!(out, "parts      {meshes} meshes, {instances} instances, {cameras} cameras")?;
    Ok(out.flush()?)
}

/// What one camera sees, largest counts first.
pub(super) fn view(view: &View, world: &World, near: f64, costs: bool, out: &mut dyn Write) -> Result<(), Failure> {
    let answer = &view.answer;
    let [width, height] = view.size;
    let reading = if answer.method.is_exact() { "exact" } else { "never fewer than are visible" };
    writeln!(out, "camera     {}: {width} x {height}, near plane at {:?}", view.camera, near as f32)?;
    let tiles = 1 << answer.depth;
    writeln!(out, "method     {}, {reading}; {tiles} x {tiles} tiles", answer.method.name())?;
    let shown = answer.shown.iter().filter(|item| **item != NOTHING).count();
    let items = answer.items.len();
    writeln!(out, "seen       {} of {items} items, in {shown} pixels", answer.visible())?;
    if costs {
        cost(&answer.cost, out)?;
    }
    let mut rows = view.rows(world);
    rows.retain(|row| row.pixels > 0);
    rows.sort_by_key(|row| (std::cmp::Reverse(row.pixels), row.instance, row.cluster));
    let clusters = answer.items.iter().any(|item| item.cluster > 0);
    table(&rows, clusters, out)
}

fn table(rows: &[Row], clusters: bool, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "{:>10} {:>10} {:>7} {:>6}  name", "pixels", "covered", "share", "tiles")?;
    for row in rows.iter().take(ROWS) {
        let share = row.covered.filter(|covered| *covered > 0);
        let share =
            share.map(|covered| format!("{:.1}%", 100.0 * f64::from(row.pixels.min(covered)) / f64::from(covered)));
        let covered = row.covered.map_or_else(|| "-".to_owned(), |covered| covered.to_string());
        let tiles = row.tiles.iter().filter(|pixels| **pixels > 0).count();
        let share = share.unwrap_or_else(|| "-".to_owned());
        let name = if row.name.is_empty() { format!("instance {}", row.instance) } else { row.name.clone() };
        let cluster = if clusters { format!(", cluster {}", row.cluster) } else { String::new() };
        writeln!(out, "{:>10} {covered:>10} {share:>7} {tiles:>6}  {name}{cluster}", row.pixels)?;
    }
    if rows.len() > ROWS {
        writeln!(out, "{:>10} more; --csv and --json have all", rows.len() - ROWS)?;
    }
    Ok(())
}

fn cost(cost: &Cost, out: &mut dyn Write) -> Result<(), Failure> {
    for (name, Spent { dispatches, lane_ops, counts }) in [("draw", cost.draw), ("count", cost.count)] {
        let ops = lane_ops.map_or_else(String::new, |ops| format!(", {ops} lane-operations"));
        writeln!(out, "{name:<10} {dispatches} dispatches{ops}")?;
        if let Some(Counts { invocations, loads, stores, bytes, atomics, .. }) = counts {
            writeln!(
                out,
                "           {invocations} invocations, {loads} loads, {stores} stores, {atomics} atomics, {bytes} bytes"
            )?;
        }
    }
    Ok(writeln!(out, "memory     {} bytes of buffers", cost.bytes)?)
}

/// What ran.
pub(super) fn backend(info: &BackendInfo, out: &mut dyn Write) -> Result<(), Failure> {
    Ok(writeln!(out, "backend    {}", machine::describe(info))?)
}

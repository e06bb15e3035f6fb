//! The report of ambient occlusion for people: engines, levels, Embree.

use std::fmt::Write;

use super::{Refinement, Row};
use crate::table::{Columns, cell};

/// All tables; those without rows are left out.
pub(super) fn render(rows: &[Row]) -> String {
    let mut text = String::new();
    let Some(first) = rows.first() else { return text };
    let Row { vertices, triangles, directions, .. } = first;
    let mib = first.matrix_bytes as f64 / f64::from(1 << 20);
    let _ = writeln!(
        text,
        "{vertices} vertices, {triangles} triangles, {directions} directions: {mib:.1} MiB of bits, {:.4} of them set",
        first.occluded
    );
    engines(rows).render(&mut text);
    for refinement in rows.iter().filter_map(|row| row.refinement.as_ref()) {
        levels(refinement, &mut text);
    }
    for row in rows.iter().filter(|row| !row.embree.is_empty()) {
        let _ = writeln!(text, "\nEmbree, packets of 16 rays, against {}", row.case);
        embree(row).render(&mut text);
    }
    text
}

fn engines(rows: &[Row]) -> Columns {
    let head =
        ["engine", "threads", "clock", "open s", "s", "ns/vertex/direction", "Mlane-ops", "ns/lane-op", "peak MiB"];
    let mut lines = vec![head.map(str::to_owned).to_vec()];
    lines.extend(rows.iter().map(|row| {
        vec![
            row.case.engine.to_string(),
            row.case.threads.count().to_string(),
            row.clock.name().to_owned(),
            cell(Some(row.open_ns / 1e9), 3),
            cell(Some(row.median_ns / 1e9), 2),
            cell(Some(row.ns_per_bit), 1),
            cell(row.lane_ops.map(|ops| ops as f64 / 1e6), 1),
            cell(row.ns_per_lane_op, 3),
            cell(row.peak_bytes.map(|bytes| bytes as f64 / f64::from(1 << 20)), 0),
        ]
    }));
    Columns { left: 1, lines }
}

fn levels(refinement: &Refinement, text: &mut String) {
    let Refinement { steps, alone, ratio } = refinement;
    text.push_str("\nlevel by level, in lane-operations\n");
    let mut lines = vec![["level", "directions", "M of the step", "M so far"].map(str::to_owned).to_vec()];
    let mut before = 0;
    for (level, step) in steps.iter().enumerate() {
        lines.push(vec![
            level.to_string(),
            step.directions.to_string(),
            cell(Some((step.lane_ops - before) as f64 / 1e6), 1),
            cell(Some(step.lane_ops as f64 / 1e6), 1),
        ]);
        before = step.lane_ops;
    }
    Columns { left: 1, lines }.render(text);
    let _ = writeln!(text, "  the last level alone: {:.1} M; ratio {ratio:.4}", *alone as f64 / 1e6);
}

fn embree(row: &Row) -> Columns {
    let head = [
        "rays",
        "build s",
        "trace s",
        "robust s",
        "Mrays",
        "ns/ray",
        "ns/vertex/direction",
        "differing",
        "share",
        "ours right",
        "ours/trace",
    ];
    let mut lines = vec![head.map(str::to_owned).to_vec()];
    lines.extend(row.embree.iter().map(|traced| {
        let (times, differing) = (&traced.times, &traced.differing);
        vec![
            if traced.above { "above the tangent plane" } else { "all" }.to_owned(),
            cell(Some(times.build_ns / 1e9), 3),
            cell(Some(times.trace_ns / 1e9), 2),
            cell(Some(times.robust_ns / 1e9), 2),
            cell(Some(times.rays as f64 / 1e6), 1),
            cell(Some(times.trace_ns / times.rays as f64), 1),
            cell(Some(times.trace_ns / (f64::from(row.vertices) * f64::from(row.directions))), 1),
            differing.rays.to_string(),
            format!("{:.1e}", differing.share),
            format!("{} of {}", differing.ours_right, differing.judged),
            cell(Some(row.median_ns / times.trace_ns), 2),
        ]
    }));
    Columns { left: 1, lines }
}
